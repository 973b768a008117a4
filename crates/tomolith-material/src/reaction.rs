//! What one block of even light does in a voxel: stages that take from the drive, one after the other, and their transposes.
//!
//! The drive u (mJ/mm³ within the block) enters; each stage changes its own state and hands on what is left. All are exact for light that is even
//! over the block, so their result does not depend on how a block is cut.

/// A stage, with the places of its states among those of its network.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stage {
    /// P′ = P e^(−x), u′ = u (P/L)(1 − e^(−x))/x, x = b u/L: L is the share that the light was computed with.
    Bleach { share: usize, lit: usize, rate: f32 },
    /// O′ = max(0, O − u/capacity); u < 0 makes inhibitor.
    Inhibit { at: usize, capacity: f32 },
    /// dO/dt ∝ −O/(O + half); u < 0 makes inhibitor.
    InhibitSmoothly { at: usize, capacity: f32, half: f32 },
    /// E′ = E + u
    Dose { at: usize },
    /// C′ = 1 − (1 − C) e^(−rate·(u/Δt)^exponent·Δt)
    Rate { at: usize, rate: f32, exponent: f32 },
}

/// (1 − e^(−x))/x and its slope.
#[inline]
fn mean_exponential(x: f32) -> (f32, f32) {
    if x < 1e-2 {
        return (1.0 - x / 2.0 + x * x / 6.0, -0.5 + x / 3.0);
    }
    let mean = -(-x).exp_m1() / x;
    (mean, ((-x).exp() - mean) / x)
}

/// y with o(1 − e^(−y)) + half·y = v: the inhibitor falls by e^(−y). Newton's steps from below never overshoot.
#[inline]
fn fall(o: f32, half: f32, v: f32) -> f32 {
    let mut y = (v / (o + half)).max((v - o) / half);
    for _ in 0..40 {
        let left = o * (-y).exp();
        let step = (v - half * y - (o - left)) / (left + half);
        y += step.max(0.0);
        if step <= 1e-6 * (1.0 + y) {
            break;
        }
    }
    y
}

/// ΔK = rate·(u/Δt)^exponent·Δt
#[inline]
fn progress(u: f32, rate: f32, exponent: f32, seconds: f32) -> f32 {
    let power = u.max(0.0) / seconds;
    let power = if exponent == 1.0 {
        power
    } else if exponent == 0.5 {
        power.sqrt()
    } else {
        power.powf(exponent)
    };
    rate * power * seconds
}

impl Stage {
    /// Changes the states, and u to what is left of it.
    pub(crate) fn forward(&self, states: &mut [&mut [f32]], u: &mut [f32], seconds: f32) {
        match *self {
            Stage::Bleach { share, lit, rate } => {
                for (i, u) in u.iter_mut().enumerate() {
                    let l = states[lit][i];
                    if *u > 0.0 && l > 0.0 {
                        let x = rate * *u / l;
                        *u *= states[share][i] / l * mean_exponential(x).0;
                        states[share][i] *= (-x).exp();
                    }
                }
            }
            Stage::Inhibit { at, capacity } => {
                let per_energy = capacity.recip();
                for (u, o) in u.iter_mut().zip(states[at].iter_mut()) {
                    let used = u.min(*o * capacity);
                    *o = (*o - *u * per_energy).max(0.0);
                    *u = (*u - used).max(0.0);
                }
            }
            Stage::InhibitSmoothly { at, capacity, half } => {
                for (u, o) in u.iter_mut().zip(states[at].iter_mut()) {
                    let v = *u / capacity;
                    if v < 0.0 {
                        *o -= v;
                        *u = 0.0;
                    } else if *o > 0.0 && v > 0.0 {
                        let y = fall(*o, half, v);
                        *o *= (-y).exp();
                        *u = capacity * half * y;
                    }
                }
            }
            Stage::Dose { at } => {
                for (u, e) in u.iter().zip(states[at].iter_mut()) {
                    *e += u.max(0.0);
                }
            }
            Stage::Rate { at, rate, exponent } => {
                for (u, c) in u.iter().zip(states[at].iter_mut()) {
                    let k = progress(*u, rate, exponent, seconds);
                    *c -= (1.0 - *c) * (-k).exp_m1();
                }
            }
        }
    }

