//! Entries that are kept between calls.

use super::*;
use std::sync::Arc;
use tomolith_core::dose::DoseModel;

/// Dose of some frames, and what it gives their pixels as a cotangent.
fn both_ways(model: &Parallel, frames: Range<usize>, x: &[f32]) -> [HostField; 2] {
    let work = Work::new();
    let mut dose = model.new_dose().unwrap();
    let x = HostField::from_slice(x);
    (model.dose_of(frames.clone(), &x, &mut dose, &work)).unwrap();
    let mut gradient = model.new_patterns().unwrap();
    (model.pullback_of(frames, &x, &dose, &mut gradient, &work)).unwrap();
    [dose, gradient]
}

#[test]
fn kept_entries_give_what_is_found_anew_and_pass_the_model_check() {
    for vial in vials() {
        for isa in Isa::available() {
            for (columns, pitch, sub_angles) in [(45, 0.11, 1), (90, 0.055, 1), (21, 0.23, 3)] {
                // More views than a group has, some columns dark for good; a grid that patches do not fill
                let mut light = weakened(PatternGrid::full_turn(11, 0.2, 19, columns, pitch), 0.2);
                light.sub_angles = sub_angles;
                let work = |column: usize| (0, if column % 5 == 2 { 0 } else { 19 });
                light.active = Some((0..11 * columns).map(work).collect());
                let grid = VolumeGrid::centered([21, 35, 37], 0.1);
                let plain = Parallel::new(vial.as_ref(), vec![light.clone()], grid.clone());
                let cached = keeping(vial.as_ref(), light, grid);
                let (plain, cached) = (plain.unwrap().with_isa(isa), cached.with_isa(isa));
                let what = format!("{vial:?} {isa:?} {columns}");
                check::model::model(&cached, 7).unwrap_or_else(|e| panic!("{what}: {e}"));
                // Two frames in three are dark, and so is most of the cotangent
                let mut x = check::noise(1, plain.patterns[0].len());
                for frame in (0..11).filter(|frame| frame % 3 > 0) {
                    x[plain.patterns[0].elements_of(frame..frame + 1)].fill(0.0);
                }
                let [expected, dose] = [&plain, &cached].map(|model| dose_of(model, &x).values);
                assert!(dose == expected, "{what}");
                let mut cotangent = plain.new_dose().unwrap();
                let noise = check::noise(2, cotangent.len());
                for (i, c) in cotangent.as_mut_slice().iter_mut().enumerate() {
                    *c = if i / 32 % 7 == 3 { noise[i] } else { 0.0 };
                }
                let gradients = [&plain, &cached].map(|model| check::adjoint(model, &cotangent));
                let [expected, gradient] = gradients.each_ref().map(HostField::as_slice);
                assert!(gradient == expected, "{what}");
            }
        }
    }
}

