//! What a machine shows makes the part that was designed, however the machine stands.
//!
//! A chiral part is optimized once and exported for machines with every flip and turn, both senses of rotation and another
//! start. The test then plays the movie or the frames on a machine of its own, written from docs/printer.md alone: it cuts
//! the picture out of the canvas, turns and mirrors it back by moving pixels, and lays the light down by a plain back
//! projection. Of the library it uses the decoder of movies, nothing else.

use crate::bench::{Bench, doubles};
use serde_json::Value;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use tomolith::io::movie::read_movie;

const FRAMES: usize = 60;
const COLUMNS: usize = 44;
const ROWS: usize = 24;
const PITCH_MM: f64 = 0.1;
const SIZE_MM: f64 = 3.0;
const HEIGHT_MM: f64 = 2.0;
const START_DEG: f64 = 12.0;

const JOB: &str = r#"[target]
phantom.chiral = { size_mm = 3.0, height_mm = 2.0 }
[grid]
pitch_mm = 0.1
[resin]
refractive_index = 1.5
pure_radon = true
critical_dose_mj_per_mm3 = 2.0
[vial.index_matched]
radius_mm = 3.0
[[light]]
pixels = [44, 24]
angles = { count = 60, start_deg = 12.0 }
projector.collimated = { pixel_pitch_mm = 0.1 }
[objective.threshold]
[stop]
iterations = 15
[evaluate]
refine = 1
[output]
folder = "run"
"#;

/// A folder with a run.
fn bench() -> Bench {
    let bench = Bench::with(&[("job.toml", JOB)]);
    bench.done("run job.toml --quiet");
    bench
}

impl Bench {
    /// Exports the run for a machine into a folder.
    fn export(&self, printer: &str, folder: &str) -> PathBuf {
        self.write("machine.toml", &format!("[printer]\n{printer}"));
        let line = format!("export run --printer machine.toml --output {folder} --quiet");
        self.ended(0, &line);
        self.path(folder)
    }
}

/// A gray picture, row 0 on top.
#[derive(Clone)]
struct Picture {
    rows: usize,
    columns: usize,
    values: Vec<f64>,
}

impl Picture {
    fn from(rows: usize, columns: usize, at: impl Fn(usize, usize) -> f64) -> Self {
        let values = (0..rows * columns)
            .map(|i| at(i / columns, i % columns))
            .collect();
        Picture {
            rows,
            columns,
            values,
        }
    }

    fn at(&self, row: usize, column: usize) -> f64 {
        self.values[row * self.columns + column]
    }

    fn clockwise(&self) -> Self {
        Picture::from(self.columns, self.rows, |row, column| {
            self.at(self.rows - 1 - column, row)
        })
    }

    fn mirrored(&self, sideways: bool, upright: bool) -> Self {
        Picture::from(self.rows, self.columns, |row, column| {
            let row = if upright { self.rows - 1 - row } else { row };
            self.at(
                row,
                if sideways {
                    self.columns - 1 - column
                } else {
                    column
                },
            )
        })
    }

    /// The rectangle of a size whose middle lies so many pixels right and up of this picture's.
    fn cut(&self, rows: usize, columns: usize, [right, up]: [isize; 2]) -> Self {
        let top = (self.rows - rows) as isize / 2 - up;
        let left = (self.columns - columns) as isize / 2 + right;
        Picture::from(rows, columns, |row, column| {
            self.at(
                (row as isize + top) as usize,
                (column as isize + left) as usize,
            )
        })
    }
}

/// A machine that shows its picture turned and mirrored, and a vial that turns.
#[derive(Clone, Copy)]
struct Machine {
    canvas: [usize; 2],
    quarter_turns: usize,
    flips: [bool; 2],
    offset: [isize; 2],
    /// +1: the azimuth of the light grows in the resin frame, that is the vial turns clockwise.
    sense: f64,
    start_deg: f64,
}

impl Machine {
    fn table(&self) -> String {
        let sense = if self.sense > 0.0 {
            "clockwise"
        } else {
            "counterclockwise"
        };
        format!(
            "canvas = {:?}\nquarter_turns = {}\nflip_horizontal = {}\nflip_vertical = {}\noffset_px = {:?}\nrotation = \"{sense}\"\nstart_deg = {:?}\n",
            self.canvas,
            self.quarter_turns,
            self.flips[0],
            self.flips[1],
            self.offset,
            self.start_deg
        )
    }

