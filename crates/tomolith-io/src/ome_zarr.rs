//! OME-Zarr 0.5, a folder `.ome.zarr`: volumes in levels for napari, neuroglancer and Fiji, in mm.
//!
//! A group holds the arrays `0`, `1`, … of Zarr 3, axes z, y, x. Each level has half as many voxels along every axis as the one before, up to one that fits into a chunk; a
//! voxel is the mean of the eight that it covers, a label the one that most of them have. `scale` and `translation` say the edges of a voxel and the
//! center of the first one. Chunks have 64 voxels along each axis and are packed with gzip; those of zeros are left out, as the format allows.
//!
//! Sources: "OME-Zarr specification 0.5", <https://ngff.openmicroscopy.org/0.5/>; "Zarr core specification 3", <https://zarr-specs.readthedocs.io>.

use super::volume::{Values, tidy};
use super::whole::{Refused, write_folder_whole};
use bytemuck::NoUninit;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::{Value, json};
use std::borrow::Cow;
use std::fs::{create_dir_all, write as write_file};
use std::io::Write;
use std::path::Path;
use tomolith_core::error::Result;
use tomolith_core::grid::{VolumeGrid, sample};
use tomolith_core::parallel::{InParallel, lines};
use tomolith_core::work::{Steps, Work};

/// Voxels along an edge of a chunk.
const CHUNK: usize = 64;
/// How hard chunks are packed: a dose gets a tenth smaller at 6, in three times as long.
const GZIP: u32 = 1;

/// Writes values that fit the grid.
pub(super) fn write(
    path: &Path,
    name: &str,
    grid: &VolumeGrid,
    values: Values<'_>,
    work: &Work,
) -> Result<()> {
    write_folder_whole(path, |folder| {
        let (levels, method) = match values {
            Values::F32(values) => (write_levels(folder, grid, values, work)?, "mean"),
            Values::U8(values) => (write_levels(folder, grid, values, work)?, "mode"),
        };
        let axis = |name| json!({ "name": name, "type": "space", "unit": "millimeter" });
        let axes = ["z", "y", "x"].map(axis);
        let multiscale = json!({ "name": name, "type": method, "axes": axes, "datasets": levels });
        let ome = json!({ "version": "0.5", "multiscales": [multiscale] });
        let group = json!({ "zarr_format": 3, "node_type": "group", "attributes": { "ome": ome } });
        Ok(write_file(folder.join("zarr.json"), group.to_string())?)
    })
}

/// A number in a voxel.
trait Sample: NoUninit + Default + PartialEq + Send + Sync {
    const TYPE: &'static str;

    /// The number of a voxel that covers these, which are one at least.
    fn of(covered: &[Self]) -> Self;
}

impl Sample for f32 {
    const TYPE: &'static str = "float32";

    fn of(covered: &[f32]) -> f32 {
        let sum: f64 = covered.iter().map(|&v| f64::from(v)).sum();
        (sum / covered.len() as f64) as f32
    }
}

impl Sample for u8 {
    const TYPE: &'static str = "uint8";

    fn of(covered: &[u8]) -> u8 {
        let votes = |label: &u8| covered.iter().filter(|other| *other == label).count();
        let most = covered
            .iter()
            .copied()
            .max_by_key(|label| (votes(label), *label));
        most.unwrap_or_default()
    }
}

/// Values of a level, `[z, y, x]`.
struct Level<'a, T: Clone> {
    shape: [usize; 3],
    values: Cow<'a, [T]>,
}

