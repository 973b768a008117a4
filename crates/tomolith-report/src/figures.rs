//! The pictures of the page: slices, sinogram, frames.

use super::number::{escape, significant};
use super::picture::{Color, Picture, hex, inferno, reduction, viridis};
use super::{DARK, INSERT, MapReport, OBSTACLE, ReportData};
use std::fmt::Write as _;
use tomolith_core::grid::{Patterns, Volume, VolumeGrid};
use tomolith_core::parallel::InParallel;
use tomolith_core::target::label;
use tomolith_metrics::Evaluation;

/// Pixels of a slice's longer edge, at most.
const SLICE_PIXELS: usize = 480;
/// Pictures that are wider are not shown with sharp pixels.
const SMOOTH_FROM: usize = 260;
/// Pixels of the sinogram and of single frames, at most.
const SINOGRAM_PIXELS: usize = 1200;
const FRAME_PIXELS: usize = 320;
/// Frames in the strip.
const STRIP: usize = 8;
/// Width of a slice in its own units, the height follows.
const UNITS: f64 = 300.0;
/// Palette index of the part's outline, and of what is not shown.
const OUTLINE: u8 = 254;
const NOTHING: u8 = 255;

/// What a voxel becomes, against what it should.
pub(super) const FATES: [(Color, &str); 5] = [
    ([0; 4], ""),
    ([140, 150, 162, 34], "liquid, as it should"),
    ([122, 135, 151, 190], "gelled, as it should"),
    ([47, 111, 208, 255], "missing (undercured)"),
    ([214, 69, 80, 255], "too much (overcured)"),
];

/// One plane of a grid, seen along an axis: columns to the right, rows upwards.
struct Slice<'a> {
    grid: &'a VolumeGrid,
    /// Axis of the array that is fixed (0 z, 1 y, 2 x), and where.
    axis: usize,
    at: usize,
}

impl Slice<'_> {
    /// Array axes of columns and rows.
    fn axes(&self) -> [usize; 2] {
        match self.axis {
            0 => [2, 1],
            1 => [2, 0],
            _ => [1, 0],
        }
    }

    fn size(&self) -> [usize; 2] {
        self.axes().map(|axis| self.grid.shape[axis])
    }

    /// Position in the array of a column and a row from the top.
    fn index(&self, column: usize, row: usize) -> usize {
        let [right, up] = self.axes();
        let mut at = [0; 3];
        at[self.axis] = self.at;
        at[right] = column;
        at[up] = self.grid.shape[up] - 1 - row;
        self.grid.index(at[0], at[1], at[2])
    }

    /// An image whose pixels join whole blocks of voxels; `index` sees the positions of a block.
    fn picture(&self, index: impl Fn(&mut dyn Iterator<Item = usize>) -> u8 + Sync) -> Picture {
        let [width, height] = self.size();
        let factor = reduction(width, height, SLICE_PIXELS);
        Picture::new(width.div_ceil(factor), height.div_ceil(factor), |x, y| {
            let rows = y * factor..((y + 1) * factor).min(height);
            let columns = x * factor..((x + 1) * factor).min(width);
            index(
                &mut rows
                    .flat_map(|row| columns.clone().map(move |column| self.index(column, row))),
            )
        })
    }

    fn title(&self) -> String {
        let (name, mm) = match self.axis {
            0 => ("z", self.grid.z(self.at)),
            1 => ("y", self.grid.y(self.at)),
            _ => ("x", self.grid.x(self.at)),
        };
        let plane = ["x–y", "x–z", "y–z"][self.axis];
        format!("{plane} plane at {name} = {} mm", significant(mm, 3))
    }
}

/// Voxel `[z, y, x]` in the middle of the box of all that is wanted (or of the grid, when nothing is).
fn middle_of_box(grid: &VolumeGrid, is_wanted: impl Fn(usize) -> bool + Sync) -> [usize; 3] {
    let [nz, ny, nx] = grid.shape;
    let empty = [[usize::MAX, 0]; 3];
    let join = |a: [[usize; 2]; 3], b: [[usize; 2]; 3]| -> [[usize; 2]; 3] {
        std::array::from_fn(|i| [a[i][0].min(b[i][0]), a[i][1].max(b[i][1])])
    };
    let slices = (0..nz).par_map(|z| {
        (0..ny * nx)
            .filter(|i| is_wanted(z * ny * nx + i))
            .map(|i| [z, i / nx, i % nx].map(|at| [at, at]))
            .fold(empty, join)
    });
    let found = slices.into_iter().fold(empty, join);
    std::array::from_fn(|axis| match found[axis] {
        [low, high] if low <= high => usize::midpoint(low, high),
        _ => grid.shape[axis] / 2,
    })
}

