//! The band loss beside a sealed field: its data brought to two bands per element, the last element first.

use super::field::SealedField;
use std::sync::Arc;
use tomolith_core::field::bands::CHORD;
use tomolith_core::field::{BLOCK, Band, BandKernel, BandLoss, Bands, Field as _};
use tomolith_core::response::ResponseForm;

const GROUP: usize = 16;
const CHUNK: usize = 32 * GROUP;

/// The loss.
pub(crate) struct SealedBands {
    loss: Arc<BandLoss>,
    first: usize,
    /// Of every element of the loss.
    bands: Vec<[Band; 2]>,
    curve: Curve,
}

/// A response where the field lives.
enum Curve {
    Identity,
    Logistic {
        lower: f32,
        range: f32,
        steepness: f32,
        midpoint: f32,
        exponent: f32,
    },
    Table {
        pieces: Vec<[f32; 5]>,
        lines: [[f32; 3]; 2],
    },
}

impl Curve {
    fn of(form: ResponseForm<'_>) -> Self {
        match form {
            ResponseForm::Identity => Curve::Identity,
            ResponseForm::Logistic(params) => Curve::Logistic {
                lower: params.lower as f32,
                range: (params.upper - params.lower) as f32,
                steepness: params.steepness as f32,
                midpoint: params.midpoint as f32,
                exponent: (1.0 / params.asymmetry) as f32,
            },
            ResponseForm::Table(table) => Curve::Table {
                pieces: table.pieces().to_vec(),
                lines: table.lines(),
            },
            ResponseForm::Code => panic!("no test has a response that is code of the host"),
        }
    }

    /// M(d) and dM/dd
    fn at(&self, dose: f32) -> (f32, f32) {
        match self {
            Curve::Identity => (dose, 1.0),
            Curve::Logistic {
                lower,
                range,
                steepness,
                midpoint,
                exponent,
            } => {
                let falling = (-steepness * (dose - midpoint)).exp();
                let u = 1.0 / (1.0 + falling);
                let height = u.powf(*exponent);
                let rise = range * steepness * exponent * height * (falling * u);
                (lower + range * height, rise)
            }
            Curve::Table {
                pieces,
                lines: [before, beyond],
            } => {
                let line = |[begin, response, slope]: [f32; 3]| {
                    let value = response + slope * (dose - begin);
                    (value.clamp(f32::MIN, f32::MAX), slope)
                };
                if dose < before[0] {
                    return line(*before);
                }
                if dose > beyond[0] {
                    return line(*beyond);
                }
                let [begin, a, b, c, d] = pieces
                    .iter()
                    .rev()
                    .find(|piece| piece[0] <= dose)
                    .copied()
                    .unwrap_or(pieces[0]);
                let t = dose - begin;
                (
                    ((d * t + c) * t + b) * t + a,
                    (3.0 * d * t + 2.0 * c) * t + b,
                )
            }
        }
    }
}

/// The bands of element i.
fn bands_of(bands: &Bands, i: usize) -> [Band; 2] {
    match bands {
        Bands::Labels { labels, table } => [table[usize::from(labels[i])], Band::FREE],
        Bands::Voxels {
            lower,
            upper,
            weight,
        } => [Band::new(lower[i], upper[i], weight[i]), Band::FREE],
        Bands::Shared {
            inside,
            part,
            void,
            scale,
            widen,
        } => {
            let s = inside[i];
            let [part_share, void_share] = if s >= 0.0 { [s, 1.0 - s] } else { [0.0; 2] };
            let scale = scale.get(i).copied().unwrap_or(1.0);
            let widen = widen.get(i).copied().unwrap_or(0.0);
            [(part, part_share), (void, void_share)]
                .map(|(band, share)| band.widened(widen).weighing(band.weight * (share * scale)))
        }
    }
}

