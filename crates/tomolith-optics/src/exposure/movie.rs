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
//! use tomolith_optics::exposure::{frame_rate, movie_name};
//! // 300 frames a turn at 12 turns a minute: 6·12/1.2 = 60 frames a second
//! assert!((frame_rate(12.0, 300, std::f64::consts::TAU).unwrap() - 60.0).abs() < 1e-12);
//! assert_eq!(movie_name("gear", None, 12.0, "mp4"), "gear_12rpm.mp4");
//! assert_eq!(movie_name("a/b gear", Some("uv"), 4.5, "mov"), "a_b_gear_uv_4.5rpm.mov");
//! ```

use std::f64::consts::TAU;
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::text::file_name;
use tomolith_core::units::{concise, exact};

/// Frames a second, when `frames` frames fill an `arc` (rad) of the vial's turn at `rpm` turns a minute.
///
/// # Errors
/// [`Error::Config`] when `rpm` or `arc` is not finite and positive, or there is no frame.
pub fn frame_rate(rpm: f64, frames: usize, arc: f64) -> Result<f64> {
    in_range(
        rpm.is_finite() && rpm > 0.0,
        "output.rpm",
        rpm,
        "a finite number > 0, turns a minute",
    )?;
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

/// Slowest movie that players show evenly, frames a second.
pub const SLOWEST: f64 = 0.1;
/// Speeds are told in six digits: what is told is accepted.
const ROUNDED: f64 = 1e-5;
/// The fastest screens, images a second: the limit where no printer says its own.
pub const FASTEST: f64 = 240.0;

/// Whether a movie of more than one frame is slower than players show evenly.
#[must_use]
pub fn is_too_slow(rate_hz: f64, frames: usize) -> bool {
    frames > 1 && rate_hz < SLOWEST * (1.0 - ROUNDED)
}

/// The frame rate of a movie at `rpm`, when a device that shows `refresh_hz` images a second can play it.
///
/// ```
/// use tomolith_optics::exposure::shown_rate;
/// let rate = shown_rate(10.0, 360, std::f64::consts::TAU, 60.0).unwrap();
/// assert!((rate - 60.0).abs() < 1e-9); // ten turns of 360 frames a minute
/// let message = shown_rate(12.0, 360, std::f64::consts::TAU, 60.0).unwrap_err().to_string();
/// assert!(message.contains("72 frames a second") && message.contains("at most 10 turns"), "{message}");
/// ```
///
/// # Errors
/// [`Error::Config`] with the nearest speed that works; as [`frame_rate`].
pub fn shown_rate(rpm: f64, frames: usize, arc: f64, refresh_hz: f64) -> Result<f64> {
    let rate = frame_rate(rpm, frames, arc)?;
    let speed = |rate_hz: f64| rpm * rate_hz / rate;
    let refuse = |why: &str, accepted: String| {
        Err(Error::config(
            "output.rpm",
            format!(
                "{} turns per minute make a movie of {} frames a second, which {why}",
                exact(rpm),
                concise(rate)
            ),
            accepted,
        ))
    };
    if rate > refresh_hz * (1.0 + ROUNDED) {
        let most = (frames as f64 * refresh_hz / rate + ROUNDED).floor();
        return refuse(
            &format!("no device of {} images a second shows", exact(refresh_hz)),
            format!(
                "at most {} turns per minute (output.rpm){}, or a device of at least {} images a second (printer.refresh_hz)",
                concise(speed(refresh_hz)),
                if most < 1.0 {
                    String::new()
                } else {
                    format!(", at most {most} frames (light.angles)")
                },
                concise(rate)
            ),
        );
    }
    if is_too_slow(rate, frames) {
        let least = (frames as f64 * SLOWEST / rate - ROUNDED).ceil();
        return refuse(
            "players do not show evenly",
            format!(
                "at least {} turns per minute (output.rpm), or at least {} frames (light.angles)",
                concise(speed(SLOWEST)),
                exact(least)
            ),
        );
    }
    Ok(rate)
}

/// `<part>_<light>_<rpm>rpm.<ending>`, without a light where there is only one; what is no letter, digit, `-`, `_` or `.` in the
/// part's name becomes `_`, and a long one is cut.
#[must_use]
pub fn movie_name(part: &str, light: Option<&str>, rpm: f64, ending: &str) -> String {
    let part = file_name(part, '_');
    let part = part.trim_matches(|c| c == '.' || c == '_');
    let part = if part.is_empty() { "part" } else { part };
    let light = light.map_or_else(String::new, |light| format!("_{light}"));
    format!("{part}{light}_{rpm}rpm.{ending}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_that_no_player_shows_come_with_the_nearest_that_works() {
        let message = |rpm, frames| shown_rate(rpm, frames, TAU, 60.0).unwrap_err().to_string();
        let fast = message(30.0, 300);
        assert!(
            fast.starts_with("output.rpm: ") && fast.contains("at most 12 turns"),
            "{fast}"
        );
        assert!(fast.contains("at most 120 frames"), "{fast}");
        let slow = message(0.01, 300);
        tomolith_core::contains!(slow, "0.05 frames", "at least 0.02 turns");
        assert!(slow.contains("at least 600 frames"), "{slow}");
        // A third of a turn a minute is told as 0.0333333
        let slow = message(0.001, 180);
        assert!(slow.contains("at least 0.0333333 turns"), "{slow}");
        assert!(message(200.0, 90).contains("at most 18 frames"));
        for (rpm, frames) in [
            (12.0, 300),
            (30.0, 120),
            (0.02, 300),
            (0.01, 600),
            (0.0333333, 180),
            (200.0, 18),
        ] {
            assert!(shown_rate(rpm, frames, TAU, 60.0).is_ok(), "{rpm} {frames}");
        }
    }

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
        assert_eq!(movie_name("../..", None, 1.0, "mp4"), "part_1rpm.mp4");
        assert_eq!(movie_name("größe", None, 1.0, "mp4"), "größe_1rpm.mp4");
    }
}
