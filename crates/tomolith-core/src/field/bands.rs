//! The band loss: data, and the passes over a dose that it is computed with.
//!
//! A voxel is right while its response lies in a band [lower, upper]; outside, it costs its distance from the band, to a power.
//!
//! **Equation** with m = M(d) of the dose d and e = max(lower − m, m − upper, 0)
//!
//! ```text
//! L        = S^(q/p),   S = Σ_v w_v·e_v^p                         w inside the sum, no voxel volume
//! ∂L/∂d_v  = (q/p)·S^(q/p − 1) · w_v·p·e_v^(p−1) · sign · M′(d_v)  sign: −1 below the band, +1 above
//! ```
//!
//! [`BandLoss`] is all of it as plain data: bands and weights of the voxels, p and q, and the response
//! ([`ResponseForm`](crate::response::ResponseForm)). A [`BandKernel`] is what a backend makes of the data, and its passes; [`HostBands`] is that of
//! host memory. Sources and presets are in the crate of objectives.
//!
//! **Where the formula has no derivative.** At L = 0 the gradient is 0, also for q < p, where the factor S^(q/p − 1) is
//! infinite. For p < 1 the slope at the edge of the band is infinite; there e^p is replaced by its chord e·δ^(p−1) for
//! e < δ = [`CHORD`], so that value and gradient stay an exact pair and finite.
//!
//! **Order of sums** of the host: distances and terms in f32, those of 16 neighbors added in pairs (i and i + 8), these in eight
//! running sums of f64 over 512 elements; then all chunks of [`BLOCK`] elements, then all blocks.
//!
//! **Cost** one pass over dose and bands. Sixteen neighbors along z that share a label skip the table; for p = 1, 2 and the
//! identity response the pass is bound by memory (about 5 bytes read per voxel).

use super::BLOCK;
use super::LANES;
use crate::dose::regions::ByElement;
use crate::error::{Error, Result, above_zero, in_range};
use crate::parallel::InParallel;
use crate::response::{Response, is_reached};
use crate::units::exact;
use std::ops::Range;
use std::sync::Arc;

mod kernel;

pub use kernel::HostBands;

/// For powers below 1: below this distance the power is replaced by its chord.
pub const CHORD: f32 = 1e-4;

/// What a voxel's response should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Smallest response without penalty, −∞ for none.
    pub lower: f32,
    /// Largest response without penalty, +∞ for none.
    pub upper: f32,
    /// Weight inside the sum, 0 for a voxel that does not count.
    pub weight: f32,
}

impl Band {
    /// A band that costs nothing anywhere.
    pub const FREE: Band = Band {
        lower: f32::NEG_INFINITY,
        upper: f32::INFINITY,
        weight: 0.0,
    };

    /// `[lower, upper]` with a weight.
    #[must_use]
    pub fn new(lower: f32, upper: f32, weight: f32) -> Self {
        Band {
            lower,
            upper,
            weight,
        }
    }

    /// One value, weight 1.
    #[must_use]
    pub fn exactly(value: f32) -> Self {
        Band::new(value, value, 1.0)
    }

    /// `(−∞, upper]`, weight 1.
    #[must_use]
    pub fn below(upper: f32) -> Self {
        Band::new(f32::NEG_INFINITY, upper, 1.0)
    }

    /// `[lower, ∞)`, weight 1.
    #[must_use]
    pub fn above(lower: f32) -> Self {
        Band::new(lower, f32::INFINITY, 1.0)
    }

    /// The same band with another weight.
    #[must_use]
    pub fn weighing(mut self, weight: f32) -> Self {
        self.weight = weight;
        self
    }

    /// The same band, wider by `tolerance` on either side.
    #[must_use]
    pub fn widened(mut self, tolerance: f32) -> Self {
        self.lower -= tolerance;
        self.upper += tolerance;
        self
    }

    fn validate(&self) -> Result<()> {
        // Also refuses NaN
        if !(self.lower <= self.upper
            && self.lower < f32::INFINITY
            && self.upper > f32::NEG_INFINITY)
        {
            return Err(Error::config(
                "band",
                format!(
                    "lower {} and upper {}",
                    exact(self.lower),
                    exact(self.upper)
                ),
                "lower ≤ upper, neither a NaN",
            ));
        }
        in_range(
            self.weight >= 0.0 && self.weight.is_finite(),
            "weight",
            self.weight,
            "a finite number, 0 or above",
        )?;
        Ok(())
    }
}

