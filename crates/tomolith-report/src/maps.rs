//! Numbers of many runs as pictures: heat maps over two axes, curves and dots over one, each a whole SVG file.
//!
//! Several panels share one scale of values. A heat map has equal cells, labeled by their values; the feasible region is outlined, the
//! best cell ringed, guide lines dashed, and a run that failed is a gray cell with a cross. Colors are viridis; they are logarithmic where positive values span more
//! than three decades, with 0 at the lowest color, and the picture says so. The paper is white: the files are for articles, too.
//!
//! ```
//! use tomolith_report::maps::{Cell, Panel, MapAxis, heat_maps};
//! let axis = |name: &str| MapAxis { name: name.to_owned(), labels: vec!["0.1".to_owned(), "0.2".to_owned()] };
//! let cell = |value| Some(Cell { value: Some(value), is_feasible: value > 1.5, is_best: value == 3.0, has_failed: false });
//! let panel = Panel { title: String::new(), cells: vec![cell(1.0), cell(2.0), None, cell(3.0)] };
//! let svg = heat_maps("PW", [&axis("lower"), &axis("upper")], &[panel], &[], "");
//! assert_eq!(svg.matches("class=\"cell\"").count(), 3);
//! assert_eq!(svg.matches("class=\"best\"").count(), 1);
//! ```

use super::number::significant;
use super::picture::{hex, viridis};
use super::plot::{Axis, polyline};
use std::collections::BTreeSet;

pub mod histograms;
pub mod profiles;
mod sheet;

use sheet::{Frame, GLYPH, LabelMargins, Sheet, Ticks, draw, panel_size, shortened};

/// Height of a curve, of its width.
const FLAT: f64 = 0.66;
/// Room for the color bar.
const BAR: f64 = 110.0;
/// Labels along an axis, at most; a cell that wide holds its value.
const LABELS: usize = 11;
const WRITTEN: f64 = 44.0;
/// Width of a name that stands upright.
const LINE: f64 = 14.0;
/// Values that span more than this have logarithmic colors.
const DECADES: f64 = 1e3;

/// One axis of a heat map: its name, and the values of its cells.
#[derive(Clone, Debug)]
pub struct MapAxis {
    /// What it is.
    pub name: String,
    /// The values, from left to right or from below.
    pub labels: Vec<String>,
}

/// A run in a heat map.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Its number; none where it is not defined.
    pub value: Option<f64>,
    /// Whether the run meets the conditions of `best.where`.
    pub is_feasible: bool,
    /// Whether no other is better.
    pub is_best: bool,
    /// Whether it could not be run.
    pub has_failed: bool,
}

/// One heat map.
#[derive(Clone, Debug)]
pub struct Panel {
    /// What tells it from the others.
    pub title: String,
    /// `[y][x]`, y upwards; none where there is no run.
    pub cells: Vec<Option<Cell>>,
}

/// A line drawn over every map.
#[derive(Clone, Debug)]
pub struct Guide {
    /// What it is, for the line of the marks.
    pub name: String,
    /// Its points, along x and y: 0 in the middle of the first cell, 1 in that of the second.
    pub points: Vec<[f64; 2]>,
}

/// Values along a curve.
#[derive(Clone, Debug)]
pub struct PlotCurve {
    /// What the values stand over.
    pub name: String,
    /// Labels of the places 0, 1, 2, … where these are no numbers.
    pub labels: Option<Vec<String>>,
    /// Whether equal ratios are equally far apart.
    pub is_log: bool,
    /// Whether neighbors are joined.
    pub is_joined: bool,
    /// Place, and what is there.
    pub points: Vec<(f64, Cell)>,
}

/// How values become colors or heights.
struct ColorScale {
    low: f64,
    high: f64,
    is_log: bool,
}

impl ColorScale {
    fn of(values: impl Iterator<Item = f64> + Clone) -> Self {
        let finite = values.filter(|v| v.is_finite());
        let low = finite.clone().reduce(f64::min).unwrap_or(0.0);
        let high = finite.clone().reduce(f64::max).unwrap_or(1.0);
        let least = finite.filter(|v| *v > 0.0).reduce(f64::min).unwrap_or(high);
        let is_log = low >= 0.0 && high > DECADES * least;
        let low = if is_log { least } else { low };
        // All equal: one color in the middle of the map
        let room = if high > low {
            0.0
        } else {
            0.5 * high.abs().max(1e-12)
        };
        ColorScale {
            low: low - room,
            high: high + room,
            is_log,
        }
    }

