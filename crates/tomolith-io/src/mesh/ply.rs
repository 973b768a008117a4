//! PLY: a header in text, then elements in text or binary.
//!
//! Elements come in any order and have any properties besides the ones that count. In a text they are words, wherever
//! lines end; what is left after the last of them is refused, since then some of them were misread.

use super::Collector;
use super::text::{Word, decoded, number, shown, split_line, words, words_of};
use crate::numbers::{Element as Stored, Kind};
use tomolith_core::error::Result;

const WANTED: &str = "a PLY file with an element `vertex` (x, y, z) and an element `face` or `tristrips` (vertex_indices)";

/// Corners of a face or a strip that are read at once: beyond that a count is damaged.
const MOST_CORNERS: f64 = 1e9;

fn number_type(name: &[u8]) -> Option<Kind> {
    Some(match name {
        b"char" | b"int8" => Kind::Signed(1),
        b"uchar" | b"uint8" => Kind::Unsigned(1),
        b"short" | b"int16" => Kind::Signed(2),
        b"ushort" | b"uint16" => Kind::Unsigned(2),
        b"int" | b"int32" => Kind::Signed(4),
        b"uint" | b"uint32" => Kind::Unsigned(4),
        b"float" | b"float32" => Kind::Float(4),
        b"double" | b"float64" => Kind::Float(8),
        _ => return None,
    })
}

struct Property {
    name: String,
    /// The type of the length, for a list.
    length: Option<Kind>,
    kind: Kind,
}

struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

#[derive(Clone, Copy, PartialEq)]
enum Encoding {
    Text,
    Binary { is_big: bool },
}

pub(super) fn parse(bytes: &[u8], out: &mut Collector) -> Result<()> {
    let bytes = &*decoded(bytes);
    let refuse = |found: String| out.refusal(found, WANTED);
    let (encoding, elements, body) = header(bytes).map_err(refuse)?;
    let surface = read(encoding, &elements, body).map_err(refuse)?;
    surface.send(out)
}

/// Reads the header; returns the rest too.
fn header(bytes: &[u8]) -> Result<(Encoding, Vec<Element>, &[u8]), String> {
    let (mut encoding, mut elements) = (None, Vec::<Element>::new());
    let (first, mut rest) = split_line(bytes);
    if first.trim_ascii() != b"ply" {
        return Err(format!("it begins with `{}`, not with `ply`", shown(bytes)));
    }
    for number in 2.. {
        if rest.is_empty() {
            return Err("truncated: the header has no `end_header`".to_owned());
        }
        let line;
        (line, rest) = split_line(rest);
        let refuse = || format!("damaged header: line {number} is `{}`", shown(line));
        let words: Vec<&[u8]> = words_of(line).collect();
        match words[..] {
            [b"end_header", ..] => break,
            [b"format", name, ..] => {
                encoding = Some(match name {
                    b"ascii" => Encoding::Text,
                    b"binary_little_endian" => Encoding::Binary { is_big: false },
                    b"binary_big_endian" => Encoding::Binary { is_big: true },
                    _ => return Err(refuse()),
                });
            }
            [b"element", name, count] => elements.push(Element {
                name: String::from_utf8_lossy(name).into_owned(),
                count: self::number(count).ok_or_else(refuse)?,
                properties: Vec::new(),
            }),
            [b"property", ..] => {
                let element = elements.last_mut().ok_or_else(refuse)?;
                element
                    .properties
                    .push(property(&words[1..]).ok_or_else(refuse)?);
            }
            [] | [b"comment" | b"obj_info", ..] => {}
            _ => return Err(refuse()),
        }
    }
    let encoding = encoding.ok_or("damaged header: there is no `format`")?;
    Ok((encoding, elements, rest))
}

fn property(words: &[&[u8]]) -> Option<Property> {
    let (length, kind, name) = match *words {
        [b"list", length, kind, name] => (Some(number_type(length)?), kind, name),
        [kind, name] => (None, kind, name),
        _ => return None,
    };
    Some(Property {
        name: String::from_utf8_lossy(name).into_owned(),
        length,
        kind: number_type(kind)?,
    })
}

