//! The light that is projected makes a right-handed part, whichever way the vial turns.
//!
//! A chiral part is optimized by the command, its PNG frames are read back, and the light they stand for is laid down
//! again by a back projection written here from `docs/conventions.md` alone: nothing of the library's models is used.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;
use std::process::Command;

const SIZE_MM: f64 = 3.0;
const HEIGHT_MM: f64 = 2.0;
const FRAMES: usize = 60;
const COLUMNS: usize = 44;
const ROWS: usize = 24;
const PITCH_MM: f64 = 0.1;
const RADIUS_MM: f64 = 3.0;
const ABSORPTION_PER_MM: f64 = 0.1;
/// Start of the turn: no symmetry of the frames may hide a mistake.
const START_DEG: f64 = 17.0;

fn job(rotation: &str) -> String {
    format!(
        r#"[target]
phantom.chiral = {{ size_mm = {SIZE_MM}, height_mm = {HEIGHT_MM} }}
[grid]
pitch_mm = {PITCH_MM}
[resin]
refractive_index = 1.5
absorption_per_mm = {ABSORPTION_PER_MM}
[vial.index_matched]
radius_mm = {RADIUS_MM}
[[light]]
pixels = [{COLUMNS}, {ROWS}]
angles = {{ count = {FRAMES}, start_deg = {START_DEG} }}
rotation = "{rotation}"
projector.collimated = {{ pixel_pitch_mm = {PITCH_MM} }}
[objective.threshold]
[stop]
iterations = 20
[evaluate]
refine = 1
[output]
folder = "run"
"#
    )
}