/// The bands of all voxels, in the order of the model's dose field.
#[derive(Clone, Debug)]
pub enum Bands {
    /// A label per voxel and a band per label.
    Labels {
        /// One per element of the field.
        labels: Vec<u8>,
        /// One per label.
        table: Box<[Band; 256]>,
    },
    /// Every voxel is part and void at once, in shares s and 1 − s: the surface cuts through it.
    Shared {
        /// s per element of the field, negative where a voxel does not count.
        inside: Vec<f32>,
        /// Weighs s.
        part: Band,
        /// Weighs 1 − s.
        void: Band,
        /// Factor of both weights per element; empty for 1.
        scale: Vec<f32>,
        /// What both bands are widened by on either side, per element; empty for 0.
        widen: Vec<f32>,
    },
    /// A band per voxel; arrays may be shared, for lower = upper.
    Voxels {
        /// Per element of the field.
        lower: Arc<[f32]>,
        /// Per element of the field.
        upper: Arc<[f32]>,
        /// Per element of the field.
        weight: Arc<[f32]>,
    },
}

impl Bands {
    /// Bands for some labels; the others do not count.
    #[must_use]
    pub fn labels(labels: Vec<u8>, bands: &[(u8, Band)]) -> Self {
        let mut table = Box::new([Band::FREE; 256]);
        for &(label, band) in bands {
            table[usize::from(label)] = band;
        }
        Bands::Labels { labels, table }
    }

    fn len(&self) -> usize {
        match self {
            Bands::Labels { labels, .. } => labels.len(),
            Bands::Shared { inside, .. } => inside.len(),
            Bands::Voxels { lower, .. } => lower.len(),
        }
    }

    fn validate(&self) -> Result<()> {
        match self {
            Bands::Labels { table, .. } => table.iter().try_for_each(Band::validate),
            Bands::Shared { part, void, .. } => part.validate().and_then(|()| void.validate()),
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => {
                for (what, found) in [("upper", upper.len()), ("weight", weight.len())] {
                    if found != lower.len() {
                        return Err(Error::shape(
                            format!("{what} of the bands"),
                            vec![lower.len()],
                            vec![found],
                        ));
                    }
                }
                let bands = lower
                    .chunks(BLOCK)
                    .zip(upper.chunks(BLOCK))
                    .zip(weight.chunks(BLOCK));
                let blocks = bands.par_map(|((lower, upper), weight)| {
                    let mut band =
                        (0..lower.len()).map(|i| Band::new(lower[i], upper[i], weight[i]));
                    band.try_for_each(|band| band.validate())
                });
                blocks.into_iter().collect()
            }
        }
    }

    /// A band that counts and of which the response reaches nothing.
    fn out_of_reach(&self, response: &dyn Response) -> Option<Band> {
        let missed = |band: &Band| {
            let [lower, upper] = [band.lower, band.upper].map(f64::from);
            band.weight > 0.0 && !is_reached(response, lower, upper)
        };
        match self {
            Bands::Labels { table, .. } => table.iter().copied().find(missed),
            Bands::Shared {
                part, void, widen, ..
            } => {
                let widest = widen.iter().copied().fold(0.0, f32::max);
                let bands = [*part, *void].map(|band| band.widened(widest));
                bands.into_iter().find(missed)
            }
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => (0..lower.len())
                .map(|i| Band::new(lower[i], upper[i], weight[i]))
                .find(missed),
        }
    }

    /// Weights times a factor and bands widened, per element; either may be empty for none.
    fn emphasized(self, scale: &[f32], widen: &[f32]) -> Self {
        let at = |field: &[f32], i: usize, none: f32| field.get(i).copied().unwrap_or(none);
        let each = |band: Band, i: usize| {
            band.widened(at(widen, i, 0.0))
                .weighing(band.weight * at(scale, i, 1.0))
        };
        match self {
            Bands::Shared {
                inside,
                part,
                void,
                scale: before,
                ..
            } => Bands::Shared {
                scale: match (before.is_empty(), scale.is_empty()) {
                    (true, _) => scale.to_vec(),
                    (_, true) => before,
                    _ => before.iter().zip(scale).map(|(a, b)| a * b).collect(),
                },
                inside,
                part,
                void,
                widen: widen.to_vec(),
            },
            Bands::Labels { labels, table } => {
                let bands: Vec<Band> = labels
                    .iter()
                    .enumerate()
                    .map(|(i, &label)| each(table[usize::from(label)], i))
                    .collect();
                Bands::voxels(&bands)
            }
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => {
                let bands: Vec<Band> = (0..lower.len())
                    .map(|i| each(Band::new(lower[i], upper[i], weight[i]), i))
                    .collect();
                Bands::voxels(&bands)
            }
        }
    }

