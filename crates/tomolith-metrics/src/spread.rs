//! Smallest, largest, mean and deviation of the response of part and void, the same for any number of threads.

/// Sums over one label's voxels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Voxels.
    pub count: u64,
    /// Smallest response.
    pub min: f32,
    /// Largest response.
    pub max: f32,
    /// Mean response.
    pub mean: f64,
    /// Standard deviation of the response (of all voxels: divided by their number).
    pub deviation: f64,
}

/// Sums over the voxels of one label in one block, of differences to the first of them.
#[derive(Clone, Copy)]
pub(super) struct Sums {
    pub(super) count: u64,
    pub(super) min: f32,
    pub(super) max: f32,
    pub(super) sum: f64,
    pub(super) squares: f64,
    pub(super) first: f32,
}

impl Sums {
    pub(super) const EMPTY: Sums = Sums {
        count: 0,
        min: f32::INFINITY,
        max: f32::NEG_INFINITY,
        sum: 0.0,
        squares: 0.0,
        first: 0.0,
    };

    /// Adds a voxel, as its difference to the first one: no cancellation in the variance.
    #[inline(always)]
    pub(super) fn add(&mut self, value: f32) {
        if self.count == 0 {
            self.first = value;
        }
        let off = f64::from(value) - f64::from(self.first);
        self.count += 1;
        self.min = if value < self.min { value } else { self.min };
        self.max = if value > self.max { value } else { self.max };
        self.sum += off;
        self.squares += off * off;
    }
}

/// Joins blocks in their order (Chan's update of mean and variance).
pub(super) fn spread(blocks: &[[Sums; 2]], class: usize) -> Option<Spread> {
    let (mut count, mut mean, mut scatter) = (0u64, 0.0, 0.0);
    let (mut min, mut max) = (f32::INFINITY, f32::NEG_INFINITY);
    for block in blocks.iter().map(|b| b[class]).filter(|b| b.count > 0) {
        let n = block.count as f64;
        let block_mean = f64::from(block.first) + block.sum / n;
        let block_scatter = (block.squares - block.sum * block.sum / n).max(0.0);
        let total = count as f64 + n;
        let off = block_mean - mean;
        scatter += block_scatter + off * off * (count as f64 * n / total);
        mean += off * n / total;
        count += block.count;
        min = min.min(block.min);
        max = max.max(block.max);
    }
    (count > 0).then(|| Spread {
        count,
        min,
        max,
        mean,
        deviation: (scatter / count as f64).sqrt(),
    })
}
