//! The target's solid as rays see it: which parts of a path segment lie inside, and how much of a voxel does.
//!
//! # Model
//! A mesh is crossed in f64, inside is where its winding number is above 0. A ray that meets an edge may count a crossing
//! twice or not at all; then the winding number does not come back to 0, and the ray is moved aside by `ASIDE`. A form is
//! followed by its distance: no step is longer than that, and none shorter than 1/64 of a voxel, so chords below may be
//! missed; roots are found to 1e-9 of a voxel.
//!
//! # Cost
//! A mesh about 1 µs a segment; a form some twenty distances per crossing.

use crate::cells::Cells;
use crate::layout::DoseLayout;
use std::collections::VecDeque;
use std::sync::Arc;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::parallel::InParallel;
use tomolith_io::mesh::Mesh;
use tomolith_optics::projector::Ray;
use tomolith_optics::surface::Net;
use tomolith_target::{Role, Shape};

/// Least step along a ray through a form, in voxels.
const STEP: f64 = 1.0 / 64.0;
/// Error of a root, in voxels.
const ROOT: f64 = 1e-9;
/// How far a ray is moved aside that meets an edge, mm, and how often.
const ASIDE: f64 = 1e-7;
const TRIES: usize = 4;
/// Lines through a cut voxel of a form: two Fibonacci numbers, whose lattice spreads them evenly.
const LINES: [usize; 2] = [233, 144];

/// Level rays whose pieces are kept: the rows of a column send the same ways, one for each ray of a pixel.
const KNOWN: usize = 256;

/// The pieces of a ray inside a solid.
#[derive(Debug, Default)]
pub struct Pieces {
    found: Vec<[f64; 2]>,
    known: VecDeque<([f64; 6], Vec<[f64; 2]>)>,
}

impl Pieces {
    /// `[from, to]` of each, mm along the ray, in order.
    #[must_use]
    pub fn found(&self) -> &[[f64; 2]] {
        &self.found
    }
}

/// A solid, its cells on a grid of voxels, and the pieces of rays inside of it.
#[derive(Debug)]
pub struct Solid {
    body: Body,
    bounds_mm: [[f64; 3]; 2],
    pitch_mm: f64,
    shape: [usize; 3],
    cells: Arc<Cells>,
}

#[derive(Debug)]
enum Body {
    Net(Net),
    Form(Arc<dyn Shape>),
}

impl Solid {
    /// The solid of a shape, and its cells on a grid.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a shape without a surface: an image, or gray values. What sampling it says.
    pub fn new(shape: &Arc<dyn Shape>, grid: &VolumeGrid) -> Result<Self> {
        let meshes = shape
            .body(Role::Print)
            .map_or_else(|| shape.meshes(), Shape::meshes);
        let body = if !meshes.is_empty() {
            Body::Net(Net::new(&together(&meshes), "target")?)
        } else if Self::has_surface(shape.as_ref()) {
            Body::Form(Arc::clone(shape))
        } else {
            return Err(Error::unsupported(
                "surface = \"cells\"",
                "the target has no surface; a mesh, or a phantom of part and void",
            ));
        };
        let mut solid = Solid {
            body,
            bounds_mm: shape.bounds_mm(),
            pitch_mm: grid.pitch_mm,
            shape: grid.shape,
            cells: Arc::default(),
        };
        let mut shares = shape.sample(grid)?;
        if let Body::Form(form) = &solid.body {
            solid.refine(form.as_ref(), &mut shares);
        }
        let layout = DoseLayout::new("dose", grid.clone(), 0);
        solid.cells = Arc::new(Cells::new(&layout, &shares));
        Ok(solid)
    }

    /// Whether a shape has a surface that cuts voxels: gray values and images have none.
    #[must_use]
    pub fn has_surface(shape: &dyn Shape) -> bool {
        let printed = shape.body(Role::Print).unwrap_or(shape);
        !printed.meshes().is_empty() || shape.distance_mm([0.0; 3]).is_some()
    }

