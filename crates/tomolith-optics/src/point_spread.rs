//! How a projector spreads the light of a pixel over its neighbors: a measured point spread function.
//!
//! A pixel that shows x lights the pixel i rows below and j columns to its right with x·K\[i, j\]. Light is spread over the image, not made or lost: Σ K = 1.
//!
//! ```text
//! lit[r, c] = Σ_ij K[i, j]·x[r − i, c − j]
//! ```
//!
//! # Files ([`PointSpread::read`])
//! | file | holds |
//! |---|---|
//! | `.png`, `.tif`, `.npy` | the image of one lit pixel, one number per pixel of the light, row 0 on top (+z) and columns as in patterns (along u); the lit pixel is in the middle, so rows and columns are odd numbers |
//! | `.csv`, `.txt` | two columns, radius in mm from 0 on and light per area there, for a spread that is round; linear between the radii, 0 beyond the last |
//!
//! Any scale will do, since the sum is divided out. The dark level of a camera must be taken away before: it would be light that is spread evenly.
//!
//! **Limits** One spread for the whole image and all depths: it is that of a projector in focus. Light that is spread beyond the image's edge is lost.
//!
//! ```
//! use tomolith_optics::point_spread::PointSpread;
//! // Half stays, a quarter goes to either side
//! let spread = PointSpread::new([3, 1], &[1.0, 2.0, 1.0]).unwrap();
//! assert_eq!((spread.reach(), spread.at(0, -1), spread.at(0, 0)), ([1, 0], 0.25, 0.5));
//! ```

use crate::exposure::maps::read_plane;
use std::path::Path;
use tomolith_core::columns::read_pairs;
use tomolith_core::error::{Error, Result};
use tomolith_core::units::exact;

/// Light per pixel round a lit one; the sum is 1.
#[derive(Clone, Debug, PartialEq)]
pub struct PointSpread {
    /// Columns and rows on either side of the middle.
    reach: [usize; 2],
    /// `[row][column]`, row 0 on top.
    values: Vec<f32>,
}

/// Most columns or rows of a spread.
const MOST: usize = 255;
/// Places along and across a pixel at which a profile is looked up.
const PLACES: usize = 9;

impl PointSpread {
    /// The image of a lit pixel, `[row][column]` with the lit one in the middle, of this size `[columns, rows]`; in any scale.
    ///
    /// # Errors
    /// What is wrong with it and what is accepted, as [`Error::Config`] at `psf`: a size that has no middle, numbers that are negative or not finite, no light at all.
    pub fn new(size: [usize; 2], values: &[f32]) -> Result<Self> {
        let [columns, rows] = size;
        let bad = |found: String, accepted: &str| Err(Error::config("psf", found, accepted));
        let is_odd = |n: usize| n % 2 == 1 && n <= MOST;
        if !is_odd(columns) || !is_odd(rows) || values.len() != columns * rows {
            let found = format!("{columns} × {rows} pixels");
            return bad(
                found,
                "odd numbers of columns and rows, 255 at most: the lit pixel is in the middle",
            );
        }
        let is_light = |v: &f32| v.is_finite() && *v >= 0.0;
        if let Some(i) = values.iter().position(|v| !is_light(v)) {
            let place = [i / columns, i % columns];
            let found = format!("{} in row {}, column {}", values[i], place[0], place[1]);
            return bad(found, "finite numbers, 0 or more");
        }
        let sum: f64 = values.iter().map(|&v| f64::from(v)).sum();
        if sum <= 0.0 {
            return bad(
                "no light: all is 0".to_owned(),
                "light in at least one pixel",
            );
        }
        let share = |&v: &f32| (f64::from(v) / sum) as f32;
        Ok(PointSpread {
            reach: [columns / 2, rows / 2],
            values: values.iter().map(share).collect(),
        })
    }

    /// A round spread: light per area over the radius, `[mm, light]`, on pixels of this size [u, z].
    ///
    /// # Errors
    /// As [`new`](Self::new); radii that do not begin at 0 and rise.
    pub fn round(profile: &[[f64; 2]], pitch_mm: [f64; 2]) -> Result<Self> {
        let bad = |found: String, accepted: &str| Err(Error::config("psf", found, accepted));
        let rises = profile.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        let (Some([first, _]), Some([last, _])) = (profile.first(), profile.last()) else {
            return bad("no radii".to_owned(), "two columns, radius in mm and light");
        };
        if profile.len() < 2 {
            let found = format!("a single radius, {} mm", exact(*first));
            let accepted = "two rows or more, radius in mm and light: the spread is linear between them and 0 beyond the last. Without a spread leave the key out";
            return bad(found, accepted);
        }
        if *first != 0.0 || !rises || !last.is_finite() {
            let found = format!("radii from {} to {} mm", exact(*first), exact(*last));
            return bad(found, "radii that begin at 0 and rise");
        }
        if let Some([radius, light]) = profile.iter().find(|p| !(p[1].is_finite() && p[1] >= 0.0)) {
            let found = format!("{} at {} mm", exact(*light), exact(*radius));
            return bad(found, "finite numbers, 0 or more");
        }
        let reach = pitch_mm.map(|mm| (last / mm - 0.5).ceil().max(0.0) as usize);
        let size = reach.map(|n| 2 * n + 1);
        if size.iter().any(|&n| n > MOST) {
            let found = format!("{} mm are {} × {} pixels", exact(*last), size[0], size[1]);
            return bad(found, "255 pixels across at most");
        }
        let values = (0..size[0] * size[1]).map(|i| {
            let middle = [i % size[0], i / size[0]];
            let offset: [f64; 2] = std::array::from_fn(|k| middle[k] as f64 - reach[k] as f64);
            mean_of_pixel(profile, offset, pitch_mm) as f32
        });
        PointSpread::new(size, &values.collect::<Vec<_>>())
    }

