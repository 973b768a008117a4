//! A ball.
//!
//! `√(x² + y² + z²) < size/2`; volume π·size³/6.

use super::{Body, BuildForm, Form};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "sphere",
    summary: "A ball",
    example: "[target]\nphantom.sphere = { size_mm = 5.0 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the sphere.
    struct Params {
        /// Diameter, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    let radius = p.size_mm.0 / 2.0;
    Ok(Form {
        body: Body::Solid(Box::new(move |[x, y, z]| {
            (x * x + y * y + z * z).sqrt() - radius
        })),
        hull: vec![[0.0; 3]],
        round: radius,
        volume_mm3: Some(4.0 / 3.0 * std::f64::consts::PI * radius.powi(3)),
    })
}
