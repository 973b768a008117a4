//! What the parallel model must get right.

use super::strips::{Beam, Columns, Major, Strip};
use super::tiles::{Spans, meeting};
use super::views::Views;
use super::walls::Walls;
use super::*;
use crate::selection;
use tomolith_core::check::{self, difference};
use tomolith_core::dose::DoseModel;
use tomolith_core::field::Field;
use tomolith_core::grid::{PatternGrid, Patterns, Volume};
use tomolith_core::near;
use tomolith_optics::resin::Resin;
use tomolith_optics::trace::Tracer;
use tomolith_optics::vial::{
    cylinder::Cylinder, double_tube::DoubleTube, index_matched::IndexMatched, square::Square,
};

mod kept;
mod regions;

fn vials() -> Vec<Box<dyn Vial>> {
    vec![
        Box::new(IndexMatched { radius_mm: 2.0 }),
        Box::new(Cylinder::new(2.0, 2.2, 1.58)),
        Box::new(Square::new(3.0, 3.6, 1.54)),
        Box::new(DoubleTube::new([2.4, 2.1, 0.8, 0.6], [1.5, 1.5, 1.33])),
    ]
}

/// Light in a resin that absorbs so much, 1/mm.
fn weakened(pixels: PatternGrid, absorption_per_mm: f64) -> Light {
    Light::new(pixels, Resin::absorbing(1.48, absorption_per_mm))
}

fn model_of(vial: &dyn Vial, light: Light, grid: VolumeGrid) -> Parallel {
    Parallel::new(vial, vec![light], grid).unwrap()
}

fn dose_of(model: &Parallel, patterns: &[f32]) -> Volume<f32> {
    let mut dose = model.new_dose().unwrap();
    model
        .dose(&HostField::from_slice(patterns), &mut dose, &Work::new())
        .unwrap();
    model.output.volume_of(dose.as_slice())
}

#[test]
fn updates_of_many_groups_are_counted_within_a_part_in_a_thousand() {
    let vial = Cylinder::new(6.0, 6.2, 1.58);
    let light = weakened(PatternGrid::full_turn(97, 0.2, 4, 110, 0.1), 0.2);
    let grid = VolumeGrid::centered([5, 220, 220], 0.05);
    for finding in [Finding::Once, Finding::InEachCall] {
        let (lights, grid, kernel) = (vec![light.clone()], grid.clone(), Kernel::default());
        let model = Parallel::planned(&vial, lights, kernel, grid, finding, &Work::new()).unwrap();
        let plan = &model.lights[0];
        let period = plan.turned.period;
        assert!(model.tiles.len() * groups(0..period).count() >= MANY_GROUPS);
        let tiles = model.tiles.iter().enumerate();
        let of_tiles = tiles.par_map_with(TileEntries::default, |entries, (index, tile)| {
            let of_view = |view| plan.updates_in(view, index, tile, 5, entries);
            (0..period).map(of_view).sum::<u64>()
        });
        let all = of_tiles.into_iter().sum::<u64>() as f64;
        // Light of 11 mm, as wide as the slice, reaches a strip of 11/1.48 mm behind the round wall. Beams of one angle count once
        near!(all / (5 * 220 * 220 * 97) as f64, 1.0 / 1.48, 0.01);
        near!(model.updates() as f64, all, 1e-3 * all);
    }
}

#[test]
fn every_vial_on_every_path_passes_the_model_check() {
    for vial in vials() {
        for isa in Isa::available() {
            // Odd sizes, an off-center grid, pixels finer and coarser than voxels, standing and turning
            for (columns, pitch, sub_angles) in [(45, 0.11, 1), (90, 0.055, 1), (21, 0.23, 3)] {
                let mut light = weakened(PatternGrid::full_turn(7, 0.2, 19, columns, pitch), 0.2);
                light.sub_angles = sub_angles;
                let grid = VolumeGrid::centered([21, 35, 37], 0.1).about([0.13, -0.05, 0.02]);
                let model = model_of(vial.as_ref(), light, grid).with_isa(isa);
                let found = check::model::model(&model, 7)
                    .unwrap_or_else(|e| panic!("{vial:?} {isa:?} {columns}: {e}"));
                assert!((found.factor - 1.0).abs() < 1e-5, "{found:?}");
            }
        }
    }
}

#[test]
fn two_lights_share_one_dose() {
    let pixels = |n| PatternGrid::full_turn(n, 0.0, 8, 30, 0.1);
    let lights = vec![
        Light::new(pixels(4), Resin::absorbing(1.48, 0.2)),
        Light::new(pixels(3), Resin::absorbing(1.47, 0.5)),
    ];
    let model = Parallel::new(
        vials()[0].as_ref(),
        lights,
        VolumeGrid::centered([5, 20, 20], 0.1),
    )
    .unwrap();
    check::model::model(&model, 3).unwrap();
}

