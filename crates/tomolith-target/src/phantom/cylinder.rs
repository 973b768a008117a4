//! A cylinder upright on its end, or, flat, a disc.
//!
//! `√(x² + y²) < size/2, |z| < height/2`; volume π·size²/4·height.

use super::{BuildForm, Form, rims};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "cylinder",
    summary: "A cylinder upright on its end; flat, a disc",
    example: "[target]\nphantom.cylinder = { size_mm = 5.0, height_mm = 3.0 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the cylinder.
    struct Params {
        /// Diameter, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Height along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(3.0),
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    let (radius, half) = (p.size_mm.0 / 2.0, p.height_mm.0 / 2.0);
    Ok(Form::upright(
        move |[x, y]| x.hypot(y) - radius,
        half,
        rims(radius, [-half, half]),
        Some(std::f64::consts::PI * radius * radius * 2.0 * half),
    ))
}
