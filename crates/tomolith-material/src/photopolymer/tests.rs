use super::*;
use crate::fixtures::{apart, network, oxygen, photopolymer, refused};
use crate::mixing::Mixing;
use tomolith_core::check::noise;
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::near;

fn threshold(inhibitors: Vec<Inhibitor>, dose: f64) -> Params {
    Params::new(vec![network(inhibitors, dose)])
}

fn domain(shape: [usize; 3]) -> Domain {
    Domain::new(VolumeGrid::centered(shape, 0.05))
}

fn build(params: Params, shape: [usize; 3]) -> Photopolymer {
    let lights = Mixing::identity(params.networks.len());
    Photopolymer::new(params, lights, domain(shape)).unwrap()
}

fn by_rate(name: &str, rate_per_s: f64, exponent: f64, gel_conversion: f64) -> Network {
    Network::new(
        name,
        Curing::RateLaw {
            rate_per_s,
            exponent,
            gel_conversion,
        },
    )
}

/// Noise on the voxels, 0 in the padding.
fn noise_on(domain: &Domain, seed: u64, [low, high]: [f32; 2]) -> HostField {
    let grid = domain.grid().clone();
    let scale = |v: f32| low + (high - low) * (v + 1.0) / 2.0;
    let values = noise(seed, grid.len()).into_iter().map(scale).collect();
    let mut field = HostField::from_slice(&domain.layout().field_of(&Volume { grid, values }));
    domain.only_resin(&mut field);
    field
}

#[test]
fn an_even_dose_gels_when_oxygen_and_threshold_are_paid() {
    // Two inhibitors, 1.5·0.8 and 0.5·1 mJ/mm³, then 2 mJ/mm³: 3.7 in all
    let first = Inhibitor {
        initial: Initial::Even(0.8),
        ..oxygen(1.5, 0.0)
    };
    let material = build(threshold(vec![first, oxygen(0.5, 0.0)], 2.0), [1, 1, 1]);
    assert_eq!(
        material.volumes(),
        ["acrylate.oxygen", "acrylate.oxygen", "acrylate.dose"]
    );
    for steps in [1, 7, 100] {
        let mut state = material.start().unwrap();
        for _ in 0..steps {
            let energy = [3.7 / steps as f32];
            material.step(&mut state, &[&energy], 0.3).unwrap();
        }
        let degree = material.readout(0).scale * state.volumes[2].as_slice()[0];
        assert!((degree - 1.0).abs() < 1e-5, "{steps}: {degree}");
        assert!(state.volumes[0].as_slice()[0].abs() < 1e-6);
    }
    let needed = material.requirement(0).unwrap();
    assert_eq!(
        (needed.dose, needed.inhibitors),
        (2.0, vec![(0, 1.5), (1, 0.5)])
    );
}

#[test]
fn a_step_is_the_printed_balance_of_a_voxel() {
    // O ← max(0, O + Δt(Σ D(O_j − O_i)/h² − κr)), and the drive left over
    let material = build(threshold(vec![oxygen(2.0, 1e-4)], 1.0), [1, 1, 5]);
    let mut state = material.start().unwrap();
    let o = [0.9f32, 0.1, 0.5, 0.0, 1.0];
    let light = [0.3f32, 0.8, 0.0, 0.4, 2.5];
    state.volumes[0].copy_from_host(&o);
    let seconds = 2.0;
    material.step(&mut state, &[&light], seconds).unwrap();
    for i in 0..5usize {
        let neighbors = [i.checked_sub(1), Some(i + 1).filter(|j| *j < 5)];
        let flux: f64 = neighbors
            .into_iter()
            .flatten()
            .map(|j| f64::from(o[j] - o[i]))
            .sum();
        let supplied = f64::from(o[i]) + seconds * 1e-4 * flux / (0.05 * 0.05);
        let after = (supplied - f64::from(light[i]) / 2.0).max(0.0);
        let left = f64::from(light[i]) - (supplied - after) * 2.0;
        assert!((f64::from(state.volumes[0].as_slice()[i]) - after).abs() < 1e-6);
        assert!((f64::from(state.volumes[1].as_slice()[i]) - left).abs() < 1e-6);
    }
}

