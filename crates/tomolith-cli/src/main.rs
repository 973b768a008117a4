//! The `tomolith` command.
fn main() {}