#[test]
fn masked_pixels_leave_an_exact_pair() {
    let grid = VolumeGrid::centered([40, 30, 30], 0.1);
    let mut wanted = Volume::filled(grid.clone(), 0u8);
    for iz in 3..30 {
        wanted.values[grid.index(iz, 12, 17)] = 1;
    }
    let mut light = weakened(PatternGrid::full_turn(6, 0.1, 44, 40, 0.1), 0.2);
    let all = model_of(vials()[1].as_ref(), light.clone(), grid.clone());
    let brought = selection::contributions(&all, &wanted, &Work::new()).unwrap();
    let selections = [tomolith_optics::light::Selection::default()];
    let chosen = selection::chosen(&all.patterns, &selections, Some(brought.as_slice()));
    light.active = Some(selection::rows_of(&all.patterns, &chosen)[0].clone());
    let masked = model_of(vials()[1].as_ref(), light, grid.clone());
    check::model::model(&masked, 5).unwrap();
    let (active, every) = (masked.patterns[0].len(), all.patterns[0].len());
    assert!(
        active > 0 && active * 8 < every,
        "one column of voxels needs few pixels: {active} of {every}"
    );
    // The wanted voxels still receive all the light they could
    let full = dose_of(&all, &vec![1.0; every]);
    let part = dose_of(&masked, &vec![1.0; active]);
    let i = grid.index(10, 12, 17);
    assert!((full.values[i] - part.values[i]).abs() < 1e-6 * full.values[i]);
}

/// Values of which nearly all are 0, in a few short stretches.
fn sparse(seed: u64, len: usize) -> Vec<f32> {
    let mut values = check::noise(seed, len);
    for (i, value) in values.iter_mut().enumerate() {
        if (i / 23) % 19 != seed as usize % 19 {
            *value = 0.0;
        }
    }
    values
}

#[test]
fn isa_paths_agree_and_zeros_that_are_left_out_change_nothing() {
    for vial in vials() {
        let mut first = None;
        for isa in Isa::available() {
            let pixels = PatternGrid::full_turn(9, 0.05, 90, 60, 0.1);
            let light = Light::new(pixels, Resin::absorbing(1.48, 0.2));
            let grid = VolumeGrid::centered([90, 40, 40], 0.1);
            let model = model_of(vial.as_ref(), light, grid).with_isa(isa);
            // What a part of the light, and all of it less that part, bring adds up to what all brings
            let part = sparse(2, model.patterns[0].len());
            let all = check::noise(3, part.len());
            let rest: Vec<f32> = all.iter().zip(&part).map(|(a, b)| a - b).collect();
            let [part, all, rest] = [part, all, rest].map(|x| dose_of(&model, &x).values);
            let both: Vec<f32> = part.iter().zip(&rest).map(|(a, b)| a + b).collect();
            assert!(difference(&both, &all) < 1e-6, "{vial:?}, {isa:?}: dose");
            let off = difference(first.get_or_insert_with(|| all.clone()), &all);
            assert!(off < 1e-6, "{vial:?}, {isa:?}: {off} from the first path");
            let adjoint = |seed: u64, is_sparse: bool| {
                let mut c = model.new_dose().unwrap();
                let len = c.len();
                let (few, many) = (sparse(seed, len), check::noise(9, len));
                for ((to, few), many) in c.as_mut_slice().iter_mut().zip(few).zip(many) {
                    *to = if is_sparse { few } else { many - few };
                }
                let grad = check::adjoint(&model, &c);
                grad.as_slice().to_vec()
            };
            let sum = |a: Vec<f32>, b: Vec<f32>| -> Vec<f32> {
                a.iter().zip(&b).map(|(a, b)| a + b).collect()
            };
            let [once, again] = [4, 5].map(|seed| sum(adjoint(seed, true), adjoint(seed, false)));
            assert!(
                difference(&once, &again) < 1e-6,
                "{vial:?}, {isa:?}: adjoint"
            );
        }
    }
}

/// Absorbed power of a column by many single rays.
fn absorbed(vial: &dyn Vial, light: &Light, azimuth: f64, column: usize) -> f64 {
    let tracer = Tracer::new(
        vial,
        light.resin,
        light.surrounding_index,
        light.polarization,
    );
    let (u, p) = (light.pixels.column_u(column), light.pixels.pitch_mm[0]);
    let n = 400;
    let ray = |i: usize| {
        tracer
            .trace(u + p * ((i as f64 + 0.5) / n as f64 - 0.5), azimuth)
            .balance
            .absorbed
    };
    (0..n).map(ray).sum::<f64>() / n as f64 * p
}

