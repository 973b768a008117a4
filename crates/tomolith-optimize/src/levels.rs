//! Patterns at the few levels that a projector shows.
//!
//! With b bits a pixel shows one of 2^b levels of the full scale s (`tomolith_optics::exposure::quantize`), and with few bits plain
//! rounding loses what the optimization reached. After the optimization, [`improve`] therefore descends once more, on the patterns
//! that are *shown*: y is the input of the machine, Q(y) what it shows, and the gradient at Q(y) moves y.
//!
//! ```text
//! v ← m·v + ∇L(Q(y))        y ← min(max(y − t·v, min), s)        m = 0.8
//! ```
//!
//! A pixel changes its level when what it was moved by adds up to half a level, so the doses' errors of all frames together decide, not
//! those of the pixel alone. t begins at 0.3 of the length to the least loss along −∇L, becomes 0.6 of itself after a step that raised
//! the loss and 1.1 of itself after one that did not. Of all steps the patterns with the least loss are taken; those of plain rounding
//! are one of them, so that the loss is never above theirs. Pixels of a machine that are turned, shifted or of another size than those of the light are made up for
//! in the same way, at any bit depth.
//!
//! **Full scale** of few levels. The brightest pixels of an optimization are few, and with few levels they cost all others their steps. Eight
//! shares of the brightest pixel (of each light), 1 to 0.18, are tried with plain rounding, and three quarters of the one with the least loss are
//! taken: the steps win back what is cut off at the top. The largest y stays s, so that the levels stay where they are.
//!
//! **Error diffusion** is tried as well for few levels, at the same full scales: a pixel carries what its level lacks to the same pixel of the next frame, whose
//! light takes nearly the same path ([`diffused`]). Where the loss is least that way, its patterns are taken.
//!
//! **Source** The gradient at the rounded values moves values that are not rounded: the straight-through estimator of Bengio, Léonard and
//! Courville, arXiv 1308.3432, § 4, without an estimate of Q′. Measured against plain rounding and error diffusion in
//! docs/choices.md.
//!
//! **Cost** At most 78 model calls of a linear model ([`CALLS`]): dose calls for plain rounding and error diffusion at eight scales each, the start and the length, and one of each
//! kind for each of up to 30 steps; five pattern fields. It ends earlier where the loss is 0. **Limits** Q comes from the caller and
//! may be a whole machine, with uneven levels and a blur, whose derivative is then left out.

use super::{Counters, Position, Problem};
use serde::Serialize;
use std::ops::Range;
use tomolith_core::dose::PatternLayout;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::Patterns;

/// Full scales that are tried with plain rounding besides the brightest pixel, as shares of it.
const SCALES: [f32; 7] = [0.85, 0.7, 0.55, 0.45, 0.35, 0.25, 0.18];
/// What is taken of the best of them.
const LOWER: f32 = 0.75;
const STEPS: usize = 30;
/// Most dose and adjoint calls of a linear model.
pub const CALLS: [usize; 2] = [2 * SCALES.len() + 4 + STEPS, STEPS];
/// Loss of what a machine of many levels shows, over that of what was asked of it, above which it is lowered. The pixels of example 09, shifted
/// by 0.8 of their width, are at 1.05: lowering that gained 0.001 of IoU.
const WORTH: f64 = 1.15;
/// First length of a step, over the length to the least loss.
const FIRST: f64 = 0.3;
const MOMENTUM: f32 = 0.8;
/// What becomes of the length after a step that lowered the loss, and after one that raised it.
const LONGER: f32 = 1.1;
const SHORTER: f32 = 0.6;

/// What the levels of a machine were improved by.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Gain {
    /// Loss of the patterns before, plainly rounded.
    pub rounded_loss: f64,
    /// Their least loss by error diffusion over neighboring frames, at any of eight full scales; None where rounding costs nothing.
    pub diffused_loss: Option<f64>,
    /// Loss of what is shown now.
    pub loss: f64,
    /// Full scale over the brightest pixel before.
    pub scale: f32,
    /// Steps that were taken.
    pub steps: usize,
    /// Model calls, those for the scale included.
    pub calls: u64,
}

