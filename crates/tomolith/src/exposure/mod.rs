//! Everything between a pattern and what a given machine shows.
//!
//! *What must it do, and who does it.* [`quantise()`] brings patterns to the projector's bit depth and back, bit for bit;
//! [`movie`] says at which rate the frames follow each other and what their movie is called.

pub mod movie;
pub mod quantise;

pub use movie::{frame_rate, movie_name};
pub use quantise::{Quantised, quantise};
