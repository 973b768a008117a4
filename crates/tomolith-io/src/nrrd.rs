//! NRRD, `.nrrd`: volumes for 3D Slicer, ITK and SimpleITK, in mm.
//!
//! Written is one array in one file, little endian, not compressed, x fastest. `space origin` is the center of voxel [0, 0, 0], `space directions` are the edges of a
//! voxel, `space units` mm. The space is `left-posterior-superior`: so ITK and Slicer understand a mesh without a space, such as `print.stl`, and dose and print lie on
//! one another there. The names of the axes mean nothing else.
//!
//! Read are `raw` and `gzip` encodings of any type of number in two or three dimensions, with their header in the same file. Axes must run along x, y and z, in
//! this order; where the voxels lie is not read.
//!
//! Format: Gordon Kindlmann, "Definition of NRRD File Format", <https://teem.sourceforge.net/nrrd/format.html>.

use super::numbers::{Element, Kind, Numbers};
use super::volume::{Values, tidy};
use super::whole::write_whole_under;
use flate2::bufread::MultiGzDecoder;
use std::collections::BTreeMap;
use std::io::{BufRead, Read, Write};
use std::path::Path;
use tomolith_core::error::Result;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::text::one_line;
use tomolith_core::units::exact;
use tomolith_core::work::Work;

/// Longest header that is believed.
const LONGEST_HEADER: u64 = 1 << 20;

/// Writes values that fit the grid.
pub(super) fn write(
    path: &Path,
    name: &str,
    grid: &VolumeGrid,
    values: Values<'_>,
    work: &Work,
) -> Result<()> {
    write_whole_under(path, work, values.bytes(), |file| {
        file.write_all(header(name, grid, values).as_bytes())?;
        Ok(values.write(file)?)
    })
}

fn header(name: &str, grid: &VolumeGrid, values: Values<'_>) -> String {
    let [nz, ny, nx] = grid.shape;
    let mm = |length: f64| exact(tidy(length));
    let [x, y, z] = [grid.x(0), grid.y(0), grid.z(0)].map(mm);
    let (across, height) = (mm(grid.pitch_mm), mm(grid.height_mm));
    let kind = match values {
        Values::F32(_) => "float",
        Values::U8(_) => "uint8",
    };
    format!(
        "NRRD0004\n\
         type: {kind}\n\
         dimension: 3\n\
         space: left-posterior-superior\n\
         sizes: {nx} {ny} {nz}\n\
         space directions: ({across},0,0) (0,{across},0) (0,0,{height})\n\
         kinds: domain domain domain\n\
         endian: little\n\
         encoding: raw\n\
         space origin: ({x},{y},{z})\n\
         space units: \"mm\" \"mm\" \"mm\"\n\
         content: {}\n\
         \n",
        one_line(name)
    )
}

/// The array of a file; its first index is that of the slowest axis.
///
/// # Errors
/// What was found.
pub(super) fn read(mut file: impl BufRead) -> Result<Numbers, String> {
    let fields = Fields::read(&mut file)?;
    let shape = fields.shape()?;
    fields.must_run_along_axes()?;
    let element = fields.element()?;
    let mut gzip;
    let data: &mut dyn Read = match fields.get("encoding")? {
        "raw" => &mut file,
        "gzip" | "gz" => {
            gzip = MultiGzDecoder::new(file);
            &mut gzip
        }
        other => return Err(format!("encoding `{other}`, neither raw nor gzip")),
    };
    Ok(Numbers {
        values: element.read_all(data, &shape)?,
        kind: element.kind,
        shape,
    })
}

/// The fields of a header by their names, which are in small letters.
struct Fields(BTreeMap<String, String>);

