//! Files that other programs made: movies, frames, arrays, meshes.

use crate::bench::{Bench, JOB, contains, npy, text_of};
use serde_json::Value;
use std::fs;
use std::process::Command;
use tomolith::io::npy::{read_patterns, read_volume};

impl Bench {
    /// What the light of the simulated patterns is.
    pub(crate) fn shown(&self, folder: &str) -> Vec<f32> {
        let mut arrays = read_patterns(&self.path(folder).join("patterns.npz")).unwrap();
        arrays.remove(0).shown
    }
}

#[test]
fn a_lossless_movie_is_the_frames_bit_for_bit() {
    let bench = Bench::new();
    bench.done(
        "run job.toml --quiet --output a --set output.movie=lossless --set evaluate.bit_depth=12",
    );
    assert!(bench.path("a/gear_10rpm.mov").is_file());
    assert!(!bench.path("a/gear_10rpm.mp4").exists());
    let report = bench.report("a");
    assert_eq!(report["movies"][0]["largest_error_of_255"], 0);
    let exposure = bench.read("a/exposure.json");
    assert!(exposure.contains("gear_10rpm.mov"), "{exposure}");
    fs::copy(bench.path("a/gear_10rpm.mov"), bench.path("alone.mov")).unwrap();
    bench.done("simulate job.toml --patterns alone.mov --quiet --output b");
    assert_eq!(bench.shown("a"), bench.shown("b"));
    bench.refuse(
        "run job.toml --set output.movie=divx",
        &["output.movie", "h264", "lossless"],
    );
}

#[test]
fn movies_that_need_ffmpeg_say_so_or_go_through_it() {
    let bench = Bench::new();
    bench.write("movie.mkv", b"\x1a\x45\xdf\xa3 and so on");
    bench.write("text.mp4", b"no movie");
    let line = "simulate job.toml --patterns movie.mkv --quiet --output a";
    bench.refuse_each(&format!(
        "$ {line}
        movie.mkv: a Matroska or WebM file, which the program ffmpeg can read, but it is not installed … ffmpeg -i movie.mkv -pix_fmt gray frames/frame_%04d.png
        $ simulate job.toml --patterns text.mp4 --output a
        text.mp4: no movie: it begins with `no movie`"
    ));
    for (name, start, what) in [
        ("a.flv", &b"FLV\x01\x01"[..], "a Flash video"),
        ("a.ogv", b"OggS\0\x02", "an Ogg file"),
        ("a.mpg", b"\0\0\x01\xba!", "an MPEG program stream"),
        (
            "a.wmv",
            b"\x30\x26\xb2\x75\x8e\x66\xcf\x11",
            "a Windows Media file",
        ),
        ("a.ts", &[0x47; 376], "an MPEG transport stream"),
    ] {
        bench.write(name, start);
        bench.refuse(
            &format!("simulate job.toml --patterns {name}"),
            &[what, "the program ffmpeg can read"],
        );
    }
    if cfg!(not(unix)) {
        return;
    }
    // A program of that name that gives 24 images, their pixels k, k + 1, …
    let programs = bench.path("programs");
    fs::create_dir(&programs).unwrap();
    let (program, body) = (programs.join("ffmpeg"), bench.path("body"));
    fs::write(&program, format!("#!/bin/sh\n. {}\n", body.display())).unwrap();
    Command::new("chmod")
        .arg("+x")
        .arg(&program)
        .status()
        .unwrap();
    let script = |text: &str| fs::write(&body, text).unwrap();
    let image = |k: usize, columns: usize| {
        let pixels = (0..16 * columns).map(|i| (i + k) as u8);
        let head = format!("P5\n{columns} 16\n255\n").into_bytes();
        head.into_iter().chain(pixels).collect::<Vec<u8>>()
    };
    let images: Vec<u8> = (0..24).flat_map(|k| image(k, 32)).collect();
    bench.write("images.pgm", &images);
    let cat = format!("/bin/cat {}", bench.path("images.pgm").display());
    script(&cat);
    text_of(0, line, &bench.output(line, &programs));
    let shown = bench.shown("a");
    for i in [0, 1, 511, 512, 24 * 512 - 1] {
        let level = (i % 512 + i / 512) as u8;
        assert!((shown[i] - f32::from(level) / 255.0).abs() < 1e-6, "{i}");
    }
    for (body, found) in [
        // What ffmpeg patches is refused, and what does not fit
        (
            format!("{cat}; echo '[h264 @ 0x5] concealing 3 errors' >&2"),
            "ffmpeg reports: concealing 3 errors",
        ),
        (format!("{cat}; exit 3"), "ffmpeg ended with"),
        (format!("{cat}; {cat}"), "more than 24 frames"),
        (
            format!("{cat} | /usr/bin/head -c 5250"),
            "10 frames instead of 24",
        ),
        (
            "printf 'P5\\n64 16\\n255\\n'".to_owned(),
            "64 × 16 pixels instead of 32 × 16",
        ),
        ("echo nonsense".to_owned(), "cannot be read"),
    ] {
        script(&body);
        contains(
            &text_of(2, line, &bench.output(line, &programs)),
            line,
            &[found],
        );
    }
}

