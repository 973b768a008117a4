//! What limits a print: the headline number from the optimization's view to the print's, one step after the other.

use super::doubts::of_bound;
use super::evaluate::{Evaluated, headline};
use super::optimize::Optimized;
use super::others::Steps;
use super::refinement::moved_pixels;
use super::scene::{Scene, few_angles};
use crate::metrics::{Better, Evaluation, Measure, MetricKind};
use crate::optics::light::Light;

use crate::report::number::significant;
use crate::report::{Cause, Limit, PrintLimits};
use crate::units::counted;
use acting::{Arcs, Ends, acting_on, coarsest_pixels};

mod acting;
mod falling;

pub use falling::Fall;
use falling::Falling;

/// Bits from which on rounding costs next to nothing: what a machine's patterns lose then is lost between its pixels and the light's.
const ENOUGH_BITS: u32 = 8;
/// Losses below this are not worth a change.
const WORTH_CHANGING: f64 = 0.001;
/// Pixels that a step from frame to frame may be long at the corners of the part's box: with more, streaks are wider than what the pixels resolve.
const WIDE_STEP: f64 = 6.0;
/// One that fell by more than this share is far from its end, whatever the IoU on the optimizer's voxels did.
const FALLING_FAST: f64 = 0.1;

/// What the patterns of a run or a simulation lose, and where, of every species.
pub(crate) fn limits(
    scene: &Scene,
    evaluated: &Evaluated,
    optimized: Option<&Optimized>,
    is_toy: bool,
) -> Vec<PrintLimits> {
    let job = Asked {
        scene,
        optimized,
        is_toy,
    };
    let of = |kind: &MetricKind| {
        let measured = |evaluation: &Evaluation| evaluation.measures.get(kind.name);
        Steps {
            optimized: evaluated.optimization.as_ref().and_then(measured),
            written: evaluated.written,
            standing: measured(&evaluated.standing),
        }
    };
    let first = job.species(
        scene,
        0,
        &evaluated.evaluation,
        of(kind_of(&evaluated.evaluation)),
    );
    let others = scene.others.iter().zip(&evaluated.others).enumerate();
    let others =
        others.map(|(s, (scene, print))| job.species(scene, s + 1, &print.evaluation, print.steps));
    std::iter::once(first).chain(others).collect()
}

fn kind_of(evaluation: &Evaluation) -> &'static MetricKind {
    headline(evaluation.half_width.is_some())
}

/// What is the same for every species of a job.
struct Asked<'a> {
    scene: &'a Scene,
    optimized: Option<&'a Optimized>,
    is_toy: bool,
}

