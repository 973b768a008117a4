use super::run::{columns, flatten, in_sweep};
use super::*;
use std::collections::BTreeMap;
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::work::Work;

fn run(name: &str, iou: f64, memory: &str) -> ComparedRun {
    let mut flat = BTreeMap::new();
    let job: Value = toml::from_str(&format!(
        "[optimizer.lbfgs]\nmemory = {memory}\n[[light]]\npixels = [3, 4]"
    ))
    .unwrap();
    flatten("", &job, &mut flat);
    ComparedRun {
        name: name.to_owned(),
        report: json!({
            "schema": "tomolith.report/1", "part": "gear <b>",
            "evaluation": {
                "iou": iou, "ver": 0.1, "surface_mean_mm": 0.012,
                "iou_curve": [[0.0, 0.2], [0.5, iou], [1.0, 0.0]],
                "histogram": { "range": [0.0, 1.0], "part": [0, 1, 9], "void": [8, 2, 0] },
            },
            "lights": [{ "budget": { "time_s": null, "light_used": 0.2 } }],
            "time": [{ "best_jaccard": iou, "best_s": 40.0, "window_s": [39.5, 41.0] }],
            "history": { "loss": 0.5, "iterations": 2 },
        }),
        job: flat,
        dose: None,
        page: None,
        job_text: String::new(),
        history: columns(
            "iteration,loss,forward_calls,adjoint_calls,seconds,iou\n0,4,1,0,0.1,\n1,2,2,1,0.2,0.8\n2,0.5,4,2,0.4,\n",
        ),
    }
}

#[test]
fn runs_of_a_sweep_are_named_by_their_axes() {
    let sweep = tempfile::tempdir().unwrap();
    let rows = json!([
        { "id": "9edf", "values": [0.5, "adam", 0.99] },
        { "id": "c13d", "values": [0.6, "lbfgs", null] },
    ]);
    let table = json!({ "axes": ["lower", "method"], "rows": rows });
    std::fs::write(sweep.path().join("table.json"), table.to_string()).unwrap();
    let run = |id: &str| in_sweep(&sweep.path().join("runs").join(id));
    assert_eq!(run("c13d").unwrap(), "lower 0.6, method lbfgs");
    assert_eq!(run("abcd"), None);
}

#[test]
fn doses_of_all_runs_are_on_the_page() {
    let mut runs = [run("rays", 0.99, "10"), run("waves", 0.9, "10")];
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("dose.npy");
    let dose = Volume::filled(VolumeGrid::centered([3, 4, 5], 0.1), 1.0);
    tomolith_io::npy::write_volume(&path, &dose, &Work::new()).unwrap();
    runs[1].dose = Some(path);
    let grid = json!({ "shape_zyx": [6, 8, 10], "pitch_mm": 0.05, "center_xyz_mm": [0, 0, 1] });
    runs[1].report["evaluation"]["grid"] = grid;
    let page = compare_page(&runs).unwrap();
    assert_eq!(page.data["runs"][0]["volumes"], json!([]));
    let dose = &page.data["runs"][1]["volumes"][0];
    assert_eq!(dose["id"], "response");
    assert_eq!(dose["shape_zyx"], json!([3, 4, 5]));
    assert_eq!(dose["pitch_mm"], 0.1);
    assert_eq!(dose["center_xyz_mm"], json!([0.0, 0.0, 1.0]));
    assert_eq!(page.blobs[0].0, "blob-1-response");
    // A number that is missing in a table is null
    let history = &page.data["runs"][0]["history"];
    assert_eq!(history["iou"], json!([null, 0.8, null]));
    assert!(page.html().contains("gear \\u003cb>"));
}

#[test]
fn nothing_is_best_of_a_run_that_prints_nothing_or_beside_another_model() {
    let mut runs = [run("rays", 0.99, "10"), run("dark", 0.99, "10")];
    let compare = |runs: &[ComparedRun]| compare_page(runs).unwrap().data["compare"].clone();
    assert_eq!(compare(&runs)["prints"], json!([true, true]));
    runs[1].report["evaluation"]["part"] = json!({ "max": 0.0 });
    let compared = compare(&runs);
    assert_eq!(compared["prints"], json!([true, false]));
    assert_eq!(compared["marks_best"], true);
    let warnings = compared["warnings"].to_string();
    tomolith_core::contains!(warnings, "Nothing of the part turns solid in dark");
    let alone = "2 species by 2 lights, each alone: parallel (distance-driven kernel)";
    runs[1].report["run"] = json!({ "models": { "evaluation": alone } });
    let compared = compare(&runs);
    assert_eq!(compared["models"], json!([null, "parallel"]));
    assert_eq!(compared["marks_best"], false);
}

