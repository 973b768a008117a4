//! What a schedule makes of written patterns: the energy that reaches the vial, and how bright the brightest pixel is.
//!
//! **Equation** A pattern value of 1 is I₀ mW/mm² while its frame shines ([`Schedule`]), so a frame k sends P_k = I₀·A·Σ x mW, x its values and A the area of a
//! pixel; the energy by the time t is Σ P_k times the seconds that k has shone by then. White s is s·I₀.

use super::schedule::schedule;
use crate::error::Result;
use crate::exposure::Budget;
use crate::grid::Patterns;
use crate::job::resolve::ResolvedJob;
use crate::job::spec::JobSpec;
use crate::report::Irradiance;
use crate::report::number::told_apart;
use tomolith_material::schedule::Schedule;

/// Quantized patterns of one light, as [`Budget`] sees them.
pub(crate) struct Emitted<'a> {
    /// The pattern value of white.
    pub(crate) white: f64,
    /// Sum of the intensities of all pixels of each frame, where white is 1, in the order in which they are shown.
    pub(crate) sums: &'a [f64],
    /// How many frames there are.
    pub(crate) frames: usize,
    /// That of a frame of white pixels.
    pub(crate) all_white: f64,
    /// Area of a pixel, mm².
    pub(crate) pixel_mm2: f64,
}

/// Time, energy and brightness of light `i` in the schedule of a job; None without one.
pub(crate) fn budget(
    spec: &JobSpec,
    i: usize,
    emitted: &Emitted<'_>,
) -> Result<Option<(Budget, Irradiance)>> {
    let Some(given) = &spec.schedule else {
        return Ok(None);
    };
    let schedule = schedule(spec)?;
    let energies = schedule.energies(i);
    let all: f64 = energies.iter().sum();
    // A broken turn ends before its last frames
    let order = spec.shown_order(i)?;
    let order = order.unwrap_or_else(|| (0..energies.len()).collect());
    let shown = order.iter().zip(emitted.sums);
    let shown: f64 = shown.map(|(&frame, sum)| energies[frame] * sum).sum();
    let energy_mj = shown * emitted.white * emitted.pixel_mm2;
    let frames = energies.len().max(1) as f64;
    let turns = spec.light[i].turns.unwrap_or(given.turns);
    let budget = Budget {
        light_used: emitted.sums.iter().sum::<f64>()
            / (emitted.frames.max(1) as f64 * emitted.all_white),
        white_mj_per_mm2: Some(emitted.white * all / frames),
        time_s: Some(match spec.light[i].turns {
            Some(_) => shone_until(&schedule, i),
            None => schedule.end_s(),
        }),
        turns: Some(turns),
        energy_per_turn_mj: Some(energy_mj / turns),
        energy_mj: Some(energy_mj),
    };
    let irradiance = Irradiance {
        white_mw_per_cm2: 100.0 * emitted.white * unit(&schedule, i),
        peak_mw_per_cm2: peak(spec, i),
    };
    Ok(Some((budget, irradiance)))
}

/// When the last frame of a light ends, s.
fn shone_until(schedule: &Schedule, light: usize) -> f64 {
    let exposures = schedule.exposures().iter().filter(|e| e.light == light);
    exposures.map(|e| e.begin_s + e.seconds).fold(0.0, f64::max)
}

/// The most that the printer gives of a light, mW/cm².
fn peak(spec: &JobSpec, light: usize) -> Option<f64> {
    spec.printer_of(light)?.peak_irradiance_mw_per_cm2
}

/// Irradiance of a pattern value of 1 of a light, mW/mm².
fn unit(schedule: &Schedule, light: usize) -> f64 {
    let exposures = schedule.exposures().iter().filter(|e| e.light == light);
    exposures
        .map(|e| e.irradiance_mw_per_mm2)
        .fold(0.0, f64::max)
}

/// Warns of lights that must be brighter than the printer is, so that the times of the schedule cannot be kept.
pub(crate) fn too_bright(job: &ResolvedJob, shown: &[Patterns]) -> Result<Vec<String>> {
    let spec = &job.spec;
    if spec.schedule.is_none() {
        return Ok(Vec::new());
    }
    let schedule = schedule(spec)?;
    let of_light = |(i, patterns): (usize, &Patterns)| {
        let peak = peak(spec, i)?;
        let most = patterns.values.iter().copied().fold(0.0, f32::max);
        let asked = 100.0 * f64::from(most) * unit(&schedule, i);
        let name = spec.light[i].name.as_deref();
        // Rounding is no lack of light
        (asked > 1.001 * peak).then(|| {
            let numbers = told_apart(&[asked, peak], 3);
            format!(
                "the schedule needs {} mW/cm² where {} is brightest, and the printer gives {} (printer.peak_irradiance_mw_per_cm2): it cannot show these \
                 patterns in this time; use longer turns (schedule.seconds_per_turn), more turns with less power each, or a larger schedule.duty",
                numbers[0],
                name.map_or_else(|| format!("light[{i}]"), str::to_owned),
                numbers[1],
            )
        })
    };
    Ok(shown.iter().enumerate().filter_map(of_light).collect())
}

