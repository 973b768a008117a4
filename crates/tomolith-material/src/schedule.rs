//! The schedule of an exposure: which frame of which light shines from when to when, and how strongly.
//!
//! A frame is numbered through all frames of the dose model of its light, as [`DoseModel::dose_of`](tomolith_core::dose::DoseModel::dose_of)
//! numbers them. A pattern value x of that frame sends x·irradiance mW/mm² while the frame shines.
//!
//! ```
//! use tomolith_material::schedule::{Power, Schedule, Turns};
//! // 4 frames, two turns of 10 s, each frame lit for half of its time, 0.3 mJ/mm² per turn for a value of 1
//! let turns = Turns { duty: 0.5, power: Power::EnergyPerTurn(0.3), ..Turns::new(4, 10.0, 2.0) };
//! let schedule = Schedule::of_turns(&[turns]).unwrap();
//! assert_eq!(schedule.end_s(), 20.0);
//! assert_eq!(schedule.seconds(0), [2.5; 4]); // 2 turns · 10/4 s · ½
//! assert_eq!(schedule.energies(0), [0.6; 4]); // mJ/mm²
//! // Blocks of at most 5 s end with frames: two frames each
//! assert_eq!(schedule.blocks(5.0).unwrap().len(), 4);
//! ```

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use tomolith_core::error::{Error, Result, above_zero};
use tomolith_core::kind::check_ranges;
use tomolith_core::units::exact;

/// Times closer than that are one, s.
const SAME_S: f64 = 1e-9;

/// Most frames that are shown in a schedule: what fits into memory without thought.
const MOST_EXPOSURES: f64 = 1e7;

/// One frame that shines for a while.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    /// Which light: the number of its dose model.
    pub light: usize,
    /// Which frame of that model.
    pub frame: usize,
    /// When it begins, s.
    pub begin_s: f64,
    /// How long it shines, s, above 0.
    pub seconds: f64,
    /// Irradiance of a pattern value of 1, mW/mm².
    pub irradiance_mw_per_mm2: f64,
}

impl Exposure {
    fn end_s(&self) -> f64 {
        self.begin_s + self.seconds
    }
}

/// How strong a pattern value of 1 is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Power {
    /// Its irradiance while its frame shines, mW/mm².
    #[serde(rename = "irradiance_mw_per_mm2")]
    Irradiance(f64),
    /// What it sends in one turn, mJ/mm².
    #[serde(rename = "energy_per_turn_mj_per_mm2")]
    EnergyPerTurn(f64),
    /// What it sends in all turns, mJ/mm²; 1 is what the values of pattern files mean. Where patterns differ from turn to turn, as in one turn.
    #[serde(rename = "energy_mj_per_mm2")]
    EnergyInAll(f64),
}

/// Frames of one light, shown turn by turn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Turns {
    /// Frames of a turn.
    #[schemars(range(min = 1))]
    pub frames: usize,
    /// Duration of a turn, s.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub seconds_per_turn: f64,
    /// How many turns; a broken number ends within a turn.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub turns: f64,
    /// Share of a frame's time in which it shines; it begins with the frame.
    #[serde(default = "one")]
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1.0))]
    pub duty: f64,
    /// How strong a pattern value of 1 is.
    #[serde(default)]
    pub power: Power,
    /// Dark time before the first turn, s.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub dark_before_s: f64,
    /// Dark time between turns, s.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub dark_between_s: f64,
    /// Dark time after the last turn, s.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub dark_after_s: f64,
    /// Whether every turn has patterns of its own: turn t shows frames t·frames … of the light's dose model.
    #[serde(default)]
    pub own_patterns: bool,
}

fn one() -> f64 {
    1.0
}

impl Default for Power {
    fn default() -> Self {
        Power::EnergyInAll(1.0)
    }
}

impl Turns {
    /// Turns without a dark moment, in which a pattern value is the energy over all of them.
    #[must_use]
    pub fn new(frames: usize, seconds_per_turn: f64, turns: f64) -> Self {
        Turns {
            frames,
            seconds_per_turn,
            turns,
            duty: 1.0,
            power: Power::default(),
            dark_before_s: 0.0,
            dark_between_s: 0.0,
            dark_after_s: 0.0,
            own_patterns: false,
        }
    }

    /// Frames that the dose model of the light must have.
    #[must_use]
    pub fn model_frames(&self) -> usize {
        if self.own_patterns {
            self.frames * self.turns.ceil() as usize
        } else {
            self.frames
        }
    }

