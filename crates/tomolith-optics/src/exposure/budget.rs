//! How long a print takes, and where the light goes.
//!
//! # Equation
//! White (see [`super::printer`]) is s, in relative units; a dose d₀ of the job turns the resin solid, which takes D_c mJ/mm³
//! in fact (`resin.critical_dose_mj_per_mm3`). So white is S = s·D_c/d₀ mJ/mm². The brightest pixel gives I mW/mm² (a
//! hundredth of `printer.peak_irradiance_mw_per_cm2`), and a frame is shown for t = Δθ/(6·rpm) seconds in each turn, Δθ its
//! arc in degrees. Then, with n frames, E = Σ over all pixels of all frames of their intensity (white = 1), N pixels of
//! area A mm² on the device,
//!
//! ```text
//! passes    S/(I·t)                 time    passes·n·t
//! energy per pass   I·t·A·E mJ      light used   E/(n·N)
//! ```
//!
//! Where the frames cover one turn, a pass is a turn. Where every turn has frames of its own, a pass takes several: turns, and the energy of one, are then those of turns and not of passes.
//!
//! The other way round, the longest pattern value that fits into a time T is s = (I·T/n)·d₀/D_c ([`ExposureBudget::white_in`]).
//!
//! ```
//! use tomolith_optics::exposure::{Budget, ExposureBudget};
//! // 100 mW/cm² = 1 mW/mm²; 10 frames a turn of 6 s: 0.6 s each, 0.6 mJ/mm² a pass
//! let exposure = ExposureBudget { peak_mw_per_cm2: Some(100.0), rpm: 10.0, frames: 10, frame_arc: std::f64::consts::TAU / 10.0,
//!     critical_mj_per_mm3: Some(2.0), gel_dose: Some(0.8) };
//! // White is 2.4·2/0.8 = 6 mJ/mm²: ten passes of 6 s. Half of 1000 pixels of 0.01 mm² are white
//! let budget = exposure.budget(2.4, 5000.0, 1000.0, 0.01);
//! assert!((budget.time_s.unwrap() - 60.0).abs() < 1e-9 && (budget.turns.unwrap() - 10.0).abs() < 1e-9);
//! assert!((budget.energy_per_turn_mj.unwrap() - 30.0).abs() < 1e-9); // 0.6·0.01·5000
//! assert_eq!(budget.light_used, 0.5);
//! assert!((exposure.white_in(60.0).unwrap() - 2.4).abs() < 1e-9);
//! ```

use serde::Serialize;
use std::f64::consts::TAU;

/// What is known of an exposure before it is simulated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExposureBudget {
    /// Irradiance of the brightest pixel at white, mW/cm².
    pub peak_mw_per_cm2: Option<f64>,
    /// Turns a minute.
    pub rpm: f64,
    /// Frames of one pass.
    pub frames: usize,
    /// Arc of a frame, rad; 0 for a list of angles, which has no times.
    pub frame_arc: f64,
    /// Dose that turns the resin solid, mJ/mm³.
    pub critical_mj_per_mm3: Option<f64>,
    /// The gel dose in the job's units.
    pub gel_dose: Option<f64>,
}

/// Time, energy and use of the light; None where something is not known.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Budget {
    /// Light of all frames over that of as many frames of white pixels.
    pub light_used: f64,
    /// White, mJ/mm² over the whole print.
    pub white_mj_per_mm2: Option<f64>,
    /// Time of the print, s.
    pub time_s: Option<f64>,
    /// Turns of the vial; passes of all frames, where these cover a part of a turn.
    pub turns: Option<f64>,
    /// Energy at the vial in one of them, mJ.
    pub energy_per_turn_mj: Option<f64>,
    /// Energy at the vial in all, mJ.
    pub energy_mj: Option<f64>,
}

impl ExposureBudget {
    /// Time for which a frame is shown in each pass, s.
    fn frame_s(&self) -> Option<f64> {
        let seconds = self.frame_arc.to_degrees() / (6.0 * self.rpm);
        (seconds > 0.0 && seconds.is_finite()).then_some(seconds)
    }

    /// Turns that a pass of all frames takes; a part of a turn counts as one.
    #[must_use]
    pub fn turns_a_pass(&self) -> f64 {
        let turns = self.frame_arc * self.frames as f64 / TAU;
        // Three turns of 40 frames are 3, and not 3.0000000000000004
        ((turns * 1e9).round() / 1e9).max(1.0)
    }

    /// mJ/mm² per unit of a pattern.
    fn unit(&self) -> Option<f64> {
        let gel = self.gel_dose.filter(|dose| *dose > 0.0)?;
        Some(self.critical_mj_per_mm3? / gel)
    }

    /// mW/mm².
    fn peak(&self) -> Option<f64> {
        self.peak_mw_per_cm2.map(|peak| peak / 100.0)
    }

    /// The pattern value of white when the print takes so many seconds.
    #[must_use]
    pub fn white_in(&self, seconds: f64) -> Option<f64> {
        Some(self.peak()? * seconds / self.frames as f64 / self.unit()?)
    }

    /// The budget of frames with this white and sum of intensities, where that of a frame of white pixels, of an area (mm²) each, is `all_white`.
    #[must_use]
    pub fn budget(&self, white: f64, emitted: f64, all_white: f64, area_mm2: f64) -> Budget {
        let white_mj_per_mm2 = self.unit().map(|unit| white * unit);
        let per_pass = self
            .peak()
            .zip(self.frame_s())
            .map(|(peak, seconds)| peak * seconds);
        let turns_a_pass = self.turns_a_pass();
        let turns = white_mj_per_mm2
            .zip(per_pass)
            .map(|(white, pass)| white / pass * turns_a_pass);
        let turn_s = self
            .frame_s()
            .map(|seconds| seconds * self.frames as f64 / turns_a_pass);
        let energy_per_turn_mj = per_pass.map(|pass| pass * area_mm2 * emitted / turns_a_pass);
        Budget {
            light_used: emitted / (self.frames.max(1) as f64 * all_white),
            white_mj_per_mm2,
            time_s: turns.zip(turn_s).map(|(turns, seconds)| turns * seconds),
            turns,
            energy_per_turn_mj,
            energy_mj: energy_per_turn_mj
                .zip(turns)
                .map(|(energy, turns)| energy * turns),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_known_is_not_invented() {
        let exposure = ExposureBudget {
            peak_mw_per_cm2: Some(10.0),
            rpm: 6.0,
            frames: 4,
            frame_arc: 0.0,
            critical_mj_per_mm3: None,
            gel_dose: Some(0.9),
        };
        let budget = exposure.budget(1.0, 3.0, 2.0, 1.0);
        assert_eq!(budget.light_used, 3.0 / 8.0);
        assert_eq!(
            (
                budget.time_s,
                budget.energy_per_turn_mj,
                budget.white_mj_per_mm2
            ),
            (None, None, None)
        );
        let turning = ExposureBudget {
            frame_arc: 0.1,
            ..exposure
        };
        // 0.1 mW/mm² for 0.1 rad = 5.73° at 36°/s
        let expected = 0.1 * 0.1f64.to_degrees() / 36.0 * 3.0;
        assert!(
            (turning
                .budget(1.0, 3.0, 2.0, 1.0)
                .energy_per_turn_mj
                .unwrap()
                - expected)
                .abs()
                < 1e-12
        );
        assert_eq!(turning.white_in(5.0), None);
    }
}
