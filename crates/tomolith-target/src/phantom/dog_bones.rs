//! Tensile test bars side by side, lying flat: narrow necks between wide grips.
//!
//! Bars along x with the proportions of ASTM D638 type V: of the length, the grips are 0.1501 wide, the neck 0.0501 over
//! 0.1501, and fillets of radius 0.2 lead from the one to the other. Volume: of each bar the rectangle less what neck and
//! fillets leave out.

use super::{BuildForm, Form, corners, rectangle};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "dog_bones",
    summary: "Tensile test bars side by side, lying flat",
    example: "[target]\nphantom.dog_bones = { size_mm = 5.0, height_mm = 1.0, count = 3 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the dog-bones.
    struct Params {
        /// Length of a bar along x, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Thickness along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(1.0),
        /// Number of bars; the gaps are as wide as the grips
        #[schemars(range(min = 1, max = 100))]
        count: u32 = 3,
    }
}

/// ASTM D638 type V, as shares of the length of 63.5 mm.
const GRIP: f64 = 9.53 / 63.5;
const NECK: f64 = 3.18 / 63.5;
const NECK_LENGTH: f64 = 9.53 / 63.5;
const FILLET: f64 = 12.7 / 63.5;

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    let (length, half) = (p.size_mm.0, p.height_mm.0 / 2.0);
    let pitch = 2.0 * GRIP * length;
    let first = -pitch * f64::from(p.count - 1) / 2.0;
    let last = f64::from(p.count - 1);
    let outline = move |[x, y]: [f64; 2]| {
        // The two bars that may be nearest
        let place = ((y - first) / pitch).floor();
        let bar = |i: f64| {
            length
                * bar([
                    x / length,
                    (y - first - i.clamp(0.0, last) * pitch) / length,
                ])
        };
        bar(place).min(bar(place + 1.0))
    };
    Ok(Form::upright(
        outline,
        half,
        corners([length / 2.0, GRIP * length / 2.0 - first, half]),
        Some(f64::from(p.count) * bar_area() * length * length * p.height_mm.0),
    ))
}

/// Signed distance to a bar of length 1 about the origin.
fn bar([x, y]: [f64; 2]) -> f64 {
    // One quarter stands for all: the neck above and two discs are left out of a rectangle
    let [x, y] = [x.abs(), y.abs()];
    let bar = rectangle([x, y], [0.0; 2], [0.5, GRIP / 2.0]);
    let above_neck = (x - NECK_LENGTH / 2.0).max(NECK / 2.0 - y);
    let disc = (x - NECK_LENGTH / 2.0).hypot(y - NECK / 2.0 - FILLET) - FILLET;
    bar.max(-above_neck.min(disc))
}

/// Area of a bar of length 1.
fn bar_area() -> f64 {
    let rise = (GRIP - NECK) / 2.0;
    let run = (FILLET * FILLET - (FILLET - rise).powi(2)).sqrt();
    // Between the grip's edge and a fillet: ∫ (rise − R + √(R² − x²)) dx from 0 to the run
    let fillet = (rise - FILLET) * run
        + (run * (FILLET - rise) + FILLET * FILLET * (run / FILLET).asin()) / 2.0;
    GRIP - 2.0 * NECK_LENGTH * rise - 4.0 * fillet
}