#[test]
fn what_cannot_be_is_named_by_its_key() {
    let one = |network: Network| {
        let params = Params::new(vec![network]);
        Photopolymer::new(params, Mixing::identity(1), domain([2; 3]))
    };
    let plain = || network(Vec::new(), 1.0);
    let with = |inhibitor: Inhibitor| network(vec![oxygen(1.0, 0.0), inhibitor], 1.0);
    let rate = |exponent: f64| by_rate("a", 1.0, exponent, 0.2);
    for (network, key) in [
        (
            network(Vec::new(), 0.0),
            "curing.threshold.critical_dose_mj_per_mm3",
        ),
        (rate(0.4), "curing.rate_law.exponent"),
        (
            Network {
                dose_diffusion_mm2_per_s: 1e-4,
                ..rate(0.5)
            },
            "dose_diffusion_mm2_per_s",
        ),
        (with(oxygen(-1.0, 0.0)), "inhibitors[1].capacity_mj_per_mm3"),
        (
            with(oxygen(1.0, f64::NAN)),
            "inhibitors[1].diffusion_mm2_per_s",
        ),
        (
            with(Inhibitor {
                initial: Initial::Even(1.1),
                ..oxygen(1.0, 0.0)
            }),
            "inhibitors[1].initial",
        ),
        (
            with(Inhibitor {
                initial: Initial::Axial(vec![[1.0, 0.2], [0.0, 0.3]]),
                ..oxygen(1.0, 0.0)
            }),
            "inhibitors[1].initial",
        ),
        (
            with(Inhibitor {
                half_saturation: Some(0.0),
                ..oxygen(1.0, 0.0)
            }),
            "inhibitors[1].half_saturation",
        ),
    ] {
        assert_eq!(refused(one(network))[0], format!("networks[0].{key}"));
    }
    let [_, accepted] = refused(one(network(vec![oxygen(1.0, -1.0)], 1.0)));
    assert_eq!(accepted, "a number in mm²/s, 0 or more");
    let shading = Shading {
        light: 1,
        network: 0,
        active_per_mm: [0.1, 0.2],
        attenuation_per_mm: [0.1, 0.2],
    };
    let shaded = |shading: Shading| {
        let params = Params::new(vec![plain()]).shaded(shading);
        let [key, _] = refused(Photopolymer::new(
            params,
            Mixing::identity(1),
            domain([2; 3]),
        ));
        key
    };
    assert_eq!(shaded(shading), "shading[0].light");
    let below = Shading {
        light: 0,
        attenuation_per_mm: [0.1, 0.1],
        ..shading
    };
    assert_eq!(shaded(below), "shading[0].attenuation_per_mm");
    // One light of a bleaching network shaded, the other not
    let bleached = Network {
        bleaching_mm3_per_mj: 1.0,
        ..plain()
    };
    let shading = Shading {
        light: 0,
        ..shading
    };
    let params = Params::new(vec![bleached]).shaded(shading);
    let both = Mixing::new(vec![vec![1.0, 0.5]]).unwrap();
    let [key, _] = refused(Photopolymer::new(params, both, domain([2; 3])));
    assert_eq!(key, "shading");
    // Modes know no air
    let spectral = threshold(vec![oxygen(1.0, 1e-4)], 1.0).diffusing_by(Scheme::Spectral);
    let domain = domain([4; 3]).with_air_on_top();
    let [key, accepted] = refused(Photopolymer::new(spectral, Mixing::identity(1), domain));
    assert!(
        key == "diffusion" && accepted.contains("faces"),
        "{accepted}"
    );
}

#[test]
fn a_step_above_the_limit_is_refused_and_the_limit_named() {
    let material = build(threshold(vec![oxygen(1.0, 1e-4)], 1.0), [4, 4, 4]);
    let limit = 0.05 * 0.05 / 6e-4;
    assert!((material.longest_step_s() - limit).abs() < 1e-9);
    let mut state = material.start().unwrap();
    let [key, accepted] = refused(material.step(&mut state, &[&[]], 1.01 * limit));
    assert_eq!(key, "step_s");
    tomolith_core::contains!(accepted, "4.1666 s");
}

