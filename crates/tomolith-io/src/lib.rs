//! Formats in and out.
//!
//! *What must it do, and who does it.* One file a format. Whatever is written appears whole or not at all: every
//! writer goes through [`whole`]. Every reader opens its file through [`open_regular`].

pub mod array;
pub mod channel;
pub mod csr;
pub mod csv;
pub mod frames;
pub mod image;
pub mod mesh;
pub mod movie;
pub mod mp4;
pub mod npy;
mod npz;
mod nrrd;
mod numbers;
mod ome_zarr;
pub mod ply;
pub mod series;
pub mod slices;
pub mod stack;
pub mod stl;
mod tiff_pages;
pub mod volume;
pub mod vti;
pub mod whole;

pub use tomolith_core::files::{open_regular, read_at_most, read_regular, read_text};
pub use whole::{
    give_up, make_folder, must_be_free, must_be_new, write_folder_whole, write_text, write_whole,
    write_whole_under,
};
