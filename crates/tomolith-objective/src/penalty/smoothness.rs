//! Smoothness: neighboring pixels and frames that differ cost.
//!
//! **Equation** over pairs of neighboring active pixels along rows (a column's next height), columns and frames, with a
//! weight per direction and Δ their difference
//!
//! ```text
//! R = Σ_pairs w·φ(Δ),   φ = ½·Δ²                          (no `edge`)
//!                       φ = δ·(√(δ² + Δ²) − δ)             (`edge` = δ: total variation, rounded below δ)
//! ```
//!
//! The first frame follows the last when the frames make a full turn. Pixels that are not active have no pairs: the rim
//! of the lit region is free.
//!
//! **Source** Tikhonov's H¹ penalty; the rounded total variation is Charbonnier et al., IEEE Trans. Image Process. 6
//! (1997) 298. **Parameters** see [`Params`]. **Cost** one pass over the patterns, three neighbors a pixel.

use super::{BuildPenalty, MakePenalty, read};
use crate::preset::{HIGHEST_POWER, LARGEST};
use std::f64::consts::TAU;
use tomolith_core::dose::PatternLayout;
use tomolith_core::dose::layout::PixelRun;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::PatternCost;
use tomolith_core::field::costs::{FramePairs, PixelPairs};
use tomolith_core::kind::{Kind, check_ranges, schema_of};

tomolith_core::keys! {
    /// The parameters of smoothness.
    pub struct Params {
        /// Weight of pairs above one another
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub rows: f64 = 1.0,
        /// Weight of pairs side by side
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub columns: f64 = 1.0,
        /// Weight of pairs of the same pixel in neighboring frames
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub angles: f64 = 0.0,
        /// Differences above this cost in proportion and not squared (default: all are squared)
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = HIGHEST_POWER))]
        pub edge: Option<f64>,
    }
}

/// Σ w·φ(xᵢ − xⱼ) for patterns of these layouts.
///
/// # Errors
/// [`Error::Config`] for a negative weight, no weight at all, or an edge that is not above 0.
pub fn smoothness(params: &Params, lights: &[PatternLayout]) -> Result<PatternCost> {
    check_ranges("", params)?;
    if params.rows + params.columns + params.angles == 0.0 {
        return Err(Error::config(
            "rows",
            "rows, columns and angles are all 0: the penalty would do nothing",
            "one of them above 0",
        ));
    }
    let mut frames = Vec::new();
    for light in lights {
        frames.extend(frames_of(params, light, frames.len()));
    }
    Ok(PatternCost::Differences {
        frames,
        edge: params.edge,
    })
}

/// The frames of a light; the first is the `first` of all.
fn frames_of(params: &Params, light: &PatternLayout, first: usize) -> Vec<FramePairs> {
    let (frames, columns) = (light.grid.frames(), light.grid.columns);
    let full = frames > 2 && (light.grid.frame_arc.abs() * frames as f64 - TAU).abs() < 1e-6;
    let run = |frame: usize, column: usize| &light.runs[frame * columns + column];
    let mut list = Vec::with_capacity(frames);
    for frame in 0..frames {
        let next = if full {
            (frame + 1) % frames
        } else {
            frame + 1
        };
        let previous = if frame == 0 && full {
            Some(frames - 1)
        } else {
            frame.checked_sub(1)
        };
        let (mut inside, mut onward) = (Vec::new(), Vec::new());
        for column in 0..columns {
            let here = run(frame, column);
            if params.rows > 0.0 && here.count > 1 {
                inside.push(PixelPairs {
                    first: here.offset,
                    second: here.offset + 1,
                    count: here.count as usize - 1,
                    weight: params.rows,
                });
            }
            if params.columns > 0.0 && column + 1 < columns {
                inside.extend(overlap(here, run(frame, column + 1), params.columns));
            }
            if params.angles > 0.0 && next < frames {
                onward.extend(overlap(here, run(next, column), params.angles));
            }
        }
        list.push(FramePairs {
            len: (0..columns).map(|c| run(frame, c).count as usize).sum(),
            inside,
            onward,
            previous: previous.map(|p| p + first),
        });
    }
    list
}

/// Pairs at the heights that two columns share.
fn overlap(a: &PixelRun, b: &PixelRun, weight: f64) -> Option<PixelPairs> {
    let low = a.bottom.max(b.bottom);
    let high = (a.bottom + a.count).min(b.bottom + b.count);
    (high > low).then(|| PixelPairs {
        first: a.offset + (low - a.bottom) as usize,
        second: b.offset + (low - b.bottom) as usize,
        count: (high - low) as usize,
        weight,
    })
}

/// The row of the table.
pub const KIND: Kind<BuildPenalty> = Kind {
    name: "smoothness",
    summary: "differences between neighboring pixels and frames: squared, or a smoothed total variation",
    example: "[[penalties]]\nsmoothness = { rows = 1.0, columns = 1.0, angles = 0.5 }\nweight = 1e-3",
    schema: schema_of::<Params>,
    build: read::<Params>,
};

impl MakePenalty for Params {
    fn make(&self, lights: &[PatternLayout]) -> Result<PatternCost> {
        smoothness(self, lights)
    }

    fn joins_frames(&self) -> bool {
        self.angles > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::super::Penalties;
    use super::super::tests::alone;
    use super::*;
    use tomolith_core::dose::Quantity;
    use tomolith_core::field::{Field, HostField};
    use tomolith_core::grid::PatternGrid;

    fn of_weights(
        rows: f64,
        columns: f64,
        angles: f64,
        lights: &[PatternLayout],
    ) -> Penalties<HostField> {
        let params = Params {
            rows,
            columns,
            angles,
            edge: None,
        };
        alone(smoothness(&params, lights).unwrap())
    }

    #[test]
    fn pairs_by_hand() {
        // Three frames of two columns: column 0 has heights 0 and 1, column 1 has heights 1 and 2
        let grid = PatternGrid::full_turn(3, 0.0, 3, 2, 0.1);
        let light = PatternLayout::new(
            grid,
            Quantity::Energy,
            0,
            &[(0, 2), (1, 2), (0, 2), (1, 2), (0, 2), (1, 2)],
        );
        let x =
            HostField::from_slice(&[1.0, 3.0, 7.0, 12.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let lights = [light];
        // Along rows ½(2² + 5²); side by side at height 1: ½(7 − 3)²; frame 0 against both others: twice ½Σx²
        assert_eq!(of_weights(1.0, 0.0, 0.0, &lights).value(&x), 14.5);
        assert_eq!(of_weights(0.0, 1.0, 0.0, &lights).value(&x), 8.0);
        assert_eq!(of_weights(0.0, 0.0, 1.0, &lights).value(&x), 203.0);
        let mut gradient = x.zeros_like();
        of_weights(1.0, 1.0, 0.0, &lights).add_gradient(&x, 1.0, &mut gradient);
        assert_eq!(gradient.as_slice()[..4], [-2.0, 2.0 - 4.0, 4.0 - 5.0, 5.0]);
    }

    #[test]
    fn even_light_costs_nothing() {
        let lights = super::super::tests::layouts();
        let len = lights.iter().map(PatternLayout::len).sum();
        let mut x = HostField::zeros(len);
        x.fill(0.7);
        assert_eq!(of_weights(1.0, 1.0, 1.0, &lights).value(&x), 0.0);
    }
}
