//! A part that differs from its mirror image, whichever way it is turned: it shows mistakes of handedness.
//!
//! A plate in the shape of the letter F, readable from above (+z), with the foot of its stem twice as high as the rest. Seen
//! from above, the stem stands on the left (−x) and the bars point right (+x), the upper bar at +y. In a box of width
//! 0.75·size along x and `size` along y: stem 0.25·size wide; upper bar 0.75·size long, lower bar 0.55·size, both
//! 0.2·size wide; the foot is the lowest 0.3·size of the stem.
//!
//! ```
//! use tomolith_core::kind::Section;
//! use tomolith_target::{Placement, Shape, phantom::Phantom};
//! use tomolith_core::grid::VolumeGrid;
//! let section = Section::new("target.phantom", serde_json::json!("chiral"));
//! let part = Phantom::build(&section, &Placement::default(), "target").unwrap();
//! let voxels = part.sample(&VolumeGrid::centered([4, 4, 4], 1.2)).unwrap();
//! assert!((voxels.at(1, 3, 2) - 0.75).abs() < 1e-6); // the upper bar: y from 1.5 in a voxel from 1.2 to 2.4
//! assert_eq!(*voxels.at(2, 3, 2), 0.0); // nothing stands on it
//! assert!(*voxels.at(2, 0, 0) > 0.5); // the foot is high
//! ```

use super::{Body, BuildForm, Form, Prism, corners, rectangle};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "chiral",
    summary: "A plate like the letter F with a raised foot: shows mistakes of handedness",
    example: "[target]\nphantom.chiral = { size_mm = 5.0, height_mm = 3.0 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the chiral part.
    struct Params {
        /// Length of the F along y, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Height of the foot along z, mm; the rest is half as high
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(3.0),
    }
}

/// Rectangles `[x0, y0, x1, y1]` in units of the size, the middle of the F's box at the origin.
const STEM: [f64; 4] = [-0.375, -0.5, -0.125, 0.5];
const UPPER: [f64; 4] = [-0.375, 0.3, 0.375, 0.5];
const LOWER: [f64; 4] = [-0.375, -0.05, 0.175, 0.15];
const FOOT: [f64; 4] = [-0.375, -0.5, -0.125, -0.2];

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    let (size, half) = (p.size_mm.0, p.height_mm.0 / 2.0);
    let letter = move |p| {
        let each = [STEM, UPPER, LOWER].map(|r| to_rectangle(p, r, size));
        each.into_iter().fold(f64::INFINITY, f64::min)
    };
    // The bars without what they share with the stem
    let area = 0.25 * 1.0 + 0.5 * 0.2 + 0.3 * 0.2;
    let foot = 0.25 * 0.3;
    Ok(Form {
        body: Body::Prisms(vec![
            Prism {
                outline: Box::new(letter),
                z: [-half, 0.0],
            },
            Prism {
                outline: Box::new(move |p| to_rectangle(p, FOOT, size)),
                z: [-half, half],
            },
        ]),
        hull: corners([0.375 * size, 0.5 * size, half]),
        round: 0.0,
        volume_mm3: Some((area + foot) * size * size * half),
    })
}

fn to_rectangle(p: [f64; 2], [x0, y0, x1, y1]: [f64; 4], size: f64) -> f64 {
    let center = [(x0 + x1) / 2.0 * size, (y0 + y1) / 2.0 * size];
    rectangle(p, center, [(x1 - x0) / 2.0 * size, (y1 - y0) / 2.0 * size])
}
