//! The model as data that a backend computes elsewhere: see [`tomolith_core::dose::strips`].

use super::cached::Finding;
use super::plan::LightPlan;
use super::radon::Kernel;
use super::strips::{Beam, Major};
use super::tiles::Tile;
use super::{Parallel, Vial, VolumeGrid, Work};
use tomolith_core::dose::form::{Form, Masked};
use tomolith_core::dose::strips::{self, LightStrips, ResinRow, StripGeometry};
use tomolith_core::error::Result;
use tomolith_core::parallel::InParallel;
use tomolith_optics::light::Light;

/// The form of a model; None of a single slice, a kernel of pure Radon, or resin that differs from place to place.
pub(super) fn form(
    vial: &dyn Vial,
    lights: &[Light],
    kernel: Kernel,
    grid: &VolumeGrid,
    work: &Work,
) -> Result<Option<Form>> {
    let is_even = lights.iter().all(|light| light.map.is_none());
    if grid.shape[0] == 1 || kernel != Kernel::DistanceDriven || !is_even {
        return Ok(None);
    }
    let (lights, finding) = (lights.to_vec(), Finding::OfAllViews);
    let model = Parallel::planned(vial, lights, kernel, grid.clone(), finding, work)?;
    Ok(Some(Form::Strips(Masked::new(model.geometry()))))
}

impl Parallel {
    /// The geometry of a model for which [`form`] has one.
    pub(crate) fn geometry(&self) -> StripGeometry {
        let lights = self
            .lights
            .iter()
            .map(|plan| plan.strips(&self.output.grid));
        StripGeometry {
            lights: lights.collect(),
            scattered: Vec::new(),
            patterns: self.patterns.clone(),
            output: self.output.clone(),
            tiles: self.tiles.iter().map(tile).collect(),
        }
    }
}

fn tile(tile: &Tile) -> strips::Tile {
    let words = |at: [usize; 2]| at.map(|i| i as u32);
    strips::Tile {
        start: words(tile.start),
        size: words(tile.size),
    }
}

impl LightPlan {
    fn strips(&self, grid: &VolumeGrid) -> LightStrips {
        let [_, ny, nx] = grid.shape;
        let rows = |major, count: usize| {
            let row = |row: usize| self.walls.resin_row(major, row as i64).form();
            (0..count).map(row).collect::<Vec<ResinRow>>()
        };
        let sides = self.views.sides();
        let source = |slot| {
            let of_side = |side| {
                let has_side = sides.contains(&side);
                has_side.then(|| self.views.pixel_column(slot, side) as u32)
            };
            [of_side(0), of_side(1)]
        };
        let spread = self.levels.spread.as_ref();
        LightStrips {
            strips: self
                .beams
                .iter()
                .par_map(|beam| self.of_beam(beam))
                .concat(),
            beams: beams(&self.beams),
            meetings: self.meetings.iter().map(|m| [m.first, m.end]).collect(),
            views: self.views.count(),
            columns: self.columns,
            sources: (0..self.lit.len()).map(source).collect(),
            is_pure_radon: self.deposit.pure_radon,
            resin_rows: [rows(Major::X, nx), rows(Major::Y, ny)],
            to_lanes: self.levels.overlaps.form(true),
            to_rows: self.levels.overlaps.form(false),
            spread: spread.map(|spread| [true, false].map(|up| spread.form(up))),
        }
    }

    fn of_beam(&self, beam: &Beam) -> Vec<strips::Strip> {
        let share = self.deposit.active_share;
        let strip = |strip: &super::strips::Strip| {
            let (power, row_mm) = (f64::from(strip.power), f64::from(strip.row_mm));
            let slot = beam.frame as usize * self.columns + strip.column as usize;
            let base = if self.deposit.pure_radon {
                power * row_mm
            } else {
                power * share
            };
            strips::Strip {
                edges: strip.edges,
                span: strip.span,
                base: base as f32,
                per_row: self.deposit.log_per_row(row_mm) as f32,
                column: strip.column,
                upward: u32::from(strip.upward),
                is_lit: u32::from(self.is_lit(slot)),
                padding: 0,
            }
        };
        beam.strips.iter().map(strip).collect()
    }
}

fn beams(beams: &[Beam]) -> Vec<strips::Beam> {
    let mut first = 0;
    let beam = |beam: &Beam| {
        let begin = first;
        first += beam.strips.len() as u32;
        strips::Beam {
            strips: [begin, first],
            view: beam.frame,
            along_y: beam.major == Major::Y,
        }
    };
    beams.iter().map(beam).collect()
}
