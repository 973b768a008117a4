//! Edges of a wall, where a vial is rough or rounded: light that enters near them does not go where a tracer says.
//!
//! # Model
//! Edges of a prism are the upright lines through its corners. Of a net they are those where two faces meet at more than
//! [`SHARPEST`]: the facets of a round wall are no edges, its rims are.
//!
//! # Limits
//! All edges are compared with every point: nets with many sharp edges are slow.
//!
//! ```
//! use tomolith_optics::edges::Edges;
//! use tomolith_optics::surface::Surface;
//! use tomolith_optics::vial::CrossSection;
//! let edges = Edges::of(&Surface::Prism(CrossSection::Square(3.0)));
//! assert!((edges.distance_mm([3.0, -2.6, 7.0]) - 0.4).abs() < 1e-12); // 0.4 mm along the face
//! assert!(Edges::of(&Surface::Prism(CrossSection::Circle(3.0))).is_empty());
//! ```

use super::surface::Surface;
use std::collections::HashMap;
use tomolith_core::vector::{cross, dot, minus, unit};

/// Faces that meet at a smaller angle than this (30°, in rad) make no edge.
pub const SHARPEST: f64 = std::f64::consts::FRAC_PI_6;

/// The edges of a wall.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Edges {
    /// Straight lines between two points, mm; lines of a prism are as long as anything that matters.
    lines: Vec<[[f64; 3]; 2]>,
}

/// Half the length of an edge without end, mm.
const ENDLESS: f64 = 1e6;

impl Edges {
    /// The edges of a surface.
    #[must_use]
    pub fn of(surface: &Surface) -> Self {
        match surface {
            // Of a vial with ends the upright edges, as without them
            Surface::Prism(curve) | Surface::Can(curve, _) => Edges {
                lines: (curve.corners().into_iter())
                    .map(|[x, y]| [[x, y, -ENDLESS], [x, y, ENDLESS]])
                    .collect(),
            },
            Surface::Net(net) => Edges {
                lines: sharp(net.corners()),
            },
        }
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// Distance of a point from the nearest edge, mm.
    #[must_use]
    pub fn distance_mm(&self, point: [f64; 3]) -> f64 {
        let to_line = |&[a, b]: &[[f64; 3]; 2]| {
            let (along, from) = (minus(b, a), minus(point, a));
            let part = (dot(from, along) / dot(along, along)).clamp(0.0, 1.0);
            let away: [f64; 3] = std::array::from_fn(|i| from[i] - part * along[i]);
            dot(away, away).sqrt()
        };
        self.lines.iter().map(to_line).fold(f64::INFINITY, f64::min)
    }
}

/// Lines at which two triangles meet at a large angle.
fn sharp(triangles: impl Iterator<Item = [[f64; 3]; 3]>) -> Vec<[[f64; 3]; 2]> {
    let bits = |point: [f64; 3]| point.map(|v| (v + 0.0).to_bits());
    let mut normals: HashMap<[[u64; 3]; 2], [f64; 3]> = HashMap::new();
    let mut lines = Vec::new();
    for [a, b, c] in triangles {
        let normal = unit(cross(minus(b, a), minus(c, a)));
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let mut key = [bits(from), bits(to)];
            key.sort_unstable();
            match normals.remove(&key) {
                None => drop(normals.insert(key, normal)),
                Some(other) if dot(normal, other) < SHARPEST.cos() => lines.push([from, to]),
                Some(_) => {}
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::Net;
    use std::sync::Arc;
    use tomolith_io::mesh::samples::cuboid;

    #[test]
    fn a_box_of_triangles_has_twelve_edges_and_no_diagonals() {
        let mesh = cuboid([-1.0, -2.0, -3.0], [1.0, 2.0, 3.0]);
        let edges = Edges::of(&Surface::Net(Arc::new(Net::new(&mesh, "mesh").unwrap())));
        assert_eq!(edges.lines.len(), 12);
        // The middle of a face lies on its diagonal
        for (point, distance) in [
            ([1.0, 0.0, 0.0], 2.0),
            ([1.0, 1.7, 0.0], 0.3),
            ([0.6, -0.5, 3.0], 0.4),
            ([2.0, 2.0, 4.0], 2.0f64.sqrt()),
        ] {
            let found = edges.distance_mm(point);
            assert!((found - distance).abs() < 1e-12, "{point:?}: {found}");
        }
    }
}