/// Voxels that get dose: the part, or what is not black in a gray image.
fn is_wanted(data: &ReportData<'_>, i: usize) -> bool {
    match (data.labels.values[i], data.inside) {
        (label::PART, _) => true,
        (label::VOID, Some(inside)) => {
            data.evaluation.half_width.is_some() && inside.values[i] > 0.0
        }
        _ => false,
    }
}

/// Three planes: target, dose, error.
pub(super) fn slices(data: &ReportData<'_>) -> String {
    let grid = &data.labels.grid;
    if grid.is_empty() {
        return String::new();
    }
    let high = data.evaluation.histogram.range[1];
    let mut out = String::new();
    let middle = middle_of_box(grid, |i| is_wanted(data, i));
    for (axis, at) in middle.into_iter().enumerate() {
        let slice = Slice { grid, axis, at };
        let pictures = [
            ("Target", target_uri(data, &slice, high)),
            (
                "Dose",
                dose_picture(data, &slice, high).data_uri(&dose_palette()),
            ),
            ("Error", error_uri(data, &slice)),
        ];
        let _ = write!(
            out,
            "<div class=\"plane\"><h3>{}</h3><div class=\"trio\">",
            slice.title()
        );
        for (name, uri) in pictures {
            let _ = write!(
                out,
                "<figure>{}<figcaption>{name}</figcaption></figure>",
                slice_svg(&slice, &uri, name)
            );
        }
        out.push_str("</div></div>");
    }
    out
}

/// Two planes of a property of the printed material, and its scale.
pub(super) fn property(map: &MapReport<'_>) -> String {
    let (grid, values) = (&map.values.grid, &map.values.values);
    let scale = |v: f64| {
        if map.is_logarithmic {
            v.max(f64::MIN_POSITIVE).log10()
        } else {
            v
        }
    };
    let Some([low, _, high]) = map.spread() else {
        return String::new();
    };
    let (from, to) = (scale(low), scale(high));
    let span = (to - from).max(f64::MIN_POSITIVE);
    let middle = middle_of_box(grid, |i| values[i].is_finite());
    let mut row = String::new();
    for (axis, at) in middle.into_iter().enumerate().take(2) {
        let slice = Slice { grid, axis, at };
        let picture = slice.picture(|voxels| {
            let solid = voxels
                .map(|i| f64::from(values[i]))
                .filter(|v| v.is_finite());
            let (sum, count) = solid.fold((0.0, 0.0), |(s, n), v| (s + scale(v), n + 1.0));
            if count == 0.0 {
                NOTHING
            } else {
                ((sum / count - from) / span * HOTTEST).clamp(0.0, HOTTEST) as u8
            }
        });
        add_figure(
            &mut row,
            &slice,
            &picture.data_uri(&dose_palette()),
            &slice.title(),
        );
    }
    let label = match map.is_logarithmic {
        true => format!("{} in {}, logarithmic", map.name, map.unit),
        false => format!("{} in {}", map.name, map.unit),
    };
    let ends = [low, high].map(|v| significant(v, 3));
    format!(
        "<div class=\"pair\">{row}</div>{}",
        bar_svg(viridis, &label, "", ends)
    )
}

/// Shares of the largest dose up to which two doses count as equal, and from which on their difference has its full color.
const EQUAL: f64 = 0.05;
const APART: f64 = DIFFERENCE_REACH * EQUAL;

/// The middle planes of the doses of several runs beside each other, on one scale; below those on the grid of the first, what they have more or
/// less than it.
pub(super) fn doses(runs: &[(&str, &Volume<f32>)]) -> String {
    let largest = |dose: &Volume<f32>| dose.values.iter().copied().fold(0.0, f32::max);
    let high = runs
        .iter()
        .map(|(_, dose)| largest(dose))
        .fold(0.0, f32::max);
    let high = f64::from(high).max(f64::MIN_POSITIVE);
    let differences: Vec<Color> = (0..=255u8)
        .map(|i| difference(f64::from(i) / 254.0))
        .collect();
    let mut out = String::new();
    for axis in [0, 1] {
        let mut figures = [String::new(), String::new()];
        let (_, first) = runs[0];
        for (i, (name, dose)) in runs.iter().enumerate() {
            let slice = Slice {
                grid: &dose.grid,
                axis,
                at: dose.grid.shape[axis] / 2,
            };
            let mean = |value: &dyn Fn(usize) -> f64, voxels: &mut dyn Iterator<Item = usize>| {
                let (sum, count) = voxels.fold((0.0, 0.0), |(s, n), i| (s + value(i), n + 1.0));
                sum / count / high
            };
            let own = |i: usize| f64::from(dose.values[i]);
            let picture = slice.picture(|v| (mean(&own, v) * HOTTEST).clamp(0.0, HOTTEST) as u8);
            add_figure(
                &mut figures[0],
                &slice,
                &picture.data_uri(&dose_palette()),
                name,
            );
            if i > 0 && dose.grid == first.grid {
                let more = |i: usize| own(i) - f64::from(first.values[i]);
                let place = |share: f64| 127.0 + 127.0 * (share / APART).clamp(-1.0, 1.0);
                let picture = slice.picture(|v| place(mean(&more, v)).round() as u8);
                let caption = format!("{name}, less {}", runs[0].0);
                add_figure(
                    &mut figures[1],
                    &slice,
                    &picture.data_uri(&differences),
                    &caption,
                );
            }
        }
        let title = ["x–y", "x–z"][axis];
        let _ = write!(out, "<div class=\"plane\"><h3>Middle {title} plane</h3>");
        for row in figures.iter().filter(|row| !row.is_empty()) {
            let _ = write!(out, "<div class=\"beside\">{row}</div>");
        }
        out.push_str("</div>");
    }
    out + &color_bar(viridis, high, "dose", None)
}

