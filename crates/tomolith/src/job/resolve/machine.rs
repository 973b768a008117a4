//! The machine of a job: one printer per light, and what the time that a print may take allows.

use crate::error::{Error, Result};
use crate::exposure::{Budget, ExposureBudget, Printer, Rotation};
use crate::io::channel::Channel;
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::goal::Goal;
use crate::job::resolve::scheduled::{self, Emitted};
use crate::job::spec::{Angles, JobSpec, Levelling, LightSpec, MovieCoding};
use crate::optics::light::Light;
use crate::report::Irradiance;
use crate::units::exact;
use std::path::Path;

/// The machine of a job for each of its lights.
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
        Printer::new(
            &printer,
            base,
            &light.pixels,
            named.rotation,
            spec.turns_of_patterns(),
        )
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
/// Refuses a resin whose critical dose is not known.
pub(crate) fn white_in_time(spec: &JobSpec, goal: &Goal) -> Result<Option<(f64, f64)>> {
    let Some(seconds) = spec.printer.as_ref().and_then(|printer| printer.time_s) else {
        return Ok(None);
    };
    let response = goal.response.as_ref();
    let middle = || {
        let thresholds = goal.thresholds();
        thresholds.map(|[lower, upper]| f64::midpoint(lower, upper))
    };
    let threshold = spec.evaluate.threshold.or_else(middle).ok_or_else(|| {
        Error::config(
            "printer.time_s",
            "a time, but no dose at which the resin turns solid",
            "evaluate.threshold as well",
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
    // One bound holds for all lights, which follow each other: their mean weighs the time that each takes
    let lights = (0..spec.light.len()).map(|i| exposure(spec, i, gel_dose));
    let lights: Vec<ExposureBudget> = lights.collect();
    let frames = lights.iter().map(|light| light.frames).sum();
    let times = lights
        .iter()
        .map(|light| Some(light.frames as f64 / light.peak_mw_per_cm2?));
    let times: Option<f64> = times.sum();
    let exposure = ExposureBudget {
        frames,
        peak_mw_per_cm2: times.map(|times| frames as f64 / times),
        ..exposure(spec, 0, gel_dose)
    };
    Ok(exposure.white_in(seconds).map(|white| (white, seconds)))
}

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

/// Brightness of the darkest pixel, where that of the brightest is 1, of a machine that counts as even.
const EVEN: f64 = 0.99;

/// Share by which pixels of a light may differ from a whole number of the machine's.
const APART: f64 = 1e-3;

/// How the patterns of a job are shown: by which machine, how fast, in which files.
#[derive(Clone, Copy)]
pub(crate) struct Showing<'a> {
    spec: &'a JobSpec,
}

impl ResolvedJob {
    /// Edge of a machine's pixels, mm, where an edge of its light's pixels is no whole number of them; None where all are, or machines show the light's own.
    pub(crate) fn machine_pixels_apart_mm(&self) -> Option<f64> {
        let lights = self.optics.lights.iter().enumerate();
        let mut pairs = lights.filter_map(|(i, light)| {
            let printer = self.spec.printer_of(i)?;
            let mut edges_mm = printer.pixel_pitch_mm?.0;
            if !printer.quarter_turns.is_multiple_of(2) {
                edges_mm.reverse();
            }
            Some(light.pixels.pitch_mm.into_iter().zip(edges_mm))
        });
        let is_apart = |(of_light, of_machine): &(f64, f64)| {
            let times = of_light / of_machine;
            (times - times.round()).abs() > APART * times
        };
        pairs.find_map(|mut edges| edges.find(is_apart).map(|(_, of_machine)| of_machine))
    }

    /// Whether patterns are improved on pixels of a machine that change them. Those of jobs that refuse few levels are left as they are.
    pub(crate) fn may_improve_pixels(&self) -> bool {
        let has_heights = (self.schedule()).is_some_and(|schedule| schedule.level_heights);
        self.printers.is_some()
            && self.evaluation().levels == Levelling::Optimized
            && self.species.len() == 1
            && self.scenarios.is_empty()
            && self.ranks.is_none()
            && !has_heights
            && !self.is_optimized_in_time()
    }

    /// Whether they are likely to be, by what the job says of the machine: its pixels are turned, or of another size.
    pub(crate) fn improves_pixels(&self) -> bool {
        let mut printers = (0..self.spec.light.len()).filter_map(|i| self.spec.printer_of(i));
        let is_apart = printers.any(|printer| printer.rotation_deg != 0.0)
            || self.machine_pixels_apart_mm().is_some();
        self.may_improve_pixels() && is_apart
    }

    /// Whether a machine has pixels that are dead or dimmer than others.
    pub(crate) fn has_dim_pixels(&self) -> bool {
        let mut lights = (0..self.spec.light.len()).filter_map(|i| self.spec.printer_of(i));
        let has_dead = lights.any(|printer| printer.dead_pixels.is_some());
        let mut printers = self.printers.iter().flatten();
        has_dead || printers.any(|printer| printer.dimmest() < EVEN)
    }

    pub(crate) fn showing(&self) -> Showing<'_> {
        Showing::of(&self.spec)
    }
}

impl<'a> Showing<'a> {
    pub(crate) fn of(spec: &'a JobSpec) -> Self {
        Showing { spec }
    }

    /// Time that the print may take, s.
    pub(crate) fn allowed_s(self) -> Option<f64> {
        self.spec.printer.as_ref()?.time_s
    }

    /// The key that says how bright pixels may be.
    pub(crate) fn bound_key(self) -> &'static str {
        match self.allowed_s() {
            Some(_) => "printer.time_s",
            None => "bounds.max",
        }
    }

    /// Whether all frames are written as one stack, too.
    pub(crate) fn is_stacked(self) -> bool {
        let printer = self.spec.printer.as_ref();
        printer.is_some_and(|printer| printer.stack)
    }

    /// Turns of the vial per minute.
    pub(crate) fn rpm(self) -> f64 {
        self.spec.output.rpm
    }

    /// The speed at which the machine still shows every frame of a light once a turn.
    pub(crate) fn fastest_rpm(self, light: usize) -> f64 {
        let refresh_hz = self.spec.printer.as_ref().map(|printer| printer.refresh_hz);
        match (&self.spec.light[light].angles, refresh_hz) {
            (Angles::Even { count, arc_deg, .. }, Some(hz)) => {
                60.0 * hz * arc_deg / (360.0 * *count as f64)
            }
            _ => f64::INFINITY,
        }
    }

    /// Whether the job wants a movie.
    pub(crate) fn has_movie(self) -> bool {
        self.spec.output.movie != MovieCoding::None
    }

    /// The ending of a light's movie, by its coding: H.264 in `mp4`, lossless in `mov`.
    pub(crate) fn movie_ending(self, light: usize) -> Option<&'static str> {
        match self.spec.output.movie {
            // H.264 stores colors at half the resolution: of blue and black in turn, pixel by pixel, it leaves 141 and 112 of 255
            MovieCoding::H264 if self.spec.channel_of(light).is_some() => Some("mov"),
            MovieCoding::H264 => Some("mp4"),
            MovieCoding::Lossless => Some("mov"),
            MovieCoding::None => None,
        }
    }

    /// The channel of color images that shows a light's patterns.
    pub(crate) fn channel(self, light: usize) -> Option<Channel> {
        self.spec.channel_of(light)
    }

    /// The way that the vial turns before a light.
    pub(crate) fn rotation(self, light: usize) -> Rotation {
        let printer = self.spec.printer.as_ref();
        let of_machine = printer.and_then(|printer| printer.rotation);
        of_machine.unwrap_or(self.spec.light[light].rotation)
    }

    /// Times and energies of a light: those of the job's schedule, with how bright that shows it, or of a resin that is solid at a known dose (in units of
    /// the job).
    pub(crate) fn budget(
        self,
        light: usize,
        emitted: &Emitted<'_>,
        gel_dose: Option<f64>,
    ) -> Result<(Budget, Option<Irradiance>)> {
        if let Some((budget, irradiance)) = scheduled::budget(self.spec, light, emitted)? {
            return Ok((budget, Some(irradiance)));
        }
        let exposure = exposure(self.spec, light, gel_dose);
        let (white, sum) = (emitted.white, emitted.sums.iter().sum());
        let budget = exposure.budget(white, sum, emitted.all_white, emitted.pixel_mm2);
        Ok((budget, None))
    }
}
