//! Resin whose absorption changes from place to place: square cells in the plane, or cubes in space.
//!
//! Cells lie centered on the axis and on z = 0 unless the caller places them; a map of one level holds at all heights. Beyond it the resin has its plain numbers.
//! A ray meets the cells one after the other; within each Beer–Lambert holds with the cell's numbers.

use super::projector::Ray;
use super::resin::Uptake;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid, sample};
use tomolith_core::units::Mm;
use tomolith_io::npy::place_of;

/// Absorption on a grid of cells about the axis, row 0 = most negative y, level 0 = lowest.
#[derive(Clone, Debug, PartialEq)]
pub struct AbsorptionMap {
    shape: [usize; 3],
    pitch_mm: f64,
    center_mm: [f64; 3],
    active: Vec<f32>,
    total: Vec<f32>,
}

impl AbsorptionMap {
    /// A map of `shape` [z, y, x] with cells of `pitch_mm`: active absorption and total attenuation, 1/mm, x fastest.
    ///
    /// # Errors
    /// [`Error::Config`] when numbers are negative, not finite, too few, or attenuation is below absorption.
    pub fn new(
        shape: [usize; 3],
        pitch_mm: f64,
        active: Vec<f32>,
        total: Vec<f32>,
    ) -> Result<Self> {
        let cells = shape.iter().product::<usize>();
        let refused = |found: String, accepted: &str| {
            Err(Error::config("resin.absorption_map", found, accepted))
        };
        if active.len() != cells || total.len() != cells || cells == 0 {
            return refused(
                format!(
                    "{} and {} values for shape {shape:?}",
                    active.len(),
                    total.len()
                ),
                "one absorption and one attenuation for every cell",
            );
        }
        if !(pitch_mm > 0.0 && pitch_mm.is_finite()) {
            return refused(
                format!("a pitch of {}", Mm(pitch_mm)),
                "a finite number > 0",
            );
        }
        let bad = active
            .iter()
            .zip(&total)
            .position(|(a, t)| !(*a >= 0.0 && t.is_finite() && t >= a));
        if let Some(i) = bad {
            let (a, t, at) = (active[i], total[i], place_of(i, &shape));
            return refused(
                format!("absorption {a} and attenuation {t} per mm in the cell {at}, as [z, y, x]"),
                "0 ≤ absorption ≤ attenuation, finite",
            );
        }
        Ok(AbsorptionMap {
            shape,
            pitch_mm,
            center_mm: [0.0; 3],
            active,
            total,
        })
    }

    /// The same map about another point [x, y, z], mm.
    #[must_use]
    pub fn about(mut self, center_mm: [f64; 3]) -> Self {
        self.center_mm = center_mm;
        self
    }

    /// Whether it is the same at all heights.
    #[must_use]
    pub fn is_flat(&self) -> bool {
        self.shape[0] == 1
    }

    /// The largest attenuation, 1/mm.
    pub fn most_per_mm(&self) -> f64 {
        f64::from(self.total.iter().copied().fold(0.0, f32::max))
    }

    /// Refuses a map whose attenuation is less than its absorption plus so much scattering.
    ///
    /// # Errors
    /// [`Error::Config`] at `resin.absorption_map.attenuation`.
    pub fn must_hold(&self, scattering_per_mm: f64) -> Result<()> {
        let mut cells = self.active.iter().zip(&self.total);
        let is_short = |(active, total): (&f32, &f32)| {
            let (active, total) = (f64::from(*active), f64::from(*total));
            // Sums in single precision are as good as that
            active + scattering_per_mm > total * (1.0 + 1e-6)
        };
        let Some(i) = cells.position(is_short) else {
            return Ok(());
        };
        let (active, total) = (self.active[i], self.total[i]);
        let at = place_of(i, &self.shape);
        Err(Error::config(
            "resin.absorption_map.attenuation",
            format!(
                "absorption {active} and attenuation {total} per mm in the cell {at}, as [z, y, x], where {scattering_per_mm} per mm are scattered"
            ),
            "an attenuation of at least absorption + resin.scattering_per_mm in every cell",
        ))
    }

