//! What one level of resolution hands to the next: the steps of [`optimize`](super::optimize).
//!
//! A level on the pixels of the one before goes on from its patterns. One on other pixels makes its own start first, which bounds them, and then takes the patterns
//! of the level before, resampled; below a ceiling that a search found it needs no start. The first level takes those of the search for a ceiling where their loss is lower than that of the start.

use super::ceiling::{self, FoundCeiling};
use super::checkpoint::{begin_anew, keep, lost};
use super::stage::{Around, EndOfLevel, SoFar, Stage};
use super::{Optimized, finest, start, warnings_at_end};
use crate::error::{Error, Result};
use crate::field::HostField;
use crate::grid::{PatternGrid, Patterns};
use crate::job::dose::cache::{self, EvaluationModel, RunCache};
use crate::job::dose::doses::Exposed;
use crate::job::progress::{Event, Progress};
use crate::job::resolve::refinement::Level;
use crate::job::resolve::{ResolvedJob, Voxels, at_section};
use crate::models::Work;
use crate::optimize::start::given::Given;
use crate::optimize::{Checkpoints, Limits, Outcome, Row, StopReason};
use std::path::Path;

/// An optimization between two levels.
pub(super) struct Search<'a> {
    job: &'a ResolvedJob,
    voxels: &'a [Voxels],
    checkpoints: Checkpoints,
    is_resumed: bool,
    cache: &'a mut RunCache,
    /// What the model of the last level is cached under.
    key: Option<u64>,
    /// The cached model, until the first level takes it.
    cached: Option<EvaluationModel>,
    ceiling: Option<FoundCeiling>,
    /// The pixels of the start.
    pixels: Option<Vec<&'a PatternGrid>>,
    /// What the start allows them.
    pub(super) highest: Vec<Limits>,
    /// That, below the ceiling.
    bounds: Vec<Limits>,
    /// The patterns of the level before.
    carried: Option<Vec<Patterns>>,
    pub(super) sofar: SoFar,
    progress: &'a mut dyn Progress,
    work: &'a Work,
}

impl<'a> Search<'a> {
    /// Looks for a ceiling of the pixels, where the job asks for one.
    pub(super) fn begin(
        job: &'a ResolvedJob,
        voxels: &'a [Voxels],
        mut checkpoints: Checkpoints,
        resumed: Option<usize>,
        cache: &'a mut RunCache,
        progress: &'a mut dyn Progress,
        work: &'a Work,
    ) -> Result<Self> {
        let key = cache::key(job, &voxels[0])?;
        let cached = cache.take(key);
        let is_resumed = resumed.is_some();
        let ceiling = ceiling::find_once(job, voxels, &mut checkpoints, is_resumed, work)?;
        if let Some(found) = &ceiling {
            let text = found.report.sentence();
            progress.event(&Event::Note { text });
        }
        let coarse = ceiling.as_ref().and_then(|_| job.compares_coarsely());
        if let Some(text) = coarse.clone() {
            progress.event(&Event::Warning { text });
        }
        let sofar = SoFar {
            warnings: coarse.into_iter().collect(),
            ..SoFar::default()
        };
        Ok(Search {
            job,
            voxels,
            checkpoints,
            is_resumed,
            cache,
            key,
            cached,
            ceiling,
            pixels: None,
            highest: Vec::new(),
            bounds: Vec::new(),
            carried: None,
            sofar,
            progress,
            work,
        })
    }

