//! Loss against seconds, one panel a target, both axes logarithmic, as an SVG for light and dark pages.

use std::fmt::Write as _;

/// A method's way.
pub(crate) struct Curve {
    pub(crate) name: String,
    pub(crate) points: Vec<[f64; 2]>,
}

/// One target.
pub(crate) struct Panel {
    pub(crate) title: String,
    pub(crate) curves: Vec<Curve>,
}

const WIDTH: f64 = 300.0;
const HEIGHT: f64 = 220.0;
const LEFT: f64 = 46.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 24.0;
const BOTTOM: f64 = 36.0;
/// Losses below are drawn here: what is left is rounding.
const FLOOR: f64 = 1e-5;
/// Panels beside each other.
const ACROSS: usize = 3;
/// Curves that are drawn, with color and dashes; the others would hide them.
const DRAWN: [(&str, &str, &str); 8] = [
    ("lbfgs", "#d62728", ""),
    ("gradient, automatic", "#1f77b4", ""),
    ("fista", "#2ca02c", ""),
    ("adam", "#9467bd", ""),
    ("gradient, 1/L, momentum 0.9", "#1f77b4", "5 3"),
    ("bclp, alternate", "#8c564b", "5 3"),
    ("osmo", "#ff7f0e", "5 3"),
    ("cal", "#7f7f7f", "5 3"),
];

/// All panels, and one legend below them.
pub(crate) fn picture(panels: &[Panel]) -> String {
    let rows = panels.len().div_ceil(ACROSS);
    let (width, foot) = (WIDTH * ACROSS as f64, 44.0);
    let height = HEIGHT * rows as f64 + foot;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"11\">\
         <title>Loss against processor seconds of every optimizer on each target</title>\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
    );
    for (i, panel) in panels.iter().enumerate() {
        let (x, y) = ((i % ACROSS) as f64 * WIDTH, (i / ACROSS) as f64 * HEIGHT);
        let _ = writeln!(
            out,
            "<g transform=\"translate({x} {y})\">{}</g>",
            draw(panel)
        );
    }
    for (i, (name, color, dashes)) in DRAWN.iter().enumerate() {
        let x = LEFT + (i % 4) as f64 * 215.0;
        let y = HEIGHT * rows as f64 + 12.0 + 18.0 * (i / 4) as f64;
        let _ = writeln!(
            out,
            "<path d=\"M{x} {y}h24\" stroke=\"{color}\" stroke-width=\"2\" stroke-dasharray=\"{dashes}\"/>\
             <text x=\"{}\" y=\"{}\">{name}</text>",
            x + 30.0,
            y + 4.0
        );
    }
    out.push_str("</svg>\n");
    out
}

/// Logarithms of the smallest and the largest value.
fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values
        .filter(|v| *v > 0.0)
        .map(f64::log10)
        .fold([f64::MAX, f64::MIN], |[low, high], v| {
            [low.min(v), high.max(v)]
        })
}

fn draw(panel: &Panel) -> String {
    let curves: Vec<_> = DRAWN
        .iter()
        .filter_map(|drawn| Some((drawn, panel.curves.iter().find(|c| c.name == drawn.0)?)))
        .collect();
    let points = || curves.iter().flat_map(|(_, curve)| &curve.points);
    let x = span(points().map(|p| p[0]));
    let y = span(points().map(|p| p[1].max(FLOOR)));
    let y = [y[0].floor(), y[1].ceil()];
    let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
    let px = |v: f64| LEFT + (v.log10() - x[0]) / (x[1] - x[0]).max(1e-9) * (right - LEFT);
    let py = |v: f64| bottom - (v.log10() - y[0]) / (y[1] - y[0]).max(1e-9) * (bottom - TOP);
    let mut out = format!(
        "<text x=\"{LEFT}\" y=\"15\" font-weight=\"bold\">{}</text>\
         <path d=\"M{LEFT} {TOP}V{bottom}H{right}\" fill=\"none\" stroke=\"#444\"/>\
         <text x=\"{}\" y=\"{}\" text-anchor=\"middle\">processor seconds</text>\
         <text transform=\"translate(12 {}) rotate(-90)\" text-anchor=\"middle\">loss</text>",
        panel.title,
        f64::midpoint(LEFT, right),
        HEIGHT - 6.0,
        f64::midpoint(TOP, bottom),
    );
    for (value, label) in ticks(x, &[1.0, 3.0]) {
        let at = px(value);
        let _ = write!(
            out,
            "<path d=\"M{at:.1} {bottom}v4\" stroke=\"#444\"/><text x=\"{at:.1}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
            bottom + 16.0
        );
    }
    for (value, label) in ticks(y, &[1.0]) {
        let at = py(value);
        let _ = write!(
            out,
            "<path d=\"M{LEFT} {at:.1}H{right}\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
            LEFT - 5.0,
            at + 4.0
        );
    }
    for ((_, color, dashes), curve) in &curves {
        let path: Vec<String> = curve
            .points
            .iter()
            .map(|p| format!("{:.1} {:.1}", px(p[0]), py(p[1].max(FLOOR))))
            .collect();
        let _ = write!(
            out,
            "<path d=\"M{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"1.6\" stroke-dasharray=\"{dashes}\"/>",
            path.join("L")
        );
    }
    out
}

/// Powers of ten times `steps` between the ends.
fn ticks([low, high]: [f64; 2], steps: &[f64]) -> Vec<(f64, String)> {
    let mut ticks = Vec::new();
    for power in low.floor() as i32..=high.ceil() as i32 {
        for step in steps {
            let value = step * 10f64.powi(power);
            if (low - 1e-9..=high + 1e-9).contains(&value.log10()) {
                let decimals = usize::try_from(-power).unwrap_or(0);
                ticks.push((value, format!("{value:.decimals$}")));
            }
        }
    }
    ticks
}
