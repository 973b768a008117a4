//! Movies through the program `ffmpeg`, where it is on the path: whatever it reads, as a stream of gray PGM images.
//!
//! A PGM image states its size and largest value, so nothing need be known of the movie before; `ffmpeg` picks 8 or 16 bits by
//! what the movie holds. Every frame is taken once, whatever its time. Whatever `ffmpeg` reports as an error is one here: a
//! frame that it patched would be a wrong pattern. Its filter `signalstats` says whether a picture is colored, of which gray
//! images would show the luma alone; an `ffmpeg` without that filter does not say. Of colored pictures its filter
//! `extractplanes` takes the channel that is asked for, in 8 bits.

use super::{CODING, GRAY, must_fit};
use crate::channel::Channel;
use crate::frames::Frames;
use std::ffi::OsString;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// Why there are no frames.
pub(super) enum Trouble {
    /// There is no such program.
    Missing,
    /// It could not read the movie, or the movie does not fit.
    Said(String),
}

/// The frames of a movie of this shape `[frames, rows, columns]`; of colored ones this channel.
pub(super) fn read(
    path: &Path,
    shape: [usize; 3],
    channel: Option<Channel>,
) -> Result<Frames, Trouble> {
    let colored = colored(path);
    let plane = match (colored, channel) {
        (Some(frame), None) => return Err(Trouble::Said(super::colored(frame))),
        (Some(_), Some(channel)) => Some(channel),
        (None, _) => None,
    };
    let mut child = start(path, plane)?;
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    let (read, complaint) = std::thread::scope(|scope| {
        let complaint = scope.spawn(|| {
            let mut text = Vec::new();
            if let Some(mut stderr) = stderr {
                // Its first words are enough; the rest is read so that the program can go on
                let _ = stderr.by_ref().take(1 << 16).read_to_end(&mut text);
                let _ = std::io::copy(&mut stderr, &mut std::io::sink());
            }
            String::from_utf8_lossy(&text).into_owned()
        });
        let read = match stdout {
            Some(stdout) => images(BufReader::with_capacity(1 << 20, stdout), shape),
            None => Err("no output".to_owned()),
        };
        if read.is_err() {
            // What is left of the movie is of no use
            let _ = child.kill();
        }
        (read, complaint.join().unwrap_or_default())
    });
    let status = child.wait().map_err(|e| Trouble::Said(e.to_string()))?;
    let frames = read.map_err(Trouble::Said)?;
    if let Some(line) = complaint.lines().find(|line| !line.trim().is_empty()) {
        // `[h264 @ 0x5581e2] …`
        let line = line
            .strip_prefix('[')
            .and_then(|l| l.split_once("] "))
            .map_or(line, |l| l.1);
        return Err(Trouble::Said(format!("ffmpeg reports: {line}")));
    }
    if !status.success() {
        return Err(Trouble::Said(format!("ffmpeg ended with {status}")));
    }
    let found = frames.shape[0];
    if found != shape[0] {
        return Err(Trouble::Said(format!(
            "{found} frames instead of {}",
            shape[0]
        )));
    }
    let is_dark = |level: &u16| *level <= u16::from(CODING);
    match plane.filter(|_| frames.values.iter().all(is_dark)) {
        Some(channel) => Err(Trouble::Said(format!(
            "a colored movie, but no {} light in it",
            channel.name()
        ))),
        None => Ok(frames),
    }
}

/// `ffmpeg` before what it is to do with a movie. A rate for the input gives frames even times and lengths.
fn command(path: &Path) -> Command {
    let mut input = OsString::from("file:");
    input.push(path);
    let mut command = Command::new("ffmpeg");
    command
        .args(["-nostdin", "-v", "error", "-r", "25", "-i"])
        .arg(input)
        .stdin(Stdio::null());
    command
}

