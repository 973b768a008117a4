//! The surface of what gels: marching cubes on a volume, as a closed triangle surface in mm.
//!
//! # What it models
//! The part where a volume's value, interpolated linearly between voxel centers, is above a level. Beyond the grid the
//! value counts as not gelled, so the surface is closed at the grid's border too.
//!
//! # Method
//! Lorensen and Cline 1987 (marching cubes). The 256 cases are not a copied table: they are built from one rule. On
//! each face of a cell every run of corners inside is cut off by one segment (so two inside corners on a diagonal stay
//! apart). The rule knows only the face, hence the two cells that share it agree, and the surface has no holes; the
//! segments are strung into loops and the loops cut into triangles by diagonals that run through the cell, never
//! along a face. Every edge of the result belongs to exactly two triangles, in opposite directions.
//! Corners stay at least 1/1024 of an edge away from its ends: no triangle degenerates, at an error of a thousandth of
//! the pitch.
//!
//! # Shapes, limits, cost
//! Volume `[z, y, x]`; triangles counter-clockwise seen from outside (from the side below the level). Up to 2³² − 1
//! corners. One pass over the volume, slabs of planes in parallel, the same result for any number of threads;
//! 400³ voxels take well under a second on two cores.
//!
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::isosurface::isosurface;
//! let volume = Volume { grid: VolumeGrid::centered([1, 1, 1], 2.0), values: vec![1.0] };
//! let surface = isosurface(&volume, 0.5);
//! // One voxel that falls to 0 at its neighbors' centers, 2 mm away: an octahedron with corners 1 mm away
//! assert_eq!((surface.corners.len(), surface.triangles.len()), (6, 8));
//! assert!((surface.volume_mm3() - 4.0 / 3.0).abs() < 1e-6);
//! ```

use std::ops::Range;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use tomolith_core::dose::Work;
use tomolith_core::error::Error;
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::parallel::InParallel;
use tomolith_core::vector::{cross, dot, minus};

/// Layers of cells that are done one after the other, with shared planes between them.
const SLAB: usize = 8;
/// How near a corner may come to the end of its cell edge, as a fraction of the edge.
const MARGIN: f64 = 1.0 / 1024.0;
/// Voxels that are compared at a time.
const COMPARED: usize = 64;

/// A closed triangle surface in mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Isosurface {
    /// Corners `[x, y, z]`, mm.
    pub corners: Vec<[f32; 3]>,
    /// Indices of corners, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Isosurface {
    /// Whether there is no triangle.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    fn triangle(&self, i: usize) -> [[f64; 3]; 3] {
        self.triangles[i].map(|corner| self.corners[corner as usize].map(f64::from))
    }

    /// Area of a triangle, mm².
    #[must_use]
    pub fn area_of(&self, i: usize) -> f64 {
        let [a, b, c] = self.triangle(i);
        let n = cross(minus(b, a), minus(c, a));
        0.5 * dot(n, n).sqrt()
    }

    /// Enclosed volume, mm³: Σ of signed tetrahedra.
    #[must_use]
    pub fn volume_mm3(&self) -> f64 {
        (0..self.triangles.len())
            .map(|i| {
                let [a, b, c] = self.triangle(i);
                dot(a, cross(b, c)) / 6.0
            })
            .sum()
    }
}

/// The surface around what is above `level`.
#[must_use]
pub fn isosurface(volume: &Volume<f32>, level: f64) -> Isosurface {
    let fill = rows_of(&volume.values);
    isosurface_within(&volume.grid, level, fill, usize::MAX, &Work::new()).unwrap_or_default()
}

/// The value that stands for "not gelled" next to a level: 0, or less when the level itself is not above 0.
#[must_use]
pub fn beyond(level: f64) -> f32 {
    if level > 0.0 { 0.0 } else { level as f32 - 1.0 }
}

/// Rows of an array, for [`isosurface_within`].
pub fn rows_of(values: &[f32]) -> impl Fn(usize, &mut [f32]) + Sync {
    |first, row| row.copy_from_slice(&values[first..][..row.len()])
}

