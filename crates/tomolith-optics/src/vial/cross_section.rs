//! The outline of a wall in the plane z = const, centered on the axis.
//!
//! Tracers, models and pictures ask an outline and know none by name: another one is a variant here, with an arm in each method.

/// Where a ray crosses an outline: distance (mm), unit normal against the ray, number of the face below [`CrossSection::MOST_FACES`].
pub(crate) type PlaneCrossing = (f64, [f64; 2], u8);

/// Distances below this (mm) are the wall the ray has just passed.
const TOUCH: f64 = 1e-9;

/// The outline of a wall: a convex curve, symmetric about x and y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CrossSection {
    /// A circle of this radius, mm.
    Circle(f64),
    /// A square of this half width, mm, faces normal to x and y of the resin frame.
    Square(f64),
}

impl CrossSection {
    /// No outline has more faces.
    pub(crate) const MOST_FACES: u8 = 4;

    /// The radius of a circle, mm; None of other outlines.
    #[must_use]
    pub fn as_circle(self) -> Option<f64> {
        match self {
            CrossSection::Circle(r) => Some(r),
            CrossSection::Square(_) => None,
        }
    }

    /// Half of the width of a square, mm; None of other outlines.
    #[must_use]
    pub fn as_square(self) -> Option<f64> {
        match self {
            CrossSection::Square(w) => Some(w),
            CrossSection::Circle(_) => None,
        }
    }

    /// Whether a point is inside.
    #[must_use]
    pub fn contains(self, x: f64, y: f64) -> bool {
        match self {
            CrossSection::Circle(r) => x * x + y * y < r * r,
            CrossSection::Square(w) => x.abs().max(y.abs()) < w,
        }
    }

    /// Radius of the largest circle inside, mm.
    #[must_use]
    pub fn inscribed_radius(self) -> f64 {
        match self {
            CrossSection::Circle(r) | CrossSection::Square(r) => r,
        }
    }

    /// Radius of the smallest circle around it, mm.
    #[must_use]
    pub fn circumscribed_radius(self) -> f64 {
        match self {
            CrossSection::Circle(r) => r,
            CrossSection::Square(w) => w * std::f64::consts::SQRT_2,
        }
    }

    /// Corners, counterclockwise, mm; a circle has none.
    #[must_use]
    pub fn corners(self) -> Vec<[f64; 2]> {
        match self {
            CrossSection::Circle(_) => Vec::new(),
            CrossSection::Square(w) => vec![[w, w], [-w, w], [-w, -w], [w, -w]],
        }
    }

    /// Half of its chord along x (`direction` 0) or y (1) at this `distance` from the axis, mm; None beyond it.
    #[must_use]
    pub fn half_chord(self, _direction: usize, distance: f64) -> Option<f64> {
        match self {
            CrossSection::Circle(r) => {
                (distance < r).then(|| ((r - distance) * (r + distance)).sqrt())
            }
            CrossSection::Square(w) => (distance < w).then_some(w),
        }
    }

    /// Where a ray from the point `p` outside along the unit vector `d` gets in; None when it misses.
    pub(crate) fn enter(self, p: [f64; 2], d: [f64; 2]) -> Option<PlaneCrossing> {
        match self {
            CrossSection::Circle(r) => {
                let b = p[0] * d[0] + p[1] * d[1];
                let lateral = p[0] * d[1] - p[1] * d[0];
                let half_squared = (r - lateral.abs()) * (r + lateral.abs());
                if half_squared <= 0.0 {
                    return None;
                }
                let t = -b - half_squared.sqrt();
                (t > TOUCH).then(|| (t, [(p[0] + t * d[0]) / r, (p[1] + t * d[1]) / r], 0))
            }
            CrossSection::Square(w) => {
                // Slab method: the last of the entries is where the ray gets in
                let (mut near, mut far, mut axis) = (f64::NEG_INFINITY, f64::INFINITY, 0);
                for i in 0..2 {
                    if d[i] == 0.0 {
                        if p[i].abs() >= w {
                            return None;
                        }
                        continue;
                    }
                    let side = w * d[i].signum();
                    let entry = (-side - p[i]) / d[i];
                    if entry > near {
                        (near, axis) = (entry, i);
                    }
                    far = far.min((side - p[i]) / d[i]);
                }
                (near < far && near > TOUCH).then(|| through(near, axis, d, d[axis] < 0.0))
            }
        }
    }

    /// Where a ray from the point `p` inside along the unit vector `d` gets out.
    pub(crate) fn leave(self, p: [f64; 2], d: [f64; 2]) -> Option<PlaneCrossing> {
        match self {
            CrossSection::Circle(r) => {
                let b = p[0] * d[0] + p[1] * d[1];
                let lateral = p[0] * d[1] - p[1] * d[0];
                let t = -b + ((r - lateral.abs()) * (r + lateral.abs())).max(0.0).sqrt();
                Some((t, [-(p[0] + t * d[0]) / r, -(p[1] + t * d[1]) / r], 0))
            }
            CrossSection::Square(w) => {
                let (axis, t) = (0..2)
                    .filter(|&i| d[i] != 0.0)
                    .map(|i| (i, (w * d[i].signum() - p[i]) / d[i]))
                    .min_by(|a, b| a.1.total_cmp(&b.1))?;
                Some(through(t, axis, d, d[axis] > 0.0))
            }
        }
    }
}

/// A crossing of the upper or the lower face of a square normal to an axis.
fn through(distance: f64, axis: usize, d: [f64; 2], is_upper: bool) -> PlaneCrossing {
    let mut normal = [0.0; 2];
    normal[axis] = -d[axis].signum();
    (distance, normal, axis as u8 * 2 + u8::from(is_upper))
}
