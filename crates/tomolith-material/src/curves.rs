//! What a print in time is evaluated by: curves over time, phases, the ideal exposure, cure times.
//!
//! Definitions are in `docs/material.md`; source: Wang et al. 2022, supplement, Note 4. All sums run over the voxels that count, in a fixed order.
//! A [`Curves`] looks at one network; lights with several have one each.

use crate::Readout;
use crate::photopolymer::Photopolymer;
use crate::print::Moment;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{BLOCK, Field, HostField};
use tomolith_core::grid::Volume;
use tomolith_core::parallel::InParallel;
use tomolith_core::target::label;

/// All numbers of one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Time, s.
    pub seconds: f64,
    /// Drive that was absorbed so far, mJ.
    pub imbued_mj: f64,
    /// The part of it in gelled voxels, mJ.
    pub contribution_mj: f64,
    /// Contrast of the dose, split halfway between its ends; NaN while all is the same.
    pub contrast: f64,
    /// The printed contrast (S12), split at half of the difference; NaN where its low class is empty.
    pub printed_contrast: f64,
    /// Gelled ∩ part over gelled ∪ part.
    pub jaccard: f64,
    /// Gelled share of part and of void.
    pub gelled: [f64; 2],
    /// Smallest and largest dose, mJ/mm³.
    pub dose: [f64; 2],
}

/// When the contribution meets the requirement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IdealExposure {
    /// At this time, s.
    At(f64),
    /// Not within the print: the largest share of the requirement that gelled voxels absorbed; where none gelled, that the part absorbed.
    NotReached(f64),
    /// There is no requirement: the gel dose depends on the power.
    NoRequirement,
}

/// Where the three phases end, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phases {
    /// Induction: when the first voxel gels. None: none does.
    pub induction_end_s: Option<f64>,
    /// Curing: when the Jaccard index is largest, the first time. None as above.
    pub curing_end_s: Option<f64>,
}

/// See the [module page](self).
pub struct Curves {
    species: usize,
    labels: Vec<u8>,
    counts: [f64; 2],
    voxel_mm3: f64,
    /// Absorbed drive, mJ/mm³.
    absorbed: HostField,
    points: Vec<CurvePoint>,
    requirement_mj: Option<f64>,
    cure: Option<CureTimes>,
    wanted: Vec<f64>,
    snapshots: Vec<(f64, Volume<f32>)>,
}

/// Readout a moment ago, and the times found so far.
struct CureTimes {
    before: HostField,
    seconds: HostField,
}

/// Sums over a block of voxels.
#[derive(Clone, Copy)]
struct Sums {
    imbued: f64,
    contribution: f64,
    /// Gelled voxels of void and part.
    gelled: [u64; 2],
    least: f32,
    most: f32,
}

impl Curves {
    /// Curves of a network, for the labels of its target (file order).
    ///
    /// # Errors
    /// [`Error::Shape`] for labels of another grid; [`Error::Config`] at `target` when no voxel is part.
    pub fn new(material: &Photopolymer, species: usize, labels: &Volume<u8>) -> Result<Self> {
        let layout = material.domain().layout();
        if labels.grid.shape != layout.grid.shape {
            return Err(Error::shape(
                "labels of the target",
                layout.grid.shape,
                labels.grid.shape,
            ));
        }
        let labels = layout.field_of(labels);
        let count = |wanted: u8| labels.iter().filter(|l| **l == wanted).count() as f64;
        let counts = [count(label::VOID), count(label::PART)];
        if counts[1] == 0.0 {
            return Err(Error::config("target", "no voxel is part", "at least one"));
        }
        let voxel_mm3 = layout.grid.voxel_mm3();
        let requirement_mj = match material.requirement(species) {
            None => None,
            Some(needed) => {
                let start = material.start()?;
                let mut sum = needed.dose * counts[1];
                for (volume, capacity) in needed.inhibitors {
                    let content = start.volumes[volume].as_slice().iter().zip(&labels);
                    let part = content.filter(|(_, l)| **l == label::PART);
                    sum += capacity * part.map(|(v, _)| f64::from(*v)).sum::<f64>();
                }
                Some(sum * voxel_mm3)
            }
        };
        Ok(Curves {
            species,
            labels,
            counts,
            voxel_mm3,
            absorbed: material.domain().zeros(),
            points: Vec::new(),
            requirement_mj,
            cure: None,
            wanted: Vec::new(),
            snapshots: Vec::new(),
        })
    }

    /// Keeps when each voxel gels: two more volumes.
    #[must_use]
    pub fn with_cure_times(mut self, material: &Photopolymer) -> Self {
        let mut never = material.domain().zeros();
        never.fill(f32::INFINITY);
        self.cure = Some(CureTimes {
            before: material.domain().zeros(),
            seconds: never,
        });
        self
    }

    /// Keeps the readout at the first moment at or after each of these times, s.
    #[must_use]
    pub fn with_snapshots(mut self, seconds: &[f64]) -> Self {
        self.wanted = seconds.to_vec();
        self.wanted.sort_by(|a, b| b.total_cmp(a));
        self
    }