#[test]
fn every_column_leaves_the_energy_that_its_rays_lose() {
    // Tiny absorption too: μ·pitch = 1e-6 must not drown in rounding
    for vial in vials() {
        for mu in [1e-5, 0.3] {
            let light = weakened(PatternGrid::full_turn(3, 0.37, 1, 53, 0.1), mu);
            // One slice as thick as a row, wide enough for all of the resin
            let model = model_of(
                vial.as_ref(),
                light.clone(),
                VolumeGrid::centered([1, 61, 61], 0.1),
            );
            for column in 0..53 {
                let mut patterns = vec![0.0; model.patterns[0].len()];
                patterns[model.patterns[0].runs[53 + column].offset] = 1.0;
                let dose = dose_of(&model, &patterns);
                let left: f64 = dose.values.iter().map(|&v| f64::from(v)).sum::<f64>() * 0.1 * 0.1;
                let lost = absorbed(vial.as_ref(), &light, light.pixels.azimuths[1], column);
                // Per emitted power; a column cut by a wall is resolved by few strips
                assert!(
                    (left - lost).abs() < 1e-3 * 0.1 * (1.0 - (-mu * 4.0f64).exp()).max(1e-12),
                    "{vial:?} μ {mu} column {column}: {left} against {lost}"
                );
            }
        }
    }
}

#[test]
fn a_grid_that_ends_with_the_resin_holds_all_that_is_absorbed() {
    // 5.5 voxels of radius: columns that end at the rim, beyond it, and within; clear and opaque resin
    for (radius, half) in [(0.55, 11), (0.53, 12)] {
        let vials: [Box<dyn Vial>; 4] = [
            Box::new(IndexMatched { radius_mm: radius }),
            Box::new(Cylinder::new(radius, 1.1 * radius, 1.58)),
            Box::new(Square::new(2.0 * radius, 2.4 * radius, 1.54)),
            Box::new(DoubleTube::new(
                [1.1 * radius, radius, 0.4 * radius, 0.3 * radius],
                [1.5, 1.5, 1.33],
            )),
        ];
        for vial in vials {
            for (mu, columns) in [(0.1, 13), (0.1, 14), (6.0, 13), (6.0, 14)] {
                let pixels = PatternGrid::full_turn(17, 0.1, 1, columns + 2, 0.1);
                let light = Light::new(pixels, Resin::absorbing(1.5, mu));
                let grid = VolumeGrid::centered([1, half, half], 0.1);
                let model = model_of(vial.as_ref(), light.clone(), grid.clone());
                let dose = dose_of(&model, &vec![1.0; model.patterns[0].len()]);
                let all: f64 = dose.values.iter().map(|&v| f64::from(v)).sum::<f64>() * 0.01;
                let tracer = Tracer::new(vial.as_ref(), light.resin, 1.0, light.polarization);
                let (rays, width) = (4000, (columns + 2) as f64 * 0.1);
                let absorbed: f64 = (light.pixels.azimuths.iter())
                    .map(|&azimuth| {
                        let ray = |i: usize| {
                            let u = width * ((i as f64 + 0.5) / rays as f64 - 0.5);
                            tracer.trace(u, azimuth).balance.absorbed
                        };
                        (0..rays).map(ray).sum::<f64>() / rays as f64 * width
                    })
                    .sum();
                let off = all / absorbed - 1.0;
                assert!(
                    off.abs() < 1e-3,
                    "{vial:?} μ {mu}, {columns} columns: {off}"
                );
                // And nothing lies where no corner of a voxel, nor its middle, has resin
                for (i, &value) in dose.values.iter().enumerate() {
                    let (x, y) = (grid.x(i % half), grid.y(i / half));
                    let points = [-0.05, -0.025, 0.0, 0.025, 0.05].map(|d| 0.999_999 * d);
                    let has_resin = (points.iter())
                        .any(|dx| points.iter().any(|dy| vial.in_resin([x + dx, y + dy, 0.0])));
                    assert!(
                        has_resin || value < 1e-3 * (1.0 - (-mu * 0.1f64).exp()) as f32,
                        "{vial:?} μ {mu}: voxel at {x} {y} has {value}"
                    );
                }
            }
        }
    }
}

