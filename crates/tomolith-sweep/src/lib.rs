//! Many runs of one job: axes, runs side by side, a table, maps and curves, and the best job.
//!
//! | step | file |
//! |---|---|
//! | the sweep file, typed, read and checked | `spec`, `file` |
//! | axes → points | `axes`, with conditions of `expression` |
//! | points → jobs that are checked, their identities, where each starts | `plan` |
//! | runs side by side, shares, merging | `engine` |
//! | folders of runs → rows, CSV | `table`, `metric` |
//! | rows → maps and curves | `pictures`, drawn by `tomolith-report` |
//! | a paper's numbers next to those of sweeps, jobs and commands | `study`, `commands`, `figures`, `reproduce` |
//!
//! The manual is docs/sweeps.md. A run's folder is named by the identity of its job ([`Job::identity`](tomolith::job::Job::identity)), so that
//! what is finished is found again whatever else has changed in the sweep.
//!
//! ```no_run
//! use tomolith::models::Work;
//! use tomolith_sweep::{Sweep, SweepEvent, Watch, run};
//! struct Quiet;
//! impl Watch for Quiet {
//!     fn event(&mut self, _: &SweepEvent) {}
//! }
//! let work = Work::new();
//! let plan = Sweep::read("examples/sweeps/threshold-map.toml".as_ref())?.plan(8, &work)?;
//! let outcome = run(&plan, None, &mut Quiet, &work)?;
//! println!("{outcome}");
//! # Ok::<(), tomolith::Error>(())
//! ```

mod axes;
mod commands;
mod engine;
mod expression;
mod figures;
mod file;
mod metric;
mod pictures;
mod plan;
mod reproduce;
mod spec;
mod study;
mod table;

pub use axes::{MOST_RUNS, SweepPoint};
pub use engine::{BestRun, Shard, SweepEvent, SweepOutcome, Watch, merge, run};
pub use file::Sweep;
pub use plan::{Planned, SweepPlan};
pub use reproduce::{Host, PublishedValue, Reproduction, StudyCost, StudyRow, Verdict, reproduce};
pub use study::Study;
pub use table::TABLE_SCHEMA;