impl Fields {
    fn read(file: &mut impl BufRead) -> Result<Self, String> {
        let mut lines = file.take(LONGEST_HEADER);
        let mut next = || {
            let mut line = Vec::new();
            let read = lines.read_until(b'\n', &mut line);
            read.map_err(|e| format!("damaged: {e}"))?;
            match line.pop() {
                Some(b'\n') => Ok(String::from_utf8_lossy(&line).trim_end().to_owned()),
                _ => Err("truncated: no empty line ends the header".to_owned()),
            }
        };
        let magic = next().unwrap_or_default();
        if !magic.starts_with("NRRD000") {
            return Err("no NRRD file: it does not begin with `NRRD000`".to_owned());
        }
        let mut fields = BTreeMap::new();
        loop {
            let line = next()?;
            if line.is_empty() {
                return Ok(Fields(fields));
            }
            if let Some((name, value)) = line.split_once(": ").filter(|_| !line.starts_with('#')) {
                fields.insert(name.to_ascii_lowercase(), value.trim().to_owned());
            }
        }
    }

    fn get(&self, name: &str) -> Result<&str, String> {
        let value = self.0.get(name).map(String::as_str);
        value.ok_or_else(|| format!("a header without `{name}`"))
    }

    /// Counts, the slowest axis first.
    fn shape(&self) -> Result<Vec<usize>, String> {
        let sizes = self.get("sizes")?;
        let counts = sizes.split_whitespace().rev().map(str::parse);
        counts
            .collect::<Result<_, _>>()
            .map_err(|_| format!("sizes `{sizes}`"))
    }

    /// How a number is stored; the data must follow the header at once.
    fn element(&self) -> Result<Element, String> {
        let apart = [
            "data file",
            "datafile",
            "line skip",
            "lineskip",
            "byte skip",
            "byteskip",
        ];
        let is_set = |name: &&&str| self.0.get(**name).is_some_and(|value| value != "0");
        if let Some(name) = apart.iter().find(is_set) {
            return Err(format!("`{name}`: its data do not follow the header"));
        }
        let kind = self.get("type")?;
        let kind = number_type(kind).ok_or_else(|| format!("numbers of type `{kind}`"))?;
        let is_big_endian = match self.0.get("endian").map(String::as_str) {
            Some("big") => true,
            Some("little") => false,
            None if kind.bytes() == 1 => false,
            other => return Err(format!("endian `{}`", other.unwrap_or("(none)"))),
        };
        Ok(Element {
            kind,
            is_big_endian,
        })
    }

    /// Refuses axes that are mirrored, turned or in another order, of which an array `[z, y, x]` knows nothing.
    fn must_run_along_axes(&self) -> Result<(), String> {
        let space = self.0.get("space").map_or("", |space| space.trim());
        let mirrored = [
            "right-anterior-superior",
            "left-anterior-superior",
            "RAS",
            "LAS",
        ];
        if mirrored.iter().any(|name| space.eq_ignore_ascii_case(name)) {
            return Err(format!(
                "space `{space}`: its x or y runs against that of left-posterior-superior"
            ));
        }
        let Some(text) = self.0.get("space directions") else {
            return Ok(());
        };
        let vectors = text
            .split(['(', ')'])
            .map(str::trim)
            .filter(|v| !v.is_empty());
        let runs_along = |(axis, vector): (usize, &str)| {
            let parts: Option<Vec<f64>> =
                vector.split(',').map(|n| n.trim().parse().ok()).collect();
            parts.is_some_and(|parts| {
                let length = parts.get(axis).copied().unwrap_or_default();
                let is_small = |(i, part): (usize, &f64)| i == axis || part.abs() <= 1e-6 * length;
                length > 0.0 && parts.iter().enumerate().all(is_small)
            })
        };
        match vectors.enumerate().all(runs_along) {
            true => Ok(()),
            false => Err(format!(
                "space directions `{text}`: its axes do not run along x, y and z"
            )),
        }
    }
}