/// Dose of a smooth pattern against single rays followed in steps of a hundredth of a voxel: relative rms of the voxels
/// that no wall cuts.
fn error_against_rays(vial: &dyn Vial, n: usize) -> f64 {
    let h = 4.5 / n as f64;
    let light = weakened(PatternGrid::full_turn(3, 0.23, 1, n + 8, h), 0.3);
    let grid = VolumeGrid::centered([1, n, n], h);
    let model = model_of(vial, light.clone(), grid.clone());
    let pattern = |u: f64| 1.0 + 0.5 * (2.0 * u).sin();
    let columns = light.pixels.columns;
    let values: Vec<f32> = (0..3 * columns)
        .map(|i| pattern(light.pixels.column_u(i % columns)) as f32)
        .collect();
    let dose = dose_of(&model, &values);
    let mut reference = vec![0.0f64; grid.len()];
    let tracer = Tracer::new(vial, light.resin, 1.0, light.polarization);
    let (rays, mu) = (100, 0.3);
    for &azimuth in &light.pixels.azimuths {
        for ray in 0..columns * rays {
            let u = ((ray as f64 + 0.5) / rays as f64 - columns as f64 / 2.0) * h;
            for segment in tracer.trace(u, azimuth).segments {
                let steps = (segment.length / (h / 40.0)).ceil().max(1.0);
                let step = segment.length / steps;
                for s in 0..steps as usize {
                    let way = (s as f64 + 0.5) * step;
                    let at = [0, 1].map(|a| {
                        ((segment.from[a] + way * segment.direction[a] - grid.bounds_mm()[0][a])
                            / h)
                            .floor()
                    });
                    if at.iter().all(|&v| (0.0..n as f64).contains(&v)) {
                        let energy = values[ray / rays] as f64 * h / rays as f64
                            * segment.power
                            * mu
                            * step
                            * (-mu * way).exp();
                        reference[at[1] as usize * n + at[0] as usize] += energy / (h * h);
                    }
                }
            }
        }
    }
    // Voxels near a wall are compared by their energy (above), not one by one
    let whole = |i: usize| {
        let (x, y) = (grid.x(i % n), grid.y(i / n));
        [(-0.2, -0.2), (-0.2, 0.2), (0.2, -0.2), (0.2, 0.2)]
            .iter()
            .all(|(a, b)| vial.in_resin([x + a, y + b, 0.0]))
    };
    let (mut error, mut size) = (0.0, 0.0);
    for (i, (&d, r)) in dose
        .values
        .iter()
        .zip(&reference)
        .enumerate()
        .filter(|(i, _)| whole(*i))
    {
        error += (f64::from(d) - r).powi(2);
        size += r * r;
        assert!(*r == 0.0 || d > 0.0, "{vial:?}: voxel {i} is dark");
    }
    (error / size).sqrt()
}

#[test]
fn refraction_and_folds_put_dose_where_single_rays_put_it() {
    // Resin radius 2.0 mm, light tangent only up to 2.2/1.48 = 1.486 mm: folds lie inside the resin
    for vial in vials() {
        let (coarse, fine) = (
            error_against_rays(vial.as_ref(), 30),
            error_against_rays(vial.as_ref(), 60),
        );
        // Beam edges are jumps and caustics poles: there the rms falls more slowly than in smooth light
        assert!(
            coarse < 0.07 && fine < 0.75 * coarse,
            "{vial:?}: {coarse}, then {fine}"
        );
        let smooth = vial.walls().len() == 1;
        assert!(!smooth || fine < 1.5e-3, "{coarse}, then {fine}");
    }
}

#[test]
fn a_quarter_turn_of_the_frames_turns_the_dose() {
    for vial in vials() {
        let light = weakened(PatternGrid::full_turn(8, 0.1, 3, 53, 0.1), 0.2);
        let model = model_of(vial.as_ref(), light, VolumeGrid::centered([3, 40, 40], 0.1));
        let patterns = check::noise(11, model.patterns[0].len());
        let per_frame = patterns.len() / 8;
        let mut rolled = patterns.clone();
        rolled.rotate_right(2 * per_frame); // frame k now shines from k + 2: a quarter turn further
        let (a, b) = (dose_of(&model, &patterns), dose_of(&model, &rolled));
        let scale = a.values.iter().fold(0.0f32, |m, v| m.max(v.abs()));
        for iy in 0..40 {
            for ix in 0..40 {
                // (x, y) turned by 90° is (−y, x)
                let turned = b.at(1, ix, 39 - iy);
                assert!(
                    (a.at(1, iy, ix) - turned).abs() < 2e-4 * scale,
                    "{vial:?} {ix} {iy}: {} {turned}",
                    a.at(1, iy, ix)
                );
            }
        }
    }
}

