//! Public properties that every model, objective and optimizer must have.
//!
//! Each check returns what is wrong in one sentence. Every row of every table is enrolled by the tests of its family.

pub mod fuzz;
pub mod model;
pub mod small;
pub mod taylor;

use crate::dose::{DoseModel, Work};
use crate::error::{Error, Result};
use crate::field::Field;
use crate::kind::{Kind, Section};
use crate::random::{STEP, SplitMix};
use serde_json::Value;

/// Signed pseudo-random numbers in (−1, 1), the same on every machine (see [`random`](crate::random)).
#[must_use]
pub fn noise(seed: u64, len: usize) -> Vec<f32> {
    let mut numbers = SplitMix(seed.wrapping_mul(STEP));
    (0..len)
        .map(|_| (numbers.bits() >> 40) as f32 / (1u64 << 23) as f32 - 1.0)
        .collect()
}

/// Numbers from 0 to below 1 that look random, one after the other, from [`noise`].
pub fn random(seed: u64) -> impl FnMut() -> f32 {
    let mut numbers = noise(seed, 1 << 16).into_iter().cycle();
    move || 0.5 + 0.5 * numbers.next().unwrap_or_default()
}

/// Asserts that a result is the refusal of a key.
///
/// # Panics
/// When it is another one, or none.
pub fn refuses<T>(result: Result<T>, key: &str) {
    match result.map(drop) {
        Err(Error::Config { key: found, .. }) => assert_eq!(found, key),
        other => panic!("{key} is not refused, but {other:?}"),
    }
}

/// Asserts that a number differs from what is expected by less than a tolerance.
///
/// ```
/// tomolith_core::near!(0.1f64 + 0.2, 0.3, 1e-12, "a sum");
/// ```
#[macro_export]
macro_rules! near {
    ($found:expr, $expected:expr, $tolerance:expr $(,)?) => {
        $crate::near!($found, $expected, $tolerance, "not near")
    };
    ($found:expr, $expected:expr, $tolerance:expr, $($what:tt)+) => {{
        let (found, expected) = ($found, $expected);
        let what = format_args!($($what)+);
        assert!((found - expected).abs() < $tolerance, "{found} in place of {expected}: {what}");
    }};
}

/// Asserts that a text has all of these parts.
///
/// ```
/// tomolith_core::contains!("size_mm: found -1; accepted: a length > 0", "size_mm", "found -1");
/// ```
#[macro_export]
macro_rules! contains {
    ($text:expr, $($part:expr),+ $(,)?) => {
        match &$text {
            text => {
                let text: &str = AsRef::<str>::as_ref(text);
                $(assert!(text.contains($part), "{:?} is not in: {text}", $part);)+
            }
        }
    };
}

/// What some work comes to on so many threads.
///
/// # Panics
/// Where the machine cannot start them.
pub fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().unwrap().install(work)
}

/// F(x).
///
/// # Panics
/// When the model fails.
pub fn dose<M: DoseModel + ?Sized>(model: &M, x: &M::Field) -> M::Field {
    let mut dose = model.new_dose().unwrap();
    model.dose(x, &mut dose, &Work::new()).unwrap();
    dose
}

/// Fᵀc of a linear model.
///
/// # Panics
/// When the model fails.
pub fn adjoint<M: DoseModel + ?Sized>(model: &M, c: &M::Field) -> M::Field {
    let (x, mut grad) = (model.new_patterns().unwrap(), model.new_patterns().unwrap());
    model.pullback(&x, c, &mut grad, &Work::new()).unwrap();
    grad
}

/// Patterns of one value.
///
/// # Panics
/// When memory is short.
pub fn even_patterns<M: DoseModel + ?Sized>(model: &M, value: f32) -> M::Field {
    let mut x = model.new_patterns().unwrap();
    x.fill(value);
    x
}

/// Patterns of [`noise`].
///
/// # Panics
/// When memory is short.
pub fn noisy_patterns<M: DoseModel + ?Sized>(model: &M, seed: u64) -> M::Field {
    let mut x = model.new_patterns().unwrap();
    x.copy_from_host(&noise(seed, x.len()));
    x
}

/// ‖a − b‖/‖b‖
///
/// # Panics
/// When there are more of one than of the other.
#[must_use]
pub fn difference(a: &[f32], b: &[f32]) -> f64 {
    assert_eq!(a.len(), b.len());
    let pairs = a.iter().zip(b);
    let error: f64 = pairs.map(|(a, b)| f64::from(a - b).powi(2)).sum();
    (error / b.iter().map(|&b| f64::from(b).powi(2)).sum::<f64>()).sqrt()
}

/// The largest |a − b| over the largest |b|: no number, or infinite, where a NaN is met or every b is 0.
///
/// # Panics
/// When there are more of one than of the other.
#[must_use]
pub fn largest_difference(a: &[f32], b: &[f32]) -> f32 {
    assert_eq!(a.len(), b.len());
    let larger = |m: f32, v: f32| if v > m || v.is_nan() { v } else { m };
    let off = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    let off = off.fold(0.0, larger);
    off / b.iter().map(|b| b.abs()).fold(0.0, larger)
}

/// The section of a row's example, `[family.kind]` at any depth or the first of `[[family]]`.
///
/// # Panics
/// When the example does not name the row's kind.
pub fn example<B>(row: &Kind<B>) -> Section {
    let value: toml::Table =
        toml::from_str(row.example).unwrap_or_else(|e| panic!("example of {}: {e}", row.name));
    let mut path = Vec::new();
    let mut value = serde_json::to_value(value).unwrap();
    // Down to the kind
    while path.last().is_none_or(|key| key != row.name) {
        // Of a list `[[family]]` the first
        if let Value::Array(list) = value {
            value = list.into_iter().next().unwrap();
            value.as_object_mut().unwrap().remove("weight");
        }
        let Value::Object(map) = value else {
            panic!("example of {} holds no [family.kind]", row.name)
        };
        let (key, inner) = map.into_iter().next().unwrap();
        path.push(key);
        value = inner;
    }
    Section::new(path.join("."), value)
}
