use crate::job::spec::import::*;

fn import(theirs: &str) -> Result<Imported> {
    crate::job::spec::import::import(theirs, &ImportFiles::unread())
}

const THEIRS: &str = r#"{
    "vial": { "type": "square", "w_int": 10.191, "w_ext": 12.408, "ior": 1.54, "medium": {
        "ior": 1.347, "extinction": 0.09, "albedo": 0.9, "phase": { "type": "rayleigh" } },
        "occlusions": [{ "filename": "rod.ply" }, { "filename": "lens.ply", "bsdf": { "type": "dielectric", "int_ior": 1.52 } }] },
    "projector": { "type": "lens", "n_patterns": 200, "resx": 200, "resy": 20,
        "cropx": 120, "crop_offset_x": 30, "fov": 5.0, "aperture_radius": 0.5,
        "focus_distance": 150, "distance": 152, "motion": "circular", "clockwise": true },
    "sensor": { "type": "dda", "scalex": 5, "scaley": 4, "scalez": 1.25, "film": { "type": "vfilm", "resx": 80, "resy": 100, "resz": 25 } },
    "target": { "filename": "box_hole.ply", "size": 4.0, "box_center_x": 0.5 },
    "loss": { "type": "threshold", "tl": 0.35, "tu": 0.55, "weight_sparsity": 0.1 },
    "filter_radon": true, "filter_corner": { "dist": 6.204, "radius": 0.2 }, "spp": 4, "spp_grad": 16, "max_depth": 6, "n_steps": 30, "output": "out/theirs" }"#;

#[test]
fn every_key_of_a_job_finds_its_place() {
    let found = import(THEIRS).unwrap();
    let job: Value = toml::from_str(&found.text).unwrap();
    let at = |pointer: &str| job.pointer(pointer).cloned().unwrap_or(Value::Null);
    assert_eq!(at("/grid/shape"), json!([100, 80, 25])); // resx counts along y
    assert_eq!(at("/grid/pitch_mm"), json!(0.05));
    assert_eq!(at("/resin/scattering_per_mm"), json!(0.9 * 0.09));
    assert_eq!(at("/vial/square/outer_width_mm"), json!(12.408));
    assert_eq!(
        at("/obstacles/1/material/dielectric/refractive_index"),
        json!(1.52)
    );
    assert_eq!(at("/light/0/rotation"), json!("counterclockwise"));
    let pitch = at("/light/0/projector/lens/pixel_pitch_mm")
        .as_f64()
        .unwrap();
    assert!((pitch - 300.0 * 2.5f64.to_radians().tan() / 200.0).abs() < 1e-12);
    let selection = json!({ "columns": [30, 120], "corner_radius_mm": 0.2 });
    assert_eq!(at("/light/0/selection"), selection);
    assert_eq!(at("/objective/threshold/upper"), json!(0.55));
    assert_eq!(at("/penalties/0/sparsity/exponent"), json!(4.0));
    assert_eq!(at("/stop/iterations"), json!(30));
    let notes = found.notes.join("\n");
    tomolith_core::contains!(notes, "filter_radon", "spp_grad", "max_depth", "0.551144");
}

fn changed(from: &str, to: &str) -> Result<Imported> {
    assert!(THEIRS.contains(from), "{from}");
    import(&THEIRS.replace(from, to))
}

/// The rows of a table, whose columns stand between arrows.
fn rows<const N: usize>(table: &str) -> impl Iterator<Item = [&str; N]> {
    let lines = table.trim().lines();
    lines.map(|line| {
        let columns: Vec<&str> = line.trim().split(" → ").collect();
        columns.try_into().unwrap()
    })
}

/// A value of the job, and all notes.
fn found(job: &Imported, pointer: &str) -> (Value, String) {
    let job_file: Value = toml::from_str(&job.text).unwrap();
    let value = job_file.pointer(pointer).cloned().unwrap_or(Value::Null);
    (value, job.notes.join("\n"))
}

