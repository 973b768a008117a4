//! Parameters of least squares, with their standard errors.
//!
//! **Equation** the least Σᵢ rᵢ(θ)², by Levenberg's and Marquardt's method: (JᵀJ + λ·diag JᵀJ)·δ = −Jᵀr, λ smaller after a step that
//! helps and larger after one that does not. Standard errors are the roots of the diagonal of s²·(JᵀJ)⁻¹, s² = Σ r²/(points − parameters).
//!
//! **Source** Marquardt, SIAM J. Appl. Math. 11 (1963) 431.
//!
//! **Limits** it finds the valley in which it starts. A residual that is not finite refuses the step. **Cost** points × parameters² a
//! step, 500 steps at most.
//!
//! ```
//! use tomolith_core::least_squares::minimize;
//! // y = a + b·x through (0, 1), (1, 3), (2, 4): a = 7/6, b = 3/2, Σ r² = 1/6 over one degree of freedom
//! let y = [1.0, 3.0, 4.0];
//! let line = minimize(&[0.0, 0.0], y.len(), |theta, i, slopes| {
//!     slopes.copy_from_slice(&[1.0, i as f64]);
//!     theta[0] + theta[1] * i as f64 - y[i]
//! });
//! assert!((line.parameters[0] - 7.0 / 6.0).abs() < 1e-9 && (line.parameters[1] - 1.5).abs() < 1e-9);
//! let errors = line.errors(0.0, y.len()).unwrap();
//! assert!((errors[1] - (1.0f64 / 6.0 / 2.0).sqrt()).abs() < 1e-9); // s²/Σ(x − x̄)²
//! ```

/// Parameters with the least sum of squares.
#[derive(Clone, Debug, PartialEq)]
pub struct Minimum {
    /// θ
    pub parameters: Vec<f64>,
    /// Σ r²
    pub cost: f64,
    /// JᵀJ there.
    normal: Vec<Vec<f64>>,
}

impl Minimum {
    /// Standard errors of the parameters. `scatter` is a sum of squares that no parameter changes (of measurements about the mean that
    /// stands for them); `measurements` counts them all. None without a degree of freedom, or where the points do not fix every parameter.
    #[must_use]
    pub fn errors(&self, scatter: f64, measurements: usize) -> Option<Vec<f64>> {
        let n = self.parameters.len();
        let freedom = measurements.checked_sub(n).filter(|f| *f > 0)?;
        let variance = (self.cost + scatter) / freedom as f64;
        let error = |i: usize| {
            let unit = (0..n).map(|k| f64::from(u8::from(k == i))).collect();
            let column = solve(self.normal.clone(), unit);
            Some((variance * column[i]).sqrt()).filter(|e| e.is_finite())
        };
        (0..n).map(error).collect()
    }
}

/// The least Σ of squares of `points` residuals, from `start`. `residual(θ, i, slopes)` is rᵢ and writes its derivatives by θ.
#[must_use]
pub fn minimize(
    start: &[f64],
    points: usize,
    residual: impl Fn(&[f64], usize, &mut [f64]) -> f64,
) -> Minimum {
    let n = start.len();
    let mut slopes = vec![0.0; n];
    let mut theta = start.to_vec();
    let mut cost_of = |theta: &[f64]| -> f64 {
        (0..points)
            .map(|i| residual(theta, i, &mut slopes).powi(2))
            .sum()
    };
    let mut cost = cost_of(&theta);
    let mut damping = 1e-3;
    for _ in 0..500 {
        let (mut matrix, right) = normal(&theta, points, &residual);
        for (i, row) in matrix.iter_mut().enumerate() {
            row[i] = row[i] * (1.0 + damping) + 1e-300;
        }
        let step = solve(matrix, right);
        let next: Vec<f64> = theta.iter().zip(&step).map(|(t, s)| t + s).collect();
        let reached = cost_of(&next);
        if reached < cost {
            let settled = cost - reached <= 1e-15 * cost;
            (theta, cost, damping) = (next, reached, (damping * 0.3).max(1e-12));
            if settled {
                break;
            }
        } else {
            damping *= 4.0;
            if damping > 1e12 {
                break;
            }
        }
    }
    at(&theta, points, residual)
}

