//! Job file → objects → the whole run.
