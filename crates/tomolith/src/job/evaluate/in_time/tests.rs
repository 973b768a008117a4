use super::TimeSummary;
use crate::field::Field;
use crate::job::evaluate::in_time::*;
use crate::job::resolve::material::{domain, resin};
use crate::job::resolve::optics::tests::key as key_of;
use crate::job::tests::{document_of, job_of};
use crate::job::{Document, Job, ResolvedJob, Silent};
use serde_json::Value;

const DISC: &str = r#"
    target = { phantom = { sphere = {} }, size_mm = 1.2 }
    grid = { pitch_mm = 0.1 }
    resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
    vial = { index_matched = { radius_mm = 2.0 } }
    light = [{ pixels = [24, 20], angles = 24, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
    stop = { iterations = 12 }
    evaluate = { refine = 1, sub_angles = 1 }
    schedule = { seconds_per_turn = 5.0, turns = 8, power = { energy_per_turn_mj_per_mm2 = 0.25 }, snapshots = 2 }
    [[material.photopolymer.networks]]
    name = "resin"
    curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } }
    inhibitors = [{ capacity_mj_per_mm3 = 0.25, diffusion_mm2_per_s = 1e-4 }]
"#;

fn job(changes: &[&str]) -> Result<Job> {
    Job::from_document(document_of(DISC, changes))
}

/// The report of a run, and its folder.
fn report(changes: &[&str]) -> (Value, tempfile::TempDir) {
    let folder = tempfile::tempdir().unwrap();
    let job = job(changes).unwrap();
    let job = job.with_folder(&folder.path().join("run"), "--output");
    crate::job::run(&job, false, &mut Silent, &Work::new()).unwrap();
    let text = std::fs::read(folder.path().join("run/report.json")).unwrap();
    (serde_json::from_slice(&text).unwrap(), folder)
}

#[test]
fn a_job_with_a_schedule_prints_in_time() {
    let (report, folder) = report(&[]);
    let time = &report["time"][0];
    let number = |key: &str| time[key].as_f64().unwrap();
    // Nothing is solid before oxygen is used up: 0.75 of the dose that is asked for in all, of 2 that are sent
    let (begin, best) = (number("induction_end_s"), number("best_s"));
    assert!(
        begin > 5.0 && best >= begin && best <= 40.0,
        "{begin} {best}"
    );
    assert!(number("best_jaccard") > 0.7, "{time}");
    let iou = time["evaluation"]["iou"].as_f64().unwrap();
    assert!((iou - number("best_jaccard")).abs() < 1e-9);
    // The page shows the print at any time, and the degree of cure at that moment
    let html = std::fs::read_to_string(folder.path().join("run/report.html")).unwrap();
    let moment = format!(
        "degree of cure after {} s",
        crate::report::number::significant(best, 3)
    );
    tomolith_core::contains!(html, "\"kind\":\"cure_time\"", &moment);
    for file in ["time.csv", "cure_time.npy", "print.mp4"] {
        assert!(folder.path().join("run").join(file).exists(), "{file}");
    }
}

#[test]
fn a_movie_has_a_few_hundred_slices_however_many_steps_a_print_takes() {
    let keys = ["schedule.step_s=0.02", "stop.iterations=1"];
    let (report, folder) = report(&keys);
    let movie = report["movies"].as_array().unwrap();
    assert!(!movie.is_empty());
    // 2000 moments: every fourth one, 500, is too many, so every eighth
    let rows = std::fs::read_to_string(folder.path().join("run/time.csv")).unwrap();
    assert!(rows.lines().count() > 1000, "{}", rows.lines().count());
    let movie = std::fs::read(folder.path().join("run/print.mp4")).unwrap();
    let stsz = movie.windows(4).position(|w| w == b"stsz").unwrap();
    let count = u32::from_be_bytes(movie[stsz + 12..stsz + 16].try_into().unwrap());
    assert!((240..480).contains(&count), "{count} slices");
}

