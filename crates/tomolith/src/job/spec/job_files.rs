//! Files that the tables of a job name, found by the keys that name them.

use serde_json::Value;
use std::path::Path;

/// Keys whose value is a file, or a list of files: fields, curves, maps, a matrix, the walls of a vial, bodies in the light, pixels that stay
/// dark, other starts. The `stack` of a target may be a pattern of names, and is none of them.
const FILES: [&str; 13] = [
    "file",
    "or",
    "image",
    "absorption",
    "attenuation",
    "outer",
    "inner",
    "mesh",
    "mask",
    "psf",
    "gray_curve_file",
    "flat_field",
    "dead_pixels",
];

/// The names of files in a table, in the order of their keys. Keys of a scenario are whole paths: "vial.mesh.outer".
pub(crate) fn files_in<'v>(
    table: impl IntoIterator<Item = (&'v String, &'v mut Value)>,
) -> Vec<&'v mut Value> {
    let mut found = Vec::new();
    for (key, value) in table {
        let name = key.rsplit('.').next().unwrap_or(key);
        collect(value, FILES.contains(&name), &mut found);
    }
    found
}

fn collect<'v>(value: &'v mut Value, is_file: bool, found: &mut Vec<&'v mut Value>) {
    match value {
        Value::String(_) if is_file => found.push(value),
        Value::Array(list) => list.iter_mut().for_each(|v| collect(v, is_file, found)),
        Value::Object(table) => found.extend(files_in(table)),
        _ => {}
    }
}

/// Makes the files of a table absolute; `base` is the folder that they are relative to.
pub(crate) fn make_absolute<'v>(
    table: impl IntoIterator<Item = (&'v String, &'v mut Value)>,
    base: &Path,
) {
    for file in files_in(table) {
        let path = absolute(base, Path::new(file.as_str().unwrap_or_default()));
        *file = path.to_string_lossy().into();
    }
}

/// The absolute path of a file in a folder; the path itself where there is no current folder.
pub(crate) fn absolute(base: &Path, file: &Path) -> std::path::PathBuf {
    let path = base.join(file);
    std::path::absolute(&path).unwrap_or(path)
}
