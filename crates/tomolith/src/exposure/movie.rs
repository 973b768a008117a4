//! Rate and name of the movie of all frames.
//!
//! A frame stays on while the vial turns through its arc Δθ, so at r turns a minute (6·r degrees a second) the frame
//! rate is
//!
//! ```text
//! f = 6·r/Δθ        [1/s, 1/min, degrees]
//! ```
//!
//! ```
//! use tomolith::exposure::{frame_rate, movie_name};
//! // 300 frames a turn at 12 turns a minute: 6·12/1.2 = 60 frames a second
//! assert!((frame_rate(12.0, 300, std::f64::consts::TAU).unwrap() - 60.0).abs() < 1e-12);
//! assert_eq!(movie_name("gear", 12.0), "gear_12rpm.mp4");
//! assert_eq!(movie_name("a/b gear", 4.5), "a_b_gear_4.5rpm.mp4");
//! ```

use crate::error::{Error, Result};
use std::f64::consts::TAU;

/// Frames a second, when `frames` frames fill an `arc` (rad) of the vial's turn at `rpm` turns a minute.
///
/// # Errors
/// [`Error::Config`] when `rpm` or `arc` is not finite and positive, or there is no frame.
pub fn frame_rate(rpm: f64, frames: usize, arc: f64) -> Result<f64> {
    if !(rpm.is_finite() && rpm > 0.0) {
        return Err(Error::config(
            "output.rpm",
            format!("found {rpm}"),
            "a finite number > 0, turns a minute",
        ));
    }
    if frames == 0 || !(arc.is_finite() && arc > 0.0) {
        return Err(Error::config(
            "light.angles",
            format!(
                "{frames} frames over an arc of {} degrees",
                arc.to_degrees()
            ),
            "at least one frame, and an arc > 0 (a list of angles has no frame rate)",
        ));
    }
    Ok(rpm / 60.0 * TAU * frames as f64 / arc)
}

/// `<part>_<rpm>rpm.mp4`; what is no letter, digit, `-`, `_` or `.` in the part's name becomes `_`.
#[must_use]
pub fn movie_name(part: &str, rpm: f64) -> String {
    let part: String = part
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || "-_.".contains(c) {
                c
            } else {
                '_'
            }
        })
        .collect();
    let part = part.trim_matches(|c| c == '.' || c == '_');
    let part = if part.is_empty() { "part" } else { part };
    format!("{part}_{rpm}rpm.mp4")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_a_turn_in_half_the_frames_has_the_same_rate() {
        let full = frame_rate(7.3, 360, TAU).unwrap();
        assert!((full - 7.3 * 6.0).abs() < 1e-12); // one degree a frame
        assert!((frame_rate(7.3, 180, TAU / 2.0).unwrap() - full).abs() < 1e-12);
    }

    #[test]
    fn impossible_rates_are_refused_and_names_stay_in_their_folder() {
        for (rpm, frames, arc) in [
            (0.0, 9, 1.0),
            (f64::NAN, 9, 1.0),
            (1.0, 0, 1.0),
            (1.0, 9, 0.0),
        ] {
            assert!(matches!(
                frame_rate(rpm, frames, arc),
                Err(Error::Config { .. })
            ));
        }
        assert_eq!(movie_name("../..", 1.0), "part_1rpm.mp4");
        assert_eq!(movie_name("größe", 1.0), "größe_1rpm.mp4");
    }
}