#[test]
fn simulations_are_told_from_optimizations() {
    let mut runs = [run("made", 0.99, "10"), run("given", 0.9, "10")];
    runs[1].report["history"] = Value::Null;
    let kinds = &compare_json(&runs)["kinds"];
    assert_eq!(*kinds, json!(["optimization", "simulation"]));
}

/// The numbers of all runs in a row of the page.
fn values_of(json: &Value, key: &str) -> Value {
    let rows = json["numbers"].as_array().unwrap();
    rows.iter().find(|row| row["key"] == key).unwrap()["values"].clone()
}

#[test]
fn scenarios_have_rows_in_runs_that_have_them() {
    let mut runs = [run("a", 0.9, "10"), run("b", 0.95, "5"), run("c", 0.9, "5")];
    let row = |name: &str, iou: f64| json!({ "name": name, "iou_at_threshold": iou });
    runs[0].report["scenarios"] = json!({
        "worst_iou": 0.91, "window": -0.02, "rows": [row("the job", 0.99), row("Wide vial", 0.91)]
    });
    runs[1].report["scenarios"] = json!({
        "worst_iou": 0.93, "window": -0.03, "rows": [row("the job", 0.98), row("pale", 0.93)]
    });
    let json = compare_json(&runs);
    let row_of = |key: &str| values_of(&json, key);
    assert_eq!(row_of("worst_iou"), json!([0.91, 0.93, null]));
    assert_eq!(row_of("scenarios_pw"), json!([-0.02, -0.03, null]));
    assert_eq!(row_of("iou_in_wide_vial"), json!([0.91, null, null]));
    assert_eq!(row_of("iou_in_pale"), json!([null, 0.93, null]));
}

#[test]
fn numbers_stand_side_by_side() {
    let runs = [run("a", 0.9, "10"), run("b", 0.95, "5")];
    let json = compare_json(&runs);
    for (key, value) in [
        ("window_s", 1.5),
        ("model_calls", 6.0),
        ("optimization_s", 0.4),
    ] {
        assert_eq!(values_of(&json, key), json!([value, value]), "{key}");
    }
    assert_eq!(values_of(&json, "iou"), json!([0.9, 0.95]));
    for row in json["numbers"].as_array().unwrap() {
        let key = row["key"].as_str().unwrap();
        let is_snake = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        assert!(key.chars().all(is_snake), "{key}");
    }
    assert_eq!(
        json["differing_keys"],
        json!([{ "key": "optimizer.lbfgs.memory", "values": ["10", "5"] }])
    );
}

#[test]
fn runs_without_history_or_curves_still_make_a_page() {
    let mut bare = run("bare", 0.5, "1");
    bare.history.clear();
    bare.report["evaluation"] = json!({ "iou": 0.5 });
    let page = compare_page(&[bare]).unwrap();
    assert_eq!(page.data["runs"][0]["history"], json!({}));
    let warnings = page.data["compare"]["warnings"].to_string();
    tomolith_core::contains!(warnings, "hold no curves");
    assert!(page.plain.contains("<th>bare</th>"));
}

#[test]
fn folders_that_are_no_runs_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let why = |path: &Path| read_runs(&[path]).unwrap_err().to_string();
    tomolith_core::contains!(
        why(folder.path()),
        "no report.json in it",
        "accepted: the folder of a run"
    );
    let report = folder.path().join("report.json");
    tomolith_core::contains!(why(&report), "there is no such folder");
    std::fs::write(&report, "{\"schema\": \"other\"}").unwrap();
    tomolith_core::contains!(why(&report), "a file, not a folder");
    assert!(matches!(
        read_runs(&[folder.path()]),
        Err(Error::Format { .. })
    ));
    assert!(matches!(
        read_runs(&[] as &[&Path]),
        Err(Error::Config { .. })
    ));
}