impl Asked<'_> {
    /// Of species `s`, whose scene this is.
    fn species(&self, own: &Scene, s: usize, evaluated: &Evaluation, steps: Steps) -> PrintLimits {
        if evaluated.part.is_some_and(|part| part.max == 0.0) {
            let sentence = "The patterns leave no dose in the part: nothing prints.".to_owned();
            return PrintLimits {
                sentence,
                causes: Vec::new(),
            };
        }
        self.measurements(own, s, evaluated, steps).limits()
    }

    fn measurements(
        &self,
        own: &Scene,
        s: usize,
        evaluated: &Evaluation,
        steps: Steps,
    ) -> Measurements {
        let (scene, spec) = (self.scene, &own.spec);
        let kind = kind_of(evaluated);
        let lights = acting_on(scene, s);
        let finest = scene.levels.last();
        let (pixel_key, pixel_light) = coarsest_pixels(&scene.optics.projector_kinds, &lights);
        let best = evaluated.curve.iter().map(|[_, iou]| *iou);
        Measurements {
            kind,
            optimized: steps.optimized,
            written: steps.written,
            standing: steps.standing,
            turning: evaluated.measures.get(kind.name),
            on_fine: (self.optimized).and_then(Optimized::last_iou).filter(|_| {
                s == 0 && !own.shape.is_gray() && spec.evaluate.bit_depth < ENOUGH_BITS
            }),
            pitches_mm: [scene.grid.pitch_mm, evaluated.grid.pitch_mm],
            bits: spec.evaluate.bit_depth,
            has_machine: spec.printer.is_some(),
            arcs: Arcs::of(&lights),
            is_optimized_turning: finest.is_some_and(|level| {
                let turning = |light: &&Light| light.pixels.frame_arc > 0.0;
                let mut turning = level.lights.iter().filter(turning).peekable();
                turning.peek().is_some() && turning.all(|light| light.sub_angles > 1)
            }),
            saw_finer: finest.is_some_and(|level| {
                level.grid.pitch_mm < scene.grid.pitch_mm
                    && level.grid.pitch_mm <= evaluated.grid.pitch_mm
            }),
            pixel_key,
            pixel_light,
            is_simulated: self.optimized.is_none(),
            is_toy: self.is_toy,
            has_few_angles: few_angles(spec).is_some()
                || (lights.iter())
                    .any(|acting| moved_pixels(acting.light, own.shape.bounds_mm()) > WIDE_STEP),
            is_held: (self.optimized).is_some_and(|own| of_bound(&scene.spec, &own.raw).is_some()),
            best: spec.evaluate.threshold.and(best.reduce(f64::max)),
            ends: own
                .shape
                .upright_mm()
                .filter(|_| !own.shape.is_gray() && own.optics.scene().beyond_slices().is_none())
                .and_then(|z| Ends::worst(z, &lights)),
            falling: self.falling(s),
        }
    }

    /// Whether the loss had not come to rest; of the first species it is known whether that would have brought anything.
    fn falling(&self, s: usize) -> Option<Falling> {
        let optimized = self.optimized?;
        let gain = optimized.gain_in_the_end().filter(|_| s == 0);
        let gains_nothing = gain.is_some_and(|gain| gain < WORTH_CHANGING);
        let history = &optimized.outcome.history;
        let falls_fast = Fall::of(history).is_some_and(|fall| fall.share > FALLING_FAST);
        (falls_fast || !gains_nothing)
            .then(|| Falling::of(optimized.outcome.reason, history))
            .flatten()
    }
}

/// Measurements that the limits of a print follow from.
struct Measurements {
    kind: &'static MetricKind,
    /// Patterns as they were optimized, on the optimization's grid.
    optimized: Measure,
    /// Patterns as they were written, on the same grid.
    written: Measure,
    /// On the finer grid.
    standing: Measure,
    /// While the vial turns.
    turning: Measure,
    /// Patterns for few levels as they were optimized, on the optimizer's own, finer voxels: the IoU that was measured last.
    on_fine: Measure,
    /// Voxels of the optimization and of the evaluation.
    pitches_mm: [f64; 2],
    bits: u32,
    has_machine: bool,
    /// Arcs of frames; None for lists of angles.
    arcs: Option<Arcs>,
    /// Whether the optimization counted the turning already.
    is_optimized_turning: bool,
    /// Whether the optimizer looked at voxels as fine as the evaluation's: the job's own then limit nothing.
    saw_finer: bool,
    /// The key of the pixels' size.
    pixel_key: String,
    /// Whose pixels these are, where there are several lights.
    pixel_light: Option<String>,
    /// Whether the patterns were given: nothing was optimized.
    is_simulated: bool,
    /// Whether the job is a quick trial, whose coarseness limits more than any key.
    is_toy: bool,
    /// Whether light comes from too few sides for any part.
    has_few_angles: bool,
    /// Whether an upper bound holds nearly all pixels that shine.
    is_held: bool,
    /// The best number over all thresholds, where the job names one.
    best: Measure,
    /// Of an upright prism in level light, where its ends are.
    ends: Option<Ends>,
    falling: Option<Falling>,
}

impl Measurements {
    fn limits(&self) -> PrintLimits {
        let mut causes: Vec<Limit> = [
            self.grid(),
            self.levels(),
            self.turning(),
            self.exposure(),
            self.row_ends(),
            self.what_remains(),
        ]
        .into_iter()
        .flatten()
        .collect();
        causes.sort_by(|a, b| b.loss.total_cmp(&a.loss));
        PrintLimits {
            sentence: self.sentence(&causes).unwrap_or_default(),
            causes,
        }
    }

    /// How much worse one number is than another.
    fn loss(&self, from: Measure, to: Measure) -> Option<f64> {
        let fall = from? - to?;
        Some(match self.kind.better {
            Better::Lower => -fall,
            _ => fall,
        })
    }