#[test]
fn a_turning_frame_is_the_mean_of_standing_ones() {
    let vial = IndexMatched { radius_mm: 2.0 };
    let grid = VolumeGrid::centered([2, 30, 30], 0.1);
    let mut turning = weakened(PatternGrid::full_turn(4, 0.0, 2, 40, 0.1), 0.2);
    turning.sub_angles = 2;
    let turning = model_of(&vial, turning, grid.clone());
    let x = check::noise(5, turning.patterns[0].len());
    let mean = dose_of(&turning, &x);
    let step = std::f64::consts::TAU / 4.0;
    let halves: Vec<Volume<f32>> = [-0.25, 0.25]
        .into_iter()
        .map(|part| {
            let light = weakened(PatternGrid::full_turn(4, part * step, 2, 40, 0.1), 0.2);
            dose_of(&model_of(&vial, light, grid.clone()), &x)
        })
        .collect();
    for (i, m) in mean.values.iter().enumerate() {
        assert!((m - 0.5 * (halves[0].values[i] + halves[1].values[i])).abs() < 1e-5);
    }
}

#[test]
fn pure_radon_adjoint_of_a_disc_is_its_chord() {
    let n = 200;
    let (h, radius) = (0.02, 1.5);
    let grid = VolumeGrid::centered([1, n, n], h);
    let light = Light::new(
        PatternGrid::full_turn(5, 0.1, 1, n, h),
        Resin::pure_radon(1.48),
    );
    let model = model_of(&IndexMatched { radius_mm: 1.99 }, light, grid.clone());
    // Cover of each voxel by the disc, from 8 × 8 points
    let mut disc = Volume::filled(grid.clone(), 0.0f32);
    for iy in 0..n {
        for ix in 0..n {
            let inside = (0..64).filter(|s| {
                let at = |c: f64, i: usize| c + h * ((i as f64 + 0.5) / 8.0 - 0.5);
                at(grid.x(ix), s % 8).hypot(at(grid.y(iy), s / 8)) < radius
            });
            disc.values[grid.index(0, iy, ix)] = inside.count() as f32 / 64.0;
        }
    }
    let grad = check::adjoint(
        &model,
        &HostField::from_slice(&model.output.field_of(&disc)),
    );
    let images = model.patterns[0].patterns_of(grad.as_slice());
    let mut squares = 0.0;
    for frame in 0..5 {
        for (column, &value) in images.frame(frame).iter().enumerate() {
            // Adjoint of dose per pixel value: chord length over voxel pitch (V = h³, pixel area h²)
            let u: f64 = images.grid.column_u(column);
            let ray = |i: i32| u + h * ((f64::from(i) + 0.5) / 40.0 - 0.5);
            let chord = (0..40)
                .map(|i| 2.0 * (radius * radius - ray(i).powi(2)).max(0.0).sqrt())
                .sum::<f64>()
                / (40.0 * h);
            if u.abs() < 0.95 * radius {
                // A rim that runs along the rows is resolved to a fraction of a voxel
                near!(f64::from(value), chord, 0.65, "{column}: {value}");
            }
            squares += (f64::from(value) - chord).powi(2) / (5.0 * n as f64);
        }
    }
    assert!(squares.sqrt() < 0.25, "rms {} voxels", squares.sqrt());
}

#[test]
fn a_single_pixel_lights_the_voxel_it_should() {
    // Frame 1 of 4 comes from +y (azimuth 90°); its columns grow along −x; row 0 is the top
    let vial = IndexMatched { radius_mm: 2.0 };
    let light = weakened(PatternGrid::full_turn(4, 0.0, 10, 20, 0.1), 0.2);
    let model = model_of(
        &vial,
        light.clone(),
        VolumeGrid::centered([10, 20, 20], 0.1),
    );
    let mut patterns = tomolith_core::grid::Patterns::dark(light.pixels);
    patterns.values[(10 + 2) * 20 + 15] = 1.0; // frame 1, row 2, column 15
    let mut field = model.new_patterns().unwrap();
    model.patterns[0].fill_field(&patterns, field.as_mut_slice());
    let dose = dose_of(&model, field.as_slice());
    for (i, &value) in dose.values.iter().enumerate() {
        let (iz, ix) = (i / 400, i % 20);
        // row 2 from the top of 10 is slice 7; column 15 of 20 is x = −0.55 mm, voxel 4
        assert_eq!(value > 0.0, iz == 7 && ix == 4, "voxel {iz} {ix}: {value}");
    }
    // Light enters at +y and weakens toward −y
    assert!(dose.at(7, 19, 4) > dose.at(7, 0, 4));
}

/// A model of so many slices, with as many rows.
fn slices(vial: &dyn Vial, nz: usize, resin: Resin, columns: usize, pitch: f64) -> Parallel {
    let (light, grid) = light_of_slices(nz, resin, columns, pitch);
    model_of(vial, light, grid)
}

