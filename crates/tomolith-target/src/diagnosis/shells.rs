//! The connected parts of a surface: their volumes, and which lie in which.

use super::Diagnosis;
use super::edges::{Edges, turn};
use std::collections::HashMap;
use tomolith_core::parallel::InParallel;
use tomolith_core::vector::{cross, dot, minus};
use tomolith_io::mesh::Mesh;

/// Sets that can be joined (union by path halving).
pub(super) struct Groups(Vec<u32>);

impl Groups {
    pub(super) fn new(count: usize) -> Self {
        Groups((0..count as u32).collect())
    }

    /// Vertices that triangles connect.
    pub(super) fn of_shells(mesh: &Mesh) -> Self {
        let mut groups = Groups::new(mesh.vertices.len());
        for &[a, b, c] in &mesh.triangles {
            groups.join(a, b);
            groups.join(b, c);
        }
        groups
    }

    pub(super) fn of(&mut self, mut item: u32) -> u32 {
        while self.0[item as usize] != item {
            let parent = self.0[item as usize];
            self.0[item as usize] = self.0[parent as usize];
            item = self.0[item as usize];
        }
        item
    }

    pub(super) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.of(a), self.of(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}

/// Shells whose volumes differ by less than this share may be copies of each other: neither lies in the other.
const SAME: f64 = 1e-9;

/// A point lies on a triangle when the tangent of half its solid angle is that of a plane up to this share: a hundred
/// times the rounding of coordinates in f32.
const ON_IT: f64 = 1e-5;

/// Triangles of a shell that are looked at, at most, to see whether it lies in another.
const LOOKS: usize = 4;

/// A connected part of the surface.
#[derive(Default)]
struct Shell {
    triangles: Vec<u32>,
    low: [f64; 3],
    high: [f64; 3],
    volume: f64,
}

/// The parts of a surface, by the number of its group for each triangle.
fn shells(mesh: &Mesh, group: impl FnMut(usize) -> u32) -> Vec<Shell> {
    let mut slots = HashMap::new();
    let mut shells: Vec<Shell> = Vec::new();
    for (t, group) in (0..mesh.triangles.len()).map(group).enumerate() {
        let slot = *slots.entry(group).or_insert(shells.len());
        if slot == shells.len() {
            shells.push(Shell {
                low: [f64::INFINITY; 3],
                high: [f64::NEG_INFINITY; 3],
                ..Shell::default()
            });
        }
        shells[slot].triangles.push(t as u32);
    }
    shells.iter_mut().par_each(|shell| shell.measure(mesh));
    shells
}

/// Triangles that edges connect. Where more than two meet in an edge, surfaces that are closed without the others only
/// touch them.
fn closed_surfaces(mesh: &Mesh) -> Groups {
    let mut groups = Groups::new(mesh.triangles.len());
    let edges = Edges::new(mesh);
    let (pairs, others): (Vec<_>, Vec<_>) = edges.iter().partition(|sides| sides.len() == 2);
    for sides in pairs {
        groups.join(sides[0].triangle, sides[1].triangle);
    }
    for sides in others {
        let mut here: Vec<u32> = sides.iter().map(|s| groups.of(s.triangle)).collect();
        here.sort_unstable();
        let is_closed = |surface: &[u32]| surface.len().is_multiple_of(2);
        if !here.chunk_by(|a, b| a == b).all(is_closed) {
            here.windows(2)
                .for_each(|pair| groups.join(pair[0], pair[1]));
        }
    }
    groups
}

impl Shell {
    fn measure(&mut self, mesh: &Mesh) {
        let origin = mesh.corners(self.triangles[0] as usize)[0];
        for &t in &self.triangles {
            let corners = mesh.corners(t as usize);
            for corner in corners {
                for (i, &v) in corner.iter().enumerate() {
                    self.low[i] = self.low[i].min(v);
                    self.high[i] = self.high[i].max(v);
                }
            }
            let [a, b, c] = corners.map(|p| minus(p, origin));
            self.volume += dot(a, cross(b, c)) / 6.0;
        }
    }

    /// Whether the other shell lies in this one; it may touch it, and not cross it. Judged by a few of its triangles.
    fn holds(&self, mesh: &Mesh, other: &Shell) -> bool {
        let in_box = (0..3).all(|i| self.low[i] <= other.low[i] && other.high[i] <= self.high[i]);
        if !in_box || other.volume.abs() >= (1.0 - SAME) * self.volume.abs() {
            return false;
        }
        let mut is_inside = false;
        for &t in other
            .triangles
            .iter()
            .step_by(other.triangles.len().div_ceil(LOOKS))
        {
            let corners = mesh.corners(t as usize);
            let middle = std::array::from_fn(|i| corners.iter().map(|c| c[i]).sum::<f64>() / 3.0);
            let winding = self.winding(mesh, middle).abs();
            // On a flat face it is a half, on a convex edge less
            if winding < 0.2 {
                return false;
            }
            is_inside |= winding > 0.8;
        }
        is_inside
    }

