//! Going on with a run that was cut off: which checkpoint belongs to a job, and what a run leaves that wrote none.

use crate::error::{Error, Result};
use crate::grid::Patterns;
use crate::io::npy::{PatternPair, write_patterns};
use crate::job::progress::{Event, Progress};
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::card::Card;
use crate::job::resolve::identity::of_unlit;
use crate::models::Work;
use crate::optimize::Checkpoints;
use crate::optimize::checkpoint::{CHECKPOINT, Contents};
use serde_json::Value;
use std::path::Path;
use std::time::Duration;

/// The level of the checkpoint to go on from, if there is one. Where the run is not to be resumed, one of this job stays until the run
/// writes its own, and one of another job is removed.
pub(crate) fn resumes(
    checkpoints: &Checkpoints,
    resume: bool,
    card: Option<&Card>,
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
            Err(_) => {
                remove(&file)?;
                let text = "the checkpoint in the folder is of a job with other settings, as that of a toy is, or broken: this run begins anew and removes it";
                let text = text.to_owned();
                progress.event(&Event::Note { text });
            }
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
        None if file.with_file_name(KEPT).exists() => format!(
            "no checkpoint to resume: starting anew. The run before left its best patterns in {}: `[start.patterns]` with a copy of this file begins from them",
            file.with_file_name(KEPT).display()
        ),
        None => "no checkpoint to resume: starting anew".to_owned(),
    };
    progress.event(&Event::Note { text });
    let of_card = card.zip(checkpoint.as_ref()).and_then(|(card, earlier)| {
        let (was, is) = (earlier.job()[CARD].as_str()?, card.version());
        (was != is).then(|| format!("the checkpoint is of {was}, this run of {is}: what comes of it may differ in its last digits from a run on one card"))
    });
    if let Some(text) = of_card {
        progress.event(&Event::Note { text });
    }
    Ok(checkpoint.map(|checkpoint| checkpoint.level()))
}

/// The key of what a checkpoint says of the card that it is of.
pub(crate) const CARD: &str = "card";

/// Removes a file that may not be there.
fn remove(file: &Path) -> Result<()> {
    match std::fs::remove_file(file) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(Error::io(file, e)),
        _ => Ok(()),
    }
}

/// A checkpoint that cannot be used: first what to do, then why.
pub(crate) fn begin_anew(error: Error) -> Error {
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

/// Removes what [`keep`] left of an earlier try, now that the run has ended well.
pub(crate) fn discard_best(folder: &Path) -> Result<()> {
    let path = folder.join(KEPT);
    match std::fs::remove_file(&path) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(Error::io(&path, e)),
        _ => Ok(()),
    }
}

/// Writes the best patterns of a run that did not end well; after a request to stop only if time suffices.
pub(crate) fn keep(
    resolved: &ResolvedJob,
    raw: &[Patterns],
    folder: &Path,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<()> {
    if !resolved.is_first() {
        return Ok(());
    }
    let writing = Work::with_patience(PATIENCE);
    if work.is_stop_asked() {
        writing.set_patient(true);
        writing.cancel();
    }
    std::fs::create_dir_all(folder).map_err(|e| Error::io(folder, e))?;
    let path = folder.join(KEPT);
    let pairs: Vec<PatternPair<'_>> = raw
        .iter()
        .enumerate()
        .map(|(i, shown)| PatternPair {
            light: resolved.light_name(i),
            shown,
            raw: None,
        })
        .collect();
    let written = match write_patterns(&path, &pairs, &writing) {
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

/// Says what is left where a card failed that held the patterns.
pub(crate) fn lost(folder: &Path, progress: &mut dyn Progress) {
    let left = match folder.join(CHECKPOINT).exists() {
        true => "; `--resume` goes on from the last checkpoint",
        false => ", and there is no checkpoint to resume",
    };
    let text = format!("the card held the patterns, and they are lost{left}");
    progress.event(&Event::Note { text });
}

/// Tables that no checkpoint depends on.
const UNIMPORTANT: [&str; 6] = [
    "stop",
    "checkpoint",
    "evaluate",
    "printer",
    "output",
    "resources",
];

/// The tables of a job that a checkpoint depends on, with every default written out, the memory that its optimizer has, the kind of device, whose
/// memory of earlier steps no other reads, what ends a run on the job's own voxels, and the pixels that the machines cannot light.
pub(crate) fn tables(resolved: &ResolvedJob) -> Result<Value> {
    let (method, mut tables) = (&resolved.method, resolved.tables(&UNIMPORTANT)?);
    if let Some(pairs) = method.pairs() {
        tables["optimizer"][method.name()]["memory"] = (pairs as f64).into();
    }
    let device = if resolved.optics.card.is_some() {
        "gpu"
    } else {
        "cpu"
    };
    tables["resources"] = serde_json::json!({ "device": device });
    let stop = resolved.stop();
    let given = [
        ("stop.iou", stop.iou.is_some()),
        ("stop.loss", stop.loss > 0.0),
        (
            "stop.relative_loss",
            stop.relative_loss.is_some_and(|part| part > 0.0),
        ),
    ];
    let chooses = |is_given: bool| is_given && resolved.stop_chooses_voxels;
    for (key, _) in given.iter().filter(|(_, is_given)| chooses(*is_given)) {
        tables[key] = true.into();
    }
    if let Some(unlit) = of_unlit(resolved) {
        tables["what printer.dead_pixels leaves dark"] = format!("{unlit:x}").into();
    }
    Ok(tables)
}
