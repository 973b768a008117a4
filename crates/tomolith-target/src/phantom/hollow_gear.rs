//! A gear as a shell: a wall that follows the teeth, open above, with or without a floor.
//!
//! The outline is that of the [gear](super::gear) with its default proportions; what lies farther than `wall_mm` inside it
//! is hollow, above a floor of `floor_mm`. Concave corners, thin walls and an inside that light must cross without curing
//! it come together in it. No closed form of the volume: the inner outline has round corners.
//!
//! ```
//! use tomolith_core::kind::Section;
//! use tomolith_target::{Placement, Shape, phantom::Phantom};
//! let section = Section::new("target.phantom", serde_json::json!("hollow_gear"));
//! let part = Phantom::build(&section, &Placement::default(), "target").unwrap();
//! assert_eq!(part.bounds_mm()[1][2], 1.5); // 3 mm high
//! let grid = tomolith_core::grid::VolumeGrid::centered([3, 1, 1], 1.0);
//! let middle = part.sample(&grid).unwrap().values;
//! assert!((middle[0] - 0.5).abs() < 1e-6 && middle[2] == 0.0); // a floor of 0.5 mm, and nothing above it
//! ```

use super::gear::spur_gear;
use super::{Body, BuildForm, Form, Prism, refused, rims};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::{Mm, concise};

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "hollow_gear",
    summary: "A gear as a thin shell, open above",
    example: "[target]\nphantom.hollow_gear = { size_mm = 6.0, height_mm = 3.0, teeth = 12, wall_mm = 0.25, floor_mm = 0.5 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the hollow gear.
    struct Params {
        /// Diameter over the tips of the teeth, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(6.0),
        /// Height along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(3.0),
        /// Number of teeth
        #[schemars(range(min = 4, max = 500))]
        teeth: u32 = 12,
        /// Thickness of the wall, mm (less than the radius of the root circle)
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        wall_mm: Mm = Mm(0.25),
        /// Thickness of the floor, mm (less than `height_mm`); 0 leaves it open below too
        #[schemars(extend("minimum" = 0.0))]
        floor_mm: Mm = Mm(0.5),
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    let wheel = spur_gear(p.size_mm, p.teeth);
    if p.wall_mm.0 >= wheel.root {
        let accepted = format!(
            "less than the root circle's radius, {} mm",
            concise(wheel.root)
        );
        return refused(section, "wall_mm", p.wall_mm, accepted);
    }
    if p.floor_mm >= p.height_mm {
        let accepted = "0, or less than `height_mm`";
        return refused(section, "floor_mm", p.floor_mm, accepted);
    }
    let (tip, wall, half) = (wheel.tip, p.wall_mm.0, p.height_mm.0 / 2.0);
    let shell = move |p| {
        let d = wheel.distance(p);
        d.max(-d - wall)
    };
    let mut prisms = vec![Prism {
        outline: Box::new(shell),
        z: [-half, half],
    }];
    if p.floor_mm.0 > 0.0 {
        prisms.push(Prism {
            outline: Box::new(move |p| wheel.distance(p)),
            z: [-half, p.floor_mm.0 - half],
        });
    }
    Ok(Form {
        body: Body::Prisms(prisms),
        hull: rims(tip, [-half, half]),
        round: 0.0,
        volume_mm3: None,
    })
}
