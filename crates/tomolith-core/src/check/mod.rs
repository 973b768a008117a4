//! Public properties that every model, objective and optimizer must have.
//!
//! Each check returns what is wrong in one sentence. Every row of every table is enrolled by the tests of its family.

pub mod model;
pub mod small;

use crate::kind::{Kind, Section};
use serde_json::Value;

/// Numbers between −1 and 1 that look random and are the same everywhere.
#[must_use]
pub fn noise(len: usize, seed: u32) -> Vec<f32> {
    let mut state = seed.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / 8_388_608.0 - 1.0
    };
    (0..len).map(|_| next()).collect()
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
