//! The table `[target]` of a job → a shape → voxels.
//!
//! [`build`] is the only place where the table becomes a shape.

use super::diagnosis::Repair;
use super::image::lengths;
use super::phantom::Phantom;
use super::placing::Placement;
use super::{Assembly, BodySpec, GrayImage, MeshShape, MeshUnit, PHANTOMS, Shape, mesh_unit};
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::kind::{Section, table_of};
use tomolith_core::parallel::{InParallel, table};
use tomolith_core::target::Target;
use tomolith_core::units::Mm;
use tomolith_core::work::Work;
use tomolith_io::image::GrayPixels;
use tomolith_io::mesh::is_mesh;
use tomolith_io::slices::{Slices, read_image, read_stack};

tomolith_core::keys! {
    /// What should be printed: exactly one of `mesh`, `phantom`, `image`, `stack` and `body`, and how it is placed.
    #[derive(PartialEq)]
    pub struct TargetSpec {
        /// Mesh file, relative to the job: .stl, .obj, .ply or .3mf
        pub mesh: Option<PathBuf>,
        /// Unit of the mesh file: "mm" (default), "um", "cm", "m" or "inch"; a .3mf file states its own
        pub mesh_unit: Option<MeshUnit>,
        /// Part by formula: a name, or a table with parameters such as `phantom.gear = { teeth = 16 }`
        #[schemars(schema_with = "phantom_schema")]
        pub phantom: Option<serde_json::Value>,
        /// Gray image, relative to the job: .png or .tif; row 0 is +y, columns grow with +x, black is 0 and white is 1
        pub image: Option<PathBuf>,
        /// Gray slices, relative to the job, the first one at the bottom: a folder of .png or .tif files, a pattern such as
        /// "slices/*.png", a .tif of several pages; or voxels `[z, y, x]` from bottom, front and left: .npy, .nrrd, .npz ("results.npz:mask")
        pub stack: Option<PathBuf>,
        /// Several bodies with roles, `[[target.body]]`; those without a file of their own share `mesh`
        pub body: Option<Vec<BodySpec>>,
        /// Whether inserts cast shadows (default true); false lets light pass them as if they were resin
        pub insert_shadow: Option<bool>,
        /// Whether pixels are values to be reproduced and not shares of a part (images: true; stacks: true when any pixel is
        /// neither black nor white)
        pub gray: Option<bool>,
        /// Name of the part, for files and titles (default: the file's name, or the phantom's)
        pub name: Option<String>,
        /// Longest edge of the box after the rotation, mm (> 0; default: true size); for an image or a stack its width, which it needs
        pub size_mm: Option<Mm>,
        /// Factor on all lengths (> 0; default 1), instead of `size_mm`
        pub scale: Option<f64>,
        /// Angles about x, y and z, degrees, counter-clockwise, in this order about fixed axes (default 0)
        pub rotate_deg: Option<[f64; 3]>,
        /// Where the middle of the box goes (with `center = false`: the origin of the file), mm (default 0)
        pub offset_mm: Option<[Mm; 3]>,
        /// Whether the middle of the box is brought to the origin first (default true)
        pub center: Option<bool>,
        /// How far repairs of a mesh may go: "safe" (default: flaws whose repair is a guess are refused) or "force"
        pub repair: Option<Repair>,
        /// Height along z of what an image is drawn to, or of a whole stack, mm (> 0; images and stacks only)
        pub height_mm: Option<Mm>,
        /// How far it may reach into a wall of the vial, mm (≥ 0; default: a hundredth of a voxel); what lies there is not printed
        pub wall_tolerance_mm: Option<Mm>,
    }
}

/// A name of the table, or a table with one name.
fn phantom_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let _ = generator;
    let names: Vec<&str> = PHANTOMS.iter().map(|kind| kind.name).collect();
    let tables = PHANTOMS.iter();
    let tables = table_of(tables.map(|kind| (kind.name.to_owned(), (kind.schema)().to_value())));
    schemars::json_schema!({
        "anyOf": [
            { "type": "string", "enum": names },
            {
                "type": "object",
                "properties": tables,
                "additionalProperties": false,
                "minProperties": 1,
                "maxProperties": 1
            }
        ]
    })
}

