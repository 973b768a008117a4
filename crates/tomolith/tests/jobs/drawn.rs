//! What `check` accepts, `run` does not refuse: jobs drawn at random from the schema, with a fixed seed. `TOMOLITH_FUZZ_SECONDS` makes it longer.

use crate::{Finished, job_of};
use serde_json::{Map, Value};
use std::time::{Duration, Instant};
use tomolith::Error;
use tomolith::job::schema::schema;
use tomolith::job::{self, Document, Job, Silent};
use tomolith::models::Work;

/// A job that a run takes a moment for; what is drawn is merged into it.
const BASE: &str = r#"
target = { phantom = { gear = {} }, size_mm = 2.0 }
grid = { pitch_mm = 0.25 }
resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
vial = { index_matched = { radius_mm = 3.0 } }
light = [{ pixels = [24, 16], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.2 } } }]
objective = { threshold = {} }
stop = { iterations = 1 }
resources = { memory_gb = 0.5 }
evaluate = { refine = 2 }
"#;

/// Tables without which most of what others say of time is refused at once.
const IN_TIME: &str = r#"
schedule = { turns = 2.0 }
material = { photopolymer = { networks = [{ name = "resin", curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } } }] } }
"#;

/// Seldom numbers that are at an end of what is a number.
const EXTREMES: [f64; 6] = [1e-300, 1e-9, 1e5, 1e9, 1e30, 1e308];
const NUMBERS: [f64; 10] = [0.0, 0.01, 0.1, 0.3, 0.5, 1.0, 1.5, 2.0, 10.0, 100.0];

/// Draws values that a schema allows.
struct Draw {
    state: u64,
    schema: Value,
}

impl Draw {
    fn below(&mut self, count: usize) -> usize {
        // splitmix64
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % count as u64) as usize
    }

    fn one_of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }

    /// A value; None where the schema asks for text of any kind, which most often names a file.
    fn value(&mut self, schema: &Value, depth: usize) -> Option<Value> {
        if let Some(reference) = schema["$ref"].as_str() {
            let schema = self.schema.pointer(&reference[1..])?.clone();
            return self.value(&schema, depth);
        }
        if let Some(options) = schema["oneOf"].as_array().or(schema["anyOf"].as_array()) {
            let option = self.one_of(options).clone();
            return self.value(&option, depth);
        }
        if let Some(names) = schema["enum"].as_array() {
            return Some(self.one_of(names).clone());
        }
        if !schema["const"].is_null() {
            return Some(schema["const"].clone());
        }
        let kind = match &schema["type"] {
            Value::Array(kinds) => kinds.first()?.as_str()?.to_owned(),
            kind => kind.as_str()?.to_owned(),
        };
        match kind.as_str() {
            "object" => self.table(schema, depth),
            "array" => {
                let count = schema["minItems"].as_u64().unwrap_or(1);
                (0..count)
                    .map(|_| self.value(&schema["items"], depth + 1))
                    .collect::<Option<_>>()
            }
            "boolean" => Some(Value::from(self.below(2) == 1)),
            "integer" => Some(Value::from(*self.one_of(&[0, 1, 2, 3, 4, 8, 12, 16]))),
            "number" if self.below(25) == 0 => Some(Value::from(*self.one_of(&EXTREMES))),
            "number" => Some(match (schema["default"].as_f64(), self.below(2)) {
                (Some(default), 0) => Value::from(default * self.one_of(&[0.5, 1.0, 2.0])),
                _ => Value::from(*self.one_of(&NUMBERS)),
            }),
            _ => None,
        }
    }

    fn table(&mut self, schema: &Value, depth: usize) -> Option<Value> {
        let required = schema["required"].as_array().cloned().unwrap_or_default();
        let mut table = Map::new();
        for (key, property) in schema["properties"].as_object()? {
            let is_required = required.iter().any(|r| r == key);
            // A few keys of each table
            if !is_required && self.below(4) != 0 {
                continue;
            }
            match self.value(property, depth + 1) {
                Some(value) => drop(table.insert(key.clone(), value)),
                None if is_required => return None,
                None => {}
            }
        }
        Some(Value::Object(table))
    }

    /// A job with one to three tables drawn.
    fn job(&mut self) -> Value {
        let mut root = Document::toml("base.toml", BASE).unwrap().root;
        if self.below(3) == 0 {
            merge(
                &mut root,
                Document::toml("time.toml", IN_TIME).unwrap().root,
            );
        }
        let properties = self.schema["properties"].as_object().unwrap().clone();
        let tables: Vec<&String> = properties.keys().filter(|key| *key != "output").collect();
        for _ in 0..=self.below(3) {
            let key = *self.one_of(&tables);
            if let Some(value) = self.value(&properties[key], 0) {
                let tagged = matches!(
                    key.as_str(),
                    "objective" | "optimizer" | "start" | "model" | "response" | "vial"
                );
                match root.get_mut(key).filter(|_| !tagged) {
                    Some(table) => merge(table, value),
                    None => root[key] = value,
                }
            }
        }
        root
    }
}

