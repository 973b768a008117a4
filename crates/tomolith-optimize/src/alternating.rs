//! Which errors a step of an alternating method corrects.

use tomolith_core::field::Field;

/// Overdose or underdose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum AlternatingHalf {
    /// Where the loss grows with the dose.
    Over,
    /// Where it falls with the dose.
    Under,
}

impl AlternatingHalf {
    /// The half of a step, counted from 0: overdose first.
    pub(super) fn of(step: u64) -> Self {
        if step.is_multiple_of(2) {
            AlternatingHalf::Over
        } else {
            AlternatingHalf::Under
        }
    }

    /// The other one.
    pub(super) fn other(self) -> Self {
        match self {
            AlternatingHalf::Over => AlternatingHalf::Under,
            AlternatingHalf::Under => AlternatingHalf::Over,
        }
    }

    /// Keeps this part of ∂L/∂dose.
    pub(super) fn keep<F: Field>(self, cotangent: &mut F) {
        match self {
            AlternatingHalf::Over => cotangent.clamp(0.0, f32::INFINITY),
            AlternatingHalf::Under => cotangent.clamp(f32::NEG_INFINITY, 0.0),
        }
    }
}
