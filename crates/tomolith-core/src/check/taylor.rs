//! Taylor test: what a derivative leaves of a change falls with the square of the step.
//!
//! ```text
//! R(h) = |f(x + h·d) − f(x) − h·f′(x)d| = O(h²)
//! ```
//! A derivative that is off by a share ε leaves ε·h·f′d, which falls with h alone: where steps go over decades, it shows however small ε is. A quotient
//! of differences at one step does not tell the two apart.
//!
//! ```
//! use tomolith_core::check::taylor::Remainders;
//! let steps = Remainders::over(2, 0.1, &|h| (1.0 + f64::from(h)).ln(), 1.0);
//! assert!((steps.order() - 2.0).abs() < 0.05);
//! // A slope that is 1 % too large
//! let steps = Remainders::over(2, 0.1, &|h| (1.0 + f64::from(h)).ln(), 1.01);
//! assert!(steps.orders().iter().any(|order| *order < 1.2));
//! ```

/// Steps in a decade.
const STEPS: usize = 3;

/// What is left of a change, over the step.
#[derive(Clone, Debug, PartialEq)]
pub struct Remainders {
    /// \[step, remainder\], the largest step first.
    pub points: Vec<[f64; 2]>,
}

impl Remainders {
    /// Of a function along a direction and its slope at 0, for steps over so many decades below the largest, three a decade.
    #[must_use]
    pub fn over(decades: usize, largest: f64, value: &dyn Fn(f32) -> f64, slope: f64) -> Self {
        let at = value(0.0);
        let point_of = |i: usize| {
            let step = (largest * 10f64.powf(-(i as f64) / STEPS as f64)) as f32;
            let change = value(step) - at;
            let step = f64::from(step);
            [step, (change - step * slope).abs()]
        };
        Remainders {
            points: (0..=decades * STEPS).map(point_of).collect(),
        }
    }

    /// With which power of the step they fall, from one to the next.
    #[must_use]
    pub fn orders(&self) -> Vec<f64> {
        let order = |pair: &[[f64; 2]]| {
            let [[h, before], [less, after]] = [pair[0], pair[1]];
            (before / after).ln() / (h / less).ln()
        };
        self.points.windows(2).map(order).collect()
    }

    /// With which power they fall over all steps.
    #[must_use]
    pub fn order(&self) -> f64 {
        let orders = self.orders();
        orders.iter().sum::<f64>() / orders.len() as f64
    }
}
