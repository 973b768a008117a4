//! Inhibitor and sub-linear kinetics from curing times at several irradiances.
//!
//! **Equation** with inhibitor O (1 = saturated)
//!
//! ```text
//! dO/dt = k(1 − O) − κI       induction t_i = −ln(1 − I_min/I)/k,  I_min = k/κ
//! dE/dt = (I/I₁)^m            cure      t_c = t₁·(I/I₁)^(−m),      0 ≤ m ≤ 1,  I₁ = the largest irradiance measured
//! ```
//!
//! and t = t_i + t_c. Fitted by least squares of ln t: I_min (below the lowest irradiance), k, t₁, m. How uncertain each is, the profile of the sum of squares
//! says ([`KineticsFit::ranges`]): towards k → 0 at constant κ the times hardly change, and a standard error from slopes would be far too small.
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
use tomolith_core::least_squares::{at, minimize};
use tomolith_core::response::curve::Curve;
use tomolith_report::plot::{Axis, Plot};

/// The t within which 68 % of Student's distribution lie (expansion in 1/ν about 1 standard deviation: 1.81 at ν = 1, where 1.84 is right).
fn student(freedom: f64) -> f64 {
    1.0 + 0.5 / freedom + 0.25 / freedom.powi(2) + 0.0625 / freedom.powi(3)
}

/// ln of how far a parameter is followed: a factor of 10⁶.
const FARTHEST: f64 = 14.0;

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
    /// Of I_min, k, t₁ and m, each: between which values the sum of squares, least over the others, is at most t²s² above the least, with s² the least over
    /// points − 4 and t from Student's distribution: 68 % where the law is nearly linear. An end is 0 or infinite where none is found. None for four
    /// points or fewer.
    pub ranges: Option<[[f64; 2]; 4]>,
    /// Whether no m within its range is better than the end of it that the resin has.
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
    let best = fit.best();
    let kinetics = fit.kinetics(&best.theta);
    let residuals = x.iter().zip(y).map(|(x, y)| {
        let time = kinetics.time_s(*x).unwrap_or(f64::INFINITY);
        time / y - 1.0
    });
    let doses = || x.iter().zip(y).map(|(x, y)| x * y);
    Ok(KineticsFit {
        kinetics,
        ranges: fit.ranges(&best),
        is_order_at_end: best.is_order_at_end,
        residuals: residuals.collect(),
        dose_spread: doses().fold(0.0, f64::max) / doses().fold(f64::INFINITY, f64::min) - 1.0,
    })
}

struct Fit<'a> {
    x: &'a [f64],
    y: &'a [f64],
}

/// Where among [`Theta`] the order is.
const ORDER: usize = 3;

/// Logit of I_min over the lowest irradiance, ln k, ln t₁, and m.
type Theta = [f64; 4];

/// Parameters with the least sum of squares, of those that were free.
#[derive(Clone, Copy)]
struct Least {
    theta: Theta,
    cost: f64,
    is_order_at_end: bool,
}

