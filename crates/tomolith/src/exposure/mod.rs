//! Everything between a pattern and what a given machine shows.
