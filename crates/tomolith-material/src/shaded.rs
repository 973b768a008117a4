//! Straight light through resin whose cured parts absorb more (or less): the light of another model, weakened on its way.
//!
//! **Equation** Frame f with light along d leaves in voxel v
//!
//! ```text
//! dose(v) = share(v)·e^(−τ_f(v))·F_f(x)(v)        τ_f(v) = ∫ (μ(v − s·d) − μ₀) ds over the way to the middle of v
//! ```
//! F: the model of the resin as it is before anything cures (μ₀), share: active absorption relative to that model's. Rays of a frame lie a voxel apart across the way; μ is linear between voxels, τ between rays. τ is summed along rays and not from
//! voxel to voxel, so shadows do not blur on the way. A voxel's own loss is that of half its width: off by (Δμ·h)²/24 of its dose.
//!
//! **Limits** Level light whose direction is that of its frame: an index-matched vial, collimated light. Cones and waves about that direction cast the shadow of
//! their middle, which is sharp. Outside of the grid nothing cures.
//!
//! **Cost** per frame F's dose of that frame and one pass over the voxels with an exponential. Memory: two volumes, one spare one in a call.

use crate::{Absorption, Model};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::{DoseModel, Facts, Renewal, Space, Work};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};
use tomolith_core::parallel::{InParallel, elements, lines};

/// Columns along z that a thread takes at least.
const COLUMNS: usize = 16;

/// See the [module page](self).
pub struct Shaded {
    model: Arc<Model>,
    /// μ − μ₀, 1/mm.
    excess: HostField,
    /// Active absorption relative to the model's.
    share: HostField,
}

impl Shaded {
    /// Light of a model made for resin of these active and total absorptions (1/mm), in resin of this absorption.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a model with several outputs or cells, or whose resin absorbs nothing; [`Error::Shape`] for other voxels.
    pub fn new(
        model: Arc<Model>,
        [active, attenuation]: [f64; 2],
        absorption: &Absorption,
    ) -> Result<Self> {
        let refused = |what: &str, reason: &str| Error::unsupported(what, reason);
        let [output] = model.outputs() else {
            let reason = "light is weakened in one dose";
            return Err(refused("shading of several outputs", reason));
        };
        if output.cells.is_some() || output.offset != 0 {
            let reason = "resin shades voxel by voxel";
            return Err(refused("shading of a dose with cells", reason));
        }
        if active <= 0.0 {
            let reason = "its dose has no absorption to be changed";
            return Err(refused("shading of pure Radon light", reason));
        }
        let changed = &absorption.attenuation_per_mm;
        if changed.grid.shape != output.grid.shape {
            return Err(Error::shape(
                "absorption of cured resin",
                output.grid.shape,
                changed.grid.shape,
            ));
        }
        let mut excess = HostField::from_slice(&output.field_of(changed));
        let mut share = HostField::from_slice(&output.field_of(&absorption.active_per_mm));
        let (active, attenuation) = (active as f32, attenuation as f32);
        elements(excess.as_mut_slice(), |_, mu| *mu -= attenuation);
        elements(share.as_mut_slice(), |_, mu| *mu /= active);
        Ok(Shaded {
            excess,
            share,
            model,
        })
    }

    /// to += share·e^(−τ)·from for the light of an azimuth.
    fn weaken(&self, azimuth: f64, from: &[f32], to: &mut [f32]) {
        let layout = &self.model.outputs()[0];
        let [_, ny, nx] = layout.grid.shape;
        let row = layout.row;
        let traversal = ColumnTraversal::new(azimuth, [nx, ny], layout.grid.pitch_mm);
        let mut behind = vec![0.0f32; traversal.rays() * row];
        let mut middle = vec![0.0f32; (traversal.across + 1) * row];
        let (excess, share) = (self.excess.as_slice(), self.share.as_slice());
        for step in 0..traversal.along {
            let (shift, rest) = traversal.shift(step);
            // Rays between voxels j − 1 and j + 1, from the one before the first voxel on
            let first = (traversal.most_shift - shift) as usize * row;
            let rays = &mut behind[first..first + middle.len()];
            let rays = rays
                .chunks_mut(COLUMNS * row)
                .zip(middle.chunks_mut(COLUMNS * row));
            rays.enumerate().par_each(|(first, (behind, middle))| {
                let rays = behind.chunks_mut(row).zip(middle.chunks_mut(row));
                for (i, (behind, middle)) in (first * COLUMNS..).zip(rays) {
                    let half = 0.5 * traversal.path_mm as f32;
                    let weights = [(1.0 - rest) * half, rest * half];
                    middle.copy_from_slice(behind);
                    for (j, weight) in [i.checked_sub(1), Some(i)].into_iter().zip(weights) {
                        let Some(j) = j.filter(|j| *j < traversal.across) else {
                            continue;
                        };
                        let column = &excess[traversal.column(step, j) * row..][..row];
                        for ((behind, middle), mu) in
                            behind.iter_mut().zip(&mut *middle).zip(column)
                        {
                            *middle += weight * mu;
                            *behind += 2.0 * weight * mu;
                        }
                    }
                }
            });
            let weigh = |j: usize, to: &mut [f32]| {
                let at = traversal.column(step, j) * row;
                let from = &from[at..at + row];
                if from.iter().all(|v| *v == 0.0) {
                    return;
                }
                let (before, after) = middle[j * row..(j + 2) * row].split_at(row);
                let values = from.iter().zip(&share[at..at + row]);
                for (((to, (from, share)), before), after) in
                    to.iter_mut().zip(values).zip(before).zip(after)
                {
                    let depth = rest * before + (1.0 - rest) * after;
                    *to += share * less(depth) * from;
                }
            };
            if traversal.is_along_x {
                let at = traversal.place(step) * row;
                lines(to, nx * row, |j, plane| weigh(j, &mut plane[at..at + row]));
            } else {
                let plane = nx * row;
                lines(
                    &mut to[traversal.place(step) * plane..][..plane],
                    row,
                    weigh,
                );
            }
        }
    }