fn add_figure(row: &mut String, slice: &Slice<'_>, uri: &str, caption: &str) {
    let caption = escape(caption);
    let svg = slice_svg(slice, uri, &caption);
    let _ = write!(
        row,
        "<figure>{svg}<figcaption>{caption}</figcaption></figure>"
    );
}

/// Bodies that are not printed, in pictures of the target: their mark, color and name.
pub(super) const BODIES: [(u8, Color, &str); 3] = [
    (DARK, [38, 44, 54, 255], "to stay dark"),
    (INSERT, [201, 148, 46, 255], "insert"),
    (OBSTACLE, [120, 84, 60, 255], "obstacle"),
];

impl ReportData<'_> {
    /// Which of [`BODIES`] a voxel belongs to.
    fn body(&self, i: usize) -> Option<usize> {
        let mark = self.bodies?.values[i];
        BODIES.iter().position(|(body, ..)| *body == mark)
    }

    /// Whether a voxel counts and holds resin.
    fn holds_resin(&self, i: usize) -> bool {
        let is_obstacle = self.bodies.is_some_and(|b| b.values[i] == OBSTACLE);
        self.labels.values[i] != label::OUTSIDE && !is_obstacle
    }
}

fn target_palette() -> Vec<Color> {
    (0..=255u8)
        .map(|i| match i {
            NOTHING => [0; 4],
            i if i > FULL => body_color(i),
            i => [
                122,
                135,
                151,
                34 + (f64::from(i) / f64::from(FULL) * 156.0) as u8,
            ],
        })
        .collect()
}

/// A pixel that lies wholly in the part, or has the largest dose; those above stand for [`BODIES`].
const FULL: u8 = OUTLINE - 1 - BODIES.len() as u8;
const HOTTEST: f64 = FULL as f64;

fn body_color(i: u8) -> Color {
    let body = BODIES.get(usize::from(i - FULL) - 1);
    body.map_or([0; 4], |(_, color, _)| *color)
}

fn target_picture(data: &ReportData<'_>, slice: &Slice<'_>) -> Picture {
    let inside = |i: usize| match (data.labels.values[i], data.inside) {
        (_, Some(inside)) => inside.values[i].clamp(0.0, 1.0),
        (label, None) => f32::from(u8::from(label == label::PART)),
    };
    slice.picture(|voxels| {
        let (mut sum, mut count, mut marked) = (0.0, 0.0, [0.0; BODIES.len()]);
        for i in voxels {
            if let Some(at) = data.body(i) {
                marked[at] += 1.0;
            } else if data.labels.values[i] != label::OUTSIDE {
                sum += inside(i);
                count += 1.0;
            }
        }
        let most = (0..BODIES.len()).max_by(|a, b| f32::total_cmp(&marked[*a], &marked[*b]));
        match most.filter(|&at| marked[at] > count) {
            Some(at) => FULL + 1 + at as u8,
            None if count == 0.0 => NOTHING,
            None => (f32::from(FULL) * sum / count) as u8,
        }
    })
}

fn dose_palette() -> Vec<Color> {
    (0..=255u8)
        .map(|i| match i {
            NOTHING => [0; 4],
            OUTLINE => [255, 255, 255, 255],
            i if i > FULL => body_color(i),
            i => viridis(f64::from(i) / HOTTEST),
        })
        .collect()
}

/// The target; gray values in the colors of the response, so that the two can be compared.
fn target_uri(data: &ReportData<'_>, slice: &Slice<'_>, high: f64) -> String {
    match (data.evaluation.half_width, data.inside) {
        (Some(_), Some(wanted)) => {
            mean_picture(data, &wanted.values, slice, high).data_uri(&dose_palette())
        }
        _ => target_picture(data, slice).data_uri(&target_palette()),
    }
}