#[test]
fn a_print_that_ends_too_soon_says_how_far_it_came() {
    let share = |turns: &str, who: &str| {
        let folder = tempfile::tempdir().unwrap();
        let job = job(&[turns, "stop.iterations=4"]).unwrap();
        let job = job.with_folder(&folder.path().join("run"), "--output");
        let summary = crate::job::run(&job, false, &mut Silent, &Work::new()).unwrap();
        let network = &summary.in_time[0];
        let share = network.largest_share.unwrap();
        assert!(network.ideal_exposure_s.is_none());
        let percent = crate::report::number::significant(100.0 * share, 3);
        let expected = format!("{who} {percent} % of what the part needs");
        assert!(network.to_string().contains(&expected), "{network}");
        share
    };
    // Half of the light leaves half of the dose
    let one = share("schedule.turns=1", "the part absorbs");
    let half = share("schedule.turns=0.5", "the part absorbs");
    assert!(
        one > 0.1 && one < 0.5 && (one / half - 2.0).abs() < 0.1,
        "{one} {half}"
    );
}

#[test]
fn shaded_light_and_two_networks_print_too() {
    let (report, folder) = report(&[
        "species=[{ name = \"soft\" }, { name = \"hard\", driven_by = { light = 0.5 } }]",
        "material.photopolymer.networks=[{ name = \"soft\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } } }, { name = \"hard\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } } }]",
        "material.photopolymer.shading=[{ light = 0, active_per_mm = [0.1, 0.1], attenuation_per_mm = [0.1, 0.5] }]",
    ]);
    let begin = |i: usize| report["time"][i]["induction_end_s"].as_f64().unwrap();
    // Half the drive takes twice as long, and a little more behind what is solid by then
    let ratio = begin(1) / begin(0);
    assert!((1.8..2.6).contains(&ratio), "{ratio}");
    assert!(folder.path().join("run/time_hard.csv").exists());
}

#[test]
fn patterns_against_the_degree_of_cure_end_at_the_gel_point() {
    for against in ["frozen", "exact"] {
        let change = format!("schedule.optimize=\"{against}\"");
        let (report, _folder) = report(&[&change, "schedule.turns=4"]);
        let time = &report["time"][0];
        let last = time["curves"]["jaccard"]
            .as_array()
            .unwrap()
            .last()
            .unwrap();
        let last = last.as_f64().unwrap();
        let best = time["best_jaccard"].as_f64().unwrap();
        assert!(last > 0.8 && last > best - 0.05, "{against}: {last} {best}");
    }
}

#[test]
fn a_dose_that_diffuses_is_that_of_every_model_spread() {
    let task = |change: &str, diffusion: &str| {
        let diffusion = format!("material={{ diffusion = {{ mm2_per_s = {diffusion} }} }}");
        let changes = [&diffusion, change, "resin.critical_dose_mj_per_mm3=0.8"];
        let job = ResolvedJob::new(&job(&changes).unwrap()).unwrap();
        job.task(&Work::new()).unwrap()
    };
    for change in [
        "model=\"parallel\"",
        "model=\"rays\"",
        "light[0].projector={ telecentric = { pixel_pitch_mm = 0.1, aperture_radius_mm = 1.0, working_distance_mm = 100.0 } }",
        "species=[{ name = \"a\", driven_by = { light = 0.7 } }]",
    ] {
        let (sharp, blurred) = (task(change, "0"), task(change, "5e-4"));
        let sums_of = |task: &crate::job::Task| {
            let dose = crate::check::dose(&*task.model, &sharp.start);
            let sum = dose.as_slice().iter().map(|v| f64::from(*v)).sum::<f64>();
            (sum, dose.dot(&dose))
        };
        // What diffuses stays in the box; 40 s at 5e-4 mm²/s spread it by 0.14 mm
        let ((all, squares), (spread, lower)) = (sums_of(&sharp), sums_of(&blurred));
        tomolith_core::near!(spread / all, 1.0, 1e-4, "{change}: {all}");
        assert!(lower < 0.995 * squares, "{change}: {squares} {lower}");
        let model = blurred.model.describe();
        assert!(model.contains("diffused at 0.0005 mm²/s"), "{model}");
    }
}

#[test]
fn a_job_whose_dose_diffuses_runs_to_its_report() {
    let iou = |diffusion: &str| {
        let material = format!("material={{ diffusion = {{ mm2_per_s = {diffusion} }} }}");
        let changes = [
            &material,
            "resin.critical_dose_mj_per_mm3=0.8",
            "schedule.power={ energy_mj_per_mm2 = 1.2 }",
            "target={ phantom = \"gear\", size_mm = 1.8 }",
        ];
        let (report, folder) = report(&changes);
        assert!(folder.path().join("run/time.csv").exists());
        let time = &report["time"][0];
        assert!(time["best_jaccard"].as_f64().unwrap() > 0.5, "{time}");
        report["evaluation"]["iou"].as_f64().unwrap()
    };
    // The headline sees the diffusion: σ = √(DT) is three voxels
    let (sharp, blurred) = (iou("0"), iou("2e-3"));
    assert!(blurred < sharp - 0.005, "{sharp} {blurred}");
}

