use super::*;
use crate::curves::Curves;
use crate::fixtures::{domain_of, network, oxygen, refused};
use crate::mixing::Mixing;
use crate::photopolymer::{Params, Photopolymer, Shading};
use crate::schedule::{Power, Turns};
use std::ops::Range;
use tomolith_core::dose::{
    DoseLayout, DoseModel, Facts, PatternLayout, Quantity, Space, ZCoupling,
};
use tomolith_core::grid::{PatternGrid, Volume, VolumeGrid};
use tomolith_core::near;
use tomolith_core::target::label;

const N: usize = 16;
const PITCH: f64 = 0.25;
const MU: f64 = 0.2;

/// Light from four sides along rows of voxels, exactly by Beer and Lambert in resin that may be uneven.
struct Cross {
    patterns: [PatternLayout; 1],
    outputs: [DoseLayout; 1],
    active: Vec<f32>,
    total: Vec<f32>,
}

impl Cross {
    fn new(active: Vec<f32>, total: Vec<f32>) -> Self {
        let pixels = PatternGrid::full_turn(4, 0.0, 1, N, PITCH);
        let runs = vec![(0, 1); 4 * N];
        let grid = VolumeGrid::centered([1, N, N], PITCH);
        Cross {
            patterns: [PatternLayout::new(pixels, Quantity::Energy, 0, &runs)],
            outputs: [DoseLayout::new("dose", grid, 0)],
            active,
            total,
        }
    }

    fn even() -> Self {
        Cross::new(vec![MU as f32; N * N], vec![MU as f32; N * N])
    }

    /// Weights of the voxels that a pixel lights, from where it enters.
    fn ray(&self, frame: usize, column: usize) -> Vec<(usize, f64)> {
        let mut power = 1.0;
        let voxel = |i: usize| match frame {
            0 => column * N + N - 1 - i,
            1 => (N - 1 - i) * N + N - 1 - column,
            2 => (N - 1 - column) * N + i,
            _ => i * N + column,
        };
        let weight = |i: usize| {
            let at = voxel(i);
            let (active, total) = (f64::from(self.active[at]), f64::from(self.total[at]));
            let lost = -(-total * PITCH).exp_m1();
            let dose = power * lost * active / total / PITCH;
            power *= 1.0 - lost;
            (at, dose)
        };
        (0..N).map(weight).collect()
    }
}

impl DoseModel for Cross {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.patterns,
            outputs: &self.outputs,
            z_coupling: ZCoupling::None,
            is_linear: true,
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        _: &Work,
    ) -> Result<()> {
        for pixel in frames.start * N..frames.end * N {
            for (voxel, weight) in self.ray(pixel / N, pixel % N) {
                dose.as_mut_slice()[voxel] += weight as f32 * x.as_slice()[pixel];
            }
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        _x: &HostField,
        c: &HostField,
        grad: &mut HostField,
        _: &Work,
    ) -> Result<()> {
        for pixel in frames.start * N..frames.end * N {
            let ray = self.ray(pixel / N, pixel % N).into_iter();
            let sum = ray
                .map(|(v, w)| w * f64::from(c.as_slice()[v]))
                .sum::<f64>();
            grad.as_mut_slice()[pixel] = sum as f32;
        }
        Ok(())
    }

    fn updates(&self) -> u64 {
        (4 * N * N) as u64
    }

    fn describe(&self) -> String {
        "light from four sides".to_owned()
    }
}

/// A network with oxygen that gels at 0.2 + 0.1 mJ/mm³, and absorbs `cured` times as much then.
fn material(cured: f64, diffusion: f64) -> Photopolymer {
    let network = network(vec![oxygen(0.1, diffusion)], 0.2);
    let both = [MU, cured * MU];
    let shading = Shading {
        light: 0,
        network: 0,
        active_per_mm: both,
        attenuation_per_mm: both,
    };
    let params = Params::new(vec![network]).shaded(shading);
    let domain = domain_of(&Cross::even());
    Photopolymer::new(params, Mixing::identity(1), domain).unwrap()
}

fn schedule(irradiance: f64) -> Schedule {
    let turns = Turns {
        power: Power::Irradiance(irradiance),
        ..Turns::new(4, 8.0, 10.0)
    };
    Schedule::of_turns(&[turns]).unwrap()
}

