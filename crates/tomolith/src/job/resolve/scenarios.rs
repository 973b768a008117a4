//! The same patterns under scenarios: the job as it is, and the job with some keys set otherwise.
//!
//! A scenario differs from the job in what light meets or in where it comes from, so that alone is resolved again; part, voxels, patterns and objective are the job's. The
//! optimization sees all of them at once ([`scenarios`](crate::models::scenarios)), and the print of the written patterns is evaluated in each.
//!
//! **Limits** methods that minimize a loss; one species, no print in time, no coarse levels, no cells, patterns of more than five bits. Pixels
//! that cannot light the part in the job as it is stay dark.

use super::grid::bounds_of;
use super::machine;
use super::optics::Optics;
use super::refinement::{Asked, Level, levels};
use super::{family, must_be_lit};
use crate::error::{Error, Result};
use crate::grid::VolumeGrid;
use crate::job::resolve::ResolvedJob;
use crate::job::spec::scenario::{at_scenario, must_be_told_apart};
use crate::job::spec::{JobSpec, RobustOf, ScenarioSpec};
use crate::objective::Join;
use crate::units::concise;
use serde_json::{Map, Value};

/// What light meets, where that is not what the job says.
pub(crate) struct Scenario {
    pub(crate) name: String,
    /// Vial and lights.
    pub(crate) optics: Optics,
    /// What may be wrong with its light.
    pub(crate) warnings: Vec<String>,
}

/// The scenarios of a job, on its voxels.
pub(crate) fn of_job(resolved: &ResolvedJob) -> Result<Vec<Scenario>> {
    let given = &resolved.spec.scenario;
    if given.is_empty() {
        return Ok(Vec::new());
    }
    must_be_told_apart(&resolved.spec)?;
    must_fit(resolved)?;
    let scenario = |(i, spec): (usize, &ScenarioSpec)| {
        let name = spec.name.clone();
        let name = name.unwrap_or_else(|| format!("scenario {}", i + 1));
        Scenario::new(resolved, name, &spec.set).map_err(|error| at_scenario(i, spec, error))
    };
    given.iter().enumerate().map(scenario).collect()
}

impl Scenario {
    fn new(job: &ResolvedJob, name: String, set: &Map<String, Value>) -> Result<Self> {
        let spec = job.spec.changed(set, &job.base)?;
        let mut optics = Optics::with_models(&spec, &job.base, job.models)?;
        let printers = machine::printers(&spec, &job.base, &optics.lights)?;
        optics.leave_dark(printers.as_deref().unwrap_or_default());
        if spec.target.insert_shadow.unwrap_or(true) {
            optics.add_inserts(job.shape())?;
        }
        let warnings = must_be_lit(&spec, &optics, &job.species, &job.grid)?;
        must_show_the_same(job, &spec, &optics)?;
        Ok(Scenario {
            name,
            optics,
            warnings,
        })
    }
}

/// What makes a job and its scenarios share their voxels.
const OWN_VOXELS: &str = "grid.refine = 1, with which the job and its scenarios are optimized on the voxels of [grid]; or a scenario whose light the model of the job computes, too";

/// What happens where a scenario needs voxels other than the job's, and what that means.
fn other_voxels(its: Option<VolumeGrid>, jobs: Option<VolumeGrid>) -> String {
    let words = |grid: Option<VolumeGrid>| {
        grid.map_or_else(
            || "none".to_owned(),
            |grid| {
                let [nz, ny, nx] = grid.shape;
                let [pitch, height] = [grid.pitch_mm, grid.height_mm].map(concise);
                format!("{nx} × {ny} × {nz} voxels of {pitch} × {pitch} × {height} mm")
            },
        )
    };
    format!(
        "its dose model needs {}, that of the job {}; both are optimized together, which takes the same voxels",
        words(its),
        words(jobs)
    )
}

/// Refuses a scenario that shows other images, or is computed on other voxels.
fn must_show_the_same(job: &ResolvedJob, spec: &JobSpec, optics: &Optics) -> Result<()> {
    let asked = Asked {
        spec,
        method: &job.method,
        species: &job.species,
    };
    let family = family(optics, &job.species, &job.grid)?;
    let bounds_mm = bounds_of(&job.species);
    let levels = levels(asked, optics, family.as_ref(), &job.grid, bounds_mm);
    let finest = |levels: &[Level]| levels.last().map(|level| level.grid.clone());
    let (its, jobs) = (finest(&levels), finest(&job.levels));
    if its != jobs {
        // Rays want cubes, and parallel light does not
        return Err(Error::config("", other_voxels(its, jobs), OWN_VOXELS));
    }
    let images = |optics: &Optics| -> Vec<_> {
        let lights = optics.lights.iter();
        lights.map(|light| light.pixels.shape()).collect()
    };
    if images(optics) == images(&job.optics) {
        return Ok(());
    }
    Err(Error::config(
        "light",
        "another number of lights, frames or pixels than the job's",
        "lights that show the job's patterns",
    ))
}

