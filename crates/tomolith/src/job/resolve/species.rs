//! What hardens in the resin: one species, or several, each with its part, its response and its objectives.
//!
//! Dose of species s: r_s = Σ_λ M_sλ q_λ, where q_λ is the dose of light λ alone ([`spectral`](crate::models::spectral)). All share
//! lights, vial, voxels and method.
//!
//! **Limits** Methods that minimize a loss take several species; those that compare one dose with one target (`osmo`, `cal`, …) do not.
//! Neither do voxels cut into cells, nor fewer bits than six.

use super::clip;
use super::compatibility::wall_tolerance_mm;
use super::goal::Goal;
use super::method::{Method, counted_as, try_kinds};
use super::optics::Optics;
use super::remarks::{ask_for_unit, at_target, must_be_seen};
use super::{cells, time_refusals};
use crate::error::{Error, Result};
use crate::grid::VolumeGrid;
use crate::job::resolve::ResolvedJob;
use crate::job::spec::JobSpec;
use crate::job::spec::kinds::known_elsewhere;
use crate::job::spec::read::Job;
pub(crate) use crate::job::spec::species::Row;
use crate::job::spec::species::at_species;
use crate::models::{Family, Work};
use crate::target::{self, Role, Shape};
use std::borrow::Cow;
use std::sync::Arc;

/// What hardens in the resin: its part, and the goal of its dose.
pub(crate) struct Species {
    /// Its name; None in a job that names no species.
    pub(crate) name: Option<String>,
    pub(crate) part: String,
    /// Its part, and the other bodies of the target.
    pub(crate) shape: Arc<dyn Shape>,
    pub(crate) goal: Goal,
    /// Whether its surface cuts voxels of the optimization into cells.
    pub(crate) has_cells: bool,
    /// How far its part may reach into a wall, mm.
    pub(crate) wall_tolerance_mm: f64,
}

impl Species {
    /// Half width of the band around gray values: ε of the first objective that has one, or that of the BCLP paper.
    pub(crate) fn half_width(&self) -> f64 {
        let given = self.goal.epsilon();
        given.unwrap_or(crate::metrics::published::Options::default().epsilon)
    }

    /// All species of a job: one at least.
    pub(crate) fn of_job(
        job: &Job,
        method: &Method,
        model: Option<&Family>,
        work: &Work,
    ) -> Result<Vec<Self>> {
        let spec = &job.spec;
        let each = |s: usize| {
            let name = spec.species.get(s).map(|species| species.name.clone());
            let of_species = Self::read(name, &spec.of_species(s), job, method, model, work);
            of_species.map_err(|e| at_species(spec, s, e))
        };
        (0..spec.species.len().max(1)).map(each).collect()
    }

    fn read(
        name: Option<String>,
        spec: &JobSpec,
        job: &Job,
        method: &Method,
        model: Option<&Family>,
        work: &Work,
    ) -> Result<Self> {
        let goal = Goal::read(spec, &job.base()).map_err(known_elsewhere)?;
        let shape = target::build_under(&spec.target, &job.base(), "target", work)
            .map_err(|e| at_target(spec, e))?;
        let shape: Arc<dyn Shape> = Arc::from(shape);
        try_kinds(spec, &goal, method, model, shape.is_gray()).map_err(known_elsewhere)?;
        cells::must_fit(&goal, method, shape.as_ref(), model)?;
        time_refusals::must_be_whole(spec, &goal)?;
        counted_as(spec, shape.is_gray())?;
        Ok(Species {
            name,
            part: spec.target.name(),
            has_cells: goal.cells_key().is_some(),
            shape,
            goal,
            wall_tolerance_mm: 0.0,
        })
    }

    /// What is printed of its shape.
    pub(crate) fn printed(&self) -> &dyn Shape {
        let printed = self.shape.body(Role::Print);
        printed.unwrap_or(self.shape.as_ref())
    }
}

/// Refuses parts that vial or light do not hold, on a grid if there is one; asks for the unit of those that are far too large or small.
pub(crate) fn must_be_held(
    species: &mut [Species],
    spec: &JobSpec,
    optics: &Optics,
    grid: Option<&VolumeGrid>,
) -> Result<Vec<String>> {
    let mut units = Vec::new();
    for (s, species) in species.iter_mut().enumerate() {
        let of_species = spec.of_species(s);
        let at = |error| at_species(spec, s, error);
        species.wall_tolerance_mm = wall_tolerance_mm(&of_species, grid).map_err(at)?;
        let unit = ask_for_unit(&of_species, optics, species.shape.as_ref());
        // Light need reach only what is printed
        let held = optics.must_hold(&of_species, species.printed(), species.wall_tolerance_mm);
        held.map_err(|e| at(e.asking(unit.as_deref())))?;
        units.push(unit.into_iter().collect());
    }
    Ok(named(species, units))
}

