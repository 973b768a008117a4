//! The `parallel` dose model: collimated light through geometry that does not change along z.
//!
//! # Model
//! Light of pixel column u enters the vial, is refracted and weakened at its walls ([`Tracer`](tomolith_optics::trace::Tracer)), and runs along straight
//! lines through resin that absorbs it. The geometry of one slice serves all heights, so the inner loop walks along z.
//!
//! # Equation
//! With pattern values x (mJ/mm²), voxel volume V, column u and height z of a point r as seen by frame k:
//!
//! ```text
//! forward   dose(v) = Σ_k (μ_a/V) ∫_V x_k(u_k(r), z) · T_k · |du/dt| · e^(−μ_t·s_k(r)) dV
//! adjoint   grad(k, column, row) = Σ_v (∂dose(v)/∂x_k(column, row)) · c(v)
//! ```
//! T: transmittance of the walls; |du/dt|: what refraction focuses or spreads; s: way through resin. In pure Radon mode
//! the factors μ_a and e^(−μ_t s) are 1. All rays that reach a point count (several branches beyond n_s·R_o/n_r, two
//! segments in a double tube).
//!
//! # Discretization
//! `kernel = "distance-driven"` (the default): see `strips.rs` and `tiles.rs`. Along z pixels are boxes and the overlap with a voxel is
//! exact; where rows of pixels are fewer than slices of voxels, the kernel runs along the rows (`z_overlap.rs`). A pixel's absorbed energy is conserved to rounding, a uniform light gives a uniform fluence, and the error of a
//! voxel falls with the square of the pitch. The published kernels of pure Radon, `"line"`, `"linear"` and `"strip"`, are
//! other enumerators of the same (column, voxel, weight): see [`radon`].
//!
//! # Source
//! Design: Nicolet et al. 2024, §3 (volumetric rendering equation without scattering); kernel: De Man & Basu 2004.
//!
//! # Shapes
//! Patterns and dose as in [`layout`](crate::layout).
//!
//! # Limits
//! Collimated light, walls and absorption that do not change along z, light reflected at a wall is lost. Absorption may
//! change across the plane ([`AbsorptionMap`](tomolith_optics::absorption_map::AbsorptionMap)) where light is straight; a bath may absorb before the vial
//! ([`Bath`](tomolith_optics::trace::Bath)).
//!
//! # Words
//! | word | meaning | in |
//! |---|---|---|
//! | view | a frame, or a frame with its opposite one where these share their weights; a *side* is one of the two | `views.rs` |
//! | strip, beam | the light of a column that runs through resin in one smooth bundle; all strips of a view and sub-angle | `strips.rs` |
//! | tile, patch | 16 × 16 voxels of the plane; 2 × 2 voxels of a tile | `tiles.rs`, `patches.rs` |
//! | lanes, vector | floats along z that a kernel runs through: slices, or rows of pixels; 16 of them | `z_overlap.rs` |
//! | slot | the lanes of one column of one view: view × columns + column | `plan.rs` |
//! | lit | the first and last lane of a slot that have light | `plan.rs` |
//! | entry | what a slot brings to a voxel or patch: (slot, weights) | `cached.rs` |
//! | group | views whose entries of a tile are stored and summed together | `cached.rs` |
//! | part | a quarter or half of the turn, after which views repeat, seen from voxels that are turned, too | `turned.rs` |
//! | band | tiles whose adjoints are summed apart, in the same order on any number of threads | `kept.rs` |
//!
//! # Cost
//! One *update* is one voxel lit by one frame: about two fused multiply-adds and two loads of one float each, shared
//! geometry aside. Where light can be reversed (pure Radon, straight light, every frame with its opposite), two frames
//! share these: see `views.rs`. An optimization stores the entries of all frames where they are few, and joins the angles of a frame:
//! see `cached.rs`. Memory in addition to the fields: lanes of all pixels once (views·columns·nz floats), and 2.1 GB of such entries at most.
//!
//! # Example
//! Uniform light of 1 mJ/mm² from four sides through an index-matched cylinder makes, at the axis, four times
//! μ·e^(−μR):
//! ```
//! use tomolith_core::field::{Field, HostField};
//! use tomolith_core::grid::{PatternGrid, VolumeGrid};
//! use tomolith_models::{DoseModel, Work, parallel::Parallel};
//! use tomolith_optics::light::Light;
//! use tomolith_optics::{resin::Resin, vial::index_matched::IndexMatched};
//! let pixels = PatternGrid::full_turn(4, 0.0, 4, 40, 0.1);
//! let light = Light::new(pixels, Resin::absorbing(1.5, 0.1));
//! let grid = VolumeGrid::centered([4, 31, 31], 0.1);
//! let model = Parallel::new(&IndexMatched { radius_mm: 2.0 }, vec![light], grid).unwrap();
//! let mut x = model.new_patterns().unwrap();
//! x.fill(1.0);
//! let mut dose = model.new_dose().unwrap();
//! model.dose(&x, &mut dose, &Work::new()).unwrap();
//! let volume = model.outputs()[0].volume_of(dose.as_slice());
//! let expected = 4.0 * 0.1 * (-0.1f64 * 2.0).exp();
//! assert!((f64::from(*volume.at(2, 15, 15)) / expected - 1.0).abs() < 1e-4);
//! ```

