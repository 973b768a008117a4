//! Graphics cards: fields, objectives, methods and dose models computed there.
//!
//! The one crate that touches an interface of graphics cards (wgpu: Vulkan, Metal, DX12). [`Gpu`] is a card, [`GpuField`] a vector on it with all operations
//! that methods, objectives and penalties are made of, [`model_on`] makes dose models of [forms](tomolith_core::dose::form::Form); [`Gpu`] as an [`Accelerator`](tomolith_core::dose::Accelerator)
//! computes models for fields of the host.
//!
//! A software adapter is never taken unless it is named. The tests run on Mesa's `lavapipe` where no card is there.

mod accelerator;
mod bands;
mod bins;
mod cells;
mod convolution;
mod costs;
mod counter;
mod device;
mod entries;
mod field;
mod half_ramp;
mod mask;
mod pairs;
mod passes;
mod paths;
mod rays;
mod scattered;
mod stretches;
mod strips;
mod transforms;
mod waves;

pub use accelerator::model_on;
pub use bands::GpuBands;
pub use costs::GpuCosts;
pub use device::{Adapter, Asked, Gpu, adapters};
pub use field::{GpuBounds, GpuField};
pub use half_ramp::GpuHalfRamp;
pub use pairs::GpuPairs;
