//! What is wrong with a mesh, in words, and the mesh made closed and outward.
//!
//! A solid is what lies where the winding number is positive. That needs a closed surface that looks outward, so a mesh
//! goes through five steps, and every change is said in [`Diagnosis::sentences`]:
//!
//! 1. **Orientation**: neighbours that disagree (an edge used twice in the same direction) are turned, the minority of a
//!    patch to the majority.
//! 2. **Holes**: edges without a partner are closed by a fan to the middle of their loop. That closes flat holes exactly
//!    and others plausibly.
//! 3. **Inside out**: with negative volume as a whole, all triangles are turned.
//! 4. **Shells**: a shell of negative volume inside another shell is a cavity and stays; one that lies in no shell is
//!    turned.
//! 5. **Overlap**: lines on a lattice of 256 along the longer of y and z look for winding numbers above 1 (shells that
//!    intersect or lie in each other: their union counts) or below 0 (surfaces that pass through themselves; such
//!    places count as outside). It finds overlaps that are thicker than 1/256 of the part; thinner ones, and
//!    surfaces that only touch, go unnoticed and change the print by less than that.

use crate::error::{Error, Result};
use crate::grid::VolumeGrid;
use crate::io::mesh::{Mesh, cross, dot, minus};
use rayon::prelude::*;
use std::collections::HashMap;
use std::path::Path;

use super::lines::{Lines, Scaled};

/// Lines along the longer of y and z that look for overlaps.
const LATTICE: f64 = 256.0;

/// A mesh counts as flat when its volume is below this share of area × diagonal: 10⁴ times the rounding of the sum.
const FLAT: f64 = 1e-12;

/// What was found in a mesh; lengths in mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnosis {
    /// Triangles, without those that close holes.
    pub triangles: usize,
    /// Edges of one triangle only.
    pub open_edges: usize,
    /// A point on an open edge.
    pub open_at: Option<[f64; 3]>,
    /// Holes that were closed by a fan.
    pub holes: usize,
    /// Edges of three or more triangles.
    pub non_manifold_edges: usize,
    /// A point on such an edge.
    pub non_manifold_at: Option<[f64; 3]>,
    /// Edges whose two triangles disagree about the outside.
    pub inconsistent_edges: usize,
    /// Triangles that were turned to agree with their neighbours.
    pub turned_triangles: usize,
    /// Whether the whole mesh was inside out.
    pub inside_out: bool,
    /// Volume of every shell after all repairs, cavities negative, mm³.
    pub shell_volumes_mm3: Vec<f64>,
    /// Shells that were inside out on their own and were turned: a point on each.
    pub turned_shells_at: Vec<[f64; 3]>,
    /// Volume where the winding number is 2 or more, mm³.
    pub overlap_mm3: f64,
    /// A point there.
    pub overlap_at: Option<[f64; 3]>,
    /// Volume where the winding number is negative, mm³.
    pub negative_mm3: f64,
    /// A point there.
    pub negative_at: Option<[f64; 3]>,
}

impl Diagnosis {
    /// Sum over the shells, cavities subtracted, mm³.
    #[must_use]
    pub fn signed_volume_mm3(&self) -> f64 {
        self.shell_volumes_mm3.iter().sum()
    }

    /// Whether the winding number was seen to be 0 or 1 everywhere.
    #[must_use]
    pub fn is_simple(&self) -> bool {
        self.overlap_at.is_none() && self.negative_at.is_none()
    }

    /// One sentence for each thing that people should know; empty for a sound mesh.
    #[must_use]
    pub fn sentences(&self) -> Vec<String> {
        let mut said = Vec::new();
        if let Some(at) = self.open_at {
            said.push(format!(
                "The mesh is open: {} edges have one triangle only, the first near {}; {} {} closed by flat fans.",
                self.open_edges,
                place(at),
                self.holes,
                if self.holes == 1 { "hole was" } else { "holes were" },
            ));
        }
        if let Some(at) = self.non_manifold_at {
            said.push(format!(
                "{} edges belong to more than two triangles, the first near {}: shells that touch, or doubled faces.",
                self.non_manifold_edges,
                place(at)
            ));
        }
        if self.inconsistent_edges > 0 {
            said.push(format!(
                "Neighbouring triangles disagree about the outside at {} edges; {} triangles were turned.",
                self.inconsistent_edges, self.turned_triangles
            ));
        }
        if self.inside_out {
            said.push(
                "The whole mesh was inside out (negative volume); all triangles were turned."
                    .into(),
            );
        }
        if let Some(&at) = self.turned_shells_at.first() {
            said.push(format!(
                "{} of {} shells were inside out and lie in no other shell, the first near {}; they were turned.",
                self.turned_shells_at.len(),
                self.shell_volumes_mm3.len(),
                place(at)
            ));
        }
        if let Some(at) = self.overlap_at {
            said.push(format!(
                "Shells overlap or lie in each other over about {:.3} mm³, the longest stretch near {}; their union is printed.",
                self.overlap_mm3,
                place(at)
            ));
        }
        if let Some(at) = self.negative_at {
            said.push(format!(
                "The surface passes through itself: about {:.3} mm³ near {} lie inside out and count as outside.",
                self.negative_mm3,
                place(at)
            ));
        }
        said
    }
}

