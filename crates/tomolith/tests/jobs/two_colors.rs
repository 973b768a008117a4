//! A whole two-color job: two gray designs become two sets of patterns, two movies and a map of stiffness (Wang et al. 2022, supplement).

use crate::{Finished, image, job_of};
use serde_json::Value;
use tomolith::io::npy;
use tomolith::job::Silent;

const JOB: &str = r#"
    target = { size_mm = 1.2, height_mm = 0.1, gray = true }
    grid = { pitch_mm = 0.05 }
    resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
    vial = { index_matched = { radius_mm = 1.0 } }
    objective = "l2"
    stop = { iterations = 20 }
    evaluate = { refine = 2 }
    light = [
        { name = "violet", pixels = [30, 4], angles = 24, projector = { collimated = { pixel_pitch_mm = 0.05 } } },
        { name = "uv", pixels = [30, 4], angles = 24, projector = { collimated = { pixel_pitch_mm = 0.05 } } },
    ]
    species = [
        { name = "acrylate", driven_by = { violet = 1.0, uv = 0.3 } },
        { name = "epoxy", driven_by = { uv = 1.0 } },
    ]

    # 5.1 MPa to 9.1 GPa, supplement, Table 2
    [[property]]
    name = "modulus"
    unit = "MPa"
    of = "epoxy"
    over = "acrylate"
    map = { logistic = { lower = 0.705, upper = 3.959, midpoint = 0.5, steepness = 10.0 } }
    log10 = true
"#;

/// The report of a run with these changes, its folder, and what is said at its end.
fn report(changes: &[String]) -> (Value, tempfile::TempDir, String) {
    let rings = image("image", "rings.png");
    let epoxy = format!("species[1].target={{ {rings}, size_mm = 1.2, height_mm = 0.1 }}");
    let targets = [image("target.image", "wheel-all.png"), epoxy];
    let job = job_of(JOB, &[&targets, changes].concat()).unwrap();
    let run = Finished::run(job, &mut Silent);
    (run.report(), run.place, run.summary.to_string())
}

/// What limits a species are the steps from a perfect print to the predicted one.
fn assert_limits_add_up(species: &Value) {
    let losses = species["limits"].as_array().unwrap().iter();
    let lost: f64 = losses
        .map(|limit| limit["loss_in_iou"].as_f64().unwrap())
        .sum();
    let iou = species["evaluation"]["iou"].as_f64().unwrap();
    assert!((1.0 - lost - iou).abs() < 1e-6, "{species}");
}

#[test]
fn two_species_are_judged_at_one_exposure() {
    let changes = [
        "target.gray=false",
        "species[1].target.gray=false",
        "objective=\"threshold\"",
        "resin.critical_dose_mj_per_mm3=0.5",
        "printer={ peak_irradiance_mw_per_cm2 = 20.0 }",
    ];
    let (report, folder, summary) = report(&changes.map(str::to_owned));
    let together = &report["one_exposure"]["iou"];
    let ious_of = |s: usize| {
        let alone = report["species"][s]["evaluation"]["iou"].as_f64().unwrap();
        (alone, together[s].as_f64().unwrap())
    };
    for (alone, together) in [ious_of(0), ious_of(1)] {
        assert!(together > 0.2 && together <= alone + 1e-9, "{report}");
    }
    // Neither's own best dose has a lowest IoU that is larger
    let lowest = ious_of(0).1.min(ious_of(1).1);
    for s in [0, 1] {
        let threshold = report["species"][s]["evaluation"]["gel_threshold"]
            .as_f64()
            .unwrap();
        let at = |s: usize| {
            let curve = report["species"][s]["evaluation"]["iou_curve"].as_array();
            let points = curve.unwrap().iter();
            let nearest = points.min_by(|a, b| {
                let off = |p: &Value| (p[0].as_f64().unwrap() - threshold).abs();
                off(a).total_cmp(&off(b))
            });
            nearest.unwrap()[1].as_f64().unwrap()
        };
        assert!(at(0).min(at(1)) <= lowest + 0.02, "{s}");
    }
    let html = std::fs::read_to_string(folder.path().join("run/report.html")).unwrap();
    assert!(html.contains("At one exposure for all the species reach"));
    // The exposure is that of all species, on the page and at the end of the run
    let limits = report["one_exposure"]["limited_by"].as_str().unwrap();
    assert_eq!(
        limits,
        if ious_of(0).1 <= ious_of(1).1 {
            "acrylate"
        } else {
            "epoxy"
        }
    );
    let sentence = format!("{limits} limits it");
    assert!(
        summary.contains(&sentence) && html.contains(&sentence),
        "{summary}"
    );
    for name in ["acrylate", "epoxy"] {
        tomolith_core::contains!(summary, &format!("\n{name}: Predicted IoU"));
        assert!(html.contains(&format!("\"name\":\"{name}\",\"sentence\":\"Predicted IoU")));
    }
    assert_eq!(report["limits"], report["species"][0]["limits"]);
    assert_limits_add_up(&report["species"][1]);
    tomolith_core::contains!(
        html,
        "Finer pixels of uv on the same field (more light.pixels) may bring more"
    );
    tomolith_core::contains!(summary, "acrylate:", "epoxy:");
    let percent = |end: &str| report["one_exposure"]["percent"][end].as_f64();
    assert!(percent("low").is_none_or(|low| low < 100.0) && percent("best") == Some(100.0));
    assert!(report["species"][1]["exposure"]["dose"]["best"].is_number());
    // What the machine is told brings that dose
    let text = std::fs::read(folder.path().join("run/exposure.json")).unwrap();
    let exposure: Value = serde_json::from_slice(&text).unwrap();
    let time = |light: usize| {
        exposure["lights"][light]["budget"]["time_s"]
            .as_f64()
            .unwrap()
    };
    let best = report["one_exposure"]["time_s"]["best"].as_f64().unwrap();
    assert!(((time(0) + time(1)) / best - 1.0).abs() < 1e-6, "{best}");
}

#[test]
fn two_gray_designs_become_two_movies_and_a_map_of_stiffness() {
    let (report, folder, summary) = report(&[]);
    let run_folder = folder.path().join("run");
    for file in [
        "frames/violet",
        "frames/uv",
        "wheel-all_violet_10rpm.mp4",
        "wheel-all_uv_10rpm.mp4",
        "dose_epoxy.npy",
    ] {
        assert!(run_folder.join(file).exists(), "{file}");
    }
    let (_, modulus) = npy::read_volume(&run_folder.join("modulus.npy")).unwrap();
    let mut solid: Vec<f32> = modulus.into_iter().filter(|v| v.is_finite()).collect();
    solid.sort_by(f32::total_cmp);
    assert!(solid.len() > 100, "{}", solid.len());
    let (soft, stiff) = (solid[solid.len() / 20], solid[solid.len() * 19 / 20]);
    assert!(solid[0] >= 5.0 && solid[solid.len() - 1] <= 9100.0);
    assert!(stiff > 30.0 * soft, "{soft} {stiff}");
    // Gray values have no IoU: each species has an exposure of its own
    assert!(report["one_exposure"].is_null());
    tomolith_core::contains!(summary, "acrylate: The best exposure has an rms error");
    tomolith_core::contains!(summary, "epoxy: The best exposure has an rms error");
    let html = std::fs::read_to_string(run_folder.join("report.html")).unwrap();
    assert!(html.contains("That is acrylate. epoxy: The response of"));
    assert!(html.contains("modulus") && html.contains("MPa"));
}
