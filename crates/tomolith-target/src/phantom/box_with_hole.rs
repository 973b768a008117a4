//! A square plate or block with a round hole along z, through its middle or aside along x.
//!
//! `|x|, |y| < size/2, |z| < height/2, √((x − hole_x)² + y²) > hole/2`; volume (size² − π·hole²/4)·height. A hole is what light from
//! the side can hardly spare: the hardest simple test of contrast.

use super::{BuildForm, Form, corners, rectangle, refused};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "box_with_hole",
    summary: "A square block with a round hole along z",
    example: "[target]\nphantom.box_with_hole = { size_mm = 5.0, height_mm = 3.0, hole_mm = 2.0 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the box with a hole.
    struct Params {
        /// Edge along x and y, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Height along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(3.0),
        /// Diameter of the hole, mm (less than `size_mm`)
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        hole_mm: Mm = Mm(2.0),
        /// Where along x its middle is, mm; the hole stays within the block
        hole_x_mm: Mm = Mm(0.0),
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    if p.hole_mm >= p.size_mm {
        let found = format!("{} in a block of {}", p.hole_mm, p.size_mm);
        return refused(section, "hole_mm", found, "a diameter below `size_mm`");
    }
    let x = p.hole_x_mm.0;
    if !x.is_finite() || 2.0 * x.abs() + p.hole_mm.0 > p.size_mm.0 {
        let found = format!(
            "a hole of {} at {} in a block of {}",
            p.hole_mm, p.hole_x_mm, p.size_mm
        );
        return refused(section, "hole_x_mm", found, "a place within the block");
    }
    let [edge, half, radius] = [p.size_mm, p.height_mm, p.hole_mm].map(|mm| mm.0 / 2.0);
    let area = 4.0 * edge * edge - std::f64::consts::PI * radius * radius;
    Ok(Form::upright(
        move |p| rectangle(p, [0.0; 2], [edge; 2]).max(radius - (p[0] - x).hypot(p[1])),
        half,
        corners([edge, edge, half]),
        Some(area * 2.0 * half),
    ))
}