    /// From cotangents after the stage to those before it, at states and u before it; `du` is that of u.
    pub(crate) fn pullback(
        &self,
        before: &[&[f32]],
        u: &[f32],
        cotangent: &mut [&mut [f32]],
        du: &mut [f32],
        seconds: f32,
    ) {
        match *self {
            Stage::Bleach { share, lit, rate } => {
                for (i, (&u, du)) in u.iter().zip(du).enumerate() {
                    let (l, p) = (before[lit][i], before[share][i]);
                    if u > 0.0 && l > 0.0 {
                        let x = rate * u / l;
                        let (mean, slope) = mean_exponential(x);
                        let left = (-x).exp();
                        let dp = cotangent[share][i];
                        cotangent[share][i] = dp * left + *du * u / l * mean;
                        // d(u·mean)/du = mean + x·slope
                        *du = *du * p / l * (mean + x * slope) - dp * p * left * rate / l;
                    }
                }
            }
            Stage::Inhibit { at, capacity } => {
                let there = before[at].iter().zip(cotangent[at].iter_mut());
                for ((&u, du), (&o, d_o)) in u.iter().zip(du).zip(there) {
                    if u < o * capacity {
                        // All is taken (or made)
                        *du = -*d_o / capacity;
                    } else {
                        *d_o = -*du * capacity;
                    }
                }
            }
            Stage::InhibitSmoothly { at, capacity, half } => {
                let there = before[at].iter().zip(cotangent[at].iter_mut());
                for ((&u, du), (&o, d_o)) in u.iter().zip(du).zip(there) {
                    let v = u / capacity;
                    if v < 0.0 {
                        *du = -*d_o / capacity;
                        continue;
                    }
                    let y = fall(o, half, v);
                    let left = (-y).exp();
                    let y_by_v = (o * left + half).recip();
                    let y_by_o = -(1.0 - left) * y_by_v;
                    // Of O′ = O e^(−y) and u′ = capacity·half·y
                    let (after, of_u) = (*d_o, *du);
                    let of_y = capacity * half * of_u - o * left * after;
                    *d_o = left * after + of_y * y_by_o;
                    *du = of_y * y_by_v / capacity;
                }
            }
            Stage::Dose { at } => {
                for ((&u, du), &de) in u.iter().zip(du).zip(cotangent[at].iter()) {
                    *du = if u > 0.0 { de } else { 0.0 };
                }
            }
            Stage::Rate { at, rate, exponent } => {
                let there = before[at].iter().zip(cotangent[at].iter_mut());
                for ((&u, du), (&c, dc)) in u.iter().zip(du).zip(there) {
                    let k = progress(u, rate, exponent, seconds);
                    let left = (-k).exp();
                    // The slope of a root at no light at all is left out
                    *du = if u > 0.0 {
                        *dc * (1.0 - c) * left * exponent * k / u
                    } else {
                        0.0
                    };
                    *dc *= left;
                }
            }
        }
    }
}