    /// Looks at a moment.
    pub fn watch(&mut self, moment: &Moment) {
        let material = moment.material;
        let readout = material.readout(self.species);
        let values = moment.state.volumes[readout.volume].as_slice();
        let row = material.drives().row(self.species);
        add_drive(row, moment.absorbed, &mut self.absorbed);
        self.keep_cure_times(moment, readout, values);
        let point = self.measure(moment.seconds, readout, values);
        self.points.push(point);
        while self
            .wanted
            .last()
            .is_some_and(|at| *at <= moment.seconds + 1e-9)
        {
            self.wanted.pop();
            let mut volume = material.domain().layout().volume_of(values);
            volume.values.iter_mut().for_each(|v| *v *= readout.scale);
            self.snapshots.push((moment.seconds, volume));
        }
    }

    fn keep_cure_times(&mut self, moment: &Moment, readout: Readout, values: &[f32]) {
        let Some(cure) = &mut self.cure else { return };
        let gel = readout.gel / readout.scale;
        let (end, step) = (moment.seconds as f32, moment.block_s as f32);
        let before = cure.before.as_mut_slice().chunks_mut(BLOCK);
        let times = cure.seconds.as_mut_slice().chunks_mut(BLOCK);
        before
            .zip(times)
            .zip(values.chunks(BLOCK))
            .par_each(|((before, times), now)| {
                for ((before, time), &now) in before.iter_mut().zip(times).zip(now) {
                    if now >= gel && *time == f32::INFINITY {
                        let rise = now - *before;
                        let share = if rise > 0.0 { (now - gel) / rise } else { 0.0 };
                        *time = end - step * share.min(1.0);
                    }
                    *before = now;
                }
            });
    }

    fn measure(&self, seconds: f64, readout: Readout, values: &[f32]) -> CurvePoint {
        let gel = readout.gel / readout.scale;
        let (doses, labels) = (self.absorbed.as_slice(), self.labels.as_slice());
        let blocks = doses.chunks(BLOCK).zip(values.chunks(BLOCK));
        let blocks = blocks.zip(labels.chunks(BLOCK));
        let sums: Vec<Sums> =
            blocks.par_map(|((doses, values), labels)| sums_of(doses, values, labels, gel));
        let whole = sums.into_iter().reduce(Sums::and).unwrap_or(Sums::NONE);
        let (least, most) = (f64::from(whole.least), f64::from(whole.most));
        let middle = least + 0.5 * (most - least);
        let [contrast, printed_contrast] = self.contrasts([middle, 0.5 * (most - least)]);
        let [void, part] = whole.gelled.map(|n| n as f64);
        CurvePoint {
            seconds,
            imbued_mj: whole.imbued * self.voxel_mm3,
            contribution_mj: whole.contribution * self.voxel_mm3,
            contrast,
            printed_contrast,
            jaccard: part / (self.counts[1] + void),
            gelled: [part / self.counts[1], void / self.counts[0].max(1.0)],
            dose: [least, most],
        }
    }

    /// (Ē_hi − Ē_lo)/(Ē_hi + Ē_lo) for two splits; NaN where a class is empty.
    fn contrasts(&self, splits: [f64; 2]) -> [f64; 2] {
        let at = splits.map(|s| s as f32);
        let blocks = self.absorbed.as_slice().chunks(BLOCK);
        // Per split: sum and count above, sum and count below
        let sums: Vec<[[f64; 4]; 2]> =
            blocks
                .zip(self.labels.chunks(BLOCK))
                .par_map(|(doses, labels)| {
                    let mut sums = [[0.0; 4]; 2];
                    for (&dose, &label) in doses.iter().zip(labels) {
                        let counted = f64::from(u8::from(label != label::OUTSIDE));
                        for (sums, &at) in sums.iter_mut().zip(&at) {
                            let above = counted * f64::from(u8::from(dose > at));
                            let below = counted * f64::from(u8::from(dose < at));
                            sums[0] += above * f64::from(dose);
                            sums[1] += above;
                            sums[2] += below * f64::from(dose);
                            sums[3] += below;
                        }
                    }
                    sums
                });
        [0, 1].map(|split| {
            let sum = |i: usize| sums.iter().map(|s| s[split][i]).sum::<f64>();
            let (high, low) = (sum(0) / sum(1), sum(2) / sum(3));
            (high - low) / (high + low)
        })
    }

    /// One per moment that was watched.
    #[must_use]
    pub fn points(&self) -> &[CurvePoint] {
        &self.points
    }

    /// The network.
    #[must_use]
    pub fn species(&self) -> usize {
        self.species
    }

    /// The least dose that gels the part, mJ; None where it depends on the power.
    #[must_use]
    pub fn requirement_mj(&self) -> Option<f64> {
        self.requirement_mj
    }

    /// Stored readouts, and their times.
    #[must_use]
    pub fn snapshots(&self) -> &[(f64, Volume<f32>)] {
        &self.snapshots
    }

    /// When each voxel gelled, s (file order); ∞ where it did not. None where the caller does not want it.
    #[must_use]
    pub fn cure_times(&self, material: &Photopolymer) -> Option<Volume<f32>> {
        let cure = self.cure.as_ref()?;
        Some(
            material
                .domain()
                .layout()
                .volume_of(cure.seconds.as_slice()),
        )
    }