impl TargetSpec {
    /// Name of the part: `name`, or the stem of the file, or the phantom.
    #[must_use]
    pub fn name(&self) -> String {
        let stem = |path: &PathBuf| {
            path.file_stem()
                .map(|stem| stem.to_string_lossy().into_owned())
        };
        let first_body = self.body.iter().flatten().find_map(|b| b.mesh.as_ref());
        let phantom = || match &self.phantom {
            Some(serde_json::Value::String(name)) => Some(name.clone()),
            Some(serde_json::Value::Object(table)) => table.keys().next().cloned(),
            _ => None,
        };
        self.name
            .clone()
            .or_else(|| self.mesh.as_ref().and_then(stem))
            .or_else(|| self.image.as_ref().and_then(stem))
            .or_else(|| self.stack.as_ref().and_then(stem))
            .or_else(|| first_body.and_then(stem))
            .or_else(phantom)
            .unwrap_or_else(|| "part".to_owned())
    }

    /// Every file that the target names.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        let bodies = self
            .body
            .iter_mut()
            .flatten()
            .filter_map(|b| b.mesh.as_mut());
        let files = [&mut self.mesh, &mut self.image, &mut self.stack];
        files.into_iter().flatten().chain(bodies)
    }

    /// Refuses an image or a stack without its width or height.
    ///
    /// # Errors
    /// [`Error::Config`] with the key.
    pub fn must_have_lengths(&self) -> Result<()> {
        match self.image.is_some() || self.stack.is_some() {
            true => lengths(self.size_mm.map(|mm| mm.0), self.height_mm.map(|mm| mm.0)).map(drop),
            false => Ok(()),
        }
    }

    fn placement(&self) -> Placement {
        Placement {
            size_mm: self.size_mm.map(|mm| mm.0),
            scale: self.scale,
            rotate_deg: self.rotate_deg.unwrap_or_default(),
            offset_mm: self.offset_mm.unwrap_or_default().map(|mm| mm.0),
            center: self.center.unwrap_or(true),
        }
    }
}

/// Reads and places the target of a job; files are relative to `base_folder`, errors name keys under `section_path`.
///
/// # Errors
/// [`Error::Config`] when not exactly one source is given or a key cannot be used;
/// [`Error::Io`], [`Error::Mesh`] and [`Error::Format`] for files that cannot be read.
pub fn build(spec: &TargetSpec, base_folder: &Path, section_path: &str) -> Result<Box<dyn Shape>> {
    build_under(spec, base_folder, section_path, &Work::new())
}

/// [`build`] as part of a run: examining a mesh of a million triangles takes seconds.
///
/// # Errors
/// As [`build`]; [`Error::Canceled`].
pub fn build_under(
    spec: &TargetSpec,
    base_folder: &Path,
    section_path: &str,
    work: &Work,
) -> Result<Box<dyn Shape>> {
    let placement = spec.placement();
    let pixels = spec.image.is_some() || spec.stack.is_some();
    for (key, given) in [
        ("mesh_unit", spec.mesh_unit.is_some()),
        ("repair", spec.repair.is_some()),
    ] {
        if given && spec.mesh.is_none() && spec.body.is_none() {
            return Err(Error::config(
                key,
                "the key is given without a mesh",
                "this key for meshes only",
            )
            .under(section_path));
        }
    }
    for (key, given) in [
        ("height_mm", spec.height_mm.is_some()),
        ("gray", spec.gray.is_some()),
    ] {
        if given && !pixels {
            return Err(Error::config(
                key,
                "the key is given without an image or a stack",
                "this key for images and stacks only; phantoms have their own, `phantom.gear = { height_mm = 3.0 }`",
            )
            .under(section_path));
        }
    }
    match source(spec, section_path)? {
        Source::Bodies(bodies) => {
            let shape = Assembly::build(spec, bodies, &placement, base_folder, section_path, work)?;
            Ok(Box::new(shape))
        }
        Source::Mesh(file) => {
            let path = base_folder.join(file);
            let file = mesh_unit::read(&path, spec.mesh_unit, section_path)?;
            let file = mesh_unit::in_mm(file, spec.mesh_unit);
            let repair = spec.repair.unwrap_or_default();
            work.check()?;
            let map = placement.map(&file.mesh.vertices, 0.0, section_path)?;
            let shape = MeshShape::placed(file, &map, &path, repair, work)?;
            Ok(Box::new(shape))
        }
        Source::Phantom(table) => {
            let section = Section::new(format!("{section_path}.phantom"), table.clone());
            let shape = Phantom::build(&section, &placement, section_path)?;
            Ok(Box::new(shape))
        }
        Source::Image(file) => {
            if is_mesh(file) {
                return Err(Error::config(
                    "image",
                    format!("`{}` is a mesh", file.display()),
                    "a .png or .tif; meshes go to `target.mesh`",
                )
                .under(section_path));
            }
            let slices = read_image(&base_folder.join(file))?;
            gray(spec, slices, true, &placement, section_path)
        }
        Source::Stack(file) => {
            let slices = read_stack(&base_folder.join(file))?;
            let shades = |slice: &GrayPixels| slice.values.iter().any(|v| *v > 0.0 && *v < 1.0);
            let shaded = slices.slices.iter().par_map(shades).contains(&true);
            gray(spec, slices, shaded, &placement, section_path)
        }
    }
}