    /// The light at the vial of what the device shows: the machine undoes turn and flips, in this order.
    fn light(&self, shown: &Picture) -> Picture {
        let lies = self.quarter_turns % 2 == 1;
        let (rows, columns) = if lies {
            (COLUMNS, ROWS)
        } else {
            (ROWS, COLUMNS)
        };
        let mut light = shown.cut(rows, columns, self.offset);
        (0..self.quarter_turns).for_each(|_| light = light.clockwise());
        light.mirrored(self.flips[0], self.flips[1])
    }

    /// Best IoU of the light of these pictures with the part, and with the part's axes multiplied by signs.
    fn prints(&self, shown: &[Picture]) -> [f64; 8] {
        let light: Vec<Picture> = shown.iter().map(|picture| self.light(picture)).collect();
        fits(&dose(&light, self.sense, self.start_deg))
    }
}

/// Samples of the test's own volume along x and y; along z at the middle of each row of pixels.
const EDGE: usize = 40;

fn place(i: usize, n: usize) -> f64 {
    (i as f64 - (n as f64 - 1.0) / 2.0) * PITCH_MM
}

/// Plain back projection `[z, y, x]`: columns grow along (−sin α, cos α), row 0 is the top.
fn dose(light: &[Picture], sense: f64, start_deg: f64) -> Vec<f64> {
    let mut dose = vec![0.0; ROWS * EDGE * EDGE];
    for (k, picture) in light.iter().enumerate() {
        let (sin, cos) = (start_deg + sense * 360.0 * k as f64 / FRAMES as f64)
            .to_radians()
            .sin_cos();
        for (i, value) in dose.iter_mut().enumerate() {
            let (iz, x, y) = (
                i / (EDGE * EDGE),
                place(i % EDGE, EDGE),
                place(i / EDGE % EDGE, EDGE),
            );
            let column = (-x * sin + y * cos) / PITCH_MM + (COLUMNS as f64 - 1.0) / 2.0;
            if column >= 0.0 && column < (COLUMNS - 1) as f64 {
                let (left, share) = (column as usize, column.fract());
                let row = ROWS - 1 - iz;
                *value += picture.at(row, left) * (1.0 - share) + picture.at(row, left + 1) * share;
            }
        }
    }
    dose
}

/// Whether a point is in the part: an F, readable from above, whose foot is twice as high as the rest.
fn inside(x: f64, y: f64, z: f64) -> bool {
    let (x, y, z) = (x / SIZE_MM, y / SIZE_MM, z / HEIGHT_MM);
    let within = |[x0, y0, x1, y1]: [f64; 4]| x0 <= x && x < x1 && y0 <= y && y < y1;
    let bars = within([-0.375, 0.3, 0.375, 0.5]) || within([-0.375, -0.05, 0.175, 0.15]);
    let letter = within([-0.375, -0.5, -0.125, 0.5]) || bars;
    let foot = within([-0.375, -0.5, -0.125, -0.2]);
    (letter && (-0.5..0.0).contains(&z)) || (foot && (-0.5..0.5).contains(&z))
}

/// Best intersection over union of {dose > t} with the part, its axes multiplied by these signs.
fn fit(dose: &[f64], [sx, sy, sz]: [f64; 3]) -> f64 {
    let sample = |(i, &dose): (usize, &f64)| {
        let (x, y, z) = (
            place(i % EDGE, EDGE),
            place(i / EDGE % EDGE, EDGE),
            place(i / (EDGE * EDGE), ROWS),
        );
        (dose, inside(sx * x, sy * y, sz * z))
    };
    let mut samples: Vec<(f64, bool)> = dose.iter().enumerate().map(sample).collect();
    samples.sort_by(|a, b| b.0.total_cmp(&a.0));
    let part = samples.iter().filter(|s| s.1).count();
    let (mut hit, mut miss, mut best) = (0usize, 0usize, 0.0f64);
    for (_, is_part) in samples {
        *(if is_part { &mut hit } else { &mut miss }) += 1;
        best = best.max(hit as f64 / (part + miss) as f64);
    }
    best
}

/// The same with the part's axes multiplied by signs; first the part as it is.
fn fits(dose: &[f64]) -> [f64; 8] {
    let sign = |i: usize, axis: usize| if i >> axis & 1 == 0 { 1.0 } else { -1.0 };
    std::array::from_fn(|i| fit(dose, [0, 1, 2].map(|axis| sign(i, axis))))
}

