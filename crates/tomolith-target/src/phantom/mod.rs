//! Phantoms: parts by formula.
//!
//! *What must it do, and who does it.* A phantom is a [`Form`]: a distance to its surface, the points that span it, and
//! its volume where a closed form is known. [`PHANTOMS`] is the table; [`sampling`] turns a form into inside fractions.

mod box_with_hole;
mod checkerboard;
mod chiral;
mod cylinder;
mod diamond;
mod dog_bones;
mod flower;
mod gear;
mod gratings;
mod gyroid;
mod hollow_gear;
mod resolution_chart;
mod ring;
pub mod sampling;
mod siemens_star;
mod sphere;
mod wall;
mod waves;
mod wheel;

use super::Shape;
use super::placing::{Map, Placement, bounds};
use std::fmt::Display;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::kind::{Kind, Section};
use tomolith_core::work::Work;

/// Signed distance to an outline in the plane, mm: negative inside, growing by at most 1 per mm.
pub type Outline = Box<dyn Fn([f64; 2]) -> f64 + Send + Sync>;

/// Signed distance to a surface, mm: negative inside, growing by at most 1 per mm.
pub type ImplicitSurface = Box<dyn Fn([f64; 3]) -> f64 + Send + Sync>;

/// An outline drawn from the height `z[0]` to `z[1]`.
pub struct Prism {
    /// The outline.
    pub outline: Outline,
    /// Lower and upper end, mm.
    pub z: [f64; 2],
}

/// Gray value at a point of the plane, 0…1.
pub type GrayFunction = Box<dyn Fn([f64; 2]) -> f64 + Send + Sync>;

/// Gray values drawn from the height `z[0]` to `z[1]`.
pub struct GrayForm {
    /// The values, 0 beyond the form.
    pub value: GrayFunction,
    /// Lower and upper end, mm.
    pub z: [f64; 2],
}

/// What fills the form.
pub enum Body {
    /// The union of prisms; where two share heights, one outline lies in the other.
    Prisms(Vec<Prism>),
    /// The inside of a surface.
    Solid(ImplicitSurface),
    /// Values to be reproduced.
    GrayFunction(GrayForm),
}

/// A part by formula, in a frame of its own.
pub struct Form {
    /// What fills it.
    pub body: Body,
    /// Points whose convex hull, widened by `round`, has the form's box whichever way it is turned.
    pub hull: Vec<[f64; 3]>,
    /// Radius of a ball about every hull point, mm.
    pub round: f64,
    /// Its volume, where a closed form is known, mm³.
    pub volume_mm3: Option<f64>,
}

impl Form {
    /// An outline drawn from `−half` to `half`; `hull` spans it.
    fn upright(
        outline: impl Fn([f64; 2]) -> f64 + Send + Sync + 'static,
        half: f64,
        hull: Vec<[f64; 3]>,
        volume_mm3: Option<f64>,
    ) -> Self {
        let (outline, z) = (Box::new(outline), [-half, half]);
        Form {
            body: Body::Prisms(vec![Prism { outline, z }]),
            hull,
            round: 0.0,
            volume_mm3,
        }
    }
}

/// Builds a form from its section.
pub type BuildForm = fn(&Section) -> Result<Form>;

/// Every phantom.
pub static PHANTOMS: &[Kind<BuildForm>] = &[
    cylinder::KIND,
    sphere::KIND,
    ring::KIND,
    box_with_hole::KIND,
    gear::KIND,
    hollow_gear::KIND,
    siemens_star::KIND,
    resolution_chart::KIND,
    checkerboard::KIND,
    dog_bones::KIND,
    gyroid::KIND,
    diamond::KIND,
    chiral::KIND,
    gratings::KIND,
    flower::KIND,
];

/// A placed form.
pub struct Phantom {
    name: &'static str,
    form: Form,
    map: Map,
    bounds_mm: [[f64; 3]; 2],
}

impl std::fmt::Debug for Phantom {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Phantom")
            .field("name", &self.name)
            .field("map", &self.map)
            .field("bounds_mm", &self.bounds_mm)
            .finish_non_exhaustive()
    }
}

impl Phantom {
    /// The phantom named in `section` (a name, or a table `{gear = {…}}`), placed; errors of the placement name keys
    /// under `target`.
    ///
    /// # Errors
    /// [`Error::Config`] when the name or a parameter is not accepted.
    pub fn build(section: &Section, placement: &Placement, target: &str) -> Result<Self> {
        let (kind, parameters) = section.kind(PHANTOMS)?;
        let form = (kind.build)(&parameters)?;
        let map = placement.map(&form.hull, form.round, target)?;
        if matches!(form.body, Body::GrayFunction(_)) && map.rotation[2] != [0.0, 0.0, 1.0] {
            return Err(Error::config(
                format!("{target}.rotate_deg"),
                format!("{:?} for gray values drawn along z", placement.rotate_deg),
                "[0, 0, angle]: a turn about z only",
            ));
        }
        let bounds_mm = bounds(
            form.hull.iter().map(|&p| map.apply(p)),
            form.round * map.scale,
        );
        Ok(Phantom {
            name: kind.name,
            form,
            map,
            bounds_mm,
        })
    }