    /// Winding number of the shell round a point: its solid angle over 4π (Van Oosterom and Strackee 1983, Eq. 8).
    fn winding(&self, mesh: &Mesh, point: [f64; 3]) -> f64 {
        let angle: f64 = self
            .triangles
            .iter()
            .map(|&t| {
                let [a, b, c] = mesh.corners(t as usize).map(|p| minus(p, point));
                let [la, lb, lc] = [a, b, c].map(|v| dot(v, v).sqrt());
                let over = dot(a, cross(b, c));
                let scale = la * lb * lc;
                let under = scale + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
                // On the triangle itself it is half a turn to either side: none, in the mean
                if over.abs() <= ON_IT * scale && under <= ON_IT * scale {
                    return 0.0;
                }
                2.0 * over.atan2(under)
            })
            .sum();
        angle / (4.0 * std::f64::consts::PI)
    }
}

/// The separate bodies of a mesh, the largest first: shells with the cavities in them.
///
/// A shell that looks the other way than the outermost shell around it is a cavity of the smallest shell that holds it;
/// any other one, also when it lies in a cavity, is a body. Shells that share a vertex are one.
pub(crate) fn components(mesh: &Mesh) -> Vec<Mesh> {
    let mut groups = Groups::of_shells(mesh);
    let shells = shells(mesh, |t| groups.of(mesh.triangles[t][0]));
    let owners: Vec<usize> = (0..shells.len()).par_map(|i| owner(mesh, &shells, i));
    let mut bodies: Vec<usize> = (0..shells.len()).filter(|&i| owners[i] == i).collect();
    let size = |i: usize| shells[i].volume.abs();
    bodies.sort_by(|&a, &b| size(b).total_cmp(&size(a)).then(a.cmp(&b)));
    let corners = |i: usize| {
        shells[i]
            .triangles
            .iter()
            .map(|&t| mesh.corners(t as usize))
    };
    bodies
        .iter()
        .map(|&body| {
            let parts = (0..shells.len()).filter(|&i| owners[i] == body);
            Mesh::of_corners(parts.flat_map(corners))
        })
        .collect()
}

/// The shell whose cavity shell `i` is, or itself.
fn owner(mesh: &Mesh, shells: &[Shell], i: usize) -> usize {
    let shell = &shells[i];
    let size = |j: &usize| shells[*j].volume.abs();
    let around = holders(mesh, shells, i);
    let by_size = |a: &usize, b: &usize| size(a).total_cmp(&size(b));
    let Some(outermost) = around.iter().copied().max_by(by_size) else {
        return i;
    };
    let outward = shells[outermost].volume.signum();
    if shell.volume.signum() == outward {
        return i;
    }
    let holders = around
        .into_iter()
        .filter(|&j| shells[j].volume.signum() == outward);
    holders.min_by(by_size).unwrap_or(i)
}

fn holders(mesh: &Mesh, shells: &[Shell], i: usize) -> Vec<usize> {
    (0..shells.len())
        .filter(|&j| j != i && shells[j].holds(mesh, &shells[i]))
        .collect()
}

/// Turns bodies that are inside out: a shell of negative volume that lies in no solid is turned, and all shells in it are
/// turned with it, so that the cavities of a mirrored part stay cavities. Notes all volumes.
pub(super) fn turn_bodies(mesh: &mut Mesh, found: &mut Diagnosis) {
    let mut groups = closed_surfaces(mesh);
    let mut shells = shells(mesh, |t| groups.of(t as u32));
    let mut order: Vec<usize> = (0..shells.len()).collect();
    let size = |i: usize| shells[i].volume.abs();
    order.sort_by(|&a, &b| size(b).total_cmp(&size(a)));
    let inward = |i: usize| shells[i].volume < 0.0;
    let mut around: Vec<Option<Vec<usize>>> =
        (0..shells.len()).par_map(|i| inward(i).then(|| holders(mesh, &shells, i)));
    let mut turned = vec![false; shells.len()];
    // From the largest, so that what holds a shell looks the right way already
    for i in order {
        if shells[i].volume >= 0.0 {
            continue;
        }
        let around = around[i]
            .take()
            .unwrap_or_else(|| holders(mesh, &shells, i));
        let winding: f64 = around.iter().map(|&j| shells[j].volume.signum()).sum();
        if winding > 0.0 {
            continue;
        }
        let body: Vec<bool> =
            (0..shells.len()).par_map(|j| j == i || shells[i].holds(mesh, &shells[j]));
        for j in (0..shells.len()).filter(|&j| body[j]) {
            shells[j].volume = -shells[j].volume;
            turned[j] = !turned[j];
        }
    }
    for (shell, _) in shells.iter().zip(&turned).filter(|(_, turned)| **turned) {
        for &t in &shell.triangles {
            turn(&mut mesh.triangles[t as usize]);
        }
        let at = mesh.corners(shell.triangles[0] as usize)[0];
        found.turned_shells_at.push(at);
    }
    found.inside_out = !turned.contains(&false);
    found.shell_volumes_mm3 = shells.iter().map(|s| s.volume).collect();
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_io::mesh::samples::{cuboid, inverted, together};

    #[test]
    fn bodies_keep_their_cavities_and_what_lies_in_a_cavity_is_a_body_of_its_own() {
        let cube = |half: f64, x: f64| cuboid([x - half, -half, -half], [x + half, half, half]);
        // A box with a cavity, in it a ball of wood with a hole; next to it a small box, inside out
        let all = [
            cube(1.0, 0.0),
            cube(4.0, 0.0),
            inverted(cube(2.0, 0.0)),
            inverted(cube(0.5, 0.0)),
            inverted(cube(0.7, 6.0)),
        ];
        for mesh in [together(&all), inverted(together(&all))] {
            let bodies = components(&mesh);
            let volumes: Vec<f64> = bodies.iter().map(|b| b.signed_volume().abs()).collect();
            let expected = [512.0 - 64.0, 8.0 - 1.0, 1.4f64.powi(3)];
            assert_eq!(volumes.len(), 3);
            for (volume, expected) in volumes.iter().zip(expected) {
                assert!((volume - expected).abs() < 1e-9, "{volumes:?}");
            }
        }
    }

    fn volumes_after_turning(shells: &[Mesh]) -> Vec<f64> {
        let mut found = Diagnosis::default();
        turn_bodies(&mut together(shells), &mut found);
        found.shell_volumes_mm3.iter().map(|v| v.round()).collect()
    }

    #[test]
    fn a_body_that_is_inside_out_is_turned_with_all_that_lies_in_it() {
        let cube = |half: f64, x: f64| cuboid([x - half, -half, -half], [x + half, half, half]);
        let hollow = |x: f64| [cube(2.0, x), inverted(cube(1.0, x))];
        let mirrored = |x: f64| hollow(x).map(inverted);
        let all = |pair: [[Mesh; 2]; 2]| volumes_after_turning(pair.as_flattened());
        for pair in [
            [hollow(0.0), hollow(6.0)],
            [hollow(0.0), mirrored(6.0)],
            [mirrored(0.0), mirrored(6.0)],
        ] {
            assert_eq!(all(pair), [64.0, -8.0, 64.0, -8.0]);
        }
        // In the cavity of a part a part, either of them mirrored
        let inner = |sign: bool| {
            let pair = [cube(0.75, 0.0), inverted(cube(0.5, 0.0))];
            if sign { pair } else { pair.map(inverted) }
        };
        for (outer, inner) in [
            (hollow(0.0), inner(true)),
            (hollow(0.0), inner(false)),
            (mirrored(0.0), inner(true)),
            (mirrored(0.0), inner(false)),
        ] {
            assert_eq!(all([outer, inner]), [64.0, -8.0, 3.0, -1.0]);
        }
        // Shells that look the same way are one solid, whichever way that is
        let nested = [cube(2.0, 0.0), cube(1.0, 0.0)];
        assert_eq!(volumes_after_turning(&nested), [64.0, 8.0]);
        assert_eq!(volumes_after_turning(&nested.map(inverted)), [64.0, 8.0]);
    }

    #[test]
    fn bodies_that_touch_in_an_edge_or_a_corner_are_turned_each_for_itself() {
        let one = cuboid([0.0; 3], [2.0; 3]);
        for low in [[2.0, 2.0, 0.0], [2.0; 3]] {
            let other = inverted(cuboid(low, low.map(|v| v + 2.0)));
            let mut mesh = together(&[one.clone(), other]).welded();
            turn_bodies(&mut mesh, &mut Diagnosis::default());
            assert!((mesh.signed_volume() - 16.0).abs() < 1e-12);
        }
    }

    #[test]
    fn shells_that_cross_do_not_lie_in_each_other() {
        let (one, two) = (cuboid([0.0; 3], [2.0; 3]), cuboid([1.0; 3], [3.0; 3]));
        // The second is a rod through the cube
        let rod = cuboid([0.5, 0.5, -1.0], [1.0, 1.0, 3.0]);
        for other in [two, rod] {
            let expected = other.signed_volume().round();
            for [a, b] in [
                [one.clone(), inverted(other.clone())],
                [inverted(one.clone()), other.clone()],
            ] {
                assert_eq!(
                    volumes_after_turning(&[a.clone(), b.clone()]),
                    [8.0, expected]
                );
                assert_eq!(volumes_after_turning(&[b, a]), [expected, 8.0]);
            }
        }
        // A cavity that touches the wall is one
        let touching = inverted(cuboid([0.0, 0.5, 0.5], [1.0, 1.5, 1.5]));
        assert_eq!(volumes_after_turning(&[one, touching]), [8.0, -1.0]);
    }
}