    fn validate(&self) -> Result<()> {
        let (Power::Irradiance(power) | Power::EnergyPerTurn(power) | Power::EnergyInAll(power)) =
            self.power;
        above_zero("power", power)?;
        check_ranges("", self)?;
        if self.frames as f64 * self.turns > MOST_EXPOSURES {
            return Err(Error::config(
                "turns",
                format!("{} turns of {} frames", exact(self.turns), self.frames),
                format!("at most {MOST_EXPOSURES:e} frames in all"),
            ));
        }
        Ok(())
    }

    /// mW/mm² of a pattern value of 1.
    fn irradiance(&self) -> f64 {
        let lit = self.seconds_per_turn / self.frames as f64 * self.duty;
        match self.power {
            Power::Irradiance(irradiance) => irradiance,
            Power::EnergyPerTurn(energy) => energy / lit,
            Power::EnergyInAll(energy) if self.own_patterns => energy / lit,
            Power::EnergyInAll(energy) => energy / lit / self.turns,
        }
    }

    fn exposures(&self, light: usize, exposures: &mut Vec<Exposure>) -> f64 {
        let frame_s = self.seconds_per_turn / self.frames as f64;
        let count = (self.turns * self.frames as f64 - SAME_S).ceil().max(1.0) as usize;
        let begin = |i: usize| {
            let (turn, frame) = (i / self.frames, i % self.frames);
            self.dark_before_s
                + turn as f64 * (self.seconds_per_turn + self.dark_between_s)
                + frame as f64 * frame_s
        };
        let mut end = self.dark_before_s;
        for i in 0..count {
            // The last frame of a broken turn may be cut
            let share = (self.turns * self.frames as f64 - i as f64).min(1.0);
            end = begin(i) + frame_s * share;
            exposures.push(Exposure {
                light,
                frame: if self.own_patterns {
                    i
                } else {
                    i % self.frames
                },
                begin_s: begin(i),
                seconds: frame_s * share.min(self.duty),
                irradiance_mw_per_mm2: self.irradiance(),
            });
        }
        end + self.dark_after_s
    }
}

/// Frames in order of time, and when all is over.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    exposures: Vec<Exposure>,
    end_s: f64,
    /// Frames that the dose model of each light must have.
    frames: Vec<usize>,
}

/// What shines during a block of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// When it begins, s.
    pub begin_s: f64,
    /// How long it takes, s.
    pub seconds: f64,
    /// Per light: (frame, mJ/mm² of a pattern value of 1), frames ascending; none in the dark.
    pub lit: Vec<Vec<(usize, f64)>>,
}

impl Block {
    /// When it ends, s.
    #[must_use]
    pub fn end_s(&self) -> f64 {
        self.begin_s + self.seconds
    }
}

impl Schedule {
    /// Lights that are shown side by side, each turn by turn; it ends with the last of them.
    ///
    /// # Errors
    /// [`Error::Config`] with the key under `light[i]`, or at `schedule` for no light at all and an end that is not finite.
    pub fn of_turns(lights: &[Turns]) -> Result<Self> {
        let mut exposures = Vec::new();
        let mut end_s = 0.0f64;
        for (light, turns) in lights.iter().enumerate() {
            turns
                .validate()
                .map_err(|e| e.under(&format!("light[{light}]")))?;
            end_s = end_s.max(turns.exposures(light, &mut exposures));
        }
        // Energy within a time that is too short is more power than a number holds
        let shines = |e: &Exposure| e.seconds > 0.0 && e.irradiance_mw_per_mm2.is_finite();
        if exposures.is_empty() || !end_s.is_finite() || !exposures.iter().all(shines) {
            return Err(Error::config(
                "schedule",
                format!("{} exposures, end at {} s", exposures.len(), exact(end_s)),
                "at least one exposure, a finite end, times above 0 and finite powers",
            ));
        }
        exposures.sort_by(|a, b| {
            let order = a.begin_s.total_cmp(&b.begin_s);
            order.then((a.light, a.frame).cmp(&(b.light, b.frame)))
        });
        Ok(Schedule {
            exposures,
            end_s,
            frames: lights.iter().map(Turns::model_frames).collect(),
        })
    }

