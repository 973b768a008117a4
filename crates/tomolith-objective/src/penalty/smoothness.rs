//! Smoothness: neighbouring pixels and frames that differ cost.
//!
//! **Equation** over pairs of neighbouring active pixels along rows (a column's next height), columns and frames, with a
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
//! (1997) 298. **Parameters** see [`Params`]. **Cost** one pass over the patterns, three neighbours a pixel.

use super::{BuildPenalty, PatternPenalty};
use crate::preset::{not_negative, positive};
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tomolith_core::dose::PatternLayout;
use tomolith_core::dose::layout::PixelRun;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::kind::Kind;

/// The parameters of smoothness.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Weight of pairs above one another, 0 or above (default 1)
    pub rows: f64,
    /// Weight of pairs side by side, 0 or above (default 1)
    pub columns: f64,
    /// Weight of pairs of the same pixel in neighbouring frames, 0 or above (default 0)
    pub angles: f64,
    /// Differences above this cost in proportion and not squared, above 0 (default: all are squared)
    pub edge: Option<f64>,
}

impl Default for Params {
    fn default() -> Self {
        Params {
            rows: 1.0,
            columns: 1.0,
            angles: 0.0,
            edge: None,
        }
    }
}

/// One direction: pairs (a + i, b + i) for i below `count`.
struct Pairs {
    first: usize,
    second: usize,
    count: usize,
    weight: f64,
}

/// The elements of a frame, and the pairs that begin in it.
struct Frame {
    len: usize,
    /// Both ends in this frame.
    inside: Vec<Pairs>,
    /// The second end in the next frame.
    onward: Vec<Pairs>,
    /// The frame whose next one this is.
    previous: Option<usize>,
}

/// Σ w·φ(xᵢ − xⱼ)
pub struct Smoothness {
    /// Every frame of every light, in the order of the field.
    frames: Vec<Frame>,
    edge: Option<f64>,
}

impl Smoothness {
    /// For patterns of these layouts.
    ///
    /// # Errors
    /// [`Error::Config`] for a negative weight, no weight at all, or an edge that is not above 0.
    pub fn new(params: &Params, lights: &[PatternLayout]) -> Result<Self> {
        for (key, weight) in [
            ("rows", params.rows),
            ("columns", params.columns),
            ("angles", params.angles),
        ] {
            not_negative(key, weight)?;
        }
        if params.rows + params.columns + params.angles == 0.0 {
            return Err(Error::config(
                "rows",
                "rows, columns and angles are all 0",
                "one of them above 0",
            ));
        }
        params.edge.map_or(Ok(()), |edge| positive("edge", edge))?;
        let mut frames = Vec::new();
        for light in lights {
            frames.extend(frames_of(params, light, frames.len()));
        }
        Ok(Smoothness {
            frames,
            edge: params.edge,
        })
    }

    /// φ and dφ/dΔ
    #[inline]
    fn term(&self, difference: f64) -> (f64, f64) {
        match self.edge {
            None => (0.5 * difference * difference, difference),
            Some(edge) => {
                let share = difference / edge;
                let root = share.mul_add(share, 1.0).sqrt();
                // δ²(√(1 + s²) − 1) without cancellation
                (difference * difference / (1.0 + root), difference / root)
            }
        }
    }

    /// Sums `each(first, second, weight)` over all pairs, frame by frame.
    fn sum(&self, each: impl Fn(usize, usize, f64) -> (f64, f64) + Sync) -> (f64, f64) {
        let sums: Vec<(f64, f64)> = self
            .frames
            .par_iter()
            .map(|frame| {
                let mut sum = (0.0, 0.0);
                for p in frame.inside.iter().chain(&frame.onward) {
                    for i in 0..p.count {
                        let term = each(p.first + i, p.second + i, p.weight);
                        sum = (sum.0 + term.0, sum.1 + term.1);
                    }
                }
                sum
            })
            .collect();
        sums.iter().fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1))
    }
}

