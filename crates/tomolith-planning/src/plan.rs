//! Power and critical dose → time, turns, speed, frame rate, duty and energy.
//!
//! **Equation** [`ExposureBudget`] says how many passes white needs, S/(I·Δt), and what a pass costs. Turns are rounded up to whole ones, so that every angle
//! gets the same; the light is then on for duty = passes/whole passes of each frame's time.
//!
//! ```text
//! time = whole·60/rpm·(arc/turn)        frame rate = 6·rpm/Δθ        energy of frame k = I·duty·Δt·A_pixel·Σ_k
//! ```
//!
//! The window is that of the run: the exposures over which the print stays nearly as good, in % of the best one, here also in s.
//!
//! ```
//! use tomolith_planning::plan::{Machine, ExposurePlan};
//! use tomolith_planning::delivered::ShownFrames;
//! // 10 frames of 100 pixels of 0.01 mm², half of them white; white is 2.4, and the resin gels at 0.8 = 2 mJ/mm³: 6 mJ/mm²
//! let shown = ShownFrames { sums: vec![50.0; 10], all_white: 100.0, pixel_mm2: 0.01, white: Some(2.4) };
//! let machine = Machine { irradiance: 95.0, rpm: 10.0, turns: None, refresh_hz: 60.0, within_s: None };
//! let plan = ExposurePlan::new(&shown, &machine, 2.4, std::f64::consts::TAU / 10.0, 2.0, 0.8, None).unwrap();
//! // 0.95 mW/mm² for 0.6 s in each turn: 10.53 turns, so 11 with the light on for 95.7 % of the time
//! assert_eq!(plan.turns, 11.0);
//! assert!((plan.duty - 6.0 / 0.57 / 11.0).abs() < 1e-12 && (plan.time_s - 66.0).abs() < 1e-9);
//! assert!((plan.energy_mj - 6.0 * 0.01 * 500.0).abs() < 1e-9); // 6 mJ/mm² on all that is lit
//! ```

use crate::delivered::ShownFrames;
use serde::Serialize;
use tomolith_core::error::{Error, Result};
use tomolith_core::units::concise;
use tomolith_optics::exposure::ExposureBudget;

/// A machine, as far as a plan needs it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Machine {
    /// Irradiance at white, mW/cm².
    pub irradiance: f64,
    /// Turns a minute.
    pub rpm: f64,
    /// Turns that the print is to take, or passes of a part of a turn: the speed follows, and `rpm` is not read.
    pub turns: Option<f64>,
    /// Images a second that the device shows.
    pub refresh_hz: f64,
    /// Longest time that the print may take, s.
    pub within_s: Option<f64>,
}

/// The longest print and the longest curing time, s: a third of a year, beyond which a number or its unit is a slip.
pub const LONGEST_S: f64 = 1e7;

/// A window of exposures in %, and the best one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Window {
    /// The shortest exposure; None where there is no limit.
    pub low: Option<f64>,
    /// The longest exposure.
    pub high: Option<f64>,
}

/// How a print is exposed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ExposurePlan {
    /// White, over the whole print, mJ/mm².
    pub white_mj_per_mm2: f64,
    /// Time with the light always on, s.
    pub continuous_s: f64,
    /// Time of whole passes, s.
    pub time_s: f64,
    /// Turns of the vial, in whole passes of all frames; these passes, where they cover a part of a turn.
    pub turns: f64,
    /// Turns of a pass, where every turn has frames of its own; else 1.
    pub turns_a_pass: f64,
    /// Share of each frame's time in which the light is on.
    pub duty: f64,
    /// Turns a minute.
    pub rpm: f64,
    /// Frames a second.
    pub frame_rate_hz: f64,
    /// Time of a frame in a pass, s.
    pub frame_s: f64,
    /// Energy at the vial of a frame in a pass, mJ: the mean, and the largest.
    pub frame_mj: [f64; 2],
    /// Energy at the vial in all, mJ.
    pub energy_mj: f64,
    /// Mean over all pixels and frames, white being 1.
    pub light_used: f64,
    /// Exposures over which the print stays nearly as good, % of the best one.
    pub window_percent: Option<Window>,
    /// The window as times at this speed and duty, s.
    pub window_s: Option<Window>,
}

