//! Bad input ends before any heavy work with one clear message, exit code 2, and earlier outputs as they were.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// A job that works, small.
const JOB: &str = r#"[target]
phantom = "gear"
size_mm = 2.0

[grid]
pitch_mm = 0.1

[resin]
refractive_index = 1.5
absorption_per_mm = 0.05

[vial.cylinder]
inner_radius_mm = 3.0
outer_radius_mm = 3.5
refractive_index = 1.5

[[light]]
pixels = [48, 24]
angles = 30
projector.collimated = { pixel_pitch_mm = 0.1 }

[objective.threshold]
lower = 0.85
upper = 0.95

[stop]
iterations = 2

[output]
folder = "FOLDER"
"#;

/// A folder with a job and an earlier run.
struct Bench {
    temp: TempDir,
}

impl Bench {
    fn new() -> Self {
        let bench = Bench {
            temp: tempfile::tempdir().unwrap(),
        };
        let run = bench.run_folder();
        fs::create_dir_all(run.join("frames")).unwrap();
        let mark = "# A Tomolith run folder; this is its job with every default written out.\n";
        fs::write(run.join("job.toml"), mark).unwrap();
        fs::write(run.join("report.json"), "{\"earlier\": true}").unwrap();
        fs::write(run.join("frames/0000.png"), "earlier").unwrap();
        bench
    }

    fn path(&self, name: &str) -> PathBuf {
        self.temp.path().join(name)
    }

    fn run_folder(&self) -> PathBuf {
        self.path("run")
    }

    /// Every file under the run folder with its content.
    fn earlier(&self) -> Vec<(PathBuf, Vec<u8>)> {
        let mut files = Vec::new();
        let mut folders = vec![self.run_folder()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
                if entry.is_dir() {
                    folders.push(entry);
                } else {
                    files.push((entry.clone(), fs::read(&entry).unwrap()));
                }
            }
        }
        files.sort();
        files
    }

    fn tomolith(&self, job: &str, more: &[&str]) -> Output {
        let file = self.path("job.toml");
        fs::write(
            &file,
            job.replace("FOLDER", &self.run_folder().display().to_string()),
        )
        .unwrap();
        tomolith(&file, more)
    }
}

fn tomolith(job: &Path, more: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tomolith"))
        .arg("run")
        .arg(job)
        .args(more)
        .output()
        .unwrap()
}

/// What is wrong: text of the job, what stands there instead, what marks the line, parts of the message.
type Wrong = (
    &'static str,
    &'static str,
    &'static str,
    &'static [&'static str],
);

