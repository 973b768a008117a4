//! The schedule of a job, and the frames that it shows.

use crate::error::{Error, Result};
use crate::job::resolve::ResolvedJob;
use crate::job::spec::{Angles, JobSpec, LightSpec};
use tomolith_material::schedule::{Schedule, Turns};

/// Frames that cover a part of a turn take that part of its time; a machine may show them in another order than the light's angles.
pub(crate) fn schedule(spec: &JobSpec) -> Result<Schedule> {
    let given = spec.schedule.clone().unwrap_or_default();
    let turn_s = given.seconds_per_turn.unwrap_or(60.0 / spec.output.rpm);
    let turns_of = |light: &LightSpec| Turns {
        duty: given.duty,
        power: light.power.unwrap_or(given.power),
        dark_before_s: given.dark_before_s,
        dark_between_s: given.dark_between_s,
        dark_after_s: given.dark_after_s,
        own_patterns: given.own_patterns,
        ..Turns::new(
            light.angles.count(),
            light.angles.turned() * turn_s,
            light.turns.unwrap_or(given.turns),
        )
    };
    let turns: Vec<Turns> = spec.light.iter().map(turns_of).collect();
    let mut schedule = Schedule::of_turns(&turns).map_err(|error| at_schedule(spec, error))?;
    for i in 0..spec.light.len() {
        if let Some(order) = spec.shown_order(i)? {
            schedule = schedule.in_order(i, &order);
        }
    }
    Ok(schedule)
}

/// Share of the energy of the brightest frame above which a frame counts as bright as that.
const EVEN: f64 = 0.95;

impl ResolvedJob {
    /// When which frame shines: the schedule of the job, or one turn.
    pub(crate) fn exposures(&self) -> Result<Schedule> {
        schedule(&self.spec)
    }