    /// A level with its model; under MPI, this process's share of it.
    pub(super) fn stage<'l>(&mut self, i: usize, share: &'l Level) -> Result<Stage<'l>>
    where
        'a: 'l,
    {
        let (job, cached) = (self.job, self.cached.take());
        let stage = Stage::new(job, self.voxels, share, cached, self.progress, self.work);
        let stage = job.agreed(stage)?.shared();
        if i == 0 {
            let text = stage.reason.clone();
            self.progress.event(&Event::Note { text });
        }
        Ok(stage)
    }

    /// The start of a level and the bounds that follow from it; None on the pixels of the level before, and where a ceiling holds them lower.
    pub(super) fn start(
        &mut self,
        i: usize,
        level: &'a Level,
        stage: &Stage<'_>,
    ) -> Result<Option<HostField>> {
        let pixels: Vec<_> = level.lights.iter().map(|light| &light.pixels).collect();
        if self.pixels.as_ref() == Some(&pixels) {
            return Ok(None);
        }
        let before = self.pixels.replace(pixels.clone());
        match before.filter(|_| self.has_ceiling()) {
            Some(before) => {
                // The ceiling lies far below this bound, so that of the coarser pixels serves
                for ((highest, before), after) in self.highest.iter_mut().zip(before).zip(pixels) {
                    highest.max *= before.frames() as f64 / after.frames() as f64;
                }
                self.bound_below_ceiling(level);
                Ok(None)
            }
            None if i == 0 => self.first(level, stage),
            None => self.first_patterns(level, None, stage).map(Some),
        }
    }

    /// Whether a ceiling holds the pixels below the bound of the start.
    fn has_ceiling(&self) -> bool {
        let is_lower = self.ceiling.as_ref().is_some_and(FoundCeiling::is_lower);
        is_lower && self.job.stop().relative_loss.is_none()
    }

    /// What the search for a ceiling ended with, unless the start has a lower loss; None where a checkpoint has the patterns, and their bounds need no start.
    fn first(&mut self, level: &Level, stage: &Stage<'_>) -> Result<Option<HostField>> {
        let ceiling = self.ceiling.as_ref().filter(|_| self.has_ceiling());
        let known = ceiling.and_then(|found| found.of_start(self.job, level));
        let mut found = None;
        if let Some(known) = &known {
            self.highest.clone_from(known);
            self.bound_below_ceiling(level);
            if self.is_resumed {
                return Ok(None);
            }
            found = self.found(stage)?;
        }
        let ceiling = self.ceiling.as_ref();
        let is_clear = |loss| ceiling.is_some_and(|ceiling| ceiling.is_clearly_better(loss));
        if let Some((x, _)) = found.take_if(|(_, loss)| is_clear(*loss)) {
            self.count_search();
            return Ok(Some(x));
        }
        let x = self.first_patterns(level, known, stage)?;
        if found.is_none() && !self.is_resumed {
            found = self.found(stage)?;
        }
        match found {
            Some((of_search, loss)) if loss < stage.loss(&x, self.work)? => {
                self.count_search();
                Ok(Some(of_search))
            }
            _ => Ok(Some(x)),
        }
    }

    /// The search stands for some of the iterations.
    fn count_search(&mut self) {
        self.sofar.rows = vec![Row::at(self.job.stop().iterations / ceiling::SHARE)];
    }

    /// What the search for a ceiling ended with, within the bounds of this level, and its loss.
    fn found(&mut self, stage: &Stage<'_>) -> Result<Option<(HostField, f64)>> {
        let patterns = self.ceiling.as_mut().and_then(FoundCeiling::take_patterns);
        let Some(patterns) = patterns else {
            return Ok(None);
        };
        let x = stage.within(&self.bounds, patterns, self.work)?;
        let loss = stage.loss(&x, self.work)?;
        Ok(Some((x, loss)))
    }

    /// The bounds of a level below its ceiling.
    fn bound_below_ceiling(&mut self, level: &Level) {
        self.bounds.clone_from(&self.highest);
        if let Some(found) = &self.ceiling {
            found.lower(&mut self.bounds, level);
        }
    }

    /// The start of the job within the bounds that follow from it, unless those are `known`.
    fn first_patterns(
        &mut self,
        level: &Level,
        known: Option<Vec<Limits>>,
        stage: &Stage<'_>,
    ) -> Result<HostField> {
        let given = self.job.own_start(level)?;
        let (brightens, key, work) = (!self.is_resumed, self.key, self.work);
        let first = stage.first_patterns(given.as_ref(), brightens, self.cache, key, work)?;
        self.sofar.first_loss = first.loss;
        self.highest = known.unwrap_or(first.bounds);
        self.bound_below_ceiling(level);
        let mut x = first.patterns;
        if self.ceiling.is_some() {
            start::clip(&mut x, stage.model.patterns(), &self.bounds)?;
        }
        Ok(x)
    }

    /// The patterns that a level begins with.
    pub(super) fn patterns(
        &mut self,
        level: &Level,
        stage: &Stage<'_>,
        start: Option<HostField>,
    ) -> Result<HostField> {
        match (self.carried.take(), start) {
            (None, Some(x)) => Ok(x),
            (None, None) => stage.model.new_patterns(),
            (Some(raw), _) => {
                let given = Given(self.job.own_patterns(level, raw));
                let mut x = stage.start(&given, self.work)?;
                start::clip(&mut x, stage.model.patterns(), &self.bounds)?;
                Ok(x)
            }
        }
    }

    /// The iterations of a level; on the last one, the ceiling is tried after them.
    pub(super) fn run(
        &mut self,
        i: usize,
        level: &Level,
        stage: &Stage<'_>,
        x: &mut HostField,
    ) -> Result<Outcome> {
        let (job, work) = (self.job, self.work);
        self.checkpoints.begin_level(i);
        if let Some(shares) = job.shares(level, stage.model.patterns()) {
            self.checkpoints.share(shares);
        }
        let is_last = i + 1 == job.levels.len();
        let around = Around {
            until: level.until,
            wider: 0,
            change: if is_last { job.steady() } else { 0.0 },
            bounds: &self.bounds,
            checkpoints: Some(&mut self.checkpoints),
            sofar: &mut self.sofar,
            progress: self.progress,
            work,
        };
        let outcome = stage.run_and_widen(x, around)?;
        let is_done = is_last && outcome.reason != StopReason::Canceled;
        let Some(found) = (self.ceiling.as_mut()).filter(|found| is_done && found.is_lower())
        else {
            return Ok(outcome);
        };
        let ended = finest::Ended {
            x,
            bounds: &mut self.bounds,
            highest: &self.highest,
            outcome,
        };
        finest::settle(stage, ended, found, &mut self.sofar, self.progress, work)
    }

    /// Hands the patterns of a level to the next.
    pub(super) fn carry(&mut self, outcome: Outcome, raw: Vec<Patterns>) {
        self.sofar.rows = outcome.history;
        self.sofar.counters = outcome.counters;
        self.carried = Some(raw);
    }

    /// What is done after the last iteration. Of a run that failed or was canceled (None) the best patterns are left in `folder`.
    pub(super) fn end(
        self,
        mut stage: Stage<'_>,
        ran: Result<Option<Outcome>>,
        x: &HostField,
        raw: Vec<Patterns>,
        folder: &Path,
    ) -> Result<Optimized> {
        let (job, work) = (self.job, self.work);
        let ended = match ran {
            // A checkpoint that does not fit: nothing was done
            Err(error @ Error::Format { .. }) => return Err(begin_anew(error)),
            Err(error) => Err(error),
            Ok(None) => Err(Error::Canceled),
            Ok(Some(outcome)) => {
                let end = stage.end(&outcome, x, &raw, &self.bounds, self.progress, work);
                end.map(|end| (outcome, end))
            }
        };
        match ended {
            Ok((outcome, end)) => Ok(self.optimized(stage, raw, outcome, end)),
            Err(error) => {
                match &error {
                    Error::Device { .. } if stage.on_card().is_ok_and(|card| card.is_some()) => {
                        lost(folder, self.progress);
                    }
                    // Refused before the first step
                    Error::Unsupported { what, .. } if what.starts_with("stop.") => {}
                    _ => keep(job, &raw, folder, self.progress, work)?,
                }
                Err(at_section("optimizer", error))
            }
        }
    }

    /// The result, whose warnings are sent. Its model is cached, unless it leaves pixels dark: then it does not give the doses of all patterns.
    fn optimized(
        self,
        stage: Stage<'_>,
        raw: Vec<Patterns>,
        outcome: Outcome,
        end: EndOfLevel,
    ) -> Optimized {
        let exposed = Exposed::new(&stage.level.grid, stage.level.lights.clone());
        let key = self.key.filter(|_| stage.dark.is_empty());
        self.cache.put(key, exposed, &stage.model, &stage.reason);
        let mut warnings = self.sofar.warnings;
        let (window, found) = (end.window.as_ref(), stage.found.as_ref());
        let at_end = warnings_at_end(self.job, &outcome, window, found);
        let of_ceiling = self.ceiling.as_ref();
        let of_ceiling = of_ceiling.and_then(|found| found.report.warning());
        for text in at_end.into_iter().chain(of_ceiling) {
            warnings.push(text.clone());
            self.progress.event(&Event::Warning { text });
        }
        Optimized {
            raw: end.levelled.unwrap_or(raw),
            levels: end.levels,
            levels_s: end.seconds,
            outcome,
            updates: stage.model.updates(),
            model: stage.reason,
            metrics_s: self.sofar.metrics_s,
            window: end.window,
            found: stage.found,
            ceiling: self.ceiling,
            wider: self.sofar.wider,
            warnings,
        }
    }
}
