//! What horizontal faces cost that lie inside rows of pixels.
//!
//! **Model** Level light ends with a row of pixels, so a horizontal face of area A prints at the nearest edge of a row, d from where it should be: A·d of the part's volume V
//! is missing or too much, a share of Σ A·d/V. Light that is moved along z moves these edges, so moves within half a row are tried. Slanted surfaces lie at every height alike; what
//! they lose is due to the size of pixels, and is left out.
//!
//! **Limits** Where light spreads over rows, or what it makes diffuses in the print in time, rows have no sharp edges: gray values put a face inside a row, and nothing is said.

use super::ResolvedJob;
use super::acting::{Acting, acting_on};
use crate::grid::{PatternGrid, Volume};
use crate::report::number::significant;
use crate::target::HorizontalFaces;

/// Steps of a row in which moves are tried.
const STEPS: i32 = 64;

/// Share of a part's volume between its faces and the edges of rows from which on people are told before a run.
const WORTH_TELLING: f64 = 0.01;

impl ResolvedJob {
    /// Horizontal faces of species `s` inside rows of pixels, in level light; `inside`: the inside fractions of its voxels.
    pub(crate) fn row_ends(&self, s: usize, inside: &Volume<f32>) -> Option<RowEnds> {
        self.row_ends_by(s, || Some(HorizontalFaces::of(inside)))
    }

    /// The same; `faces`: those of a part that is neither a prism nor a mesh.
    fn row_ends_by(
        &self,
        s: usize,
        faces: impl FnOnce() -> Option<HorizontalFaces>,
    ) -> Option<RowEnds> {
        let shape = self.species[s].shape.as_ref();
        let spreads = self
            .optics
            .lights
            .iter()
            .any(|light| light.point_spread.is_some());
        if shape.is_gray() || spreads || self.schedule().is_some() {
            return None;
        }
        if self.optics.scene().beyond_slices().is_some() {
            return None;
        }
        let lights = acting_on(self, s);
        if let Some(part_mm) = shape.upright_mm() {
            return RowEnds::of_prism(part_mm, &lights);
        }
        let faces = match (shape.meshes().as_slice(), shape.volume_mm3()) {
            ([mesh], Some(volume_mm3)) => HorizontalFaces::of_mesh(mesh, volume_mm3),
            _ => faces()?,
        };
        let part_mm = shape.bounds_mm().map(|corner| corner[2]);
        RowEnds::of(&faces, part_mm, &lights)
    }

    /// What people should know beforehand of faces inside rows of pixels: where moving the light helps. The rows of a toy are not those of its job.
    pub(crate) fn warning_of_row_ends(&self, s: usize, inside: &Volume<f32>) -> Option<String> {
        let ends = (!self.is_toy).then(|| self.row_ends(s, inside))??;
        let offset_mm = self.offset_worth_telling(&ends)?;
        let percent = |share: f64| significant((1000.0 * share).round() / 10.0, 2);
        let [across, up] = offset_mm.map(|mm| significant(mm, 4));
        Some(format!(
            "horizontal faces of the part lie inside rows of pixels, but light ends with a row: {} % of the part's volume lies between. {} = [{across}, {up}] leaves {} %",
            percent(ends.share),
            ends.move_key(),
            percent(ends.best_move.1)
        ))
    }

    /// The `light.offset_mm` with which horizontal faces of the part lie nearest to edges of rows; None where that brings little, light is not level, or the
    /// part is neither a prism nor one closed mesh.
    #[must_use]
    pub fn better_offset_mm(&self) -> Option<[f64; 2]> {
        self.offset_worth_telling(&self.row_ends_by(0, || None)?)
    }

    fn offset_worth_telling(&self, ends: &RowEnds) -> Option<[f64; 2]> {
        let moved = ends.worthy_move()?;
        let [across, up] = self.optics.lights[ends.light.0].pixels.offset_mm;
        let micrometers = |mm: f64| (mm * 1e3).round() / 1e3 + 0.0;
        (ends.share >= WORTH_TELLING).then(|| [across, micrometers(up + moved)])
    }
}

/// Horizontal faces of a part inside rows of pixels.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RowEnds {
    /// Share of the part's volume between faces and the nearest edges of rows.
    pub(crate) share: f64,
    /// The move of the light along z with which the least would lie between, mm, and how much.
    pub(crate) best_move: (f64, f64),
    /// Of a prism: its ends, mm, and the nearest edges of rows.
    pub(crate) ends: Option<[[f64; 2]; 2]>,
    /// Whose rows: the light's place, and its name where there are several.
    pub(crate) light: (usize, Option<String>),
}