/// Without the notes that frames of Tomolith hold, white is the largest level.
#[test]
fn gray_frames_may_be_stored_in_color() {
    let bench = Bench::new();
    fs::create_dir(bench.path("frames")).unwrap();
    for k in 0..24 {
        let file = fs::File::create(bench.path(&format!("frames/{k}.png"))).unwrap();
        let mut encoder = png::Encoder::new(file, 32, 16);
        encoder.set_color(png::ColorType::Rgb);
        let pixels: Vec<u8> = (0..512).flat_map(|i| [(i / 2 + k) as u8; 3]).collect();
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(&pixels).unwrap();
    }
    bench.done("simulate job.toml --patterns frames --quiet --output a");
    assert!((bench.shown("a")[5 * 512 + 100] - 55.0 / 255.0).abs() < 1e-6);
}

#[test]
fn patterns_are_numbers_of_any_type() {
    let bench = Bench::new();
    let bytes: Vec<u8> = (0..24 * 512).map(|i| (i % 7) as u8).collect();
    let halves = [0x0000u16, 0x3c00, 0x4000, 0x4200, 0x4400, 0x4500, 0x4600];
    let big: Vec<u8> = bytes
        .iter()
        .flat_map(|&b| halves[usize::from(b)].to_be_bytes())
        .collect();
    bench.write("u1.npy", &npy("|u1", "24, 16, 32", &bytes));
    bench.write("f2.npy", &npy(">f2", "24, 16, 32", &big));
    for name in ["u1", "f2"] {
        bench.done(&format!(
            "simulate job.toml --patterns {name}.npy --quiet --output {name}"
        ));
        let shown = bench.shown(name);
        for (found, wanted) in shown.iter().zip(&bytes) {
            assert!(
                (found - f32::from(*wanted)).abs() < 0.02,
                "{name}: {found} {wanted}"
            );
        }
    }
    // A start, a map and an objective's weights ask the same reader
    bench.done("run job.toml --quiet --output c --set start.patterns.file=f2.npy");
    bench.write("dose.npy", &npy(">i2", "2, 2", &[0, 1, 0, 9, 0, 8, 0, 2]));
    bench.write("target.npy", &npy("|u1", "2, 2", &[0, 1, 1, 0]));
    let found = bench.json("metrics dose.npy target.npy");
    assert_eq!(found["evaluation"]["iou"], 1.0);
}

/// A box as OBJ, its corner at the origin.
fn obj([x, y, z]: [f64; 3]) -> String {
    let corner = |i: usize| {
        let [a, b, c] = [i & 1, i >> 1 & 1, i >> 2].map(|bit| bit as f64);
        format!("v {} {} {}\n", a * x, b * y, c * z)
    };
    let faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    (0..8).map(corner).collect::<String>() + faces
}