/// The light that a machine shows for given patterns.
pub type ShownDose<'a> = dyn FnMut(&HostField) -> Result<HostField> + 'a;

/// Improves patterns as a machine shows them: what to ask of it, and what that brings. `bits` where it shows few levels, for which full scales and error diffusion
/// are tried as well.
///
/// # Errors
/// [`Error::Canceled`], [`Error::NonFinite`], and those of `shown`.
pub fn improve(
    problem: &mut Problem<HostField>,
    x: &HostField,
    shown: &mut ShownDose<'_>,
    bits: Option<u32>,
) -> Result<(HostField, Gain)> {
    let model = problem.model();
    let mut pass = Pass {
        before: problem.counters,
        brightest: Brightest::of(model.patterns(), x),
        at: Position::new(model.new_dose()?, model.new_dose()?),
        problem,
        shown,
    };
    pass.show(x)?;
    let rounded_loss = pass.at.loss;
    let mut gain = Gain {
        rounded_loss,
        diffused_loss: None,
        loss: rounded_loss,
        scale: 1.0,
        steps: 0,
        calls: 0,
    };
    let mut best = x.clone();
    let is_worth = match bits {
        Some(_) => rounded_loss > 0.0,
        None => {
            pass.problem.measure(x, &mut pass.at)?;
            let wanted = pass.at.loss;
            rounded_loss > WORTH * wanted
        }
    };
    if is_worth {
        let scale = match bits {
            Some(_) => LOWER * pass.scale(x, rounded_loss)?,
            None => 1.0,
        };
        pass.descend(scale, &mut best, &mut gain)?;
        if let Some(bits) = bits {
            pass.diffuse(x, bits, &mut best, &mut gain)?;
        }
    }
    gain.calls = pass.calls();
    Ok((best, gain))
}

/// The work of [`improve`].
struct Pass<'p, 'm, 's, 'c> {
    before: Counters,
    brightest: Brightest,
    at: Position<HostField>,
    problem: &'p mut Problem<'m, HostField>,
    shown: &'s mut ShownDose<'c>,
}

impl Pass<'_, '_, '_, '_> {
    fn calls(&self) -> u64 {
        let [now, before] = [self.problem.counters, self.before].map(|c| c.forward + c.adjoint);
        now - before
    }

    /// Goes to what is shown for these patterns.
    fn show(&mut self, asked: &HostField) -> Result<HostField> {
        let x = (self.shown)(asked)?;
        self.problem.measure(&x, &mut self.at)?;
        Ok(x)
    }

    /// Brings pixels between dark and a share of the brightest, and within their bounds; `any` is a field of pixels.
    fn cut(&self, asked: &mut HostField, scale: f32, any: &HostField) {
        self.brightest.cut(asked, scale);
        asked.move_along(any, 0.0, self.problem.bounds(any));
    }

    /// The scale at which plain rounding has the least loss.
    fn scale(&mut self, x: &HostField, rounded_loss: f64) -> Result<f32> {
        let (mut best, mut least) = (1.0, rounded_loss);
        for scale in SCALES {
            let mut asked = x.clone();
            self.cut(&mut asked, scale, x);
            self.show(&asked)?;
            if self.at.loss < least {
                (best, least) = (scale, self.at.loss);
            }
        }
        Ok(best)
    }

    /// Tries error diffusion at all scales; `best` follows where it has the least loss.
    fn diffuse(
        &mut self,
        x: &HostField,
        bits: u32,
        best: &mut HostField,
        gain: &mut Gain,
    ) -> Result<()> {
        let lights = self.problem.model().patterns();
        for scale in [&[1.0], &SCALES[..]].concat() {
            let mut asked = x.clone();
            self.cut(&mut asked, scale, x);
            for light in lights {
                let patterns = diffused(&light.patterns_of(asked.as_slice()), bits);
                light.fill_field(&patterns, asked.as_mut_slice());
            }
            asked.move_along(x, 0.0, self.problem.bounds(x));
            self.show(&asked)?;
            let loss = self.at.loss;
            gain.diffused_loss = Some(gain.diffused_loss.map_or(loss, |least| least.min(loss)));
            if loss < gain.loss {
                (gain.loss, gain.scale) = (loss, scale);
                best.copy_from(&asked);
            }
        }
        Ok(())
    }