    /// 0 at the lowest, 1 at the highest.
    fn place(&self, value: f64) -> f64 {
        let part = if self.is_log {
            (value.max(self.low) / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        };
        part.clamp(0.0, 1.0)
    }

    /// Values and labels along the scale.
    fn ticks(&self) -> Vec<(f64, String)> {
        if self.is_log {
            let inside = |(value, _): &(f64, String)| (self.low..=self.high).contains(value);
            return Axis::log("", self.low, self.high)
                .ticks(6)
                .into_iter()
                .filter(inside)
                .collect();
        }
        Axis::linear("", self.low, self.high).ticks(5)
    }
}

/// Heat maps side by side, as one SVG file; `caption` stands below them.
#[must_use]
pub fn heat_maps(
    title: &str,
    [x, y]: [&MapAxis; 2],
    panels: &[Panel],
    guides: &[Guide],
    caption: &str,
) -> String {
    let cells = || panels.iter().flat_map(|p| p.cells.iter().flatten());
    let values = ColorScale::of(cells().filter_map(|cell| cell.value));
    let most = longest_name(panels.len());
    let [width, _] = panel_size(panels.len());
    let left = match are_words(&y.labels) {
        true => longest(&all_shortened(&y.labels, most)),
        false => 0,
    };
    let below = match are_words(&x.labels) {
        true => upright_letters(&x.labels, width, most),
        false => 0,
    };
    let margins = LabelMargins::new(left, below);
    let mut sheet = Sheet::new(panels.len(), 1.0, BAR, margins);
    let title = if values.is_log {
        format!("{title} (logarithmic colors)")
    } else {
        title.to_owned()
    };
    let mut left_out = 0;
    let has_both = cells().any(|c| !c.is_feasible);
    for (i, panel) in panels.iter().enumerate() {
        let frame = sheet.frame(i);
        map(&mut sheet.body, &frame, [x, y], most, panel, &values);
        if has_both {
            draw_outline(&mut sheet.body, &frame, [x, y], panel);
        }
        rings(&mut sheet.body, &frame, [x, y], panel);
        let sizes = [x, y].map(|scale| scale.labels.len());
        draw_guides(&mut sheet.body, &frame, sizes, guides);
        // Above the guides, which must not cover them
        left_out += numbers(&mut sheet.body, &frame, sizes, panel, &values);
    }
    let written = cells().filter(|cell| cell.value.is_some()).count() - left_out;
    let room = match (written, left_out) {
        (_, 0) => "",
        (0, _) => " The cells are too small for numbers.",
        _ => " Numbers stand where cells have room for them.",
    };
    sheet.head(&title, format!("{caption}{room}").trim());
    sheet.bar(&values);
    let outlined = mark(cells(), |c| c.is_feasible, "outlined: feasible");
    let mut marks = vec![outlined.filter(|_| has_both)];
    marks.extend(common_marks(cells));
    let strokes = guides.iter().zip(STROKES.iter().cycle());
    marks.extend(strokes.map(|(guide, (stroke, _))| Some(format!("{stroke}: {}", guide.name))));
    sheet.svg(&title, &marks)
}

/// What a mark means, where a cell has it.
fn mark<'c>(
    mut cells: impl Iterator<Item = &'c Cell>,
    has_it: fn(&Cell) -> bool,
    meaning: &str,
) -> Option<String> {
    cells.any(has_it).then(|| meaning.to_owned())
}

fn common_marks<'c, I: Iterator<Item = &'c Cell>>(cells: impl Fn() -> I) -> [Option<String>; 2] {
    [
        mark(cells(), |c| c.is_best, "ring: best"),
        mark(cells(), |c| c.has_failed, "×: failed"),
    ]
}

