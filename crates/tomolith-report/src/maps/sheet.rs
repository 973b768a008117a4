//! The sheet of a picture of many runs: its panels side by side, the frame of each, title, caption and marks.

use crate::number::escape;

/// Adds an element, whose text is formatted, to a picture.
macro_rules! draw {
    ($body:expr, $($text:tt)+) => {{
        use std::fmt::Write as _;
        // Writing into a string cannot fail
        let _ = write!($body, $($text)+);
    }};
}
pub(super) use draw;

/// Width and height of a panel's drawing, alone and among others.
const ALONE: [f64; 2] = [460.0, 400.0];
const AMONG: [f64; 2] = [230.0, 200.0];
/// Room round a panel: left and below, where labels are short; above.
const LEFT: f64 = 76.0;
const BELOW: f64 = 62.0;
const ABOVE: f64 = 34.0;
/// Room of a label's letter; between a panel and its name, around labels on the left and below it.
pub(super) const GLYPH: f64 = 7.0;
const NAME_LEFT: f64 = 36.0;
const NAME_BELOW: f64 = 42.0;
/// Room above all, and for a line below.
const HEAD: f64 = 34.0;
const FOOT: f64 = 30.0;
/// Panels in a row.
const ROW: usize = 4;

const STYLE: &str = "<style>text{font:13px Inter,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif;fill:#16202b}\
    .title{font-size:16px;font-weight:600}.small{font-size:11.5px}.muted{fill:#5a6775}.frame{fill:none;stroke:#8b96a2}\
    .grid{stroke:#e1e6eb}.line{fill:none;stroke:#0f6f7c;stroke-width:1.8}.dot{fill:#0f6f7c}.out{fill:#fff;stroke:#0f6f7c;stroke-width:1.4}\
    .halo{fill:none;stroke:#fff;stroke-width:4.5;stroke-linecap:square}.edge{fill:none;stroke:#d64550;stroke-width:2;stroke-linecap:square}\
    .under{fill:none;stroke:#fff;stroke-width:3;stroke-opacity:.65}.guide{fill:none;stroke:#16202b;stroke-width:1.8}\
    .best{fill:none;stroke:#fff;stroke-width:5}.ring{fill:none;stroke:#16202b;stroke-width:2.2}.failed{fill:#c9d0d7}\
    .cross{stroke:#5a6775;stroke-width:1.4}\
    .band{fill:#5a6775;fill-opacity:.18}.part,.void,.third,.fourth{fill-opacity:.3;stroke-width:1.2}.part{fill:#0f8b8d;stroke:#0f8b8d}\
    .void{fill:#d9822b;stroke:#d9822b}.third{fill:#8457c9;stroke:#8457c9}.fourth{fill:#d64550;stroke:#d64550}</style>";

/// Where a panel is drawn.
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
    margins: LabelMargins,
}

/// Margins for labels left of panels and below them.
#[derive(Clone, Copy)]
pub(super) struct LabelMargins {
    pub(super) left: f64,
    pub(super) below: f64,
}

impl LabelMargins {
    /// For labels of so many letters on the left, and so many that stand upright below.
    pub(super) fn new(left: usize, below: usize) -> Self {
        LabelMargins {
            left: LEFT.max(NAME_LEFT + GLYPH * left as f64),
            below: BELOW.max(NAME_BELOW + GLYPH * below as f64),
        }
    }
}

/// Labels at parts of the lower edge of a panel.
pub(super) struct Ticks {
    pub(super) labels: Vec<(f64, String)>,
    /// Whether they are written upwards, for they are long.
    pub(super) are_upright: bool,
}

impl Ticks {
    pub(super) fn level(labels: Vec<(f64, String)>) -> Self {
        let are_upright = false;
        Ticks {
            labels,
            are_upright,
        }
    }
}

impl Frame {
    pub(super) fn x(&self, part: f64) -> f64 {
        self.left + part * self.width
    }

    pub(super) fn y(&self, part: f64) -> f64 {
        self.top + (1.0 - part) * self.height
    }

