//! A gray image as a target: values to be reproduced, drawn along z; or a stack of slices, the first one at the bottom.
//!
//! Row 0 is at +y, columns grow with +x, so the image appears upright seen from above. Pixels are square,
//! `size_mm`/columns wide. A voxel's value is the mean over its area of the image: where voxels are larger than pixels,
//! pixels count with the area they share (exact); where they are smaller, values are interpolated between the middles of
//! the pixels; along z slices are treated in the same way. Beyond the image everything is 0.

use super::Shape;
use super::placing::Placement;
use super::voxels::zeros;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::parallel::InParallel;
use tomolith_core::units::Mm;
use tomolith_core::work::Work;
use tomolith_io::image::GrayPixels;

/// A placed gray image, or a stack of them.
#[derive(Clone, Debug)]
pub struct GrayImage {
    /// From the bottom up, all of one size.
    slices: Vec<GrayPixels>,
    is_gray: bool,
    /// Low corner of the image, mm.
    low: [f64; 3],
    /// Edge of a pixel, mm.
    pixel: f64,
    height: f64,
    /// How its files were read.
    note: Option<String>,
}

impl GrayImage {
    /// Slices `size_mm` wide that fill `height_mm` along z, from the bottom up; one slice is an image drawn along z. Images are not turned: of the placement only offset and
    /// `center` count (not centered, the lower left corner of the image is the origin).
    ///
    /// # Errors
    /// [`Error::Config`] when width or height are missing or not positive, a rotation or scale is given, or there is no
    /// slice; [`Error::Shape`] for slices of different sizes.
    pub fn new(
        slices: Vec<GrayPixels>,
        size_mm: Option<f64>,
        height_mm: Option<f64>,
        placement: &Placement,
    ) -> Result<Self> {
        let [width, height] = lengths(size_mm, height_mm)?;
        if placement.scale.is_some() {
            return Err(Error::config(
                "scale",
                "a scale for an image",
                "`size_mm`, the width of the image or of the stack",
            ));
        }
        if placement.rotate_deg != [0.0; 3] {
            return Err(Error::config(
                "rotate_deg",
                format!("{:?} for an image", placement.rotate_deg),
                "no rotation; turn the image file instead",
            ));
        }
        placement.check()?;
        let Some(first) = slices.first() else {
            return Err(Error::config("stack", "no slice", "at least one image"));
        };
        let (rows, columns) = (first.rows, first.columns);
        if let Some(other) = slices
            .iter()
            .find(|s| (s.rows, s.columns) != (rows, columns))
        {
            return Err(Error::shape(
                "a slice",
                vec![rows, columns],
                vec![other.rows, other.columns],
            ));
        }
        let pixel = width / columns as f64;
        let extent = [width, pixel * rows as f64, height];
        let low = std::array::from_fn(|i| {
            let middle = if placement.center {
                extent[i] / 2.0
            } else {
                0.0
            };
            placement.offset_mm[i] - middle
        });
        Ok(GrayImage {
            slices,
            is_gray: true,
            low,
            pixel,
            height,
            note: None,
        })
    }

    /// Whether its values are to be reproduced (as by default), or are shares of a part.
    #[must_use]
    pub fn as_gray(mut self, is_gray: bool) -> Self {
        self.is_gray = is_gray;
        self
    }

    /// With what people should know of how its files were read.
    #[must_use]
    pub(crate) fn noting(mut self, note: Option<String>) -> Self {
        self.note = note;
        self
    }

    /// Rows and columns.
    fn size(&self) -> [usize; 2] {
        [self.slices[0].rows, self.slices[0].columns]
    }
}

/// Width and height of an image or a stack, mm, both of which it needs.
pub(crate) fn lengths(size_mm: Option<f64>, height_mm: Option<f64>) -> Result<[f64; 2]> {
    let width = "the width of the image, or of the stack, in mm, > 0";
    let height = "the height along z in mm, > 0";
    Ok([
        length("size_mm", size_mm, width)?,
        length("height_mm", height_mm, height)?,
    ])
}

