//! Wavefront OBJ: only vertices (`v`) and faces (`f`) matter here.
//!
//! Of a vertex the first three numbers count: colors may follow, and a weight, which is for curves alone. Normals,
//! materials, names and comments cannot make a good surface unreadable; free-form surfaces are refused.

use super::Collector;
use super::text::{decoded, lines, number, shown, words_of};
use tomolith_core::error::Result;

const ACCEPTED: &str = "an OBJ file with `v x y z` and `f i j k …` lines";

/// Vertices so far, and the corners of faces with their lines.
#[derive(Default)]
struct Surface {
    points: Vec<[f64; 3]>,
    /// Line of the first vertex with a weight other than 1.
    weighted: Option<usize>,
    faces: Vec<Face>,
}

struct Face {
    line: usize,
    /// Numbers of vertices, from 0; a file may use them before they come.
    corners: Vec<usize>,
}

pub(super) fn parse(bytes: &[u8], out: &mut Collector) -> Result<()> {
    let text = decoded(bytes);
    let mut surface = Surface::default();
    let mut statement: Vec<&[u8]> = Vec::new();
    let mut last = 0;
    for (line, content) in lines(&text) {
        let content = content.split(|b| *b == b'#').next().unwrap_or_default();
        let content = content.trim_ascii_end();
        let whole = content.strip_suffix(b"\\");
        statement.extend(words_of(whole.unwrap_or(content)));
        if whole.is_none() {
            surface.take(&statement, line, out)?;
            statement.clear();
        }
        last = line;
    }
    surface.take(&statement, last, out)?;
    if surface.faces.is_empty() {
        let found = match surface.points.len() {
            0 => format!(
                "no `v` and no `f` in it (it begins with `{}`)",
                shown(&text)
            ),
            points => format!("{points} vertices and no face (`f`)"),
        };
        return Err(out.refusal(found, ACCEPTED));
    }
    surface.send(out)
}

impl Surface {
    /// Takes a statement that ends on a line.
    fn take(&mut self, words: &[&[u8]], line: usize, out: &Collector) -> Result<()> {
        let refuse = |found: String| Err(out.refusal(format!("line {line}: {found}"), ACCEPTED));
        match words {
            [b"v", numbers @ ..] => {
                let mut point = [f64::NAN; 3];
                for (axis, value) in point.iter_mut().enumerate() {
                    let word = numbers.get(axis).copied().unwrap_or_default();
                    match number(word) {
                        Some(read) => *value = read,
                        None => {
                            return refuse(format!("`{}` in place of a coordinate", shown(word)));
                        }
                    }
                }
                let weight = numbers.get(3).and_then(|word| number::<f64>(word));
                if numbers.len() == 4 && weight != Some(1.0) {
                    self.weighted.get_or_insert(line);
                }
                self.points.push(point);
            }
            [b"f" | b"fo", corners @ ..] => {
                let known = self.points.len();
                let mut face = Vec::with_capacity(corners.len());
                for word in corners {
                    let first = word.split(|b| *b == b'/').next().unwrap_or_default();
                    let index = match number::<i64>(first) {
                        Some(i) if i > 0 => usize::try_from(i - 1).ok(),
                        Some(i) if i < 0 => usize::try_from(i.unsigned_abs())
                            .ok()
                            .and_then(|back| known.checked_sub(back)),
                        _ => None,
                    };
                    match index {
                        Some(index) => face.push(index),
                        None => {
                            return refuse(format!("a face refers to vertex `{}`", shown(first)));
                        }
                    }
                }
                self.faces.push(Face {
                    line,
                    corners: face,
                });
            }
            [b"surf", ..] => {
                return refuse("a free-form surface (`surf`), which is no mesh".to_owned());
            }
            _ => {}
        }
        Ok(())
    }

    fn send(&self, out: &mut Collector) -> Result<()> {
        if let Some(line) = self.weighted {
            out.note(format!(
                "Vertices have a fourth number other than 1, the first on line {line}: a weight of curves, without effect here."
            ));
        }
        let mut corners = Vec::new();
        for face in &self.faces {
            corners.clear();
            for &index in &face.corners {
                let Some(point) = self.points.get(index) else {
                    let found = format!(
                        "line {}: a face refers to vertex {}, but there are {}",
                        face.line,
                        index + 1,
                        self.points.len()
                    );
                    return Err(out.refusal(found, ACCEPTED));
                };
                corners.push(*point);
            }
            out.fan(&corners)?;
        }
        Ok(())
    }
}
