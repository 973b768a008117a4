//! The connected parts of a surface: their volumes, and which lie in which.

use super::Diagnosis;
use super::edges::turn;
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

/// A connected part of the surface.
#[derive(Default)]
struct Shell {
    triangles: Vec<u32>,
    low: [f64; 3],
    high: [f64; 3],
    volume: f64,
}

fn shells(mesh: &Mesh) -> Vec<Shell> {
    let mut groups = Groups::of_shells(mesh);
    let mut slot = vec![u32::MAX; mesh.vertices.len()];
    let mut shells: Vec<Shell> = Vec::new();
    for (t, triangle) in mesh.triangles.iter().enumerate() {
        let group = groups.of(triangle[0]) as usize;
        if slot[group] == u32::MAX {
            slot[group] = shells.len() as u32;
            shells.push(Shell {
                low: [f64::INFINITY; 3],
                high: [f64::NEG_INFINITY; 3],
                ..Shell::default()
            });
        }
        shells[slot[group] as usize].triangles.push(t as u32);
    }
    shells.iter_mut().par_each(|shell| shell.measure(mesh));
    shells
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

    fn box_holds(&self, p: [f64; 3]) -> bool {
        (0..3).all(|i| self.low[i] <= p[i] && p[i] <= self.high[i])
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
                let under = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
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
    let shells = shells(mesh);
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
    let point = mesh.corners(shell.triangles[0] as usize)[0];
    let size = |j: &usize| shells[*j].volume.abs();
    let around: Vec<usize> = (0..shells.len())
        .filter(|&j| j != i && shells[j].volume.abs() > shell.volume.abs())
        .filter(|&j| shells[j].box_holds(point) && shells[j].winding(mesh, point).abs() > 0.5)
        .collect();
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

/// Turns shells of negative volume that lie in no other shell; notes all volumes.
pub(super) fn turn_lone_shells(mesh: &mut Mesh, found: &mut Diagnosis) {
    let mut shells = shells(mesh);
    let lone: Vec<bool> = shells.iter().enumerate().par_map(|(i, shell)| {
        shell.volume < 0.0 && {
            let point = mesh.corners(shell.triangles[0] as usize)[0];
            let others = shells.iter().enumerate().filter(|(j, _)| *j != i);
            let winding: f64 = others
                .filter(|(_, other)| other.box_holds(point))
                .map(|(_, other)| other.winding(mesh, point))
                .sum();
            winding < 0.5
        }
    });
    for (shell, lone) in shells.iter_mut().zip(lone) {
        if lone {
            for &t in &shell.triangles {
                turn(&mut mesh.triangles[t as usize]);
            }
            shell.volume = -shell.volume;
            found
                .turned_shells_at
                .push(mesh.corners(shell.triangles[0] as usize)[0]);
        }
    }
    found.shell_volumes_mm3 = shells.iter().map(|s| s.volume).collect();
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_io::mesh::samples::{cuboid, inverted, together};

    #[test]
    fn bodies_keep_their_cavities_and_what_lies_in_a_cavity_is_a_body_of_its_own() {
        let cube = |half: f64, x: f64| cuboid([x - half, -half, -half], [x + half, half, half]);
        // A box with a cavity, in it a ball of wood with a hole; beside it a small box, inside out
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
}
