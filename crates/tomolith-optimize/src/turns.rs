//! Which errors a step of an alternating method corrects.

use tomolith_core::field::Field;

/// Overdose or underdose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turn {
    /// Where the loss grows with the dose.
    Over,
    /// Where it falls with the dose.
    Under,
}

impl Turn {
    /// The turn of a step, counted from 0: overdose first.
    pub(super) fn of(step: u64) -> Self {
        if step.is_multiple_of(2) {
            Turn::Over
        } else {
            Turn::Under
        }
    }

    /// The other one.
    pub(super) fn other(self) -> Self {
        match self {
            Turn::Over => Turn::Under,
            Turn::Under => Turn::Over,
        }
    }

    /// Keeps this part of ∂L/∂dose.
    pub(super) fn keep<F: Field>(self, cotangent: &mut F) {
        match self {
            Turn::Over => cotangent.clamp(0.0, f32::INFINITY),
            Turn::Under => cotangent.clamp(f32::NEG_INFINITY, 0.0),
        }
    }
}
