//! STL: triangles with their corners in f32, as text or in 50 bytes each.
//!
//! Of a text only `facet`, `vertex`, `endfacet` and `endsolid` matter, in any case and on any lines; normals are left out:
//! they follow from the corners, and some programs write NaN for those of slivers. A facet must be whole.

use super::Collector;
use super::text::{Word, decoded, number, shown, words};
use tomolith_core::error::{Error, Result};

const HEADER: usize = 84;
const TRIANGLE: usize = 50;

const ACCEPTED: &str =
    "an ASCII STL file with facets, or a binary one with as many triangles as its header says";

/// Reads either kind. The length decides first: a binary file may begin with the word `solid` too.
pub(super) fn parse(bytes: &[u8], out: &mut Collector) -> Result<()> {
    let promised = promised(bytes);
    if promised.is_some_and(|count| HEADER + TRIANGLE * count == bytes.len()) {
        return parse_binary(bytes, out);
    }
    if let Some(what) = other(bytes) {
        return Err(neither(what, bytes, out));
    }
    let text = decoded(bytes);
    // The count and the coordinates of a binary file are full of control characters, a text has none
    let start = &text[..text.len().min(1024)];
    if start
        .iter()
        .any(|b| b.is_ascii_control() && !b.is_ascii_whitespace())
    {
        return parse_binary(bytes, out);
    }
    if parse_text(&text, out)? == 0 {
        return Err(neither("a text without a facet", &text, out));
    }
    Ok(())
}

/// Another format under the name of an STL file.
fn other(bytes: &[u8]) -> Option<&'static str> {
    let known = [
        (&b"PK\x03\x04"[..], "a zip archive, perhaps 3MF"),
        (b"\x89PNG", "a PNG image"),
        (b"ply\n", "a PLY file"),
        (b"ply\r", "a PLY file"),
        (b"glTF", "a glTF file"),
        (b"ISO-10303-21", "a STEP file"),
    ];
    let known = known.iter().find(|(magic, _)| bytes.starts_with(magic));
    known.map(|(_, what)| *what)
}

fn neither(what: &str, bytes: &[u8], out: &Collector) -> Error {
    let beginning = shown(bytes);
    let found =
        format!("{what} (it begins with `{beginning}`), neither an ASCII nor a binary STL file");
    out.refusal(found, ACCEPTED)
}

/// Triangles that the header of a binary file promises.
fn promised(bytes: &[u8]) -> Option<usize> {
    let count = u32::from_le_bytes(bytes.get(80..HEADER)?.try_into().ok()?);
    Some(count as usize)
}

fn parse_binary(bytes: &[u8], out: &mut Collector) -> Result<()> {
    let Some(promised) = promised(bytes) else {
        let found = format!(
            "truncated: {} bytes are too few for an STL file",
            bytes.len()
        );
        return Err(out.refusal(found, ACCEPTED));
    };
    let (there, extra) = (
        (bytes.len() - HEADER) / TRIANGLE,
        (bytes.len() - HEADER) % TRIANGLE,
    );
    // Programs that write while they compute leave a count of 0 or of all ones
    let is_whole = there > 0 && extra == 0;
    let is_open = [0, u32::MAX as usize].contains(&promised);
    if promised > there && !(is_whole && is_open) || promised == 0 && there > 0 && !is_whole {
        let found = format!(
            "truncated: the header promises {promised} triangles ({} bytes), the file has {} bytes",
            HEADER as u128 + TRIANGLE as u128 * promised as u128,
            bytes.len()
        );
        return Err(out.refusal(found, ACCEPTED));
    }
    let count = if is_whole { there } else { promised };
    if count != promised {
        out.note(format!(
            "The header promises {promised} triangles, the file holds {there}: all are read."
        ));
    }
    let (triangles, rest) = bytes[HEADER..].split_at(TRIANGLE * count);
    if rest.iter().any(|b| *b != 0) {
        let left = rest.len();
        out.note(format!(
            "{left} bytes after the last triangle are not read."
        ));
    }
    for triangle in triangles.chunks_exact(TRIANGLE) {
        let value = |i: usize| {
            let at = 12 + 4 * i;
            let bytes = [0, 1, 2, 3].map(|k| triangle[at + k]);
            f64::from(f32::from_le_bytes(bytes))
        };
        out.triangle([0, 3, 6].map(|i| [value(i), value(i + 1), value(i + 2)]))?;
    }
    Ok(())
}