fn gray(
    spec: &TargetSpec,
    slices: Slices,
    is_gray: bool,
    placement: &Placement,
    section_path: &str,
) -> Result<Box<dyn Shape>> {
    let [size, height] = [spec.size_mm, spec.height_mm].map(|mm| mm.map(|mm| mm.0));
    let shape = GrayImage::new(slices.slices, size, height, placement)
        .map_err(|e| e.under(section_path))?
        .as_gray(spec.gray.unwrap_or(is_gray))
        .noting(slices.note);
    Ok(Box::new(shape))
}

/// Where a target comes from.
enum Source<'a> {
    Bodies(&'a [BodySpec]),
    Mesh(&'a Path),
    Phantom(&'a serde_json::Value),
    Image(&'a Path),
    Stack(&'a Path),
}

fn source<'a>(spec: &'a TargetSpec, section_path: &str) -> Result<Source<'a>> {
    // The bodies' own files, and the one that they may share
    let bodies = spec.body.as_deref().map(Source::Bodies);
    let mesh = spec.mesh.as_deref().map(Source::Mesh);
    let mut given = vec![
        ("mesh", if bodies.is_some() { None } else { mesh }),
        ("body", bodies),
        ("phantom", spec.phantom.as_ref().map(Source::Phantom)),
        ("image", spec.image.as_deref().map(Source::Image)),
        ("stack", spec.stack.as_deref().map(Source::Stack)),
    ];
    given.retain(|(_, source)| source.is_some());
    if let [(_, only)] = &mut given[..]
        && let Some(only) = only.take()
    {
        return Ok(only);
    }
    let names: Vec<&str> = given.iter().map(|(name, _)| *name).collect();
    let found = if names.is_empty() {
        "no target is named".to_owned()
    } else {
        format!("more than one target ({})", names.join(", "))
    };
    Err(Error::config(
        section_path,
        found,
        "exactly one of `mesh`, `phantom`, `image`, `stack` and `[[target.body]]`",
    ))
}

/// Samples a shape on a grid; the volume is in array order `[z, y, x]`.
///
/// # Errors
/// [`Error::Resources`] when there is not enough memory.
pub fn voxelize(shape: &dyn Shape, name: &str, grid: &VolumeGrid) -> Result<Target> {
    voxelize_under(shape, name, grid, &Work::new())
}

/// [`voxelize`] as a part of a run.
///
/// # Errors
/// As [`voxelize`]; [`Error::Canceled`].
pub fn voxelize_under(
    shape: &dyn Shape,
    name: &str,
    grid: &VolumeGrid,
    work: &Work,
) -> Result<Target> {
    Ok(Target {
        name: name.to_owned(),
        inside: sampled(shape, grid, work)?,
        gray: shape.is_gray(),
    })
}

/// Cubes that are sampled at a time where voxels are no cubes.
const CUBES: usize = 1 << 24;

/// Inside fractions on any grid: shapes are sampled on cubes, and a voxel higher than wide is the mean of those that fill it.
///
/// # Errors
/// What the shape refuses; [`Error::Unsupported`] for voxels that cubes of their width do not fill.
pub fn sampled(shape: &dyn Shape, grid: &VolumeGrid, work: &Work) -> Result<Volume<f32>> {
    let cubes = (grid.height_mm / grid.pitch_mm).round().max(1.0) as usize;
    if (grid.height_mm - cubes as f64 * grid.pitch_mm).abs() > 1e-9 * grid.height_mm {
        return Err(Error::unsupported(
            format!(
                "voxels {} mm wide and {} mm high",
                grid.pitch_mm, grid.height_mm
            ),
            "cubes do not fill them",
        ));
    }
    if cubes == 1 {
        return shape.sample_under(grid, work);
    }
    let [nz, ny, nx] = grid.shape;
    let plane = ny * nx;
    let slices = (CUBES / (plane * cubes).max(1)).max(1);
    let mut values = Vec::with_capacity(grid.len());
    for first in (0..nz).step_by(slices) {
        let count = slices.min(nz - first);
        let mut slab = VolumeGrid {
            shape: [count * cubes, ny, nx],
            height_mm: grid.pitch_mm,
            ..grid.clone()
        };
        slab.center_mm[2] = grid.z(first) + (count as f64 - 1.0) / 2.0 * grid.height_mm;
        let part = work.part(count as f64 / nz as f64);
        let inside = shape.sample_under(&slab, &part)?.values;
        for voxels in inside.chunks_exact(plane * cubes) {
            let mean = |i: usize| {
                let sum: f32 = voxels.iter().skip(i).step_by(plane).sum();
                sum / cubes as f32
            };
            values.extend(table(plane, mean));
        }
    }
    Ok(Volume::new(grid.clone(), values))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_files_are_named_and_exactly_one_source_is_accepted() {
        for (toml, message) in [
            ("", "target: no target is named"),
            (
                "mesh = \"a.stl\"\nphantom = \"gear\"",
                "target: more than one target (mesh, phantom)",
            ),
            ("mesh = \"a.stl\"", "a.stl"),
            ("mesh = \"a.step\"", "extension `.step` is not known"),
            ("phantom = \"gear\"\nheight_mm = 2", "target.height_mm: "),
            (
                "phantom = \"gear\"\nmesh_unit = \"m\"",
                "target.mesh_unit: ",
            ),
            (
                "image = \"a.png\"\nrepair = \"force\"",
                "target.repair: the key is given without a mesh",
            ),
            (
                "mesh = \"a.PNG\"",
                "target.mesh: `/nowhere/a.PNG` is an image",
            ),
            ("mesh = \"a.PNG\"", "images go to `target.image`"),
            (
                "image = \"a.stl\"\nsize_mm = 2",
                "meshes go to `target.mesh`",
            ),
            ("mesh = \"a.3mf\"\nmesh_unit = \"m\"", "states its own"),
            (
                "phantom = \"gear\"\nsize_mm = 2\nscale = 2",
                "target.scale: both",
            ),
            ("phantom = \"gear\"\nscale = inf", "target.scale: found inf"),
        ] {
            let spec: TargetSpec = toml::from_str(toml).unwrap();
            let built = build(&spec, Path::new("/nowhere"), "target");
            tomolith_core::contains!(built.unwrap_err().to_string(), message);
        }
        assert!(toml::from_str::<TargetSpec>("phantm = \"gear\"").is_err());
    }

    #[test]
    fn a_mesh_has_the_unit_that_the_job_says() {
        let folder = tempfile::tempdir().unwrap();
        let cube = tomolith_io::mesh::samples::cuboid([0.0; 3], [0.002, 0.004, 0.006]);
        let bytes = tomolith_io::mesh::samples::stl_binary(&cube);
        std::fs::write(folder.path().join("a.stl"), bytes).unwrap();
        let size = |toml: &str| {
            let spec: TargetSpec = toml::from_str(toml).unwrap();
            let [low, high] = build(&spec, folder.path(), "target").unwrap().bounds_mm();
            [high[0] - low[0], high[2] - low[2]]
        };
        for (unit, factor) in [
            ("um", 1e-3),
            ("mm", 1.0),
            ("cm", 10.0),
            ("m", 1e3),
            ("inch", 25.4),
            ("in", 25.4),
        ] {
            for toml in [
                format!("mesh = \"a.stl\"\nmesh_unit = \"{unit}\""),
                format!("body = [{{ mesh = \"a.stl\", mesh_unit = \"{unit}\" }}]"),
                format!("mesh_unit = \"{unit}\"\nbody = [{{ mesh = \"a.stl\" }}]"),
            ] {
                let [x, z] = size(&toml);
                assert!((x / (0.002 * factor) - 1.0).abs() < 1e-6, "{toml}: {x}");
                assert!((z / (0.006 * factor) - 1.0).abs() < 1e-6, "{toml}: {z}");
            }
        }
        assert!(toml::from_str::<TargetSpec>("mesh_unit = \"furlong\"").is_err());
    }

    #[test]
    fn a_part_far_too_large_or_small_is_asked_for_its_unit() {
        let asked = |toml: &str, longest: f64| {
            let spec: TargetSpec = toml::from_str(toml).unwrap();
            spec.ask_for_unit([[0.0; 3], [longest, 0.0, 0.0]], [0.15, 15.0])
        };
        let mesh = "mesh = \"a.stl\"";
        // 0.006 where 0.15 to 15 mm are expected: 6 mm if the file is in meters
        for (longest, words, unit) in [
            (0.006, "meters", "m"),
            (0.1, "inches", "inch"),
            (6000.0, "micrometers", "um"),
        ] {
            let expected = format!(
                "the part is {longest} mm long: is its file in {words}? set target.mesh_unit = \"{unit}\""
            );
            let text = asked(mesh, longest).unwrap();
            assert_eq!(text, expected);
        }
        // 4 mm that became 4 inches
        let text = asked(mesh, 101.6).unwrap();
        let expected = "the part is 101.6 mm long: were its millimeters exported as inches? set target.size_mm = 4";
        assert_eq!(text, expected);
        // A part that is merely too large, one of the right size, and what says its size
        for (toml, longest) in [
            (mesh, 30.0),
            (mesh, 0.2),
            ("mesh = \"a.3mf\"", 0.006),
            ("mesh = \"a.stl\"\nsize_mm = 3", 0.006),
            ("mesh = \"a.stl\"\nmesh_unit = \"mm\"", 0.006),
            ("phantom = \"gear\"", 0.006),
        ] {
            assert_eq!(asked(toml, longest), None, "{toml}: {longest}");
        }
    }

    #[test]
    fn names_follow_from_what_is_given() {
        let name = |toml: &str| toml::from_str::<TargetSpec>(toml).unwrap().name();
        assert_eq!(name("mesh = \"parts/boat.v2.stl\""), "boat.v2");
        assert_eq!(name("phantom.gear = { teeth = 9 }"), "gear");
        assert_eq!(name("phantom = \"sphere\"\nname = \"marble\""), "marble");
    }

    #[test]
    fn a_phantom_is_placed_like_a_mesh() {
        let spec: TargetSpec = toml::from_str(
            "phantom.cylinder = { size_mm = 2.0, height_mm = 4.0 }\nsize_mm = 8\nrotate_deg = [90, 0, 0]\noffset_mm = [0, 1, 0]",
        )
        .unwrap();
        let shape = build(&spec, Path::new("."), "target").unwrap();
        // Lying along y, doubled: 4 × 8 × 4
        let expected = [[-2.0, -3.0, -2.0], [2.0, 5.0, 2.0]];
        for (corner, expected) in shape.bounds_mm().iter().zip(expected) {
            for (value, expected) in corner.iter().zip(expected) {
                assert!((value - expected).abs() < 1e-12, "{:?}", shape.bounds_mm());
            }
        }
        let volume = shape.volume_mm3().unwrap();
        assert!((volume - std::f64::consts::PI * 4.0 * 8.0).abs() < 1e-9);
    }
}
