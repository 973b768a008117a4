//! Public properties that every model, objective and optimizer must have.
//!
//! Each check returns what is wrong in one sentence. Every row of every table is enrolled by the tests of its family.

pub mod model;
pub mod small;
pub mod taylor;

use crate::kind::{Kind, Section};
use serde_json::Value;

/// Signed pseudo-random numbers in (−1, 1), the same on every machine (splitmix64: Steele, Lea, Flood 2014, doi:10.1145/2660193.2660195).
#[must_use]
pub fn noise(seed: u64, len: usize) -> Vec<f32> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (0..len)
        .map(|_| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^= z >> 31;
            (z >> 40) as f32 / (1u64 << 23) as f32 - 1.0
        })
        .collect()
}

/// The section of a row's example, `[family.kind]` or the first of `[[family]]`.
///
/// # Panics
/// When the example does not name the row's kind.
pub fn example<B>(row: &Kind<B>) -> Section {
    let value: toml::Table =
        toml::from_str(row.example).unwrap_or_else(|e| panic!("example of {}: {e}", row.name));
    let mut path = Vec::new();
    let mut value = serde_json::to_value(value).unwrap();
    // Down to the kind: `[family.kind]`
    for _ in 0..2 {
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
    assert_eq!(path[1], row.name, "the example names another kind");
    Section::new(path.join("."), value)
}
