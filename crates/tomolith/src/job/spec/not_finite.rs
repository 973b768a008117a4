//! Which keys of a job make a loss that is no finite number: of those that the job sets, the ones that are far from 1.

use super::document::join;
use crate::error::Error;
use crate::units::exact;
use serde_json::Value;

/// Tables whose numbers scale the loss, its gradient or the patterns.
const TABLES: [&str; 8] = [
    "objective",
    "objectives",
    "species",
    "penalties",
    "response",
    "optimizer",
    "bounds",
    "light",
];
/// Names of exponents: what they raise decides how much they do.
const EXPONENTS: [&str; 3] = ["exponent", "p", "q"];
/// Powers of ten from which a number is far from 1, and most numbers that are named.
const FAR: f64 = 3.0;
const MOST: usize = 4;

/// A number that a job sets.
struct Number {
    key: String,
    value: f64,
}

impl Number {
    /// Powers of ten that it changes the loss by; an exponent raises what is some ten times too large or small, and one near 0 the norm to its inverse.
    fn powers(&self) -> f64 {
        let name = self.key.rsplit('.').next().unwrap_or_default();
        match EXPONENTS.contains(&name) {
            true => (self.value / 2.0).max(0.5 / self.value),
            false => self.value.abs().log10().abs(),
        }
    }
}

/// An error of a number that is not finite as one of the keys that made it, where the job sets any.
pub(crate) fn blamed(root: &Value, error: Error) -> Error {
    let Error::NonFinite {
        what,
        value,
        iteration,
    } = &error
    else {
        return error;
    };
    let mut numbers = Vec::new();
    for table in TABLES {
        collect(table, &root[table], &mut numbers);
    }
    numbers.retain(|number| number.powers().is_finite() && number.powers() >= FAR);
    numbers.sort_by(|a, b| b.powers().total_cmp(&a.powers()));
    let Some(first) = numbers.first() else {
        return error;
    };
    let others = numbers[1..].iter().take(MOST - 1);
    let others: Vec<String> = others
        .map(|other| format!("{} = {}", other.key, exact(other.value)))
        .collect();
    let others = match others.is_empty() {
        true => String::new(),
        false => format!(", together with {}", others.join(", ")),
    };
    Error::config(
        first.key.as_str(),
        format!(
            "found {}{others}: {what} became {value} at iteration {iteration}",
            exact(first.value)
        ),
        "a number nearer to 1",
    )
}

/// The numbers of a table, of tables in it and of lists of tables.
fn collect(key: &str, value: &Value, numbers: &mut Vec<Number>) {
    match value {
        Value::Object(table) => {
            for (name, value) in table {
                collect(&join(key, name), value, numbers);
            }
        }
        Value::Array(list) if list.iter().all(Value::is_object) => {
            for (i, value) in list.iter().enumerate() {
                collect(&format!("{key}[{i}]"), value, numbers);
            }
        }
        // Of a light only its bounds
        Value::Number(number) if !key.starts_with("light") || key.contains(".bounds.") => {
            let key = key.to_owned();
            numbers.extend(number.as_f64().map(|value| Number { key, value }));
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Result;
    use crate::job::tests::document_of;
    use crate::job::{Document, Job, Silent, run};
    use crate::models::Work;

    const SMALL: &str = r#"
        target = { phantom = "gear", size_mm = 2.0 }
        grid = { pitch_mm = 0.2 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        light = [{ pixels = [16, 12], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.2 } } }]
        stop = { iterations = 3 }
    "#;

    #[test]
    fn a_loss_that_is_infinite_is_blamed_on_keys_that_the_job_sets() {
        let folder = tempfile::tempdir().unwrap();
        let refusal = |changes: &[&str]| -> Result<()> {
            let job = Job::from_document(document_of(SMALL, changes))?;
            let job = job.with_folder(&folder.path().join("run"), "");
            run(&job, false, &mut Silent, &Work::new()).map(drop)
        };
        let changes = [
            "objective.threshold.exponent=60",
            "optimizer.gradient.step=1e30",
            "bounds.max=1e9",
            "bounds.min=0",
        ];
        let Err(Error::Config { key, found, .. }) = refusal(&changes) else {
            panic!("a loss of more than 1e308 is taken")
        };
        assert_eq!(key, "objective.threshold.exponent");
        tomolith_core::contains!(found, "the loss became inf at iteration 1");
        for named in ["optimizer.gradient.step = 1e30", "bounds.max = 1000000000"] {
            assert!(found.contains(named), "{found}");
        }
        assert!(!found.contains("bounds.min"), "{found}");
    }

    #[test]
    fn what_no_key_makes_stays_what_it_is() {
        let error = || Error::NonFinite {
            what: "the loss".to_owned(),
            value: f64::NAN,
            iteration: 2,
        };
        let root = |text: &str| Document::toml("a.toml", text).unwrap().root;
        let plain = root("objective.threshold = { lower = 0.8, exponent = 4.0 }");
        assert!(matches!(blamed(&plain, error()), Error::NonFinite { .. }));
        let weight = root("penalties = [{ weight = 1e8, sparsity = {} }]");
        let message = blamed(&weight, error()).to_string();
        assert!(
            message.starts_with("penalties[0].weight: found 100000000"),
            "{message}"
        );
    }
}