/// These parameters as they are, though others may be better.
#[must_use]
pub fn at(
    theta: &[f64],
    points: usize,
    residual: impl Fn(&[f64], usize, &mut [f64]) -> f64,
) -> Minimum {
    let mut slopes = vec![0.0; theta.len()];
    let square = |i| residual(theta, i, &mut slopes).powi(2);
    Minimum {
        parameters: theta.to_vec(),
        cost: (0..points).map(square).sum(),
        normal: normal(theta, points, &residual).0,
    }
}

/// JᵀJ and −Jᵀr.
fn normal(
    theta: &[f64],
    points: usize,
    residual: &impl Fn(&[f64], usize, &mut [f64]) -> f64,
) -> (Vec<Vec<f64>>, Vec<f64>) {
    let n = theta.len();
    let (mut matrix, mut right) = (vec![vec![0.0; n]; n], vec![0.0; n]);
    let mut slopes = vec![0.0; n];
    for point in 0..points {
        let rest = residual(theta, point, &mut slopes);
        for i in 0..n {
            right[i] -= slopes[i] * rest;
            for j in 0..n {
                matrix[i][j] += slopes[i] * slopes[j];
            }
        }
    }
    (matrix, right)
}

/// A small system of equations, by elimination with the largest pivot; not finite where it has no one solution.
#[must_use]
pub fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for i in 0..n {
        let pivot = (i..n)
            .max_by(|&p, &q| a[p][i].abs().total_cmp(&a[q][i].abs()))
            .unwrap_or(i);
        a.swap(i, pivot);
        b.swap(i, pivot);
        for row in i + 1..n {
            let factor = a[row][i] / a[i][i];
            let above = a[i].clone();
            a[row]
                .iter_mut()
                .zip(above)
                .for_each(|(cell, up)| *cell -= factor * up);
            b[row] -= factor * b[i];
        }
    }
    let mut x = vec![0.0; n];
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| a[i][j] * x[j]).sum();
        x[i] = (b[i] - known) / a[i][i];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::near;

    /// Misra1a of NIST's Statistical Reference Datasets: y = b₁·(1 − e^(−b₂x)), certified values and standard deviations.
    #[test]
    fn certified_parameters_and_errors_come_out() {
        let x = [
            77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1,
            689.1, 760.0,
        ];
        let y = [
            10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40,
            75.47, 81.78,
        ];
        let found = minimize(&[500.0, 1e-4], x.len(), |b, i, slopes| {
            let rest = (-b[1] * x[i]).exp();
            slopes.copy_from_slice(&[1.0 - rest, b[0] * x[i] * rest]);
            b[0] * (1.0 - rest) - y[i]
        });
        let errors = found.errors(0.0, x.len()).unwrap();
        for (found, certified) in found.parameters.iter().chain(&errors).zip([
            2.389_421_291_8E+02,
            5.501_564_318_1E-04,
            2.707_007_524_1,
            7.266_868_823_6E-06,
        ]) {
            near!(found / certified, 1.0, 1e-6, "{found} {certified}");
        }
        assert!((found.cost / 1.245_513_889_4E-01 - 1.0).abs() < 1e-8);
    }

    #[test]
    fn what_points_do_not_fix_has_no_error() {
        // The second parameter does nothing
        let found = minimize(&[0.0, 1.0], 3, |t, i, slopes| {
            slopes.copy_from_slice(&[1.0, 0.0]);
            t[0] - i as f64
        });
        assert!((found.parameters[0] - 1.0).abs() < 1e-9);
        assert_eq!(found.errors(0.0, 3), None);
        assert_eq!(found.errors(0.0, 2), None);
    }
}
