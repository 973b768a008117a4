//! The commands beside `run`: each does its work, says it as JSON, and refuses bad input with exit code 2.

use crate::bench::{Bench, JOB, doubles};
use serde_json::Value;
use std::fs;
use std::process::Command;

#[test]
fn meshes_and_phantoms_become_voxels() {
    let bench = Bench::new();
    let cylinder = bench
        .json("phantom cylinder --set size_mm=2 --set height_mm=1 --pitch-mm 0.05 --output c.npy");
    let exact = std::f64::consts::PI;
    assert!((cylinder["exact_volume_mm3"].as_f64().unwrap() - exact).abs() < 1e-9);
    assert!(
        (cylinder["volume_mm3"].as_f64().unwrap() / exact - 1.0).abs() < 2e-3,
        "{cylinder}"
    );
    let shape: Vec<u64> = serde_json::from_value(cylinder["shape_zyx"].clone()).unwrap();
    let bytes = fs::read(bench.path("c.npy")).unwrap();
    assert_eq!(bytes.len() as u64, 128 + 4 * shape.iter().product::<u64>());
    // A unit cube as a mesh: 10 × 10 × 10 voxels of it are inside
    let corner = |i: usize| format!("v {} {} {}\n", i & 1, i >> 1 & 1, i >> 2);
    let corners: String = (0..8).map(corner).collect();
    let faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    bench.write("cube.obj", &(corners + faces));
    let cube = bench.json("voxelize cube.obj --pitch-mm 0.1 --binary --output cube.vti");
    assert_eq!(cube["part_voxels"], 1000);
    bench.done("phantom gear --pitch-mm 0.2 --output gear.png --quiet");
    let slice =
        bench.json("phantom cylinder --pitch-mm 0.1 --shape 60 56 1 --clip --output slice.npy");
    assert_eq!(slice["shape_zyx"], serde_json::json!([1, 56, 60]));
    let disc = std::f64::consts::PI * 2.5 * 2.5 * 0.1;
    assert!((slice["volume_mm3"].as_f64().unwrap() / disc - 1.0).abs() < 2e-3);
    let none = "phantom cylinder --pitch-mm 0.1 --shape 60 56 0 --output none.npy";
    bench.refuse(none, &["--shape"]);
    assert_eq!(fs::read(bench.path("gear.png")).unwrap()[..4], *b"\x89PNG");

    // Two faces that share an edge are missing: a hole that is neither flat nor small
    let open = bench.read("cube.obj");
    let open = open.replace("f 3 7 8 4\n", "").replace("f 2 4 8 6\n", "");
    bench.write("open.obj", &open);
    let voxels = "voxelize open.obj --pitch-mm 0.1 --output o.npy";
    bench.refuse(voxels, &["--repair force"]);
    bench.says(0, &format!("{voxels} --repair force"), &["warning"]);
    bench.says(
        0,
        "voxelize cube.obj --pitch-mm 50 --output p.npy",
        &["no voxel is at least half inside"],
    );
    // 1200³ voxels: the pitch alone makes no file of 6.9 GB
    bench.refuse(
        "voxelize cube.obj --pitch-mm 0.001 --output large.npy",
        &[
            "--pitch-mm: ",
            "a file of 6912 MB",
            "--shape 1200 1200 1200",
        ],
    );
    bench.refuse(
        "phantom gear --pitch-mm -1 --output a.npy",
        &["--pitch-mm: -1"],
    );

    bench.refuse_each(
        "$ phantom gaer --pitch-mm 0.1 --output a.npy
        error: NAME: unknown kind `gaer` … did you mean `gear`?
        $ phantom gear --set tooth=4 --pitch-mm 0.1 --output a.npy
        tooth
        $ phantom gear --pitch-mm 0 --output a.npy
        --pitch-mm
        $ phantom gear --pitch-mm 0.1 --output a.txt
        .png, .npy, .vti, .nrrd, .tif or .ome.zarr
        $ voxelize none.stl --pitch-mm 0.1 --output a.npy
        none.stl",
    );
}