mod block_sparsity;
mod cached;
pub(crate) mod chains;
mod form;
mod kept;
pub mod kernel;
mod loose;
mod mapped;
mod patches;
mod plan;
mod plane;
pub mod radon;
mod regions;
mod strips;
mod tiles;
mod turned;
mod uniform_strips;
mod views;
mod walls;
mod z_overlap;

use crate::{
    Capabilities, Cost, DoseLayout, DoseModel, HostModel, MakeFamily, ModelFamily, ModelInput,
    ModelKind, OpticalScene, PatternLayout, Purpose, Refines, Work, ZCoupling, own_frames,
};
use cached::{CachedEntries, Finding, LightEntries};
use kernel::Isa;
use loose::Loose;
use plan::{KernelPath, LightPlan};
pub use radon::Kernel;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::sync::{Arc, OnceLock};
use tiles::{TILE, Tile, TileEntries};
use tomolith_core::dose::form::Form;
use tomolith_core::dose::{Facts, Regions, Space};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::field::scratch::Scratch;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::parallel::InParallel;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;
use turned::Turned;
use views::SeenViews;

/// Keys of `[model.parallel]`.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// How the light of a pixel column is shared among voxels; the last three for an index-matched vial and
    /// `resin.pure_radon` only.
    pub kernel: Kernel,
}

/// Row of [`MODELS`](super::MODELS).
pub const KIND: ModelKind = ModelKind {
    name: "parallel",
    summary: "Collimated light through a vial that does not change along z: refraction, absorption, pure Radon.",
    example: "[model.parallel]\nkernel = \"distance-driven\"\n",
    schema: tomolith_core::kind::schema_of::<Params>,
    build: MakeFamily {
        read: |section| Ok(Arc::new(section.parse::<Params>()?)),
        unasked: Some(|| Arc::new(Params::default())),
    },
};

