//! Which heights of the resin a light reaches on every side, after refraction.
//!
//! **Model** The rays of the field's lower and upper edge are traced through the vial, across all of the field. A voxel at the distance ρ from the axis
//! goes round in a circle: every frame lights it where it stays above all of the lower rays, and below all of the upper ones, on the disc of radius ρ.
//!
//! **Equation** A round vial of outer radius R and one index n, tilted by τ in surroundings of index n₀: light of the height v in the field
//! passes the axis at z = v/cos τ + R·(tan τ − tan τ′) with n·sin τ′ = n₀·sin τ. A vial in air lifts light from above: by 1.09 mm at
//! τ = 20°, n = 1.47, R = 8.75 mm.
//!
//! **Limits** Light through the middle of an aperture, without bodies in its way.

use super::field::{field_mm, is_cut_along_axis};
use super::of_part;
use crate::grid::Volume;
use crate::job::resolve::optics::Optics;
use crate::optics::projector::Ray;
use crate::optics::space::{SpaceTracer, TraceLimits};
use crate::report::number::significant;
use crate::units::concise;
use std::f64::consts::TAU;
use tomolith_core::parallel::{InParallel, table};

/// Rays across the field, an odd number: one of them passes the axis.
const ACROSS: usize = 17;
/// Azimuths from which a vial is looked at that is not round, or does not stand on the rotation axis.
const AZIMUTHS: usize = 16;
/// Distances from the axis that are tabulated.
const DISTANCES: usize = 256;
/// Rays pass the axis where they are so much farther from it than at their nearest, mm: rounding.
const NEAR: f64 = 1e-9;
/// Heights of light that ends nowhere.
const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// A straight piece of an edge ray in the resin, mm.
#[derive(Clone, Copy, Debug)]
struct Piece {
    ray: Ray,
    length: f64,
}

impl Piece {
    /// How far along it passes nearest to the axis, and how near, mm; None where it is parallel to the axis.
    fn nearest(&self) -> Option<[f64; 2]> {
        let ([x, y, _], [dx, dy, _]) = (self.ray.from, self.ray.direction);
        let level = dx * dx + dy * dy;
        let along = -(x * dx + y * dy) / level;
        let [x, y, _] = self.ray.at(along);
        (level > 0.0).then(|| [along, x.hypot(y)])
    }

    /// Heights of its ends within a distance of the axis; None where it passes farther out.
    fn within(&self, distance: f64) -> Option<[f64; 2]> {
        let ([_, _, z], [dx, dy, dz]) = (self.ray.from, self.ray.direction);
        let [middle, nearest] = self.nearest()?;
        let half = ((distance - nearest) * (distance + nearest)).sqrt() / dx.hypot(dy);
        let [from, to] = [(middle - half).max(0.0), (middle + half).min(self.length)];
        (nearest <= distance && from <= to).then(|| [from, to].map(|along| z + along * dz))
    }

    /// Its least distance from the axis, mm.
    fn distance(&self) -> f64 {
        self.nearest().map_or(f64::INFINITY, |[along, _]| {
            let [x, y, _] = self.ray.at(along.clamp(0.0, self.length));
            x.hypot(y)
        })
    }
}

/// The heights that a light reaches.
#[derive(Debug)]
pub(crate) struct LitHeights {
    /// Where its lowest and its highest ray pass the axis, mm.
    pub(crate) on_axis: [f64; 2],
    /// Pieces of the rays of both edges.
    edges: [Vec<Piece>; 2],
}

impl LitHeights {
    /// Lowest and highest height lit on every side up to a distance from the axis, mm; no end where no ray of that edge comes so near.
    pub(crate) fn within(&self, distance: f64) -> [f64; 2] {
        let ends = |edge: usize| {
            let pieces = self.edges[edge].iter();
            pieces.filter_map(move |piece| piece.within(distance))
        };
        [
            ends(0)
                .flatten()
                .fold(f64::NEG_INFINITY, |highest, z| highest.max(z)),
            ends(1)
                .flatten()
                .fold(f64::INFINITY, |lowest, z| lowest.min(z)),
        ]
    }
}

/// What of a part lies above or below a light.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Missed {
    pub(crate) light: usize,
    /// Share of the part's voxels that it does not reach on every side.
    pub(crate) share: f64,
    /// What would reach them.
    pub(crate) remedy: Remedy,
    /// Why the field is not where it seems to be.
    because: String,
}