fn light_of_slices(nz: usize, resin: Resin, columns: usize, pitch: f64) -> (Light, VolumeGrid) {
    let mut light = Light::new(PatternGrid::full_turn(9, 0.2, nz, columns, pitch), resin);
    // Rows as high as slices whatever their pitch: one row for one slice
    light.pixels.rows = (nz as f64 * 0.1 / pitch).round().max(1.0) as usize;
    light.sub_angles = 2;
    let grid = VolumeGrid::centered([nz, 35, 37], 0.1).about([0.13, -0.05, 0.0]);
    (light, grid)
}

/// A model that keeps its entries.
fn keeping(vial: &dyn Vial, light: Light, grid: VolumeGrid) -> Parallel {
    finding(Finding::Once, vial, light, grid)
}

fn finding(finding: Finding, vial: &dyn Vial, light: Light, grid: VolumeGrid) -> Parallel {
    let (lights, kernel) = (vec![light], Kernel::default());
    Parallel::planned(vial, lights, kernel, grid, finding, &Work::new()).unwrap()
}

#[test]
fn a_plane_passes_the_model_check_in_every_vial_on_every_path() {
    // In the last one no tile meets a wall
    let wide: Box<dyn Vial> = Box::new(IndexMatched { radius_mm: 9.0 });
    for vial in vials().into_iter().chain([wide]) {
        for isa in Isa::available() {
            for resin in [Resin::absorbing(1.48, 0.2), Resin::pure_radon(1.48)] {
                // Two taps, three, and pixels too fine for uniform strips
                for (columns, pitch) in [(45, 0.11), (52, 0.09), (99, 0.05), (21, 0.23)] {
                    let model = slices(vial.as_ref(), 1, resin, columns, pitch).with_isa(isa);
                    check::model::model(&model, 7)
                        .unwrap_or_else(|e| panic!("{vial:?} {isa:?} {columns}: {e}"));
                }
            }
        }
    }
}

#[test]
fn a_plane_is_a_slice_of_a_volume() {
    let wide: Box<dyn Vial> = Box::new(IndexMatched { radius_mm: 9.0 });
    for vial in vials().into_iter().chain([wide]) {
        for isa in Isa::available() {
            let resin = Resin::absorbing(1.48, 0.3);
            let plane = slices(vial.as_ref(), 1, resin, 45, 0.1).with_isa(isa);
            let volume = slices(vial.as_ref(), 3, resin, 45, 0.1).with_isa(isa);
            assert!(plane.is_plane() && !volume.is_plane());
            // The same light at all heights: fields hold the rows of a (frame, column) one after the other
            let x = check::noise(3, plane.patterns[0].len());
            let same: Vec<f32> = x.iter().flat_map(|&v| [v; 3]).collect();
            let (a, b) = (dose_of(&plane, &x), dose_of(&volume, &same));
            let middle = &b.values[b.grid.index(1, 0, 0)..b.grid.index(2, 0, 0)];
            let found = difference(&a.values, middle);
            assert!(found < 5e-6, "{vial:?} {isa:?}: {found}");
        }
    }
}

#[test]
fn straight_light_through_a_plane_is_uniform_strips() {
    let vial = IndexMatched { radius_mm: 9.0 };
    let model = slices(&vial, 1, Resin::absorbing(1.48, 0.3), 45, 0.1);
    let met = |m: &&tiles::Meeting| m.end > m.first;
    let meetings = || model.lights[0].meetings.iter().filter(met);
    assert!(meetings().count() > 0);
    assert!(
        meetings().all(|m| m.uniform_strips),
        "tiles without uniform strips"
    );
}

/// A light of pure Radon from these azimuths, some of its pixels dark.
fn reversible(azimuths: Vec<f64>) -> Light {
    let pixels = PatternGrid {
        azimuths,
        ..PatternGrid::full_turn(1, 0.0, 40, 33, 0.11)
    };
    let run = |i: usize| ((i % 7) as u32, 5 + (i % 29) as u32);
    let active = (0..pixels.frames() * pixels.columns).map(run).collect();
    Light {
        active: Some(active),
        ..Light::new(pixels, Resin::pure_radon(1.5))
    }
}

