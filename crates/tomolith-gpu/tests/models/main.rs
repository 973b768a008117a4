//! Dose models on a card beside those of the processor.

#[path = "../common/mod.rs"]
mod common;
mod joint;
mod paths;
mod planar;
#[path = "../common/portable.rs"]
mod portable;
mod rays;
mod scene;
mod waves;