/// Means over the voxels of resin that count, on the scale of the dose. Where none does, the bodies that are not printed.
fn mean_picture(data: &ReportData<'_>, values: &[f32], slice: &Slice<'_>, high: f64) -> Picture {
    slice.picture(|voxels| {
        let (mut sum, mut count, mut body) = (0.0, 0.0, None);
        for i in voxels {
            if data.holds_resin(i) {
                sum += f64::from(values[i]);
                count += 1.0;
            } else {
                body = body.or_else(|| data.body(i));
            }
        }
        match body {
            _ if count > 0.0 => (sum / count / high * HOTTEST).clamp(0.0, HOTTEST) as u8,
            Some(at) => FULL + 1 + at as u8,
            None => NOTHING,
        }
    })
}

fn dose_picture(data: &ReportData<'_>, slice: &Slice<'_>, high: f64) -> Picture {
    let part = |i: usize| data.labels.values[i] == label::PART;
    let mut picture = mean_picture(data, &data.response.values, slice, high);
    if data.evaluation.half_width.is_some() {
        return picture;
    }
    // The part's outline: pixels of the void that are close to a pixel of the part; two wide in large pictures, which
    // may be shown smaller than they are
    let inside = slice.picture(|voxels| {
        let (parts, all) = voxels.fold((0, 0), |(p, n), i| (p + usize::from(part(i)), n + 1));
        u8::from(2 * parts >= all)
    });
    let (w, h) = (inside.width, inside.height);
    let reach = if w > SMOOTH_FROM { 2 } else { 1 };
    for i in (0..w * h).filter(|&i| inside.pixels[i] == 0) {
        let (x, y) = (i % w, i / w);
        let near = (1..=reach).any(|d| {
            x >= d && inside.pixels[i - d] == 1
                || x + d < w && inside.pixels[i + d] == 1
                || y >= d && inside.pixels[i - d * w] == 1
                || y + d < h && inside.pixels[i + d * w] == 1
        });
        let is_body = picture.pixels[i] > FULL && picture.pixels[i] < OUTLINE;
        if near && !is_body {
            picture.pixels[i] = OUTLINE;
        }
    }
    picture
}

fn error_uri(data: &ReportData<'_>, slice: &Slice<'_>) -> String {
    match (shown_half_width(data.evaluation), data.inside) {
        (Some(half_width), Some(wanted)) => {
            let palette: Vec<Color> = (0..=255u8)
                .map(|i| match i {
                    NOTHING => [0; 4],
                    i => difference(f64::from(i) / 254.0),
                })
                .collect();
            difference_picture(data, wanted, slice, half_width).data_uri(&palette)
        }
        _ => {
            let bodies = BODIES.iter().map(|(_, color, _)| *color);
            let palette: Vec<Color> = FATES.iter().map(|f| f.0).chain(bodies).collect();
            fate_picture(data, slice).data_uri(&palette)
        }
    }
}

/// Differences are drawn up to this many half widths of the band.
const DIFFERENCE_REACH: f64 = 4.0;

/// Up to where differences are drawn gray: within the band, or within their root mean square where the band has no width.
pub(super) fn shown_half_width(evaluation: &Evaluation) -> Option<f64> {
    let own = evaluation.half_width?;
    if own > 0.0 {
        return Some(own);
    }
    Some(evaluation.measures.get("rms_error").unwrap_or(own))
}

/// From too little (0, blue) over none (½, gray) to too much (1, red); gray in the band.
fn difference(at: f64) -> Color {
    let off = 2.0 * at - 1.0;
    let in_band = 1.0 / DIFFERENCE_REACH;
    let share = ((off.abs() - in_band) / (1.0 - in_band)).clamp(0.0, 1.0);
    let end = if off < 0.0 { FATES[3].0 } else { FATES[4].0 };
    let middle = [200u8, 205, 211];
    let blend = |i: usize| {
        let (from, to) = (f64::from(middle[i]), f64::from(end[i]));
        (from + (to - from) * share).round() as u8
    };
    [blend(0), blend(1), blend(2), 255]
}

/// The largest difference of each block, with its sign.
fn difference_picture(
    data: &ReportData<'_>,
    wanted: &Volume<f32>,
    slice: &Slice<'_>,
    half_width: f64,
) -> Picture {
    let reach = DIFFERENCE_REACH * half_width.max(f64::MIN_POSITIVE);
    slice.picture(|voxels| {
        let counted = voxels.filter(|&i| data.labels.values[i] != label::OUTSIDE);
        let differences =
            counted.map(|i| f64::from(data.response.values[i]) - f64::from(wanted.values[i]));
        let largest = differences.max_by(|a, b| a.abs().total_cmp(&b.abs()));
        largest.map_or(NOTHING, |off| {
            (127.0 + 127.0 * (off / reach).clamp(-1.0, 1.0)).round() as u8
        })
    })
}

