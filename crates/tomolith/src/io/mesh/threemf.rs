//! 3MF.
use super::{Sink, bad};
use crate::error::Result;
use std::path::Path;
pub(super) fn parse(_bytes: &[u8], path: &Path, _sink: Sink) -> Result<()> {
    Err(bad(path, "3MF", "later"))
}
