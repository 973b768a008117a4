//! Chooses the dose model of a job, and says why.