fn movie(folder: &Path, [columns, rows]: [usize; 2]) -> Vec<Picture> {
    let read = read_movie(
        &folder.join("chiral_10rpm.mp4"),
        [FRAMES, rows, columns],
        None,
    )
    .unwrap();
    let picture = |levels: &[u16]| {
        Picture::from(rows, columns, |row, column| {
            f64::from(levels[row * columns + column])
        })
    };
    read.values.chunks(rows * columns).map(picture).collect()
}

/// The PNG frames of a folder.
fn frames(folder: &Path) -> Vec<Picture> {
    let frame = |k: usize| {
        let file = File::open(folder.join(format!("frames/frame_{k:04}.png"))).unwrap();
        let mut reader = png::Decoder::new(BufReader::new(file)).read_info().unwrap();
        let mut gray = vec![0; reader.output_buffer_size().unwrap()];
        let shape = reader.next_frame(&mut gray).unwrap();
        let mut texts = reader.info().uncompressed_latin1_text.iter();
        assert!(texts.any(|text| text.keyword == "tomolith:full_scale"));
        Picture::from(
            shape.height as usize,
            shape.width as usize,
            |row, column| f64::from(gray[row * shape.width as usize + column]),
        )
    };
    (0..FRAMES).map(frame).collect()
}

#[test]
#[ignore = "slow"]
fn the_movie_alone_makes_the_right_part_on_machines_of_all_flips_and_turns() {
    let bench = bench();
    for number in 0..10 {
        // Four turns and both sideways flips are the eight ways a picture can stand; two of them again by upright flips
        let machine = Machine {
            canvas: [90, 80],
            quarter_turns: number % 4,
            flips: [number / 4 % 2 == 1, number / 8 == 1],
            offset: [7, -5],
            sense: if number % 3 == 0 { 1.0 } else { -1.0 },
            start_deg: START_DEG + 6.0 * (number % 5) as f64,
        };
        let folder = bench.export(&machine.table(), &format!("machine{number}"));
        let shown = if number < 8 {
            movie(&folder, machine.canvas)
        } else {
            frames(&folder)
        };
        let fits = machine.prints(&shown);
        assert!(fits[0] > 0.9, "{number}: {fits:?}");
        for wrong in &fits[1..] {
            assert!(*wrong < fits[0] - 0.3, "{number}: {fits:?}");
        }
        // The test sees what it is for: on a machine with one flip more the same movie makes another part
        let other = Machine {
            flips: [!machine.flips[0], machine.flips[1]],
            ..machine
        };
        assert!(other.prints(&shown)[0] < fits[0] - 0.3, "{number}");
        let turned = Machine {
            sense: -machine.sense,
            ..machine
        };
        assert!(turned.prints(&shown)[0] < fits[0] - 0.3, "{number}");
    }
}

#[test]
fn frames_on_disk_make_a_right_handed_part_in_both_senses() {
    for (rotation, sense) in [("clockwise", 1.0), ("counterclockwise", -1.0)] {
        // Start of the turn: no symmetry of the frames may hide a mistake
        let turn =
            format!("rotation = \"{rotation}\"\nangles = {{ count = 60, start_deg = 17.0 }}");
        let job = JOB.replace("angles = { count = 60, start_deg = 12.0 }", &turn);
        let bench = Bench::with(&[("job.toml", &job)]);
        bench.done("run job.toml --quiet");
        let shown = frames(&bench.path("run"));
        let fits = fits(&dose(&shown, sense, 17.0));
        assert!(fits[0] > 0.9, "{rotation}: {fits:?}");
        for wrong in &fits[1..] {
            assert!(*wrong < fits[0] - 0.3, "{rotation}: {fits:?}");
        }
        // Turned the other way round the same frames make the mirror image: the test sees what it is for
        let mirrored = fit(&dose(&shown, -sense, 17.0), [1.0; 3]);
        assert!(mirrored < fits[0] - 0.3, "{rotation}: {mirrored}");
    }
}

/// A machine with everything: other pixels, a turn, a curve, an axis that is off, a vial beside its axis, two copies.
const EVERYTHING: &str = r#"canvas = [300, 260]
pixel_pitch_mm = 0.05
offset_px = [3.3, -8.6]
flip_vertical = true
quarter_turns = 3
rotation_deg = 1.7
axis_offset_mm = 0.13
eccentricity_mm = 0.21
eccentricity_deg = 40.0
copies_px = [[-70, 0], [70, 0]]
rotation = "counterclockwise"
start_deg = 78.0
gray_curve = [[0.0, 0.01], [0.3, 0.1], [0.7, 0.5], [1.0, 1.0]]
flat_field = "flat.npy"
dead_pixels = "dead.npy"
peak_irradiance_mw_per_cm2 = 50.0
stack = true
"#;

