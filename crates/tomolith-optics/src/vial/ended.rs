//! A vial that ends: a bottom under the resin, a lid or the free surface above it.
//!
//! # Model
//! Another vial between two planes normal to the axis. The resin ends at `z_mm`; the walls around it go on for `thickness_mm`: a plate of
//! their material, or, where it is 0, a surface that the resin shares with the surroundings. What stands in the resin, the inner tube of
//! a double tube and its core, ends where the resin does: on the plate, or with it at the free surface.
//!
//! # Limits
//! A free surface is flat (no meniscus), and the glass ends where the resin does. The plates of a double tube are of its outer glass, and
//! close the inner tube too.
//!
//! # Example
//! ```
//! use tomolith_core::units::Mm;
//! use tomolith_optics::vial::{Vial, cylinder::Cylinder, ended::{End, Ended}};
//! let glass = Cylinder { inner_radius_mm: 8.0, outer_radius_mm: 8.7, refractive_index: 1.58 };
//! let bottom = End { z_mm: Mm(-10.0), thickness_mm: Mm(1.0) };
//! let vial = Ended::new(Box::new(glass), Some(bottom), None).unwrap();
//! assert!(vial.in_resin([0.0, 0.0, -9.9]) && !vial.in_resin([0.0, 0.0, -10.1]));
//! ```

use super::{CrossSection, Medium, Vial, Wall};
use crate::surface::Surface;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::error::{Error, Result};
use tomolith_core::units::{Mm, exact};

/// Keys of `[vial.bottom]` and `[vial.top]`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct End {
    /// Where the resin ends.
    pub z_mm: Mm,
    /// Thickness of the plate there; 0: the resin meets the surroundings.
    #[serde(default)]
    pub thickness_mm: Mm,
}

/// See the [module page](self).
#[derive(Debug)]
pub struct Ended {
    vial: Box<dyn Vial>,
    /// Heights of the resin, and of the walls around it, mm.
    resin: [f64; 2],
    walls: [f64; 2],
}

impl Ended {
    /// The vial between two ends; None: it goes on for ever there.
    ///
    /// # Errors
    /// [`Error::Config`] at `vial.bottom` or `vial.top`.
    pub fn new(vial: Box<dyn Vial>, bottom: Option<End>, top: Option<End>) -> Result<Self> {
        for (key, end) in [("vial.bottom", bottom), ("vial.top", top)] {
            let Some(end) = end else { continue };
            let refused = |key: String, found: String, accepted: &str| {
                Err(Error::config(key, found, accepted))
            };
            let [z_mm, thickness_mm] = [end.z_mm.0, end.thickness_mm.0];
            if !z_mm.is_finite() {
                let found = format!("found {}", exact(z_mm));
                return refused(format!("{key}.z_mm"), found, "a finite number");
            }
            if !(thickness_mm.is_finite() && thickness_mm >= 0.0) {
                let found = format!("found {}", exact(thickness_mm));
                return refused(format!("{key}.thickness_mm"), found, "a finite number >= 0");
            }
            if !vial.is_invariant() {
                return refused(
                    key.into(),
                    "a mesh, which has ends of its own".into(),
                    "an index-matched, round or square vial, or a double tube",
                );
            }
            if vial.walls().len() == 1 && thickness_mm > 0.0 {
                let found = "a plate on a vial without walls".into();
                return refused(format!("{key}.thickness_mm"), found, "0");
            }
        }
        let z = |end: Option<End>, none: f64| end.map_or(none, |e| e.z_mm.0);
        let thickness = |end: Option<End>| end.map_or(0.0, |e| e.thickness_mm.0);
        let resin = [z(bottom, f64::NEG_INFINITY), z(top, f64::INFINITY)];
        if resin[0] >= resin[1] {
            return Err(Error::config(
                "vial.bottom.z_mm",
                format!(
                    "found {}, not below the top at {}",
                    Mm(resin[0]),
                    Mm(resin[1])
                ),
                format!("a height below {}", Mm(resin[1])),
            ));
        }
        let walls = [resin[0] - thickness(bottom), resin[1] + thickness(top)];
        Ok(Ended { vial, resin, walls })
    }
}