#[test]
fn what_an_evaluation_saw_has_the_numbers_of_its_report() {
    let bench = Bench::new();
    bench.done("run job.toml -o out --set output.evaluation=true");
    let report = bench.report("out");
    let of_report = &report["evaluation"];
    let pitch = of_report["grid"]["pitch_mm"].as_f64().unwrap();
    let found = bench.json(&format!(
        "metrics out/evaluation/response.npy out/evaluation/target.npy --labels out/evaluation/labels.npy --pitch-mm {pitch}"
    ));
    for name in ["iou", "ver", "pw", "gel_threshold", "surface_mean_mm"] {
        assert!(of_report[name].is_f64(), "{name}");
        assert_eq!(found["evaluation"][name], of_report[name], "{name}");
    }
    // The next run removes what it does not write
    bench.done("run job.toml -o out");
    assert!(!bench.path("out/evaluation").exists());
}

#[test]
fn volumes_for_other_programs_hold_the_same_numbers() {
    let bench = Bench::new();
    let formats = r#"--set output.volumes=["nrrd","tiff","ome-zarr"]"#;
    bench.done(&format!("run job.toml -o out {formats}"));
    let measured = |dose: &str, ending: &str| {
        bench.json(&format!(
            "metrics {dose} out/volumes/target.{ending} --labels out/volumes/label.{ending}"
        ))
    };
    let expected = measured("out/dose.npy", "nrrd");
    assert!(expected["evaluation"]["iou"].as_f64().unwrap() > 0.5);
    for ending in ["nrrd", "tif"] {
        let dose = format!("out/volumes/dose.{ending}");
        assert_eq!(measured(&dose, ending), expected, "{ending}");
    }
    for array in ["dose", "target", "label"] {
        let level = format!("out/volumes/{array}.ome.zarr/0/zarr.json");
        assert!(bench.path(&level).is_file(), "{level}");
    }
    // The next run removes what it does not write
    bench.done("run job.toml -o out");
    assert!(!bench.path("out/volumes").exists());
}

#[test]
fn several_slips_are_told_in_one_run() {
    let bench = Bench::with(&[(
        "job.toml",
        &JOB.replace("refractive_index", "ior")
            .replace("iterations", "iteratons"),
    )]);
    let ended = bench.ended(2, "check job.toml");
    let message = String::from_utf8(ended.stderr).unwrap();
    let [first, second] = ["resin.ior", "stop.iteratons"].map(|key| message.find(key).unwrap());
    assert!(
        first < second && message.contains("did you mean `refractive_index`?"),
        "{message}"
    );
    let line = bench.ended(2, "check job.toml --json").stdout;
    let line: Value = serde_json::from_slice(&line).unwrap();
    assert_eq!(line["errors"][1]["key"], "stop.iteratons");
    assert_eq!(line["errors"][1]["nearest"], "iterations");
}

