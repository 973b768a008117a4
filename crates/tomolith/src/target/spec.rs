//! The table `[target]` of a job → a shape → voxels.
//!
//! [`build`] is the only place where the table becomes a shape. Several bodies with roles, `[[target.body]]`, will be a
//! further field here, each body with the keys of today's table.

use super::phantom::Phantom;
use super::placing::Placement;
use super::{GreyImage, MeshShape, PHANTOMS, Shape, Target};
use crate::error::{Error, Result};
use crate::grid::VolumeGrid;
use crate::io::image::read_grey;
use crate::io::mesh::read_mesh;
use crate::kind::Section;
use crate::units::Mm;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// What should be printed: exactly one of `mesh`, `phantom` and `image`, and how it is placed.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TargetSpec {
    /// Mesh file, relative to the job: .stl, .obj, .ply or .3mf
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh: Option<PathBuf>,
    /// Part by formula: a name, or a table with parameters such as `phantom.gear = { teeth = 16 }`
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "phantom_schema")]
    pub phantom: Option<serde_json::Value>,
    /// Grey image, relative to the job: .png or .tif; row 0 is +y, columns grow with +x, black is 0 and white is 1
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub image: Option<PathBuf>,
    /// Name of the part, for files and titles (default: the file's name, or the phantom's)
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Longest edge of the box after the rotation, mm (> 0; default: true size); for an image its width, which it needs
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub size_mm: Option<Mm>,
    /// Factor on all lengths (> 0; default 1), instead of `size_mm`
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<f64>,
    /// Angles about x, y and z, degrees, counter-clockwise, in this order about fixed axes (default 0)
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotate_deg: Option<[f64; 3]>,
    /// Where the middle of the box goes (with `center = false`: the origin of the file), mm (default 0)
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub offset_mm: Option<[Mm; 3]>,
    /// Whether the middle of the box is brought to the origin first (default true)
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub center: Option<bool>,
    /// Height along z of what an image is drawn to, mm (> 0; images only)
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height_mm: Option<Mm>,
}

/// A name of the table, or a table with one name.
fn phantom_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let _ = generator;
    let names: Vec<&str> = PHANTOMS.iter().map(|kind| kind.name).collect();
    let tables: serde_json::Map<String, serde_json::Value> = PHANTOMS
        .iter()
        .map(|kind| (kind.name.to_owned(), (kind.schema)().to_value()))
        .collect();
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
        let phantom = || match &self.phantom {
            Some(serde_json::Value::String(name)) => Some(name.clone()),
            Some(serde_json::Value::Object(table)) => table.keys().next().cloned(),
            _ => None,
        };
        self.name
            .clone()
            .or_else(|| self.mesh.as_ref().and_then(stem))
            .or_else(|| self.image.as_ref().and_then(stem))
            .or_else(phantom)
            .unwrap_or_else(|| "part".to_owned())
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
/// [`Error::Config`] when not exactly one of `mesh`, `phantom` and `image` is given or a key cannot be used;
/// [`Error::Io`], [`Error::Mesh`] and [`Error::Format`] for files that cannot be read.
pub fn build(spec: &TargetSpec, base_folder: &Path, section_path: &str) -> Result<Box<dyn Shape>> {
    let placement = spec.placement();
    if spec.height_mm.is_some() && spec.image.is_none() {
        return Err(Error::config(
            "height_mm",
            "a height without an image",
            "a height for images only; phantoms take it in their own table, `phantom.gear = { height_mm = 3.0 }`",
        )
        .under(section_path));
    }
    match (&spec.mesh, &spec.phantom, &spec.image) {
        (Some(file), None, None) => {
            let path = base_folder.join(file);
            let mesh = read_mesh(&path)?;
            let shape = MeshShape::new(mesh, &placement, &path, section_path)?;
            Ok(Box::new(shape))
        }
        (None, Some(table), None) => {
            let section = Section::new(format!("{section_path}.phantom"), table.clone());
            let shape = Phantom::build(&section, &placement, section_path)?;
            Ok(Box::new(shape))
        }
        (None, None, Some(file)) => {
            let image = read_grey(base_folder.join(file))?;
            let size = spec.size_mm.map(|mm| mm.0);
            let height = spec.height_mm.map(|mm| mm.0);
            let shape = GreyImage::new(image, size, height, &placement)
                .map_err(|e| e.under(section_path))?;
            Ok(Box::new(shape))
        }
        (mesh, phantom, image) => {
            let given = [
                ("mesh", mesh.is_some()),
                ("phantom", phantom.is_some()),
                ("image", image.is_some()),
            ];
            let given: Vec<&str> = given.iter().filter(|g| g.1).map(|g| g.0).collect();
            let found = if given.is_empty() {
                "no target is named".to_owned()
            } else {
                format!("more than one target ({})", given.join(", "))
            };
            Err(Error::config(
                section_path,
                found,
                "exactly one of `mesh`, `phantom` and `image`",
            ))
        }
    }
}

/// Samples a shape on a grid; the volume is in array order `[z, y, x]`.
///
/// # Errors
/// [`Error::Resources`] when there is not enough memory.
pub fn voxelise(shape: &dyn Shape, name: &str, grid: &VolumeGrid) -> Result<Target> {
    Ok(Target {
        name: name.to_owned(),
        inside: shape.sample(grid)?,
        grey: shape.is_grey(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(toml: &str) -> String {
        let spec: TargetSpec = toml::from_str(toml).unwrap();
        build(&spec, Path::new("/nowhere"), "target")
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn exactly_one_source_is_accepted() {
        assert!(refused("").starts_with("target: no target is named"));
        assert!(
            refused("mesh = \"a.stl\"\nphantom = \"gear\"")
                .starts_with("target: more than one target (mesh, phantom)")
        );
    }

    #[test]
    fn keys_and_files_are_named() {
        assert!(refused("mesh = \"a.stl\"").contains("a.stl"));
        assert!(refused("mesh = \"a.step\"").contains("extension `.step` is not known"));
        assert!(refused("phantom = \"gear\"\nheight_mm = 2").starts_with("target.height_mm"));
        assert!(
            refused("phantom = \"gear\"\nsize_mm = 2\nscale = 2").starts_with("target.scale: both")
        );
        assert!(refused("phantom = \"gear\"\nscale = inf").starts_with("target.scale: inf"));
        assert!(toml::from_str::<TargetSpec>("phantm = \"gear\"").is_err());
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
