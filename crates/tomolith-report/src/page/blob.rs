//! Arrays as the page holds them: reduced to what a file can carry, 8 bits a value, deflated (zlib, whose checksum tells a damaged array), in base64.
//!
//! A value is `low + code/top·(high − low)`, where `top` is 255, or 254 where 255 stands for no value.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::{Compression, write::ZlibEncoder};
use std::io::{Read as _, Write as _};
use std::ops::Range;
use tomolith_core::grid::{Patterns, VolumeGrid};
use tomolith_core::parallel::InParallel;

/// The code of "no value".
pub(super) const NOTHING: u8 = 255;

/// Values as codes of 8 bits.
pub(super) struct Codes {
    pub(super) codes: Vec<u8>,
    pub(super) low: f64,
    pub(super) high: f64,
    /// Whether [`NOTHING`] stands for values that are no number.
    pub(super) has_gaps: bool,
}

impl Codes {
    /// The codes of some values between the least and the largest of them.
    pub(super) fn of(values: &[f32]) -> Self {
        let finite = || values.iter().copied().filter(|v| v.is_finite());
        let [low, high] = [f32::min, f32::max].map(|end| finite().reduce(end).unwrap_or(0.0));
        let has_gaps = values.iter().any(|v| !v.is_finite());
        let top = if has_gaps { 254.0 } else { 255.0 };
        let (low, high) = (f64::from(low), f64::from(high));
        let per_code = if high > low { top / (high - low) } else { 0.0 };
        let code = |v: f32| match v.is_finite() {
            true => ((f64::from(v) - low) * per_code).round() as u8,
            false => NOTHING,
        };
        Codes {
            codes: values.iter().map(|&v| code(v)).collect(),
            low,
            high,
            has_gaps,
        }
    }
}

/// A grid whose voxels join `factor` of another one's along each edge; at its far ends they may reach beyond it.
pub(super) fn reduced_grid(grid: &VolumeGrid, factor: usize) -> VolumeGrid {
    let shape = grid.shape.map(|n| n.div_ceil(factor));
    let scale = factor as f64;
    let beyond =
        |axis: usize, edge: f64| 0.5 * edge * (shape[axis] * factor - grid.shape[axis]) as f64;
    VolumeGrid {
        shape,
        pitch_mm: grid.pitch_mm * scale,
        height_mm: grid.height_mm * scale,
        center_mm: [
            grid.center_mm[0] + beyond(2, grid.pitch_mm),
            grid.center_mm[1] + beyond(1, grid.pitch_mm),
            grid.center_mm[2] + beyond(0, grid.height_mm),
        ],
    }
}

/// What `reduce` makes of each block of `factor`³ voxels, in the order of the array. It gets the positions of the block's rows.
pub(super) fn blocks<T: Send>(
    grid: &VolumeGrid,
    factor: usize,
    reduce: impl Fn(&[Range<usize>]) -> T + Sync,
) -> Vec<T> {
    let [nz, ny, nx] = grid.shape;
    let part = |i: usize, n: usize| i * factor..((i + 1) * factor).min(n);
    let slices: Vec<Vec<T>> = (0..nz.div_ceil(factor)).par_map(|z| {
        let mut rows = Vec::with_capacity(factor * factor);
        let mut found = Vec::with_capacity(ny.div_ceil(factor) * nx.div_ceil(factor));
        for y in 0..ny.div_ceil(factor) {
            for x in 0..nx.div_ceil(factor) {
                rows.clear();
                for iz in part(z, nz) {
                    for iy in part(y, ny) {
                        let row = (iz * ny + iy) * nx;
                        let across = part(x, nx);
                        rows.push(row + across.start..row + across.end);
                    }
                }
                found.push(reduce(&rows));
            }
        }
        found
    });
    slices.into_iter().flatten().collect()
}

