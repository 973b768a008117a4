//! The program `tomolith`; what it does is the library's.

use std::env::{args_os, current_exe};
use std::process::ExitCode;

fn main() -> ExitCode {
    silence_mesa();
    let words: Vec<_> = args_os().collect();
    let itself = current_exe().map_or_else(|_| "tomolith".into(), Into::into);
    ExitCode::from(tomolith_cli::main_with(&words, &[itself]))
}

/// Mesa's layer for the choice of a card, which is Tomolith's own choice, asks for a screen and prints an error where there is none.
#[expect(
    unsafe_code,
    reason = "the environment is changed before any thread starts"
)]
fn silence_mesa() {
    // SAFETY: no other thread runs yet that could read the environment.
    unsafe { std::env::set_var("NODEVICE_SELECT", "1") };
}