impl ExposurePlan {
    /// For frames whose white has a value in units of the job and whose arcs are `frame_arc` (rad), of a resin that gels at `gel_dose` in these units and at
    /// `critical` mJ/mm³ in fact.
    ///
    /// # Errors
    /// [`Error::Config`] for frames without times, a time that does not do (with the share of the dose that it gives) or is beyond [`LONGEST_S`], turns that are no
    /// whole passes, and frames faster than the device.
    pub fn new(
        shown: &ShownFrames,
        machine: &Machine,
        white: f64,
        frame_arc: f64,
        critical: f64,
        gel_dose: f64,
        window: Option<Window>,
    ) -> Result<Self> {
        if frame_arc <= 0.0 {
            return Err(Error::config(
                "RUN",
                "frames of a list of angles, which have no times",
                "a run whose light.angles are even",
            ));
        }
        let frames = shown.sums.len();
        let at_speed = |rpm: f64| ExposureBudget {
            peak_mw_per_cm2: Some(machine.irradiance),
            rpm,
            frames,
            frame_arc,
            critical_mj_per_mm3: Some(critical),
            gel_dose: Some(gel_dose),
        };
        let total: f64 = shown.sums.iter().sum();
        let turns_a_pass = at_speed(machine.rpm).turns_a_pass();
        must_be_whole_passes(machine.turns, turns_a_pass)?;
        let budget = at_speed(machine.rpm).budget(white, total, shown.all_white, shown.pixel_mm2);
        let (Some(continuous_s), Some(exact), Some(white_mj_per_mm2)) =
            (budget.time_s, budget.turns, budget.white_mj_per_mm2)
        else {
            return Err(Error::config(
                "RUN",
                format!("white {white} and a gel dose {gel_dose}"),
                "numbers above 0",
            ));
        };
        // A pass of a part of a turn is shorter
        let arc = frame_arc * frames as f64 / std::f64::consts::TAU;
        let (passes, rpm) = match machine.turns.map(|turns| turns / turns_a_pass) {
            Some(passes) => (passes, 60.0 * arc * passes / continuous_s),
            // A hair over a whole number is that number
            None => ((exact / turns_a_pass - 1e-9).ceil().max(1.0), machine.rpm),
        };
        let turns = passes * turns_a_pass;
        let pass_s = arc * 60.0 / rpm;
        let time_s = passes * pass_s;
        let duty = continuous_s / time_s;
        if time_s > LONGEST_S || time_s.is_nan() {
            let found = format!(
                "{} s in {} turns at {} a minute, with {} mW/cm² and a critical dose of {} mJ/mm³",
                concise(time_s),
                concise(turns),
                concise(rpm),
                concise(machine.irradiance),
                concise(critical)
            );
            let accepted = format!("at most {} s", concise(LONGEST_S));
            return Err(Error::config("time to print", found, accepted));
        }
        must_end_in_time(
            machine,
            [turns, time_s],
            [turns_a_pass, pass_s],
            continuous_s,
        )?;
        let frame_s = frame_arc.to_degrees() / (6.0 * rpm);
        must_be_shown(machine, frames, frame_arc, frame_s)?;
        let lit = machine.irradiance / 100.0 * frame_s * duty * shown.pixel_mm2;
        let largest = shown.sums.iter().copied().fold(0.0, f64::max);
        let scale = |value: Option<f64>| value.map(|percent| time_s * percent / 100.0);
        Ok(ExposurePlan {
            white_mj_per_mm2,
            continuous_s,
            time_s,
            turns,
            turns_a_pass,
            duty,
            rpm,
            frame_rate_hz: 1.0 / frame_s,
            frame_s,
            frame_mj: [lit * total / frames as f64, lit * largest],
            energy_mj: lit * total * passes,
            light_used: shown.mean(),
            window_percent: window,
            window_s: window.map(|w| Window {
                low: scale(w.low),
                high: scale(w.high),
            }),
        })
    }
}

/// Refuses turns that end within a pass of the frames of several.
fn must_be_whole_passes(turns: Option<f64>, turns_a_pass: f64) -> Result<()> {
    let ends_within = |turns: &f64| {
        let passes = turns / turns_a_pass;
        (passes - passes.round()).abs() > 1e-9
    };
    match turns.filter(ends_within) {
        Some(turns) => Err(Error::config(
            "--turns",
            format!("found {}", concise(turns)),
            format!(
                "{0}, or a multiple of {0}: every turn has frames of its own",
                concise(turns_a_pass)
            ),
        )),
        None => Ok(()),
    }
}

