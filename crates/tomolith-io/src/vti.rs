//! VTK image data, `.vti`: volumes for ParaView, in mm.
//!
//! One piece, *point* data at the voxel centers (so that ParaView draws contours and volumes without a conversion),
//! raw appended little-endian arrays with 64-bit sizes. VTK's order is x fastest, as ours; `Origin` is the center of
//! voxel [0, 0, 0], `Spacing` the pitch.
//!
//! ```
//! use tomolith_core::dose::Work;
//! use tomolith_core::grid::VolumeGrid;
//! use tomolith_io::volume::Values;
//! use tomolith_io::vti::write_vti;
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("dose.vti");
//! let grid = VolumeGrid::centered([1, 2, 3], 0.5);
//! write_vti(&path, &grid, &[("dose", Values::F32(&[0.0; 6]))], &Work::new()).unwrap();
//! let text = String::from_utf8_lossy(&std::fs::read(&path).unwrap()).into_owned();
//! assert!(text.contains(r#"WholeExtent="0 2 0 1 0 0" Origin="-0.5 -0.25 0" Spacing="0.5 0.5 0.5""#));
//! ```

use super::volume::{Values, tidy};
use super::whole::write_whole_under;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use tomolith_core::error::Result;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::units::exact;
use tomolith_core::work::Work;

/// Writes named arrays on a grid.
///
/// # Errors
/// [`Error::Io`](tomolith_core::error::Error::Io), or [`Error::Shape`](tomolith_core::error::Error::Shape) when an array and the grid do not fit.
pub fn write_vti(
    path: &Path,
    grid: &VolumeGrid,
    arrays: &[(&str, Values<'_>)],
    work: &Work,
) -> Result<()> {
    for (name, values) in arrays {
        values.must_fit(grid, name, path)?;
    }
    let bytes = arrays.iter().map(|(_, values)| values.bytes()).sum();
    write_whole_under(path, work, bytes, |file| {
        file.write_all(header(grid, arrays).as_bytes())?;
        for (_, values) in arrays {
            file.write_all(&(values.bytes() as u64).to_le_bytes())?;
            values.write(file)?;
        }
        file.write_all(b"\n  </AppendedData>\n</VTKFile>\n")?;
        Ok(())
    })
}

/// Everything up to the underscore after which the raw bytes start.
fn header(grid: &VolumeGrid, arrays: &[(&str, Values<'_>)]) -> String {
    let extent = [2, 1, 0]
        .map(|axis| format!("0 {}", grid.shape[axis].saturating_sub(1)))
        .join(" ");
    let origin = [grid.x(0), grid.y(0), grid.z(0)]
        .map(|mm| exact(tidy(mm)))
        .join(" ");
    let pitch = exact(tidy(grid.pitch_mm));
    let mut data = String::new();
    let mut offset = 0;
    for (name, values) in arrays {
        // Writing into a string cannot fail
        let _ = writeln!(
            data,
            "        <DataArray type=\"{}\" Name=\"{}\" format=\"appended\" offset=\"{offset}\"/>",
            match values {
                Values::F32(_) => "Float32",
                Values::U8(_) => "UInt8",
            },
            escape(name)
        );
        offset += 8 + values.bytes();
    }
    let first = arrays.first().map_or("", |(name, _)| *name);
    format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         \x20 <ImageData WholeExtent=\"{extent}\" Origin=\"{origin}\" Spacing=\"{pitch} {pitch} {pitch}\">\n\
         \x20   <Piece Extent=\"{extent}\">\n\
         \x20     <PointData Scalars=\"{}\">\n{data}\
         \x20     </PointData>\n\
         \x20   </Piece>\n\
         \x20 </ImageData>\n\
         \x20 <AppendedData encoding=\"raw\">\n_",
        escape(first)
    )
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bytes_are_where_the_header_says() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.vti");
        let grid = VolumeGrid::centered([2, 3, 4], 0.25).about([1.0, 2.0, 3.0]);
        let dose: Vec<f32> = (0..24).map(|i| i as f32 * 0.1).collect();
        let labels: Vec<u8> = (0..24).collect();
        write_vti(
            &path,
            &grid,
            &[
                ("dose", Values::F32(&dose)),
                ("target <1>", Values::U8(&labels)),
            ],
            &Work::new(),
        )
        .unwrap();
        let bytes = std::fs::read(&path).unwrap();
        let start = bytes.windows(2).position(|w| w == b"\n_").unwrap() + 2;
        let head = std::str::from_utf8(&bytes[..start]).unwrap();
        assert!(
            head.contains(
                r#"WholeExtent="0 3 0 2 0 1" Origin="0.625 1.75 2.875" Spacing="0.25 0.25 0.25""#
            ),
            "{head}"
        );
        assert!(head.contains(r#"Name="target &lt;1>""#), "{head}");
        let offsets: Vec<usize> = head
            .split("offset=\"")
            .skip(1)
            .map(|s| s.split('"').next().unwrap().parse().unwrap())
            .collect();
        let array = |offset: usize| {
            let at = start + offset;
            let size = u64::from_le_bytes(bytes[at..at + 8].try_into().unwrap()) as usize;
            &bytes[at + 8..at + 8 + size]
        };
        let read: Vec<f32> = array(offsets[0])
            .chunks(4)
            .map(|c| f32::from_le_bytes(c.try_into().unwrap()))
            .collect();
        assert_eq!(read, dose);
        assert_eq!(array(offsets[1]), labels);
        let tail = start + offsets[1] + 8 + 24;
        assert_eq!(&bytes[tail..], b"\n  </AppendedData>\n</VTKFile>\n");
    }
}
