//! Several species at one exposure. A print has only one, so species that are best at different doses are printed together only where their networks gel at
//! doses of that ratio.
//!
//! **Definition** Of all doses, the one at which the lowest IoU of all species is the largest, every network gelling at that dose; of all times of a print in time,
//! the one at which the lowest Jaccard index is. Between the points of their curves both are taken as linear.

use super::latitude;
use super::latitude::Bracket;
use super::number::{significant, told_apart};
use super::time::in_minutes;
use serde::Serialize;
use tomolith_metrics::latitude::TOLERANCE;

/// What several species become together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OneExposure {
    /// The dose at which every network gels, in units of the job.
    pub gel_dose: f64,
    /// Names of the species.
    pub species: Vec<String>,
    /// IoU of each of them there.
    pub iou: Vec<f64>,
    /// The species whose IoU is the lowest.
    pub limited_by: String,
    /// Exposures over which the lowest IoU is at most 0.01 worse, % of this one.
    pub percent: Bracket,
    /// The bracket as times to print, s; none where the job does not give times.
    pub time_s: Option<Bracket>,
}

impl OneExposure {
    /// Of the IoU of each species over its dose, `[dose, IoU]` with ascending doses; None for fewer than two species, where no dose lies on all curves, and where
    /// one of them prints nothing at any dose that prints the others.
    #[must_use]
    pub fn of(species: &[(&str, Vec<[f64; 2]>)]) -> Option<Self> {
        let curves: Vec<_> = species.iter().map(|(_, curve)| curve.as_slice()).collect();
        let Together {
            at: gel_dose,
            values: iou,
            lowest,
            from,
            to,
        } = Together::of(&curves)?;
        // At s times the exposure, what gels is what got gel_dose/s
        let percent = |dose: f64| Some(100.0 * gel_dose / dose).filter(|p| p.is_finite());
        (iou[lowest] > 0.0).then(|| OneExposure {
            gel_dose,
            species: species.iter().map(|(name, _)| (*name).to_owned()).collect(),
            iou,
            limited_by: species[lowest].0.to_owned(),
            percent: Bracket {
                low: to.and_then(percent),
                best: Some(100.0),
                high: from.and_then(percent),
            },
            time_s: None,
        })
    }

    /// With times to print: a resin that gels at this dose takes so many seconds.
    #[must_use]
    pub fn in_time(mut self, dose: f64, seconds: f64) -> Self {
        let best = seconds * dose / self.gel_dose;
        self.time_s = Some(self.percent.map(|percent| best * percent / 100.0));
        self
    }

    /// In words.
    #[must_use]
    pub fn sentence(&self) -> String {
        let mut text = format!(
            "A print has one exposure: with a gel dose of {} for all species they reach IoU {}; {} limits it. The lowest IoU is at most {TOLERANCE} worse {} of this exposure",
            significant(self.gel_dose, 3),
            listed(&self.species, &self.iou),
            self.limited_by,
            latitude::from_to(&self.percent, "%"),
        );
        if let Some(time) = &self.time_s {
            text += &latitude::times(time);
        }
        text.push('.');
        text
    }
}

/// What several networks of a print in time are together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OneMoment {
    /// When the lowest Jaccard index is the largest, s.
    pub seconds: f64,
    /// Names of the networks.
    pub networks: Vec<String>,
    /// Jaccard index of each of them then.
    pub jaccard: Vec<f64>,
    /// The network whose index is the lowest.
    pub limited_by: String,
    /// Energy that all lights have sent to the vial by then, mJ.
    pub sent_mj: f64,
    /// Within which times the lowest is at most 0.01 worse, s.
    pub window_s: [f64; 2],
}

impl OneMoment {
    /// Of the Jaccard index of each network over time, `[s, index]` ascending, and of the energy that was sent to the vial, `[s, mJ]`; None for fewer
    /// than two, and where one of them is never solid.
    #[must_use]
    pub fn of(networks: &[(&str, Vec<[f64; 2]>)], sent: &[[f64; 2]]) -> Option<Self> {
        let curves: Vec<_> = networks.iter().map(|(_, curve)| curve.as_slice()).collect();
        let together = Together::of(&curves)?;
        let lowest = together.values[together.lowest];
        let end = curves[0].last().map_or(together.at, |point| point[0]);
        (lowest > 0.0).then(|| OneMoment {
            seconds: together.at,
            networks: networks
                .iter()
                .map(|(name, _)| (*name).to_owned())
                .collect(),
            limited_by: networks[together.lowest].0.to_owned(),
            jaccard: together.values,
            sent_mj: value_at(sent, together.at).unwrap_or(0.0),
            window_s: [together.from.unwrap_or(0.0), together.to.unwrap_or(end)],
        })
    }