#[test]
fn turns_with_patterns_of_their_own_are_optimized_and_printed() {
    let changes = [
        "schedule.optimize=\"exact\"",
        "schedule.turns=2",
        "schedule.power={ energy_per_turn_mj_per_mm2 = 1.0 }",
        "light[0].angles=12",
    ];
    let loss = |folder: &tempfile::TempDir| {
        let text = std::fs::read_to_string(folder.path().join("run/history.csv")).unwrap();
        let row = |line: &str| line.split(',').nth(1).unwrap().parse::<f64>().unwrap();
        let rows: Vec<f64> = text.lines().skip(1).map(row).collect();
        (rows[0], rows[rows.len() - 1])
    };
    let (_, folder) = report(&changes);
    let (start, repeated) = loss(&folder);
    let (time, folder) = report(&[&changes[..], &["schedule.own_patterns=true"]].concat());
    let (same, apart) = loss(&folder);
    assert!((same / start - 1.0).abs() < 0.01, "{same} {start}");
    assert!(apart < 1.01 * repeated, "{apart} {repeated}");
    assert!(time["time"][0]["best_jaccard"].as_f64().unwrap() > 0.7);
}

#[test]
fn heights_are_done_together_where_rows_are_rescaled() {
    // Oxygen rises from a fifth at the bottom to all at the top
    let axial = "material.photopolymer.networks=[{ name = \"resin\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }, inhibitors = [{ capacity_mj_per_mm3 = 0.4, initial = { axial = [[-0.6, 0.2], [0.6, 1.0]] } }] }]";
    // When half of the voxels about the axis are solid, in the upper part over the lower one
    let ratio = |change: &str| {
        let (_, folder) = report(&[axial, change]);
        let file = folder.path().join("run/cure_time.npy");
        let ([nz, ny, nx], times) = crate::io::npy::read_volume(&file).unwrap();
        let median = |slices: std::ops::Range<usize>| {
            let near = |i: &usize| {
                let (y, x) = (i / nx % ny, i % nx);
                y.abs_diff(ny / 2) < 3 && x.abs_diff(nx / 2) < 3
            };
            let voxels = (slices.start * ny * nx..slices.end * ny * nx).filter(near);
            let mut seconds: Vec<f32> = voxels.map(|i| times[i]).collect();
            seconds.sort_by(f32::total_cmp);
            seconds[seconds.len() / 2]
        };
        median(nz / 2 + 2..nz / 2 + 5) / median(nz / 2 - 5..nz / 2 - 2)
    };
    let (before, after) = (
        ratio("schedule.level_heights=false"),
        ratio("schedule.level_heights=true"),
    );
    assert!(
        before > 1.15 && (after - 1.0).abs() < 0.05,
        "{before} {after}"
    );
}

