//! Patterns that are given: those of an earlier run, of another program, or of a coarser level.
//!
//! **Equation** x at a pixel is the value of the given patterns at its place, linear between the middles of their frames, rows and
//! columns and 0 beyond their field, times frames given / frames wanted: a frame that stands for a larger arc holds more dose. Patterns
//! of the same shape are taken as they are. Frame 0 of both has the same azimuth, and both cover the same arc.
//!
//! **Parameters** see [`Params`]; the file is `patterns.npz` of a run folder, or any `.npz` with an array `patterns` \[angle, row,
//! column\] (`patterns_<light>`, in the order of the job's lights, when there are several); `patterns_raw`, the values before
//! quantization, is preferred. Its field of view is that of the job's light.
//!
//! **Cost** no model call. **Limits** none on the model: patterns are energies, whatever its unknowns are.
//!
//! ```
//! use tomolith_core::grid::{PatternGrid, Patterns};
//! use tomolith_optimize::start::given::resample;
//! // one row of two columns of 2 mm, two frames
//! let mut coarse = Patterns::dark(PatternGrid::full_turn(2, 0.0, 1, 2, 2.0));
//! coarse.values = vec![0.0, 4.0, 2.0, 2.0];
//! let fine = resample(&coarse, &PatternGrid::full_turn(4, 0.0, 1, 4, 1.0));
//! // four columns of 1 mm at −1.5 … 1.5, the two of before at ∓1; half the dose in each of twice as many frames
//! assert_eq!(fine.frame(0), [0.0, 0.5, 1.5, 2.0]);
//! assert_eq!(fine.frame(1)[1..3], [0.75, 1.25]); // between frames
//! ```

use super::{BuildStart, InitialPatterns, StartInput, starts};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::fmt;
use std::path::PathBuf;
use tomolith_core::dose::Work;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::{PatternGrid, Patterns};
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::parallel::InParallel;
use tomolith_io::npy::read_patterns;

/// The parameters of `patterns`.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// The file with the patterns, `.npz`; relative to the job file
    pub file: PathBuf,
    /// Where neither job nor light set a largest pixel: another start, as in `{ fbp = {} }`, whose largest pixel is the bound; when left out, that of the file
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Map<String, Value>>")]
    pub bounds_as: Option<Value>,
    /// Whether they are multiplied by the factor with which their loss is lowest, where the dose is linear in them (default false)
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub scaled: bool,
    /// With `scaled`, further files: the start is the one with the lowest loss
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub or: Vec<PathBuf>,
    /// With `scaled`, one more start, a step ahead: `file` + (the last file but one − the last), dark where negative; the last file is then no start by itself (default false)
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub continued: bool,
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildStart<F>> {
    Kind {
        name: "patterns",
        summary: "patterns of a file: those of an earlier run, or of another program",
        example: "[start.patterns]\nfile = \"patterns.npz\"",
        schema: schema_of::<Params>,
        build: |section| Ok(Box::new(GivenFiles::read(section)?)),
    }
}

/// Patterns of files, as a job begins with them.
pub struct GivenFiles<F: Field = HostField> {
    /// Those that it begins with.
    pub first: OfFile,
    /// The start whose largest pixel bounds the pixels; None: these patterns.
    pub bounds_as: Option<Box<dyn InitialPatterns<F>>>,
    /// Whether they are made as bright as suits the objective best.
    pub scaled: bool,
    /// Further ones, of which it takes the best.
    pub or: Vec<OfFile>,
    /// What the first ones become when the step between two others is added.
    pub step: Option<[OfFile; 2]>,
}

impl<F: Field> fmt::Debug for GivenFiles<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "GivenFiles({:?}, scaled: {})", self.first, self.scaled)
    }
}

