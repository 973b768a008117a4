//! Lines, dots and bands as an SVG file.
//!
//! Sizes are in units of a 480 wide view box, so that labels stay readable on a telephone. Colors are CSS classes
//! (`s-…` for strokes, `f-…` for areas: part, void, accent, gel, still, window), those of a report on its card.
//!
//! ```
//! use tomolith_report::plot::{Axis, Plot};
//! let mut plot = Plot::new(Axis::linear("time, s", 0.0, 4.0), Axis::linear("dose", 0.0, 16.0));
//! plot.line(&[[0.0, 0.0], [2.0, 4.0], [4.0, 16.0]], "accent", "t²");
//! plot.dots(&[[1.0, 1.0], [3.0, 9.0]], "void", "measured");
//! let file = plot.file("a parabola");
//! assert!(file.starts_with("<svg xmlns="));
//! assert_eq!(file.matches("<circle").count(), 2);
//! ```

use super::number::{escape, exponent, significant};
use std::fmt::Write as _;

const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 290.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 14.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 46.0;
/// Share of a logarithmic axis that stands for 0, below its lowest decade.
const ZERO: f64 = 0.09;

/// One axis.
pub struct Axis {
    pub(crate) label: String,
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) log: bool,
    /// Whether 0 has a place below the decades.
    pub(crate) zero: bool,
}

impl Axis {
    /// Evenly divided; a high end that is not above the low one is one more.
    #[must_use]
    pub fn linear(label: &str, low: f64, high: f64) -> Self {
        let high = if high > low { high } else { low + 1.0 };
        Axis {
            label: label.to_owned(),
            low,
            high,
            log: false,
            zero: false,
        }
    }

    /// Whole decades around the values.
    #[must_use]
    pub fn log(label: &str, low: f64, high: f64) -> Self {
        let low = low.max(f64::MIN_POSITIVE).log10().floor();
        let high = high.max(f64::MIN_POSITIVE).log10().ceil().max(low + 1.0);
        Axis {
            label: label.to_owned(),
            low: 10f64.powf(low),
            high: 10f64.powf(high),
            log: true,
            zero: false,
        }
    }

    /// Decades, and 0 below them, which has no logarithm.
    pub(crate) fn log_with_zero(label: &str, low: f64, high: f64) -> Self {
        Axis {
            zero: true,
            ..Axis::log(label, low, high)
        }
    }

    /// 0 at the low end, 1 at the high end.
    pub(super) fn place(&self, value: f64) -> f64 {
        let place = if self.zero && value <= 0.0 {
            0.0
        } else if self.log {
            let decades =
                (value.max(f64::MIN_POSITIVE) / self.low).log10() / (self.high / self.low).log10();
            if self.zero {
                // What is off the decades is still not 0
                ZERO + (1.0 - ZERO) * decades.max(0.0)
            } else {
                decades
            }
        } else {
            (value - self.low) / (self.high - self.low)
        };
        place.clamp(-0.02, 1.02)
    }

    /// Values and labels of the ticks.
    pub(super) fn ticks(&self, wanted: usize) -> Vec<(f64, String)> {
        if self.log {
            let (low, high) = (
                self.low.log10().round() as i32,
                self.high.log10().round() as i32,
            );
            let step = ((high - low) as usize).div_ceil(wanted).max(1);
            let zero = self.zero.then(|| (0.0, "0".to_owned()));
            let decades = (low..=high).step_by(step);
            return zero
                .into_iter()
                .chain(decades.map(|power| {
                    let label = match power {
                        0 => "1".to_owned(),
                        1 => "10".to_owned(),
                        power => exponent(power),
                    };
                    (10f64.powi(power), label)
                }))
                .collect();
        }
        let step = nice_step((self.high - self.low) / wanted as f64);
        let first = (self.low / step - 1e-9).ceil() as i64;
        let last = (self.high / step + 1e-9).floor() as i64;
        // All ticks with as many decimals as the step needs
        let decimals = (-step.log10().floor()).max(0.0) as usize;
        (first..=last)
            .map(|i| {
                let value = i as f64 * step;
                let plain = step >= 1e-4 && value.abs() < 1e5;
                let label = if plain {
                    format!("{value:.decimals$}").replace('-', "−")
                } else {
                    significant(value, 3)
                };
                (value, label)
            })
            .collect()
    }
}

