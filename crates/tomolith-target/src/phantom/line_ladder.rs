//! Straight bars that narrow from one to the next: the finest line that still prints.
//!
//! `lines` bars along y, side by side along x, from `widest_mm` on the left to `narrowest_mm` on the right in equal steps
//! (by default 500, 400, 300, 200 and 100 µm), with gaps of `gap_mm`. Volume (sum of the widths)·size·height.
//!
//! ```
//! use tomolith_core::kind::Section;
//! use tomolith_target::{Placement, Shape, phantom::Phantom};
//! let section = Section::new("target.phantom", serde_json::json!("line_ladder"));
//! let part = Phantom::build(&section, &Placement::default(), "target").unwrap();
//! // 0.5 + 0.4 + 0.3 + 0.2 + 0.1 mm wide, 5 mm long, 1 mm high
//! assert!((part.volume_mm3().unwrap() - 1.5 * 5.0).abs() < 1e-12);
//! assert!((part.bounds_mm()[1][0] - (1.5 + 4.0 * 0.5) / 2.0).abs() < 1e-12); // and four gaps
//! ```

use super::{Body, BuildForm, Form, Prism, corners, positive, rectangle};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::error::{Error, Result};
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "line_ladder",
    summary: "Straight bars that narrow from one to the next",
    example: "[target]\nphantom.line_ladder = { size_mm = 5.0, height_mm = 1.0, lines = 5, widest_mm = 0.5, narrowest_mm = 0.1, gap_mm = 0.5 }",
    schema: schema_of::<Params>,
    build,
};

/// Parameters of the line ladder.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
struct Params {
    /// Length of the bars along y, mm (> 0)
    size_mm: Mm,
    /// Height along z, mm (> 0)
    height_mm: Mm,
    /// Number of bars (2 to 200)
    lines: u32,
    /// Width of the first bar, mm (> 0)
    widest_mm: Mm,
    /// Width of the last bar, mm (> 0)
    narrowest_mm: Mm,
    /// Gap between bars, mm (> 0)
    gap_mm: Mm,
}

impl Default for Params {
    fn default() -> Self {
        Params {
            size_mm: Mm(5.0),
            height_mm: Mm(1.0),
            lines: 5,
            widest_mm: Mm(0.5),
            narrowest_mm: Mm(0.1),
            gap_mm: Mm(0.5),
        }
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    positive(
        section,
        &[
            ("size_mm", p.size_mm),
            ("height_mm", p.height_mm),
            ("widest_mm", p.widest_mm),
            ("narrowest_mm", p.narrowest_mm),
            ("gap_mm", p.gap_mm),
        ],
    )?;
    if !(2..=200).contains(&p.lines) {
        let found = p.lines.to_string();
        return Err(Error::config("lines", found, "a number from 2 to 200").under(&section.path));
    }
    let steps = f64::from(p.lines - 1);
    let mut bars = Vec::new();
    let mut left = 0.0;
    for i in 0..p.lines {
        let width = p.widest_mm.0 + (p.narrowest_mm.0 - p.widest_mm.0) * f64::from(i) / steps;
        bars.push([left + width / 2.0, width / 2.0]);
        left += width + p.gap_mm.0;
    }
    let middle = (left - p.gap_mm.0) / 2.0;
    let (long, half) = (p.size_mm.0 / 2.0, p.height_mm.0 / 2.0);
    let widths: f64 = bars.iter().map(|bar| 2.0 * bar[1]).sum();
    let outline = move |p: [f64; 2]| {
        let each = bars
            .iter()
            .map(|[at, width]| rectangle(p, [at - middle, 0.0], [*width, long]));
        each.fold(f64::INFINITY, f64::min)
    };
    Ok(Form {
        body: Body::Prisms(vec![Prism {
            outline: Box::new(outline),
            z: [-half, half],
        }]),
        hull: corners([middle, long, half]),
        round: 0.0,
        volume_mm3: Some(widths * p.size_mm.0 * p.height_mm.0),
    })
}