/// H: 0 up to −½, 1 from ½ on, 3s² − 2s³ between (s = x + ½); and its slope.
///
/// A width of 0 makes it a step: infinite arguments are fine.
#[inline]
pub(crate) fn smooth_step(x: f32) -> (f32, f32) {
    let s = (x + 0.5).clamp(0.0, 1.0);
    (s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLEACH: Stage = Stage::Bleach {
        share: 0,
        lit: 1,
        rate: 0.4,
    };
    const INHIBIT: Stage = Stage::Inhibit {
        at: 0,
        capacity: 1.7,
    };

    fn smoothly(half: f32) -> Stage {
        Stage::InhibitSmoothly {
            at: 0,
            capacity: 1.7,
            half,
        }
    }

    fn by_rate(exponent: f32) -> Stage {
        Stage::Rate {
            at: 0,
            rate: 0.8,
            exponent,
        }
    }

    fn all() -> Vec<(Stage, Vec<f32>)> {
        vec![
            (BLEACH, vec![0.7, 0.9]),
            (INHIBIT, vec![0.6]),
            (smoothly(0.05), vec![0.6]),
            (Stage::Dose { at: 0 }, vec![0.3]),
            (by_rate(0.5), vec![0.3]),
            (by_rate(0.7), vec![0.3]),
            (by_rate(1.0), vec![0.3]),
        ]
    }

    /// States and u after a stage, of one voxel.
    fn after(stage: Stage, states: &[f32], u: f32, seconds: f32) -> (Vec<f32>, f32) {
        let mut states: Vec<Vec<f32>> = states.iter().map(|&v| vec![v]).collect();
        let mut u = [u];
        let mut views: Vec<&mut [f32]> = states.iter_mut().map(Vec::as_mut_slice).collect();
        stage.forward(&mut views, &mut u, seconds);
        (states.concat(), u[0])
    }

    #[test]
    fn what_is_used_and_what_is_left_add_up() {
        for (stage, state) in all() {
            let (Stage::Inhibit { capacity, .. } | Stage::InhibitSmoothly { capacity, .. }) = stage
            else {
                continue;
            };
            for u in [0.01, 0.5, 1.019, 1.021, 3.0, 40.0] {
                let (o, left) = after(stage, &state, u, 1.0);
                let used = (state[0] - o[0]) * capacity;
                assert!((used + left - u).abs() < 3e-6 * u.max(1.0), "{stage:?} {u}");
                assert!(o[0] >= 0.0 && left >= 0.0);
            }
            // An antagonist makes what it is worth
            let (o, left) = after(stage, &state, -1.7, 1.0);
            assert!((o[0] - 1.6).abs() < 1e-6 && left == 0.0);
        }
        // Much smaller K: the zeroth order
        let zeroth = after(INHIBIT, &[0.6], 0.4, 1.0);
        let smooth = after(smoothly(1e-5), &[0.6], 0.4, 1.0);
        assert!((zeroth.0[0] - smooth.0[0]).abs() < 1e-4 && smooth.1 < 1e-4);
    }

    #[test]
    fn a_block_in_halves_is_the_block() {
        for (stage, states) in all() {
            for u in [0.3, 1.5, 4.0] {
                let (whole, left) = after(stage, &states, u, 2.0);
                let (half, first) = after(stage, &states, u / 2.0, 1.0);
                let (halves, second) = after(stage, &half, u / 2.0, 1.0);
                for (a, b) in whole.iter().zip(&halves) {
                    assert!((a - b).abs() < 2e-6, "{stage:?} {u}: {whole:?} {halves:?}");
                }
                let passes = matches!(stage, Stage::Dose { .. } | Stage::Rate { .. });
                assert!(
                    passes || (left - first - second).abs() < 5e-6,
                    "{stage:?} {u}"
                );
            }
        }
    }

    #[test]
    fn smooth_consumption_follows_its_differential_equation() {
        // dO/dt = −r/capacity·O/(O + K), in 10⁵ small steps of f64
        let (capacity, half, u) = (1.7f64, 0.05f64, 1.3f64);
        let (mut o, n) = (0.6f64, 100_000);
        for _ in 0..n {
            o -= u / f64::from(n) / capacity * o / (o + half);
        }
        let (found, left) = after(smoothly(0.05), &[0.6], 1.3, 1.0);
        assert!((f64::from(found[0]) - o).abs() < 1e-5, "{found:?} {o}");
        assert!((f64::from(left) - (u - (0.6 - o) * capacity)).abs() < 1e-5);
    }

    #[test]
    fn every_pullback_is_the_derivative() {
        for (stage, states) in all() {
            for u in [-0.3f32, 0.2, 0.9, 2.5] {
                let weights = [0.7f32, -0.4, 0.9];
                let value = |states: &[f32], u: f32| -> f64 {
                    let (states, left) = after(stage, states, u, 2.0);
                    let sum: f32 = states.iter().zip(weights).map(|(s, w)| s * w).sum();
                    // The last stages hand nothing on
                    let ends = matches!(stage, Stage::Dose { .. } | Stage::Rate { .. });
                    f64::from(sum + if ends { 0.0 } else { weights[2] * left })
                };
                let before: Vec<&[f32]> = states.iter().map(std::slice::from_ref).collect();
                let mut c: Vec<Vec<f32>> = (0..states.len()).map(|i| vec![weights[i]]).collect();
                let mut views: Vec<&mut [f32]> = c.iter_mut().map(Vec::as_mut_slice).collect();
                let mut du = [weights[2]];
                stage.pullback(&before, &[u], &mut views, &mut du, 2.0);
                let close = |difference: f64, exact: f32, what: &str| {
                    let exact = f64::from(exact);
                    assert!(
                        (difference - exact).abs() < 2e-3 * (1.0 + exact.abs()),
                        "{stage:?} at {u}, by {what}: {difference} {exact}"
                    );
                };
                let h = 2e-3f32;
                let by_u = (value(&states, u + h) - value(&states, u - h)) / f64::from(2.0 * h);
                close(by_u, du[0], "u");
                // L is a constant
                let count = if matches!(stage, Stage::Bleach { .. }) {
                    1
                } else {
                    states.len()
                };
                for i in 0..count {
                    let moved = |h: f32| {
                        let mut states = states.clone();
                        states[i] += h;
                        value(&states, u)
                    };
                    close(
                        (moved(h) - moved(-h)) / f64::from(2.0 * h),
                        c[i][0],
                        "state",
                    );
                }
            }
        }
    }

    #[test]
    fn the_smooth_step_has_a_compact_rise() {
        for (x, value) in [
            (-0.6, 0.0),
            (-0.5, 0.0),
            (0.0, 0.5),
            (0.5, 1.0),
            (f32::INFINITY, 1.0),
        ] {
            assert_eq!(smooth_step(x).0, value);
        }
        assert_eq!(smooth_step(0.0).1, 1.5);
    }
}
