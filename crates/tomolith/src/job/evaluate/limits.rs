//! What limits a print: the headline number from the optimization's view to the print's, one step after the other.

use super::SpeciesPrint;
use super::around::Around;
use super::doubts::{held_by, of_background};
use crate::exposure::Printer;
use crate::grid::Patterns;
use crate::job::evaluate::{Evaluated, at_best_threshold, headline};
use crate::job::optimize::Optimized;
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::acting::acting_on;
use crate::job::resolve::refinement::moved_pixels;
use crate::job::resolve::row_ends::RowEnds;
use crate::metrics::{Better, Evaluation, Measure, MetricKind};
use crate::report::number::significant;
use crate::report::{Cause, Limit, PrintLimits};
use crate::units::{counted, exact};
use acting::{Arcs, coarsest_pixels};
use lack::Lack;

pub(crate) mod acting;
pub(crate) mod falling;
pub(crate) mod lack;
pub(crate) mod time;

pub use falling::Fall;
use falling::Falling;

/// Bits from which on rounding costs next to nothing: what a machine's patterns lose then is lost between its pixels and the light's.
pub(crate) const ENOUGH_BITS: u32 = 8;
/// Losses below this are not worth a change.
const WORTH_CHANGING: f64 = 0.001;
/// Pixels that a step from frame to frame may be long at the corners of the part's box: with more, streaks are wider than what the pixels resolve.
const WIDE_STEP: f64 = 6.0;
/// Losses below this are not worth other pixels.
const WORTH_PIXELS: f64 = 0.005;
/// What a print lacks where light that misses a part of it is to blame.
const UNLIT: f64 = 0.02;
/// One that fell by more than this share is far from its end, whatever the IoU on the optimizer's voxels did.
const FALLING_FAST: f64 = 0.1;

/// What the patterns of a run or a simulation lose, and where, of every species.
pub(crate) fn limits(
    resolved: &ResolvedJob,
    evaluated: &Evaluated,
    optimized: Option<&Optimized>,
    is_toy: bool,
) -> Vec<PrintLimits> {
    let asked = Asked {
        resolved,
        optimized,
        is_toy,
    };
    let spoiled = evaluated.around.as_ref().map(Around::sentence);
    let prints = evaluated.species.iter().enumerate();
    let limits = |(s, print)| PrintLimits {
        spoiled: spoiled.clone(),
        ..asked.limits(s, print)
    };
    prints.map(limits).collect()
}

/// What is the same for every species of a job.
struct Asked<'a> {
    resolved: &'a ResolvedJob,
    optimized: Option<&'a Optimized>,
    is_toy: bool,
}