/// The mean of each block of `factor`³ voxels, of its values that are numbers, in the order of the array; NaN where there is none.
pub(super) fn means(grid: &VolumeGrid, values: &[f32], factor: usize) -> Vec<f32> {
    let [nz, ny, nx] = grid.shape;
    let across = nx.div_ceil(factor);
    let layers: Vec<Vec<f32>> = (0..nz.div_ceil(factor)).par_map(|z| {
        let mut sums = vec![(0.0, 0u32); ny.div_ceil(factor) * across];
        // Row by row, as they lie in memory
        for slice in values.chunks(ny * nx).skip(z * factor).take(factor) {
            for (y, row) in slice.chunks(nx).enumerate() {
                let sums = &mut sums[y / factor * across..];
                for (part, (sum, count)) in row.chunks(factor).zip(sums) {
                    for value in part.iter().filter(|value| value.is_finite()) {
                        *sum += f64::from(*value);
                        *count += 1;
                    }
                }
            }
        }
        let mean = |(sum, count)| (sum / f64::from(count)) as f32;
        sums.into_iter().map(mean).collect()
    });
    layers.concat()
}

/// The most frequent code of each block; of equally frequent ones the highest.
pub(super) fn majorities(grid: &VolumeGrid, codes: &[u8], factor: usize) -> Vec<u8> {
    blocks(grid, factor, |rows| {
        let first = codes[rows[0].start];
        // Most blocks lie away from every surface
        let is_even = |row: &Range<usize>| codes[row.clone()].iter().all(|&code| code == first);
        if rows.iter().all(is_even) {
            return first;
        }
        let mut counts = [0u32; 256];
        let mut best = (0, 0);
        for row in rows {
            for &code in &codes[row.clone()] {
                let count = &mut counts[usize::from(code)];
                *count += 1;
                best = best.max((*count, code));
            }
        }
        best.1
    })
}

/// Patterns reduced to fewer frames and pixels.
pub(super) struct Film {
    pub(super) frames: Vec<usize>,
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) binned: usize,
    pub(super) codes: Vec<u8>,
}

impl Film {
    /// Every n-th frame of patterns, and means of n × n pixels, so that at most so many pixels are left. `white` gets 255.
    pub(super) fn of(patterns: &Patterns, white: f32, most: usize) -> Self {
        let [frames, rows, columns] = patterns.grid.shape();
        // Fewer frames first, down to 180 of a turn, then fewer pixels
        let pixels = |every: usize, binned: usize| {
            frames.div_ceil(every) * rows.div_ceil(binned) * columns.div_ceil(binned)
        };
        let few = (frames / 180).max(1);
        let every = (1..few).find(|&every| pixels(every, 1) <= most);
        let every = every.unwrap_or(few);
        let mut binned = 1;
        while pixels(every, binned) > most && binned < rows.max(columns) {
            binned += 1;
        }
        let shown: Vec<usize> = (0..frames).step_by(every).collect();
        let per_code = if white > 0.0 { 255.0 / white } else { 0.0 };
        let codes: Vec<Vec<u8>> = (shown.iter()).par_map(|&k| {
            let slice = VolumeGrid::centered([1, rows, columns], 1.0);
            let code = |mean: f32| (mean * per_code).round().clamp(0.0, 255.0) as u8;
            let frame = patterns.frame(k);
            means(&slice, frame, binned).into_iter().map(code).collect()
        });
        Film {
            frames: shown,
            rows: rows.div_ceil(binned),
            columns: columns.div_ceil(binned),
            binned,
            codes: codes.concat(),
        }
    }
}

/// Bytes as zlib packs them.
pub(super) fn deflate(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::new(6));
    // Writing into a vector cannot fail
    let deflated = encoder.write_all(bytes).and_then(|()| encoder.finish());
    deflated.unwrap_or_default()
}

/// Bytes as text of the page: deflated, in base64.
pub(super) fn packed(bytes: &[u8]) -> String {
    STANDARD.encode(deflate(bytes))
}

/// Deflated bytes of text of the page; None where it is no base64.
#[must_use]
pub fn deflated(text: &str) -> Option<Vec<u8>> {
    STANDARD.decode(text.trim()).ok()
}

