//! The gray curve of a device: level → intensity, and the level that comes nearest to an intensity.
//!
//! A curve is a table of points (value, intensity), joined by the monotone cubic of [`monotone_cubic`](tomolith_core::monotone_cubic);
//! value is the level over the highest level, 0 to 1. Intensities are divided by the last one, so that a curve may be given in whatever unit it was measured.
//! What is left at value 0 is light that the device cannot switch off.

use tomolith_core::error::{Error, Result};
use tomolith_core::monotone_cubic::{slopes, value_and_slope};
use tomolith_core::units::exact;
use tomolith_io::frames::top_level;

/// What a curve must be, for messages.
const ACCEPTED: &str = "at least two points [value, intensity], values rising from 0 to 1, intensities from 0 or more, each \
     larger than the one before; `tomolith calibrate gray` makes such a curve of measurements";

#[derive(Clone, Debug, PartialEq)]
pub(super) struct ToneCurve {
    points: Vec<[f64; 2]>,
    slopes: Vec<f64>,
}

impl ToneCurve {
    /// A curve from its table; `key` names it in errors.
    pub(super) fn new(points: &[[f64; 2]], key: &str) -> Result<Self> {
        let refuse = |found: String| Err(Error::config(key, found, ACCEPTED));
        if points.len() < 2 {
            return refuse(format!("{} points", points.len()));
        }
        if let Some(i) = points.iter().position(|p| !p.iter().all(|v| v.is_finite())) {
            return refuse(format!("point {} is {:?}", i + 1, points[i]));
        }
        let (first, last) = (points[0], points[points.len() - 1]);
        let refuse_but = |found: String| refuse(format!("{found}; {}", usable(points)));
        if first[1] < 0.0 {
            return refuse_but(format!("an intensity of {}", first[1]));
        }
        for (i, pair) in points.windows(2).enumerate() {
            for (what, axis) in [("value", 0), ("intensity", 1)] {
                if pair[1][axis] <= pair[0][axis] {
                    return refuse_but(format!(
                        "the {what} goes from {} to {} between points {} and {}: not monotone",
                        pair[0][axis],
                        pair[1][axis],
                        i + 1,
                        i + 2
                    ));
                }
            }
        }
        if first[0] != 0.0 || last[0] != 1.0 {
            return refuse(format!(
                "values from {} to {}",
                exact(first[0]),
                exact(last[0])
            ));
        }
        let white = last[1];
        let values: Vec<f64> = points.iter().map(|p| p[0]).collect();
        let intensities: Vec<f64> = points.iter().map(|p| p[1] / white).collect();
        Ok(ToneCurve {
            slopes: slopes(&values, &intensities),
            points: values
                .into_iter()
                .zip(intensities)
                .map(Into::into)
                .collect(),
        })
    }

    fn at(&self, value: f64) -> f64 {
        let next = self.points.partition_point(|p| p[0] <= value);
        if next == self.points.len() {
            // White, as rounding would miss it
            return 1.0;
        }
        let k = next - 1;
        let ([x0, y0], [x1, y1]) = (self.points[k], self.points[next]);
        let slopes = [self.slopes[k], self.slopes[next]];
        value_and_slope(x1 - x0, [y0, y1], slopes, value - x0).0
    }
}

/// The part of a table in which values and intensities rise, from 0 or more: the one with the largest rise, in words.
fn usable(points: &[[f64; 2]]) -> String {
    let rises = |a: &[f64; 2], b: &[f64; 2]| a[1] >= 0.0 && b[0] > a[0] && b[1] > a[1];
    let parts = points.chunk_by(rises).filter(|part| part.len() > 1);
    let ends = parts.map(|part| (part[0], part[part.len() - 1]));
    let most = ends.max_by(|(a, b), (c, d)| (b[1] - a[1]).total_cmp(&(d[1] - c[1])));
    match most {
        Some((low, high)) => format!(
            "it is usable from value {} to {}",
            exact(low[0]),
            exact(high[0])
        ),
        None => "no part of it is usable".to_owned(),
    }
}

/// Levels of a bit depth and their intensities.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tone {
    top: u16,
    /// Intensity of each level, the highest is 1; None: proportional to the level.
    table: Option<Vec<f64>>,
}

impl Tone {
    pub(super) fn new(curve: Option<&ToneCurve>, bits: u32) -> Self {
        let top = top_level(bits);
        let table = curve.map(|curve| {
            (0..=top)
                .map(|level| curve.at(f64::from(level) / f64::from(top)))
                .collect()
        });
        Tone { top, table }
    }

    /// Intensity of a level, 0 to 1.
    pub(super) fn intensity(&self, level: u16) -> f64 {
        match &self.table {
            None => f64::from(level) / f64::from(self.top),
            Some(table) => table[usize::from(level.min(self.top))],
        }
    }