impl<F: Field> GivenFiles<F> {
    fn read(section: &Section) -> Result<Self> {
        let params: Params = section.parse()?;
        let bounds_as = |value| section.within("bounds_as", value).read(starts::<F>());
        let at = |file: PathBuf| OfFile(section.file(&file));
        let first = at(params.file);
        let mut or: Vec<OfFile> = params.or.into_iter().map(at).collect();
        if !params.scaled && (params.continued || !or.is_empty()) {
            let key = if params.continued { "continued" } else { "or" };
            return Err(Error::config(
                format!("{}.{key}", section.path),
                "starts to choose among, without `scaled`",
                "scaled = true, with which the start of the lowest loss is taken; or `file` alone",
            ));
        }
        let from = or.pop_if(|_| params.continued);
        if params.continued && from.is_none() {
            return Err(Error::config(
                format!("{}.or", section.path),
                "no file, where `continued` needs one",
                "at least one file, or no `continued`",
            ));
        }
        let to = or.last().unwrap_or(&first).clone();
        Ok(GivenFiles {
            first,
            bounds_as: params.bounds_as.map(bounds_as).transpose()?,
            scaled: params.scaled,
            or,
            step: from.map(|from| [from, to]),
        })
    }
}

/// Patterns of a file, read on demand.
#[derive(Clone, Debug)]
pub struct OfFile(pub PathBuf);

impl OfFile {
    /// The patterns of the file, on the field of view and the arc of these grids, one per light.
    ///
    /// # Errors
    /// [`Error::Format`] for those of another number of lights, and what reading says.
    pub fn read(&self, lights: &[&PatternGrid]) -> Result<Vec<Patterns>> {
        let arrays = read_patterns(&self.0)?;
        if arrays.len() != lights.len() {
            return Err(Error::format(
                self.0.clone(),
                format!("patterns of {} lights", arrays.len()),
                format!("patterns of {}, one per light of the job", lights.len()),
            ));
        }
        let patterns = arrays
            .into_iter()
            .zip(lights)
            .map(|(array, light)| Patterns {
                grid: with_shape(light, array.shape),
                values: array.raw.unwrap_or(array.shown),
            });
        Ok(patterns.collect())
    }
}

/// Patterns at hand, one per light.
#[derive(Clone, Debug)]
pub struct Given(pub Vec<Patterns>);

impl<F: Field> InitialPatterns<F> for OfFile {
    fn is_given(&self) -> bool {
        true
    }

    fn patterns(&self, input: &StartInput<F>, work: &Work) -> Result<F> {
        let lights = input.model.patterns().iter();
        let grids: Vec<&PatternGrid> = lights.map(|light| &light.grid).collect();
        Given(self.read(&grids)?).patterns(input, work)
    }
}

impl<F: Field> InitialPatterns<F> for GivenFiles<F> {
    fn is_given(&self) -> bool {
        true
    }

    fn files(&self) -> Option<&GivenFiles<F>> {
        Some(self)
    }

    fn patterns(&self, input: &StartInput<F>, work: &Work) -> Result<F> {
        self.first.patterns(input, work)
    }
}

impl<F: Field> InitialPatterns<F> for Given {
    fn is_given(&self) -> bool {
        true
    }

    fn patterns(&self, input: &StartInput<F>, _: &Work) -> Result<F> {
        let lights = input.model.patterns();
        if self.0.len() != lights.len() {
            return Err(Error::shape(
                "lights of the given patterns",
                vec![lights.len()],
                vec![self.0.len()],
            ));
        }
        let mut x = input.model.new_patterns()?;
        // Images are host memory: their pixels are sorted there
        let mut values = vec![0.0; x.len()];
        for (given, light) in self.0.iter().zip(lights) {
            light.fill_field(&resample(given, &light.grid), &mut values);
        }
        x.copy_from_host(&values);
        input.bounded(x)
    }
}

