//! `tomolith completions` and `tomolith man`: what shells and manuals know of the command.

use crate::arguments::Arguments;
use clap::CommandFactory;
use clap_complete::Shell;
use std::path::{Path, PathBuf};
use tomolith::io::make_folder;
use tomolith::{Error, Result};

pub(crate) fn completions(shell: Shell) {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "tomolith", &mut text);
    crate::screen::say(String::from_utf8_lossy(&text).trim_end());
}

/// Writes a manual page of every command into a folder, and says where.
pub(crate) fn manual(folder: &Path) -> Result<()> {
    make_folder(folder)?;
    clap_mangen::generate_to(Arguments::command(), folder).map_err(|e| Error::io(folder, e))?;
    let first: PathBuf = folder.join("tomolith.1");
    crate::screen::say(&format!("`man {}` shows the first page", first.display()));
    Ok(())
}
