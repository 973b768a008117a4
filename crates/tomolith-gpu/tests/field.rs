//! Every operation of a field, its bounds, pairs, penalties and half ramp beside those of the host.

mod common;
#[path = "common/portable.rs"]
mod portable;

use common::{SMALL, gpu};
use std::sync::Arc;
use tomolith_core::check::noise;
use tomolith_core::dose::Work;
use tomolith_core::field::{
    Bounds, ColumnRun, CostKernel, Direction, Field, HalfRamp, HalfRampKernel, HostField, Latest,
    Pairs, PatternCost, Stretch,
};
use tomolith_gpu::{Gpu, GpuField, model_on};
use tomolith_objective::penalty::smoothness::{Params, smoothness};

/// A field of the card with a few pieces: three frames of different length each.
fn like(gpu: &Gpu) -> GpuField {
    model_on(gpu, &tiny::form(), &Work::new())
        .and_then(|model| model.new_patterns())
        .unwrap()
}

mod tiny {
    use tomolith_core::dose::form::Form;
    use tomolith_core::grid::{PatternGrid, VolumeGrid};
    use tomolith_models::rays::Optics;
    use tomolith_models::{ModelFamily, ModelInput, OpticalScene, Purpose, Work, parallel};
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    /// 12 frames of 90 columns and 50 rows, not all of them active.
    pub(crate) fn form() -> Form {
        let grid = VolumeGrid::centered([40, 24, 24], 0.1);
        let pixels = PatternGrid::full_turn(12, 0.0, 50, 90, 0.05);
        let mut light = Light::new(pixels, Resin::absorbing(1.5, 0.1));
        let work = |i: usize| ((i % 4) as u32, (46 - i % 5) as u32);
        light.active = Some((0..12 * 90).map(work).collect());
        let (vial, lights) = (IndexMatched { radius_mm: 3.0 }, [light]);
        let optics = [Optics::collimated(0.1)];
        let scene = OpticalScene::new(&vial, &lights, &optics, Purpose::Optimize);
        let work = Work::new();
        let input = ModelInput::new(scene, &grid, &work).unwrap();
        parallel::Params::default().form(&input).unwrap().unwrap()
    }
}

/// The same numbers on the host and on the card.
struct Both {
    host: HostField,
    card: GpuField,
}

impl Both {
    fn of(values: &[f32], like: &GpuField) -> Self {
        let mut card = like.zeros_like();
        card.copy_from_host(values);
        Both {
            host: HostField::from_slice(values),
            card,
        }
    }

    fn noise(seed: u64, like: &GpuField) -> Self {
        Self::of(&noise(seed, like.len()), like)
    }

    fn assert_near(&self, tolerance: f32, what: &str) {
        let found = self.card.to_host();
        for (i, (found, expected)) in found.iter().zip(self.host.as_slice()).enumerate() {
            let error = (found - expected).abs();
            assert!(
                error <= tolerance * (1.0 + expected.abs()),
                "{what}: element {i} is {found}, {expected} on the host"
            );
        }
    }
}

fn near(found: f64, expected: f64, magnitude: f64, what: &str) {
    assert!(
        (found - expected).abs() <= 3e-7 * magnitude,
        "{what}: {found} instead of {expected}"
    );
}