#[test]
fn entries_of_a_part_of_the_turn_serve_all_of_it() {
    // Quarters of a square grid and halves of a rectangular one; tiles that a turn maps onto tiles, and some that it does not; columns that are
    // dark from some sides alone; more views than a group has in each part; light that can be reversed, whose opposite frames are one view
    let absorbing = Resin::absorbing(1.48, 0.2);
    let cases = vials().into_iter().take(2).flat_map(|vial| {
        let vial = Arc::<dyn Vial>::from(vial);
        [
            ([5, 36, 36], 44, false, absorbing),
            ([5, 32, 32], 12, true, absorbing),
            ([5, 30, 40], 22, false, absorbing),
        ]
        .map(|case| (vial.clone(), case))
    });
    let matched: Arc<dyn Vial> = Arc::new(IndexMatched { radius_mm: 3.0 });
    let reversible = (matched, ([20, 36, 36], 44, false, Resin::pure_radon(1.5)));
    for (vial, (shape, frames, descends, resin)) in cases.chain([reversible]) {
        let mut pixels = PatternGrid::full_turn(frames, 0.2, 6, 45, 0.11);
        if descends {
            pixels
                .azimuths
                .iter_mut()
                .for_each(|azimuth| *azimuth = -*azimuth);
        }
        let mut light = Light::new(pixels, resin);
        light.sub_angles = 2;
        let work = |slot: usize| (0, if slot % 7 == 2 { 0 } else { 6 });
        light.active = Some((0..frames * 45).map(work).collect());
        let grid = VolumeGrid::centered(shape, 0.1);
        let plain = finding(
            Finding::OfAllViews,
            vial.as_ref(),
            light.clone(),
            grid.clone(),
        );
        assert!(!plain.lights[0].turned.repeats());
        let cached = keeping(vial.as_ref(), light, grid);
        let quarters = if shape[1] == shape[2] { 4 } else { 2 };
        assert_eq!(cached.lights[0].turned.period, frames / quarters);
        assert!(cached.lights[0].turned.repeats());
        check::model::model(&cached, 7).unwrap_or_else(|e| panic!("{vial:?} {shape:?}: {e}"));
        let x = check::noise(1, plain.patterns[0].len());
        let [expected, dose] = [&plain, &cached].map(|model| dose_of(model, &x).values);
        // Some frames alone, within a part and across its end
        for some in [
            1..3,
            0..frames / 2 + 2,
            frames / quarters - 2..frames / quarters + 3,
        ] {
            let fields = [&plain, &cached].map(|model| both_ways(model, some.clone(), &x));
            for (expected, found) in fields[0].iter().zip(&fields[1]) {
                let off = check::largest_difference(found.as_slice(), expected.as_slice());
                assert!(off < 2e-5, "{vial:?} {shape:?} {some:?}: {off}");
            }
        }
        let [some, all] = [&cached, &plain].map(DoseModel::updates);
        assert_eq!(some, all, "{vial:?} {shape:?}");
        // Strips of a turned frame are rounded otherwise
        let off = check::largest_difference(&dose, &expected);
        assert!(off < 1e-5, "{vial:?} {shape:?}: {off}");
    }
}

#[test]
fn what_is_kept_takes_the_memory_that_was_said() {
    for vial in &vials()[..2] {
        for (pitch, sub_angles) in [(0.05, 1), (0.05, 4), (0.2, 4), (0.11, 2)] {
            let columns = (4.6 / pitch) as usize;
            let mut light = weakened(PatternGrid::full_turn(24, 0.2, 19, columns, pitch), 0.2);
            light.sub_angles = sub_angles;
            let grid = VolumeGrid::centered([21, 48, 48], 0.05);
            let estimate = cached::bytes(&[light.clone()], vial.as_ref(), &grid).unwrap();
            let model = keeping(vial.as_ref(), light, grid);
            let found = model.entries(0, &Work::new()).unwrap();
            let ratio = found.cached.bytes() as f64 / estimate;
            assert!(
                (0.8..1.1).contains(&ratio),
                "{vial:?} {pitch} {sub_angles}: {ratio}"
            );
        }
    }
}

#[test]
fn entries_found_in_each_call_give_the_bits_of_those_that_are_kept() {
    // More views than a group has in each quarter; slices, and rows of pixels under more slices; so many rows that what is kept does not serve all quarters
    for (shape, rows) in [([20, 36, 36], 30), ([40, 36, 36], 20), ([110, 20, 20], 100)] {
        for vial in vials().iter().take(2) {
            let mut light = weakened(PatternGrid::full_turn(44, 0.2, rows, 45, 0.11), 0.2);
            light.sub_angles = 2;
            let grid = VolumeGrid::centered(shape, 0.1);
            let each = [Finding::Once, Finding::InEachCall];
            let models = each.map(|kind| finding(kind, vial.as_ref(), light.clone(), grid.clone()));
            assert!(models[1].lights[0].turned.repeats());
            let x = check::noise(1, models[0].patterns[0].len());
            let [cached, found] = models.each_ref().map(|model| both_ways(model, 3..17, &x));
            let is_alike = models[0].lights[0].turned.repeats();
            assert_eq!(is_alike, rows < 100);
            for (cached, found) in cached.iter().zip(&found) {
                let off = check::largest_difference(found.as_slice(), cached.as_slice());
                assert!(
                    off <= if is_alike { 0.0 } else { 1e-5 },
                    "{vial:?} {shape:?}: {off}"
                );
            }
            let [all, as_many] = models.each_ref().map(DoseModel::updates);
            assert_eq!(all, as_many);
        }
    }
}

