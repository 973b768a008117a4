//! Holes, and the fans that close them.

use super::Diagnosis;
use super::edges::Edges;
use super::shells::Groups;
use std::collections::HashMap;
use tomolith_core::vector::{cross, dot, minus};
use tomolith_io::mesh::Mesh;

/// A fan of at most this share of the surface cannot be wrong by much, whatever it closes.
const SMALL: f64 = 0.01;

/// A rim counts as flat up to this share of the fan's extent.
const FLAT: f64 = 1e-3;

/// Closes the boundary: every directed side without an opposite one gets a triangle to the middle of its loop.
/// Those that are neither flat nor small are guesses of what was there.
pub(super) fn close(mesh: &mut Mesh, found: &mut Diagnosis) {
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
        return;
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
    let small = SMALL * mesh.area();
    found.holes = members.len();
    for sides in &members {
        let mut middle = [0.0; 3];
        for &[from, _] in sides {
            for (m, v) in middle.iter_mut().zip(mesh.vertices[from as usize]) {
                *m += v / sides.len() as f64;
            }
        }
        if !is_plain(mesh, sides, middle, small) {
            found.guessed_holes += 1;
            found.guessed_hole_at.get_or_insert(middle);
        }
        let tip = mesh.vertices.len() as u32;
        mesh.vertices.push(middle);
        mesh.triangles
            .extend(sides.iter().map(|&[from, to]| [from, to, tip]));
    }
}

/// Whether a fan round `middle` is flat, or no larger than `small`.
fn is_plain(mesh: &Mesh, sides: &[[u32; 2]], middle: [f64; 3], small: f64) -> bool {
    let spokes = |side: &[u32; 2]| side.map(|v| minus(mesh.vertices[v as usize], middle));
    let mut normal = [0.0; 3];
    let (mut area, mut longest) = (0.0, 0.0f64);
    for side in sides {
        let [from, to] = spokes(side);
        let double = cross(from, to);
        for (sum, v) in normal.iter_mut().zip(double) {
            *sum += v;
        }
        area += dot(double, double).sqrt() / 2.0;
        longest = longest.max(dot(from, from).sqrt());
    }
    let length = dot(normal, normal).sqrt();
    let off = |side: &[u32; 2]| dot(spokes(side)[0], normal).abs() <= FLAT * longest * length;
    area <= small || (length > 0.0 && sides.iter().all(off))
}