impl RowEnds {
    /// Those of a prism between two heights, mm.
    pub(crate) fn of_prism(part_mm: [f64; 2], lights: &[Acting<'_>]) -> Option<Self> {
        let faces = HorizontalFaces {
            volume_mm3: part_mm[1] - part_mm[0],
            areas: part_mm.map(|z| (z, 1.0)).to_vec(),
        };
        let mut worst = Self::of(&faces, part_mm, lights)?;
        let limiting = lights.iter().find(|acting| acting.index == worst.light.0)?;
        let rows = Rows::of(&limiting.light.pixels);
        // In the middle of a row light goes on to its end: beyond the part
        let outward = [1e-6, -1e-6];
        let nearest = |i: usize| rows.edge((rows.above(part_mm[i]) + outward[i]).round());
        worst.ends = Some([part_mm, [nearest(0), nearest(1)]]);
        Some(worst)
    }

    /// Those of a part between two heights, mm, and of the light between whose rows most of it lies.
    pub(crate) fn of(
        faces: &HorizontalFaces,
        part_mm: [f64; 2],
        lights: &[Acting<'_>],
    ) -> Option<Self> {
        let of_light = |acting: &Acting<'_>| {
            let rows = Rows::of(&acting.light.pixels);
            let share = |moved| rows.moved(moved).between(&faces.areas) / faces.volume_mm3;
            let moves = (-STEPS / 2..=STEPS / 2).map(|i| f64::from(i) / f64::from(STEPS));
            let moves = moves.map(|rows_up| rows_up * rows.pitch);
            let moves = moves.filter(|&moved| moved == 0.0 || rows.moved(moved).hold(part_mm));
            let tried = moves.map(|moved| (moved, share(moved)));
            // Of moves that are as good, the shortest
            let order = |a: &(f64, f64), b: &(f64, f64)| {
                (a.1 + 1e-9 * a.0.abs()).total_cmp(&(b.1 + 1e-9 * b.0.abs()))
            };
            RowEnds {
                share: share(0.0),
                best_move: tried.min_by(order).unwrap_or_default(),
                ends: None,
                light: (acting.index, acting.name.map(str::to_owned)),
            }
        };
        let found = lights.iter().map(of_light);
        found.reduce(|worst, other| {
            if other.share > worst.share {
                other
            } else {
                worst
            }
        })
    }

    /// The move of the light along z that makes up for more than half of it, mm.
    pub(crate) fn worthy_move(&self) -> Option<f64> {
        let (moved, left) = self.best_move;
        (left < self.share / 2.0).then_some(moved)
    }

    pub(crate) fn move_key(&self) -> String {
        match &self.light {
            (index, Some(_)) => format!("light[{index}].offset_mm"),
            (_, None) => "light.offset_mm".to_owned(),
        }
    }
}

/// Rows of pixels, from the upper edge down.
#[derive(Clone, Copy)]
struct Rows {
    bottom: f64,
    top: f64,
    pitch: f64,
}

impl Rows {
    fn of(pixels: &PatternGrid) -> Self {
        let [low, high] = pixels.field_mm();
        Rows {
            bottom: low[1],
            top: high[1],
            pitch: pixels.pitch_mm[1],
        }
    }

    fn moved(self, mm: f64) -> Self {
        Rows {
            bottom: self.bottom + mm,
            top: self.top + mm,
            ..self
        }
    }

    /// How many rows lie above a height.
    fn above(&self, z: f64) -> f64 {
        (self.top - z) / self.pitch
    }

    fn edge(&self, rows_above: f64) -> f64 {
        self.top - rows_above * self.pitch
    }

    /// Whether the whole part lies within the light.
    fn hold(&self, part_mm: [f64; 2]) -> bool {
        self.bottom - 1e-9 <= part_mm[0] && part_mm[1] <= self.top + 1e-9
    }

    /// Volume between faces and the nearest edges.
    fn between(&self, areas: &[(f64, f64)]) -> f64 {
        let distance = |z: f64| {
            let rows = self.above(z);
            (rows - rows.round()).abs() * self.pitch
        };
        areas.iter().map(|&(z, area)| area * distance(z)).sum()
    }
}

#[cfg(test)]
mod tests {
    use crate::job::resolve::ResolvedJob;
    use crate::job::tests::{FULL, job_of};
    use crate::models::Work;

    #[test]
    fn faces_inside_rows_are_told_before_a_run_where_moving_the_light_helps() {
        // A gear from z = −1.5 to 1.5 mm in rows of 0.05 mm
        let warnings = |offset: &str, more: &[&str]| {
            let set = format!("light[0].offset_mm={offset}");
            let job = ResolvedJob::new(&job_of(FULL, &[&[&*set], more].concat())).unwrap();
            let voxels = job.voxels(&job.grid, &Work::new()).unwrap();
            let mut warnings = job.warnings_of(&voxels).unwrap();
            warnings.retain(|text| text.contains("rows of pixels"));
            warnings
        };
        assert!(warnings("[0, 0]", &[]).is_empty());
        assert_eq!(
            warnings("[0.1, 0.01875]", &[]),
            [
                "horizontal faces of the part lie inside rows of pixels, but light ends with a row: 1.5 % of the part's volume lies between. light.offset_mm = [0.1, 0] leaves 0 %"
            ]
        );
        // Radicals that diffuse round the edges of rows
        let in_time = "schedule={turns=3, seconds_per_turn=20, power={energy_mj_per_mm2=1.1}}";
        let diffusing = [
            in_time,
            "material={diffusion={mm2_per_s=1e-4}}",
            "resin.critical_dose_mj_per_mm3=0.8",
        ];
        assert!(warnings("[0.1, 0.01875]", &diffusing).is_empty());
        // A projector whose pixels light their neighbors
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("psf.csv");
        std::fs::write(&file, "0, 1\n0.1, 0.4\n0.25, 0\n").unwrap();
        let blurred = format!("light[0].psf={file:?}");
        assert!(warnings("[0.1, 0.01875]", &[&blurred]).is_empty());
    }
}