    /// Its cells on the grid.
    #[must_use]
    pub fn cells(&self) -> &Arc<Cells> {
        &self.cells
    }

    /// Whether it was made for a grid like this one.
    pub(super) fn fits(&self, grid: &VolumeGrid) -> bool {
        (self.shape, self.pitch_mm) == (grid.shape, grid.pitch_mm)
    }

    /// The pieces (mm along the ray) that lie inside, of the first `length` mm; overwrites those of the ray before.
    pub fn inside(&self, ray: &Ray, length: f64, pieces: &mut Pieces) {
        pieces.found.clear();
        let Some([from, to]) = self.in_box(ray) else {
            return;
        };
        match &self.body {
            Body::Net(net) => {
                // From before the box, where nothing is inside
                through(net, ray, from - self.pitch_mm, &mut pieces.found);
                for piece in &mut pieces.found {
                    *piece = piece.map(|t| t.clamp(0.0, length));
                }
                pieces.found.retain(|[a, b]| a < b);
            }
            Body::Form(shape) => {
                let span = [from.max(0.0), to.min(length)];
                match shape.upright_mm().filter(|_| ray.direction[2] == 0.0) {
                    Some(heights) => self.level(shape.as_ref(), heights, ray, span, pieces),
                    None => follow(shape.as_ref(), ray, span, self.pitch_mm, &mut pieces.found),
                }
            }
        }
    }

    /// A level ray through an upright prism: as any other above or below it, and so known from there.
    fn level(
        &self,
        shape: &dyn Shape,
        [low, high]: [f64; 2],
        ray: &Ray,
        span: [f64; 2],
        pieces: &mut Pieces,
    ) {
        let ([x, y, z], [dx, dy, _]) = (ray.from, ray.direction);
        if z <= low || z >= high {
            return;
        }
        let way = [x, y, dx, dy, span[0], span[1]];
        if let Some((_, known)) = pieces.known.iter().find(|(known, _)| *known == way) {
            pieces.found.extend(known);
            return;
        }
        let middle = Ray {
            from: [x, y, (low + high) / 2.0],
            ..*ray
        };
        follow(shape, &middle, span, self.pitch_mm, &mut pieces.found);
        pieces.known.truncate(KNOWN - 1);
        pieces.known.push_front((way, pieces.found.clone()));
    }

    /// Where a ray (in both directions) is in the box of the solid.
    fn in_box(&self, ray: &Ray) -> Option<[f64; 2]> {
        let [low, high] = self.bounds_mm;
        let mut span = [f64::NEG_INFINITY, f64::INFINITY];
        for i in 0..3 {
            // A wall of the box may be a face of the solid, to rounding
            let slack = STEP * self.pitch_mm;
            let [a, b] = [low[i] - slack, high[i] + slack]
                .map(|wall| (wall - ray.from[i]) / ray.direction[i]);
            if ray.direction[i] == 0.0 {
                if !(low[i] - slack..=high[i] + slack).contains(&ray.from[i]) {
                    return None;
                }
                continue;
            }
            span = [span[0].max(a.min(b)), span[1].min(a.max(b))];
        }
        (span[0] < span[1]).then_some(span)
    }