/// A path through points; one that is not there parts it.
pub(crate) fn polyline(points: impl Iterator<Item = Option<[f64; 2]>>) -> String {
    let (mut path, mut letter) = (String::new(), 'M');
    for point in points {
        if let Some([x, y]) = point {
            // Writing into a string cannot fail
            let _ = write!(path, "{letter}{x:.1} {y:.1}");
        }
        letter = if point.is_some() { 'L' } else { 'M' };
    }
    path
}

/// 1, 2 or 5 times a power of ten, not smaller than `step`.
fn nice_step(step: f64) -> f64 {
    let power = 10f64.powf(step.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|m| m * power)
        .find(|s| *s >= step * (1.0 - 1e-9))
        .unwrap_or(power * 10.0)
}

/// What is drawn.
pub struct Plot {
    x: Axis,
    y: Axis,
    body: String,
    legend: Vec<(String, String)>,
}

impl Plot {
    /// An empty plot.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Self {
        Plot {
            x,
            y,
            body: String::new(),
            legend: Vec::new(),
        }
    }

    fn px(&self, x: f64) -> f64 {
        LEFT + self.x.place(x) * (WIDTH - LEFT - RIGHT)
    }

    fn py(&self, y: f64) -> f64 {
        HEIGHT - BOTTOM - self.y.place(y) * (HEIGHT - TOP - BOTTOM)
    }

    fn add(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing into a string cannot fail
        let _ = self.body.write_fmt(element);
    }

    /// A shaded range of x.
    pub fn band(&mut self, from: f64, to: f64, class: &str, name: &str) {
        let (a, b) = (self.px(from), self.px(to));
        let (top, height) = (TOP, HEIGHT - TOP - BOTTOM);
        self.add(format_args!(
            "<rect class=\"f-{class}\" x=\"{a:.1}\" y=\"{top}\" width=\"{:.1}\" height=\"{height}\"/>",
            (b - a).max(1.0)
        ));
        self.legend.push((class.to_owned(), name.to_owned()));
    }

    /// An upright line.
    pub fn line_at(&mut self, x: f64, class: &str, name: &str) {
        let (x, bottom) = (self.px(x), HEIGHT - BOTTOM);
        self.add(format_args!(
            "<path class=\"s-{class}\" d=\"M{x:.1} {TOP}V{bottom}\"/>"
        ));
        self.legend.push((class.to_owned(), name.to_owned()));
    }

    /// Points joined by a line.
    pub fn line(&mut self, points: &[[f64; 2]], class: &str, name: &str) {
        let path = polyline(points.iter().map(|&[x, y]| Some([self.px(x), self.py(y)])));
        self.add(format_args!("<path class=\"s-{class}\" d=\"{path}\"/>"));
        if !name.is_empty() {
            self.legend.push((class.to_owned(), name.to_owned()));
        }
    }

    fn dot(&mut self, point: [f64; 2], class: &str) {
        let (x, y) = (self.px(point[0]), self.py(point[1]));
        self.add(format_args!(
            "<circle class=\"f-{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>"
        ));
    }

    /// Measured points.
    pub fn dots(&mut self, points: &[[f64; 2]], class: &str, name: &str) {
        points.iter().for_each(|point| self.dot(*point, class));
        self.legend.push((class.to_owned(), name.to_owned()));
    }

    /// The finished drawing; `title` is read by screen readers.
    #[must_use]
    pub fn file(&self, title: &str) -> String {
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        let mut grid = String::new();
        for (value, label) in self.y.ticks(5) {
            let y = self.py(value);
            let _ = write!(
                grid,
                "<path class=\"grid\" d=\"M{LEFT} {y:.1}H{right}\"/><text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
                LEFT - 7.0,
                y + 4.0
            );
        }
        for (value, label) in self.x.ticks(6) {
            let x = self.px(value);
            let _ = write!(
                grid,
                "<path class=\"tick\" d=\"M{x:.1} {bottom}v5\"/><text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
                bottom + 18.0
            );
        }
        // Without names nothing stands above the plot
        let above = if self.legend.is_empty() { 22.0 } else { 0.0 };
        let middle = f64::midpoint(LEFT, right);
        let upright = f64::midpoint(TOP, bottom);
        let style = include_str!("plot.css");
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"{}\" height=\"{}\" viewBox=\"0 {above} {WIDTH} {}\" \
             role=\"img\" aria-label=\"{}\"><style><![CDATA[{style}]]></style>\
             <rect x=\"0\" y=\"{above}\" width=\"100%\" height=\"100%\" fill=\"#fff\"/>{grid}\
             <path class=\"axis\" d=\"M{LEFT} {TOP}V{bottom}H{right}\"/>{}{}\
             <text class=\"label\" x=\"{middle}\" y=\"{}\" text-anchor=\"middle\">{}</text>\
             <text class=\"label\" transform=\"translate(14 {upright}) rotate(-90)\" text-anchor=\"middle\">{}</text></svg>\n",
            2.0 * WIDTH,
            2.0 * (HEIGHT - above),
            HEIGHT - above,
            escape(title),
            self.body,
            self.legend(),
            HEIGHT - 8.0,
            escape(&self.x.label),
            escape(&self.y.label),
        )
    }

    /// One line above the plot.
    fn legend(&self) -> String {
        let mut out = String::new();
        let mut x = LEFT;
        for (class, name) in &self.legend {
            let _ = write!(
                out,
                "<rect class=\"key f-{class} s-{class}\" x=\"{x:.1}\" y=\"9\" width=\"12\" height=\"12\" rx=\"2\"/>\
                 <text class=\"key-name\" x=\"{:.1}\" y=\"19\">{}</text>",
                x + 17.0,
                escape(name)
            );
            x += 17.0 + width_of(name) + 14.0;
        }
        out
    }
}

