//! How far from the axis light reaches on every side, and what of a part lies beyond; [`along_axis`] has the same along the axis.

pub(crate) mod along_axis;
pub(crate) mod field;

use super::compatibility::is_part;
use super::optics::Optics;
use super::reach::field::{field_mm, is_cut_sideways};
use crate::grid::Volume;
use crate::optics::light::Light;
use crate::report::number::significant;
use crate::target::Shape;
use crate::units::concise;
use tomolith_core::parallel::{InParallel, table};

/// What of a part lies beyond the reach of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unreached {
    pub(crate) light: usize,
    /// Distance from the axis up to which it is tangent on every side, mm. 0: it lights one side of the axis.
    pub(crate) reach_mm: f64,
    /// That of the part's farthest voxel.
    pub(crate) farthest_mm: f64,
    /// Share of the part's voxels that lie beyond.
    pub(crate) share: f64,
    pub(crate) ended_by: EndedBy,
}

/// What ends the reach of a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EndedBy {
    /// The number of its pixels.
    Pixels,
    /// An offset, a selection or a map of the printer.
    Cut,
    /// The vial: what passes nearest to its wall is bent so far inward.
    Vial,
}

impl EndedBy {
    fn of_field(light: &Light) -> Self {
        match is_cut_sideways(light) {
            true => EndedBy::Cut,
            false => EndedBy::Pixels,
        }
    }

    /// What is to be done with it.
    pub(crate) fn verb(self) -> &'static str {
        match self {
            EndedBy::Pixels => "raise",
            EndedBy::Cut => "change",
            EndedBy::Vial => "widen",
        }
    }
}

impl Unreached {
    pub(crate) fn warning(self) -> String {
        let Self {
            light,
            reach_mm,
            farthest_mm,
            share,
            ended_by,
        } = self;
        let times = (100.0 * farthest_mm / reach_mm - 1e-6).ceil() / 100.0;
        let times = significant(times, 3);
        let advice = match ended_by {
            _ if reach_mm <= 0.0 => "what it lights lies off the axis: use a smaller `offset_mm`, or more columns in `pixels` or `selection`".to_owned(),
            EndedBy::Cut => "`offset_mm`, `selection` or a map of the printer cut its field: leave it wider".to_owned(),
            EndedBy::Pixels => format!("use {times} times as many columns in `pixels`"),
            EndedBy::Vial => format!("no pixel gets farther through this vial: use one that is {times} times as wide, or a bath (`vial.surrounding_index`) whose index is nearer to the resin's"),
        };
        format!(
            "after refraction, light[{light}] reaches only {} mm from the axis on every side, the part {} mm: {:.1} % of the \
             part lies outside and is not lit from all sides; {advice}",
            concise(reach_mm),
            concise(farthest_mm),
            100.0 * share,
        )
    }
}

/// What is known of the places of a slice, in those of its voxels that belong to a part. Most rows of `nx` voxels hold none.
fn of_part<'a, T>(
    inside: &'a [f32],
    of_places: &'a [T],
    nx: usize,
    gray: bool,
) -> impl Iterator<Item = &'a T> {
    let rows = inside.chunks(nx.max(1)).zip(of_places.chunks(nx.max(1)));
    let is_own = move |&inside: &f32| is_part(inside, gray);
    let rows = rows.filter(move |(inside, _)| inside.iter().any(is_own));
    let pairs = rows.flat_map(|(inside, of_places)| inside.iter().zip(of_places));
    pairs.filter_map(move |(inside, of_place)| is_own(inside).then_some(of_place))
}

impl Optics {
    /// What of a part on voxels no light that ends there reaches on every side; None where nothing.
    pub(crate) fn unreached(&self, inside: &Volume<f32>, gray: bool) -> Option<Unreached> {
        let grid = &inside.grid;
        let [_, ny, nx] = grid.shape;
        let (reach_mm, light) = self.reach_mm();
        let radii = table(nx * ny, |i| grid.x(i % nx).hypot(grid.y(i / nx)));
        let of_slice = |inside: &[f32]| {
            let [mut part, mut beyond] = [0u64; 2];
            let mut farthest = 0.0f64;
            for &radius in of_part(inside, &radii, nx, gray) {
                part += 1;
                beyond += u64::from(radius > reach_mm);
                farthest = farthest.max(radius);
            }
            (part, beyond, farthest)
        };
        let slices = inside.values.chunks((nx * ny).max(1)).par_map(of_slice);
        let (part, beyond, farthest_mm) = slices
            .into_iter()
            .fold((0, 0, 0.0f64), |a, b| (a.0 + b.0, a.1 + b.1, a.2.max(b.2)));
        (beyond > 0).then(|| Unreached {
            light,
            reach_mm,
            farthest_mm,
            share: beyond as f64 / part as f64,
            ended_by: self.ended_by(light, reach_mm),
        })
    }

