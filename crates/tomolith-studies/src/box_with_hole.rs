//! A box with a hole in seven scenes, with and without scattering.
//!
//! The box has 4 × 4 × 1 mm and a hole of radius 1 mm at x = −1; 200 frames of 200 × 20 pixels, 100 × 100 × 50 voxels of
//! 0.05 mm. The scenes and their thresholds are those of the tests of Dr.TVAM. The score is the share of all voxels that are right
//! when dose is cut midway between the thresholds, standing still, on the same voxels; of patterns made without scattering in mind
//! where it is highest. Prints a table; see docs/validation.md.
//!
//! A name as argument runs that scene alone; `paths` as second argument judges scattering scenes by Monte Carlo paths too.
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;
use tomolith::job::{Job, Silent, Summary, run, simulate};
use tomolith::models::Run;

/// Half edges of the closed boxes that stand as meshes.
const OUTER: [f64; 3] = [7.53 / 2.0, 7.42 / 2.0, 5.0];
const INNER: [f64; 3] = [5.0 / 2.0, 4.82 / 2.0, 4.9];
const BODY: [f64; 3] = [1.0, 0.5, 0.25];

/// Volume of all voxels, mm³.
const ALL: f64 = 5.0 * 5.0 * 2.5;

struct Scene {
    name: &'static str,
    vial: &'static str,
    index: f64,
    attenuation: f64,
    albedo: f64,
    thresholds: [f64; 2],
    projector: &'static str,
    extra: &'static str,
    /// Of the part, what a body stands in: no light can be there, and nothing is to be printed.
    hidden_mm3: f64,
}

const PLAIN: Scene = Scene {
    name: "",
    vial: "",
    index: 1.347,
    attenuation: 0.03,
    albedo: 0.0,
    thresholds: [0.85, 0.95],
    projector: "collimated = { pixel_pitch_mm = 0.05 }",
    extra: "",
    hidden_mm3: 0.0,
};

const SCENES: [Scene; 8] = [
    Scene {
        name: "index-matched",
        vial: "index_matched = { radius_mm = 2.9 }",
        ..PLAIN
    },
    Scene {
        name: "cylinder",
        vial: "cylinder = { inner_radius_mm = 7.0, outer_radius_mm = 8.0, refractive_index = 1.54 }",
        index: 1.4,
        attenuation: 0.1,
        ..PLAIN
    },
    Scene {
        name: "cylinder-albedo-0.5",
        vial: "cylinder = { inner_radius_mm = 7.0, outer_radius_mm = 8.0, refractive_index = 1.54 }",
        index: 1.4,
        attenuation: 0.1,
        albedo: 0.5,
        ..PLAIN
    },
    Scene {
        name: "square",
        vial: "square = { inner_width_mm = 10.191, outer_width_mm = 12.408, refractive_index = 1.54 }",
        ..PLAIN
    },
    Scene {
        name: "square-low-thresholds",
        vial: "square = { inner_width_mm = 7.0, outer_width_mm = 8.0, refractive_index = 1.24 }",
        attenuation: 0.09,
        thresholds: [0.35, 0.55],
        ..PLAIN
    },
    Scene {
        name: "square-albedo-0.9",
        vial: "square = { inner_width_mm = 7.0, outer_width_mm = 8.0, refractive_index = 1.24 }",
        attenuation: 0.09,
        albedo: 0.9,
        thresholds: [0.35, 0.55],
        ..PLAIN
    },
    Scene {
        name: "mesh-cuvette",
        vial: "mesh = { outer = \"outer.stl\", inner = \"inner.stl\", refractive_index = 1.4702 }",
        index: 1.33,
        attenuation: 0.06,
        thresholds: [0.9, 0.97],
        projector: "telecentric = { pixel_pitch_mm = 0.05, aperture_radius_mm = 0.01, working_distance_mm = 20.0 }",
        ..PLAIN
    },
    Scene {
        name: "black-body",
        vial: "square = { inner_width_mm = 7.191, outer_width_mm = 7.6, refractive_index = 1.3 }",
        index: 1.15,
        attenuation: 0.06,
        thresholds: [0.9, 0.97],
        extra: "[[obstacles]]\nmesh = \"body.stl\"\n",
        // 4160 voxels have their middles in the body and in the box, not in its hole
        hidden_mm3: 0.52,
        ..PLAIN
    },
];

