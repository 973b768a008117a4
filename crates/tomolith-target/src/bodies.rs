//! Several bodies with roles: what to print, what is there already, where no light may pass.
//!
//! | role | its voxels | light |
//! |---|---|---|
//! | `print` | part | as ever |
//! | `insert` | no resin: they count nowhere | black, unless `insert_shadow = false`: rays end at it |
//! | `keep-dark` | void | no pixel whose light passes the body is used |
//! | `ignore` | as if it were not there | as ever |
//!
//! A body is a file, or some of the connected components of one, counted from 1, the largest first; a component is a shell
//! with the cavities in it, and shells that share a vertex are one component. Every component of a file has one role. All
//! bodies are placed together, as one shape whose box is that of all bodies but ignored ones. Light and voxels need reach only what is
//! printed or stays dark: an insert may be longer than the grid, the field of a light and the vial. A body that is printed may
//! not overlap one of another role: up to a thousandth of the smaller one is taken for rounding.
//!
//! ```toml
//! [target]
//! mesh = "hinge.stl"
//! size_mm = 8.0
//! insert_shadow = false
//!
//! [[target.body]]
//! components = [1]
//!
//! [[target.body]]
//! components = [2, 3]
//! role = "insert"
//!
//! [[target.body]]
//! mesh = "window.stl"
//! role = "keep-dark"
//! ```

use super::diagnosis::components;
use super::placing::Placement;
use super::voxels::zeros;
use super::{MeshShape, MeshUnit, Shape, TargetSpec, mesh_unit};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::parallel::elements;
use tomolith_core::units::concise;
use tomolith_core::work::Work;
use tomolith_io::mesh::{Mesh, MeshFile};

/// What a body is there for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// It is printed.
    #[default]
    Print,
    /// It stands in the resin before the print begins.
    Insert,
    /// No light may pass it.
    KeepDark,
    /// It is not there.
    Ignore,
}

impl Role {
    /// Its name in a job.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Role::Print => "print",
            Role::Insert => "insert",
            Role::KeepDark => "keep-dark",
            Role::Ignore => "ignore",
        }
    }
}

tomolith_core::keys! {
    /// One body of a target: a mesh, or some of its components, and its role.
    #[derive(PartialEq)]
    pub struct BodySpec {
        /// Mesh file, relative to the job (default: `target.mesh`)
        pub mesh: Option<PathBuf>,
        /// Unit of this body's own file: "mm", "um", "cm", "m" or "inch" (default: `target.mesh_unit`)
        pub mesh_unit: Option<MeshUnit>,
        /// Which connected components of the file, counted from 1, the largest first (default: all)
        pub components: Option<Vec<usize>>,
        /// "print" (default), "insert", "keep-dark" or "ignore"
        pub role: Role = Role::default(),
    }
}

/// Placed bodies.
#[derive(Clone, Debug)]
pub struct Assembly {
    print: Group,
    insert: Option<Group>,
    keep_dark: Option<Group>,
    bounds_mm: [[f64; 3]; 2],
}

/// Bodies of one role: their union.
#[derive(Clone, Debug, Default)]
struct Group(Vec<MeshShape>);

impl Assembly {
    /// Reads, places and examines the bodies of a target; `folder` is what files are relative to, `section` its table.
    pub(super) fn build(
        spec: &TargetSpec,
        bodies: &[BodySpec],
        placement: &Placement,
        folder: &Path,
        section: &str,
        work: &Work,
    ) -> Result<Self> {
        let key = |i: usize| format!("{section}.body[{i}]");
        let meshes = meshes(spec, bodies, folder, section)?;
        let counts = |i: &usize| bodies[*i].role != Role::Ignore;
        let present: Vec<usize> = (0..bodies.len()).filter(counts).collect();
        let hull: Vec<[f64; 3]> = present
            .iter()
            .flat_map(|&i| meshes[i].mesh.vertices.iter().copied())
            .collect();
        let map = placement.map(&hull, 0.0, section)?;
        let mut groups: [Group; 3] = Default::default();
        let mut shapes = Vec::new();
        for &i in &present {
            let repair = spec.repair.unwrap_or_default();
            let (mesh, file) = (meshes[i].clone(), file_of(spec, &bodies[i]));
            let shape = MeshShape::placed(mesh, &map, &file, repair, work)
                .map_err(|e| e.of_file(key(i)))?;
            groups[bodies[i].role as usize].0.push(shape.clone());
            shapes.push((i, shape));
        }
        refuse_overlaps(&shapes, bodies, &key)?;
        let [print, insert, keep_dark] = groups;
        if print.0.is_empty() {
            return Err(Error::config(
                format!("{section}.body"),
                "no body has the role print",
                "at least one",
            ));
        }
        let some = |group: Group| (!group.0.is_empty()).then_some(group);
        let lit = [&print, &keep_dark].into_iter().flat_map(|group| &group.0);
        let bounds_mm = super::placing::bounds(lit.flat_map(Shape::bounds_mm), 0.0);
        Ok(Assembly {
            print,
            insert: some(insert),
            keep_dark: some(keep_dark),
            bounds_mm,
        })
    }
}