    /// A part that turns out of the field of a light, because the vial stands off the rotation axis or the axis runs out: as a share, that of
    /// the distance from the axis.
    pub(crate) fn unreached_moving(&self, shape: &dyn Shape) -> Option<Unreached> {
        let motion = self.paths.first()?.motion;
        let [low, high] = shape.bounds_mm();
        // A shape touches every face of its box, so some of it goes round as far from the axis as that face
        let out = |[x, y]: [f64; 2]| {
            let faces = [(0, x), (1, y)].map(|(i, by)| (high[i] + by).max(-low[i] - by));
            faces.into_iter().fold(0.0, f64::max)
        };
        let farthest_mm = out(motion.offset_mm) + motion.axis_runout_mm;
        let end = |light: &Light| {
            let field = field_mm(light);
            field[1][0].max(-field[0][0])
        };
        let ends = self.lights.iter().map(end).enumerate();
        let (light, reach_mm) = ends.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let is_beyond = farthest_mm > out([0.0; 2]) && farthest_mm > reach_mm * (1.0 + 1e-9);
        is_beyond.then(|| Unreached {
            light,
            reach_mm,
            farthest_mm,
            share: 1.0 - reach_mm.max(0.0) / farthest_mm,
            ended_by: EndedBy::of_field(&self.lights[light]),
        })
    }

    /// Warns of it.
    pub(crate) fn moved_away(&self, shape: &dyn Shape) -> Option<String> {
        let Unreached {
            light,
            reach_mm,
            farthest_mm,
            ..
        } = self.unreached_moving(shape)?;
        Some(format!(
            "motion.offset_mm and motion.axis_runout_mm take the part up to {} mm from the rotation axis, but the \
             field of light[{light}] ends at {} mm: in some frames what lies beyond gets no light; use more columns in \
             light[{light}].pixels, or move the vial less",
            concise(farthest_mm),
            concise(reach_mm),
        ))
    }

