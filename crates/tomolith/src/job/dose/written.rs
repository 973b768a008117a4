//! Patterns → frames of the job's machine, and back from files that a machine shows.

use crate::error::{Error, Result};
use crate::exposure::{Printer, Quantized, quantize};
use crate::grid::{PatternGrid, Patterns};
use crate::io::frames::{Frames, read_frames};
use crate::io::movie::{is_movie, read_movie};
use crate::io::npy::read_patterns;
use crate::io::read_text;
use crate::io::stack::read_stack;
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::optics::Optics;
use crate::job::spec::file_names::EXPOSURE;
use crate::models::Work;
use crate::optics::light::Light;
use serde_json::Value;
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// Share of the light of frames beside the patterns that is worth a warning; films of others blur edges.
const BESIDE: f64 = 0.01;

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
    pub(crate) fn of_raw(raw: Vec<Patterns>, job: &ResolvedJob) -> Result<Self> {
        let bits = job.evaluation().bit_depth;
        let Some(printers) = &job.printers else {
            let frames: Vec<Quantized> = raw
                .iter()
                .map(|raw| quantize(raw, bits))
                .collect::<Result<_>>()?;
            let shown = frames.iter().map(Quantized::patterns).collect();
            return Ok(Written {
                shown: with_background(job, shown, &raw),
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
            shown: with_background(job, shown, &raw),
            raw: Some(raw),
            frames: None,
        })
    }

    /// The levels of the machine, per light.
    pub(crate) fn frames(&self, job: &ResolvedJob) -> Result<Cow<'_, [Quantized]>> {
        match (&self.frames, &self.raw, &job.printers) {
            (Some(frames), ..) => Ok(Cow::Borrowed(frames)),
            (None, Some(raw), Some(printers)) => {
                exposed(printers, raw, job.evaluation().bit_depth).map(Cow::Owned)
            }
            _ => Ok(Cow::Borrowed(&[])),
        }
    }
}

/// Light that is at least the background of its projector (`bounds.min`), where the `wanted` patterns are: level 0 of a frame is not darker.
fn with_background(
    job: &ResolvedJob,
    mut shown: Vec<Patterns>,
    wanted: &[Patterns],
) -> Vec<Patterns> {
    for (i, (shown, wanted)) in shown.iter_mut().zip(wanted).enumerate() {
        let least = job.bounds_of(i).0 as f32;
        if least == 0.0 {
            continue;
        }
        let values = shown.values.iter_mut().zip(&wanted.values);
        values.for_each(|(value, wanted)| *value = value.max(wanted.min(least)));
    }
    shown
}