    fn voxels(bands: &[Band]) -> Self {
        Bands::Voxels {
            lower: bands.iter().map(|b| b.lower).collect(),
            upper: bands.iter().map(|b| b.upper).collect(),
            weight: bands.iter().map(|b| b.weight).collect(),
        }
    }

    /// Fills up to whole lanes with elements that do not count.
    fn pad(&mut self) -> Result<()> {
        let len = self.len().next_multiple_of(LANES);
        match self {
            Bands::Labels { labels, table } => {
                if labels.len() < len {
                    let free = (0..=255u8).find(|&l| table[usize::from(l)].weight == 0.0);
                    let free = free.ok_or_else(|| {
                        Error::unsupported(
                            "a table in which all 256 labels count",
                            "one is needed for elements that do not",
                        )
                    })?;
                    labels.resize(len, free);
                }
            }
            Bands::Shared {
                inside,
                scale,
                widen,
                ..
            } => {
                inside.resize(len, -1.0);
                for field in [scale, widen] {
                    if !field.is_empty() {
                        field.resize(len, 0.0);
                    }
                }
            }
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => {
                for (array, value) in [(lower, 0.0), (upper, 0.0), (weight, 0.0)] {
                    if array.len() < len {
                        let mut longer = array.to_vec();
                        longer.resize(len, value);
                        *array = longer.into();
                    }
                }
            }
        }
        Ok(())
    }
}

/// A band loss as plain data; see the [module](self).
#[derive(Clone, Debug)]
pub struct BandLoss {
    elements: Range<usize>,
    bands: Bands,
    p: f64,
    q: f64,
    response: Arc<dyn Response>,
}

impl BandLoss {
    /// A loss on the `elements` of the model's dose field (see [`DoseLayout::range`]), which must begin at a multiple of 16;
    /// `bands` has one entry per element.
    ///
    /// # Errors
    /// [`Error::Config`] for p or q not above 0, lower > upper, a NaN or a negative weight; [`Error::Shape`].
    ///
    /// [`DoseLayout::range`]: crate::dose::DoseLayout::range
    pub fn new(
        elements: Range<usize>,
        mut bands: Bands,
        p: f64,
        q: f64,
        response: Arc<dyn Response>,
    ) -> Result<Self> {
        for (key, value) in [("p", p), ("q", q)] {
            above_zero(key, value)?;
        }
        if bands.len() != elements.len() || !elements.start.is_multiple_of(LANES) {
            return Err(Error::shape(
                "bands of the objective (beginning at a multiple of 16)",
                vec![elements.start.next_multiple_of(LANES), elements.len()],
                vec![elements.start, bands.len()],
            ));
        }
        bands.validate()?;
        bands.pad()?;
        Ok(BandLoss {
            elements,
            bands,
            p,
            q,
            response,
        })
    }

    /// The elements of the dose field that the bands are for; the first is a multiple of 16.
    #[must_use]
    pub fn elements(&self) -> Range<usize> {
        self.elements.clone()
    }

    /// The bands, in the order of the elements and filled up to whole lanes.
    #[must_use]
    pub fn bands(&self) -> &Bands {
        &self.bands
    }

    /// p, the power of the distances, and q, that of the norm.
    #[must_use]
    pub fn powers(&self) -> [f64; 2] {
        [self.p, self.q]
    }

    /// The same bands for another response.
    pub fn set_response(&mut self, response: Arc<dyn Response>) {
        self.response = response;
    }

    /// M, the response that the bands are for.
    #[must_use]
    pub fn response(&self) -> &dyn Response {
        self.response.as_ref()
    }

    /// Whether the loss is convex in the dose.
    #[must_use]
    pub fn is_convex(&self) -> bool {
        self.p >= 1.0 && self.q >= 1.0 && self.response.is_identity()
    }

