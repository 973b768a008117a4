//! Triangle surfaces as binary STL, in mm.
//!
//! Eighty bytes of title, the number of triangles, then 50 bytes a triangle: unit normal by the right-hand rule, three
//! corners, two zero bytes; little endian. Shared corners are written with the same bits, so readers that weld equal
//! corners get the closed surface back. Written in blocks that are filled in parallel.
//!
//! ```
//! use tomolith_io::stl::write_stl;
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("print.stl");
//! let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! write_stl(&path, "print", &corners, &[[0, 1, 2]]).unwrap();
//! let bytes = std::fs::read(&path).unwrap();
//! assert_eq!(bytes.len(), 84 + 50);
//! assert_eq!(bytes[84 + 8..84 + 12], 1.0f32.to_le_bytes()); // the normal is +z
//! ```

use super::whole::{Refused, write_whole_under};
use std::io::{Seek as _, SeekFrom, Write};
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::parallel::lines;
use tomolith_core::vector::{cross, dot, minus};
use tomolith_core::work::Work;

/// Records that are turned into bytes at a time: 3 MB of triangles.
const BATCH: usize = 1 << 16;

/// Writes triangles (indices of corners, counter-clockwise seen from outside).
///
/// # Errors
/// [`Error::Io`]; [`Error::Unsupported`] for more than 2³² − 1 triangles or an index without corner.
pub fn write_stl(
    path: &Path,
    title: &str,
    corners: &[[f32; 3]],
    triangles: &[[u32; 3]],
) -> Result<()> {
    write_stl_pieces(path, title, |put| put(corners, triangles), &Work::new())
}

/// Takes a piece of a surface: corners, and triangles as indices of them.
pub type Put<'p> = &'p mut dyn FnMut(&[[f32; 3]], &[[u32; 3]]) -> Result<(), Refused>;

/// Writes a surface that is never held whole: `pieces` calls what it is given once for each piece, in order.
///
/// # Errors
/// As [`write_stl`], and what `pieces` returns.
pub fn write_stl_pieces(
    path: &Path,
    title: &str,
    pieces: impl FnOnce(Put<'_>) -> Result<(), Refused>,
    work: &Work,
) -> Result<()> {
    let refuse =
        |reason: &str| Error::unsupported(format!("the surface for {}", path.display()), reason);
    write_whole_under(path, work, 0, |file| {
        file.write_all(&title_bytes(title))?;
        let place_of_count = file.stream_position()?;
        file.write_all(&0u32.to_le_bytes())?;
        let mut count = 0;
        pieces(&mut |corners, triangles| {
            let known = |&i: &u32| (i as usize) < corners.len();
            if !triangles.as_flattened().iter().all(known) {
                return Err(refuse("a triangle refers to a vertex that does not exist").into());
            }
            count += triangles.len();
            Ok(write_records::<50>(file, triangles.len(), |i, out| {
                let [a, b, c] = triangles[i].map(|i| corners[i as usize]);
                let numbers = [normal([a, b, c]), a, b, c];
                for (slot, number) in out.chunks_exact_mut(4).zip(numbers.as_flattened()) {
                    slot.copy_from_slice(&number.to_le_bytes());
                }
            })?)
        })?;
        let count = u32::try_from(count)
            .map_err(|_| refuse("STL holds at most 4,294,967,295 triangles"))?;
        file.seek(SeekFrom::Start(place_of_count))?;
        Ok(file.write_all(&count.to_le_bytes())?)
    })
}

/// Writes records of N bytes that `fill` makes of zeros, many at a time.
pub(super) fn write_records<const N: usize>(
    file: &mut impl Write,
    count: usize,
    fill: impl Fn(usize, &mut [u8]) + Sync,
) -> std::io::Result<()> {
    let mut bytes = vec![0u8; N * BATCH.min(count)];
    for first in (0..count).step_by(BATCH) {
        let bytes = &mut bytes[..N * BATCH.min(count - first)];
        lines(bytes, N, |i, out| fill(first + i, out));
        file.write_all(bytes)?;
    }
    Ok(())
}

/// The title padded to eighty bytes; readers take a file that starts with `solid` for ASCII.
fn title_bytes(title: &str) -> [u8; 80] {
    let mut bytes = [b' '; 80];
    let text = format!("Tomolith, mm: {title}");
    let length = text.len().min(80);
    bytes[..length].copy_from_slice(&text.as_bytes()[..length]);
    bytes
}

/// Unit normal, computed in f64 because triangles may be slivers; zero for a triangle without area.
fn normal(corners: [[f32; 3]; 3]) -> [f32; 3] {
    let [a, b, c] = corners.map(|corner| corner.map(f64::from));
    let n = cross(minus(b, a), minus(c, a));
    let length = dot(n, n).sqrt();
    if length > 0.0 {
        n.map(|x| (x / length) as f32)
    } else {
        [0.0; 3]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::vector::unit;

    #[test]
    fn a_reader_finds_the_same_triangles() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("t.stl");
        let corners = [
            [0.1, 0.0, 0.0],
            [1.0, 0.2, 0.0],
            [0.0, 1.0, 0.3],
            [0.0, 0.0, 1.0],
        ];
        let triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        write_stl(&path, "solid? no", &corners, &triangles).unwrap();
        let mesh = stl_io::read_stl(&mut std::fs::File::open(&path).unwrap()).unwrap();
        mesh.validate().unwrap(); // watertight after welding equal corners
        assert_eq!(mesh.vertices.len(), 4);
        for (face, triangle) in mesh.faces.iter().zip(triangles) {
            for (i, corner) in face.vertices.iter().zip(triangle) {
                assert_eq!(mesh.vertices[*i].0, corners[corner as usize]);
            }
            let [a, b, c] = triangle.map(|i: u32| corners[i as usize].map(f64::from));
            let outward = unit(cross(minus(b, a), minus(c, a)));
            assert!((dot(outward, face.normal.0.map(f64::from)) - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn an_empty_print_is_a_valid_file_and_a_wild_index_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("t.stl");
        write_stl(&path, "", &[], &[]).unwrap();
        assert_eq!(std::fs::read(&path).unwrap().len(), 84);
        assert!(matches!(
            write_stl(&path, "", &[[0.0; 3]], &[[0, 0, 1]]),
            Err(Error::Unsupported { .. })
        ));
    }
}
