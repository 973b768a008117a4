//! Going on with a run that was cut off: which checkpoint belongs to a job, and what is kept where none was written.

use super::progress::{Event, Progress};
use super::read::with_every_default;
use super::scene::{Scene, Voxels};
use crate::error::{Error, Result};
use crate::field::BLOCK;
use crate::grid::Patterns;
use crate::io::npy::{PatternPair, write_patterns};
use crate::models::Run;
use crate::optimize::Checkpoints;
use crate::optimize::checkpoint::{CHECKPOINT, Contents};
use serde_json::Value;
use std::io::Read;
use std::path::Path;
use std::time::Duration;
use tomolith_core::files::open_regular;
use tomolith_core::parallel::InParallel;

/// The level of the checkpoint to go on from, if there is one. Where the run is not to be resumed, one of this job stays until the run
/// writes its own, and one of another job is removed.
pub(super) fn resumes(
    checkpoints: &Checkpoints,
    resume: bool,
    progress: &mut dyn Progress,
) -> Result<Option<usize>> {
    let file = checkpoints.file();
    if !resume {
        match checkpoints.open() {
            Ok(Some(earlier)) => progress.event(&Event::Note {
                text: format!(
                    "the folder holds a checkpoint of this job after iteration {}; this run begins anew, and its first checkpoint replaces \
                     that one. To go on from it, stop and use --resume",
                    earlier.iteration()
                ),
            }),
            Ok(None) => {}
            Err(_) => remove(&file)?,
        }
        remove(&file.with_file_name(KEPT))?;
        return Ok(None);
    }
    let checkpoint = checkpoints.open().map_err(begin_anew)?;
    let text = match &checkpoint {
        Some(checkpoint) => {
            let after = format!("resuming after iteration {}", checkpoint.iteration());
            match checkpoint.contents() {
                Contents::All => after,
                Contents::Patterns => format!(
                    "{after}, from its patterns alone: the method begins anew with them and all its iterations, and the result is not that of an uninterrupted run"
                ),
            }
        }
        None => "no checkpoint to resume: starting anew".to_owned(),
    };
    progress.event(&Event::Note { text });
    Ok(checkpoint.map(|checkpoint| checkpoint.level()))
}

/// Removes a file that may not be there.
fn remove(file: &Path) -> Result<()> {
    match std::fs::remove_file(file) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(Error::io(file, e)),
        _ => Ok(()),
    }
}

/// A checkpoint that cannot be used: first what to do, then why.
pub(super) fn begin_anew(error: Error) -> Error {
    match error {
        Error::Format {
            path,
            found,
            accepted,
        } => Error::config(
            "--resume",
            format!("leave it out to begin anew: {} is {found}", path.display()),
            accepted,
        ),
        other => other,
    }
}

/// The best patterns of a run that did not end well, in the checkpoint folder.
const KEPT: &str = "patterns.npz";

/// How long writing them may take after a request to stop, which has waited for the step at hand already.
const PATIENCE: Duration = Duration::from_millis(200);

