//! All keys of a job that are at fault, and not only the one that was met first.
//!
//! A copy of the job is read again and again, each time without what was found last: a misspelt key takes the nearest name, a value that is refused is
//! left out, a value that is missing is that of an example. Errors that follow from such a repair alone are left out: those of keys in and around one that was
//! reported, and those of keys that exclude others.

use super::document::{Document, at, is_within, join, parent};
use super::kinds::families;
use super::validate;
use crate::error::{Error, Result};
use crate::field::HostField;
use crate::job::spec::JobSpec;
use crate::kind::{MISSING, Section};
use crate::models::{MODELS, ModelKind};
use crate::objective::objectives;
use crate::objective::penalty::PENALTIES;
use crate::objective::voxel_weights::Common;
use crate::optics::projector::PROJECTORS;
use crate::optics::vial::VIALS;
use crate::optimize::optimizers;
use crate::optimize::start::STARTS;
use crate::response::RESPONSES;
use crate::target::PHANTOMS;
use serde_json::Value;
use std::path::Path;

/// Most errors that are reported, and most repairs.
const MOST: usize = 20;
const REPAIRS: usize = 60;

/// What stands for tables that are missing.
const TABLES: &str = r#"
target = { phantom = "gear", size_mm = 5.0 }
resin = { refractive_index = 1.5, absorption_per_mm = 0.05 }
vial = { index_matched = { radius_mm = 8.0 } }
light = [{ pixels = [128, 128], angles = 360, projector = { collimated = { pixel_pitch_mm = 0.05 } } }]
"#;

/// The first error of a document with all others of its keys, in the order of the file; `models` are known in addition to those of `MODELS`.
pub(crate) fn with_others(
    document: &Document,
    models: &'static [ModelKind],
    base: &Path,
    first: Error,
) -> Error {
    let mut copy = document.clone();
    let (mut errors, mut touched) = (Vec::new(), Vec::new());
    let mut next = first;
    for _ in 0..REPAIRS {
        let error = next;
        let mended = match is_of_key(&error) {
            true => mend(&mut copy.root, &error),
            false => None,
        };
        let is_new = is_of_key(&error) && !follows(&touched, &error);
        touched.extend(key_of(&error).map(str::to_owned));
        if errors.is_empty() || is_new {
            errors.push(error);
        }
        let Some(mended) = mended.filter(|_| errors.len() < MOST) else {
            break;
        };
        touched.push(mended);
        match read(&copy, models, base) {
            Ok(()) => break,
            Err(error) => next = error,
        }
    }
    errors.sort_by_key(|error| match error {
        Error::Config { place, .. } => place.as_ref().map(|place| place.span.start),
        _ => None,
    });
    match errors.len() {
        1 => errors.remove(0),
        _ => Error::Several(errors),
    }
}

/// Reads a document as far as keys go: tables, parameters of kinds, ranges.
fn read(document: &Document, models: &'static [ModelKind], base: &Path) -> Result<()> {
    let spec = JobSpec::from_document(document)?;
    let keys = || -> Result<()> {
        kinds(&spec, models, base)?;
        for s in 0..spec.species.len().max(1) {
            minimized(&spec.of_species(s), base)?;
        }
        validate::tables(&spec)?;
        (spec.target.must_have_lengths()).map_err(|e| e.under("target"))
    };
    keys().map_err(|e| document.locate(e))
}

/// What light meets, and the part.
fn kinds(spec: &JobSpec, models: &'static [ModelKind], base: &Path) -> Result<()> {
    let section = |key: &str, value: &Value| Section::new(key, value.clone()).based(base);
    if let Some(phantom) = &spec.target.phantom {
        let (kind, section) = section("target.phantom", phantom).kind(PHANTOMS)?;
        (kind.build)(&section)?;
    }
    let (kind, of_vial) = section("vial", &spec.vial.kind).kind(VIALS)?;
    (kind.build)(&of_vial)?;
    for (i, light) in spec.light.iter().enumerate() {
        let key = format!("light[{i}].projector");
        let (kind, section) = section(&key, &light.projector.0).kind(PROJECTORS)?;
        (kind.build)(&section)?;
    }
    if let Some(model) = &spec.model {
        let (kind, section) = section("model", model).kind(MODELS.iter().chain(models))?;
        (kind.build.read)(&section)?;
    }
    Ok(())
}

