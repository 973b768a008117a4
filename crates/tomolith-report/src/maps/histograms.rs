//! Histograms side by side over one scale, as one SVG file: those of several runs, with the band of each objective.
//!
//! Each panel shows shares of its own voxels, logarithmically, with 0 below the decades: peaks at the edges of a band and the few voxels
//! with the largest errors are both seen. Bins are joined until a panel has about a hundred of them.

use super::placed;
use super::sheet::{Frame, LabelMargins, Sheet, Ticks, draw};
use crate::plot::Axis;

/// Bins of a panel, at most.
const BINS: f64 = 100.0;
/// Height of a panel, of its width.
const FLAT: f64 = 0.9;
/// Margin on either side, as a share of what is shown.
const BESIDE: f64 = 0.04;
/// How series are drawn, so that they differ.
pub(super) const SERIES: [(&str, &str); 4] = [
    ("part", "teal"),
    ("void", "orange"),
    ("third", "violet"),
    ("fourth", "red"),
];

/// One histogram.
#[derive(Clone, Debug)]
pub struct HistogramPanel {
    /// What tells it from the others.
    pub title: String,
    /// Lower end of the first and upper end of the last bin.
    pub range: [f64; 2],
    /// A range that is shaded.
    pub band: Option<[f64; 2]>,
    /// Name, and counts per bin, all of equal width.
    pub series: Vec<(String, Vec<f64>)>,
}

impl HistogramPanel {
    fn bins(&self) -> usize {
        let counts = self.series.iter().map(|(_, counts)| counts.len());
        counts.max().unwrap_or(0)
    }

    fn all(&self) -> f64 {
        let counts = self.series.iter().flat_map(|(_, counts)| counts);
        counts.sum::<f64>().max(f64::MIN_POSITIVE)
    }
}

/// Ends of what has voxels or a band, in all histograms; the same on both sides of 0 where ranges are.
#[must_use]
pub fn extent(panels: &[HistogramPanel]) -> [f64; 2] {
    let mut ends: Vec<f64> = Vec::new();
    for panel in panels {
        ends.extend(panel.band.iter().flatten());
        let width = (panel.range[1] - panel.range[0]) / panel.bins().max(1) as f64;
        for (_, counts) in &panel.series {
            let filled = |n: &f64| *n > 0.0;
            let first = counts.iter().position(filled);
            let last = counts.iter().rposition(filled);
            ends.extend(first.map(|i| panel.range[0] + i as f64 * width));
            ends.extend(last.map(|i| panel.range[0] + (i + 1) as f64 * width));
        }
    }
    let low = ends.iter().copied().reduce(f64::min).unwrap_or(0.0);
    let high = ends.iter().copied().reduce(f64::max).unwrap_or(1.0);
    let room = BESIDE * (high - low).max(1e-9);
    if panels.iter().all(|panel| panel.range[0] == -panel.range[1]) {
        let reach = low.abs().max(high.abs()) + room;
        return [-reach, reach];
    }
    [low - room, high + room]
}

/// Counts of so many neighboring bins together that about `most` lie within `shown`; the ends of what they cover, which is `shown` or more.
/// Bins are joined from the middle of the range, so that 0 stays an edge.
#[must_use]
pub fn joined(
    [low, high]: [f64; 2],
    counts: &[f64],
    shown: [f64; 2],
    most: f64,
) -> ([f64; 2], Vec<f64>) {
    let width = (high - low) / counts.len().max(1) as f64;
    let step = ((shown[1] - shown[0]) / width / most).ceil().max(1.0) as i64;
    let middle = counts.len() as i64 / 2;
    let edge = |value: f64| (value - low) / width - middle as f64;
    let first = (edge(shown[0]) / step as f64).floor() as i64;
    let last = (edge(shown[1]) / step as f64).ceil() as i64;
    let count = |i: i64| usize::try_from(i).ok().and_then(|i| counts.get(i));
    let sum = |k: i64| {
        let bins = middle + k * step..middle + (k + 1) * step;
        bins.filter_map(count).sum()
    };
    let end = |k: i64| low + (middle + k * step) as f64 * width;
    ([end(first), end(last)], (first..last).map(sum).collect())
}

/// Histograms side by side, as one SVG file; `caption` stands below them.
#[must_use]
pub fn histograms(title: &str, x: &str, panels: &[HistogramPanel], caption: &str) -> String {
    let shown = extent(panels);
    let shares = |panel: &HistogramPanel| {
        let percent_of = |(_, counts): &(String, Vec<f64>)| {
            let (ends, joined) = joined(panel.range, counts, shown, BINS);
            let percent = joined.iter().map(|n| 100.0 * n / panel.all());
            (ends, percent.collect::<Vec<f64>>())
        };
        panel.series.iter().map(percent_of).collect::<Vec<_>>()
    };
    let drawn: Vec<_> = panels.iter().map(shares).collect();
    let heights = || {
        let of_series = drawn.iter().flatten().flat_map(|(_, shares)| shares);
        of_series.copied().filter(|share| *share > 0.0)
    };
    let [least, most] = [
        heights().reduce(f64::min).unwrap_or(0.1),
        heights().reduce(f64::max).unwrap_or(1.0),
    ];
    let axes = [
        Axis::linear(x, shown[0], shown[1]),
        Axis::log_with_zero("", least, most),
    ];
    let mut sheet = Sheet::new(panels.len(), FLAT, 20.0, LabelMargins::new(0, 0));
    sheet.head(title, caption);
    for (i, (panel, drawn)) in panels.iter().zip(&drawn).enumerate() {
        let frame = sheet.frame(i);
        draw(&mut sheet.body, &frame, panel, drawn, &axes);
    }
    let mut marks = colors(panels.iter().map(|panel| &panel.series));
    let has_band = panels.iter().any(|panel| panel.band.is_some());
    marks.push(has_band.then_some("shaded: the band of the objective".to_owned()));
    sheet.svg(title, &marks)
}

