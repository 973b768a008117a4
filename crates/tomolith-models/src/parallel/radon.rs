//! The published kernels of pure Radon: `line`, `linear` and `strip`.
//!
//! Three ways to say how much of a column's light belongs to a voxel, as reconstruction programs know them; they exist to
//! compare with what others published. With the ray of the column's middle (unit of length: a voxel, p pixel pitch, h
//! voxel pitch):
//!
//! ```text
//! line     weight = p/h² · length of the ray in the voxel                        (Siddon, Med. Phys. 12, 252 (1985))
//! linear   weight = p/h² · way through a row of voxels · linear interpolation    (Joseph, IEEE Trans. Med. Imaging 1, 192
//!          between the two voxels nearest to the ray at the row's middle          (1982))
//! strip    weight = 1/h² · area that column (as wide as a pixel) and voxel share, exact
//! ```
//! Rows run along the axis that the ray is closer to. All three are defined for straight light that nothing weakens: an
//! index-matched vial and `pure_radon`. Light lives in the vial only; for the kernel exactly as published the vial must
//! hold the corners of the grid. `strip` is what `distance-driven` approximates: it conserves energy and makes uniform
//! light uniform; `line` does neither where pixels are finer or coarser than voxels.

use super::strips::{Beam, Columns, Major, Strip};
use super::tiles::{Local, TileEntries};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::grid::{PatternGrid, VolumeGrid};

/// How the light of a pixel column is shared among the voxels it meets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Kernel {
    /// By the interval between the column's edges in the middle of each row of voxels; every vial, every absorption.
    #[default]
    DistanceDriven,
    /// By the length of the column's middle ray in each voxel (Siddon).
    Line,
    /// By linear interpolation between the two voxels nearest to the middle ray, row by row (Joseph).
    Linear,
    /// By the exact area that column and voxel share.
    Strip,
}

impl Kernel {
    /// Its name in job files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Kernel::DistanceDriven => "distance-driven",
            Kernel::Line => "line",
            Kernel::Linear => "linear",
            Kernel::Strip => "strip",
        }
    }

    /// How far beyond the middle ray a column lights voxels: in voxels, given half the column's width.
    fn reach(self, half_width: f64) -> f64 {
        match self {
            // A ray along a face of a tile must not pass between two tiles
            Kernel::Line => 1e-3,
            Kernel::Linear => 1.0,
            Kernel::DistanceDriven | Kernel::Strip => half_width,
        }
    }
}

/// Beams of straight light through a circle of resin of `radius` mm; the edges of a strip are as far from its ray as the
/// kernel reaches.
pub(super) fn beams(
    kernel: Kernel,
    radius: f64,
    pixels: &PatternGrid,
    sub_angles: usize,
    grid: &VolumeGrid,
) -> Vec<Beam> {
    let mut beams = Vec::with_capacity(pixels.frames() * sub_angles);
    for (frame, &azimuth) in pixels.azimuths.iter().enumerate() {
        for sub in 0..sub_angles {
            let within = (sub as f64 + 0.5) / sub_angles as f64 - 0.5;
            let rays = Rays {
                kernel,
                radius,
                azimuth: azimuth + within * pixels.frame_arc,
                weight: 1.0 / sub_angles as f64,
            };
            let beam = rays.beam(frame as u32, pixels, grid);
            if !beam.strips.is_empty() {
                beams.push(beam);
            }
        }
    }
    beams
}

struct Rays {
    kernel: Kernel,
    radius: f64,
    azimuth: f64,
    weight: f64,
}

impl Rays {
    fn beam(&self, frame: u32, pixels: &PatternGrid, grid: &VolumeGrid) -> Beam {
        let (sin, cos) = self.azimuth.sin_cos();
        let major = if cos.abs() > sin.abs() {
            Major::X
        } else {
            Major::Y
        };
        let mut strips: Vec<Strip> = (0..pixels.columns)
            .filter_map(|column| self.strip(column, [sin, cos], major, pixels, grid))
            .collect();
        // In growing order across the rows, as tiles expect
        if strips.len() > 1 && strips[0].edges[0][0] > strips[1].edges[0][0] {
            strips.reverse();
        }
        Beam {
            frame,
            azimuth: self.azimuth,
            major,
            strips,
            columns: Columns::default(),
        }
    }