impl ModelFamily for Params {
    fn name(&self) -> &'static str {
        KIND.name
    }

    fn capabilities(&self) -> Capabilities {
        Capabilities {
            refines: Refines::Voxels,
            is_along_frames: true,
            ..Capabilities::default()
        }
    }

    fn unsupported(&self, scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> Option<&'static str> {
        scene.beyond_slices()
    }

    fn cost(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Result<Cost> {
        let is_optimized = scene.purpose == Purpose::Optimize;
        Ok(Cost {
            runs_along_rows: true,
            ..if is_optimized {
                stored(scene, grid)
            } else {
                Cost::default()
            }
        })
    }

    /// Where neither stores entries: which parts of the turn stored ones serve depends on the rows.
    fn evaluates_alike(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> bool {
        cached::bytes(scene.lights, scene.vial, grid).is_none()
    }

    fn build(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        let (scene, grid) = (&input.scene, input.grid.clone());
        let (lights, kernel) = (scene.lights.to_vec(), self.kernel);
        let (vial, purpose) = (scene.vial, scene.purpose);
        let model = Parallel::for_purpose(vial, lights, kernel, grid, purpose, input.work)?;
        Ok(Box::new(model))
    }

    fn form(&self, input: &ModelInput<'_>) -> Result<Option<Form>> {
        let scene = &input.scene;
        form::form(
            scene.vial,
            scene.lights,
            self.kernel,
            input.grid,
            input.work,
        )
    }

    /// One adjoint of all pixels: nothing is stored, and the first part of the turn serves all of it.
    fn unscattered(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        let mut input = input.clone();
        input.scene.purpose = Purpose::Evaluate { refine: 1 };
        self.build(&input)
    }

    fn merit(&self) -> String {
        "collimated light and a vial that does not change along z, so one slice's geometry serves all heights".to_owned()
    }
}

/// Bytes of what an optimization stores, 0 where that is too much, and the entries of a call.
pub(crate) fn stored(scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Cost {
    let (lights, vial) = (scene.lights, scene.vial);
    if let [1, ny, nx] = grid.shape {
        return Cost {
            cached_bytes: Some(loose::bytes(lights, nx * ny)),
            ..Cost::default()
        };
    }
    let bytes = cached::bytes(lights, vial, grid);
    Cost {
        cached_bytes: Some(bytes.map_or(0.0, |bytes| bytes + kept::bytes_of_bands(lights, grid))),
        entries: bytes.map_or(0.0, |_| cached::entries(lights, vial, grid)),
        ..Cost::default()
    }
}

/// See the [module page](self).
pub struct Parallel {
    lights: Vec<LightPlan>,
    patterns: Vec<PatternLayout>,
    output: DoseLayout,
    tiles: Vec<Tile>,
    /// Tiles that the turn maps onto one another.
    orbits: Vec<Vec<usize>>,
    kernel: Kernel,
    path: KernelPath,
    /// Lanes of pixels, reused between calls.
    scratch: Scratch,
    updates: OnceLock<u64>,
    /// How entries are found; those of each light; the single entries of a slice that are stored.
    finding: Finding,
    cache: Vec<OnceLock<CachedEntries>>,
    loose: Vec<OnceLock<Loose>>,
}

/// Views whose entries are found together: more need more cache, fewer more passes over the dose.
const GROUP: usize = 8;
/// Groups of all tiles from which on updates are counted of one view a group: counting all was 1.7 s in a profile of the boat of 400³ voxels.
const MANY_GROUPS: usize = 1000;
/// Rows of lanes that one thread does in a row.
const TOGETHER: usize = 256;

impl Parallel {
    /// The model of a vial, its lights and the voxels where dose is wanted.
    ///
    /// # Errors
    /// [`Error::Config`] when there is nothing to light or nothing that absorbs.
    pub fn new(vial: &dyn Vial, lights: Vec<Light>, grid: VolumeGrid) -> Result<Self> {
        Self::under(vial, lights, Kernel::default(), grid, &Work::new())
    }

    /// [`new`](Self::new) with a kernel, which shares a column's light among voxels, as a part of a run.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::Canceled`].
    pub fn under(
        vial: &dyn Vial,
        lights: Vec<Light>,
        kernel: Kernel,
        grid: VolumeGrid,
        work: &Work,
    ) -> Result<Self> {
        Self::planned(vial, lights, kernel, grid, Finding::InEachCall, work)
    }

    /// The model for a purpose: an optimization stores entries where there is room.
    pub(crate) fn for_purpose(
        vial: &dyn Vial,
        lights: Vec<Light>,
        kernel: Kernel,
        grid: VolumeGrid,
        purpose: Purpose,
        work: &Work,
    ) -> Result<Self> {
        let is_kept = || grid.shape[0] == 1 || cached::bytes(&lights, vial, &grid).is_some();
        let finding = match purpose {
            Purpose::Optimize if is_kept() => Finding::Once,
            Purpose::Probe => Finding::OfAllViews,
            _ => Finding::InEachCall,
        };
        Self::planned(vial, lights, kernel, grid, finding, work)
    }

    /// The model of a plan; to find the entries (column, voxel, weight) of all frames once is worth it where a dose is asked for
    /// again and again, and their memory is there ([`cached`]). Of a slice those are kept that its fast kernels do not find.
    fn planned(
        vial: &dyn Vial,
        lights: Vec<Light>,
        kernel: Kernel,
        grid: VolumeGrid,
        finding: Finding,
        work: &Work,
    ) -> Result<Self> {
        if grid.is_empty() {
            return Err(Error::config(
                "grid",
                format!("shape {:?} [z, y, x]", grid.shape),
                "at least one voxel",
            ));
        }
        let [_, ny, nx] = grid.shape;
        let turned = Turned::of_lights(vial, &lights, &grid, finding);
        let repeats = turned.iter().all(Turned::repeats);
        let tiles = Tile::cover([nx, ny], repeats && !turned.is_empty());
        let orbits = (turned.first()).map_or_else(Vec::new, |turned| turned.orbits(&tiles));
        let (mut plans, mut patterns) = (Vec::new(), Vec::new());
        let mut offset = 0;
        for (light, turned) in lights.into_iter().zip(turned) {
            light.check()?;
            check_kernel(kernel, &light, vial)?;
            must_be_even(kernel, &light, vial)?;
            let plan = LightPlan::new(vial, &light, kernel, turned, &grid, &tiles, work);
            work.check()?;
            plans.push(plan);
            let layout = light.layout(offset);
            offset += layout.len();
            patterns.push(layout);
        }
        Ok(Parallel {
            cache: plans.iter().map(|_| OnceLock::new()).collect(),
            loose: plans.iter().map(|_| OnceLock::new()).collect(),
            finding,
            lights: plans,
            patterns,
            output: DoseLayout::new("dose", grid, 0),
            tiles,
            orbits,
            kernel,
            path: KernelPath::of(Isa::in_use()),
            scratch: Scratch::default(),
            updates: OnceLock::new(),
        })
    }

    /// Uses a given instruction set.
    #[cfg(test)]
    pub(crate) fn with_isa(mut self, isa: Isa) -> Self {
        self.path = KernelPath::of(isa);
        self
    }

    fn entries(&self, light: usize, work: &Work) -> Result<LightEntries<'_>> {
        let (plan, path, cache) = (&self.lights[light], self.path, &self.cache[light]);
        let cached = match (cache.get(), self.finding) {
            (Some(found), _) => found,
            (None, Finding::Once) => {
                let found = CachedEntries::of(plan, path, &self.tiles, work)?;
                // Whoever comes first; all would find the same
                cache.get_or_init(|| found)
            }
            (None, _) => cache.get_or_init(CachedEntries::in_each_call),
        };
        Ok(LightEntries { plan, path, cached })
    }

    /// The stored single entries of a light of a slice; None where none are.
    fn loose(&self, light: usize, work: &Work) -> Result<Option<&Loose>> {
        if self.finding == Finding::Once && self.loose[light].get().is_none() {
            let found = Loose::of(self, &self.lights[light], loose::MOST, work)?;
            let _ = self.loose[light].set(found);
        }
        Ok(self.loose[light].get())
    }

    /// Whether there is a single slice, whose rows have no lanes.
    fn is_plane(&self) -> bool {
        self.output.row == 1
    }

    /// dose += light of these views of one light.
    fn add_light(
        &self,
        light: usize,
        seen: &SeenViews,
        x: &[f32],
        dose: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        if self.is_plane() {
            return self.add_light_of_plane(light, seen, x, dose, work);
        }
        self.add_kept(light, seen, None, x, dose, work)
    }

    /// grad = Aᵀ c for these views of one light.
    fn adjoint_light(
        &self,
        light: usize,
        seen: &SeenViews,
        cotangent: &[f32],
        grad: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        if self.is_plane() {
            return self.adjoint_light_of_plane(light, seen, cotangent, grad, work);
        }
        self.adjoint_kept(light, seen, cotangent, grad, work)
    }

    /// A cotangent as the lanes of the kernel, where these are not its slices.
    fn of_rows(&self, plan: &LightPlan, cotangent: &[f32]) -> Option<HostField> {
        plan.levels.spread.as_ref().map(|spread| {
            let columns = cotangent.len() / self.output.row;
            let mut of_rows = self.scratch.borrow(columns * plan.levels.row);
            spread.collect(cotangent, &mut of_rows);
            of_rows
        })
    }
}

/// Views in groups, which begin at multiples of [`GROUP`].
fn groups(views: Range<usize>) -> impl Iterator<Item = Range<usize>> {
    let mut first = views.start;
    std::iter::from_fn(move || {
        let end = (first / GROUP + 1) * GROUP;
        let group = first..end.min(views.end);
        first = group.end;
        (!group.is_empty()).then_some(group)
    })
}

/// Updates of the views of one of so many groups; of very many, those of a view in its middle stand for the others.
fn updates_of_group(
    views: Range<usize>,
    groups: usize,
    mut of_view: impl FnMut(usize) -> u64,
) -> u64 {
    if groups < MANY_GROUPS {
        return views.map(of_view).sum();
    }
    views.len() as u64 * of_view(views.start + views.len() / 2)
}

/// Refuses a kernel of pure Radon where light bends or is weakened.
fn check_kernel(kernel: Kernel, light: &Light, vial: &dyn Vial) -> Result<()> {
    let name = kernel.name();
    let refused = |found: String| {
        Err(Error::config(
            "model.parallel.kernel",
            found,
            "\"distance-driven\" (\"line\", \"linear\" and \"strip\" need an index-matched vial and resin.pure_radon = true)",
        ))
    };
    if kernel == Kernel::DistanceDriven {
        return Ok(());
    }
    if !is_straight(vial, light) {
        return refused(format!(
            "{name:?} needs straight rays, and this vial refracts"
        ));
    }
    if light.bath.is_some() {
        return refused(format!(
            "{name:?} is a kernel of pure Radon, and this bath absorbs"
        ));
    }
    if !light.resin.pure_radon {
        return refused(format!(
            "{name:?} is a kernel of pure Radon, and this resin absorbs"
        ));
    }
    Ok(())
}

/// Why a light is beyond this model because its resin differs from place to place; None when it is not.
#[must_use]
pub fn beyond(light: &Light, vial: &dyn Vial) -> Option<&'static str> {
    if light.resin.gradient.is_some() {
        return Some("the resin's index changes from place to place");
    }
    let map = light.map.as_ref()?;
    if !map.is_flat() {
        Some("the absorption changes along z")
    } else if !is_straight(vial, light) {
        Some("the absorption changes across the plane, and this vial refracts")
    } else {
        None
    }
}

