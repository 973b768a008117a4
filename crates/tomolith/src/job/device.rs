//! Patterns → frames of the job's machine, and back from files that a machine shows.

use super::build::Optics;
use super::progress::{Event, Progress, left_out};
use super::resolve::JobKinds;
use super::scene::Scene;
use super::scheduled::{self, Emitted};
use super::spec::{JobSpec, LightSpec, MovieCoding};
use crate::error::{Error, Result};
use crate::exposure::{
    Budget, ExposureBudget, Printer, Quantized, Rotation, frame_rate, movie_name, quantize,
};
use crate::grid::{PatternGrid, Patterns};
use crate::io::frames::{FrameSet, Frames, read_frames, write_frames};
use crate::io::movie::{check_lossless, is_movie, read_movie, write_lossless};
use crate::io::mp4::{check_movie, write_movie};
use crate::io::npy::read_patterns;
use crate::io::stack::{read_stack, write_stack};
use crate::io::{read_text, write_whole};
use crate::models::Run;
use crate::optics::light::Light;
use crate::report::number::significant;
use crate::report::{Irradiance, MovieReport};
use crate::units::exact;
use serde_json::{Value, json};
use std::borrow::Cow;
use std::f64::consts::TAU;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What is left out where frames make no movie, and what else could show them.
const MOVIE: [&str; 2] = [
    "the movie",
    "the frames are written; output.movie = \"lossless\" takes frames of any kind, \"none\" writes no movie",
];
/// Name of the file that says how frames and movies are to be shown.
pub(crate) const EXPOSURE: &str = "exposure.json";

/// The machine of a job for each of its lights.
///
/// # Errors
/// As [`Printer::new`].
pub(crate) fn printers(
    spec: &JobSpec,
    base: &Path,
    lights: &[Light],
) -> Result<Option<Vec<Printer>>> {
    if spec.printer.is_none() {
        return Ok(None);
    }
    let one = |(i, (light, named)): (usize, (&Light, &LightSpec))| {
        let printer = spec.printer_of(i).unwrap_or_default();
        Printer::new(&printer, base, &light.pixels, named.rotation)
            .map_err(|e| spec.at_printer_of(i, e))
    };
    lights
        .iter()
        .zip(&spec.light)
        .enumerate()
        .map(one)
        .collect::<Result<_>>()
        .map(Some)
}

/// The largest pattern value in the time that the print may take, and that time.
///
/// # Errors
/// [`Error::Config`] when the dose that turns the resin solid is not known.
pub(super) fn white_in_time(spec: &JobSpec, kinds: &JobKinds) -> Result<Option<(f64, f64)>> {
    let Some(seconds) = spec.printer.as_ref().and_then(|printer| printer.time_s) else {
        return Ok(None);
    };
    let response = kinds.response.as_ref();
    let middle = || {
        let thresholds = kinds.thresholds();
        thresholds.map(|[lower, upper]| f64::midpoint(lower, upper))
    };
    let threshold = spec.evaluate.threshold.or_else(middle).ok_or_else(|| {
        Error::config(
            "printer.time_s",
            "a time, but no dose at which the resin turns solid",
            "evaluate.threshold beside it",
        )
    })?;
    let [low, high] = response.range();
    if threshold <= low || threshold >= high {
        return Err(Error::config(
            "printer.time_s",
            format!(
                "a time, but the resin would be solid at {threshold:.3} and its response goes from {} to {}",
                exact(low),
                exact(high)
            ),
            "bands within the response's range, or evaluate.threshold there",
        ));
    }
    let gel_dose = Some(f64::from(response.inverse(threshold as f32)));
    let frames = (0..spec.light.len())
        .map(|i| spec.angles_of(i).count())
        .sum();
    // One bound holds for all lights: that of the darkest
    let peaks = (0..spec.light.len()).filter_map(|i| exposure(spec, i, gel_dose).peak_mw_per_cm2);
    let exposure = ExposureBudget {
        frames,
        peak_mw_per_cm2: peaks.reduce(f64::min),
        ..exposure(spec, 0, gel_dose)
    };
    Ok(exposure.white_in(seconds).map(|white| (white, seconds)))
}

/// Share by which a print may take longer than it is allowed to without a word: what the rounding of frames and thresholds moves.
const OVERRUN: f64 = 0.005;

