//! A spur gear with a bore.
//!
//! Tip diameter `size`, module m = size/(teeth + 2), teeth 2.25·m deep (the standard full depth) with straight flanks that
//! leave half of the pitch circle to the teeth: a tooth is 0.72 of its pitch wide at the root circle and 0.28 at the tip.
//! Volume: area of the [wheel](super::wheel) minus the bore, times the height.

use super::wheel::Wheel;
use super::{BuildForm, Form, refused, rims};
use std::f64::consts::PI;
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::{Mm, concise};

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "gear",
    summary: "A spur gear with a bore",
    example: "[target]\nphantom.gear = { size_mm = 6.0, height_mm = 3.0, teeth = 12, bore_mm = 2.0 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the gear.
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
        /// Diameter of the bore, mm (less than the root circle)
        #[schemars(extend("minimum" = 0.0))]
        bore_mm: Mm = Mm(2.0),
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    let wheel = spur_gear(p.size_mm, p.teeth);
    let tip = wheel.tip;
    let bore = p.bore_mm.0 / 2.0;
    if bore >= wheel.root {
        let found = format!(
            "{} in a root circle of {} mm",
            p.bore_mm,
            concise(2.0 * wheel.root)
        );
        let accepted = "a diameter ≥ 0 below the root circle";
        return refused(section, "bore_mm", found, accepted);
    }
    let half = p.height_mm.0 / 2.0;
    Ok(Form::upright(
        move |p| {
            // Without a bore the axis is no wall
            let hole = if bore > 0.0 {
                bore - p[0].hypot(p[1])
            } else {
                f64::NEG_INFINITY
            };
            wheel.distance(p).max(hole)
        },
        half,
        rims(tip, [-half, half]),
        Some((wheel.area() - PI * bore * bore) * 2.0 * half),
    ))
}

/// The outline of a gear `size_mm` wide over the tips.
pub(super) fn spur_gear(size: Mm, teeth: u32) -> Wheel {
    let tip = size.0 / 2.0;
    let module = size.0 / f64::from(teeth + 2);
    let half_pitch = PI / f64::from(teeth);
    Wheel {
        count: teeth,
        root: tip - 2.25 * module,
        tip,
        root_angle: 0.72 * half_pitch,
        tip_angle: 0.28 * half_pitch,
    }
}
