//! Four sinusoidal gratings of different gray depth: a gray target with known frequencies.
//!
//! In each quarter of a square, ½·(1 − cos 2π·periods·s) with s from 0 to 1 along x, from 0 to 1 gray, rounded to the
//! 2^bits levels k/(2^bits − 1); quarters are `gap_mm` apart. Counter-clockwise from the lower right: 1, 2, 4 and 12 bits,
//! the order of Li et al. 2023 (BCLP), section 3.4; their period, gaps and orientation are in a figure only. Four times 1
//! bit are the binary gratings of its supplement S.10. Gray values, not an inside fraction: no volume.
//!
//! ```
//! use tomolith_core::kind::Section;
//! use tomolith_target::{Placement, Shape, phantom::Phantom};
//! let section = Section::new("target.phantom", serde_json::json!("gratings"));
//! let part = Phantom::build(&section, &Placement::default(), "target").unwrap();
//! use tomolith_core::grid::VolumeGrid;
//! let grid = VolumeGrid { shape: [1, 1, 1], pitch_mm: 0.01, height_mm: 0.01, center_mm: [1.35, -1.35, 0.0] };
//! assert!(part.is_gray());
//! // The middle of the lower right grating, 2.3 mm wide: half a period after the last dark line of 5
//! assert_eq!(part.sample(&grid).unwrap().values[0], 1.0);
//! ```

use super::waves::wave;
use super::{Body, BuildForm, Form, GrayForm, corners, positive, within};
use tomolith_core::error::{Error, Result};
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
        /// Edge of the whole square, mm (> 0)
        size_mm: Mm = Mm(5.0),
        /// Height along z, mm (> 0)
        height_mm: Mm = Mm(1.0),
        /// Periods per grating (1 to 1000)
        periods: u32 = 5,
        /// Between two gratings, mm (≥ 0, less than `size_mm`)
        gap_mm: Mm = Mm(0.4),
        /// Gray depth of the gratings, counter-clockwise from the lower right (1 to 16)
        bits: [u32; 4] = [1, 2, 4, 12],
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    positive!(section, p, size_mm, height_mm);
    let refused = |key: &str, found: String, accepted: &str| {
        Err(Error::config(key, found, accepted).under(&section.path))
    };
    within(section, "periods", p.periods, 1..=1000)?;
    if !(p.gap_mm.0 >= 0.0 && p.gap_mm < p.size_mm) {
        let found = p.gap_mm.to_string();
        return refused("gap_mm", found, "0, or a length below `size_mm`");
    }
    if p.bits.iter().any(|bits| !(1..=16).contains(bits)) {
        return refused("bits", format!("{:?}", p.bits), "four numbers from 1 to 16");
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