/// Refuses what does not go with scenarios.
fn must_fit(resolved: &ResolvedJob) -> Result<()> {
    let spec = &resolved.spec;
    for (key, is_there, found, accepted) in [
        (
            "species",
            !spec.species.is_empty(),
            "several species",
            "one species",
        ),
        (
            "schedule",
            spec.schedule.is_some(),
            "a print in time",
            "no [schedule]",
        ),
        (
            "multiresolution",
            spec.multiresolution.is_some(),
            "coarse levels",
            "no [multiresolution]",
        ),
        (
            "objective",
            resolved.first().has_cells,
            "voxels cut into cells",
            "surface = \"fraction\" or \"voxel\"",
        ),
        (
            "optimizer",
            resolved.method.needs_target(),
            "a method that compares one dose with one target",
            "lbfgs, or another method that minimizes the loss",
        ),
        (
            "evaluate.levels",
            spec.evaluate.improves_levels(),
            "patterns improved on few levels",
            "\"rounded\"",
        ),
    ] {
        if is_there {
            return Err(Error::config(
                key,
                format!("{found}, in a job with [[scenario]]"),
                accepted,
            ));
        }
    }
    Ok(())
}

/// Warns of a worst case without cases.
pub(crate) fn worst_of_one(spec: &JobSpec) -> Option<String> {
    (spec.robust.of == RobustOf::Worst && spec.scenario.is_empty()).then(|| {
        "robust.of = \"worst\" changes nothing without a [[scenario]]: add one, or leave it out"
            .to_owned()
    })
}

/// How the losses of the scenarios become one.
pub(crate) fn join(job: &ResolvedJob) -> Join {
    match job.spec.robust.of {
        _ if job.scenarios.is_empty() => Join::Sum,
        RobustOf::Mean => Join::Mean,
        RobustOf::Worst => Join::Worst,
    }
}