    /// None where the ray misses the resin.
    fn strip(
        &self,
        column: usize,
        [sin, cos]: [f64; 2],
        major: Major,
        pixels: &PatternGrid,
        grid: &VolumeGrid,
    ) -> Option<Strip> {
        let u = pixels.column_u(column);
        let half_chord = ((self.radius - u) * (self.radius + u)).max(0.0).sqrt();
        if half_chord == 0.0 {
            return None;
        }
        let (along, across) = major.axes();
        let (foot, direction) = ([-u * sin, u * cos], [-cos, -sin]);
        let (low, h) = (grid.bounds_mm()[0], grid.pitch_mm);
        let slope = direction[across] / direction[along];
        let offset = (foot[across] - slope * (foot[along] - low[along]) - low[across]) / h;
        let middle = (foot[along] - low[along]) / h;
        let half_span = half_chord * direction[along].abs() / h;
        let reach = self
            .kernel
            .reach(pixels.pitch_mm[0] / (2.0 * h * direction[along].abs()));
        Some(Strip {
            column: column as u32,
            upward: direction[along] > 0.0,
            edges: [-reach, reach].map(|beyond| [(offset + beyond) as f32, slope as f32]),
            span: [(middle - half_span) as f32, (middle + half_span) as f32],
            power: (pixels.pitch_mm[0] * self.weight / (h * h)) as f32,
            row_mm: (h / direction[along].abs()) as f32,
        })
    }
}

/// A strip's ray seen from a tile.
struct Ray {
    offset: f64,
    slope: f64,
    half_width: f64,
    /// Weight of a whole row.
    per_row: f64,
    /// Share of the strip that one unit of area makes.
    per_area: f64,
}

impl Ray {
    fn new(strip: &Strip, local: &Local) -> Self {
        let [[low, slope], [high, _]] = strip.edges.map(|edge| edge.map(f64::from));
        let [row, across] = local.origin.map(f64::from);
        let per_row = f64::from(strip.power) * f64::from(strip.row_mm);
        let width = high - low;
        Ray {
            offset: 0.5 * (low + high) + slope * row - across,
            slope,
            half_width: 0.5 * width,
            per_row,
            per_area: if width > 0.0 { per_row / width } else { 0.0 },
        }
    }

    fn at(&self, row: f64) -> f64 {
        self.offset + self.slope * row
    }
}

impl TileEntries {
    /// Appends what `strips` light in the tile by a published kernel; `keep` says which columns count.
    pub(super) fn add_radon(
        &mut self,
        kernel: Kernel,
        strips: &[Strip],
        local: &Local,
        keep: impl Fn(u32) -> bool,
    ) {
        for strip in strips {
            if !keep(strip.column) {
                continue;
            }
            let begin = self.slots.len() as u32;
            let ray = Ray::new(strip, local);
            let [low, high] = strip.span.map(|t| f64::from(t - local.origin[0]));
            for row in 0..local.rows {
                let (from, to) = ((row as f64).max(low), (row as f64 + 1.0).min(high));
                if from >= to {
                    continue;
                }
                match kernel {
                    Kernel::Line => self.add_line(&ray, local, row, from, to),
                    Kernel::Linear => self.add_linear(&ray, local, row, from, to),
                    Kernel::Strip | Kernel::DistanceDriven => {
                        self.add_area(&ray, local, row, from, to);
                    }
                }
            }
            self.end_run(strip.column, begin);
        }
    }

    /// The ray between `from` and `to` of a row, cut at the faces of voxels.
    fn add_line(&mut self, ray: &Ray, local: &Local, row: usize, from: f64, to: f64) {
        let (a, b) = (ray.at(from), ray.at(to));
        let (low, high) = (a.min(b), a.max(b));
        let weight = ray.per_row * (to - from);
        for voxel in low.floor() as i64..=high.floor() as i64 {
            let share = if high > low {
                (high.min(voxel as f64 + 1.0) - low.max(voxel as f64)) / (high - low)
            } else {
                1.0
            };
            self.push_voxel(local, row, voxel, weight * share);
        }
    }