    /// What a file holds, for pixels of this size [u, z].
    ///
    /// # Errors
    /// As [`new`](Self::new) and [`round`](Self::round); [`Error::Io`] and [`Error::Format`] of the file.
    pub fn read(path: &Path, pitch_mm: [f64; 2]) -> Result<Self> {
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        if ["csv", "txt"].contains(&extension.to_ascii_lowercase().as_str()) {
            return Self::round(&read_pairs(path, "radius and light")?, pitch_mm);
        }
        let ([rows, columns], values) = read_plane(path)?;
        Self::new([columns, rows], &values)
    }

    /// Columns and rows on either side of the middle.
    #[must_use]
    pub fn reach(&self) -> [usize; 2] {
        self.reach
    }

    /// Share of a pixel's light so many rows below and columns beside it, within the [reach](Self::reach).
    #[must_use]
    pub fn at(&self, down: isize, along: isize) -> f32 {
        let row = self.reach[1].checked_add_signed(down);
        let column = self.reach[0].checked_add_signed(along);
        let [columns, rows] = self.reach.map(|n| 2 * n + 1);
        match (row, column) {
            (Some(row), Some(column)) if row < rows && column < columns => {
                self.values[row * columns + column]
            }
            _ => 0.0,
        }
    }

    /// The spread on pixels so many times as large.
    #[must_use]
    pub fn coarser(&self, factor: usize) -> Self {
        let reach = self.reach.map(|n| (n + factor / 2).div_ceil(factor));
        let columns = 2 * reach[0] + 1;
        let mut values = vec![0.0f32; columns * (2 * reach[1] + 1)];
        let [u, z] = [0, 1].map(|axis| shares(self.reach[axis], reach[axis], factor));
        for (row, to_rows) in z.iter().enumerate() {
            for (column, to_columns) in u.iter().enumerate() {
                let value = self.values[row * u.len() + column];
                for (to_row, of_row) in to_rows {
                    for (to_column, of_column) in to_columns {
                        values[to_row * columns + to_column] += value * of_row * of_column;
                    }
                }
            }
        }
        PointSpread { reach, values }
    }
}

/// Of every fine pixel across a spread: which of the coarse ones it lies on, and which share of it.
fn shares(fine: usize, coarse: usize, factor: usize) -> Vec<Vec<(usize, f32)>> {
    let factor = factor as f64;
    let shares_of = |i: usize| {
        // In coarse pixels, counted from the lower edge of the first
        let middle = (i as f64 - fine as f64) / factor + coarse as f64 + 0.5;
        let [low, high] = [-0.5, 0.5].map(|half| middle + half / factor);
        let covered = |to: usize| (high.min(to as f64 + 1.0) - low.max(to as f64)) * factor;
        let all = (0..2 * coarse + 1).map(|to| (to, covered(to) as f32));
        all.filter(|(_, share)| *share > 0.0).collect()
    };
    (0..2 * fine + 1).map(shares_of).collect()
}

/// Mean of a profile over the pixel at this place, in pixels from the lit one.
fn mean_of_pixel(profile: &[[f64; 2]], offset: [f64; 2], pitch_mm: [f64; 2]) -> f64 {
    let within = |i: usize| (i as f64 + 0.5) / PLACES as f64 - 0.5;
    let all = (0..PLACES * PLACES).map(|i| {
        let u = (offset[0] + within(i % PLACES)) * pitch_mm[0];
        let z = (offset[1] + within(i / PLACES)) * pitch_mm[1];
        light_at(profile, u.hypot(z))
    });
    all.sum::<f64>() / (PLACES * PLACES) as f64
}