impl Scene {
    /// The job; with `albedo` instead of the scene's own, the attenuation kept.
    fn job(&self, albedo: f64) -> String {
        let Scene {
            vial,
            index,
            attenuation,
            thresholds: [lower, upper],
            projector,
            extra,
            ..
        } = self;
        let (absorbed, scattered) = ((1.0 - albedo) * attenuation, albedo * attenuation);
        let middle = (lower + upper) / 2.0;
        format!(
            "[target]
phantom.box_with_hole = {{ size_mm = 4.0, height_mm = 1.0, hole_mm = 2.0, hole_x_mm = -1.0 }}
[grid]
shape = [100, 100, 50]
pitch_mm = 0.05
[resin]
refractive_index = {index}
absorption_per_mm = {absorbed}
attenuation_per_mm = {attenuation}
scattering_per_mm = {scattered}
[vial]
{vial}
{extra}
[[light]]
pixels = [200, 20]
angles = 200
projector.{projector}
[objective.threshold]
lower = {lower}
upper = {upper}
[stop]
iterations = 30
[evaluate]
refine = 1
sub_angles = 1
bit_depth = 16
threshold = {middle}
"
        )
    }
}

/// Twelve triangles of a box as a binary STL, outside counter-clockwise.
fn write_box(path: &Path, half: [f64; 3]) -> std::io::Result<()> {
    const FACES: [[usize; 4]; 6] = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let corner = |i: usize| -> [f32; 3] {
        std::array::from_fn(|axis| {
            let sign = if i >> axis & 1 == 1 { 1.0 } else { -1.0 };
            (sign * half[axis]) as f32
        })
    };
    let mut bytes = vec![0u8; 80];
    bytes.extend(12u32.to_le_bytes());
    for [a, b, c, d] in FACES {
        for triangle in [[a, b, c], [a, c, d]] {
            bytes.extend([0u8; 12]);
            for value in triangle.into_iter().flat_map(corner) {
                bytes.extend(value.to_le_bytes());
            }
            bytes.extend([0u8; 2]);
        }
    }
    std::fs::write(path, bytes)
}

fn job(text: &str, folder: &Path, name: &str) -> Result<Job, Box<dyn Error>> {
    let file = folder.join(format!("{name}.toml"));
    std::fs::write(&file, text)?;
    let job = Job::read(&file, &[])?;
    Ok(job.with_folder(&folder.join(name), "folder"))
}

/// Share of all voxels that are right.
fn score(scene: &Scene, folder: &Path) -> Result<f64, Box<dyn Error>> {
    let text = std::fs::read_to_string(folder.join("report.json"))?;
    let report: serde_json::Value = serde_json::from_str(&text)?;
    let wrong = |key: &str| report["evaluation"][key].as_f64().unwrap_or(f64::NAN);
    let wrong = wrong("over_mm3") + wrong("under_mm3") - scene.hidden_mm3;
    Ok(1.0 - wrong / ALL)
}

pub(crate) fn study(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let with_paths = arguments.get(1).is_some_and(|word| word == "paths");
    let folder = tempfile::tempdir()?;
    for (name, half) in [("outer", OUTER), ("inner", INNER), ("body", BODY)] {
        write_box(&folder.path().join(format!("{name}.stl")), half)?;
    }
    println!(
        "scene                  right %   IoU     s     without scattering in mind: right %   IoU    by paths: right %   IoU"
    );
    for scene in &SCENES {
        if arguments
            .first()
            .is_some_and(|name| name != scene.name && name != "all")
        {
            continue;
        }
        println!("{}", line(scene, folder.path(), with_paths)?);
    }
    Ok(())
}

fn line(scene: &Scene, folder: &Path, with_paths: bool) -> Result<String, Box<dyn Error>> {
    let cancel = Run::new();
    let show = |summary: &Summary, folder: &Path| -> Result<String, Box<dyn Error>> {
        let iou = summary.evaluation.iou.unwrap_or(f64::NAN);
        Ok(format!("{:8.3} {iou:7.4}", 100.0 * score(scene, folder)?))
    };
    let own = job(&scene.job(scene.albedo), folder, scene.name)?;
    let start = Instant::now();
    let summary = run(&own, false, &mut Silent, &cancel)?;
    let seconds = start.elapsed().as_secs_f64();
    let mut text = format!("{:22}", scene.name);
    write!(text, "{} {seconds:6.1}", show(&summary, &own.folder())?)?;
    if scene.albedo > 0.0 {
        let clear = job(&scene.job(0.0), folder, &format!("{}-clear", scene.name))?;
        run(&clear, false, &mut Silent, &cancel)?;
        let patterns = clear.folder().join("patterns.npz");
        // Cut where they print best: their dose is another one
        let best = scene.job(scene.albedo).replace("\nthreshold = ", "\n# ");
        let other = job(&best, folder, &format!("{}-other", scene.name))?;
        let summary = simulate(&other, &patterns, &mut Silent, &cancel)?;
        write!(text, "   {}", show(&summary, &other.folder())?)?;
        if with_paths {
            let random = format!(
                "{}[model.monte_carlo]\npaths_per_pixel = 1\n",
                scene.job(scene.albedo)
            );
            let judge = job(&random, folder, &format!("{}-paths", scene.name))?;
            let patterns = own.folder().join("patterns.npz");
            let summary = simulate(&judge, &patterns, &mut Silent, &cancel)?;
            write!(text, "   {}", show(&summary, &judge.folder())?)?;
        }
    }
    Ok(text)
}