    /// The moment at which the Jaccard index is largest, the first of several; None where nothing of the part is ever solid.
    #[must_use]
    pub fn best(&self) -> Option<&CurvePoint> {
        let mut best: Option<&CurvePoint> = None;
        for point in &self.points {
            if best.is_none_or(|b| point.jaccard > b.jaccard) {
                best = Some(point);
            }
        }
        best.filter(|point| point.jaccard > 0.0)
    }

    /// Where the phases end.
    #[must_use]
    pub fn phases(&self) -> Phases {
        let gelled = self.first_gelled_s();
        Phases {
            induction_end_s: gelled,
            curing_end_s: gelled.and(self.best()).map(|p| p.seconds),
        }
    }

    /// When the first voxel gels, s: within a step, where cure times are kept.
    fn first_gelled_s(&self) -> Option<f64> {
        let mut points = self.points.iter();
        let at_end = points.find(|p| p.gelled[0] + p.gelled[1] > 0.0)?.seconds;
        let Some(cure) = &self.cure else {
            return Some(at_end);
        };
        let voxels = cure.seconds.as_slice().iter().zip(&self.labels);
        let counted = voxels.filter(|(_, l)| **l != label::OUTSIDE);
        Some(counted.fold(at_end, |first, (s, _)| first.min(f64::from(*s))))
    }

    /// What the part has absorbed, mJ.
    fn part_mj(&self) -> f64 {
        let voxels = self.absorbed.as_slice().iter().zip(&self.labels);
        let part = voxels.filter(|(_, l)| **l == label::PART);
        self.voxel_mm3 * part.map(|(v, _)| f64::from(*v)).sum::<f64>()
    }

    /// When the contribution meets the requirement.
    #[must_use]
    pub fn ideal_exposure(&self) -> IdealExposure {
        let Some(needed) = self.requirement_mj else {
            return IdealExposure::NoRequirement;
        };
        let reached = |p: &CurvePoint| p.contribution_mj >= needed;
        match self.points.iter().position(reached) {
            None => {
                let contributions = self.points.iter().map(|p| p.contribution_mj);
                let most = contributions.fold(0.0, f64::max);
                let reached = if most > 0.0 { most } else { self.part_mj() };
                IdealExposure::NotReached(reached / needed)
            }
            Some(0) => IdealExposure::At(self.points[0].seconds),
            Some(i) => {
                let [a, b] = [self.points[i - 1], self.points[i]];
                let share = (needed - a.contribution_mj) / (b.contribution_mj - a.contribution_mj);
                let seconds = a.seconds + share * (b.seconds - a.seconds);
                // Nothing contributes before it gels
                IdealExposure::At(seconds.max(self.first_gelled_s().unwrap_or(0.0)))
            }
        }
    }
}

impl Sums {
    const NONE: Sums = Sums {
        imbued: 0.0,
        contribution: 0.0,
        gelled: [0; 2],
        least: f32::INFINITY,
        most: f32::NEG_INFINITY,
    };

    fn and(self, other: Sums) -> Sums {
        Sums {
            imbued: self.imbued + other.imbued,
            contribution: self.contribution + other.contribution,
            gelled: [0, 1].map(|i| self.gelled[i] + other.gelled[i]),
            least: self.least.min(other.least),
            most: self.most.max(other.most),
        }
    }
}

/// sum += the positive part of the drive.
pub(crate) fn add_drive(row: &[f32], absorbed: &[&[f32]], sum: &mut HostField) {
    let lit: Vec<(f32, &[f32])> = row
        .iter()
        .zip(absorbed)
        .filter(|(m, e)| **m != 0.0 && !e.is_empty())
        .map(|(m, e)| (*m, *e))
        .collect();
    let blocks = sum.as_mut_slice().chunks_mut(BLOCK);
    match lit[..] {
        [] => {}
        [(m, energy)] if m > 0.0 => blocks.zip(energy.chunks(BLOCK)).par_each(|(a, e)| {
            a.iter_mut().zip(e).for_each(|(a, e)| *a += m * e);
        }),
        _ => blocks.enumerate().par_each(|(i, block)| {
            for (j, a) in block.iter_mut().enumerate() {
                let at = i * BLOCK + j;
                *a += lit.iter().map(|(m, e)| m * e[at]).sum::<f32>().max(0.0);
            }
        }),
    }
}

fn sums_of(doses: &[f32], values: &[f32], labels: &[u8], gel: f32) -> Sums {
    let mut sums = Sums::NONE;
    for ((&dose, &value), &label) in doses.iter().zip(values).zip(labels) {
        if label == label::OUTSIDE {
            continue;
        }
        let is_gelled = value >= gel;
        sums.imbued += f64::from(dose);
        sums.contribution += if is_gelled { f64::from(dose) } else { 0.0 };
        sums.gelled[usize::from(label == label::PART)] += u64::from(is_gelled);
        sums.least = sums.least.min(dose);
        sums.most = sums.most.max(dose);
    }
    sums
}

#[cfg(test)]
mod tests;
