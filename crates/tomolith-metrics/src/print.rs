//! A predicted print: what the metrics look at.
//!
//! Labels say what each voxel should become, the response what the dose makes of it; the print is what is above the gel
//! threshold: the one that was given, else the best one. Work that several metrics share (counts over thresholds,
//! distances of surfaces) is done once, when it is first needed.
//!
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::print::Print;
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 3], 0.1);
//! let labels = Volume { grid: grid.clone(), values: vec![VOID, PART, VOID] };
//! let response = Volume { grid, values: vec![0.2, 0.9, 0.4] };
//! let print = Print::new(&labels, &response).unwrap();
//! // From 0.4 to 0.9 only the part gels; the threshold is the middle
//! assert!((print.gel_threshold().unwrap() - 0.65).abs() < 1e-7);
//! ```

use super::error_histogram::ErrorHistogram;
use super::gray::{GrayErrors, gray_errors};
use super::isosurface::{Isosurface, beyond, isosurface_pieces};
use super::scan::{Plateau, Scan};
use super::surface::{
    Compared, Deviation, MOST_TRIANGLES, SurfaceDistance, TargetSurface, compared, deviation,
};
use std::sync::{Arc, OnceLock};
use tomolith_core::dose::Work;
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::field::BLOCK;
use tomolith_core::grid::{Patterns, Volume, VolumeGrid};
use tomolith_core::parallel::InParallel;
use tomolith_core::response::Response;
use tomolith_core::target::label;

/// Sums over the pixels of all frames and lights, dark and masked ones included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatternStats {
    /// Pixels.
    pub pixels: u64,
    /// Sum of the pattern values.
    pub sum: f64,
    /// Largest pattern value.
    pub max: f32,
    /// Frames times the largest pattern value of a light, of all lights together: what pixels that are always white send.
    pub white: f64,
}

impl PatternStats {
    /// Sums over all lights.
    pub fn of<'p>(lights: impl IntoIterator<Item = &'p Patterns>) -> Self {
        let mut stats = PatternStats {
            pixels: 0,
            sum: 0.0,
            max: 0.0,
            white: 0.0,
        };
        for patterns in lights {
            let blocks: Vec<(f64, f32)> = patterns.values.chunks(BLOCK).par_map(|block| {
                block.iter().fold((0.0, 0.0f32), |(sum, max), &v| {
                    (sum + f64::from(v), max.max(v))
                })
            });
            stats.pixels += patterns.values.len() as u64;
            stats.sum += blocks.iter().map(|b| b.0).sum::<f64>();
            let max = blocks.iter().fold(0.0f32, |max, b| max.max(b.1));
            stats.max = stats.max.max(max);
            stats.white += patterns.grid.frames() as f64 * f64::from(max);
        }
        stats
    }
}

/// A predicted print.
pub struct Print<'a> {
    labels: &'a Volume<u8>,
    response: &'a Volume<f32>,
    inside: Option<&'a Volume<f32>>,
    patterns: Option<PatternStats>,
    material: Option<Arc<dyn Response>>,
    threshold: Option<f64>,
    gray: Option<(&'a Volume<f32>, f64)>,
    has_distance: bool,
    pub(super) target_surface: Arc<TargetSurface>,
    pub(super) most_triangles: usize,
    pub(super) most_corners: usize,
    scan: Scan<'a>,
    best: OnceLock<Option<Plateau>>,
    above: OnceLock<[u64; 2]>,
    compared: OnceLock<Option<Compared>>,
    errors: OnceLock<Option<GrayErrors>>,
    /// What stops work on it.
    pub(super) work: Work,
}

/// Share of the work on a print that is counting; the rest are distances of surfaces.
const COUNTING: f64 = 0.5;

fn same_shape(what: &str, grid: &VolumeGrid, found: &VolumeGrid, len: usize) -> Result<()> {
    if grid.shape == found.shape && len == grid.len() {
        return Ok(());
    }
    Err(Error::shape(what, grid.shape, found.shape))
}

impl<'a> Print<'a> {
    /// Labels ([`label`]) and response of the same voxels.
    ///
    /// # Errors
    /// [`Error::Shape`] when they do not fit; [`Error::NonFinite`] when the response of a part or void voxel is not
    /// finite.
    pub fn new(labels: &'a Volume<u8>, response: &'a Volume<f32>) -> Result<Self> {
        Self::under(labels, response, Work::new())
    }

