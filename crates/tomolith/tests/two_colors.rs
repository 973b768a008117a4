//! A whole two-color job: two gray designs become two sets of patterns, two movies and a map of stiffness (Wang et al. 2022, supplement).

use serde_json::Value;
use std::path::Path;
use tomolith::io::npy;
use tomolith::job::{Document, Job, Silent, run};
use tomolith::models::Run;

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

#[test]
fn two_gray_designs_become_two_movies_and_a_map_of_stiffness() {
    let images = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/images");
    let image = |name: &str| format!("{:?}", images.join(name).display().to_string());
    let mut document = Document::toml("two.toml", JOB).unwrap();
    let epoxy = format!(
        "species[1].target={{ image = {}, size_mm = 1.2, height_mm = 0.1 }}",
        image("rings.png")
    );
    for change in [format!("target.image={}", image("wheel-all.png")), epoxy] {
        document.set(&change).unwrap();
    }
    let folder = tempfile::tempdir().unwrap();
    let own = folder.path().join("run");
    let job = Job::from_document(document).unwrap();
    run(
        &job.with_folder(&own, "--output"),
        false,
        &mut Silent,
        &Run::new(),
    )
    .unwrap();
    for file in [
        "frames/violet",
        "frames/uv",
        "wheel-all_violet_10rpm.mp4",
        "wheel-all_uv_10rpm.mp4",
        "dose_epoxy.npy",
    ] {
        assert!(own.join(file).exists(), "{file}");
    }
    let (_, modulus) = npy::read_volume(&own.join("modulus.npy")).unwrap();
    let mut solid: Vec<f32> = modulus.into_iter().filter(|v| v.is_finite()).collect();
    solid.sort_by(f32::total_cmp);
    assert!(solid.len() > 100, "{}", solid.len());
    let (soft, stiff) = (solid[solid.len() / 20], solid[solid.len() * 19 / 20]);
    assert!(solid[0] >= 5.0 && solid[solid.len() - 1] <= 9100.0);
    assert!(stiff > 30.0 * soft, "{soft} {stiff}");
    let report: Value =
        serde_json::from_slice(&std::fs::read(own.join("report.json")).unwrap()).unwrap();
    assert!(report["species"].is_array() || report["species"].is_object());
    let html = std::fs::read_to_string(own.join("report.html")).unwrap();
    assert!(html.contains("modulus") && html.contains("MPa"));
}