    /// Azimuth of a frame, counted through all lights.
    fn azimuth(&self, frame: usize) -> f64 {
        let all = self.model.patterns().iter();
        let mut azimuths = all.flat_map(|layout| &layout.grid.azimuths);
        azimuths.nth(frame).copied().unwrap_or(0.0)
    }
}

/// Traversal of the grid's columns by a frame's light, step by step along the axis that it runs along most.
struct ColumnTraversal {
    is_along_x: bool,
    /// Whether it runs toward lower numbers.
    backward: bool,
    along: usize,
    across: usize,
    nx: usize,
    /// Voxels across that it moves in a step.
    slope: f64,
    /// Its path in a step.
    path_mm: f64,
    most_shift: i64,
    least_shift: i64,
}

impl ColumnTraversal {
    fn new(azimuth: f64, [nx, ny]: [usize; 2], pitch_mm: f64) -> Self {
        // Light of azimuth α comes from there
        let (sin, cos) = azimuth.sin_cos();
        let is_along_x = cos.abs() >= sin.abs();
        let ([forth, aside], [along, across]) = if is_along_x {
            ([-cos, -sin], [nx, ny])
        } else {
            ([-sin, -cos], [ny, nx])
        };
        let slope = aside / forth.abs();
        let last = (slope * along.saturating_sub(1) as f64).floor() as i64;
        ColumnTraversal {
            is_along_x,
            backward: forth < 0.0,
            along,
            across,
            nx,
            slope,
            path_mm: pitch_mm / forth.abs(),
            most_shift: last.max(0),
            least_shift: last.min(0),
        }
    }

    /// Rays that meet the grid.
    fn rays(&self) -> usize {
        self.across + 1 + (self.most_shift - self.least_shift) as usize
    }

    /// By how many voxels rays are moved across before a step: whole ones and the rest.
    fn shift(&self, step: usize) -> (i64, f32) {
        let moved = self.slope * step as f64;
        let whole = moved.floor();
        (whole as i64, (moved - whole) as f32)
    }

    /// Voxel along the axis at a step.
    fn place(&self, step: usize) -> usize {
        if self.backward {
            self.along - 1 - step
        } else {
            step
        }
    }

    /// Number of the column along z of voxel `j` across at a step.
    fn column(&self, step: usize, j: usize) -> usize {
        if self.is_along_x {
            j * self.nx + self.place(step)
        } else {
            self.place(step) * self.nx + j
        }
    }
}

/// e^(−depth) within 6e-6 of itself up to a depth of 80, and 1 at 0: in a form that compilers turn into vectors.
fn less(depth: f32) -> f32 {
    /// Adding it rounds to whole numbers, which its last bits then hold.
    const WHOLE: f32 = 12_582_912.0;
    let power = (-std::f32::consts::LOG2_E * depth).clamp(-126.0, 126.0);
    let shifted = power + WHOLE;
    let rest = power - (shifted - WHOLE);
    // 2^rest, |rest| ≤ ½: Taylor in rest·ln 2
    let t = rest * std::f32::consts::LN_2;
    let factors = [
        1.0 / 720.0,
        1.0 / 120.0,
        1.0 / 24.0,
        1.0 / 6.0,
        0.5,
        1.0,
        1.0,
    ];
    let two_to_rest = factors
        .into_iter()
        .fold(0.0, |sum, factor| sum * t + factor);
    f32::from_bits(two_to_rest.to_bits().wrapping_add(shifted.to_bits() << 23))
}

impl DoseModel for Shaded {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        self.model.facts()
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        self.model.new_field(space)
    }

    fn updates(&self) -> u64 {
        self.model.updates()
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        self.model.renewal()
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let mut frame_cotangent = cotangent.zeros_like();
        for frame in frames {
            work.check()?;
            frame_cotangent.fill(0.0);
            self.weaken(
                self.azimuth(frame),
                cotangent.as_slice(),
                frame_cotangent.as_mut_slice(),
            );
            self.model
                .pullback_of(frame..frame + 1, x, &frame_cotangent, grad, &work.aside())?;
        }
        Ok(())
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let mut frame_dose = dose.zeros_like();
        for frame in frames {
            work.check()?;
            frame_dose.fill(0.0);
            self.model
                .dose_of(frame..frame + 1, x, &mut frame_dose, &work.aside())?;
            self.weaken(
                self.azimuth(frame),
                frame_dose.as_slice(),
                dose.as_mut_slice(),
            );
        }
        Ok(())
    }

    fn describe(&self) -> String {
        format!("{}, shaded by cured resin", self.model.describe())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;

    #[test]
    fn the_exponential_is_that_of_the_library() {
        assert_eq!(less(0.0), 1.0);
        for i in -2000..=8000 {
            let depth = i as f32 * 0.01;
            let exact = (-f64::from(depth)).exp();
            near!(f64::from(less(depth)) / exact, 1.0, 6e-6, "{depth}");
        }
        assert!(less(1e9) < 1e-37 && less(1e9) >= 0.0);
    }
}
