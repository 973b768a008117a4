//! The half ramp of a sealed field, one row of pixels after the other.

use super::field::SealedField;
use tomolith_core::field::half_ramp::SECTIONS;
use tomolith_core::field::{ColumnRun, HalfRamp, HalfRampKernel};

/// The rows of pixels.
pub(crate) struct SealedHalfRamp(HalfRamp);

impl HalfRampKernel<SealedField> for SealedHalfRamp {
    fn new(ramp: HalfRamp, _: &SealedField) -> Self {
        SealedHalfRamp(ramp)
    }

    fn apply(&self, x: &SealedField, out: &mut SealedField) {
        for runs in &self.0.frames {
            let is_lit = |run: &ColumnRun| run.count > 0;
            let (Some(first), Some(last)) =
                (runs.iter().position(is_lit), runs.iter().rposition(is_lit))
            else {
                continue;
            };
            let runs = &runs[first..=last];
            let top = runs.iter().map(|run| run.bottom + run.count).max();
            for row in 0..top.unwrap_or(0) {
                let element = |run: &ColumnRun| {
                    let at = row.checked_sub(run.bottom)?;
                    (at < run.count).then(|| run.first + at)
                };
                let elements: Vec<Option<usize>> = runs.iter().map(element).collect();
                let mut values: Vec<f32> = elements
                    .iter()
                    .map(|element| element.map_or(0.0, |i| x.at(i)))
                    .collect();
                recur(&mut values);
                values.reverse();
                recur(&mut values);
                values.reverse();
                for (element, value) in elements.iter().zip(values) {
                    if let Some(i) = element {
                        out.set(*i, value);
                    }
                }
            }
        }
    }
}

/// M along a row.
fn recur(values: &mut [f32]) {
    let mut states = [0.0f32; 2];
    for value in values {
        for ([b, a], state) in SECTIONS.into_iter().zip(&mut states) {
            let y = *value + *state;
            *state = a * y - b * *value;
            *value = y;
        }
    }
}