/// As [`isosurface`], of values that `fill` writes: a row of voxels along x that begins at a position of the array. Empty when
/// the run is canceled; None where it has more than `most` corners: then no more are made.
pub fn isosurface_within(
    grid: &VolumeGrid,
    level: f64,
    fill: impl Fn(usize, &mut [f32]) + Sync,
    most: usize,
    work: &Work,
) -> Option<Isosurface> {
    if grid.is_empty() {
        return Some(Isosurface::default());
    }
    let march = March::new(grid, level, &fill);
    let slabs = slabs(grid);
    let steps = work.steps(slabs.len());
    let corners = AtomicUsize::new(0);
    let parts: Vec<Isosurface> = slabs.into_iter().par_map(|slab| {
        steps.add(1);
        if steps.is_canceled() || corners.load(Ordering::Relaxed) > most {
            return Isosurface::default();
        }
        let part = march.triangulate(slab, Last::Next);
        corners.fetch_add(part.corners.len(), Ordering::Relaxed);
        part
    });
    if work.is_canceled() {
        return Some(Isosurface::default());
    }
    let corners = corners.into_inner();
    if corners > most {
        return None;
    }
    let mut surface = Isosurface {
        corners: Vec::with_capacity(corners),
        triangles: Vec::with_capacity(parts.iter().map(|p| p.triangles.len()).sum()),
    };
    for part in parts {
        // The corners on a slab's last plane are the first of the next slab
        let first = surface.corners.len() as u32;
        let triangles = part.triangles.into_iter().map(|t| t.map(|i| first + i));
        surface.triangles.extend(triangles);
        surface.corners.extend(part.corners);
    }
    Some(surface)
}

/// The same surface in pieces from below to above, each with separate corners, so that it is never held whole: where two
/// pieces meet both have the same corners, to the last bit. Empty pieces are left out.
///
/// # Errors
/// What `take` refuses; [`Error::Canceled`].
pub fn isosurface_pieces<E: From<Error>>(
    grid: &VolumeGrid,
    level: f64,
    fill: impl Fn(usize, &mut [f32]) + Sync,
    mut take: impl FnMut(&Isosurface) -> Result<(), E>,
    work: &Work,
) -> Result<(), E> {
    if grid.is_empty() {
        return Ok(());
    }
    let march = March::new(grid, level, &fill);
    let slabs = slabs(grid);
    let steps = work.steps(slabs.len());
    for some in slabs.chunks(rayon::current_num_threads()) {
        work.check()?;
        steps.add(some.len());
        let pieces: Vec<Isosurface> =
            (some.iter()).par_map(|slab| march.triangulate(slab.clone(), Last::Own));
        for piece in pieces.iter().filter(|piece| !piece.is_empty()) {
            take(piece)?;
        }
    }
    Ok(())
}

fn slabs(grid: &VolumeGrid) -> Vec<Range<usize>> {
    let layers = grid.shape[0] + 1;
    (0..layers)
        .step_by(SLAB)
        .map(|first| first..layers.min(first + SLAB))
        .collect()
}

/// One plane of voxel centers with a frame of padding, and the numbers of the corners on its edges.
#[derive(Clone, Default)]
struct Plane {
    values: Vec<f32>,
    inside: Vec<u8>,
    /// Per row: whether anything is inside.
    rows: Vec<bool>,
    /// Number of the corner on the edge toward +x and toward +y, where the surface crosses it; elsewhere anything.
    along: [Vec<u32>; 2],
}

/// Whose corners those on the last plane of a slab are.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Last {
    /// The slab's own too.
    Own,
    /// The next slab's.
    Next,
}

struct March<'a, F> {
    grid: &'a VolumeGrid,
    level: f64,
    /// The largest f32 that is not above the level: v > level is v > cut.
    cut: f32,
    pad: f32,
    width: usize,
    height: usize,
    fill: &'a F,
}

impl<'a, F: Fn(usize, &mut [f32]) + Sync> March<'a, F> {
    fn new(grid: &'a VolumeGrid, level: f64, fill: &'a F) -> Self {
        let nearest = level as f32;
        March {
            grid,
            level,
            cut: if f64::from(nearest) > level {
                nearest.next_down()
            } else {
                nearest
            },
            pad: beyond(level),
            width: grid.shape[2] + 2,
            height: grid.shape[1] + 2,
            fill,
        }
    }