/// The colors of the series of panels, which have the same names.
pub(super) fn colors<'p, T: 'p>(
    panels: impl Iterator<Item = &'p Vec<(String, T)>>,
) -> Vec<Option<String>> {
    let longest = panels.max_by_key(|series| series.len());
    let named = longest.into_iter().flatten().zip(SERIES.iter().cycle());
    named
        .map(|((name, _), (_, color))| Some(format!("{color}: {name}")))
        .collect()
}

fn draw(
    body: &mut String,
    frame: &Frame,
    panel: &HistogramPanel,
    drawn: &[([f64; 2], Vec<f64>)],
    [x, y]: &[Axis; 2],
) {
    let across = |value: f64| frame.x(x.place(value).clamp(0.0, 1.0));
    if let Some([from, to]) = panel.band {
        // A band of no width is a line
        let (left, right) = (across(from), across(to));
        draw!(
            body,
            "<rect class=\"band\" x=\"{left:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\"/>",
            frame.top,
            (right - left).max(1.5),
            frame.height
        );
    }
    let base = frame.y(0.0);
    for ((ends, shares), (class, _)) in drawn.iter().zip(SERIES.iter().cycle()) {
        let width = (ends[1] - ends[0]) / shares.len().max(1) as f64;
        let mut path = format!("M{:.1} {base:.1}", across(ends[0]));
        for (i, &share) in shares.iter().enumerate() {
            let top = frame.y(y.place(share).clamp(0.0, 1.0));
            let to = across(ends[0] + (i + 1) as f64 * width);
            draw!(path, "V{top:.1}H{to:.1}");
        }
        draw!(body, "<path class=\"{class}\" d=\"{path}V{base:.1}Z\"/>");
    }
    frame.title(body, &panel.title);
    let below = Ticks::level(placed(x, (frame.width / 60.0) as usize));
    let left = placed(y, (frame.height / 30.0) as usize);
    frame.axes(body, [&x.label, "voxels per bin, %"], &below, &left);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(band: f64, counts: Vec<f64>) -> HistogramPanel {
        HistogramPanel {
            title: "a < b".to_owned(),
            range: [-1.0, 1.0],
            band: Some([-band, band]),
            series: vec![("part".to_owned(), counts)],
        }
    }

    #[test]
    fn bins_are_joined_from_the_middle_and_no_voxel_is_lost() {
        let mut counts = vec![0.0; 800];
        (counts[399], counts[400], counts[480]) = (3.0, 5.0, 7.0);
        let (ends, few) = joined([-1.0, 1.0], &counts, [-0.25, 0.25], 20.0);
        // 200 bins of 0.0025 in steps of ten, ten on either side of 0
        assert_eq!(few.len(), 20);
        assert!((ends[0] + 0.25).abs() < 1e-12 && (ends[1] - 0.25).abs() < 1e-12);
        assert_eq!([few[9], few[10], few[18]], [3.0, 5.0, 7.0]);
        let (ends, one) = joined([0.0, 1.0], &[1.0], [0.0, 1.0], 100.0);
        assert_eq!((ends, one), ([0.0, 1.0], vec![1.0]));
    }

    #[test]
    fn what_is_shown_holds_voxels_and_bands_on_both_sides_of_zero() {
        let mut counts = vec![0.0; 800];
        counts[520] = 1.0;
        let [low, high] = extent(&[panel(0.2, counts)]);
        // The bin ends at 0.3025
        assert!((high - 0.3025 - BESIDE * 0.5025).abs() < 1e-9 && low == -high);
        let empty = histograms("e", "x", &[panel(0.0, vec![0.0; 4])], "");
        assert!(!empty.contains("NaN") && !empty.contains("inf"), "{empty}");
    }

    #[test]
    fn each_panel_has_its_band_and_the_colors_are_named() {
        let panels = [panel(0.2, vec![1.0; 8]), panel(0.0, vec![2.0; 8])];
        let svg = histograms("m", "error", &panels, "");
        assert_eq!(svg.matches("class=\"band\"").count(), 2);
        assert_eq!(svg.matches("a &lt; b").count(), 2);
        assert!(svg.contains("teal: part · shaded: the band of the objective"));
    }
}