impl<T: Sample> Level<'_, T> {
    /// Half as many voxels along every axis, the last one of an odd number for itself.
    fn halved(&self) -> Level<'static, T> {
        let [_, ny, nx] = self.shape;
        let shape = self.shape.map(|n| n.div_ceil(2));
        let mut values = vec![T::default(); shape.iter().product()];
        lines(&mut values, shape[2], |line, voxels| {
            let at = [line / shape[1], line % shape[1]];
            let pair = |axis: usize, i: usize| 2 * i..(2 * i + 2).min(self.shape[axis]);
            for (x, voxel) in voxels.iter_mut().enumerate() {
                let (mut covered, mut count) = ([T::default(); 8], 0);
                for z in pair(0, at[0]) {
                    for y in pair(1, at[1]) {
                        for x in pair(2, x) {
                            covered[count] = self.values[(z * ny + y) * nx + x];
                            count += 1;
                        }
                    }
                }
                *voxel = T::of(&covered[..count]);
            }
        });
        Level {
            shape,
            values: values.into(),
        }
    }

    /// Counts of a chunk.
    fn chunk(&self) -> [usize; 3] {
        self.shape.map(|n| n.min(CHUNK))
    }

    /// Writes the array into a new folder.
    fn write(&self, folder: &Path, work: &Work, steps: &Steps<'_>) -> Result<(), Refused> {
        create_dir_all(folder)?;
        let endian = if cfg!(target_endian = "big") {
            "big"
        } else {
            "little"
        };
        let array = json!({
            "zarr_format": 3,
            "node_type": "array",
            "shape": self.shape,
            "data_type": T::TYPE,
            "chunk_grid": { "name": "regular", "configuration": { "chunk_shape": self.chunk() } },
            "chunk_key_encoding": { "name": "default", "configuration": { "separator": "/" } },
            "fill_value": 0,
            "codecs": [
                { "name": "bytes", "configuration": { "endian": endian } },
                { "name": "gzip", "configuration": { "level": GZIP } },
            ],
            "dimension_names": ["z", "y", "x"],
            "attributes": {},
        });
        write_file(folder.join("zarr.json"), array.to_string())?;
        let [nz, ny, nx] = [0, 1, 2].map(|axis| self.shape[axis].div_ceil(CHUNK));
        let chunks = (0..nz * ny * nx).map(|i| [i / (ny * nx), i / nx % ny, i % nx]);
        let written = chunks.par_map(|[z, y, x]| -> Result<(), Refused> {
            work.check()?;
            let chunk = self.chunk_at([z, y, x]);
            steps.add(size_of_val(&chunk[..]));
            if chunk.iter().all(|value| *value == T::default()) {
                return Ok(());
            }
            let folder = folder.join(format!("c/{z}/{y}"));
            create_dir_all(&folder)?;
            let mut packed = GzEncoder::new(Vec::new(), Compression::new(GZIP));
            packed.write_all(bytemuck::cast_slice(&chunk))?;
            Ok(write_file(folder.join(x.to_string()), packed.finish()?)?)
        });
        written.into_iter().collect()
    }

    /// The values of a chunk; zeros beyond the end of the array.
    fn chunk_at(&self, chunk: [usize; 3]) -> Vec<T> {
        let [_, ny, nx] = self.shape;
        let [cz, cy, cx] = self.chunk();
        let mut values = vec![T::default(); cz * cy * cx];
        let [zs, ys, xs] = [0, 1, 2].map(|axis| {
            let start = chunk[axis] * CHUNK;
            start..(start + CHUNK).min(self.shape[axis])
        });
        for (k, z) in zs.enumerate() {
            for (j, y) in ys.clone().enumerate() {
                let row = &self.values[(z * ny + y) * nx..][xs.clone()];
                values[(k * cy + j) * cx..][..row.len()].copy_from_slice(row);
            }
        }
        values
    }
}

/// Writes all levels into a new folder; what the group says of them.
fn write_levels<T: Sample>(
    folder: &Path,
    grid: &VolumeGrid,
    values: &[T],
    work: &Work,
) -> Result<Vec<Value>, Refused> {
    // Levels together are an eighth more, and so on
    let steps = work.steps(size_of_val(values) * 8 / 7);
    let mut level = Level {
        shape: grid.shape,
        values: values.into(),
    };
    // An axis of one voxel stays as it is
    let mut covered = [1; 3];
    let mut levels = Vec::new();
    loop {
        let path = levels.len().to_string();
        level.write(&folder.join(&path), work, &steps)?;
        levels.push(dataset(&path, grid, covered));
        if level.shape.iter().all(|&n| n <= CHUNK) {
            return Ok(levels);
        }
        covered = [0, 1, 2].map(|axis| covered[axis] * level.shape[axis].min(2));
        level = level.halved();
    }
}

