//! The files of a run folder.

use super::folder::RunFolder;
use super::judge::Judged;
use super::optimise::Optimised;
use super::progress::{Event, Progress};
use super::read::Job;
use super::scene::{Scene, Voxels};
use crate::error::Result;
use crate::exposure::{Quantised, frame_rate, movie_name};
use crate::grid::Patterns;
use crate::io::csv::{HistoryRow, write_history};
use crate::io::frames::{FrameSet, write_frames};
use crate::io::mp4::{MovieCheck, check_movie, write_movie};
use crate::io::npy::{PatternPair, write_patterns, write_volume};
use crate::io::stl::write_stl;
use crate::io::vti::{VtiValues, write_vti};
use crate::metrics::print::Print;
use std::path::Path;

/// The patterns of a run, per light.
pub(crate) struct Written {
    /// As whole numbers.
    pub(crate) quantised: Vec<Quantised>,
    /// What they stand for.
    pub(crate) shown: Vec<Patterns>,
    /// Before quantisation.
    pub(crate) raw: Option<Vec<Patterns>>,
}

/// Writes everything to the folder's new files.
///
/// # Errors
/// [`Error::Io`](crate::Error::Io), and what a format cannot hold.
#[expect(
    clippy::too_many_arguments,
    reason = "every stage of the run leaves something in the folder"
)]
pub(crate) fn all(
    job: &Job,
    scene: &Scene,
    voxels: &Voxels,
    patterns: &Written,
    judged: &Judged,
    optimised: Option<&Optimised>,
    folder: &RunFolder,
    progress: &mut dyn Progress,
) -> Result<()> {
    let new = folder.new_files();
    let pairs: Vec<PatternPair<'_>> = patterns
        .shown
        .iter()
        .enumerate()
        .map(|(i, shown)| PatternPair {
            light: scene.light_name(i),
            shown,
            raw: patterns.raw.as_ref().map(|raw| &raw[i]),
        })
        .collect();
    write_patterns(&new.join("patterns.npz"), &pairs)?;
    let sets: Vec<FrameSet<'_>> = patterns
        .quantised
        .iter()
        .enumerate()
        .map(|(i, levels)| levels.frames(scene.light_name(i)))
        .collect();
    write_frames(&new.join("frames"), &sets)?;
    let movies = movies(scene, &sets, &new, progress)?;
    write_volume(&new.join("dose.npy"), &judged.dose)?;
    write_vti(
        &new.join("dose.vti"),
        &scene.grid,
        &[
            ("dose", VtiValues::F32(&judged.dose.values)),
            ("target", VtiValues::F32(&voxels.target.inside.values)),
            ("label", VtiValues::U8(&voxels.labels.values)),
        ],
    )?;
    print(scene, voxels, judged, &new.join("print.stl"))?;
    if let Some(optimised) = optimised {
        write_history(&new.join("history.csv"), &history(optimised))?;
    }
    let _ = (job, movies);
    Ok(())
}

/// A movie per light, read back; lights whose frames make no movie (a list of angles) have none.
fn movies(
    scene: &Scene,
    sets: &[FrameSet<'_>],
    folder: &Path,
    progress: &mut dyn Progress,
) -> Result<Vec<(String, MovieCheck)>> {
    let mut checks = Vec::new();
    for set in sets {
        let arc = set.grid.frame_arc * set.grid.frames() as f64;
        if arc == 0.0 {
            let text = "a list of angles has no frame rate: no movie is written".to_owned();
            progress.event(&Event::Note { text });
            continue;
        }
        let part = set.light.map_or_else(
            || scene.name.clone(),
            |light| format!("{}_{light}", scene.name),
        );
        let name = movie_name(&part, scene.spec.output.rpm);
        let path = folder.join(&name);
        write_movie(
            &path,
            set,
            frame_rate(scene.spec.output.rpm, set.grid.frames(), arc)?,
        )?;
        checks.push((name, check_movie(&path, set)?));
    }
    Ok(checks)
}

/// The predicted surface, from the dose on the optimisation's voxels at the threshold of the evaluation.
fn print(scene: &Scene, voxels: &Voxels, judged: &Judged, path: &Path) -> Result<()> {
    let response = scene.responses(judged.dose.clone())?;
    let mut print = Print::new(&voxels.labels, &response)?;
    if let Some(threshold) = judged.evaluation.gel_threshold {
        print = print.with_threshold(threshold)?;
    }
    let surface = print.surface();
    write_stl(
        path,
        &format!("{}, predicted print", scene.name),
        &surface.corners,
        &surface.triangles,
    )
}

fn history(optimised: &Optimised) -> Vec<HistoryRow> {
    let row = |row: &crate::optimize::Row| HistoryRow {
        iteration: row.iteration,
        loss: row.loss,
        projected_gradient: row.projected_gradient.unwrap_or(f64::NAN),
        step: row.step.unwrap_or(f64::NAN),
        forward_calls: row.forward as usize,
        adjoint_calls: row.adjoint as usize,
        seconds: row.seconds,
    };
    optimised.outcome.history.iter().map(row).collect()
}
