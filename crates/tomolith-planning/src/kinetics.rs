//! Inhibitor and sub-linear kinetics from curing times at several irradiances.
//!
//! **Equation** with inhibitor O (1 = saturated)
//!
//! ```text
//! dO/dt = k(1 − O) − κI       induction t_i = −ln(1 − I_min/I)/k,  I_min = k/κ
//! dE/dt = (I/I₁)^m            cure      t_c = t₁·(I/I₁)^(−m),      0 ≤ m ≤ 1,  I₁ = the largest irradiance measured
//! ```
//!
//! and t = t_i + t_c. Fitted by least squares of ln t: I_min (below the lowest irradiance), k, t₁, m. Where the best m is beyond its range, it is fixed
//! at the end; standard errors count how uncertain m is there, too.
//!
//! **Source** zeroth-order consumption: Wang et al. 2022, supplement, Fig. S12; sub-linear rates: there, Fig. S11; the sum is ours. **Units** mW/cm², s.
//! **Limits** four irradiances. One volume without space: light is even, inhibitor flows in at the rate k only.
//!
//! ```
//! use tomolith_planning::kinetics::Kinetics;
//! let resin = Kinetics { min_irradiance: 2.0, supply_per_s: 0.01, cure_s: 30.0, order: 0.5, reference: 8.0 };
//! // induction −ln(1 − 2/4)/0.01 = 69.3 s, cure 30·√2 = 42.4 s
//! assert!((resin.time_s(4.0).unwrap() - 111.74).abs() < 0.01);
//! assert_eq!(resin.time_s(1.0), None); // half of the inhibitor is used up at most
//! assert_eq!(resin.inhibitor_used(1.0), 0.5);
//! ```

use serde::Serialize;
use tomolith_core::error::{Error, Result};
use tomolith_core::least_squares::{Minimum, at, minimize};
use tomolith_core::response::curve::Curve;
use tomolith_report::plot::{Axis, Plot};

/// A resin of one volume.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Kinetics {
    /// I_min: below it nothing cures, mW/cm².
    pub min_irradiance: f64,
    /// k: rate at which inhibitor flows back, 1/s.
    pub supply_per_s: f64,
    /// t₁: curing time after induction at the reference irradiance, s.
    pub cure_s: f64,
    /// m: order of the rate of cure in the irradiance.
    pub order: f64,
    /// I₁, mW/cm².
    pub reference: f64,
}

impl Kinetics {
    /// Time until the resin is cured; None at irradiances at which it never is.
    #[must_use]
    pub fn time_s(&self, irradiance: f64) -> Option<f64> {
        (irradiance > self.min_irradiance).then(|| {
            let induction = -(-self.min_irradiance / irradiance).ln_1p() / self.supply_per_s;
            induction + self.cure_s * (irradiance / self.reference).powf(-self.order)
        })
    }

    /// The largest share of the inhibitor that light of this irradiance ever uses up.
    #[must_use]
    pub fn inhibitor_used(&self, irradiance: f64) -> f64 {
        (irradiance / self.min_irradiance).min(1.0)
    }

    /// 1/κ: areal dose that uses up all inhibitor where none flows back, mJ/cm².
    #[must_use]
    pub fn inhibitor_dose(&self) -> f64 {
        self.min_irradiance / self.supply_per_s
    }
}

/// What was fitted, and how well.
#[derive(Clone, Debug, Serialize)]
pub struct KineticsFit {
    /// The resin.
    pub kinetics: Kinetics,
    /// Standard errors of I_min, k, t₁ and m; None where the points do not fix them.
    pub errors: Option<[f64; 4]>,
    /// Whether the best m is beyond its range, and the resin has the end of it.
    pub is_order_at_end: bool,
    /// Time of the fit over the measured one, minus 1, from the lowest irradiance on.
    pub residuals: Vec<f64>,
    /// The largest areal dose I·t that was needed over the smallest one, minus 1: what a pure dose threshold misses.
    pub dose_spread: f64,
}

impl KineticsFit {
    /// The largest residual, without its sign.
    #[must_use]
    pub fn worst(&self) -> f64 {
        self.residuals
            .iter()
            .fold(0.0, |worst, r| worst.max(r.abs()))
    }
}