fn place([x, y, z]: [f64; 3]) -> String {
    format!("({x:.3}, {y:.3}, {z:.3}) mm")
}

/// Examines a mesh and makes it closed and outward.
///
/// # Errors
/// [`Error::Mesh`] when it encloses no volume.
pub(super) fn examine(mut mesh: Mesh, path: &Path) -> Result<(Mesh, Diagnosis)> {
    let mut found = Diagnosis {
        triangles: mesh.triangles.len(),
        ..Diagnosis::default()
    };
    let edges = Edges::new(&mesh);
    edges.count(&mesh, &mut found);
    if found.inconsistent_edges > 0 {
        found.turned_triangles = agree(&mut mesh, &edges);
    }
    found.holes = close(&mut mesh);
    if mesh.signed_volume() < 0.0 {
        found.inside_out = true;
        mesh.triangles.iter_mut().for_each(turn);
    }
    turn_lone_shells(&mut mesh, &mut found);
    let [low, high] = mesh.bounds();
    let diagonal = dot(minus(high, low), minus(high, low)).sqrt();
    let volume = found.signed_volume_mm3();
    if volume <= FLAT * mesh.area() * diagonal {
        return Err(Error::Mesh {
            path: path.to_owned(),
            found: format!(
                "its {} triangles enclose no volume ({volume:e} mm³)",
                found.triangles
            ),
            accepted: "a closed surface round a volume".to_owned(),
        });
    }
    find_overlaps(&mesh, &mut found);
    Ok((mesh, found))
}

fn turn(triangle: &mut [u32; 3]) {
    triangle.swap(1, 2);
}

/// One side of a triangle, filed under its edge.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    low: u32,
    high: u32,
    triangle: u32,
    /// Whether the triangle runs from `low` to `high`.
    forward: bool,
}

/// All sides, those of one edge next to each other.
struct Edges {
    sides: Vec<Side>,
}

impl Edges {
    fn new(mesh: &Mesh) -> Self {
        let mut sides: Vec<Side> = mesh
            .triangles
            .par_iter()
            .enumerate()
            .flat_map_iter(|(t, &[a, b, c])| {
                [(a, b), (b, c), (c, a)].map(|(from, to)| Side {
                    low: from.min(to),
                    high: from.max(to),
                    triangle: t as u32,
                    forward: from < to,
                })
            })
            .collect();
        sides.par_sort_unstable();
        Edges { sides }
    }

    fn iter(&self) -> impl Iterator<Item = &[Side]> {
        self.sides
            .chunk_by(|a, b| (a.low, a.high) == (b.low, b.high))
    }

    fn count(&self, mesh: &Mesh, found: &mut Diagnosis) {
        for edge in self.iter() {
            let at = || {
                let (a, b) = (
                    mesh.vertices[edge[0].low as usize],
                    mesh.vertices[edge[0].high as usize],
                );
                std::array::from_fn(|i| (a[i] + b[i]) / 2.0)
            };
            match edge {
                [_] => {
                    found.open_edges += 1;
                    found.open_at.get_or_insert_with(at);
                }
                [a, b] if a.forward == b.forward => found.inconsistent_edges += 1,
                [_, _] => {}
                _ => {
                    found.non_manifold_edges += 1;
                    found.non_manifold_at.get_or_insert_with(at);
                }
            }
        }
    }
}

