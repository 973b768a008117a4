//! What tells a job from others: hashes of its tables, of the files that they name, and of voxels.

use crate::error::{Error, Result};
use crate::exposure::Printer;
use crate::field::BLOCK;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::job::spec::JobSpec;
use crate::job::spec::job_files::files_in;
use crate::job::spec::read::with_every_default;
use serde_json::Value;
use std::io::Read;
use std::path::Path;
use tomolith_core::files::open_regular;
use tomolith_core::parallel::InParallel;

use crate::io::slices::stack_files;

use crate::target::TargetSpec;

/// 2 and 2.0 are the same number, however a job writes it.
fn as_floats(value: &mut Value) {
    match value {
        Value::Number(number) => {
            if let Some(float) = number.as_f64() {
                *value = Value::from(float);
            }
        }
        Value::Array(list) => list.iter_mut().for_each(as_floats),
        Value::Object(map) => map.values_mut().for_each(as_floats),
        _ => {}
    }
}

/// All tables of a job but some, with every default written out.
pub(crate) fn tables_of(spec: &JobSpec, without: &[&str]) -> Result<Value> {
    let mut tables = with_every_default(spec.clone()).to_value()?;
    as_floats(&mut tables);
    if let Some(map) = tables.as_object_mut() {
        map.retain(|key, _| !without.contains(&key.as_str()));
    }
    Ok(tables)
}

/// What makes a checkpoint belong to this job: its tables and the content of their files, wherever these lie, and the voxels in place of the
/// target's table, unless this has bodies that change the light; not the part's name.
pub(crate) fn fingerprint(tables: &Value, voxels: &Voxels, base: &Path) -> Result<u64> {
    let mut tables = tables.clone();
    let prints = |body: &Value| body["role"] == "print";
    let bodies = tables["target"]["body"].as_array();
    let changes_light = bodies.is_some_and(|bodies| !bodies.iter().all(prints));
    if let Some(map) = tables.as_object_mut().filter(|_| !changes_light) {
        map.remove("target");
    }
    let mut parts = of_voxels(voxels).to_vec();
    contents(&tables, base, &mut parts)?;
    parts.push(hash(without_names(tables).to_string().as_bytes()));
    Ok(hash(bytemuck::cast_slice(&parts)))
}

/// Tables without what may change while the job stays the same: where its files lie, and what the part is called.
pub(crate) fn without_names(mut tables: Value) -> Value {
    if let Some(target) = tables.get_mut("target").and_then(Value::as_object_mut) {
        target.remove("name");
    }
    let map = tables.as_object_mut();
    for file in map.map(files_in).unwrap_or_default() {
        *file = Value::Null;
    }
    tables
}

/// A hash of the pixels that the machines of the lights cannot light; None where they light all.
pub(crate) fn of_unlit(resolved: &ResolvedJob) -> Option<u64> {
    let lights = resolved.optics.lights.iter();
    let masks = lights.flat_map(|light| &light.selection.masks);
    let of_mask = |sum, open: &bool| hash_on(sum, &[u8::from(*open)]);
    let mut printers = resolved.printers.iter().flatten();
    printers
        .any(Printer::has_dead_pixels)
        .then(|| (masks.flat_map(|mask| mask.as_slice())).fold(FNV, of_mask))
}

/// Hashes of labels and of shares.
pub(crate) fn of_voxels(voxels: &Voxels) -> [u64; 2] {
    let labels = voxels.labels.values.chunks(BLOCK).par_map(hash);
    let inside = voxels.target.inside.values.chunks(BLOCK);
    let inside = inside.par_map(|block| hash(bytemuck::cast_slice(block)));
    [labels, inside].map(|hashes| hash(bytemuck::cast_slice(&hashes)))
}

/// Hashes of the contents of all files that tables name, in the order of their keys.
pub(crate) fn contents(tables: &Value, base: &Path, found: &mut Vec<u64>) -> Result<()> {
    let mut tables = tables.clone();
    for file in tables.as_object_mut().map(files_in).unwrap_or_default() {
        found.push(content(&base.join(file.as_str().unwrap_or_default()))?);
    }
    Ok(())
}

