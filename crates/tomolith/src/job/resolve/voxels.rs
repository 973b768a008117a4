//! The target on voxels: what is part, what is void, what counts.

use super::optics::Optics;
use super::refinement::Level;
use super::remarks::at_grid;
use super::species::{Species, named};
use crate::error::Result;
use crate::grid::{Volume, VolumeGrid};
use crate::job::progress::SpeciesTarget;
use crate::job::resolve::ResolvedJob;
use crate::job::spec::scenario::at_scenario;
use crate::job::spec::species::at_species;
use crate::metrics::surface::TargetSurface;
use crate::models::{DoseLayout, Work};
use crate::objective::voxel_weights::Ground;
use crate::report;
use crate::report::number::significant;
use crate::target::{self, Role, Target, label, label_columns, label_voxels, thin::Thin};
use crate::units::concise;
use std::sync::Arc;
use tomolith_core::parallel::table;

/// The target on a grid.
#[derive(Clone)]
pub(crate) struct Voxels {
    pub(crate) target: Target,
    pub(crate) labels: Volume<u8>,
    /// Its surface, which all prints of it share.
    pub(crate) surface: Arc<TargetSurface>,
    /// Smallest inside fraction of voxels that light should reach.
    least: f32,
}

impl Voxels {
    pub(crate) fn shown(&self, species: &Species) -> SpeciesTarget {
        SpeciesTarget {
            species: species.name.clone().unwrap_or_default(),
            inside: self.target.inside.clone(),
            labels: self.labels.clone(),
            quantity: species.goal.quantity(),
            band: self.target.gray.then(|| species.half_width()),
        }
    }
}

/// Shares of the part from which on walls and gaps that voxels leave out are worth a word. Edges of parts that voxels resolve lose up to 0.02 % in walls, and next to nothing in gaps; a closed
/// channel is a small share of its part.
const THIN_WALLS: f64 = 1e-3;
const THIN_GAPS: f64 = 2e-4;

/// Warns of a target with walls or gaps that its voxels leave out; gray values are no shape.
fn of_thin(target: &Target) -> Option<String> {
    if target.gray {
        return None;
    }
    let thin = Thin::of(&target.inside);
    let are_walls_lost = thin.walls_mm3 > THIN_WALLS * thin.part_mm3;
    let are_gaps_lost = thin.gaps_mm3 > THIN_GAPS * thin.part_mm3;
    let percent = report::number::significant(100.0 * thin.walls_mm3 / thin.part_mm3, 2);
    let [walls, gaps] =
        [thin.walls_mm3, thin.gaps_mm3].map(|mm3| report::number::significant(mm3, 2));
    let of_walls = format!("walls of {walls} mm³ ({percent} % of the part)");
    let of_gaps = format!("gaps of {gaps} mm³");
    let what = match (are_walls_lost, are_gaps_lost) {
        (false, false) => return None,
        (true, false) => of_walls,
        (false, true) => of_gaps,
        (true, true) => format!("{of_walls} and {of_gaps}"),
    };
    Some(format!(
        "{what} are too thin for voxels of {} mm: a voxel counts as part from one half on, so IoU, VER and the other numbers of the print leave them out. \
         Use voxels no wider than they are (grid.pitch_mm)",
        concise(target.inside.grid.pitch_mm)
    ))
}

/// Smallest inside fraction that light should reach where the objective sees fractions: thinner slivers are left to chance.
const SLIVER: f32 = 0.05;

/// Largest value of a gray picture below which it is hardly meant so.
const DIM: f32 = 0.5;

/// A gray picture that is dark everywhere, as colors are by their luma.
fn of_dim(species: &Species, target: &Target) -> Vec<String> {
    let most = target.inside.values.iter().copied().fold(0.0, f32::max);
    let is_dim = target.gray && species.shape.pixel_mm().is_some() && most < DIM;
    let text = || {
        format!(
            "the brightest voxel of the gray target is {}, and 1 is white: the print has no more. Colors of a picture count by their luma (red 0.21, green 0.72, blue 0.07): \
             make it brighter, or gray",
            significant(f64::from(most), 2)
        )
    };
    is_dim.then(text).into_iter().collect()
}

impl ResolvedJob {
    /// The targets of all species on a grid.
    pub(crate) fn voxels(&self, grid: &VolumeGrid, work: &Work) -> Result<Vec<Voxels>> {
        let targets = self.sampled(grid, &work.part(0.9))?;
        self.voxels_of(targets, grid, work)
    }

