//! Movies that FFmpeg 5.1 made of six frames of 32 × 24 pixels (`odd_444`: 31 × 23) with the levels of [`level`], in
//! `samples`: libx264 `-crf 4` with `keyint=4` (`-bf 0` but for `b_frames`), mjpeg `-q:v 2`, libvpx-vp9 `-crf 4`. `slow.gif`: 10
//! frames per second, by 7.0. `colored.avi`: mjpeg of the test source, whose frames are colored.

use super::*;
use crate::channel::Channel;
use crate::frames::FrameSet;
use std::path::PathBuf;
use tomolith_core::grid::PatternGrid;

fn level(frame: usize, row: usize, column: usize) -> u16 {
    (8 + 20 * frame + 3 * row + 2 * column) as u16
}

const SHAPE: [usize; 3] = [6, 24, 32];

fn sample(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("src/movie/samples")
        .join(name)
}

/// Largest error of frames read back.
fn error(read: &Frames) -> u16 {
    let [_, rows, columns] = read.shape;
    let places = read.values.iter().enumerate();
    let errors = places.map(|(i, found)| {
        let (frame, row) = (i / (rows * columns), i / columns % rows);
        found.abs_diff(level(frame, row, i % columns))
    });
    errors.max().unwrap_or(u16::MAX)
}

fn has_ffmpeg() -> bool {
    let version = std::process::Command::new("ffmpeg")
        .arg("-version")
        .output();
    version.is_ok()
}

fn refused(path: &Path, shape: [usize; 3]) -> String {
    read_movie(path, shape, None).unwrap_err().to_string()
}

#[test]
fn movies_without_b_frames_are_read_with_their_limited_range() {
    // Frames that follow from the frame before; rows that are cropped from 32 to 24; black 16 and white 235
    for name in ["baseline.mp4", "high.mp4"] {
        let read = read_movie(&sample(name), SHAPE, None).unwrap();
        assert_eq!((read.shape, read.bits), (SHAPE, 8));
        assert!(error(&read) <= 3, "{name}: {}", error(&read));
    }
    // Neither cut to a smaller light nor stretched to a larger one
    for (shape, found) in [
        ([6, 12, 16], "32 × 24 pixels instead of 16 × 12"),
        ([6, 24, 34], "32 × 24 pixels instead of 34 × 24"),
        ([5, 24, 32], "6 frames instead of 5"),
    ] {
        let text = refused(&sample("high.mp4"), shape);
        assert!(text.contains(found), "{text}");
    }
}