/// What is known of the exposure of a light.
fn exposure(spec: &JobSpec, light: usize, gel_dose: Option<f64>) -> ExposureBudget {
    let angles = spec.angles_of(light);
    let (_, frame_arc) = angles.azimuths(spec.light[light].rotation);
    ExposureBudget {
        peak_mw_per_cm2: spec
            .printer_of(light)
            .and_then(|printer| printer.peak_irradiance_mw_per_cm2),
        rpm: spec.output.rpm,
        frames: angles.count(),
        frame_arc,
        critical_mj_per_mm3: spec.resin.critical_dose_mj_per_mm3,
        gel_dose,
    }
}

/// The patterns of a run, per light.
pub(crate) struct Written {
    /// The light that the frames put into the vial.
    pub(crate) shown: Vec<Patterns>,
    /// What was wanted: before quantization and machine.
    pub(crate) raw: Option<Vec<Patterns>>,
    /// Levels, where they are small or were read; else they are made again when they are needed.
    frames: Option<Vec<Quantized>>,
}

impl Written {
    /// Raw patterns and what the machine makes of them at its bit depth.
    ///
    /// # Errors
    /// As [`quantize`] and [`Printer::expose`].
    pub(crate) fn of_raw(raw: Vec<Patterns>, scene: &Scene) -> Result<Self> {
        let bits = scene.spec.evaluate.bit_depth;
        let Some(printers) = &scene.printers else {
            let frames: Vec<Quantized> = raw
                .iter()
                .map(|raw| quantize(raw, bits))
                .collect::<Result<_>>()?;
            let shown = frames.iter().map(Quantized::patterns).collect();
            return Ok(Written {
                shown,
                raw: Some(raw),
                frames: Some(frames),
            });
        };
        let light =
            |(printer, raw): (&Printer, &Patterns)| printer.light_of(&printer.expose(raw, bits)?);
        let shown = printers
            .iter()
            .zip(&raw)
            .map(light)
            .collect::<Result<_>>()?;
        Ok(Written {
            shown,
            raw: Some(raw),
            frames: None,
        })
    }

    /// The levels of the machine, per light.
    ///
    /// # Errors
    /// As [`of_raw`](Self::of_raw).
    pub(crate) fn frames(&self, scene: &Scene) -> Result<Cow<'_, [Quantized]>> {
        match (&self.frames, &self.raw, &scene.printers) {
            (Some(frames), ..) => Ok(Cow::Borrowed(frames)),
            (None, Some(raw), Some(printers)) => {
                exposed(printers, raw, scene.spec.evaluate.bit_depth).map(Cow::Owned)
            }
            _ => Ok(Cow::Borrowed(&[])),
        }
    }
}

/// Levels of patterns on their machines.
pub(crate) fn exposed(
    printers: &[Printer],
    wanted: &[Patterns],
    bits: u32,
) -> Result<Vec<Quantized>> {
    let pairs = printers.iter().zip(wanted);
    pairs
        .map(|(printer, wanted)| printer.expose(wanted, bits))
        .collect()
}

/// Patterns of a file, one set per light of the job: `patterns.npz` or the run folder that holds it; or what a machine
/// shows: a folder of frames, a `frames.npz`, a movie. And what people should know of them.
///
/// # Errors
/// [`Error::Io`], [`Error::Format`], [`Error::Shape`] for files that do not fit the job's lights and machine; [`Error::Canceled`].
pub(crate) fn read(scene: &Scene, given: &Path, run: &Run) -> Result<(Written, Vec<String>)> {
    // A run folder stands for its patterns, an exported one for its frames
    let within = ["patterns.npz", "frames"].map(|name| given.join(name));
    let path = within.iter().find(|path| path.exists());
    let path = path.map_or(given, PathBuf::as_path);
    let (mut frames, mut notes) = (Vec::new(), Vec::new());
    for i in 0..scene.spec.light.len() {
        let Some(found) = frames_of(scene, i, path, &mut notes)? else {
            return wanted_of(path, &scene.optics, &names(&scene.spec), run)
                .and_then(|(wanted, raw)| of_patterns(scene, wanted, raw, run))
                .map(|written| (written, notes));
        };
        run.check()?;
        frames.push(found);
    }
    let light = |(i, frames): (usize, &Quantized)| match &scene.printers {
        Some(printers) => printers[i].light_of(frames),
        None => Ok(frames.patterns()),
    };
    let shown = frames
        .iter()
        .enumerate()
        .map(light)
        .collect::<Result<_>>()?;
    let written = Written {
        shown,
        raw: None,
        frames: Some(frames),
    };
    Ok((written, notes))
}

