//! A checkerboard: solid and open squares in turn, half of the material.
//!
//! `cells` × `cells` squares, the one at the lower left solid; volume (half of the squares, rounded up)·(size/cells)²·
//! height. Solid squares touch at their corners only.

use super::{BuildForm, Form, corners, rectangle};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "checkerboard",
    summary: "Solid and open squares in turn",
    example: "[target]\nphantom.checkerboard = { size_mm = 5.0, height_mm = 1.0, cells = 5 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the checkerboard.
    struct Params {
        /// Edge of the board, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Height along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(1.0),
        /// Squares along an edge
        #[schemars(range(min = 1, max = 1000))]
        cells: u32 = 5,
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    let (edge, half) = (p.size_mm.0 / 2.0, p.height_mm.0 / 2.0);
    let cell = p.size_mm.0 / f64::from(p.cells);
    let solid = f64::from((p.cells * p.cells).div_ceil(2));
    let last = f64::from(p.cells - 1);
    let outline = move |p: [f64; 2]| {
        // Beyond the board the squares at its rim go on; its own edge is the rectangle's
        let at = p.map(|v| (v + edge) / cell);
        let odd: f64 = at.map(|v| v.floor().clamp(0.0, last)).into_iter().sum();
        let to_line = at.map(|v| (v - v.round().clamp(1.0, last.max(1.0))).abs());
        let to_line = to_line[0].min(to_line[1]) * cell;
        let squares = match (last > 0.0, odd.rem_euclid(2.0) > 0.5) {
            (false, _) => f64::NEG_INFINITY,
            (true, true) => to_line,
            (true, false) => -to_line,
        };
        squares.max(rectangle(p, [0.0; 2], [edge; 2]))
    };
    Ok(Form::upright(
        outline,
        half,
        corners([edge, edge, half]),
        Some(solid * cell * cell * p.height_mm.0),
    ))
}
