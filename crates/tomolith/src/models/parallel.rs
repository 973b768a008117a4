//! The `parallel` dose model (see below).
