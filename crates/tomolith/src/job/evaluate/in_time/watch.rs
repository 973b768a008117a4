//! What is looked at while a network cures: its curves, its best moment, a slice of each moment.

use crate::error::Result;
use crate::field::{Field, HostField};
use crate::grid::{Patterns, Volume};
use crate::job::evaluate::in_time::NetworkInTime;
use crate::job::evaluate::measure_at;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::report::TimeReport;
use crate::target::label;
use tomolith_material::curves::Curves;
use tomolith_material::photopolymer::Photopolymer;
use tomolith_material::print::Moment;

/// Slices of a movie: at least so many, and less than twice as many, of a print with so many moments.
const SLICES: usize = 240;
/// Level of resin that is about to become solid; that of solid resin is 255.
const LIQUID: f32 = 190.0;

/// The curves of a network, and its state at the best moment so far.
pub(crate) struct Watched {
    pub(crate) curves: Curves,
    pub(crate) best: f64,
    pub(crate) readout: HostField,
    /// The middle slice at moments that are equally many apart.
    pub(crate) slices: Vec<Vec<u16>>,
    /// How many moments apart they are, and how many there were.
    stride: usize,
    moments: usize,
    pub(crate) middle: usize,
}

impl Watched {
    pub(crate) fn new(
        material: &Photopolymer,
        s: usize,
        voxels: &Voxels,
        times: &[f64],
    ) -> Result<Self> {
        let curves = Curves::new(material, s, &voxels.labels)?
            .with_cure_times(material)
            .with_snapshots(times);
        Ok(Watched {
            curves,
            best: 0.0,
            readout: material.domain().zeros(),
            slices: Vec::new(),
            stride: 1,
            moments: 0,
            middle: middle_of(&voxels.labels),
        })
    }

    pub(crate) fn look(&mut self, moment: &Moment) {
        self.curves.watch(moment);
        if self.moments.is_multiple_of(self.stride) {
            self.slices.push(self.slice(moment));
        }
        self.moments += 1;
        if self.slices.len() == 2 * SLICES {
            let mut is_kept = [false, true].into_iter().cycle();
            self.slices.retain(|_| is_kept.next() == Some(false));
            self.stride *= 2;
        }
        let jaccard = self.curves.points().last().map_or(0.0, |p| p.jaccard);
        if jaccard > self.best {
            self.best = jaccard;
            let readout = moment.material.readout(self.curves.species());
            self.readout
                .copy_from(&moment.state.volumes[readout.volume]);
        }
    }

    /// The middle slice, row 0 = +y.
    fn slice(&self, moment: &Moment) -> Vec<u16> {
        let readout = moment.material.readout(self.curves.species());
        let values = moment.state.volumes[readout.volume].as_slice();
        let layout = moment.material.domain().layout();
        let [_, ny, nx] = layout.grid.shape;
        let level = |i: usize| {
            let (row, column) = (i / nx, i % nx);
            let degree = readout.scale * values[layout.index(self.middle, ny - 1 - row, column)];
            match degree >= readout.gel {
                true => 255,
                false => (LIQUID * (degree / readout.gel).clamp(0.0, 1.0)) as u16,
            }
        };
        (0..nx * ny).map(level).collect()
    }

    pub(crate) fn finish(
        self,
        material: &Photopolymer,
        name: String,
        sent_mj: Vec<f64>,
        job: &ResolvedJob,
        voxels: &Voxels,
        patterns: &[Patterns],
    ) -> Result<NetworkInTime> {
        let Watched {
            curves,
            best,
            mut readout,
            slices,
            ..
        } = self;
        let of_material = material.readout(curves.species());
        readout.scale(of_material.scale);
        let mut snapshots = curves.snapshots().to_vec();
        let evaluation = match curves.phases().curing_end_s {
            Some(seconds) if best > 0.0 => {
                let degree = material.domain().layout().volume_of(readout.as_slice());
                let gel = f64::from(of_material.gel);
                let evaluation = measure_at(job, voxels, &degree, gel, patterns)?;
                with_moment(&mut snapshots, seconds, degree);
                Some(evaluation)
            }
            _ => None,
        };
        let no_time = || Volume::filled(job.grid.clone(), f32::INFINITY);
        Ok(NetworkInTime {
            report: TimeReport {
                name,
                points: curves.points().to_vec(),
                sent_mj,
                requirement_mj: curves.requirement_mj(),
                ideal: curves.ideal_exposure(),
                phases: curves.phases(),
                evaluation,
                cure_times: curves.cure_times(material).unwrap_or_else(no_time),
                snapshots,
            },
            labels: voxels.labels.clone(),
            slices,
        })
    }
}

/// Puts a moment among others, unless one of them is it.
fn with_moment(snapshots: &mut Vec<(f64, Volume<f32>)>, seconds: f64, degree: Volume<f32>) {
    let at = snapshots.partition_point(|(before, _)| *before < seconds);
    if snapshots.get(at).is_none_or(|(next, _)| *next > seconds) {
        snapshots.insert(at, (seconds, degree));
    }
}

/// The height in the middle of what is part.
fn middle_of(labels: &Volume<u8>) -> usize {
    let [nz, ny, nx] = labels.grid.shape;
    let is_part =
        |iz: &usize| labels.values[iz * ny * nx..(iz + 1) * ny * nx].contains(&label::PART);
    let first = (0..nz).find(is_part);
    let last = (0..nz).rfind(is_part);
    first
        .zip(last)
        .map_or(nz / 2, |(a, b)| usize::midpoint(a, b))
}
