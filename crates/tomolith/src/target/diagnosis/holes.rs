//! Holes, and the fans that close them.

use super::edges::Edges;
use super::shells::Groups;
use crate::io::mesh::Mesh;
use std::collections::HashMap;

/// Closes the boundary: every directed side without an opposite one gets a triangle to the middle of its loop.
/// Returns the number of loops.
pub(super) fn close(mesh: &mut Mesh) -> usize {
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
