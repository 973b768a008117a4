//! How long a print takes, for any machine and resin: N·M/t.
//!
//! ```text
//! N·M/t = frames · largest pixel / dose at which the resin gels, mm; of several lights the sum
//! ```
//!
//! A pixel is the energy that it delivers over the whole print, mJ/mm², so a projector whose white has irradiance I shines for M·(D_c/t)/I on each of N angles, where
//! D_c is the resin's critical dose: the print takes N·M/t times D_c/I. Of two prints with one machine and one resin, the one with half N·M/t takes half the time. Lights follow one another here,
//! all with the same irradiance. None when no patterns are given, all are dark, nothing gels, or the response is not known.
//!
//! Two frames, a brightest pixel of 3 mJ/mm², and resin that gels at 0.75 mJ/mm³:
//! ```
//! use std::sync::Arc;
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_core::response::Identity;
//! use tomolith_core::target::label::{PART, VOID};
//! use tomolith_metrics::{evaluate, print::{PatternStats, Print}};
//! let grid = VolumeGrid::centered([1, 1, 2], 0.5);
//! let labels = Volume { grid: grid.clone(), values: vec![PART, VOID] };
//! let response = Volume { grid, values: vec![1.0, 0.5] };
//! let stats = PatternStats { pixels: 8, sum: 12.0, max: 3.0, white: 6.0 };
//! let print = Print::new(&labels, &response).unwrap().with_patterns(stats).with_response(Arc::new(Identity));
//! assert_eq!(evaluate(&print).measures.get("print_time_mm"), Some(8.0)); // the best threshold is 0.75, between void and part
//! ```

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    let patterns = print.patterns()?;
    let dose = print.gel_dose()?;
    (patterns.white > 0.0 && dose > 0.0 && dose.is_finite()).then(|| patterns.white / dose)
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "print_time_mm",
    title: "Print time N·M/t",
    summary: "Frames times the brightest pixel over the dose at which the resin gels: how long the print takes with a given machine and resin.",
    unit: "mm (N·M/t)",
    better: Better::Lower,
    measure,
};
