//! Frames of written patterns: how they are shown, and their files.

use crate::error::Result;
use crate::exposure::{Budget, Printer, Quantized, Rotation, frame_rate, movie_name};
use crate::io::frames::{FrameSet, write_frames};
use crate::io::movie::{check_lossless, write_lossless};
use crate::io::mp4::{check_movie, write_movie};
use crate::io::stack::write_stack;
use crate::io::write_text;
use crate::job::progress::{Event, Progress, left_out};
use crate::job::resolve::machine::Showing;
use crate::job::resolve::scheduled::Emitted;
use crate::job::spec::file_names::EXPOSURE;
use crate::models::Work;
use crate::report::number::significant;
use crate::report::{Irradiance, MovieReport};
use crate::units::exact;
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::path::Path;

/// What is left out where frames make no movie, and what else could show them.
const MOVIE: [&str; 2] = [
    "the movie",
    "the frames are written; output.movie = \"lossless\" takes frames of any kind, \"none\" writes no movie",
];

/// Share by which a print may take longer than it is allowed to without a word: what the rounding of frames and thresholds moves.
const OVERRUN: f64 = 0.005;

/// What a print takes at least, times this, leaves pixels room to differ: a gear in even light (IoU 0.58) has 0.71 with no room, 0.90 with a tenth, 0.91 with a fifth.
const HEADROOM: f64 = 1.2;

/// Turns below which it shows that a print ends within one: some sides have then shone a half more often than others.
const FEW_TURNS: f64 = 3.0;

/// Time below which a print is a slip of units, s.
const FLASH_S: f64 = 0.2;

/// Share by which turns may miss a whole number.
const WHOLE: f64 = 0.01;

/// A print that takes longer than this, s, is none: published ones take seconds to minutes.
const LONG_S: f64 = 1800.0;

/// Turns a minute that throw no resin about.
const FASTEST_RPM: f64 = 60.0;

/// How one light is shown.
#[derive(Clone, Copy)]
pub(crate) struct ShownLight {
    pub(crate) bits: u32,
    pub(crate) white: f32,
    pub(crate) canvas: Option<[usize; 2]>,
    pub(crate) budget: Budget,
    /// Its machine's darkest pixel over the brightest.
    dimmest: f64,
    /// How bright the job's schedule shows it.
    pub(crate) irradiance: Option<Irradiance>,
}

#[derive(Default)]
pub(crate) struct WrittenFrames {
    /// One per light; None where there is no movie.
    pub(crate) movies: Vec<Option<MovieReport>>,
    /// What was left out.
    pub(crate) warnings: Vec<String>,
}

/// How a job is shown: frames, movies, times.
pub(crate) struct Shown<'a> {
    showing: Showing<'a>,
    lights: Vec<ShownLight>,
}

impl<'a> Shown<'a> {
    /// What people should know of the time to print; `is_held`: nearly all pixels are as bright as they may be.
    pub(crate) fn warnings(&self, is_held: bool) -> Vec<String> {
        let mut lights = self.lights.iter().enumerate();
        let few_turns = lights.find_map(|(i, light)| self.few_turns(i, light));
        let of_print = self.overrun(is_held).into_iter().chain(self.hours());
        of_print.chain(few_turns).collect()
    }

    /// Warns of a print that takes longer than resin keeps still.
    fn hours(&self) -> Option<String> {
        let times = self.lights.iter().map(|light| light.budget.time_s);
        let seconds: f64 = times.sum::<Option<f64>>()?;
        (seconds > LONG_S).then(|| {
            format!(
                "the print takes {} h, and resin keeps still for minutes: the part sinks, and what reacts goes on without light. Look at the units of printer.peak_irradiance_mw_per_cm2, \
                 resin.critical_dose_mj_per_mm3 and resin.absorption_per_mm (prints are shortest where it is about 1 over the radius of the vial), or use a brighter projector",
                significant(seconds / 3600.0, 3)
            )
        })
    }