/// The mesh of every body in the frame of its file, mm.
fn meshes(
    spec: &TargetSpec,
    bodies: &[BodySpec],
    folder: &Path,
    section: &str,
) -> Result<Vec<MeshFile>> {
    let key = |i: usize| format!("{section}.body[{i}]");
    let mut meshes = vec![MeshFile::default(); bodies.len()];
    let mut done = vec![false; bodies.len()];
    for first in 0..bodies.len() {
        if done[first] {
            continue;
        }
        let file = file_of(spec, &bodies[first]);
        if file.as_os_str().is_empty() {
            return Err(Error::config(
                format!("{}.mesh", key(first)),
                "no file is named",
                "a mesh file here, or in `target.mesh` for all bodies",
            ));
        }
        let unit = unit_of(spec, &bodies[first]);
        if bodies[first].mesh.is_none() && bodies[first].mesh_unit.is_some() {
            return Err(Error::config(
                format!("{}.mesh_unit", key(first)),
                "this key needs a mesh file of the body's own",
                "`target.mesh_unit`, the unit of the file that bodies share",
            ));
        }
        let mut file_content = mesh_unit::read(&folder.join(&file), unit, &key(first))
            .map_err(|e| e.of_file(format!("{}.mesh", key(first))))?;
        let is_same = |i: &usize| {
            (file_of(spec, &bodies[*i]), unit_of(spec, &bodies[*i])) == (file.clone(), unit)
        };
        let sharing: Vec<usize> = (first..bodies.len()).filter(is_same).collect();
        for &i in &sharing {
            done[i] = true;
        }
        if let [only] = sharing[..]
            && bodies[only].components.is_none()
        {
            meshes[only] = mesh_unit::in_mm(file_content, unit);
            continue;
        }
        let parts = components(&file_content.mesh);
        share_out(&parts, &sharing, bodies, &key)?;
        for &i in &sharing {
            let chosen = bodies[i]
                .components
                .iter()
                .flatten()
                .map(|&c| &parts[c - 1]);
            let corners =
                chosen.flat_map(|part| (0..part.triangles.len()).map(|t| part.corners(t)));
            let body = MeshFile {
                mesh: Mesh::of_corners(corners),
                negative: file_content.negative.clone(),
                notes: std::mem::take(&mut file_content.notes),
            };
            meshes[i] = mesh_unit::in_mm(body, unit);
        }
    }
    Ok(meshes)
}

fn unit_of(spec: &TargetSpec, body: &BodySpec) -> Option<MeshUnit> {
    body.mesh_unit.or(spec.mesh_unit)
}

fn file_of(spec: &TargetSpec, body: &BodySpec) -> PathBuf {
    body.mesh
        .clone()
        .or_else(|| spec.mesh.clone())
        .unwrap_or_default()
}