/// Refuses parts smaller than a voxel, or cut by the grid; says how much that cuts off.
pub(crate) fn must_be_on(
    species: &[Species],
    spec: &JobSpec,
    optics: &Optics,
    grid: &VolumeGrid,
    work: &Work,
) -> Result<Vec<String>> {
    let is_coarse = optics.are_coarse(grid);
    let each = species.iter().enumerate().map(|(s, species)| {
        let (of_species, shape) = (spec.of_species(s), species.shape.as_ref());
        let unit = ask_for_unit(&of_species, optics, shape);
        must_be_seen(&of_species, shape, grid, unit.as_deref(), is_coarse)
            .and_then(|()| clip::must_hold(&spec.grid, grid, shape, work))
            .map(|cut_off| cut_off.into_iter().collect())
            .map_err(|e| at_species(spec, s, e))
    });
    Ok(named(species, each.collect::<Result<_>>()?))
}

/// Texts about each of several species, with its name before what does not hold for all of them.
pub(crate) fn named(species: &[Species], texts: Vec<Vec<String>>) -> Vec<String> {
    let is_of_all = |text: &String| texts.iter().all(|each| each.contains(text));
    let mut all: Vec<String> = texts[0].iter().filter(|t| is_of_all(t)).cloned().collect();
    for (species, texts) in species.iter().zip(&texts) {
        let name = species.name.as_deref().unwrap_or_default();
        let apart = texts.iter().filter(|text| !is_of_all(text));
        all.extend(apart.map(|text| format!("{name}: {text}")));
    }
    all
}

/// Refuses what does not go with several species.
pub(crate) fn must_fit(resolved: &ResolvedJob) -> Result<()> {
    if resolved.mixing.is_none() {
        return Ok(());
    }
    let asked = resolved.optics.model.as_ref();
    if asked.is_some_and(|family| family.capabilities().is_stored) {
        let found = "a stored matrix holds the lights together, not one by one";
        return Err(Error::config(
            "species",
            found,
            "another model, or no [[species]]",
        ));
    }
    if resolved.species.iter().any(|species| species.has_cells) {
        let found = "an objective whose surface cuts voxels into cells";
        return Err(Error::config(
            "species",
            found,
            "surface = \"fraction\" or \"voxel\"",
        ));
    }
    if resolved.species.len() == 1 {
        return Ok(());
    }
    if resolved.method.needs_target() {
        let found = "a method that compares one dose with one target";
        let accepted = "lbfgs, or another method that minimizes the loss, with several [[species]]";
        return Err(Error::config("optimizer", found, accepted));
    }
    if resolved.spec.evaluate.improves_levels() {
        let found = "patterns on few levels are not improved for several [[species]]";
        return Err(Error::config("evaluate.levels", found, "\"rounded\""));
    }
    Ok(())
}

/// The light that drives a species most, for each light the species it begins with and the factor of its patterns: lights that begin with
/// the same species share its dose. None for a light that drives nothing: it begins dark.
pub(crate) fn beginnings(rows: &[Row]) -> Vec<Option<(usize, f64)>> {
    let lights = rows[0].1.len();
    let strongest = |light: usize| {
        let drive = |s: &usize| rows[*s].1[light];
        let best = (0..rows.len()).max_by(|a, b| drive(a).total_cmp(&drive(b)).then(b.cmp(a)))?;
        (drive(&best) > 0.0).then_some(best)
    };
    let species: Vec<Option<usize>> = (0..lights).map(strongest).collect();
    let sharing = |s: usize| species.iter().filter(|&&other| other == Some(s)).count() as f64;
    let factor =
        |(light, s): (usize, &Option<usize>)| s.map(|s| (s, 1.0 / (rows[s].1[light] * sharing(s))));
    species.iter().enumerate().map(factor).collect()
}

/// How many times as bright as where it begins a light must be, where the dose that drives a species makes good what other lights take away from it.
pub(crate) fn against_inhibition(rows: &[Row]) -> Vec<f64> {
    let begins = beginnings(rows);
    let taken = |s: usize| -> f64 {
        let lights = rows[s].1.iter().zip(&begins);
        let of_light = |(drive, begin): (&f64, &Option<(usize, f64)>)| {
            begin.map_or(0.0, |(_, factor)| (-drive).max(0.0) * factor)
        };
        lights.map(of_light).sum()
    };
    let times = |begin: &Option<(usize, f64)>| begin.map_or(1.0, |(s, _)| 1.0 + taken(s));
    begins.iter().map(times).collect()
}