/// Names of the lights for files: none when there is only one.
pub(crate) fn names(spec: &JobSpec) -> Vec<Option<&str>> {
    let several = spec.light.len() > 1;
    spec.light
        .iter()
        .map(|light| light.name.as_deref().filter(|_| several))
        .collect()
}

/// Patterns of an array: with a machine they are what is wanted, else what is shown.
fn of_patterns(
    scene: &Scene,
    shown: Vec<Patterns>,
    raw: Option<Vec<Patterns>>,
    run: &Run,
) -> Result<Written> {
    run.check()?;
    if scene.printers.is_some() {
        return Written::of_raw(raw.unwrap_or(shown), scene);
    }
    let bits = scene.spec.evaluate.bit_depth;
    let frames = shown
        .iter()
        .map(|patterns| run.check().and_then(|()| quantize(patterns, bits)))
        .collect::<Result<_>>()?;
    Ok(Written {
        shown,
        raw,
        frames: Some(frames),
    })
}

/// `patterns.npz`: what is shown and, when the file holds it for every light, what was wanted.
pub(crate) fn wanted_of(
    path: &Path,
    optics: &Optics,
    names: &[Option<&str>],
    run: &Run,
) -> Result<(Vec<Patterns>, Option<Vec<Patterns>>)> {
    let arrays = read_patterns(path)?;
    let (mut shown, mut raw) = (Vec::new(), Vec::new());
    for (light, name) in optics.lights.iter().zip(names) {
        run.check()?;
        let found = arrays
            .iter()
            .find(|a| a.light.as_deref() == *name)
            .ok_or_else(|| Error::Format {
                path: path.to_owned(),
                found: format!(
                    "no patterns for the light {}",
                    name.unwrap_or("(the only one)")
                ),
                accepted: "one array `patterns`, or `patterns_<light>` for each light of the job"
                    .to_owned(),
            })?;
        let grid = &light.pixels;
        same_shape(path, "patterns [angle, row, column]", grid, found.shape)?;
        let patterns = |values: &Vec<f32>| Patterns {
            grid: grid.clone(),
            values: values.clone(),
        };
        shown.push(patterns(&found.shown));
        raw.extend(found.raw.as_ref().map(patterns));
    }
    let raw = (raw.len() == shown.len()).then_some(raw);
    Ok((shown, raw))
}

fn same_shape(path: &Path, what: &str, grid: &PatternGrid, found: [usize; 3]) -> Result<()> {
    if found == grid.shape() {
        return Ok(());
    }
    Err(Error::Shape {
        what: format!("{}: {what}", path.display()),
        expected: grid.shape().to_vec(),
        found: found.to_vec(),
    })
}

/// Frames of one light in a folder, a stack or a movie; None when the file is none of these.
fn frames_of(
    scene: &Scene,
    i: usize,
    path: &Path,
    notes: &mut Vec<String>,
) -> Result<Option<Quantized>> {
    let name = names(&scene.spec)[i];
    let grid = match &scene.printers {
        Some(printers) => printers[i].canvas_grid(),
        None => scene.optics.lights[i].pixels.clone(),
    };
    let found = if path.is_dir() {
        read_frames(&name.map_or_else(|| path.to_owned(), |name| path.join(name)))?
    } else if is_movie(path) {
        if name.is_some() {
            return Err(Error::Unsupported {
                what: path.display().to_string(),
                reason: "a movie holds one light, the job has several: give the folder of frames"
                    .to_owned(),
            });
        }
        read_movie(path, grid.shape())?
    } else {
        match read_stack(path, name) {
            Ok(frames) => frames,
            Err(_) => return Ok(None),
        }
    };
    same_shape(path, "frames [frame, row, column]", &grid, found.shape)?;
    let Frames {
        bits,
        full_scale,
        values,
        ..
    } = found;
    let full_scale = full_scale
        .or_else(|| white_beside(path))
        .unwrap_or_else(|| {
            notes.push(format!(
                "{} does not say which pattern value white stands for: 1 is assumed",
                path.display()
            ));
            1.0
        });
    Ok(Some(Quantized {
        grid,
        bits,
        full_scale,
        values,
    }))
}