#[test]
fn oxygen_may_change_along_the_axis_and_walls_hold_none() {
    let axial = Inhibitor {
        initial: Initial::Axial(vec![[-0.05, 0.2], [0.05, 0.8]]),
        ..oxygen(1.0, 0.0)
    };
    let grid = VolumeGrid::centered([5, 1, 2], 0.05);
    let mut resin = Volume::filled(grid.clone(), true);
    resin.values[3] = false;
    let domain = Domain::new(grid).with_walls(&resin).unwrap();
    let material = photopolymer(network(vec![axial], 1.0), domain);
    let state = material.start().unwrap();
    let volume = material
        .domain()
        .layout()
        .volume_of(state.volumes[0].as_slice());
    let expected = [0.2, 0.2, 0.2, 0.0, 0.5, 0.5, 0.8, 0.8, 0.8, 0.8];
    for (found, expected) in volume.values.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-6, "{:?}", volume.values);
    }
}

#[test]
fn strang_splitting_converges_with_the_square_of_the_step() {
    let smooth = Inhibitor {
        half_saturation: Some(0.2),
        ..oxygen(1.0, 1e-3)
    };
    let params = threshold(vec![smooth], 1.0).diffusing_by(Scheme::Spectral);
    let material = build(params, [1, 1, 32]);
    let light: Vec<f32> = (0..32).map(|i| if i < 12 { 0.9 } else { 0.05 }).collect();
    let dose = |steps: usize| {
        let mut state = material.start().unwrap();
        let energy: Vec<f32> = light.iter().map(|l| 2.0 * l / steps as f32).collect();
        for _ in 0..steps {
            material
                .step(&mut state, &[&energy], 8.0 / steps as f64)
                .unwrap();
        }
        state.volumes[1].clone()
    };
    let best = dose(512);
    let error = |steps: usize| apart(&best, &dose(steps));
    let errors = [4, 8, 16].map(error);
    assert!(
        errors[0] / errors[1] > 3.2 && errors[1] / errors[2] > 3.2,
        "{errors:?}"
    );
}

#[test]
fn both_schemes_agree_where_both_are_exact_enough() {
    let values_of = |scheme: Scheme| {
        let params = threshold(vec![oxygen(1.0, 1e-4)], 1.0).diffusing_by(scheme);
        let material = build(params, [6, 12, 10]);
        let mut state = material.start().unwrap();
        let layout = material.domain().layout();
        let grid = material.domain().grid();
        let light = layout.field_of(&Volume::from_fn(grid.clone(), |middle| {
            let r2: f64 = middle.iter().map(|v| v * v).sum();
            (0.04 * (-r2 / 0.03).exp()) as f32
        }));
        for _ in 0..60 {
            material.step(&mut state, &[&light], 0.5).unwrap();
        }
        state
    };
    let (faces, spectral) = (values_of(Scheme::Faces), values_of(Scheme::Spectral));
    // Of 1 and of about 1.4 mJ/mm³, by voxels and by splitting
    for (volume, tolerance) in [(0, 0.02), (1, 0.03)] {
        let off = apart(&faces.volumes[volume], &spectral.volumes[volume]);
        assert!(off < tolerance, "volume {volume}: {off}");
    }
}

#[test]
fn cured_resin_that_lets_nothing_through_is_a_wall() {
    let stopped = Inhibitor {
        cured_diffusion: 0.0,
        ..oxygen(1.0, 1e-4)
    };
    let material = build(threshold(vec![stopped], 1.0), [1, 1, 5]);
    let mut state = material.start().unwrap();
    state.volumes[0].copy_from_host(&[1.0, 0.5, 0.0, 0.0, 0.0]);
    state.volumes[1].copy_from_host(&[0.0, 0.0, 2.0, 0.0, 0.0]);
    for _ in 0..200 {
        material.step(&mut state, &[&[]], 4.0).unwrap();
    }
    let o = state.volumes[0].as_slice();
    assert!((o[0] - 0.75).abs() < 1e-5 && (o[1] - 0.75).abs() < 1e-5);
    assert_eq!(o[2..], [0.0; 3]);
}