    /// Warns of a print that ends before the vial has turned a few times, which no schedule counts on.
    fn few_turns(&self, i: usize, light: &ShownLight) -> Option<String> {
        let budget = light.budget;
        let turns = budget.turns.filter(|turns| *turns < FEW_TURNS)?;
        let is_whole = turns > 0.5 && (turns - turns.round()).abs() < WHOLE * turns;
        if light.irradiance.is_some() || is_whole {
            return None;
        }
        if budget.time_s.is_some_and(|seconds| seconds < FLASH_S) {
            return Some(format!(
                "{} takes {} s, which no machine shows: look at the units of resin.critical_dose_mj_per_mm3 and printer.peak_irradiance_mw_per_cm2",
                self.named(i),
                significant(budget.time_s?, 3)
            ));
        }
        let enough = self.showing.rpm() * FEW_TURNS / turns;
        let fastest = self.showing.fastest_rpm(i).min(FASTEST_RPM);
        let advice = if enough <= fastest {
            let rpm = significant(enough, 4);
            format!("Set output.rpm = {rpm} for three whole turns")
        } else {
            "Lower printer.peak_irradiance_mw_per_cm2 for more turns".to_owned()
        };
        Some(format!(
            "{} takes {} s, {} turns of the vial: it ends within a turn, so some sides have shone more often than others, and the part comes out uneven. \
             {advice}; `tomolith expose` plans whole turns",
            self.named(i),
            significant(budget.time_s?, 3),
            significant(turns, 3)
        ))
    }

    /// The print, or that of one of several lights.
    fn named(&self, i: usize) -> String {
        match self.lights.len() {
            1 => "the print".to_owned(),
            _ => format!("light[{i}]"),
        }
    }

    /// Warns of a print that takes longer than the job allows.
    fn overrun(&self, is_held: bool) -> Option<String> {
        let asked = self.showing.allowed_s()?;
        let times = self.lights.iter().map(|light| light.budget.time_s);
        let found: f64 = times.sum::<Option<f64>>()?;
        let dimmest = self
            .lights
            .iter()
            .map(|light| light.dimmest)
            .fold(1.0, f64::min);
        let is_dimmed = dimmest < 1.0 && found * dimmest < asked * (1.0 + OVERRUN);
        (found > asked * (1.0 + OVERRUN)).then(|| {
            let [times, longer] = [found / asked, found].map(|least| significant(HEADROOM * least, 3));
            let [found, lower] = [found, asked * asked / found].map(|seconds| significant(seconds, 3));
            let asked = exact(asked);
            if is_held {
                return format!(
                    "the print takes {found} s where printer.time_s allows {asked} s, though nearly all pixels that shine are as bright as they may be. \
                     Light that even gives the part no shape. Set printer.time_s = {longer}, or use a projector that is {times} times as bright (printer.peak_irradiance_mw_per_cm2)"
                );
            }
            if is_dimmed {
                return format!(
                    "the print takes {found} s where printer.time_s allows {asked} s: printer.flat_field dims pixels to {} % of the brightest one, which the bound of the \
                     pixels was made for. After {asked} s parts are softer than predicted: set printer.time_s = {lower}",
                    significant(100.0 * dimmest, 3)
                );
            }
            format!(
                "the print takes {found} s where printer.time_s allows {asked} s: the resin gels at another dose than the bound of the pixels was made for, or several \
                 lights follow each other. After {asked} s parts are softer than predicted: set printer.time_s = {lower}, or evaluate.threshold to the gel threshold of this report"
            )
        })
    }

    /// Times and energies of frames: those of the job's schedule, or of a resin that is solid at a known dose (in units of the job).
    pub(crate) fn new(
        showing: Showing<'a>,
        printers: Option<&[Printer]>,
        frames: &[Quantized],
        gel_dose: Option<f64>,
    ) -> Result<Self> {
        let light = |(i, frames): (usize, &Quantized)| -> Result<ShownLight> {
            let printer = printers.map(|printers| &printers[i]);
            let (grid, white) = (&frames.grid, f64::from(frames.full_scale));
            let (emitted, all_white) = match printer {
                Some(printer) => (printer.emitted(frames), printer.all_white()),
                None => (frames.sums(), (grid.rows * grid.columns) as f64),
            };
            let emitted = Emitted {
                white,
                sums: &emitted,
                frames: grid.frames(),
                all_white,
                pixel_mm2: grid.pixel_mm2(),
            };
            let (budget, irradiance) = showing.budget(i, &emitted, gel_dose)?;
            Ok(ShownLight {
                bits: frames.bits,
                white: frames.full_scale,
                canvas: printer.map(|_| [grid.columns, grid.rows]),
                budget,
                dimmest: printer.map_or(1.0, Printer::dimmest),
                irradiance,
            })
        };
        let lights = frames.iter().enumerate().map(light);
        Ok(Shown {
            showing,
            lights: lights.collect::<Result<_>>()?,
        })
    }