/// w·e^p and its derivative by m.
fn penalty(p: f64, band: &Band, m: f32) -> (f32, f32) {
    let positive = |v: f32| if v > 0.0 { v } else { 0.0 };
    let distance = positive(m - band.upper) - positive(band.lower - m) + m * 0.0;
    let (w, e) = (band.weight, distance.abs());
    if p == 2.0 {
        let slope = w * distance;
        return (slope * distance, slope + slope);
    }
    if p == 1.0 {
        let sign = f32::from(distance > 0.0) - f32::from(distance < 0.0);
        return (w * e, w * sign);
    }
    if let Some(whole) = (3..=4u8).find(|&whole| f64::from(whole) == p) {
        let rise = (3..whole).fold(e, |rise, _| rise * e);
        let slope = w * rise * distance;
        return (slope * distance, slope * f32::from(whole));
    }
    if e == 0.0 || w == 0.0 {
        return (w * e, 0.0);
    }
    let chord = if p < 1.0 { CHORD } else { 0.0 };
    let rise = e.max(chord).powf(p as f32 - 1.0);
    let slope = if e < chord { rise } else { p as f32 * rise };
    (w * rise * e, w * slope.copysign(distance))
}

impl SealedBands {
    /// S and, by `give(i, slope)`, ∂S/∂dᵢ at doses `dose(i)`; Σ slope·step.
    fn pass(
        &self,
        dose: impl Fn(usize) -> f32,
        step: impl Fn(usize) -> f32,
        mut give: impl FnMut(usize, f32),
    ) -> (f64, f64) {
        let [p, _] = self.loss.powers();
        let mut all = (0.0, 0.0);
        for block in (0..self.bands.len()).step_by(BLOCK) {
            let mut of_block = (0.0, 0.0);
            let end = self.bands.len().min(block + BLOCK);
            for chunk in (block..end).step_by(CHUNK) {
                let (mut sums, mut along) = ([0.0f64; 8], [0.0f64; 8]);
                for group in (chunk..end.min(chunk + CHUNK)).step_by(GROUP) {
                    let (mut values, mut products) = ([[0.0f32; GROUP]; 2], [0.0f32; GROUP]);
                    for k in group..end.min(group + GROUP) {
                        let (m, inner) = self.curve.at(dose(self.first + k));
                        let [a, b] =
                            self.bands[self.bands.len() - 1 - k].map(|band| penalty(p, &band, m));
                        let slope = (a.1 + b.1) * inner;
                        give(self.first + k, slope);
                        values[0][k - group] = a.0;
                        values[1][k - group] = b.0;
                        products[k - group] = slope * step(self.first + k);
                    }
                    for i in 0..8 {
                        for values in &values {
                            sums[i] += f64::from(values[i] + values[i + 8]);
                        }
                        along[i] += f64::from(products[i] + products[i + 8]);
                    }
                }
                of_block.0 += sums.iter().sum::<f64>();
                of_block.1 += along.iter().sum::<f64>();
            }
            all.0 += of_block.0;
            all.1 += of_block.1;
        }
        all
    }
}

impl BandKernel<SealedField> for SealedBands {
    fn new(loss: &Arc<BandLoss>, _: &SealedField) -> Self {
        let elements = loss.elements();
        SealedBands {
            loss: loss.clone(),
            first: elements.start,
            bands: (0..elements.len())
                .rev()
                .map(|i| bands_of(loss.bands(), i))
                .collect(),
            curve: Curve::of(loss.response().form()),
        }
    }

    fn value(&self, dose: &SealedField) -> f64 {
        let (sum, _) = self.pass(|i| dose.at(i), |_| 0.0, |_, _| {});
        self.loss.loss(sum)
    }

    fn value_and_gradient(&self, dose: &SealedField, grad: &mut SealedField) -> f64 {
        grad.fill(0.0);
        let (sum, _) = self.pass(|i| dose.at(i), |_| 0.0, |i, slope| grad.set(i, slope));
        let slope = self.loss.loss_slope(sum);
        if slope != 1.0 {
            grad.scale(slope as f32);
        }
        self.loss.loss(sum)
    }

    fn slope_along(&self, dose: &SealedField, step: &SealedField, alpha: f32) -> (f64, f64) {
        let moved = |i: usize| dose.at(i) + alpha * step.at(i);
        let (sum, slope) = self.pass(moved, |i| step.at(i), |_, _| {});
        (self.loss.loss(sum), self.loss.loss_slope(sum) * slope)
    }

    fn advance(&self, dose: &mut SealedField, step: &mut SealedField, alpha: f32) -> f64 {
        dose.axpy(alpha, step);
        self.value_and_gradient(dose, step)
    }
}
