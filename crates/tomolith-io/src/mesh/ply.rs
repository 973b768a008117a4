//! PLY: a header in text, then elements in text or binary.

use super::{Sink, bad};
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use std::io::Cursor;
use std::path::Path;
use tomolith_core::error::{Error, Result};

const WANTED: &str =
    "a PLY file with an element `vertex` (x, y, z) and an element `face` (vertex_indices)";

/// What is kept of an element, whichever it is.
#[derive(Debug)]
struct Row {
    point: [f64; 3],
    indices: Vec<i64>,
}

impl PropertyAccess for Row {
    fn new() -> Self {
        Row {
            point: [f64::NAN; 3],
            indices: Vec::new(),
        }
    }

    fn set_property(&mut self, key: &str, property: Property) -> PropertyAccessResult {
        let axis = ["x", "y", "z"].iter().position(|&name| name == key);
        if let Some(axis) = axis {
            match scalar(&property) {
                Some(value) => self.point[axis] = value,
                None => return PropertyAccessResult::UnsupportedType,
            }
        } else if is_indices(key) {
            match list(property) {
                Some(indices) => self.indices = indices,
                None => return PropertyAccessResult::UnsupportedType,
            }
        }
        PropertyAccessResult::Set
    }
}

fn is_indices(key: &str) -> bool {
    matches!(key, "vertex_indices" | "vertex_index")
}

fn scalar(property: &Property) -> Option<f64> {
    Some(match *property {
        Property::Char(v) => v.into(),
        Property::UChar(v) => v.into(),
        Property::Short(v) => v.into(),
        Property::UShort(v) => v.into(),
        Property::Int(v) => v.into(),
        Property::UInt(v) => v.into(),
        Property::Float(v) => v.into(),
        Property::Double(v) => v,
        _ => return None,
    })
}

fn list(property: Property) -> Option<Vec<i64>> {
    fn wide<T: Into<i64>>(values: Vec<T>) -> Vec<i64> {
        values.into_iter().map(Into::into).collect()
    }
    Some(match property {
        Property::ListChar(v) => wide(v),
        Property::ListUChar(v) => wide(v),
        Property::ListShort(v) => wide(v),
        Property::ListUShort(v) => wide(v),
        Property::ListInt(v) => wide(v),
        Property::ListUInt(v) => wide(v),
        _ => return None,
    })
}

pub(super) fn parse(bytes: &[u8], path: &Path, sink: Sink) -> Result<()> {
    let refused = |e: ParseError| {
        let text = e.to_string();
        let first = text.lines().next().unwrap_or_default();
        let what = match e.kind() {
            std::io::ErrorKind::UnexpectedEof => "truncated",
            _ => "damaged PLY",
        };
        bad(path, format!("{what}: {first}"), WANTED)
    };
    let parser = Parser::<Row>::new();
    let mut reader = Reader::new(Cursor::new(bytes));
    let header = parser.read_header(&mut reader).map_err(refused)?;
    let start = usize::try_from(reader.get_ref().position()).unwrap_or(usize::MAX);
    check_counts(
        header.elements.values(),
        header.encoding,
        bytes.len().saturating_sub(start),
        path,
    )?;
    let mut points = None;
    for (name, element) in &header.elements {
        let rows = parser
            .read_payload_for_element(&mut reader, element, &header)
            .map_err(refused)?;
        match name.as_str() {
            "vertex" => points = Some(rows.iter().map(|row| row.point).collect::<Vec<_>>()),
            "face" => {
                let Some(points) = &points else {
                    return Err(bad(path, "the faces come before the vertices", WANTED));
                };
                send_faces(&rows, points, path, sink)?;
            }
            _ => {}
        }
    }
    Ok(())
}

/// Refuses a header that promises more than the bytes can hold, before anything is reserved for it.
fn check_counts<'a>(
    elements: impl Iterator<Item = &'a ElementDef>,
    encoding: Encoding,
    available: usize,
    path: &Path,
) -> Result<()> {
    let mut needed = 0u128;
    for element in elements {
        let each: u128 = element
            .properties
            .values()
            .map(|p| match (&p.data_type, encoding) {
                // A digit and a blank (or the end of the line)
                (_, Encoding::Ascii) => 2,
                (PropertyType::Scalar(kind), _) | (PropertyType::List(kind, _), _) => {
                    bytes_of(kind)
                }
            })
            .sum();
        if each == 0 && element.count > 0 {
            return Err(bad(
                path,
                format!("element `{}` has no property", element.name),
                WANTED,
            ));
        }
        needed += each * element.count as u128;
    }
    // The last line may lack its end
    if needed > available as u128 + 1 {
        return Err(truncated(needed, available, path));
    }
    Ok(())
}

fn truncated(needed: u128, available: usize, path: &Path) -> Error {
    bad(
        path,
        format!(
            "truncated: the header promises at least {needed} bytes of elements, {available} are there"
        ),
        WANTED,
    )
}

fn bytes_of(kind: &ScalarType) -> u128 {
    match kind {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}

/// Cuts every polygon into a fan of triangles.
fn send_faces(rows: &[Row], points: &[[f64; 3]], path: &Path, sink: Sink) -> Result<()> {
    for (number, row) in rows.iter().enumerate() {
        let corner = |index: i64| {
            usize::try_from(index)
                .ok()
                .and_then(|i| points.get(i))
                .copied()
                .ok_or_else(|| {
                    bad(
                        path,
                        format!(
                            "face {number} refers to vertex {index}, but there are {}",
                            points.len()
                        ),
                        "indices from 0 to the number of vertices − 1",
                    )
                })
        };
        for pair in row.indices.get(1..).unwrap_or_default().windows(2) {
            sink([corner(row.indices[0])?, corner(pair[0])?, corner(pair[1])?])?;
        }
    }
    Ok(())
}
