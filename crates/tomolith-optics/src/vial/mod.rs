//! Vials: what stands around the resin.
//!
//! *What must it do, and who does it.* A vial is a nest of closed walls, from outside to inside; each wall says what lies
//! within it. The tracers ([`crate::trace`] in the plane, [`crate::space`] in space) know Snell and Fresnel, so a
//! vial is its geometry and nothing else.

mod cross_section;
pub mod cylinder;
pub mod double_tube;
pub mod ended;
pub mod index_matched;
pub mod mesh;
pub mod square;

pub use self::cross_section::CrossSection;
pub(crate) use self::cross_section::PlaneCrossing;
use crate::surface::Surface;
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section};
use tomolith_core::units::Mm;

/// What lies inside a wall (up to the next one).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Medium {
    /// The photosensitive resin.
    Resin,
    /// Something clear of this refractive index (glass, air, water).
    Clear(f64),
}

/// A wall, and what it encloses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// Its shape.
    pub curve: CrossSection,
    /// What lies within.
    pub inside: Medium,
}

/// A vial: most have the same cross-section at all heights.
pub trait Vial: std::fmt::Debug + Send + Sync {
    /// Walls from outside to inside; exactly one of them encloses [`Medium::Resin`].
    fn walls(&self) -> Vec<Wall>;

    /// The same walls in space.
    fn surfaces(&self) -> Vec<(Surface, Medium)> {
        let in_space = |wall: Wall| (Surface::Prism(wall.curve), wall.inside);
        self.walls().into_iter().map(in_space).collect()
    }

    /// No part of the vial is farther from the axis, mm.
    fn outer_radius_mm(&self) -> f64 {
        let walls = self.walls();
        let outer = walls.first().map(|wall| wall.curve);
        outer.map_or(0.0, CrossSection::circumscribed_radius)
    }

    /// Index of what surrounds the vial, given the index in the job and that of the resin.
    fn surrounding_index(&self, asked: f64, _resin: f64) -> f64 {
        asked
    }

    /// What people should know of its files, one sentence each, with the key of the file.
    fn notes(&self) -> &[String] {
        &[]
    }

    /// Whether it is the same at all heights.
    fn is_invariant(&self) -> bool {
        true
    }

    /// Whether the cross-section is the same from every azimuth.
    fn is_round(&self) -> bool {
        let walls = self.walls();
        walls.iter().all(|wall| wall.curve.as_circle().is_some())
    }

    /// Whether straight lines between points of the resin stay in it.
    fn is_convex(&self) -> bool {
        let walls = self.walls();
        walls
            .last()
            .is_some_and(|wall| wall.inside == Medium::Resin)
    }

    /// Whether a point (mm) is in the resin.
    fn in_resin(&self, [x, y, _]: [f64; 3]) -> bool {
        let walls = self.walls();
        let inside = walls.iter().take_while(|w| w.curve.contains(x, y)).count();
        inside > 0 && walls[inside - 1].inside == Medium::Resin
    }

    /// The wall that holds the resin, mm.
    fn resin_wall(&self) -> CrossSection {
        self.walls()
            .iter()
            .find(|w| w.inside == Medium::Resin)
            .map_or(CrossSection::Circle(0.0), |w| w.curve)
    }

    /// Distance from the axis up to which light is tangent to circles, so that a part can be lit from all sides:
    /// min(R_i, n_s·min(R_o, half field)/n_r), mm (Bouguer's invariant).
    fn reach_mm(&self, half_field_mm: f64, surrounding: f64, resin: f64) -> f64 {
        let outer = self
            .walls()
            .first()
            .map_or(0.0, |w| w.curve.inscribed_radius());
        (surrounding * outer.min(half_field_mm) / resin).min(self.resin_wall().inscribed_radius())
    }
}

/// Builds a vial from its section.
pub type BuildVial = fn(&Section) -> Result<Box<dyn Vial>>;

/// Every vial.
pub static VIALS: &[Kind<BuildVial>] = &[
    index_matched::KIND,
    cylinder::KIND,
    square::KIND,
    double_tube::KIND,
    mesh::KIND,
];

/// Refuses anything but a finite number > 0.
pub(crate) fn positive(section: &Section, key: &str, value: f64) -> Result<f64> {
    let is_in = value.is_finite() && value > 0.0;
    section.in_range(is_in, key, value, "a finite number > 0")?;
    Ok(value)
}

/// Refuses an inner measure that is not smaller than the outer one.
pub(crate) fn inner_below_outer(
    section: &Section,
    (inner_key, inner): (&str, f64),
    (outer_key, outer): (&str, f64),
) -> Result<()> {
    if inner < outer {
        return Ok(());
    }
    let (inner, outer) = (Mm(inner), Mm(outer));
    Err(section.refused(
        inner_key,
        format!("{inner}, not smaller than {outer_key} = {outer}"),
        format!("a length below {outer}"),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::example;
    use tomolith_io::mesh::samples::{cuboid, stl_binary};

    #[test]
    fn every_example_builds_and_holds_resin_on_its_resin_wall() {
        for kind in VIALS {
            let folder = tempfile::tempdir().unwrap();
            for (file, half) in [("cuvette-outer.stl", 3.0), ("cuvette-inner.stl", 2.5)] {
                let wall = cuboid([-half; 3], [half; 3]);
                std::fs::write(folder.path().join(file), stl_binary(&wall)).unwrap();
            }
            let section = example(kind).based(folder.path());
            let vial = (kind.build)(&section).unwrap();
            let r = vial.resin_wall().inscribed_radius();
            assert!(vial.in_resin([r * 0.999, 0.0, 0.0]), "{}", kind.name);
            assert!(!vial.in_resin([r * 1.001, 0.0, 0.0]), "{}", kind.name);
            let walls = vial.walls();
            let resin = walls.iter().filter(|w| w.inside == Medium::Resin);
            assert_eq!(resin.count(), 1);
        }
    }
}