/// Refuses a resin that differs from place to place where light bends, or where nothing absorbs.
fn must_be_even(kernel: Kernel, light: &Light, vial: &dyn Vial) -> Result<()> {
    let refused = |what: &str, reason: &str| Err(Error::unsupported(what, reason));
    let what = if light.resin.gradient.is_some() {
        "resin.gradient"
    } else {
        "resin.absorption_map"
    };
    match (beyond(light, vial), &light.map) {
        (Some(reason), _) => refused(what, reason),
        (None, None) => Ok(()),
        (None, Some(_)) if light.resin.pure_radon => {
            refused(what, "with resin.pure_radon nothing absorbs")
        }
        (None, Some(_)) if kernel != Kernel::DistanceDriven => {
            refused(what, "the kernels of pure Radon do not model absorption")
        }
        (None, Some(_)) => Ok(()),
    }
}

/// Whether light passes the vial as if it were not there: one round wall between equal indices.
pub(crate) fn is_straight(vial: &dyn Vial, light: &Light) -> bool {
    let index = light.resin.refractive_index;
    let outside = vial.surrounding_index(light.surrounding_index, index);
    vial.walls().len() == 1 && vial.is_round() && (outside - index).abs() < 1e-12
}

/// The dose, cut into tiles: for each tile its rows of voxels.
fn tile_rows<'a>(
    tiles: &[Tile],
    dose: &'a mut [f32],
    row: usize,
    nx: usize,
) -> Vec<Vec<&'a mut [f32]>> {
    let mut by_place: Vec<usize> = (0..tiles.len()).collect();
    by_place.sort_by_key(|&i| [tiles[i].start[1], tiles[i].start[0]]);
    let mut rows: Vec<Vec<&mut [f32]>> = tiles.iter().map(|_| Vec::with_capacity(TILE)).collect();
    let mut lines = dose.chunks_mut(nx * row);
    for band in by_place.chunk_by(|&a, &b| tiles[a].start[1] == tiles[b].start[1]) {
        for line in lines.by_ref().take(tiles[band[0]].size[1]) {
            let mut rest = line;
            for &i in band {
                let (tile_row, others) = rest.split_at_mut(tiles[i].size[0] * row);
                rows[i].push(tile_row);
                rest = others;
            }
        }
    }
    rows
}