    /// The two voxels nearest to the ray in the middle of a row, if light is there.
    fn add_linear(&mut self, ray: &Ray, local: &Local, row: usize, from: f64, to: f64) {
        let middle = row as f64 + 0.5;
        if !(from..=to).contains(&middle) {
            return;
        }
        let position = ray.at(middle) - 0.5;
        let (voxel, share) = (position.floor(), position - position.floor());
        self.push_voxel(local, row, voxel as i64, ray.per_row * (1.0 - share));
        self.push_voxel(local, row, voxel as i64 + 1, ray.per_row * share);
    }

    /// The area between the edges of the strip, and between `from` and `to`.
    fn add_area(&mut self, ray: &Ray, local: &Local, row: usize, from: f64, to: f64) {
        let (a, b) = (ray.at(from), ray.at(to));
        let first = (a.min(b) - ray.half_width).floor() as i64;
        let last = (a.max(b) + ray.half_width).floor() as i64;
        for voxel in first.max(0)..=last.min(local.across as i64 - 1) {
            let below = |edge: f64| {
                let corner = voxel as f64 - edge;
                mean_of_clamped(a - corner, b - corner)
            };
            let area = (below(ray.half_width) - below(-ray.half_width)) * (to - from);
            self.push_voxel(local, row, voxel, ray.per_area * area);
        }
    }

    fn push_voxel(&mut self, local: &Local, row: usize, voxel: i64, weight: f64) {
        let inside = (0..local.across as i64).contains(&voxel);
        if inside && weight > 0.0 {
            self.push(local, [row, voxel as usize], weight as f32);
        }
    }
}

