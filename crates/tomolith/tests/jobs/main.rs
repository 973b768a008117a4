//! Whole jobs, as another program runs them: stopped and resumed, on several ranks, in time, in two colors. One program, so that it is linked once.

mod bclp_orderings;
mod co_optimize;
mod drawn;
mod foreign_model;
mod in_time;
mod layers;
mod light_in_time;
mod peers;
mod print_time;
mod ranks;
mod resume;
mod two_colors;
mod two_machines;