impl Missed {
    pub(crate) fn warning(&self) -> String {
        format!(
            "light[{}] passes above or below {} % of the part, which is not lit from all sides{}; use {}",
            self.light,
            significant(100.0 * self.share, 3),
            self.because,
            self.remedy.advice
        )
    }
}

/// The key of a light that moves its field along the axis, and how.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Remedy {
    /// Which key of the light: `offset_mm`, `pixels` or `selection`.
    pub(crate) key: &'static str,
    /// What to do with it.
    pub(crate) verb: &'static str,
    pub(crate) advice: String,
}

impl Optics {
    /// The heights that a light reaches.
    pub(crate) fn lit_heights(&self, light: usize) -> LitHeights {
        let [low, high] = field_mm(&self.lights[light]);
        let outer = self.vial.outer_radius_mm();
        let across = [low[0].max(-outer), high[0].min(outer)];
        let middle = 0f64.clamp(across[0].min(across[1]), across[1]);
        let mut us: Vec<f64> = (0..ACROSS)
            .map(|i| across[0] + (across[1] - across[0]) * i as f64 / (ACROSS - 1) as f64)
            .collect();
        us.push(middle);
        let traced = |v: f64| -> Vec<Vec<Piece>> {
            us.iter().map(|&u| self.edge_ray(light, [u, v])).collect()
        };
        let edges = [low[1], high[1]].map(traced);
        let on_axis = std::array::from_fn(|edge| {
            let [lowest, highest] = edges[edge].last().map_or(EVERYWHERE, |ray| at_axis(ray));
            [lowest, highest][edge]
        });
        LitHeights {
            on_axis,
            edges: edges.map(|rays| rays.into_iter().flatten().collect()),
        }
    }

    /// The pieces in resin of the ray from a point of the field, mm, in all frames that differ.
    fn edge_ray(&self, light: usize, point: [f64; 2]) -> Vec<Piece> {
        let (light, path) = (&self.lights[light], &self.paths[light]);
        let tracer = SpaceTracer::new(
            self.vial.as_ref(),
            light.resin,
            light.surrounding_index,
            light.polarization,
            TraceLimits::default(),
        );
        let frames = match self.vial.is_round() && path.motion.is_symmetric() {
            true => 1,
            false => AZIMUTHS,
        };
        let ray = path.projector.ray(point, [0.0; 2]);
        let from = |i: usize| {
            let azimuth = TAU * i as f64 / frames as f64;
            tracer.segments(path.motion.seen_from_vial(ray, azimuth), None)
        };
        let segments = (0..frames).flat_map(from);
        segments
            .map(|segment| Piece {
                ray: segment.ray,
                length: segment.length,
            })
            .collect()
    }

    /// What of a part on voxels a light passes above or below: of the light that misses most; None where nothing.
    pub(crate) fn missed(&self, inside: &Volume<f32>, gray: bool) -> Option<Missed> {
        let missed = (0..self.lights.len()).filter_map(|i| self.missed_by(i, inside, gray));
        missed.max_by(|a, b| a.share.total_cmp(&b.share))
    }

    fn missed_by(&self, light: usize, inside: &Volume<f32>, gray: bool) -> Option<Missed> {
        let lit = self.lit_heights(light);
        let grid = &inside.grid;
        let [_, ny, nx] = grid.shape;
        let [low, high] = grid.bounds_mm();
        let farthest = f64::hypot(high[0].max(-low[0]), high[1].max(-low[1]));
        let step = farthest / (DISTANCES - 1) as f64;
        let by_distance = table(DISTANCES, |i| lit.within(i as f64 * step));
        let places = table(nx * ny, |i| {
            let distance = grid.x(i % nx).hypot(grid.y(i / nx));
            ((distance / step).ceil() as usize).min(DISTANCES - 1)
        });
        let of_slice = |(iz, inside): (usize, &[f32])| {
            let z = grid.z(iz);
            let mut found = Beyond::default();
            for &place in of_part(inside, &places, nx, gray) {
                found.add(z, by_distance[place]);
            }
            found
        };
        let slices = inside.values.chunks((nx * ny).max(1)).enumerate();
        let found = (slices.par_map(of_slice).into_iter()).fold(Beyond::default(), Beyond::with);
        let half = grid.height_mm / 2.0;
        (found.beyond > 0).then(|| Missed {
            light,
            share: found.beyond as f64 / found.part as f64,
            remedy: self.remedy(light, found.short_mm.map(|mm| mm + half)),
            because: self.because(),
        })
    }