    /// A cause; `action` says what changes it, unless there is nothing to gain.
    fn limit(&self, cause: Cause, loss: f64, key: &str, found: String, action: &str) -> Limit {
        let action = match loss >= WORTH_CHANGING {
            true if self.is_of_patterns(cause) => {
                format!(
                    " Make the patterns anew: {} `{key}`.",
                    action.to_lowercase()
                )
            }
            true => format!(" {action} `{key}`."),
            false => String::new(),
        };
        Limit {
            cause,
            measure: self.kind.name,
            loss,
            key: key.to_owned(),
            advice: found + &action,
        }
    }

    /// Whether no key changes it while the patterns are given.
    fn is_of_patterns(&self, cause: Cause) -> bool {
        self.is_simulated && cause != Cause::Exposure
    }

    /// "IoU 0.974".
    fn value(&self, value: f64) -> String {
        let name = if self.kind.better == Better::Lower {
            "rms error"
        } else {
            self.kind.title
        };
        format!("{name} {value:.3}")
    }

    /// "IoU 0.974 instead of 1.000", or that it is as before.
    fn change(&self, before: f64, after: f64) -> String {
        let (value, before) = (self.value(after), format!("{before:.3}"));
        if value.ends_with(&before) {
            format!("{value} as before")
        } else {
            format!("{value} instead of {before}")
        }
    }

    fn grid(&self) -> Option<Limit> {
        if self.saw_finer {
            return None;
        }
        // An optimization that counts the turning is compared with a print that turns
        let to = if self.is_optimized_turning {
            self.turning
        } else {
            self.standing
        };
        let loss = self.loss(self.written, to)?;
        let [own, fine] = self.pitches_mm.map(|mm| significant(mm * 1e3, 3));
        let found = format!(
            "On voxels of {fine} µm instead of {own} µm the print has {}: the optimizer resolves nothing below a voxel.",
            self.change(self.written?, to?),
        );
        Some(self.limit(Cause::Grid, loss, "grid.pitch_mm", found, "Lower"))
    }

    /// What the patterns have before and after they are written, and where: the job's own voxels, where they are coarser than the optimizer's, do not see all.
    fn writing(&self) -> Option<([f64; 2], &'static str)> {
        let Some(seen) = self.on_fine.filter(|_| self.saw_finer) else {
            let own = [self.optimized?, self.written?];
            return Some((own, "the patterns have {} on the job's own voxels"));
        };
        let print = match self.is_optimized_turning {
            true => self.best.or(self.turning),
            false => self.standing,
        };
        // Slices that rows of pixels beside the part light are not on these voxels
        let of_ends = self.row_ends().map_or(0.0, |limit| limit.loss);
        Some(([seen - of_ends, print?], "the print has {}"))
    }

    fn levels(&self) -> Option<Limit> {
        // Voxels that see little of the print do not see what is next to nothing
        if self.saw_finer && self.bits >= ENOUGH_BITS && !self.has_machine {
            return None;
        }
        let ([before, after], what) = self.writing()?;
        let loss = self.loss(Some(before), Some(after))?;
        let (bits, machine) = (counted(self.bits as usize, "bit"), self.machine());
        let what = what.replace("{}", &self.change(before, after));
        let found = format!("Written with {bits}{machine} {what}.");
        if self.has_machine && self.bits >= ENOUGH_BITS {
            let action = "Bring the pixels of machine and light together (pitch, offset, turn) in";
            return Some(self.limit(Cause::Levels, loss, "printer", found, action));
        }
        Some(self.limit(Cause::Levels, loss, "evaluate.bit_depth", found, "Raise"))
    }