/// What is minimized, and how.
fn minimized(spec: &JobSpec, base: &Path) -> Result<()> {
    let section = |key: &str, value: &Value| Section::new(key, value.clone()).based(base);
    section("response", &spec.response).read(RESPONSES)?;
    for objective in spec.objectives()? {
        let (common, section) = Common::split(objective.based(base))?;
        if let Some(response) = &common.response {
            section
                .within("response", response.clone())
                .read(RESPONSES)?;
        }
        section.read(objectives::<HostField>())?;
    }
    for (i, penalty) in spec.penalties.iter().enumerate() {
        let mut section = section(&format!("penalties[{i}]"), penalty).without(&["weight"]);
        let weight = section
            .value
            .as_object_mut()
            .and_then(|map| map.remove("weight"));
        penalty_weight(i, weight.as_ref())?;
        section.read(PENALTIES)?;
    }
    section("optimizer", &spec.optimizer).read(optimizers::<HostField>())?;
    section("start", &spec.start).read(STARTS)?;
    Ok(())
}

pub(crate) fn penalty_weight(i: usize, weight: Option<&Value>) -> Result<f64> {
    weight.and_then(Value::as_f64).ok_or_else(|| {
        Error::config(
            format!("penalties[{i}].weight"),
            weight.map_or("the key is missing".to_owned(), |w| format!("found {w}")),
            "a number, 0 or more",
        )
    })
}

/// Whether an error is of a key alone: unknown, missing, or a value that no job may have there.
fn is_of_key(error: &Error) -> bool {
    let Error::Config { key, found, .. } = error else {
        return false;
    };
    let words = ["unknown ", "found ", "`", MISSING, "the table is missing"];
    !key.starts_with("--") && words.iter().any(|word| found.starts_with(word))
}

fn key_of(error: &Error) -> Option<&str> {
    match error {
        Error::Config { key, .. } => Some(key),
        _ => None,
    }
}

/// Whether an error is in or around a key that was reported, or changed.
fn follows(touched: &[String], error: &Error) -> bool {
    let key = key_of(error).unwrap_or_default();
    touched
        .iter()
        .any(|path| is_within(path, key) || is_within(key, path))
}

/// Changes what an error is about, so that what comes after it is found: the key that has changed, if one could.
fn mend(root: &mut Value, error: &Error) -> Option<String> {
    let Error::Config { key, nearest, .. } = error else {
        return None;
    };
    let (outer, name) = (parent(key), key.rsplit('.').next().unwrap_or(key));
    let taken = match table_at(root, outer) {
        Some(Value::Object(table)) => table.remove(name),
        // A list is replaced as a whole
        Some(list @ Value::Array(_)) => Some(list.take()),
        _ => None,
    };
    let (path, value) = match (taken, nearest) {
        (Some(value), Some(nearest)) => (join(outer, nearest), value),
        (Some(_), None) => return Some(key.clone()),
        (None, _) => (key.clone(), example(key)?),
    };
    let name = path.rsplit('.').next().unwrap_or(&path).to_owned();
    if let Some(Value::Object(table)) = table_at(root, outer) {
        table.entry(name).or_insert(value);
    }
    Some(path)
}

/// The value at a path, which may be that of the whole job.
fn table_at<'v>(root: &'v mut Value, path: &str) -> Option<&'v mut Value> {
    match path {
        "" => Some(root),
        path => at(root, path),
    }
}

