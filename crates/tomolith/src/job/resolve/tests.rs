use super::grid::{cut, on_rows};
use crate::grid::PatternGrid;
use crate::job::resolve::goal::Goal;
use crate::job::resolve::*;
use std::path::Path;

#[test]
fn a_grid_is_cut_by_the_resin_and_stays_where_it_was() {
    let grid = VolumeGrid {
        shape: [3, 40, 50],
        pitch_mm: 0.1,
        height_mm: 0.1,
        center_mm: [0.3, 0.0, 1.0],
    };
    let cut = cut(&grid, 1.95);
    // x from −2.2 to 2.8 keeps whole voxels up to beyond ±1.95: −2.0 … 2.0; y from −2 to 2 stays
    assert_eq!(cut.shape, [3, 40, 40]);
    let [low, high] = cut.bounds_mm();
    assert!(
        (low[0] + 2.0).abs() < 1e-12 && (high[0] - 2.0).abs() < 1e-12,
        "{low:?} {high:?}"
    );
    assert_eq!(super::grid::cut(&grid, 10.0), grid);
}

#[test]
fn slices_lie_on_the_rows_of_the_pixels() {
    let grid = |slices, z| VolumeGrid {
        shape: [slices, 4, 4],
        pitch_mm: 0.1,
        height_mm: 0.1,
        center_mm: [0.0, 0.0, z],
    };
    let rows = |count| PatternGrid::full_turn(3, 0.0, count, 8, 0.1);
    let moved = |slices, z, count| on_rows(grid(slices, z), &rows(count), [-0.5, 0.5]).center_mm[2];
    // Even slices about the middle of even rows, and odd ones of odd rows, stay; others move by half a voxel
    assert_eq!((moved(20, 0.0, 32), moved(21, 0.0, 33)), (0.0, 0.0));
    tomolith_core::near!(moved(21, 0.0, 32), 0.05, 1e-9);
    assert!((moved(20, 0.03, 32) - 0.0).abs() < 1e-9);
    assert!((moved(20, -0.03, 33) - -0.05).abs() < 1e-9);
    // Ten slices hold the target only where they are
    assert_eq!(moved(10, 0.0, 33), 0.0);
    // Slices whose edges cannot lie on those of rows stay, and those that miss them by rounding do not
    let of_pitch = |pitch_mm| {
        let grid = VolumeGrid {
            pitch_mm,
            height_mm: pitch_mm,
            ..grid(21, 0.0)
        };
        on_rows(grid, &rows(32), [-0.5, 0.5]).center_mm[2]
    };
    tomolith_core::near!(of_pitch(0.05), 0.025, 1e-9);
    assert!(of_pitch(0.08) == 0.0 && of_pitch(0.0999) != 0.0);
}

#[test]
fn light_from_less_than_half_a_turn_is_told() {
    use super::optics::tests::spec;
    use super::remarks::narrow_arc;
    let remark_of = |angles: &str| narrow_arc(&spec(&[&format!("light.angles={angles}")]));
    let narrow = remark_of("{ count = 36, start_deg = 300, arc_deg = 90 }").unwrap();
    assert!(narrow.contains("an arc of 90°"), "{narrow}");
    // Half a turn is enough, and few directions are told otherwise
    for angles in ["{ count = 36, arc_deg = 180 }", "72", "12", "4"] {
        assert_eq!(remark_of(angles), None, "{angles}");
    }
}

#[test]
fn a_tube_that_reflects_totally_is_told() {
    use super::optics::Optics;
    use super::optics::tests::spec;
    use super::remarks::lost_reflections;
    let remark_of = |core: f64, model: &str| {
        let vial = format!(
            "vial={{ double_tube = {{ outer_radius_mm = 7.0, resin_outer_radius_mm = 6.0, resin_inner_radius_mm = 3.0, inner_radius_mm = 2.5, \
             outer_refractive_index = 1.5, inner_refractive_index = 1.5, core_refractive_index = {core} }} }}"
        );
        let spec = spec(&[&vial, model]);
        lost_reflections(&spec, &Optics::new(&spec, Path::new("")).unwrap())
    };
    let found = remark_of(1.33, "model={ rays = {} }").unwrap();
    assert!(found.contains("reflects light totally"), "{found}");
    assert_eq!(
        remark_of(1.33, "model={ rays = { reflections = true } }"),
        None
    );
    assert_eq!(remark_of(1.6, "model={ rays = {} }"), None);
}

#[test]
fn a_threshold_in_percent_is_told() {
    use super::optics::tests::spec;
    use super::remarks::far_threshold;
    let remark_of = |threshold: &str| {
        let objective = "objective={ threshold = { lower = 0.8, upper = 0.9 } }";
        let spec = spec(&[objective, &format!("evaluate.threshold={threshold}")]);
        far_threshold(&spec, &Goal::read(&spec, Path::new("")).unwrap())
    };
    let far = remark_of("80").unwrap();
    assert!(far.contains("80 is far from the objective's thresholds 0.8 and 0.9"));
    for near in ["0.5", "0.85", "1.5"] {
        assert_eq!(remark_of(near), None, "{near}");
    }
}

#[test]
fn a_degree_of_cure_below_gelation_is_told() {
    use super::optics::tests::spec;
    use super::remarks::below_gel;
    let remark_of = |against: &str, upper: f64| {
        let objective = format!(
            "objective={{ threshold = {{ lower = 0.7, upper = {upper}, ceiling = 1.5 }} }}"
        );
        let schedule = format!(
            "schedule={{ turns = 2, seconds_per_turn = 8.0, power = {{ irradiance_mw_per_mm2 = 1.0 }}, optimize = \"{against}\" }}"
        );
        let spec = spec(&[&objective, &schedule]);
        below_gel(&spec, &Goal::read(&spec, Path::new("")).unwrap())
    };
    assert!(
        remark_of("frozen", 0.9)
            .unwrap()
            .contains("the part for 0.9")
    );
    assert_eq!(remark_of("frozen", 1.2), None);
    assert_eq!(remark_of("dose", 0.9), None);
}

#[test]
fn a_dose_per_area_taken_for_one_per_volume_is_told() {
    use super::optics::tests::spec;
    use super::remarks::large_critical_dose;
    let remark_of = |dose: &str| {
        large_critical_dose(&spec(&[&format!("resin.critical_dose_mj_per_mm3={dose}")]))
    };
    assert!(remark_of("38").unwrap().contains("is 38 J/cm³"));
    assert_eq!(remark_of("0.8"), None);
}
