//! Repairs before a surface is examined: cracks between vertices, and duplicate triangles.

use super::Diagnosis;
use super::edges::Edges;
use super::shells::Groups;
use std::collections::HashMap;
use tomolith_core::vector::{cross, dot, minus};
use tomolith_io::mesh::Mesh;

/// How far apart vertices on the two sides of a crack may lie, as a share of the mesh's diagonal.
const CRACK: f64 = 1e-5;

/// Welds vertices on open edges that lie within a crack of each other, when that closes edges; how many went.
pub(super) fn weld_cracks(mesh: &mut Mesh) -> usize {
    let open = |mesh: &Mesh| {
        let mut vertices = Vec::new();
        for side in Edges::new(mesh).iter().filter(|sides| sides.len() == 1) {
            vertices.extend([side[0].low, side[0].high]);
        }
        vertices
    };
    let rim = open(mesh);
    if rim.is_empty() {
        return 0;
    }
    let to = nearby(mesh, &rim);
    if to.is_empty() {
        return 0;
    }
    let mut welded = mesh.clone();
    for v in welded.triangles.iter_mut().flatten() {
        *v = *to.get(v).unwrap_or(v);
    }
    welded
        .triangles
        .retain(|[a, b, c]| a != b && b != c && c != a);
    if open(&welded).len() >= rim.len() {
        return 0;
    }
    mesh.triangles = welded.triangles;
    to.len()
}

/// Which of these vertices should become which other one: the first within a crack.
fn nearby(mesh: &Mesh, among: &[u32]) -> HashMap<u32, u32> {
    let [low, high] = mesh.bounds();
    let extent = minus(high, low);
    let reach = CRACK * dot(extent, extent).sqrt();
    let cell = |p: [f64; 3]| p.map(|v| (v / reach).floor() as i64);
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    let mut to = HashMap::new();
    let mut among = among.to_vec();
    among.sort_unstable();
    among.dedup();
    for v in among {
        let p = mesh.vertices[v as usize];
        let home = cell(p);
        let near = (0..27).find_map(|i| {
            let offset = [i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1];
            let there: [i64; 3] =
                std::array::from_fn(|axis| home[axis].saturating_add(offset[axis]));
            let others = cells.get(&there)?.iter();
            others.copied().find(|&o| {
                let away = minus(mesh.vertices[o as usize], p);
                dot(away, away) <= reach * reach
            })
        });
        match near {
            Some(other) => drop(to.insert(v, other)),
            None => cells.entry(home).or_default().push(v),
        }
    }
    to
}

/// Drops all but one of the copies of a triangle, and walls without thickness: neither changes what is inside. Of a closed
/// body that is there twice, once inside out, one stays.
pub(super) fn drop_doubles(mesh: &mut Mesh, found: &mut Diagnosis) {
    /// Corners in rising order, which way it looks, its number.
    type Key = ([u32; 3], bool, usize);
    let mut keys: Vec<Key> = mesh
        .triangles
        .iter()
        .enumerate()
        .map(|(t, &corners)| {
            let [a, b, c] = corners;
            let mut sorted = corners;
            sorted.sort_unstable();
            let even = [[a, b, c], [b, c, a], [c, a, b]].contains(&sorted);
            (sorted, even, t)
        })
        .collect();
    keys.sort_unstable();
    let mut keep = vec![true; keys.len()];
    // Pairs that cancel: one triangle of either kind
    let mut walls: Vec<[usize; 2]> = Vec::new();
    // Triangles of which there is one copy, which looks the same way
    let mut twins: Vec<[usize; 2]> = Vec::new();
    for same in keys
        .chunk_by(|a, b| a.0 == b.0)
        .filter(|same| same.len() > 1)
    {
        let odd = same.iter().filter(|key| !key.1).count();
        let even = same.len() - odd;
        let pairs = odd.min(even);
        found.back_to_back_triangles += 2 * pairs;
        found.copied_triangles += (odd.max(even) - pairs).saturating_sub(1);
        let survivor = (odd != even).then(|| same.iter().find(|key| key.1 == (even > odd)));
        for (_, _, t) in same {
            keep[*t] = survivor.flatten().is_some_and(|key| key.2 == *t);
        }
        if let ([a, b], 0) = (same, pairs) {
            twins.push([a.2, b.2]);
        }
        if survivor.is_none() {
            let first = |even: bool| {
                same.iter()
                    .filter(|key| key.1 == even)
                    .map(|key| key.2)
                    .min()
            };
            walls.push([first(true), first(false)].map(Option::unwrap_or_default));
        }
    }
    for t in outward_copies(mesh, &walls) {
        keep[t] = true;
        found.back_to_back_triangles -= 1;
    }
    for pair in between_bodies(mesh, &twins) {
        pair.into_iter().for_each(|t| keep[t] = false);
        found.back_to_back_triangles += 2;
        found.copied_triangles -= 1;
    }
    if keep.contains(&false) {
        let mut keep = keep.into_iter();
        mesh.triangles.retain(|_| keep.next().unwrap_or(true));
    }
}

