use super::*;
use crate::check;
use crate::tests::Room;
use crate::{OBJECTIVES, ObjectiveInput};
use serde_json::json;
use std::sync::Arc;
use tomolith_core::check::small::SmallModel;
use tomolith_core::check::{noise, refuses};
use tomolith_core::dose::Work;
use tomolith_core::field::{Field, HostField};
use tomolith_core::near;
use tomolith_core::response::Identity;
use tomolith_io::npy::write_volume;

impl Room {
    fn ground<'a>(&'a self, base: &'a Path) -> Ground<'a> {
        Ground {
            layout: &self.layout,
            labels: &self.labels,
            target: &self.target,
            base,
        }
    }

    /// Weights and tolerances of these keys, without files.
    fn weigh(&self, json: Value) -> Result<VoxelWeights> {
        common(json).voxel_weights(&self.ground(Path::new("")))
    }

    fn array(&self, field: Vec<f32>) -> Vec<f32> {
        self.layout.volume_of(&field).values
    }
}

fn common(json: Value) -> Common {
    let (common, rest) = Common::split(Section::new("objectives[0]", json)).unwrap();
    assert!(rest.value.as_object().unwrap().keys().all(|k| k == "bclp"));
    common
}

#[test]
fn regions_without_a_voxel_that_counts_are_told() {
    // The first of six voxels in a row does not count
    let mut room = Room::row(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], false);
    room.labels.values[0] = label::OUTSIDE;
    let at = |range: [f64; 2]| json!({"radius_mm": range, "value": 2.0});
    let reach = room.layout.grid.x(5).hypot(room.layout.grid.y(0));
    let empty = |mut section: Value| {
        section["bclp"] = json!({});
        common(section)
            .empty_regions(&room.ground(Path::new(".")))
            .unwrap()
    };
    let beyond = [reach + 0.01, reach + 1.0];
    assert_eq!(
        empty(json!({
            "region": {"of": "void", "radius_mm": beyond},
            "weights": {"regions": [at([0.0, reach]), at(beyond)]},
            "tolerance": {"regions": [at(beyond), at([0.0, reach])]},
        })),
        ["region", "weights.regions[1]", "tolerance.regions[0]"]
    );
    assert!(empty(json!({"region": {"of": "part"}})).is_empty());
}

#[test]
fn weights_by_role_buffer_region_and_file() {
    let room = Room::row(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], false);
    let folder = tempfile::tempdir().unwrap();
    let factors = Volume::new(
        room.layout.grid.clone(),
        vec![1.0f32, 2.0, 3.0, 4.0, 5.0, 6.0],
    );
    write_volume(&folder.path().join("w.npy"), &factors, &Work::new()).unwrap();
    let ground = room.ground(folder.path());
    let weight = |json: Value| room.array(common(json).voxel_weights(&ground).unwrap().weight);
    assert_eq!(
        weight(json!({"weights": {"part": 0.5, "void": 2.0}})),
        [2.0, 2.0, 2.0, 0.5, 0.5, 0.5]
    );
    // Voxels of 0.5 mm: erosion by 0.5 mm takes the first part voxel, dilation by 1 mm two of the void
    let buffer = json!({"weights": {"buffer_part_mm": 0.5, "buffer_void_mm": "1 mm"}});
    assert_eq!(weight(buffer), [1.0, 0.0, 0.0, 0.0, 1.0, 1.0]);
    // Centers at ±0.25, ±0.75, ±1.25 mm; the second region lies in the first
    let regions =
        json!([{"radius_mm": [0.0, 1.0], "value": 2.0}, {"radius_mm": [0.0, 0.5], "value": 1.5}]);
    assert_eq!(
        weight(json!({"weights": {"void": 0.5, "regions": regions}})),
        [0.5, 1.0, 1.5, 3.0, 2.0, 1.0]
    );
    let tolerance = json!({"tolerance": {"part": 0.25, "regions": regions}});
    let tolerance = common(tolerance).voxel_weights(&ground).unwrap().tolerance;
    assert_eq!(room.array(tolerance), [0.0, 2.0, 3.5, 3.75, 2.25, 0.25]);
    let file = json!({"weights": {"file": "w.npy"}, "region": "void"});
    assert_eq!(weight(file), [1.0, 2.0, 3.0, 0.0, 0.0, 0.0]);
    assert_eq!(
        weight(json!({"region": {"radius_mm": [0.5, 1.0]}})),
        [0.0, 1.0, 0.0, 0.0, 1.0, 0.0]
    );
    assert_eq!(weight(json!({"region": {"z_mm": [0.1, 1.0]}})), [0.0; 6]);
    assert_eq!(
        common(json!({"bclp": {}})).voxel_weights(&ground).unwrap(),
        VoxelWeights::default()
    );
}

