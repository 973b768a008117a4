//! OSMO: object-space model optimization, as published.
//!
//! **Step** a model M of the object is pushed down where void is overdosed and up where part is underdosed; its projection, cut
//! at 0 and divided by the largest dose it gives, is the pattern. N divides by the maximum.
//!
//! ```text
//! g  = Fᵀ M                     x = N-scaled max(g, 0), so that max F(x) = 1
//! void half   M ← M − max(0, F(x) − D_l) in the void
//! part half   M ← M + max(0, D_h − F(x)) in the part
//! ```
//!
//! **Edges** `edges = true` (Chen et al. 2023) ends a step with two more halves that correct voxels at the part's surface alone: those of the
//! part that have a void neighbor by a face are pushed up, those of the void that have a part neighbor down. Only the abstract of that
//! article was at hand: it says that there are two more halves, one for either side of the edge; that their corrections are those of
//! the first two is our reading.
//!
//! The corrections are −½·∂L/∂dose of the objective, its positive and its negative part, so any objective drives the method;
//! [`osmo`](tomolith_objective::osmo), which holds D_h and D_l, makes it the published one. M itself is never needed: g is linear in
//! it and is kept instead (Li et al., eqs. 15–20), negative values included.
//!
//! **Start** g = R Fᵀ T of the target T with the window `filter` of the [ramp](super::filter), as the VAMToolbox family filters T;
//! `none` is M = T, as in the article. The job's `[start]` is only the patterns of row 0 of the history.
//!
//! **Counting** `count = "double"`: a step is both halves, two calls each way, as in the program and in Pellizzon et al.; `"half"`:
//! they alternate, as Li et al. count.
//!
//! **Floor and bits** after each projection g, cut and divided by its largest pixel, is rounded to `bounds.bits` levels on [0, 1],
//! and pixels below `inhibition` become it.
//!
//! **Scale** the patterns returned give the largest counted dose 1, so the objective's thresholds mean what they mean in the
//! article, and the loss is that of the normalized dose. Divide by its mean in the part to compare it with an absolute one.
//! `bounds.min` and `bounds.max` hold at that scale; where they cut, the largest dose is no longer 1 and a forward call is added.
//!
//! **Source** Rackson et al., Additive Manufacturing 48 (2021) 102367; Li et al. (2024), eqs. 11–20; edges: Chen et al., Micromachines
//! 14 (2023) 1362.
//!
//! **Parameters** see [`Params`]. **Limits** linear models; the loss may rise, the iterate with the best print is [kept](super::keep); a dose that is zero
//! everywhere ends the run (thresholds so low that the void half takes all light). **Cost** a forward and an adjoint call for each
//! half, one of each more at the first; three pattern fields, the target, and the marks of edges.

use super::alternating::AlternatingHalf;
use super::filter::{Filter, target_projection};
use super::{
    BuildOptimizer, Checkpoint, MakeOptimizer, Memory, Optimizer, Position, Problem, Requirements,
    Step, read, read_saved_fields, read_saved_numbers, zeros,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::error::Result;
use tomolith_core::field::{Bounds, Field};
use tomolith_core::kind::{Kind, check_ranges, schema_of};

/// What a step is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Count {
    /// Void and part.
    #[default]
    Double,
    /// Void in odd steps, part in even ones.
    Half,
}

tomolith_core::keys! {
    /// The parameters of OSMO.
    pub struct Params {
        /// Window of the ramp that the target is filtered with: "ram_lak", "shepp_logan", "cosine", "hamming", "hann", or
        /// "none" for the target itself
        pub filter: Filter = Filter::RamLak,
        /// What a step is: "double" (void and part) or "half" (in turn)
        pub count: Count = Count::Double,
        /// Whether two more halves correct voxels at the part's surface alone
        pub edges: bool = false,
        /// Smallest pixel as a share of the largest
        #[schemars(range(min = 0.0, max = 1.0))]
        pub inhibition: f64 = 0.0,
    }
}