    /// Why light does not pass where its field is.
    pub(crate) fn because(&self) -> String {
        match self.tilt_rad() {
            0.0 => String::new(),
            tilt => format!(
                " (the axis is tilted by {}°, and light bends at the walls)",
                significant(tilt.abs().to_degrees(), 3)
            ),
        }
    }

    /// What brings a light to heights that lie so far, mm, below and above those that it reaches; less than 0: it reaches farther.
    pub(crate) fn remedy(&self, i: usize, short_mm: [f64; 2]) -> Remedy {
        let light = &self.lights[i];
        // Seen by the projector, a height is as much smaller as the axis leans
        let [below, above] = short_mm.map(|mm| mm * self.tilt_rad().cos());
        let key = format!("light[{i}]");
        let [u, v] = light.pixels.offset_mm;
        if is_cut_along_axis(light) {
            return Remedy {
                key: "selection",
                verb: "change",
                advice: format!(
                    "more rows: {key}.selection or a map of the printer leaves some dark"
                ),
            };
        }
        let pitch = light.pixels.pitch_mm[1];
        let more = ((below + above).max(0.0) / pitch).ceil();
        let room = (more * pitch - below - above) / 2.0;
        let shift = (above - below) / 2.0;
        let offset = format!(
            "{key}.offset_mm = [{}, {}]",
            concise(u),
            rounded(v + shift, room)
        );
        let rows = light.pixels.rows as f64 + more;
        match (more > 0.0, shift.abs() <= room) {
            (true, true) => Remedy {
                key: "pixels",
                verb: "raise",
                advice: format!("at least {rows} rows in {key}.pixels"),
            },
            (true, false) => Remedy {
                key: "pixels",
                verb: "raise",
                advice: format!("at least {rows} rows in {key}.pixels, with {offset}"),
            },
            (false, _) => Remedy {
                key: "offset_mm",
                verb: "change",
                advice: offset,
            },
        }
    }
}

/// Voxels of a part that light misses.
#[derive(Clone, Copy)]
struct Beyond {
    part: u64,
    beyond: u64,
    /// How far below and above the light they lie at most, mm.
    short_mm: [f64; 2],
}

impl Default for Beyond {
    fn default() -> Self {
        Beyond {
            part: 0,
            beyond: 0,
            short_mm: [f64::NEG_INFINITY; 2],
        }
    }
}

impl Beyond {
    /// Counts a voxel at a height, of a place that is lit between two.
    fn add(&mut self, z: f64, [low, high]: [f64; 2]) {
        self.part += 1;
        self.beyond += u64::from(z < low || z > high);
        self.short_mm = [
            self.short_mm[0].max(low - z),
            self.short_mm[1].max(z - high),
        ];
    }

    fn with(self, other: Self) -> Self {
        Beyond {
            part: self.part + other.part,
            beyond: self.beyond + other.beyond,
            short_mm: std::array::from_fn(|i| self.short_mm[i].max(other.short_mm[i])),
        }
    }
}

/// Lowest and highest height of a ray where it passes the axis.
fn at_axis(ray: &[Piece]) -> [f64; 2] {
    let nearest = ray
        .iter()
        .map(Piece::distance)
        .fold(f64::INFINITY, f64::min);
    let ends = ray.iter().filter_map(|piece| piece.within(nearest + NEAR));
    let found = ends.flatten().fold(None, |found: Option<[f64; 2]>, z| {
        Some(found.map_or([z; 2], |[low, high]| [low.min(z), high.max(z)]))
    });
    found.unwrap_or(EVERYWHERE)
}