/// The bytes of text of the page; None where it is no such text.
#[must_use]
pub fn unpacked(text: &str) -> Option<Vec<u8>> {
    let (packed, mut bytes) = (deflated(text)?, Vec::new());
    let mut decoder = flate2::read::ZlibDecoder::new(packed.as_slice());
    decoder.read_to_end(&mut bytes).ok()?;
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::PatternGrid;

    #[test]
    fn values_come_back_within_half_a_code_and_gaps_stay_gaps() {
        let values = [-1.0, 0.3, f32::NAN, 4.0];
        let Codes {
            codes,
            low,
            high,
            has_gaps,
        } = Codes::of(&values);
        assert_eq!((low, high, has_gaps, codes[2]), (-1.0, 4.0, true, NOTHING));
        for i in [0, 1, 3] {
            let back = low + f64::from(codes[i]) / 254.0 * (high - low);
            assert!((back - f64::from(values[i])).abs() <= 0.5 * 5.0 / 254.0);
        }
        let flat = Codes::of(&[2.0; 3]);
        assert_eq!((flat.low, flat.codes), (2.0, vec![0; 3]));
    }

    #[test]
    fn blocks_at_the_ends_hold_what_is_there_and_keep_their_places() {
        let grid = VolumeGrid {
            height_mm: 0.2,
            ..VolumeGrid::centered([3, 2, 5], 0.1)
        };
        let values: Vec<f32> = (0..30).map(|i| i as f32).collect();
        let halved = reduced_grid(&grid, 2);
        assert_eq!((halved.shape, halved.height_mm), ([2, 1, 3], 0.4));
        // The corner at low x, y, z stays where it is
        let corner = |g: &VolumeGrid| [g.x(0) - 0.5 * g.pitch_mm, g.z(0) - 0.5 * g.height_mm];
        let (from, to) = (corner(&grid), corner(&halved));
        assert!((from[0] - to[0]).abs() < 1e-12 && (from[1] - to[1]).abs() < 1e-12);
        let mean = means(&grid, &values, 2);
        // z 0 and 1, y 0 and 1, x 0 and 1: 0, 1, 5, 6, 10, 11, 15, 16; the last: z = 2, x = 4
        assert_eq!((mean[0], mean[5]), (8.0, 26.5));
        assert_eq!(majorities(&grid, &[7; 30], 2), [7; 6]);
        // Three of eight are 9, three 4: the higher one; the last block has a single voxel
        let mut codes = [0; 30];
        for i in [0, 1, 5] {
            codes[i] = 9;
        }
        for i in [6, 10, 11] {
            codes[i] = 4;
        }
        codes[24] = 2;
        assert_eq!(majorities(&grid, &codes, 2), [9, 0, 0, 0, 0, 2]);
    }

    #[test]
    fn films_keep_white_and_what_is_packed_comes_back() {
        let mut patterns = Patterns::dark(PatternGrid::full_turn(3, 0.0, 2, 2, 0.1));
        patterns.values[5] = 4.0;
        let film = Film::of(&patterns, 4.0, 100);
        assert_eq!((film.frames.len(), film.binned, film.codes[5]), (3, 1, 255));
        let large = Patterns::dark(PatternGrid::full_turn(720, 0.0, 200, 300, 0.1));
        let film = Film::of(&large, 1.0, 3_000_000);
        assert!(film.codes.len() <= 3_000_000 && film.frames.len() >= 180);
        assert_eq!(unpacked(&packed(&film.codes)), Some(film.codes));
        assert_eq!(unpacked("no base64!"), None);
        // A byte that was changed on the way is noticed wherever it lies, but for bits that only fill up a byte
        let whole = deflate(&[7; 1000]);
        for place in 2..whole.len() {
            let mut damaged = whole.clone();
            damaged[place] ^= 4;
            let found = unpacked(&STANDARD.encode(&damaged));
            assert!(found.is_none_or(|bytes| bytes == [7; 1000]), "byte {place}");
        }
    }
}