#[test]
fn opposite_frames_are_one_view_and_change_nothing() {
    let all = PatternGrid::full_turn(10, 0.3, 1, 1, 0.1).azimuths;
    let vial = IndexMatched { radius_mm: 3.0 };
    for nz in [1, 37] {
        let grid = VolumeGrid::centered([nz, 30, 35], 0.1);
        let whole = reversible(all.clone());
        // The same frames as two lights of half a turn each: no frame has its opposite
        let halves = [0..5, 5..10].map(|frames: Range<usize>| {
            let columns = whole.pixels.columns;
            let active = whole.active.as_ref().unwrap();
            Light {
                active: Some(active[frames.start * columns..frames.end * columns].to_vec()),
                ..reversible(all[frames].to_vec())
            }
        });
        let paired = model_of(&vial, whole, grid.clone());
        let single = Parallel::new(&vial, halves.to_vec(), grid).unwrap();
        assert_eq!(paired.lights[0].of_view.len(), 5);
        assert_eq!(single.lights[0].of_view.len(), 5);
        assert_eq!(paired.updates(), single.updates());
        check::model::model(&paired, 3).unwrap();
        let x = HostField::from_slice(&check::noise(5, paired.patterns[0].len()));
        let dose_of = |model: &Parallel, frames: Range<usize>| {
            let mut dose = model.new_dose().unwrap();
            model.dose_of(frames, &x, &mut dose, &Work::new()).unwrap();
            dose
        };
        for frames in [0..10, 2..4, 3..9, 6..10] {
            let (a, b) = (dose_of(&paired, frames.clone()), dose_of(&single, frames));
            assert!(difference(a.as_slice(), b.as_slice()) < 1e-6);
        }
        let noise = check::noise(6, paired.output.len());
        let cotangent = HostField::from_slice(&noise);
        let [a, b] = [&paired, &single].map(|model| check::adjoint(model, &cotangent));
        assert!(difference(a.as_slice(), b.as_slice()) < 1e-6);
    }
}

#[test]
fn frames_have_opposites_only_where_light_can_be_reversed() {
    let all = |count| PatternGrid::full_turn(count, 0.3, 1, 1, 0.1).azimuths;
    let views = |vial: &dyn Vial, light: &Light| Views::of(vial, light).count();
    let light = reversible(all(10));
    let matched = IndexMatched { radius_mm: 3.0 };
    assert_eq!(views(&matched, &light), 5);
    assert_eq!(views(&matched, &reversible(all(9))), 9);
    assert_eq!(views(vials()[1].as_ref(), &light), 10);
    let absorbing = Light {
        resin: Resin::absorbing(1.5, 0.1),
        ..light
    };
    assert_eq!(views(&matched, &absorbing), 10);
    let mut uneven = all(10);
    uneven[7] += 1e-3;
    assert_eq!(views(&matched, &reversible(uneven)), 10);
}

#[test]
fn strips_asked_together_meet_the_tiles_that_each_meets_alone() {
    let tiles = Tile::cover([100, 70], false);
    let grid = VolumeGrid::centered([1, 70, 100], 0.1);
    let walls = Walls::new(&IndexMatched { radius_mm: 50.0 }, &grid);
    let noise = |i: usize| (i * 7919 % 1009) as f32 / 1009.0;
    let mut met = 0;
    for (k, major) in (0..40).map(|k| (k, [Major::X, Major::Y][k % 2])) {
        let strip = |i: usize| {
            let offset = 4.0 * (i as f32 - 5.0) + noise(100 * k + i);
            let slope = noise(31 * k) * 2.0 - 1.0 + 0.02 * noise(i);
            Strip {
                column: i as u32,
                upward: true,
                edges: [[offset, slope], [offset + 3.0 * noise(k + i), slope + 0.01]],
                span: [30.0 * noise(7 * k + i), 40.0 + 60.0 * noise(3 * k + i)],
                power: 1.0,
                row_mm: 0.1,
            }
        };
        let beam = Beam {
            frame: 0,
            azimuth: 0.0,
            major,
            strips: (0..45).map(strip).collect(),
            columns: Columns::default(),
        };
        // Edges without limits leave every strip to be asked alone
        let open = vec![Spans::OPEN; Spans::of_beam(&beam).len()];
        for tile in &tiles {
            let found = meeting(&beam, &Spans::of_beam(&beam), None, &walls, tile);
            assert_eq!(found, meeting(&beam, &open, None, &walls, tile));
            met += usize::from(found.end > found.first);
        }
    }
    assert!(met > 100 && met < 40 * tiles.len(), "{met}");
}

/// Patterns of numbers that look random.
fn patterns(grid: &PatternGrid) -> Patterns {
    Patterns {
        values: check::noise(9, grid.len())
            .iter()
            .map(|v| v.abs())
            .collect(),
        grid: grid.clone(),
    }
}

/// The dose of patterns by a model of one light.
fn dose_by(vial: &dyn Vial, light: &Light, grid: &VolumeGrid, patterns: &Patterns) -> Vec<f32> {
    let light = Light {
        pixels: patterns.grid.clone(),
        ..light.clone()
    };
    let model = model_of(vial, light, grid.clone());
    let mut x = model.new_patterns().unwrap();
    model.patterns[0].fill_field(patterns, x.as_mut_slice());
    dose_of(&model, x.as_slice()).values
}