#[test]
fn every_operation_gives_the_numbers_of_the_host() {
    let Some(gpu) = gpu(SMALL) else { return };
    let like = like(&gpu);
    let n = like.len() as f64;
    let [a, b, c] = [1, 2, 3].map(|seed| Both::noise(seed, &like));
    let check = |what: &str, on_host: &dyn Fn(&mut HostField), on_card: &dyn Fn(&mut GpuField)| {
        let mut both = Both::of(a.host.as_slice(), &like);
        on_host(&mut both.host);
        on_card(&mut both.card);
        both.assert_near(1e-6, what);
    };
    check("axpy", &|y| y.axpy(0.3, &b.host), &|y| y.axpy(0.3, &b.card));
    check("scale", &|y| y.scale(-2.5), &|y| y.scale(-2.5));
    check("shift", &|y| y.shift(0.7), &|y| y.shift(0.7));
    check("fill", &|y| y.fill(0.7), &|y| y.fill(0.7));
    check("clamp", &|y| y.clamp(-0.2, 0.4), &|y| y.clamp(-0.2, 0.4));
    check("multiply", &|y| y.multiply(&b.host), &|y| {
        y.multiply(&b.card)
    });
    check("keep", &|y| y.keep_positive(&b.host), &|y| {
        y.keep_positive(&b.card)
    });
    check("mix", &|y| y.mix(0.8, &b.host), &|y| y.mix(0.8, &b.card));
    check("squares", &|y| y.mix_squares(0.8, &b.host), &|y| {
        y.mix_squares(0.8, &b.card)
    });
    check("logistic", &|y| y.logistic_error(&b.host, 0.1, 0.3), &|y| {
        y.logistic_error(&b.card, 0.1, 0.3);
    });
    check(
        "moved",
        &|y| y.change_where_moved(&b.host, &c.host, &b.host),
        &|y| {
            y.change_where_moved(&b.card, &c.card, &b.card);
        },
    );
    check("copy", &|y| y.copy_from(&b.host), &|y| y.copy_from(&b.card));
    check("write", &|y| y.write(17_000, &[1.0; 20_000]), &|y| {
        y.write(17_000, &[1.0; 20_000])
    });
    check("clear", &|y| y.clear(9_000..41_000), &|y| {
        y.clear(9_000..41_000)
    });
    // Through the ends of pieces on either side
    let stretches = [(0, 20_000, 19_000), (19_000, 3, 7), (25_000, 1_000, 22_000)];
    let stretches = stretches.map(|(to, from, count)| Stretch { to, from, count });
    for adds in [true, false] {
        check(
            "stretches",
            &|y| y.set_stretches(adds, -0.6, &b.host, &stretches),
            &|y| y.set_stretches(adds, -0.6, &b.card, &stretches),
        );
    }
    let mut squares = Both::of(b.host.as_slice(), &like);
    squares.host.multiply(&b.host);
    squares.card.multiply(&b.card);
    check(
        "roots",
        &|y| y.divide_by_roots(&squares.host, 4.0, 0.1),
        &|y| {
            y.divide_by_roots(&squares.card, 4.0, 0.1);
        },
    );
    near(a.card.dot(&b.card), a.host.dot(&b.host), n, "dot");
    near(a.card.norm(), a.host.norm(), n.sqrt(), "norm");
    assert_eq!(a.card.max_abs(), a.host.max_abs());
    assert_eq!(a.card.max_marked(&b.card), a.host.max_marked(&b.host));
    assert_eq!(a.card.lowest(), a.host.lowest());
    let (found, expected) = (
        a.card.secant(&b.card, &c.card),
        a.host.secant(&b.host, &c.host),
    );
    for (found, expected) in [
        (found.pp, expected.pp),
        (found.py, expected.py),
        (found.yy, expected.yy),
    ] {
        near(found, expected, n, "secant");
    }
    assert_eq!(a.card.clone().to_host(), a.host.as_slice());
    assert_eq!(a.card.host_bytes(), a.host.host_bytes());
    portable::assert_portable(gpu.sources().iter().map(|(name, text)| (name, text)));
}

#[test]
fn what_is_no_number_is_not_lost() {
    let Some(gpu) = gpu(SMALL) else { return };
    let like = like(&gpu);
    let mut values = noise(4, like.len());
    values[12_345] = f32::NAN;
    let both = Both::of(&values, &like);
    let mut marks = vec![1.0; values.len()];
    assert!(both.card.max_abs().is_nan());
    assert!(both.card.max_marked(&Both::of(&marks, &like).card).is_nan());
    marks[12_345] = -1.0;
    let of_others = both.card.max_marked(&Both::of(&marks, &like).card);
    assert_eq!(
        of_others,
        both.host.max_marked(&HostField::from_slice(&marks))
    );
    assert_eq!(both.card.lowest(), both.host.lowest());
    assert!(both.card.dot(&both.card).is_nan());
    let mut moved = both.card.clone();
    let bounds = moved.compile_bounds(&Bounds::uniform(values.len(), 0.0, 1.0));
    moved.move_along(&both.card, 0.0, &bounds);
    assert!(moved.to_host()[12_345].is_nan());
}

