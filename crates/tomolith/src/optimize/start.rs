//! Where an optimiser begins.