    /// Its name in the table.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }
}

impl Shape for Phantom {
    fn bounds_mm(&self) -> [[f64; 3]; 2] {
        self.bounds_mm
    }

    fn sample_under(&self, grid: &VolumeGrid, work: &Work) -> Result<Volume<f32>> {
        sampling::inside_fractions(&self.form.body, &self.map, grid, work)
    }

    fn is_gray(&self) -> bool {
        matches!(self.form.body, Body::GrayFunction(_))
    }

    fn volume_mm3(&self) -> Option<f64> {
        self.form.volume_mm3.map(|v| v * self.map.scale.powi(3))
    }

    fn upright_mm(&self) -> Option<[f64; 2]> {
        match &self.form.body {
            Body::Prisms(prisms) if self.map.rotation[2] == [0.0, 0.0, 1.0] => match &prisms[..] {
                [only] => Some(only.z.map(|z| self.map.apply([0.0, 0.0, z])[2])),
                _ => None,
            },
            _ => None,
        }
    }

    fn distance_mm(&self, point: [f64; 3]) -> Option<f64> {
        let distance = self.form.body.distance(self.map.undo(point))?;
        Some(self.map.scale * distance)
    }
}

/// Refuses the value of a parameter.
fn refused<T>(
    section: &Section,
    key: &str,
    found: impl Display,
    accepted: impl Into<String>,
) -> Result<T> {
    Err(Error::config(key, found.to_string(), accepted).under(&section.path))
}

/// Points on two circles about the z axis, a degree apart, for the hull of something round.
fn rims(radius: f64, z: [f64; 2]) -> Vec<[f64; 3]> {
    (0..720)
        .map(|i| {
            let (sin, cos) = f64::from(i % 360).to_radians().sin_cos();
            [radius * cos, radius * sin, z[(i / 360) as usize]]
        })
        .collect()
}

/// The corners of a box about the origin.
fn corners([x, y, z]: [f64; 3]) -> Vec<[f64; 3]> {
    (0..8)
        .map(|i| {
            let side = |bit: i32, half: f64| if i & bit == 0 { -half } else { half };
            [side(1, x), side(2, y), side(4, z)]
        })
        .collect()
}

/// Signed distance to a rectangle with half edges `half` about `center`.
fn rectangle(p: [f64; 2], center: [f64; 2], half: [f64; 2]) -> f64 {
    let d = [0, 1].map(|i| (p[i] - center[i]).abs() - half[i]);
    let outside = d.iter().map(|v| v.max(0.0).powi(2)).sum::<f64>().sqrt();
    outside + d[0].max(d[1]).min(0.0)
}