/// White wherever the light of a job may shine: where its background does, as far as frames alone tell.
fn all_lit(job: &ResolvedJob) -> Vec<Patterns> {
    let of_light = |light: &Light| {
        let mut lit = Patterns::dark(light.pixels.clone());
        let [rows, columns] = [light.pixels.rows, light.pixels.columns];
        for (at, value) in lit.values.iter_mut().enumerate() {
            let pixel = [at / (rows * columns), at / columns % rows, at % columns];
            *value = match light.selection.allows(pixel) {
                true => f32::INFINITY,
                false => 0.0,
            };
        }
        lit
    };
    job.optics.lights.iter().map(of_light).collect()
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

/// The error of a run that left no patterns.
pub(crate) fn without_patterns(key: &str, run: &Path) -> Error {
    let run = run.display();
    let found = format!("`{run}` has no patterns: it was run with --keep metrics");
    Error::config(key, found, "a run that left them")
}

/// Patterns of a file, one set per light of the job: `patterns.npz` or the run folder that holds it; or what a machine
/// shows: a folder of frames, a `frames.npz`, a movie. And what people should know of them.
pub(crate) fn read(job: &ResolvedJob, given: &Path, work: &Work) -> Result<(Written, Vec<String>)> {
    // A run folder stands for its patterns, an exported one for its frames
    let within = ["patterns.npz", "frames"].map(|name| given.join(name));
    let path = within.iter().find(|path| path.exists());
    if path.is_none() && given.join("history.csv").exists() {
        return Err(without_patterns("--patterns", given));
    }
    let path = path.map_or(given, PathBuf::as_path);
    let (mut frames, mut notes) = (Vec::new(), Vec::new());
    for i in 0..job.optics.lights.len() {
        let Some(found) = frames_of(job, i, path, &mut notes)? else {
            return wanted_of(path, &job.optics, &job.light_names(), work)
                .and_then(|(wanted, raw)| of_patterns(job, wanted, raw, work))
                .map(|written| (written, notes));
        };
        work.check()?;
        frames.push(found);
    }
    let light = |(i, frames): (usize, &Quantized)| match &job.printers {
        Some(printers) => printers[i].light_of(frames),
        None => Ok(frames.patterns()),
    };
    let shown: Vec<Patterns> = frames
        .iter()
        .enumerate()
        .map(light)
        .collect::<Result<_>>()?;
    let lights = 0..job.optics.lights.len();
    let shown = match lights.into_iter().any(|i| job.bounds_of(i).0 > 0.0) {
        true => with_background(job, shown, &all_lit(job)),
        false => shown,
    };
    let written = Written {
        shown,
        raw: None,
        frames: Some(frames),
    };
    Ok((written, notes))
}

/// What to say of frames that cannot be what they seem: masks, and light beside the patterns.
pub(crate) fn doubts_of_frames(job: &ResolvedJob, written: &Written) -> Result<Vec<String>> {
    let printers = job.printers.iter().flatten();
    let frames = || written.frames.iter().flatten();
    let is_mask = |frames: &Quantized| frames.bits > 1 && frames.values.iter().max() == Some(&1);
    let masks = frames().find(|frames| is_mask(frames)).map(|frames| {
        let top = (1u32 << frames.bits) - 1;
        format!("the frames have levels 0 and 1 alone, and white is level {top}: 1 is taken as that part of white. Of a mask, write {top} in place of 1")
    });
    let shares = (printers.zip(frames()))
        .map(|(printer, frames)| printer.beside(frames))
        .collect::<Result<Vec<_>>>()?;
    let texts = shares.into_iter().filter(|share| *share > BESIDE).map(|share| {
        format!(
            "{:.0} % of the light of the frames falls beside the patterns: the machine shows it, and this prediction leaves it out. Where it is part of the print, \
             raise light.pixels; where the frames are shifted, mirrored or turned, set offset_px, flip_horizontal, flip_vertical or quarter_turns of [printer]",
            100.0 * share
        )
    });
    Ok(masks.into_iter().chain(texts).collect())
}

/// Patterns of an array: with a machine they are what is wanted, else what is shown, by levels of the job's bit depth as its frames have them.
fn of_patterns(
    job: &ResolvedJob,
    shown: Vec<Patterns>,
    raw: Option<Vec<Patterns>>,
    work: &Work,
) -> Result<Written> {
    work.check()?;
    if job.printers.is_some() {
        return Written::of_raw(raw.unwrap_or(shown), job);
    }
    let bits = job.evaluation().bit_depth;
    let frames: Vec<Quantized> = shown
        .iter()
        .map(|patterns| work.check().and_then(|()| quantize(patterns, bits)))
        .collect::<Result<_>>()?;
    let of_levels = frames.iter().map(Quantized::patterns).collect();
    let of_levels = with_background(job, of_levels, &shown);
    // Those of a run are on levels already
    let raw = raw.or_else(|| (of_levels != shown).then_some(shown));
    Ok(Written {
        shown: of_levels,
        raw,
        frames: Some(frames),
    })
}

/// `patterns.npz`: what is shown and, when the file holds it for every light, what was wanted.
pub(crate) fn wanted_of(
    path: &Path,
    optics: &Optics,
    names: &[Option<&str>],
    work: &Work,
) -> Result<(Vec<Patterns>, Option<Vec<Patterns>>)> {
    let arrays = read_patterns(path)?;
    let array = |name: &Option<&str>| match name {
        Some(name) => format!("patterns_{name}"),
        None => "patterns".to_owned(),
    };
    let (mut shown, mut raw) = (Vec::new(), Vec::new());
    for (light, name) in optics.lights.iter().zip(names) {
        work.check()?;
        let found = arrays
            .iter()
            .find(|a| a.light.as_deref() == *name)
            .ok_or_else(|| {
                let accepted = names.iter().map(|name| format!("`{}`", array(name)));
                let accepted = accepted.collect::<Vec<_>>().join(", ");
                let found = format!("no array `{}`", array(name));
                Error::format(
                    path,
                    found,
                    format!("{accepted}: one for each light of the job"),
                )
            })?;
        let grid = &light.pixels;
        let what = format!("{} [angle, row, column]", array(name));
        same_shape(path, &what, grid, found.shape)?;
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
    job: &ResolvedJob,
    i: usize,
    path: &Path,
    notes: &mut Vec<String>,
) -> Result<Option<Quantized>> {
    let name = job.light_names()[i];
    let grid = match &job.printers {
        Some(printers) => printers[i].canvas_grid(),
        None => job.optics.lights[i].pixels.clone(),
    };
    let channel = job.showing().channel(i);
    let found = if path.is_dir() {
        read_frames(
            &name.map_or_else(|| path.to_owned(), |name| path.join(name)),
            channel,
        )?
    } else if is_movie(path) {
        if name.is_some() {
            return Err(Error::Unsupported {
                what: path.display().to_string(),
                reason: "a movie holds one light, the job has several: give the folder of frames"
                    .to_owned(),
            });
        }
        read_movie(path, grid.shape(), channel)?
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
                "{} does not say which pattern value white stands for: 1 is assumed. Doses and times scale with it: put the {EXPOSURE} that names it beside it",
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

/// White of a movie, from the `exposure.json` in its folder that names it.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::tests::job_of;

    #[test]
    fn written_light_is_nowhere_darker_than_the_background() {
        let text = r#"
            target = { phantom = { sphere = {} }, size_mm = 1.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
            vial = { index_matched = { radius_mm = 2.0 } }
            light = [{ pixels = [4, 1], angles = 1, selection = { columns = [1, 3] }, projector = { collimated = { pixel_pitch_mm = 0.5 } } }]
            bounds = { min = 0.1 }
            evaluate = { bit_depth = 2 }
        "#;
        let job = job_of(text, &[]);
        let resolved = ResolvedJob::under(&job, &Work::new()).unwrap();
        let raw = Patterns {
            grid: resolved.optics.lights[0].pixels.clone(),
            values: vec![0.0, 0.1, 0.6, 3.0],
        };
        // Levels of 0, 1, 2 and 3; the first pixel may not shine
        let written = Written::of_raw(vec![raw], &resolved).unwrap();
        assert_eq!(written.shown[0].values, [0.0, 0.1, 1.0, 3.0]);
        let frames = written.frames(&resolved).unwrap();
        assert_eq!(frames[0].values, [0, 0, 1, 3]);
        let lit = all_lit(&resolved);
        let shown = with_background(&resolved, vec![frames[0].patterns()], &lit);
        // Frames alone tell the same, and patterns on levels stay what they are
        assert_eq!(shown, written.shown);
        let again = of_patterns(&resolved, shown.clone(), None, &Work::new()).unwrap();
        assert_eq!((&again.shown, &again.raw), (&shown, &None));
        // Those of an array are what its frames show
        let between = vec![Patterns {
            values: vec![0.0, 0.1, 0.6, 3.0],
            ..shown[0].clone()
        }];
        let array = of_patterns(&resolved, between.clone(), None, &Work::new()).unwrap();
        assert_eq!((array.shown, array.raw), (shown, Some(between)));
    }
}