    /// The same where a machine shows frame `order[j]` of a light when its frame j is due.
    #[must_use]
    pub fn in_order(mut self, light: usize, order: &[usize]) -> Self {
        let exposures = self.exposures.iter_mut().filter(|e| e.light == light);
        exposures.for_each(|e| e.frame = order[e.frame]);
        self
    }

    /// All exposures, by time.
    #[must_use]
    pub fn exposures(&self) -> &[Exposure] {
        &self.exposures
    }

    /// When all is over, dark times included, s.
    #[must_use]
    pub fn end_s(&self) -> f64 {
        self.end_s
    }

    /// Frames that the dose model of each light must have.
    #[must_use]
    pub fn frames(&self) -> &[usize] {
        &self.frames
    }

    /// How long each frame of a light shines, s.
    #[must_use]
    pub fn seconds(&self, light: usize) -> Vec<f64> {
        self.sums(light, |e| e.seconds)
    }

    /// What a pattern value of 1 in each frame of a light sends, mJ/mm².
    #[must_use]
    pub fn energies(&self, light: usize) -> Vec<f64> {
        self.sums(light, |e| e.seconds * e.irradiance_mw_per_mm2)
    }

    fn sums(&self, light: usize, amount_of: impl Fn(&Exposure) -> f64) -> Vec<f64> {
        let mut sums = vec![0.0; self.frames[light]];
        let exposures = self.exposures.iter().filter(|e| e.light == light);
        exposures.for_each(|e| sums[e.frame] += amount_of(e));
        sums
    }

    /// Refuses blocks that are no times, or too many.
    ///
    /// # Errors
    /// [`Error::Config`] at `step_s`.
    pub fn must_cut(&self, longest_s: f64) -> Result<()> {
        if longest_s > 0.0 && self.end_s / longest_s <= MOST_EXPOSURES {
            return Ok(());
        }
        Err(Error::config(
            "step_s",
            format!(
                "found {} for a print of {} s",
                exact(longest_s),
                exact(self.end_s)
            ),
            format!("a time above 0 that cuts the print into at most {MOST_EXPOSURES:e} steps"),
        ))
    }

    /// The whole time in blocks of at most `longest_s`. They end where frames begin or end, unless a frame (or the dark) is longer: it is cut
    /// into equal parts.
    ///
    /// # Errors
    /// As [`must_cut`](Self::must_cut).
    pub fn blocks(&self, longest_s: f64) -> Result<Vec<Block>> {
        self.must_cut(longest_s)?;
        let cuts = self.cuts(longest_s);
        let mut blocks: Vec<Block> = cuts
            .windows(2)
            .map(|ends| Block {
                begin_s: ends[0],
                seconds: ends[1] - ends[0],
                lit: Vec::new(),
            })
            .collect();
        let mut lit = vec![vec![BTreeMap::new(); self.frames.len()]; blocks.len()];
        for e in &self.exposures {
            let first = cuts.partition_point(|&cut| cut <= e.begin_s + SAME_S);
            for i in first.saturating_sub(1)..blocks.len() {
                let block = &blocks[i];
                if block.begin_s >= e.end_s() - SAME_S {
                    break;
                }
                // Whole exposures keep their seconds to the bit
                let (early, late) = (
                    block.begin_s - e.begin_s > SAME_S,
                    e.end_s() - block.end_s() > SAME_S,
                );
                let seconds = match (early, late) {
                    (false, false) => e.seconds,
                    (false, true) => block.end_s() - e.begin_s,
                    (true, false) => e.end_s() - block.begin_s,
                    (true, true) => block.seconds,
                };
                *lit[i][e.light].entry(e.frame).or_insert(0.0) += seconds * e.irradiance_mw_per_mm2;
            }
        }
        for (block, lit) in blocks.iter_mut().zip(lit) {
            block.lit = lit.into_iter().map(|l| l.into_iter().collect()).collect();
        }
        Ok(blocks)
    }

