//! Winding numbers on a lattice of lines: where shells count twice, or less than nothing.

use super::Diagnosis;
use crate::lines::{Lines, Scaled};
use tomolith_core::grid::VolumeGrid;
use tomolith_core::parallel::InParallel;
use tomolith_core::work::Work;
use tomolith_io::mesh::Mesh;

/// Lines along the longer of y and z that look for overlaps.
const LATTICE: f64 = 256.0;

/// Volume and longest stretch of one kind of misfit.
#[derive(Clone, Copy, Default)]
struct Misfit {
    length: f64,
    longest: f64,
    at: [f64; 3],
}

impl Misfit {
    fn add(&mut self, length: f64, at: [f64; 3]) {
        self.length += length;
        if length > self.longest {
            (self.longest, self.at) = (length, at);
        }
    }

    fn join(&mut self, other: &Misfit) {
        self.length += other.length;
        if other.longest > self.longest {
            (self.longest, self.at) = (other.longest, other.at);
        }
    }
}

/// Looks along the lines of the lattice for winding numbers other than 0 and 1; in vain when the run is canceled.
pub(super) fn find_overlaps(mesh: &Mesh, found: &mut Diagnosis, work: &Work) {
    let [low, high] = mesh.bounds();
    let pitch_mm = (high[1] - low[1]).max(high[2] - low[2]) / LATTICE;
    let count = |axis: usize| ((high[axis] - low[axis]) / pitch_mm).ceil().max(1.0) as usize;
    let grid = VolumeGrid {
        center_mm: std::array::from_fn(|i| (low[i] + high[i]) / 2.0),
        ..VolumeGrid::centered([count(2), count(1), 1], pitch_mm)
    };
    let scaled = Scaled::new(mesh, None, &grid);
    let x0 = grid.bounds_mm()[0][0];
    let slices: Vec<[Misfit; 2]> = (0..grid.shape[0]).par_map_with(Lines::default, |lines, iz| {
        if work.is_canceled() {
            return Default::default();
        }
        let z = iz as f64 + 0.5;
        let active = scaled.between(z, z);
        lines.cast(&scaled, &active, z, |j| j as f64 + 0.5, 0..grid.shape[1]);
        let mut misfits = [Misfit::default(); 2];
        lines.for_each_line(|iy, crossings| {
            let mut winding = 0;
            for pair in crossings.windows(2) {
                winding += pair[0].step;
                let length = (pair[1].x - pair[0].x) * pitch_mm;
                let x = x0 + (pair[0].x + pair[1].x) / 2.0 * pitch_mm;
                // A stretch shorter than a thousandth of the spacing is rounding, not overlap
                if !(0..=1).contains(&winding) && length > 1e-3 * pitch_mm {
                    let kind = usize::from(winding < 0);
                    misfits[kind].add(length, [x, grid.y(iy), grid.z(iz)]);
                }
            }
        });
        misfits
    });
    let mut total = [Misfit::default(); 2];
    for slice in &slices {
        for (total, misfit) in total.iter_mut().zip(slice) {
            total.join(misfit);
        }
    }
    let volume = |m: &Misfit| m.length * pitch_mm * pitch_mm;
    let at = |m: &Misfit| (m.longest > 0.0).then_some(m.at);
    (found.overlap_mm3, found.overlap_at) = (volume(&total[0]), at(&total[0]));
    (found.negative_mm3, found.negative_at) = (volume(&total[1]), at(&total[1]));
}
