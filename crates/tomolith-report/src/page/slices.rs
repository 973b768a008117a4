//! Slices of a large volume, one at a time: what a page asks a server for.

use serde_json::json;
use std::path::Path;
use tomolith_core::error::Result;
use tomolith_core::parallel::InParallel;
use tomolith_io::npy::read_volume;

/// A volume from which slices are cut.
#[derive(Clone, Debug)]
pub struct VolumeSlices {
    shape: [usize; 3],
    values: Vec<f32>,
    low: f32,
    high: f32,
}

/// Values that one thread looks through at a time.
const BLOCK: usize = 1 << 20;

impl VolumeSlices {
    /// Those of an array of numbers in a file.
    ///
    /// # Errors
    /// As [`read_volume`].
    pub fn read(path: &Path) -> Result<Self> {
        let (shape, values) = read_volume(path)?;
        Ok(Self::of(shape, values))
    }

    fn of(shape: [usize; 3], values: Vec<f32>) -> Self {
        let ends = values.chunks(BLOCK).par_map(|block| {
            let finite = || block.iter().copied().filter(|v| v.is_finite());
            [
                finite().fold(f32::INFINITY, f32::min),
                finite().fold(f32::NEG_INFINITY, f32::max),
            ]
        });
        let low = ends.iter().fold(f32::INFINITY, |low, end| low.min(end[0]));
        let high = ends
            .iter()
            .fold(f32::NEG_INFINITY, |high, end| high.max(end[1]));
        VolumeSlices {
            shape,
            values,
            low,
            high,
        }
    }

    /// A slice across an array axis: a line of JSON (`shape`, `low`, `high`, `bits`), then 16 bits a voxel, little endian, between the least and the
    /// largest value of the whole volume. None where there is no such slice.
    #[must_use]
    pub fn cut(&self, axis: usize, index: usize) -> Option<Vec<u8>> {
        let [nz, ny, nx] = self.shape;
        if index >= *self.shape.get(axis)? {
            return None;
        }
        let (shape, steps, start) = match axis {
            0 => ([ny, nx], [nx, 1], index * ny * nx),
            1 => ([nz, nx], [ny * nx, 1], index * nx),
            _ => ([nz, ny], [ny * nx, nx], index),
        };
        let (low, high) = (self.low, self.high);
        let per_code = if high > low {
            f32::from(u16::MAX) / (high - low)
        } else {
            0.0
        };
        let header = json!({ "shape": shape, "low": low, "high": high, "bits": 16 });
        let mut bytes = format!("{header}\n").into_bytes();
        bytes.reserve(2 * shape[0] * shape[1]);
        for row in 0..shape[0] {
            for column in 0..shape[1] {
                let value = self.values[start + row * steps[0] + column * steps[1]];
                let code = ((value - low) * per_code).round() as u16;
                bytes.extend(code.to_le_bytes());
            }
        }
        Some(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    #[test]
    fn slices_across_each_axis_hold_their_voxels() {
        let volume = VolumeSlices::of([2, 3, 4], (0..24u8).map(f32::from).collect());
        for (axis, index, expected) in [
            (0, 1, (12..24).collect::<Vec<u32>>()),
            (1, 2, vec![8, 9, 10, 11, 20, 21, 22, 23]),
            (2, 3, vec![3, 7, 11, 15, 19, 23]),
        ] {
            let bytes = volume.cut(axis, index).unwrap();
            let end = bytes.iter().position(|b| *b == b'\n').unwrap() + 1;
            let header: Value = serde_json::from_slice(&bytes[..end]).unwrap();
            assert_eq!(
                (&header["low"], &header["high"]),
                (&json!(0.0), &json!(23.0))
            );
            let codes = bytes[end..]
                .chunks(2)
                .map(|b| u16::from_le_bytes([b[0], b[1]]));
            let values = codes.map(|code| (f32::from(code) * 23.0 / 65535.0).round() as u32);
            assert_eq!(values.collect::<Vec<_>>(), expected);
        }
        assert_eq!((volume.cut(0, 2), volume.cut(3, 0)), (None, None));
    }
}
