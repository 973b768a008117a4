//! The house has floors: a room imports only from floors below its own (ARCHITECTURE.md).

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Floor of each room; `check` may see all.
const FLOORS: &[(u32, &[&str])] = &[
    (1, &["grid", "field", "error", "kind", "units", "run"]),
    (2, &["io"]),
    (3, &["target", "optics", "exposure"]),
    (4, &["models", "response"]),
    (5, &["objective", "metrics"]),
    (6, &["optimize"]),
    (7, &["report"]),
    (8, &["job"]),
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("source folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// Rooms that a line of code names as `crate::room` (comments and doctests aside).
fn rooms_named(line: &str) -> Vec<&str> {
    let code = line.split("//").next().unwrap_or_default();
    let mut rooms = Vec::new();
    for (at, _) in code.match_indices("crate::") {
        let rest = &code[at + 7..];
        if let Some(list) = rest.strip_prefix('{') {
            rooms.extend(list.split([',', '}']).map(|item| first_name(item.trim())));
        } else {
            rooms.push(first_name(rest));
        }
    }
    rooms
}

fn first_name(text: &str) -> &str {
    let end = text
        .find(|c: char| !c.is_alphanumeric() && c != '_')
        .unwrap_or(text.len());
    &text[..end]
}

#[test]
fn no_room_imports_from_a_floor_above_its_own() {
    let floors: BTreeMap<&str, u32> = FLOORS
        .iter()
        .flat_map(|(floor, rooms)| rooms.iter().map(move |room| (*room, *floor)))
        .collect();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    let mut imports = 0;
    let mut wrong = Vec::new();
    for file in files {
        let inner = file.strip_prefix(&root).expect("below src");
        let room = first_name(
            inner
                .components()
                .next()
                .and_then(|c| c.as_os_str().to_str())
                .unwrap_or_default(),
        );
        if matches!(room, "lib" | "check") {
            continue;
        }
        let own = *floors.get(room).unwrap_or_else(|| {
            panic!("room `{room}` has no floor: add it to FLOORS and ARCHITECTURE.md")
        });
        let text = std::fs::read_to_string(&file).expect("source file");
        // Tests at the end of a file may use what they like
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        if inner.ends_with("tests.rs") {
            continue;
        }
        for (number, line) in code.lines().enumerate() {
            for other in rooms_named(line) {
                let Some(&floor) = floors.get(other) else {
                    continue;
                };
                imports += 1;
                if floor > own || (floor == own && other != room && floor > 1) {
                    wrong.push(format!(
                        "{}:{}: {room} (floor {own}) uses {other} (floor {floor})",
                        inner.display(),
                        number + 1
                    ));
                }
            }
        }
    }
    assert!(
        imports > 50,
        "the test has lost its sight: only {imports} imports found"
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