    /// The steps from `best`, which follows.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn descend(&mut self, scale: f32, best: &mut HostField, gain: &mut Gain) -> Result<()> {
        let mut asked = best.clone();
        self.cut(&mut asked, scale, best);
        let mut shown = self.show(&asked)?;
        let (mut gradient, mut velocity) = (best.zeros_like(), best.zeros_like());
        let mut length = None;
        for step in 0..=STEPS {
            let loss = self.at.loss;
            if !loss.is_finite() {
                return Err(Error::NonFinite {
                    what: "the loss of patterns on their levels".to_owned(),
                    value: loss,
                    iteration: step,
                });
            }
            if loss < gain.loss {
                (gain.loss, gain.scale) = (loss, scale);
                best.copy_from(&asked);
            }
            if step == STEPS || loss == 0.0 {
                break;
            }
            self.problem.gradient(&shown, &self.at, &mut gradient)?;
            let t = match length {
                Some(t) => t,
                None => {
                    let mut direction = best.zeros_like();
                    let whole = self.problem.first_length(
                        &shown,
                        &gradient,
                        &mut direction,
                        &mut self.at,
                    )?;
                    (FIRST * whole) as f32
                }
            };
            velocity.scale(MOMENTUM);
            velocity.axpy(1.0, &gradient);
            asked.move_along(&velocity, -t, self.problem.bounds(&velocity));
            self.cut(&mut asked, scale, &velocity);
            shown = self.show(&asked)?;
            length = Some(t * if self.at.loss > loss { SHORTER } else { LONGER });
            gain.steps = step + 1;
        }
        Ok(())
    }
}

/// Patterns on the levels of their brightest pixel: what a pixel's level lacks is added to the same pixel of the next frame. Dark pixels stay dark.
#[must_use]
pub fn diffused(wanted: &Patterns, bits: u32) -> Patterns {
    let full = wanted.values.iter().copied().fold(0.0, f32::max);
    let top = ((1u32 << bits) - 1) as f32;
    let size = wanted.grid.rows * wanted.grid.columns;
    let mut lacking = vec![0.0f32; size];
    let show = |(i, &value): (usize, &f32)| {
        if value == 0.0 {
            return 0.0;
        }
        let lacking = &mut lacking[i % size];
        let wanted = value + *lacking;
        let shown = (wanted / full * top).round().clamp(0.0, top) / top * full;
        *lacking = (wanted - shown).clamp(-full, full);
        shown
    };
    Patterns {
        grid: wanted.grid.clone(),
        values: wanted.values.iter().enumerate().map(show).collect(),
    }
}

/// The brightest pixel of each light, and where the light lies in a field.
struct Brightest(Vec<(Range<usize>, f32)>);

impl Brightest {
    fn of(lights: &[PatternLayout], x: &HostField) -> Self {
        let of_light = |light: &PatternLayout| {
            let range = light.range();
            let largest = x.as_slice()[range.clone()].iter().copied();
            (range, largest.fold(0.0, f32::max))
        };
        Brightest(lights.iter().map(of_light).collect())
    }