/// Refuses bodies of one file that do not name each of its components once.
fn share_out(
    parts: &[Mesh],
    sharing: &[usize],
    bodies: &[BodySpec],
    key: &dyn Fn(usize) -> String,
) -> Result<()> {
    let there = || {
        let each = parts.iter().enumerate().map(|(i, part)| {
            let [low, high] = part.bounds();
            let middle: [f64; 3] = std::array::from_fn(|axis| (low[axis] + high[axis]) / 2.0);
            let volume = part.signed_volume().abs();
            let [x, y, z] = middle;
            format!("{} ({volume:.4} about ({x:.3}, {y:.3}, {z:.3}))", i + 1)
        });
        let list: Vec<String> = each.take(12).collect();
        let more = if parts.len() > 12 { ", …" } else { "" };
        format!(
            "each of the file's {} components in one body, with their volumes in the file's unit: {}{more}",
            parts.len(),
            list.join(", ")
        )
    };
    let refused = |i: usize, found: String| {
        let key = format!("{}.components", key(i));
        Err(Error::config(key, found, there()))
    };
    let mut taken: Vec<Option<usize>> = vec![None; parts.len()];
    for &i in sharing {
        let Some(chosen) = &bodies[i].components else {
            let found = "the key is missing, and other bodies take components of the same file";
            return refused(i, found.to_owned());
        };
        for &c in chosen {
            match c.checked_sub(1).and_then(|slot| taken.get_mut(slot)) {
                None => return refused(i, format!("component {c}")),
                Some(Some(other)) => {
                    return refused(i, format!("component {c}, which body[{other}] has too"));
                }
                Some(slot) => *slot = Some(i),
            }
        }
    }
    let missing: Vec<String> = (1..=parts.len())
        .filter(|c| taken[c - 1].is_none())
        .map(|c| c.to_string())
        .collect();
    if missing.is_empty() {
        return Ok(());
    }
    let last = sharing.last().copied().unwrap_or_default();
    refused(
        last,
        format!("no body has component {}", missing.join(", ")),
    )
}

/// Share of the smaller body that two bodies may have in common.
const ROUNDING: f64 = 1e-3;

/// Voxels along the longest edge of the box in which two bodies may overlap.
const LOOK: f64 = 96.0;

fn refuse_overlaps(
    shapes: &[(usize, MeshShape)],
    bodies: &[BodySpec],
    key: &dyn Fn(usize) -> String,
) -> Result<()> {
    let printed = |i: usize| bodies[i].role == Role::Print;
    for (n, (i, one)) in shapes.iter().enumerate() {
        for (j, other) in &shapes[..n] {
            if printed(*i) == printed(*j) {
                continue;
            }
            let shared = shared_mm3(one, other)?;
            let smaller = [one, other].map(|s| s.diagnosis().signed_volume_mm3());
            if shared > ROUNDING * smaller[0].min(smaller[1]) {
                return Err(Error::config(
                    key(*i),
                    format!(
                        "this body ({}) and body[{j}] ({}) share {} mm³",
                        bodies[*i].role.name(),
                        bodies[*j].role.name(),
                        concise(shared)
                    ),
                    "a printed body that overlaps no insert and no keep-dark body",
                ));
            }
        }
    }
    Ok(())
}

/// Volume that two shapes have in common, at least: where their fractions of a voxel sum to more than one.
fn shared_mm3(one: &MeshShape, other: &MeshShape) -> Result<f64> {
    let [a, b] = [one.bounds_mm(), other.bounds_mm()];
    let low: [f64; 3] = std::array::from_fn(|i| a[0][i].max(b[0][i]));
    let high: [f64; 3] = std::array::from_fn(|i| a[1][i].min(b[1][i]));
    let extent: [f64; 3] = std::array::from_fn(|i| high[i] - low[i]);
    if extent.iter().any(|e| *e <= 0.0) {
        return Ok(0.0);
    }
    let pitch_mm = extent.iter().copied().fold(0.0, f64::max) / LOOK;
    let [nx, ny, nz] = extent.map(|e| (e / pitch_mm).ceil().max(1.0) as usize);
    let grid = VolumeGrid {
        center_mm: std::array::from_fn(|i| (low[i] + high[i]) / 2.0),
        ..VolumeGrid::centered([nz, ny, nx], pitch_mm)
    };
    let [a, b] = [one.sample(&grid)?, other.sample(&grid)?];
    let both = a.values.iter().zip(&b.values);
    let shared: f64 = both.map(|(a, b)| f64::from((a + b - 1.0).max(0.0))).sum();
    Ok(shared * grid.voxel_mm3())
}