/// Mean of min(max(e, 0), 1) while e goes evenly from `a` to `b`.
fn mean_of_clamped(a: f64, b: f64) -> f64 {
    // Closer than this, the difference of the integrals has lost its digits
    if (b - a).abs() < 1e-6 {
        return (0.5 * (a + b)).clamp(0.0, 1.0);
    }
    let integral = |e: f64| {
        let inside = e.clamp(0.0, 1.0);
        0.5 * inside * inside + (e - 1.0).max(0.0)
    };
    (integral(b) - integral(a)) / (b - a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Work;
    use crate::parallel::Parallel;
    use tomolith_core::check;
    use tomolith_core::dose::DoseModel;
    use tomolith_core::field::HostField;
    use tomolith_core::grid::Volume;
    use tomolith_core::near;
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::{cylinder::Cylinder, index_matched::IndexMatched};

    /// What ASTRA 2.5.0 (CPU, `parallel` geometry, 9 × 9 pixels, 13 detectors of width 1) projects of the image
    /// `(7·row + 3·column) % 11 / 10` at the angles [`ANGLES`].
    const ASTRA: [(Kernel, [[f64; 13]; 4]); 3] = [
        (
            Kernel::Line,
            [
                [
                    0.0, 0.0, 4.3, 4.8, 4.2, 4.7, 4.1, 4.6, 5.1, 4.5, 3.9, 0.0, 0.0,
                ],
                [
                    0.0, 0.748599, 3.33762, 3.9763, 5.35794, 4.82481, 4.42567, 4.90998, 4.16279,
                    4.30634, 3.26691, 1.2184, 0.0,
                ],
                [
                    0.0127683, 0.969843, 3.31149, 2.94335, 5.50184, 4.68121, 5.28288, 4.77565,
                    4.90066, 3.58602, 2.45915, 1.87434, 0.0255365,
                ],
                [
                    0.0, 0.667783, 2.11565, 5.11802, 4.29182, 3.87518, 6.16639, 5.22242, 3.70586,
                    4.95576, 3.20859, 0.641669, 0.0,
                ],
            ],
        ),
        (
            Kernel::Linear,
            [
                [
                    0.0, 0.0, 4.3, 4.8, 4.2, 4.7, 4.1, 4.6, 5.1, 4.5, 3.9, 0.0, 0.0,
                ],
                [
                    0.0, 0.847597, 3.11777, 4.32864, 4.97705, 4.40236, 5.08693, 4.67803, 3.98743,
                    4.47518, 3.22695, 1.07576, 0.0,
                ],
                [
                    0.0340473, 1.03468, 3.26579, 3.04016, 5.13291, 4.78458, 5.29512, 4.76113,
                    4.92552, 3.58618, 2.46748, 1.90718, 0.0680946,
                ],
                [
                    0.0765858, 0.842413, 2.21383, 4.49527, 4.41785, 4.48992, 5.61625, 5.2156,
                    4.45623, 4.48833, 3.18551, 0.818786, 0.0,
                ],
            ],
        ),
        (
            Kernel::Strip,
            [
                [
                    0.0, 0.0, 4.3, 4.8, 4.2, 4.7, 4.1, 4.6, 5.1, 4.5, 3.9, 0.0, 0.0,
                ],
                [
                    0.00294055, 0.862821, 3.11757, 4.33319, 4.92308, 4.43491, 5.08284, 4.67181,
                    3.99633, 4.4608, 3.20524, 1.10258, 0.00588112,
                ],
                [
                    0.0412002, 1.08733, 3.08099, 3.10417, 5.08106, 4.80126, 5.2619, 4.78883,
                    4.9171, 3.60905, 2.48678, 1.85556, 0.0847775,
                ],
                [
                    0.0846019,
                    0.896843,
                    2.2414,
                    4.36118,
                    4.48954,
                    4.59393,
                    5.41168,
                    5.13092,
                    4.60289,
                    4.44253,
                    3.04679,
                    0.896793,
                    0.000926793,
                ],
            ],
        ),
    ];
    const ANGLES: [f64; 4] = [0.0, 0.3, 1.1, 2.0];

    fn model(kernel: Kernel, pixels: PatternGrid, grid: VolumeGrid) -> Parallel {
        let light = Light::new(pixels, Resin::pure_radon(1.5));
        let vial = IndexMatched { radius_mm: 50.0 };
        Parallel::under(&vial, vec![light], kernel, grid, &Work::new()).unwrap()
    }

    #[test]
    fn projections_are_those_of_another_program() {
        // Its detectors count along (cos a, sin a), ours along (−sin α, cos α); its image rows fall with y
        let azimuths = ANGLES.map(|a| a - std::f64::consts::FRAC_PI_2).to_vec();
        let pixels = PatternGrid {
            azimuths,
            frame_arc: 0.0,
            rows: 1,
            columns: 13,
            pitch_mm: [1.0; 2],
            offset_mm: [0.0; 2],
        };
        let grid = VolumeGrid::centered([1, 9, 9], 1.0);
        let image: Vec<f32> = (0..81)
            .map(|i| ((7 * (8 - i / 9) + 3 * (i % 9)) % 11) as f32 / 10.0)
            .collect();
        for (kernel, expected) in ASTRA {
            let model = model(kernel, pixels.clone(), grid.clone());
            let volume = Volume::new(grid.clone(), image.clone());
            let cotangent = HostField::from_slice(&model.outputs()[0].field_of(&volume));
            let grad = check::adjoint(&model, &cotangent);
            let found = model.patterns()[0].patterns_of(grad.as_slice());
            for (i, (&found, &expected)) in
                found.values.iter().zip(expected.as_flattened()).enumerate()
            {
                assert!(
                    (f64::from(found) - expected).abs() <= 2e-5 * 5.0,
                    "{kernel:?}, angle {}, detector {}: {found}, not {expected}",
                    i / 13,
                    i % 13
                );
            }
        }
    }

    #[test]
    fn every_kernel_passes_the_model_check() {
        for kernel in [Kernel::Line, Kernel::Linear, Kernel::Strip] {
            for pitch in [0.11, 0.055, 0.23] {
                let pixels = PatternGrid::full_turn(7, 0.2, 9, 45, pitch);
                let grid = VolumeGrid::centered([11, 35, 37], 0.1).about([0.13, -0.05, 0.02]);
                check::model::model(&model(kernel, pixels, grid), 7)
                    .unwrap_or_else(|e| panic!("{kernel:?} {pitch}: {e}"));
            }
        }
    }

    #[test]
    fn a_strip_shares_its_area_and_a_ray_its_length() {
        // One column of width 0.3 through a square of 2 × 2: adjoint of 1 is p·length/h² for the middle column
        let pixels = PatternGrid {
            azimuths: vec![0.4],
            frame_arc: 0.0,
            rows: 1,
            columns: 5,
            pitch_mm: [0.3; 2],
            offset_mm: [0.0; 2],
        };
        let grid = VolumeGrid::centered([1, 20, 20], 0.1);
        let way = 2.0 / 0.4f64.cos();
        for kernel in [Kernel::Line, Kernel::Linear, Kernel::Strip] {
            let model = model(kernel, pixels.clone(), grid.clone());
            let all = Volume::filled(grid.clone(), 1.0f32);
            let cotangent = HostField::from_slice(&model.outputs()[0].field_of(&all));
            let grad = check::adjoint(&model, &cotangent);
            let found = f64::from(grad.as_slice()[2]);
            let expected = 0.3 * way / (0.1 * 0.1);
            assert!(
                (found / expected - 1.0).abs() < 1e-5,
                "{kernel:?}: {found} {expected}"
            );
        }
    }

    #[test]
    fn a_ray_along_a_face_lights_one_of_its_voxels_in_a_slice_as_in_a_volume() {
        // An odd number of columns and an even one of voxels: at multiples of 90° the middle ray runs between two tiles
        let azimuths = (0..8).map(|k| f64::from(k) * std::f64::consts::FRAC_PI_4);
        let pixels = |rows: usize| PatternGrid {
            azimuths: azimuths.clone().chain([0.02, 0.7, 2.1]).collect(),
            frame_arc: 0.0,
            rows,
            columns: 41,
            pitch_mm: [0.1; 2],
            offset_mm: [0.0; 2],
        };
        let grid = |slices| VolumeGrid::centered([slices, 32, 32], 0.1);
        let ones = |model: &Parallel| {
            let all = Volume::filled(model.outputs()[0].grid.clone(), 1.0f32);
            let cotangent = HostField::from_slice(&model.outputs()[0].field_of(&all));
            let grad = check::adjoint(model, &cotangent);
            model.patterns()[0].patterns_of(grad.as_slice()).values
        };
        for isa in crate::parallel::kernel::Isa::available() {
            let plane = model(Kernel::Line, pixels(1), grid(1)).with_isa(isa);
            let volume = model(Kernel::Line, pixels(2), grid(2)).with_isa(isa);
            let (of_plane, of_volume) = (ones(&plane), ones(&volume));
            for frame in (0..8).step_by(2) {
                let middle = f64::from(of_plane[frame * 41 + 20]);
                near!(middle / 32.0, 1.0, 1e-5, "{isa:?} {frame}: {middle}");
            }
            // Columns 4 and 36 run along the outermost faces: inside or outside is rounding
            let within = |(i, _): &(usize, &f32)| ![4, 36].contains(&(i % 41));
            for (i, &value) in of_plane.iter().enumerate().filter(within) {
                let twin = of_volume[(i / 41 * 2) * 41 + i % 41];
                near!(value, twin, 1e-3 * 32.0, "{isa:?} {i}");
            }
            check::model::model(&plane, 3).unwrap_or_else(|e| panic!("{isa:?}: {e}"));
        }
    }

    #[test]
    fn bent_and_weakened_light_is_refused_with_the_reason() {
        let glass = Cylinder::new(2.0, 2.2, 1.58);
        let matched = IndexMatched { radius_mm: 2.0 };
        let pixels = PatternGrid::full_turn(3, 0.0, 1, 9, 0.2);
        let grid = VolumeGrid::centered([1, 5, 5], 0.2);
        let mut light = Light::new(pixels, Resin::pure_radon(1.5));
        let refused = |vial: &dyn tomolith_optics::vial::Vial, light: &Light| {
            Parallel::under(
                vial,
                vec![light.clone()],
                Kernel::Strip,
                grid.clone(),
                &Work::new(),
            )
            .err()
            .map(|e| e.to_string())
            .unwrap_or_default()
        };
        assert!(refused(&glass, &light).contains("this vial refracts"));
        light.resin = Resin::absorbing(1.5, 0.1);
        assert!(refused(&matched, &light).contains("this resin absorbs"));
        light.resin = Resin::pure_radon(1.5);
        assert_eq!(refused(&matched, &light), "");
    }
}