#[test]
fn bounds_of_one_light_and_of_two_hold_as_on_the_host() {
    let Some(gpu) = gpu(SMALL) else { return };
    let like = like(&gpu);
    let len = like.len();
    let two = Bounds::of_pieces([(len - 9_001, 0.0, 0.4), (9_001, 0.1, f32::INFINITY)]);
    for bounds in [Bounds::uniform(len, 0.0, 0.6), two] {
        let [x, g, step] = [5, 6, 7].map(|seed| Both::noise(seed, &like));
        let there = x.card.compile_bounds(&bounds);
        let new = || Both::of(x.host.as_slice(), &like);
        let mut moved = new();
        moved.host.move_along(&step.host, 0.5, &bounds);
        moved.card.move_along(&step.card, 0.5, &there);
        moved.assert_near(1e-6, "move_along");
        let mut free = new();
        free.host.free_gradient(&moved.host, &g.host, &bounds);
        free.card.free_gradient(&moved.card, &g.card, &there);
        free.assert_near(0.0, "free_gradient");
        let mut projected = new();
        let expected = projected
            .host
            .project_step(&moved.host, &g.host, 0.3, &bounds);
        let found = projected
            .card
            .project_step(&moved.card, &g.card, 0.3, &there);
        projected.assert_near(1e-6, "project_step");
        near(found.slope, expected.slope, len as f64, "slope");
        near(found.square, expected.square, len as f64, "square");
        moved.host.quantize(9, &bounds);
        moved.card.quantize(9, &there);
        moved.assert_near(1e-6, "quantize");
    }
    portable::assert_portable(gpu.sources().iter().map(|(name, text)| (name, text)));
}

fn latest<F>([x, step, gradient, change, image]: [&F; 5]) -> Latest<'_, F> {
    Latest {
        x,
        step,
        alpha: 0.7,
        gradient,
        change,
        image,
    }
}

#[test]
fn pairs_give_the_products_and_directions_of_the_host() {
    let Some(gpu) = gpu(SMALL) else { return };
    let like = like(&gpu);
    let len = like.len();
    let bounds = Bounds::uniform(len, 0.0, 0.8);
    let there = like.compile_bounds(&bounds);
    let slots = 6;
    let mut host = <HostField as Field>::Pairs::new(slots, &bounds);
    let mut card = <GpuField as Field>::Pairs::new(slots, &there);
    let fields = |round: u64| [0, 10, 20, 30, 40].map(|seed| Both::noise(round + seed, &like));
    for round in 0..7u64 {
        let [mut x, step, gradient, change, image] = fields(round);
        x.host.clamp(0.0, 0.8);
        x.card.clamp(0.0, 0.8);
        let slot = round as usize % slots;
        let all = [&x, &step, &gradient, &change, &image];
        let expected = host.record(slot, &latest(all.map(|both| &both.host)), &bounds);
        let found = card.record(slot, &latest(all.map(|both| &both.card)), &there);
        for (found, expected) in [
            (&found.s_y, &expected.s_y),
            (&found.z_y, &expected.z_y),
            (&found.s_g, &expected.s_g),
            (&found.z_g, &expected.z_g),
        ] {
            for (found, expected) in found.iter().zip(expected) {
                near(*found, *expected, len as f64, "products");
            }
        }
        near(found.s_s, expected.s_s, len as f64, "s·s");
        near(found.y_y, expected.y_y, len as f64, "y·y");
    }
    let direction = Direction {
        scale: 0.3,
        length: 0.2,
        along_s: vec![0.5, -0.2, 0.1, 0.0, 0.3, -0.4],
        along_z: vec![0.05, 0.1, -0.3, 0.0, 0.2, 0.1],
        stretch: 1.5,
    };
    let [mut x, _, gradient, _, image] = fields(50);
    x.host.clamp(0.0, 0.8);
    x.card.clamp(0.0, 0.8);
    let mut out = Both::noise(9, &like);
    let expected = host.direction(
        &direction,
        &x.host,
        &gradient.host,
        &image.host,
        &bounds,
        &mut out.host,
    );
    let mut again = <GpuField as Field>::Pairs::new(slots, &there);
    let parts: Vec<_> = card
        .parts()
        .into_iter()
        .map(|p| (p.name, (p.bytes)().into_owned()))
        .collect();
    let read = &mut |name: &str, into: &mut [u8]| {
        let part = parts.iter().find(|part| part.0 == name).unwrap();
        into.copy_from_slice(&part.1);
        Ok(())
    };
    again.restore(read).unwrap();
    let found = again.direction(
        &direction,
        &x.card,
        &gradient.card,
        &image.card,
        &there,
        &mut out.card,
    );
    out.assert_near(2e-6, "direction");
    near(found.slope, expected.slope, len as f64, "slope");
    near(
        found.gradient_square,
        expected.gradient_square,
        len as f64,
        "gradient square",
    );
    portable::assert_portable(gpu.sources().iter().map(|(name, text)| (name, text)));
}