    /// [`new`](Self::new) as a part of a run. When that is canceled, numbers that are computed afterwards mean nothing.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::Canceled`].
    pub fn under(labels: &'a Volume<u8>, response: &'a Volume<f32>, work: Work) -> Result<Self> {
        same_shape("labels", &labels.grid, &labels.grid, labels.values.len())?;
        same_shape(
            "response",
            &labels.grid,
            &response.grid,
            response.values.len(),
        )?;
        Ok(Print {
            labels,
            response,
            inside: None,
            patterns: None,
            material: None,
            threshold: None,
            gray: None,
            has_distance: true,
            target_surface: Arc::default(),
            most_triangles: MOST_TRIANGLES,
            most_corners: usize::MAX,
            scan: Scan::under(&labels.values, &response.values, work.part(COUNTING))?,
            work,
            best: OnceLock::new(),
            above: OnceLock::new(),
            compared: OnceLock::new(),
            errors: OnceLock::new(),
        })
    }

    /// Adds the target's inside fraction, which places its surface within the voxels.
    ///
    /// # Errors
    /// [`Error::Shape`] when it does not fit.
    pub fn with_inside(mut self, inside: &'a Volume<f32>) -> Result<Self> {
        same_shape(
            "inside fraction",
            &self.labels.grid,
            &inside.grid,
            inside.values.len(),
        )?;
        self.inside = Some(inside);
        Ok(self)
    }

    /// Says that the target is gray: its values, and the half width of the band around them, in units of the
    /// response.
    ///
    /// # Errors
    /// [`Error::Shape`] when the values do not fit; [`Error::Config`] for a half width that is negative or not finite.
    pub fn with_gray(mut self, wanted: &'a Volume<f32>, half_width: f64) -> Result<Self> {
        same_shape(
            "gray values",
            &self.labels.grid,
            &wanted.grid,
            wanted.values.len(),
        )?;
        in_range(
            half_width.is_finite() && half_width >= 0.0,
            "epsilon",
            half_width,
            "a finite number, 0 or above",
        )?;
        self.gray = Some((wanted, half_width));
        Ok(self)
    }

    /// Adds what is known of the patterns.
    #[must_use]
    pub fn with_patterns(mut self, stats: PatternStats) -> Self {
        self.patterns = Some(stats);
        self
    }

    /// Says what the material makes of a dose, so that the dose of a threshold is known.
    #[must_use]
    pub fn with_response(mut self, material: Arc<dyn Response>) -> Self {
        self.material = Some(material);
        self
    }

    /// Sets the gel threshold, in units of the response.
    ///
    /// # Errors
    /// [`Error::Config`] when it is not finite.
    pub fn with_threshold(mut self, threshold: f64) -> Result<Self> {
        in_range(
            threshold.is_finite(),
            "evaluate.threshold",
            threshold,
            "a finite number",
        )?;
        self.threshold = Some(threshold);
        Ok(self)
    }

    /// Leaves out the distances of surfaces, which take most of the time.
    #[must_use]
    pub fn without_distance(mut self) -> Self {
        self.has_distance = false;
        self
    }

    /// Shares the target's surface with other prints of the same labels and inside fraction.
    #[must_use]
    pub fn with_target_surface(mut self, shared: &Arc<TargetSurface>) -> Self {
        self.target_surface = shared.clone();
        self
    }

    /// Measures distances between surfaces of at most so many triangles each, averaging voxels until they have no more; at most 4·10⁶.
    #[must_use]
    pub fn with_most_triangles(mut self, most: usize) -> Self {
        self.most_triangles = most.min(MOST_TRIANGLES);
        self
    }

    /// Measures distances between surfaces from about so many corners of each, evenly spread: enough for means, and faster.
    #[must_use]
    pub fn with_most_corners(mut self, most: usize) -> Self {
        self.most_corners = most.max(1);
        self
    }

    /// Where the voxels are.
    #[must_use]
    pub fn grid(&self) -> &VolumeGrid {
        &self.labels.grid
    }

