//! Four equal square posts at growing distance from the axis: how sharp a small feature stays there.
//!
//! In a circle of diameter `size`, posts of edge `post` whose upper left corners lie on the axis, at half the radius in
//! the third quadrant (−x, −y), and at 0.5 and 0.9 of the radius in the second (−x, +y), on the diagonals: the impulse
//! responses of the dual-color paper's supplement (Wang 2022, Note 3). Volume 4·post²·height. The box is that of the
//! circle, so that the first corner stays on the axis.
//!
//! ```
//! use tomolith_core::kind::Section;
//! use tomolith_target::{Placement, Shape, phantom::Phantom};
//! let section = Section::new("target.phantom", serde_json::json!("square_posts"));
//! let part = Phantom::build(&section, &Placement::default(), "target").unwrap();
//! assert!((part.volume_mm3().unwrap() - 4.0 * 0.2f64.powi(2)).abs() < 1e-12); // 0.2 mm wide, 1 mm high
//! ```

use super::{Body, BuildForm, Form, Prism, positive, rectangle, rims};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_1_SQRT_2;
use tomolith_core::error::{Error, Result};
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "square_posts",
    summary: "Four square posts at growing distance from the axis",
    example: "[target]\nphantom.square_posts = { size_mm = 10.0, height_mm = 1.0, post_mm = 0.2 }",
    schema: schema_of::<Params>,
    build,
};

/// Parameters of the square posts.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
struct Params {
    /// Diameter of the circle, mm (> 0)
    size_mm: Mm,
    /// Height along z, mm (> 0)
    height_mm: Mm,
    /// Edge of a post, mm (> 0, at most an eighth of `size_mm`)
    post_mm: Mm,
}

impl Default for Params {
    fn default() -> Self {
        Params {
            size_mm: Mm(10.0),
            height_mm: Mm(1.0),
            post_mm: Mm(0.2),
        }
    }
}

/// Upper left corners in units of the radius: on the axis, and on the diagonals.
const CORNERS: [[f64; 2]; 4] = [
    [0.0, 0.0],
    [-0.5 * FRAC_1_SQRT_2, -0.5 * FRAC_1_SQRT_2],
    [-0.5 * FRAC_1_SQRT_2, 0.5 * FRAC_1_SQRT_2],
    [-0.9 * FRAC_1_SQRT_2, 0.9 * FRAC_1_SQRT_2],
];

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    positive(
        section,
        &[
            ("size_mm", p.size_mm),
            ("height_mm", p.height_mm),
            ("post_mm", p.post_mm),
        ],
    )?;
    // Then the two outer posts on one diagonal do not touch
    if p.post_mm.0 > 0.125 * p.size_mm.0 {
        let found = format!("{} in a circle of {}", p.post_mm, p.size_mm);
        return Err(
            Error::config("post_mm", found, "at most an eighth of `size_mm`").under(&section.path),
        );
    }
    let [radius, half, post] = [p.size_mm, p.height_mm, p.post_mm].map(|mm| mm.0 / 2.0);
    let outline = move |p: [f64; 2]| {
        let posts = CORNERS
            .iter()
            .map(|[x, y]| rectangle(p, [x * radius + post, y * radius - post], [post; 2]));
        posts.fold(f64::INFINITY, f64::min)
    };
    Ok(Form {
        body: Body::Prisms(vec![Prism {
            outline: Box::new(outline),
            z: [-half, half],
        }]),
        hull: rims(radius, [-half, half]),
        round: 0.0,
        volume_mm3: Some(4.0 * p.post_mm.0.powi(2) * p.height_mm.0),
    })
}