    /// The level whose intensity is nearest, the upper one of two that are equally near.
    pub(super) fn level(&self, intensity: f64) -> u16 {
        let Some(table) = &self.table else {
            return ((intensity * f64::from(self.top) + 0.5).floor() as u16).min(self.top);
        };
        let above = table.partition_point(|&i| i < intensity);
        if above == 0 {
            return 0;
        }
        let nearest =
            if above == table.len() || intensity - table[above - 1] < table[above] - intensity {
                above - 1
            } else {
                above
            };
        nearest as u16
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::monotone_cubic::coefficients;

    #[test]
    fn a_curve_is_followed_and_its_nearest_levels_are_found() {
        let curve = ToneCurve::new(&[[0.0, 4.0], [0.5, 8.0], [1.0, 40.0]], "c").unwrap();
        let tone = Tone::new(Some(&curve), 8);
        assert_eq!((tone.intensity(0), tone.intensity(255)), (0.1, 1.0));
        // Secants 0.2 and 1.6 have the harmonic mean 16/45, and the first slope of −0.5 is brought to 0
        let cubic = coefficients(0.5, [0.1, 0.2], [0.0, 16.0 / 45.0]);
        let t = 100.0 / 255.0;
        let expected = cubic[0] + t * t * (cubic[2] + t * cubic[3]);
        assert!((tone.intensity(100) - expected).abs() < 1e-12);
        for level in 0..=255 {
            assert_eq!(tone.level(tone.intensity(level)), level);
        }
        for i in 0..1000 {
            let wanted = f64::from(i) / 999.0;
            let found = (tone.intensity(tone.level(wanted)) - wanted).abs();
            let best = (0..=255)
                .map(|l| (tone.intensity(l) - wanted).abs())
                .fold(1.0, f64::min);
            assert_eq!(found, best, "{wanted}");
        }
    }

    /// Of a projector with gamma 2.2, 11 points say nearly as much as 256; straight lines between them miss by 0.33 % of white.
    #[test]
    fn few_points_describe_a_smooth_curve() {
        let gamma = |value: f64| value.powf(2.2);
        let of = |last: u32| {
            let at = |i: u32| f64::from(i) / f64::from(last);
            let points: Vec<[f64; 2]> = (0..=last).map(|i| [at(i), gamma(at(i))]).collect();
            Tone::new(Some(&ToneCurve::new(&points, "c").unwrap()), 16)
        };
        for (last, most) in [(10, 7e-4), (255, 1e-6)] {
            let tone = of(last);
            let levels = (0..=u16::MAX).step_by(7);
            let off = levels
                .clone()
                .map(|l| (tone.intensity(l) - gamma(f64::from(l) / 65535.0)).abs());
            let off = off.fold(0.0, f64::max);
            assert!(off < most, "{last}: {off}");
            for level in levels {
                assert_eq!(tone.level(tone.intensity(level)), level);
            }
        }
    }

    #[test]
    fn without_a_curve_halves_are_rounded_up() {
        let tone = Tone::new(None, 2);
        assert_eq!([0.0, 0.4999, 0.5, 1.0].map(|i| tone.level(i)), [0, 1, 2, 3]);
    }

    #[test]
    fn what_is_no_curve_is_refused_with_the_place() {
        for (points, word) in [
            (&[[0.0, 0.0]][..], "1 points"),
            (
                &[[0.0, 0.0], [0.5, 0.6], [1.0, 0.5]],
                "between points 2 and 3: not monotone; it is usable from value 0 to 0.5",
            ),
            (
                &[[0.0, 0.0], [0.2, 0.1], [0.3, 0.05], [1.0, 1.0]],
                "usable from value 0.3 to 1",
            ),
            (
                &[[0.0, 0.0], [0.5, 0.5], [0.5, 0.6], [1.0, 1.0]],
                "the value goes from 0.5 to 0.5",
            ),
            (&[[0.0, 0.0], [0.9, 1.0]], "values from 0 to 0.9"),
            (
                &[[0.0, -0.1], [0.2, 0.0], [1.0, 1.0]],
                "an intensity of -0.1; it is usable from value 0.2 to 1",
            ),
            (
                &[[0.0, -0.1], [1.0, 1.0]],
                "an intensity of -0.1; no part of it is usable",
            ),
            (&[[0.0, 0.0], [1.0, f64::NAN]], "point 2"),
            (&[[0.0, 0.0], [1.0, 0.0]], "not monotone"),
        ] {
            let message = ToneCurve::new(points, "printer.gray_curve")
                .unwrap_err()
                .to_string();
            assert!(
                message.contains(word) && message.starts_with("printer.gray_curve"),
                "{message}"
            );
        }
    }
}