    /// Mean active absorption in every voxel of a grid, 1/mm; beyond the map it is `plain`.
    pub fn means(&self, grid: &VolumeGrid, plain: f64) -> Volume<f32> {
        let plain = plain as f32;
        let mut values: Vec<f32> = self.active.iter().map(|a| a - plain).collect();
        // Overlaps are products of those along x, y and z
        for axis in 0..3 {
            let n = self.shape[2 - axis];
            let inner: usize = (0..axis).map(|done| grid.shape[2 - done]).product();
            let shares = self.shares(grid, axis);
            let mut sums = Vec::with_capacity(values.len() / n * shares.len());
            for block in values.chunks_exact(n * inner) {
                for of_voxel in &shares {
                    let at = |i: usize| -> f32 {
                        let of_cell =
                            |&(cell, share): &(usize, f32)| share * block[cell * inner + i];
                        of_voxel.iter().map(of_cell).sum()
                    };
                    sums.extend((0..inner).map(at));
                }
            }
            values = sums;
        }
        values.iter_mut().for_each(|value| *value += plain);
        Volume::new(grid.clone(), values)
    }

    /// The cells that every voxel of a grid meets along an axis (x, y, z), with their parts of it.
    fn shares(&self, grid: &VolumeGrid, axis: usize) -> Vec<Vec<(usize, f32)>> {
        let (cells, voxels) = (self.shape[2 - axis], grid.shape[2 - axis]);
        if axis == 2 && cells == 1 {
            return vec![vec![(0, 1.0)]; voxels];
        }
        let width = grid.pitch_mm / self.pitch_mm;
        let low =
            (grid.bounds_mm()[0][axis] - self.center_mm[axis]) / self.pitch_mm + cells as f64 / 2.0;
        let of_voxel = |voxel: usize| {
            let from = low + voxel as f64 * width;
            let to = from + width;
            let first = from.floor().max(0.0) as usize;
            let last = to.ceil().clamp(0.0, cells as f64) as usize;
            let share = |cell: usize| {
                let overlap = to.min(cell as f64 + 1.0) - from.max(cell as f64);
                (cell, (overlap / width) as f32)
            };
            (first..last).map(share).collect()
        };
        (0..voxels).map(of_voxel).collect()
    }

    /// Active absorption and total attenuation at a point of the plane (mm), of the lowest level; None where the map ends.
    pub fn at(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let [_, ny, nx] = self.shape;
        let cell = |c: f64, n: usize| {
            let i = ((c - sample(0, n, self.pitch_mm)) / self.pitch_mm + 0.5).floor();
            (i >= 0.0 && i < n as f64).then_some(i as usize)
        };
        let [from_x, from_y, _] = self.center_mm;
        let i = cell(y - from_y, ny)? * nx + cell(x - from_x, nx)?;
        Some([f64::from(self.active[i]), f64::from(self.total[i])])
    }

    /// Calls `visit(from, to, uptake)` for the pieces of a ray up to `length` (mm along it) in cells that differ; `plain` holds beyond
    /// the map.
    pub(super) fn for_each_piece(
        &self,
        ray: &Ray,
        length: f64,
        plain: Uptake,
        mut visit: impl FnMut(f64, f64, Uptake),
    ) {
        let mut faces: [Faces; 3] = std::array::from_fn(|i| self.faces(ray, i));
        let (mut begin, mut at) = (0.0, 0.0);
        let mut current: Option<Uptake> = None;
        while at < length {
            let next = faces.iter().map(|f| f.next).fold(length, f64::min);
            for face in &mut faces {
                if face.next <= next {
                    face.advance();
                }
            }
            if next > at {
                let here = self.uptake(ray.at(0.5 * (at + next)), plain);
                if let Some(before) = current.filter(|before| *before != here) {
                    visit(begin, at, before);
                    begin = at;
                }
                current = Some(here);
                at = next;
            }
        }
        if let Some(last) = current {
            visit(begin, length, last);
        }
    }

    /// What a point's cell takes; `plain` beyond the map.
    pub(super) fn uptake(&self, point: [f64; 3], plain: Uptake) -> Uptake {
        let mut index = 0;
        for axis in [2, 1, 0] {
            let n = self.shape[2 - axis];
            if axis == 2 && n == 1 {
                continue;
            }
            let from = point[axis] - self.center_mm[axis];
            let place = (from / self.pitch_mm + n as f64 / 2.0).floor();
            if !(0.0..n as f64).contains(&place) {
                return plain;
            }
            index = index * n + place as usize;
        }
        Uptake {
            attenuation_per_mm: f64::from(self.total[index]),
            active_per_mm: f64::from(self.active[index]),
        }
    }