#[test]
fn anybodys_arrays_are_measured() {
    let bench = Bench::new();
    bench.write("dose.npy", &doubles("2, 2", &[0.2, 0.8, 0.9, 0.4]));
    bench.write("target.npy", &doubles("2, 2", &[0.0, 1.0, 1.0, 0.0]));
    let found = bench.json("metrics dose.npy target.npy");
    let near = |value: &Value, expected: f64| {
        assert!(
            (value.as_f64().unwrap() - expected).abs() < 1e-6,
            "{value} {expected}"
        )
    };
    near(&found["evaluation"]["iou"], 1.0);
    near(&found["evaluation"]["pw"], 0.4);
    let published = |name: &str| {
        let list = found["published"].as_array().unwrap();
        list.iter().find(|one| one["name"] == name).unwrap()["value"].clone()
    };
    near(&published("pw"), 0.4);
    assert_eq!(found["slices"].as_array().unwrap().len(), 1);
    near(&found["slices"][0]["pw"], 0.4);
    near(&published("ipdr"), 0.1);
    let output = bench.says(0, "metrics dose.npy target.npy", &["as published:"]);
    // Lengths in voxels are not called mm
    assert!(
        output.contains(" hausdorff ") && !output.contains("_mm"),
        "{output}"
    );
    assert_eq!(found["lengths_in"], "voxel");
    let (text, evaluation) = (found.to_string(), &found["evaluation"]);
    assert!(!text.contains("_mm") && !text.contains("\"mm"), "{text}");
    near(&evaluation["over_voxel3"], 0.0);
    near(&evaluation["grid"]["pitch_voxel"], 1.0);
    let scaled = bench.json("metrics dose.npy target.npy --pitch-mm 0.1");
    near(&scaled["evaluation"]["over_mm3"], 0.0);
    bench.says(
        0,
        "metrics dose.npy target.npy --pitch-mm 0.1",
        &[" hausdorff_mm "],
    );

    bench.write("other.npy", &doubles("1, 4", &[0.0; 4]));
    bench.refuse(
        "metrics dose.npy other.npy",
        &["expected shape [1, 2, 2], found [1, 1, 4]"],
    );
    bench.refuse("metrics dose.npy target.npy --pitch-mm 0", &["--pitch-mm"]);
    bench.write("nan.npy", &doubles("2, 2", &[0.2, f64::NAN, 0.9, 0.4]));
    bench.refuse(
        "metrics nan.npy target.npy",
        &["NaN at [0, 0, 1], as [z, y, x]"],
    );
    bench.write("dark.npy", &doubles("2, 2", &[-0.2, 0.8, 0.9, -1.5]));
    let expected = "dark.npy: 2 of 4 doses are below 0, the least -1.5";
    bench.says(0, "metrics dark.npy target.npy", &["warning", expected]);
    let warned = bench.json("metrics dark.npy target.npy")["warnings"].to_string();
    assert!(warned.contains(expected), "{warned}");
    assert_eq!(found["warnings"], serde_json::json!([]));
    bench.write("bytes.npy", &doubles("2, 2", &[0.0, 255.0, 128.0, 0.0]));
    bench.write("mask.npy", &doubles("2, 2", &[0.0, 255.0, 255.0, 0.0]));
    bench.write("one.npy", &doubles("2, 2", &[0.0, 1.0, 1.0, 0.0]));
    let metrics_of = |target: &str| bench.json(&format!("metrics dose.npy {target}"));
    assert_eq!(metrics_of("mask.npy"), metrics_of("one.npy"));
    bench.write("none.npy", &doubles("2, 2", &[0.0; 4]));
    bench.refuse_each(
        "$ metrics dose.npy none.npy
        none.npy: no voxel of the part
        $ metrics dose.npy bytes.npy
        bytes.npy: a value of 255 … divide 8-bit values by 255
        $ metrics dose.npy mask.npy --gray --epsilon -1
        epsilon
        $ metrics dose.npy target.npy --trim-percent -1
        --trim-percent: found -1
        $ metrics dose.npy target.npy --threshold NaN
        error: --threshold: found NaN",
    );
}