/// One row per kind of slip.
const WRONG: &[Wrong] = &[
    // Names
    (
        "iterations = 2",
        "iteratons = 2",
        "iteratons",
        &["stop.iteratons", "did you mean `iterations`?"],
    ),
    (
        "[resin]",
        "[resn]",
        "[resn]",
        &["resn", "did you mean `resin`?"],
    ),
    (
        "[vial.cylinder]",
        "[vial.cilinder]",
        "[vial.cil",
        &["vial.cilinder", "did you mean `cylinder`?", "index_matched"],
    ),
    (
        "[objective.threshold]",
        "[objective.treshold]",
        "[objective.tre",
        &["objective.treshold", "did you mean `threshold`?"],
    ),
    (
        "lower = 0.85",
        "lwer = 0.85",
        "lwer",
        &["objective.threshold.lwer", "did you mean `lower`?"],
    ),
    (
        "\"gear\"",
        "\"gaer\"",
        "\"gaer\"",
        &["target.phantom", "did you mean `gear`?"],
    ),
    (
        "[stop]",
        "[optimizer.lbfg]\n[stop]",
        "[optimizer.lbfg",
        &["optimizer.lbfg", "did you mean `lbfgs`?"],
    ),
    (
        "collimated",
        "colimated",
        "colimated",
        &["light[0].projector.colimated", "did you mean `collimated`?"],
    ),
    // Types and units
    (
        "iterations = 2",
        "iterations = \"two\"",
        "\"two\"",
        &["stop.iterations", "a whole number, 0 or more"],
    ),
    (
        "iterations = 2",
        "iterations = 2.5",
        "2.5",
        &["stop.iterations", "a whole number, 0 or more"],
    ),
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = \"0.1 kg\"\n\n",
        "kg",
        &["grid.pitch_mm", "unknown unit of length `kg`", "nm, um, mm"],
    ),
    (
        "inner_radius_mm = 3.0",
        "inner_radius_mm = true",
        "true",
        &["vial.cylinder.inner_radius_mm", "a length"],
    ),
    (
        "[48, 24]",
        "[48]",
        "[48]",
        &["light[0].pixels", "a list of 2"],
    ),
    ("[[light]]", "[light]", "[light]", &["light", "a list"]),
    // Numbers that cannot be
    (
        "0.05",
        "nan",
        "nan",
        &["resin.absorption_per_mm", "a finite number"],
    ),
    (
        "0.05",
        "inf",
        "inf",
        &["resin.absorption_per_mm", "a finite number"],
    ),
    (
        "0.05",
        "-0.05",
        "-0.05",
        &["resin.absorption_per_mm", "found -0.05"],
    ),
    (
        "0.05",
        "0",
        "per_mm = 0",
        &["resin.absorption_per_mm", "found 0", "pure_radon"],
    ),
    (
        "refractive_index = 1.5\nabs",
        "refractive_index = 0.5\nabs",
        "0.5",
        &["resin.refractive_index", "found 0.5"],
    ),
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = 0\n\n",
        "pitch_mm = 0\n",
        &["grid.pitch_mm", "found 0"],
    ),
    (
        "size_mm = 2.0",
        "size_mm = -2.0",
        "-2.0",
        &["target.size_mm", "-2"],
    ),
    (
        "angles = 30",
        "angles = 0",
        "angles = 0",
        &["light[0].angles", "found 0"],
    ),
    (
        "angles = 30",
        "angles = { list_deg = [] }",
        "list_deg",
        &["light[0].angles.list_deg", "an empty list", "azimuths"],
    ),
    (
        "inner_radius_mm = 3.0",
        "inner_radius_mm = 3.5",
        "inner_r",
        &["vial.cylinder.inner_radius_mm", "outer_radius_mm = 3.5"],
    ),
    // Bands
    (
        "lower = 0.85",
        "lower = 0.95",
        "lower",
        &["objective.threshold.lower", "0.95"],
    ),
    (
        "lower = 0.85",
        "lower = 1.85",
        "lower",
        &["objective.threshold.lower", "1.85"],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\nceiling = 0.9",
        "ceiling",
        &["objective.threshold.ceiling", "0.9"],
    ),
    (
        "threshold]\nlower = 0.85\nupper = 0.95",
        "bclp]\nepsilon = -0.1",
        "epsilon",
        &["objective.bclp.epsilon", "-0.1"],
    ),
    // Numbers with which no loss is a number
    (
        "upper = 0.95",
        "upper = 0.95\nexponent = 1e30",
        "exponent",
        &["objective.threshold.exponent", "at most 100"],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\nceiling = 1e38",
        "ceiling",
        &["objective.threshold.ceiling", "from -1e9 to 1e9"],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\npart_weight = 1e300",
        "part_weight",
        &["objective.threshold.part_weight", "from 0 to 1e9"],
    ),
    (
        "[objective.threshold]",
        "[objective]\nweight = 1e300\n[objective.threshold]",
        "weight",
        &["objective.weight", "from 0 to 1e9"],
    ),
    (
        "[stop]",
        "[response.logistic]\nsteepness = 1e30\n[stop]",
        "steepness",
        &["response.logistic.steepness", "at most 1e6"],
    ),
    (
        "[stop]",
        "[bounds]\nmin = 1e30\n[stop]",
        "min = 1e30",
        &["bounds.min", "0 to 1e9 mJ/mm²"],
    ),
    (
        "[stop]",
        "[bounds]\nmax = 1e30\n[stop]",
        "max = 1e30",
        &["bounds.max", "from bounds.min = 0 to 1e9 mJ/mm²"],
    ),
    (
        "[stop]",
        "[checkpoint]\nevery_s = \"often\"\n[stop]",
        "often",
        &["checkpoint.every_s", "seconds above 0, or \"auto\""],
    ),
    // More than a machine holds
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = 0.0002\n\n",
        "pitch_mm = 0.0002",
        &["grid.pitch_mm", "memory", "MB needed", "MB available"],
    ),
    (
        "pixels = [48, 24]\nangles = 30",
        "pixels = [16000, 16000]\nangles = 1400",
        "pixels",
        &[
            "light[0].pixels",
            "memory",
            "MB needed",
            "fewer pixels or angles",
        ],
    ),
    // Responses and penalties
    (
        "threshold]\nlower = 0.85\nupper = 0.95",
        "pm]\nd_h = 1.4\nd_l = 0.7\n[response.logistic]\nupper = 1.0",
        "pm]",
        &["objective.pm", "1.4", "cannot reach"],
    ),
    (
        "[stop]",
        "[response.table]\ndose = [0, 1, 2]\nresponse = [0.0, 0.6, 0.5]\n[stop]",
        "response = ",
        &["response.table.response[2]", "0.5 after 0.6", "falls"],
    ),
    (
        "[stop]",
        "[response.logistic]\nupper = 0.97\n[stop]",
        "response",
        &[
            "response: the start asks for the dose of the response 1, and no dose has it",
            "from 0 to 0.97",
            "[start.zero], [start.patterns]",
        ],
    ),
    (
        "[stop]",
        "[response.fit]\ndose = [0, 1, 2, 3, 4, 5]\nresponse = [0.9, 0.8, 0.6, 0.5, 0.3, 0.1]\n[stop]",
        "response = ",
        &["response.fit.response", "falls with dose", "0.9 to 0.1"],
    ),
    (
        "[stop]",
        "[response.fit]\nform = \"table\"\ndose = [0, 1, 2]\nresponse = [0.9, 0.6, 0.1]\n[stop]",
        "response = ",
        &["response.fit.response", "falls with dose", "0.9 to 0.1"],
    ),
    (
        "[stop]",
        "[response.logistic]\nlower = 1.0\nupper = 0.2\n[stop]",
        "lower = 1.0",
        &["response.logistic.lower", "lower 1 is not below upper 0.2"],
    ),
    (
        "[stop]",
        "[response.logistic]\n[evaluate]\nthreshold = 1.5\n[stop]",
        "threshold = 1.5",
        &["evaluate.threshold", "found 1.5", "goes from 0 to 1"],
    ),
    (
        "0.05",
        "0.05\ncritical_dose_mj_per_mm3 = 0.8\n[response.logistic]\nupper = 0.5\n[objective.response.identity]\n\
         [start.zero]\n[printer]\ntime_s = 60.0\npeak_irradiance_mw_per_cm2 = 5.0",
        "time_s",
        &["printer.time_s", "solid at 0.900", "from 0 to 0.5"],
    ),
    // Methods and what they cannot have
    (
        "[stop]",
        "[optimizer.lbfgs]\nfilter = \"hann\"\n[stop]",
        "filter",
        &[
            "optimizer.lbfgs.filter",
            "`lbfgs` has no `filter`, these have:",
            "optimizer.osmo",
            "optimizer.cal",
            "start.fbp",
        ],
    ),
    (
        "[stop]",
        "[start.zero]\nfilter = \"hann\"\n[stop]",
        "filter",
        &[
            "start.zero.filter",
            "nothing: this table has no keys",
            "start.fbp",
        ],
    ),
    (
        "[stop]",
        "[optimizer.osmo]\nfilter = \"ramlak\"\n[stop]",
        "filter",
        &["optimizer.osmo.filter", "did you mean `ram_lak`?"],
    ),
    (
        "[stop]",
        "[bounds]\nbits = 8\n[stop]",
        "bits",
        &["bounds.bits", "optimizer.lbfgs with rounding in every step"],
    ),
    (
        "[stop]",
        "[optimizer.fista]\n[response.logistic]\n[stop]",
        "[optimizer",
        &["optimizer.fista", "not convex together", "one of the two"],
    ),
    (
        "[stop]",
        "[optimizer.osmo]\n[[penalties]]\nweight = 1.0\nsparsity = { exponent = 2 }\n[stop]",
        "[[penalties",
        &["penalties[0]", "optimizer.osmo with penalties"],
    ),
    // Bits
    (
        "[stop]",
        "[evaluate]\nbit_depth = 0\n[stop]",
        "bit_depth",
        &["evaluate.bit_depth", "found 0", "from 1 to 16"],
    ),
    (
        "[stop]",
        "[evaluate]\nbit_depth = 17\n[stop]",
        "bit_depth",
        &["evaluate.bit_depth", "found 17", "from 1 to 16"],
    ),
    (
        "[stop]",
        "[bounds]\nbits = 0\n[stop]",
        "bits",
        &["bounds.bits", "found 0", "1 to 16 bits"],
    ),
    (
        "[stop]",
        "[bounds]\nbits = 17\n[stop]",
        "bits",
        &["bounds.bits", "found 17", "1 to 16 bits"],
    ),
    (
        "[stop]",
        "[evaluate]\nrequire_in_band = 0.9\n[stop]",
        "require",
        &["evaluate.require_in_band", "part and void", "require_iou"],
    ),
    (
        "[stop]",
        "[[penalties]]\nsparsity = { exponent = 2 }\n[stop]",
        "penalties",
        &["penalties[0].weight", "missing"],
    ),
    // What does not fit
    (
        "size_mm = 2.0",
        "size_mm = 9.0",
        "[target]",
        &["target", "reaches 4.5", "the resin ends at 3"],
    ),
    (
        "[48, 24]",
        "[12, 24]",
        "[12, 24]",
        &["light[0].pixels", "sideways"],
    ),
    (
        "[48, 24]",
        "[48, 4]",
        "[48, 4]",
        &["light[0].pixels", "along the axis"],
    ),
    // The machine
    (
        "[stop]",
        "[printer]\nrpm = 3\n[stop]",
        "rpm = 3",
        &["printer.rpm", "unknown name"],
    ),
    (
        "[stop]",
        "[printer]\ncanvas = [40, 60]\n[stop]",
        "[40, 60]",
        &["printer.canvas", "need 48 × 24", "at least [48, 24]"],
    ),
    (
        "[stop]",
        "[printer]\ngrey_curve = [[0.0, 0.0], [0.5, 0.7], [1.0, 0.6]]\n[stop]",
        "grey_curve",
        &["printer.grey_curve", "not monotone"],
    ),
    (
        "[stop]",
        "[printer]\nflat_field = \"none.png\"\n[stop]",
        "flat_field",
        &["printer.flat_field", "none.png"],
    ),
    (
        "[stop]",
        "[printer]\nrefresh_hz = 4.0\n[stop]",
        "[output]",
        &["output.rpm", "5 frames a second", "at most 8 turns"],
    ),
    (
        "\"FOLDER\"",
        "\"FOLDER\"\nrpm = 900",
        "rpm",
        &["output.rpm", "450 frames a second", "at most 480 turns"],
    ),
    (
        "\"FOLDER\"",
        "\"FOLDER\"\nrpm = 0.01",
        "rpm",
        &["output.rpm", "0.005 frames a second", "at least 0.2 turns"],
    ),
    (
        "[stop]",
        "[printer]\ncopies_px = [[0, 0], [30, 0]]\n[stop]",
        "copies_px",
        &["printer.copies_px", "copies 1 and 2 overlap"],
    ),
    // Cells that the surface cuts, beside what knows whole voxels only
    (
        "upper = 0.95",
        "upper = 0.95\nsurface = \"cells\"\n\n[optimizer.osmo]",
        "surface",
        &[
            "objective.threshold.surface",
            "[optimizer.osmo]",
            "whole voxels",
        ],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\nsurface = \"cells\"\n\n[model.parallel]",
        "surface",
        &[
            "objective.threshold.surface",
            "[model.parallel]",
            "whole voxels",
        ],
    ),
    (
        "[objective.threshold]\nlower = 0.85\nupper = 0.95",
        "[[objectives]]\nthreshold = { surface = \"cells\" }\n\n[[objectives]]\nl2 = {}",
        "l2",
        &["objectives[1].l2", "another objective has cells"],
    ),
    // What scatters, and what is beyond parallel light
    (
        "0.05",
        "0.05\nscattering_per_mm = -1.0",
        "scatt",
        &["resin.scattering_per_mm", "1/mm"],
    ),
    (
        "0.05",
        "0.05\nattenuation_per_mm = 0.1\nscattering_per_mm = 0.2",
        "atten",
        &["resin.attenuation_per_mm", "resin.scattering_per_mm"],
    ),
    (
        "0.05",
        "0.05\nphase.raleigh = {}",
        "phase",
        &["resin.phase.raleigh", "did you mean `rayleigh`?"],
    ),
    (
        "angles = 30",
        "angles = 30\noffset_mm = [0, 2000]",
        "offset_mm",
        &["light[0].offset_mm[1]", "-1000 to 1000"],
    ),
    (
        "angles = 30",
        "angles = 30\noffset_mm = [0, -0.9]",
        "pixels",
        &[
            "light[0].pixels",
            "the field reaches 0.300 mm along the axis",
            "another offset_mm",
        ],
    ),
    (
        "pixel_pitch_mm = 0.1",
        "pixel_pitch_mm = [0.1, 0]",
        "pixel_pitch",
        &["light[0].projector.collimated.pixel_pitch_mm[1]", "> 0"],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.columns = [40, 9]",
        "selection",
        &[
            "light[0].selection.columns",
            "found [40, 9], but there are 48",
        ],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.rows = [0, 14]",
        "pixels",
        &[
            "light[0].pixels",
            "the field reaches 0.200 mm along the axis",
        ],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.least_contribution = 1.5",
        "selection",
        &["light[0].selection.least_contribution", "0 to 0.999"],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.corner_radius_mm = 0.2",
        "selection",
        &[
            "light[0].selection.corner_radius_mm",
            "its outer wall has none",
        ],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.mask = \"none.png\"",
        "selection",
        &[
            "light[0].selection.mask",
            "none.png",
            "a file that can be read",
        ],
    ),
    (
        "[stop]",
        "[motion]\ntilt_deg = 95\n[stop]",
        "tilt",
        &["motion.tilt_deg", "-80 to 80"],
    ),
    (
        "[stop]",
        "[[obstacles]]\nmesh = \"none.stl\"\n[stop]",
        "mesh",
        &["obstacles[0].mesh", "none.stl"],
    ),
    (
        "[stop]",
        "[model.rays]\nrays_per_pixel = 0\n[stop]",
        "rays_per",
        &["model.rays.rays_per_pixel", "1 to 4096"],
    ),
    // A model that does not cover the optics
    (
        "[stop]",
        "[model.parallel]\n[motion]\ntilt_deg = 5\n[stop]",
        "[model.parallel]",
        &["model.parallel", "light is not normal to the axis"],
    ),
    (
        "0.05\n",
        "0.05\nscattering_per_mm = 0.2\n\n[model.rays]\n",
        "[model.rays]",
        &["model.rays", "the resin scatters", "[model.scatter]"],
    ),
    // Syntax
    (
        "iterations = 2",
        "iterations = 2\niterations = 3",
        "iterations = 3",
        &["duplicate key"],
    ),
    (
        "iterations = 2",
        "iterations = ",
        "iterations =",
        &["a job file in TOML"],
    ),
];

