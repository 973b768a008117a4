//! Dose models of random paths of scattered light, drawn and followed on the card.
//!
//! **Model** [`tomolith_core::dose::paths`], the `monte_carlo` model of the processor as data. Unscattered light is a [`GpuRays`]. Another kernel follows what is
//! scattered: a thread takes the segments of a pixel one by one, goes on from a random point of each to the wall of the resin, and from there no more, for what
//! leaves the resin is gone; and so on from event to event. Segments are followed through cells as those of rays are through voxels, with the same code.
//! Dose and adjoint are two visitors of the same walk.
//!
//! **Random numbers** Four of an event: whether it goes on, where, and in which direction (cosine, azimuth). They are the hash `pcg4d` of four words: the pixel's number, that
//! of the path and the event, and the seed (M. Jarzynski, M. Olano, *Hash functions for GPU rendering*, J. Comput. Graph. Techn. 9(3), 2020). So they depend on nothing
//! that a thread did before. They are not the processor's: its matrix of a seed is another one, with the same mean.
//!
//! **Sums** As of [rays](crate::rays): deposits are whole multiples of a unit in 64 bits a cell, so a seed has the same bits in every run. Dose and adjoint
//! are two programs, which a compiler may round differently: some event in 10⁷ is decided differently.
//!
//! **Cost** About 150 operations an event, and those of rays for each cell passed. Memory: that of rays, and a few fields on cells.

use crate::cells::DeviceCells;
use crate::device::{Buffer, Gpu};
use crate::field::GpuField;
use crate::rays::{GpuRays, Walk, add_sums, adding, collecting, head, unit_of};
use crate::scattered::voxels_of;
use crate::strips::must_be_bound;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use tomolith_core::dose::form::Masked;
use tomolith_core::dose::paths::{LightPaths, PathForm, PathGeometry, PhaseForm};
use tomolith_core::dose::{
    DoseModel, Facts, PatternLayout, Renewal, Space, Work, ZCoupling, own_frames,
};
use tomolith_core::error::Result;
use tomolith_core::field::Field;

/// Heights of a wall without ends, in cells: light that far has gone.
const FAR: f32 = 1e6;
/// How much more an event takes than a voxel that a segment passes, where light passes some ten cells from one event to the next.
const EVENT: u64 = 4;
/// Events of a path, about; few have more.
const EVENTS: usize = 16;

/// What models of a geometry share.
struct Geometry {
    data: Arc<PathGeometry>,
    cells: DeviceCells,
    /// One for each (y, x) of voxels: all of a voxel has the dose of cells.
    shares: Buffer,
    /// The table of each light's phase function; one number where it is not scattered, or by a formula.
    tables: Vec<Buffer>,
}

/// A dose model whose fields are on a graphics card.
pub(crate) struct GpuPaths {
    gpu: Gpu,
    geometry: Arc<Geometry>,
    straight: GpuRays,
    /// How often other paths have been drawn.
    round: AtomicU64,
}

impl Geometry {
    fn new(gpu: &Gpu, data: &Arc<PathGeometry>) -> Result<Self> {
        let output = &data.straight.output;
        let [_, ny, nx] = output.grid.shape;
        let most = data.cells.layout.len().max(ny * nx);
        must_be_bound(gpu, 4 * most as u64, "a larger model.monte_carlo.smooth")?;
        let table = |light: &Option<LightPaths>| match light.as_ref().map(|light| &light.phase) {
            Some(PhaseForm::Table(cosines)) => gpu.upload(cosines),
            _ => gpu.buffer(4),
        };
        Ok(Geometry {
            data: data.clone(),
            cells: DeviceCells::new(gpu, &data.cells, output.row),
            shares: gpu.upload(&vec![1.0f32; ny * nx]),
            tables: data.lights.iter().map(table).collect(),
        })
    }
}

impl GpuPaths {
    /// The model of a form on a card.
    /// Refuses what [`GpuRays::new`] refuses, and cells that do not fit a binding.
    pub(crate) fn new(gpu: &Gpu, form: &PathForm, work: &Work) -> Result<Self> {
        let straight = Masked {
            geometry: form.geometry.straight.clone(),
            dark: form.dark.clone(),
            factor: form.factor,
        };
        Ok(GpuPaths {
            gpu: gpu.clone(),
            geometry: gpu.shared(
                |known: &Geometry| Arc::ptr_eq(&known.data, &form.geometry),
                || Geometry::new(gpu, &form.geometry),
            )?,
            straight: GpuRays::new(gpu, &straight, work)?,
            round: AtomicU64::new(0),
        })
    }

    fn data(&self) -> &PathGeometry {
        &self.geometry.data
    }

    fn patterns(&self) -> &[PatternLayout] {
        &self.data().straight.patterns
    }

    /// Follows what is scattered out of some frames, counted through all lights.
    fn follow(&self, frames: &Range<usize>, fields: &Fields<'_>, work: &Work) -> Result<()> {
        let cells = &self.data().cells.layout;
        for (light, frames) in own_frames(self.patterns(), frames) {
            let Some(paths) = &self.data().lights[light] else {
                continue;
            };
            let walk = Walk {
                name: fields.name,
                source: fields.source,
                patterns: fields.patterns,
                output: cells,
                corner: [self.data().corner[0], self.data().corner[1]],
                voxels: vec![(0..cells.len(), fields.cells.clone())],
                scale: fields.scale,
                adds: true,
                table: &self.geometry.tables[light],
                numbers: self.numbers(paths),
                updates: EVENT * paths.updates,
                ways: EVENTS,
            };
            self.straight.follow(light, &frames, &walk, work)?;
        }
        Ok(())
    }