#[test]
fn runs_are_compared_and_exported() {
    let bench = Bench::new();
    bench.done("run job.toml --quiet --output a");
    bench.done("run job.toml --quiet --output b --set stop.iterations=8");
    bench.write("mine.html", "<html>mine");
    bench.refuse_each(
        "$ compare a b --output mine.html
        `mine.html` is there already
        $ compare a b --output a/report.html
        `a/report.html` is there already",
    );
    bench.done("compare a --output page.html --quiet");
    // An earlier comparison is replaced
    let found = bench.json("compare a b --output page.html");
    assert_eq!(found["differing_keys"][0]["key"], "stop.iterations");
    assert_eq!(
        found["differing_keys"][0]["values"],
        serde_json::json!(["4", "8"])
    );
    let page = bench.read("page.html");
    assert!(page.contains("\"kind\":\"compare\"") && page.contains("id=\"blob-1-response\""));

    let exported =
        bench.json("export a --output frames --set output.rpm=20 --set printer.quarter_turns=1");
    assert_eq!(exported["lights"][0]["canvas"], serde_json::json!([16, 32]));
    assert_eq!(exported["lights"][0]["movie"], "gear_20rpm.mp4");
    assert!((exported["lights"][0]["frame_rate"].as_f64().unwrap() - 8.0).abs() < 1e-3);
    assert!(bench.path("frames/frames/frame_0023.png").is_file());

    bench.refuse("export a --output frames", &["is not empty"]);
    let lossless = bench.json("export a --output lossless --set output.movie=lossless");
    assert_eq!(lossless["lights"][0]["movie"], "gear_10rpm.mov");
    // A folder of exported frames stands for its frames
    bench.done("export a --output plain --quiet");
    bench.done("simulate job.toml --patterns plain --output again --quiet");
    let kinds = &bench.json("compare a again")["kinds"];
    assert_eq!(*kinds, serde_json::json!(["optimization", "simulation"]));
    bench.refuse("export job.toml --output c", &["is a file, and no folder"]);
    bench.refuse(
        "export a --printer job.toml --output c",
        &["holds no [printer]"],
    );
    bench.refuse("export a --printer a --output c", &["--printer: `a` is a"]);
    bench.refuse(
        "export a --printer opencol --output c",
        &["did you mean `opencal`", "(from --printer opencol)"],
    );
    let of_profile = bench.json("export a --printer opencal --output profile");
    assert_eq!(
        of_profile["lights"][0]["canvas"],
        serde_json::json!([1920, 1080])
    );
    bench.done("run job.toml --toy --output toy --quiet");
    bench.says(
        0,
        "export toy --output of_toy",
        &["the frames of a toy of the job"],
    );
    bench.write("toy/report.json", "{}");
    for line in ["export toy --output c", "view toy --no-browser"] {
        bench.refuse(line, &["toy/report.json: no `schema`"]);
    }
    // What an export does not read changes nothing, and is refused
    for key in [
        "resin.absorption_per_mm",
        "light[0].angles",
        "output.folder",
        "outputs.rpm",
    ] {
        bench.says(
            2,
            &format!("export a --output c --json --set {key}=3"),
            &[
                &format!("an export does not read `{key}`"),
                "keys of [printer]",
            ],
        );
    }
    bench.refuse(
        "export a --output c --set printer.canvas=[20,20]",
        &["printer.canvas", "need 32 × 16"],
    );
    bench.refuse("compare a nowhere", &["nowhere", "no such folder"]);
    assert!(!bench.path("c").exists());
}

#[test]
fn calibration_frames_are_drawn_for_a_canvas_and_for_a_job() {
    let bench = Bench::new();
    let drawn = bench.json("calibrate --canvas 64 48 --output all");
    assert_eq!(drawn["files"].as_array().unwrap().len(), 7);
    for file in drawn["files"].as_array().unwrap() {
        assert!(bench.path(file.as_str().unwrap()).is_file(), "{file}");
    }
    bench.write(
        "machine.toml",
        &format!("{JOB}[printer]\ncanvas = [40, 60]\nquarter_turns = 1\n"),
    );
    bench.done("calibrate --job machine.toml orientation border --output two --quiet");
    assert_eq!(fs::read_dir(bench.path("two")).unwrap().count(), 2);
    bench.refuse(
        "calibrate --canvas 64 48 boarder --output x",
        &["did you mean `border`?"],
    );
    bench.refuse(
        "calibrate --canvas 64 48 border border --output x",
        &["`border` twice"],
    );
    bench.refuse("calibrate --canvas 64 48 --bits 17 --output x", &["--bits"]);
    bench.refuse("calibrate --canvas 64 0 --output x", &["canvas"]);
    bench.refuse("calibrate --canvas 64 48 --output all", &["is not empty"]);
}