/// Pattern values of one frame, `[row, column]`: gray over white, times the full scale that the file states.
fn frame(path: &Path) -> Vec<f64> {
    let decoder = png::Decoder::new(BufReader::new(File::open(path).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut gray = vec![0; reader.output_buffer_size().unwrap()];
    let shape = reader.next_frame(&mut gray).unwrap();
    assert_eq!(
        (shape.width as usize, shape.height as usize, shape.bit_depth),
        (COLUMNS, ROWS, png::BitDepth::Eight)
    );
    let texts = &reader.info().uncompressed_latin1_text;
    let scale = texts
        .iter()
        .find(|text| text.keyword == "tomolith:full_scale")
        .unwrap();
    let scale: f64 = scale.text.parse().unwrap();
    gray.iter().map(|&v| f64::from(v) / 255.0 * scale).collect()
}

/// Samples of the test's own volume along x and y, and along z: at the middle of each pixel row.
const EDGE: usize = 40;

/// Sample i of n, mm from the center.
fn place(i: usize, n: usize) -> f64 {
    (i as f64 - (n as f64 - 1.0) / 2.0) * PITCH_MM
}

/// Dose `[z, y, x]` of frames whose azimuths run in one sense (+1 or −1): light of frame k arrives from α_k and travels
/// along −(cos α, sin α); columns grow along (−sin α, cos α); row 0 is the top.
fn dose(frames: &[Vec<f64>], sense: f64) -> Vec<f64> {
    let mut dose = vec![0.0; ROWS * EDGE * EDGE];
    for (k, image) in frames.iter().enumerate() {
        let turn = sense * 360.0 * k as f64 / FRAMES as f64;
        let (sin, cos) = (START_DEG + turn).to_radians().sin_cos();
        for iy in 0..EDGE {
            for ix in 0..EDGE {
                let (x, y) = (place(ix, EDGE), place(iy, EDGE));
                if x.hypot(y) > RADIUS_MM {
                    continue;
                }
                let (sideways, toward_light) = (-x * sin + y * cos, x * cos + y * sin);
                let entry = (RADIUS_MM * RADIUS_MM - sideways * sideways).sqrt();
                let reaches = (-ABSORPTION_PER_MM * (entry - toward_light)).exp();
                let column = sideways / PITCH_MM + (COLUMNS as f64 - 1.0) / 2.0;
                if column < 0.0 || column >= (COLUMNS - 1) as f64 {
                    continue;
                }
                let (left, share) = (column as usize, column.fract());
                for row in 0..ROWS {
                    let pixels = &image[row * COLUMNS + left..][..2];
                    let light = pixels[0] * (1.0 - share) + pixels[1] * share;
                    let iz = ROWS - 1 - row;
                    dose[(iz * EDGE + iy) * EDGE + ix] += ABSORPTION_PER_MM * light * reaches;
                }
            }
        }
    }
    dose
}

/// Whether a point is in the part: an F, readable from above, whose foot is twice as high as the rest.
fn inside(x: f64, y: f64, z: f64) -> bool {
    let (x, y, z) = (x / SIZE_MM, y / SIZE_MM, z / HEIGHT_MM);
    let within = |[x0, y0, x1, y1]: [f64; 4]| x0 <= x && x < x1 && y0 <= y && y < y1;
    let letter = within([-0.375, -0.5, -0.125, 0.5])
        || within([-0.375, 0.3, 0.375, 0.5])
        || within([-0.375, -0.05, 0.175, 0.15]);
    let foot = within([-0.375, -0.5, -0.125, -0.2]);
    (letter && (-0.5..0.0).contains(&z)) || (foot && (-0.5..0.5).contains(&z))
}

/// Best intersection over union of {dose > t} with the part, its axes multiplied by these signs.
fn fit(dose: &[f64], [sx, sy, sz]: [f64; 3]) -> f64 {
    let mut samples: Vec<(f64, bool)> = Vec::with_capacity(dose.len());
    for (i, &dose) in dose.iter().enumerate() {
        let (iz, iy, ix) = (i / (EDGE * EDGE), i / EDGE % EDGE, i % EDGE);
        let (x, y, z) = (place(ix, EDGE), place(iy, EDGE), place(iz, ROWS));
        samples.push((dose, inside(sx * x, sy * y, sz * z)));
    }
    samples.sort_by(|a, b| b.0.total_cmp(&a.0));
    let part = samples.iter().filter(|s| s.1).count();
    let (mut hit, mut miss, mut best) = (0usize, 0usize, 0.0f64);
    for (_, is_part) in samples {
        if is_part {
            hit += 1;
        } else {
            miss += 1;
        }
        best = best.max(hit as f64 / (part + miss) as f64);
    }
    best
}

/// Every other way to lay the part into the frame: mirrored or turned by half a turn.
const WRONG: [[f64; 3]; 7] = [
    [-1.0, 1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [-1.0, 1.0, -1.0],
    [1.0, -1.0, -1.0],
    [-1.0, -1.0, -1.0],
];

#[test]
fn frames_on_disk_make_a_right_handed_part_in_both_senses() {
    for (rotation, sense) in [("clockwise", 1.0), ("counterclockwise", -1.0)] {
        let temp = tempfile::tempdir().unwrap();
        fs::write(temp.path().join("job.toml"), job(rotation)).unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_tomolith"))
            .current_dir(temp.path())
            .args(["run", "job.toml", "--quiet"])
            .output()
            .unwrap();
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{message}");
        let path = |k| temp.path().join(format!("run/frames/frame_{k:04}.png"));
        let frames: Vec<Vec<f64>> = (0..FRAMES).map(|k| frame(&path(k))).collect();

        let right = dose(&frames, sense);
        let upright = fit(&right, [1.0; 3]);
        let others = WRONG.map(|signs| fit(&right, signs));
        assert!(upright > 0.9, "{rotation}: {upright}");
        for (signs, other) in WRONG.iter().zip(others) {
            assert!(other < upright - 0.3, "{rotation}, {signs:?}: {other}");
        }

        // Turned the other way round the same frames make the mirror image: the test sees what it is for
        let wrong = dose(&frames, -sense);
        let best = fit(&wrong, [1.0; 3]);
        assert!(best < upright - 0.3, "{rotation}, wrong sense: {best}");
    }
}
