//! Optimisers: from a problem to patterns.