/// Energy that all lights have sent to the vial by these times (ascending, s), mJ.
pub(crate) fn sent_mj(schedule: &Schedule, patterns: &[Patterns], seconds: &[f64]) -> Vec<f64> {
    let sums: Vec<Vec<f64>> = patterns.iter().map(of_frames).collect();
    // When the power changes, and by how many mW
    let mut changes = Vec::with_capacity(2 * schedule.exposures().len());
    for e in schedule.exposures() {
        let power = e.irradiance_mw_per_mm2 * sums[e.light][e.frame];
        changes.extend([[e.begin_s, power], [e.begin_s + e.seconds, -power]]);
    }
    changes.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (mut now, mut power, mut energy) = (0.0, 0.0, 0.0);
    let mut changes = changes.into_iter().peekable();
    let by = |&until: &f64| {
        while let Some([at, change]) = changes.next_if(|[at, _]| *at <= until) {
            energy += power * (at - now);
            (now, power) = (at, power + change);
        }
        energy += power * (until - now);
        now = until;
        energy
    };
    seconds.iter().map(by).collect()
}

/// A·Σ x of each frame, mm².
fn of_frames(patterns: &Patterns) -> Vec<f64> {
    let grid = &patterns.grid;
    let frames = patterns.values.chunks((grid.rows * grid.columns).max(1));
    let sum = |frame: &[f32]| frame.iter().map(|&x| f64::from(x)).sum::<f64>();
    frames.map(|frame| grid.pixel_mm2() * sum(frame)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::PatternGrid;
    use tomolith_core::near;
    use tomolith_material::schedule::{Power, Turns};

    /// Of a white of 2, four pixels of 0.25 mm² and frames with these sums, shown at 3 mW/mm² by turns of four angles and 8 s.
    fn budget_of(turns: &str, machine: &str, sums: &[f64]) -> Budget {
        let text = format!(
            r#"
            target = {{ phantom = "gear", size_mm = 2.0 }}
            resin = {{ refractive_index = 1.5, absorption_per_mm = 0.1, critical_dose_mj_per_mm3 = 0.1 }}
            vial = {{ index_matched = {{ radius_mm = 3.0 }} }}
            light = [{{ pixels = [2, 2], angles = 4, projector = {{ collimated = {{ pixel_pitch_mm = 0.5 }} }} }}]
            schedule = {{ {turns}, seconds_per_turn = 8.0, power = {{ irradiance_mw_per_mm2 = 3.0 }} }}
            {machine}
        "#
        );
        let document = crate::job::Document::toml("a.toml", &text).unwrap();
        let spec = JobSpec::from_document(&document).unwrap();
        let emitted = Emitted {
            white: 2.0,
            sums,
            frames: sums.len(),
            all_white: 4.0,
            pixel_mm2: 0.25,
        };
        budget(&spec, 0, &emitted).unwrap().unwrap().0
    }

    #[test]
    fn a_broken_turn_sends_what_its_frames_send() {
        // Half a turn shows the first two of four frames of the machine; the others are brighter, and never seen
        for machine in ["", "printer = { rotation = \"counterclockwise\" }"] {
            let budget = budget_of("turns = 0.5", machine, &[1.0, 2.0, 4.0, 4.0]);
            // 2 s · 3 mW/mm² · 2 (white) · 0.25 mm² · (1 + 2)
            near!(budget.energy_mj.unwrap(), 9.0, 1e-9);
            near!(budget.energy_per_turn_mj.unwrap(), 18.0, 1e-9);
        }
    }

    #[test]
    fn white_of_two_turns_with_patterns_of_their_own_is_shown_for_one_frame() {
        let budget = budget_of("turns = 2, own_patterns = true", "", &[1.0; 8]);
        // 2 s · 3 mW/mm² · 2 (white)
        near!(budget.white_mj_per_mm2.unwrap(), 12.0, 1e-9);
    }

    #[test]
    fn energy_grows_while_frames_shine() {
        // Two frames of 5 s, half of it lit, at 2 mW/mm²; pixels of 0.25 mm²: 8 mW, then 4 mW
        let grid = PatternGrid::full_turn(2, 0.0, 2, 2, 0.5);
        let patterns = Patterns {
            values: [[4.0; 4], [2.0; 4]].concat(),
            grid,
        };
        let turns = Turns {
            duty: 0.5,
            power: Power::Irradiance(2.0),
            dark_before_s: 1.0,
            ..Turns::new(2, 10.0, 1.5)
        };
        let schedule = Schedule::of_turns(&[turns]).unwrap();
        let times = [0.5, 2.0, 3.5, 6.0, 8.5, 16.0];
        let found = sent_mj(&schedule, &[patterns], &times);
        for (found, expected) in found.iter().zip([0.0, 8.0, 20.0, 20.0, 30.0, 50.0]) {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
    }
}