#[test]
fn bodies_and_inserts_are_walls() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/11-bodies.toml");
    let mut document = Document::read(&file).unwrap();
    for change in [
        "target.body[1].role=\"insert\"",
        "grid.pitch_mm=0.2",
        "schedule={ turns = 2 }",
        "material={ photopolymer = { networks = [{ name = \"resin\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }, inhibitors = [{ capacity_mj_per_mm3 = 0.4, diffusion_mm2_per_s = 1e-3 }] }] } }",
    ] {
        document.set(change).unwrap();
    }
    let resolved =
        ResolvedJob::under(&Job::from_document(document).unwrap(), &Work::new()).unwrap();
    let held = resin(&resolved, &resolved.grid).unwrap();
    let walls = held.values.iter().filter(|v| !**v).count();
    assert!(walls > 20 && walls < held.values.len() / 4, "{walls}");
    // Light uses oxygen up in half of the box; what flows stays in the resin
    let domain = domain(&resolved, &resolved.grid).unwrap();
    let material = resolved.photopolymer(domain).unwrap();
    let mut state = material.start().unwrap();
    let layout = material.domain().layout().clone();
    let half = Volume {
        values: (0..resolved.grid.len())
            .map(|i| 0.2 * f32::from(u8::from(i % 2 == 0)))
            .collect(),
        grid: resolved.grid.clone(),
    };
    let light = layout.field_of(&half);
    material.step(&mut state, &[&light], 1.0).unwrap();
    let oxygen = |state: &tomolith_material::State| {
        let content = layout.volume_of(state.volumes[0].as_slice()).values;
        let sum_of = |resin: bool| {
            let voxels = content
                .iter()
                .zip(&held.values)
                .filter(|(_, r)| **r == resin);
            voxels.map(|(v, _)| f64::from(*v)).sum::<f64>()
        };
        (sum_of(true), sum_of(false), content)
    };
    let (before, inside, then) = oxygen(&state);
    for _ in 0..20 {
        material
            .step(&mut state, &[&[]], material.longest_step_s().min(5.0))
            .unwrap();
    }
    let (after, still, now) = oxygen(&state);
    assert!((after / before - 1.0).abs() < 1e-5, "{before} {after}");
    assert_eq!((inside, still), (0.0, 0.0));
    assert!(then.iter().zip(&now).any(|(a, b)| (a - b).abs() > 0.1));
}