/// Writes the best patterns of a run that did not end well; of one that was asked to stop, where there is time for them.
pub(super) fn keep(
    scene: &Scene,
    raw: &[Patterns],
    folder: &Path,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<()> {
    if !scene.is_first() {
        return Ok(());
    }
    let run = Run::with_patience(PATIENCE);
    if cancel.is_stop_asked() {
        run.set_patient(true);
        run.cancel();
    }
    std::fs::create_dir_all(folder).map_err(|e| Error::io(folder, e))?;
    let path = folder.join(KEPT);
    let pairs: Vec<PatternPair<'_>> = raw
        .iter()
        .enumerate()
        .map(|(i, shown)| PatternPair {
            light: scene.light_name(i),
            shown,
            raw: None,
        })
        .collect();
    let written = match write_patterns(&path, &pairs, &run) {
        Err(Error::Canceled) => false,
        written => written.map(|()| true)?,
    };
    let is_saved = folder.join(CHECKPOINT).exists();
    let place = path.display();
    let text = match (written, is_saved) {
        (true, true) => format!(
            "the best patterns so far are in {place}; `--resume` goes on from the last checkpoint"
        ),
        (true, false) => format!(
            "the best patterns so far are in {place}; there is no checkpoint to resume; `[start.patterns]` with this file begins from them"
        ),
        (false, true) => format!(
            "writing the best patterns to {place} would have taken too long; `--resume` goes on from the last checkpoint"
        ),
        (false, false) => format!(
            "writing the best patterns to {place} would have taken too long, and there is no checkpoint to resume"
        ),
    };
    progress.event(&Event::Note { text });
    Ok(())
}

/// The tables of a job that a checkpoint depends on, with every default written out, the memory that its optimizer has, and the kind of device, whose
/// memory of earlier steps no other reads.
pub(super) fn tables(scene: &Scene) -> Result<Value> {
    let (spec, kinds) = (&scene.spec, &scene.kinds);
    let mut tables = with_every_default(spec.clone()).to_value()?;
    if let Some(pairs) = kinds.pairs() {
        tables["optimizer"][kinds.method()]["memory"] = pairs.into();
    }
    if let Some(map) = tables.as_object_mut() {
        for unimportant in [
            "stop",
            "checkpoint",
            "evaluate",
            "printer",
            "output",
            "resources",
        ] {
            map.remove(unimportant);
        }
    }
    let device = if scene.optics.card.is_some() {
        "gpu"
    } else {
        "cpu"
    };
    tables["resources"] = serde_json::json!({ "device": device });
    as_floats(&mut tables);
    Ok(tables)
}

/// 2 and 2.0 are the same number, however a job writes it.
pub(super) fn as_floats(value: &mut Value) {
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

/// What makes a checkpoint belong to this job: its tables and the content of their files, and the voxels in place of the
/// target's table.
pub(super) fn fingerprint(tables: &Value, voxels: &Voxels, base: &Path) -> Result<u64> {
    let mut tables = tables.clone();
    if let Some(map) = tables.as_object_mut() {
        map.remove("target");
    }
    let mut parts = vec![hash(tables.to_string().as_bytes())];
    parts.extend(of_voxels(voxels));
    contents(&tables, base, &mut parts)?;
    Ok(hash(bytemuck::cast_slice(&parts)))
}

/// Hashes of labels and of shares.
pub(super) fn of_voxels(voxels: &Voxels) -> [u64; 2] {
    let labels = voxels.labels.values.chunks(BLOCK).par_map(hash);
    let inside = voxels.target.inside.values.chunks(BLOCK);
    let inside = inside.par_map(|block| hash(bytemuck::cast_slice(block)));
    [labels, inside].map(|hashes| hash(bytemuck::cast_slice(&hashes)))
}

/// Keys that name a file, or a list of files: fields, curves, maps, a matrix, the walls of a vial, bodies in the light, pixels that stay dark, other
/// starts.
const FILES: [&str; 12] = [
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
    "flat_field",
    "dead_pixels",
];

/// Hashes of the contents of all files that tables name, in the order of their keys.
pub(super) fn contents(tables: &Value, base: &Path, found: &mut Vec<u64>) -> Result<()> {
    match tables {
        Value::Array(list) => list.iter().try_for_each(|v| contents(v, base, found)),
        Value::Object(map) => map.iter().try_for_each(|(key, value)| {
            // Those of a scenario are whole paths: "vial.mesh.outer"
            let name = key.rsplit('.').next().unwrap_or(key);
            match FILES.contains(&name) {
                true => files(value, base, found),
                false => contents(value, base, found),
            }
        }),
        _ => Ok(()),
    }
}

/// Hashes of the files that the value of a key names; of a table, of those that it names in turn.
fn files(value: &Value, base: &Path, found: &mut Vec<u64>) -> Result<()> {
    match value {
        Value::String(file) => found.push(content(&base.join(file))?),
        Value::Array(list) => list.iter().try_for_each(|v| files(v, base, found))?,
        table => contents(table, base, found)?,
    }
    Ok(())
}

/// Hash of a file's content.
pub(super) fn content(path: &Path) -> Result<u64> {
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
pub(super) fn hash(bytes: &[u8]) -> u64 {
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
        });
        let hashes = || {
            let mut found = Vec::new();
            contents(&tables, folder.path(), &mut found).map(|()| found)
        };
        let files = ["o.stl", "i.stl", "b.stl", "m.npz"];
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
}
