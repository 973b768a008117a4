//! One job on several processes (ranks), each with a share of the frames of every light.
//!
//! Every rank reads the job and samples the target. In the optimization patterns, gradients and the method's vectors are shares; doses are summed over
//! ranks ([`Sharded`](crate::models::sharded::Sharded)) and whole on each, as is the objective. Rank 0 alone speaks, writes checkpoints and
//! the run folder, and evaluates the written patterns.
//!
//! **Limits** models whose dose is a sum over frames that are computed alike wherever they are: no Monte Carlo paths, no stored matrix. No
//! print optimized in time, no dose that diffuses, no patterns improved on few levels; no penalty between frames and no `min_contribution`, which compares the pixels of
//! all frames. At least as many frames of every light as ranks.
//!
//! **Memory** doses, the target and what belongs to voxels are on every rank; what belongs to pixels is shared. Checkpoints and the end of a
//! level need the whole patterns once, on rank 0.

use crate::error::{Error, Result};
use crate::grid::Patterns;
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::identity::hash;
use crate::job::resolve::refinement::Level;
use crate::models::PatternLayout;
use crate::models::parallel::kernel::Isa;
use crate::optics::light::Light;
use crate::optimize::start::given::{Given, resample};
use crate::ranks::{Shares, frames_of_rank, together};
use std::borrow::Cow;
use std::sync::Arc;

fn with_frames(light: &Light, frames: &[usize]) -> Light {
    let mut part = light.clone();
    let all = &light.pixels.azimuths;
    part.pixels.azimuths = frames.iter().map(|&frame| all[frame]).collect();
    part.selection = light.selection.mapped(|mask| match mask.is_still() {
        true => mask.clone(),
        false => mask.of_frames(frames),
    });
    part
}

impl ResolvedJob {
    /// What this process came to, if no rank failed.
    pub(crate) fn agreed<T>(&self, result: Result<T>) -> Result<T> {
        match &self.ranks {
            Some(ranks) => together(ranks.as_ref(), result),
            None => result,
        }
    }

    /// Whether this process speaks and writes.
    pub(crate) fn is_first(&self) -> bool {
        self.ranks.as_ref().is_none_or(|ranks| ranks.is_first())
    }

    /// Refuses ranks that read another job or other files, planned otherwise with the memory they have, would stop at another iteration, or compute
    /// with other instructions, whose sums differ.
    pub(crate) fn must_agree(&self, fingerprint: u64) -> Result<()> {
        let Some(ranks) = &self.ranks else {
            return Ok(());
        };
        let isa = Isa::in_use().name();
        let tables = self.tables(&[])?;
        let ends = ["stop", "checkpoint", "evaluate"].map(|table| tables[table].to_string());
        let parts = [
            (fingerprint, "its job, files or memory differ from those of rank 0: all ranks need the same files, and resources.memory_gb says what each may use".to_owned()),
            (hash(ends.concat().as_bytes()), "its [stop], [checkpoint] or [evaluate] differs from that of rank 0: all ranks need the same".to_owned()),
            (hash(isa.as_bytes()), format!("it computes with {isa}, and rank 0 with other instructions: TOMOLITH_ISA names what all ranks have")),
        ];
        // Sixteen bits are a number without rounding
        let sixteens =
            |(sum, _): &(u64, String)| [0, 16, 32, 48].map(|shift| (sum >> shift & 0xffff) as f32);
        let sums = parts.each_ref().map(sixteens);
        let mut first = sums;
        ranks.broadcast(first.as_flattened_mut());
        let mut other = parts.into_iter().zip(sums.iter().zip(&first));
        let same = match other.find(|(_, (sum, first))| sum != first) {
            None => Ok(()),
            Some(((_, reason), _)) => Err(Error::Unsupported {
                what: format!("rank {}", ranks.rank()),
                reason,
            }),
        };
        self.agreed(same)
    }

    /// The levels with this process's frames.
    pub(crate) fn own_levels(&self) -> Cow<'_, [Level]> {
        if self.ranks.is_none() {
            return Cow::Borrowed(&self.levels);
        }
        let levels = self.levels.iter().map(|level| Level {
            lights: self.own_lights(&level.lights),
            ..level.clone()
        });
        Cow::Owned(levels.collect())
    }

    /// Lights with this process's frames.
    pub(crate) fn own_lights(&self, lights: &[Light]) -> Vec<Light> {
        let Some(ranks) = &self.ranks else {
            return lights.to_vec();
        };
        let part_of = |light: &Light| {
            let frames = frames_of_rank(light.pixels.frames(), ranks.rank(), ranks.size());
            with_frames(light, &frames)
        };
        lights.iter().map(part_of).collect()
    }

    /// Where the elements of every rank lie in the patterns of a level, whose layouts on this rank are `layouts`.
    pub(crate) fn shares(&self, level: &Level, layouts: &[PatternLayout]) -> Option<Shares> {
        let ranks = self.ranks.as_ref()?;
        let lights = level.lights.iter();
        let frames: Vec<usize> = lights.map(|light| light.pixels.frames()).collect();
        Some(Shares::new(Arc::clone(ranks), &frames, layouts))
    }

    /// Whole patterns, on any pixels, as this process's part of a level's.
    pub(crate) fn own_patterns(&self, level: &Level, whole: Vec<Patterns>) -> Vec<Patterns> {
        let Some(ranks) = &self.ranks else {
            return whole;
        };
        let part_of = |(whole, light): (Patterns, &Light)| {
            let whole = resample(&whole, &light.pixels);
            let frames = frames_of_rank(light.pixels.frames(), ranks.rank(), ranks.size());
            let images = frames.iter().flat_map(|&frame| whole.frame(frame));
            Patterns {
                values: images.copied().collect(),
                grid: with_frames(light, &frames).pixels,
            }
        };
        whole.into_iter().zip(&level.lights).map(part_of).collect()
    }

    /// The patterns of a file that the job begins with, as this process's part of a level's; None where it begins otherwise, or alone.
    pub(crate) fn own_start(&self, level: &Level) -> Result<Option<Given>> {
        let files = self.method.start.files();
        let Some(files) = files.filter(|_| self.ranks.is_some()) else {
            return Ok(None);
        };
        let grids: Vec<_> = level.lights.iter().map(|light| &light.pixels).collect();
        let whole = self.agreed(files.first.read(&grids))?;
        Ok(Some(Given(self.own_patterns(level, whole))))
    }

    /// The patterns of all ranks on the pixels of a level, from this rank's; on other ranks than the first only where they are wanted there, else
    /// nothing.
    pub(crate) fn whole_patterns(
        &self,
        level: &Level,
        parts: Vec<Patterns>,
        everywhere: bool,
    ) -> Vec<Patterns> {
        let Some(ranks) = &self.ranks else {
            return parts;
        };
        let mut all = Vec::new();
        for (part, light) in parts.iter().zip(&level.lights) {
            let shares = ranks.gather(&part.values);
            if !ranks.is_first() && !everywhere {
                continue;
            }
            let mut whole = Patterns::dark(light.pixels.clone());
            let size = light.pixels.rows * light.pixels.columns;
            for (rank, values) in shares.iter().enumerate() {
                let frames = frames_of_rank(light.pixels.frames(), rank, ranks.size());
                for (frame, image) in frames.into_iter().zip(values.chunks(size)) {
                    whole.values[frame * size..][..size].copy_from_slice(image);
                }
            }
            if everywhere {
                ranks.broadcast(&mut whole.values);
            }
            all.push(whole);
        }
        all
    }
}