/// What that is called.
pub(crate) fn name_of_join(job: &ResolvedJob) -> &'static str {
    job.spec.robust.of.name()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::job::resolve::optics::tests::key as key_of;
    use crate::job::tests::document_of;
    use crate::job::{Job, ResolvedJob};
    use crate::models::Work;
    use crate::objective::Objective;

    const JOB: &str = r#"
        target = { phantom = "gear", size_mm = 2.0 }
        grid = { pitch_mm = 0.1, refine = 1 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        stop = { iterations = 4 }
        [[light]]
        pixels = [28, 12]
        angles = 16
        projector.collimated = { pixel_pitch_mm = 0.1 }
    "#;

    pub(crate) fn resolved(scenarios: &[&str], changes: &[&str]) -> Result<ResolvedJob> {
        let tables = scenarios
            .iter()
            .map(|set| format!("[[scenario]]\nset = {{ {set} }}\n"));
        let text = format!("{JOB}\n{}", tables.collect::<String>());
        ResolvedJob::new(&Job::from_document(document_of(&text, changes))?)
    }

    #[test]
    fn a_scenario_that_changes_nothing_leaves_the_loss_and_one_that_absorbs_more_does_not() {
        let work = Work::new();
        let loss = |scenarios: &[&str]| {
            let task = resolved(scenarios, &[]).unwrap().task(&work).unwrap();
            let dose = crate::check::dose(&*task.model, &task.start);
            (task.model.outputs().len(), task.objective.value(&dose))
        };
        let alone = loss(&[]);
        let same = loss(&["resin.absorption_per_mm = 0.1"]);
        assert_eq!((alone.0, same.0), (1, 2));
        tomolith_core::near!(same.1, alone.1, 1e-6 * alone.1, "{same:?}, {alone:?}");
        let (outputs, other) = loss(&[
            "\"resin.absorption_per_mm\" = 0.2",
            "vial.index_matched.radius_mm = 2.1",
        ]);
        assert_eq!(outputs, 3);
        assert!(
            (other - alone.1).abs() > 1e-3 * alone.1,
            "{other}, {alone:?}"
        );
    }

    #[test]
    fn a_scenario_has_the_voxels_of_the_job_where_the_program_chooses_them() {
        // Rows of pixels outside of the part: alone, the job leaves out the slices that they light
        let finest = |scenarios: &[&str]| {
            let changes = ["grid={ pitch_mm = 0.1 }", "light[0].pixels=[28, 40]"];
            let job = resolved(scenarios, &changes).unwrap();
            job.levels.last().unwrap().grid.clone()
        };
        let together = finest(&["resin.absorption_per_mm = 0.3"]);
        let alone = finest(&[]);
        assert!(alone.shape[0] < together.shape[0] && alone.shape[1..] == together.shape[1..]);
    }

    #[test]
    fn a_scenario_may_set_a_whole_list_of_tables() {
        let light = "light = [{ pixels = [28, 12], angles = 16, offset_mm = [0.05, 0.0], projector = { collimated = { pixel_pitch_mm = 0.1 } } }]";
        let job = resolved(&[light], &[]).unwrap();
        let aside = |optics: &Optics| optics.lights[0].pixels.offset_mm[0].abs();
        assert_eq!(aside(&job.optics), 0.0);
        assert!((aside(&job.scenarios[0].optics) - 0.05).abs() < 1e-12);
    }

    #[test]
    fn light_that_misses_the_part_in_a_scenario_is_a_warning_with_its_name() {
        let found = |scenario: &str| {
            let job = resolved(&[scenario], &[]).unwrap();
            job.warnings_of(job.own_voxels(&Work::new()).unwrap())
                .unwrap()
        };
        let aside = found("\"motion.offset_mm\" = [1.5, 0.0]");
        let named = |text: &String| text.starts_with("scenario 1: ");
        assert!(!aside.is_empty() && aside.iter().all(named), "{aside:?}");
        assert!(found("resin.absorption_per_mm = 0.2").is_empty());
    }

    #[test]
    fn what_is_wrong_with_a_scenario_names_file_line_name_and_key() {
        let refused = |set: &str| {
            let text = format!("{JOB}\n[[scenario]]\nname = \"wide\"\nset = {{ {set} }}\n");
            let line = text.lines().count();
            let job = Job::from_document(document_of(&text, &[])).unwrap();
            let error = ResolvedJob::new(&job).map(drop).unwrap_err();
            (error.to_string(), format!("(a.toml, line {line})"))
        };
        let slips = r#"
            "resin.absorption_per_mm" = -0.1 → scenario[0].set.resin.absorption_per_mm: in "wide", found -0.1
            vial.index_matched.radius_mm = 0.5 → scenario[0].set.vial.index_matched.radius_mm: in "wide", `target`:
            "vial.index_matched.radius_mm" = 0.5, "resin.absorption_per_mm" = 0.2 → scenario[0].set: in "wide", `target`:
            "stop.iterations" = 3 → scenario[0].set.stop.iterations: in "wide", no key
             → scenario[0].set: no key: the job once more
        "#;
        for slip in slips.trim().lines() {
            let (set, begin) = slip.split_once("→ ").unwrap();
            let (text, line) = refused(set);
            assert!(text.starts_with(begin) && text.contains(&line), "{text}");
            assert!(!text.contains("--set"), "{text}");
        }
    }

    #[test]
    fn voxels_that_a_scenario_does_not_share_are_told_with_both_sizes() {
        let grid = |shape, pitch| Some(VolumeGrid::centered(shape, pitch));
        let found = other_voxels(grid([40, 20, 10], 0.05), grid([10, 20, 10], 0.1));
        let expected = "its dose model needs 10 × 20 × 40 voxels of 0.05 × 0.05 × 0.05 mm, that of the job 10 × 20 × 10 voxels of 0.1 × 0.1 × 0.1 mm; both";
        assert!(found.starts_with(expected), "{found}");
    }

    #[test]
    fn a_scenario_that_makes_the_job_invalid_is_refused_by_its_number_and_key() {
        let refused = |scenario: &str, change: &[&str]| {
            let sets = ["resin.absorption_per_mm = 0.2", scenario];
            key_of(resolved(&sets, change).map(drop).unwrap_err())
        };
        // The second is no key of the scenario, but its doing
        let slips = r#"
            vial.index_matched.radius_mm = -1.0 → vial.index_matched.radius_mm
            vial.index_matched.radius_mm = 0.5 → vial.index_matched.radius_mm
            resin.absorbtion_per_mm = 0.1 → resin.absorbtion_per_mm
            stop.iterations = 3 → stop.iterations
            motion.offset_mm = [0.1, 0.0], "motion.offset_mm" = [0.2, 0.0] → motion.offset_mm
            "light[0].pixels" = [30, 12] → light
            motion.offset_mm = [2000.0, 0.0] → motion.offset_mm[0]
        "#;
        for slip in slips.trim().lines() {
            let (scenario, key) = slip.trim().split_once(" → ").unwrap();
            let found = refused(scenario, &[]);
            let expected = format!("scenario[1].set.{key}");
            assert!(found.starts_with(&expected), "{scenario}: {found}");
        }
        let same = "resin.absorption_per_mm = 0.2";
        assert_eq!(refused(same, &["optimizer=\"osmo\""]), "optimizer");
        assert_eq!(refused(same, &["evaluate.bit_depth=2"]), "evaluate.levels");
    }
}
