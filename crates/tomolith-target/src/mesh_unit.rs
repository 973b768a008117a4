//! The unit of a mesh file, which STL, OBJ and PLY do not state.

use super::TargetSpec;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result};
use tomolith_core::units::concise;
use tomolith_io::mesh::{MeshFile, read_mesh};

/// Unit of the numbers in a mesh file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MeshUnit {
    /// Micrometers.
    Um,
    /// Millimeters.
    #[default]
    Mm,
    /// Centimeters.
    Cm,
    /// Meters.
    M,
    /// Inches.
    #[serde(alias = "in")]
    Inch,
}

impl MeshUnit {
    /// All of them.
    pub const ALL: [MeshUnit; 5] = [
        MeshUnit::Um,
        MeshUnit::Mm,
        MeshUnit::Cm,
        MeshUnit::M,
        MeshUnit::Inch,
    ];

    /// Its length in mm, its name in a job, and in words.
    fn row(self) -> (f64, &'static str, &'static str) {
        match self {
            MeshUnit::Um => (1e-3, "um", "micrometers"),
            MeshUnit::Mm => (1.0, "mm", "millimeters"),
            MeshUnit::Cm => (10.0, "cm", "centimeters"),
            MeshUnit::M => (1000.0, "m", "meters"),
            MeshUnit::Inch => (25.4, "inch", "inches"),
        }
    }

    /// Its name in a job.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().1
    }
}

/// Longest edge above which a part is asked whether its numbers were taken for inches, mm: parts in a vial are shorter.
pub const LONG_MM: f64 = 100.0;

/// Reads the mesh of a table of the job, which may state its unit; lengths in that unit.
/// Refuses an image, and a unit with a 3MF file, which states its unit.
pub(super) fn read(path: &Path, unit: Option<MeshUnit>, section: &str) -> Result<MeshFile> {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    if ["png", "tif", "tiff"].iter().any(|image| ending == **image) {
        return Err(Error::config(
            format!("{section}.mesh"),
            format!("`{}` is an image", path.display()),
            "a mesh file; images go to `target.image` (drawn along z) or `target.stack` (slices)",
        ));
    }
    if let (true, Some(unit)) = (ending == "3mf", unit) {
        return Err(Error::config(
            format!("{section}.mesh_unit"),
            format!("\"{}\" for a 3MF file", unit.name()),
            "no unit here: a 3MF file states its own",
        ));
    }
    read_mesh(path)
}

pub(super) fn in_mm(mut file: MeshFile, unit: Option<MeshUnit>) -> MeshFile {
    let (factor, ..) = unit.unwrap_or_default().row();
    if factor != 1.0 {
        let vertices = [&mut file.mesh, &mut file.negative].map(|mesh| &mut mesh.vertices);
        let values = vertices.into_iter().flatten().flatten();
        values.for_each(|value| *value *= factor);
    }
    file
}

impl TargetSpec {
    /// Asks for the unit of the mesh, when nothing but its file says how large it is, its box is not between these lengths, and
    /// would be in another unit.
    #[must_use]
    pub fn ask_for_unit(&self, bounds: [[f64; 3]; 2], expected_mm: [f64; 2]) -> Option<String> {
        let bodies = || self.body.iter().flatten();
        let mut files = (self.mesh.iter()).chain(bodies().filter_map(|b| b.mesh.as_ref()));
        let ending = |file: &PathBuf| file.extension().unwrap_or_default().to_ascii_lowercase();
        let is_open = files.next().is_some_and(|file| ending(file) != "3mf");
        let is_stated = self.size_mm.is_some()
            || self.scale.is_some()
            || self.mesh_unit.is_some()
            || bodies().any(|body| body.mesh_unit.is_some());
        if !is_open || is_stated {
            return None;
        }
        let longest = (0..3)
            .map(|i| bounds[1][i] - bounds[0][i])
            .fold(0.0, f64::max);
        let [least, most] = expected_mm;
        let is_expected = |mm: f64| (least..=most).contains(&mm);
        let others: &[MeshUnit] = if longest < least {
            &[MeshUnit::M, MeshUnit::Inch, MeshUnit::Cm]
        } else if longest > most {
            &[MeshUnit::Um]
        } else {
            &[]
        };
        let mut rows = others.iter().map(|unit| unit.row());
        let unit = rows.find(|(mm, ..)| is_expected(longest * mm));
        let unit = unit.map(|(_, name, words)| {
            format!("is its file in {words}? set target.mesh_unit = \"{name}\"")
        });
        let (inch, ..) = MeshUnit::Inch.row();
        let in_mm = longest / inch;
        let of_inches = (longest > most.max(LONG_MM) && is_expected(in_mm)).then(|| {
            let size = concise(in_mm);
            format!("were its millimeters exported as inches? set target.size_mm = {size}")
        });
        let questions: Vec<String> = unit.into_iter().chain(of_inches).collect();
        (!questions.is_empty()).then(|| {
            format!(
                "the part is {} mm long: {}",
                concise(longest),
                questions.join("; ")
            )
        })
    }
}