/// How guides differ: in words, and as SVG has it.
const STROKES: [(&str, &str); 6] = [
    ("dashed", "7 5"),
    ("dotted", "1.5 4"),
    ("dash-dotted", "9 4 1.5 4"),
    ("long dashes", "16 6"),
    ("dash and two dots", "9 4 1.5 4 1.5 4"),
    ("full", "1 0"),
];

/// Guides within the frame of a map of so many columns and rows.
fn draw_guides(body: &mut String, frame: &Frame, [columns, rows]: [usize; 2], guides: &[Guide]) {
    let part = |place: f64, cells: usize| (place + 0.5) / cells.max(1) as f64;
    for (guide, (_, dashes)) in guides.iter().zip(STROKES.iter().cycle()) {
        let path = polyline(guide.points.iter().map(|&[x, y]| {
            let (x, y) = (part(x, columns), part(y, rows));
            let is_inside = (0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y);
            is_inside.then(|| [frame.x(x), frame.y(y)])
        }));
        draw!(
            body,
            "<path class=\"under\" d=\"{path}\"/><path class=\"guide\" stroke-dasharray=\"{dashes}\" d=\"{path}\"/>"
        );
    }
}

/// Curves or dots side by side over one scale of values, as one SVG file; `caption` stands below them.
#[must_use]
pub fn curves(title: &str, curves: &[PlotCurve], caption: &str) -> String {
    let points = || {
        curves
            .iter()
            .flat_map(|c| c.points.iter().map(|(_, cell)| cell))
    };
    let values = ColorScale::of(points().filter_map(|cell| cell.value));
    let (is_log, room) = (values.is_log, 0.05 * (values.high - values.low));
    let values = Axis {
        zero: is_log && points().any(|cell| cell.value == Some(0.0)),
        ..if is_log {
            Axis::log("", values.low, values.high)
        } else {
            Axis::linear("", values.low - room, values.high + room)
        }
    };
    let most = longest_name(curves.len());
    let [width, _] = panel_size(curves.len());
    let names = curves.iter().filter_map(|curve| curve.labels.as_ref());
    let below = names.map(|names| upright_letters(names, width, most)).max();
    let mut sheet = Sheet::new(
        curves.len(),
        FLAT,
        20.0,
        LabelMargins::new(0, below.unwrap_or(0)),
    );
    sheet.head(title, caption);
    for (i, curve) in curves.iter().enumerate() {
        let frame = sheet.frame(i);
        draw_curve(&mut sheet.body, &frame, curve, most, &values);
    }
    let hollow = mark(points(), |c| !c.is_feasible, "hollow: not feasible");
    let [best, failed] = common_marks(points);
    sheet.svg(title, &[hollow, best, failed])
}

/// Parts of an edge in the middle of equal cells, and their labels: so many that they do not touch.
fn middles(labels: &[String], most: usize) -> Vec<(f64, String)> {
    let step = labels.len().div_ceil(most.max(1)).max(1);
    let middle =
        |(i, label): (usize, &String)| ((i as f64 + 0.5) / labels.len() as f64, label.clone());
    labels
        .iter()
        .enumerate()
        .step_by(step)
        .map(middle)
        .collect()
}

/// How many labels of so many letters fit along an edge.
fn fitting(labels: &[String], width: f64) -> usize {
    ((width / (GLYPH * longest(labels) as f64 + 10.0)) as usize).clamp(1, LABELS)
}

fn map(
    body: &mut String,
    frame: &Frame,
    [x, y]: [&MapAxis; 2],
    most: usize,
    panel: &Panel,
    values: &ColorScale,
) {
    let cells = MapCells::new(frame, [x, y]);
    for (i, cell) in panel.cells.iter().enumerate() {
        let (Some(cell), [left, top]) = (cell, cells.corner(i)) else {
            continue;
        };
        let [width, height] = cells.size;
        draw_cell(body, [left, top, width, height], cell, values);
    }
    frame.title(body, &panel.title);
    let up = match are_words(&y.labels) {
        true => y.labels.len(),
        false => ((frame.height / 16.0) as usize).min(LABELS),
    };
    let across = match are_words(&x.labels) {
        true => name_ticks(&x.labels, frame.width, most),
        false => Ticks::level(middles(&x.labels, fitting(&x.labels, frame.width))),
    };
    let left = middles(&all_shortened(&y.labels, most), up);
    frame.axes(body, [&x.name, &y.name], &across, &left);
}