/// Signed distance to a box with half edges `half` about the origin.
fn cuboid(p: [f64; 3], half: [f64; 3]) -> f64 {
    let d: [f64; 3] = std::array::from_fn(|i| p[i].abs() - half[i]);
    let outside = d.iter().map(|v| v.max(0.0).powi(2)).sum::<f64>().sqrt();
    outside + d[0].max(d[1]).max(d[2]).min(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::region::{Resolution, default_grid, sampled_volume};
    use serde_json::json;

    fn phantom(value: serde_json::Value, placement: &Placement) -> Phantom {
        Phantom::build(&Section::new("target.phantom", value), placement, "target").unwrap()
    }

    fn is_gray(name: &str) -> bool {
        phantom(json!(name), &Placement::default()).is_gray()
    }

    #[test]
    fn every_phantom_has_its_closed_volume_upright_and_tilted() {
        let tilted = Placement {
            rotate_deg: [33.0, 21.0, 10.0],
            scale: Some(1.3),
            ..Placement::default()
        };
        let mut wrong = Vec::new();
        for kind in PHANTOMS {
            // Detail that the coarse grid can hold, where it is not so by default
            let (parameters, most) = match kind.name {
                "resolution_chart" => (json!({}), [2e-2, 5e-3]),
                // Bars of gray values begin between voxels of the coarse grid
                "gratings" => (json!({}), [2e-2, 1e-3]),
                "diamond" => (json!({ "cells": 1 }), [5e-3, 1e-3]),
                _ => (json!({}), [5e-3, 1e-3]),
            };
            for placement in [Placement::default(), tilted] {
                if placement == tilted && is_gray(kind.name) {
                    continue;
                }
                let shape = phantom(json!({ kind.name: parameters }), &placement);
                let coarse = sampled_volume(&shape, 40);
                let fine = sampled_volume(&shape, 80);
                let exact = shape.volume_mm3().unwrap_or(fine);
                let errors = [coarse, fine].map(|volume| (volume / exact - 1.0).abs());
                if !(errors[0] < most[0] && errors[1] < most[1]) {
                    wrong.push(format!("{}: {errors:?}", kind.name));
                }
            }
        }
        assert!(wrong.is_empty(), "{wrong:?}");
    }

    #[test]
    fn no_phantom_leaves_its_box_and_upright_it_fills_it() {
        let placement = Placement {
            rotate_deg: [25.0, 40.0, -15.0],
            ..Placement::default()
        };
        for kind in PHANTOMS.iter().filter(|kind| !is_gray(kind.name)) {
            for placement in [Placement::default(), placement] {
                let shape = phantom(json!(kind.name), &placement);
                let [low, high] = shape.bounds_mm();
                let grid = default_grid([low, high], Resolution::Shape([36; 3])).unwrap();
                let values = shape.sample(&grid).unwrap().values;
                let half = grid.pitch_mm / 2.0;
                // The rims of round parts are polygons of 360 corners: they miss the circle by 4e-5 of the radius
                let slack = half + 1e-3;
                let filled = (0..values.len()).filter(|&i| values[i] > 0.0);
                let places: Vec<_> = filled.map(|i| grid.middle(i)).collect();
                let is_out =
                    |p: [f64; 3]| (0..3).any(|i| p[i] < low[i] - slack || p[i] > high[i] + slack);
                assert!(!places.iter().any(|p| is_out(*p)), "{}", kind.name);
                // Upright, it fills its box
                let fills = |i: usize| {
                    let reach = |end: f64| places.iter().any(|p| (p[i] - end).abs() < slack);
                    reach(low[i]) && reach(high[i])
                };
                let is_turned = placement.rotate_deg != [0.0; 3];
                assert!(is_turned || (0..3).all(fills), "{}", kind.name);
            }
        }
    }

    #[test]
    fn bad_parameters_name_their_key() {
        let refused = |value: serde_json::Value| {
            let section = Section::new("target.phantom", value);
            let built = Phantom::build(&section, &Placement::default(), "target");
            built.unwrap_err().to_string()
        };
        for (kind, key, value) in [
            ("gear", "teeth", json!(2)),
            ("gear", "teeth", json!(-1)),
            ("gear", "bore_mm", json!(9.0)),
            ("sphere", "size_mm", json!(-1)),
            ("sphere", "radius", json!(1)),
            ("gyroid", "cells", json!(0)),
            ("box_with_hole", "hole_mm", json!(7)),
            ("siemens_star", "hub_mm", json!(7)),
            ("siemens_star", "spokes", json!(1)),
            ("ring", "hole_mm", json!(7)),
            ("hollow_gear", "floor_mm", json!(3)),
            ("dog_bones", "count", json!(0)),
            ("checkerboard", "cells", json!(0)),
            ("gratings", "bits", json!([1, 2, 4, 17])),
        ] {
            let text = refused(json!({ kind: { key: value } }));
            let place = format!("target.phantom.{kind}.{key}");
            assert!(text.starts_with(&place), "{text}");
            // Each number of things has one range, whatever is wrong with it
            assert_eq!(text.contains("4 to 500"), key == "teeth", "{text}");
        }
        let text = refused(json!("gaer"));
        assert!(text.starts_with("target.phantom.gaer: unknown kind `gaer`"));
        let text = refused(json!({"diamond": {"wall_mm": 0.5}}));
        let expected = "target.phantom.diamond.wall_mm: 0.5 mm with a period of 2.5 mm; accepted: a thickness > 0, at most 0.3125 mm";
        assert!(text.starts_with(expected), "{text}");
    }

    #[test]
    fn walls_of_lattices_have_the_thickness_they_are_asked_for() {
        // Volume over area; of the area, periods² per cell, these are counts of random points near the surfaces
        for (name, area) in [("gyroid", 3.0967), ("diamond", 3.8378)] {
            let wall = json!({ name: { "size_mm": 2.0, "cells": 2, "wall_mm": 0.04 } });
            let shape = phantom(wall, &Placement::default());
            let grid = VolumeGrid::centered([100; 3], 0.02);
            let volume = shape.sample(&grid).unwrap();
            let volume: f64 = volume.values.iter().map(|&v| f64::from(v)).sum();
            let thickness = volume * grid.voxel_mm3() / (8.0 * area);
            assert!((thickness / 0.04 - 1.0).abs() < 0.02, "{name}: {thickness}");
        }
    }

    #[test]
    fn gratings_have_the_levels_of_their_bits() {
        let shape = phantom(json!("gratings"), &Placement::default());
        let grid = VolumeGrid::centered([1, 2000, 2000], 0.0025);
        let volume = shape.sample(&grid).unwrap();
        let levels = |ix: std::ops::Range<usize>, iy: usize| {
            let mut found: Vec<u32> = ix.map(|ix| volume.at(0, iy, ix).to_bits()).collect();
            found.sort_unstable();
            found.dedup();
            found.len()
        };
        // Voxels at steps hold means of two levels: at most one more level between every two
        let right = 1100..1990;
        assert!((2..=3).contains(&levels(right.clone(), 500)));
        assert!((4..=7).contains(&levels(right, 1500)));
        let left = 10..900;
        assert!((16..=31).contains(&levels(left.clone(), 1500)));
        assert!(levels(left, 500) > 60);
        // No light in the gap, and the full range in every grating
        assert_eq!(*volume.at(0, 1000, 1500), 0.0);
        for (ix, iy) in [
            (1100..1990, 500),
            (1100..1990, 1500),
            (10..900, 1500),
            (10..900, 500),
        ] {
            let row: Vec<f32> = ix.map(|ix| *volume.at(0, iy, ix)).collect();
            assert!(row.iter().any(|v| *v < 0.001) && row.iter().any(|v| *v > 0.999));
        }
    }

    #[test]
    fn the_flower_has_the_statistics_of_a_photograph() {
        let shape = phantom(json!("flower"), &Placement::default());
        let grid = VolumeGrid::centered([1, 256, 256], 5.0 / 256.0);
        let values = shape.sample(&grid).unwrap().values;
        let inside: Vec<f64> = values
            .iter()
            .filter(|v| **v > 0.0)
            .map(|&v| f64::from(v))
            .collect();
        let mean = inside.iter().sum::<f64>() / inside.len() as f64;
        let variance = inside.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / inside.len() as f64;
        let brightest = inside.iter().copied().fold(0.0, f64::max);
        assert!(values[0] == 0.0 && brightest > 0.8 && brightest < 0.931);
        let disc = inside.len() as f64 / (256.0 * 256.0);
        assert!((disc - std::f64::consts::FRAC_PI_4).abs() < 0.02, "{disc}");
        assert!((0.40..0.50).contains(&mean), "{mean}");
        assert!(
            (0.17..0.23).contains(&variance.sqrt()),
            "{}",
            variance.sqrt()
        );
    }

    #[test]
    fn gray_forms_turn_about_z_only() {
        let section = Section::new("target.phantom", json!("flower"));
        let placement = |rotate_deg| Placement {
            rotate_deg,
            ..Placement::default()
        };
        let refused = Phantom::build(&section, &placement([10.0, 0.0, 0.0]), "target");
        let text = refused.unwrap_err().to_string();
        assert!(text.starts_with("target.rotate_deg"), "{text}");
        // A quarter turn: what lay along x lies along y
        let [plain, turned] = [[0.0; 3], [0.0, 0.0, 90.0]].map(|angles| {
            let shape = phantom(json!("flower"), &placement(angles));
            shape
                .sample(&VolumeGrid::centered([1, 40, 40], 0.125))
                .unwrap()
        });
        for i in 0..40 {
            for j in 0..40 {
                assert!((plain.at(0, j, i) - turned.at(0, i, 39 - j)).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn every_example_builds() {
        for kind in PHANTOMS {
            let table: toml::Table = kind.example.parse().unwrap();
            let value = serde_json::to_value(&table["target"]["phantom"]).unwrap();
            phantom(value, &Placement::default());
        }
    }

    #[test]
    fn the_chiral_part_differs_from_its_mirror_image_in_every_turn() {
        let turned = |rotate_deg| {
            let placement = Placement {
                rotate_deg,
                ..Placement::default()
            };
            let grid = VolumeGrid::centered([32, 32, 32], 0.25);
            phantom(json!("chiral"), &placement).sample(&grid).unwrap()
        };
        let part = turned([0.0; 3]);
        let solid: f64 = part.values.iter().map(|&v| f64::from(v)).sum();
        let rows = part.values.chunks(32);
        let mirrored: Vec<f32> = rows.flat_map(|row| row.iter().rev().copied()).collect();
        for rx in [0.0, 90.0, 180.0, 270.0] {
            for ry in [0.0, 90.0, 180.0, 270.0] {
                for rz in [0.0, 90.0, 180.0, 270.0] {
                    let other = turned([rx, ry, rz]);
                    let pairs = other.values.iter().zip(&mirrored);
                    let difference: f64 = pairs.map(|(a, b)| f64::from((a - b).abs())).sum();
                    let share = difference / solid;
                    assert!(share > 0.1, "{rx} {ry} {rz}: {share}");
                }
            }
        }
    }
}