    /// Where blocks begin and end.
    fn cuts(&self, longest_s: f64) -> Vec<f64> {
        let mut borders: Vec<f64> = vec![0.0, self.end_s];
        for e in &self.exposures {
            borders.extend([e.begin_s, e.end_s().min(self.end_s)]);
        }
        borders.sort_by(f64::total_cmp);
        borders.dedup_by(|a, b| *a - *b < SAME_S);
        let mut cuts = vec![0.0];
        let mut next = 1;
        while next < borders.len() {
            let from = cuts[cuts.len() - 1];
            // The last border that is near enough, or the first one
            let beyond = borders.partition_point(|&b| b <= from + longest_s * (1.0 + 1e-9));
            let to = beyond.saturating_sub(1).max(next);
            let parts = ((borders[to] - from) / longest_s - 1e-6).ceil().max(1.0);
            let step = (borders[to] - from) / parts;
            cuts.extend((1..parts as usize).map(|i| from + i as f64 * step));
            cuts.push(borders[to]);
            next = to + 1;
        }
        cuts
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::refused;
    use tomolith_core::near;

    #[test]
    fn blocks_hold_all_energy_and_never_exceed_the_longest() {
        // Two lights of other frame rates, dark times, a broken turn, an own list of patterns
        let lights = [
            Turns {
                duty: 0.7,
                dark_before_s: 0.3,
                dark_between_s: 1.1,
                dark_after_s: 2.0,
                power: Power::Irradiance(0.2),
                ..Turns::new(7, 3.0, 2.4)
            },
            Turns {
                own_patterns: true,
                power: Power::EnergyPerTurn(0.5),
                ..Turns::new(5, 4.0, 2.0)
            },
        ];
        let schedule = Schedule::of_turns(&lights).unwrap();
        assert_eq!(schedule.frames(), [7, 10]);
        assert!((schedule.end_s() - (0.3 + 2.0 * 4.1 + 1.2 + 2.0)).abs() < 1e-12);
        // 2.4 turns of 7 frames are 16.8: frames 0, 1 three times, frame 2 thrice with the last one cut to 0.8 > duty: whole
        let frame_s = 3.0 / 7.0 * 0.7;
        let seconds = schedule.seconds(0);
        for (frame, times) in [3.0, 3.0, 3.0, 2.0, 2.0, 2.0, 2.0].into_iter().enumerate() {
            near!(seconds[frame], times * frame_s, 1e-12, "{seconds:?}");
        }
        for longest in [0.05, 0.4, 1.0, 3.7, 100.0] {
            let blocks = schedule.blocks(longest).unwrap();
            let whole: f64 = blocks.iter().map(|b| b.seconds).sum();
            assert!((whole - schedule.end_s()).abs() < 1e-9);
            assert!(
                blocks
                    .iter()
                    .all(|b| b.seconds <= longest * (1.0 + 1e-6) && b.seconds > 0.0)
            );
            for light in 0..2 {
                let mut sums = vec![0.0; schedule.frames()[light]];
                for block in &blocks {
                    block.lit[light]
                        .iter()
                        .for_each(|&(frame, e)| sums[frame] += e);
                }
                for (sum, energy) in sums.iter().zip(schedule.energies(light)) {
                    assert!((sum - energy).abs() < 1e-12, "{longest}: {sum} {energy}");
                }
            }
        }
    }

    #[test]
    fn what_cannot_be_is_named_by_its_key() {
        type Change = fn(&mut Turns);
        let plain = Turns::new(4, 10.0, 2.0);
        let changes: [(Change, &str); 9] = [
            (|t| t.frames = 0, "light[0].frames"),
            (|t| t.seconds_per_turn = 0.0, "light[0].seconds_per_turn"),
            (|t| t.turns = f64::NAN, "light[0].turns"),
            (|t| t.duty = 1.5, "light[0].duty"),
            (|t| t.dark_after_s = -1.0, "light[0].dark_after_s"),
            (|t| t.power = Power::Irradiance(-2.0), "light[0].power"),
            (|t| t.turns = 1e9, "light[0].turns"),
            (|t| t.seconds_per_turn = 1e-310, "schedule"),
            (
                |t| (t.dark_before_s, t.dark_after_s) = (f64::MAX, f64::MAX),
                "schedule",
            ),
        ];
        for (change, expected) in changes {
            let mut turns = plain;
            change(&mut turns);
            let [key, _] = refused(Schedule::of_turns(&[turns]));
            assert_eq!(key, expected);
        }
        let schedule = Schedule::of_turns(&[plain]).unwrap();
        assert_eq!(refused(schedule.blocks(0.0))[0], "step_s");
    }

    #[test]
    fn energy_over_the_whole_exposure_is_one_to_the_last_bit_of_f32() {
        for turns in [1.0, 3.0, 7.0, 49.0] {
            let schedule = Schedule::of_turns(&[Turns::new(36, 0.7, turns)]).unwrap();
            assert!(schedule.energies(0).iter().all(|&e| e as f32 == 1.0));
        }
    }
}