/// The worst fate of each block: errors stay visible. Where nothing counts, the bodies that are not printed.
fn fate_picture(data: &ReportData<'_>, slice: &Slice<'_>) -> Picture {
    let threshold = data.evaluation.gel_threshold.unwrap_or(f64::INFINITY);
    let fate = |i: usize| {
        let gelled = f64::from(data.response.values[i]) > threshold;
        match (data.labels.values[i], gelled) {
            (label::VOID, false) => u8::from(data.holds_resin(i)),
            (label::PART, true) => 2,
            (label::PART, false) => 3,
            (label::VOID, true) => 4,
            _ => 0,
        }
    };
    slice.picture(|voxels| {
        let (mut worst, mut first) = (0, None);
        for i in voxels {
            worst = worst.max(fate(i));
            first = first.or_else(|| data.body(i));
        }
        match first {
            Some(body) if worst == 0 => (FATES.len() + body) as u8,
            _ => worst,
        }
    })
}

/// Solid and liquid against the part, and the degree of cure (2 is the end of its scale), in two planes.
pub(super) fn growth(labels: &Volume<u8>, degree: &Volume<f32>) -> String {
    let grid = &labels.grid;
    let middle = middle_of_box(grid, |i| labels.values[i] == label::PART);
    let fates: Vec<Color> = FATES.iter().map(|(color, _)| *color).collect();
    let mut row = String::new();
    for (axis, at) in middle.into_iter().enumerate().take(2) {
        let slice = Slice { grid, axis, at };
        let fate = |i: usize| match (labels.values[i], degree.values[i] >= 1.0) {
            (label::VOID, false) => 1,
            (label::PART, true) => 2,
            (label::PART, false) => 3,
            (label::VOID, true) => 4,
            _ => 0,
        };
        let picture = slice.picture(|voxels| voxels.map(fate).max().unwrap_or(0));
        add_figure(
            &mut row,
            &slice,
            &picture.data_uri(&fates),
            "solid against the part",
        );
        let picture = slice.picture(|voxels| {
            let (sum, count) = voxels.fold((0.0, 0.0), |(s, n), i| {
                (s + f64::from(degree.values[i]), n + 1.0)
            });
            (sum / f64::max(count, 1.0) / 2.0 * HOTTEST).clamp(0.0, HOTTEST) as u8
        });
        add_figure(
            &mut row,
            &slice,
            &picture.data_uri(&dose_palette()),
            "degree of cure, 0 to 2",
        );
    }
    row
}

/// A picture with its scale bar.
fn slice_svg(slice: &Slice<'_>, uri: &str, name: &str) -> String {
    let [width, height] = slice.size();
    let tall = UNITS * height as f64 / width as f64;
    let mm = width as f64 * slice.grid.pitch_mm;
    let length = nice_length(mm / 4.0);
    let bar = UNITS * length / mm;
    let (x, y) = (10.0, tall + 20.0);
    format!(
        "<svg class=\"slice{}\" viewBox=\"0 0 {UNITS} {:.1}\" role=\"img\" aria-label=\"{name}, {}\">\
         <image href=\"{uri}\" width=\"{UNITS}\" height=\"{tall:.2}\" preserveAspectRatio=\"none\"/>\
         <path class=\"scale\" d=\"M{x} {y:.1}h{bar:.1}\"/><text x=\"{:.1}\" y=\"{:.1}\">{} mm</text></svg>",
        if width > SMOOTH_FROM { "" } else { " sharp" },
        tall + 36.0,
        escape(&slice.title()),
        x + bar + 8.0,
        y + 7.0,
        significant(length, 2),
    )
}

/// 1, 2 or 5 times a power of ten, not larger than `length`.
pub(super) fn nice_length(length: f64) -> f64 {
    let power = 10f64.powf(length.log10().floor());
    [5.0, 2.0, 1.0]
        .into_iter()
        .map(|m| m * power)
        .find(|l| *l <= length)
        .unwrap_or(power)
}

/// A color bar from 0 to `high`, with marks.
pub(super) fn color_bar(
    map: fn(f64) -> Color,
    high: f64,
    label: &str,
    mark: Option<(f64, &str)>,
) -> String {
    bar_svg(
        map,
        label,
        &marked_at(high, mark),
        ["0".to_owned(), significant(high, 3)],
    )
}

