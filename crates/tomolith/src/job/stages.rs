//! stub
use super::*;
use crate::error::Result;
use crate::models::Run;
use std::path::Path;
/// stub
pub fn run(_job: &Job, _resume: bool, _progress: &mut dyn Progress, _run: &Run) -> Result<Summary> {
    unimplemented!()
}
/// stub
pub fn simulate(
    _job: &Job,
    _patterns: &Path,
    _progress: &mut dyn Progress,
    _run: &Run,
) -> Result<Summary> {
    unimplemented!()
}
/// stub
pub fn check(_job: &Job, _run: &Run) -> Result<Plan> {
    unimplemented!()
}