    /// Fills padded plane `k`: plane 0 and the last one are padding, plane k holds slice k − 1.
    fn load(&self, k: usize, plane: &mut Plane) {
        let (w, h) = (self.width, self.height);
        let is_padding = k == 0 || k > self.grid.shape[0];
        if is_padding || plane.values.is_empty() {
            plane.values = vec![self.pad; w * h];
            plane.inside = vec![0; w * h];
            plane.rows = vec![false; h];
        }
        if is_padding {
            return;
        }
        // The frame of padding stays as it is
        for y in 1..h - 1 {
            let row = y * w + 1..(y + 1) * w - 1;
            let values = &mut plane.values[row.clone()];
            (self.fill)(self.grid.index(k - 1, y - 1, 0), values);
            let mut any = 0;
            for (inside, value) in plane.inside[row].iter_mut().zip(values) {
                *inside = u8::from(*value > self.cut);
                any |= *inside;
            }
            plane.rows[y] = any == 1;
        }
    }

    /// Numbers the corners on the flat edges of a plane, and appends them to `corners` when they are this slab's own.
    fn number_flat(
        &self,
        k: usize,
        plane: &mut Plane,
        first: u32,
        mut corners: Option<&mut Vec<[f32; 3]>>,
    ) {
        let (w, h) = (self.width, self.height);
        let mut next = first;
        for along in &mut plane.along {
            along.resize(w * h, 0);
        }
        for y in 0..h {
            for (axis, step) in [(0, 1), (1, w)] {
                let there = y + axis;
                if there >= h || !(plane.rows[y] || plane.rows[there]) {
                    continue;
                }
                let (row, len) = (y * w, w - 1 + axis);
                let [here, beyond] = [row, row + step].map(|i| &plane.inside[i..][..len]);
                differences(here, beyond, |x| {
                    let i = row + x;
                    plane.along[axis][i] = next;
                    next += 1;
                    if let Some(corners) = corners.as_mut() {
                        let f = self.fraction(plane.values[i], plane.values[i + step]);
                        corners.push(self.position([x, y, k], axis, f));
                    }
                });
            }
        }
    }

    /// Where along an edge the value crosses the level.
    fn fraction(&self, from: f32, to: f32) -> f64 {
        let (from, to) = (f64::from(from), f64::from(to));
        ((self.level - from) / (to - from)).clamp(MARGIN, 1.0 - MARGIN)
    }

    /// mm of a point at `f` of the edge that starts at a padded voxel `[x, y, z]` and runs along an axis.
    fn position(&self, at: [usize; 3], axis: usize, f: f64) -> [f32; 3] {
        let origin = [self.grid.x(0), self.grid.y(0), self.grid.z(0)];
        std::array::from_fn(|i| {
            let along = if i == axis { f } else { 0.0 };
            (origin[i] + (at[i] as f64 - 1.0 + along) * self.grid.pitch_mm) as f32
        })
    }

    /// The triangles of a slab and the corners it owns, numbered from 0 on in the order they are made; those on its last plane follow.
    fn triangulate(&self, slab: Range<usize>, last: Last) -> Isosurface {
        let (w, h) = (self.width, self.height);
        let mut surface = Isosurface::default();
        let next = |surface: &Isosurface| surface.corners.len() as u32;
        let (mut low, mut high) = (Plane::default(), Plane::default());
        let mut upright = vec![0; w * h];
        self.load(slab.start, &mut low);
        self.number_flat(slab.start, &mut low, 0, Some(&mut surface.corners));
        let end = slab.end;
        for k in slab {
            self.load(k + 1, &mut high);
            for y in (0..h).filter(|&y| low.rows[y] || high.rows[y]) {
                let row = y * w;
                let [here, above] = [&low, &high].map(|plane| &plane.inside[row..][..w]);
                differences(here, above, |x| {
                    let i = row + x;
                    let f = self.fraction(low.values[i], high.values[i]);
                    upright[i] = next(&surface);
                    surface.corners.push(self.position([x, y, k], 2, f));
                });
            }
            let number = next(&surface);
            let corners = (k + 1 < end || last == Last::Own).then_some(&mut surface.corners);
            self.number_flat(k + 1, &mut high, number, corners);
            self.cells(&low, &high, &upright, &mut surface.triangles);
            std::mem::swap(&mut low, &mut high);
        }
        surface
    }

