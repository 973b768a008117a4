//! A grey image as a target: values to be reproduced, drawn along z.
//!
//! Row 0 is at +y, columns grow with +x, so the image appears upright seen from above. Pixels are square,
//! `size_mm`/columns wide. A voxel's value is the mean over its area of the image: where voxels are larger than pixels,
//! pixels count with the area they share (exact); where they are smaller, values are interpolated between the middles of
//! the pixels. Beyond the image everything is 0, along z a voxel counts with the height it shares.

use super::Shape;
use super::placing::Placement;
use super::voxels::zeros;
use crate::error::{Error, Result};
use crate::grid::{Volume, VolumeGrid};
use crate::io::image::GreyPixels;
use rayon::prelude::*;

/// A placed grey image.
#[derive(Clone, Debug)]
pub struct GreyImage {
    pixels: GreyPixels,
    /// Low corner of the image, mm.
    low: [f64; 3],
    /// Edge of a pixel, mm.
    pixel: f64,
    height: f64,
}

impl GreyImage {
    /// An image `size_mm` wide, drawn over `height_mm` along z. Images are not turned: of the placement only offset and
    /// `center` count (not centred, the lower left corner of the image is the origin).
    ///
    /// # Errors
    /// [`Error::Config`] when width or height are missing or not positive, or a rotation or scale is given.
    pub fn new(
        pixels: GreyPixels,
        size_mm: Option<f64>,
        height_mm: Option<f64>,
        placement: &Placement,
    ) -> Result<Self> {
        let width = length("size_mm", size_mm, "the width of the image in mm, > 0")?;
        let height = length("height_mm", height_mm, "the height along z in mm, > 0")?;
        if placement.scale.is_some() {
            return Err(Error::config(
                "scale",
                "a scale for an image",
                "`size_mm`, the width of the image",
            ));
        }
        if placement.rotate_deg != [0.0; 3] {
            return Err(Error::config(
                "rotate_deg",
                format!("{:?} for an image", placement.rotate_deg),
                "no rotation; turn the image file instead",
            ));
        }
        if placement.offset_mm.iter().any(|v| !v.is_finite()) {
            return Err(Error::config(
                "offset_mm",
                format!("{:?}", placement.offset_mm),
                "three finite numbers [x, y, z]",
            ));
        }
        let pixel = width / pixels.columns as f64;
        let extent = [width, pixel * pixels.rows as f64, height];
        let low = std::array::from_fn(|i| {
            placement.offset_mm[i]
                - if placement.center {
                    extent[i] / 2.0
                } else {
                    0.0
                }
        });
        Ok(GreyImage {
            pixels,
            low,
            pixel,
            height,
        })
    }
}

fn length(key: &str, value: Option<f64>, accepted: &str) -> Result<f64> {
    match value {
        Some(value) if value.is_finite() && value > 0.0 => Ok(value),
        Some(value) => Err(Error::config(key, format!("{value} mm"), accepted)),
        None => Err(Error::config(key, "the key is missing", accepted)),
    }
}

/// Which pixels along an axis a voxel sees, with which weights (sum 1 when it lies in the image).
type Weights = Vec<(usize, f64)>;

/// Weights of the pixels (unit edges from 0 to `count`) in a voxel from `low` to `high`.
fn weights(low: f64, high: f64, count: usize) -> Weights {
    let end = count as f64;
    let share = (high.min(end) - low.max(0.0)) / (high - low);
    if share <= 0.0 {
        return Vec::new();
    }
    if high - low >= 1.0 {
        let (first, last) = (
            low.max(0.0) as usize,
            (high.min(end).ceil() as usize).min(count),
        );
        return (first..last)
            .map(|i| {
                let overlap = high.min(i as f64 + 1.0) - low.max(i as f64);
                (i, overlap.max(0.0) / (high - low))
            })
            .collect();
    }
    // Between the middles of two pixels; the outer half pixels are flat
    let at = ((low + high) / 2.0 - 0.5).clamp(0.0, end - 1.0);
    let i = (at as usize).min(count - 1);
    let next = (i + 1).min(count - 1);
    let part = at - i as f64;
    vec![(i, share * (1.0 - part)), (next, share * part)]
}

impl Shape for GreyImage {
    fn bounds_mm(&self) -> [[f64; 3]; 2] {
        let extent = [
            self.pixel * self.pixels.columns as f64,
            self.pixel * self.pixels.rows as f64,
            self.height,
        ];
        [self.low, std::array::from_fn(|i| self.low[i] + extent[i])]
    }