    /// In words.
    #[must_use]
    pub fn sentence(&self) -> String {
        let [from, to] = self.window_s;
        let texts = told_apart(&[from, self.seconds, to], 3);
        format!(
            "All networks together are best after {} s{}, when {} mJ have been sent to the vial: IoU {}; {} limits it. The lowest is at most \
             {TOLERANCE} worse from {} s to {} s.",
            texts[1],
            in_minutes(self.seconds),
            significant(self.sent_mj, 3),
            listed(&self.networks, &self.jaccard),
            self.limited_by,
            texts[0],
            texts[2],
        )
    }
}

/// Names, each with its number.
fn listed(names: &[String], values: &[f64]) -> String {
    let text_of = |(name, value): (&String, &f64)| format!("{name} {}", significant(*value, 4));
    let all: Vec<String> = names.iter().zip(values).map(text_of).collect();
    all.join(", ")
}

/// Where the lowest of several curves is the largest.
struct Together {
    at: f64,
    /// Of each curve there.
    values: Vec<f64>,
    /// Which of them is the lowest.
    lowest: usize,
    /// Between these the lowest is at most [`TOLERANCE`] below; none where the curves end before.
    from: Option<f64>,
    to: Option<f64>,
}

impl Together {
    fn of(curves: &[&[[f64; 2]]]) -> Option<Self> {
        if curves.len() < 2 {
            return None;
        }
        let mut places: Vec<f64> = curves
            .iter()
            .flat_map(|curve| curve.iter().map(|point| point[0]))
            .filter(|place| place.is_finite())
            .collect();
        places.sort_by(f64::total_cmp);
        let at = |place: f64| -> Option<Vec<f64>> {
            curves.iter().map(|curve| value_at(curve, place)).collect()
        };
        // The lowest is the largest at a point of a curve, or where two lines cross
        let crossed: Vec<f64> = places
            .windows(2)
            .flat_map(|pair| match (at(pair[0]), at(pair[1])) {
                (Some(from), Some(to)) => crossings([pair[0], pair[1]], &from, &to),
                _ => Vec::new(),
            })
            .collect();
        places.extend(crossed);
        places.sort_by(f64::total_cmp);
        let low =
            |place: f64| at(place).map(|values| values.into_iter().fold(f64::INFINITY, f64::min));
        let known: Vec<[f64; 2]> = places
            .iter()
            .filter_map(|&place| Some([place, low(place)?]))
            .collect();
        // Where the lowest stands still the next lowest decides, then the earliest place
        let ranked = |place: f64| -> Vec<i64> {
            let mut values: Vec<i64> = at(place)
                .into_iter()
                .flatten()
                .map(|value| (value * EQUAL).round() as i64)
                .collect();
            values.sort_unstable();
            values
        };
        let best = known
            .iter()
            .rev()
            .copied()
            .max_by_key(|point| ranked(point[0]))?;
        let is_good = |place: f64| low(place).is_some_and(|value| value >= best[1] - TOLERANCE);
        let first_bad = |mut places: Box<dyn Iterator<Item = f64> + '_>| {
            let mut good = best[0];
            places
                .find(|&place| {
                    let is_bad = !is_good(place);
                    good = if is_bad { good } else { place };
                    is_bad
                })
                .map(|bad| border(good, bad, &is_good))
        };
        let all = || known.iter().map(|point| point[0]);
        let from = first_bad(Box::new(all().rev().filter(|place| *place < best[0])));
        let to = first_bad(Box::new(all().filter(|place| *place > best[0])));
        let values = at(best[0])?;
        let lowest = (0..values.len()).min_by(|&a, &b| values[a].total_cmp(&values[b]))?;
        Some(Together {
            at: best[0],
            values,
            lowest,
            from,
            to,
        })
    }
}

/// Values are equal where they agree to a part in so many.
const EQUAL: f64 = 1e6;

/// Where lines cross that go from some values to others between two places.
fn crossings([first, last]: [f64; 2], from: &[f64], to: &[f64]) -> Vec<f64> {
    let pairs = (0..from.len()).flat_map(|a| (0..a).map(move |b| (a, b)));
    let crossing = |(a, b): (usize, usize)| {
        let (before, after) = (from[a] - from[b], to[a] - to[b]);
        (before * after < 0.0).then(|| first + (last - first) * before / (before - after))
    };
    pairs.filter_map(crossing).collect()
}