/// The grid of patterns with another shape on the same field of view and arc.
fn with_shape(grid: &PatternGrid, [frames, rows, columns]: [usize; 3]) -> PatternGrid {
    if grid.shape() == [frames, rows, columns] {
        return grid.clone();
    }
    let first = grid.azimuths.first().copied().unwrap_or_default();
    let arc = grid.frame_arc * grid.frames() as f64;
    PatternGrid {
        azimuths: (0..frames)
            .map(|k| first + arc * k as f64 / frames as f64)
            .collect(),
        frame_arc: arc / frames.max(1) as f64,
        rows,
        columns,
        pitch_mm: [
            grid.pitch_mm[0] * grid.columns as f64 / columns.max(1) as f64,
            grid.pitch_mm[1] * grid.rows as f64 / rows.max(1) as f64,
        ],
        offset_mm: grid.offset_mm,
    }
}

/// Patterns on another grid; see the [module](self).
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "patterns are f32")]
pub fn resample(given: &Patterns, to: &PatternGrid) -> Patterns {
    let from = &given.grid;
    if from.shape() == to.shape() {
        return Patterns {
            grid: to.clone(),
            values: given.values.clone(),
        };
    }
    let mut patterns = Patterns::dark(to.clone());
    if given.values.is_empty() || patterns.values.is_empty() {
        return patterns;
    }
    let per_frame = from.frames() as f64 / to.frames() as f64;
    let axis = |n: usize, m: usize, wrap: bool, place: &dyn Fn(usize) -> f64| -> Vec<Taps> {
        (0..n).map(|i| taps(place(i), m, wrap)).collect()
    };
    // Place in samples of the other grid, of a coordinate from its middle
    let place = |mm: f64, axis: usize, m: usize| mm / from.pitch_mm[axis] + (m as f64 - 1.0) / 2.0;
    let frames = axis(to.frames(), from.frames(), true, &|k| k as f64 * per_frame);
    let rows = axis(to.rows, from.rows, false, &|i| {
        place(from.offset_mm[1] - to.row_z(i), 1, from.rows)
    });
    let columns = axis(to.columns, from.columns, false, &|i| {
        place(to.column_u(i) - from.offset_mm[0], 0, from.columns)
    });
    patterns
        .values
        .chunks_mut(to.rows * to.columns)
        .zip(&frames)
        .par_each(|(out, frame)| {
            // Up to four lines of samples are near a line of pixels: two of each of two frames
            let mut near: Vec<(&[f32], f64)> = Vec::with_capacity(4);
            for (line, row) in out.chunks_mut(to.columns).zip(&rows) {
                near.clear();
                for (k, wk) in present(frame) {
                    let lines = |j: usize| &given.frame(k)[j * from.columns..][..from.columns];
                    near.extend(present(row).map(|(j, wj)| (lines(j), wk * wj)));
                }
                for (value, column) in line.iter_mut().zip(&columns) {
                    let mut sum = 0.0;
                    for (samples, weight) in &near {
                        for (i, wi) in present(column) {
                            sum += weight * wi * f64::from(samples[i]);
                        }
                    }
                    *value = (sum * per_frame) as f32;
                }
            }
        });
    patterns
}

/// Two samples and their weights.
type Taps = [(usize, f64); 2];

/// Those that count.
fn present(taps: &Taps) -> impl Iterator<Item = (usize, f64)> {
    taps.iter().copied().filter(|tap| tap.1 > 0.0)
}