/// About the width of a text of the legend.
fn width_of(text: &str) -> f64 {
    let of_letter = |letter: char| match letter {
        'f' | 'i' | 'j' | 'l' | 'r' | 't' | 'I' | ' ' | '.' | ',' => 4.4,
        'm' | 'w' | 'M' | 'W' => 10.2,
        _ => 7.0,
    };
    text.chars().map(of_letter).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_numbers_with_equal_decimals() {
        let labels = |axis: Axis| axis.ticks(5).into_iter().map(|t| t.1).collect::<Vec<_>>();
        assert_eq!(
            labels(Axis::linear("", 0.0, 1.0)),
            ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]
        );
        assert_eq!(labels(Axis::linear("", -0.3, 0.31)), ["−0.2", "0.0", "0.2"]);
        assert_eq!(
            labels(Axis::linear("", 0.0, 240.0)),
            ["0", "50", "100", "150", "200"]
        );
        assert_eq!(
            labels(Axis::log("", 0.5, 3000.0)),
            ["10⁻¹", "1", "10", "10²", "10³", "10⁴"]
        );
        assert_eq!(labels(Axis::log("", 1e-9, 1.0)).len(), 5);
    }

    #[test]
    fn zero_has_a_place_of_its_own_below_the_decades() {
        let axis = Axis::log_with_zero("", 1.0, 1000.0);
        let labels: Vec<String> = axis.ticks(5).into_iter().map(|t| t.1).collect();
        assert_eq!(labels, ["0", "1", "10", "10²", "10³"]);
        assert_eq!(
            [0.0, 1.0, 1000.0, 1e-9].map(|v| axis.place(v)),
            [0.0, ZERO, 1.0, ZERO]
        );
    }

    #[test]
    fn values_land_where_they_should() {
        let mut plot = Plot::new(Axis::linear("x", 0.0, 2.0), Axis::log("y", 1.0, 100.0));
        plot.line(&[[0.0, 1.0], [1.0, 10.0], [2.0, 100.0]], "a", "a < b");
        let svg = plot.file("t");
        let (mid_x, mid_y) = (
            f64::midpoint(LEFT, WIDTH - RIGHT),
            f64::midpoint(TOP, HEIGHT - BOTTOM),
        );
        let expected = format!(
            "d=\"M{LEFT:.1} {:.1}L{mid_x:.1} {mid_y:.1}L{:.1} {TOP:.1}\"",
            HEIGHT - BOTTOM,
            WIDTH - RIGHT
        );
        assert!(svg.contains(&expected), "{svg}");
        assert!(svg.contains("a &lt; b"));
    }

    #[test]
    fn a_file_names_its_colors() {
        let mut plot = Plot::new(Axis::linear("x", 0.0, 2.0), Axis::linear("y", 0.0, 1.0));
        plot.line(&[[0.0, 0.0], [2.0, 1.0]], "part", "a");
        let file = plot.file("t");
        assert!(file.contains(".s-part { stroke: #0f8b8d; }"), "{file}");
        assert!(!file.contains("var(") && !file.contains("@media"), "{file}");
    }

    #[test]
    fn flat_and_empty_data_make_a_plot_without_nan() {
        let mut plot = Plot::new(Axis::linear("x", 3.0, 3.0), Axis::log("y", 0.0, 0.0));
        plot.line(&[], "a", "");
        plot.line(&[[3.0, 0.0]], "a", "");
        let svg = plot.file("t");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}