#[test]
fn the_dose_model_of_a_small_job_is_a_matrix() {
    let bench = Bench::new();
    let small = "--set grid.pitch_mm=0.4 --set light.angles=5";
    let found = bench.json(&format!("export-matrix job.toml {small} --output m.npz"));
    assert_eq!(found["columns"], 5 * 32 * 16);
    let (rows, entries) = (
        found["rows"].as_u64().unwrap(),
        found["entries"].as_u64().unwrap(),
    );
    // Every voxel in the field is lit by a pixel or more of each of the five frames
    assert!(entries >= 5 * rows, "{found}");
    // While the vial turns, by more of them than where it stands
    let line = format!("export-matrix job.toml {small} --set light.sub_angles=1 --output s.npz");
    let standing = bench.json(&line)["entries"].as_u64().unwrap();
    assert!(entries > standing, "{entries}, {standing}");
    assert_eq!(fs::read(bench.path("m.npz")).unwrap()[..2], *b"PK");
    bench.refuse("export-matrix job.toml --output m.txt", &[".npz"]);
    bench.refuse("export-matrix none.toml --output m.npz", &["none.toml"]);
    // As a job's model: the file is looked at first, and named with its key
    let job = format!("{small} --set evaluate.refine=1 --set evaluate.sub_angles=1");
    bench.done(&format!(
        "check job.toml {job} --set model.matrix.file=m.npz"
    ));
    bench.write("torn.npz", b"PK");
    // A file that is missing is told before what it could not be asked for
    bench.refuse(
        &format!("check job.toml {small} --set model.matrix.file=none.npz"),
        &["model.matrix.file"],
    );
    for (change, wanted) in [
        ("model.matrix.file=none.npz", "none.npz"),
        ("model.matrix.file=torn.npz", "scipy.sparse.save_npz"),
        (
            "model.matrix.file=m.npz --set light.angles=6",
            "matrix [voxels, pixels]",
        ),
    ] {
        let message = bench.expect(2, &format!("run job.toml {job} --set {change}"));
        let message = message.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            message.contains("model.matrix.file")
                && message.contains(wanted)
                && !message.contains("optimizing"),
            "{message}"
        );
    }
    // Without --json the stages are told
    bench.says(
        0,
        &format!("export-matrix job.toml {small} --output n.npz"),
        &["lighting every pixel"],
    );
}