    /// Shares of the cut voxels of a form, of the same solid that rays see: lines along the axis that crosses the surface most
    /// steeply, exact along each. An upright prism has the same share in every slice that it fills.
    fn refine(&self, shape: &dyn Shape, shares: &mut Volume<f32>) {
        let grid = shares.grid.clone();
        let [nz, ny, nx] = grid.shape;
        let cut = |s: f32| s > 0.0 && s < 1.0;
        if let Some([low, high]) = shape.upright_mm() {
            let middle = (low + high) / 2.0;
            let heights: Vec<f64> = (0..nz)
                .map(|iz| {
                    let [bottom, top] = [-0.5, 0.5].map(|side| grid.z(iz) + side * grid.pitch_mm);
                    ((top.min(high) - bottom.max(low)) / grid.pitch_mm).clamp(0.0, 1.0)
                })
                .collect();
            let in_plane = |i: usize, pieces: &mut Pieces| {
                let slices = (0..nz).map(|iz| shares.values[iz * nx * ny + i]);
                let at = [grid.x(i % nx), grid.y(i / nx), middle];
                slices.clone().any(cut).then(|| self.share(at, pieces))
            };
            let columns: Vec<Option<f64>> =
                (0..nx * ny).par_map_with(Pieces::default, |pieces, i| in_plane(i, pieces));
            for (slice, height) in shares.values.chunks_mut(nx * ny).zip(heights) {
                for (s, share) in slice.iter_mut().zip(&columns) {
                    *s = share.map_or(*s, |share| (share * height) as f32);
                }
            }
            return;
        }
        let rows = shares.values.chunks_mut(nx.max(1)).enumerate();
        rows.par_each_with(Pieces::default, |pieces, (row, shares)| {
            for (x, s) in shares.iter_mut().enumerate().filter(|(_, s)| cut(**s)) {
                let middle = [grid.x(x), grid.y(row % ny), grid.z(row / ny)];
                *s = self.share(middle, pieces) as f32;
            }
        });
    }

    /// The share of a voxel about `middle` that is inside.
    fn share(&self, middle: [f64; 3], pieces: &mut Pieces) -> f64 {
        let pitch = self.pitch_mm;
        let axis = self.steepest(middle);
        let sides = super::segment::others(axis);
        let mut direction = [0.0; 3];
        direction[axis] = 1.0;
        let mut sum = 0.0;
        for i in 0..LINES[0] {
            let mut from = middle;
            from[axis] -= pitch / 2.0;
            let along = (i as f64 + 0.5) / LINES[0] as f64;
            let across = ((i * LINES[1] % LINES[0]) as f64 + 0.5) / LINES[0] as f64;
            from[sides[0]] += pitch * (along - 0.5);
            from[sides[1]] += pitch * (across - 0.5);
            self.inside(&Ray { from, direction }, pitch, pieces);
            sum += pieces.found.iter().map(|[a, b]| b - a).sum::<f64>();
        }
        sum / (LINES[0] as f64 * pitch)
    }

    /// The axis along which the distance changes most across a voxel.
    fn steepest(&self, middle: [f64; 3]) -> usize {
        let Body::Form(shape) = &self.body else {
            return 0;
        };
        let rise = |axis: usize| {
            let [low, high] = [-0.5, 0.5].map(|side| {
                let mut at = middle;
                at[axis] += side * self.pitch_mm;
                shape.distance_mm(at).unwrap_or(0.0)
            });
            (high - low).abs()
        };
        (0..3)
            .max_by(|&a, &b| rise(a).total_cmp(&rise(b)))
            .unwrap_or(0)
    }
}

fn together(meshes: &[&Mesh]) -> Mesh {
    let mut all = Mesh::default();
    for mesh in meshes {
        let first = all.vertices.len() as u32;
        all.vertices.extend(&mesh.vertices);
        let triangles = mesh.triangles.iter().map(|t| t.map(|v| v + first));
        all.triangles.extend(triangles);
    }
    all
}

/// The pieces of a ray inside a net; distances count from the ray's own point, crossings are looked for from `start` on, which
/// is outside.
fn through(net: &Net, ray: &Ray, start: f64, pieces: &mut Vec<[f64; 2]>) {
    let mut crossings: Vec<(f64, i32)> = Vec::new();
    for attempt in 0..TRIES {
        let mut from = ray.at(start);
        // Three ways aside that no ordinary edge runs along
        let aside = attempt as f64 * ASIDE;
        from = [
            from[0] + 0.61 * aside,
            from[1] - 0.37 * aside,
            from[2] + 0.71 * aside,
        ];
        crossings.clear();
        net.for_each_hit(&Ray { from, ..*ray }, |distance, enters| {
            crossings.push((start + distance, if enters { 1 } else { -1 }));
        });
        crossings.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        if crossings.iter().map(|c| c.1).sum::<i32>() == 0 {
            break;
        }
    }
    let mut winding = 0;
    for pair in crossings.windows(2) {
        winding += pair[0].1;
        if winding <= 0 {
            continue;
        }
        match pieces.last_mut() {
            Some(last) if last[1] == pair[0].0 => last[1] = pair[1].0,
            _ => pieces.push([pair[0].0, pair[1].0]),
        }
    }
}

