//! Pieces of rays on a grid of voxels.
//!
//! A [`Segment`] runs along the axis in which it advances most, its *major* axis a: there cell i covers [i, i + 1), and the
//! other two coordinates are b(a) = b₀ + s_b·a and c(a) = c₀ + s_c·a with |s| ≤ 1. In one cell of a it therefore meets at
//! most two cells of b and two of c: three pieces, which vectors of sixteen cells can treat alike.

use crate::layout::DoseLayout;
use tomolith_core::dose::rays::RaySegment;
use tomolith_core::grid::VolumeGrid;
use tomolith_optics::projector::Ray;
use tomolith_optics::space::PathSegment;

/// A grid as the kernel sees it: counts, and floats from one voxel to the next, along x, y, z.
#[derive(Clone, Debug)]
pub(super) struct Lattice {
    pub(super) counts: [usize; 3],
    pub(super) strides: [usize; 3],
    low: [f64; 3],
    pitch: f64,
}

/// A piece of a ray. Lengths are in voxels, counted from the low corner of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(super) struct Segment {
    /// Coordinates of the other two axes at a = 0, and their slopes.
    pub(super) offset: [f32; 2],
    pub(super) slope: [f32; 2],
    /// The part of the major axis that lies in the grid.
    pub(super) low: f32,
    pub(super) high: f32,
    /// Where the light enters the resin: what it has left there is `energy` per voxel of way.
    pub(super) enter: f32,
    /// Attenuation per cell of a; negative where light travels toward lower a.
    pub(super) rate: f32,
    /// Deposit per cell of a right behind `enter`, for a pixel of value 1.
    pub(super) energy: f32,
    /// Element of the pattern field.
    pub(super) pixel: u32,
}

impl Lattice {
    pub(super) fn new(layout: &DoseLayout) -> Self {
        let VolumeGrid {
            shape: [nz, ny, nx],
            pitch_mm,
            ..
        } = layout.grid;
        Lattice {
            counts: [nx, ny, nz],
            strides: [layout.row, layout.row * nx, 1],
            low: layout.grid.bounds_mm()[0],
            pitch: pitch_mm,
        }
    }

    /// Voxel pitch, mm.
    pub(super) fn pitch(&self) -> f64 {
        self.pitch
    }

    /// A place in voxels from the low corner.
    pub(super) fn place(&self, point: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| (point[i] - self.low[i]) / self.pitch)
    }

    /// x and y of the low corner, in voxels from the axis of the vial.
    pub(super) fn corner(&self) -> [f32; 2] {
        [self.low[0], self.low[1]].map(|low| (low / self.pitch) as f32)
    }

    /// A path segment as data, wherever it lies; `energy_mm2` as for [`segment`](Self::segment).
    pub(super) fn ray(&self, path: &PathSegment, energy_mm2: f64) -> RaySegment {
        let ([x, y, _], [dx, dy, _]) = (path.ray.from, path.ray.direction);
        // Of light along the axis any point
        let nearest = -(x * dx + y * dy) / (dx * dx + dy * dy).max(1e-6);
        let [x, y, z] = path.ray.at(nearest);
        let span = [-nearest, path.length - nearest];
        RaySegment {
            nearest: [x, y, z - self.low[2]].map(|v| (v / self.pitch) as f32),
            rate: (path.uptake.attenuation_per_mm * self.pitch) as f32,
            direction: path.ray.direction.map(|v| v as f32),
            energy: (path.uptake.active_per_mm * path.power * energy_mm2 / self.pitch.powi(2))
                as f32,
            span: span.map(|v| (v / self.pitch) as f32),
        }
    }

    /// Moves a ray to the middle of the lowest slice; the height where it was, in voxels from the low end.
    pub(super) fn to_first_slice(&self, ray: &mut Ray) -> f64 {
        let height = (ray.from[2] - self.low[2]) / self.pitch;
        ray.from[2] = self.low[2] + 0.5 * self.pitch;
        height
    }

    /// The part of a path segment that lies in the grid, and its major axis; None when it misses the grid.
    ///
    /// `energy_mm2`: what a pixel of value 1 sends along this path segment's ray, in mm² of area times its power.
    pub(super) fn segment(
        &self,
        path_segment: &PathSegment,
        energy_mm2: f64,
        pixel: u32,
    ) -> Option<(usize, Segment)> {
        let direction = path_segment.ray.direction;
        let axis = major(direction);
        let others = others(axis);
        let place = |i: usize| (path_segment.ray.from[i] - self.low[i]) / self.pitch;
        let enter = place(axis);
        let end = enter + path_segment.length * direction[axis] / self.pitch;
        let slope = others.map(|i| direction[i] / direction[axis]);
        let offset: [f64; 2] = std::array::from_fn(|i| place(others[i]) - slope[i] * enter);
        let (mut low, mut high) = (
            enter.min(end).max(0.0),
            enter.max(end).min(self.counts[axis] as f64),
        );
        for i in 0..2 {
            let count = self.counts[others[i]] as f64;
            if slope[i] == 0.0 {
                if !(0.0..count).contains(&offset[i]) {
                    return None;
                }
                continue;
            }
            let (at0, at1) = (-offset[i] / slope[i], (count - offset[i]) / slope[i]);
            low = low.max(at0.min(at1));
            high = high.min(at0.max(at1));
        }
        if low >= high {
            return None;
        }
        // Way through one cell of a, mm
        let step = self.pitch / direction[axis].abs();
        Some((
            axis,
            Segment {
                offset: offset.map(|v| v as f32),
                slope: slope.map(|v| v as f32),
                low: low as f32,
                high: high as f32,
                enter: enter as f32,
                rate: (path_segment.uptake.attenuation_per_mm * step).copysign(direction[axis])
                    as f32,
                energy: (path_segment.uptake.active_per_mm * step * path_segment.power * energy_mm2
                    / self.pitch.powi(3)) as f32,
                pixel,
            },
        ))
    }
}

