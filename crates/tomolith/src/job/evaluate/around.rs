//! The resin around the voxels of a job: whether it solidifies, of which no number of the print knows.
//!
//! Light passes the resin between wall and part before it is weakened. Where that is deep, the wall solidifies first: a gear of 3 mm in a vial of 7.6 mm radius has an IoU of
//! 0.998 on the voxels around it at 0.3, 0.45 and 0.6 per mm, and at the wall 0.68, 1.9 and 5.6 times the dose at which it gels.
//!
//! **Method** Dose of the written patterns, the vial standing, in cubes of a sixty-fourth of the vial's width over the height of the job's voxels; those within the box of the job do not count. Of light that is scattered, what is not: less than all.
//! Patterns that were not optimized for the part may light any height and place: of these the cubes reach over all rows of pixels, in any resin.
//! **Limits** Not looked at: resin that weakens light by less than e^1.5 from the wall to the middle where patterns were optimized for the part, coherent light, stored models, gray targets, patterns that differ from turn to turn. What is finer than the voxels is averaged.

use super::SpeciesPrint;
use crate::error::Result;
use crate::grid::{Patterns, VolumeGrid};
use crate::job::dose::doses::{Doses, Exposed, unscattered};
use crate::job::resolve::ResolvedJob;
use crate::models::Work;
use crate::optics::light::Light;
use crate::report::number::significant;

/// Voxels across the vial.
const ACROSS: usize = 64;

/// Solid voxels from which on there is something.
const LEAST: usize = 4;

/// Lengths of attenuation from the wall to the middle of the vial up to which a wall gets less dose than a part within it.
const CLEAR: f64 = 1.5;

/// Resin around the voxels of a print that solidifies.
pub(crate) struct Around {
    /// The most dose there, in those at which the part gels.
    times: f64,
    /// How far from the axis, and at which height, mm.
    from_axis_mm: f64,
    z_mm: f64,
    /// Whether the resin takes so much light that a wall gets more than a part within it.
    is_deep: bool,
    /// Radius of the resin, mm.
    radius_mm: f64,
}

/// Whether resin around the voxels of a print solidifies, and where most; `is_given`: the patterns were not optimized here.
pub(super) fn of_resin(
    job: &ResolvedJob,
    shown: &[Patterns],
    prints: &[SpeciesPrint],
    is_given: bool,
    work: &Work,
) -> Result<Option<Around>> {
    let optics = &job.optics;
    let is_stored = |family: &crate::models::Family| family.capabilities().is_stored;
    if job.schedule().is_some_and(|given| given.own_patterns)
        || optics.model.as_ref().is_some_and(is_stored)
    {
        return Ok(None);
    }
    let radius = optics.vial.resin_wall().inscribed_radius();
    let is_clear =
        |light: &Light| light.map.is_none() && light.resin.attenuation_per_mm * radius < CLEAR;
    let is_deep = !optics.lights.iter().all(is_clear);
    if !is_deep && !is_given {
        return Ok(None);
    }
    let [low, high] = job.grid.bounds_mm().map(|corner| corner[2]);
    let heights = match is_given {
        true => lit_heights(&optics.lights, [low, high]),
        false => [low, high],
    };
    let grid = across(heights, radius);
    let around = places(&grid, &job.grid, radius);
    if around.len() < LEAST {
        return Ok(None);
    }
    let found = if optics.scene().scatters() {
        unscattered(job, &grid, shown, &work.aside())
    } else {
        let mut doses = Doses::new(job, optics);
        doses.will_show(&[shown]);
        let exposed = Exposed::new(&grid, optics.lights_standing());
        let found = doses.of(&exposed, shown, &work.aside());
        found.map(|(doses, _)| doses)
    };
    work.check()?;
    // Voxels of this size may be too coarse for a model
    let Ok(doses) = found else {
        return Ok(None);
    };
    let each = job.species.iter().zip(prints).zip(&doses);
    let of_species = |((species, print), dose): ((_, &SpeciesPrint), &crate::grid::Volume<f32>)| {
        let species: &crate::job::resolve::Species = species;
        let threshold = print.evaluation.gel_threshold?;
        let gels = species.goal.response.as_ref().inverse(threshold as f32);
        let solid = around.iter().filter(|&&i| dose.values[i] > gels);
        let most = |most: Option<usize>, &i: &usize| {
            most.filter(|&other| dose.values[other] >= dose.values[i])
                .or(Some(i))
        };
        let is_solid = !print.fine.target.gray && solid.clone().count() >= LEAST;
        let at = solid.fold(None, most).filter(|_| is_solid)?;
        Some((at, f64::from(dose.values[at] / gels)))
    };
    let worst = each
        .filter_map(of_species)
        .max_by(|a, b| a.1.total_cmp(&b.1));
    Ok(worst.map(|(at, times)| {
        let [x, y, z] = grid.middle(at);
        Around {
            times,
            from_axis_mm: x.hypot(y),
            z_mm: z,
            // Above and below the part no wall is to blame
            is_deep: is_deep && (low..high).contains(&z),
            radius_mm: radius,
        }
    }))
}

impl Around {
    /// In one sentence, for what speaks of the print.
    pub(crate) fn sentence(&self) -> String {
        format!(
            "Outside the voxels of this job resin gets {} times the dose at which the part gels, and solidifies: the numbers of this print leave that out.",
            significant(self.times, 2)
        )
    }