/// The last good place on the way from a good to a bad one.
fn border(mut good: f64, mut bad: f64, is_good: &dyn Fn(f64) -> bool) -> f64 {
    for _ in 0..50 {
        let middle = f64::midpoint(good, bad);
        if is_good(middle) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    good
}

/// A curve between its points; None outside of them.
fn value_at(curve: &[[f64; 2]], place: f64) -> Option<f64> {
    let above = curve.partition_point(|point| point[0] < place);
    let high = curve.get(above)?;
    if high[0] == place {
        return Some(high[1]);
    }
    let low = curve[above.checked_sub(1)?];
    let share = (place - low[0]) / (high[0] - low[0]);
    Some(low[1] + share * (high[1] - low[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tent(top: f64, width: f64) -> Vec<[f64; 2]> {
        vec![[top - width, 0.0], [top, 1.0], [top + width, 0.0]]
    }

    #[test]
    fn the_lowest_species_limits_the_one_exposure_and_its_window() {
        // A wide species and a narrow one of the same dose: the narrow one limits it, 0.01 of it is 0.005 in the dose
        let one = OneExposure::of(&[("wide", tent(2.0, 2.0)), ("narrow", tent(2.0, 0.5))]).unwrap();
        assert_eq!((one.gel_dose, &one.iou), (2.0, &vec![1.0, 1.0]));
        let close = |found: Option<f64>, expected: f64| {
            assert!((found.unwrap() - expected).abs() < 1e-6, "{found:?}");
        };
        close(one.percent.low, 100.0 * 2.0 / 2.005);
        close(one.percent.high, 100.0 * 2.0 / 1.995);
        // Perfect at doses of 1 and 2: nearest to that together at 1.5
        let both = OneExposure::of(&[("a", tent(1.0, 1.0)), ("b", tent(2.0, 1.0))]).unwrap();
        assert_eq!((both.gel_dose, both.iou), (1.5, vec![0.5, 0.5]));
        let apart = OneExposure::of(&[("a", tent(2.0, 2.0)), ("b", tent(2.5, 1.0))]).unwrap();
        // 1 − (d − 2)/2 and 1 − (2.5 − d) meet at 7/3
        assert!((apart.gel_dose - 7.0 / 3.0).abs() < 1e-9, "{apart:?}");
        let lowest = apart.iou.iter().copied().fold(1.0, f64::min);
        let limits = apart
            .species
            .iter()
            .position(|name| *name == apart.limited_by);
        assert_eq!(apart.iou[limits.unwrap()], lowest);
        let dark = vec![[0.0, 0.0], [1.0, 0.0], [3.0, 0.0]];
        assert_eq!(
            OneExposure::of(&[("a", tent(2.0, 2.0)), ("dark", dark)]),
            None
        );
    }

    #[test]
    fn times_follow_the_dose_and_words_say_who_limits() {
        let one = OneExposure::of(&[
            ("soft", tent(2.0, 2.0)),
            ("stiff", vec![[1.0, 0.9], [2.0, 0.9], [3.0, 0.9]]),
        ]);
        // A resin that gels at 1 takes 40 s, one that gels at 2 takes 20 s
        let one = one.unwrap().in_time(1.0, 2.0 * 20.0);
        assert_eq!(one.limited_by, "stiff");
        let best = one.time_s.unwrap().best.unwrap();
        assert!((best - 40.0 / one.gel_dose).abs() < 1e-9);
        let text = one.sentence();
        assert!(text.contains("stiff 0.9; stiff limits it"), "{text}");
    }

    #[test]
    fn networks_have_one_best_moment_or_none() {
        let later = tent(30.0, 10.0);
        let sent = [[0.0, 0.0], [60.0, 30.0]];
        let moment = OneMoment::of(&[("a", tent(20.0, 20.0)), ("b", later)], &sent).unwrap();
        // 1 − (t − 20)/20 and 1 − (30 − t)/10 meet at 80/3, at half a mJ a second
        assert!((moment.seconds - 80.0 / 3.0).abs() < 1e-9, "{moment:?}");
        assert!((moment.sent_mj - 40.0 / 3.0).abs() < 1e-9, "{moment:?}");
        let [from, to] = moment.window_s;
        assert!(from < moment.seconds && moment.seconds < to);
        // One stands still after its light has ended: the other says when
        let still = vec![[0.0, 0.0], [20.0, 0.4], [40.0, 0.4]];
        let moment = OneMoment::of(&[("a", still), ("b", tent(30.0, 15.0))], &sent).unwrap();
        assert_eq!((moment.seconds, &moment.limited_by[..]), (30.0, "a"));
        let never = vec![[0.0, 0.0], [40.0, 0.0]];
        let unlike = [("a", tent(20.0, 20.0)), ("b", never)];
        assert_eq!(OneMoment::of(&unlike, &sent), None);
    }
}
