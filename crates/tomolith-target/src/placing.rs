//! Where a shape stands: rotation, size, offset.
//!
//! A point p of the file goes to `s·R·p + t`: first the rotation R = R_z·R_y·R_x (about the fixed axes of the frame: first
//! about x, then about y, then about z; counter-clockwise seen from the tip of the axis), then the scale s, then the shift
//! t, which brings the middle of the box to the origin (unless `center = false`) and then to `offset_mm`.
//!
//! ```
//! use tomolith_target::Placement;
//! let placement = Placement { size_mm: Some(8.0), rotate_deg: [0.0, 0.0, 90.0], ..Placement::default() };
//! // A bar 4 long along x: turned to y, doubled so that its longest edge is 8, its middle at the origin
//! let map = placement.map(&[[10.0, 0.0, 0.0], [14.0, 0.0, 0.0]], 0.0, "target").unwrap();
//! let end = map.apply([14.0, 0.0, 0.0]);
//! assert!(end[0].abs() < 1e-12 && (end[1] - 4.0).abs() < 1e-12);
//! ```

use tomolith_core::error::{Error, Result};
use tomolith_core::units::exact;
use tomolith_io::mesh::Mesh;

/// How a shape is placed; by default in true size with the middle of its box at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Longest edge of the box after the rotation, mm (> 0). Not together with `scale`.
    pub size_mm: Option<f64>,
    /// Factor on all lengths (> 0). Not together with `size_mm`.
    pub scale: Option<f64>,
    /// Angles about x, y and z, degrees, applied in this order about fixed axes.
    pub rotate_deg: [f64; 3],
    /// Where the middle of the box (or the file's origin) goes, mm.
    pub offset_mm: [f64; 3],
    /// Whether the middle of the box comes to the origin before the offset.
    pub center: bool,
}

impl Default for Placement {
    fn default() -> Self {
        Placement {
            size_mm: None,
            scale: None,
            rotate_deg: [0.0; 3],
            offset_mm: [0.0; 3],
            center: true,
        }
    }
}

/// p → scale·rotation·p + shift
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Map {
    /// Rows of the rotation matrix.
    pub rotation: [[f64; 3]; 3],
    /// Factor on lengths, > 0.
    pub scale: f64,
    /// Added last, mm.
    pub shift: [f64; 3],
}

impl Placement {
    /// The map of a shape whose hull is these points, each with a ball of radius `round` about it.
    ///
    /// # Errors
    /// [`Error::Config`] under the key path `section` when a number is not finite, a size or scale is not positive, or
    /// both are given.
    pub fn map(&self, hull: &[[f64; 3]], round: f64, section: &str) -> Result<Map> {
        self.check().map_err(|e| e.under(section))?;
        let rotation = rotation(self.rotate_deg);
        let turned = Map {
            rotation,
            scale: 1.0,
            shift: [0.0; 3],
        };
        let [low, high] = bounds(hull.iter().map(|&p| turned.apply(p)), round);
        let longest = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        let scale = match (self.size_mm, self.scale) {
            (Some(size), _) => size / longest,
            (None, Some(scale)) => scale,
            (None, None) => 1.0,
        };
        if !(scale.is_finite() && scale > 0.0) {
            return Err(Error::config(
                format!("{section}.size_mm"),
                format!("a shape of size {longest} cannot be scaled"),
                "a shape with an extent",
            ));
        }
        let shift = std::array::from_fn(|i| {
            let middle = if self.center {
                scale * (low[i] + high[i]) / 2.0
            } else {
                0.0
            };
            self.offset_mm[i] - middle
        });
        Ok(Map {
            rotation,
            scale,
            shift,
        })
    }

    /// Refuses numbers that place nothing.
    pub(super) fn check(&self) -> Result<()> {
        if self.size_mm.is_some() && self.scale.is_some() {
            return Err(Error::config(
                "scale",
                "both `size_mm` and `scale` are given",
                "one of them, or neither for true size",
            ));
        }
        for (key, value) in [("size_mm", self.size_mm), ("scale", self.scale)] {
            if let Some(value) = value
                && !(value.is_finite() && value > 0.0)
            {
                return Err(Error::refused(key, exact(value), "a number > 0"));
            }
        }
        for (key, values) in [
            ("rotate_deg", self.rotate_deg),
            ("offset_mm", self.offset_mm),
        ] {
            if values.iter().any(|v| !v.is_finite()) {
                return Err(Error::config(
                    key,
                    format!("{values:?}"),
                    "three finite numbers [x, y, z]",
                ));
            }
        }
        Ok(())
    }
}

impl Map {
    /// The identity map.
    pub const IDENTITY: Map = Map {
        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        scale: 1.0,
        shift: [0.0; 3],
    };

