//! The history of an optimization as a table: `history.csv`.
//!
//! One line an iteration, with a header; numbers as short as they can be read back exactly, `.` as decimal point.
//!
//! ```
//! use tomolith_io::csv::{HistoryRow, history_text};
//! let row = HistoryRow { iteration: 1, loss: 0.5, projected_gradient: Some(1e-3), step: Some(1.0), forward_calls: 2, adjoint_calls: 2, seconds: 0.25, iou: Some(0.875), process_window: None, response: Vec::new() };
//! assert_eq!(
//!     history_text(&[row]),
//!     "iteration,loss,projected_gradient,step,forward_calls,adjoint_calls,seconds,iou,process_window\n1,0.5,0.001,1,2,2,0.25,0.875,\n"
//! );
//! ```

use super::whole::write_text;
use std::fmt::Write as _;
use std::path::Path;
use tomolith_core::error::Result;
use tomolith_core::units::exact;

/// What is known after one iteration. Metrics are measured after some of them.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct HistoryRow {
    /// Iteration, 0 = the start.
    pub iteration: usize,
    /// Loss, penalties included.
    pub loss: f64,
    /// Norm of the projected gradient before the step, relative to that of the first step; none at the start.
    pub projected_gradient: Option<f64>,
    /// Step length that was taken; none at the start.
    pub step: Option<f64>,
    /// Dose model calls so far.
    pub forward_calls: usize,
    /// Pull-back calls so far.
    pub adjoint_calls: usize,
    /// Wall time since the start, s.
    pub seconds: f64,
    /// Best IoU on the optimization's own grid, where it was measured.
    pub iou: Option<f64>,
    /// Process window on the optimization's own grid, where it was measured.
    pub process_window: Option<f64>,
    /// Parameters of the response that were found with the patterns; empty where none were unknowns. Each is a column `response.NAME`.
    #[serde(default)]
    pub response: Vec<(String, f64)>,
}

/// A number, or nothing where there is none.
fn text_of(value: Option<f64>) -> String {
    value.map(exact).unwrap_or_default()
}

/// The table as text.
#[must_use]
pub fn history_text(rows: &[HistoryRow]) -> String {
    let mut text = String::from(
        "iteration,loss,projected_gradient,step,forward_calls,adjoint_calls,seconds,iou,process_window",
    );
    let names: Vec<&str> = rows.last().map_or_else(Vec::new, |row| {
        row.response.iter().map(|(name, _)| name.as_str()).collect()
    });
    names
        .iter()
        .for_each(|name| text.extend([",response.", name]));
    text.push('\n');
    for r in rows {
        // Writing into a string cannot fail
        let _ = write!(
            text,
            "{},{},{},{},{},{},{},{},{}",
            r.iteration,
            exact(r.loss),
            text_of(r.projected_gradient),
            text_of(r.step),
            r.forward_calls,
            r.adjoint_calls,
            exact(r.seconds),
            text_of(r.iou),
            text_of(r.process_window),
        );
        for i in 0..names.len() {
            text.push(',');
            text += &text_of(r.response.get(i).map(|(_, value)| *value));
        }
        text.push('\n');
    }
    text
}

/// Writes `history.csv`.
///
/// # Errors
/// [`Error::Io`](tomolith_core::Error::Io).
pub fn write_history(path: &Path, rows: &[HistoryRow]) -> Result<()> {
    write_text(path, &history_text(rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_losses_are_short_and_whole_numbers_have_no_point() {
        let row = HistoryRow {
            iteration: 3,
            loss: 6.394_884_621_840_902e-10,
            projected_gradient: None,
            step: Some(1.0),
            forward_calls: 4,
            adjoint_calls: 3,
            seconds: 0.5,
            iou: Some(0.875),
            process_window: None,
            response: vec![("steepness".to_owned(), 12.0)],
        };
        assert_eq!(
            history_text(&[row]),
            "iteration,loss,projected_gradient,step,forward_calls,adjoint_calls,seconds,iou,process_window,response.steepness\n\
             3,6.394884621840902e-10,,1,4,3,0.5,0.875,,12\n"
        );
    }
}