impl Asked<'_> {
    fn limits(&self, s: usize, print: &SpeciesPrint) -> PrintLimits {
        let evaluation = &print.evaluation;
        if evaluation.part.is_some_and(|part| part.max == 0.0) {
            let sentence =
                "The patterns leave no dose in the part: nothing of it prints.".to_owned();
            return PrintLimits {
                sentence,
                ..PrintLimits::default()
            };
        }
        let mut limits = self.measurements(s, print).limits();
        let has_time = evaluation.measures.get("print_time_mm").is_some();
        let of_time = self.optimized.filter(|_| s == 0 && has_time);
        let kind = headline(evaluation.half_width.is_some());
        let of_time =
            of_time.and_then(|optimized| time::of_ceiling(self.resolved, optimized, kind));
        limits.causes.extend(of_time);
        limits
    }

    fn measurements(&self, s: usize, print: &SpeciesPrint) -> Measurements {
        let (resolved, evaluated) = (self.resolved, &print.evaluation);
        let (optics, shape) = (&resolved.optics, resolved.species[s].shape.as_ref());
        let kind = headline(evaluated.half_width.is_some());
        let measured = |evaluation: &Evaluation| evaluation.measures.get(kind.name);
        let lights = acting_on(resolved, s);
        let finest = resolved.levels.last();
        let (pixel_key, pixel_light) = coarsest_pixels(&optics.projector_kinds, &lights);
        // Where the job names a threshold, what it costs is a cause of its own
        let at_best = |evaluation| at_best_threshold(resolved, evaluation);
        Measurements {
            kind,
            optimized: (print.optimization.as_ref())
                .and_then(|evaluation| at_best(evaluation).or(measured(evaluation))),
            written: print.written,
            own_turning: print.own_turning,
            turning: measured(evaluated),
            unrounded: print.unrounded,
            pitches_mm: [resolved.grid.pitch_mm, evaluated.grid.pitch_mm],
            bits: resolved.evaluation().bit_depth,
            has_machine: resolved.printers.is_some(),
            by_pixels: self.changes_by_pixels(),
            dark_light: self.dark_light(),
            apart_from_mm: resolved.machine_pixels_apart_mm(),
            has_dim_pixels: resolved.has_dim_pixels(),
            arcs: Arcs::of(&lights),
            saw_finer: finest.is_some_and(|level| {
                level.grid.pitch_mm < resolved.grid.pitch_mm
                    && level.grid.pitch_mm <= evaluated.grid.pitch_mm
            }),
            pixel_key,
            pixel_light,
            is_simulated: self.optimized.is_none(),
            is_toy: self.is_toy,
            has_few_angles: resolved.has_few_angles()
                || (lights.iter())
                    .any(|acting| moved_pixels(acting.light, shape.bounds_mm()) > WIDE_STEP),
            lack: Lack::of(resolved, shape, &print.fine, &lights),
            has_level_heights: (resolved.schedule()).is_some_and(|given| given.level_heights),
            has_no_iterations: (self.optimized).is_some_and(|optimized| {
                optimized
                    .outcome
                    .history
                    .last()
                    .is_none_or(|row| row.iteration == 0)
            }),
            starts_at_zero: (self.optimized).is_some_and(|optimized| {
                let start = optimized.outcome.history.last();
                start.is_some_and(|row| row.iteration == 0 && row.loss == 0.0)
            }),
            has_own_sub_angles: resolved.has_own_sub_angles(),
            held_by: (self.optimized).and_then(|optimized| held_by(resolved, &optimized.raw)),
            has_background: (self.optimized)
                .is_some_and(|optimized| of_background(resolved, &optimized.raw).is_some()),
            best: at_best(evaluated),
            stands: resolved.most_evaluated_angles() == 1 && resolved.optimizes_turning(),
            ends: resolved.row_ends(s, &print.fine.target.inside),
            falling: self.falling(s),
        }
    }

    /// The brightest light of a machine's level 0 that the patterns do not count.
    fn dark_light(&self) -> Option<[f64; 2]> {
        let (printers, raw) = (self.resolved.printers.as_ref()?, &self.optimized?.raw);
        let of_light = |(printer, raw): (&Printer, &Patterns)| {
            let white = raw.values.iter().copied().fold(0.0, f32::max);
            [
                printer.dark_light(),
                printer.dark_light() * f64::from(white),
            ]
        };
        let all = printers.iter().zip(raw).map(of_light).enumerate();
        let brightest = all.max_by(|(_, a), (_, b)| a[1].total_cmp(&b[1]))?;
        let (i, light) = brightest;
        (light[1] > self.resolved.bounds_of(i).0).then_some(light)
    }

    /// Whether a machine of few levels changes patterns by its pixels more than by its levels: at 8 bits by half as much, or more.
    fn changes_by_pixels(&self) -> bool {
        let bits = self.resolved.evaluation().bit_depth;
        let (Some(printers), Some(optimized)) = (&self.resolved.printers, self.optimized) else {
            return false;
        };
        let square_of = |bits: u32, (printer, raw): (&Printer, &Patterns)| {
            let shown = printer.expose(raw, bits).and_then(|f| printer.light_of(&f));
            let pairs = shown.map(|shown| raw.values.clone().into_iter().zip(shown.values));
            let squares = |(raw, shown): (f32, f32)| f64::from(raw - shown).powi(2);
            pairs.map_or(0.0, |pairs| pairs.map(squares).sum())
        };
        let change = |bits| -> f64 {
            let lights = printers.iter().zip(&optimized.raw);
            lights.map(|light| square_of(bits, light)).sum()
        };
        bits < ENOUGH_BITS && 4.0 * change(ENOUGH_BITS) >= change(bits)
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
    /// That number while the vial turns; None where the optimization counted that.
    own_turning: Measure,
    /// On the finer grid, while the vial turns, at the job's threshold; all others are at the best one.
    turning: Measure,
    /// The print that is evaluated, by patterns for few levels as they were optimized.
    unrounded: Measure,
    /// Voxels of the optimization and of the evaluation.
    pitches_mm: [f64; 2],
    bits: u32,
    has_machine: bool,
    /// Whether its pixels change patterns more than its few levels do.
    by_pixels: bool,
    /// What the machine gives at level 0, as a share of white and as a pattern value; None where the patterns count that light, or there is none.
    dark_light: Option<[f64; 2]>,
    /// Width of the machine's pixels, mm, where those of the light are no whole number of them; None where they are, or there is no machine.
    apart_from_mm: Option<f64>,
    /// Whether a machine has pixels that are dead or dimmer than others.
    has_dim_pixels: bool,
    /// Arcs of frames; None for lists of angles.
    arcs: Option<Arcs>,
    /// Whether the optimization's voxels were as fine as the evaluation's: the job's voxels then limit nothing.
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
    /// Why light may leave a part of the part without what it needs.
    lack: Option<Lack>,
    /// Whether rows are scaled so that all heights are done at the same time.
    has_level_heights: bool,
    /// Whether the patterns are those that the optimization would begin with.
    has_no_iterations: bool,
    /// Whether their loss is 0, so that iterations would change nothing.
    starts_at_zero: bool,
    /// Whether the job says at how many angles of a frame the optimization looks.
    has_own_sub_angles: bool,
    /// The key of the upper bound that holds most pixels that shine; None where none does.
    held_by: Option<String>,
    /// Whether the lower bound holds nearly all pixels.
    has_background: bool,
    /// The best number over all thresholds, where the job names one.
    best: Measure,
    /// Whether the evaluation looks at one angle of each frame, and the optimization at several.
    stands: bool,
    /// Horizontal faces inside rows of pixels, in level light.
    ends: Option<RowEnds>,
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
        ]
        .into_iter()
        .chain(self.what_remains())
        .flatten()
        .collect();
        causes.sort_by(|a, b| b.loss.total_cmp(&a.loss));
        // What finer voxels or more angles lose of such a print comes back with the light
        let of_light = causes.iter().position(|limit| limit.cause == Cause::Optics);
        let comes_first = |i: &usize| {
            let is_worth = causes[*i].loss >= WORTH_CHANGING;
            is_worth && self.lacking().is_some_and(|lack| lack.comes_first)
        };
        if let Some(i) = of_light.filter(comes_first) {
            causes[..=i].rotate_right(1);
        }
        // Light is moved for nothing, and what iterations or finer pixels bring of the rest is not known
        let of_rows = causes.iter().position(|limit| limit.cause == Cause::Ends);
        let is_of_rest = |limit: &Limit| matches!(limit.cause, Cause::Iterations | Cause::Optics);
        let is_free = self.light_up().is_some() && self.lacking().is_none();
        if let Some(i) = of_rows.filter(|&i| is_free && causes[..i].iter().all(is_of_rest)) {
            causes[..=i].rotate_right(1);
        }
        PrintLimits {
            sentence: self.sentence(&causes).unwrap_or_default(),
            causes,
            spoiled: None,
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

    /// The print that is evaluated, at the best threshold.
    fn at_best(&self) -> Measure {
        self.best.or(self.turning)
    }

    fn grid(&self) -> Option<Limit> {
        let [coarse, fine] = self.pitches_mm;
        // Of given frames it is not known on which voxels they were optimized
        if self.saw_finer || self.optimized.is_none() || coarse <= 1.001 * fine {
            return None;
        }
        let before = self.own_turning.or(self.written);
        let loss = self.loss(before, self.at_best())?;
        let [coarse, fine] = self.pitches_mm.map(|mm| significant(mm * 1e3, 3));
        let found = format!(
            "On voxels of {fine} µm instead of {coarse} µm the print has {}: the optimizer resolves nothing below a voxel.",
            self.change(before?, self.at_best()?),
        );
        Some(self.limit(Cause::Grid, loss, "grid.pitch_mm", found, "Lower"))
    }

    /// What the patterns have before and after they are written, and where: the job's own voxels, where they are coarser than the optimizer's, do not see all.
    fn writing(&self) -> Option<([f64; 2], &'static str)> {
        if self.saw_finer && self.unrounded.is_some() {
            return Some(([self.unrounded?, self.at_best()?], "the print has {}"));
        }
        let pair = [self.optimized?, self.written?];
        Some((pair, "the patterns have {} on the job's own voxels"))
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
        if self.has_machine && (self.bits >= ENOUGH_BITS || self.by_pixels) {
            if let Some([share, value]) = self.dark_light {
                let [percent, value] = [100.0 * share, value].map(|n| significant(n, 3));
                let found = format!(
                    "{found} At level 0 the machine still gives {percent} % of white, {value} in these patterns, which the optimizer did not count."
                );
                return Some(self.limit(Cause::Levels, loss, "bounds.min", found, "Raise"));
            }
            if let Some(pitch_mm) = self.apart_from_mm {
                let found = format!(
                    "{found} The machine's pixels are {} mm wide, and those of the light no whole number of them.",
                    exact(pitch_mm)
                );
                let action = format!("Set to a multiple of {} mm", exact(pitch_mm));
                return Some(self.limit(Cause::Levels, loss, &self.pixel_key, found, &action));
            }
            if self.has_dim_pixels {
                let found =
                    format!("{found} Pixels of the machine that are dead or dim get no brighter.");
                let action = "Bring the pixels of machine and light together (offset, turn), and the image away from dead or dim pixels, in";
                return Some(self.limit(Cause::Levels, loss, "printer", found, action));
            }
            let action = "Bring the pixels of machine and light together (offset, turn) in";
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
        let loss = self.loss(self.written, self.own_turning)?;
        if self.stands {
            let found = format!(
                "The evaluation looks at one angle of each frame, the optimization at several, which gives {}.",
                self.change(self.written?, self.own_turning?),
            );
            return Some(self.limit(Cause::Turning, loss, "evaluate.sub_angles", found, "Raise"));
        }
        let (by, key) = match &self.arcs {
            Some(arcs) => (format!(" by {}", arcs.text), arcs.key.as_str()),
            None => (String::new(), "light.angles"),
        };
        let key = match self.has_own_sub_angles {
            true => "light.sub_angles",
            false => key,
        };
        let found = format!(
            "The vial turns{by} during each frame, which gives {}.",
            self.change(self.written?, self.own_turning?),
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

    /// What horizontal faces inside rows of pixels cost: light ends with a row, so the part becomes higher or lower there than it should.
    fn row_ends(&self) -> Option<Limit> {
        let ends = self.ends.as_ref();
        let ends = ends.filter(|_| self.kind.better != Better::Lower)?;
        let loss = match (ends.ends, self.loss(Some(self.perfect()), self.at_best())) {
            // Of other parts than prisms it is an estimate
            (None, Some(lost)) => ends.share.min(lost),
            _ => ends.share,
        };
        if loss < WORTH_CHANGING {
            return None;
        }
        let of_light = ends.light.1.as_ref();
        let of_light = of_light.map_or_else(String::new, |name| format!(" of {name}"));
        let faces = match ends.ends {
            Some(heights) => {
                let [[low, high], [below, above]] = heights.map(|z| z.map(|mm| significant(mm, 4)));
                format!(
                    "The part ends at z = {low} and {high} mm, inside rows of pixels{of_light}, but light ends with a row, at {below} and {above} mm."
                )
            }
            None => format!(
                "Horizontal faces of the part lie inside rows of pixels{of_light}, but light ends with a row."
            ),
        };
        let percent = |share: f64| significant(100.0 * share, 1);
        let found = format!(
            "{faces} {} % of the part's volume lies between",
            percent(loss)
        );
        if let Some(up) = self.light_up() {
            let found = format!(
                "{found}, {} % with the light where it fits best.",
                percent(ends.best_move.1)
            );
            let action = format!("Move the light {up} with");
            return Some(self.limit(Cause::Ends, loss, &ends.move_key(), found, &action));
        }
        let action = match ends.ends {
            Some(_) => "Change the part's height or place, or lower",
            None => "Put faces a whole number of rows apart, or lower",
        };
        Some(self.limit(Cause::Ends, loss, &self.pixel_key, found + ".", action))
    }

    /// By how much the light should move along z, where that makes up for what faces inside rows cost.
    fn light_up(&self) -> Option<String> {
        let mm = self.ends.as_ref()?.worthy_move()?;
        let way = if mm > 0.0 { "up" } else { "down" };
        Some(format!("{way} by {} mm", significant(mm.abs(), 2)))
    }

    /// What the patterns leave before they are written: the light's share, and what an optimization that was not at its end may still gain.
    fn what_remains(&self) -> [Option<Limit>; 2] {
        let Some((reach, [lost, of_rest])) = self.reached() else {
            return [None, None];
        };
        let is_lit = !self.has_few_angles && self.lacking().is_none();
        // Half as many iterations more, each quarter of which lowers the loss by the same share
        let share = |fall: Fall| 1.0 - (1.0 - fall.share).powi(2);
        let falling = self.falling.filter(|_| is_lit);
        let iterations = falling.map(|Falling { fall, key }| {
            let found = format!(
                "The loss function still fell by {} % in the last {} of {}: more may recover a part of what the patterns lack.",
                significant(100.0 * fall.share, 2),
                fall.last,
                counted(fall.all, "iteration")
            );
            self.limit(Cause::Iterations, share(fall) * of_rest, key, found, "Raise")
        });
        let of_light = of_rest * falling.map_or(1.0, |falling| 1.0 - share(falling.fall));
        let rest = match of_rest >= WORTH_CHANGING {
            true if self.is_simulated => "; the rest is due to the given patterns.",
            true if self.has_level_heights => {
                "; rows are scaled so that all heights gel at the same time. This dose does not show that, the print in time does."
            }
            true if of_light < 0.5 * of_rest => "; a part of the rest is the limit of this light.",
            true if falling.is_some() => "; most of the rest is the limit of this light.",
            true => "; the rest is the limit of this light.",
            false if lost >= WORTH_CHANGING => ": the other causes take what it lacks.",
            false => ": there is nothing left to improve.",
        };
        let found = reach + rest;
        let optics = if self.is_simulated || self.has_level_heights {
            Limit {
                cause: Cause::Optics,
                measure: self.kind.name,
                loss: of_light,
                key: String::new(),
                advice: found,
            }
        } else {
            let (key, action) = self.more_of_light();
            self.limit(Cause::Optics, of_light, &key, found, &action)
        };
        [iterations, Some(optics)]
    }

    /// What the patterns reach before they are written, in words; what that lacks, and what of it no other cause takes.
    fn reached(&self) -> Option<(String, [f64; 2])> {
        let (reached, reach) = if self.saw_finer {
            let at = self.best.map_or("The", |_| "At its best threshold the");
            let of_print = format!("{at} print has {}", self.value(self.at_best()?));
            (self.at_best(), of_print)
        } else {
            let reach = format!(
                "Before they are written, the patterns reach {} on the job's own voxels",
                self.value(self.optimized?)
            );
            (self.optimized, reach)
        };
        let lost = self.loss(Some(self.perfect()), reached)?;
        // What other causes of the same print take is not the light's. Without finer voxels `reached` is before the patterns are written, on
        // voxels that do not see rows' ends
        let of_print = [self.levels(), self.row_ends(), self.turning()]
            .map(|limit| limit.filter(|limit| self.saw_finer && limit.loss > 0.0));
        let others: f64 = of_print.iter().flatten().map(|limit| limit.loss).sum();
        let rest = if others == 0.0 {
            lost
        } else {
            (lost - others).max(0.0)
        };
        Some((reach, [lost, rest]))
    }

    /// Why light leaves a part of the part without what it needs, where that may be most of what the print lacks.
    fn lacking(&self) -> Option<&Lack> {
        let loss = self.loss(Some(self.perfect()), self.turning)?;
        let lies_there = |lack: &&Lack| lack.share > loss / 2.0;
        (self.lack.as_ref()).filter(|lack| loss > UNLIT && !self.is_simulated && lies_there(lack))
    }

    fn perfect(&self) -> f64 {
        match self.kind.better {
            Better::Lower => 0.0,
            _ => 1.0,
        }
    }

    /// The key that makes light print better, and what to do with it.
    fn more_of_light(&self) -> (String, String) {
        let action = |what: &str| what.to_owned();
        if let Some(lack) = self.lacking() {
            let action = format!("{}: {}", lack.found, lack.verb);
            return (lack.key.clone(), action);
        }
        if self.starts_at_zero {
            let action = action("The loss of the start is 0, so nothing was optimized: change");
            return ("objective".to_owned(), action);
        }
        if self.has_no_iterations {
            let action = action("These are the patterns to begin with: raise");
            return ("stop.iterations".to_owned(), action);
        }
        if let Some(key) = &self.held_by {
            let action = action("Most pixels that shine are at their bound: raise");
            return (key.to_owned(), action);
        }
        if self.has_few_angles {
            let action = action("Light comes from too few sides: raise");
            return ("light.angles".to_owned(), action);
        }
        if self.has_background {
            let action = action("Nearly all pixels are as dark as their bound lets them be: lower");
            return ("bounds.min".to_owned(), action);
        }
        let light = self.pixel_light.as_ref();
        let of_light = light.map_or_else(String::new, |name| format!(" of {name}"));
        let action = format!(
            "Finer pixels{of_light} on the same field (more light.pixels) may bring more: lower"
        );
        (self.pixel_key.clone(), action)
    }

    /// All in one line; None where nothing was measured.
    fn sentence(&self, causes: &[Limit]) -> Option<String> {
        let turning = self.value(self.turning?);
        let seen = self.seen()?;
        let steps: Vec<String> = causes.iter().filter_map(|limit| self.step(limit)).collect();
        let steps = match steps.join(", ") {
            steps if steps.is_empty() => String::new(),
            steps => format!(": {steps}"),
        };
        let improve = self.improvement(causes).unwrap_or_default();
        Some(format!("Predicted {turning}{seen}{steps}.{improve}"))
    }

    /// What was seen before the patterns were written, or on coarser voxels, in parentheses.
    fn seen(&self) -> Option<String> {
        let at = self.best.map_or("", |_| " at the best threshold");
        Some(match (self.optimized, self.is_simulated) {
            _ if self.saw_finer && self.unrounded.is_some() => {
                format!(" (before rounding{at} {:.3})", self.unrounded?)
            }
            (Some(seen), _) if self.saw_finer => {
                let [coarse, fine] = self.pitches_mm;
                let place = match coarse > 1.001 * fine {
                    true => "on the job's own, coarser voxels",
                    false => "before the patterns are written",
                };
                format!(" ({place}{at} {seen:.3})")
            }
            (Some(seen), false) => format!(" (the optimizer saw {seen:.3}{at})"),
            (Some(seen), true) => format!(" (unwritten, on the job's grid{at}: {seen:.3})"),
            (None, _) => String::new(),
        })
    }

    /// What a cause changes; None for what the optimizer saw, and for what explains nothing.
    fn step(&self, limit: &Limit) -> Option<String> {
        let name = match limit.cause {
            Cause::Grid => "finer grid".to_owned(),
            Cause::Levels => {
                format!("{}{}", counted(self.bits as usize, "bit"), self.machine())
            }
            Cause::Turning => "rotation".to_owned(),
            Cause::Ends => "faces within rows of pixels".to_owned(),
            Cause::Exposure => "exposure".to_owned(),
            Cause::Optics | Cause::Iterations | Cause::Time => return None,
        };
        let change = match self.kind.better == Better::Lower {
            true => signed(limit.loss),
            false => signed(-limit.loss),
        };
        // Beside what finer voxels saw, a gain explains nothing
        let counts = !self.saw_finer || limit.loss > 0.0;
        let of_others: f64 = [self.levels(), self.turning()]
            .iter()
            .flatten()
            .map(|limit| limit.loss.max(0.0))
            .sum();
        let lost = self.loss(Some(self.perfect()), self.turning);
        let left = lost.map(|lost| lost - of_others);
        let hidden = match limit.cause == Cause::Ends && Some(limit.loss) > left {
            true => ", which voxels of this size do not show",
            false => "",
        };
        (counts && change != "0").then(|| format!("{name} {change}{hidden}"))
    }

    /// Which key to change; None where the first cause is not worth it.
    fn improvement(&self, causes: &[Limit]) -> Option<String> {
        let limit = causes.first().filter(|limit| self.is_worth(limit))?;
        if self.is_toy {
            return Some(
                " This is a toy of the job: run without `--toy` before you change it.".to_owned(),
            );
        }
        let moving = self
            .light_up()
            .map(|up| format!("move the light {up} with"));
        let verb = match limit.cause {
            Cause::Grid => "lower",
            Cause::Ends if moving.is_some() => moving.as_deref().unwrap_or_default(),
            Cause::Ends => "place the part's faces between rows of pixels, or lower",
            Cause::Exposure => "change",
            Cause::Levels if limit.key == "bounds.min" => "count the light of level 0: raise",
            Cause::Levels if limit.key == self.pixel_key => {
                "set to a multiple of the machine's pixels"
            }
            Cause::Levels if limit.key == "printer" && self.has_dim_pixels => {
                "bring the pixels of machine and light together, and the image away from dead or dim ones, in"
            }
            Cause::Levels if limit.key == "printer" => {
                "bring the pixels of machine and light together in"
            }
            Cause::Optics if limit.key == self.pixel_key => "try a lower",
            Cause::Optics if limit.key == "objective" => "change",
            Cause::Optics if limit.key == "bounds.min" => "lower",
            Cause::Optics => self.lacking().map_or("raise", |lack| lack.verb),
            _ => "raise",
        };
        let anew = match self.is_of_patterns(limit.cause) {
            true => "make the patterns anew: ",
            false => "",
        };
        let light = self.pixel_light.as_ref();
        let light = light.filter(|_| limit.key == self.pixel_key);
        let field = match verb {
            "try a lower" => ", with more light.pixels",
            _ => "",
        };
        let light_name = light.map_or_else(String::new, |name| format!(" ({name})"));
        Some(format!(
            " To improve, {anew}{verb} `{}`{light_name}{field}.",
            limit.key
        ))
    }

    /// Whether a cause costs enough to change its key.
    fn is_worth(&self, limit: &Limit) -> bool {
        let least = match limit.cause == Cause::Optics && limit.key == self.pixel_key {
            true => WORTH_PIXELS,
            false => WORTH_CHANGING,
        };
        // What light leaves of gray values may be left by finer pixels too
        let is_certain = limit.cause != Cause::Optics || self.kind.better != Better::Lower;
        limit.loss >= least && is_certain && !limit.key.is_empty()
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
mod tests;