#[test]
fn the_unit_systems_of_a_dose_want_all_that_their_formulas_need() {
    let bench = Bench::new();
    bench.write("dose.npy", &doubles("1, 1, 2", &[0.4, 0.2]));
    bench.write("target.npy", &doubles("1, 1, 2", &[1.0, 0.0]));
    let line = "metrics dose.npy target.npy --absorption-per-mm 0.1";
    let found = bench.json(&format!("{line} --brightest 2 --exposure-s 10"));
    let rows = found["unit_systems"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    // 2 mJ/mm² in 10 s are 0.02 W/cm², and a dose of 0.3 over 1 per cm is 0.3 J/cm²
    assert_eq!(rows[3]["system"], "areal_rate");
    assert!((rows[3]["pattern"][0].as_f64().unwrap() - 0.02).abs() < 1e-12);
    assert!((rows[3]["dose"][0].as_f64().unwrap() - 0.3).abs() < 1e-6);
    assert!(bench.json("metrics dose.npy target.npy")["unit_systems"].is_null());
    bench.refuse(line, &["--brightest"]);
    bench.refuse(
        &format!("{line} --brightest 0 --exposure-s 10"),
        &["--brightest", "a finite number above 0"],
    );
}

#[test]
fn files_go_into_folders_that_exist_and_pages_are_web_pages() {
    let bench = Bench::new();
    for line in [
        "phantom gear --pitch-mm 0.1 --output no/gear.npy",
        "compare a --output no/page.html",
        "export-matrix job.toml --output no/m.npz",
        "trace job.toml --pixel 0,1,1 --output no/light.npy",
    ] {
        bench.refuse(line, &["--output", "no folder `no`"]);
    }
    // A file in the place of a folder
    for (line, what) in [
        ("man job.toml", "job.toml: it cannot be made"),
        (
            "analyze buildup --radius-mm 8 --penetration-mm 8 --output job.toml/x",
            "job.toml: it cannot be made",
        ),
        (
            "calibrate --canvas 64 48 --output job.toml",
            "--output: `job.toml` is no folder",
        ),
    ] {
        bench.refuse(line, &[what]);
    }
    bench.refuse("check .", &["a folder", "a job file, such as ./job.toml"]);
    bench.refuse("sweep .", &["a folder", "a sweep file"]);
    bench.refuse(
        "trace job.toml --light 3 --pixel 0,0,0",
        &["--light: there is no light 3", "lights below 1"],
    );
    bench.refuse("new gray.toml --part gratings", &["--part", "gray values"]);
    bench.refuse("new job2.json", &["FILE", "ending in .toml"]);
    bench.refuse("kinds printer nope", &["`nope` of the table `printer`"]);
    bench.write("part.stl", "solid part\n");
    bench.refuse_each(
        "$ run part.stl
        a mesh … tomolith new job.toml --part part.stl
        $ phantom gear --pitch-mm 1e300 --output gear.npy
        --pitch-mm: 1e300 mm … at most 1000 mm
        $ compare a --output page.txt
        `page.txt` has another ending … .html",
    );
}

#[test]
fn light_that_is_scattered_is_traced() {
    let bench = Bench::new();
    let line = "trace job.toml --pixel 0,16,8 --set resin.scattering_per_mm=0.3 --json";
    let traced = &bench.events(0, line)[0];
    // The job goes order by order and names no number of paths
    assert_eq!(traced["result"]["paths"], 4096);
    let account = traced["result"]["account"].as_object().unwrap();
    let total: f64 = account.values().map(|v| v.as_f64().unwrap()).sum();
    assert!((total - 1.0).abs() < 1e-9, "{account:?}");
    assert!(account["absorbed"].as_f64().unwrap() > 0.1, "{account:?}");
    assert!(!traced["result"]["segments"].as_array().unwrap().is_empty());
}

#[test]
fn light_that_is_no_ray_is_not_traced() {
    let bench = Bench::new();
    for model in ["wave", "incoherent_cone"] {
        let line = format!(
            "trace job.toml --pixel 0,16,8 --set vial={{index_matched={{radius_mm=3.0}}}} --set model={{{model}={{}}}}"
        );
        let message = bench.says(2, &line, &[&format!("model.{model}:")]);
        assert!(message.contains("model={rays={}}"), "{message}");
    }
}

#[test]
fn waves_have_no_matrix_and_light_that_spreads_says_how_large_its_is() {
    let bench = Bench::new();
    let job = "job.toml --output m.npz --set vial={index_matched={radius_mm=3.0}}";
    bench.refuse(
        &format!("export-matrix {job} --set model={{wave={{}}}}"),
        &["not linear in the patterns", "[model.incoherent_cone]"],
    );
    assert!(!bench.path("m.npz").exists());
    let small = "--set grid.shape=[4,4,2] --set grid.clip=true --set light.pixels=[32,16] --set light.angles=3";
    let line = format!("export-matrix {job} {small} --set model={{incoherent_cone={{}}}}");
    let output = bench.expect(0, &line);
    // 32 voxels, 1536 pixels
    assert!(output.contains("4.92e4 entries"), "{output}");
}

#[test]
fn levels_that_are_too_small_to_be_made_are_told() {
    let bench = Bench::new();
    bench.says(
        0,
        "check job.toml --set multiresolution.levels=5",
        &["multiresolution.levels = 5"],
    );
}

#[test]
fn a_job_of_another_program_is_translated_and_can_be_checked() {
    let bench = Bench::new();
    let theirs = r#"{
        "target": { "filename": "part.stl", "size": 2.0 },
        "vial": { "type": "cylindrical", "r_int": 3, "r_ext": 3.4, "ior": 1.5,
            "medium": { "ior": 1.48, "extinction": 0.1, "albedo": 0.0 } },
        "projector": { "type": "collimated", "n_patterns": 24, "resx": 32, "resy": 16, "pixel_size": 0.1, "distance": 20,
            "motion": "circular" },
        "sensor": { "type": "dda", "scalex": 2.4, "scaley": 2.4, "scalez": 1.2,
            "film": { "type": "vfilm", "resx": 24, "resy": 24, "resz": 12 } },
        "n_steps": 3 }"#;
    bench.write("theirs.json", theirs);
    let done = bench.json("import theirs.json --output ours.toml");
    assert!(done["notes"][0].as_str().unwrap().contains("0.456"));
    let ours = bench.read("ours.toml");
    let job: toml::Value = toml::from_str(&ours).unwrap();
    assert_eq!(
        job["vial"]["cylinder"]["outer_radius_mm"].as_float(),
        Some(3.4)
    );
    // Nothing is written over, and what cannot be mapped is named
    bench.refuse(
        "import theirs.json --output ours.toml",
        &["is there already"],
    );
    // A key that they do not read is left out with a note
    bench.write("slip.json", &theirs.replace("n_steps", "n_stepps"));
    let line = "import slip.json --output slip.toml";
    bench.says(0, line, &["did you mean `n_steps`"]);
    bench.refuse(
        "import job.toml --output wrong.toml",
        &["it is no JSON (expected ident at line 1 column 3), as jobs of"],
    );
    bench.write("empty.json", "{}");
    bench.says(
        2,
        "import empty.json --output wrong.toml --json",
        &["sensor: the key is missing; accepted: a job of Dr.TVAM"],
    );
}

