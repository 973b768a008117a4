//! The program `tomolith`; what it does is the library's.

use std::env::{args_os, current_exe};
use std::process::ExitCode;

fn main() -> ExitCode {
    let words: Vec<_> = args_os().collect();
    let itself = current_exe().map_or_else(|_| "tomolith".into(), Into::into);
    ExitCode::from(tomolith_cli::main_with(&words, &[itself]))
}