impl Shape for Group {
    fn bounds_mm(&self) -> [[f64; 3]; 2] {
        let corners = self.0.iter().flat_map(Shape::bounds_mm);
        super::placing::bounds(corners, 0.0)
    }

    fn sample_under(&self, grid: &VolumeGrid, work: &Work) -> Result<Volume<f32>> {
        if let [only] = &self.0[..] {
            return only.sample_under(grid, work);
        }
        let mut values = zeros(grid)?;
        for shape in &self.0 {
            let more = shape.sample_under(grid, &work.part(1.0 / self.0.len() as f64))?;
            elements(&mut values, |i, sum| {
                *sum = (*sum + more.values[i]).min(1.0)
            });
        }
        Ok(Volume::new(grid.clone(), values))
    }

    fn meshes(&self) -> Vec<&Mesh> {
        self.0.iter().flat_map(Shape::meshes).collect()
    }
}

impl Shape for Assembly {
    fn bounds_mm(&self) -> [[f64; 3]; 2] {
        self.bounds_mm
    }

    fn sample_under(&self, grid: &VolumeGrid, work: &Work) -> Result<Volume<f32>> {
        self.print.sample_under(grid, work)
    }

    fn body(&self, role: Role) -> Option<&dyn Shape> {
        let group = match role {
            Role::Print => Some(&self.print),
            Role::Insert => self.insert.as_ref(),
            Role::KeepDark => self.keep_dark.as_ref(),
            Role::Ignore => None,
        };
        group.map(|group| group as &dyn Shape)
    }

    fn volume_mm3(&self) -> Option<f64> {
        match &self.print.0[..] {
            [only] => only.volume_mm3(),
            _ => None,
        }
    }

    fn warnings(&self) -> Vec<String> {
        let groups = [
            Some(&self.print),
            self.insert.as_ref(),
            self.keep_dark.as_ref(),
        ];
        let shapes = groups.into_iter().flatten().flat_map(|group| &group.0);
        shapes.flat_map(Shape::warnings).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build;
    use crate::region::sampled_volume;
    use tomolith_io::mesh::samples::{cuboid, inverted, stl_binary, together};

    /// A folder with two boxes that touch and one apart in a file, and a rod through the first in another.
    fn folder() -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        let big = cuboid([0.0; 3], [4.0, 4.0, 4.0]);
        let hole = inverted(cuboid([1.0; 3], [2.0; 3]));
        let small = cuboid([6.0, 0.0, 0.0], [8.0, 2.0, 2.0]);
        let write = |name: &str, mesh: &Mesh| {
            std::fs::write(folder.path().join(name), stl_binary(mesh)).unwrap()
        };
        write("two.stl", &together(&[small, big, hole]));
        write("rod.stl", &cuboid([3.0, 1.0, -1.0], [5.0, 3.0, 5.0]));
        write("beside.stl", &cuboid([4.0, 1.0, 0.0], [5.0, 3.0, 4.0]));
        folder
    }

    fn built(toml: &str) -> Result<Box<dyn Shape>> {
        let folder = folder();
        let spec: TargetSpec = toml::from_str(toml).unwrap();
        build(&spec, folder.path(), "target")
    }

    fn refused(toml: &str) -> String {
        built(toml).unwrap_err().to_string()
    }

    fn volume(shape: &dyn Shape) -> f64 {
        sampled_volume(shape, 60)
    }

    #[test]
    fn components_of_a_file_have_roles_and_are_placed_together() {
        let shape = built(
            "mesh = \"two.stl\"\nscale = 0.5\nbody = [{ components = [1] }, { components = [2], role = \"keep-dark\" }]",
        )
        .unwrap();
        // The box of both: 8 × 4 × 4, half as large, about the origin
        assert_eq!(shape.bounds_mm(), [[-2.0, -1.0, -1.0], [2.0, 1.0, 1.0]]);
        assert!((shape.volume_mm3().unwrap() - 63.0 / 8.0).abs() < 1e-9); // the largest, less its cavity
        let dark = shape.body(Role::KeepDark).unwrap();
        assert!((volume(dark) - 1.0).abs() < 1e-4);
        assert_eq!(dark.bounds_mm(), [[1.0, -1.0, -1.0], [2.0, 0.0, 0.0]]);
        assert!(shape.body(Role::Insert).is_none());
    }