/// Whether labels are names, of which none may be left out, and not numbers along a scale.
fn are_words(labels: &[String]) -> bool {
    let is_number =
        |label: &String| label.starts_with(|c: char| c.is_ascii_digit() || "-−.".contains(c));
    !labels.iter().all(is_number)
}

/// Letters of a name along an axis, at most, in a picture of so many panels.
fn longest_name(panels: usize) -> usize {
    if panels == 1 { 32 } else { 18 }
}

fn longest(labels: &[String]) -> usize {
    labels.iter().map(|l| l.chars().count()).max().unwrap_or(1)
}

/// Letters of the longest of the names that stand upright below a panel; 0 where labels lie side by side.
fn upright_letters(labels: &[String], width: f64, most: usize) -> usize {
    let letters = longest(&all_shortened(labels, most));
    let fit = labels.len() as f64 * (GLYPH * letters as f64 + 10.0) <= width;
    if fit { 0 } else { letters }
}

/// Names below a panel so wide, upright where they do not fit side by side: as many as have room, cut to so many letters.
fn name_ticks(labels: &[String], width: f64, most: usize) -> Ticks {
    let are_upright = upright_letters(labels, width, most) > 0;
    let count = match are_upright {
        true => (width / LINE) as usize,
        false => labels.len(),
    };
    Ticks {
        labels: middles(&all_shortened(labels, most), count),
        are_upright,
    }
}

/// Labels cut to so many letters, or as many more as tell them apart.
fn all_shortened(labels: &[String], most: usize) -> Vec<String> {
    let cut = |most: usize| labels.iter().map(move |label| shortened(label, most));
    let count = labels.iter().collect::<BTreeSet<_>>().len();
    let differ = |most: &usize| cut(*most).collect::<BTreeSet<_>>().len() == count;
    let most = (most..longest(labels)).find(differ);
    cut(most.unwrap_or(usize::MAX)).collect()
}

/// A colored cell; a gray one with a cross where there is no value.
fn draw_cell(
    body: &mut String,
    [left, top, width, height]: [f64; 4],
    cell: &Cell,
    values: &ColorScale,
) {
    let shape =
        format!("x=\"{left:.2}\" y=\"{top:.2}\" width=\"{width:.2}\" height=\"{height:.2}\"");
    let Some(value) = cell.value else {
        draw!(body, "<rect class=\"failed\" {shape}/>");
        if cell.has_failed {
            let (r, cx, cy) = (
                0.18 * width.min(height),
                left + 0.5 * width,
                top + 0.5 * height,
            );
            draw!(
                body,
                "<path class=\"cross\" d=\"M{:.1} {:.1}l{:.1} {:.1}m0 {:.1}l{:.1} {:.1}\"/>",
                cx - r,
                cy - r,
                2.0 * r,
                2.0 * r,
                -2.0 * r,
                -2.0 * r,
                2.0 * r
            );
        }
        return;
    };
    let color = viridis(values.place(value));
    draw!(
        body,
        "<rect class=\"cell\" fill=\"{}\" stroke=\"{0}\" stroke-width=\".4\" {shape}/>",
        hex(color)
    );
}