#[test]
fn every_slip_is_named_with_key_line_and_what_is_accepted() {
    let bench = Bench::new();
    let before = bench.earlier();
    for (from, to, mark, parts) in WRONG {
        assert!(JOB.contains(from), "{from:?} is not in the job");
        let job = JOB.replacen(from, to, 1);
        let line = 1 + job[..job.find(mark).unwrap()].matches('\n').count();
        let output = bench.tomolith(&job, &[]);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{to:?}: {message}");
        let place = format!("job.toml, line {line})");
        for part in parts.iter().copied().chain([place.as_str()]) {
            assert!(
                flat(&message).contains(part),
                "{to:?}: `{part}` is not in\n{message}"
            );
        }
        assert_eq!(bench.earlier(), before, "{to:?} changed earlier outputs");
    }
}

/// A message without the line breaks and the frame of its display.
fn flat(message: &str) -> String {
    let words = message.split_whitespace().filter(|word| *word != "│");
    words.collect::<Vec<_>>().join(" ")
}

/// The message of a job that must be refused: exit code 2, earlier outputs as they were, and all of `parts` in it.
fn refused(bench: &Bench, job: &str, parts: &[&str]) {
    let before = bench.earlier();
    let output = bench.tomolith(job, &[]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in parts {
        assert!(
            flat(&message).contains(part),
            "`{part}` is not in\n{message}"
        );
    }
    assert_eq!(bench.earlier(), before, "{parts:?} changed earlier outputs");
}

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
    let bench = Bench::new();
    let solid = |name: &str, boxes: &[[[f64; 3]; 2]]| {
        let facets: String = boxes.iter().copied().map(stl_box).collect();
        fs::write(bench.path(name), format!("solid a\n{facets}endsolid a\n")).unwrap();
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
    refused(
        &bench,
        &job(&format!(
            "size_mm = 2.0\n[[target.body]]\nmesh = \"a.stl\"\n[[target.body]]\nmesh = \"b.stl\"\n{keep_dark}"
        )),
        &[
            "target.body[1]: this body (keep-dark) and body[0] (print) share",
            "a printed body that overlaps no insert and no keep-dark body",
            "job.toml, line 5)",
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
        let place = format!("job.toml, line {line})");
        refused(&bench, &job(&bodies), &[parts[0], parts[1], &place]);
    }
}

#[test]
fn images_of_different_sizes_are_no_stack() {
    let bench = Bench::new();
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
    refused(
        &bench,
        &job,
        &[
            "target.stack: ",
            "2.png: slice 3 has 9 × 8 pixels, the first one",
            "images of one size",
            "job.toml, line 2)",
        ],
    );
}

#[test]
fn a_dose_that_is_zero_everywhere_stops_osmo_and_keeps_its_patterns() {
    let bench = Bench::new();
    let job = JOB
        .replace(
            "[objective.threshold]",
            "[optimizer.osmo]\n[objective.osmo]",
        )
        .replace("lower = 0.85\nupper = 0.95", "d_l = 0.0\nd_h = 0.02")
        .replace("iterations = 2", "iterations = 30");
    let output = bench.tomolith(&job, &[]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in [
        "optimizer: normalising by the largest dose, but the dose became zero everywhere",
        "accepted: thresholds nearer to 1",
        "job.toml, line ",
    ] {
        assert!(flat(&message).contains(part), "{part}: {message}");
    }
    assert!(bench.run_folder().join("checkpoint/patterns.npz").exists());
    let report = fs::read_to_string(bench.run_folder().join("report.json")).unwrap();
    assert_eq!(report, "{\"earlier\": true}");
}

#[test]
fn meshes_that_cannot_be_printed_are_refused() {
    let bench = Bench::new();
    let before = bench.earlier();
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
            fs::write(bench.path(name), content).unwrap();
        }
        let output = bench.tomolith(
            &JOB.replace("phantom = \"gear\"", &format!("mesh = \"{name}\"")),
            &[],
        );
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{name}: {message}");
        assert!(flat(&message).contains(name), "{name} is not in\n{message}");
        assert_eq!(bench.earlier(), before, "{name} changed earlier outputs");
    }
}

#[test]
fn a_folder_that_is_not_ours_is_left_alone() {
    let bench = Bench::new();
    let foreign = bench.path("thesis");
    fs::create_dir(&foreign).unwrap();
    fs::write(foreign.join("chapter.tex"), "mine").unwrap();
    let output = bench.tomolith(JOB, &["--output", &foreign.display().to_string()]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in ["output.folder", "not from a run", "(from --output /"] {
        assert!(flat(&message).contains(part), "{part}: {message}");
    }
    assert!(!message.contains("line"), "blamed on the file: {message}");
    assert_eq!(fs::read_dir(&foreign).unwrap().count(), 1);
}

#[test]
fn too_little_memory_is_said_with_the_estimate() {
    let bench = Bench::new();
    let before = bench.earlier();
    let output = bench.tomolith(JOB, &["--set", "grid.shape=[9000, 9000, 9000]"]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        flat(&message).contains("grid.shape: memory") && flat(&message).contains("MB needed"),
        "{message}"
    );
    assert_eq!(bench.earlier(), before);
}

#[test]
fn an_override_names_itself_and_json_errors_are_one_line() {
    let bench = Bench::new();
    let output = bench.tomolith(JOB, &["--set", "light.angles=0", "--json"]);
    assert_eq!(output.status.code(), Some(2));
    let line: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&line["event"], &line["key"]),
        (&"error".into(), &"light[0].angles".into())
    );
    assert!(
        line["found"]
            .as_str()
            .unwrap()
            .contains("--set light.angles=0"),
        "{line}"
    );
    let output = tomolith(&bench.path("nothing.toml"), &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("nothing.toml"));
}