/// Lays one table over another.
fn merge(under: &mut Value, over: Value) {
    match (under, over) {
        (Value::Object(under), Value::Object(over)) => {
            for (key, value) in over {
                match under.get_mut(&key) {
                    Some(inner) => merge(inner, value),
                    None => drop(under.insert(key, value)),
                }
            }
        }
        (Value::Array(under), Value::Array(over)) if !under.is_empty() => {
            under
                .iter_mut()
                .zip(over)
                .for_each(|(inner, value)| merge(inner, value));
        }
        (under, over) => *under = over,
    }
}

/// The key at which a job is refused.
fn refused_at(done: Result<(), Error>) -> String {
    match done {
        Err(Error::Config { key, .. }) => key,
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_a_run_refuses_before_its_first_step_check_refuses_at_the_same_key() {
    let place = tempfile::tempdir().unwrap();
    let in_time = format!("{BASE}{IN_TIME}");
    let slips = r#"
        in time: multiresolution={} + schedule.optimize=exact → multiresolution
        in time: schedule.dark_before_s=1e9 → schedule.dark_before_s
        in time: material.photopolymer.networks[0].inhibitors=[{ name = "oxygen", capacity_mj_per_mm3 = 0.4, diffusion_mm2_per_s = 65536 }] → material.photopolymer.networks[0].inhibitors[0].diffusion_mm2_per_s
        bounds={ min = 0.01, max = 0.01 } → bounds.max
        vial.index_matched.radius_mm=90000 → light
        bath={ absorption_per_mm = 0.0, radius_mm = 1e308 } → light
    "#;
    for slip in slips.trim().lines() {
        let (changes, key) = slip.trim().split_once(" → ").unwrap();
        let (text, changes) = match changes.strip_prefix("in time: ") {
            Some(changes) => (in_time.as_str(), changes),
            None => (BASE, changes),
        };
        let changes: Vec<&str> = changes.split(" + ").collect();
        let folder = place.path().join("run");
        let job = || Ok(job_of(text, &changes)?.with_folder(&folder, "--output"));
        let check = |job| job::check(&job, &mut Silent, &Work::new()).map(drop);
        let run = |job| job::run(&job, false, &mut Silent, &Work::new()).map(drop);
        for done in [job().and_then(check), job().and_then(run)] {
            assert_eq!(refused_at(done), key, "{changes:?}");
        }
    }
}

#[test]
fn frames_that_make_no_movie_are_a_warning() {
    let run = |change: &str| {
        let run = Finished::run(job_of(BASE, &[change]).unwrap(), &mut Silent);
        let report = run.report();
        assert!(run.path("patterns.npz").is_file() && run.path("print.stl").is_file());
        assert_eq!(report["movies"], Value::Array(Vec::new()));
        let warnings = report["warnings"].to_string();
        let warned = warnings.contains("the movie is left out");
        (warned, run.path("exposure.json").is_file())
    };
    // Wider than any H.264 that the encoder writes
    assert_eq!(run("light[0].pixels=[3844, 16]"), (true, true));
    assert_eq!(run("output.movie=none"), (false, true));
}

#[test]
#[ignore = "slow"]
fn what_check_accepts_run_does_not_refuse() {
    let seconds = std::env::var("TOMOLITH_FUZZ_SECONDS")
        .ok()
        .and_then(|s| s.parse().ok());
    let longest = Duration::from_secs_f64(seconds.unwrap_or(5.0));
    let seed = std::env::var("TOMOLITH_FUZZ_SEED")
        .ok()
        .and_then(|s| s.parse().ok());
    let place = tempfile::tempdir().unwrap();
    let mut draw = Draw {
        state: seed.unwrap_or(46),
        schema: schema(),
    };
    let (begin, mut accepted, mut drawn, mut refused) = (Instant::now(), 0, 0, Vec::new());
    while begin.elapsed() < longest {
        drawn += 1;
        let root = draw.job();
        let text = root.to_string();
        let Ok(job) = Document::json("drawn.json", text.as_str()).and_then(Job::from_document)
        else {
            continue;
        };
        let job = job.with_folder(&place.path().join(drawn.to_string()), "--output");
        if job::check(&job, &mut Silent, &Work::new()).is_err() {
            continue;
        }
        accepted += 1;
        if let Err(error) = job::run(&job, false, &mut Silent, &Work::new()) {
            refused.push(format!("{error}\n    {text}"));
        }
    }
    assert!(
        accepted * 10 > drawn,
        "{accepted} of {drawn} drawn jobs are accepted: too few to find anything"
    );
    assert!(
        refused.is_empty(),
        "{} of {accepted} accepted jobs ({drawn} drawn) are refused:\n{}",
        refused.len(),
        refused.join("\n")
    );
}