#[test]
fn bleached_light_is_the_same_whether_its_model_was_renewed_or_not() {
    let network = Network {
        bleaching_mm3_per_mj: 0.5,
        ..network(Vec::new(), 1.0)
    };
    let shading = Shading {
        light: 0,
        network: 0,
        active_per_mm: [0.2, 0.2],
        attenuation_per_mm: [0.3, 0.3],
    };
    let params = Params::new(vec![network]).shaded(shading);
    let material = build(params, [1, 1, 1]);
    // ∫P dq = (1 − e^(−bQ))/b
    let exact = (1.0 - (-0.5f64 * 3.0).exp()) / 0.5;
    let mut plain = material.start().unwrap();
    material.step(&mut plain, &[&[3.0]], 1.0).unwrap();
    assert!((f64::from(plain.volumes[2].as_slice()[0]) - exact).abs() < 1e-6);
    // Renewed after a third: the model's own absorption falls with the initiator
    let mut state = material.start().unwrap();
    material.step(&mut state, &[&[1.0]], 1.0).unwrap();
    let map = material.absorption(&state, 0).unwrap();
    let left = (-0.5f32).exp();
    assert!((map.active_per_mm.values[0] - 0.2 * left).abs() < 1e-6);
    assert!((map.attenuation_per_mm.values[0] - (0.1 + 0.2 * left)).abs() < 1e-6);
    material.light_was_renewed(&mut state, 0);
    material.step(&mut state, &[&[2.0 * left]], 1.0).unwrap();
    assert!((f64::from(state.volumes[2].as_slice()[0]) - exact).abs() < 1e-6);
}

#[test]
fn absorption_follows_the_cured_share() {
    let shading = Shading {
        light: 0,
        network: 0,
        active_per_mm: [0.1, 0.4],
        attenuation_per_mm: [0.2, 0.6],
    };
    let params = threshold(Vec::new(), 2.0).shaded(shading);
    let material = build(params, [1, 1, 4]);
    let mut state = material.start().unwrap();
    assert!(material.absorption(&state, 1).is_none());
    // w = 0.1: from 1.9 to 2.1 mJ/mm³
    state.volumes[0].copy_from_host(&[1.89, 2.0, 2.11, 0.0]);
    let map = material.absorption(&state, 0).unwrap();
    for (found, expected) in map.active_per_mm.values.iter().zip([0.1, 0.25, 0.4, 0.1]) {
        assert!((found - expected).abs() < 1e-5, "{map:?}");
    }
    assert!((map.attenuation_per_mm.values[1] - 0.4).abs() < 1e-5);
}

/// All there is: two networks, an antagonist, bleaching, inhibitors of both kinds, D that falls, walls and air, a rate law.
fn everything(scheme: Scheme) -> Photopolymer {
    let is_faces = scheme == Scheme::Faces;
    let smooth = Inhibitor {
        half_saturation: Some(0.05),
        cured_diffusion: if is_faces { 0.1 } else { 1.0 },
        ..oxygen(0.8, 2e-4)
    };
    let tempo = Inhibitor {
        name: "tempo".to_owned(),
        half_saturation: Some(0.1),
        from_air: false,
        ..oxygen(0.5, 1e-4)
    };
    let first = Network {
        inhibitors: vec![smooth, tempo],
        bleaching_mm3_per_mj: 0.2,
        gel_width: 1.0,
        ..by_rate("acrylate", 0.6, 0.5, 0.3)
    };
    let second = Network {
        dose_diffusion_mm2_per_s: 5e-5,
        name: "epoxy".to_owned(),
        inhibitors: vec![Inhibitor {
            half_saturation: Some(0.3),
            ..oxygen(0.2, 0.0)
        }],
        ..network(Vec::new(), 1.5)
    };
    let mixing = Mixing::new(vec![vec![1.0, 0.3], vec![-0.1, 0.8]]).unwrap();
    let grid = VolumeGrid::centered([6, 5, 7], 0.05);
    let mut domain = Domain::new(grid.clone());
    if is_faces {
        let mut resin = Volume::filled(grid, true);
        for i in [0, 7, 40, 100, 209] {
            resin.values[i] = false;
        }
        domain = domain.with_walls(&resin).unwrap().with_air_on_top();
    }
    let params = Params::new(vec![first, second]).diffusing_by(scheme);
    Photopolymer::new(params, mixing, domain).unwrap()
}