/// Hash of a file's content.
pub(crate) fn content(path: &Path) -> Result<u64> {
    let failed = |e| Error::io(path, e);
    let mut file = open_regular(path)?;
    let (mut block, mut sum) = (vec![0u8; BLOCK], FNV);
    loop {
        let read = file.read(&mut block).map_err(failed)?;
        if read == 0 {
            return Ok(sum);
        }
        sum = hash_on(sum, &block[..read]);
    }
}

/// FNV-1a, 64 bits.
pub(crate) fn hash(bytes: &[u8]) -> u64 {
    hash_on(FNV, bytes)
}

/// Where FNV-1a begins.
const FNV: u64 = 0xcbf2_9ce4_8422_2325;

/// Goes on with FNV-1a.
fn hash_on(sum: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(sum, |h, &b| {
        (h ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// Hashes of the contents of all files that a target names, which then go by their names alone.
pub(crate) fn take_files(target: &mut TargetSpec, base: &Path, found: &mut Vec<u64>) -> Result<()> {
    for file in target.files_mut() {
        let path = base.join(&*file);
        // A stack is a folder, or a pattern of names; whoever reads it reports what is missing
        let files = stack_files(&path).unwrap_or_default();
        for file in files.iter().filter(|file| file.is_file()) {
            found.push(content(file)?);
        }
        *file = file.file_name().map(Into::into).unwrap_or_default();
    }
    Ok(())
}

impl ResolvedJob {
    /// What the parts of all species on the job's grid are known by.
    pub(crate) fn identity_of_parts(&self) -> Result<u64> {
        let mut parts = vec![hash(format!("{:?}", self.grid).as_bytes())];
        for s in 0..self.species.len() {
            let mut target = with_every_default(self.spec.of_species(s)).target;
            take_files(&mut target, &self.base, &mut parts)?;
            parts.push(hash(format!("{target:?}").as_bytes()));
        }
        Ok(hash(bytemuck::cast_slice(&parts)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_that_a_job_names_is_looked_into() {
        let folder = tempfile::tempdir().unwrap();
        let tables = serde_json::json!({
            "vial": { "mesh": { "outer": "o.stl", "inner": "i.stl", "refractive_index": 1.5 } },
            "obstacles": [{ "mesh": "b.stl", "scale": 1.0 }],
            "model": { "matrix": { "file": "m.npz" } },
            "printer": { "gray_curve_file": "g.csv" },
            "scenario": [{ "set": { "light[0].selection.mask": "s.npy" } }],
            "start": { "patterns": { "file": "p.npz", "or": ["q.npz"] } },
        });
        let hashes = || {
            let mut found = Vec::new();
            contents(&tables, folder.path(), &mut found).map(|()| found)
        };
        let files = [
            "o.stl", "i.stl", "b.stl", "m.npz", "g.csv", "s.npy", "p.npz", "q.npz",
        ];
        for name in files {
            assert!(hashes().is_err(), "{name} is not there yet");
            std::fs::write(folder.path().join(name), "1").unwrap();
        }
        let before = hashes().unwrap();
        assert_eq!(before.len(), files.len());
        for name in files {
            std::fs::write(folder.path().join(name), "2").unwrap();
            assert_ne!(hashes().unwrap(), before, "{name}");
            std::fs::write(folder.path().join(name), "1").unwrap();
        }
    }

    #[test]
    fn names_and_places_of_files_are_not_the_job() {
        let job = |name: &str, mesh: &str, role: &str| {
            let body = serde_json::json!({ "mesh": mesh, "role": role });
            let tables = serde_json::json!({ "target": { "name": name, "body": [body] } });
            without_names(tables)
        };
        let here = job("knob", "knob.stl", "insert");
        assert_eq!(here, job("another", "moved/knob.stl", "insert"));
        assert_ne!(here, job("knob", "knob.stl", "keep-dark"));
    }
}
