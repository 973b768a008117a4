//! Cubes cut out of a curved wall that repeats in all three directions: gyroid, Schwarz P, diamond.
//!
//! With k = 2π·cells/size and a wave field g of period 2π, the surface g(k·r) = 0 splits space into two labyrinths; solid
//! is |g| < level inside the cube. A wall of mean thickness w has level = k·w/2 divided by the mean of k/|∇g| over the
//! surface.

use super::waves::wave;
use super::{Body, Form, corners, cuboid, refused};
use std::f64::consts::TAU;
use tomolith_core::error::Result;
use tomolith_core::kind::Section;
use tomolith_core::units::{Mm, concise};

tomolith_core::keys! {
    /// A cube of curved wall.
    pub(super) struct Params {
        /// Edge of the cube, mm
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        size_mm: Mm = Mm(5.0),
        /// Periods along an edge
        #[schemars(range(min = 1, max = 100))]
        cells: u32 = 2,
        /// Mean thickness of the wall, mm (at most, and by default, a fifth of a period, an eighth for the diamond)
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        wall_mm: Option<Mm>,
    }
}

/// sin and cos of an angle.
pub(super) type Wave = (f64, f64);

/// A wave field and what is known of it, for k = 1.
pub(super) struct Waves {
    /// g from the sines and cosines of x, y and z.
    pub(super) field: fn([Wave; 3]) -> f64,
    /// The largest |∇g| anywhere.
    pub(super) steepest: f64,
    /// 1 over the mean of 1/|∇g| on the surface g = 0.
    pub(super) mean_slope: f64,
    /// The thickest wall, in periods.
    pub(super) thickest: f64,
}

/// A cube of the wall that these waves make.
pub(super) fn build(section: &Section, waves: &'static Waves) -> Result<Form> {
    let p: Params = section.parse()?;
    let period = p.size_mm.0 / f64::from(p.cells);
    let thickest = waves.thickest * period;
    let wall = p.wall_mm.map_or(thickest, |mm| mm.0);
    if wall > thickest * (1.0 + 1e-9) {
        let found = format!("{} with a period of {} mm", Mm(wall), concise(period));
        let accepted = format!("a thickness > 0, at most {} mm", concise(thickest));
        return refused(section, "wall_mm", found, accepted);
    }
    let half = p.size_mm.0 / 2.0;
    let turns = 1.0 / period;
    let level = TAU * turns * waves.mean_slope * wall / 2.0;
    let to_mm = 1.0 / (TAU * turns * waves.steepest);
    Ok(Form {
        body: Body::Solid(Box::new(move |point| {
            let [x, y, z] = point;
            let g = (waves.field)([wave(x * turns), wave(y * turns), wave(z * turns)]);
            ((g.abs() - level) * to_mm).max(cuboid(point, [half; 3]))
        })),
        hull: corners([half; 3]),
        round: 0.0,
        volume_mm3: None,
    })
}