    fn sample(&self, grid: &VolumeGrid) -> Result<Volume<f32>> {
        let mut values = zeros(grid)?;
        let [_, ny, nx] = grid.shape;
        let (rows, columns) = (self.pixels.rows, self.pixels.columns);
        let half = grid.pitch_mm / 2.0;
        let along = |middle: f64, axis: usize, count: usize| {
            let middle = middle - self.low[axis];
            weights(
                (middle - half) / self.pixel,
                (middle + half) / self.pixel,
                count,
            )
        };
        let in_x: Vec<Weights> = (0..nx).map(|ix| along(grid.x(ix), 0, columns)).collect();
        let in_y: Vec<Weights> = (0..ny).map(|iy| along(grid.y(iy), 1, rows)).collect();
        let mut layer = vec![0.0f32; nx * ny];
        if values.is_empty() {
            return Ok(Volume {
                grid: grid.clone(),
                values,
            });
        }
        layer
            .par_chunks_mut(nx)
            .zip(&in_y)
            .for_each(|(line, in_y)| {
                for (value, in_x) in line.iter_mut().zip(&in_x) {
                    let sum: f64 = in_y
                        .iter()
                        .flat_map(|&(y, wy)| {
                            // Rows count from the top
                            let row = &self.pixels.values[(rows - 1 - y) * columns..][..columns];
                            in_x.iter().map(move |&(x, wx)| wy * wx * f64::from(row[x]))
                        })
                        .sum();
                    *value = sum as f32;
                }
            });
        values
            .par_chunks_mut(nx * ny)
            .enumerate()
            .for_each(|(iz, slice)| {
                let z = grid.z(iz) - self.low[2];
                let share = ((z + half).min(self.height) - (z - half).max(0.0)) / grid.pitch_mm;
                let share = share.clamp(0.0, 1.0) as f32;
                if share > 0.0 {
                    for (value, grey) in slice.iter_mut().zip(&layer) {
                        *value = grey * share;
                    }
                }
            });
        Ok(Volume {
            grid: grid.clone(),
            values,
        })
    }

    fn is_grey(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two rows, three columns: 0.1 0.2 0.3 on top (+y), 0.4 0.5 0.6 below.
    fn image(placement: &Placement) -> GreyImage {
        let pixels = GreyPixels {
            rows: 2,
            columns: 3,
            values: vec![0.1, 0.2, 0.3, 0.4, 0.5, 0.6],
        };
        GreyImage::new(pixels, Some(3.0), Some(2.0), placement).unwrap()
    }

    #[test]
    fn the_top_row_is_at_plus_y_and_columns_grow_with_x() {
        let image = image(&Placement::default());
        assert_eq!(image.bounds_mm(), [[-1.5, -1.0, -1.0], [1.5, 1.0, 1.0]]);
        let grid = VolumeGrid::centered([2, 2, 3], 1.0);
        let slice = [0.4, 0.5, 0.6, 0.1, 0.2, 0.3];
        assert_eq!(image.sample(&grid).unwrap().values, [slice, slice].concat());
        assert!(image.is_grey());
    }

    #[test]
    fn large_voxels_hold_the_mean_over_their_area_and_height() {
        let image = image(&Placement::default());
        // x from −2 to 2, y from −2 to 2, z from −2 to 2: the sum of all pixels over 16 mm², half the height
        let one = image.sample(&VolumeGrid::centered([1, 1, 1], 4.0)).unwrap();
        assert!((one.values[0] - 2.1 / 16.0 / 2.0).abs() < 1e-7);
        // Half of the left and half of the middle column
        let grid = VolumeGrid {
            shape: [1, 1, 1],
            pitch_mm: 1.0,
            center_mm: [-0.5, 0.5, 0.0],
        };
        assert!((image.sample(&grid).unwrap().values[0] - 0.15).abs() < 1e-7);
    }

    #[test]
    fn small_voxels_are_interpolated() {
        let image = image(&Placement::default());
        let at = |x: f64, y: f64| {
            let grid = VolumeGrid {
                shape: [1, 1, 1],
                pitch_mm: 1e-3,
                center_mm: [x, y, 0.0],
            };
            image.sample(&grid).unwrap().values[0]
        };
        assert!((at(-1.0, 0.5) - 0.1).abs() < 1e-6); // the middle of a pixel
        assert!((at(-0.75, 0.5) - 0.125).abs() < 1e-6); // a quarter of the way to the next
        assert!((at(-1.0, 0.0) - 0.25).abs() < 1e-6); // between the rows
        assert!((at(-1.4, 0.9) - 0.1).abs() < 1e-6); // the outer half pixel is flat
        assert_eq!(at(-1.6, 0.5), 0.0);
    }

    #[test]
    fn images_need_width_and_height() {
        let pixels = GreyPixels {
            rows: 1,
            columns: 1,
            values: vec![1.0],
        };
        let placement = Placement::default();
        let refused = |size, height| {
            GreyImage::new(pixels.clone(), size, height, &placement)
                .unwrap_err()
                .to_string()
        };
        assert!(refused(None, Some(1.0)).starts_with("size_mm: the key is missing"));
        assert!(refused(Some(1.0), Some(-1.0)).starts_with("height_mm: -1 mm"));
    }
}