/// A length with as few decimals as leave it within so much of what it is.
fn rounded(mm: f64, room: f64) -> String {
    let to = |decimals: i32| {
        let ten = 10f64.powi(decimals);
        (mm * ten).round() / ten
    };
    let short = (1..6).map(to).find(|short| (short - mm).abs() <= room);
    concise(short.unwrap_or(mm))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::VolumeGrid;
    use crate::job::resolve::optics::tests::spec;
    use std::path::Path;

    fn optics(changes: &[&str]) -> Optics {
        Optics::new(&spec(changes), Path::new("")).unwrap()
    }

    /// A vial of 8.75 mm, glass and resin of one index in air.
    const VIAL: &str = "vial={ cylinder = { inner_radius_mm = 8.0, outer_radius_mm = 8.75, refractive_index = 1.47 } }";
    const INDEX: &str = "resin.refractive_index=1.47";

    #[test]
    fn a_vial_lifts_light_from_above_by_what_snell_says() {
        for tilt in [0f64, 20.0, 60.0, -20.0] {
            let tilted = format!("motion.tilt_deg={tilt:?}");
            let lit = optics(&[VIAL, INDEX, &tilted]).lit_heights(0);
            let (sin, cos) = tilt.to_radians().sin_cos();
            let bent = (sin / 1.47).asin().tan();
            let lifted = 8.75 * (sin / cos - bent);
            // 64 rows of 0.05 mm reach 1.6 mm up and down in the field
            for (found, v) in lit.on_axis.into_iter().zip([-1.6, 1.6]) {
                assert!((found - (v / cos + lifted)).abs() < 1e-9, "{tilt}: {found}");
            }
            // A ray at the distance u from the axis enters at √(R² − u²) and passes the axis at u·cos τ/√(n² − sin² τ) (Bouguer's invariant); heights where it is
            // 2 mm before and behind the axis
            let across = (1.47f64.powi(2) - sin * sin).sqrt();
            let heights = |u: f64, v: f64| {
                let [entry, nearest] = [8.75f64.powi(2) - u * u, (u * cos / across).powi(2)];
                let inside = (8.75f64.powi(2) - nearest).sqrt();
                let half = (4.0 - nearest).sqrt();
                let z = |level: f64| v / cos + entry.sqrt() * sin / cos - level * bent;
                [z(inside - half), z(inside + half)]
            };
            let at = |i: usize, v: f64| heights(3.2 * (i as f64 / 8.0 - 1.0), v);
            let all = |v: f64| {
                (0..ACROSS)
                    .flat_map(move |i| at(i, v))
                    .filter(|z| z.is_finite())
            };
            let [low, high] = lit.within(2.0);
            let [bottom, top] = [
                all(-1.6).fold(-99.0, f64::max),
                all(1.6).fold(99.0, f64::min),
            ];
            assert!((low - bottom).abs() < 1e-9, "{tilt}: {low} {bottom}");
            assert!((high - top).abs() < 1e-9, "{tilt}: {high} {top}");
        }
    }

    #[test]
    fn light_through_water_of_its_index_is_not_lifted() {
        let matched = "vial={ index_matched = { radius_mm = 6.0 } }";
        let lit = optics(&[matched, "motion.tilt_deg=30"]).lit_heights(0);
        let (sin, cos) = 30f64.to_radians().sin_cos();
        assert!((lit.on_axis[1] - 1.6 / cos).abs() < 1e-9);
        let expected = (1.6 - 2.0 * sin) / cos;
        assert!((lit.within(2.0)[1] - expected).abs() < 1e-9);
    }

    #[test]
    fn what_is_missed_is_counted_and_the_remedy_reaches_it() {
        // A disc of 2 mm of voxels of 0.1 mm, ±0.5 mm high
        let grid = VolumeGrid::centered([10, 40, 40], 0.1);
        let part = Volume::from_fn(grid, |[x, y, _]| f32::from(x.hypot(y) < 2.0));
        let missed = |changes: &[&str]| {
            let all = [&[VIAL, INDEX][..], changes].concat();
            optics(&all).missed(&part, false)
        };
        assert_eq!(missed(&[]), None);
        let found = missed(&["motion.tilt_deg=20"]).unwrap();
        assert!(found.share > 0.1, "{found:?}");
        assert_eq!(
            (found.remedy.key, found.remedy.verb),
            ("offset_mm", "change")
        );
        let warning = found.warning();
        assert!(warning.contains("light[0].offset_mm = [0, -1"), "{warning}");
        let moved = warning
            .rsplit_once("use light[0].")
            .unwrap()
            .1
            .replace(' ', "");
        let moved = format!("light.{moved}");
        assert_eq!(missed(&["motion.tilt_deg=20", &moved]), None, "{moved}");
        // Too few rows for any offset
        let few = ["motion.tilt_deg=20", "light.pixels=[128, 24]"];
        let found = missed(&few).unwrap();
        assert_eq!((found.remedy.key, found.remedy.verb), ("pixels", "raise"));
        let warning = found.warning();
        let words: Vec<&str> = warning.split(' ').collect();
        let rows = words[words.iter().position(|word| *word == "rows").unwrap() - 1];
        let offset = warning.rsplit_once("offset_mm = ").unwrap().1;
        let pixels = format!("light.pixels=[128, {rows}]");
        let offset = format!("light.offset_mm={offset}");
        assert_eq!(missed(&["motion.tilt_deg=20", &pixels, &offset]), None);
        // Rows that may not be lit
        let cut = ["motion.tilt_deg=20", "light.selection.rows=[20, 24]"];
        assert_eq!(missed(&cut).unwrap().remedy.key, "selection");
    }
}