/// Turns triangles so that neighbours over two-sided edges agree; returns how many were turned.
fn agree(mesh: &mut Mesh, edges: &Edges) -> usize {
    let mut neighbours = vec![Vec::new(); mesh.triangles.len()];
    for edge in edges.iter() {
        if let [a, b] = edge {
            let agree = a.forward != b.forward;
            neighbours[a.triangle as usize].push((b.triangle, agree));
            neighbours[b.triangle as usize].push((a.triangle, agree));
        }
    }
    let mut turned: Vec<Option<bool>> = vec![None; mesh.triangles.len()];
    let mut total = 0;
    for start in 0..mesh.triangles.len() {
        if turned[start].is_some() {
            continue;
        }
        turned[start] = Some(false);
        let mut patch = vec![start];
        let mut next = 0;
        while let Some(&t) = patch.get(next) {
            next += 1;
            for &(other, agree) in &neighbours[t] {
                let other = other as usize;
                if turned[other].is_none() {
                    // Together when they agree already, apart when not
                    turned[other] = turned[t].map(|t| t == agree);
                    patch.push(other);
                }
            }
        }
        let minority: Vec<usize> = {
            let (yes, no): (Vec<usize>, Vec<usize>) =
                patch.iter().partition(|&&t| turned[t] == Some(true));
            if yes.len() <= no.len() { yes } else { no }
        };
        total += minority.len();
        for t in minority {
            turn(&mut mesh.triangles[t]);
        }
    }
    total
}

/// Closes the boundary: every directed side without an opposite one gets a triangle to the middle of its loop.
/// Returns the number of loops.
fn close(mesh: &mut Mesh) -> usize {
    let mut missing = Vec::new();
    for edge in Edges::new(mesh).iter() {
        let surplus: i64 = edge.iter().map(|s| if s.forward { 1 } else { -1 }).sum();
        let (from, to) = if surplus > 0 {
            (edge[0].high, edge[0].low)
        } else {
            (edge[0].low, edge[0].high)
        };
        for _ in 0..surplus.abs() {
            missing.push([from, to]);
        }
    }
    if missing.is_empty() {
        return 0;
    }
    let mut loops = Groups::new(mesh.vertices.len());
    for &[from, to] in &missing {
        loops.join(from, to);
    }
    let mut by_loop: HashMap<u32, usize> = HashMap::new();
    let mut members: Vec<Vec<[u32; 2]>> = Vec::new();
    for &side in &missing {
        let slot = *by_loop.entry(loops.of(side[0])).or_insert(members.len());
        if slot == members.len() {
            members.push(Vec::new());
        }
        members[slot].push(side);
    }
    for sides in &members {
        let mut middle = [0.0; 3];
        for &[from, _] in sides {
            for (m, v) in middle.iter_mut().zip(mesh.vertices[from as usize]) {
                *m += v / sides.len() as f64;
            }
        }
        let tip = mesh.vertices.len() as u32;
        mesh.vertices.push(middle);
        mesh.triangles
            .extend(sides.iter().map(|&[from, to]| [from, to, tip]));
    }
    members.len()
}

/// Sets that can be joined (union by path halving).
struct Groups(Vec<u32>);

impl Groups {
    fn new(count: usize) -> Self {
        Groups((0..count as u32).collect())
    }

    fn of(&mut self, mut item: u32) -> u32 {
        while self.0[item as usize] != item {
            let parent = self.0[item as usize];
            self.0[item as usize] = self.0[parent as usize];
            item = self.0[item as usize];
        }
        item
    }