    /// The inside fractions of their parts.
    pub(crate) fn sampled(&self, grid: &VolumeGrid, work: &Work) -> Result<Vec<Target>> {
        let share = 1.0 / self.species.len() as f64;
        let sampled = |species: &Species| {
            let (shape, work) = (species.shape.as_ref(), work.part(share));
            let target = target::voxelize_under(shape, &species.part, grid, &work);
            target.map_err(|e| at_grid(&self.spec, e))
        };
        self.species.iter().map(sampled).collect()
    }

    /// What counts, for these parts on a grid.
    pub(crate) fn voxels_of(
        &self,
        targets: Vec<Target>,
        grid: &VolumeGrid,
        work: &Work,
    ) -> Result<Vec<Voxels>> {
        let all = targets.into_iter().zip(&self.species);
        all.map(|(target, species)| self.labeled(target, species, grid, work))
            .collect()
    }

    fn labeled(
        &self,
        target: Target,
        species: &Species,
        grid: &VolumeGrid,
        work: &Work,
    ) -> Result<Voxels> {
        let counts = self.optics.counts(self.spec.grid.region, &self.grid);
        let mut labels = if self.optics.vial.is_invariant() {
            label_columns(&target, |[x, y]| counts([x, y, 0.0]))
        } else {
            label_voxels(&target, counts)
        };
        // There is no resin in an insert
        if let Some(insert) = species.shape.body(Role::Insert) {
            let inside = target::sampled(insert, grid, work)?.values;
            for (label, inside) in labels.values.iter_mut().zip(inside) {
                *label = if inside >= 0.5 {
                    label::OUTSIDE
                } else {
                    *label
                };
            }
        }
        let sees_fractions = !self.method.needs_target() && species.goal.sees_fractions();
        let least = if sees_fractions { SLIVER } else { 0.5 };
        Ok(Voxels {
            target,
            labels,
            surface: Arc::default(),
            least,
        })
    }

    /// What people should know of voxels beyond the reach of light, of regions without voxels, and of scenarios in which the job would warn them otherwise.
    pub(crate) fn warnings_of(&self, voxels: &[Voxels]) -> Result<Vec<String>> {
        let mut found = self.warned(&self.optics, voxels)?;
        let regions = self.species.iter().zip(voxels).map(|(species, voxels)| {
            let layout = DoseLayout::new("dose", voxels.labels.grid.clone(), 0);
            let ground = Ground {
                layout: &layout,
                labels: &voxels.labels,
                target: &voxels.target,
                base: &self.base,
            };
            let objectives = species.goal.objectives().iter();
            let warnings = objectives.map(|objective| objective.warnings(&ground));
            warnings.collect::<Result<Vec<_>>>().map(|all| all.concat())
        });
        found.extend(named(&self.species, regions.collect::<Result<_>>()?));
        let faces = voxels.iter().enumerate().map(|(s, voxels)| {
            let warning = self.warning_of_row_ends(s, &voxels.target.inside);
            warning.into_iter().collect()
        });
        found.extend(named(&self.species, faces.collect()));
        let dim = self.species.iter().zip(voxels);
        let dim = dim.map(|(species, voxels)| of_dim(species, &voxels.target));
        found.extend(named(&self.species, dim.collect()));
        if self.sees_own_voxels() {
            found.extend(self.too_thin(voxels.iter().map(|voxels| &voxels.target)));
        }
        let given = self.scenarios.iter().zip(&self.spec.scenario);
        for (i, (scenario, spec)) in given.enumerate() {
            let of_voxels = self.warned(&scenario.optics, voxels);
            let of_voxels = of_voxels.map_err(|error| at_scenario(i, spec, error))?;
            let all = of_voxels.iter().chain(&scenario.warnings);
            let is_new = |text: &&String| !found.contains(text) && !self.warnings.contains(text);
            let new: Vec<String> = all.filter(is_new).cloned().collect();
            found.extend(new.iter().map(|text| format!("{}: {text}", scenario.name)));
        }
        Ok(found)
    }

    /// Whether the optimization has no finer voxels than the job.
    pub(crate) fn sees_own_voxels(&self) -> bool {
        let is_finer = |level: &Level| level.grid.pitch_mm < self.grid.pitch_mm;
        !self.levels.iter().any(is_finer)
    }