#[test]
fn what_cannot_be_printed_in_time_is_refused_by_its_key() {
    let refused = |changes: &[&str]| {
        let found = job(changes).and_then(|job| ResolvedJob::new(&job).map(drop));
        key_of(found.unwrap_err())
    };
    let is_sound = |changes: &[&str]| ResolvedJob::new(&job(changes).unwrap()).is_ok();
    // 0.1²/(6·10⁻⁴) is 16.7 s, the longest step; air on top takes a seventh in place of a sixth: 14.3 s.
    // An inhibitor of which there is none is none; scattered light has no single way along which it is weakened, and cells know nothing that flows between them
    let slips = r#"
        schedule.turns=0 → schedule.turns
        schedule.duty=1.5 → schedule.duty
        schedule.step_s=0 → schedule.step_s
        schedule.step_s=1e-9 → schedule.step_s
        schedule.snapshots=101 → schedule.snapshots
        schedule={ turns = 2, rounds = 0, optimize = "frozen" } → schedule.rounds
        schedule.shading_every_s=-1 → schedule.shading_every_s
        material.photopolymer.shading=[{ light = 0, active_per_mm = [0.2, 0.2], attenuation_per_mm = [0.2, 0.5] }] → material.photopolymer.shading[0].active_per_mm
        material.photopolymer.shading=[{ light = 0, active_per_mm = [0.1, 0.2], attenuation_per_mm = [0.2, 0.5] }] → material.photopolymer.shading[0].attenuation_per_mm
        schedule.power={ irradiance_mw_per_mm2 = -1 } → schedule.power
        light[0].power={ irradiance_mw_per_mm2 = -1 } → light[0].power
        schedule.own_patterns=true → schedule.own_patterns
        printer={ time_s = 60.0 } → printer.time_s
        material={} → material
        material={ diffusion = { mm2_per_s = 1e-4 } } → material
        material={ diffusion = { mm2_per_s = -1 } } → material.diffusion.mm2_per_s
        species=[{ name = "resin", driven_by = { light = -1.0 } }] → species[0].driven_by
        schedule.step_s=100 → schedule.step_s
        material.photopolymer.networks=[] → material.photopolymer.networks
        material.photopolymer.networks=[{ name = "resin", curing = { threshold = { critical_dose_mj_per_mm3 = -1 } } }] → material.photopolymer.networks[0].curing.threshold.critical_dose_mj_per_mm3
        material.photopolymer.networks=[{ name = "resin", curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } } }] + schedule.optimize="frozen" → schedule.optimize
        material={ diffusion = { mm2_per_s = 1e-4 }, air_on_top = true } + resin.critical_dose_mj_per_mm3=0.8 → material.air_on_top
        material.photopolymer.diffusion="spectral" + material.air_on_top=true → material.photopolymer.diffusion
        material.photopolymer.networks=[{ name = "resin", curing = { rate_law = { rate_per_s = 1.0, exponent = 0.5, gel_conversion = 0.2 } } }] + schedule.optimize="frozen" → schedule.optimize
        material.photopolymer.networks=[{ name = "resin", curing = { rate_law = { rate_per_s = 1.0, exponent = 0.5, gel_conversion = 0.2 } } }] + schedule.level_heights=true → schedule.level_heights
        material.photopolymer.networks[0].inhibitors[0].initial={ even = 0.0 } + schedule.optimize="frozen" → schedule.optimize
        resin.scattering_per_mm=0.1 + material.photopolymer.shading=[{ light = 0, active_per_mm = [0.1, 0.1], attenuation_per_mm = [0.2, 0.5] }] + model={ successive_orders = {} } → material.photopolymer.shading[0]
        objective={ threshold = { surface = "cells" } } + schedule.optimize="exact" → objective.threshold.surface
        material.air_on_top=true + schedule.step_s=15 → schedule.step_s
    "#;
    for slip in slips.trim().lines() {
        let (changes, key) = slip.trim().split_once(" → ").unwrap();
        let all: Vec<&str> = changes.split(" + ").collect();
        assert_eq!(refused(&all), key, "{changes}");
    }
    // What a light is to inhibit needs something that it makes
    let lights = "light=[{ name = \"a\", pixels = [24, 20], angles = 24, projector = { collimated = { pixel_pitch_mm = 0.1 } } }, \
                  { name = \"b\", pixels = [24, 20], angles = 24, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]";
    let species = "species=[{ name = \"resin\", driven_by = { a = 1.0, b = -0.5 } }]";
    let bare = "material.photopolymer.networks=[{ name = \"resin\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } } }]";
    assert!(is_sound(&[lights, species]));
    let nothing = refused(&[lights, species, bare]);
    assert_eq!(nothing, "material.photopolymer.networks[0].inhibitors");
    // A network is that of the species at its place
    let two = "species=[{ name = \"resin\", driven_by = { a = 1.0 } }, { name = \"epoxy\", driven_by = { b = 1.0 } }]";
    let network = |name: &str| {
        format!(
            "{{ name = \"{name}\", curing = {{ threshold = {{ critical_dose_mj_per_mm3 = 0.5 }} }} }}"
        )
    };
    let networks = |names: [&str; 2]| {
        format!(
            "material.photopolymer.networks=[{}]",
            names.map(network).join(", ")
        )
    };
    assert!(is_sound(&[lights, two, &networks(["resin", "epoxy"])]));
    let swapped = refused(&[lights, two, &networks(["epoxy", "resin"])]);
    assert_eq!(swapped, "material.photopolymer.networks[0].name");
    // There is an inhibitor again where air or a light brings it
    let empty = "material.photopolymer.networks[0].inhibitors[0].initial={ even = 0.0 }";
    let frozen = "schedule.optimize=\"frozen\"";
    assert!(is_sound(&[empty, frozen, "material.air_on_top=true"]));
    // Waves are weakened along their way
    let shades = "material.photopolymer.shading=[{ light = 0, active_per_mm = [0.1, 0.1], attenuation_per_mm = [0.1, 0.5] }]";
    assert!(is_sound(&[shades]) && is_sound(&[shades, "model={ wave = {} }"]));
    assert!(is_sound(&["schedule.step_s=15"]));
    let without = "schedule={ turns = 2 }";
    let text = DISC.split("[[material").next().unwrap();
    let found = ResolvedJob::new(&job_of(text, &[without])).map(drop);
    assert_eq!(key_of(found.unwrap_err()), "material");
}

#[test]
fn an_exposure_that_never_comes_says_what_would_help() {
    let text_of = |induction_end_s: Option<f64>, share: f64| {
        let summary = TimeSummary {
            name: "resin".to_owned(),
            induction_end_s,
            best_s: induction_end_s,
            best_jaccard: None,
            best_mj: None,
            ideal_exposure_s: None,
            largest_share: Some(share),
        };
        summary.to_string()
    };
    let nothing = text_of(None, 1.18);
    assert!(nothing.contains("ideal exposure never (the part absorbs 118 % of what"));
    assert!(nothing.ends_with("too unevenly or too slowly for any of it to become solid)"));
    for (text, who) in [
        (text_of(None, 0.4), "(the part absorbs 40 %"),
        (text_of(Some(9.0), 0.4), "(solid voxels absorb 40 %"),
    ] {
        assert!(text.contains(who), "{text}");
        assert!(text.ends_with("more turns, or more power)"), "{text}");
    }
}