/// The first colored frame: its least or largest chroma is far from gray's.
fn colored(path: &Path) -> Option<usize> {
    let stats = "format=yuv444p,signalstats,metadata=print:file=-";
    let output = command(path)
        .args(["-map", "0:v:0", "-vf", stats, "-f", "null", "-"])
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stdout);
    let mut frame = 0;
    for line in text.lines() {
        // `frame:0    pts:0       pts_time:0`, then a line for each number
        if let Some(found) = line.strip_prefix("frame:") {
            frame = found.split_whitespace().next()?.parse().ok()?;
        }
        let Some((name, value)) = line.split_once('=') else {
            continue;
        };
        let is_chroma = ["UMIN", "UMAX", "VMIN", "VMAX"]
            .iter()
            .any(|end| name.ends_with(end));
        let off = value
            .parse()
            .map_or(0.0, |v: f64| (v - f64::from(GRAY)).abs());
        if is_chroma && off > f64::from(CODING) {
            return Some(frame);
        }
    }
    None
}

fn start(path: &Path, plane: Option<Channel>) -> Result<Child, Trouble> {
    let plane = plane.map_or("", |channel| match channel {
        Channel::Red => ",format=gbrp,extractplanes=r",
        Channel::Green => ",format=gbrp,extractplanes=g",
        Channel::Blue => ",format=gbrp,extractplanes=b",
    });
    let filters = format!("settb=1/25,setpts=N{plane}");
    command(path)
        // The rate of the input and these times together: either alone has versions of ffmpeg that drop or double frames
        // (4.2, 9.0), and the option that forbids it has a name before version 5.1 and another since
        .args(["-map", "0:v:0", "-vf", &filters, "-r", "25"])
        .args(["-f", "image2pipe", "-c:v", "pgm", "-"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| match e.kind() {
            std::io::ErrorKind::NotFound => Trouble::Missing,
            _ => Trouble::Said(format!("ffmpeg could not be started: {e}")),
        })
}

/// A stream of PGM images to its end, or until one does not fit.
fn images(mut stream: impl BufRead, [frames, rows, columns]: [usize; 3]) -> Result<Frames, String> {
    let (mut values, mut found, mut bits) = (Vec::new(), 0, 8);
    while let Some([width, height, top]) = header(&mut stream)? {
        if found == frames {
            return Err(format!("more than {frames} frames"));
        }
        must_fit([width, height], [rows, columns])?;
        let bytes = if top > 255 { 2 } else { 1 };
        bits = 8 * bytes as u32;
        let mut image = vec![0; width * height * bytes];
        stream
            .read_exact(&mut image)
            .map_err(|e| format!("frame {found}: {e}"))?;
        for row in image.chunks(width * bytes).take(rows) {
            let pixels = row.chunks(bytes).take(columns);
            values.extend(pixels.map(|pixel| {
                pixel
                    .iter()
                    .fold(0, |level, &byte| level << 8 | u16::from(byte))
            }));
        }
        found += 1;
    }
    Ok(Frames {
        shape: [found, rows, columns],
        bits,
        full_scale: None,
        values,
    })
}

/// Columns, rows and largest value of the next image; None at the end.
fn header(stream: &mut impl BufRead) -> Result<Option<[usize; 3]>, String> {
    let mut words = Vec::new();
    // `P5`, `columns rows`, `largest`, a line each
    for _ in 0..3 {
        let mut line = Vec::new();
        stream
            .take(64)
            .read_until(b'\n', &mut line)
            .map_err(|e| e.to_string())?;
        words.extend(
            String::from_utf8_lossy(&line)
                .split_whitespace()
                .map(str::to_owned),
        );
    }
    if words.is_empty() {
        return Ok(None);
    }
    let number = |i: usize| words.get(i).and_then(|word: &String| word.parse().ok());
    match (words[0].as_str(), number(1), number(2), number(3)) {
        ("P5", Some(columns), Some(rows), Some(top)) if top < 65536 => {
            Ok(Some([columns, rows, top]))
        }
        _ => Err("a stream of images that cannot be read".to_owned()),
    }
}