/// What an optimization wants pixels to be, [angle, row, column]: the job with these keys of its light, and further tables.
fn wanted(bench: &Bench, name: &str, light: &str, tables: &str) -> Vec<f32> {
    let job = JOB.replace("pixels = [32, 16]", light) + tables;
    bench.write(&format!("{name}.toml"), &job);
    bench.done(&format!("run {name}.toml --quiet --output {name}"));
    let file = bench.path(name).join("patterns.npz");
    let mut arrays = tomolith::io::npy::read_patterns(&file).unwrap();
    arrays.remove(0).raw.unwrap()
}

#[test]
fn a_part_of_the_projector_is_a_smaller_image_beside_the_axis() {
    let bench = Bench::new();
    let inside = |row: usize, column: usize| (1..14).contains(&row) && (4..30).contains(&column);
    let image: Vec<f64> = (0..16 * 32)
        .map(|i| f64::from(u8::from(inside(i / 32, i % 32))))
        .collect();
    bench.write("mask.npy", &doubles("16, 32", &image));
    let crop = "pixels = [32, 16]\nselection = { columns = [4, 26], rows = [1, 13] }";
    let mask = "pixels = [32, 16]\nselection.mask = \"mask.npy\"";
    // Columns 4 to 29 have their middle 0.1 mm beside that of 32, rows 1 to 13 theirs 0.05 mm above that of 16
    let small = "pixels = [26, 13]\noffset_mm = [0.1, 0.05]";
    // Pixels of twice the width lie otherwise in the smaller image, and so the lowest ceiling may be another
    let bound = "[bounds]\nceiling = \"start\"\n";
    for (model, tables) in [("parallel", ""), ("rays", "[model.rays]\n")] {
        let tables = format!("{bound}{tables}");
        let run =
            |name: &str, light: &str| wanted(&bench, &format!("{model}-{name}"), light, &tables);
        let cropped = run("crop", crop);
        assert_eq!(cropped, run("mask", mask));
        let smaller = run("beside", small);
        let most = cropped.iter().copied().fold(0.0, f32::max);
        let mut inner = smaller.iter();
        for (i, &value) in cropped.iter().enumerate() {
            if inside(i / 32 % 16, i % 32) {
                let other = inner.next().unwrap();
                assert!((value - other).abs() < 1e-3 * most, "{i}: {value} {other}");
            } else {
                assert_eq!(value, 0.0);
            }
        }
        assert!(most > 0.0 && inner.next().is_none());
    }
}