/// The frames of a light; the first is the `first` of all.
fn frames_of(params: &Params, light: &PatternLayout, first: usize) -> Vec<Frame> {
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
                inside.push(Pairs {
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
        list.push(Frame {
            len: (0..columns).map(|c| run(frame, c).count as usize).sum(),
            inside,
            onward,
            previous: previous.map(|p| p + first),
        });
    }
    list
}

/// Pairs at the heights that two columns share.
fn overlap(a: &PixelRun, b: &PixelRun, weight: f64) -> Option<Pairs> {
    let low = a.bottom.max(b.bottom);
    let high = (a.bottom + a.count).min(b.bottom + b.count);
    (high > low).then(|| Pairs {
        first: a.offset + (low - a.bottom) as usize,
        second: b.offset + (low - b.bottom) as usize,
        count: (high - low) as usize,
        weight,
    })
}

impl PatternPenalty<HostField> for Smoothness {
    fn value(&self, x: &HostField) -> f64 {
        let x = x.as_slice();
        self.sum(|i, j, w| (w * self.term(f64::from(x[i]) - f64::from(x[j])).0, 0.0))
            .0
    }

    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn add_gradient(&self, x: &HostField, scale: f64, gradient: &mut HostField) -> f64 {
        let values = x.as_slice();
        let push = |p: &Pairs, i: usize| {
            let difference = f64::from(values[p.first + i]) - f64::from(values[p.second + i]);
            (scale * p.weight * self.term(difference).1) as f32
        };
        let (mut rest, mut begin) = (gradient.as_mut_slice(), 0);
        let mut pieces = Vec::with_capacity(self.frames.len());
        for frame in &self.frames {
            let piece = rest.split_off_mut(..frame.len).unwrap_or_default();
            pieces.push((begin, piece, frame));
            begin += frame.len;
        }
        // Each frame gathers what its own pairs and those of the one before push on it
        pieces.par_iter_mut().for_each(|(begin, gradient, frame)| {
            for p in &frame.inside {
                for i in 0..p.count {
                    let push = push(p, i);
                    gradient[p.first + i - *begin] += push;
                    gradient[p.second + i - *begin] -= push;
                }
            }
            for p in &frame.onward {
                (0..p.count).for_each(|i| gradient[p.first + i - *begin] += push(p, i));
            }
            let before = frame.previous.map_or(&[][..], |p| &self.frames[p].onward);
            for p in before {
                (0..p.count).for_each(|i| gradient[p.second + i - *begin] -= push(p, i));
            }
        });
        self.value(x)
    }

    fn slope_along(&self, x: &HostField, step: &HostField, alpha: f32) -> (f64, f64) {
        let (x, step) = (x.as_slice(), step.as_slice());
        let at = |i: usize| f64::from(x[i] + alpha * step[i]);
        self.sum(|i, j, w| {
            let (term, slope) = self.term(at(i) - at(j));
            (
                w * term,
                w * slope * (f64::from(step[i]) - f64::from(step[j])),
            )
        })
    }

    fn is_convex(&self) -> bool {
        true
    }
}

/// The row of the table.
pub const KIND: Kind<BuildPenalty> = Kind {
    name: "smoothness",
    summary: "neighbouring pixels and frames that differ cost: squares, or rounded total variation",
    example: "[[penalties]]\nsmoothness = { rows = 1.0, columns = 1.0, angles = 0.5 }\nweight = 1e-3",
    schema: || schemars::schema_for!(Params),
    build: |section, lights| {
        let params: Params = section.parse()?;
        let penalty = Smoothness::new(&params, lights).map_err(|e| e.under(&section.path))?;
        Ok(Box::new(penalty))
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::dose::Quantity;
    use tomolith_core::field::Field;
    use tomolith_core::grid::PatternGrid;

    fn smoothness(rows: f64, columns: f64, angles: f64, lights: &[PatternLayout]) -> Smoothness {
        Smoothness::new(
            &Params {
                rows,
                columns,
                angles,
                edge: None,
            },
            lights,
        )
        .unwrap()
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
        assert_eq!(smoothness(1.0, 0.0, 0.0, &lights).value(&x), 14.5);
        assert_eq!(smoothness(0.0, 1.0, 0.0, &lights).value(&x), 8.0);
        assert_eq!(smoothness(0.0, 0.0, 1.0, &lights).value(&x), 203.0);
        let mut gradient = x.zeros_like();
        smoothness(1.0, 1.0, 0.0, &lights).add_gradient(&x, 1.0, &mut gradient);
        assert_eq!(gradient.as_slice()[..4], [-2.0, 2.0 - 4.0, 4.0 - 5.0, 5.0]);
    }

    #[test]
    fn even_light_costs_nothing_and_steps_cost_their_height_once_they_are_edges() {
        let lights = super::super::tests::layouts();
        let len = lights.iter().map(PatternLayout::len).sum();
        let mut x = HostField::zeros(len);
        x.fill(0.7);
        assert_eq!(smoothness(1.0, 1.0, 1.0, &lights).value(&x), 0.0);
        let edged = Smoothness {
            frames: Vec::new(),
            edge: Some(1e-3),
        };
        let (term, slope) = edged.term(2.0);
        assert!((term / 1e-3 - (2.0 - 1e-3)).abs() < 1e-6 && (slope / 1e-3 - 1.0).abs() < 1e-6);
        let (term, _) = edged.term(1e-5);
        assert!((term / 0.5e-10 - 1.0).abs() < 1e-4);
    }
}