    /// What each voxel should become.
    #[must_use]
    pub fn labels(&self) -> &Volume<u8> {
        self.labels
    }

    /// What the dose makes of each voxel.
    #[must_use]
    pub fn response(&self) -> &Volume<f32> {
        self.response
    }

    /// What is known of the patterns.
    #[must_use]
    pub fn patterns(&self) -> Option<PatternStats> {
        self.patterns
    }

    /// Half width of the band round the gray values, `None` for a target of part and void.
    #[must_use]
    pub fn half_width(&self) -> Option<f64> {
        self.gray.map(|(_, half_width)| half_width)
    }

    /// Errors against the gray values, `None` for a target of part and void.
    #[must_use]
    pub fn gray_errors(&self) -> Option<GrayErrors> {
        let (wanted, half_width) = self.gray?;
        *self.errors.get_or_init(|| {
            let (labels, response) = (&self.labels.values, &self.response.values);
            gray_errors(labels, response, &wanted.values, half_width)
        })
    }

    /// Voxels over the error against the gray values, `None` for a target of part and void, and without voxels that count.
    #[must_use]
    pub fn error_histogram(&self) -> Option<ErrorHistogram> {
        let (wanted, _) = self.gray?;
        let largest = self.gray_errors()?.largest.into_iter().flatten();
        let (labels, response) = (&self.labels.values, &self.response.values);
        let largest = largest.fold(0.0, f64::max);
        Some(ErrorHistogram::of(
            labels,
            response,
            &wanted.values,
            largest,
        ))
    }

    /// Counts over thresholds.
    #[must_use]
    pub fn scan(&self) -> &Scan<'a> {
        &self.scan
    }

    /// The thresholds of the best IoU, `None` without part or when none prints any of it.
    #[must_use]
    pub fn best(&self) -> Option<Plateau> {
        *self.best.get_or_init(|| self.scan.best_plateau())
    }

    /// The gel threshold: the given one, else the best one.
    #[must_use]
    pub fn gel_threshold(&self) -> Option<f64> {
        self.threshold
            .or_else(|| self.best().map(|best| best.middle()))
    }

    /// The dose at which the resin gels; None where the [response](Self::with_response) is not known, and for gray targets.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "responses are f32")]
    pub fn gel_dose(&self) -> Option<f64> {
        let threshold = self.gel_threshold().filter(|_| self.gray.is_none())?;
        let material = self.material.as_ref()?;
        Some(match material.is_identity() {
            true => threshold,
            false => f64::from(material.inverse(threshold as f32)),
        })
    }

    /// Part and void voxels that gel.
    #[must_use]
    pub fn printed(&self) -> [u64; 2] {
        *self.above.get_or_init(|| {
            self.gel_threshold()
                .map_or([0, 0], |threshold| self.scan.count_above(threshold))
        })
    }

    /// Response of a row of voxels that begins at a position, nothing outside of the resin.
    pub(super) fn printed_row(&self, first: usize, threshold: f64, row: &mut [f32]) {
        printed_row(self.labels, self.response, first, threshold, row);
    }

    /// Inside fraction of a row of voxels, or 0 and 1 by label when none is known.
    pub(super) fn target_row(&self, first: usize, row: &mut [f32]) {
        let labels = &self.labels.values[first..];
        let Some(inside) = self.inside else {
            for (value, &label) in row.iter_mut().zip(labels) {
                *value = f32::from(u8::from(label == label::PART));
            }
            return;
        };
        let voxels = labels.iter().zip(&inside.values[first..]);
        for (value, (&label, &inside)) in row.iter_mut().zip(voxels) {
            *value = if label == label::OUTSIDE { 0.0 } else { inside };
        }
    }

    /// The print's surface with its signed distances to the target's; `None` when one of them is empty. Made anew at each call.
    #[must_use]
    pub fn deviation(&self) -> Option<Deviation> {
        deviation(self)
    }

    /// The deviation, from the [distances](Self::distance) that were measured; `None` where none were.
    #[must_use]
    pub fn into_measured_deviation(mut self) -> Option<Deviation> {
        let compared = self.compared.take().flatten()?;
        compared.deviation(&self)
    }

    /// Distances between the print's surface and the target's; `None` when one of them is empty, and where they are left out.
    #[must_use]
    pub fn distance(&self) -> Option<SurfaceDistance> {
        let measured = || self.has_distance.then(|| compared(self)).flatten();
        let compared = self.compared.get_or_init(measured).as_ref();
        compared.map(|compared| compared.distance)
    }
}