    fn join(&mut self, a: u32, b: u32) {
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
    let mut groups = Groups::new(mesh.vertices.len());
    for &[a, b, c] in &mesh.triangles {
        groups.join(a, b);
        groups.join(b, c);
    }
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
    shells.par_iter_mut().for_each(|shell| shell.measure(mesh));
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

/// Turns shells of negative volume that lie in no other shell; notes all volumes.
fn turn_lone_shells(mesh: &mut Mesh, found: &mut Diagnosis) {
    let mut shells = shells(mesh);
    let lone: Vec<bool> = shells
        .par_iter()
        .enumerate()
        .map(|(i, shell)| {
            shell.volume < 0.0 && {
                let point = mesh.corners(shell.triangles[0] as usize)[0];
                let others = shells.iter().enumerate().filter(|(j, _)| *j != i);
                let winding: f64 = others
                    .filter(|(_, other)| other.box_holds(point))
                    .map(|(_, other)| other.winding(mesh, point))
                    .sum();
                winding < 0.5
            }
        })
        .collect();
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

/// Volume and longest stretch of one kind of misfit.
#[derive(Clone, Copy, Default)]
struct Misfit {
    length: f64,
    longest: f64,
    at: [f64; 3],
}

impl Misfit {
    fn add(&mut self, length: f64, at: [f64; 3]) {
        self.length += length;
        if length > self.longest {
            (self.longest, self.at) = (length, at);
        }
    }

    fn join(&mut self, other: &Misfit) {
        self.length += other.length;
        if other.longest > self.longest {
            (self.longest, self.at) = (other.longest, other.at);
        }
    }
}

/// Looks along the lines of the lattice for winding numbers other than 0 and 1.
fn find_overlaps(mesh: &Mesh, found: &mut Diagnosis) {
    let [low, high] = mesh.bounds();
    let pitch_mm = (high[1] - low[1]).max(high[2] - low[2]) / LATTICE;
    let count = |axis: usize| ((high[axis] - low[axis]) / pitch_mm).ceil().max(1.0) as usize;
    let grid = VolumeGrid {
        shape: [count(2), count(1), 1],
        pitch_mm,
        center_mm: std::array::from_fn(|i| (low[i] + high[i]) / 2.0),
    };
    let scaled = Scaled::new(mesh, &grid);
    let x0 = grid.bounds_mm()[0][0];
    let slices: Vec<[Misfit; 2]> = (0..grid.shape[0])
        .into_par_iter()
        .map_init(Lines::default, |lines, iz| {
            let z = iz as f64 + 0.5;
            let active = scaled.between(z, z);
            lines.cast(&scaled, &active, z, |j| j as f64 + 0.5, 0..grid.shape[1]);
            let mut misfits = [Misfit::default(); 2];
            lines.for_each_line(|iy, crossings| {
                let mut winding = 0;
                for pair in crossings.windows(2) {
                    winding += pair[0].step;
                    let length = (pair[1].x - pair[0].x) * pitch_mm;
                    let x = x0 + (pair[0].x + pair[1].x) / 2.0 * pitch_mm;
                    // A stretch shorter than a thousandth of the spacing is rounding, not overlap
                    if !(0..=1).contains(&winding) && length > 1e-3 * pitch_mm {
                        let kind = usize::from(winding < 0);
                        misfits[kind].add(length, [x, grid.y(iy), grid.z(iz)]);
                    }
                }
            });
            misfits
        })
        .collect();
    let mut total = [Misfit::default(); 2];
    for slice in &slices {
        for (total, misfit) in total.iter_mut().zip(slice) {
            total.join(misfit);
        }
    }
    let volume = |m: &Misfit| m.length * pitch_mm * pitch_mm;
    let at = |m: &Misfit| (m.longest > 0.0).then_some(m.at);
    (found.overlap_mm3, found.overlap_at) = (volume(&total[0]), at(&total[0]));
    (found.negative_mm3, found.negative_at) = (volume(&total[1]), at(&total[1]));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::mesh::samples::{ball, cuboid, inverted, together};

    fn found(mesh: Mesh) -> (Mesh, Diagnosis) {
        examine(mesh, Path::new("test")).unwrap()
    }

    #[test]
    fn sound_meshes_are_left_alone() {
        for mesh in [cuboid([0.0; 3], [1.0, 2.0, 3.0]), ball([1.0; 3], 2.0, 3)] {
            let (after, diagnosis) = found(mesh.clone());
            assert_eq!(after, mesh);
            assert_eq!(diagnosis.sentences(), Vec::<String>::new());
            assert_eq!(diagnosis.shell_volumes_mm3.len(), 1);
        }
    }

    #[test]
    fn a_hole_is_said_and_closed() {
        let mut mesh = cuboid([0.0; 3], [1.0, 2.0, 3.0]);
        mesh.triangles.drain(2..4); // the top, z = 3
        let (after, diagnosis) = found(mesh);
        assert_eq!((diagnosis.open_edges, diagnosis.holes), (4, 1));
        assert!((after.signed_volume() - 6.0).abs() < 1e-12);
        let said = diagnosis.sentences();
        assert!(
            said[0].contains("4 edges") && said[0].contains("3.000) mm"),
            "{said:?}"
        );
        assert!(diagnosis.is_simple());
    }

    #[test]
    fn turned_triangles_are_turned_back() {
        let mut mesh = ball([0.0; 3], 1.0, 3);
        let exact = mesh.signed_volume();
        for t in [5, 6, 300, 301, 302, 1000] {
            mesh.triangles[t].swap(0, 1);
        }
        let (after, diagnosis) = found(mesh);
        assert_eq!(diagnosis.turned_triangles, 6);
        assert!((after.signed_volume() - exact).abs() < 1e-12);
        assert!(diagnosis.sentences()[0].contains("6 triangles were turned"));
    }

    #[test]
    fn inside_out_meshes_and_shells_are_turned_and_cavities_kept() {
        let (_, diagnosis) = found(inverted(cuboid([0.0; 3], [1.0; 3])));
        assert!(diagnosis.inside_out && (diagnosis.signed_volume_mm3() - 1.0).abs() < 1e-12);
        let outer = cuboid([0.0; 3], [4.0; 3]);
        let cavity = inverted(cuboid([1.0; 3], [2.0; 3]));
        let lone = inverted(cuboid([6.0; 3], [8.0; 3]));
        let (_, diagnosis) = found(together(&[outer, cavity, lone]));
        let expected = [64.0, -1.0, 8.0];
        for (volume, expected) in diagnosis.shell_volumes_mm3.iter().zip(expected) {
            assert!(
                (volume - expected).abs() < 1e-9,
                "{:?}",
                diagnosis.shell_volumes_mm3
            );
        }
        assert_eq!(diagnosis.turned_shells_at, [[6.0; 3]]);
        assert_eq!(diagnosis.sentences().len(), 1);
        // A part that is mostly such shells is not inside out as a whole
        assert!(!diagnosis.inside_out);
    }

    #[test]
    fn overlaps_are_measured_and_located() {
        let (_, diagnosis) = found(together(&[
            cuboid([0.0; 3], [2.0; 3]),
            cuboid([1.0, 1.0, 1.0], [3.0, 3.0, 3.0]),
        ]));
        assert!(
            (diagnosis.overlap_mm3 - 1.0).abs() < 0.03,
            "{}",
            diagnosis.overlap_mm3
        );
        let at = diagnosis.overlap_at.unwrap();
        assert!(at.iter().all(|v| (1.0..=2.0).contains(v)), "{at:?}");
        assert!(diagnosis.sentences()[0].contains("their union is printed"));
        // Shells that touch do not overlap
        let (_, diagnosis) = found(together(&[
            cuboid([0.0; 3], [2.0; 3]),
            cuboid([2.0, 0.0, 0.0], [3.0, 2.0, 2.0]),
        ]));
        assert!(diagnosis.is_simple() && diagnosis.sentences().is_empty());
    }

    #[test]
    fn a_surface_through_itself_is_said() {
        // The apex of a pyramid pulled down through its base
        let mesh = Mesh {
            vertices: vec![
                [0.0, 0.0, 0.0],
                [4.0, 0.0, 0.0],
                [4.0, 4.0, 0.0],
                [0.0, 4.0, 0.0],
                [2.0, 2.0, 2.0],
                [1.0, 1.0, 0.0],
                [3.0, 1.0, 0.0],
                [3.0, 3.0, 0.0],
                [1.0, 3.0, 0.0],
                [2.0, 2.0, 3.0],
            ],
            triangles: vec![
                [0, 1, 4],
                [1, 2, 4],
                [2, 3, 4],
                [3, 0, 4],
                [0, 5, 6],
                [0, 6, 1],
                [1, 6, 7],
                [1, 7, 2],
                [2, 7, 8],
                [2, 8, 3],
                [3, 8, 5],
                [3, 5, 0],
                [5, 9, 6],
                [6, 9, 7],
                [7, 9, 8],
                [8, 9, 5],
            ],
        };
        let (_, diagnosis) = found(mesh);
        assert_eq!(diagnosis.open_edges, 0);
        // At height z the outer pyramid is 2·(2 − z) wide, the inner 2·(1 − z/3): from z = 1.5 on, 1 wide there, the inner
        // lies outside: a tip 1.5 high less one 0.5 high
        let exact = (1.5 - 0.5) / 3.0;
        assert!(
            (diagnosis.negative_mm3 - exact).abs() < 2e-3,
            "{} {exact}",
            diagnosis.negative_mm3
        );
        assert!(diagnosis.sentences()[0].contains("passes through itself"));
    }

    #[test]
    fn doubled_faces_and_edges_of_many_triangles_are_said() {
        let touching = together(&[
            cuboid([0.0; 3], [1.0; 3]),
            cuboid([1.0, 1.0, 0.0], [2.0, 2.0, 1.0]),
        ])
        .welded();
        let (_, diagnosis) = found(touching);
        assert_eq!(diagnosis.non_manifold_edges, 1);
        assert!(
            diagnosis.sentences()[0].contains("(1.000, 1.000, 0.500) mm"),
            "{:?}",
            diagnosis.sentences()
        );
        assert!((diagnosis.signed_volume_mm3() - 2.0).abs() < 1e-12);
    }

    #[test]
    fn flat_meshes_are_refused() {
        let mut sheet = cuboid([0.0; 3], [1.0, 2.0, 0.0]);
        let refused = |mesh: Mesh| examine(mesh, Path::new("a.stl")).unwrap_err().to_string();
        assert!(refused(sheet.clone()).contains("enclose no volume"));
        sheet.triangles.truncate(2);
        assert!(refused(sheet.welded()).starts_with("mesh a.stl: its "));
        // A thin plate is no sheet
        found(cuboid([0.0; 3], [10.0, 10.0, 1e-5]));
    }
}