/// What a property is read for.
#[derive(Clone, Copy, PartialEq)]
enum Use {
    Axis(usize),
    Corners,
    Nothing,
}

impl Element {
    /// What each property is read for.
    fn uses(&self) -> Result<Vec<Use>, String> {
        let all = self.properties.iter();
        let uses: Vec<Use> = match self.name.as_str() {
            "vertex" => all
                .map(|p| p.axis().map_or(Use::Nothing, Use::Axis))
                .collect(),
            "face" | "tristrips" => {
                let corners = self.corners()?;
                let used = |i| {
                    if i == corners {
                        Use::Corners
                    } else {
                        Use::Nothing
                    }
                };
                (0..self.properties.len()).map(used).collect()
            }
            _ => vec![Use::Nothing; self.properties.len()],
        };
        let missing = |&axis: &usize| self.name == "vertex" && !uses.contains(&Use::Axis(axis));
        match (0..3).find(missing) {
            Some(axis) => Err(format!(
                "a vertex has no property `{}`",
                ["x", "y", "z"][axis]
            )),
            None if self.properties.is_empty() && self.count > 0 => {
                Err(format!("element `{}` has no property", self.name))
            }
            None => Ok(uses),
        }
    }

    /// Which list holds the corners of a face: the one of the usual names, or the only one of integers.
    fn corners(&self) -> Result<usize, String> {
        let is_list = |p: &Property| p.length.is_some() && !matches!(p.kind, Kind::Float(_));
        let lists = self
            .properties
            .iter()
            .enumerate()
            .filter(|(_, p)| is_list(p));
        let usual = |p: &Property| matches!(p.name.as_str(), "vertex_indices" | "vertex_index");
        let lists: Vec<(usize, &Property)> = lists.collect();
        match (lists.iter().find(|(_, p)| usual(p)), &lists[..]) {
            (Some((i, _)), _) | (None, [(i, _)]) => Ok(*i),
            _ => {
                let names: Vec<&str> = self.properties.iter().map(|p| &*p.name).collect();
                Err(format!(
                    "element `{}` has no list of integers `vertex_indices` (it has: {})",
                    self.name,
                    names.join(", ")
                ))
            }
        }
    }
}

impl Property {
    fn axis(&self) -> Option<usize> {
        let axis = ["x", "y", "z"].iter().position(|name| *name == self.name);
        axis.filter(|_| self.length.is_none())
    }
}

/// The numbers of the elements, one after the other.
enum Numbers<'a, W: Iterator<Item = Word<'a>>> {
    Text(W),
    Binary { rest: &'a [u8], is_big: bool },
}

impl<'a, W: Iterator<Item = Word<'a>>> Numbers<'a, W> {
    /// The next number; what is wrong with it.
    fn next(&mut self, kind: Kind) -> Result<f64, String> {
        let (rest, is_big_endian) = match self {
            Numbers::Text(words) => {
                let word = words
                    .next()
                    .ok_or("truncated, or its rows have more numbers than properties")?;
                let read = match kind {
                    Kind::Float(4) => number::<f32>(word.text).map(f64::from),
                    _ => number(word.text),
                };
                let refuse = || format!("line {}: `{}` is no number", word.line, shown(word.text));
                return read.ok_or_else(refuse);
            }
            Numbers::Binary { rest, is_big } => (rest, *is_big),
        };
        let bytes;
        (bytes, *rest) = rest.split_at_checked(kind.bytes()).ok_or("truncated")?;
        let stored = Stored {
            kind,
            is_big_endian,
        };
        Ok(match kind {
            Kind::Float(4) => f64::from(stored.value(bytes)),
            Kind::Float(_) => f64::from_bits(stored.word(bytes)),
            _ => stored.integer(bytes) as f64,
        })
    }
}

/// What counts of the elements.
#[derive(Default)]
struct Surface {
    points: Vec<[f64; 3]>,
    faces: Lists,
    strips: Lists,
}

/// Corners of faces or strips, as numbers of vertices, and where each list ends.
#[derive(Default)]
struct Lists {
    corners: Vec<f64>,
    ends: Vec<usize>,
}