fn assert_alike(a: &[f32], b: &[f32], tolerance: f32, what: &str) {
    let off = check::largest_difference(b, a);
    assert!(off <= tolerance, "{what}: {off}");
}

#[test]
fn an_image_beside_the_axis_is_a_part_of_a_larger_one() {
    // 14 columns and 10 rows, three columns to the right and two rows down of the axis: the last of 20 columns, the lowest of 14 rows
    for pitch in [[0.1, 0.1], [0.08, 0.15]] {
        let large = PatternGrid {
            pitch_mm: pitch,
            ..PatternGrid::full_turn(6, 0.2, 14, 20, 0.1)
        };
        let small = PatternGrid {
            rows: 10,
            columns: 14,
            offset_mm: [3.0 * pitch[0], -2.0 * pitch[1]],
            ..large.clone()
        };
        let given = patterns(&small);
        let mut within = Patterns::dark(large);
        for (i, &value) in given.values.iter().enumerate() {
            let (frame, row, column) = (i / 140, i / 14 % 10, i % 14);
            within.values[(frame * 14 + row + 4) * 20 + column + 6] = value;
        }
        for vial in vials() {
            for (resin, slices) in [
                (Resin::absorbing(1.48, 0.2), 14),
                (Resin::absorbing(1.48, 0.2), 1),
                (Resin::pure_radon(1.48), 14),
                (Resin::pure_radon(1.48), 1),
            ] {
                let light = Light::new(small.clone(), resin);
                let mut grid = VolumeGrid::centered([slices, 21, 22], 0.1);
                grid.center_mm[2] = -0.1;
                let [a, b] = [&given, &within].map(|p| dose_by(vial.as_ref(), &light, &grid, p));
                assert_alike(&a, &b, 2e-6, &format!("{vial:?} {pitch:?} {slices}"));
            }
        }
    }
}

#[test]
fn pixels_twice_as_high_or_wide_are_two_equal_ones() {
    let square = PatternGrid::full_turn(5, 0.2, 12, 32, 0.06);
    let grid = VolumeGrid::centered([9, 25, 26], 0.08);
    let repeated = |rows: usize, columns: usize| {
        let larger = PatternGrid {
            rows: square.rows / rows,
            columns: square.columns / columns,
            pitch_mm: [0.06 * columns as f64, 0.06 * rows as f64],
            ..square.clone()
        };
        let given = patterns(&larger);
        let mut each = Patterns::dark(square.clone());
        for (i, value) in each.values.iter_mut().enumerate() {
            let (frame, row, column) = (i / (12 * 32), i / 32 % 12 / rows, i % 32 / columns);
            *value = given.values[(frame * larger.rows + row) * larger.columns + column];
        }
        [given, each]
    };
    for vial in vials() {
        let light = Light::new(square.clone(), Resin::absorbing(1.48, 0.2));
        let [a, b] = repeated(3, 1).map(|p| dose_by(vial.as_ref(), &light, &grid, &p));
        assert_alike(&a, &b, 2e-6, &format!("{vial:?}"));
    }
    // Straight light that nothing weakens has no detail within a column, far from where the resin ends
    let wide = IndexMatched { radius_mm: 30.0 };
    let light = Light::new(square.clone(), Resin::pure_radon(1.48));
    let [a, b] = repeated(1, 2).map(|p| dose_by(&wide, &light, &grid, &p));
    assert_alike(&a, &b, 1e-5, "wide");
}

#[test]
fn pixels_that_are_not_square_leave_the_energy_of_their_area_and_are_an_exact_pair() {
    // Strongly absorbing resin, all of it in the grid
    let pixels = PatternGrid {
        pitch_mm: [0.13, 0.05],
        offset_mm: [-0.31, 0.12],
        ..PatternGrid::full_turn(3, 0.1, 8, 9, 0.1)
    };
    let grid = VolumeGrid::centered([20, 46, 46], 0.1);
    let light = Light::new(pixels.clone(), Resin::absorbing(1.48, 9.0));
    let even = Patterns {
        values: vec![2.0; pixels.len()],
        grid: pixels.clone(),
    };
    let dose = dose_by(vials()[0].as_ref(), &light, &grid, &even);
    let energy: f64 = dose.iter().map(|&v| f64::from(v)).sum::<f64>() * grid.voxel_mm3();
    let sent = 2.0 * 3.0 * (8.0 * 0.05) * (9.0 * 0.13);
    assert!((energy / sent - 1.0).abs() < 1e-5, "{energy} of {sent}");
    for vial in vials() {
        let light = Light::new(pixels.clone(), Resin::absorbing(1.48, 0.3));
        let model = model_of(vial.as_ref(), light, grid.clone());
        check::model::model(&model, 3).unwrap();
    }
}