/// A facet that has begun.
struct Facet {
    line: usize,
    corners: Vec<[f64; 3]>,
}

/// Reads all facets of all solids; how many.
fn parse_text(text: &[u8], out: &mut Collector) -> Result<usize> {
    let mut words = words(text).peekable();
    let mut facet: Option<Facet> = None;
    let (mut count, mut is_solid_open) = (0, false);
    while let Some(word) = words.next() {
        let next_is = |name: &str, next: Option<&Word>| next.is_some_and(|next| next.is(name));
        // A solid may be called `facet`, or hold the word in its name
        let begins =
            word.is("facet") && (next_is("normal", words.peek()) || next_is("outer", words.peek()));
        let ends = |what: &str, next: Option<&Word>| {
            word.is(&format!("end{what}")) || word.is("end") && next_is(what, next)
        };
        if begins || ends("solid", words.peek()) {
            if let Some(facet) = facet {
                let found = format!(
                    "line {}: the facet of line {} has no end",
                    word.line, facet.line
                );
                return Err(out.refusal(found, ACCEPTED));
            }
            is_solid_open = begins;
            facet = begins.then(|| Facet {
                line: word.line,
                corners: Vec::new(),
            });
        } else if let Some(open) = &mut facet {
            if word.is("vertex") {
                open.corners.push(corner(word.line, &mut words, out)?);
            } else if ends("facet", words.peek()) {
                send(open, out)?;
                (facet, count) = (None, count + 1);
                // The second of two words must not begin another facet
                words.next_if(|next| next.is("facet") && word.is("end"));
            }
        } else if word.is("vertex")
            && words
                .peek()
                .is_some_and(|next| number::<f32>(next.text).is_some())
        {
            let found = format!("line {}: a corner outside of a facet", word.line);
            return Err(out.refusal(found, ACCEPTED));
        }
    }
    if let Some(facet) = facet {
        let found = format!(
            "truncated: the file ends in the facet of line {}",
            facet.line
        );
        return Err(out.refusal(found, ACCEPTED));
    }
    if is_solid_open {
        out.note("The file ends without `endsolid`: it may have been cut off.".to_owned());
    }
    Ok(count)
}

/// The three numbers after `vertex`, rounded to f32 as in binary files, so that corners of several triangles meet.
fn corner<'a>(
    mut line: usize,
    words: &mut impl Iterator<Item = Word<'a>>,
    out: &Collector,
) -> Result<[f64; 3]> {
    let mut corner = [0.0; 3];
    for value in &mut corner {
        let word = words.next();
        line = word.map_or(line, |word| word.line);
        let text = word.map_or(&b""[..], |word| word.text);
        let read: Option<f32> = number(text);
        *value = f64::from(read.ok_or_else(|| {
            let found = format!("line {line}: `{}` in place of a coordinate", shown(text));
            let what = if word.is_some() {
                "damaged"
            } else {
                "truncated"
            };
            out.refusal(format!("{what}: {found}"), ACCEPTED)
        })?);
    }
    Ok(corner)
}

fn send(facet: &Facet, out: &mut Collector) -> Result<()> {
    let corners = &facet.corners;
    if corners.len() < 3 {
        let found = format!(
            "damaged: the facet of line {} has {} corners",
            facet.line,
            corners.len()
        );
        return Err(out.refusal(found, ACCEPTED));
    }
    out.fan(corners)
}