/// A value that a key may have, from an example.
fn example(key: &str) -> Option<Value> {
    // Examples have one element of each list, or a table in its place
    let parts = key.split_inclusive('[').flat_map(|part| part.split(']'));
    let (mut first, mut bare) = (String::new(), String::new());
    for part in parts {
        match part.strip_suffix('[') {
            Some(list) => {
                first += &format!("{list}[0]");
                bare += list;
            }
            None if part.parse::<usize>().is_err() => {
                first += part;
                bare += part;
            }
            None => {}
        }
    }
    let pages = families().iter().flat_map(|family| &family.kinds);
    let examples = pages.map(|page| page.example);
    let mut found = std::iter::once(TABLES).chain(examples).filter_map(|text| {
        let table: toml::Table = text.parse().ok()?;
        let mut example = serde_json::to_value(table).ok()?;
        let place = [&first, &bare]
            .into_iter()
            .find(|key| at(&mut example, key).is_some());
        at(&mut example, place?).map(|value| value.take())
    });
    found.next()
}

#[cfg(test)]
mod tests {
    use crate::error::Error;
    use crate::job::{Document, Job};

    /// The keys at fault in a job, and the names that are proposed.
    fn at_fault(text: &str) -> Vec<(String, Option<String>)> {
        let job = Document::toml("a.toml", text).and_then(Job::from_document);
        let error = match job {
            Err(error) => error,
            Ok(job) => {
                crate::job::check(&job, &mut crate::job::Silent, &crate::models::Work::new())
                    .unwrap_err()
            }
        };
        let several = match error {
            Error::Several(several) => several,
            one => vec![one],
        };
        let key_and_name = |error: Error| match error {
            Error::Config {
                key,
                nearest,
                place: Some(_),
                ..
            } => (key, nearest),
            other => panic!("{other}"),
        };
        several.into_iter().map(key_and_name).collect()
    }

    #[test]
    fn all_keys_at_fault_are_told_at_once() {
        let text = r#"
            [target]
            phantom = "gear"
            size = 2.0
            [resin]
            ior = 1.5
            mu = 0.1
            [vial.cylinder]
            diameter = 6.0
            outer_radius_mm = 8.0
            refractive_index = 9.0
            [[light]]
            pixels = [24, 0]
            projector.collimated = { pixel_pitch_mm = 0.2 }
            [objective.threshold]
            lowr = 0.8
            [evaluate]
            bit_depth = 40
        "#;
        let found = at_fault(text);
        let expected = [
            ("target.size", Some("size_mm")),
            ("resin.ior", Some("refractive_index")),
            ("resin.mu", Some("absorption_per_mm")),
            ("light[0].angles", None),
            ("vial.cylinder.diameter", Some("inner_radius_mm")),
            ("vial.cylinder.refractive_index", None),
            ("objective.threshold.lowr", Some("lower")),
            ("light[0].pixels[1]", None),
            ("evaluate.bit_depth", None),
        ];
        for (key, nearest) in expected {
            let nearest = nearest.map(str::to_owned);
            assert!(
                found.contains(&(key.to_owned(), nearest)),
                "{key} is not in {found:?}"
            );
        }
        assert_eq!(found.len(), expected.len(), "{found:?}");
    }

    #[test]
    fn both_lengths_of_an_image_are_told_at_once() {
        let image = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../examples/images/rings.png"
        );
        let text = format!(
            r#"
            target = {{ image = '{image}' }}
            resin = {{ refractive_index = 1.5, absorption_per_mm = 0.1 }}
            vial = {{ index_matched = {{ radius_mm = 3.0 }} }}
            light = [{{ pixels = [24, 16], angles = 12, projector = {{ collimated = {{ pixel_pitch_mm = 0.2 }} }} }}]
        "#
        );
        let keys = at_fault(&text).into_iter().map(|(key, _)| key);
        assert_eq!(
            keys.collect::<Vec<_>>(),
            ["target.size_mm", "target.height_mm"]
        );
    }

    #[test]
    fn what_follows_from_a_repair_alone_is_not_told() {
        // Without the misspelt dose the time would be refused, too
        let text = r#"
            target = { phantom = "gear", size_mm = 2.0 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1, dose_needed_xyz = 3.0 }
            vial = { index_matched = { radius_mm = 3.0 } }
            light = [{ pixels = [24, 16], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.2 } } }]
            printer = { time_s = 60.0, peak_irradiance_mw_per_cm2 = 5.0 }
        "#;
        let found = at_fault(text);
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].0, "resin.dose_needed_xyz");
    }
}
