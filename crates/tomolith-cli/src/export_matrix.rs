//! `tomolith export-matrix`: the dose model of a small job as a sparse matrix.

use crate::arguments::{JobArguments, Manner, must_be_a_place, must_end_in};
use crate::screen::{Screen, done, say};
use clap::Args;
use serde_json::json;
use std::path::PathBuf;
use tomolith::Result;
use tomolith::job::Job;
use tomolith::job::export::matrix;
use tomolith::models::Work;

const EXAMPLES: &str = "\
Examples:
  tomolith export-matrix small.toml --output matrix.npz
  tomolith export-matrix examples/01-gear.toml --toy --output matrix.npz --json
In Python: scipy.sparse.load_npz(\"matrix.npz\") @ patterns.ravel() is the dose [z, y, x], ravelled";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct MatrixArguments {
    #[command(flatten)]
    pub(crate) job: JobArguments,
    /// SciPy CSR file to write: rows are voxels [z, y, x], columns are pixels [angle, row, column] of one light after the other
    #[arg(long, short, value_name = "NPZ")]
    output: PathBuf,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

pub(crate) fn export_matrix(given: &MatrixArguments, job: &Job, work: &Work) -> Result<()> {
    must_end_in("--output", &given.output, &["npz"])?;
    must_be_a_place("--output", &given.output)?;
    let mut screen = Screen::new(given.manner);
    let [rows, columns, entries] = matrix(job, &given.output, &mut screen, work)?;
    drop(screen);
    let found =
        json!({ "file": given.output, "rows": rows, "columns": columns, "entries": entries });
    done(given.manner, found, || {
        say(&format!(
            "{rows} voxels × {columns} pixels, {entries} entries in {}",
            given.output.display()
        ));
    });
    Ok(())
}