/// Of pairs of triangles back to back that together form closed surfaces, the ones that look outward: such a surface is no
/// wall without thickness, but a body that is there twice, once inside out.
fn outward_copies(mesh: &Mesh, walls: &[[usize; 2]]) -> Vec<usize> {
    let pairs = walls.iter().map(|&[a, b]| [a.min(b), a.max(b)]);
    let pairs: Vec<[usize; 2]> = pairs.collect();
    let firsts = Mesh {
        vertices: mesh.vertices.clone(),
        triangles: pairs.iter().map(|pair| mesh.triangles[pair[0]]).collect(),
    };
    let mut groups = Groups::of_shells(&firsts);
    let mut is_open = vec![false; mesh.vertices.len()];
    for sides in Edges::new(&firsts).iter() {
        is_open[groups.of(sides[0].low) as usize] |= sides.len() % 2 == 1;
    }
    let mut volumes = vec![0.0; mesh.vertices.len()];
    for (t, triangle) in firsts.triangles.iter().enumerate() {
        let group = groups.of(triangle[0]);
        let origin = mesh.vertices[group as usize];
        let [a, b, c] = firsts.corners(t).map(|corner| minus(corner, origin));
        volumes[group as usize] += dot(a, cross(b, c));
    }
    let closed = firsts
        .triangles
        .iter()
        .zip(&pairs)
        .filter_map(|(triangle, pair)| {
            let group = groups.of(triangle[0]) as usize;
            (!is_open[group]).then(|| pair[usize::from(volumes[group] < 0.0)])
        });
    closed.collect()
}