/// The color bar of the differences.
pub(super) fn error_bar(half_width: f64) -> String {
    let reach = significant(DIFFERENCE_REACH * half_width, 3);
    let ends = [format!("−{reach}"), format!("+{reach}")];
    bar_svg(difference, "response − gray value", "", ends)
}

fn marked_at(high: f64, mark: Option<(f64, &str)>) -> String {
    mark.map_or(String::new(), |(at, name)| {
        let x = 10.0 + 300.0 * (at / high).clamp(0.0, 1.0);
        let anchor = if x > 250.0 { "end" } else { "middle" };
        format!(
            "<path class=\"mark\" d=\"M{x:.1} 14v20\"/><text x=\"{x:.1}\" y=\"11\" text-anchor=\"{anchor}\">{}</text>",
            escape(name)
        )
    })
}

pub(super) fn bar_svg(
    map: fn(f64) -> Color,
    label: &str,
    marked: &str,
    [low, high]: [String; 2],
) -> String {
    let stops: String = (0..=20)
        .map(|i| {
            format!(
                "<stop offset=\"{}%\" stop-color=\"{}\"/>",
                i * 5,
                hex(map(f64::from(i) / 20.0))
            )
        })
        .collect();
    let letters: String = label.chars().filter(char::is_ascii_alphanumeric).collect();
    let (id, label) = (format!("bar-{letters}"), escape(label));
    format!(
        "<svg class=\"bar\" viewBox=\"0 0 320 62\" role=\"img\" aria-label=\"{label}\"><defs><linearGradient id=\"{id}\">{stops}\
         </linearGradient></defs><rect x=\"10\" y=\"18\" width=\"300\" height=\"12\" rx=\"2\" fill=\"url(#{id})\"/>{marked}\
         <text x=\"10\" y=\"46\">{low}</text><text x=\"160\" y=\"46\" text-anchor=\"middle\">{label}</text>\
         <text x=\"310\" y=\"46\" text-anchor=\"end\">{high}</text></svg>"
    )
}

pub(super) fn dose_bar(data: &ReportData<'_>) -> String {
    let high = data.evaluation.histogram.range[1];
    let mark = data
        .evaluation
        .gel_threshold
        .filter(|_| data.evaluation.half_width.is_none())
        .map(|t| (t, format!("gel threshold {}", significant(t, 3))));
    color_bar(
        viridis,
        high,
        "response to the dose",
        mark.as_ref().map(|(t, name)| (*t, name.as_str())),
    )
}

fn light_palette() -> Vec<Color> {
    (0..=255u8).map(|i| inferno(f64::from(i) / 255.0)).collect()
}

/// How light is stretched for reading. Few pixels are bright: on the projector's own scale most pictures of them are black.
pub(super) struct LightScale {
    /// What has the last color; brighter pixels have it, too.
    top: f64,
    /// White of the projector.
    white: f64,
}

/// Share of the pixels that shine which are brighter than the last color.
const BEYOND: f64 = 0.005;
/// Steps of the square root of light between which that is found.
const STEPS: usize = 1024;

impl LightScale {
    /// For the patterns of a light.
    pub(super) fn of(patterns: &Patterns, white: f32) -> Self {
        let white = f64::from(white);
        let mut counts = [0u64; STEPS + 1];
        for &value in patterns.values.iter().filter(|value| **value > 0.0) {
            let root = (f64::from(value) / white).sqrt();
            counts[(root * STEPS as f64).ceil().clamp(0.0, STEPS as f64) as usize] += 1;
        }
        let all: u64 = counts.iter().sum();
        let mut beyond = 0;
        let last = counts.iter().rposition(|count| {
            beyond += count;
            beyond as f64 > BEYOND * all as f64
        });
        let top = white * (last.unwrap_or(STEPS) as f64 / STEPS as f64).powi(2);
        LightScale { top, white }
    }

    /// Place of a value among the colors, 0 to 1.
    fn place(&self, value: f64) -> f64 {
        match self.top > 0.0 {
            true => (value / self.top).clamp(0.0, 1.0).sqrt(),
            false => 0.0,
        }
    }

    /// The colors and what they mean, in per cent of white.
    pub(super) fn bar(&self) -> String {
        let percent = |value: f64| significant(100.0 * value / self.white, 2);
        let mut marks = String::new();
        for quarter in 1..4 {
            let place = f64::from(quarter) / 4.0;
            let x = 10.0 + 300.0 * place;
            let value = percent(self.top * place.powi(2));
            let _ = write!(
                marks,
                "<path class=\"mark\" d=\"M{x:.1} 14v20\"/><text x=\"{x:.1}\" y=\"11\" text-anchor=\"middle\">{value}</text>"
            );
        }
        let beyond = if self.top < self.white {
            " and more"
        } else {
            ""
        };
        let ends = ["0".to_owned(), format!("{}{beyond}", percent(self.top))];
        bar_svg(inferno, "light, % of white", &marks, ends)
    }
}