impl ResolvedJob {
    /// M, a row per species, where lights are computed one by one: with several species, or for a print in time.
    pub(crate) fn rows(&self) -> Option<Cow<'_, [Row]>> {
        match &self.mixing {
            Some(rows) => Some(Cow::Borrowed(rows)),
            None if self.is_optimized_in_time() => {
                let row = vec![1.0; self.spec.light.len()];
                Some(Cow::Owned(vec![("resin".to_owned(), row)]))
            }
            None => None,
        }
    }

    /// The species that headline numbers are of: the first.
    pub(crate) fn first(&self) -> &Species {
        &self.species[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check;
    use crate::field::Field;
    use crate::job::resolve::optics::tests::key as key_of;
    use crate::job::spec::JobSpec;
    use crate::job::tests::{document_of, job_of};
    use crate::job::{Job, ResolvedJob};
    use crate::models::Work;
    use crate::objective::Objective;

    const TWO: &str = r#"
        target = { phantom = "gear", size_mm = 2.0 }
        grid = { pitch_mm = 0.1 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1, attenuation_per_mm = 0.3 }
        vial = { index_matched = { radius_mm = 2.0 } }
        stop = { iterations = 4 }
        [[light]]
        name = "violet"
        pixels = [28, 12]
        angles = 16
        projector.collimated = { pixel_pitch_mm = 0.1 }
        [[light]]
        name = "uv"
        pixels = [30, 12]
        angles = 12
        projector.collimated = { pixel_pitch_mm = 0.1 }
        resin = { absorption_per_mm = 0.4, refractive_index = 1.6 }
        [[species]]
        name = "soft"
        driven_by = { violet = 1.0, uv = 0.5 }
        [[species]]
        name = "stiff"
        driven_by = { uv = 2.0 }
        target = { phantom = "sphere", size_mm = 1.0 }
    "#;

    fn resolved(changes: &[&str]) -> Result<ResolvedJob> {
        ResolvedJob::new(&Job::from_document(document_of(TWO, changes))?)
    }

    #[test]
    fn a_light_sees_its_own_resin() {
        let spec = JobSpec::from_document(&document_of(TWO, &[])).unwrap();
        let [violet, uv] = [0, 1].map(|i| spec.resin_of(i));
        assert_eq!(violet.attenuation_per_mm, Some(0.3));
        // Its absorption is another one, so the attenuation of the others says nothing of it
        let resin = (
            uv.refractive_index,
            uv.absorption_per_mm,
            uv.attenuation_per_mm,
        );
        assert_eq!(resin, (1.6, Some(0.4), None));
        let job = resolved(&[]).unwrap();
        let resins = job.lights().iter().map(|light| &light.resin);
        let seen: Vec<_> = resins
            .map(|resin| (resin.refractive_index, resin.attenuation_per_mm))
            .collect();
        assert_eq!(seen, [(1.5, 0.3), (1.6, 0.4)]);
    }

    #[test]
    fn what_does_not_hold_for_all_species_is_told_with_a_name() {
        let warning_of = |changes: &[&str]| {
            let warnings = resolved(changes).unwrap().warnings;
            let of_pixels = |text: &String| text.contains("a pixel is 0.1 mm wide");
            warnings.into_iter().find(of_pixels)
        };
        assert_eq!(warning_of(&["grid.pitch_mm=0.04"]), None);
        let small = "species[1].target.size_mm=0.08";
        let text = warning_of(&["grid.pitch_mm=0.04", small]).unwrap();
        assert!(text.starts_with("stiff: light[0]: a pixel"), "{text}");
    }

    #[test]
    fn two_species_are_optimized_together() {
        let (job, run) = (resolved(&[]).unwrap(), Work::new());
        let mut task = job.task(&run).unwrap();
        assert_eq!(task.model.outputs().len(), 2);
        assert_eq!(
            (task.start.len(), task.limits.len()),
            (task.model.patterns()[1].range().end, 2)
        );
        let mut dose = check::dose(&*task.model, &task.start);
        let [soft, stiff] = task.model.outputs() else {
            panic!()
        };
        // Where it begins the sphere gets its dose from the ultraviolet alone
        let field = stiff.volume_of(dose.as_slice());
        let middle = field.at(
            field.grid.shape[0] / 2,
            field.grid.shape[1] / 2,
            field.grid.shape[2] / 2,
        );
        assert!((0.6..1.4).contains(middle), "{middle}");
        let before = task.objective.value(&dose);
        let bounds = task.bounds().unwrap();
        let (mut slope, mut gradient) = (dose.zeros_like(), task.start.zeros_like());
        task.objective.value_and_gradient(&dose, &mut slope);
        assert!(slope.as_slice()[soft.range()].iter().any(|&v| v != 0.0));
        task.model
            .pullback(&task.start, &slope, &mut gradient, &run)
            .unwrap();
        let step = 0.01 * task.start.max_abs() / gradient.max_abs();
        task.start.move_along(&gradient, -step, &bounds);
        task.model.dose(&task.start, &mut dose, &run).unwrap();
        assert!(task.objective.value(&dose) < before);
    }

    #[test]
    fn one_species_of_one_light_is_the_plain_job() {
        let one = "[{ name = \"violet\", pixels = [28, 12], angles = 16, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]";
        let light = format!("light={one}");
        let dose = |changes: &[&str]| {
            let (job, run) = (resolved(changes).unwrap(), Work::new());
            let task = job.task(&run).unwrap();
            check::dose(&*task.model, &task.start).as_slice().to_vec()
        };
        assert_eq!(
            dose(&[&light, "species=[]"]),
            dose(&[&light, "species=[{ name = \"a\" }]"])
        );
    }

    #[test]
    fn a_resolved_job_finds_its_start_and_the_files_of_its_species_from_anywhere() {
        let changes = [
            "species[1].target={ image = \"stiff.png\", size_mm = 1.0, height_mm = 1.0 }",
            "species[1].response={ table = { file = \"curve.csv\" } }",
            "start={ patterns = { file = \"earlier.npz\" } }",
        ];
        let job = job_of(TWO, &changes);
        let start = job.complete().start;
        let start = start.pointer("/patterns/file");
        let start = start.and_then(serde_json::Value::as_str).unwrap();
        assert!(
            std::path::Path::new(start).is_absolute() && start.ends_with("earlier.npz"),
            "{start}"
        );
        let resolved = &job.complete().species[1];
        let image = resolved.target.as_ref().unwrap().image.clone().unwrap();
        let curve = resolved.response.as_ref().unwrap().pointer("/table/file");
        let curve = curve.and_then(serde_json::Value::as_str).unwrap();
        assert!(
            image.is_absolute() && image.ends_with("stiff.png"),
            "{image:?}"
        );
        assert!(std::path::Path::new(curve).is_absolute(), "{curve}");
    }

    #[test]
    fn what_does_not_go_together_is_refused_by_its_key() {
        let slips = r#"
            species[0].driven_by={ violett = 1.0 } → species[0].driven_by.violett
            species[1].driven_by={ uv = -1.0 } → species[1].driven_by
            species[0].name="stiff" → species[1].name
            species[0].name="a b" → species[0].name
            species[1].target.size_mm=9.0 → species[1].target
            species[1].objective={ threshold = { lower = 2.0, upper = 1.0 } } → species[1].objective.threshold
            light[1].resin.absorption_per_mm=0.0 → light[1].resin.absorption_per_mm
            optimizer="osmo" → optimizer
            evaluate.bit_depth=2 → evaluate.levels
            species=[{ name = "a", driven_by = { uv = 1.0 } }] → light[0]
        "#;
        for slip in slips.trim().lines() {
            let (change, key) = slip.trim().split_once(" → ").unwrap();
            let found = key_of(resolved(&[change]).map(drop).unwrap_err());
            assert!(found.starts_with(key), "{change}: {found}");
        }
    }

    #[test]
    fn lights_begin_with_the_species_that_they_drive_most() {
        let row = |name: &str, row: &[f64]| (name.to_owned(), row.to_vec());
        let dual = [row("acrylate", &[1.0, 0.25]), row("epoxy", &[0.0, 2.0])];
        assert_eq!(beginnings(&dual), [Some((0, 1.0)), Some((1, 0.5))]);
        let antagonistic = [row("acrylate", &[2.0, -1.0])];
        assert_eq!(beginnings(&antagonistic), [Some((0, 0.5)), None]);
        let both = [row("acrylate", &[1.0, 1.0])];
        assert_eq!(beginnings(&both), [Some((0, 0.5)), Some((0, 0.5))]);
        assert_eq!(against_inhibition(&both), [1.0, 1.0]);
        // b gives its species a dose of 1, and takes half of that from the species of a
        let rows = [
            ("net".into(), vec![1.0, -0.5]),
            ("two".into(), vec![0.0, 1.0]),
        ];
        assert_eq!(against_inhibition(&rows), [1.5, 1.0]);
    }
}