/// OSMO; see the [module](self).
pub struct Osmo<F> {
    params: Params,
    steps: u64,
    /// Fᵀ M, of either sign, and work space.
    fields: Option<[F; 2]>,
}

/// Which errors a half corrects, and whether those at the part's surface alone.
type Half = (AlternatingHalf, bool);

/// The numbers of a checkpoint: steps done, under the method's name.
#[derive(Deserialize, Serialize)]
struct SavedNumbers {
    osmo: u64,
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildOptimizer<F>> {
    Kind {
        name: "osmo",
        summary: "OSMO as published: corrections in object space, doses relative to the largest (use [objective.osmo])",
        example: "[optimizer.osmo]\nfilter = \"ram_lak\"",
        schema: schema_of::<Params>,
        build: read::<F, Params>,
    }
}

impl<F: Field> MakeOptimizer<F> for Params {
    fn make(&self) -> Result<Box<dyn Optimizer<F>>> {
        Ok(Box::new(Osmo::new(self.clone())?))
    }
}

impl<F: Field> Osmo<F> {
    /// The method with these parameters.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) for an inhibition outside 0 to 1.
    pub fn new(params: Params) -> Result<Self> {
        check_ranges("", &params)?;
        Ok(Osmo {
            params,
            steps: 0,
            fields: None,
        })
    }

    /// The patterns of the model, and their normalized dose.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn show(
        &self,
        [model, scratch]: &mut [F; 2],
        problem: &mut Problem<F>,
        x: &mut F,
        at: &mut Position<F>,
    ) -> Result<()> {
        x.copy_from(model);
        x.clamp(0.0, f32::INFINITY);
        let largest = x.max_abs();
        if largest > 0.0 {
            x.scale(1.0 / largest);
        }
        if let Some(levels) = problem.levels() {
            let shares = x.compile_bounds(&Bounds::uniform(x.len(), 0.0, 1.0));
            x.quantize(levels, &shares);
        }
        x.clamp(self.params.inhibition as f32, f32::INFINITY);
        problem.evaluate_scaled(x, scratch, at).map(drop)
    }

    fn halves(&self) -> Vec<Half> {
        let mut halves = vec![
            (AlternatingHalf::Over, false),
            (AlternatingHalf::Under, false),
        ];
        if self.params.edges {
            halves.extend([
                (AlternatingHalf::Under, true),
                (AlternatingHalf::Over, true),
            ]);
        }
        match self.params.count {
            Count::Double => halves,
            Count::Half => {
                let half = self.steps % halves.len() as u64;
                halves.into_iter().skip(half as usize).take(1).collect()
            }
        }
    }

    /// One half: the correction, projected and added; returns its squared norm.
    fn half(
        &self,
        (half, is_of_edges): Half,
        fields: &mut [F; 2],
        problem: &mut Problem<F>,
        x: &mut F,
        at: &mut Position<F>,
    ) -> Result<f64> {
        half.keep(&mut at.cotangent);
        at.cotangent.scale(-0.5);
        if is_of_edges {
            at.cotangent.multiply(problem.edges()?);
        }
        let square = at.cotangent.dot(&at.cotangent);
        let [model, scratch] = fields;
        problem.project(x, &at.cotangent, scratch)?;
        model.axpy(1.0, scratch);
        self.show(fields, problem, x, at)?;
        Ok(square)
    }
}

impl<F: Field> Optimizer<F> for Osmo<F> {
    fn step(&mut self, problem: &mut Problem<F>, x: &mut F, at: &mut Position<F>) -> Result<Step> {
        let mut fields = match self.fields.take() {
            Some(fields) => fields,
            None => {
                let projection = target_projection(problem, self.params.filter, x)?;
                let mut fields = [projection.patterns, x.zeros_like()];
                self.show(&mut fields, problem, x, at)?;
                fields
            }
        };
        let mut square = 0.0;
        for half in self.halves() {
            square += self.half(half, &mut fields, problem, x, at)?;
        }
        self.steps += 1;
        self.fields = Some(fields);
        Ok(Step {
            // A half without error is no end: the other one may have some
            projected_gradient: square.sqrt().max(f64::MIN_POSITIVE),
            length: 1.0,
        })
    }