#[test]
fn a_mesh_in_another_unit_is_asked_for_it() {
    let bench = Bench::new();
    bench.write("meters.obj", obj([0.002, 0.002, 0.001]).as_bytes());
    bench.write("microns.obj", obj([2000.0, 2000.0, 1000.0]).as_bytes());
    let job = |name: &str| {
        JOB.replace(
            "phantom = \"gear\"\nsize_mm = 2.0",
            &format!("mesh = \"{name}\""),
        )
    };
    for (name, unit, asked) in [
        (
            "meters.obj",
            "m",
            "is its file in meters? set target.mesh_unit = \"m\"",
        ),
        (
            "microns.obj",
            "um",
            "is its file in micrometers? set target.mesh_unit = \"um\"",
        ),
    ] {
        bench.write("mesh.toml", job(name).as_bytes());
        bench.refuse("check mesh.toml", &[asked]);
        bench.done(&format!(
            "check mesh.toml --set target.mesh_unit=\"{unit}\""
        ));
    }
    let line = "voxelize meters.obj --pitch-mm 0.1 --output v.npy";
    bench.says(
        0,
        line,
        &[
            "no voxel is at least half inside",
            "is its file in meters? give --mesh-unit \"m\"",
        ],
    );
    bench.write("inches.obj", obj([101.6, 25.4, 25.4]).as_bytes());
    bench.says(
        0,
        "voxelize inches.obj --pitch-mm 5 --output i.npy",
        &[
            "is its file in micrometers? give --mesh-unit \"um\"; were its millimeters exported as inches? give --size-mm 4",
        ],
    );
    let line = line.replace("v.npy", "w.npy");
    let found = bench.json(&format!("{line} --mesh-unit m"));
    assert_eq!(found["part_voxels"], 20 * 20 * 10);
    bench.write("image.png", b"");
    bench.write("mesh.toml", job("image.png").as_bytes());
    bench.refuse(
        "check mesh.toml",
        &["target.mesh: ", "is an image", "`target.image`"],
    );
    bench.write("text.stl", b"Dear colleague,\nthe part is attached.\n");
    let text = bench.says(2, "voxelize text.stl --pitch-mm 0.1 --output x.npy", &[
            "a text without a facet (it begins with `Dear colleague,`), neither an ASCII nor a binary STL file",
        ]);
    assert!(!text.contains("truncated"), "{text}");
}

#[test]
fn a_repaired_mesh_can_be_saved() {
    let bench = Bench::new();
    // Without its top, a flat hole
    let open = obj([1.0, 2.0, 3.0]).replace("f 5 6 8 7\n", "");
    bench.write("open.obj", open.as_bytes());
    let line = "voxelize open.obj --pitch-mm 0.1 --output v.npy --save-mesh fixed.stl";
    bench.says(0, line, &["The mesh is open", "written fixed.stl"]);
    let found = bench.json("voxelize fixed.stl --pitch-mm 0.1 --output w.npy");
    assert_eq!(found["warnings"], serde_json::json!([]));
    assert!((found["exact_volume_mm3"].as_f64().unwrap() - 6.0).abs() < 1e-5);
    assert_eq!(
        read_volume(&bench.path("v.npy")).unwrap(),
        read_volume(&bench.path("w.npy")).unwrap()
    );
    bench.refuse(
        "voxelize open.obj --pitch-mm 0.1 --output v.npy --save-mesh fixed.obj",
        &["--save-mesh", ".stl"],
    );
    // Neither the mesh nor what somebody has is replaced
    let before = fs::read(bench.path("fixed.stl")).unwrap();
    for line in [
        "voxelize fixed.stl --pitch-mm 0.1 --output y.npy --save-mesh fixed.stl",
        "voxelize fixed.stl --pitch-mm 0.1 --output open.obj --save-mesh z.stl",
        "voxelize fixed.stl --pitch-mm 0.1 --output v.npy",
    ] {
        bench.expect(2, line);
    }
    assert_eq!(fs::read(bench.path("fixed.stl")).unwrap(), before);
    assert!(!bench.path("y.npy").exists());
}