    fn machine(&self) -> &'static str {
        if self.has_machine {
            " on the machine's pixels"
        } else {
            ""
        }
    }

    fn turning(&self) -> Option<Limit> {
        if self.is_optimized_turning {
            return None;
        }
        let loss = self.loss(self.standing, self.turning)?;
        let (by, key) = match &self.arcs {
            Some(arcs) => (format!(" by {}", arcs.said), arcs.key.as_str()),
            None => (String::new(), "light.angles"),
        };
        let found = format!(
            "The vial turns{by} during each frame, which gives {}.",
            self.change(self.standing?, self.turning?),
        );
        Some(self.limit(Cause::Turning, loss, key, found, "Raise"))
    }

    /// What the threshold that the job names costs.
    fn exposure(&self) -> Option<Limit> {
        let loss = self.loss(self.best, self.turning)?;
        let found = format!(
            "At the threshold of the job the print has {}.",
            self.change(self.best?, self.turning?)
        );
        let key = "evaluate.threshold";
        (loss >= WORTH_CHANGING)
            .then(|| self.limit(Cause::Exposure, loss, key, found, "Leave out, or change,"))
    }

    /// What flat ends within rows of pixels cost: light ends with a row, so a prism becomes higher or lower than it should.
    fn row_ends(&self) -> Option<Limit> {
        let ends = self.ends.as_ref();
        let ends = ends.filter(|_| self.kind.better != Better::Lower)?;
        let loss = ends.share();
        let [[low, high], [below, above]] =
            [ends.part_mm, ends.rows_mm].map(|z| z.map(|mm| significant(mm, 4)));
        let of = ends.light.as_ref();
        let of = of.map_or_else(String::new, |name| format!(" of {name}"));
        let found = format!(
            "The part ends at z = {low} and {high} mm, inside rows of pixels{of}, but light ends with a row, at {below} and {above} mm. {} % of the part's volume lies between.",
            significant(100.0 * loss, 1)
        );
        let action = "Change the part's height or place, or lower";
        (loss >= WORTH_CHANGING)
            .then(|| self.limit(Cause::Ends, loss, &self.pixel_key, found, action))
    }

    /// What the patterns leave before they are written: the light's share, or that of an optimization that was not at its end.
    fn what_remains(&self) -> Option<Limit> {
        let perfect = match self.kind.better {
            Better::Lower => 0.0,
            _ => 1.0,
        };
        let (reached, reach) = if self.saw_finer {
            let of_print = format!("The print has {}", self.value(self.turning?));
            (self.turning, of_print)
        } else {
            let reach = format!(
                "Before they are written, the patterns reach {} on the job's own voxels",
                self.value(self.optimized?)
            );
            (self.optimized, reach)
        };
        let loss = self.loss(Some(perfect), reached)?;
        // What other causes of the same print take is not the light's. Without finer voxels `reached` is before the patterns are written, on
        // voxels that do not see rows' ends
        let of_print =
            [self.levels(), self.row_ends()].map(|limit| limit.filter(|_| self.saw_finer));
        let exposure = self.exposure();
        let others = of_print.iter().chain([&exposure]).flatten();
        let others: f64 = others.map(|limit| limit.loss).sum();
        let loss = if others == 0.0 {
            loss
        } else {
            (loss - others).max(0.0)
        };
        let Some(Falling { fall, key }) = self.falling.filter(|_| !self.has_few_angles) else {
            let rest = match loss >= WORTH_CHANGING {
                true if self.is_simulated => "; the rest is due to the given patterns.",
                true => "; the rest is the limit of this light.",
                false => ": there is nothing left to improve.",
            };
            let found = reach + rest;
            if self.is_simulated {
                return Some(Limit {
                    cause: Cause::Optics,
                    measure: self.kind.name,
                    loss,
                    key: String::new(),
                    advice: found,
                });
            }
            if self.has_few_angles {
                let action = "Light comes from too few sides: raise";
                return Some(self.limit(Cause::Optics, loss, "light.angles", found, action));
            }
            if self.is_held {
                let action = "Nearly all pixels that shine are at their bound: raise";
                return Some(self.limit(Cause::Optics, loss, "bounds.max", found, action));
            }
            let of = self.pixel_light.as_ref();
            let of = of.map_or_else(String::new, |name| format!(" of {name}"));
            let action = format!("Finer pixels{of} may bring more: lower");
            return Some(self.limit(Cause::Optics, loss, &self.pixel_key, found, &action));
        };
        let found = format!(
            "{reach}, and the loss function still fell by {} % in the last {} of {} iterations: more of them mend a part of what is missing, the rest is the limit of this light.",
            significant(100.0 * fall.share, 2),
            fall.last,
            fall.all
        );
        Some(self.limit(Cause::Iterations, loss, key, found, "Raise"))
    }

    /// All in one line; None where nothing was measured.
    fn sentence(&self, causes: &[Limit]) -> Option<String> {
        let seen = match (self.optimized, self.is_simulated) {
            _ if self.saw_finer && self.on_fine.is_some() => {
                format!(" (the optimizer saw {:.3})", self.on_fine?)
            }
            (Some(seen), _) if self.saw_finer => {
                let [own, fine] = self.pitches_mm;
                let place = match own > 1.001 * fine {
                    true => "on the job's own, coarser voxels",
                    false => "before the patterns are written",
                };
                format!(" ({place} {seen:.3})")
            }
            (Some(seen), false) => format!(" (the optimizer saw {seen:.3})"),
            (Some(seen), true) => format!(" (unwritten, on the job's grid: {seen:.3})"),
            (None, _) => String::new(),
        };
        let step = |limit: &Limit| {
            let name = match limit.cause {
                Cause::Grid => "finer grid".to_owned(),
                Cause::Levels => {
                    format!("{}{}", counted(self.bits as usize, "bit"), self.machine())
                }
                Cause::Turning => "rotation".to_owned(),
                Cause::Ends => "ends within rows of pixels".to_owned(),
                Cause::Exposure => "exposure".to_owned(),
                // What the optimizer saw says it
                Cause::Optics | Cause::Iterations => return None,
            };
            let change = if self.kind.better == Better::Lower {
                limit.loss
            } else {
                -limit.loss
            };
            let change = signed(change);
            // Beside what finer voxels saw, a gain explains nothing
            let counts = !self.saw_finer || limit.loss > 0.0;
            (counts && change != "0").then(|| format!("{name} {change}"))
        };
        let steps: Vec<String> = causes.iter().filter_map(step).collect();
        // What light leaves of gray values may be left by finer pixels too
        let is_certain =
            |limit: &Limit| limit.cause != Cause::Optics || self.kind.better != Better::Lower;
        let worth = |limit: &&Limit| {
            limit.loss >= WORTH_CHANGING && is_certain(limit) && !limit.key.is_empty()
        };
        let improve = causes.first().filter(worth);
        let improve = improve.map_or_else(String::new, |limit| {
            if self.is_toy {
                return " This is a toy of the job: run without `--toy` before you change it."
                    .to_owned();
            }
            let verb = match limit.cause {
                Cause::Grid => "lower",
                Cause::Optics if limit.key == self.pixel_key => "try a lower",
                Cause::Ends => "place the part's ends between rows of pixels, or lower",
                Cause::Exposure => "change",
                Cause::Levels if limit.key == "printer" => {
                    "bring the pixels of machine and light together in"
                }
                _ => "raise",
            };
            let anew = match self.is_of_patterns(limit.cause) {
                true => "make the patterns anew: ",
                false => "",
            };
            let of = self.pixel_light.as_ref();
            let of = of.filter(|_| limit.key == self.pixel_key);
            let of = of.map_or_else(String::new, |name| format!(" ({name})"));
            format!(" To improve, {anew}{verb} `{}`{of}.", limit.key)
        });
        let turning = self.value(self.turning?);
        let steps = match steps.join(", ") {
            steps if steps.is_empty() => String::new(),
            steps => format!(": {steps}"),
        };
        Some(format!("Predicted {turning}{seen}{steps}.{improve}"))
    }
}

