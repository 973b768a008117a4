//! A gray flower before a blurred background, in a circle: a target with detail of all sizes and all gray levels.
//!
//! It stands in for the photograph that Li et al. 2023 (BCLP, section 3.4.2) print, which has another license: five petals
//! and a leaf with veins, one petal dark in its middle, bright stamens, a stem. Petals are |s| < w(t) in coordinates t along
//! and s across, w = width·√(sin π·t^1.4) with a ruffled edge; what lies farther in front covers what is behind, with soft
//! edges. In the circle values run from 0.07 to 0.93 (mean 0.444, standard deviation 0.224; the photograph: 0.447,
//! 0.194); beyond it they are 0. Gray values, not an inside fraction: no volume.

use super::{Body, BuildForm, Form, GrayForm, rims};
use std::f64::consts::PI;
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::Mm;

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "flower",
    summary: "A gray flower before a blurred background: a target of all gray levels",
    example: "[target]\nphantom.flower = { size_mm = 5.0, height_mm = 1.0 }",
    schema: schema_of::<Params>,
    build,
};

tomolith_core::keys! {
    /// Parameters of the flower.
    struct Params {
        /// Diameter of the circle, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Height along z, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Mm = Mm(1.0),
    }
}

fn build(section: &Section) -> Result<Form> {
    let p: Params = section.parse()?;
    let (radius, half) = (p.size_mm.0 / 2.0, p.height_mm.0 / 2.0);
    Ok(Form {
        body: Body::GrayFunction(GrayForm {
            value: Box::new(move |p| picture(p.map(|v| v / radius))),
            z: [-half, half],
        }),
        hull: rims(radius, [-half, half]),
        round: 0.0,
        volume_mm3: None,
    })
}

/// Where the petals meet.
const HEART: [f64; 2] = [-0.02, -0.13];

/// Blurred lights of the background: place, radius, brightness.
const LIGHTS: [([f64; 2], f64, f64); 7] = [
    ([-0.3, -1.05], 0.5, 0.20),
    ([0.85, 0.55], 0.33, 0.42),
    ([0.35, 0.85], 0.3, 0.22),
    ([0.75, 0.1], 0.4, 0.20),
    ([-0.2, -0.6], 0.3, -0.08),
    ([0.0, -0.85], 0.4, 0.10),
    ([-0.3, 0.75], 0.35, -0.10),
];

/// A petal: direction in degrees, length, half width, brightness, number of veins, how dark its middle is.
struct Petal(f64, f64, f64, f64, f64, f64);

/// From behind to before.
const PETALS: [Petal; 6] = [
    Petal(176.0, 0.85, 0.13, 0.58, 5.0, 0.0),
    Petal(205.0, 0.95, 0.20, 0.66, 9.0, 0.0),
    Petal(126.0, 0.92, 0.23, 0.64, 9.0, 0.0),
    Petal(47.0, 1.05, 0.22, 0.68, 9.0, 0.0),
    Petal(-5.0, 1.02, 0.22, 0.66, 9.0, 0.0),
    Petal(91.0, 0.80, 0.25, 0.64, 11.0, 0.42),
];

/// A bent line: from, to, bend, half width, brightness, softness of its edge.
struct Stroke([f64; 2], [f64; 2], f64, f64, f64, f64);

const STEM: Stroke = Stroke([0.10, -0.33], [0.75, -0.95], 0.1, 0.035, 0.42, 0.02);

/// Ends and bends of the stamens.
const STAMENS: [([f64; 2], [f64; 2], f64); 6] = [
    ([0.0, -0.3], [-0.18, 0.2], 0.08),
    ([-0.02, -0.32], [-0.1, -0.07], -0.2),
    ([0.02, -0.38], [0.03, -0.08], 0.2),
    ([0.04, -0.36], [0.08, -0.1], -0.15),
    ([-0.02, -0.36], [-0.22, -0.12], 0.25),
    ([0.05, -0.3], [0.07, -0.2], 0.1),
];

/// The gray value at a point of the unit disc.
fn picture(p: [f64; 2]) -> f64 {
    if p[0].hypot(p[1]) > 1.0 {
        return 0.0;
    }
    let mut value = 0.17;
    for ([x, y], radius, brightness) in LIGHTS {
        let near = ((p[0] - x).powi(2) + (p[1] - y).powi(2)) / (radius * radius);
        value += brightness * (-near).exp();
    }
    STEM.paint(p, &mut value);
    for petal in &PETALS {
        petal.paint(p, &mut value);
    }
    for (from, to, bend) in STAMENS {
        Stroke(from, to, bend, 0.014, 0.93, 0.006).paint(p, &mut value);
    }
    value.clamp(0.02, 1.0)
}

/// Lays a paint over a value: by how much, at a signed distance from its edge.
fn cover(value: &mut f64, paint: f64, distance: f64, soft: f64) {
    let share = (0.5 - distance / (2.0 * soft)).clamp(0.0, 1.0);
    let share = share * share * (3.0 - 2.0 * share);
    *value += share * (paint - *value);
}

impl Petal {
    fn paint(&self, p: [f64; 2], value: &mut f64) {
        let Petal(degrees, length, width, base, veins, dark) = *self;
        let (sin, cos) = degrees.to_radians().sin_cos();
        let [x, y] = [p[0] - HEART[0], p[1] - HEART[1]];
        let (t, s) = ((x * cos + y * sin) / length, y * cos - x * sin);
        if !(0.0..1.0).contains(&t) {
            return;
        }
        let ruffle = 1.0 + 0.05 * (37.0 * t + 5.0 * s.signum()).sin();
        let half = (width * (PI * t.powf(1.4)).sin().sqrt() * ruffle).max(1e-3);
        let r = s.abs() / half;
        let outer = 1.0 - t;
        let lines = (PI * veins * r * (1.0 + 0.2 * t)).cos();
        let mut paint = base + 0.1 * lines * outer.sqrt() + 0.11 * r * r - 0.12 * r * outer
            + 0.14 * outer * (-(r / 0.15).powi(2)).exp();
        let fade = (1.25 - t).clamp(0.0, 1.0);
        paint -= dark * (-(r / 0.55).powi(2)).exp() * fade * fade * (3.0 - 2.0 * fade);
        cover(value, paint, s.abs() - half, 0.008);
    }
}

impl Stroke {
    fn paint(&self, p: [f64; 2], value: &mut f64) {
        let Stroke(from, to, bend, half, paint, soft) = *self;
        let along = [to[0] - from[0], to[1] - from[1]];
        let length = along[0].hypot(along[1]);
        let q = [p[0] - from[0], p[1] - from[1]];
        let t = (q[0] * along[0] + q[1] * along[1]) / (length * length);
        let s = (q[1] * along[0] - q[0] * along[1]) / length;
        let on = t.clamp(0.0, 1.0);
        let arc = 4.0 * bend * on * (1.0 - on) * length;
        cover(
            value,
            paint,
            (s - arc).hypot((t - on) * length) - half,
            soft,
        );
    }
}
