//! Metrics: one number of the report a file.