#[test]
fn a_grid_that_cuts_the_part_is_refused_or_says_what_is_lost() {
    let bench = Bench::new();
    bench.write("box.obj", obj([2.0, 2.0, 2.0]).as_bytes());
    let line = "voxelize box.obj --pitch-mm 0.1 --shape 20 20 15 --output v.npy";
    bench.refuse(
        line,
        &[
            "--shape: a grid of 2 × 2 × 1.5 mm cuts the part, which is 2 × 2 × 2 mm",
            "--clip",
        ],
    );
    assert!(!bench.path("v.npy").exists());
    let clip = format!("{line} --clip");
    bench.says(
        0,
        &clip,
        &["the grid cuts the part: 25 % of its volume is lost"],
    );
    let lost = bench.json(&clip.replace("v.npy", "w.npy"))["lost_share"]
        .as_f64()
        .unwrap();
    assert!((lost - 0.25).abs() < 1e-5, "{lost}");
    let whole = bench.json("voxelize box.obj --pitch-mm 0.1 --shape 20 20 20 --output x.npy");
    assert_eq!(whole["lost_share"], Value::Null);
}

#[test]
fn an_array_that_is_read_as_a_mask_is_told() {
    let bench = Bench::new();
    let voxels = (0..10 * 12 * 20).map(|i| u8::from(i < 4 * 240 || i % 20 < 8));
    let voxels: Vec<u8> = voxels.collect();
    bench.write("mask.npy", &npy("|u1", "10, 12, 20", &voxels));
    bench.says(
        0,
        "check job.toml --set target={stack=\"mask.npy\",size_mm=2,height_mm=1} --set grid={pitch_mm=0.1}",
        &["the largest value in it is 1 of 255: it is read as a mask"],
    );
}

#[test]
#[cfg(unix)]
fn what_is_no_regular_file_is_refused_at_once() {
    let bench = Bench::new();
    let fifo = Command::new("mkfifo").arg(bench.path("f.png")).status();
    assert!(fifo.unwrap().success());
    for line in [
        "check f.png",
        "check /dev/zero",
        "check job.toml --set target={stack=\"f.png\"}",
        "simulate job.toml --patterns f.png --output a",
        "simulate job.toml --patterns /dev/zero --output a",
        "metrics f.png f.png",
        "import f.png --output x.toml",
    ] {
        bench.says(2, line, &["a device, a FIFO or a socket"]);
    }
    bench.write("long.toml", "a".repeat(9_000_000).as_bytes());
    bench.refuse(
        "check long.toml",
        &["a file of 9.0 MB; accepted: a file of 8 MB at most"],
    );
}

/// Names of parts end up in names of files and on terminals.
#[test]
fn a_name_of_a_part_steers_no_terminal_and_is_never_too_long() {
    let bench = Bench::new();
    let job = bench.read("job.toml");
    let name = format!("\\u001b[31m{}", "ü".repeat(124));
    let job = job.replacen("[target]", &format!("[target]\nname = \"{name}\""), 1);
    bench.write("named.toml", job.as_bytes());
    let output = bench.expect(0, "run named.toml --output a");
    assert!(
        output.contains("\\u{1b}[31m") && !output.contains('\u{1b}'),
        "{output}"
    );
    let entries = fs::read_dir(bench.path("a")).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let movies: Vec<String> = names.filter(|name| name.ends_with(".mp4")).collect();
    let cut = "ü".repeat(57);
    assert!(movies.len() == 1 && movies[0].contains(&cut), "{movies:?}");
}
