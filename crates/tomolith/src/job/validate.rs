//! Ranges of every key, before any work.
