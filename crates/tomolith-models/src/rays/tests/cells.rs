//! Rays on voxels that a surface cuts.

use super::*;

#[test]
fn every_vial_with_every_optics_is_an_exact_pair_with_cells_too() {
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    for solid in solids(&grid) {
        assert!(solid.cells().len() > 50);
        for vial in vials() {
            for (name, optics) in optics() {
                let params = Params {
                    rays_per_pixel: 3,
                    reflections: true,
                    least_power: 0.02,
                    ..Params::default()
                };
                let light = light(3, 5, 7, 0.3);
                let model = rays(vial.as_ref(), light, &optics, &params, grid.clone())
                    .with_cells(Arc::clone(&solid));
                let found = check::model::model(&model, 3)
                    .unwrap_or_else(|e| panic!("{vial:?} {name}: {e}"));
                assert!(found.adjoint_error < 1e-6, "{vial:?} {name}: {found:?}");
            }
        }
    }
}

#[test]
fn energies_of_cells_equal_a_brute_force_walk_and_add_up_to_the_plain_dose() {
    let grid = VolumeGrid::centered([11, 13, 12], 0.17).about([0.03, -0.02, 0.05]);
    let [solid, _] = solids(&grid);
    for attenuation in [0.3, 9.0] {
        for (name, optics) in optics() {
            let mut light = light(7, 9, 15, 0.13);
            light.resin.attenuation_per_mm = attenuation;
            for is_plain in [false, true] {
                let params = Params::default();
                let mut whole = rays(&GLASS, light.clone(), &optics, &params, grid.clone());
                if is_plain {
                    whole = whole.plain();
                }
                let mut x = whole.new_patterns().unwrap();
                let values = check::noise(1, x.len());
                x.copy_from_host(&values.iter().map(|v| v.abs()).collect::<Vec<_>>());
                let expected = dose(&whole, &x);
                let inside = brute_force_where(&whole, x.as_slice(), |segment, t| {
                    chord(segment.ray.from, segment.ray.direction)
                        .is_some_and(|[a, b]| a < t && t < b)
                });
                let model = whole.with_cells(Arc::clone(&solid));
                let field = check::dose(&model, &x);
                let layout = &model.output;
                let mean = layout.volume_of(field.as_slice());
                let largest = f64::from(expected.values.iter().copied().fold(0.0, f32::max));
                for (a, b) in expected.values.iter().zip(&mean.values) {
                    let error = f64::from((a - b).abs()) / largest;
                    // Tilted light without cells runs in columns
                    assert!(error < 5e-6, "{name}, plain {is_plain}: {error:e}");
                }
                let cells = &field.as_slice()[layout.voxels()..];
                for ((voxel, (_, s)), cell) in layout
                    .cut_voxels()
                    .into_iter()
                    .zip(solid.cells().iter())
                    .zip(cells)
                {
                    let error = (inside[voxel] - f64::from(s * cell)).abs() / largest;
                    assert!(error < 2e-5, "{name}, plain {is_plain}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn even_light_gives_both_cells_of_a_voxel_the_same_dose() {
    let grid = VolumeGrid::centered([6, 7, 7], 0.2);
    let mut light = light(40, 24, 32, 0.1);
    light.resin = Resin::pure_radon(1.48);
    let vial = IndexMatched { radius_mm: 1.7 };
    let params = Params {
        rays_per_pixel: 100,
        ..Params::default()
    };
    for solid in solids(&grid) {
        let model = rays(
            &vial,
            light.clone(),
            &Optics::collimated(0.1),
            &params,
            grid.clone(),
        )
        .with_cells(Arc::clone(&solid));
        let x = check::even_patterns(&model, 1.0);
        let field = check::dose(&model, &x);
        let (voxels, cells) = field.as_slice().split_at(model.output.voxels());
        // Forty frames of fluence 1
        let mut worst = 0.0f32;
        for ((voxel, s), inside) in solid.cells().iter().zip(cells) {
            for (share, dose) in [(1.0 - s, voxels[voxel]), (s, *inside)] {
                worst = worst.max((dose / 40.0 - 1.0).abs() * share);
            }
        }
        assert!(worst < 4e-3, "{worst}");
    }
}