impl Segment {
    /// Voxels that it passes: the planes of each axis that it crosses.
    pub(super) fn passed(&self) -> f64 {
        let [b, c] = self.slope.map(f32::abs);
        f64::from(self.high - self.low) * f64::from(1.0 + b + c)
    }

    /// Unit direction of the light, x, y, z; `axis` is the major one.
    pub(super) fn direction(&self, axis: usize) -> [f64; 3] {
        let [b, c] = self.slope.map(f64::from);
        // The sign of a rate is there where the rate is 0, too
        let along = (1.0 + b * b + c * c).sqrt().recip();
        let along = along.copysign(f64::from(self.rate));
        let mut direction = [along; 3];
        for (i, slope) in others(axis).into_iter().zip([b, c]) {
            direction[i] *= slope;
        }
        direction
    }

    /// Cuts a segment into its pieces inside and outside, in the order of travel: `visit(is_inside, piece)`. `inside` are the
    /// pieces `[from, to]` of the path segment, mm; `step`: cells of the major axis per mm of the path segment, with its sign.
    pub(super) fn cut(self, step: f64, inside: &[[f64; 2]], mut visit: impl FnMut(bool, Segment)) {
        let place = |t: f64| {
            let a = (f64::from(self.enter) + t * step) as f32;
            a.clamp(self.low, self.high)
        };
        let mut piece = |is_inside: bool, [from, to]: [f32; 2]| {
            if from != to {
                let (low, high) = (from.min(to), from.max(to));
                visit(is_inside, Segment { low, high, ..self });
            }
        };
        let [begin, end] = if step > 0.0 {
            [self.low, self.high]
        } else {
            [self.high, self.low]
        };
        let mut at = begin;
        for span in inside {
            let [from, to] = span.map(place);
            piece(false, [at, from]);
            piece(true, [from, to]);
            at = to;
        }
        piece(false, [at, end]);
    }
}

/// The axis along which a direction advances most.
fn major(direction: [f64; 3]) -> usize {
    let size = direction.map(f64::abs);
    if size[0] >= size[1] && size[0] >= size[2] {
        0
    } else if size[1] >= size[2] {
        1
    } else {
        2
    }
}

/// The other two axes, x before y before z.
pub(super) fn others(axis: usize) -> [usize; 2] {
    match axis {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    }
}
