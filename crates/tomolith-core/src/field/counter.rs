//! Counts of the elements of part and void, where a field lives: what the print of a dose is measured from.
//!
//! Fields of the host need none of it: [`Field::counter`](super::Field::counter) gives nothing, and whoever measures reads them in place.

/// Bins of [`Counter::counts`].
pub const BINS: usize = 1024;

/// Counts elements by their [labels](crate::target::label): of the part first, then of the void.
pub trait Counter<F>: Send + Sync {
    /// Smallest and largest value of each class, +∞ and −∞ where there is none; what is no number is left out.
    fn ranges(&self, values: &F) -> [[f32; 2]; 2];
    /// Elements of each class in [`BINS`] bins: number (value − low)·scale, rounded down; what lies beyond the last bin counts there, what is no
    /// number in the first.
    fn counts(&self, values: &F, low: f32, scale: f32) -> Vec<[u64; 2]>;
}
