//! A ring, or, high, a tube: the simplest part that light has to leave dark inside.
//!
//! `hole/2 < √(x² + y²) < size/2, |z| < height/2`; volume π·(size² − hole²)/4·height.

use super::{BuildForm, Form, refused, rims};
use std::f64::consts::PI;
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "ring",
    summary: "A ring; high, a tube",
    example: "[target]\nphantom.ring = { size_mm = 5.0, height_mm = 3.0, hole_mm = 3.0 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the ring.
    struct Params {
        /// Outer diameter, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Height along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(3.0),
        /// Inner diameter, mm (less than `size_mm`)
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        hole_mm: Mm = Mm(3.0),
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    if p.hole_mm >= p.size_mm {
        let found = format!("{} in a ring of {}", p.hole_mm, p.size_mm);
        return refused(section, "hole_mm", found, "a diameter below `size_mm`");
    }
    let [outer, half, inner] = [p.size_mm, p.height_mm, p.hole_mm].map(|mm| mm.0 / 2.0);
    let (middle, width) = ((outer + inner) / 2.0, (outer - inner) / 2.0);
    Ok(Form::upright(
        move |[x, y]| (x.hypot(y) - middle).abs() - width,
        half,
        rims(outer, [-half, half]),
        Some(PI * (outer * outer - inner * inner) * 2.0 * half),
    ))
}