impl Lists {
    fn iter(&self) -> impl Iterator<Item = &[f64]> {
        let mut from = 0;
        self.ends
            .iter()
            .map(move |&end| &self.corners[std::mem::replace(&mut from, end)..end])
    }
}

fn read(encoding: Encoding, elements: &[Element], body: &[u8]) -> Result<Surface, String> {
    let has = |name: &str| elements.iter().any(|e| e.name == name && e.count > 0);
    if !has("vertex") || !has("face") && !has("tristrips") {
        let counted = |e: &Element| format!("{} of `{}`", e.count, e.name);
        let there: Vec<String> = elements.iter().map(counted).collect();
        return Err(format!("no surface: its elements are {}", there.join(", ")));
    }
    let mut numbers = match encoding {
        Encoding::Text => Numbers::Text(words(body)),
        Encoding::Binary { is_big } => Numbers::Binary { rest: body, is_big },
    };
    let mut surface = Surface::default();
    for element in elements {
        let uses = element.uses()?;
        for row in 0..element.count {
            surface.take(element, &uses, &mut numbers).map_err(|what| {
                let (name, count) = (&element.name, element.count);
                format!("{what}: {row} of the {count} rows of `{name}` that the header promises can be read")
            })?;
        }
    }
    if let Numbers::Text(mut words) = numbers
        && let Some(word) = words.next()
    {
        let (line, text) = (word.line, shown(word.text));
        return Err(format!(
            "line {line} after the header: `{text}` follows the last element, so rows have more numbers than properties"
        ));
    }
    Ok(surface)
}

impl Surface {
    /// Reads a row of an element.
    fn take<'a>(
        &mut self,
        element: &Element,
        uses: &[Use],
        numbers: &mut Numbers<'a, impl Iterator<Item = Word<'a>>>,
    ) -> Result<(), String> {
        let mut point = [f64::NAN; 3];
        let lists = match element.name.as_str() {
            "face" => &mut self.faces,
            _ => &mut self.strips,
        };
        for (property, used) in element.properties.iter().zip(uses) {
            let count = match property.length {
                Some(kind) => numbers.next(kind)?,
                None => 1.0,
            };
            if !(0.0..=MOST_CORNERS).contains(&count) {
                return Err(format!("a list of {count} numbers"));
            }
            for _ in 0..count as usize {
                let value = numbers.next(property.kind)?;
                match used {
                    Use::Axis(axis) => point[*axis] = value,
                    Use::Corners => lists.corners.push(value),
                    Use::Nothing => {}
                }
            }
            if *used == Use::Corners {
                lists.ends.push(lists.corners.len());
            }
        }
        if element.name == "vertex" {
            self.points.push(point);
        }
        Ok(())
    }

    fn send(&self, out: &mut Collector) -> Result<()> {
        let mut corners = Vec::new();
        for (row, face) in self.faces.iter().enumerate() {
            corners.clear();
            for &index in face {
                corners.push(self.point(index, "face", row, out)?);
            }
            out.fan(&corners)?;
        }
        for (row, strip) in self.strips.iter().enumerate() {
            // A strip begins anew after −1
            for strip in strip.split(|index| *index < 0.0) {
                for (i, three) in strip.windows(3).enumerate() {
                    let [a, b, c] = [0, 1, 2].map(|k| self.point(three[k], "strip", row, out));
                    // Every other triangle of a strip looks the other way
                    let corners = if i % 2 == 0 {
                        [a?, b?, c?]
                    } else {
                        [b?, a?, c?]
                    };
                    out.triangle(corners)?;
                }
            }
        }
        Ok(())
    }

    fn point(&self, index: f64, what: &str, row: usize, out: &Collector) -> Result<[f64; 3]> {
        let count = self.points.len();
        let there = (0.0..count as f64).contains(&index) && index.fract() == 0.0;
        let point = there.then(|| self.points[index as usize]);
        point.ok_or_else(|| {
            let found = format!("{what} {row} refers to vertex {index}, but there are {count}");
            out.refusal(found, "indices from 0 to the number of vertices − 1")
        })
    }
}