#[test]
fn cells_are_weighed_by_what_they_are() {
    let room = Room::row(&[0.0, 0.4, 1.0], false).cut();
    let json = json!({"weights": {"part": 3.0, "void": 2.0}, "tolerance": {"part": 0.5}});
    let voxel_weights = room.weigh(json).unwrap();
    // Three voxels, the middle one with its outside cell, and the inside cell behind them
    assert_eq!(voxel_weights.weight, [2.0, 2.0, 3.0, 3.0]);
    assert_eq!(voxel_weights.tolerance, [0.0, 0.0, 0.5, 0.5]);
    let json = json!({"region": "part"});
    let voxel_weights = room.weigh(json).unwrap();
    assert_eq!(voxel_weights.weight, [0.0, 0.0, 1.0, 1.0]);
    // On top of the shares: L = 3·0.4·(1 − 0.25)² inside and 2·0.6·0.25² outside
    let mut l2 = room.build("l2", json!({"surface": "cells"}));
    let weights = json!({"weights": {"part": 3.0, "void": 2.0}});
    let voxel_weights = room.weigh(weights).unwrap();
    l2.set_voxel_weights(&voxel_weights).unwrap();
    let dose = HostField::from_slice(&[0.0, 0.25, 1.0, 0.25]);
    let expected = 3.0 * 0.4 * 0.75f64.powi(2) + 2.0 * 0.6 * 0.25f64.powi(2);
    assert!((l2.value(&dose) - expected).abs() < 1e-6);
}

#[test]
fn edges_of_gray_targets_lose_weight() {
    let room = Room::row(&[0.0, 0.0, 0.5, 1.0, 1.0], true);
    let edge = json!({"weights": {"edge_per_mm": 1.0}});
    let field = room.weigh(edge.clone()).unwrap();
    // Gradients 0, 0.5, 1, 0.5, 0 per mm
    assert_eq!(room.array(field.weight), [1.0, 0.8, 0.5, 0.8, 1.0]);
    let part = Room::row(&[0.0, 1.0], false);
    refuses(part.weigh(edge), "weights.edge_per_mm");
}

#[test]
fn a_tolerance_widens_and_a_weight_scales_every_kind_of_band() {
    let part = [1.0f32, 1.0, 0.0, 0.0, 0.75];
    let dose = [0.5f32, 1.5, 0.25, 0.0, 0.5];
    for (json, gray) in [
        (json!({}), false),
        (json!({}), true),
        (json!({"surface": "fraction"}), false),
    ] {
        let room = Room::row(&part, gray);
        let field = |values: &[f32]| {
            room.layout
                .field_of(&Volume::new(room.layout.grid.clone(), values.to_vec()))
        };
        let dose = HostField::from_slice(&field(&dose));
        let plain = room.build("l2", json.clone());
        let mut gradient = dose.zeros_like();
        plain.value_and_gradient(&dose, &mut gradient);
        let scale = [1.0f32, 2.0, 0.0, 1.0, 0.5];
        let mut scaled = room.build("l2", json.clone());
        scaled
            .set_voxel_weights(&VoxelWeights {
                weight: field(&scale),
                ..VoxelWeights::default()
            })
            .unwrap();
        let mut slopes = dose.zeros_like();
        scaled.value_and_gradient(&dose, &mut slopes);
        let [plain, slopes] =
            [gradient, slopes].map(|g| room.layout.volume_of(g.as_slice()).values);
        for i in 0..5 {
            near!(slopes[i], scale[i] * plain[i], 1e-6, "{json} {gray}");
        }
        // Bands [f − ½, f + ½]: doses 0.5 and 1.5 are in the part's, 0.25 and 0 in the void's
        let mut wide = room.build("l2", json);
        wide.set_voxel_weights(&VoxelWeights {
            tolerance: field(&[0.5; 5]),
            ..VoxelWeights::default()
        })
        .unwrap();
        assert_eq!(wide.value(&dose), 0.0);
        assert!(
            wide.set_voxel_weights(&VoxelWeights {
                weight: vec![1.0; 3],
                ..VoxelWeights::default()
            })
            .is_err()
        );
    }
}