    /// Up to which dose, from 0 on, an element costs nothing: 0 where a dose of 0 does, +∞ where no dose does. The first element is that of the bands.
    #[must_use]
    pub fn harmless(&self) -> Box<ByElement<'_>> {
        let [at_rest, most] = [self.response.value(0.0), self.response.range()[1] as f32];
        let up_to = move |band: Band| match band {
            Band { weight: 0.0, .. } => f32::INFINITY,
            Band { lower, upper, .. } if !(lower..=upper).contains(&at_rest) => 0.0,
            Band { upper, .. } if upper >= most => f32::INFINITY,
            Band { upper, .. } => self.response.inverse(upper).max(0.0),
        };
        match &self.bands {
            Bands::Labels { labels, table } => {
                let of_label = table.map(up_to);
                Box::new(move |i| of_label[usize::from(labels[i])])
            }
            Bands::Shared {
                inside,
                part,
                void,
                scale,
                widen,
            } => {
                let plain = [part, void].map(|band| up_to(*band));
                Box::new(move |i| {
                    let share = inside[i];
                    if share < 0.0 || scale.get(i) == Some(&0.0) {
                        return f32::INFINITY;
                    }
                    let [part, void] = match widen.get(i) {
                        None => plain,
                        Some(&by) => [part, void].map(|band| up_to(band.widened(by))),
                    };
                    let of_share =
                        |limit, share: f32| if share > 0.0 { limit } else { f32::INFINITY };
                    of_share(part, share).min(of_share(void, 1.0 - share))
                })
            }
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => Box::new(move |i| up_to(Band::new(lower[i], upper[i], weight[i]))),
        }
    }

    /// Multiplies weights and widens bands on either side, per element; either may be empty for none.
    ///
    /// # Errors
    /// [`Error::Shape`], [`Error::Config`] for a negative weight.
    pub fn set_voxel_weights(&mut self, weight: &[f32], tolerance: &[f32]) -> Result<()> {
        let n = self.elements.len();
        for (what, field) in [("weights", weight), ("tolerance", tolerance)] {
            if !field.is_empty() && field.len() != n {
                return Err(Error::shape(
                    format!("{what} of the objective"),
                    vec![n],
                    vec![field.len()],
                ));
            }
        }
        if weight.is_empty() && tolerance.is_empty() {
            return Ok(());
        }
        let free = Bands::voxels(&[]);
        let bands = std::mem::replace(&mut self.bands, free);
        self.bands = bands.emphasized(weight, tolerance);
        self.bands.validate()?;
        self.bands.pad()
    }

    /// Refuses bands that the response cannot reach.
    ///
    /// # Errors
    /// [`Error::Config`] (without a key).
    pub fn must_be_reached(&self) -> Result<()> {
        // The identity reaches everything, and bands per voxel are many
        let Some(band) = (!self.response.is_identity())
            .then(|| self.bands.out_of_reach(self.response.as_ref()))
            .flatten()
        else {
            return Ok(());
        };
        let [low, high] = self.response.range().map(exact);
        let [lower, upper] = [band.lower, band.upper].map(exact);
        Err(Error::config(
            "",
            format!("the band from {lower} to {upper} lies outside the response's range"),
            format!("bands that meet the response's range, {low} to {high}"),
        ))
    }

    /// The groups of sixteen elements that count.
    fn groups(&self) -> Range<usize> {
        self.elements.start / LANES..self.elements.end.div_ceil(LANES)
    }

    /// L of S.
    #[must_use]
    pub fn loss(&self, sum: f64) -> f64 {
        if self.p == self.q {
            sum
        } else {
            sum.powf(self.q / self.p)
        }
    }

    /// dL/dS; 0 at S = 0, where it is infinite for q < p.
    #[must_use]
    pub fn loss_slope(&self, sum: f64) -> f64 {
        if self.p == self.q {
            1.0
        } else if sum == 0.0 {
            0.0
        } else {
            self.q / self.p * sum.powf(self.q / self.p - 1.0)
        }
    }
}

/// The passes of a band loss over doses, where the fields F live.
pub trait BandKernel<F>: Send + Sync {
    /// Brings the data to where `like` lives.
    fn new(loss: &Arc<BandLoss>, like: &F) -> Self;
    /// L(dose)
    fn value(&self, dose: &F) -> f64;
    /// L(dose), and ∂L/∂dose written over `grad`, 0 for elements that the loss is not for; the value equals
    /// [`value`](Self::value) bit for bit.
    fn value_and_gradient(&self, dose: &F, grad: &mut F) -> f64;
    /// L of dose + α·step and its derivative by α.
    fn slope_along(&self, dose: &F, step: &F, alpha: f32) -> (f64, f64);
    /// dose ← dose + α·step, step ← ∂L/∂dose there; L there.
    fn advance(&self, dose: &mut F, step: &mut F, alpha: f32) -> f64;
}