#[test]
fn a_stopped_run_keeps_no_half_of_the_entries() {
    let light = weakened(PatternGrid::full_turn(9, 0.2, 19, 40, 0.1), 0.2);
    let grid = VolumeGrid::centered([21, 35, 37], 0.1);
    let model = keeping(vials()[0].as_ref(), light, grid);
    let (work, x) = (Work::new(), model.new_patterns().unwrap());
    work.cancel();
    let mut dose = model.new_dose().unwrap();
    let stopped = model.dose_of(0..9, &x, &mut dose, &work);
    assert!(matches!(stopped, Err(Error::Canceled)));
    assert!(model.cache[0].get().is_none());
    model.dose_of(0..9, &x, &mut dose, &Work::new()).unwrap();
    assert!(model.cache[0].get().is_some());
}

#[test]
fn single_entries_of_a_slice_are_found_once_and_have_the_same_bits() {
    for vial in vials() {
        for isa in Isa::available() {
            let (light, grid) = light_of_slices(1, Resin::absorbing(1.48, 0.2), 45, 0.11);
            let estimate = loose::bytes(std::slice::from_ref(&light), 35 * 37);
            let plain = Parallel::new(vial.as_ref(), vec![light.clone()], grid.clone());
            let part = keeping(vial.as_ref(), light.clone(), grid.clone()).with_isa(isa);
            let cached = keeping(vial.as_ref(), light, grid);
            let (plain, cached) = (plain.unwrap().with_isa(isa), cached.with_isa(isa));
            // Of one there is room for three tiles and beams
            let most = 3 * loose::OF_MEETING;
            let found = Loose::of(&part, &part.lights[0], most, &Work::new()).unwrap();
            assert!(part.loose[0].set(found).is_ok());
            let what = format!("{vial:?} {isa:?}");
            let x = check::noise(1, plain.patterns[0].len());
            let at = HostField::from_slice(&x);
            // Once to find them, once to read them
            let doses = [&plain, &cached, &cached, &part].map(|model| dose_of(model, &x).values);
            assert!(doses[1..].iter().all(|dose| *dose == doses[0]), "{what}");
            let mut cotangent = plain.new_dose().unwrap();
            cotangent.as_mut_slice().copy_from_slice(&doses[0]);
            let gradients = [&plain, &cached, &part].map(|model| {
                let mut gradient = model.new_patterns().unwrap();
                let work = Work::new();
                model
                    .pullback(&at, &cotangent, &mut gradient, &work)
                    .unwrap();
                gradient.as_slice().to_vec()
            });
            assert!(
                gradients[1..].iter().all(|each| *each == gradients[0]),
                "{what}"
            );
            let loose = cached.loose(0, &Work::new()).unwrap().unwrap();
            assert!(
                loose.bytes() > 0 && (loose.bytes() as f64) < estimate,
                "{what}: {}, {estimate}",
                loose.bytes()
            );
            let of_part = part.loose(0, &Work::new()).unwrap().unwrap();
            assert!(
                of_part.bytes() > 0 && of_part.bytes() < loose.bytes(),
                "{what}"
            );
            assert!(plain.loose(0, &Work::new()).unwrap().is_none());
        }
    }
}