    /// Triangles of all cells between two planes.
    fn cells(&self, low: &Plane, high: &Plane, upright: &[u32], triangles: &mut Vec<[u32; 3]>) {
        let w = self.width;
        let cases = &*CASES;
        for y in 0..self.height - 1 {
            if ![low.rows[y], low.rows[y + 1], high.rows[y], high.rows[y + 1]].contains(&true) {
                continue;
            }
            // Bits of the four corners of one x, at the places of the lower x
            let column = |x: usize| {
                low.inside[y * w + x]
                    | low.inside[(y + 1) * w + x] << 2
                    | high.inside[y * w + x] << 4
                    | high.inside[(y + 1) * w + x] << 6
            };
            let mut case = column(0) << 1;
            for x in 0..w - 1 {
                case = case >> 1 & 0x55 | column(x + 1) << 1;
                if case == 0 || case == 0xff {
                    continue;
                }
                let i = y * w + x;
                let number = |edge: u8| match edge {
                    0 => low.along[0][i],
                    1 => low.along[0][i + w],
                    2 => high.along[0][i],
                    3 => high.along[0][i + w],
                    4 => low.along[1][i],
                    5 => low.along[1][i + 1],
                    6 => high.along[1][i],
                    7 => high.along[1][i + 1],
                    8 => upright[i],
                    9 => upright[i + 1],
                    10 => upright[i + w],
                    _ => upright[i + w + 1],
                };
                triangles.extend(cases[usize::from(case)].iter().map(|t| t.map(number)));
            }
        }
    }
}

/// Does something at every place where two rows differ: they do in few.
fn differences(a: &[u8], b: &[u8], mut at: impl FnMut(usize)) {
    let chunks = a.chunks(COMPARED).zip(b.chunks(COMPARED));
    for (i, (a, b)) in chunks.enumerate().filter(|(_, (a, b))| a != b) {
        let places = a.iter().zip(b).enumerate();
        let places = places.filter(|(_, (a, b))| a != b);
        places.for_each(|(x, _)| at(i * COMPARED + x));
    }
}

/// Triangles of each of the 256 cases, as edges of the cell. Corner bits: x 1, y 2, z 4 (bit number = corner).
/// Edge 4·axis + (0…3): the other two coordinates, the lower axis counting 1, the higher 2.
static CASES: LazyLock<Vec<Vec<[u8; 3]>>> =
    LazyLock::new(|| (0..=255).map(case_triangles).collect());

/// The corners of the six faces, counter-clockwise seen from outside the cell.
const FACES: [[u8; 4]; 6] = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
];

/// The edge between two neighboring corners.
fn edge_between(a: u8, b: u8) -> u8 {
    match (a ^ b, a & b) {
        (1, rest) => rest >> 1,
        (2, rest) => 4 + (rest & 1 | rest >> 1 & 2),
        (_, rest) => 8 + rest,
    }
}

fn case_triangles(case: u8) -> Vec<[u8; 3]> {
    let inside = |corner: u8| case >> corner & 1 == 1;
    // On each face, every run of inside corners is cut off by one segment, from where it is entered to where it is left
    let mut next = [None; 12];
    for face in FACES {
        for start in 0..4 {
            let corner = |i: usize| face[(start + i) % 4];
            if !inside(corner(0)) && inside(corner(1)) {
                let run = (1..4).take_while(|&i| inside(corner(i))).count();
                let entered = edge_between(corner(0), corner(1));
                next[usize::from(entered)] = Some(edge_between(corner(run), corner(run + 1)));
            }
        }
    }
    let mut triangles = Vec::new();
    for first in 0..12 {
        let mut around = Vec::new();
        let mut edge = first;
        while let Some(following) = next[edge].take() {
            around.push(edge as u8);
            edge = usize::from(following);
        }
        if around.len() >= 3 {
            let cut = cut_polygon(&around, &|a, b| !on_one_face(a, b));
            triangles.extend(
                cut.or_else(|| cut_polygon(&around, &|_, _| true))
                    .unwrap_or_default(),
            );
        }
    }
    triangles
}

fn on_one_face(a: u8, b: u8) -> bool {
    FACES.iter().any(|face| {
        let mut edges = (0..4).map(|i| edge_between(face[i], face[(i + 1) % 4]));
        edges.clone().any(|e| e == a) && edges.any(|e| e == b)
    })
}