#[test]
fn a_movie_that_is_shown_turned_is_read_turned() {
    let mut file = std::fs::read(sample("high.mp4")).unwrap();
    let header = file.windows(4).position(|kind| kind == b"tkhd").unwrap() + 4;
    for at in [0, 16] {
        file[header + 40 + at..][..4].copy_from_slice(&(-0x1_0000i32).to_be_bytes());
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("turned.mp4");
    std::fs::write(&path, file).unwrap();
    match read_movie(&path, SHAPE, None) {
        Ok(mut read) => {
            let [_, rows, columns] = SHAPE;
            let pictures = read.values.chunks_mut(rows * columns);
            pictures.for_each(<[_]>::reverse);
            assert!(error(&read) <= 3, "{}", error(&read));
        }
        Err(found) => tomolith_core::contains!(
            found.to_string(),
            "turned, mirrored or scaled when it is shown",
            "which the program ffmpeg can read"
        ),
    }
}

#[test]
fn other_movies_are_read_by_ffmpeg_or_named() {
    for (name, what) in [
        ("b_frames.mp4", "H.264 High, with B-frames"),
        (
            "odd_444.mp4",
            "H.264 High 4:4:4 Predictive, 4:4:4 of 8 bits",
        ),
        ("mjpeg.mp4", "MPEG-4 Visual or Motion JPEG (`mp4v`)"),
        ("vp9.webm", "a Matroska or WebM file"),
        // Fewer frames per second than those that ffmpeg 9 doubled
        ("slow.gif", "a GIF file"),
    ] {
        let shape = if name == "odd_444.mp4" {
            [6, 23, 31]
        } else {
            SHAPE
        };
        match (has_ffmpeg(), read_movie(&sample(name), shape, None)) {
            (true, read) => {
                let read = read.unwrap();
                assert!(error(&read) <= 3, "{name}: {}", error(&read));
                let more = [shape[0] + 1, shape[1], shape[2]];
                let text = refused(&sample(name), more);
                assert!(text.contains("6 frames instead of 7"), "{text}");
            }
            (false, read) => {
                // Without ffmpeg only what is said of its absence
                let text = read.unwrap_err().to_string();
                tomolith_core::contains!(
                    text,
                    what,
                    "which the program ffmpeg can read",
                    "frame_%04d.png"
                );
            }
        }
    }
}

#[test]
fn a_colored_movie_is_refused() {
    let text = refused(&sample("colored.mp4"), SHAPE);
    tomolith_core::contains!(text, "a colored picture in frame 0", "printer.channel");
    let text = refused(&sample("colored.avi"), SHAPE);
    let parts = [
        "a colored picture in frame 0",
        "which the program ffmpeg can read",
    ];
    assert!(parts.iter().any(|part| text.contains(part)), "{text}");
}

#[test]
fn of_a_colored_movie_ffmpeg_takes_the_channel_that_is_asked_for() {
    let read = |name, channel| read_movie(&sample(name), SHAPE, Some(channel));
    for name in ["colored.mp4", "colored.avi"] {
        if !has_ffmpeg() {
            let text = read(name, Channel::Blue).unwrap_err().to_string();
            tomolith_core::contains!(text, "which the program ffmpeg can read");
            continue;
        }
        // The bars of the test source: each channel has black and white ones, but not the same
        let levels = Channel::ALL.map(|channel| read(name, channel).unwrap());
        for (i, frames) in levels.iter().enumerate() {
            assert_eq!((frames.shape, frames.bits), (SHAPE, 8));
            assert!(frames.values.iter().any(|level| *level > 200), "{name}");
            assert_ne!(frames.values, levels[(i + 1) % 3].values, "{name}");
        }
    }
}

#[test]
fn what_is_no_movie_or_cut_off_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("m.mp4");
    let found = |bytes: &[u8]| {
        std::fs::write(&path, bytes).unwrap();
        refused(&path, SHAPE)
    };
    let text = found(b"This is a text, not a movie.");
    tomolith_core::contains!(text, "no movie: it begins with `This is a text, `");
    assert!(found(b"").contains("the file is empty"));
    let whole = std::fs::read(sample("high.mp4")).unwrap();
    for cut in [20, 45, 200, whole.len() / 2, whole.len() - 3] {
        let text = found(&whole[..cut]);
        tomolith_core::contains!(text, "truncated: the box `", "should have");
    }
    assert!(track::missing(&whole[..6]).unwrap().contains("should have"));
    let movie = whole.windows(4).position(|w| w == b"moov").unwrap() - 4;
    assert!(found(&whole[..movie]).contains("no box `moov`"));
}

#[test]
fn lossless_movies_keep_every_level_at_any_depth() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("m.mov");
    let grid = PatternGrid::full_turn(70, 0.3, 7, 9, 0.02);
    let kinds = [
        (1, None),
        (8, None),
        (12, None),
        (16, None),
        (8, Some(Channel::Blue)),
    ];
    for (bits, channel) in kinds {
        let top = u32::from(crate::frames::top_level(bits));
        let values: Vec<u16> = (0..grid.len() as u32)
            .map(|i| (i.wrapping_mul(2_654_435_761) >> 7 & top) as u16)
            .collect();
        let set = FrameSet {
            full_scale: 0.7,
            channel,
            ..FrameSet::of(&grid, bits, &values)
        };
        write_lossless(&path, &set, 44.4).unwrap();
        let check = check_lossless(&path, &set).unwrap();
        assert_eq!((check.frames, check.width, check.height), (70, 9, 7));
        assert!((check.frame_rate - 44.4).abs() < 0.01, "{check:?}");
        let read = read_movie(&path, grid.shape(), None).unwrap();
        assert_eq!((read.bits, read.full_scale), (bits, Some(0.7)));
        assert_eq!(read.values, values, "{bits} bits");
        // One level off by one is seen
        let mut other = values.clone();
        other[999] ^= 1;
        let set = FrameSet {
            values: &other,
            ..set
        };
        assert!(check_lossless(&path, &set).is_err());
    }
}

#[test]
fn mutated_files_end_in_frames_or_an_error() {
    use tomolith_core::check::fuzz::{mutate, rounds};
    let names = ["high.mp4", "baseline.mp4"];
    let whole = names.map(|name| std::fs::read(sample(name)).unwrap());
    let [_, count] = rounds(0.5, |random| {
        let mut bytes = whole[random.below(2)].clone();
        mutate(&mut bytes, random);
        let _ = track::missing(&bytes);
        read_built_in(&bytes, Path::new("m.mp4"), SHAPE, None).is_ok()
    });
    assert!(count > 0);
}