    fn requirements(&self) -> Requirements {
        Requirements {
            linear: Some("a correction of the object is projected to the patterns by the adjoint"),
            unpenalized: Some("it corrects the object, where patterns have no price"),
            target: Some("it begins with the target's own projection"),
            edges: self
                .params
                .edges
                .then_some("`edges` corrects the voxels at the part's surface"),
            tolerant: Some(
                "its void half takes away all dose above the void's band, and in the end all light",
            ),
            ..Requirements::of("osmo")
        }
    }

    fn normalizes(&self) -> bool {
        true
    }

    fn memory(&self) -> Memory<'_> {
        let fields = self.fields.as_ref().map(|[model, _]| ("model", model));
        Memory::of(SavedNumbers { osmo: self.steps }, fields.as_slice())
    }

    fn restore(&mut self, memory: &mut Checkpoint, _: &Problem<F>, x: &F) -> Result<()> {
        let SavedNumbers { osmo } = read_saved_numbers(memory)?;
        self.steps = osmo;
        if osmo > 0 {
            let mut fields = zeros(x);
            read_saved_fields(memory, &mut [("model", &mut fields[0])])?;
            self.fields = Some(fields);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::{Case, assert_near, ramp};
    use tomolith_core::field::HostField;

    const D_H: f64 = 0.9;
    const D_L: f64 = 0.6;

    /// N Fᵀ max(0, P M) of eqs. 11 and 13 from a projected model, with floor and levels: patterns and dose.
    fn shown(
        case: &Case,
        projected: &[f64],
        floor: f64,
        levels: Option<f64>,
    ) -> (Vec<f64>, Vec<f64>) {
        let cut: Vec<f64> = projected.iter().map(|g| g.max(0.0)).collect();
        let largest = cut.iter().copied().fold(0.0, f64::max);
        let shown: Vec<f64> = cut
            .iter()
            .map(|g| g / largest)
            .map(|b| levels.map_or(b, |n| (b * (n - 1.0) + 0.5).floor() / (n - 1.0)))
            .map(|b| b.max(floor))
            .collect();
        let dose = case.dense.forward(&shown);
        let counted = dose.iter().zip(case.marked_target());
        let top = counted
            .filter(|(_, t)| *t >= 0.0)
            .fold(0.0, |m: f64, (d, _)| m.max(*d));
        (
            shown.iter().map(|b| b / top).collect(),
            dose.iter().map(|d| d / top).collect(),
        )
    }

    /// The article's iteration with the model in object space, M kept as its part beyond the (filtered) target.
    fn article(case: &Case, filtered: bool, floor: f64, levels: Option<f64>) -> Vec<Vec<f64>> {
        let order = [(0.0, false), (1.0, false)];
        halves(case, filtered, floor, levels, &order)
    }

    /// The article's steps with halves of part (1) or void (0), at edges alone or not.
    fn halves(
        case: &Case,
        filtered: bool,
        floor: f64,
        levels: Option<f64>,
        halves: &[(f64, bool)],
    ) -> Vec<Vec<f64>> {
        let inner = case.without_neighbors_of_the_other_kind();
        let target = case.dense.target();
        let first = case.dense.adjoint(&target);
        let first = if filtered {
            ramp(&first, case.n)
        } else {
            first
        };
        let mut beyond = vec![0.0; target.len()];
        let mut history = Vec::new();
        let marked = case.marked_target();
        for k in 0..9 {
            let change = case.dense.adjoint(&beyond);
            let projected: Vec<f64> = first.iter().zip(&change).map(|(a, b)| a + b).collect();
            let (patterns, dose) = shown(case, &projected, floor, levels);
            history.push(patterns);
            for i in 0..dose.len() {
                let (kind, is_of_edges) = halves[k % halves.len()];
                if marked[i] != kind || is_of_edges && inner[i] {
                    continue;
                }
                if kind > 0.0 {
                    beyond[i] += (D_H - dose[i]).max(0.0);
                } else {
                    beyond[i] -= (dose[i] - D_L).max(0.0);
                }
            }
        }
        history
    }

    fn osmo(params: Params) -> Osmo<HostField> {
        Osmo::new(params).unwrap()
    }

    #[test]
    fn it_follows_the_article_half_by_half_and_step_by_step() {
        let case = Case::new();
        let objective = case.objective("osmo", serde_json::json!({"d_h": D_H, "d_l": D_L}));
        for (filter, filtered) in [(Filter::None, false), (Filter::RamLak, true)] {
            let expected = article(&case, filtered, 0.0, None);
            for (count, halves) in [(Count::Half, 1), (Count::Double, 2)] {
                let params = Params {
                    filter,
                    count,
                    ..Params::default()
                };
                let found = case.run(&*objective, &mut osmo(params), 4, None);
                for step in 1..=4 {
                    let what = format!("{filter:?}, {count:?}, step {step}");
                    let expected = &expected[step * halves];
                    assert_near(&found.patterns[step], expected, 2e-5, &what);
                }
                // Row 0 is the job's start; the method's own costs a call each way
                let counters = found.outcome.counters;
                let calls = 4 * halves as u64;
                assert_eq!((counters.forward, counters.adjoint), (2 + calls, 1 + calls));
            }
        }
    }

    #[test]
    fn edges_are_corrected_by_two_more_halves() {
        let case = Case::new();
        let objective = case.objective("osmo", serde_json::json!({"d_h": D_H, "d_l": D_L}));
        let order = [(0.0, false), (1.0, false), (1.0, true), (0.0, true)];
        let expected = halves(&case, true, 0.0, None, &order);
        for (count, halves) in [(Count::Half, 1), (Count::Double, 4)] {
            let params = Params {
                count,
                edges: true,
                ..Params::default()
            };
            let found = case.run(&*objective, &mut osmo(params), 8 / halves, None);
            for (step, patterns) in found.patterns.iter().enumerate().skip(1) {
                assert_near(patterns, &expected[step * halves], 2e-5, "patterns");
            }
        }
        let plain = article(&case, true, 0.0, None);
        let largest = plain[4].iter().copied().fold(0.0, f64::max);
        let change = plain[4]
            .iter()
            .zip(&expected[4])
            .map(|(a, b)| (a - b).abs());
        assert!(change.fold(0.0, f64::max) > 0.01 * largest);
    }

    #[test]
    fn floor_and_levels_follow_the_program() {
        let case = Case::new();
        let objective = case.objective("osmo", serde_json::json!({"d_h": D_H, "d_l": D_L}));
        let params = Params {
            count: Count::Half,
            inhibition: 0.07,
            ..Params::default()
        };
        let found = case.run(&*objective, &mut osmo(params), 4, Some(6));
        let expected = article(&case, true, 0.07, Some(64.0));
        for (found, expected) in found.patterns.iter().zip(&expected).skip(1) {
            assert_near(found, expected, 2e-5, "patterns");
        }
        assert!(found.patterns.len() > 4 && expected.len() > 4);
    }

    #[test]
    fn a_dose_that_is_zero_everywhere_ends_the_run_and_keeps_the_start() {
        let case = Case::new();
        // The void's correction, a hundredfold, takes all light at once
        let json = serde_json::json!({"d_h": 0.02, "d_l": 0.01});
        let objective = case.weighed_objective("osmo", json, 1000.0);
        let (patterns, _, outcome) =
            case.try_run(&objective, &mut osmo(Params::default()), 4, None);
        let refusal = outcome.unwrap_err().to_string();
        assert!(refusal.contains("zero everywhere"), "{refusal}");
        assert_near(patterns.as_slice(), &case.start(), 1e-6, "the start");
    }
}