/// A state in the middle of a print, and the light of a block.
fn middle(material: &Photopolymer) -> (State, [HostField; 2]) {
    let domain = material.domain();
    let mut state = material.start().unwrap();
    for (i, volume) in state.volumes.iter_mut().enumerate() {
        *volume = noise_on(domain, 20 + i as u64, [0.1, 0.6]);
    }
    let lights = [(1, [0.3, 1.5]), (2, [0.2, 1.0])];
    (
        state,
        lights.map(|(seed, range)| noise_on(domain, seed, range)),
    )
}

#[test]
fn the_pullback_of_a_step_is_the_transpose_of_its_derivative() {
    for scheme in [Scheme::Faces, Scheme::Spectral] {
        let material = everything(scheme);
        let domain = material.domain();
        let (state, lights) = middle(&material);
        let signed = |seed| noise_on(domain, seed, [-1.0, 1.0]);
        let each = 0..state.volumes.len() as u64;
        let [c, d] =
            [50, 80].map(|from| each.clone().map(|i| signed(from + i)).collect::<Vec<_>>());
        let of_light = [91, 92].map(signed);
        // L of the bleached initiator is a constant of the step
        let fixed = material.chains[0].initiator.unwrap()[1];
        let value = |e: f32| {
            let mut state = state.clone();
            for (i, (volume, d)) in state.volumes.iter_mut().zip(&d).enumerate() {
                if i != fixed {
                    volume.axpy(e, d);
                }
            }
            let mut lights = lights.clone();
            lights
                .iter_mut()
                .zip(&of_light)
                .for_each(|(l, d)| l.axpy(e, d));
            let views = [lights[0].as_slice(), lights[1].as_slice()];
            material.step(&mut state, &views, 1.0).unwrap();
            let pairs = state.volumes.iter().zip(&c);
            pairs.map(|(v, c)| v.dot(c)).sum::<f64>()
        };
        let mut back = State {
            seconds: 0.0,
            volumes: c.clone(),
        };
        let mut grad = [domain.zeros(), domain.zeros()];
        let views = [lights[0].as_slice(), lights[1].as_slice()];
        material
            .pullback_step(&state, &views, 1.0, &mut back, &mut grad)
            .unwrap();
        let by_state: f64 = (0..c.len())
            .filter(|i| *i != fixed)
            .map(|i| back.volumes[i].dot(&d[i]))
            .sum();
        let by_light: f64 = (0..2).map(|l| grad[l].dot(&of_light[l])).sum();
        let exact = by_state + by_light;
        assert!(
            by_state.abs() > 0.1 && by_light.abs() > 0.1,
            "{by_state} {by_light}"
        );
        // The remainder of a central difference falls with h²
        let error =
            |h: f32| ((value(h) - value(-h)) / f64::from(2.0 * h) - exact).abs() / exact.abs();
        let errors = [8e-3, 4e-3].map(error);
        assert!(errors[1] < 1e-3, "{scheme:?}: {errors:?}");
    }
}

#[test]
fn zeroth_order_and_dose_are_transposed_too() {
    let params = threshold(vec![oxygen(1.0, 1e-4)], 1.0);
    let material = build(params, [4, 4, 4]);
    let domain = material.domain();
    let mut state = material.start().unwrap();
    state.volumes[0] = noise_on(domain, 3, [0.0, 0.8]);
    let light = noise_on(domain, 4, [0.0, 1.0]);
    let [a, b, d] = [5, 6, 7].map(|seed| noise_on(domain, seed, [-1.0, 1.0]));
    let c = [a, b];
    let value = |e: f32| {
        let (mut state, mut light) = (state.clone(), light.clone());
        light.axpy(e, &d);
        state.volumes[0].axpy(-e, &d);
        material.step(&mut state, &[light.as_slice()], 1.0).unwrap();
        state.volumes[0].dot(&c[0]) + state.volumes[1].dot(&c[1])
    };
    let mut back = State {
        seconds: 0.0,
        volumes: c.to_vec(),
    };
    let mut grad = [domain.zeros()];
    material
        .pullback_step(&state, &[light.as_slice()], 1.0, &mut back, &mut grad)
        .unwrap();
    let exact = grad[0].dot(&d) - back.volumes[0].dot(&d);
    let difference = (value(1e-4) - value(-1e-4)) / 2e-4;
    near!(difference / exact, 1.0, 1e-2, "{difference} {exact}");
}