impl Parallel {
    /// The elements of Aᵀ c of some frames: overwrites these of `grad`.
    pub(crate) fn collect(
        &self,
        frames: Range<usize>,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let (cotangent, grad) = (cotangent.as_slice(), grad.as_mut_slice());
        for (light, light_frames) in own_frames(&self.patterns, &frames) {
            for part in self.lights[light].views.of_frames(light_frames) {
                self.adjoint_light(light, &part, cotangent, grad, work)?;
            }
        }
        Ok(())
    }
}

impl DoseModel for Parallel {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.patterns,
            outputs: std::slice::from_ref(&self.output),
            z_coupling: ZCoupling::None,
            is_linear: true,
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        for (light, light_frames) in own_frames(&self.patterns, &frames) {
            let parts = self.lights[light].views.of_frames(light_frames);
            let share = 1.0 / (self.lights.len() * parts.len()) as f64;
            for part in parts {
                let work = work.part(share);
                self.add_light(light, &part, x.as_slice(), dose.as_mut_slice(), &work)?;
            }
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        _x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        self.collect(frames, cotangent, grad, work)
    }

    fn updates(&self) -> u64 {
        *self.updates.get_or_init(|| self.count_updates())
    }

    fn regions(&self) -> Option<&dyn Regions<HostField>> {
        self.as_regions()
    }