    /// Its outline, ticks at parts of its edges, and the names of both.
    pub(super) fn axes(&self, body: &mut String, names: [&str; 2], x: &Ticks, y: &[(f64, String)]) {
        let (bottom, right) = (self.top + self.height, self.left + self.width);
        let name_below = bottom
            + if x.are_upright {
                self.margins.below - 25.0
            } else {
                37.0
            };
        for (part, label) in &x.labels {
            let (at, label) = (self.x(*part), escape(label));
            draw!(body, "<path class=\"frame\" d=\"M{at:.1} {bottom:.1}v4\"/>");
            let place = match x.are_upright {
                true => format!(
                    "transform=\"translate({:.1} {:.1}) rotate(-90)\" text-anchor=\"end\"",
                    at + 4.0,
                    bottom + 8.0
                ),
                false => format!(
                    "x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\"",
                    bottom + 17.0
                ),
            };
            draw!(body, "<text class=\"small\" {place}>{label}</text>");
        }
        for (part, label) in y {
            let at = self.y(*part);
            draw!(
                body,
                "<path class=\"frame\" d=\"M{:.1} {at:.1}h4\"/><text class=\"small\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                self.left - 4.0,
                self.left - 8.0,
                at + 4.0,
                escape(label)
            );
        }
        let (middle, upright) = (
            f64::midpoint(self.left, right),
            f64::midpoint(self.top, bottom),
        );
        draw!(
            body,
            "<rect class=\"frame\" x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\"/>\
             <text x=\"{middle:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>\
             <text transform=\"translate({:.1} {upright:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            self.left,
            self.top,
            self.width,
            self.height,
            name_below,
            escape(names[0]),
            self.left - self.margins.left + 20.0,
            escape(names[1])
        );
    }

    pub(super) fn title(&self, body: &mut String, title: &str) {
        let x = self.left + 0.5 * self.width;
        let title = shortened(title, ((self.width + LEFT - 10.0) / GLYPH) as usize);
        draw!(
            body,
            "<text class=\"small\" x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            self.top - 8.0,
            escape(&title)
        );
    }
}

/// A text of at most so many letters: what is left out is in the middle, since many names begin alike.
pub(super) fn shortened(text: &str, most: usize) -> String {
    let letters: Vec<char> = text.chars().collect();
    if letters.len() <= most {
        return text.to_owned();
    }
    let room = most.saturating_sub(1);
    let (head, tail) = (room.div_ceil(2), room / 2);
    let tail = &letters[letters.len() - tail..];
    letters[..head].iter().chain(&['…']).chain(tail).collect()
}

/// Width and height of one of so many panels.
pub(super) fn panel_size(panels: usize) -> [f64; 2] {
    if panels == 1 { ALONE } else { AMONG }
}

/// Width of a letter of a caption, about.
const LETTER: f64 = 6.5;

/// A text in lines of at most so many letters, but for longer words.
fn wrapped(text: &str, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The whole picture.
pub(super) struct Sheet {
    pub(super) columns: usize,
    rows: usize,
    panel: [f64; 2],
    margins: LabelMargins,
    /// Room on the right.
    right: f64,
    pub(super) body: String,
    lines: usize,
}

impl Sheet {
    pub(super) fn new(panels: usize, flat: f64, right: f64, margins: LabelMargins) -> Self {
        let columns = panels.clamp(1, ROW);
        let [width, height] = panel_size(panels);
        Sheet {
            columns,
            rows: panels.div_ceil(columns).max(1),
            panel: [width, flat * height],
            margins,
            right,
            body: String::new(),
            lines: 0,
        }
    }

    fn width(&self) -> f64 {
        self.columns as f64 * (self.margins.left + self.panel[0]) + self.right
    }

    fn size(&self) -> [f64; 2] {
        let height = self.panel[1];
        let foot = (1 + self.lines) as f64 * FOOT;
        [
            self.width(),
            HEAD + self.rows as f64 * (ABOVE + height + self.margins.below) + foot,
        ]
    }

    pub(super) fn frame(&self, i: usize) -> Frame {
        let ([width, height], column, row) = (self.panel, i % self.columns, i / self.columns);
        let LabelMargins { left, below } = self.margins;
        Frame {
            left: left + column as f64 * (left + width),
            top: HEAD + ABOVE + row as f64 * (ABOVE + height + below),
            width,
            height,
            margins: self.margins,
        }
    }

    pub(super) fn head(&mut self, title: &str, caption: &str) {
        let lines = wrapped(caption, ((self.width() - 32.0) / LETTER) as usize);
        self.lines = lines.len();
        let [_, height] = self.size();
        draw!(
            self.body,
            "<text class=\"title\" x=\"16\" y=\"28\">{}</text>",
            escape(title)
        );
        for (line, below) in lines.iter().rev().zip(1..) {
            let y = height - f64::from(below) * FOOT - 12.0;
            draw!(
                self.body,
                "<text class=\"small\" x=\"16\" y=\"{y:.1}\">{}</text>",
                escape(line)
            );
        }
    }

    /// The file, with what its marks mean in one line below all.
    pub(super) fn svg(&self, title: &str, marks: &[Option<String>]) -> String {
        let [width, height] = self.size();
        let marks: Vec<&str> = marks.iter().flatten().map(String::as_str).collect();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" viewBox=\"0 0 {width:.0} {height:.0}\" \
             role=\"img\" aria-label=\"{}\">{STYLE}<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>{}\
             <text class=\"small muted\" x=\"16\" y=\"{:.1}\">{}</text></svg>\n",
            escape(title),
            self.body,
            height - 12.0,
            escape(&marks.join(" · "))
        )
    }
}
