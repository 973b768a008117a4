//! Rows of patterns made brighter or darker until every height of the print is done at the same time.
//!
//! The print is shown in time; a height is done when what is solid there has absorbed what the part needs there
//! ([`Heights`](tomolith_material::heights)). A row of pixels gets the light of its height times the time of that height over the mean of all, and
//! the print is shown again, [`ROUNDS`] times at most: inhibitor that flows from height to height, and light that leans, make one round too few.
//!
//! **Source** Wang et al. 2022, supplement, Note 4: gray values rescaled slice by slice.
//!
//! **Limits** A row acts on its own height: level light. With several networks a light follows the one that it drives most. Where a pixel would be brighter than
//! `bounds.max`, all rows of its light are darkened alike.

use crate::error::Result;
use crate::grid::Patterns;
use crate::job::dose::in_time::Shown;
use crate::job::progress::{Event, Progress};
use crate::job::resolve::species::beginnings;
use crate::job::resolve::{ResolvedJob, Voxels, at_section};
use crate::models::Work;
use crate::report::number::told_apart;
use tomolith_material::curves::IdealExposure;
use tomolith_material::heights::Heights;
use tomolith_material::photopolymer::at_height;

/// Rounds of showing and rescaling.
const ROUNDS: usize = 5;
/// Heights whose times differ by less than this share of their mean are level.
const LEVEL: f64 = 0.01;
/// A round makes rows at most so many times brighter, or darker.
const MOST: f64 = 2.0;

/// When heights are done: z in mm and seconds, ascending.
type Times = Vec<[f64; 2]>;

/// The patterns with rows rescaled.
/// Refuses a network whose dose depends on the power.
pub(crate) fn level(
    job: &ResolvedJob,
    voxels: &[Voxels],
    mut patterns: Vec<Patterns>,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Vec<Patterns>> {
    let alone = vec![("resin".to_owned(), vec![1.0; patterns.len()])];
    let rows = job.mixing.as_deref().unwrap_or(&alone);
    let follows: Vec<Option<usize>> = beginnings(rows)
        .into_iter()
        .map(|begin| begin.map(|(species, _)| species))
        .collect();
    let mut first = None;
    for round in 0..=ROUNDS {
        let (times, end_s) = times(job, voxels, &patterns, work)?;
        let spread = spread(&times);
        let before = *first.get_or_insert(spread);
        if round == ROUNDS || times.iter().all(|times| width(times) < LEVEL) {
            progress.event(&Event::Note {
                text: sentence(before, spread, round),
            });
            break;
        }
        for (light, species) in follows.iter().enumerate() {
            if let Some(species) = species {
                rescale(&mut patterns[light], &times[*species], end_s);
                keep_below(&mut patterns[light], job.bounds_of(light).1);
            }
        }
    }
    Ok(patterns)
}

/// When the heights of each network are done; those that are not, by what they have of it at the end.
fn times(
    job: &ResolvedJob,
    voxels: &[Voxels],
    patterns: &[Patterns],
    work: &Work,
) -> Result<(Vec<Times>, f64)> {
    let work = work.aside();
    let shown = Shown::new(job, patterns, &work)?;
    let heights = voxels.iter().enumerate();
    let mut heights = heights
        .map(|(s, voxels)| Heights::new(&shown.material, s, &voxels.labels))
        .collect::<Result<Vec<_>>>()
        .map_err(|e| at_section("schedule.level_heights", e))?;
    shown.print(&mut |moment| heights.iter_mut().for_each(|heights| heights.watch(moment)))?;
    let end_s = shown.schedule.end_s();
    let seconds = |done: IdealExposure| match done {
        IdealExposure::At(seconds) => seconds,
        IdealExposure::NotReached(share) => end_s / share.max(1.0 / MOST),
        IdealExposure::NoRequirement => end_s,
    };
    let times_of = |heights: &Heights| -> Times {
        let done = heights.done().into_iter().enumerate();
        done.filter_map(|(z, done)| Some([job.grid.z(z), seconds(done?)]))
            .collect()
    };
    Ok((heights.iter().map(times_of).collect(), end_s))
}

fn mean(times: &Times) -> f64 {
    times.iter().map(|[_, s]| s).sum::<f64>() / times.len().max(1) as f64
}

/// First and last height that is done, s, of all networks.
fn spread(times: &[Times]) -> [f64; 2] {
    let all = || times.iter().flatten().map(|[_, s]| *s);
    [
        all().fold(f64::INFINITY, f64::min),
        all().fold(0.0, f64::max),
    ]
}

/// Time between first and last, relative to the mean.
fn width(times: &Times) -> f64 {
    let [first, last] = spread(std::slice::from_ref(times));
    (last - first) / mean(times)
}

fn sentence([a, b]: [f64; 2], [c, d]: [f64; 2], rounds: usize) -> String {
    let (before, now) = (told_apart(&[a, b], 3), told_apart(&[c, d], 3));
    format!(
        "rows of the patterns are rescaled {rounds} times: heights were done between {} and {} s, and are now between {} and {} s",
        before[0], before[1], now[0], now[1]
    )
}

/// Every row times the time of its height over the mean, which is no later than the end.
fn rescale(patterns: &mut Patterns, times: &Times, end_s: f64) {
    let reference = mean(times).min(end_s);
    let grid = &patterns.grid;
    let gains: Vec<f32> = (0..grid.rows)
        .map(|row| (at_height(times, grid.row_z(row)) / reference).clamp(1.0 / MOST, MOST) as f32)
        .collect();
    let rows = patterns.values.chunks_mut(grid.columns.max(1));
    for (row, gain) in rows.zip(gains.iter().cycle()) {
        row.iter_mut().for_each(|v| *v *= gain);
    }
}

/// Darkens patterns whose brightest pixel is above what the job allows their light.
fn keep_below(patterns: &mut Patterns, bound: Option<f64>) {
    let most = patterns.values.iter().copied().fold(0.0f32, f32::max);
    let Some(bound) = bound.filter(|b| f64::from(most) > *b) else {
        return;
    };
    let gain = (bound / f64::from(most)) as f32;
    patterns.values.iter_mut().for_each(|v| *v *= gain);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::PatternGrid;

    #[test]
    fn a_row_gets_the_light_of_its_height() {
        let grid = PatternGrid::full_turn(2, 0.0, 3, 2, 1.0);
        let mut patterns = Patterns {
            values: vec![1.0; grid.len()],
            grid,
        };
        // Row 0 is the highest: z = 1, 0, −1; the mean is 20 s
        rescale(&mut patterns, &vec![[-1.0, 10.0], [1.0, 30.0]], 100.0);
        let one = [1.5, 1.5, 1.0, 1.0, 0.5, 0.5];
        assert_eq!(patterns.values, [one, one].concat());
        keep_below(&mut patterns, Some(0.75));
        assert_eq!(patterns.values[..6], [0.75, 0.75, 0.5, 0.5, 0.25, 0.25]);
    }
}
