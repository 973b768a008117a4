//! Targets that cannot be printed, and what is asked of them that they cannot have.

use super::*;

/// An STL box between two corners.
fn stl_box([low, high]: [[f64; 3]; 2]) -> String {
    const FACES: [[usize; 4]; 6] = [
        [0, 1, 3, 2],
        [4, 6, 7, 5],
        [0, 4, 5, 1],
        [2, 3, 7, 6],
        [0, 2, 6, 4],
        [1, 5, 7, 3],
    ];
    let corner = |i: usize| {
        let [x, y, z] = [i >> 2, i >> 1, i].map(|bit| bit & 1);
        let pick = |axis: usize, upper: usize| [low, high][upper][axis];
        format!("vertex {} {} {}\n", pick(0, x), pick(1, y), pick(2, z))
    };
    FACES
        .iter()
        .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
        .map(|points| {
            let points: String = points.map(|i| corner(*i)).concat();
            format!("facet normal 0 0 0\nouter loop\n{points}endloop\nendfacet\n")
        })
        .collect()
}

#[test]
fn bodies_that_contradict_each_other_are_refused() {
    let bench = Bench::beside_a_run();
    let solid = |name: &str, boxes: &[[[f64; 3]; 2]]| {
        let facets: String = boxes.iter().copied().map(stl_box).collect();
        bench.write(name, &format!("solid a\n{facets}endsolid a\n"));
    };
    let (first, overlapping) = (
        [[0.0, 0.0, 0.0], [2.0, 2.0, 1.0]],
        [[1.0, 1.0, 0.0], [3.0, 2.0, 1.0]],
    );
    solid("a.stl", &[first]);
    solid("b.stl", &[overlapping]);
    solid("two.stl", &[first, [[3.0, 0.0, 0.0], [4.0, 1.0, 1.0]]]);
    let job = |bodies: &str| JOB.replace("phantom = \"gear\"\nsize_mm = 2.0", bodies);
    let keep_dark = "role = \"keep-dark\"";
    bench.refused_before_work(&job(&format!(
            "size_mm = 2.0\n[[target.body]]\nmesh = \"a.stl\"\n[[target.body]]\nmesh = \"b.stl\"\n{keep_dark}"
        )),
        &[
            "target.body[1]: this body (keep-dark) and body[0] (print) share",
            "a printed body that overlaps no insert and no keep-dark body",
            "job.toml:5:",
        ],
    );
    for (components, line, parts) in [
        (
            ["[1]", "[3]"],
            7,
            ["target.body[1].components: component 3", "2 components"],
        ),
        (
            ["[1]", "[1]"],
            7,
            ["component 1, which body[0] has too", "2 components"],
        ),
        (
            ["[1]", "[]"],
            7,
            ["no body has component 2", "1.0000 about"],
        ),
    ] {
        let [a, b] = components;
        let bodies = format!(
            "mesh = \"two.stl\"\nsize_mm = 2.0\n[[target.body]]\ncomponents = {a}\n[[target.body]]\ncomponents = {b}\n{keep_dark}"
        );
        let place = format!("job.toml:{line}:");
        bench.refused_before_work(&job(&bodies), &[parts[0], parts[1], &place]);
    }
}

#[test]
fn images_of_different_sizes_are_no_stack() {
    let bench = Bench::beside_a_run();
    fs::create_dir(bench.path("slices")).unwrap();
    for (i, width) in [8u32, 8, 9].into_iter().enumerate() {
        let file = fs::File::create(bench.path(&format!("slices/{i}.png"))).unwrap();
        let mut encoder = png::Encoder::new(file, width, 8);
        encoder.set_color(png::ColorType::Grayscale);
        let pixels = vec![255; width as usize * 8];
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(&pixels).unwrap();
    }
    let job = JOB.replace("phantom = \"gear\"", "stack = \"slices\"\nheight_mm = 0.5");
    bench.refused_before_work(
        &job,
        &[
            "target.stack: ",
            "2.png: slice 3 has 9 × 8 pixels, the first one",
            "images of one size",
            "job.toml:2:",
        ],
    );
}

#[test]
fn a_dose_that_is_zero_everywhere_stops_osmo_and_keeps_its_patterns() {
    let bench = Bench::beside_a_run();
    let job = JOB
        .replace(
            "[objective.threshold]",
            "[optimizer.osmo]\n[objective.osmo]",
        )
        .replace("lower = 0.85\nupper = 0.95", "d_l = 0.01\nd_h = 0.02")
        .replace("iterations = 2", "iterations = 30");
    let why = "optimizer: normalizing by the largest dose, but the dose became zero everywhere";
    let advice = "accepted: use thresholds closer to 1";
    bench.refused(&job, &[], &[why, advice, "job.toml:"]);
    assert!(bench.run_folder().join("checkpoint/patterns.npz").exists());
    let report = fs::read_to_string(bench.run_folder().join("report.json")).unwrap();
    assert_eq!(report, "{\"earlier\": true}");
}

