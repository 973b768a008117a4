//! The voxel that a printer can make: pixel or angle step, whichever is larger.
//!
//! **Equation** (Wang et al. 2022, supplement, S1 to S3; N_θ corrected: frames that repeat after half a turn are no new angles)
//!
//! ```text
//! p = 2R/N_p      N_θ = FPS·min(τ_c, 180°/v)      l = max(p, R·π/N_θ)      covered = min(1, v·τ_c/180°)
//! τ_c = (E_d/αI₀)·e^(R/D_p)                       R* = D_p·ln(π·N_p/(2·FPS·E_d/αI₀))
//! ```
//!
//! **Units** mm, s, degrees per s. **Limits** τ_c is that of the axis; R* is that of the printed N_θ.
//!
//! ```
//! use tomolith_planning::voxel::Setup;
//! let setup = Setup { pixels: 1000.0, fps: 60.0, dose_time_s: 5.0, penetration_mm: 10.0, turn_deg_per_s: Some(5.0) };
//! let radius = setup.crossing_mm().unwrap();
//! let size = setup.printed(radius); // there pixel and angle step are the same
//! assert!((size.pixel_mm - size.step_mm).abs() < 1e-12);
//! assert!(setup.corrected(radius).step_mm >= size.step_mm - 1e-12);
//! ```

use crate::plan::LONGEST_S;
use serde::Serialize;
use tomolith_core::error::{Result, above_zero, in_range};
use tomolith_core::units::concise;

/// A printer with its resin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    /// N_p: pixels across the vial.
    pub pixels: f64,
    /// Frames a second.
    pub fps: f64,
    /// E_d/αI₀: time in which unattenuated light brings the dose, s.
    pub dose_time_s: f64,
    /// D_p, mm.
    pub penetration_mm: f64,
    /// v; None: fast enough that the half turn is covered in the curing time.
    pub turn_deg_per_s: Option<f64>,
}

/// Sizes at a radius.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Size {
    /// p, mm.
    pub pixel_mm: f64,
    /// R·δθ, mm.
    pub step_mm: f64,
    /// Angles in a half turn.
    pub angles: f64,
    /// τ_c, s.
    pub curing_s: f64,
    /// Share of the half turn that is shown before the axis cures.
    pub covered: f64,
}

impl Size {
    /// l, mm.
    #[must_use]
    pub fn voxel_mm(&self) -> f64 {
        self.pixel_mm.max(self.step_mm)
    }
}

/// The fastest stage, degrees a second: a hundred turns.
pub const FASTEST_DEG_PER_S: f64 = 36_000.0;

impl Setup {
    /// Checks every number.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) with the option that is out of range.
    pub fn check(&self) -> Result<()> {
        for (key, value) in [
            ("--pixels", self.pixels),
            ("--fps", self.fps),
            ("--penetration-mm", self.penetration_mm),
        ] {
            above_zero(key, value)?;
        }
        let turn = self.turn_deg_per_s.unwrap_or(1.0);
        for (key, value, most, unit) in [
            ("--dose-time-s", self.dose_time_s, LONGEST_S, "s"),
            (
                "--turn-deg-per-s",
                turn,
                FASTEST_DEG_PER_S,
                "degrees a second",
            ),
        ] {
            let accepted = format!("above 0, at most {} {unit}", concise(most));
            in_range(value > 0.0 && value <= most, key, value, accepted)?;
        }
        Ok(())
    }

    /// τ_c on the axis, s.
    #[must_use]
    pub fn curing_s(&self, radius_mm: f64) -> f64 {
        self.dose_time_s * (radius_mm / self.penetration_mm).exp()
    }

    /// As printed: N_θ = FPS·τ_c.
    #[must_use]
    pub fn printed(&self, radius_mm: f64) -> Size {
        self.size(radius_mm, f64::INFINITY)
    }

    /// With the angles that differ.
    #[must_use]
    pub fn corrected(&self, radius_mm: f64) -> Size {
        self.size(radius_mm, self.half_turn_s())
    }

    fn half_turn_s(&self) -> f64 {
        self.turn_deg_per_s.map_or(f64::INFINITY, |v| 180.0 / v)
    }

    fn size(&self, radius_mm: f64, longest_s: f64) -> Size {
        let curing_s = self.curing_s(radius_mm);
        let angles = self.fps * curing_s.min(longest_s);
        let half = self.half_turn_s();
        Size {
            pixel_mm: 2.0 * radius_mm / self.pixels,
            step_mm: radius_mm * std::f64::consts::PI / angles,
            angles,
            curing_s,
            covered: if half.is_finite() {
                (curing_s / half).min(1.0)
            } else {
                1.0
            },
        }
    }

    /// R*: above it the pixel is the larger one, mm; None where it always is.
    #[must_use]
    pub fn crossing_mm(&self) -> Option<f64> {
        let ratio = std::f64::consts::PI * self.pixels / (2.0 * self.fps * self.dose_time_s);
        let radius = self.penetration_mm * ratio.ln();
        (radius > 0.0).then_some(radius)
    }

    /// The crossing with the angles that differ: None where one of the two is always the larger one.
    #[must_use]
    pub fn corrected_crossing_mm(&self) -> Option<f64> {
        // Beyond the radius at which a half turn is covered both grow in proportion
        self.crossing_mm()
            .filter(|radius| self.curing_s(*radius) <= self.half_turn_s())
    }
}