    /// Walls and gaps that the voxels of these targets, one a species, leave out.
    pub(crate) fn too_thin<'t>(&self, targets: impl Iterator<Item = &'t Target>) -> Vec<String> {
        let each = self.species.iter().zip(targets);
        let warnings = each.map(|(species, target)| {
            // From pixel to pixel shares rise over several voxels that are narrower
            let pitch_mm = target.inside.grid.pitch_mm;
            let is_ramp = (species.shape.pixel_mm()).is_some_and(|pixel_mm| pixel_mm > pitch_mm);
            let thin = (!is_ramp).then(|| of_thin(target)).flatten();
            thin.into_iter().collect()
        });
        named(&self.species, warnings.collect())
    }

    /// What lies outside the resin, or beyond the reach of these optics.
    fn warned(&self, optics: &Optics, voxels: &[Voxels]) -> Result<Vec<String>> {
        let each = self.species.iter().zip(voxels).enumerate();
        let each = each.map(|(s, (species, Voxels { target, labels, .. }))| {
            let tolerance_mm = species.wall_tolerance_mm;
            let found = optics.warnings(&target.inside, labels, target.gray, tolerance_mm);
            found.map_err(|e| at_species(&self.spec, s, e))
        });
        Ok(named(&self.species, each.collect::<Result<_>>()?))
    }

    /// Share of each voxel that no light may pass, when the target has such bodies.
    pub(crate) fn keep_dark(&self, grid: &VolumeGrid) -> Result<Option<Volume<f32>>> {
        let dark = self.first().shape.body(Role::KeepDark);
        dark.map(|dark| target::sampled(dark, grid, &Work::new()))
            .transpose()
    }

    /// Which voxels belong to bodies that are not printed: obstacles, inserts, and those that stay dark by these shares.
    pub(crate) fn bodies(
        &self,
        grid: &VolumeGrid,
        dark: Option<&Volume<f32>>,
    ) -> Result<Option<Volume<u8>>> {
        let insert = self
            .first()
            .shape
            .body(Role::Insert)
            .map(|body| body.sample(grid));
        let insert = insert.transpose()?;
        if dark.is_none() && insert.is_none() && self.optics.obstacles().is_empty() {
            return Ok(None);
        }
        let obstacle = |i| report::OBSTACLE * u8::from(self.optics.in_obstacle(grid.middle(i)));
        let mut bodies = Volume::new(grid.clone(), table(grid.len(), obstacle));
        for (mark, shares) in [(report::DARK, dark), (report::INSERT, insert.as_ref())] {
            let shares = shares.into_iter().flat_map(|shares| &shares.values);
            for (body, _) in bodies
                .values
                .iter_mut()
                .zip(shares)
                .filter(|(_, s)| **s >= 0.5)
            {
                *body = mark;
            }
        }
        Ok(Some(bodies))
    }
}

impl Voxels {
    /// The highest value of a gray target that counts; None for one of part and void.
    pub(crate) fn highest_gray(&self) -> Option<f64> {
        let values = self.target.inside.values.iter().zip(&self.labels.values);
        let counted = values.filter(|(_, label)| **label != label::OUTSIDE);
        let highest = counted.fold(0.0f32, |highest, (&value, _)| highest.max(value));
        self.target.gray.then_some(f64::from(highest))
    }

    /// Voxels that light should reach: 1 where something is to be printed, else 0.
    pub(crate) fn wanted(&self) -> Volume<u8> {
        let (labels, inside) = (&self.labels.values, &self.target.inside.values);
        let wanted = |(&l, &s): (&u8, &f32)| {
            let least = if self.target.gray {
                f32::MIN_POSITIVE
            } else {
                self.least
            };
            u8::from(l == label::PART || (l == label::VOID && s >= least))
        };
        Volume {
            grid: self.labels.grid.clone(),
            values: labels.iter().zip(inside).map(wanted).collect(),
        }
    }

    /// Voxels that count and that light should not reach, 1, else 0.
    pub(crate) fn unwanted(&self) -> Volume<u8> {
        let mut unwanted = self.wanted();
        for (wanted, &label) in unwanted.values.iter_mut().zip(&self.labels.values) {
            *wanted = u8::from(label != label::OUTSIDE && *wanted == 0);
        }
        unwanted
    }
}
