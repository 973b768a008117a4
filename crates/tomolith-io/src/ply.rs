//! Triangle surfaces with one number and one color per corner, as binary PLY, in mm.
//!
//! An ASCII header, then for each corner x, y, z and the number as f32 and red, green, blue as bytes; for each triangle a 3 as
//! a byte and three corner numbers as i32; little endian. Viewers of meshes show the colors; those that know scalar fields
//! (CloudCompare, MeshLab, PyVista) read the number too.
//!
//! ```
//! use tomolith_io::ply::{PlyCorners, write_ply};
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("print.ply");
//! let corners = PlyCorners {
//!     places: &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//!     name: "deviation_um",
//!     numbers: &[-5.0, 0.0, 2.5],
//!     colors: &[[0, 0, 255], [200, 200, 200], [255, 0, 0]],
//! };
//! write_ply(&path, "millimeters", &corners, &[[0, 1, 2]]).unwrap();
//! let bytes = std::fs::read(&path).unwrap();
//! let header = b"end_header\n";
//! let end = bytes.windows(header.len()).position(|w| w == header).unwrap() + header.len();
//! assert_eq!(bytes.len() - end, 3 * 19 + 13);
//! assert_eq!(bytes[end + 12..end + 16], (-5.0f32).to_le_bytes()); // the first corner's number
//! ```

use super::stl::write_records;
use super::whole::write_whole;
use std::io::Write;
use std::path::Path;
use tomolith_core::error::{Error, Result};

/// Corners of a surface, with what is known at each.
#[derive(Clone, Copy, Debug)]
pub struct PlyCorners<'a> {
    /// `[x, y, z]`, mm.
    pub places: &'a [[f32; 3]],
    /// The property's name for the numbers: letters, digits and underscores.
    pub name: &'a str,
    /// One number per corner.
    pub numbers: &'a [f32],
    /// Red, green, blue per corner.
    pub colors: &'a [[u8; 3]],
}

/// Writes triangles (indices of corners, counter-clockwise seen from outside) under a comment of one line.
///
/// # Errors
/// [`Error::Io`]; [`Error::Shape`] when numbers or colors are not as many as corners; [`Error::Unsupported`] for more than
/// 2³¹ − 1 corners.
pub fn write_ply(
    path: &Path,
    comment: &str,
    corners: &PlyCorners<'_>,
    triangles: &[[u32; 3]],
) -> Result<()> {
    let count = corners.places.len();
    for found in [corners.numbers.len(), corners.colors.len()] {
        if found != count {
            return Err(Error::shape(
                format!("numbers and colors of the corners for {}", path.display()),
                vec![count],
                vec![found],
            ));
        }
    }
    if i32::try_from(count).is_err() {
        return Err(Error::unsupported(
            format!("the surface for {}", path.display()),
            "PLY numbers at most 2,147,483,647 corners",
        ));
    }
    let head = format!(
        "ply\nformat binary_little_endian 1.0\ncomment Tomolith, {}\nelement vertex {count}\nproperty float x\nproperty float y\n\
         property float z\nproperty float {}\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        // Readers expect ASCII in headers
        comment.replace(|c: char| !(c.is_ascii_graphic() || c == ' '), "_"),
        corners.name,
        triangles.len(),
    );
    write_whole(path, |file| {
        file.write_all(head.as_bytes())?;
        write_records::<19>(file, count, |i, out| {
            let [x, y, z] = corners.places[i];
            for (slot, number) in out.chunks_exact_mut(4).zip([x, y, z, corners.numbers[i]]) {
                slot.copy_from_slice(&number.to_le_bytes());
            }
            out[16..].copy_from_slice(&corners.colors[i]);
        })?;
        write_records::<13>(file, triangles.len(), |i, out| {
            out[0] = 3;
            for (slot, corner) in out[1..].chunks_exact_mut(4).zip(triangles[i]) {
                slot.copy_from_slice(&corner.to_le_bytes());
            }
        })?;
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::read_mesh;

    #[test]
    fn our_own_reader_gets_the_surface_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.ply");
        let places = [
            [0.0, 0.5, 1.0],
            [2.0, 0.0, 0.0],
            [0.0, 3.0, 0.0],
            [0.0, 0.0, 4.0],
        ];
        let triangles = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
        let corners = PlyCorners {
            places: &places,
            name: "deviation_um",
            numbers: &[-5.0, 0.0, 2.5, 1.0],
            colors: &[[1, 2, 3]; 4],
        };
        write_ply(&path, "two\nlines", &corners, &triangles).unwrap();
        // The number and the color of the first corner stand behind its place
        let bytes = std::fs::read(&path).unwrap();
        let first = [&(-5.0f32).to_le_bytes()[..], &[1, 2, 3]].concat();
        let header = bytes.len() - 4 * 19 - 4 * 13;
        assert_eq!(bytes[header + 12..header + 19], first);
        let mesh = read_mesh(&path).unwrap().mesh;
        assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (4, 4));
        for (t, triangle) in triangles.iter().enumerate() {
            let expected = triangle.map(|i: u32| places[i as usize].map(f64::from));
            assert_eq!(mesh.corners(t), expected);
        }
    }

    #[test]
    fn lists_of_different_lengths_are_refused() {
        let corners = PlyCorners {
            places: &[[0.0; 3]],
            name: "a",
            numbers: &[],
            colors: &[[0; 3]],
        };
        let error = write_ply(Path::new("a.ply"), "", &corners, &[]);
        assert!(matches!(error, Err(Error::Shape { .. })));
    }
}