    /// The faces between cells that a ray meets along an axis (x, y, z).
    fn faces(&self, ray: &Ray, axis: usize) -> Faces {
        let n = self.shape[2 - axis];
        let (from, slope) = (ray.from[axis] - self.center_mm[axis], ray.direction[axis]);
        if slope == 0.0 || (axis == 2 && n == 1) {
            return Faces {
                next: f64::INFINITY,
                step: f64::INFINITY,
                left: 0,
            };
        }
        // Faces are counted in the direction of travel
        let low = -(n as f64) / 2.0;
        let place = from / self.pitch_mm * slope.signum() - low;
        let first = (place.floor() + 1.0).max(0.0);
        let step = self.pitch_mm / slope.abs();
        let left = (n as f64 + 1.0 - first).max(0.0) as usize;
        let mut faces = Faces {
            next: (first - place) * step,
            step,
            left,
        };
        if left == 0 {
            faces.next = f64::INFINITY;
        }
        faces
    }
}

/// Where a ray meets the faces between cells along one axis, mm.
struct Faces {
    next: f64,
    step: f64,
    /// Faces from the next one on.
    left: usize,
}

impl Faces {
    fn advance(&mut self) {
        self.left = self.left.saturating_sub(1);
        self.next = if self.left == 0 {
            f64::INFINITY
        } else {
            self.next + self.step
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;

    const PLAIN: Uptake = Uptake {
        attenuation_per_mm: 9.0,
        active_per_mm: 9.0,
    };

    fn values() -> Vec<f32> {
        (0..60).map(|i| 0.1 + (i * 7 % 13) as f32).collect()
    }

    /// Unlike cells of 0.7 mm.
    fn cells() -> AbsorptionMap {
        AbsorptionMap::new([3, 4, 5], 0.7, values(), values()).unwrap()
    }

    fn pieces(map: &AbsorptionMap, ray: Ray, length: f64) -> Vec<(f64, f64, f64)> {
        let mut found = Vec::new();
        map.for_each_piece(&ray, length, PLAIN, |from, to, uptake| {
            found.push((from, to, uptake.attenuation_per_mm));
        });
        found
    }

    #[test]
    fn a_ray_meets_cells_in_its_order_and_the_plain_resin_beyond() {
        let values = vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        // Two rows of three cells of 2 mm: x from −3 to 3, y from −2 to 2
        let map = AbsorptionMap::new([1, 2, 3], 2.0, values.clone(), values).unwrap();
        let ray = Ray::new([-5.0, 1.0, 7.0], [1.0, 0.0, 0.0]);
        let expected = [
            (0., 2., 9.),
            (2., 4., 4.),
            (4., 6., 5.),
            (6., 8., 6.),
            (8., 10., 9.),
        ];
        assert_eq!(pieces(&map, ray, 10.0), expected);
        let back = Ray::new([2.0, -1.0, 0.0], [-1.0, 0.0, 0.0]);
        let expected = [(0., 1., 3.), (1., 3., 2.), (3., 4.5, 1.)];
        assert_eq!(pieces(&map, back, 4.5), expected);
        // Straight up a map of two levels, 2 mm below and above z = 0; equal cells are one piece
        let values = vec![1.0, 1.0, 2.0, 2.0];
        let map = AbsorptionMap::new([2, 1, 2], 2.0, values.clone(), values).unwrap();
        assert!(!map.is_flat());
        let up = Ray::new([0.5, 0.5, -3.0], [0.0, 0.0, 1.0]);
        let expected = [(0., 1., 9.), (1., 3., 1.), (3., 5., 2.), (5., 6., 9.)];
        assert_eq!(pieces(&map, up, 6.0), expected);
    }

    #[test]
    fn a_map_about_another_point_is_moved() {
        let by = [0.3, -0.2, 1.1];
        let moved = cells().about(by);
        let direction = [0.6, 0.64, 0.48];
        let from = [-1.5, -1.4, -0.9];
        let there = Ray::new(std::array::from_fn(|i| from[i] + by[i]), direction);
        let [here, there] = [(cells(), Ray { from, direction }), (moved, there)]
            .map(|(map, ray)| pieces(&map, ray, 4.0));
        assert_eq!(here.len(), there.len());
        for (a, b) in here.iter().zip(&there) {
            assert!((a.0 - b.0).abs() < 1e-12 && a.2 == b.2, "{a:?} {b:?}");
        }
        let grid = VolumeGrid::centered([6, 8, 10], 0.35);
        let elsewhere = VolumeGrid {
            center_mm: by,
            ..grid.clone()
        };
        let [centered, other] = [(cells(), grid), (cells().about(by), elsewhere)]
            .map(|(map, grid)| map.means(&grid, 9.0).values);
        let worst = centered.iter().zip(&other).map(|(a, b)| (a - b).abs());
        assert!(worst.fold(0.0, f32::max) < 1e-5);
    }

    #[test]
    fn means_over_voxels_are_those_of_what_they_cover() {
        let (map, values) = (cells(), values());
        // Voxels of half a cell on the faces of the cells: each lies in one, or beyond
        let half = VolumeGrid::centered([8, 10, 12], 0.35);
        let means = map.means(&half, 9.0);
        let at = |[z, y, x]: [usize; 3]| f64::from(*means.at(z, y, x));
        for index in [
            [0, 0, 0],
            [1, 1, 1],
            [3, 5, 7],
            [6, 8, 10],
            [7, 9, 11],
            [4, 0, 3],
        ] {
            let [z, y, x] = index;
            let point = [half.x(x), half.y(y), half.z(z)];
            let expected = map.uptake(point, PLAIN).active_per_mm;
            assert!((at(index) - expected).abs() < 1e-5, "{index:?}");
        }
        // One voxel over two columns of cells and 1.4 mm beyond: 3 × 4 × 2 cells of 3 × 4 × 4
        let one = VolumeGrid::centered([1, 1, 1], 2.8).about([-1.75, 0.0, 0.0]);
        let within: f32 = (0..12)
            .map(|row| values[5 * row] + values[5 * row + 1])
            .sum();
        // Along z the voxel is four cells high, and the map three
        let expected = (f64::from(within) + 9.0 * (64.0 - 24.0)) / 64.0;
        assert!((f64::from(map.means(&one, 9.0).values[0]) - expected).abs() < 1e-5);
        // A map of one level holds at all heights
        let flat = AbsorptionMap::new([1, 2, 1], 1.0, vec![2.0, 4.0], vec![2.0, 4.0]).unwrap();
        let tall = VolumeGrid::centered([3, 1, 1], 0.5);
        assert_eq!(flat.means(&tall, 9.0).values, [3.0; 3]);
    }

    #[test]
    fn scattering_must_fit_into_the_attenuation_of_every_cell() {
        let map = AbsorptionMap::new([1, 1, 2], 1.0, vec![0.1, 0.3], vec![0.4, 0.6]).unwrap();
        map.must_hold(0.3).unwrap();
        let Err(Error::Config { key, found, .. }) = map.must_hold(0.31) else {
            panic!("accepted");
        };
        assert!(
            key == "resin.absorption_map.attenuation" && found.contains("0.1"),
            "{found}"
        );
    }

    #[test]
    fn along_any_ray_the_pieces_are_its_length_and_sampling_agrees() {
        let map = cells();
        for i in 0..50 {
            let angle = 0.37 * f64::from(i);
            let from = [
                3.0 * angle.cos(),
                3.0 * angle.sin(),
                0.1 * f64::from(i) - 2.0,
            ];
            let ray = Ray::through(from, [0.3, -0.2, 0.02 * f64::from(i)]);
            let found = pieces(&map, ray, 6.0);
            assert_eq!((found[0].0, found[found.len() - 1].1), (0.0, 6.0));
            assert!(found.windows(2).all(|w| w[0].1 == w[1].0));
            let exact: f64 = found.iter().map(|(a, b, mu)| (b - a) * mu).sum();
            let samples = 60_000;
            let step = 6.0 / f64::from(samples);
            let sampled: f64 = (0..samples)
                .map(|k| map.uptake(ray.at((f64::from(k) + 0.5) * step), PLAIN))
                .map(|uptake| uptake.attenuation_per_mm * step)
                .sum();
            // Each of some 15 faces is met to half a step
            near!(exact, sampled, 15.0 * 13.0 * step, "{i}");
        }
    }
}