#[test]
fn the_same_bits_on_any_number_of_threads() {
    for scheme in [Scheme::Faces, Scheme::Spectral] {
        let material = everything(scheme);
        let (state, lights) = middle(&material);
        let views = [lights[0].as_slice(), lights[1].as_slice()];
        let state_on = |threads: usize| {
            tomolith_core::check::on_threads(threads, || {
                let mut after = state.clone();
                for _ in 0..3 {
                    material.step(&mut after, &views, 1.0).unwrap();
                }
                let mut back = after.clone();
                let mut grad = lights.clone();
                material
                    .pullback_step(&after, &views, 1.0, &mut back, &mut grad)
                    .unwrap();
                let all = after.volumes.iter().chain(&back.volumes).chain(&grad);
                let bits = all.flat_map(|v| v.as_slice().iter().map(|v| v.to_bits()));
                bits.collect::<Vec<u32>>()
            })
        };
        let one = state_on(1);
        assert!(one == state_on(2) && one == state_on(8));
    }
}

/// Balls of one gray value each: irradiance at it (mW/cm²) and when they appear (s). Wang et al. 2022, supplement, Table 1 and Note 1.
const BALLS_UV: [[f64; 2]; 6] = [
    [32.53, 360.0],
    [29.40, 365.0],
    [26.27, 365.0],
    [22.89, 390.0],
    [19.28, 450.0],
    [16.39, 570.0],
];
const BALLS_VISIBLE: [[f64; 2]; 5] = [
    [4.62, 1260.0],
    [4.53, 1260.0],
    [4.43, 1260.0],
    [4.15, 1300.0],
    [3.11, 1740.0],
];

/// Largest |ln(found/measured)| of the gel times of a voxel that oxygen flows back to.
///
/// Fitted per light: inhibitor (mW s/cm²), how fast it flows back (1/s), bleaching (cm²/(mW s)), rate (cm²/mW)^m/s, m.
fn misfit(balls: &[[f64; 2]], [inhibitor, back, bleaching, rate, m]: [f64; 5]) -> f64 {
    // 1 mW/cm² in resin that absorbs 0.1/mm is 10⁻³ mW/mm³; at 1 − 1/e the exponent of the rate law is 1
    let unit = 1e-3;
    let h = 0.05f64;
    let network = Network {
        inhibitors: vec![oxygen(inhibitor * unit, back * h * h / 2.0)],
        bleaching_mm3_per_mj: bleaching / unit,
        ..by_rate("balls", rate * unit.powf(-m), m, 1.0 - (-1.0f64).exp())
    };
    let domain = Domain::new(VolumeGrid::centered([1, 1, 1], h)).with_air_on_top();
    let material = photopolymer(network, domain);
    let readout = material.readout(0);
    let of_ball = |&[irradiance, measured]: &[f64; 2]| {
        let mut state = material.start().unwrap();
        let energy = [(irradiance * unit) as f32];
        while state.volumes[readout.volume].as_slice()[0] * readout.scale < 1.0 {
            material.step(&mut state, &[&energy], 1.0).unwrap();
            assert!(state.seconds < 4000.0, "{irradiance} mW/cm² never cures");
        }
        (state.seconds / measured).ln().abs()
    };
    balls.iter().map(of_ball).fold(0.0, f64::max)
}

#[test]
fn oxygen_and_kinetics_fit_measured_cure_times_that_a_dose_does_not() {
    // What gels by dose gels at one I·t: here the largest is a third more than the smallest
    let doses = BALLS_UV.map(|[irradiance, seconds]| irradiance * seconds);
    let [least, most] = [f64::min, f64::max].map(|f| doses.into_iter().reduce(f).unwrap());
    assert!((most / least - 1.35).abs() < 0.005);
    let uv = misfit(
        &BALLS_UV,
        [26.8905, 0.070775, 2.372875e-4, 6.578905e-4, 0.7],
    );
    assert!(uv < 0.05, "{uv}");
    let visible = misfit(
        &BALLS_VISIBLE,
        [2299.1355, 0.000243, 4.240056e-6, 7.204003e-4, 0.5],
    );
    assert!(visible < 0.05, "{visible}");
    // Without oxygen that flows back the weakest light is too fast
    let closed = misfit(&BALLS_UV, [26.8905, 1e-9, 2.372875e-4, 6.578905e-4, 0.7]);
    assert!(closed > 0.1, "{closed}");
}