    pub(crate) fn lights(&self) -> &[ShownLight] {
        &self.lights
    }

    /// Writes frames, movies, the stack where the job wants it, and `exposure.json`; the movies are read back. Lights whose
    /// frames make no movie (a list of angles) have none.
    pub(crate) fn write(
        &self,
        folder: &Path,
        part: &str,
        sets: &[FrameSet<'_>],
        progress: &mut dyn Progress,
        work: &Work,
    ) -> Result<WrittenFrames> {
        write_frames(&folder.join("frames"), sets, &work.part(0.2))?;
        if self.showing.is_stacked() {
            write_stack(&folder.join("frames.npz"), sets, &work.part(0.1))?;
        }
        let (mut written, mut lights) = (WrittenFrames::default(), Vec::new());
        for (i, set) in sets.iter().enumerate() {
            let movie = self.write_movie(folder, part, i, set, &work.part(0.7 / sets.len() as f64));
            let movie = left_out(MOVIE, movie, progress, &mut written.warnings)?.flatten();
            let arc = set.grid.frame_arc * set.grid.frames() as f64;
            if arc == 0.0 && self.showing.has_movie() {
                let text =
                    "a list of angles, or a single frame, has no frame rate: no movie is written"
                        .to_owned();
                progress.event(&Event::Note { text });
            }
            let name = movie.as_ref().map(|movie| movie.file.as_str());
            lights.push(self.light_json(i, set, name));
            written.movies.push(movie);
        }
        let rpm = self.showing.rpm();
        let exposure = json!({ "schema": "tomolith.exposure/1", "rpm": rpm, "lights": lights });
        write_text(&folder.join(EXPOSURE), &format!("{exposure:#}\n"))?;
        Ok(written)
    }

    /// The movie of a light, read back; None where it has no frame rate, or the job wants no movie.
    fn write_movie(
        &self,
        folder: &Path,
        part: &str,
        light: usize,
        set: &FrameSet<'_>,
        work: &Work,
    ) -> Result<Option<MovieReport>> {
        let rpm = self.showing.rpm();
        let Some(ending) = self.showing.movie_ending(light) else {
            return Ok(None);
        };
        let arc = set.grid.frame_arc * set.grid.frames() as f64;
        if arc == 0.0 {
            return Ok(None);
        }
        let file = movie_name(part, set.light, rpm, ending);
        let path = folder.join(&file);
        let rate = frame_rate(rpm, set.grid.frames(), arc)?;
        let check = if ending == "mp4" {
            write_movie(&path, set, rate, &work.part(0.6))
                .and_then(|()| check_movie(&path, set, &work.part(0.4)))
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
        let grid = set.grid;
        let sense = self.showing.rotation(i);
        let degrees: Vec<f64> = grid
            .azimuths
            .iter()
            // Without the last digits of a conversion: 30, not 29.999999999999996
            .map(|a| (a.rem_euclid(TAU).to_degrees() * 1e9).round() / 1e9)
            .collect();
        json!({
            "name": set.light,
            "movie": movie,
            "frames": grid.frames(),
            "columns": grid.columns,
            "rows": grid.rows,
            "pixel_pitch_mm": grid.pitch_mm,
            "bits": set.bits,
            "white": set.full_scale,
            "frame_rate": frame_rate(self.showing.rpm(), grid.frames(), grid.frame_arc * grid.frames() as f64).ok(),
            "vial_turns": if sense == Rotation::Clockwise { "clockwise" } else { "counterclockwise" },
            "azimuth_deg": degrees,
            "budget": self.lights[i].budget,
            "irradiance": self.lights[i].irradiance,
        })
    }
}