#[test]
fn pixels_that_may_not_be_lit_or_cannot_be_or_bring_little_stay_dark() {
    let bench = Bench::new();
    let image = |value: f64, at: [usize; 2]| {
        let here = |i: usize| [i / 32, i % 32] == at;
        let values: Vec<f64> = (0..16 * 32)
            .map(|i| if here(i) { value } else { 1.0 - value })
            .collect();
        doubles("16, 32", &values)
    };
    bench.write("mask.npy", &image(0.0, [7, 15]));
    bench.write("dead.npy", &image(1.0, [8, 17]));
    let plain = wanted(&bench, "plain", "pixels = [32, 16]", "");
    let chosen = wanted(
        &bench,
        "chosen",
        "pixels = [32, 16]\nselection = { mask = \"mask.npy\", min_contribution = 0.3 }",
        "[printer]\ndead_pixels = \"dead.npy\"\n",
    );
    let lit = |values: &[f32], [row, column]: [usize; 2]| {
        (0..24).any(|frame| values[(frame * 16 + row) * 32 + column] > 0.0)
    };
    for at in [[7, 15], [8, 17]] {
        assert!(lit(&plain, at) && !lit(&chosen, at), "{at:?}");
    }
    assert!(lit(&chosen, [7, 16]) && lit(&chosen, [8, 16]));
    let count = |values: &[f32]| values.iter().filter(|v| **v > 0.0).count();
    let (few, all) = (count(&chosen), count(&plain));
    assert!(few > 0 && few + 48 < all, "{few} {all}");
}

#[test]
fn a_background_lights_pixels_that_miss_the_part_and_none_that_may_not_be_lit() {
    let bench = Bench::new();
    let background = 0.01;
    let light = "pixels = [32, 16]\nselection.columns = [1, 31]";
    let dark = wanted(&bench, "dark", light, "");
    let tables = format!("[bounds]\nmin = {background}\n");
    let lit = wanted(&bench, "lit", light, &tables);
    let mut missing = 0;
    for (i, (&dark, &lit)) in dark.iter().zip(&lit).enumerate() {
        let (row, column) = (i / 32 % 16, i % 32);
        if column == 0 {
            assert_eq!([dark, lit], [0.0; 2], "{i}");
            continue;
        }
        assert!(lit >= background, "{i}: {lit}");
        // A corner of the image is far from the part, which more light there cannot help
        if [row, column] == [0, 1] {
            assert_eq!([dark, lit], [0.0, background], "{i}");
            missing += 1;
        }
    }
    assert_eq!(missing, 24);
}

/// Where nothing can be written, every command that prints ends with 2 and one line.
#[test]
#[cfg(target_os = "linux")]
fn a_full_standard_output_is_told() {
    let bench = Bench::new();
    bench.write("job.toml", JOB);
    for line in [
        "schema",
        "schema --markdown",
        "kinds",
        "kinds vial --json",
        "check job.toml",
        "phantom gear --pitch-mm 0.5 --output a.npy",
        "--help",
        "--version",
    ] {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_tomolith"))
            .current_dir(bench.temp.path())
            .args(line.split(' '))
            .stdout(full)
            .output()
            .unwrap();
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{line}: {message}");
        let last = message.lines().last().unwrap_or_default();
        assert!(
            last.contains("standard output: No space left"),
            "{line}: {message}"
        );
        assert_eq!(
            message.matches("standard output").count(),
            1,
            "{line}: {message}"
        );
    }
}

/// Asked to stop in the middle of a large file, a command without stages ends with 130 and leaves nothing.
#[test]
#[cfg(unix)]
fn ctrl_c_ends_the_writing_of_voxels_and_leaves_nothing_half_written() {
    let bench = Bench::new();
    fs::remove_file(bench.path("job.toml")).unwrap();
    let line = "phantom cylinder --shape 350 350 350 --output c.npy";
    let mut child = Command::new(env!("CARGO_BIN_EXE_tomolith"))
        .current_dir(bench.temp.path())
        .args(line.split(' '))
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    let names = || {
        let entries = fs::read_dir(bench.temp.path()).unwrap();
        let names = entries.map(|e| e.unwrap().file_name().into_string().unwrap());
        names.collect::<Vec<_>>()
    };
    while names().is_empty() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let pid = child.id().to_string();
    let kill = Command::new("kill").args(["-INT", &pid]).status();
    assert!(kill.unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert!(names().is_empty(), "{:?}", names());
}