    pub(super) fn warning(&self) -> String {
        if !self.is_deep {
            return format!(
                "resin around the voxels of this job solidifies: {} mm from the axis at z = {} mm it gets {} times the dose at which the part gels, and the numbers of this print \
                 leave it out. These patterns light more than the part: voxels across the vial and over all rows of pixels (grid.shape) show what they print",
                significant(self.from_axis_mm, 2),
                significant(self.z_mm, 2),
                significant(self.times, 2),
            );
        }
        format!(
            "resin around the voxels of this job solidifies: {} mm from the axis it gets {} times the dose at which the part gels, and the numbers of this print leave it out. \
             Use a resin that absorbs less (with resin.absorption_per_mm = {} light falls to 1/e from the wall to the middle), or a vial no wider than the part needs; \
             voxels across the vial (grid.shape) show where",
            significant(self.from_axis_mm, 2),
            significant(self.times, 2),
            significant(1.0 / self.radius_mm, 2),
        )
    }
}

/// From the lowest to the highest of these heights and of the rows of pixels, mm.
fn lit_heights(lights: &[Light], [low, high]: [f64; 2]) -> [f64; 2] {
    let rows = lights.iter().map(|light| {
        let half = light.pixels.rows as f64 * light.pixels.pitch_mm[1] / 2.0;
        [-half, half].map(|edge| light.pixels.offset_mm[1] + edge)
    });
    rows.fold([low, high], |[low, high], [bottom, top]| {
        [low.min(bottom), high.max(top)]
    })
}

/// Cubes across a vial, over some heights.
fn across([low, high]: [f64; 2], radius: f64) -> VolumeGrid {
    let pitch_mm = 2.0 * radius / ACROSS as f64;
    let slices = ((high - low) / pitch_mm).round().max(1.0) as usize;
    VolumeGrid {
        shape: [slices, ACROSS, ACROSS],
        pitch_mm,
        height_mm: pitch_mm,
        center_mm: [0.0, 0.0, f64::midpoint(low, high)],
    }
}

/// The voxels that lie in the resin as a whole, and not in the box of the job.
fn places(grid: &VolumeGrid, job: &VolumeGrid, radius: f64) -> Vec<usize> {
    let [low, high] = job.bounds_mm();
    let edge = grid.pitch_mm;
    let is_around = |&i: &usize| {
        let at = grid.middle(i);
        let is_inside = (0..3).all(|k| at[k] > low[k] - edge && at[k] < high[k] + edge);
        !is_inside && at[0].hypot(at[1]) < radius - edge
    };
    (0..grid.len()).filter(is_around).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::evaluate::{Origin, evaluate_patterns};
    use crate::job::progress::Silent;
    use crate::job::tests::job_of;

    #[test]
    fn a_wall_that_solidifies_before_the_part_is_a_warning() {
        let text = r#"
            target = { phantom = { cylinder = {} }, size_mm = 1.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
            vial = { index_matched = { radius_mm = 4.0 } }
            evaluate = { refine = 1, sub_angles = 1 }
            light = [{ pixels = [12, 14], angles = 40, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        "#;
        let warnings = |changes: &[&str]| {
            let job = ResolvedJob::under(&job_of(text, changes), &Work::new()).unwrap();
            let mut patterns = Patterns::dark(job.optics.lights[0].pixels.clone());
            patterns.values.fill(1.0);
            let (shown, run) = ([patterns], Work::new());
            let voxels = job.own_voxels(&run).unwrap();
            let printed =
                evaluate_patterns(&job, voxels, &shown, Origin::default(), &mut Silent, &run);
            let around = |text: &&String| text.starts_with("resin around the voxels");
            printed
                .unwrap()
                .warnings
                .into_iter()
                .filter(|text| around(&text))
                .collect::<Vec<_>>()
        };
        assert_eq!(warnings(&[]), [""; 0]);
        // Even light of twice the width, or of twice the height of the part
        for pixels in ["light[0].pixels=[24, 14]", "light[0].pixels=[12, 28]"] {
            tomolith_core::contains!(
                warnings(&[pixels])[0],
                "These patterns light more than the part"
            );
        }
        let deep = warnings(&["resin.absorption_per_mm=1.5"]);
        // Even light over 1.2 mm has e^(1.5·3.4) = 164 times as much power at 3.9 mm as at 0.5 mm, on a circle 7.8 times as long
        tomolith_core::contains!(
            deep[0],
            "mm from the axis it gets",
            "with resin.absorption_per_mm = 0.25"
        );
        // So does light that is no sheet, or is scattered
        for light in [
            "light[0].projector={ diverging = { pixel_pitch_mm = 0.1, distance_mm = 60.0 } }",
            "resin.scattering_per_mm=0.2",
        ] {
            let found = warnings(&["resin.absorption_per_mm=1.5", light]);
            assert_eq!(found.len(), 1, "{light}");
        }
        // Voxels across the vial see it themselves
        let seen = [
            "resin.absorption_per_mm=1.5",
            "grid={ shape = [84, 84, 14], pitch_mm = 0.1 }",
        ];
        assert_eq!(warnings(&seen), [""; 0]);
    }
}
