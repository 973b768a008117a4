//! A Siemens star: spokes that narrow toward the middle, for the finest detail that still prints.
//!
//! Spokes and gaps have equal angles, π/spokes each; at radius r a spoke is π·r/spokes wide. A disc in the middle holds
//! them together. Volume: (area of the hub + half of the ring)·height.

use super::wheel::Wheel;
use super::{BuildForm, Form, refused, rims};
use std::f64::consts::PI;
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "siemens_star",
    summary: "Spokes that narrow toward the middle, for the finest detail that still prints",
    example: "[target]\nphantom.siemens_star = { size_mm = 6.0, height_mm = 1.5, spokes = 16, hub_mm = 1.0 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the Siemens star.
    struct Params {
        /// Diameter, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(6.0),
        /// Height along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(1.5),
        /// Number of spokes
        #[schemars(range(min = 2, max = 500))]
        spokes: u32 = 16,
        /// Diameter of the disc in the middle, mm (less than `size_mm`)
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        hub_mm: Mm = Mm(1.0),
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    if p.hub_mm >= p.size_mm {
        let found = format!("{} in a star of {}", p.hub_mm, p.size_mm);
        return refused(section, "hub_mm", found, "a diameter below `size_mm`");
    }
    let half_spoke = PI / f64::from(p.spokes) / 2.0;
    let wheel = Wheel {
        count: p.spokes,
        root: p.hub_mm.0 / 2.0,
        tip: p.size_mm.0 / 2.0,
        root_angle: half_spoke,
        tip_angle: half_spoke,
    };
    let half = p.height_mm.0 / 2.0;
    Ok(Form::upright(
        move |p| wheel.distance(p),
        half,
        rims(wheel.tip, [-half, half]),
        Some(wheel.area() * 2.0 * half),
    ))
}
