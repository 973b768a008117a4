//! STL: triangles with their corners in f32, as text or in 50 bytes each.

use super::{Mesh, Sink, bad};
use std::io::Cursor;
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::vector::{cross, dot, minus};

const HEADER: usize = 84;
const TRIANGLE: usize = 50;

const ACCEPTED: &str = "an ASCII STL file beginning with `solid`, or a binary one with as many triangles as its header says";

/// Reads either kind. The length decides: a binary file may begin with the word `solid` too.
pub(super) fn parse(bytes: &[u8], path: &Path, sink: Sink) -> Result<()> {
    let start = bytes.trim_ascii_start();
    let named = start
        .get(..5)
        .is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    // The count and the coordinates of a binary file are full of zero bytes, a text has none
    let is_text = named && !bytes[..bytes.len().min(1024)].contains(&0);
    if binary_length(bytes) == Some(bytes.len()) {
        return parse_binary(bytes, path, sink);
    }
    if let Some(found) = other(bytes, is_text) {
        return Err(bad(path, found, ACCEPTED));
    }
    if is_text {
        parse_text(bytes, path, sink)
    } else {
        parse_binary(bytes, path, sink)
    }
}

/// What a file is that is named like an STL file and is none: another format, or a text.
fn other(bytes: &[u8], is_named: bool) -> Option<String> {
    let start = &bytes[..bytes.len().min(1024)];
    let is_text = !start
        .iter()
        .any(|b| b.is_ascii_control() && !b.is_ascii_whitespace());
    let known = [
        (&b"PK\x03\x04"[..], "a zip archive, perhaps 3MF"),
        (b"\x89PNG", "a PNG image"),
        (b"ply", "a PLY file"),
        (b"glTF", "a glTF file"),
        (b"ISO-10303-21", "a STEP file"),
    ];
    let known = known.iter().find(|(magic, _)| start.starts_with(magic));
    let what = match known {
        Some((_, what)) => what,
        None if is_named => {
            // The name of a solid may be anything, what follows it may not
            let lines = bytes.split(|b| *b == b'\n').skip(1).map(<[u8]>::trim_ascii);
            let next = lines
                .filter(|line| !line.is_empty())
                .map(<[u8]>::to_ascii_lowercase)
                .next();
            let follows = |word: &[u8]| next.as_ref().is_none_or(|line| line.starts_with(word));
            if follows(b"facet") || follows(b"endsolid") {
                return None;
            }
            "a text"
        }
        None if is_text => "a text",
        None => return None,
    };
    let beginning = String::from_utf8_lossy(&start[..start.len().min(24)]);
    let beginning = beginning.lines().next().unwrap_or_default();
    Some(format!(
        "{what} (it begins with `{}`), neither an ASCII nor a binary STL file",
        beginning.trim()
    ))
}

/// Bytes that a binary file with this header has.
fn binary_length(bytes: &[u8]) -> Option<usize> {
    let count = u32::from_le_bytes(bytes.get(80..HEADER)?.try_into().ok()?);
    Some(HEADER + TRIANGLE * count as usize)
}

fn parse_binary(bytes: &[u8], path: &Path, sink: Sink) -> Result<()> {
    let Some(length) = binary_length(bytes) else {
        return Err(bad(
            path,
            format!("{} bytes are too few for an STL file", bytes.len()),
            ACCEPTED,
        ));
    };
    if length > bytes.len() {
        return Err(bad(
            path,
            format!(
                "truncated: the header promises {} triangles ({length} bytes), the file has {} bytes",
                (length - HEADER) / TRIANGLE,
                bytes.len()
            ),
            ACCEPTED,
        ));
    }
    // A blank header keeps the reader from taking a binary file whose name begins with `solid` for text
    let mut blank = bytes.to_vec();
    blank[..80].fill(0);
    send(&mut Cursor::new(blank), path, sink)
}

/// ASCII files may hold several solids, one after the other, in capitals too; the reader takes one, in small letters.
/// Normals are left out: they follow from the corners, and some programs write NaN for those of slivers.
fn parse_text(bytes: &[u8], path: &Path, sink: Sink) -> Result<()> {
    let mut block = Vec::new();
    for line in bytes.split_inclusive(|&b| b == b'\n') {
        let words = &*line.trim_ascii().to_ascii_lowercase();
        if block.is_empty() {
            match words {
                b"" => continue,
                _ if words.starts_with(b"solid") => block.extend_from_slice(b"solid x\n"),
                _ => {
                    return Err(bad(
                        path,
                        "text between two solids",
                        "`solid` … `endsolid`, once or several times",
                    ));
                }
            }
            continue;
        }
        let is_facet = words.starts_with(b"facet");
        block.extend_from_slice(if is_facet {
            b"facet normal 0 0 0"
        } else {
            words
        });
        block.push(b'\n');
        if words.starts_with(b"endsolid") {
            send(&mut Cursor::new(std::mem::take(&mut block)), path, sink)?;
        }
    }
    if block.is_empty() {
        Ok(())
    } else {
        Err(bad(
            path,
            "truncated: the last solid has no `endsolid`",
            "`solid` … `endsolid`",
        ))
    }
}

fn send(bytes: &mut Cursor<Vec<u8>>, path: &Path, sink: Sink) -> Result<()> {
    let refused = |e: std::io::Error| {
        bad(
            path,
            format!("damaged STL: {e}"),
            "an ASCII or binary STL file",
        )
    };
    for triangle in stl_io::create_stl_reader(bytes).map_err(refused)? {
        sink(
            triangle
                .map_err(refused)?
                .vertices
                .map(|v| v.0.map(f64::from)),
        )?;
    }
    Ok(())
}

/// Writes a binary STL file, aside first and then renamed, so that it appears whole or not at all.
///
/// # Errors
/// [`Error::Io`] when it cannot be written; [`Error::Mesh`] when there are more than 2³² − 1 triangles.
pub fn write_stl_binary(path: impl AsRef<Path>, mesh: &Mesh) -> Result<()> {
    let path = path.as_ref();
    if u32::try_from(mesh.triangles.len()).is_err() {
        return Err(bad(
            path,
            format!("{} triangles", mesh.triangles.len()),
            "at most 4 294 967 295 in an STL file",
        ));
    }
    let mut aside = path.as_os_str().to_owned();
    aside.push(".part");
    let aside = Path::new(&aside);
    let write = || -> std::io::Result<()> {
        let mut file = std::fs::File::create(aside)?;
        let triangles = (0..mesh.triangles.len()).map(|t| stl_triangle(mesh.corners(t)));
        stl_io::write_stl(&mut file, triangles)?;
        file.sync_all()?;
        std::fs::rename(aside, path)
    };
    write().map_err(|e| {
        // The file aside is ours; when it cannot be removed either, the first error says more
        let _ = std::fs::remove_file(aside);
        Error::io(path, e)
    })
}

fn stl_triangle(corners: [[f64; 3]; 3]) -> stl_io::Triangle {
    let [a, b, c] = corners;
    let normal = cross(minus(b, a), minus(c, a));
    let length = dot(normal, normal).sqrt();
    let scale = if length > 0.0 { 1.0 / length } else { 0.0 };
    stl_io::Triangle {
        normal: stl_io::Normal::new(normal.map(|v| (v * scale) as f32)),
        vertices: corners.map(|p| stl_io::Vertex::new(p.map(|v| v as f32))),
    }
}