    fn describe(&self) -> String {
        format!(
            "parallel ({} kernel, {} path)",
            self.kernel.name(),
            self.path.isa.name()
        )
    }
}

impl Parallel {
    /// Pairs of voxel and frame of which at least one active pixel lights the voxel, times the angles of a frame; of large models within a part in a thousand.
    fn count_updates(&self) -> u64 {
        let nz = self.output.grid.shape[0];
        let of_light = |(light, plan): (usize, &LightPlan)| {
            let found = (!self.is_plane()).then(|| self.entries(light, &Work::new()));
            if let Some(Ok(entries)) = found
                && entries.cached.is_kept()
            {
                return entries.cached.updates(plan, nz);
            }
            let period = plan.turned.period;
            let all = self.tiles.len() * groups(0..period).count();
            let tiles = self.tiles.iter().enumerate();
            let of_tiles = tiles.par_map_with(TileEntries::default, |entries, (index, tile)| {
                let mut of_view = |view| plan.updates_in(view, index, tile, nz, entries);
                groups(0..period)
                    .map(|views| updates_of_group(views, all, &mut of_view))
                    .sum::<u64>()
            });
            of_tiles.into_iter().sum::<u64>()
        };
        self.lights.iter().enumerate().map(of_light).sum()
    }
}

#[cfg(test)]
mod tests;