    /// Warns of frames that the schedule shows less often than others, or never: the dose counts all alike, unless it diffuses.
    pub(crate) fn uneven_turns(&self) -> Result<Option<String>> {
        if self.schedule().is_none() || self.diffusion().is_some() {
            return Ok(None);
        }
        let schedule = self.exposures()?;
        let of_light = |light: usize| {
            let energies = schedule.energies(light);
            let most = energies.iter().copied().fold(0.0, f64::max);
            let less = energies.iter().filter(|e| **e < EVEN * most).count();
            let never = energies.iter().filter(|e| **e == 0.0).count();
            let (count, how_often) = match (never, less) {
                (0, 0) => return None,
                (0, less) => (less, "less often than the others"),
                (never, _) => (never, "never"),
            };
            Some(format!(
                "the schedule shows {count} of {} frames of light[{light}] {how_often}. The dose and the IoU count all alike; only the print in time counts what is shown. \
                 A whole number of turns (schedule.turns) makes both the same",
                energies.len()
            ))
        };
        Ok((0..schedule.frames().len()).find_map(of_light))
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

    /// How many turns have frames of their own.
    pub(crate) fn turns_of_patterns(&self) -> usize {
        let schedule = self.schedule.as_ref().filter(|given| given.own_patterns);
        schedule.map_or(1, |given| given.turns.max(1.0) as usize)
    }

    /// The frame of a light that its machine shows as number j; None where no machine is given.
    pub(crate) fn shown_order(&self, light: usize) -> Result<Option<Vec<usize>>> {
        let Some(printer) = self.printer_of(light) else {
            return Ok(None);
        };
        let rotation = self.light[light].rotation;
        let (azimuths, arc) = self.angles_of(light).azimuths(rotation);
        let order = printer.order(&azimuths, arc, rotation, self.turns_of_patterns());
        let (order, _) = order.map_err(|e| self.at_printer_of(light, e))?;
        Ok(Some(order))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::tests::job_of;

    /// Azimuth (degrees) and begin (s) of what shines, by a job of three angles and a turn of 6 s.
    fn shown(changes: &[&str]) -> Vec<(f64, f64)> {
        let text = r#"
            target = { phantom = "gear", size_mm = 2.0 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
            vial = { index_matched = { radius_mm = 3.0 } }
            light = [{ pixels = [2, 2], angles = 3, projector = { collimated = { pixel_pitch_mm = 0.5 } } }]
            schedule = { seconds_per_turn = 6.0 }
        "#;
        let spec = job_of(text, changes).spec;
        let (azimuths, _) = spec.angles_of(0).azimuths(spec.light[0].rotation);
        let schedule = schedule(&spec).unwrap();
        let exposures = schedule.exposures().iter();
        let shown =
            exposures.map(|e| (azimuths[e.frame].to_degrees().rem_euclid(360.0), e.begin_s));
        shown.map(|(degrees, s)| (degrees.round(), s)).collect()
    }

    #[test]
    fn frames_shine_in_the_order_of_the_machine() {
        let by_light = [(0.0, 0.0), (120.0, 2.0), (240.0, 4.0)];
        assert_eq!(shown(&[]), by_light);
        let other_way = "printer.rotation=\"counterclockwise\"";
        let backwards = [(0.0, 0.0), (240.0, 2.0), (120.0, 4.0)];
        assert_eq!(shown(&[other_way]), backwards);
        let from_the_side = [(120.0, 0.0), (0.0, 2.0), (240.0, 4.0)];
        assert_eq!(shown(&[other_way, "printer.start_deg=120"]), from_the_side);
        // Frames of its own for each of two turns: the first turn is the first that is shown
        let two = ["schedule.turns=2", "schedule.own_patterns=true"];
        let backwards_twice: Vec<_> = (backwards.iter().copied())
            .chain(backwards.map(|(degrees, s)| (degrees, s + 6.0)))
            .collect();
        assert_eq!(shown(&[&two[..], &[other_way]].concat()), backwards_twice);
        let spec = job_of(
            r#"
            target = { phantom = "gear", size_mm = 2.0 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
            vial = { index_matched = { radius_mm = 3.0 } }
            light = [{ pixels = [2, 2], angles = { list_deg = [0, 10, 50] }, projector = { collimated = { pixel_pitch_mm = 0.5 } } }]
            printer = { rotation = "counterclockwise" }
            "#,
            &two,
        )
        .spec;
        assert_eq!(spec.shown_order(0).unwrap().unwrap(), [2, 1, 0, 5, 4, 3]);
    }

    #[test]
    fn frames_of_a_part_of_a_turn_take_its_part_of_the_time() {
        let half = "light.angles={ count = 2, arc_deg = 180 }";
        let passes = [(0.0, 0.0), (90.0, 1.5), (0.0, 3.0), (90.0, 4.5)];
        assert_eq!(shown(&[half, "schedule.turns=2"]), passes);
    }

    #[test]
    fn frames_that_a_broken_turn_leaves_out_are_warned_of() {
        use crate::models::Work;
        let text = r#"
            target = { phantom = { sphere = {} }, size_mm = 1.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1, critical_dose_mj_per_mm3 = 0.4 }
            vial = { index_matched = { radius_mm = 2.0 } }
            light = [{ pixels = [4, 4], angles = 8, projector = { collimated = { pixel_pitch_mm = 0.5 } } }]
            schedule = { power = { energy_per_turn_mj_per_mm2 = 0.5 } }
        "#;
        let warning_of = |turns: &str| {
            let job = job_of(text, &[turns]);
            let job = ResolvedJob::under(&job, &Work::new()).unwrap();
            job.uneven_turns().unwrap()
        };
        assert_eq!(warning_of("schedule.turns=3"), None);
        assert_eq!(warning_of("schedule.turns=30.5"), None);
        let [fewer, never] = ["schedule.turns=1.5", "schedule.turns=0.25"].map(warning_of);
        tomolith_core::contains!(fewer.unwrap(), "4 of 8 frames of light[0] less often");
        tomolith_core::contains!(never.unwrap(), "6 of 8 frames of light[0] never");
    }
}