    /// Distance from the axis up to which every light is tangent, mm, and the light that ends there.
    ///
    /// Seen along the axis, tilted light is bent as if both indices were those of their parts across it: n·sin of the angle
    /// to the plane is the same outside and inside.
    pub(crate) fn reach_mm(&self) -> (f64, usize) {
        let reach = |(i, light): (usize, &Light)| {
            let [low, high] = field_mm(light);
            (self.reach_of(light, high[0].min(-low[0]).max(0.0)), i)
        };
        let reaches = self.lights.iter().enumerate().map(reach);
        reaches.fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a })
    }

    /// That of a light whose field reached so far, mm.
    fn reach_of(&self, light: &Light, half_field: f64) -> f64 {
        let resin = light.resin.refractive_index;
        let surrounding = self.vial.surrounding_index(light.surrounding_index, resin);
        let (sin, cos) = self.tilt_rad().sin_cos();
        let across = (resin.powi(2) - (surrounding * sin).powi(2))
            .max(0.0)
            .sqrt();
        self.vial.reach_mm(half_field, surrounding * cos, across)
    }

    /// What ends this reach of a light.
    fn ended_by(&self, light: usize, reach_mm: f64) -> EndedBy {
        let light = &self.lights[light];
        match reach_mm >= self.reach_of(light, f64::INFINITY) {
            true => EndedBy::Vial,
            false => EndedBy::of_field(light),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::VolumeGrid;
    use crate::job::resolve::optics::tests::{shape, spec};
    use crate::models::rays;
    use std::path::Path;

    fn optics(changes: &[&str]) -> Optics {
        Optics::new(&spec(changes), Path::new("")).unwrap()
    }

    #[test]
    fn what_lies_beyond_the_reach_is_counted() {
        // Middles at ±0.5, ±1.5 … ±3.5 mm; 128 columns of 0.05 mm reach 3.2 mm
        let part = Volume::filled(VolumeGrid::centered([1, 8, 8], 1.0), 1.0f32);
        let beyond = |changes: &[&str]| optics(changes).unreached(&part, false);
        let vial = "vial={ index_matched = { radius_mm = 6.0 } }";
        let found = beyond(&[vial]).unwrap();
        assert!((found.reach_mm - 3.2).abs() < 1e-12 && found.light == 0);
        let near = |i: usize, j: usize| (i as f64 - 3.5).hypot(j as f64 - 3.5) <= 3.2;
        let within = (0..64).filter(|i| near(i / 8, i % 8)).count();
        assert_eq!(found.share, 1.0 - within as f64 / 64.0);
        assert!((found.farthest_mm - 3.5 * 2f64.sqrt()).abs() < 1e-12);
        tomolith_core::contains!(found.warning(), "use 1.55 times as many columns");
        assert_eq!(beyond(&[vial, "light.pixels=[200, 64]"]), None);
        let cut = beyond(&[
            vial,
            "light.pixels=[200, 64]",
            "light.selection.columns=[50, 150]",
        ])
        .unwrap();
        tomolith_core::contains!(cut.warning(), "leave it wider");
        // Light that grazes a tube of 6 mm is bent to 4 mm from its axis, however many pixels there are
        let bent = beyond(&[
            "vial={ cylinder = { inner_radius_mm = 5.5, outer_radius_mm = 6.0, refractive_index = 1.5 } }",
            "resin.refractive_index=1.5",
            "light.pixels=[400, 64]",
        ])
        .unwrap();
        tomolith_core::near!(bent.reach_mm, 4.0, 1e-9);
        tomolith_core::contains!(bent.warning(), "use one that is 1.24 times as wide");
        // A field that begins 0.1 mm from the axis
        let off_axis = beyond(&[vial, "light.offset_mm=[3.3, 0]"]).unwrap();
        assert_eq!((off_axis.reach_mm, off_axis.share), (0.0, 1.0));
        tomolith_core::contains!(off_axis.warning(), "smaller `offset_mm`");
    }

    #[test]
    fn a_part_that_turns_out_of_the_field_is_told() {
        let gear = shape(serde_json::json!({ "phantom": "gear", "size_mm": 5.0 }));
        let warned = |change: &str| optics(&[change]).moved_away(gear.as_ref());
        // The field ends at 3.2 mm, the gear reaches 2.5 mm
        for within in [
            "motion.offset_mm=[0, 0]",
            "motion.offset_mm=[0.6, 0]",
            "motion.axis_runout_mm=0.6",
        ] {
            assert_eq!(warned(within), None, "{within}");
        }
        for beyond in ["motion.offset_mm=[0, -0.8]", "motion.axis_runout_mm=0.8"] {
            let text = warned(beyond).unwrap();
            tomolith_core::contains!(text, "up to 3.3 mm", "ends at 3.2 mm");
        }
    }

    #[test]
    fn the_outermost_ray_of_a_leaning_vial_passes_the_axis_at_the_reach() {
        for tilt in ["0", "25"] {
            let spec = spec(&[&format!("motion.tilt_deg={tilt}")]);
            let optics = Optics::new(&spec, Path::new("")).unwrap();
            let job = optics.scene();
            let rays = rays::Rays::new(
                job.vial,
                optics.lights.clone(),
                job.optics,
                &rays::Params::default(),
                VolumeGrid::centered([8, 8, 8], 1.0),
            )
            .unwrap();
            // The middle of the last of 128 columns
            let (segments, _) = rays.trace(0, 0, 127, 32);
            let (from, along) = (segments[0].ray.from, segments[0].ray.direction);
            let passes = (from[0] * along[1] - from[1] * along[0]).abs() / along[0].hypot(along[1]);
            let (reach, light) = optics.reach_mm();
            tomolith_core::near!(passes, reach * 127.0 / 128.0, 1e-9, "{tilt}");
            assert_eq!(light, 0);
        }
    }
}