/// The pieces of `[from, to]` of a ray in which the distance of a shape is negative; it grows by at most 1 per mm.
fn follow(
    shape: &dyn Shape,
    ray: &Ray,
    [from, to]: [f64; 2],
    pitch: f64,
    pieces: &mut Vec<[f64; 2]>,
) {
    if from >= to {
        return;
    }
    let distance = |t| shape.distance_mm(ray.at(t)).unwrap_or(f64::INFINITY);
    let (mut at, mut here) = (from, distance(from));
    let mut entered = (here < 0.0).then_some(from);
    while at < to {
        let next = (at + here.abs().max(STEP * pitch)).min(to);
        let there = distance(next);
        if (here < 0.0) != (there < 0.0) {
            let root = root(distance, [at, next], [here, there], ROOT * pitch);
            match entered.take() {
                Some(begin) => pieces.push([begin, root]),
                None => entered = Some(root),
            }
        }
        (at, here) = (next, there);
    }
    if let Some(begin) = entered {
        pieces.push([begin, to]);
    }
}

/// Where a function changes its sign, to `error`: the Illinois form of the false position.
fn root(
    f: impl Fn(f64) -> f64,
    [mut a, mut b]: [f64; 2],
    [mut fa, mut fb]: [f64; 2],
    error: f64,
) -> f64 {
    for _ in 0..60 {
        if (b - a).abs() <= error || fb == 0.0 {
            break;
        }
        let c = (b - fb * (b - a) / (fb - fa)).clamp(a.min(b), a.max(b));
        let fc = f(c);
        if fc.abs() <= error {
            return c;
        }
        if (fc < 0.0) == (fb < 0.0) {
            fa /= 2.0;
        } else {
            (a, fa) = (b, fb);
        }
        (b, fb) = (c, fc);
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;
    use tomolith_core::kind::Section;
    use tomolith_core::near;
    use tomolith_io::mesh::samples::{ball, cuboid, together as joined};
    use tomolith_target::phantom::Phantom;
    use tomolith_target::{MeshShape, Placement, Repair};

    fn mesh(mesh: Mesh) -> Arc<dyn Shape> {
        let placement = Placement {
            center: false,
            ..Placement::default()
        };
        let path = Path::new("part");
        Arc::new(MeshShape::new(mesh, &placement, path, "target", Repair::Safe).unwrap())
    }

    fn phantom(json: serde_json::Value) -> Arc<dyn Shape> {
        let section = Section::new("target.phantom", json);
        Arc::new(Phantom::build(&section, &Placement::default(), "target").unwrap())
    }

    fn inside(solid: &Solid, from: [f64; 3], to: [f64; 3], length: f64) -> Vec<[f64; 2]> {
        let mut pieces = Pieces::default();
        solid.inside(&Ray::through(from, to), length, &mut pieces);
        pieces.found
    }

    fn assert_pieces(found: &[[f64; 2]], expected: &[[f64; 2]]) {
        let near = |a: &[f64; 2], b: &[f64; 2]| (0..2).all(|i| (a[i] - b[i]).abs() < 2e-6);
        let same = found.len() == expected.len();
        assert!(
            same && found.iter().zip(expected).all(|(a, b)| near(a, b)),
            "{found:?} instead of {expected:?}"
        );
    }

    #[test]
    fn a_ray_is_inside_between_its_crossings_of_touching_nested_and_overlapping_shells() {
        let boxes = joined(&[
            cuboid([-1.0, -1.0, -1.0], [0.0, 1.0, 1.0]),
            // Touches the first, overlaps the third
            cuboid([0.0, -1.0, -1.0], [0.5, 1.0, 1.0]),
            cuboid([0.25, -0.5, -0.5], [2.0, 0.5, 0.5]),
            tomolith_io::mesh::samples::inverted(cuboid([-0.75, -0.5, -0.5], [-0.25, 0.5, 0.5])),
        ]);
        let grid = VolumeGrid::centered([8, 8, 8], 0.5);
        let solid = Solid::new(&mesh(boxes), &grid).unwrap();
        // Along the edges of triangles too: y = z is a diagonal of every face
        for (y, z) in [(0.1, 0.2), (0.0, 0.0), (0.3, 0.3), (-0.2, 0.2)] {
            let found = inside(&solid, [-5.0, y, z], [5.0, y, z], 10.0);
            let total: f64 = found.iter().map(|[a, b]| b - a).sum();
            assert!((total - 2.5).abs() < 1e-9, "{y} {z}: {found:?}");
            assert!((found[0][0] - 4.0).abs() < 1e-9 && (found[0][1] - 4.25).abs() < 1e-9);
        }
        // A segment that begins and ends inside
        assert_pieces(
            &inside(&solid, [-0.1, 0.0, 0.1], [1.0, 0.0, 0.1], 0.7),
            &[[0.0, 0.7]],
        );
        assert_pieces(&inside(&solid, [-5.0, 3.0, 0.1], [5.0, 3.0, 0.1], 9.0), &[]);
    }

    #[test]
    fn forms_are_crossed_where_their_formula_says() {
        let grid = VolumeGrid::centered([8, 8, 8], 0.3);
        let sphere = phantom(serde_json::json!({"sphere": {"size_mm": 2.0}}));
        let solid = Solid::new(&sphere, &grid).unwrap();
        for height in [0.0, 0.3, 0.95, 0.9999] {
            let half = f64::sqrt(1.0 - height * height);
            let found = inside(&solid, [-3.0, height, 0.0], [3.0, height, 0.0], 6.0);
            assert_pieces(&found, &[[3.0 - half, 3.0 + half]]);
        }
        assert_pieces(
            &inside(&solid, [-3.0, 1.01, 0.0], [3.0, 1.01, 0.0], 6.0),
            &[],
        );
        assert_pieces(
            &inside(&solid, [0.0; 3], [0.0, 0.6, 0.8], 0.5),
            &[[0.0, 0.5]],
        );
        let hole = serde_json::json!({"box_with_hole": {"size_mm": 2.0, "height_mm": 1.0, "hole_mm": 1.0}});
        let solid = Solid::new(&phantom(hole), &grid).unwrap();
        // A hole of radius ½
        let found = inside(&solid, [-3.0, 0.3, 0.1], [3.0, 0.3, 0.1], 6.0);
        assert_pieces(&found, &[[2.0, 2.6], [3.4, 4.0]]);
    }

    #[test]
    fn shares_are_volumes_of_the_same_solid() {
        let grid = VolumeGrid::centered([9, 10, 11], 0.23);
        let sphere = phantom(serde_json::json!({"sphere": {"size_mm": 2.0}}));
        let solid = Solid::new(&sphere, &grid).unwrap();
        let net = Solid::new(&mesh(ball([0.0; 3], 1.0, 5)), &grid).unwrap();
        assert!(solid.cells().len() > 200);
        // The ball of triangles is smaller by 1e-3; of voxels that both cut, shares agree to that
        let other: std::collections::BTreeMap<usize, f32> = net.cells().iter().collect();
        let mut worst = 0.0f32;
        for (voxel, s) in solid.cells().iter() {
            worst = worst.max(other.get(&voxel).map_or(0.0, |other| (s - other).abs()));
        }
        assert!(worst < 4e-3, "{worst}");
    }

    /// Everything below a plane.
    #[derive(Debug)]
    struct Below {
        normal: [f64; 3],
        at: f64,
    }

    impl Shape for Below {
        fn bounds_mm(&self) -> [[f64; 3]; 2] {
            [[-1.0; 3], [1.0; 3]]
        }

        /// Only whether a voxel may be cut.
        fn sample_under(
            &self,
            grid: &VolumeGrid,
            _: &crate::Work,
        ) -> tomolith_core::error::Result<Volume<f32>> {
            Ok(Volume::filled(grid.clone(), 0.5))
        }

        fn distance_mm(&self, p: [f64; 3]) -> Option<f64> {
            Some((0..3).map(|i| self.normal[i] * p[i]).sum::<f64>() - self.at)
        }
    }

    /// Share of the unit cube about the origin where normal·p < at: with a = |normal|, t = Σa/2 + at and all subsets S of the
    /// axes, Σ (−1)^|S| max(0, t − Σ_S a)³/(6·a₁·a₂·a₃).
    fn below(normal: [f64; 3], at: f64) -> f64 {
        let a = normal.map(f64::abs);
        let t = a.iter().sum::<f64>() / 2.0 + at;
        let term = |set: usize| {
            let taken = (0..3).filter(|i| set >> i & 1 == 1);
            let sign = if set.count_ones().is_multiple_of(2) {
                1.0
            } else {
                -1.0
            };
            sign * (t - taken.map(|i| a[i]).sum::<f64>()).max(0.0).powi(3)
        };
        (0..8).map(term).sum::<f64>() / (6.0 * a[0] * a[1] * a[2])
    }

    #[test]
    fn a_slanted_plane_cuts_off_what_the_closed_form_says() {
        let (normal, at) = ([0.48, -0.6, 0.64], 0.03);
        let grid = VolumeGrid::centered([6, 6, 6], 0.2);
        let shape: Arc<dyn Shape> = Arc::new(Below { normal, at });
        let solid = Solid::new(&shape, &grid).unwrap();
        assert!(solid.cells().len() > 30);
        let layout = DoseLayout::new("dose", grid.clone(), 0);
        let (mut worst, mut seen) = (0.0f64, 0);
        for (voxel, s) in solid.cells().iter() {
            let (z, column) = (voxel % layout.row, voxel / layout.row);
            let middle = [grid.x(column % 6), grid.y(column / 6), grid.z(z)];
            let offset = (at - (0..3).map(|i| normal[i] * middle[i]).sum::<f64>()) / 0.2;
            worst = worst.max((below(normal, offset) - f64::from(s)).abs());
            seen += 1;
        }
        assert_eq!(seen, solid.cells().len());
        assert!(worst < 1e-3, "{worst}");
    }

    #[test]
    fn an_upright_prism_has_one_share_in_all_slices_that_it_fills() {
        let grid = VolumeGrid::centered([7, 24, 24], 0.2).about([0.0, 0.0, 0.01]);
        let star = serde_json::json!({"siemens_star": {"size_mm": 4.0, "height_mm": 1.1, "spokes": 6, "hub_mm": 1.0}});
        let star = phantom(star);
        let solid = Solid::new(&star, &grid).unwrap();
        let row = DoseLayout::new("dose", grid, 0).row;
        let mut sum = 0.0;
        for (voxel, s) in solid.cells().iter() {
            // Slices reach from −0.69 on, 0.2 apart: the lowest holds 0.06/0.2 of the height, the top one 0.04/0.2
            let found = solid
                .cells()
                .iter()
                .find(|(v, _)| *v == voxel / row * row + 3);
            // None where it is all of the voxel but a merged cell
            let (whole, error) = found.map_or((1.0, 1e-3), |(_, s)| (s, 1e-5));
            let height = [0.3, 1.0, 1.0, 1.0, 1.0, 1.0, 0.2][voxel % row];
            near!(s, whole * height, error, "{voxel}: {s} of {whole}");
            sum += f64::from(s);
        }
        assert!(sum > 50.0);
    }
}