/// Writes the numbers of cells, with three digits or where these have no room with two, each on its color, which hides guides behind it; how many
/// have no room.
fn numbers(
    body: &mut String,
    frame: &Frame,
    [columns, rows]: [usize; 2],
    panel: &Panel,
    values: &ColorScale,
) -> usize {
    let [width, height] = [
        frame.width / columns.max(1) as f64,
        frame.height / rows.max(1) as f64,
    ];
    let mut left_out = 0;
    for (i, cell) in panel.cells.iter().enumerate() {
        let Some(value) = cell.and_then(|cell| cell.value) else {
            continue;
        };
        let wide = |text: &String| width >= WRITTEN.max(GLYPH * text.chars().count() as f64);
        // An IoU of nearly 1 is not 1
        let digits = match value < 1.0 && significant(value, 3) == "1" {
            true => [4, 3],
            false => [3, 2],
        };
        let texts = digits.map(|digits| significant(value, digits));
        let Some(text) = texts.into_iter().find(wide).filter(|_| height >= 18.0) else {
            left_out += 1;
            continue;
        };
        let color = viridis(values.place(value));
        let light: u32 = color[..3]
            .iter()
            .zip([3, 6, 1])
            .map(|(&c, w)| u32::from(c) * w)
            .sum();
        let ink = if light > 1250 { "#16202b" } else { "#ffffff" };
        let middle = frame.left + ((i % columns) as f64 + 0.5) * width;
        let line = frame.top + ((rows - 1 - i / columns) as f64 + 0.5) * height;
        let half = 0.5 * GLYPH * text.chars().count() as f64;
        draw!(
            body,
            "<rect class=\"plate\" fill=\"{}\" x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"13\"/>\
                 <text class=\"small\" style=\"fill:{ink}\" x=\"{middle:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{text}</text>",
            hex(color),
            middle - half,
            line - 6.5,
            2.0 * half,
            line + 4.0
        );
    }
    left_out
}

/// Where the equal cells of a heat map lie.
struct MapCells {
    /// Columns and rows.
    counts: [usize; 2],
    /// Width and height of a cell.
    size: [f64; 2],
    /// The left upper corner of all.
    origin: [f64; 2],
}

impl MapCells {
    fn new(frame: &Frame, scales: [&MapAxis; 2]) -> Self {
        let counts = scales.map(|scale| scale.labels.len());
        let [columns, rows] = counts.map(|count| count.max(1) as f64);
        MapCells {
            counts,
            size: [frame.width / columns, frame.height / rows],
            origin: [frame.left, frame.top],
        }
    }

    /// The left upper corner of a cell.
    fn corner(&self, i: usize) -> [f64; 2] {
        let ([columns, rows], [width, height]) = (self.counts, self.size);
        [
            self.origin[0] + (i % columns) as f64 * width,
            self.origin[1] + (rows - 1 - i / columns) as f64 * height,
        ]
    }
}

/// The edges between feasible cells and all others.
fn draw_outline(body: &mut String, frame: &Frame, scales: [&MapAxis; 2], panel: &Panel) {
    let cells = MapCells::new(frame, scales);
    let ([columns, rows], [width, height]) = (cells.counts, cells.size);
    let is_feasible = |column: usize, row: usize| {
        let cell = (column < columns && row < rows)
            .then(|| panel.cells.get(row * columns + column))
            .flatten();
        cell.copied().flatten().is_some_and(|cell| cell.is_feasible)
    };
    let (down, across) = (format!("v{height:.1}"), format!("h{width:.1}"));
    let mut path = String::new();
    for i in (0..columns * rows).filter(|i| is_feasible(i % columns, i / columns)) {
        let ([left, top], column, row) = (cells.corner(i), i % columns, i / columns);
        let sides = [
            (column.wrapping_sub(1), row, [left, top], &down),
            (column + 1, row, [left + width, top], &down),
            (column, row + 1, [left, top], &across),
            (column, row.wrapping_sub(1), [left, top + height], &across),
        ];
        for (column, row, [x, y], side) in sides {
            if !is_feasible(column, row) {
                draw!(path, "M{x:.1} {y:.1}{side}");
            }
        }
    }
    draw!(
        body,
        "<path class=\"halo\" d=\"{path}\"/><path class=\"edge\" d=\"{path}\"/>"
    );
}

/// Rings round the best cells.
fn rings(body: &mut String, frame: &Frame, scales: [&MapAxis; 2], panel: &Panel) {
    let cells = MapCells::new(frame, scales);
    let [width, height] = cells.size;
    let all = panel.cells.iter().enumerate();
    for (i, _) in all.filter(|(_, cell)| cell.is_some_and(|cell| cell.is_best)) {
        let [left, top] = cells.corner(i);
        let (cx, cy, r) = (
            left + 0.5 * width,
            top + 0.5 * height,
            (0.42 * width.min(height)).clamp(4.0, 24.0),
        );
        draw!(
            body,
            "<circle class=\"best\" cx=\"{cx:.1}\" cy=\"{cy:.1}\" r=\"{r:.1}\"/><circle class=\"ring\" cx=\"{cx:.1}\" cy=\"{cy:.1}\" r=\"{r:.1}\"/>"
        );
    }
}