#[test]
fn the_half_ramp_and_penalties_are_those_of_the_host() {
    let Some(gpu) = gpu(SMALL) else { return };
    let model = model_on(&gpu, &tiny::form(), &Work::new()).unwrap();
    let like = model.new_patterns().unwrap();
    let runs = |layout: &tomolith_core::dose::PatternLayout| {
        let run = |run: &tomolith_core::dose::layout::PixelRun| ColumnRun {
            first: run.offset,
            bottom: run.bottom as usize,
            count: run.count as usize,
        };
        let frames = layout.runs.chunks(90);
        frames.map(|runs| runs.iter().map(run).collect()).collect()
    };
    let ramp = HalfRamp {
        frames: runs(&model.patterns()[0]),
    };
    let x = Both::noise(8, &like);
    let mut out = Both::noise(9, &like);
    <HostField as Field>::HalfRamp::new(ramp.clone(), &x.host).apply(&x.host, &mut out.host);
    <GpuField as Field>::HalfRamp::new(ramp, &x.card).apply(&x.card, &mut out.card);
    out.assert_near(2e-6, "half ramp");
    let powers = [0.5, 1.0, 1.5, 2.0, 3.0].map(|exponent| PatternCost::Power { exponent });
    // Squares; edges of the size of the noise; and so small that their ratio overflows in f32
    let differences = [None, Some(0.3), Some(1e-30)].map(|edge| {
        let [rows, columns, angles] = [1.0, 0.7, 0.4];
        let params = Params {
            rows,
            columns,
            angles,
            edge,
        };
        smoothness(&params, model.patterns()).unwrap()
    });
    for cost in powers.into_iter().chain(differences) {
        let cost = Arc::new(cost);
        let host = <HostField as Field>::Costs::new(&cost, &x.host);
        let card = <GpuField as Field>::Costs::new(&cost, &x.card);
        let n = like.len() as f64;
        near(
            card.value(&x.card),
            host.value(&x.host),
            30.0 * n,
            "penalty",
        );
        let (found, expected) = (
            card.slope_along(&x.card, &out.card, 0.1),
            host.slope_along(&x.host, &out.host, 0.1),
        );
        near(found.1, expected.1, 300.0 * n, "slope of a penalty");
        host.add_gradient(&x.host, 0.3, &mut out.host);
        card.add_gradient(&x.card, 0.3, &mut out.card);
        out.assert_near(1e-4, "gradient of a penalty");
    }
    portable::assert_portable(gpu.sources().iter().map(|(name, text)| (name, text)));
}