/// Of pairs of triangles that look the same way, those that are a wall between two bodies, one of which is inside out: without both of
/// them the rest is closed.
fn between_bodies(mesh: &Mesh, twins: &[[usize; 2]]) -> Vec<[usize; 2]> {
    if twins.is_empty() {
        return Vec::new();
    }
    let mut patch_of = vec![None; mesh.triangles.len()];
    for (patch, t) in twins
        .iter()
        .enumerate()
        .flat_map(|(i, pair)| pair.map(|t| (i, t)))
    {
        patch_of[t] = Some(patch as u32);
    }
    let mut patches = Groups::new(twins.len());
    let mut rims = Vec::new();
    for sides in Edges::new(mesh).iter() {
        let here: Vec<u32> = (sides.iter())
            .filter_map(|side| patch_of[side.triangle as usize])
            .collect();
        here.windows(2).for_each(|two| patches.join(two[0], two[1]));
        let others = sides.len() - here.len();
        rims.extend(
            here.first()
                .filter(|_| others > 0)
                .map(|&patch| (patch, others)),
        );
    }
    let [mut has_rim, mut closes] = [vec![false; twins.len()], vec![true; twins.len()]];
    for (patch, others) in rims {
        let patch = patches.of(patch) as usize;
        has_rim[patch] = true;
        closes[patch] &= others.is_multiple_of(2);
    }
    let is_between = |patch: usize| has_rim[patch] && closes[patch];
    let pairs = twins.iter().enumerate();
    let between = pairs.filter(|(i, _)| is_between(patches.of(*i as u32) as usize));
    between.map(|(_, pair)| *pair).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_io::mesh::samples::{ball, cuboid, inverted, together};

    #[test]
    fn a_crack_is_welded_and_a_gap_is_not() {
        let cracked = |gap: f64| {
            let mut mesh = ball([0.0; 3], 1.0, 2);
            // Every triangle of the upper half gets its corners on the equator anew, a little higher
            let mut copies = HashMap::new();
            for t in 0..mesh.triangles.len() {
                let corners = mesh.corners(t);
                if corners.iter().map(|c| c[2]).sum::<f64>() > 0.0 {
                    for v in &mut mesh.triangles[t] {
                        let p = mesh.vertices[*v as usize];
                        *v = *copies.entry(*v).or_insert_with(|| {
                            mesh.vertices.push([p[0], p[1], p[2] + gap]);
                            mesh.vertices.len() as u32 - 1
                        });
                    }
                }
            }
            mesh
        };
        let mut mesh = cracked(1e-6);
        let open = |mesh: &Mesh| Edges::new(mesh).iter().filter(|e| e.len() == 1).count();
        assert!(open(&mesh) > 20);
        assert!(weld_cracks(&mut mesh) > 10);
        assert_eq!(open(&mesh), 0);
        let mut mesh = cracked(1e-2);
        let before = mesh.clone();
        assert_eq!((weld_cracks(&mut mesh), mesh == before), (0, true));
    }

    /// Copies and triangles back to back that are dropped from meshes in one, and what is left.
    fn dropped(meshes: &[Mesh]) -> ([usize; 2], Mesh) {
        let (mut mesh, mut found) = (together(meshes).welded(), Diagnosis::default());
        drop_doubles(&mut mesh, &mut found);
        let counts = [found.copied_triangles, found.back_to_back_triangles];
        (counts, mesh)
    }

    #[test]
    fn copies_and_walls_without_thickness_are_dropped() {
        let cube = cuboid([0.0; 3], [1.0; 3]);
        let (flipped, above) = (
            inverted(cube.clone()),
            cuboid([0.0, 0.0, 1.0], [1.0, 1.0, 2.0]),
        );
        let mut sheet = cube.clone();
        sheet.triangles.truncate(2);
        let mut third = cube.clone();
        third.triangles = vec![cube.triangles[3]];
        for (meshes, counts, volume, left) in [
            // A copy; a cube and the same inside out, whichever comes first; a sheet with two sides is nothing
            ([&cube, &cube], [12, 0], 1.0, 12),
            ([&cube, &flipped], [0, 12], 1.0, 12),
            ([&flipped, &cube], [0, 12], 1.0, 12),
            ([&sheet, &inverted(sheet.clone())], [0, 4], 0.0, 0),
            // Cubes with a wall between them become one block, one of them inside out, too; a single copy leaves no hole
            ([&cube, &above], [0, 4], 2.0, 20),
            ([&cube, &third], [1, 0], 1.0, 12),
        ] {
            let (found, mesh) = dropped(&meshes.map(Mesh::clone));
            assert_eq!((found, mesh.triangles.len()), (counts, left));
            assert!(left == 0 || (mesh.signed_volume() - volume).abs() < 1e-12);
        }
        let (counts, block) = dropped(&[cube.clone(), inverted(above)]);
        assert_eq!(counts, [0, 4]);
        assert!(Edges::new(&block).iter().all(|edge| edge.len() == 2));
        assert_eq!(
            dropped(std::slice::from_ref(&cube)),
            ([0, 0], cube.welded())
        );
    }
}