fn draw_curve(body: &mut String, frame: &Frame, curve: &PlotCurve, most: usize, values: &Axis) {
    let places = || curve.points.iter().map(|(place, _)| *place);
    let (low, high) = (
        places().fold(f64::INFINITY, f64::min),
        places().fold(f64::NEG_INFINITY, f64::max),
    );
    let across = match &curve.labels {
        Some(labels) => Axis::linear("", -0.5, labels.len() as f64 - 0.5),
        None if curve.is_log => Axis::log("", low, high),
        None => {
            let room = 0.04 * (high - low);
            Axis::linear("", low - room, high + room)
        }
    };
    let ticks = match &curve.labels {
        Some(labels) => name_ticks(labels, frame.width, most),
        None => Ticks::level(placed(&across, (frame.width / 60.0) as usize)),
    };
    let heights = placed(values, (frame.height / 45.0) as usize);
    for (part, _) in &heights {
        let at = frame.y(*part);
        draw!(
            body,
            "<path class=\"grid\" d=\"M{:.1} {at:.1}h{:.1}\"/>",
            frame.left,
            frame.width
        );
    }
    frame.axes(body, [&curve.name, ""], &ticks, &heights);
    let at = |(place, cell): &(f64, Cell)| {
        Some([
            frame.x(across.place(*place)),
            frame.y(values.place(cell.value?)),
        ])
    };
    if curve.is_joined {
        let path = polyline(curve.points.iter().map(at));
        draw!(body, "<path class=\"line\" d=\"{path}\"/>");
    }
    for point in &curve.points {
        let Some([x, y]) = at(point) else {
            if point.1.has_failed {
                let (x, y) = (frame.x(across.place(point.0)), frame.y(0.03));
                draw!(
                    body,
                    "<path class=\"cross\" d=\"M{:.1} {:.1}l8 8m0 -8l-8 8\"/>",
                    x - 4.0,
                    y - 4.0
                );
            }
            continue;
        };
        let class = if point.1.is_feasible { "dot" } else { "out" };
        draw!(
            body,
            "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.4\"/>"
        );
        if point.1.is_best {
            draw!(
                body,
                "<circle class=\"ring\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"8\"/>"
            );
        }
    }
}

/// Ticks as parts of an edge, two at least: a single one says nothing of the scale.
fn placed(axis: &Axis, wanted: usize) -> Vec<(f64, String)> {
    let part = |(value, label): (f64, String)| (axis.place(value), label);
    let finer = (wanted.max(2)..wanted + 5).map(|wanted| axis.ticks(wanted));
    let ticks = finer.into_iter().find(|ticks| ticks.len() > 1);
    ticks.into_iter().flatten().map(part).collect()
}