/// Three decimals and a sign, or 0.
fn signed(value: f64) -> String {
    let text = format!("{value:+.3}").replace('-', "−");
    if text.ends_with("0.000") {
        "0".to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::acting::Acting;
    use super::*;
    use crate::grid::PatternGrid;
    use crate::metrics::{gray, iou};
    use crate::optimize::{Row, StopReason};

    /// The numbers of the first example.
    fn measurements() -> Measurements {
        Measurements {
            kind: &iou::KIND,
            optimized: Some(1.0),
            written: Some(1.0),
            standing: Some(0.9736),
            turning: Some(0.975),
            on_fine: None,
            pitches_mm: [0.056, 0.028],
            bits: 8,
            has_machine: false,
            arcs: Some(Arcs {
                said: "2°".to_owned(),
                key: "light.angles".to_owned(),
            }),
            is_optimized_turning: false,
            saw_finer: false,
            pixel_key: "light[0].projector.collimated.pixel_pitch_mm".to_owned(),
            pixel_light: None,
            is_simulated: false,
            is_toy: false,
            has_few_angles: false,
            is_held: false,
            best: None,
            ends: None,
            falling: None,
        }
    }

    fn losses(limits: &PrintLimits) -> Vec<(Cause, f64)> {
        let losses = limits.causes.iter();
        losses
            .map(|l| (l.cause, (l.loss * 1e4).round() / 1e4))
            .collect()
    }

    #[test]
    fn rounding_is_told_from_the_voxels_that_see_it() {
        // Two bits: the job's own voxels see nothing of it, the optimizer's do
        let limits = Measurements {
            optimized: Some(0.990),
            written: Some(0.990),
            on_fine: Some(0.997),
            turning: Some(0.987),
            bits: 2,
            is_optimized_turning: true,
            saw_finer: true,
            ..measurements()
        };
        let limits = limits.limits();
        assert_eq!(
            limits.sentence,
            "Predicted IoU 0.987 (the optimizer saw 0.997): 2 bits −0.010. To improve, raise `evaluate.bit_depth`."
        );
        let losses = losses(&limits);
        assert_eq!(losses, [(Cause::Levels, 0.01), (Cause::Optics, 0.003)]);
        assert!(
            limits.causes[0]
                .advice
                .starts_with("Written with 2 bits the print has IoU 0.987 instead of 0.997."),
            "{}",
            limits.causes[0].advice
        );
    }

    #[test]
    fn the_largest_loss_comes_first_and_names_the_key() {
        let limits = measurements().limits();
        assert_eq!(
            limits.sentence,
            "Predicted IoU 0.975 (the optimizer saw 1.000): finer grid −0.026, rotation +0.001. To improve, lower `grid.pitch_mm`."
        );
        assert_eq!(
            losses(&limits),
            [
                (Cause::Grid, 0.0264),
                (Cause::Levels, 0.0),
                (Cause::Optics, 0.0),
                (Cause::Turning, -0.0014)
            ]
        );
        assert_eq!(
            limits.causes[0].advice,
            "On voxels of 28 µm instead of 56 µm the print has IoU 0.974 instead of 1.000: the optimizer resolves nothing below a voxel. \
             Lower `grid.pitch_mm`."
        );
        let toy = Measurements {
            is_toy: true,
            ..measurements()
        };
        let said = toy.limits().sentence;
        assert!(
            said.ends_with(
                "rotation +0.001. This is a toy of the job: run without `--toy` before you change it."
            ),
            "{said}"
        );
        // Nothing to gain, nothing to change
        let advice = |i: usize| limits.causes[i].advice.as_str();
        assert_eq!(
            advice(1),
            "Written with 8 bits the patterns have IoU 1.000 as before on the job's own voxels."
        );
        assert!(advice(2).ends_with("voxels: there is nothing left to improve."));
        assert_eq!(
            advice(3),
            "The vial turns by 2° during each frame, which gives IoU 0.975 instead of 0.974."
        );
    }

    #[test]
    fn voxels_are_called_coarser_only_where_they_are() {
        let said = |pitches_mm| {
            let measured = Measurements {
                saw_finer: true,
                pitches_mm,
                ..measurements()
            };
            measured.limits().sentence
        };
        assert!(said([0.056, 0.014]).contains("(on the job's own, coarser voxels 1.000)"));
        assert!(said([0.056, 0.056]).contains("(before the patterns are written 1.000)"));
    }

    #[test]
    fn the_losses_of_a_run_add_up_to_what_is_missing() {
        let measured = Measurements {
            optimized: Some(0.95),
            written: Some(0.94),
            ..measurements()
        };
        let limits = measured.limits();
        let sum: f64 = limits.causes.iter().map(|l| l.loss).sum();
        assert!((1.0 - sum - 0.975).abs() < 1e-12);
        assert_eq!(limits.causes[0].cause, Cause::Optics);
        assert!(
            limits.sentence.ends_with(
                "To improve, try a lower `light[0].projector.collimated.pixel_pitch_mm`."
            )
        );
    }

    #[test]
    fn what_remains_belongs_to_the_iterations_while_the_loss_falls() {
        let row = |iteration: usize, loss: f64| Row {
            response: Vec::new(),
            print: None,
            iteration,
            loss,
            projected_gradient: None,
            step: None,
            forward: 0,
            adjoint: 0,
            seconds: 0.0,
        };
        let history = |end: f64| -> Vec<Row> {
            let mut rows: Vec<Row> = (0..=30).map(|i| row(i, 100.0)).collect();
            rows.extend((31..=40).map(|i| row(i, end)));
            rows
        };
        let falling = Falling::of(StopReason::Iterations, &history(80.0)).unwrap();
        assert_eq!(
            (falling.fall.last, falling.fall.all, falling.key),
            (10, 40, "stop.iterations")
        );
        assert!((falling.fall.share - 0.2).abs() < 1e-12);
        assert_eq!(Falling::of(StopReason::Iterations, &history(99.5)), None);
        assert_eq!(Falling::of(StopReason::Steady, &history(80.0)), None);
        assert_eq!(Falling::of(StopReason::Iterations, &[]), None);
        let said = |end| Fall::of(&history(end)).map(|fall| fall.to_string());
        assert_eq!(
            said(80.0).as_deref(),
            Some("not converged: the loss fell by 20 % in the last 10 iterations")
        );
        assert_eq!(
            said(99.5).as_deref(),
            Some("converged: the loss fell by 0.5 % in the last 10 iterations")
        );
        assert_eq!(said(101.0), None);
        assert_eq!(Fall::of(&history(80.0)[..1]), None);
        let limits = Measurements {
            optimized: Some(0.9),
            written: Some(0.9),
            standing: Some(0.9),
            turning: Some(0.9),
            falling: Some(falling),
            ..measurements()
        }
        .limits();
        assert_eq!(
            limits.causes[0].advice,
            "Before they are written, the patterns reach IoU 0.900 on the job's own voxels, and the loss function still fell by 20 % in the \
             last 10 of 40 iterations: more of them mend a part of what is missing, the rest is the limit of this light. Raise `stop.iterations`."
        );
        assert!(limits.causes.iter().all(|l| l.cause != Cause::Optics));
    }

    #[test]
    fn flat_ends_within_rows_are_what_limits_a_prism() {
        // Rows of 56 µm with an edge at 0: a gear 3 mm high reaches 26.786 of them to each side
        let rows = PatternGrid::full_turn(180, 0.0, 64, 176, 0.056);
        let ends = Ends::of([-1.5, 1.5], &rows, None);
        assert!((ends.share() - 2.0 * (27.0 * 0.056 - 1.5) / 3.0).abs() < 1e-12);
        let gear = Measurements {
            optimized: Some(0.995),
            written: Some(0.995),
            turning: Some(0.985),
            is_optimized_turning: true,
            saw_finer: true,
            ends: Some(ends),
            ..measurements()
        };
        let limits = gear.limits();
        assert_eq!(losses(&limits)[0], (Cause::Ends, 0.008));
        assert!(limits.causes[0].advice.starts_with(
            "The part ends at z = −1.5 and 1.5 mm, inside rows of pixels, but light ends with a row, at −1.512 and 1.512 mm. 0.8 % of the part's volume lies between."
        ), "{}", limits.causes[0].advice);
        // The light's share is what is left
        assert!(
            (limits.causes[1].loss - 0.007).abs() < 1e-9 && limits.causes[1].cause == Cause::Optics
        );
        let fits = Ends::of([-1.512, 1.512], &rows, None);
        let gear = Measurements {
            ends: Some(fits),
            ..gear
        };
        assert!(gear.limits().causes.iter().all(|l| l.cause != Cause::Ends));
    }

    #[test]
    fn of_several_lights_the_one_that_limits_is_named() {
        use crate::optics::resin::Resin;
        let light = |frames, pitch| {
            let pixels = PatternGrid::full_turn(frames, 0.0, 4, 8, pitch);
            Light::new(pixels, Resin::absorbing(1.5, 0.1))
        };
        let lights = [light(120, 0.05), light(180, 0.1)];
        let acting = |index: usize, name| Acting {
            index,
            name,
            light: &lights[index],
        };
        let both = [acting(0, Some("violet")), acting(1, Some("uv"))];
        let arcs = Arcs::of(&both).unwrap();
        assert_eq!(arcs.said, "3° (violet) and 2° (uv)");
        assert_eq!(arcs.key, "light[0].angles");
        let one = Arcs::of(&[acting(0, None)]).unwrap();
        assert_eq!((&one.said[..], &one.key[..]), ("3°", "light.angles"));
        let rows = &lights[1].pixels;
        let measured = Measurements {
            optimized: Some(0.9),
            written: Some(0.9),
            standing: Some(0.9),
            turning: Some(0.88),
            arcs: Some(arcs),
            pixel_key: "light[1].projector.collimated.pixel_pitch_mm".to_owned(),
            pixel_light: Some("uv".to_owned()),
            ends: Some(Ends::of([-0.15, 0.2], rows, Some("uv"))),
            ..measurements()
        };
        let limits = measured.limits();
        let said: String = limits
            .causes
            .iter()
            .map(|l| l.advice.clone() + "\n")
            .collect();
        for text in [
            "The vial turns by 3° (violet) and 2° (uv) during each frame",
            "Raise `light[0].angles`",
            "Finer pixels of uv may bring more",
            "inside rows of pixels of uv, but",
        ] {
            assert!(said.contains(text), "{said}");
        }
        let sentence = &limits.sentence;
        assert!(sentence.ends_with("pixel_pitch_mm` (uv)."), "{sentence}");
    }

    #[test]
    fn a_threshold_that_is_far_off_and_too_few_sides_are_named() {
        let off = Measurements {
            turning: Some(0.0),
            best: Some(0.98),
            saw_finer: true,
            is_optimized_turning: true,
            ..measurements()
        };
        assert!(
            off.limits()
                .sentence
                .ends_with("exposure −0.980. To improve, change `evaluate.threshold`."),
            "{}",
            off.limits().sentence
        );
        let few = Measurements {
            turning: Some(0.5),
            saw_finer: true,
            is_optimized_turning: true,
            has_few_angles: true,
            ..measurements()
        };
        assert!(
            few.limits()
                .sentence
                .ends_with("To improve, raise `light.angles`.")
        );
        let held = Measurements {
            has_few_angles: false,
            is_held: true,
            ..few
        };
        assert!(
            held.limits()
                .sentence
                .ends_with("To improve, raise `bounds.max`.")
        );
        // What was given is not improved by a key of the job
        let given = Measurements {
            turning: Some(0.5),
            standing: Some(0.5),
            written: Some(0.5),
            optimized: Some(0.5),
            is_simulated: true,
            ..measurements()
        };
        assert!(
            !given.limits().sentence.contains("To improve"),
            "{}",
            given.limits().sentence
        );
    }

    #[test]
    fn what_was_not_measured_is_not_said() {
        // A simulation of patterns optimizes nothing
        let patterns = Measurements {
            is_simulated: true,
            ..measurements()
        };
        let said = patterns.limits().sentence;
        assert!(
            said.starts_with("Predicted IoU 0.975 (unwritten, on the job's grid: 1.000): "),
            "{said}"
        );
        assert!(
            said.ends_with("To improve, make the patterns anew: lower `grid.pitch_mm`."),
            "{said}"
        );
        // Of frames it is not known what was wanted
        let frames = Measurements {
            is_simulated: true,
            optimized: None,
            written: None,
            ..measurements()
        };
        assert_eq!(losses(&frames.limits()), [(Cause::Turning, -0.0014)]);
        assert_eq!(
            frames.limits().sentence,
            "Predicted IoU 0.975: rotation +0.001."
        );
        // An optimization that averages its frames over their arcs
        let turning = Measurements {
            is_optimized_turning: true,
            ..measurements()
        };
        assert_eq!(losses(&turning.limits())[0], (Cause::Grid, 0.025));
        let empty = Measurements {
            optimized: Some(0.0),
            written: None,
            standing: None,
            turning: None,
            ..measurements()
        };
        assert_eq!(empty.limits().sentence, "");
    }

    #[test]
    fn the_error_of_a_gray_print_rises_where_an_iou_falls() {
        let limits = Measurements {
            kind: &gray::RMS,
            optimized: Some(0.126),
            written: Some(0.13),
            standing: Some(0.128),
            turning: Some(0.128),
            ..measurements()
        }
        .limits();
        assert!(limits.sentence.starts_with(
            "Predicted rms error 0.128 (the optimizer saw 0.126): 8 bits +0.004, finer grid −0.002."
        ), "{}", limits.sentence);
        assert_eq!(
            losses(&limits)[..2],
            [(Cause::Optics, 0.126), (Cause::Levels, 0.004)]
        );
    }
}