#[test]
fn what_an_option_set_is_not_blamed_on_the_file() {
    let bench = Bench::new();
    for (option, key) in [
        ("light.pixels=[0,0]", "light[0].pixels[0]"),
        ("light.angles={list_deg=[]}", "light[0].angles.list_deg"),
        ("light.pixels=[12, 24]", "light[0].pixels"),
        ("target.size_mm=9", "target"),
        (
            "resin.phase.henyey_greenstein.g=2",
            "resin.phase.henyey_greenstein.g",
        ),
    ] {
        let output = bench.tomolith(JOB, &["--set", option]);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{option}: {message}");
        let parts = [format!("× {key}: "), format!("(from --set {option})")];
        for part in parts {
            assert!(flat(&message).contains(&part), "{part}: {message}");
        }
        assert!(!message.contains("job.toml"), "{option}: {message}");
    }
}

#[test]
fn a_grey_image_has_an_objective_of_its_own_and_refuses_that_of_part_and_void() {
    let bench = Bench::new();
    let image = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/images/rings.png");
    let phantom = "phantom = \"gear\"";
    let grey = JOB.replace(
        phantom,
        &format!("image = \"{}\"\nheight_mm = 0.5", image.display()),
    );
    let line = 1 + grey[..grey.find("[objective").unwrap()]
        .matches('\n')
        .count();
    let output = bench.tomolith(&grey, &[]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in [
        "objective.threshold: ",
        "the target is grey",
        "l2, l1, dose_matching and bclp",
        &format!("job.toml, line {line})"),
    ] {
        assert!(flat(&message).contains(part), "{part}: {message}");
    }
    let default = grey.replace("[objective.threshold]\nlower = 0.85\nupper = 0.95\n", "");
    let output = bench.tomolith(&default, &["--quiet"]);
    assert_eq!(output.status.code(), Some(0));
    let resolved = fs::read_to_string(bench.run_folder().join("job.toml")).unwrap();
    assert!(resolved.contains("[objective.l2]"), "{resolved}");
}

/// A job whose target is a grey image.
fn grey_job() -> String {
    let image = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/images/rings.png");
    JOB.replace(
        "phantom = \"gear\"",
        &format!("image = \"{}\"\nheight_mm = 0.5", image.display()),
    )
    .replace(
        "threshold]\nlower = 0.85\nupper = 0.95",
        "bclp]\nepsilon = 0.05",
    )
}

#[test]
fn goals_of_part_and_void_are_refused_for_grey_values() {
    let bench = Bench::new();
    let grey = grey_job();
    for (from, to, mark, parts) in [
        (
            "iterations = 2",
            "iou = 0.9",
            "iou",
            ["stop.iou: counts part and void", "stop.loss"],
        ),
        (
            "[stop]",
            "[evaluate]\nrequire_iou = 0.9\n[stop]",
            "require_iou",
            ["evaluate.require_iou: counts", "evaluate.require_in_band"],
        ),
    ] {
        let job = grey.replace(from, to);
        let line = 1 + job[..job.find(mark).unwrap()].matches('\n').count();
        let place = format!("job.toml, line {line})");
        refused(&bench, &job, &[parts[0], parts[1], &place]);
    }
    // What the start asks for is known with the voxels only: the brightest rings are above 0.7
    let job = grey.replace(
        "epsilon = 0.05",
        "epsilon = 0.35\n[response.logistic]\nupper = 0.7",
    );
    let output = bench.tomolith(&job, &[]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in [
        "response: the start asks for the dose",
        "from 0 to 0.7",
        "job.toml, line 25)",
    ] {
        assert!(flat(&message).contains(part), "{part}: {message}");
    }
    let report = fs::read_to_string(bench.run_folder().join("report.json")).unwrap();
    assert_eq!(report, "{\"earlier\": true}");
    for (asked, code) in [("1.0", 1), ("0.0", 0)] {
        let option = format!("evaluate.require_in_band={asked}");
        let output = bench.tomolith(&grey, &["--set", &option]);
        assert_eq!(output.status.code(), Some(code), "{asked}");
    }
}

#[test]
fn resuming_notices_that_a_file_of_the_job_has_other_content() {
    let bench = Bench::new();
    let job = JOB.replace("[stop]", "[response.table]\nfile = \"curve.csv\"\n[stop]");
    fs::write(bench.path("curve.csv"), "0 0\n0.5 0.4\n1 1\n").unwrap();
    assert!(bench.tomolith(&job, &["--quiet"]).status.success());
    let resume = || bench.tomolith(&job, &["--resume", "--quiet"]);
    assert!(resume().status.success());
    fs::write(bench.path("curve.csv"), "0 0\n0.5 0.6\n1 1\n").unwrap();
    let output = resume();
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        flat(&message).contains("the content of a file that the job names, have changed"),
        "{message}"
    );
}

#[test]
fn resuming_says_what_to_do_and_what_has_changed() {
    let bench = Bench::new();
    assert!(bench.tomolith(JOB, &["--quiet"]).status.success());
    let refused = |more: &[&str], parts: &[&str]| {
        let output = bench.tomolith(JOB, &[&["--resume"], more].concat());
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        for part in ["× --resume: leave it out to begin anew"]
            .iter()
            .chain(parts)
        {
            assert!(flat(&message).contains(part), "{part}: {message}");
        }
    };
    refused(
        &[
            "--set",
            "resin.absorption_per_mm=0.06",
            "--set",
            "light.rotation=counterclockwise",
        ],
        &[
            "resin.absorption_per_mm was 0.05, is 0.06",
            "light[0].rotation was \"clockwise\", is \"counterclockwise\"",
        ],
    );
    refused(
        &["--set", "target.size_mm=1.9"],
        &["target.size_mm was 2, is 1.9"],
    );
    let file = bench.run_folder().join("checkpoint/state.safetensors");
    let whole = fs::read(&file).unwrap();
    let mut scribbled = whole.clone();
    scribbled[20..40].fill(b'x');
    for broken in [&whole[..100], &whole[..whole.len() - 1], &scribbled, &[]] {
        fs::write(&file, broken).unwrap();
        refused(&[], &["damaged checkpoint"]);
    }
    // What resuming does not depend on may change
    fs::write(&file, &whole).unwrap();
    let more = ["--resume", "--quiet", "--set", "stop.iterations=3"];
    let output = bench.tomolith(
        JOB,
        &[&more[..], &["--set", "objective.threshold.exponent=2"]].concat(),
    );
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
}

#[test]
fn a_simulation_never_mixes_with_a_run() {
    let bench = Bench::new();
    assert!(bench.tomolith(JOB, &["--quiet"]).status.success());
    let before = bench.earlier();
    let run = bench.run_folder();
    let simulate = |more: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_tomolith"))
            .arg("simulate")
            .arg(bench.path("job.toml"))
            .arg("--patterns")
            .arg(run.join("patterns.npz"))
            .arg("--quiet")
            .args(more)
            .output()
            .unwrap()
    };
    let output = simulate(&["--output", &run.display().to_string()]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in ["output.folder", "holds a run", "(from --output"] {
        assert!(flat(&message).contains(part), "{part}: {message}");
    }
    assert!(simulate(&[]).status.success());
    assert!(bench.path("run-simulated/report.json").exists());
    assert!(!bench.path("run-simulated/history.csv").exists());
    assert!(simulate(&[]).status.success(), "over a simulation");
    assert_eq!(bench.earlier(), before);
}

/// A disk that is full in the middle of a file: one message, the file's, and nothing of the libraries behind it.
#[test]
#[cfg(unix)]
fn a_full_disk_ends_with_one_message() {
    let bench = Bench::new();
    assert!(bench.tomolith(JOB, &["--quiet"]).status.success());
    let before = bench.earlier();
    // Patterns take 277 kB, the checkpoint of the patterns alone less than 150 kB (blocks of 512 or 1024 bytes)
    let checkpoint = "--set checkpoint.contents=patterns";
    let line = format!(
        "trap '' XFSZ; ulimit -f 260; exec {} run {} --quiet {checkpoint}",
        env!("CARGO_BIN_EXE_tomolith"),
        bench.path("job.toml").display()
    );
    let output = Command::new("sh").args(["-c", &line]).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        flat(&message).contains("patterns.npz: File too large"),
        "{message}"
    );
    assert!(!message.contains("ZipWriter"), "{message}");
    // A matrix of some megabytes stops in the same place
    let line = format!(
        "trap '' XFSZ; ulimit -f 260; exec {} export-matrix {} --output {}",
        env!("CARGO_BIN_EXE_tomolith"),
        bench.path("job.toml").display(),
        bench.path("matrix.npz").display()
    );
    let output = Command::new("sh").args(["-c", &line]).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        flat(&message).contains("matrix.npz: File too large") && !message.contains("ZipWriter"),
        "{message}"
    );
    let unchanged = |files: Vec<(PathBuf, Vec<u8>)>| -> Vec<_> {
        let of_run = |path: &PathBuf| path.ends_with("job.toml") || path.ends_with("report.json");
        files.into_iter().filter(|(path, _)| of_run(path)).collect()
    };
    let now: Vec<_> = unchanged(bench.earlier())
        .into_iter()
        .filter(|(path, _)| !path.to_string_lossy().contains(".new"))
        .collect();
    assert_eq!(now, unchanged(before));
}