impl Sheet {
    fn bar(&mut self, values: &ColorScale) {
        let (last, first) = (self.frame(self.columns - 1), self.frame(0));
        let (left, steps) = (last.left + last.width + 24.0, 64);
        let step = first.height / f64::from(steps);
        for i in 0..steps {
            let color = hex(viridis((f64::from(i) + 0.5) / f64::from(steps)));
            let top = first.top + first.height - f64::from(i + 1) * step;
            draw!(
                self.body,
                "<rect fill=\"{color}\" x=\"{left:.1}\" y=\"{top:.2}\" width=\"16\" height=\"{:.2}\"/>",
                step + 0.3
            );
        }
        for (value, label) in values.ticks() {
            let y = first.y(values.place(value));
            draw!(
                self.body,
                "<path class=\"frame\" d=\"M{:.1} {y:.1}h4\"/><text class=\"small\" x=\"{:.1}\" y=\"{:.1}\">{label}</text>",
                left + 16.0,
                left + 24.0,
                y + 4.0
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scale(name: &str, count: usize) -> MapAxis {
        MapAxis {
            name: name.to_owned(),
            labels: (0..count).map(|i| i.to_string()).collect(),
        }
    }

    fn cell(value: Option<f64>, is_feasible: bool) -> Option<Cell> {
        Some(Cell {
            value,
            is_feasible,
            is_best: value == Some(4.0),
            has_failed: value.is_none(),
        })
    }

    fn panel(title: &str, cells: impl IntoIterator<Item = Option<Cell>>) -> Panel {
        Panel {
            title: title.to_owned(),
            cells: cells.into_iter().collect(),
        }
    }

    fn guide(name: &str, points: &[[f64; 2]]) -> Guide {
        Guide {
            name: name.to_owned(),
            points: points.to_vec(),
        }
    }

    /// A curve of values at 0, 1, 2, … over labels.
    fn curve(name: &str, labels: &[String], values: &[f64]) -> PlotCurve {
        let points = (values.iter().enumerate())
            .filter_map(|(i, value)| Some((i as f64, cell(Some(*value), true)?)));
        PlotCurve {
            name: name.to_owned(),
            labels: Some(labels.to_vec()),
            is_log: false,
            is_joined: false,
            points: points.collect(),
        }
    }

    #[test]
    fn names_of_others_are_text() {
        const NAME: &str = "\"'><img src=x>&";
        const TEXT: &str = "&quot;&#39;&gt;&lt;img src=x&gt;&amp;";
        let labels = [NAME.to_owned()];
        let scale = MapAxis {
            labels: labels.to_vec(),
            ..scale(NAME, 0)
        };
        let panel = panel(NAME, [cell(Some(4.0), true)]);
        let guide = guide(NAME, &[[0.0, 0.0]]);
        let map = heat_maps(NAME, [&scale, &scale], &[panel], &[guide], NAME);
        for page in [map, curves(NAME, &[curve(NAME, &labels, &[4.0])], NAME)] {
            assert!(!page.contains("<img") && !page.contains("\"'>"), "{page}");
            assert!(page.matches(TEXT).count() > 4, "{page}");
        }
    }

    #[test]
    fn names_too_long_for_the_axis_stand_upright_below_the_frame() {
        let named = |names: &[String]| {
            let values: Vec<f64> = (0..names.len()).map(|i| i as f64).collect();
            curves("m", &[curve("method", names, &values)], "")
        };
        let few = named(&["a", "b"].map(str::to_owned));
        assert!(few.contains(">a<") && !few.contains("text-anchor=\"end\">a<"));
        let names: Vec<String> = (0..12).map(|i| format!("gradient of step {i}")).collect();
        let many = named(&names);
        // The frame is as high as that of short names, and the names hang below it
        let bottom = 34.0 + 34.0 + 0.66 * 400.0;
        for name in &names {
            let place = many.split(&format!(" text-anchor=\"end\">{name}<")).next();
            let place = place.unwrap().rsplit("translate(").next().unwrap();
            let y = place.split([' ', ')']).nth(1).unwrap();
            assert!(y.parse::<f64>().unwrap() > bottom, "{name}: {place}");
        }
        let height = |svg: &str| {
            let height = svg.split("height=\"").nth(1)?.split('"').next()?;
            height.parse::<f64>().ok()
        };
        // 19 letters
        let more = height(&many).unwrap() - height(&few).unwrap();
        assert_eq!(more, 42.0 + 7.0 * 19.0 - 62.0);
    }

    #[test]
    fn the_feasible_region_is_outlined_by_its_outer_edges_alone() {
        // Feasible: the two cells on the right of 3 × 1
        let cells = [(1.0, false), (2.0, true), (4.0, true)].map(|(v, good)| cell(Some(v), good));
        let guides = [guide(
            "x < 2",
            &[[-1.0, 0.0], [0.0, 0.0], [2.0, 0.25], [3.0, 0.5]],
        )];
        let scales = [&scale("x", 3), &scale("y", 1)];
        let svg = heat_maps("m", scales, &[panel("a < b", cells)], &guides, "");
        // What is beyond the cells is left out of a guide: two of four points are left
        let path = |class: &str| {
            let element = svg.split(&format!("class=\"{class}\"")).nth(1)?;
            element.split(" d=\"").nth(1)?.split('"').next()
        };
        assert_eq!(path("guide").unwrap().matches(['M', 'L']).count(), 2);
        assert!(svg.contains("dashed: x &lt; 2"));
        // Left of the first, right of the last, two above and two below; none between them
        let edges = ['v', 'h'].map(|letter| path("edge").unwrap().matches(letter).count());
        assert_eq!(edges, [2, 4]);
        assert!(svg.contains("a &lt; b") && svg.contains("outlined: feasible · ring: best"));
    }

    #[test]
    fn numbers_stand_above_guides_and_those_without_room_are_told() {
        let guides = [guide("x = y", &[[0.0, 0.0], [1.0, 1.0]])];
        let map = |count: usize| {
            let cells = (0..count * count).map(|i| cell(Some(0.125 + i as f64), true));
            let scales = [&scale("x", count), &scale("y", count)];
            heat_maps("m", scales, &[panel("", cells)], &guides, "")
        };
        let few = map(2);
        let place = |text: &str| few.find(text).unwrap_or_else(|| panic!("{text}: {few}"));
        assert!(place("class=\"guide\"") < place("class=\"plate\""));
        assert!(place("class=\"plate\"") < place(">0.125<"));
        let one = [scale("x", 2), scale("y", 1)];
        let nearly = panel("", [cell(Some(0.9997), true), cell(Some(1.0), true)]);
        let nearly = heat_maps("m", [&one[0], &one[1]], &[nearly], &[], "");
        assert!(nearly.contains(">0.9997<") && nearly.contains(">1<"));
        assert!(!few.contains("too small") && !few.contains("have room"));
        let many = map(20);
        assert!(!many.contains("class=\"plate\""));
        assert!(many.contains(">The cells are too small for numbers.<"));
    }

    #[test]
    fn names_of_cells_are_cut_in_the_middle_and_none_is_left_out() {
        let names = ["as it is", "fista with twenty iterations", "osmo"].map(str::to_owned);
        assert!(are_words(&names) && !are_words(&["0.1".to_owned(), "−2".to_owned()]));
        let cut = ["as it is", "fista wit…erations", "osmo"];
        assert_eq!(all_shortened(&names, 18), cut);
        let alike = ["step 1 of all", "step 2 of all"].map(str::to_owned);
        assert_eq!(all_shortened(&alike, 5), ["step 1…f all", "step 2…f all"]);
        let panels = vec![panel("", [cell(Some(1.0), false); 3]); 4];
        let one = scale("y", 1);
        let names = MapAxis {
            labels: names.to_vec(),
            ..scale("method", 0)
        };
        let across = heat_maps("m", [&names, &one], &panels, &[], "");
        let up = heat_maps("m", [&one, &names], &panels, &[], "");
        for svg in [across, up] {
            assert_eq!(svg.matches(">fista wit…erations<").count(), 4, "{svg}");
        }
    }

    #[test]
    fn zero_has_the_lowest_of_logarithmic_colors_and_all_equal_values_one() {
        let values = ColorScale::of([0.0, 1e-4, 1.0].into_iter());
        assert!(values.is_log);
        assert_eq!(
            [0.0, 1e-4, 1e-2, 1.0].map(|v| values.place(v)),
            [0.0, 0.0, 0.5, 1.0]
        );
        let values = ColorScale::of([0.3, 0.3].into_iter());
        assert!(!values.is_log && (values.place(0.3) - 0.5).abs() < 1e-12);
        assert!(!ColorScale::of([-1.0, 1e-9, 1.0].into_iter()).is_log);
    }

    #[test]
    fn nothing_and_failures_make_a_picture_without_nan() {
        let scales = [&scale("x", 2), &scale("y", 1)];
        let panels = [panel("", [None, cell(None, false)])];
        let svg = heat_maps("m", scales, &panels, &[], "none");
        assert!(
            svg.contains("class=\"cross\"") && !svg.contains("NaN"),
            "{svg}"
        );
        let cells = [cell(None, false), cell(Some(4.0), true)];
        let curve = PlotCurve {
            labels: None,
            is_log: true,
            is_joined: true,
            points: cells.map(|cell| (1.0, cell.unwrap())).to_vec(),
            ..curve("x", &[], &[])
        };
        let svg = curves("m", &[curve], "");
        assert!(
            svg.contains("class=\"ring\"") && !svg.contains("NaN") && !svg.contains("inf"),
            "{svg}"
        );
    }
}