/// White of a movie, from the file beside it that names it.
fn white_beside(path: &Path) -> Option<f32> {
    let text = read_text(path.with_file_name(EXPOSURE)).ok()?;
    let exposure: Value = serde_json::from_str(&text).ok()?;
    let name = path.file_name()?.to_str()?;
    let light = exposure["lights"]
        .as_array()?
        .iter()
        .find(|light| light["movie"] == name)?;
    light["white"].as_f64().map(|white| white as f32)
}

/// How one light is shown.
#[derive(Clone, Copy)]
pub(crate) struct ShownLight {
    pub(crate) bits: u32,
    pub(crate) white: f32,
    pub(crate) canvas: Option<[usize; 2]>,
    pub(crate) budget: Budget,
    /// How bright the job's schedule shows it.
    pub(crate) irradiance: Option<Irradiance>,
}

/// What of frames was written.
#[derive(Default)]
pub(crate) struct WrittenFrames {
    /// One per light; None where there is no movie.
    pub(crate) movies: Vec<Option<MovieReport>>,
    /// What was left out.
    pub(crate) warnings: Vec<String>,
}

/// How a job is shown: frames, movies, times.
pub(crate) struct Shown<'a> {
    spec: &'a JobSpec,
    names: &'a [Option<&'a str>],
    lights: Vec<ShownLight>,
}

impl<'a> Shown<'a> {
    /// Warns of a print that takes longer than the job allows.
    pub(crate) fn overrun(&self) -> Option<String> {
        let asked = self.spec.printer.as_ref()?.time_s?;
        let times = self.lights.iter().map(|light| light.budget.time_s);
        let found: f64 = times.sum::<Option<f64>>()?;
        (found > asked * (1.0 + OVERRUN)).then(|| {
            let [found, lower] = [found, asked * asked / found].map(|seconds| significant(seconds, 3));
            let asked = exact(asked);
            format!(
                "the print takes {found} s where printer.time_s allows {asked} s: the resin gels at another dose than the bound of the pixels was made for, or several \
                 lights follow each other. After {asked} s parts are softer than predicted: set printer.time_s = {lower}, or evaluate.threshold to the gel threshold of this report"
            )
        })
    }