/// The surface of what gels at a threshold, in pieces from below to above, so that it is never held whole; see [`isosurface_pieces`]. Nothing is counted.
///
/// # Errors
/// What `take` refuses; [`Error::Canceled`].
pub fn surface_pieces<E: From<Error>>(
    labels: &Volume<u8>,
    response: &Volume<f32>,
    threshold: f64,
    take: impl FnMut(&Isosurface) -> std::result::Result<(), E>,
    work: &Work,
) -> std::result::Result<(), E> {
    let fill = |i, row: &mut [f32]| printed_row(labels, response, i, threshold, row);
    isosurface_pieces(&labels.grid, threshold, fill, take, work)
}

/// See [`Print::printed_row`].
fn printed_row(
    labels: &Volume<u8>,
    response: &Volume<f32>,
    first: usize,
    threshold: f64,
    row: &mut [f32],
) {
    let outside = beyond(threshold);
    let voxels = labels.values[first..].iter().zip(&response.values[first..]);
    for (value, (&label, &response)) in row.iter_mut().zip(voxels) {
        *value = if label == label::OUTSIDE {
            outside
        } else {
            response
        };
    }
}

/// Small prints for the tests of the metrics.
#[cfg(test)]
pub(super) mod samples {
    use super::*;
    use crate::Measure;

    /// A row of voxels, 0.5 mm each.
    pub(crate) fn row<T: Clone>(values: &[T]) -> Volume<T> {
        let grid = VolumeGrid::centered([1, 1, values.len()], 0.5);
        Volume::new(grid, values.to_vec())
    }

    /// ½ and the depth under the surface of a ball about a point of the axis x: ½ at the surface.
    pub(crate) fn ball(grid: &VolumeGrid, radius: f64, x0: f64) -> Volume<f32> {
        let depth = |[x, y, z]: [f64; 3]| radius - (x - x0).hypot(y).hypot(z);
        Volume::from_fn(grid.clone(), |at| (0.5 + depth(at)) as f32)
    }

    /// Part where at least half is inside, else void.
    pub(crate) fn labeled(inside: &Volume<f32>) -> Volume<u8> {
        let label = |&share: &f32| [label::VOID, label::PART][usize::from(share >= 0.5)];
        let labels = inside.values.iter().map(label).collect();
        Volume::new(inside.grid.clone(), labels)
    }

    /// The print of a response that gels at ½, with the target's inside fraction.
    pub(crate) fn print_of<'a>(
        labels: &'a Volume<u8>,
        inside: &'a Volume<f32>,
        response: &'a Volume<f32>,
    ) -> Print<'a> {
        let print = Print::new(labels, response).unwrap();
        let print = print.with_inside(inside).unwrap();
        print.with_threshold(0.5).unwrap()
    }

    /// What a metric says of a row of voxels without inside fraction and patterns.
    pub(crate) fn measured(
        measure: fn(&Print<'_>) -> Measure,
        labels: &[u8],
        response: &[f32],
    ) -> Measure {
        measure(&Print::new(&row(labels), &row(response)).unwrap())
    }

    /// Whether a number is the expected one up to f32.
    pub(crate) fn near(found: Measure, expected: f64) -> bool {
        found.is_some_and(|found| (found - expected).abs() < 1e-6)
    }
}

#[cfg(test)]
mod tests {
    use super::samples::{ball, labeled, print_of, row};
    use super::*;
    use tomolith_core::near;
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    #[test]
    fn a_given_threshold_replaces_the_best_one() {
        let labels = row(&[VOID, PART, PART, OUTSIDE]);
        let response = row(&[0.3, 0.6, 0.9, 5.0]);
        let print = || Print::new(&labels, &response).unwrap();
        assert_eq!(print().printed(), [2, 0]);
        let given = print().with_threshold(0.25).unwrap();
        assert_eq!(given.printed(), [2, 1]);
        assert_eq!(given.gel_threshold(), Some(0.25));
        assert!(print().with_threshold(f64::NAN).is_err());
    }

