//! What a job takes of the memory budget, and what is lowered until it fits.

use super::extent::{Extent, FIELDS_PER_SCENARIO};
use super::optics::Optics;
use super::remarks::grid_key;
use super::resources::{free_memory_mb, memory_budget_mb, require};
use super::species::Species;
use super::{cells, extent, refinement};
use crate::error::Result;
use crate::exposure::Printer;
use crate::grid::VolumeGrid;
use crate::job::resolve::ResolvedJob;
use crate::job::spec::JobSpec;
use crate::models::{Family, OpticalScene, Purpose};

/// Least memory of a quasi-Newton method that is still worth having.
const LEAST_MEMORY: usize = 3;

/// What a job takes, with all that its levels, its model and its outputs add to what it counts for itself.
pub(crate) fn extent(resolved: &ResolvedJob, family: &Family) -> Result<Extent> {
    let (spec, grid, extent) = (&resolved.spec, &resolved.grid, &resolved.extent);
    let lit = resolved.optimizing();
    let last = &resolved.levels[resolved.levels.len() - 1];
    let finest = lit.lit_by(&last.lights);
    let finest_cost = family.cost(&finest, &last.grid).unwrap_or_default();
    let job_cost = family.cost(&lit, grid)?;
    let entries = [&finest_cost, &job_cost].map(|cost| cost.entries);
    let (lights, iterations) = (&resolved.optics.lights, spec.stop.iterations);
    let effort = refinement::effort(&resolved.levels, grid, lights, iterations, entries);
    let judged_finer = refinement::judged_finer(resolved, family.as_ref());
    let canvases = resolved.printers.iter().flatten().map(Printer::canvas_grid);
    Ok(Extent {
        effort: effort * (1 + spec.scenario.len()) as f64,
        cached_entries: finest_cost.cached_entries,
        cached_bytes: finest_cost.cached_bytes,
        finest: last.grid.clone(),
        fields: with_fields(spec, &resolved.species),
        in_time: in_time(spec),
        judged_finer,
        judged_finer_asked: judged_finer,
        canvas: canvases.map(|canvas| canvas.len()).sum(),
        stacked: bytes_stacked(spec),
        // Dose and target, and a label, and a level of eighths
        bytes_of_volumes: spec.output.volumes.len() * 10,
        // Response and target, and a label
        bytes_evaluated: usize::from(spec.output.evaluation) * 9,
        is_noisy: family.monte_carlo_paths().is_some(),
        scenarios: spec.scenario.len(),
        species: resolved.species.len(),
        working_mb: [
            job_cost.working_bytes as f64 / 1e6,
            evaluated_mb(&resolved.optics, grid, extent.refine)?,
        ],
        ..extent.clone()
    })
}

impl ResolvedJob {
    /// What to say where prints below a ceiling are compared on voxels that fit the memory budget.
    pub(crate) fn compares_coarsely(&self) -> Option<String> {
        let judged = |finer| refinement::judged(&self.extent.finest, finer);
        let is_lowered = judged(self.extent.judged_finer) != judged(self.extent.judged_finer_asked);
        is_lowered.then(|| {
            "the memory budget (resources.memory_gb) is too small: prints below a ceiling of the pixels are compared on coarser voxels than those of the evaluation, and the ceiling may \
             end elsewhere"
                .to_owned()
        })
    }

    /// Lowers what prints below a ceiling are compared on, the optimizer's memory and the refinement of the evaluation until all fit, and says so.
    pub(crate) fn fit_memory(&mut self) -> Result<()> {
        let budget = memory_budget_mb(self.spec.resources.memory_gb);
        let fits = |needed: u64| budget.is_none_or(|budget| needed <= budget);
        while !fits(self.extent.optimization_mb()) && self.extent.judged_finer > 1 {
            self.extent.judged_finer -= 1;
        }
        let asked = self.extent.memory;
        while !fits(self.extent.optimization_mb()) && self.extent.memory > LEAST_MEMORY {
            self.extent.memory -= 1;
        }
        if self.extent.memory < asked {
            let memory = self.extent.memory;
            self.method.set_pairs(memory);
            self.warnings.push(format!(
                "the memory budget (resources.memory_gb) is too small: optimizer.{}.memory is {memory}, not {asked}",
                self.method.name()
            ));
        }
        let asked = self.extent.refine;
        while !fits(self.extent.evaluation_mb()) && self.extent.refine > 1 {
            self.extent.refine -= 1;
            self.extent.working_mb[1] = evaluated_mb(&self.optics, &self.grid, self.extent.refine)?;
        }
        if self.extent.refine < asked {
            let refine = self.extent.refine;
            self.warnings.push(format!(
                "the memory budget (resources.memory_gb) is too small: evaluating on {}, not on a {asked}× finer one",
                match refine {
                    1 => "the job's own grid".to_owned(),
                    refine => format!("a {refine}× finer grid"),
                }
            ));
        }
        // What the job's own voxels would take of that for the optimization's
        let finest = self.levels.last().map_or(1, |level| level.grid.len());
        let share = self.grid.len() as f64 / finest as f64;
        for (what, parts) in [
            ("memory for the optimization", self.extent.optimization()),
            ("memory for the evaluation", self.extent.evaluation()),
        ] {
            let [voxels_mb, pixels_mb, frames_mb] = parts;
            let (key, accepted) = if frames_mb > voxels_mb.max(pixels_mb) {
                let accepted =
                    "fewer pixels or voxels, larger errors allowed in the model, fewer --threads";
                ("model".to_owned(), accepted)
            } else if voxels_mb >= pixels_mb
                && what.ends_with("optimization")
                && share < 1.0
                && fits(extent::whole_mb([share * voxels_mb, pixels_mb, frames_mb]))
            {
                let accepted = "a smaller grid.refine (the optimization's voxels are finer than the job's; 1 takes the job's own)";
                ("grid.refine".to_owned(), accepted)
            } else if voxels_mb >= pixels_mb {
                let accepted = "fewer voxels (a larger grid.pitch_mm, a smaller grid.shape)";
                (grid_key(&self.spec), accepted)
            } else if what.ends_with("evaluation") && 2.0 * self.extent.canvas_mb() > pixels_mb {
                let accepted =
                    "a smaller canvas (it need only hold the patterns), or fewer light.angles";
                ("printer.canvas".to_owned(), accepted)
            } else {
                let accepted = "fewer pixels or angles (light.pixels, light.angles)";
                (pixels_key(&self.spec), accepted)
            };
            let needed_mb = extent::whole_mb(parts);
            let accepted = match self.spec.resources.memory_gb {
                Some(_) => format!("{accepted}, or a larger resources.memory_gb"),
                None => accepted.to_owned(),
            };
            require(&key, what, needed_mb, budget, &accepted)?;
        }
        self.warn_of_others();
        Ok(())
    }

