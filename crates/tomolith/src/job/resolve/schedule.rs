//! The schedule of a job, and the frames that it shows.

use crate::error::{Error, Result};
use crate::job::resolve::ResolvedJob;
use crate::job::spec::{Angles, JobSpec};
use tomolith_material::schedule::{Schedule, Turns};

pub(crate) fn schedule(spec: &JobSpec) -> Result<Schedule> {
    let given = spec.schedule.clone().unwrap_or_default();
    let turns: Vec<Turns> = spec
        .light
        .iter()
        .map(|light| Turns {
            duty: given.duty,
            power: light.power.unwrap_or(given.power),
            dark_before_s: given.dark_before_s,
            dark_between_s: given.dark_between_s,
            dark_after_s: given.dark_after_s,
            own_patterns: given.own_patterns,
            ..Turns::new(
                light.angles.count(),
                given.seconds_per_turn.unwrap_or(60.0 / spec.output.rpm),
                light.turns.unwrap_or(given.turns),
            )
        })
        .collect();
    Schedule::of_turns(&turns).map_err(|error| at_schedule(spec, error))
}

impl ResolvedJob {
    /// When which frame shines: the schedule of the job, or one turn.
    pub(crate) fn exposures(&self) -> Result<Schedule> {
        schedule(&self.spec)
    }
}

impl JobSpec {
    /// The angles of all frames of a light: those of a turn, or of all turns where each has patterns of its own.
    pub(crate) fn angles_of(&self, light: usize) -> Angles {
        let angles = &self.light[light].angles;
        let schedule = self.schedule.as_ref().filter(|given| given.own_patterns);
        schedule
            .and_then(|given| angles.turn_after_turn(given.turns as usize))
            .unwrap_or_else(|| angles.clone())
    }
}

/// `light.turns` of a light that an error calls `light[i`.
fn turns_of(spec: &JobSpec, light: &str) -> Option<f64> {
    let i: usize = light.strip_prefix("light[")?.parse().ok()?;
    spec.light.get(i)?.turns
}

/// Names the key of the job.
fn at_schedule(spec: &JobSpec, error: Error) -> Error {
    let Error::Config {
        key,
        found,
        accepted,
        ..
    } = &error
    else {
        return error;
    };
    match key.split_once("].") {
        Some((light, "turns")) if turns_of(spec, light).is_some() => {
            Error::config(format!("{light}].turns"), found, accepted)
        }
        Some((light, "power")) => {
            let i: Option<usize> = light.strip_prefix("light[").and_then(|i| i.parse().ok());
            let power = i.and_then(|i| spec.light.get(i)).and_then(|l| l.power);
            let key = match power {
                Some(_) => format!("{light}].power"),
                None => "schedule.power".to_owned(),
            };
            Error::config(key, found, accepted)
        }
        Some((_, key)) => Error::config(format!("schedule.{key}"), found, accepted),
        None => error.under("schedule"),
    }
}