/// Refuses a time that is too short, with the share of the dose that it gives.
fn must_end_in_time(
    machine: &Machine,
    [turns, time_s]: [f64; 2],
    [turns_a_pass, pass_s]: [f64; 2],
    continuous_s: f64,
) -> Result<()> {
    let Some(within) = machine.within_s.filter(|within| *within < time_s) else {
        return Ok(());
    };
    let whole = (within / pass_s + 1e-9).floor();
    let brighter = |seconds: f64| {
        // Rounded up, so that what is advised is enough
        let needed = machine.irradiance * continuous_s / seconds;
        format!(
            "an irradiance from {} mW/cm²",
            concise((100.0 * needed).ceil() / 100.0)
        )
    };
    let other = if machine.turns.is_some() {
        brighter(within)
    } else if whole >= 1.0 {
        brighter(whole * pass_s)
    } else if within >= continuous_s {
        "a faster vial (--rpm)".to_owned()
    } else {
        format!("{} in a faster vial (--rpm)", brighter(within))
    };
    let whole_turns = whole * turns_a_pass;
    Err(Error::config(
        "--within-s",
        format!(
            "{} s hold {} whole turns, which give {:.1} % of the dose at which the resin gels",
            concise(within),
            concise(whole_turns),
            100.0 * whole * pass_s / continuous_s
        ),
        format!(
            "{} s or more ({} whole turns), or {other}",
            concise(time_s),
            concise(turns)
        ),
    ))
}

/// Refuses frames that follow one another faster than the device shows them.
fn must_be_shown(machine: &Machine, frames: usize, frame_arc: f64, frame_s: f64) -> Result<()> {
    if 1.0 / frame_s > machine.refresh_hz * (1.0 + 1e-9) {
        return Err(Error::config(
            if machine.turns.is_some() {
                "--turns"
            } else {
                "--rpm"
            },
            format!(
                "{} frames a second, and the device shows {}",
                concise(1.0 / frame_s),
                concise(machine.refresh_hz)
            ),
            format!(
                "at most {} turns a minute with {frames} frames",
                concise(machine.refresh_hz * frame_arc.to_degrees() / 6.0)
            ),
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn turns_with_frames_of_their_own_are_passes_of_several() {
        // Three turns of ten frames; white is 6 mJ/mm², of which a frame of 0.6 s gives 0.57
        let shown = ShownFrames {
            sums: vec![50.0; 30],
            all_white: 100.0,
            pixel_mm2: 0.01,
            white: Some(2.4),
        };
        let machine = Machine {
            irradiance: 95.0,
            rpm: 10.0,
            turns: None,
            refresh_hz: 60.0,
            within_s: None,
        };
        let plan = |turns, within_s| {
            let machine = Machine {
                turns,
                within_s,
                ..machine
            };
            ExposurePlan::new(&shown, &machine, 2.4, TAU / 10.0, 2.0, 0.8, None)
        };
        let at_speed = plan(None, None).unwrap();
        assert_eq!((at_speed.turns, at_speed.turns_a_pass), (33.0, 3.0));
        assert!((at_speed.time_s - 33.0 * 6.0).abs() < 1e-9);
        assert!((at_speed.energy_mj - 6.0 * 0.01 * 1500.0).abs() < 1e-9);
        // 30 frames of 6/0.95 s in three turns
        let slow = plan(Some(3.0), None).unwrap();
        assert!((slow.time_s - 30.0 * 6.0 / 0.95).abs() < 1e-9);
        assert!((slow.rpm - 3.0 * 60.0 / slow.time_s).abs() < 1e-9);
        let message = |turns, within_s| plan(turns, within_s).unwrap_err().to_string();
        assert!(message(Some(4.0), None).contains("3, or a multiple of 3"));
        // No vial is fast enough where light that is always on takes longer
        let refusal = message(None, Some(5.0));
        tomolith_core::contains!(refusal, "0 whole turns", "mW/cm² in a faster vial");
        assert!(message(Some(3.0), Some(5.0)).ends_with("mW/cm²"));
    }
}