/// A profile between its points; 0 beyond the last.
fn light_at(profile: &[[f64; 2]], radius: f64) -> f64 {
    let above = profile.partition_point(|point| point[0] <= radius);
    let Some(&[high, after]) = profile.get(above) else {
        return 0.0;
    };
    let [low, before] = profile[above - 1];
    before + (after - before) * (radius - low) / (high - low)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sum(spread: &PointSpread) -> f64 {
        spread.values.iter().map(|&v| f64::from(v)).sum()
    }

    #[test]
    fn a_round_spread_has_the_width_of_its_profile() {
        // A Gaussian of σ = 0.1 mm on pixels of 0.05 × 0.08 mm: of its variance the pixel adds pitch²/12
        let sigma = 0.1f64;
        let light = |i: usize| {
            let radius = 0.002 * i as f64;
            [radius, (-0.5 * (radius / sigma).powi(2)).exp()]
        };
        let profile: Vec<_> = (0..=300).map(light).collect();
        let pitch = [0.05, 0.08];
        let spread = PointSpread::round(&profile, pitch).unwrap();
        assert!((sum(&spread) - 1.0).abs() < 1e-6);
        let [columns, rows] = spread.reach().map(|n| n as isize);
        let mut variance = [0.0; 2];
        for row in -rows..=rows {
            for column in -columns..=columns {
                let share = f64::from(spread.at(row, column));
                variance[0] += share * (column as f64 * pitch[0]).powi(2);
                variance[1] += share * (row as f64 * pitch[1]).powi(2);
            }
        }
        for (found, pitch) in variance.into_iter().zip(pitch) {
            let expected = sigma.powi(2) + pitch.powi(2) / 12.0;
            assert!((found / expected - 1.0).abs() < 5e-3, "{found} {expected}");
        }
    }

    #[test]
    fn coarser_pixels_get_all_of_the_light_where_it_was() {
        let values: Vec<f32> = (0..15).map(|i| 1.0 + i as f32).collect();
        let spread = PointSpread::new([5, 3], &values).unwrap();
        let coarser = spread.coarser(2);
        assert!((sum(&coarser) - 1.0).abs() < 1e-6);
        // The mean column of the light, in pixels of either
        let mean = |spread: &PointSpread| {
            let [columns, rows] = spread.reach().map(|n| n as isize);
            let all = (-rows..=rows).flat_map(|r| (-columns..=columns).map(move |c| (r, c)));
            all.map(|(r, c)| f64::from(spread.at(r, c)) * c as f64)
                .sum::<f64>()
        };
        assert!((2.0 * mean(&coarser) - mean(&spread)).abs() < 1e-6);
        assert_eq!(spread.coarser(1), spread);
    }

    #[test]
    fn what_is_no_spread_is_refused_with_what_was_found() {
        let refused =
            |size, values: &[f32]| PointSpread::new(size, values).unwrap_err().to_string();
        for (size, values, word) in [
            ([2, 1], &[1.0, 1.0][..], "2 × 1 pixels"),
            ([3, 1], &[1.0, -0.5, 1.0], "-0.5 in row 0, column 1"),
            ([1, 3], &[1.0, 1.0, f32::NAN], "NaN in row 2, column 0"),
            ([3, 1], &[0.0; 3], "no light"),
        ] {
            let message = refused(size, values);
            assert!(
                message.starts_with("psf") && message.contains(word),
                "{message}"
            );
        }
        let round = |profile: &[[f64; 2]]| {
            let refused = PointSpread::round(profile, [0.1, 0.1]);
            refused.unwrap_err().to_string()
        };
        for (profile, word) in [
            (&[][..], "no radii"),
            (&[[0.1, 1.0], [0.2, 0.0]], "radii from 0.1 to 0.2 mm"),
            (&[[0.0, 1.0], [0.1, -1.0]], "-1 at 0.1 mm"),
            (&[[0.0, 0.0], [0.1, 0.0]], "no light"),
            (&[[0.0, 1.0], [20.0, 0.0]], "401 × 401 pixels"),
        ] {
            let message = round(profile);
            assert!(message.contains(word), "{message}");
        }
    }

    #[test]
    fn files_of_every_kind_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("round.csv"), "# mm, light\n0, 1\n0.1, 0\n").unwrap();
        let round = PointSpread::read(&at("round.csv"), [0.1, 0.1]).unwrap();
        assert_eq!(round.reach(), [1, 1]);
        assert!((sum(&round) - 1.0).abs() < 1e-6 && round.at(0, 1) == round.at(-1, 0));
        let floats = [0.0f32, 3.0, 1.0].map(f32::to_le_bytes).concat();
        let header = "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 1), }";
        let header = format!("{header:<117}\n");
        let bytes = [b"\x93NUMPY\x01\x00\x76\x00", header.as_bytes(), &floats].concat();
        std::fs::write(at("up.npy"), bytes).unwrap();
        let up = PointSpread::read(&at("up.npy"), [0.1, 0.1]).unwrap();
        assert_eq!((up.at(-1, 0), up.at(0, 0), up.at(1, 0)), (0.0, 0.75, 0.25));
        std::fs::write(at("bad.csv"), "0 1 2\n").unwrap();
        assert!(PointSpread::read(&at("bad.csv"), [0.1, 0.1]).is_err());
        assert!(PointSpread::read(&at("none.png"), [0.1, 0.1]).is_err());
    }
}