/// One pixel from the side of frame 0: the dose along its row, what it imbued, and how many models were made.
fn along_a_row(cured: f64, irradiance: f64) -> (Vec<f32>, Vec<f64>, usize) {
    let (first, material, schedule) = (Cross::even(), material(cured, 0.0), schedule(irradiance));
    let mut x = first.new_patterns().unwrap();
    x.as_mut_slice()[5] = 1.0;
    let labels = Volume::filled(VolumeGrid::centered([1, N, N], PITCH), label::PART);
    let mut curves = Curves::new(&material, 0, &labels).unwrap();
    let mut made = 0;
    let mut renew = |light: usize, now: &Absorption| -> Result<Box<Model>> {
        assert_eq!(light, 0);
        made += 1;
        let [active, total] = [&now.active_per_mm, &now.attenuation_per_mm];
        Ok(Box::new(Cross::new(
            active.values.clone(),
            total.values.clone(),
        )))
    };
    let light = LightSource::new(&first, &x);
    let print = PrintRun::new(&material, &schedule, vec![light]).unwrap();
    let mut print = print
        .with_step_s(2.0)
        .unwrap()
        .with_renewal(2.0, &mut renew);
    let mut watch = |moment: &Moment| {
        curves.watch(moment);
        ControlFlow::Continue(())
    };
    let state = print.run(&Work::new(), &mut watch).unwrap();
    drop(print);
    let dose = &state.volumes[material.readout(0).volume].as_slice()[5 * N..6 * N];
    let imbued = curves.points().iter().map(|p| p.imbued_mj).collect();
    (dose.iter().rev().copied().collect(), imbued, made)
}

#[test]
fn cured_resin_shades_what_lies_behind_it_and_nothing_does_before() {
    let (plain, even, _) = along_a_row(1.0, 0.05);
    let (shaded, imbued, made) = along_a_row(4.0, 0.05);
    // Before every block but the first: all frames are shown, three of four with dark patterns
    assert_eq!(made, 39);
    // 0.05·2 mJ/mm², of which μ(1 − e^(−μh))/(μh) = 0.1951 per mm in the first voxel: 0.0195 a turn, gel after 15: not within ten
    let first = 0.1 * (-(-MU * PITCH).exp_m1()) / PITCH * 10.0;
    near!(f64::from(plain[0]), first - 0.1, 1e-6, "{}", plain[0]);
    assert_eq!(even, imbued);
    assert_eq!(plain, shaded);
    // Ten times the light: the first voxels cure within two turns, take more, and leave less
    let (plain, even, _) = along_a_row(1.0, 0.5);
    let (shaded, imbued, _) = along_a_row(4.0, 0.5);
    assert!(shaded[0] > 1.5 * plain[0] && shaded[N - 1] < 0.8 * plain[N - 1]);
    assert_eq!(even[1], imbued[1]);
    assert!(imbued[imbued.len() - 1] > 1.2 * even[even.len() - 1]);
}

#[test]
fn a_step_that_is_not_stable_is_refused_by_its_limit_and_others_end_early() {
    let (model, material, schedule) = (Cross::even(), material(1.0, 0.01), schedule(0.5));
    let x = model.new_patterns().unwrap();
    let light = LightSource::new(&model, &x);
    let print = || PrintRun::new(&material, &schedule, vec![light]).unwrap();
    // Four faces in a plane: h²/(4D) = 1.5625 s
    let [key, accepted] = refused(print().with_step_s(1.6));
    assert_eq!(key, "step_s");
    tomolith_core::contains!(accepted, "1.5625 s");
    let mut seen = Vec::new();
    let mut watch = |moment: &Moment| {
        seen.push((moment.seconds, moment.absorbed[0].is_empty()));
        if moment.steps[0] == 2 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    let mut print = print().with_step_s(1.0).unwrap();
    print.run(&Work::new(), &mut watch).unwrap();
    assert_eq!(seen, [(0.0, true), (1.0, false), (2.0, false)]);
    let work = Work::new();
    work.cancel();
    let stopped = print.run(&work, &mut |_| ControlFlow::Continue(()));
    assert!(matches!(stopped, Err(Error::Canceled)));
}

#[test]
fn a_renewed_model_of_other_voxels_is_refused() {
    let (model, material, schedule) = (Cross::even(), material(2.0, 0.0), schedule(0.5));
    let x = model.new_patterns().unwrap();
    let light = LightSource::new(&model, &x);
    let mut renew = |_: usize, _: &Absorption| -> Result<Box<Model>> {
        Ok(Box::new(tomolith_core::check::small::SmallModel::new(
            N, 4, 1,
        )))
    };
    let print = PrintRun::new(&material, &schedule, vec![light]).unwrap();
    let mut print = print.with_renewal(1.0, &mut renew);
    let refused = print.run(&Work::new(), &mut |_| ControlFlow::Continue(()));
    assert!(matches!(refused, Err(Error::Unsupported { .. })));
}