    #[test]
    fn ignored_bodies_are_not_there_and_printed_ones_are_united() {
        let shape = built(
            "center = false\nbody = [{ mesh = \"rod.stl\", role = \"ignore\" }, { mesh = \"two.stl\", components = [1, 2] }, \
             { mesh = \"beside.stl\" }]",
        )
        .unwrap();
        assert_eq!(shape.bounds_mm(), [[0.0; 3], [8.0, 4.0, 4.0]]);
        assert!((volume(shape.as_ref()) - (63.0 + 8.0 + 8.0)).abs() < 1e-3);
    }

    #[test]
    fn an_insert_is_placed_with_the_part_but_its_box_is_none_of_the_shape() {
        // The rod reaches from z = −1 to 5 mm, the block beside it from 0 to 4
        let shape = built(
            "body = [{ mesh = \"beside.stl\" }, { mesh = \"rod.stl\", role = \"ignore\" }, { mesh = \"two.stl\", role = \"insert\" }]",
        )
        .unwrap();
        // The box of both, 8 × 4 × 4 mm, is about the origin
        assert_eq!(shape.bounds_mm(), [[0.0, -1.0, -2.0], [1.0, 1.0, 2.0]]);
        let insert = shape.body(Role::Insert).unwrap();
        assert_eq!(insert.bounds_mm(), [[-4.0, -2.0, -2.0], [4.0, 2.0, 2.0]]);
    }

    #[test]
    fn bodies_of_opposite_roles_may_touch_and_not_overlap() {
        let with = |file: &str| {
            format!(
                "mesh = \"{file}\"\nbody = [{{ mesh = \"two.stl\" }}, {{ role = \"keep-dark\" }}]"
            )
        };
        assert!(built(&with("beside.stl")).is_ok());
        let text = refused(&with("rod.stl"));
        // 1 × 2 × 4 mm
        let expected = "target.body[1]: this body (keep-dark) and body[0] (print) share 8 mm³";
        assert!(text.starts_with(expected), "{text}");
    }

    #[test]
    fn what_does_not_fit_is_named() {
        let two = |bodies: &str| refused(&format!("mesh = \"two.stl\"\nbody = [{bodies}]"));
        let text = two("{ components = [1] }");
        let listed = "1 (63.0000 about (2.000, 2.000, 2.000)), 2 (8.0000 about";
        tomolith_core::contains!(text, listed);
        let unprinted = r#"{ role = "ignore" }, { mesh = "rod.stl", role = "keep-dark" }"#;
        for (bodies, found) in [
            ("{ components = [1, 3] }", "component 3"),
            ("{ components = [0] }", "component 0"),
            (
                "{ components = [1] }, { components = [2, 1] }",
                "which body[0] has too",
            ),
            (
                "{ components = [1] }, { role = \"ignore\" }",
                "the key is missing",
            ),
            (unprinted, "no body has the role print"),
            ("", "no body"),
        ] {
            tomolith_core::contains!(two(bodies), found);
        }
        let rod = "body = [{ mesh = \"rod.stl\" }]";
        for (text, start) in [
            (text, "target.body[0].components: no body has component 2"),
            (
                refused("body = [{}]"),
                "target.body[0].mesh: no file is named",
            ),
            (
                refused("body = [{ mesh = \"none.stl\" }]"),
                "target.body[0].mesh: ",
            ),
            (refused(&format!("phantom = \"gear\"\n{rod}")), "target: "),
        ] {
            assert!(text.starts_with(start), "{text}");
        }
        assert!(toml::from_str::<TargetSpec>("body = [{ role = \"keepdark\" }]").is_err());
    }

    #[test]
    fn an_insert_is_a_body_of_its_own_with_its_surface() {
        let job = "body = [{ mesh = \"two.stl\" }, { mesh = \"beside.stl\", role = \"insert\" }]";
        let shape = built(job).unwrap();
        let insert = shape.body(Role::Insert).unwrap();
        assert!((volume(insert) - 8.0).abs() < 1e-3);
        let surface: f64 = insert.meshes().iter().map(|m| m.signed_volume()).sum();
        assert!((surface - 8.0).abs() < 1e-9);
    }
}