/// The resin nearest to irradiances (mW/cm², the doses of the curve) and times (s, its responses).
///
/// # Errors
/// [`Error::Config`] for fewer than four irradiances or numbers that are not above 0.
pub fn fit(table: &Curve) -> Result<KineticsFit> {
    let (x, y) = (&table.doses, &table.responses);
    if x.len() < 4 {
        return Err(Error::config(
            "irradiance",
            format!("found {} irradiances", x.len()),
            "at least four, which I_min, k, t₁ and m need",
        ));
    }
    for (key, values) in [("irradiance", x), ("time", y)] {
        if let Some(value) = values.iter().find(|v| **v <= 0.0) {
            return Err(Error::refused(key, value, "numbers above 0"));
        }
    }
    let fit = Fit { x, y };
    let free = fit.best(None);
    let order = free.parameters[3];
    let end = order.clamp(0.0, 1.0);
    let minimum = if order == end {
        free
    } else {
        let mut theta = fit.best(Some(end)).parameters;
        theta.push(end);
        at(&theta, x.len(), |theta, i, slopes| {
            fit.residual(theta, None, i, slopes)
        })
    };
    let kinetics = fit.kinetics(&minimum.parameters, None);
    let used = kinetics.min_irradiance / x[0];
    let errors = minimum.errors(0.0, x.len()).map(|e| {
        [
            e[0] * kinetics.min_irradiance * (1.0 - used),
            e[1] * kinetics.supply_per_s,
            e[2] * kinetics.cure_s,
            e[3],
        ]
    });
    let residuals = x.iter().zip(y).map(|(x, y)| {
        let time = kinetics.time_s(*x).unwrap_or(f64::INFINITY);
        time / y - 1.0
    });
    let doses = || x.iter().zip(y).map(|(x, y)| x * y);
    Ok(KineticsFit {
        kinetics,
        errors,
        is_order_at_end: order != end,
        residuals: residuals.collect(),
        dose_spread: doses().fold(0.0, f64::max) / doses().fold(f64::INFINITY, f64::min) - 1.0,
    })
}

struct Fit<'a> {
    x: &'a [f64],
    y: &'a [f64],
}

impl Fit<'_> {
    /// Parameters: logit of I_min over the lowest irradiance, ln k, ln t₁, and m unless it is fixed.
    fn kinetics(&self, theta: &[f64], order: Option<f64>) -> Kinetics {
        let used = 1.0 / (1.0 + (-theta[0]).exp());
        Kinetics {
            min_irradiance: used * self.x[0],
            supply_per_s: theta[1].exp(),
            cure_s: theta[2].exp(),
            order: order.unwrap_or_else(|| theta[3]),
            reference: self.x[self.x.len() - 1],
        }
    }

    /// The least of several valleys.
    fn best(&self, order: Option<f64>) -> Minimum {
        let shortest = self.y.iter().copied().fold(f64::INFINITY, f64::min);
        let mut best: Option<Minimum> = None;
        for logit in [-1.0, 1.0, 3.0] {
            for share in [0.1, 0.5, 0.9] {
                // Induction takes a share of the shortest time
                let used = 1.0 / (1.0 + f64::exp(-logit));
                let y = used * self.x[0] / self.x[self.x.len() - 1];
                let supply = -(-y).ln_1p() / (share * shortest);
                let mut start = vec![logit, supply.ln(), ((1.0 - share) * shortest).ln()];
                start.extend(order.is_none().then_some(0.5));
                let found = minimize(&start, self.x.len(), |theta, i, slopes| {
                    self.residual(theta, order, i, slopes)
                });
                if found.cost.is_finite() && best.as_ref().is_none_or(|b| found.cost < b.cost) {
                    best = Some(found);
                }
            }
        }
        // A start is finite by construction
        best.unwrap_or_else(|| minimize(&[0.0; 4], 0, |_, _, _| 0.0))
    }

    /// ln of time over measured time, and its derivatives.
    fn residual(&self, theta: &[f64], order: Option<f64>, i: usize, slopes: &mut [f64]) -> f64 {
        let k = self.kinetics(theta, order);
        let (x, y) = (self.x[i], k.min_irradiance / self.x[i]);
        let induction = -(-y).ln_1p() / k.supply_per_s;
        let ratio = x / k.reference;
        let cure = k.cure_s * ratio.powf(-k.order);
        let time = induction + cure;
        let used = k.min_irradiance / self.x[0];
        slopes[0] = k.min_irradiance * (1.0 - used) / (x * (1.0 - y) * k.supply_per_s) / time;
        slopes[1] = -induction / time;
        slopes[2] = cure / time;
        if let Some(slope) = slopes.get_mut(3) {
            *slope = -ratio.ln() * cure / time;
        }
        (time / self.y[i]).ln()
    }
}

/// Measured times, those of the fit, and those of one critical dose (the geometric mean).
#[must_use]
pub fn plot(table: &Curve, fit: &KineticsFit) -> String {
    let (x, y) = (&table.doses, &table.responses);
    let (first, last) = (x[0], x[x.len() - 1]);
    let logs: f64 = x.iter().zip(y).map(|(x, y)| (x * y).ln()).sum();
    let dose = (logs / x.len() as f64).exp();
    let from = f64::max(0.9 * first, 1.001 * fit.kinetics.min_irradiance);
    let at = |i: i32| from + (1.05 * last - from) * f64::from(i) / 200.0;
    let most = 1.3 * y.iter().copied().fold(0.0, f64::max);
    let mut plot = Plot::new(
        Axis::linear("irradiance, mW/cm²", 0.8 * first, 1.05 * last),
        Axis::linear("curing time, s", 0.0, most),
    );
    let constant: Vec<[f64; 2]> = (0..=200).map(|i| [at(i), dose / at(i)]).collect();
    plot.line(&constant, "still", "one critical dose");
    let line = (0..=200).filter_map(|i| Some([at(i), fit.kinetics.time_s(at(i))?]));
    let line: Vec<[f64; 2]> = line.filter(|p| p[1] <= most).collect();
    plot.line(&line, "accent", "inhibitor and kinetics");
    let points: Vec<[f64; 2]> = x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
    plot.dots(&points, "gel", "measured");
    plot.file("Curing time against irradiance")
}