/// Means over blocks, stretched.
fn light_picture(
    size: [usize; 2],
    most: usize,
    scale: &LightScale,
    value: impl Fn(usize, usize) -> f32 + Sync,
) -> Picture {
    let [width, height] = size;
    let factor = reduction(width, height, most);
    Picture::new(width.div_ceil(factor), height.div_ceil(factor), |x, y| {
        let (mut sum, mut count) = (0.0, 0.0);
        for row in y * factor..((y + 1) * factor).min(height) {
            for column in x * factor..((x + 1) * factor).min(width) {
                sum += f64::from(value(column, row));
                count += 1.0;
            }
        }
        (255.0 * scale.place(sum / count)) as u8
    })
}

/// The row that carries most light.
fn brightest_row(patterns: &Patterns) -> usize {
    let grid = &patterns.grid;
    let mut sums = vec![0.0f64; grid.rows];
    for frame in patterns
        .values
        .chunks_exact((grid.rows * grid.columns).max(1))
    {
        for (row, pixels) in frame.chunks_exact(grid.columns).enumerate() {
            sums[row] += pixels.iter().map(|&v| f64::from(v)).sum::<f64>();
        }
    }
    (0..grid.rows)
        .max_by(|&a, &b| sums[a].total_cmp(&sums[b]).then(b.cmp(&a)))
        .unwrap_or(0)
}

/// All frames of one row: angle to the right, column upwards.
pub(super) fn sinogram(patterns: &Patterns, scale: &LightScale) -> String {
    let grid = &patterns.grid;
    if grid.is_empty() {
        return String::new();
    }
    let row = brightest_row(patterns);
    let (frames, columns) = (grid.frames(), grid.columns);
    let picture = light_picture([frames, columns], SINOGRAM_PIXELS, scale, |frame, up| {
        patterns.values[(frame * grid.rows + row) * columns + columns - 1 - up]
    });
    let uri = picture.data_uri(&light_palette());
    let half = 0.5 * columns as f64 * grid.pitch_mm[0];
    let tick = nice_length(half);
    let (left, top, width, height) = (56.0, 8.0, 606.0, 236.0);
    let bottom = top + height;
    let mut axes = String::new();
    let first = grid.azimuths[0].to_degrees();
    let arc = (grid.azimuths[frames - 1] - grid.azimuths[0]).to_degrees() * frames as f64
        / (frames as f64 - 1.0).max(1.0);
    let evenly = grid.azimuths.windows(2).all(|w| {
        let step = arc.to_radians() / frames as f64;
        (w[1] - w[0] - step).abs() <= 1e-6 + 1e-3 * step.abs()
    });
    for i in 0..=4 {
        let x = left + width * f64::from(i) / 4.0;
        // Unevenly spaced frames are counted, not measured
        let label = if evenly && frames > 1 {
            format!("{}°", significant(first + arc * f64::from(i) / 4.0, 3))
        } else {
            significant(frames as f64 * f64::from(i) / 4.0, 3)
        };
        let _ = write!(
            axes,
            "<path class=\"tick\" d=\"M{x:.1} {bottom}v5\"/><text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
            bottom + 19.0
        );
    }
    for u in [-tick, 0.0, tick] {
        let y = top + height * (0.5 - 0.5 * u / half);
        let _ = write!(
            axes,
            "<path class=\"tick\" d=\"M{left} {y:.1}h-5\"/><text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            left - 8.0,
            y + 4.0,
            significant(grid.offset_mm[0] + u, 2)
        );
    }
    let x_label = if evenly {
        "azimuth of the light"
    } else {
        "frame"
    };
    format!(
        "<svg class=\"plot wide\" viewBox=\"0 0 690 296\" role=\"img\" aria-label=\"Sinogram of row {row}\">\
         <image href=\"{uri}\" x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\"/>{axes}\
         <text class=\"label\" x=\"{}\" y=\"290\" text-anchor=\"middle\">{x_label}</text>\
         <text class=\"label\" transform=\"translate(12 {}) rotate(-90)\" text-anchor=\"middle\">column, mm</text></svg>\
         <p class=\"note\">Row {row} of {} (z = {} mm), the one that carries most light.</p>",
        left + width / 2.0,
        top + height / 2.0,
        grid.rows,
        significant(grid.row_z(row), 3),
    )
}