#[test]
fn a_band_that_no_dose_reaches_is_refused_unless_it_is_widened() {
    let room = Room::row(&[1.0, 0.0], false);
    let params = tomolith_core::response::logistic::Params {
        upper: 0.8,
        ..Default::default()
    };
    let response = Arc::new(tomolith_core::response::Logistic::new(params).unwrap());
    let input = room.input(response);
    for surface in ["voxel", "fraction"] {
        let section = Section::new("objective", json!({"l2": {"surface": surface}}));
        let mut objective = section.read(OBJECTIVES).unwrap().make(&input).unwrap();
        let text = objective.must_be_reached().unwrap_err().to_string();
        tomolith_core::contains!(text, "from 1 to 1", "0 to 0.8");
        let tolerance = vec![0.25; room.layout.len()];
        objective
            .set_voxel_weights(&VoxelWeights {
                tolerance,
                ..VoxelWeights::default()
            })
            .unwrap();
        objective.must_be_reached().unwrap();
    }
}

#[test]
fn every_row_with_fields_passes_the_check() {
    let model = SmallModel::new(18, 2, 21);
    let (target, labels) = model.ring();
    let layout = model.layout().clone();
    let numbers = noise(11, layout.len());
    let weight = |v: &f32| if *v < -0.5 { 0.0 } else { 1.0 + v };
    let voxel_weights = VoxelWeights {
        weight: numbers.iter().map(weight).collect(),
        tolerance: numbers.iter().map(|v| 0.05 * (1.0 + v)).collect(),
    };
    // A process window has no bands that could be wider
    let without_tolerance = VoxelWeights {
        weight: voxel_weights.weight.clone(),
        tolerance: Vec::new(),
    };
    let mut dose = HostField::from_slice(&noise(5, layout.len()));
    dose.scale(0.8);
    dose.shift(0.6);
    let input = ObjectiveInput {
        layout: &layout,
        labels: &labels,
        target: &target,
        response: Arc::new(Identity),
    };
    for row in OBJECTIVES {
        for surface in ["voxel", "fraction"] {
            let mut section = tomolith_core::check::example(row);
            section.value["surface"] = surface.into();
            let mut objective = (row.build)(&section).unwrap().make(&input).unwrap();
            if row.name == crate::process_window::NAME {
                assert!(objective.set_voxel_weights(&voxel_weights).is_err());
                objective.set_voxel_weights(&without_tolerance).unwrap();
            } else {
                objective.set_voxel_weights(&voxel_weights).unwrap();
            }
            check::objective(&*objective, &dose)
                .unwrap_or_else(|e| panic!("{} ({surface}): {e}", row.name));
        }
    }
}

#[test]
fn what_is_wrong_is_named() {
    for (json, key) in [
        (json!({"weight": -1}), "weight"),
        (json!({"region": "inside"}), "region.of"),
        (json!({"region": {"radius_mm": [2, 1]}}), "region.radius_mm"),
        (json!({"weights": {"part": -1}}), "weights.part"),
        (json!({"weights": {"edges": 1}}), "weights.edges"),
        (json!({"tolerance": {"void": -0.1}}), "tolerance.void"),
        (
            json!({"tolerance": {"regions": [{"value": 0.1}, {"value": -0.1}]}}),
            "tolerance.regions[1].value",
        ),
        (
            json!({"weights": {"regions": [{"value": 2, "z_mm": [1, 1]}]}}),
            "weights.regions[0].z_mm",
        ),
    ] {
        let key = format!("objectives[0].{key}");
        refuses(Common::split(Section::new("objectives[0]", json)), &key);
    }
    let folder = tempfile::tempdir().unwrap();
    let grid = VolumeGrid::centered([1, 1, 2], 0.5);
    let write = |name: &str, values: &[f32]| {
        let grid = VolumeGrid::centered([1, 1, values.len()], 0.5);
        write_volume(
            &folder.path().join(name),
            &Volume::new(grid, values.to_vec()),
            &Work::new(),
        )
        .unwrap();
    };
    write("good.npy", &[0.0, 2.0]);
    write("long.npy", &[0.0, 2.0, 1.0]);
    write("bad.npy", &[0.0, -2.0]);
    std::fs::write(folder.path().join("text.npy"), "no array").unwrap();
    for (file, says) in [
        ("good.npy", None),
        ("long.npy", Some("shape [1, 1, 3]")),
        ("bad.npy", Some("holds -2 at [")),
        ("text.npy", Some("a 3D .npy array")),
        ("none.npy", Some("a file that can be read")),
    ] {
        let common = common(json!({"weights": {"file": file}}));
        let checked = common.check_files(&grid, folder.path());
        match says {
            None => checked.unwrap(),
            Some(says) => {
                let text = checked.unwrap_err().to_string();
                assert!(
                    text.starts_with("weights.file") && text.contains(says),
                    "{text}"
                );
            }
        }
    }
}