/// A level whose voxels cover so many of the grid along each axis.
fn dataset(path: &str, grid: &VolumeGrid, covered: [usize; 3]) -> Value {
    let edges = [grid.height_mm, grid.pitch_mm, grid.pitch_mm];
    let first = [grid.z(0), grid.y(0), grid.x(0)];
    let scale = [0, 1, 2].map(|axis| tidy(covered[axis] as f64 * edges[axis]));
    // The middle of those that the first voxel covers: the last sample of them lies as far beyond it as the first one before
    let middle = |axis: usize| first[axis] - sample(0, covered[axis], edges[axis]);
    let translation = [0, 1, 2].map(|axis| tidy(middle(axis)));
    json!({
        "path": path,
        "coordinateTransformations": [
            { "type": "scale", "scale": scale },
            { "type": "translation", "translation": translation },
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::read::GzDecoder;
    use std::fs::{read, read_to_string};
    use std::io::Read;

    fn json_of(path: &Path) -> Value {
        serde_json::from_str(&read_to_string(path.join("zarr.json")).unwrap()).unwrap()
    }

    fn chunk(path: &Path) -> Vec<u8> {
        let mut bytes = Vec::new();
        let packed = read(path).unwrap();
        GzDecoder::new(&packed[..]).read_to_end(&mut bytes).unwrap();
        bytes
    }

    #[test]
    fn levels_are_means_that_lie_where_their_voxels_do() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("dose.ome.zarr");
        let grid = VolumeGrid::centered([1, 3, 130], 0.5).about([1.0, 2.0, 3.0]);
        // The last voxels alone are not zero
        let mut dose = vec![0.0; grid.len()];
        dose[128..130].copy_from_slice(&[1.0, 2.0]);
        dose[258..260].copy_from_slice(&[3.0, 4.0]);
        write(&path, "dose", &grid, Values::F32(&dose), &Work::new()).unwrap();
        let ome = &json_of(&path)["attributes"]["ome"];
        assert_eq!(ome["version"], "0.5");
        let levels = &ome["multiscales"][0]["datasets"];
        assert_eq!(levels.as_array().unwrap().len(), 3);
        let transform = |level: usize| {
            let transforms = &levels[level]["coordinateTransformations"];
            [&transforms[0]["scale"], &transforms[1]["translation"]].map(Value::to_string)
        };
        assert_eq!(transform(0), ["[0.5,0.5,0.5]", "[3.0,1.5,-31.25]"]);
        assert_eq!(transform(1), ["[0.5,1.0,1.0]", "[3.0,1.75,-31.0]"]);
        assert_eq!(json_of(&path.join("1"))["shape"], json!([1, 2, 65]));
        // Chunks of zeros are not there; the last one is as large as all, with zeros beyond its end
        assert!(!path.join("0/c/0/0/0").exists());
        let last = chunk(&path.join("0/c/0/0/2"));
        let row =
            |values: [f32; 2]| [&values.map(f32::to_le_bytes).concat()[..], &[0; 62 * 4]].concat();
        assert_eq!(
            last,
            [row([1.0, 2.0]), row([3.0, 4.0]), row([0.0; 2])].concat()
        );
        // (1 + 2 + 3 + 4) / 4 is the second half's only voxel
        assert_eq!(chunk(&path.join("1/c/0/0/1"))[..4], 2.5f32.to_le_bytes());
    }

    #[test]
    fn a_label_is_the_one_that_most_have() {
        assert_eq!(u8::of(&[1, 2, 2, 0, 1, 2, 1, 1]), 1);
        assert_eq!(u8::of(&[1, 2]), 2);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("label.ome.zarr");
        let grid = VolumeGrid::centered([2, 2, 2], 0.5);
        write(&path, "label", &grid, Values::U8(&[1; 8]), &Work::new()).unwrap();
        assert_eq!(chunk(&path.join("0/c/0/0/0")), [1; 8]);
        assert!(!path.join("1").exists());
    }

    #[test]
    fn a_canceled_run_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let work = Work::new();
        work.cancel();
        work.cancel();
        let grid = VolumeGrid::centered([2, 2, 2], 0.5);
        let error = write(
            &folder.path().join("a.zarr"),
            "a",
            &grid,
            Values::U8(&[1; 8]),
            &work,
        );
        assert!(matches!(error, Err(tomolith_core::error::Error::Canceled)));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
