//! A wheel with straight-flanked teeth: the outline of the gear and of the Siemens star.
//!
//! The outline is its own mirror image in 2·count planes through the axis, so a point is folded into the wedge between the
//! middle of a tooth (angle 0) and the middle of a gap (angle π/count). There the outline is an arc at the tip radius up
//! to `tip_angle`, a straight flank, and an arc at the root radius from `root_angle` on.

use std::f64::consts::{PI, TAU};

/// Radii in mm, angles in rad from the middle of a tooth; `tip_angle ≤ root_angle ≤ π/count`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wheel {
    pub(super) count: u32,
    pub(super) root: f64,
    pub(super) tip: f64,
    pub(super) root_angle: f64,
    pub(super) tip_angle: f64,
}

impl Wheel {
    /// Signed distance to the outline.
    pub(super) fn distance(&self, [x, y]: [f64; 2]) -> f64 {
        let radius = x.hypot(y);
        let wedge = TAU / f64::from(self.count);
        let angle = y.atan2(x).rem_euclid(wedge);
        let angle = angle.min(wedge - angle);
        let (sin, cos) = angle.sin_cos();
        let p = [radius * cos, radius * sin];
        let [foot, head] = self.flank();
        let mut nearest = to_segment(p, foot, head);
        if angle <= self.tip_angle {
            nearest = nearest.min((radius - self.tip).abs());
        }
        if angle >= self.root_angle {
            nearest = nearest.min((radius - self.root).abs());
        }
        let left = (head[0] - foot[0]) * (p[1] - foot[1]) - (head[1] - foot[1]) * (p[0] - foot[0]);
        let inside = radius < self.root || (radius < self.tip && left < 0.0);
        if inside { -nearest } else { nearest }
    }

    /// Area: ½∮ r² dφ over arcs and flanks.
    pub(super) fn area(&self) -> f64 {
        let [foot, head] = self.flank();
        let flank = (head[0] * foot[1] - head[1] * foot[0]) / 2.0;
        let tip = self.tip.powi(2) * self.tip_angle / 2.0;
        let root = self.root.powi(2) * (PI / f64::from(self.count) - self.root_angle) / 2.0;
        2.0 * f64::from(self.count) * (tip + flank + root)
    }

    fn flank(&self) -> [[f64; 2]; 2] {
        let polar = |r: f64, angle: f64| [r * angle.cos(), r * angle.sin()];
        [
            polar(self.root, self.root_angle),
            polar(self.tip, self.tip_angle),
        ]
    }
}

fn to_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let share = (to[0] * along[0] + to[1] * along[1]) / (along[0].powi(2) + along[1].powi(2));
    let share = share.clamp(0.0, 1.0);
    (to[0] - share * along[0]).hypot(to[1] - share * along[1])
}