#[test]
fn meshes_that_cannot_be_printed_are_refused() {
    let bench = Bench::beside_a_run();
    let facet = |points: [[f32; 3]; 3]| {
        let vertices: String = points
            .iter()
            .map(|[x, y, z]| format!("vertex {x} {y} {z}\n"))
            .collect();
        format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
    };
    let flat_sheet = format!(
        "solid a\n{}{}endsolid a\n",
        facet([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        facet([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
    );
    let mut truncated = vec![0u8; 80];
    truncated.extend(1000u32.to_le_bytes());
    truncated.extend([0u8; 70]);
    for (name, content) in [
        ("missing.stl", None),
        ("empty.stl", Some(Vec::new())),
        ("truncated.stl", Some(truncated)),
        ("flat.stl", Some(flat_sheet.into_bytes())),
        ("none.stl", Some(b"solid a\nendsolid a\n".to_vec())),
    ] {
        if let Some(content) = content {
            bench.write(name, &content);
        }
        let job = JOB.replace("phantom = \"gear\"", &format!("mesh = \"{name}\""));
        bench.refused_before_work(&job, &[name]);
    }
}

#[test]
fn a_gray_image_has_an_objective_of_its_own_and_refuses_that_of_part_and_void() {
    let bench = Bench::beside_a_run();
    let gray = of_gray_image();
    let line = 1 + gray[..gray.find("[objective").unwrap()]
        .matches('\n')
        .count();
    let (place, others) = (
        format!("job.toml:{line}:"),
        "l2, l1, dose_matching and bclp",
    );
    let parts = [
        "objective.threshold: ",
        "the target is gray",
        others,
        &place,
    ];
    bench.refused(&gray, &[], &parts);
    let default = gray.replace("[objective.threshold]\nlower = 0.85\nupper = 0.95\n", "");
    let output = bench.tomolith(&default, &["--quiet"]);
    assert_eq!(output.status.code(), Some(0));
    let resolved = fs::read_to_string(bench.run_folder().join("job.toml")).unwrap();
    assert!(resolved.contains("[objective.l2]"), "{resolved}");
}

/// The job with a gray image as its target.
fn of_gray_image() -> String {
    let image = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/images/rings.png");
    let target = format!("image = \"{}\"\nheight_mm = 0.5", image.display());
    JOB.replace("phantom = \"gear\"", &target)
}

#[test]
fn goals_of_part_and_void_are_refused_for_gray_values() {
    let bench = Bench::beside_a_run();
    let threshold = "threshold]\nlower = 0.85\nupper = 0.95";
    let gray = of_gray_image().replace(threshold, "bclp]\nepsilon = 0.05");
    for (from, to, mark, parts) in [
        (
            "iterations = 2",
            "iou = 0.9",
            "iou",
            ["stop.iou: needs a target of part and void", "stop.loss"],
        ),
        (
            "[stop]",
            "[evaluate]\nrequire_iou = 0.9\n[stop]",
            "require_iou",
            [
                "evaluate.require_iou: needs a target of part and void",
                "evaluate.require_in_band",
            ],
        ),
    ] {
        let job = gray.replace(from, to);
        let line = 1 + job[..job.find(mark).unwrap()].matches('\n').count();
        let place = format!("job.toml:{line}:");
        bench.refused_before_work(&job, &[parts[0], parts[1], &place]);
    }
    // What the start asks for is known with the voxels only: the brightest rings are above 0.7
    let job = gray.replace(
        "epsilon = 0.05",
        "epsilon = 0.35\n[response.logistic]\nupper = 0.7",
    );
    let parts = [
        "response: the start needs a dose",
        "from 0 to 0.7",
        "job.toml:25:",
    ];
    bench.refused(&job, &[], &parts);
    let report = fs::read_to_string(bench.run_folder().join("report.json")).unwrap();
    assert_eq!(report, "{\"earlier\": true}");
    for (asked, code) in [("1.0", 1), ("0.0", 0)] {
        let option = format!("evaluate.require_in_band={asked}");
        let output = bench.tomolith(&gray, &["--set", &option]);
        assert_eq!(output.status.code(), Some(code), "{asked}");
    }
}

#[test]
fn pixels_in_micrometers_are_blamed_where_voxels_follow_them() {
    let bench = Bench::beside_a_run();
    let job = JOB.replace("[grid]\npitch_mm = 0.1", "");
    let pixels = ["--set", "light.projector.collimated.pixel_pitch_mm=50"];
    let found = "light[0].projector: a pixel is 50 mm wide, the part 2 mm long";
    bench.refused(&job, &pixels, &[found, "\"50 um\""]);
}