/// Some frames, evenly spread.
pub(super) fn strip(patterns: &Patterns, scale: &LightScale) -> String {
    let grid = &patterns.grid;
    let frames = grid.frames();
    if grid.is_empty() {
        return String::new();
    }
    let shown = frames.min(STRIP);
    let mut out = String::from("<div class=\"strip\">");
    for i in 0..shown {
        let frame = i * frames / shown;
        let values = patterns.frame(frame);
        let picture = light_picture(
            [grid.columns, grid.rows],
            FRAME_PIXELS,
            scale,
            |column, row| values[row * grid.columns + column],
        );
        let _ = write!(
            out,
            "<figure><img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"Frame {frame}\"><figcaption>{frame} · {}°</figcaption></figure>",
            picture.data_uri(&light_palette()),
            picture.width,
            picture.height,
            significant((grid.azimuths[frame].to_degrees() * 10.0).round() / 10.0, 4),
        );
    }
    out + "</div>"
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::PatternGrid;

    #[test]
    fn slices_are_seen_from_the_right_side() {
        let grid = VolumeGrid::centered([2, 3, 4], 0.1);
        let top = Slice {
            grid: &grid,
            axis: 0,
            at: 1,
        };
        assert_eq!(top.size(), [4, 3]);
        assert_eq!(top.index(0, 0), grid.index(1, 2, 0)); // left and highest y on top
        let front = Slice {
            grid: &grid,
            axis: 1,
            at: 2,
        };
        assert_eq!(
            (front.size(), front.index(3, 1)),
            ([4, 2], grid.index(0, 2, 3))
        );
        let side = Slice {
            grid: &grid,
            axis: 2,
            at: 0,
        };
        assert_eq!(
            (side.size(), side.index(1, 0)),
            ([3, 2], grid.index(1, 1, 0))
        );
    }

    #[test]
    fn the_middle_is_that_of_the_box_not_of_the_mass() {
        let grid = VolumeGrid::centered([5, 6, 7], 0.1);
        assert_eq!(middle_of_box(&grid, |_| false), [2, 3, 3]);
        // Much at x = 0, a single voxel at x = 6 and z = 4
        let spike = grid.index(4, 5, 6);
        let wanted = |i: usize| i == spike || (i.is_multiple_of(7) && i < 3 * 42);
        assert_eq!(middle_of_box(&grid, wanted), [2, 2, 3]);
    }

    #[test]
    fn differences_in_the_band_are_gray_and_beyond_it_colored_by_their_sign() {
        let [low, middle, high] = [0.0, 0.5, 1.0].map(difference);
        assert_eq!((low, high), (FATES[3].0, FATES[4].0));
        assert_eq!(difference(0.5 + 0.49 / DIFFERENCE_REACH), middle);
        assert_ne!(difference(0.5 + 0.6 / DIFFERENCE_REACH), middle);
    }

    #[test]
    fn dim_light_is_stretched_until_it_is_seen_and_the_bar_says_how() {
        let mut patterns = Patterns::dark(PatternGrid::full_turn(1, 0.0, 1, 1000, 0.1));
        patterns.values[..400].fill(0.04);
        patterns.values[0] = 1.0;
        // One of 400 pixels that shine is brighter than the last color: less than one in 200
        let scale = LightScale::of(&patterns, 1.0);
        assert!((scale.top - 0.04).abs() < 1e-3, "{}", scale.top);
        let places = [0.0, 0.01, 0.04, 1.0].map(|value| scale.place(value));
        for (found, expected) in places.into_iter().zip([0.0, 0.5, 1.0, 1.0]) {
            assert!((found - expected).abs() < 0.01, "{places:?}");
        }
        let bar = scale.bar();
        assert!(bar.contains(">4 and more<") && bar.contains(">1<"), "{bar}");
        patterns.values.fill(0.5);
        assert!((LightScale::of(&patterns, 0.5).top - 0.5).abs() < 1e-9);
        patterns.values.fill(0.0);
        assert_eq!(LightScale::of(&patterns, 0.0).place(0.0), 0.0);
    }

    #[test]
    fn scale_bars_have_round_lengths() {
        for (length, bar) in [(2.4, 2.0), (0.99, 0.5), (1.0, 1.0), (70.0, 50.0)] {
            assert!((nice_length(length) - bar).abs() < 1e-9);
        }
    }

    #[test]
    fn one_wrong_voxel_is_seen_in_a_reduced_picture() {
        let grid = VolumeGrid::centered([1, 1, 3 * SLICE_PIXELS], 0.1);
        let slice = Slice {
            grid: &grid,
            axis: 0,
            at: 0,
        };
        let picture = slice.picture(|voxels| voxels.map(|i| u8::from(i == 700)).max().unwrap_or(0));
        assert_eq!(picture.width, SLICE_PIXELS);
        assert_eq!(picture.pixels.iter().filter(|p| **p == 1).count(), 1);
    }
}
