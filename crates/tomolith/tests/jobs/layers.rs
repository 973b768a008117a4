//! The layers of a job import only from themselves and from those before them, those after `resolve` no tables, and crates stand on those that ARCHITECTURE.md says.

use std::path::{Path, PathBuf};

/// In the order of `job/mod.rs`; all of them may report progress.
const LAYERS: [&str; 8] = [
    "progress", "spec", "resolve", "dose", "optimize", "evaluate", "output", "run",
];

/// What the layers after `resolve` may take from `spec`: the job whose text goes into the run folder, and the names of files.
const OF_SPEC: [&str; 2] = ["read::Job", "file_names"];

/// Files of these layers that read or change jobs themselves.
const OF_JOBS: [&str; 3] = ["output/export", "output/replace", "run/many"];

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|end| end == "rs") {
            found.push(path);
        }
    }
}

/// The code of a file, without comments and without what comes behind its tests' attribute.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let text = text
        .split("#[cfg(test)]\npub(crate) mod tests {")
        .next()
        .unwrap();
    let lines = text
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// The paths below the module of jobs that code names: `depth` is how many `super` lead there from its module.
fn paths(code: &str, depth: usize) -> Vec<&str> {
    let starts = ["crate::job::".to_owned(), "super::".repeat(depth)];
    let mut found = Vec::new();
    for start in starts.iter().filter(|start| !start.is_empty()) {
        for (at, _) in code.match_indices(start.as_str()) {
            let is_longer = code[..at].ends_with("super::");
            let rest = &code[at + start.len()..];
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_' && c != ':');
            let path = &rest[..end.unwrap_or(rest.len())];
            if !is_longer && !path.starts_with("super") {
                found.push(path);
            }
        }
    }
    found
}

#[test]
fn layers_of_a_job_import_from_below() {
    let job = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/job");
    let mut all = Vec::new();
    files(&job, &mut all);
    let mut wrong = Vec::new();
    for file in all {
        let path = file.strip_prefix(&job).unwrap().with_extension("");
        let names: Vec<String> = path
            .iter()
            .map(|name| name.to_string_lossy().into_owned())
            .filter(|name| name != "mod")
            .collect();
        let Some(layer) = names.first() else { continue };
        if names.last().is_some_and(|name| name == "tests") {
            continue;
        }
        let place = |name: &str| LAYERS.iter().position(|layer| *layer == name);
        let here = place(layer).unwrap_or_else(|| panic!("{layer} is no layer"));
        let code = code(&std::fs::read_to_string(&file).unwrap());
        let reads_jobs = OF_JOBS.iter().any(|listed| path == Path::new(listed));
        for found in paths(&code, names.len()) {
            let (name, rest) = found.split_once("::").unwrap_or((found, ""));
            // What is no layer is a name that the module of jobs takes from one, for its users alone
            let is_upward = place(name).is_none_or(|other| other > here);
            let is_table = name == "spec" && here > place("resolve").unwrap();
            let may_be = reads_jobs || OF_SPEC.iter().any(|known| rest.starts_with(known));
            if is_upward || is_table && !may_be {
                wrong.push(format!("{}: {found}", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn crates_stand_on_those_of_the_table() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |file: &str| std::fs::read_to_string(root.join(file)).unwrap();
    let page = read("ARCHITECTURE.md");
    let rows = page.lines().filter(|line| line.starts_with("| `tomolith"));
    let mut known: Vec<String> = Vec::new();
    for row in rows {
        let columns: Vec<&str> = row.split('|').map(str::trim).collect();
        let name = columns[1].trim_matches('`').to_owned();
        let stands_on = columns[3];
        let manifest = read(&format!("crates/{name}/Cargo.toml"));
        let manifest: toml::Table = manifest.parse().unwrap();
        let needs = manifest["dependencies"].as_table().unwrap().keys();
        for other in needs.filter(|other| other.starts_with("tomolith")) {
            let short = other.strip_prefix("tomolith-").unwrap_or(other);
            let is_named = stands_on.split(", ").any(|name| name == short);
            assert!(
                is_named || stands_on == "all of the above" && known.contains(other),
                "{name} stands on {other}"
            );
        }
        known.push(name);
    }
    let crates = std::fs::read_dir(root.join("crates")).unwrap();
    assert_eq!(known.len(), crates.count(), "a row for each crate");
}
