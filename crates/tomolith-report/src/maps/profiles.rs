//! Numbers along a length side by side, as one SVG file: those of the slices of several runs, over one scale.

use super::histograms::{SERIES, colors};
use super::placed;
use super::sheet::{Frame, LabelMargins, Sheet, Ticks, draw};
use crate::plot::{Axis, polyline};

/// Height of a panel, of its width.
const FLAT: f64 = 0.9;
/// Room above and below what is shown, of its extent.
const BESIDE: f64 = 0.04;

/// The curves of one run.
#[derive(Clone, Debug)]
pub struct ProfilePanel {
    /// What tells it from the others.
    pub title: String,
    /// Name, and points from left to right.
    pub series: Vec<(String, Vec<[f64; 2]>)>,
}

/// Curves side by side over one scale, as one SVG file; `caption` stands below them.
#[must_use]
pub fn profiles(title: &str, names: [&str; 2], panels: &[ProfilePanel], caption: &str) -> String {
    let axis = |i: usize, room: f64| {
        let curves = panels.iter().flat_map(|panel| &panel.series);
        let values = || curves.clone().flat_map(|(_, points)| points).map(|p| p[i]);
        let low = values().reduce(f64::min).unwrap_or(0.0);
        let high = values().reduce(f64::max).unwrap_or(1.0);
        // One slice is a point
        let room = match high > low {
            true => room * (high - low),
            false => 0.1 * low.abs().max(1.0),
        };
        Axis::linear(names[i], low - room, high + room)
    };
    let axes = [axis(0, 0.0), axis(1, BESIDE)];
    let mut sheet = Sheet::new(panels.len(), FLAT, 20.0, LabelMargins::new(0, 0));
    sheet.head(title, caption);
    for (i, panel) in panels.iter().enumerate() {
        let frame = sheet.frame(i);
        draw(&mut sheet.body, &frame, panel, &axes);
    }
    sheet.svg(title, &colors(panels.iter().map(|panel| &panel.series)))
}

fn draw(body: &mut String, frame: &Frame, panel: &ProfilePanel, [x, y]: &[Axis; 2]) {
    for ((_, points), (class, _)) in panel.series.iter().zip(SERIES.iter().cycle()) {
        let place = |&[at, value]: &[f64; 2]| [frame.x(x.place(at)), frame.y(y.place(value))];
        let path = polyline(points.iter().map(|point| Some(place(point))));
        draw!(
            body,
            "<path class=\"{class}\" style=\"fill:none\" d=\"{path}\"/>"
        );
        if let [point] = &points[..] {
            let [left, top] = place(point);
            draw!(
                body,
                "<circle class=\"{class}\" cx=\"{left:.1}\" cy=\"{top:.1}\" r=\"3\"/>"
            );
        }
    }
    frame.title(body, &panel.title);
    let below = Ticks::level(placed(x, (frame.width / 60.0) as usize));
    let left = placed(y, (frame.height / 30.0) as usize);
    frame.axes(body, [&x.label, &y.label], &below, &left);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_run_has_its_curves_over_the_scale_of_all() {
        let panel = |title: &str, high: f64| ProfilePanel {
            title: title.to_owned(),
            series: vec![
                ("pw".to_owned(), vec![[0.0, 0.0], [1.0, high]]),
                ("a < b".to_owned(), vec![[0.0, 0.5], [1.0, 0.5]]),
            ],
        };
        let panels = [panel("low", 1.0), panel("high", 2.0)];
        let svg = profiles("t", ["z, mm", "y"], &panels, "");
        assert_eq!(svg.matches("class=\"part\"").count(), 2);
        assert_eq!(svg.matches("class=\"void\"").count(), 2);
        assert!(svg.contains("teal: pw") && svg.contains("orange: a &lt; b"));
        // The lower curve ends half as high: 1 and 2 of a scale from −0.08 to 2.08
        let ends: Vec<f64> = svg
            .split("class=\"part\"")
            .skip(1)
            .filter_map(|part| part.split("d=\"M").nth(1)?.split('"').next())
            .filter_map(|path| {
                let tops = path
                    .split('L')
                    .map(|p| p.split(' ').nth(1)?.parse::<f64>().ok());
                let tops = tops.collect::<Option<Vec<_>>>()?;
                Some(tops[0] - tops[1])
            })
            .collect();
        assert!((ends[1] / ends[0] - 2.0).abs() < 0.01, "{ends:?}");
        let one = ProfilePanel {
            title: "one slice".to_owned(),
            series: vec![("pw".to_owned(), vec![[0.0, 0.1]])],
        };
        assert!(profiles("t", ["z, mm", "y"], &[one], "").contains("<circle class=\"part\""));
    }
}
