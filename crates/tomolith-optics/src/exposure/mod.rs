//! Everything between a pattern and what a given machine shows.
//!
//! *What must it do, and who does it.* [`quantize()`] brings patterns to the projector's bit depth and back, bit for bit;
//! [`printer`] puts them on the pixels of a device and takes them back from there (canvas, turns, flips, gray curve, maps,
//! order of frames); [`movie`] says at which rate the frames follow each other and what their movie is called; [`budget`]
//! says how long the print takes and where the light goes; [`calibration`] draws frames for setting a machine up.

pub mod budget;
pub mod calibration;
pub(crate) mod maps;
pub mod movie;
mod placing;
pub mod printer;
pub mod quantize;
mod tone;

pub use budget::{Budget, ExposureBudget};
pub use calibration::{CALIBRATIONS, Calibration};
pub use maps::read_map;
pub use movie::{SLOWEST, frame_rate, is_too_slow, movie_name, shown_rate};
pub use printer::{Printer, PrinterSpec, Rotation};
pub use quantize::{Quantized, quantize};
