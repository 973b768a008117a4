//! Regions whose doses are left out.

use super::*;
use tomolith_core::dose::DoseModel;

/// Stands where no dose was written.
const UNTOUCHED: f32 = 7.0;

/// Lights, grids and vials in which lanes are slices or rows of pixels, which begin together or do not, and entries those of all or of a part of the turn.
fn models(isa: Isa) -> Vec<Parallel> {
    let shapes = [
        ([133, 12, 14], 150, 0.09, 11),
        ([150, 12, 14], 130, 0.13, 11),
        ([40, 36, 36], 20, 0.2, 44),
        ([70, 30, 40], 60, 0.11, 22),
    ];
    let resins = [Resin::absorbing(1.48, 0.2), Resin::pure_radon(1.48)];
    let cases = shapes
        .into_iter()
        .flat_map(|shape| resins.map(|resin| (shape, resin)));
    let of_case =
        |((shape, rows, height, frames), resin): (([usize; 3], usize, f64, usize), Resin)| {
            let mut pixels = PatternGrid::full_turn(frames, 0.2, rows, 45, 0.11);
            pixels.pitch_mm[1] = height;
            let mut light = Light::new(pixels, resin);
            let run = |slot: usize| (0, if slot % 7 == 2 { 0 } else { rows as u32 });
            light.active = Some((0..frames * 45).map(run).collect());
            let grid = VolumeGrid::centered(shape, 0.1);
            keeping(&IndexMatched { radius_mm: 3.0 }, light, grid).with_isa(isa)
        };
    cases.map(of_case).collect()
}

/// Patterns from 0 up that are dark in places, and a step that keeps them so.
fn patterns(model: &Parallel) -> [HostField; 2] {
    let len = model.patterns[0].len();
    let dark = |i: usize| i / 300 % 3 == 1;
    let values = |seed: u64| {
        check::noise(seed, len)
            .into_iter()
            .map(f32::abs)
            .enumerate()
    };
    let at = values(1).map(|(i, value)| if dark(i) { 0.0 } else { value });
    let x: Vec<f32> = at.collect();
    let step = values(2).map(|(i, value)| if dark(i / 2) { -x[i] } else { value - x[i] });
    let step: Vec<f32> = step.collect();
    [x, step].map(|values| HostField::from_slice(&values))
}

#[test]
fn regions_hold_every_lit_voxel_and_their_doses_have_the_bits_of_the_whole() {
    for isa in Isa::available() {
        for model in models(isa) {
            let what = format!("{isa:?} {:?}", model.output.grid.shape);
            let regions = model.regions().unwrap();
            let [x, _] = patterns(&model);
            let whole = check::dose(&model, &x);
            let chosen: Vec<bool> = (0..regions.count())
                .map(|i| i % 5 == 2 || i % 7 < 3)
                .collect();
            let mut dose = whole.zeros_like();
            dose.fill(UNTOUCHED);
            (regions.dose_in(&chosen, &x, &mut dose, &Work::new())).unwrap();
            let pairs = || dose.as_slice().iter().zip(whole.as_slice());
            let is_written: Vec<f32> = pairs()
                .map(|(part, _)| f32::from(u8::from(*part != UNTOUCHED)))
                .collect();
            assert!(
                pairs().all(|(part, whole)| *part == UNTOUCHED || part == whole),
                "{what}"
            );
            assert!(
                is_written.contains(&0.0) && is_written.contains(&1.0),
                "{what}"
            );
            for (chosen, least) in chosen.iter().zip(regions.least(&|i| is_written[i])) {
                assert!(!chosen || least >= 1.0, "{what}: a voxel is missing");
            }
            // Together they are the whole
            let others: Vec<bool> = chosen.iter().map(|chosen| !chosen).collect();
            (regions.dose_in(&others, &x, &mut dose, &Work::new())).unwrap();
            let is_lit = |(part, whole): (&f32, &f32)| *whole == 0.0 || part == whole;
            assert!(
                dose.as_slice().iter().zip(whole.as_slice()).all(is_lit),
                "{what}"
            );
        }
    }
}

#[test]
fn a_bound_is_never_below_the_dose_and_mostly_near_it() {
    for isa in Isa::available() {
        for model in models(isa) {
            let what = format!("{isa:?} {:?}", model.output.grid.shape);
            let regions = model.regions().unwrap();
            let [x, step] = patterns(&model);
            let mut end = x.clone();
            end.axpy(1.0, &step);
            let dose = check::dose(&model, &end);
            // Above all doses by what the smallest distance tells
            let above = 2.0 * dose.max_abs();
            let least = regions.least(&|i| above - dose.as_slice()[i]);
            let largest: Vec<f32> = least.into_iter().map(|least| above - least).collect();
            let bounds = regions.bounds(&x, &step, &Work::new()).unwrap();
            let pairs = || {
                bounds
                    .iter()
                    .zip(&largest)
                    .filter(|(_, largest)| **largest > 0.0)
            };
            assert!(
                pairs().all(|(bound, largest)| *bound >= largest * 0.9999),
                "{what}"
            );
            let far = pairs().filter(|(bound, largest)| **bound > 2.5 * **largest);
            let (far, lit) = (far.count(), pairs().count());
            assert!(lit > 0 && 2 * far < lit, "{what}: {far} of {lit}");
        }
    }
}

#[test]
fn a_region_holds_something_where_any_of_its_voxels_does() {
    for model in models(Isa::in_use()) {
        let regions = model.regions().unwrap();
        let mut field = model.new_dose().unwrap();
        let all = vec![true; regions.count()];
        assert!(!regions.holds_any(&field, &all).contains(&true));
        let [nz, ny, nx] = model.output.grid.shape;
        let lit = model.output.index(nz / 2, ny / 2, nx / 2);
        field.as_mut_slice()[lit] = -1.0;
        let found = regions.holds_any(&field, &all);
        let least = regions.least(&|i| field.as_slice()[i] + 1.0);
        assert!(found.contains(&true));
        for (found, least) in found.iter().zip(least) {
            assert_eq!(*found, least == 0.0);
        }
        let none = vec![false; regions.count()];
        assert!(!regions.holds_any(&field, &none).contains(&true));
    }
}

#[test]
fn models_that_find_entries_anew_or_have_two_lights_have_no_regions() {
    let vial = IndexMatched { radius_mm: 2.0 };
    let light = weakened(PatternGrid::full_turn(9, 0.2, 70, 40, 0.1), 0.2);
    let grid = || VolumeGrid::centered([70, 20, 20], 0.1);
    let anew = model_of(&vial, light.clone(), grid());
    assert!(anew.regions().is_none());
    let cached = keeping(&vial, light.clone(), grid());
    assert!(cached.regions().is_some());
    let (both, kernel, finding) = (vec![light.clone(), light], Kernel::default(), Finding::Once);
    let two = Parallel::planned(&vial, both, kernel, grid(), finding, &Work::new()).unwrap();
    assert!(two.regions().is_none());
}