    /// Triangles of a surface that the evaluation has memory for.
    pub(crate) fn most_triangles(&self) -> usize {
        let budget = memory_budget_mb(self.spec.resources.memory_gb);
        self.extent.most_triangles(budget)
    }

    /// Warns where other programs hold the memory that the run plans with.
    fn warn_of_others(&mut self) {
        let needed = self
            .extent
            .optimization_mb()
            .max(self.extent.evaluation_mb());
        if let Some(free) = free_memory_mb().filter(|&free| free < needed) {
            self.warnings.push(format!(
                "the run needs {needed} MB of memory and {free} MB are free now: it may become slow or be stopped by the system. End other \
                 programs, or make the job smaller (grid.pitch_mm, light.pixels)"
            ));
        }
    }
}

/// Volumes that a further species, and a print in time, take, as objectives with fields.
const PER_SPECIES: usize = 2;

const PER_PRINT: usize = 5;

/// Objectives with numbers per voxel.
fn with_fields(spec: &JobSpec, species: &[Species]) -> usize {
    let of_one = |species: &Species| {
        let is_gray = species.shape.is_gray();
        let common = species.goal.common();
        let fields = common.filter(|(_, common)| is_gray || common.has_fields());
        fields.count() + if species.has_cells { cells::FIELDS } else { 0 }
    };
    // Dose and target of each further species or scenario; state and snapshots of a print in time
    species.iter().map(of_one).sum::<usize>()
        + PER_SPECIES * (species.len() - 1)
        + FIELDS_PER_SCENARIO * spec.scenario.len()
        + in_time(spec)
}

/// Volumes of a print in time.
fn in_time(spec: &JobSpec) -> usize {
    spec.schedule.as_ref().map_or(0, |_| PER_PRINT)
}

/// Bytes of a canvas pixel in `frames.npz`, 0 when the job asks for none.
pub(crate) fn bytes_stacked(spec: &JobSpec) -> usize {
    let asked = spec.printer.as_ref().is_some_and(|printer| printer.stack);
    usize::from(asked) * if spec.evaluate.bit_depth > 8 { 2 } else { 1 }
}

/// The key of the light with the most pixels.
fn pixels_key(spec: &JobSpec) -> String {
    let pixels = |i: &usize| {
        let light = &spec.light[*i];
        light.pixels.iter().product::<usize>() * light.angles.count()
    };
    let largest = (0..spec.light.len()).max_by_key(pixels).unwrap_or(0);
    format!("light[{largest}].pixels")
}

/// Memory of the frames that are evaluated at a time, MB.
pub(crate) fn evaluated_mb(optics: &Optics, grid: &VolumeGrid, refine: usize) -> Result<f64> {
    let grid = grid.refined(refine);
    let resolved = OpticalScene {
        purpose: Purpose::Evaluate { refine },
        ..optics.scene()
    };
    let cost = optics.family(&grid)?.cost(&resolved, &grid)?;
    Ok(cost.working_bytes as f64 / 1e6)
}

#[cfg(test)]
mod tests {
    use crate::job::resolve::ResolvedJob;
    use crate::job::tests::job_of;
    use crate::models::Work;

    #[test]
    fn voxels_that_the_program_chose_too_fine_for_the_memory_are_blamed() {
        let text = r#"
            target = { phantom = { sphere = {} }, size_mm = 4.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
            vial = { index_matched = { radius_mm = 4.0 } }
            light = [{ pixels = [64, 48], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
            optimizer = { lbfgs = { memory = 1 } }
        "#;
        let resolved = |more: &[&str]| ResolvedJob::under(&job_of(text, more), &Work::new());
        let needed = |more: &[&str]| resolved(more).unwrap().extent.optimization_mb();
        let (fine, coarse) = (needed(&[]), needed(&["grid.refine=1"]));
        assert!(fine > coarse + 20, "{fine} {coarse}");
        let budget = format!("resources.memory_gb={}", (fine + coarse) as f64 / 2e3);
        let refusal = resolved(&[&budget]).err().unwrap().to_string();
        tomolith_core::contains!(
            refusal,
            "grid.refine: memory for the optimization",
            "1 takes the job's own"
        );
        resolved(&[&budget, "grid.refine=1"]).unwrap();
    }
}