fn number_type(name: &str) -> Option<Kind> {
    Some(match name {
        "signed char" | "int8" | "int8_t" => Kind::Signed(1),
        "uchar" | "unsigned char" | "uint8" | "uint8_t" => Kind::Unsigned(1),
        "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => {
            Kind::Signed(2)
        }
        "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => {
            Kind::Unsigned(2)
        }
        "int" | "signed int" | "int32" | "int32_t" => Kind::Signed(4),
        "uint" | "unsigned int" | "uint32" | "uint32_t" => Kind::Unsigned(4),
        "longlong"
        | "long long"
        | "long long int"
        | "signed long long"
        | "signed long long int"
        | "int64"
        | "int64_t" => Kind::Signed(8),
        "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => {
            Kind::Unsigned(8)
        }
        "float" => Kind::Float(4),
        "double" => Kind::Float(8),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::Compression;
    use flate2::write::GzEncoder;

    fn grid() -> VolumeGrid {
        VolumeGrid::centered([2, 3, 4], 0.25).about([1.0, 2.0, 3.0])
    }

    #[test]
    fn what_is_written_says_where_it_is_and_comes_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("dose.nrrd");
        let dose: Vec<f32> = (0..24).map(|i| i as f32 * 0.1).collect();
        write(&path, "dose", &grid(), Values::F32(&dose), &Work::new()).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        let end = bytes.windows(2).position(|w| w == b"\n\n").unwrap() + 2;
        let head = std::str::from_utf8(&bytes[..end]).unwrap();
        for line in [
            "sizes: 4 3 2\n",
            "space directions: (0.25,0,0) (0,0.25,0) (0,0,0.25)\n",
            "space origin: (0.625,1.75,2.875)\n",
            "content: dose\n\n",
        ] {
            assert!(head.contains(line), "{head}");
        }
        assert_eq!(bytes[bytes.len() - 4..], dose[23].to_le_bytes());
        let read = read(&bytes[..]).unwrap();
        assert_eq!((&read.shape[..], read.values), (&[2, 3, 4][..], dose));
    }

    #[test]
    fn types_ends_and_encodings_of_other_programs_are_read() {
        let file = |fields: &str, data: &[u8]| {
            let head =
                format!("NRRD0005\n# by hand\nDimension: 3\nsizes: 3 1 1\n{fields}\nkey:=a: b\n\n");
            read(&[head.as_bytes(), data].concat()[..]).map(|numbers| numbers.values)
        };
        let big = file(
            "type: short\nendian: big\nencoding: raw",
            &[0, 1, 255, 255, 1, 0],
        );
        assert_eq!(big.unwrap(), [1.0, -1.0, 256.0]);
        let mut gzip = GzEncoder::new(Vec::new(), Compression::fast());
        gzip.write_all(&[0, 1, 2]).unwrap();
        let gzip = gzip.finish().unwrap();
        assert_eq!(
            file("type: uchar\nencoding: gz", &gzip).unwrap(),
            [0.0, 1.0, 2.0]
        );
        for (fields, data, found) in [
            (
                "type: float\nendian: little\nencoding: raw",
                &[0u8; 11][..],
                "truncated",
            ),
            ("type: uint8\nencoding: gzip", &gzip[..8], "truncated"),
            ("type: uint8\nencoding: ascii", &[0; 3], "encoding `ascii`"),
            ("type: block\nencoding: raw", &[0; 3], "type `block`"),
            ("type: float\nencoding: raw", &[0; 12], "endian `(none)`"),
            ("type: uint8", &[0; 3], "without `encoding`"),
            (
                "type: uint8\nencoding: raw\ndata file: a.raw",
                &[],
                "`data file`",
            ),
            (
                "type: uint8\nencoding: raw\nspace directions: (0,0,1) (0,1,0) (1,0,0)",
                &[0; 3],
                "do not run along x, y and z",
            ),
            (
                "type: uint8\nencoding: raw\nspace: RAS\nspace directions: (1,0,0) (0,1,0) (0,0,1)",
                &[0; 3],
                "runs against",
            ),
            (
                "type: uint8\nencoding: raw\nspace directions: (-1,0,0) (0,1,0) (0,0,1)",
                &[0; 3],
                "do not run along x, y and z",
            ),
        ] {
            let error = file(fields, data).unwrap_err();
            assert!(error.contains(found), "{error}");
        }
        assert!(
            read(&b"NRRD0004\nsizes: 1 1 1"[..])
                .unwrap_err()
                .contains("no empty line")
        );
        assert!(read(&b"P6 1 1"[..]).unwrap_err().contains("no NRRD file"));
    }
}