    /// Brings pixels between dark and a share of the brightest; the largest one stays there, so that it is the full scale.
    fn cut(&self, x: &mut HostField, scale: f32) {
        for (range, brightest) in &self.0 {
            let (pixels, full) = (&mut x.as_mut_slice()[range.clone()], scale * brightest);
            let mut largest = (0, 0.0);
            for (i, value) in pixels.iter_mut().enumerate() {
                *value = value.clamp(0.0, full);
                if *value > largest.1 {
                    largest = (i, *value);
                }
            }
            if let Some(pixel) = pixels.get_mut(largest.0) {
                *pixel = full;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lbfgs::{self, Lbfgs};
    use crate::reference::Case;
    use crate::{Limits, Outcome, Stop, run};
    use serde_json::json;
    use tomolith_core::check::{self, small::SmallModel};
    use tomolith_core::dose::{DoseModel, Work};
    use tomolith_core::grid::PatternGrid;
    use tomolith_objective::Objective;
    use tomolith_optics::exposure::quantize;

    /// What a projector of so many bits shows.
    fn projector(
        model: &SmallModel,
        bits: u32,
    ) -> impl FnMut(&HostField) -> Result<HostField> + use<'_> {
        move |asked| {
            let layout = &model.patterns()[0];
            let levels = quantize(&layout.patterns_of(asked.as_slice()), bits)?;
            let mut x = asked.zeros_like();
            layout.fill_field(&levels.patterns(), x.as_mut_slice());
            Ok(x)
        }
    }

    /// What the default method makes of even patterns.
    fn solved(problem: &mut Problem<HostField>, case: &Case, stop: &Stop) -> (HostField, Outcome) {
        let mut x = check::even_patterns(&case.model, 0.5);
        let mut lbfgs = Lbfgs::new(lbfgs::Params::default()).unwrap();
        let outcome = run(problem, &mut lbfgs, &mut x, stop, None, &mut []);
        (x, outcome.unwrap())
    }

    /// Patterns of the ring, optimized without levels, and what becomes of them.
    fn improved(case: &Case, bits: u32, limits: Limits) -> (HostField, HostField, Gain) {
        let objective: Box<dyn Objective<HostField>> =
            case.objective("l2", json!({ "void_weight": 5.0 }));
        let flag = Work::new();
        let mut problem = Problem::new(&case.model, &*objective, &[limits], &flag).unwrap();
        let (x, _) = solved(&mut problem, case, &Stop::default());
        let mut shown = projector(&case.model, bits);
        let (asked, gain) = improve(&mut problem, &x, &mut shown, Some(bits)).unwrap();
        let shown = shown(&asked).unwrap();
        // What is claimed is what the model says of what is shown
        let loss = objective.value(&check::dose(&case.model, &shown));
        assert!((loss - gain.loss).abs() <= 1e-6 * loss, "{loss} {gain:?}");
        (asked, shown, gain)
    }

    #[test]
    fn few_levels_lose_less_than_by_rounding_each_pixel_and_no_more_than_by_error_diffusion() {
        let case = Case::of(24, 36);
        for bits in [1, 2, 3] {
            let (asked, shown, gain) = improved(&case, bits, Limits::default());
            assert!(gain.loss <= gain.rounded_loss, "{bits}: {gain:?}");
            assert!(bits > 1 || gain.loss < gain.rounded_loss, "{gain:?}");
            let diffused = gain.diffused_loss.unwrap();
            assert!(gain.loss <= diffused, "{bits}: {gain:?}");
            assert!(bits > 1 || diffused < gain.rounded_loss, "{gain:?}");
            assert!(gain.calls <= (CALLS[0] + CALLS[1]) as u64, "{gain:?}");
            // On the levels of the brightest pixel, which is one of them
            let (top, full) = (((1 << bits) - 1) as f32, asked.max_abs());
            assert_eq!(shown.max_abs(), full);
            for &v in shown.as_slice() {
                let level = v / full * top;
                assert!((level - level.round()).abs() < 1e-4, "{v} of {full}");
            }
            // Shown again, it stays: files of levels give the same light
            let again = projector(&case.model, bits)(&shown).unwrap();
            assert_eq!(again.as_slice(), shown.as_slice());
        }
    }

    #[test]
    fn one_bit_is_the_best_of_all_that_a_small_projector_can_show_at_its_full_scale() {
        let (n, frames) = (5, 3);
        let case = Case::of(n, frames);
        let (asked, _, gain) = improved(&case, 1, Limits::default());
        let objective: Box<dyn Objective<HostField>> =
            case.objective("l2", json!({ "void_weight": 5.0 }));
        let (full, flag) = (asked.max_abs(), Work::new());
        let mut dose = case.model.new_dose().unwrap();
        let mut losses: Vec<f64> = (1u32..1 << (n * frames))
            .map(|lit| {
                let pixel = |i| if lit >> i & 1 == 1 { full } else { 0.0 };
                let shown: Vec<f32> = (0..n * frames).map(pixel).collect();
                case.model
                    .dose(&HostField::from_slice(&shown), &mut dose, &flag)
                    .unwrap();
                objective.value(&dose)
            })
            .collect();
        losses.sort_by(f64::total_cmp);
        let better = losses
            .iter()
            .filter(|&&l| l < gain.loss * (1.0 - 1e-6))
            .count();
        let rounded = losses.iter().filter(|&&l| l < gain.rounded_loss).count();
        // Of 32767 binary patterns none is better; 67 are better than plain rounding
        assert!(better == 0 && rounded > 50, "{better} {rounded} {gain:?}");
    }

    #[test]
    fn what_a_level_lacks_goes_to_the_next_frame() {
        // One pixel of 0.3 in ten frames beside one that is white: at one bit it is white in three of them
        let values = (0..20).map(|i| [0.3, 1.0][i % 2]).collect();
        let grid = PatternGrid::full_turn(10, 0.0, 1, 2, 1.0);
        let shown = diffused(&Patterns { grid, values }, 1);
        let pixel = |i: usize| shown.values.iter().skip(i).step_by(2).copied();
        assert_eq!(pixel(0).sum::<f32>(), 3.0);
        assert!(pixel(0).all(|v| v == 0.0 || v == 1.0));
        assert!(pixel(1).all(|v| v == 1.0));
    }

    #[test]
    fn bounds_hold_for_what_is_asked() {
        let case = Case::of(16, 24);
        // The second has scales at which white is below the darkest that is allowed
        for min in [0.1, 0.35] {
            let limits = Limits { min, max: 0.6 };
            let (asked, _, gain) = improved(&case, 2, limits);
            assert!(gain.loss <= gain.rounded_loss, "{gain:?}");
            let range = min as f32..=0.6;
            assert!(asked.as_slice().iter().all(|v| range.contains(v)));
        }
    }

    #[test]
    fn a_machine_with_levels_and_places_of_its_own_is_descended_as_it_is() {
        // Every other pixel is a third dimmer, and white is what it is
        let case = Case::of(24, 36);
        let objective = case.objective("l2", json!({}));
        let flag = Work::new();
        let mut problem =
            Problem::new(&case.model, &*objective, &[Limits::default()], &flag).unwrap();
        let (x, _) = solved(&mut problem, &case, &Stop::default());
        let mut even = projector(&case.model, 3);
        let mut shown = |asked: &HostField| {
            let mut x = even(asked)?;
            let odd = x.as_mut_slice().iter_mut().skip(1).step_by(2);
            odd.for_each(|v| *v *= 2.0 / 3.0);
            Ok(x)
        };
        let (_, gain) = improve(&mut problem, &x, &mut shown, Some(3)).unwrap();
        assert!(gain.loss < gain.rounded_loss, "{gain:?}");
    }

    #[test]
    fn what_rounding_does_not_hurt_is_left_alone() {
        let case = Case::of(16, 24);
        let objective = case.objective("threshold", json!({}));
        let flag = Work::new();
        let mut problem =
            Problem::new(&case.model, &*objective, &[Limits::default()], &flag).unwrap();
        let (x, outcome) = solved(&mut problem, &case, &Stop::after(500));
        assert_eq!(outcome.loss, 0.0);
        // All it takes is the dose of what is shown; rounding of the loss leaves thresholds a little apart
        let wide = json!({ "lower": 0.75, "upper": 0.85, "ceiling": 1.1 });
        let objective = case.objective("threshold", wide);
        let mut problem =
            Problem::new(&case.model, &*objective, &[Limits::default()], &flag).unwrap();
        let (asked, gain) = improve(&mut problem, &x, &mut |x| Ok(x.clone()), Some(3)).unwrap();
        assert_eq!((gain.calls, gain.steps, gain.scale), (1, 0, 1.0));
        assert_eq!(asked.as_slice(), x.as_slice());
    }
}
