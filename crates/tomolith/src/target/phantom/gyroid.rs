//! A cube of gyroid: a curved wall that splits space into two labyrinths.
//!
//! With k = 2π·cells/size, g = sin kx·cos ky + sin ky·cos kz + sin kz·cos kx vanishes in the middle of the wall; solid is
//! |g| < 0.75·k·wall inside the cube. |∇g| lies between 1.2·k and √3·k on the surface (its largest value anywhere is
//! √3·k), 1.5·k on average, so the wall is `wall_mm` thick on average, 0.87 to 1.25 of it from place to place.
//!
//! ```
//! use tomolith::{kind::Section, target::{Placement, Shape, phantom::Phantom}};
//! let section = Section::new("target.phantom", serde_json::json!("gyroid"));
//! let cube = Phantom::build(&section, &Placement::default(), "target").unwrap();
//! assert_eq!(cube.bounds_mm(), [[-2.5; 3], [2.5; 3]]); // 5 mm edges
//! assert_eq!(cube.volume_mm3(), None); // no closed form
//! ```

use super::waves::wave;
use super::{Body, BuildForm, Form, corners, cuboid, positive};
use crate::error::{Error, Result};
use crate::kind::{Kind, Section};
use crate::units::Mm;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "gyroid",
    summary: "A cube of gyroid: a curved wall that splits space into two labyrinths",
    example: "[target]\nphantom.gyroid = { size_mm = 5.0, cells = 2, wall_mm = 0.5 }",
    schema: || schemars::schema_for!(Params),
    build,
};

/// Parameters of the gyroid.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
struct Params {
    /// Edge of the cube, mm (> 0)
    size_mm: Mm,
    /// Periods along an edge (1 to 100)
    cells: u32,
    /// Mean thickness of the wall, mm (> 0, at most a fifth of a period)
    wall_mm: Mm,
}

impl Default for Params {
    fn default() -> Self {
        Params {
            size_mm: Mm(5.0),
            cells: 2,
            wall_mm: Mm(0.5),
        }
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    positive(section, &[("size_mm", p.size_mm), ("wall_mm", p.wall_mm)])?;
    if !(1..=100).contains(&p.cells) {
        let found = p.cells.to_string();
        return Err(Error::config("cells", found, "a number from 1 to 100").under(&section.path));
    }
    let period = p.size_mm.0 / f64::from(p.cells);
    if p.wall_mm.0 > period / 5.0 {
        let found = format!("{} mm with a period of {period} mm", p.wall_mm.0);
        return Err(
            Error::config("wall_mm", found, "at most a fifth of a period").under(&section.path),
        );
    }
    let half = p.size_mm.0 / 2.0;
    let turns = 1.0 / period;
    let k = TAU * turns;
    let level = 0.75 * k * p.wall_mm.0;
    let steepest = 1.0 / (k * 3f64.sqrt());
    Ok(Form {
        body: Body::Solid(Box::new(move |point| {
            let [x, y, z] = point;
            let ((sx, cx), (sy, cy), (sz, cz)) =
                (wave(x * turns), wave(y * turns), wave(z * turns));
            let g = sx * cy + sy * cz + sz * cx;
            let wall = (g.abs() - level) * steepest;
            let cube = cuboid(point, [half; 3]);
            wall.max(cube)
        })),
        hull: corners([half; 3]),
        round: 0.0,
        volume_mm3: None,
    })
}