    #[test]
    fn arrays_that_do_not_fit_are_refused() {
        let (labels, response) = (row(&[VOID, PART]), row(&[0.3, 0.6, 0.9]));
        assert!(matches!(
            Print::new(&labels, &response),
            Err(Error::Shape { .. })
        ));
        let short = row(&[0.1, 0.2]);
        assert!(
            Print::new(&labels, &short)
                .unwrap()
                .with_inside(&response)
                .is_err()
        );
        let mut torn = row(&[0.1, 0.2]);
        torn.values.pop();
        assert!(matches!(
            Print::new(&labels, &torn),
            Err(Error::Shape { .. })
        ));
    }

    #[test]
    fn pattern_sums_count_every_pixel_of_every_light() {
        let patterns = |frames: usize, values: Vec<f32>| {
            let columns = values.len() / frames;
            Patterns {
                grid: tomolith_core::grid::PatternGrid::full_turn(frames, 0.0, 1, columns, 0.1),
                values,
            }
        };
        let (a, b) = (
            patterns(2, vec![0.0, 2.0]),
            patterns(1, vec![1.0, 0.0, 0.0]),
        );
        let stats = PatternStats::of([&a, &b]);
        assert_eq!(
            stats,
            PatternStats {
                pixels: 5,
                sum: 3.0,
                max: 2.0,
                white: 2.0 * 2.0 + 1.0
            }
        );
    }

    #[test]
    fn the_surface_in_pieces_holds_the_volume_that_is_measured() {
        // An egg that reaches beyond several slabs, and a shell round it that does not gel
        let grid = VolumeGrid::centered([64, 48, 48], 0.1);
        let height = |[x, y, z]: [f64; 3]| 1.5 - (x.hypot(y) / 1.9).hypot(z / 2.8);
        let response = Volume::from_fn(grid.clone(), |at| height(at) as f32);
        let labels = labeled(&response);
        let print = Print::new(&labels, &response).unwrap();
        let (mut volume, mut pieces) = (0.0, 0);
        let take = |piece: &Isosurface| -> Result<()> {
            // Signed tetrahedra from the origin add up over the pieces of a closed surface
            volume += piece.volume_mm3();
            pieces += 1;
            Ok(())
        };
        let threshold = print.gel_threshold().unwrap();
        surface_pieces(&labels, &response, threshold, take, &Work::new()).unwrap();
        let [part, void] = print.printed();
        let measured = (part + void) as f64 * grid.voxel_mm3();
        assert!(pieces > 4 && void == 0);
        near!(volume / measured, 1.0, 5e-3, "{volume} {measured}");
    }

    #[test]
    fn distances_that_were_measured_have_the_deviation_of_the_surface() {
        let grid = VolumeGrid::centered([24, 24, 24], 0.1);
        let (inside, response) = (ball(&grid, 0.7, 0.0), ball(&grid, 0.8, 0.0));
        let labels = labeled(&inside);
        let print = || print_of(&labels, &inside, &response);
        let measured = print();
        assert!(measured.distance().is_some());
        // Two prints of one target share its surface, and their numbers are those of each alone
        let shared = Arc::default();
        for threshold in [0.5, 0.4] {
            let at = |print: Print<'_>| print.with_threshold(threshold).unwrap().distance();
            assert_eq!(at(print().with_target_surface(&shared)), at(print()));
        }
        let found = measured.into_measured_deviation();
        assert!(found.is_some());
        assert_eq!(found, print().deviation());
        assert_eq!(print().into_measured_deviation(), None);
        let some = print().with_most_corners(50);
        assert!(some.distance().is_some());
        assert_eq!(some.into_measured_deviation(), None);
    }

    #[test]
    fn what_lies_outside_of_the_resin_is_no_print() {
        let (labels, response) = (row(&[OUTSIDE, VOID, PART]), row(&[9.0, 0.0, 1.0]));
        let print = Print::new(&labels, &response).unwrap();
        let surface = print.deviation().unwrap().surface;
        assert!(surface.corners.iter().all(|c| c[0] > 0.0), "{surface:?}");
        assert_eq!(surface.triangles.len(), 8);
    }
}