fn length(key: &str, value: Option<f64>, accepted: &str) -> Result<f64> {
    match value {
        Some(value) if value.is_finite() && value > 0.0 => Ok(value),
        Some(value) => Err(Error::config(key, Mm(value).to_string(), accepted)),
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

/// Adds a slice, seen by voxels with these weights, times `share` to a layer `[y, x]`.
fn add_layer(
    slice: &GrayPixels,
    in_x: &[Weights],
    in_y: &[Weights],
    share: f64,
    layer: &mut [f32],
) {
    for (line, in_y) in layer.chunks_mut(in_x.len()).zip(in_y) {
        for (value, in_x) in line.iter_mut().zip(in_x) {
            let sum: f64 = in_y
                .iter()
                .flat_map(|&(y, wy)| {
                    // Rows count from the top
                    let row =
                        &slice.values[(slice.rows - 1 - y) * slice.columns..][..slice.columns];
                    in_x.iter().map(move |&(x, wx)| wy * wx * f64::from(row[x]))
                })
                .sum();
            *value += (share * sum) as f32;
        }
    }
}

impl Shape for GrayImage {
    fn bounds_mm(&self) -> [[f64; 3]; 2] {
        let [rows, columns] = self.size().map(|n| self.pixel * n as f64);
        let extent = [columns, rows, self.height];
        [self.low, std::array::from_fn(|i| self.low[i] + extent[i])]
    }

    fn pixel_mm(&self) -> Option<f64> {
        Some(self.pixel)
    }

    fn upright_mm(&self) -> Option<[f64; 2]> {
        let [low, high] = self.bounds_mm().map(|corner| corner[2]);
        (self.slices.len() == 1).then_some([low, high])
    }

    fn sample_under(&self, grid: &VolumeGrid, work: &Work) -> Result<Volume<f32>> {
        let mut values = zeros(grid)?;
        let [_, ny, nx] = grid.shape;
        let [rows, columns] = self.size();
        let half = grid.pitch_mm / 2.0;
        let along = |middle: f64, axis: usize, edge: f64, count: usize| {
            let middle = middle - self.low[axis];
            weights((middle - half) / edge, (middle + half) / edge, count)
        };
        let in_x: Vec<Weights> = (0..nx)
            .map(|ix| along(grid.x(ix), 0, self.pixel, columns))
            .collect();
        let in_y: Vec<Weights> = (0..ny)
            .map(|iy| along(grid.y(iy), 1, self.pixel, rows))
            .collect();
        let count = self.slices.len();
        let thick = self.height / count as f64;
        // One image is resampled once, a stack at every height
        let single = (count == 1).then(|| {
            let mut layer = vec![0.0; nx * ny];
            add_layer(&self.slices[0], &in_x, &in_y, 1.0, &mut layer);
            layer
        });
        if !values.is_empty() {
            let layers = work.steps(grid.shape[0]);
            values
                .chunks_mut(nx * ny)
                .enumerate()
                .par_each(|(iz, layer)| {
                    if layers.is_canceled() {
                        return;
                    }
                    layers.add(1);
                    for (slice, share) in along(grid.z(iz), 2, thick, count) {
                        match &single {
                            Some(single) => layer
                                .iter_mut()
                                .zip(single)
                                .for_each(|(value, gray)| *value += gray * share as f32),
                            None => add_layer(&self.slices[slice], &in_x, &in_y, share, layer),
                        }
                    }
                });
        }
        work.check()?;
        Ok(Volume::new(grid.clone(), values))
    }

    fn is_gray(&self) -> bool {
        self.is_gray
    }

    fn warnings(&self) -> Vec<String> {
        self.note.iter().cloned().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixels<const N: usize>(rows: &[[f32; N]]) -> GrayPixels {
        GrayPixels {
            rows: rows.len(),
            columns: N,
            values: rows.concat(),
        }
    }

    /// Row 0 is on top (+y).
    fn image() -> GrayImage {
        let slices = vec![pixels(&[[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]])];
        GrayImage::new(slices, Some(3.0), Some(2.0), &Placement::default()).unwrap()
    }

    #[test]
    fn the_top_row_is_at_plus_y_and_columns_grow_with_x() {
        let image = image();
        assert_eq!(image.bounds_mm(), [[-1.5, -1.0, -1.0], [1.5, 1.0, 1.0]]);
        let grid = VolumeGrid::centered([2, 2, 3], 1.0);
        let slice = [0.4, 0.5, 0.6, 0.1, 0.2, 0.3];
        assert_eq!(image.sample(&grid).unwrap().values, [slice, slice].concat());
        assert!(image.is_gray());
    }

    #[test]
    fn large_voxels_hold_the_mean_over_their_area_and_height() {
        let image = image();
        // x from −2 to 2, y from −2 to 2, z from −2 to 2: the sum of all pixels over 16 mm², half the height
        let one = image.sample(&VolumeGrid::centered([1, 1, 1], 4.0)).unwrap();
        assert!((one.values[0] - 2.1 / 16.0 / 2.0).abs() < 1e-7);
        // Half of the left and half of the middle column
        let grid = VolumeGrid::centered([1, 1, 1], 1.0).about([-0.5, 0.5, 0.0]);
        assert!((image.sample(&grid).unwrap().values[0] - 0.15).abs() < 1e-7);
    }

    #[test]
    fn small_voxels_are_interpolated() {
        let image = image();
        let at = |x: f64, y: f64| {
            let grid = VolumeGrid::centered([1, 1, 1], 1e-3).about([x, y, 0.0]);
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
        let refused = |size, height| {
            let slices = vec![pixels(&[[1.0]])];
            let made = GrayImage::new(slices, size, height, &Placement::default());
            made.unwrap_err().to_string()
        };
        assert!(refused(None, Some(1.0)).starts_with("size_mm: the key is missing"));
        assert!(refused(Some(1.0), Some(-1.0)).starts_with("height_mm: -1 mm"));
    }

    #[test]
    fn a_stack_is_filled_from_the_bottom_up() {
        let flat = |value: f32| pixels(&[[value; 2]; 2]);
        let slices = vec![flat(0.2), flat(0.6), flat(1.0)];
        let stack = GrayImage::new(slices, Some(2.0), Some(3.0), &Placement::default()).unwrap();
        assert_eq!(stack.bounds_mm(), [[-1.0, -1.0, -1.5], [1.0, 1.0, 1.5]]);
        let column = |shape: [usize; 3], pitch: f64| {
            stack
                .sample(&VolumeGrid::centered(shape, pitch))
                .unwrap()
                .values
        };
        assert_eq!(column([3, 1, 1], 1.0), [0.2, 0.6, 1.0]);
        // Larger voxels hold the mean of what they share, smaller ones are interpolated between the middles of slices
        let [low, high] = column([2, 1, 1], 1.5)[..] else {
            panic!("two voxels")
        };
        assert!((low - (0.2 + 0.3) / 1.5).abs() < 1e-6 && (high - (0.3 + 1.0) / 1.5).abs() < 1e-6);
        let fine = column([6, 1, 1], 0.5);
        for (value, expected) in fine.iter().zip([0.2, 0.3, 0.5, 0.7, 0.9, 1.0]) {
            assert!((value - expected).abs() < 1e-6, "{fine:?}");
        }
        let slices = vec![flat(0.0), pixels(&[[0.0; 4]])];
        let text = GrayImage::new(slices, Some(1.0), Some(1.0), &Placement::default());
        tomolith_core::contains!(text.unwrap_err().to_string(), "[2, 2]", "[1, 4]");
    }
}