    /// Times and energies of frames: those of the job's schedule, or of a resin that is solid at a known dose (in units of the job).
    ///
    /// # Errors
    /// Those of the schedule.
    pub(crate) fn new(
        spec: &'a JobSpec,
        printers: Option<&[Printer]>,
        names: &'a [Option<&'a str>],
        frames: &[Quantized],
        gel_dose: Option<f64>,
    ) -> Result<Self> {
        let light = |(i, frames): (usize, &Quantized)| -> Result<ShownLight> {
            let printer = printers.map(|printers| &printers[i]);
            let emitted = match printer {
                Some(printer) => printer.emitted(frames),
                None => frames.sums(),
            };
            let (grid, white) = (&frames.grid, f64::from(frames.full_scale));
            let (pixels, pixel_mm2) = (grid.rows * grid.columns, grid.pixel_mm2());
            let scheduled = scheduled::budget(
                spec,
                i,
                &Emitted {
                    white,
                    sums: &emitted,
                    pixels: grid.frames() * pixels,
                    pixel_mm2,
                },
            )?;
            let (budget, irradiance) = match scheduled {
                Some((budget, irradiance)) => (budget, Some(irradiance)),
                None => {
                    let exposure = exposure(spec, i, gel_dose);
                    (
                        exposure.budget(white, emitted.iter().sum(), pixels, pixel_mm2),
                        None,
                    )
                }
            };
            Ok(ShownLight {
                bits: frames.bits,
                white: frames.full_scale,
                canvas: printer.map(|_| [grid.columns, grid.rows]),
                budget,
                irradiance,
            })
        };
        let lights = frames.iter().enumerate().map(light);
        Ok(Shown {
            spec,
            names,
            lights: lights.collect::<Result<_>>()?,
        })
    }

    pub(crate) fn lights(&self) -> &[ShownLight] {
        &self.lights
    }

    /// Writes frames, movies, the stack when it is asked for, and `exposure.json`; the movies are read back. Lights whose
    /// frames make no movie (a list of angles) have none.
    pub(crate) fn write(
        &self,
        folder: &Path,
        part: &str,
        sets: &[FrameSet<'_>],
        progress: &mut dyn Progress,
        run: &Run,
    ) -> Result<WrittenFrames> {
        write_frames(&folder.join("frames"), sets, &run.part(0.2))?;
        if self
            .spec
            .printer
            .as_ref()
            .is_some_and(|printer| printer.stack)
        {
            write_stack(&folder.join("frames.npz"), sets, &run.part(0.1))?;
        }
        let (mut written, mut lights) = (WrittenFrames::default(), Vec::new());
        for (i, set) in sets.iter().enumerate() {
            let movie = self.write_movie(folder, part, set, &run.part(0.7 / sets.len() as f64));
            let movie = left_out(MOVIE, movie, progress, &mut written.warnings)?.flatten();
            let arc = set.grid.frame_arc * set.grid.frames() as f64;
            if arc == 0.0 && self.spec.output.movie != MovieCoding::None {
                let text =
                    "a list of angles, or a single frame, has no frame rate: no movie is written"
                        .to_owned();
                progress.event(&Event::Note { text });
            }
            let name = movie.as_ref().map(|movie| movie.file.as_str());
            lights.push(self.light_json(i, set, name));
            written.movies.push(movie);
        }
        let rpm = self.spec.output.rpm;
        let exposure = json!({ "schema": "tomolith.exposure/1", "rpm": rpm, "lights": lights });
        write_whole(&folder.join(EXPOSURE), |file| {
            serde_json::to_writer_pretty(&mut *file, &exposure).map_err(std::io::Error::from)?;
            Ok(file.write_all(b"\n")?)
        })?;
        Ok(written)
    }

    /// The movie of a light, read back; None where it has no frame rate, or none is asked for.
    fn write_movie(
        &self,
        folder: &Path,
        part: &str,
        set: &FrameSet<'_>,
        run: &Run,
    ) -> Result<Option<MovieReport>> {
        let (coding, rpm) = (self.spec.output.movie, self.spec.output.rpm);
        let ending = match coding {
            MovieCoding::H264 => "mp4",
            MovieCoding::Lossless => "mov",
            MovieCoding::None => return Ok(None),
        };
        let arc = set.grid.frame_arc * set.grid.frames() as f64;
        if arc == 0.0 {
            return Ok(None);
        }
        let file = movie_name(part, set.light, rpm, ending);
        let path = folder.join(&file);
        let rate = frame_rate(rpm, set.grid.frames(), arc)?;
        let check = if coding == MovieCoding::H264 {
            write_movie(&path, set, rate, &run.part(0.6))
                .and_then(|()| check_movie(&path, set, &run.part(0.4)))
        } else {
            write_lossless(&path, set, rate).and_then(|()| check_lossless(&path, set))
        };
        match check {
            Ok(check) => Ok(Some(MovieReport { file, check })),
            Err(error) => {
                // A movie that cannot be read back is none
                let _ = std::fs::remove_file(&path);
                Err(error)
            }
        }
    }

    fn light_json(&self, i: usize, set: &FrameSet<'_>, movie: Option<&str>) -> Value {
        let (spec, grid) = (&self.spec.light[i], set.grid);
        let sense = self
            .spec
            .printer
            .as_ref()
            .and_then(|printer| printer.rotation)
            .unwrap_or(spec.rotation);
        let degrees: Vec<f64> = grid
            .azimuths
            .iter()
            // Without the last digits of a conversion: 30, not 29.999999999999996
            .map(|a| (a.rem_euclid(TAU).to_degrees() * 1e9).round() / 1e9)
            .collect();
        json!({
            "name": self.names[i],
            "movie": movie,
            "frames": grid.frames(),
            "columns": grid.columns,
            "rows": grid.rows,
            "pixel_pitch_mm": grid.pitch_mm,
            "bits": set.bits,
            "white": set.full_scale,
            "frame_rate": frame_rate(self.spec.output.rpm, grid.frames(), grid.frame_arc * grid.frames() as f64).ok(),
            "vial_turns": if sense == Rotation::Clockwise { "clockwise" } else { "counterclockwise" },
            "azimuth_deg": degrees,
            "budget": self.lights[i].budget,
            "irradiance": self.lights[i].irradiance,
        })
    }
}