/// The neighbors of a place among `n` samples, which end half a sample beyond the outermost unless they wrap round.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "places brought into the range of the samples"
)]
fn taps(place: f64, n: usize, wrap: bool) -> Taps {
    let last = n as f64 - 1.0;
    if !wrap && !(-0.5..=last + 0.5).contains(&place) {
        return [(0, 0.0); 2];
    }
    let place = if wrap {
        place.rem_euclid(n as f64)
    } else {
        place.clamp(0.0, last)
    };
    let (index, part) = (place.floor() as usize, place.fract());
    [(index % n, 1.0 - part), ((index + 1) % n, part)]
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::reference::FREE;
    use tomolith_core::check::small::SmallModel;
    use tomolith_core::dose::DoseModel;

    use tomolith_io::npy::{PatternPair, write_patterns};

    #[test]
    fn a_smooth_pattern_keeps_its_dose_on_a_finer_grid() {
        // cos² across, another by frame: linear interpolation of 24 columns and 40 frames errs by a few parts in a thousand
        let smooth = |grid: &PatternGrid| {
            let mut patterns = Patterns::dark(grid.clone());
            let (rows, columns) = (grid.rows, grid.columns);
            for (i, value) in patterns.values.iter_mut().enumerate() {
                let (frame, column) = (i / (rows * columns), i % columns);
                let u = grid.column_u(column) / 12.0;
                let across = (0.4 * std::f64::consts::PI * u).cos().powi(2);
                let turn = 1.0 + 0.5 * grid.azimuths[frame].sin();
                *value = (across * turn / grid.frames() as f64) as f32;
            }
            patterns
        };
        let coarse = PatternGrid::full_turn(40, 0.0, 3, 24, 1.0);
        let fine = PatternGrid::full_turn(80, 0.0, 6, 48, 0.5);
        let (found, expected) = (resample(&smooth(&coarse), &fine), smooth(&fine));
        for row in 1..5 {
            for frame in 0..80 {
                for column in 2..46 {
                    let at = (frame * 6 + row) * 48 + column;
                    let error = (found.values[at] - expected.values[at]).abs();
                    assert!(error < 0.02 / 80.0, "{error} at {frame}, {row}, {column}");
                }
            }
        }
    }

    #[test]
    fn starts_to_choose_among_need_what_chooses_and_a_step_needs_two_files() {
        let read = |table: serde_json::Value| {
            let found = GivenFiles::<HostField>::read(&Section::new("start.patterns", table));
            found.map(|files| files.step.map(|step| step.map(|file| file.0)))
        };
        let refusal = |table| read(table).unwrap_err().to_string();
        let json = serde_json::json!({ "file": "a", "or": ["b"] });
        assert!(refusal(json).starts_with("start.patterns.or: "));
        let json = serde_json::json!({ "file": "a", "continued": true });
        assert!(refusal(json).starts_with("start.patterns.continued: "));
        let json = serde_json::json!({ "file": "a", "scaled": true, "continued": true });
        assert!(refusal(json).starts_with("start.patterns.or: no file"));
        let step = |or: &[&str]| {
            let json =
                serde_json::json!({ "file": "a", "or": or, "scaled": true, "continued": true });
            read(json).unwrap().unwrap()
        };
        // From the last to the one before it, which is the first of all where there are two
        assert_eq!(step(&["b", "c"]), ["c", "b"].map(PathBuf::from));
        assert_eq!(step(&["c"]), ["c", "a"].map(PathBuf::from));
    }

    #[test]
    fn a_file_of_the_same_shape_is_taken_bit_for_bit_and_of_another_count_refused() {
        let model = SmallModel::new(8, 6, 2);
        let (target, labels) = model.ring();
        let input = StartInput::new(&model, &target, &labels, &FREE);
        let light = &model.patterns()[0];
        let mut patterns = Patterns::dark(light.grid.clone());
        for (i, v) in patterns.values.iter_mut().enumerate() {
            *v = (i * 37 % 101) as f32 / 101.0;
        }
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("given.npz");
        let pair = |light| PatternPair {
            light,
            shown: &patterns,
            raw: None,
        };
        write_patterns(&file, &[pair(None)], &Work::new()).unwrap();
        let x = OfFile(file.clone()).patterns(&input, &Work::new()).unwrap();
        assert_eq!(light.patterns_of(x.as_slice()), patterns);
        write_patterns(&file, &[pair(Some("a")), pair(Some("b"))], &Work::new()).unwrap();
        let refusal = OfFile(file).patterns(&input, &Work::new()).unwrap_err();
        assert!(matches!(refusal, Error::Format { .. }), "{refusal}");
    }
}