#[test]
fn simulate_takes_back_what_a_machine_does_from_every_file() {
    let bench = bench();
    let pixels = |value: &dyn Fn(usize, usize) -> f64| {
        let values: Vec<f64> = (0..260 * 300).map(|i| value(i / 300, i % 300)).collect();
        doubles("260, 300", &values)
    };
    let edge = |row: usize, column: usize| {
        let (x, y) = (column as f64 / 150.0 - 1.0, row as f64 / 130.0 - 1.0);
        1.0 - 0.3 * (x * x + y * y)
    };
    bench.write("flat.npy", &pixels(&edge));
    let dead =
        |row: usize, column: usize| f64::from(u8::from(row * 300 + column == 131 * 300 + 77));
    bench.write("dead.npy", &pixels(&dead));
    bench.write(
        "machine.toml",
        &format!("{JOB}[printer]\n{EVERYTHING}").replace("\"run\"", "\"everything\""),
    );
    bench.done("run machine.toml --quiet --overwrite");
    let report = bench.report("everything");
    let plain = bench.report("run");
    let iou = |report: &Value| report["evaluation"]["iou"].as_f64().unwrap();
    assert!(
        iou(&report) > iou(&plain) - 0.03,
        "{} {}",
        iou(&report),
        iou(&plain)
    );
    for (file, tolerance) in [
        ("patterns.npz", 0.0),
        ("frames", 0.0),
        ("frames.npz", 0.0),
        ("chiral_10rpm.mp4", 0.01),
    ] {
        bench.done(&format!(
            "simulate machine.toml --quiet --patterns everything/{file} --output again"
        ));
        let again = bench.report("again");
        assert!(
            (iou(&again) - iou(&report)).abs() <= tolerance,
            "{file}: {} {}",
            iou(&again),
            iou(&report)
        );
        let scale = |report: &Value| report["lights"][0]["full_scale"].as_f64().unwrap();
        assert_eq!(scale(&again), scale(&report), "{file}");
    }
    // The report states time, energy and use of the light
    let budget = &report["lights"][0]["budget"];
    let number = |name: &str| budget[name].as_f64().unwrap();
    let turns = number("turns");
    assert!(
        (number("time_s") - 6.0 * turns).abs() < 1e-6 * turns,
        "{budget}"
    ); // 10 turns a minute
    assert!(
        (number("energy_mj") - turns * number("energy_per_turn_mj")).abs()
            < 1e-6 * number("energy_mj")
    );
    let best = report["exposure"]["time_s"]["best"].as_f64().unwrap();
    assert!((best / number("time_s") - 1.0).abs() < 1e-12, "{best}");
    assert!(number("light_used") > 0.0 && number("light_used") < 0.5);
    // White is shown for a sixtieth of the time, at half a mW/mm²
    let white = number("time_s") / 60.0 * 0.5;
    assert!(
        (number("white_mj_per_mm2") / white - 1.0).abs() < 1e-6,
        "{budget}"
    );

    // A movie without a machine in the job is of another size, and is refused
    bench.refuse(
        "simulate job.toml --patterns everything/frames --output no",
        &["expected shape [60, 24, 44]"],
    );
}

