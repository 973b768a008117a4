//! VTK image data, `.vti`: volumes for ParaView, in mm.
//!
//! One piece, *point* data at the voxel centers (so that ParaView draws contours and volumes without a conversion),
//! raw appended little-endian arrays with 64-bit sizes. VTK's order is x fastest, as ours; `Origin` is the center of
//! voxel [0, 0, 0], `Spacing` the pitch.
//!
//! ```
//! use tomolith_core::dose::Run;
//! use tomolith_core::grid::VolumeGrid;
//! use tomolith_io::vti::{VtiValues, write_vti};
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("dose.vti");
//! let grid = VolumeGrid::centered([1, 2, 3], 0.5);
//! write_vti(&path, &grid, &[("dose", VtiValues::F32(&[0.0; 6]))], &Run::new()).unwrap();
//! let text = String::from_utf8_lossy(&std::fs::read(&path).unwrap()).into_owned();
//! assert!(text.contains(r#"WholeExtent="0 2 0 1 0 0" Origin="-0.5 -0.25 0" Spacing="0.5 0.5 0.5""#));
//! ```

use super::whole::write_whole_under;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::VolumeGrid;
use tomolith_core::run::Run;
use tomolith_core::units::exact;

/// Values of one array, `[z, y, x]`, x fastest.
#[derive(Clone, Copy, Debug)]
pub enum VtiValues<'a> {
    /// Doses and fractions.
    F32(&'a [f32]),
    /// Labels.
    U8(&'a [u8]),
}

impl VtiValues<'_> {
    fn len(&self) -> usize {
        match self {
            VtiValues::F32(v) => v.len(),
            VtiValues::U8(v) => v.len(),
        }
    }

    fn bytes(&self) -> u64 {
        match self {
            VtiValues::F32(v) => 4 * v.len() as u64,
            VtiValues::U8(v) => v.len() as u64,
        }
    }

    fn type_name(&self) -> &'static str {
        match self {
            VtiValues::F32(_) => "Float32",
            VtiValues::U8(_) => "UInt8",
        }
    }

    fn write(&self, file: &mut impl std::io::Write) -> std::io::Result<()> {
        match self {
            VtiValues::U8(values) => file.write_all(values),
            VtiValues::F32(values) if cfg!(target_endian = "little") => {
                file.write_all(bytemuck::cast_slice(values))
            }
            VtiValues::F32(values) => values
                .iter()
                .try_for_each(|v| file.write_all(&v.to_le_bytes())),
        }
    }
}

/// Writes named arrays on a grid.
///
/// # Errors
/// [`Error::Io`], or [`Error::Shape`] when an array and the grid do not fit.
pub fn write_vti(
    path: &Path,
    grid: &VolumeGrid,
    arrays: &[(&str, VtiValues<'_>)],
    run: &Run,
) -> Result<()> {
    for (name, values) in arrays {
        if values.len() != grid.len() {
            return Err(Error::shape(
                format!("{name} for {}", path.display()),
                grid.shape,
                vec![values.len()],
            ));
        }
    }
    let bytes: u64 = arrays.iter().map(|(_, values)| values.bytes()).sum();
    write_whole_under(path, (run, bytes as usize), |file| {
        file.write_all(header(grid, arrays).as_bytes())?;
        for (_, values) in arrays {
            file.write_all(&values.bytes().to_le_bytes())?;
            values.write(file)?;
        }
        file.write_all(b"\n  </AppendedData>\n</VTKFile>\n")?;
        Ok(())
    })
}

/// A length in mm without the last digits that arithmetic leaves: twelve are a picometer of a meter.
fn tidy(mm: f64) -> String {
    exact(format!("{mm:.11e}").parse().unwrap_or(mm) + 0.0)
}

/// Everything up to the underscore after which the raw bytes start.
fn header(grid: &VolumeGrid, arrays: &[(&str, VtiValues<'_>)]) -> String {
    let extent = [2, 1, 0]
        .map(|axis| format!("0 {}", grid.shape[axis].saturating_sub(1)))
        .join(" ");
    let origin = [grid.x(0), grid.y(0), grid.z(0)].map(tidy).join(" ");
    let pitch = tidy(grid.pitch_mm);
    let mut data = String::new();
    let mut offset = 0;
    for (name, values) in arrays {
        // Writing into a string cannot fail
        let _ = writeln!(
            data,
            "        <DataArray type=\"{}\" Name=\"{}\" format=\"appended\" offset=\"{offset}\"/>",
            values.type_name(),
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
    fn lengths_have_no_digits_of_arithmetic() {
        assert_eq!(
            [tidy(-1.7249999999999999), tidy(-0.0), tidy(0.1 + 0.2)],
            ["-1.725", "0", "0.3"]
        );
    }

    #[test]
    fn the_bytes_are_where_the_header_says() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.vti");
        let mut grid = VolumeGrid::centered([2, 3, 4], 0.25);
        grid.center_mm = [1.0, 2.0, 3.0];
        let dose: Vec<f32> = (0..24).map(|i| i as f32 * 0.1).collect();
        let labels: Vec<u8> = (0..24).collect();
        write_vti(
            &path,
            &grid,
            &[
                ("dose", VtiValues::F32(&dose)),
                ("target <1>", VtiValues::U8(&labels)),
            ],
            &Run::new(),
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

    #[test]
    fn an_array_of_another_size_is_refused() {
        let grid = VolumeGrid::centered([2, 2, 2], 1.0);
        let error = write_vti(
            Path::new("a.vti"),
            &grid,
            &[("dose", VtiValues::F32(&[0.0]))],
            &Run::new(),
        )
        .unwrap_err();
        assert!(matches!(error, Error::Shape { .. }));
    }
}
