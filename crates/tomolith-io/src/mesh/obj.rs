//! Wavefront OBJ: only vertices (`v`) and faces (`f`) matter here.

use super::{Sink, bad};
use std::io::Cursor;
use std::path::Path;
use tomolith_core::error::Result;

/// Reads vertices and faces. All other lines (normals, materials, names, comments in any encoding) are taken out first:
/// they cannot make a good surface unreadable then.
pub(super) fn parse(bytes: &[u8], path: &Path, sink: Sink) -> Result<()> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..Default::default()
    };
    let surface = surface_lines(bytes);
    let (models, _) = tobj::load_obj_buf(&mut Cursor::new(surface), &options, |_| {
        Ok(Default::default())
    })
    .map_err(|e| {
        bad(
            path,
            format!("damaged OBJ: {e}"),
            "an OBJ file with `v x y z` and `f i j k …` lines",
        )
    })?;
    for model in &models {
        let corner = |i: u32| {
            let at = 3 * i as usize;
            std::array::from_fn(|axis| model.mesh.positions[at + axis])
        };
        for triangle in model.mesh.indices.chunks_exact(3) {
            sink([0, 1, 2].map(|i| corner(triangle[i])))?;
        }
    }
    Ok(())
}

/// The `v` and `f` lines, those that a backslash continues joined to one.
fn surface_lines(bytes: &[u8]) -> Vec<u8> {
    let mut kept = Vec::with_capacity(bytes.len());
    let mut wanted = false;
    let mut continued = false;
    for line in bytes.split(|&b| b == b'\n').map(<[u8]>::trim_ascii) {
        if !continued {
            wanted = matches!(line, [b'v' | b'f', b' ' | b'\t', ..]);
        }
        let text = line.strip_suffix(b"\\").unwrap_or(line);
        continued = text.len() < line.len();
        if wanted {
            // A comment may follow on the line
            kept.extend_from_slice(text.split(|&b| b == b'#').next().unwrap_or_default());
            kept.push(if continued { b' ' } else { b'\n' });
        }
    }
    kept
}
