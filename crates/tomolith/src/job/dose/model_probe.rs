//! A test, before any work, of whether successive orders are accurate enough for a job.
//!
//! A job that names no model takes [`successive_orders`](crate::models::successive_orders) where it covers vial and lights. How near it comes to Monte Carlo paths is known for some scenes
//! only (docs/scattering.md), so the job itself is tried: the part on a grid of at most 32 voxels along an edge, lit evenly through
//! its silhouettes. Where an error of more than 1 % of the part's mean dose is seen, or cells would be too many for a machine, Monte
//! Carlo paths are taken instead, and a line of the screen says so. The probe knows nothing of patterns, so a run, its `check` and a later `simulate` decide
//! alike. A job that names `[model.successive_orders]` gets it, and a warning from the error of its patterns.

use super::cross_check::CrossCheck;
use crate::error::{Error, Result};
use crate::grid::Patterns;
use crate::job::progress::{Event, Progress};
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::multiresolution::coarser_grid;
use crate::models::selection::contributions;
use crate::models::{ModelInput, Work};

/// Voxels along the longest edge of the probe.
const VOXELS: usize = 32;
/// Paths of each of its two estimates, about: half a second of a core.
const PATHS: usize = 100_000;

/// Takes Monte Carlo paths for a job that names no model and whose probe by orders is far off; says so.
pub(crate) fn try_orders(
    job: &mut ResolvedJob,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<()> {
    if !job.optics.scene().scatters() || job.optics.model.is_some() {
        return Ok(());
    }
    let (why, text) = match probe(job, work) {
        Err(Error::Config { key, found, .. }) if key == "model.successive_orders.cell_mm" => (
            "successive orders would need too many cells",
            format!("scattered light by Monte Carlo paths: successive orders would take {found}"),
        ),
        Err(error) => return Err(error),
        Ok(Some(found)) if found.is_far_off() => (
            "a test of successive orders was too far off",
            format!(
                "scattered light by Monte Carlo paths: in a test of successive orders it was {found}"
            ),
        ),
        Ok(_) => return Ok(()),
    };
    job.optics.probe_failed = Some(why);
    // Their windows are compared with the job's: one model for all
    for scenario in &mut job.scenarios {
        scenario.optics.probe_failed = Some(why);
    }
    progress.event(&Event::Note { text });
    Ok(())
}

fn probe(job: &ResolvedJob, work: &Work) -> Result<Option<CrossCheck>> {
    let longest = job.grid.shape.iter().copied().max();
    let grid = coarser_grid(&job.grid, longest.unwrap_or(1).div_ceil(VOXELS));
    let family = job.optics.family(&grid)?;
    if family.compared_with().is_none() {
        return Ok(None);
    }
    let voxels = &job.voxels(&grid, &Work::new())?[0];
    let lights = job.optics.lights_standing();
    let optics = job.optics.scene().lit_by(&lights);
    let straight = family.unscattered(&ModelInput::new(optics, &grid, work)?)?;
    let brought = contributions(straight.as_ref(), &voxels.wanted(), work)?;
    let lit: Vec<f32> = (brought.as_slice().iter())
        .map(|&brought| f32::from(brought > 0.0))
        .collect();
    let layouts = straight.patterns().iter();
    let silhouettes: Vec<Patterns> = layouts.map(|layout| layout.patterns_of(&lit)).collect();
    CrossCheck::of(job, voxels, &silhouettes, PATHS, work)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::resolve::optics::Optics;
    use crate::job::tests::job_of;

    /// The note on a sphere in a resin that scatters so much per mm, and whether Monte Carlo paths are taken.
    fn tried(scattering: &str, model: &str) -> (Vec<String>, bool) {
        let text = format!(
            r#"
            target = {{ phantom = {{ sphere = {{}} }}, size_mm = 2.0 }}
            grid = {{ pitch_mm = 0.1 }}
            resin = {{ refractive_index = 1.5, absorption_per_mm = 0.1, scattering_per_mm = {scattering} }}
            vial = {{ index_matched = {{ radius_mm = 4.0 }} }}
            light = [{{ pixels = [24, 24], angles = 12, projector = {{ collimated = {{ pixel_pitch_mm = 0.1 }} }} }}]
            objective = {{ threshold = {{}} }}
            {model}
            "#
        );
        let mut job = ResolvedJob::under(&job_of(&text, &[]), &Work::new()).unwrap();
        let mut notes = Vec::new();
        let mut note = |event: &Event| {
            if let Event::Note { text } = event {
                notes.push(text.clone());
            }
        };
        try_orders(&mut job, &mut note, &Work::new()).unwrap();
        let by_paths = |optics: &Optics| {
            let family = optics.family(&job.grid).unwrap();
            family.monte_carlo_paths().is_some()
        };
        // A scenario is compared with the job: by one model
        let found = by_paths(&job.optics);
        let of_scenarios = job.scenarios.iter().map(|s| by_paths(&s.optics));
        assert!(of_scenarios.into_iter().all(|scenario| scenario == found));
        (notes, found)
    }

    #[test]
    fn orders_are_taken_where_they_are_near_enough_and_monte_carlo_paths_where_cells_would_be_too_many()
     {
        assert_eq!(tried("0.2", ""), (vec![], false));
        // 8 mm across in cells of 0.2/20 mm
        let (notes, by_paths) = tried("20", "");
        assert!(
            by_paths && notes.len() == 1 && notes[0].contains("800 × 800 cells of 0.01 mm"),
            "{notes:?}"
        );
        let scenario = "scenario = [{ set = { \"resin.absorption_per_mm\" = 0.11 } }]";
        assert!(tried("20", scenario).1);
        // Whoever names a model is not second-guessed
        assert_eq!(
            tried("0.2", "model = { successive_orders = {} }"),
            (vec![], false)
        );
    }
}