    /// Where a point of the shape's own frame goes, mm.
    #[must_use]
    pub fn apply(&self, p: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| {
            let row = self.rotation[i];
            self.scale * (row[0] * p[0] + row[1] * p[1] + row[2] * p[2]) + self.shift[i]
        })
    }

    /// Which point of the shape's own frame comes to `p`.
    #[must_use]
    pub fn undo(&self, p: [f64; 3]) -> [f64; 3] {
        let q: [f64; 3] = std::array::from_fn(|i| (p[i] - self.shift[i]) / self.scale);
        std::array::from_fn(|i| (0..3).map(|row| self.rotation[row][i] * q[row]).sum())
    }

    /// Moves all vertices of a mesh.
    pub fn apply_to(&self, mesh: &mut Mesh) {
        for vertex in &mut mesh.vertices {
            *vertex = self.apply(*vertex);
        }
    }
}

/// Box `[low, high]` of points with a ball of radius `round` about each.
pub(super) fn bounds(points: impl Iterator<Item = [f64; 3]>, round: f64) -> [[f64; 3]; 2] {
    let mut low = [f64::INFINITY; 3];
    let mut high = [f64::NEG_INFINITY; 3];
    for p in points {
        for i in 0..3 {
            low[i] = low[i].min(p[i] - round);
            high[i] = high[i].max(p[i] + round);
        }
    }
    [low, high]
}

/// R_z·R_y·R_x; quarter turns are exact.
fn rotation(degrees: [f64; 3]) -> [[f64; 3]; 3] {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.map(sine_and_cosine);
    [
        [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
        [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
        [-sy, cy * sx, cy * cx],
    ]
}

/// Exact at multiples of 90°, so that a quarter turn does not tilt a wall by 1e-16 off the grid.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    let turns = degrees.rem_euclid(360.0);
    match turns {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => turns.to_radians().sin_cos(),
    }
}

/// A mesh turned about the middle of its box, which comes to the origin.
#[cfg(test)]
pub(crate) fn turned(mut mesh: Mesh, rotate_deg: [f64; 3]) -> Mesh {
    let placement = Placement {
        rotate_deg,
        ..Placement::default()
    };
    let map = placement.map(&mesh.vertices, 0.0, "target").unwrap();
    map.apply_to(&mut mesh);
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(rotate_deg: [f64; 3]) -> Map {
        let placement = Placement {
            rotate_deg,
            ..Placement::default()
        };
        placement.map(&[[0.0; 3]], 1.0, "target").unwrap()
    }

    #[test]
    fn rotations_turn_counter_clockwise_about_fixed_axes_in_the_order_x_y_z() {
        // x → y about z, y → z about x, z → x about y
        let [x, y, z] = Map::IDENTITY.rotation;
        assert_eq!(map([0.0, 0.0, 90.0]).apply(x), y);
        assert_eq!(map([90.0, 0.0, 0.0]).apply(y), z);
        assert_eq!(map([0.0, 90.0, 0.0]).apply(z), x);
        // First about x (y → z), then about the fixed z (z stays): the other order would give x → … → y → z
        assert_eq!(map([90.0, 0.0, 90.0]).apply(y), z);
    }

    #[test]
    fn undo_is_the_inverse() {
        let placement = Placement {
            scale: Some(2.5),
            rotate_deg: [20.0, -35.0, 110.0],
            offset_mm: [1.0, 2.0, 3.0],
            ..Placement::default()
        };
        let map = placement
            .map(&[[0.0; 3], [1.0, 2.0, 3.0]], 0.0, "target")
            .unwrap();
        let p = [0.3, -0.7, 1.9];
        let back = map.undo(map.apply(p));
        for i in 0..3 {
            assert!((back[i] - p[i]).abs() < 1e-14, "{back:?}");
        }
    }

    #[test]
    fn bad_numbers_are_named() {
        let plain = Placement::default();
        let refused = |placement: Placement| {
            let map = placement.map(&[[0.0; 3], [1.0; 3]], 0.0, "target");
            map.unwrap_err().to_string()
        };
        let size = |mm: f64, scale: Option<f64>| Placement {
            size_mm: Some(mm),
            scale,
            ..plain
        };
        assert!(refused(size(1.0, Some(1.0))).starts_with("target.scale: both"));
        assert_eq!(
            refused(size(-1.0, None)),
            "target.size_mm: found -1; accepted: a number > 0"
        );
        let nan = Placement {
            offset_mm: [0.0, f64::NAN, 0.0],
            ..plain
        };
        assert!(refused(nan).starts_with("target.offset_mm: [0.0, NaN, 0.0]"));
    }
}
