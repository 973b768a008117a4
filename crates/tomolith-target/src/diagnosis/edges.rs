//! The edges of a mesh: who shares them, and in which direction.

use super::Diagnosis;
use rayon::slice::ParallelSliceMut;
use tomolith_io::mesh::Mesh;

pub(super) fn turn(triangle: &mut [u32; 3]) {
    triangle.swap(1, 2);
}

/// One side of a triangle, filed under its edge.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Side {
    pub(super) low: u32,
    pub(super) high: u32,
    pub(super) triangle: u32,
    /// Whether the triangle runs from `low` to `high`.
    pub(super) forward: bool,
}

/// All sides, those of one edge next to each other.
pub(super) struct Edges {
    sides: Vec<Side>,
}

impl Edges {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let mut sides: Vec<Side> = mesh
            .triangles
            .iter()
            .enumerate()
            .flat_map(|(t, &[a, b, c])| {
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

    pub(super) fn iter(&self) -> impl Iterator<Item = &[Side]> {
        self.sides
            .chunk_by(|a, b| (a.low, a.high) == (b.low, b.high))
    }

    /// Edges whose two triangles disagree about the outside.
    pub(super) fn inconsistent(&self) -> usize {
        let disagree = |edge: &&[Side]| matches!(edge, [a, b] if a.forward == b.forward);
        self.iter().filter(disagree).count()
    }

    /// The sides of the edge between two vertices.
    pub(super) fn of(&self, a: u32, b: u32) -> &[Side] {
        let edge = (a.min(b), a.max(b));
        let first = self.sides.partition_point(|s| (s.low, s.high) < edge);
        let sides = &self.sides[first..];
        let count = sides.iter().take_while(|s| (s.low, s.high) == edge).count();
        &sides[..count]
    }

    pub(super) fn count(&self, mesh: &Mesh, found: &mut Diagnosis) {
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

/// Turns triangles so that neighbors over two-sided edges agree; returns how many were turned.
pub(super) fn agree(mesh: &mut Mesh, edges: &Edges) -> usize {
    let mut neighbors = vec![Vec::new(); mesh.triangles.len()];
    for edge in edges.iter() {
        if let [a, b] = edge {
            let agree = a.forward != b.forward;
            neighbors[a.triangle as usize].push((b.triangle, agree));
            neighbors[b.triangle as usize].push((a.triangle, agree));
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
            for &(other, agree) in &neighbors[t] {
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