#[test]
fn frames_in_one_color_print_what_gray_frames_print() {
    let bench = bench();
    let gray = frames(&bench.export("stack = true", "gray"));
    let folder = bench.export("stack = true\nchannel = \"blue\"", "blue");
    for (k, gray) in gray.iter().enumerate() {
        let file = File::open(folder.join(format!("frames/frame_{k:04}.png"))).unwrap();
        let mut reader = png::Decoder::new(BufReader::new(file)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let shape = reader.next_frame(&mut pixels).unwrap();
        assert_eq!(shape.color_type, png::ColorType::Rgb);
        assert_eq!(shape.bit_depth, png::BitDepth::Eight);
        for (pixel, level) in pixels.chunks(3).zip(&gray.values) {
            assert_eq!(pixel, [0, 0, *level as u8]);
        }
    }
    assert!(!folder.join("chiral_10rpm.mp4").exists());
    let simulated = |patterns: &str, machine: &str| {
        bench.done(&format!(
            "simulate job.toml --quiet --patterns {patterns} --output again {machine}"
        ));
        (
            bench.shown("again"),
            bench.report("again")["evaluation"].clone(),
        )
    };
    let expected = simulated("gray/frames", "");
    for patterns in [
        "blue/frames",
        "blue/chiral_10rpm.mov",
        "blue/frames.npz",
        "blue",
    ] {
        for machine in ["", "--set printer.channel=blue"] {
            let found = simulated(patterns, machine);
            assert!(found == expected, "{patterns} {machine}");
        }
    }
    assert!(simulated("gray/frames", "--set printer.channel=green") == expected);
    bench.refuse(
        "simulate job.toml --patterns blue/frames --output no --set printer.channel=red",
        &["blue/frames/frame_0000.png: light, but none of it red"],
    );
    for line in ["check job.toml", "export run --output no"] {
        bench.refuse(
            &format!("{line} --set printer.channel=violet"),
            &["printer.channel: ", "violet", "red", "green", "blue"],
        );
        bench.refuse(
            &format!("{line} --set printer.channel=blue --set evaluate.bit_depth=12"),
            &["evaluate.bit_depth: 12 bits together with printer.channel = \"blue\""],
        );
    }
}

#[test]
fn calibration_frames_shine_in_the_channel_of_the_machine() {
    let bench = Bench::with(&[
        ("job.toml", JOB),
        (
            "blue.toml",
            &format!("{JOB}[printer]\nchannel = \"blue\"\n"),
        ),
    ]);
    bench.done("calibrate --job job.toml gray_steps --output gray");
    bench.done("calibrate --job blue.toml gray_steps --output of_job");
    let colored = |name: &str| {
        let file = File::open(bench.path(name)).unwrap();
        let mut reader = png::Decoder::new(BufReader::new(file)).read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let shape = reader.next_frame(&mut bytes).unwrap();
        (shape.color_type.samples(), bytes)
    };
    let (samples, gray) = colored("gray/gray_steps.png");
    assert_eq!(samples, 1);
    let in_place = |place: usize| -> Vec<u8> {
        let color = |level: &u8| {
            (0..3)
                .map(|i| if i == place { *level } else { 0 })
                .collect()
        };
        gray.iter().flat_map::<Vec<u8>, _>(color).collect()
    };
    assert_eq!(colored("of_job/gray_steps.png"), (3, in_place(2)));
    let canvas = "--canvas 44 24 --channel";
    bench.done(&format!(
        "calibrate {canvas} green gray_steps --output of_canvas"
    ));
    assert_eq!(colored("of_canvas/gray_steps.png"), (3, in_place(1)));
    bench.refuse(
        &format!("calibrate {canvas} red --bits 12 --output no"),
        &["--bits: 12 bits"],
    );
    let discs =
        "calibrate discs --canvas 80 80 --pixel-pitch-mm 0.1 --irradiance 25 --from 20 --to 400";
    bench.done(&format!("{discs} --channel red --output discs"));
    let (samples, pixels) = colored("discs/frames/frame_0000.png");
    assert_eq!((samples, pixels.iter().max()), (3, Some(&255)));
    assert!(pixels.chunks(3).all(|pixel| pixel[1..] == [0, 0]));
}

#[test]
fn a_time_bounds_the_pixels() {
    let bench = bench();
    let time = |folder: &str| {
        bench.report(folder)["lights"][0]["budget"]["time_s"]
            .as_f64()
            .unwrap()
    };
    let machine = "[printer]\npeak_irradiance_mw_per_cm2 = 50.0\n";
    bench.write("timed.toml", &format!("{JOB}{machine}"));
    bench.done("run timed.toml --quiet --output free");
    let free = time("free");
    let limit = format!("printer.time_s={}", free * 0.8);
    bench.done(&format!(
        "run timed.toml --quiet --output bound --set {limit}"
    ));
    // The gel dose of the print is not exactly the middle of the window that the bound was made with
    assert!(
        (time("bound") / (0.8 * free) - 1.0).abs() < 0.1,
        "{free} {}",
        time("bound")
    );
}

#[test]
fn device_pixels_in_micrometers_are_refused_and_their_size_is_told_where_it_is_left_out() {
    let bench = Bench::with(&[("job.toml", JOB)]);
    let check = "check job.toml --set printer.canvas=[60,40]";
    bench.says(
        0,
        check,
        &["as large at the vial as one of the light, 0.1 mm"],
    );
    let line = format!("{check} --set printer.pixel_pitch_mm=100");
    bench.refuse(&line, &["printer.pixel_pitch_mm: 100 mm, 1000 times"]);
    let line = "check job.toml --set printer.pixel_pitch_mm=1e-5";
    let found = "printer.pixel_pitch_mm: pixels so small that the patterns need";
    bench.refuse(line, &[found, "at most 16384 along an axis"]);
}