impl Fit<'_> {
    fn kinetics(&self, theta: &Theta) -> Kinetics {
        let used = 1.0 / (1.0 + (-theta[0]).exp());
        Kinetics {
            min_irradiance: used * self.x[0],
            supply_per_s: theta[1].exp(),
            cure_s: theta[2].exp(),
            order: theta[ORDER],
            reference: self.x[self.x.len() - 1],
        }
    }

    /// The least with an order of its range. Where the least of all is beyond the range, one within it may still be less than both ends.
    fn best(&self) -> Least {
        let free = self.least_of_valleys(0.5, &[0, 1, 2, ORDER]);
        if (0.0..=1.0).contains(&free.theta[ORDER]) {
            return free;
        }
        let of = |order| self.least_of_valleys(order, &[0, 1, 2]);
        let all: Vec<Least> = (0..=20).map(|i| of(f64::from(i) / 20.0)).collect();
        let (i, least) = (all.iter().enumerate())
            .min_by(|a, b| a.1.cost.total_cmp(&b.1.cost))
            .map_or((0, free), |(i, least)| (i, *least));
        let [mut low, mut high] =
            [i.saturating_sub(1), (i + 1).min(20)].map(|i| all[i].theta[ORDER]);
        // Golden section: each time the third without the lesser of two is left out
        let share = 0.5 * (5f64.sqrt() - 1.0);
        let mut inner = least;
        while high - low > 1e-7 {
            let [left, right] = [high - share * (high - low), low + share * (high - low)]
                .map(|order| self.least_with(&least.theta, ORDER, order));
            for found in [left, right] {
                if found.cost < inner.cost {
                    inner = found;
                }
            }
            if left.cost < right.cost {
                high = right.theta[ORDER];
            } else {
                low = left.theta[ORDER];
            }
        }
        // What rounding makes of a least at an end is no order within the range
        let best = if inner.cost < least.cost * (1.0 - 1e-9) {
            inner
        } else {
            least
        };
        Least {
            is_order_at_end: [0.0, 1.0].contains(&best.theta[ORDER]),
            ..best
        }
    }

    /// The least of several valleys, in which the parameters that are not free stay as they begin.
    fn least_of_valleys(&self, order: f64, free: &[usize]) -> Least {
        let shortest = self.y.iter().copied().fold(f64::INFINITY, f64::min);
        let mut best: Option<Least> = None;
        for logit in [-1.0, 1.0, 3.0] {
            for share in [0.1, 0.5, 0.9] {
                // Induction takes a share of the shortest time
                let used = 1.0 / (1.0 + f64::exp(-logit));
                let y = used * self.x[0] / self.x[self.x.len() - 1];
                let supply = -(-y).ln_1p() / (share * shortest);
                let start = [logit, supply.ln(), ((1.0 - share) * shortest).ln(), order];
                let found = self.least(&start, free);
                if found.cost.is_finite() && best.is_none_or(|b| found.cost < b.cost) {
                    best = Some(found);
                }
            }
        }
        // A start is finite by construction
        best.unwrap_or_else(|| self.least(&[0.0; 4], &[]))
    }

    /// The least from a start, in which the parameters that are not free stay as they begin.
    fn least(&self, start: &Theta, free: &[usize]) -> Least {
        let whole = |part: &[f64]| {
            let mut theta = *start;
            free.iter()
                .zip(part)
                .for_each(|(i, value)| theta[*i] = *value);
            theta
        };
        let part: Vec<f64> = free.iter().map(|i| start[*i]).collect();
        let found = minimize(&part, self.x.len(), |part, point, slopes| {
            let (rest, all) = self.residual(&whole(part), point);
            slopes
                .iter_mut()
                .zip(free)
                .for_each(|(slope, i)| *slope = all[*i]);
            rest
        });
        Least {
            theta: whole(&found.parameters),
            cost: found.cost,
            is_order_at_end: false,
        }
    }

    /// The least with one parameter of this value and an order of its range, in the valley of a start.
    fn least_with(&self, start: &Theta, parameter: usize, value: f64) -> Least {
        let mut start = *start;
        start[parameter] = value;
        let free: Vec<usize> = (0..4).filter(|i| *i != parameter).collect();
        let found = self.least(&start, &free);
        if (0.0..=1.0).contains(&found.theta[ORDER]) {
            return found;
        }
        let free: Vec<usize> = (0..ORDER).filter(|i| *i != parameter).collect();
        let [first, second, third] = [start[ORDER], 0.0, 1.0].map(|order| {
            start[ORDER] = order;
            self.least(&start, &free)
        });
        let lesser = |a: Least, b: Least| if b.cost < a.cost { b } else { a };
        lesser(first, lesser(second, third))
    }

    /// Of I_min, k, t₁ and m; None without a degree of freedom.
    fn ranges(&self, best: &Least) -> Option<[[f64; 2]; 4]> {
        let (points, start) = (self.x.len(), best.theta);
        let linear = at(&start, points, |theta, i, slopes| {
            let theta = [theta[0], theta[1], theta[2], theta[ORDER]];
            let (rest, all) = self.residual(&theta, i);
            slopes.copy_from_slice(&all);
            rest
        });
        if points <= 4 {
            return None;
        }
        // First steps alone: any will do where the points leave a parameter open
        let errors = linear.errors(0.0, points);
        let errors = errors.unwrap_or_else(|| vec![1.0; 4]);
        let freedom = (points - 4) as f64;
        let most = best.cost * (1.0 + student(freedom).powi(2) / freedom);
        let ends = |parameter: usize| {
            [-1.0, 1.0].map(|side| self.end(best, parameter, side * errors[parameter], most))
        };
        let [logit, ln_supply, ln_cure, order] = [ends(0), ends(1), ends(2), ends(ORDER)];
        Some([
            logit.map(|t| self.x[0] / (1.0 + (-t).exp())),
            ln_supply.map(f64::exp),
            ln_cure.map(f64::exp),
            order,
        ])
    }

    /// How far a parameter may go, in steps of this sign, until the least of all others is above `most`; infinite where it never is.
    fn end(&self, best: &Least, parameter: usize, step: f64, most: f64) -> f64 {
        let within = |value: f64| match parameter {
            ORDER => value.clamp(0.0, 1.0),
            _ => value,
        };
        let mut inside = best.theta;
        let mut step = step.clamp(-1.0, 1.0);
        let mut outside = loop {
            let value = within(inside[parameter] + step);
            if value == inside[parameter] {
                return value;
            }
            if (value - best.theta[parameter]).abs() > FARTHEST {
                return step.signum() * f64::INFINITY;
            }
            let found = self.least_with(&inside, parameter, value);
            if found.cost > most || found.cost.is_nan() {
                break value;
            }
            inside = found.theta;
            step *= 2.0;
        };
        for _ in 0..12 {
            let value = 0.5 * (inside[parameter] + outside);
            let found = self.least_with(&inside, parameter, value);
            if found.cost <= most {
                inside = found.theta;
            } else {
                outside = value;
            }
        }
        inside[parameter]
    }

    /// ln of time over measured time, and its derivatives.
    fn residual(&self, theta: &Theta, i: usize) -> (f64, Theta) {
        let k = self.kinetics(theta);
        let (x, y) = (self.x[i], k.min_irradiance / self.x[i]);
        let induction = -(-y).ln_1p() / k.supply_per_s;
        let ratio = x / k.reference;
        let cure = k.cure_s * ratio.powf(-k.order);
        let time = induction + cure;
        let used = k.min_irradiance / self.x[0];
        let slopes = [
            k.min_irradiance * (1.0 - used) / (x * (1.0 - y) * k.supply_per_s) / time,
            -induction / time,
            cure / time,
            -ratio.ln() * cure / time,
        ];
        ((time / self.y[i]).ln(), slopes)
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