#[test]
fn what_has_no_place_is_refused_by_name() {
    let slips = r#"
        "type": "lens" → "type": "conebeam" → projector.type
        "albedo": 0.9 → "albedo": 1.1 → vial.medium.albedo
        "scalez": 1.25 → "scalez": -1.0 → sensor.scalez
        "size": 4.0 → "size": -4.0 → target.size
        "w_int": 10.191 → "w_int": -10.191 → vial.w_int
        "ior": 1.54 → "ior": 0 → vial.ior
        "fov": 5.0 → "fov": 400 → projector.fov
        "fov": 5.0 → "pixel_size": -0.02 → projector.pixel_size
        "aperture_radius": 0.5 → "aperture_radius": -0.5 → projector.aperture_radius
        "focus_distance": 150 → "focus_distance": -150 → projector.focus_distance
        "distance": 152 → "distance": 0 → projector.distance
        "resz": 25 → "resz": 0 → sensor.film
        "crop_offset_x": 30 → "crop_offset_x": 81 → projector.cropx
        "type": "dielectric" → "type": "principled" → bsdf.type
        "rayleigh" → "sggx" → phase.type
        "n_steps" → "physical_model": { "type": "inhibitor" }, "n_steps" → physical_model
    "#;
    for [from, to, named] in rows(slips) {
        let text = changed(from, to).unwrap_err().to_string();
        assert!(text.contains(named), "{named}: {text}");
    }
}

#[test]
fn keys_that_are_not_read_there_are_noted() {
    let slips = r#"
        "n_steps" → "n_step" → n_step is left out: Dr.TVAM does not read it; did you mean `n_steps`
        "tl" → "tL" → loss.tL is left out
        "w_int" → "comment": "mine", "w_int" → vial.comment is left out
        "filter_radon" → "spp_final": 4, "filter_radon" → spp_final is left out
    "#;
    for [from, to, named] in rows(slips) {
        let job = changed(from, to).unwrap();
        assert!(
            job.notes.iter().any(|note| note.starts_with(named)),
            "{:?}",
            job.notes
        );
        assert!(job.text.contains(named), "{}", job.text);
    }
}

#[test]
fn voxels_that_are_no_cubes_become_cubes() {
    let cubes = |x: f64, y: f64, z: f64, counts: [u64; 3]| {
        let size: [f64; 3] = std::array::from_fn(|i| [x, y, z][i] * counts[i] as f64);
        crate::job::spec::import::cubes(size, [x, y, z], counts)
    };
    // Of the shortest edge
    assert_eq!(
        cubes(0.05, 0.05, 0.025, [100, 100, 50]),
        (0.025, [200, 200, 50])
    );
    assert_eq!(cubes(0.05, 0.05, 0.05, [10, 11, 12]), (0.05, [10, 11, 12]));
    // At most four times as many: 1 × 1 × 0.01 mm / 4 = 0.1357³ mm³
    let (pitch, shape) = cubes(1.0, 1.0, 0.01, [10, 10, 100]);
    assert!((pitch - 0.0025f64.cbrt()).abs() < 1e-12);
    assert_eq!(shape, [74, 74, 8]);
    let job = changed("\"scalez\": 1.25", "\"scalez\": 0.625").unwrap();
    let (shape, notes) = found(&job, "/grid/shape");
    assert_eq!(shape, json!([200, 160, 25]));
    assert!(notes.contains("0.05 × 0.05 × 0.025 mm"), "{notes}");
}

#[test]
fn spots_about_corners_reach_as_far_along_the_wall_as_there() {
    let radius = |dist: &str| {
        found(
            &changed("\"dist\": 6.204", dist).unwrap(),
            "/light/0/selection/corner_radius_mm",
        )
        .0
    };
    // Half of w_ext is 6.204 mm, the radius 0.2 mm
    assert_eq!(radius("\"dist\": 6.204"), json!(0.2));
    // 0.004 mm in front of the face: √(0.2² − 0.004²) along it, from 6.2 mm on
    let expected = 0.004 + (0.2f64.powi(2) - 0.004f64.powi(2)).sqrt();
    assert!((radius("\"dist\": 6.2").as_f64().unwrap() - expected).abs() < 1e-9);
    // Too far from the face
    let far = changed("\"dist\": 6.204", "\"dist\": 6.0").unwrap();
    let (selection, notes) = found(&far, "/light/0/selection");
    assert_eq!(selection, json!({ "columns": [30, 120] }));
    assert!(notes.contains("filter_corner is left out"), "{notes}");
    let round = THEIRS.replace(
        "\"square\", \"w_int\": 10.191, \"w_ext\": 12.408",
        "\"cylindrical\", \"r_int\": 5, \"r_ext\": 6",
    );
    assert!(found(&import(&round).unwrap(), "").1.contains("not square"));
}