    /// What the kernels know of a light's paths: [`NUMBERS`].
    fn numbers(&self, paths: &LightPaths) -> Vec<u32> {
        let data = self.data();
        let seed = data.seed.wrapping_add(self.round.load(Ordering::Relaxed));
        let (g, intervals) = match &paths.phase {
            PhaseForm::HenyeyGreenstein(g) => (*g, 0),
            PhaseForm::Table(cosines) => (0.0, cosines.len() - 1),
        };
        let [low, high] = data.wall.ends.map(|z| z.clamp(-FAR, FAR));
        let scales = [
            data.edge as f32,
            -data.corner[2],
            data.wall.half,
            low,
            high,
            paths.albedo,
            paths.least,
            g,
        ];
        let words = [
            u32::from(data.wall.is_round),
            intervals as u32,
            data.orders as u32,
            seed as u32,
            (seed >> 32) as u32,
        ];
        scales.map(f32::to_bits).into_iter().chain(words).collect()
    }

    /// What voxels see of a field on cells, or its transpose, where that is not the field.
    fn sharper(&self, field: &Buffer) -> Option<Buffer> {
        let strength = self.data().sharpened?;
        Some(self.geometry.cells.sharper(strength, field))
    }

    /// The largest energy that a segment on cells may have, for a pixel of value 1: an event sends on less than it meets, or, by chance, `least`.
    fn brightest(&self) -> f32 {
        let paths = self.data().lights.iter().flatten();
        let by_chance = paths.fold(0.0f32, |most, paths| most.max(paths.least));
        let voxels = (self.data().edge * self.data().edge) as f32;
        (self.straight.brightest() / voxels).max(self.straight.factor() * by_chance)
    }
}

/// Fields that paths go between.
struct Fields<'a> {
    name: &'static str,
    source: &'a dyn Fn() -> String,
    patterns: &'a GpuField,
    cells: Vec<&'a Buffer>,
    scale: f32,
}

impl Renewal<GpuField> for GpuPaths {
    /// Draws other paths, whatever the patterns are.
    fn renew(&self, iteration: usize, _x: &GpuField, _run: &Work) -> Result<bool> {
        let round = (iteration.saturating_sub(1) / self.data().renew) as u64;
        Ok(self.round.swap(round, Ordering::Relaxed) != round)
    }
}

impl DoseModel for GpuPaths {
    type Field = GpuField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            z_coupling: ZCoupling::Full,
            ..self.straight.facts()
        }
    }

    fn new_field(&self, space: Space) -> Result<GpuField> {
        self.straight.new_field(space)
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &GpuField,
        dose: &mut GpuField,
        work: &Work,
    ) -> Result<()> {
        (self.straight).dose_of(frames.clone(), x, dose, work)?;
        let energy = x.max_abs() * self.brightest();
        if energy == 0.0 {
            return self.gpu.check();
        }
        let unit = unit_of(energy);
        let field = || GpuField::of_lengths(&self.gpu, vec![self.data().cells.layout.len()]);
        let (low, high, sums) = (field(), field(), field());
        let fields = Fields {
            name: "dose of paths",
            source: &dose_source,
            patterns: x,
            cells: vec![&low.pieces()[0], &high.pieces()[0]],
            scale: 1.0 / unit,
        };
        self.follow(&frames, &fields, work)?;
        add_sums([&low, &high], unit, None, &sums);
        let sums = &sums.pieces()[0];
        let sharp = self.sharper(sums);
        for piece in voxels_of(dose, self.data().straight.output.row) {
            let seen = sharp.as_ref().unwrap_or(sums);
            (self.geometry.cells).spread(seen, &self.geometry.shares, &piece);
        }
        self.gpu.check()
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &GpuField,
        cotangent: &GpuField,
        grad: &mut GpuField,
        work: &Work,
    ) -> Result<()> {
        (self.straight).pullback_of(frames.clone(), x, cotangent, grad, work)?;
        let gathered = self.geometry.cells.dark(1);
        for piece in voxels_of(cotangent, self.data().straight.output.row) {
            (self.geometry.cells).gather(&gathered, &self.geometry.shares, &piece);
        }
        let seen = self.sharper(&gathered).unwrap_or(gathered);
        let fields = Fields {
            name: "adjoint of paths",
            source: &adjoint_source,
            patterns: grad,
            cells: vec![&seen],
            scale: 1.0,
        };
        self.follow(&frames, &fields, work)?;
        self.gpu.check()
    }

    fn renewal(&self) -> Option<&dyn Renewal<GpuField>> {
        (self.data().renew > 0).then_some(self as _)
    }

    fn updates(&self) -> u64 {
        let paths = self.data().lights.iter().flatten();
        self.data().straight.updates + paths.map(|paths| paths.updates).sum::<u64>()
    }

    fn describe(&self) -> String {
        let place = self.gpu.with(self.straight.stored_bytes(), "rays");
        format!("{} ({place})", self.data().summary)
    }
}

/// What the kernels of paths are told, behind what those of rays are.
const NUMBERS: &str = "edge: f32, floor: f32, half: f32, low_end: f32, high_end: f32, albedo: f32, least: f32, g: f32,
    is_round: u32, intervals: u32, orders: u32, seed_low: u32, seed_high: u32,";

/// Light that is scattered, on cells.
const CELLS: &str = concat!(
    "
@group(0) @binding(5) var<storage, read> table: array<f32>;
",
    include_str!("shaders/paths.wgsl")
);

fn dose_source() -> String {
    adding(&head(NUMBERS, CELLS))
}

fn adjoint_source() -> String {
    collecting(&head(NUMBERS, CELLS))
}
