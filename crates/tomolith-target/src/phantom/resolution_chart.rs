//! A resolution chart after USAF 1951 in a square frame: groups of three bars, along x and along y, that shrink.
//!
//! Two columns of six elements; element i (0 … 11) has bars w·2^(−i/6) wide, five times as long, as far apart as wide, one
//! group lying and one standing; below the smaller column a solid square of 5·w. w is 0.0262 of the size, so that the
//! bars run from 0.131 to 0.0367 mm in a chart of 5 mm, and the frame is 0.04 of the size wide. Volume: of all bars,
//! the square and the frame.

use super::{BuildForm, Form, corners, rectangle};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "resolution_chart",
    summary: "Groups of bars that shrink, in a square frame (after USAF 1951)",
    example: "[target]\nphantom.resolution_chart = { size_mm = 5.0, height_mm = 1.0 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the resolution chart.
    struct Params {
        /// Edge of the frame, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Height along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(1.0),
    }
}

/// Width of the widest bar, and of the frame, in a chart of size 1.
const WIDEST: f64 = 0.0262;
const FRAME: f64 = 0.04;

/// Elements per column.
const ROWS: u32 = 6;

/// A rectangle: its middle and half its edges.
type Bar = ([f64; 2], [f64; 2]);

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    let (size, half) = (p.size_mm.0, p.height_mm.0 / 2.0);
    let bars = bars();
    let area: f64 =
        bars.iter().map(|(_, [a, b])| 4.0 * a * b).sum::<f64>() + 4.0 * FRAME * (1.0 - FRAME);
    let outline = move |p: [f64; 2]| {
        let p = p.map(|v| v / size);
        let frame = rectangle(p, [0.0; 2], [0.5; 2]).max(-rectangle(p, [0.0; 2], [0.5 - FRAME; 2]));
        let each = bars
            .iter()
            .map(|&(middle, half)| rectangle(p, middle, half));
        size * each.fold(frame, f64::min)
    };
    Ok(Form::upright(
        outline,
        half,
        corners([size / 2.0, size / 2.0, half]),
        Some(area * size * size * p.height_mm.0),
    ))
}

/// All bars and the square, in a chart of size 1.
fn bars() -> Vec<Bar> {
    let mut bars = Vec::new();
    let width = |i: u32| WIDEST * (-f64::from(i) / 6.0).exp2();
    let mut top = 0.0;
    for (column, left) in [(0, -0.36), (1, 0.1)] {
        top = 0.42;
        for i in column * ROWS..(column + 1) * ROWS {
            let w = width(i);
            for k in 0..3 {
                let along = f64::from(2 * k) * w + w / 2.0;
                bars.push(([left + 2.5 * w, top - along], [2.5 * w, w / 2.0]));
                bars.push(([left + 7.0 * w + along, top - 2.5 * w], [w / 2.0, 2.5 * w]));
            }
            top -= 7.0 * w;
        }
    }
    bars.push(([0.1 + 2.5 * WIDEST, top - 2.5 * WIDEST], [2.5 * WIDEST; 2]));
    bars
}