impl Vial for Ended {
    fn walls(&self) -> Vec<Wall> {
        self.vial.walls()
    }

    fn surfaces(&self) -> Vec<(Surface, Medium)> {
        let mut heights = self.walls;
        let can = |wall: Wall| {
            // From the resin inwards
            if wall.inside == Medium::Resin {
                heights = self.resin;
            }
            (Surface::Can(wall.curve, heights), wall.inside)
        };
        self.walls().into_iter().map(can).collect()
    }

    fn outer_radius_mm(&self) -> f64 {
        self.vial.outer_radius_mm()
    }

    fn surrounding_index(&self, asked: f64, resin: f64) -> f64 {
        self.vial.surrounding_index(asked, resin)
    }

    fn is_invariant(&self) -> bool {
        false
    }

    fn is_round(&self) -> bool {
        self.vial.is_round()
    }

    fn is_convex(&self) -> bool {
        self.vial.is_convex()
    }

    fn in_resin(&self, point: [f64; 3]) -> bool {
        point[2] > self.resin[0] && point[2] < self.resin[1] && self.vial.in_resin(point)
    }

    fn resin_wall(&self) -> CrossSection {
        self.vial.resin_wall()
    }

    fn reach_mm(&self, half_field_mm: f64, surrounding: f64, resin: f64) -> f64 {
        self.vial.reach_mm(half_field_mm, surrounding, resin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vial::cylinder::Cylinder;
    use crate::vial::double_tube::DoubleTube;
    use crate::vial::index_matched::IndexMatched;
    use crate::vial::mesh::MeshVial;
    use tomolith_io::mesh::samples::cuboid;

    const AT: End = End {
        z_mm: Mm(3.0),
        thickness_mm: Mm(1.0),
    };

    fn key(vial: impl Vial + 'static, bottom: Option<End>, top: Option<End>) -> String {
        match Ended::new(Box::new(vial), bottom, top) {
            Err(Error::Config { key, .. }) => key,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn ends_that_cannot_be_are_refused_by_their_key() {
        let glass = Cylinder::new(4.0, 5.0, 1.5);
        assert_eq!(key(glass.clone(), Some(AT), Some(AT)), "vial.bottom.z_mm");
        let thin = End {
            thickness_mm: Mm(-1.0),
            ..AT
        };
        assert_eq!(
            key(glass.clone(), None, Some(thin)),
            "vial.top.thickness_mm"
        );
        let nowhere = End {
            z_mm: Mm(f64::NAN),
            ..AT
        };
        assert_eq!(key(glass, Some(nowhere), None), "vial.bottom.z_mm");
        let bath = IndexMatched { radius_mm: 4.0 };
        assert_eq!(key(bath, Some(AT), None), "vial.bottom.thickness_mm");
        let wall = |half: f64| cuboid([-half; 3], [half; 3]);
        let mesh = MeshVial::new(&wall(3.0), &wall(2.5), 1.5, "vial.mesh").unwrap();
        assert_eq!(key(mesh, None, Some(AT)), "vial.top");
    }

    #[test]
    fn a_tube_in_the_resin_ends_with_it() {
        let tube = DoubleTube::new([9.0, 8.0, 3.0, 2.5], [1.5, 1.5, 1.0]);
        let bottom = End {
            z_mm: Mm(-4.0),
            thickness_mm: Mm(0.5),
        };
        let vial = Ended::new(Box::new(tube), Some(bottom), Some(AT)).unwrap();
        let heights = |(surface, _): &(Surface, Medium)| match surface {
            Surface::Can(_, heights) => *heights,
            other => panic!("{other:?}"),
        };
        let found: Vec<_> = vial.surfaces().iter().map(heights).collect();
        assert_eq!(found, [[-4.5, 4.0], [-4.0, 3.0], [-4.0, 3.0], [-4.0, 3.0]]);
        for (point, is_resin) in [
            ([5.0, 0.0, -3.9], true),
            ([5.0, 0.0, -4.1], false), // the plate
            ([5.0, 0.0, 3.1], false),
            ([2.8, 0.0, 0.0], false), // the inner glass
            ([1.0, 0.0, 0.0], false),
        ] {
            assert_eq!(vial.in_resin(point), is_resin, "{point:?}");
        }
    }
}