#[test]
fn a_vial_inside_out_is_refused() {
    let walls = r#"
        "w_ext": 12.408 → "w_ext": 10.1 → vial.w_ext: found 10.1; accepted: more than the w_int of 10.191
        "square", "w_int": 10.191, "w_ext": 12.408 → "cylindrical", "r_int": 5, "r_ext": 4 → vial.r_ext: found 4; accepted: more than the r_int of 5
        "square", "w_int": 10.191, "w_ext": 12.408 → "double_cylindrical", "r_int_inner": 2, "r_ext_inner": 3, "r_int_outer": 3, "r_ext_outer": 6 → vial.r_int_outer: found 3
    "#;
    for [from, to, expected] in rows(walls) {
        assert!(THEIRS.contains(from), "{from}");
        let refused = import(&THEIRS.replace(from, to)).unwrap_err().to_string();
        assert!(refused.starts_with(expected), "{refused}");
    }
}

#[test]
fn bodies_do_what_they_do_there() {
    let material = |bsdf: &str, reflections: bool| {
        let bsdf = format!("\"rod.ply\", \"bsdf\": {bsdf}");
        let switch = format!("\"transmission_only\": {}, \"n_steps\"", !reflections);
        let theirs = THEIRS
            .replace("\"rod.ply\"", &bsdf)
            .replace("\"n_steps\"", &switch);
        let job = import(&theirs).unwrap();
        (
            found(&job, "/obstacles/0/material"),
            found(&job, "/model").0,
        )
    };
    let steel = r#"{ "type": "roughconductor", "eta": 1.5, "k": 2.8, "alpha": 0.04, "distribution": "ggx" }"#;
    let ((metal, notes), model) = material(steel, true);
    assert_eq!(
        metal,
        json!({ "metal": { "refractive_index": 1.5, "extinction_coefficient": 2.8 } })
    );
    tomolith_core::contains!(notes, "are left out: surfaces are smooth");
    assert_eq!(
        model,
        json!({ "monte_carlo": { "paths_per_pixel": 4, "reflections": true } })
    );
    // Without reflections light ends at whatever lets none through
    for bsdf in [
        steel,
        r#"{ "type": "diffuse" }"#,
        r#"{ "type": "conductor" }"#,
    ] {
        assert_eq!(material(bsdf, false).0.0, json!("black"));
    }
    let ((gray, _), _) = material(r#"{ "type": "diffuse" }"#, true);
    assert_eq!(gray, json!({ "diffuse": { "reflectance": 0.5 } }));
    let spectrum = r#"{ "type": "diffuse", "reflectance": { "type": "spectrum", "value": 0.0 } }"#;
    assert_eq!(material(spectrum, true).0.0, json!("black"));
    let ((named, notes), _) = material(r#"{ "type": "roughconductor", "material": "Al" }"#, true);
    assert_eq!(named, json!("mirror"));
    assert!(notes.contains("Al reflects all light"), "{notes}");
}

#[test]
fn weights_of_the_two_sides_of_the_part_become_two_objectives() {
    let objectives = |weights: &str| {
        let job = changed("\"tl\"", &format!("{weights}, \"tl\"")).unwrap();
        (
            found(&job, "/objectives").0,
            found(&job, "/objective/threshold/part_weight").0,
        )
    };
    let (both, _) = objectives("\"weight_object\": 2, \"weight_void\": 0.9");
    assert_eq!(both[0]["threshold"]["part_weight"], json!(1.0));
    assert_eq!(both[0]["threshold"]["void_weight"], json!(0.9));
    assert_eq!(both[1]["pm"]["rho_1"], json!(1.0));
    assert_eq!(both[1]["pm"]["rho_2"], json!(0.0));
    assert_eq!(both[1]["pm"]["d_h"], json!(0.55));
    let (both, _) = objectives("\"weight_limit\": 3");
    assert_eq!(both[1]["threshold"]["part_weight"], json!(2.0));
    assert_eq!(
        objectives("\"weight_object\": 2, \"weight_limit\": 2"),
        (Value::Null, json!(2.0))
    );
}

#[test]
fn a_surface_aware_film_asks_for_cells() {
    let job = changed(
        "\"type\": \"vfilm\"",
        "\"type\": \"vfilm\", \"surface_aware\": true",
    )
    .unwrap();
    let surface = found(&job, "/objective/threshold/surface").0;
    assert_eq!(surface, json!("cells"));
}

#[test]
fn files_get_the_paths_that_are_asked_for() {
    let theirs = THEIRS.replace(
        "\"n_patterns\"",
        "\"patterns\": \"start.npz\", \"n_patterns\"",
    );
    let files = ImportFiles {
        path: &|file| format!("../{file}"),
        // 10 × 4 × 1 of the file's units
        bounds: &|_| Some([[0.0; 3], [10.0, 4.0, 1.0]]),
    };
    let job = crate::job::spec::import::import(&theirs, &files).unwrap();
    let at = |pointer: &str| found(&job, pointer).0;
    assert_eq!(at("/target/mesh"), json!("../box_hole.ply"));
    assert_eq!(at("/obstacles/1/mesh"), json!("../lens.ply"));
    assert_eq!(at("/start/patterns/file"), json!("../start.npz"));
    // A part of 4 × 1.6 × 0.4 mm in 5 × 4 × 1.25 mm; of 6 mm the grid follows the part
    assert_eq!(at("/grid/shape"), json!([100, 80, 25]));
    let larger = theirs.replace("\"size\": 4.0", "\"size\": 6.0");
    let job = crate::job::spec::import::import(&larger, &files).unwrap();
    let (shape, notes) = found(&job, "/grid/shape");
    assert_eq!(shape, Value::Null);
    assert!(notes.contains("the part reaches beyond it"), "{notes}");
}

#[test]
fn keys_with_their_default_values_change_nothing() {
    let plain = import(THEIRS).unwrap();
    let defaults = r#"
        "n_steps" → "surface_aware": false, "n_steps"
        "type": "vfilm" → "type": "vfilm", "surface_aware": false
        "n_steps" → "progressive": false, "export_wasserstein_distance": false, "n_steps"
        "n_steps" → "time": 1, "transmission_only": true, "regular_sampling": false, "n_steps"
        "n_steps" → "psf_analysis": null, "physical_model": null, "final_sensor": null, "n_steps"
        "distance" → "tilt": 0.0, "filter_nonzero": false, "cropy": 20, "crop_offset_y": 0, "distance"
        "tl" → "reduction": "sum", "K": 2, "M": 4, "weight_limit": 1, "weight_object": 1.0, "tl"
        "n_steps" → "optimizer": { "type": "lbfgs" }, "n_steps"
        "size" → "scale_and_center": true, "box_center_z": 0, "size"
        "rod.ply" → "rod.ply", "bsdf": { "type": "diffuse", "reflectance": 0 }
    "#;
    for [from, to] in rows(defaults) {
        assert!(THEIRS.contains(from), "{from}");
        let found = import(&THEIRS.replacen(from, to, 1)).unwrap();
        assert_eq!(found, plain, "{to}");
    }
    let optimizer = |keys: &str| {
        let with = format!("\"optimizer\": {{ \"lr\": 0.1, {keys} }}, \"n_steps\"");
        import(&THEIRS.replace("\"n_steps\"", &with))
    };
    assert!(optimizer("\"type\": \"adam\", \"amsgrad\": false, \"uniform\": false").is_ok());
    assert!(optimizer("\"type\": \"sgd\", \"nesterov\": false, \"mask_updates\": false").is_ok());
    // What would change something is told or refused
    let text = optimizer("\"type\": \"adam\", \"amsgrad\": true")
        .unwrap_err()
        .to_string();
    assert!(
        text.starts_with("optimizer.amsgrad: found true; accepted: false"),
        "{text}"
    );
    let found =
        import(&THEIRS.replace("\"n_steps\"", "\"surface_aware\": true, \"n_steps\"")).unwrap();
    assert!(
        found
            .notes
            .iter()
            .any(|note| note.starts_with("surface_aware is left out"))
    );
}
