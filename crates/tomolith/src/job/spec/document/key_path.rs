//! Key paths: `light[0].angles` → steps → the value there, or a place made for one.

use crate::job::spec::kinds::kinds_at;
use crate::units::counted;
use serde_json::{Map, Value};

/// `a`, `b` → `a.b`
pub(crate) fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

/// Whether a key path is `outer` or leads into it.
pub(crate) fn is_within(path: &str, outer: &str) -> bool {
    let rest = path.strip_prefix(outer);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// The path without its last key or index.
pub(crate) fn parent(path: &str) -> &str {
    &path[..path.rfind(['.', '[']).unwrap_or(0)]
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Step {
    Key(String),
    Index(usize),
}

/// `light[0].angles` and `light.0.angles` → the steps; None when it cannot be read.
fn steps(path: &str) -> Option<Vec<Step>> {
    let mut steps = Vec::new();
    for part in path.split('.') {
        let (name, indices) = part.split_at(part.find('[').unwrap_or(part.len()));
        match name.parse() {
            Ok(index) => steps.push(Step::Index(index)),
            Err(_) if name.is_empty() || name.contains(char::is_whitespace) => return None,
            Err(_) => steps.push(Step::Key(name.to_owned())),
        }
        for index in indices.split_inclusive(']') {
            let index = index.strip_prefix('[')?.strip_suffix(']')?;
            steps.push(Step::Index(index.parse().ok()?));
        }
    }
    Some(steps)
}

pub(crate) fn at<'v>(root: &'v mut Value, path: &str) -> Option<&'v mut Value> {
    steps(path)?.iter().try_fold(root, |node, step| match step {
        Step::Key(key) => node.get_mut(key),
        Step::Index(index) => node.get_mut(index),
    })
}

/// Deepest nesting of a key that is set; far more than any job has.
const DEEPEST: usize = 32;

/// Puts a value at a key; where it went, or what was found there instead and is accepted. A kind of which a job has one takes the place of the job's.
pub(crate) fn put(root: &mut Value, key: &str, value: Value) -> Result<String, [String; 2]> {
    let refuse = |found: &str| {
        let accepted = "KEY=VALUE with a dotted key, for example stop.iterations=10";
        Err([found.to_owned(), accepted.to_owned()])
    };
    let Some(steps) = steps(key) else {
        return refuse("a key that cannot be read");
    };
    if steps.len() > DEEPEST {
        return refuse("a key of too many parts");
    }
    let path = insert(root, &steps, value, "")?;
    if let Some((family, is_replaced)) = replaced_by(&path)
        && let Some(Value::Object(table)) = at(root, family)
    {
        table.retain(|key, _| !is_replaced(key));
    }
    Ok(path)
}

/// The family of a kind at a path, and whether it excludes another key of its table.
pub(crate) fn replaced_by(path: &str) -> Option<(&str, impl Fn(&str) -> bool)> {
    let (family, chosen) = path.rsplit_once('.').unwrap_or(("", path));
    let kinds = kinds_at(family);
    // Bodies may be of the mesh of the target
    let goes_with = move |key: &str| (chosen, key) == ("body", "mesh");
    kinds
        .contains(&chosen)
        .then_some((family, move |key: &str| {
            key != chosen && kinds.contains(&key) && !goes_with(key)
        }))
}

/// Steps as they are written.
fn dotted(steps: &[Step]) -> String {
    steps.iter().fold(String::new(), |path, step| match step {
        Step::Key(key) => join(&path, key),
        Step::Index(index) => format!("{path}[{index}]"),
    })
}

/// Puts `value` where the steps lead, making tables on the way; returns the path, or what was found instead and is accepted.
fn insert(
    node: &mut Value,
    steps: &[Step],
    value: Value,
    path: &str,
) -> Result<String, [String; 2]> {
    let Some((step, rest)) = steps.split_first() else {
        *node = value;
        return Ok(path.to_owned());
    };
    if node.is_null() {
        *node = match step {
            Step::Key(_) => Value::Object(Map::new()),
            Step::Index(_) => Value::Array(Vec::new()),
        };
    }
    // A kind without parameters may be written as text: `response = "identity"`
    if let (Value::String(kind), Step::Key(key)) = (&*node, step)
        && (kind == key || rest.is_empty() && kinds_at(path).contains(&key.as_str()))
    {
        let mut map = Map::new();
        map.insert(key.clone(), Value::Object(Map::new()));
        *node = Value::Object(map);
    }
    // A key with dots in it, as scenarios have: "motion.offset_mm" = [0.1, 0]
    if let Value::Object(map) = node {
        let is_key = |n: &usize| map.contains_key(&dotted(&steps[..*n]));
        if let Some(n) = (2..=steps.len()).rev().find(is_key) {
            let key = dotted(&steps[..n]);
            let child = map.entry(key.clone()).or_insert(Value::Null);
            return insert(child, &steps[n..], value, &join(path, &key));
        }
    }
    match (node, step) {
        (Value::Object(map), Step::Key(key)) => {
            let child = map.entry(key.clone()).or_insert(Value::Null);
            insert(child, rest, value, &join(path, key))
        }
        (Value::Array(list), Step::Key(_)) if list.len() == 1 => {
            insert(&mut list[0], steps, value, &format!("{path}[0]"))
        }
        (Value::Array(list), Step::Index(index)) => {
            let length = list.len();
            match list.get_mut(*index) {
                Some(child) => insert(child, rest, value, &format!("{path}[{index}]")),
                None => Err([
                    format!("`{path}` has {}", counted(length, "element")),
                    match length {
                        0 => format!("a whole list: {path}=[…]"),
                        1 => format!("`{path}[0]`, the first one"),
                        n => format!("`{path}[0]`, the first one, to `{path}[{}]`", n - 1),
                    },
                ]),
            }
        }
        (Value::Array(list), Step::Key(key)) => Err([
            format!("`{path}` has {}", counted(list.len(), "element")),
            format!("one of them, as in `{path}[0].{key}`"),
        ]),
        (other, _) => Err([
            format!("`{path}` is {other}, not a table"),
            "a key of a table".to_owned(),
        ]),
    }
}
