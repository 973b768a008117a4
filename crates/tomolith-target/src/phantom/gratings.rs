//! Four sinusoidal gratings of different gray depth: a gray target with known frequencies.
//!
//! In each quarter of a square, ½·(1 − cos 2π·periods·s) with s from 0 to 1 along x, from 0 to 1 gray, rounded to the
//! 2^bits levels k/(2^bits − 1); quarters are `gap_mm` apart. Counter-clockwise from the lower right: 1, 2, 4 and 12 bits,
//! the order of Li et al. 2023 (BCLP), section 3.4; their period, gaps and orientation are in a figure only. Four times 1
//! bit are the binary gratings of its supplement S.10. Gray values, not an inside fraction: no volume.

use super::waves::wave;
use super::{Body, BuildForm, Form, GrayForm, corners, refused};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "gratings",
    summary: "Four sinusoidal gratings of 1, 2, 4 and 12 bit: a gray target",
    example: "[target]\nphantom.gratings = { size_mm = 5.0, height_mm = 1.0, periods = 5, gap_mm = 0.4, bits = [1, 2, 4, 12] }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the gratings.
    struct Params {
        /// Edge of the whole square, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Height along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(1.0),
        /// Periods per grating
        #[schemars(range(min = 1, max = 1000))]
        periods: u32 = 5,
        /// Between two gratings, mm (less than `size_mm`)
        #[schemars(extend("minimum" = 0.0))]
        gap_mm: Mm = Mm(0.4),
        /// Gray depth of the gratings, counter-clockwise from the lower right
        #[schemars(inner(range(min = 1, max = 16)))]
        bits: [u32; 4] = [1, 2, 4, 12],
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    if p.gap_mm >= p.size_mm {
        let accepted = "0, or a length below `size_mm`";
        return refused(section, "gap_mm", p.gap_mm, accepted);
    }
    let (edge, half) = (p.size_mm.0 / 2.0, p.height_mm.0 / 2.0);
    let (gap, periods, bits) = (p.gap_mm.0 / 2.0, f64::from(p.periods), p.bits);
    let value = move |[x, y]: [f64; 2]| {
        let inside = |v: f64| (gap..edge).contains(&v.abs());
        if !(inside(x) && inside(y)) {
            return 0.0;
        }
        let quarter = match (x > 0.0, y > 0.0) {
            (true, false) => 0,
            (true, true) => 1,
            (false, true) => 2,
            (false, false) => 3,
        };
        let share = (x.abs() - gap) / (edge - gap);
        let (_, cos) = wave(periods * share);
        let levels = f64::from((1u32 << bits[quarter]) - 1);
        (0.5 * (1.0 - cos) * levels).round() / levels
    };
    Ok(Form {
        body: Body::GrayFunction(GrayForm {
            value: Box::new(value),
            z: [-half, half],
        }),
        hull: corners([edge, edge, half]),
        round: 0.0,
        volume_mm3: None,
    })
}