/// Cuts a polygon into triangles by allowed diagonals.
fn cut_polygon(polygon: &[u8], allowed: &dyn Fn(u8, u8) -> bool) -> Option<Vec<[u8; 3]>> {
    if polygon.len() < 3 {
        return Some(Vec::new());
    }
    let last = polygon.len() - 1;
    (1..last).find_map(|apex| {
        let side = |a: usize, b: usize| b - a == 1 || allowed(polygon[a], polygon[b]);
        if !(side(0, apex) && side(apex, last)) {
            return None;
        }
        let mut triangles = cut_polygon(&polygon[..=apex], allowed)?;
        triangles.push([polygon[0], polygon[apex], polygon[last]]);
        triangles.extend(cut_polygon(&polygon[apex..], allowed)?);
        Some(triangles)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;
    use std::f64::consts::PI;
    use tomolith_core::check::{on_threads, random};

    fn sphere(n: usize, radius: f64, center: [f64; 3]) -> Volume<f32> {
        let grid = VolumeGrid::centered([n, n + 1, n + 2], 4.0 / n as f64);
        Volume::from_fn(grid, |at| {
            let p = minus(at, center);
            (radius + 1.0 - dot(p, p).sqrt()) as f32
        })
    }

    /// Every directed edge once, and its reverse once.
    fn assert_closed(surface: &Isosurface) {
        let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
        for t in &surface.triangles {
            for i in 0..3 {
                *edges.entry((t[i], t[(i + 1) % 3])).or_default() += 1;
            }
        }
        for (&(a, b), &count) in &edges {
            assert_eq!(count, 1, "edge {a}→{b}");
            assert_eq!(edges.get(&(b, a)), Some(&1), "edge {a}→{b} has no partner");
        }
        let used: std::collections::HashSet<u32> =
            surface.triangles.iter().flatten().copied().collect();
        assert_eq!(used.len(), surface.corners.len(), "every corner is used");
    }

    #[test]
    fn no_case_needs_a_diagonal_along_a_face_and_opposite_cases_mirror() {
        for case in 0..=255u8 {
            let crossed = (0..8u8)
                .flat_map(|a| [1, 2, 4].map(|bit| (a, a ^ bit)))
                .filter(|(a, b)| a < b && (case >> a & 1) != (case >> b & 1))
                .count();
            let triangles = case_triangles(case);
            let used: std::collections::HashSet<u8> = triangles.iter().flatten().copied().collect();
            assert_eq!(
                used.len(),
                crossed,
                "case {case}: each crossed edge carries a corner"
            );
            let mut sides: HashMap<(u8, u8), i32> = HashMap::new();
            for t in &triangles {
                for i in 0..3 {
                    *sides.entry((t[i], t[(i + 1) % 3])).or_default() += 1;
                }
            }
            for (&(a, b), &count) in &sides {
                assert_eq!(count, 1, "case {case}");
                // An inner diagonal runs both ways and must not lie on a face; a side lies on a face and runs one way
                assert_eq!(
                    sides.contains_key(&(b, a)),
                    !on_one_face(a, b),
                    "case {case}: {a}-{b}"
                );
            }
        }
    }

    #[test]
    fn area_and_volume_of_a_sphere_converge_to_second_order() {
        let center = [0.03, -0.07, 0.11];
        let errors: Vec<[f64; 2]> = [16, 32, 64]
            .map(|n| {
                let surface = isosurface(&sphere(n, 1.2, center), 1.0);
                let area: f64 = (0..surface.triangles.len())
                    .map(|i| surface.area_of(i))
                    .sum();
                assert_closed(&surface);
                let (r2, r3) = (1.2f64.powi(2), 1.2f64.powi(3));
                [
                    (area / (4.0 * PI * r2) - 1.0).abs(),
                    (surface.volume_mm3() / (4.0 / 3.0 * PI * r3) - 1.0).abs(),
                ]
            })
            .to_vec();
        for pair in errors.windows(2) {
            for (coarse, fine) in pair[0].iter().zip(pair[1]) {
                let order = (coarse / fine).log2();
                assert!((1.7..2.4).contains(&order), "order {order} of {errors:?}");
            }
        }
        assert!(errors[2].iter().all(|e| *e < 2e-3), "{errors:?}");
    }

    #[test]
    fn noise_gives_a_closed_surface_even_at_the_border_of_the_grid() {
        let grid = VolumeGrid::centered([21, 13, 17], 0.1);
        let mut random = random(9);
        let values = (0..grid.len()).map(|_| random()).collect();
        let volume = Volume { grid, values };
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("noise.stl");
        for level in [0.2, 0.5, 0.9] {
            let surface = isosurface(&volume, level);
            assert!(surface.triangles.len() > 1000);
            assert_closed(&surface);
            assert!(surface.volume_mm3() > 0.0);
            // A file has no shared corners: it must be closed after equal corners are welded
            tomolith_io::stl::write_stl(&path, "noise", &surface.corners, &surface.triangles)
                .unwrap();
            let read = stl_io::read_stl(&mut std::fs::File::open(&path).unwrap()).unwrap();
            assert_eq!(read.vertices.len(), surface.corners.len());
            let corners = read.vertices.iter().map(|v| v.0).collect();
            let triangles = read
                .faces
                .iter()
                .map(|f| f.vertices.map(|i| i as u32))
                .collect();
            assert_closed(&Isosurface { corners, triangles });
        }
        let full = isosurface(&volume, -1.0);
        assert_closed(&full);
        let [lo, hi] = volume.grid.bounds_mm();
        let bound: f64 = (0..3).map(|i| hi[i] - lo[i] + 0.2).product();
        assert!(full.volume_mm3() > 0.9 * 2.0 * 1.2 * 1.6 && full.volume_mm3() < bound);
    }

    #[test]
    fn corners_lie_on_the_plane_and_in_the_right_place() {
        // A slab that ends at x = 0.3: value 1 − (x − 0.3), level 1
        let grid = VolumeGrid::centered([4, 4, 8], 0.5).about([0.1, 5.0, -3.0]);
        let volume = Volume::from_fn(grid, |[x, ..]| (1.3 - x) as f32);
        let surface = isosurface(&volume, 1.0);
        let right: Vec<_> = surface
            .corners
            .iter()
            .filter(|c| c[0] > -1.0 && (c[1] - 5.0).abs() < 0.8 && (c[2] + 3.0).abs() < 0.8)
            .collect();
        assert_eq!(right.len(), 16);
        assert!(right.iter().all(|c| (c[0] - 0.3).abs() < 1e-6), "{right:?}");
    }

    #[test]
    fn pieces_make_the_same_surface() {
        let volume = sphere(12 * SLAB, 1.1, [0.1, 0.0, -0.2]);
        let whole = isosurface(&volume, 1.0);
        let flat = |surface: &Isosurface| -> Vec<[[f32; 3]; 3]> {
            let corner = |i: u32| surface.corners[i as usize];
            surface.triangles.iter().map(|t| t.map(corner)).collect()
        };
        let (mut triangles, mut pieces) = (Vec::new(), 0);
        isosurface_pieces(
            &volume.grid,
            1.0,
            rows_of(&volume.values),
            |piece| -> Result<(), Error> {
                pieces += 1;
                triangles.extend(flat(piece));
                Ok(())
            },
            &Work::new(),
        )
        .unwrap();
        assert!(pieces > 3, "{pieces}");
        assert_eq!(triangles, flat(&whole));
        let ended = |take: &dyn Fn() -> Result<(), Error>, work: &Work| {
            let rows = rows_of(&volume.values);
            isosurface_pieces(&volume.grid, 1.0, rows, |_| take(), work).unwrap_err()
        };
        let enough = || Err(Error::config("a", "enough", "b"));
        assert!(ended(&enough, &Work::new()).to_string().contains("enough"));
        let work = Work::new();
        work.cancel();
        assert!(matches!(ended(&|| Ok(()), &work), Error::Canceled));
    }

    #[test]
    fn threads_do_not_matter() {
        let volume = sphere(24, 1.1, [0.0; 3]);
        let run = |threads| on_threads(threads, || isosurface(&volume, 1.0));
        assert_eq!(run(1), run(3));
        let empty = isosurface(&volume, 5.0);
        assert_eq!(empty, Isosurface::default());
    }
}
