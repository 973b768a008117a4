//! The book: no link is broken or leaves it, code names no page that is missing, and SUMMARY.md lists every page.

use std::path::{Path, PathBuf};

fn files(at: PathBuf) -> Vec<PathBuf> {
    match std::fs::read_dir(&at) {
        Ok(below) => below.flat_map(|e| files(e.unwrap().path())).collect(),
        Err(_) => vec![at],
    }
}

fn read(page: &Path) -> String {
    std::fs::read_to_string(page).unwrap_or_default()
}

/// What stands between each mark and the end of its link.
fn after<'a>(text: &'a str, mark: &'a str) -> impl Iterator<Item = &'a str> {
    let ends = [' ', '\n', ')', '"', '`', ',', ';', ':'];
    let parts = text.split(mark).skip(1);
    let links = parts.filter_map(move |rest| rest.split(ends).next());
    links.filter(|link| link.contains(['.', '#']))
}

fn has_heading(page: &Path, anchor: &str) -> bool {
    let is_kept = |c: &char| c.is_alphanumeric() || "-_".contains(*c);
    let title_of = |line: &str| line.trim_start_matches('#').trim().to_lowercase();
    let lines = read(page);
    let mut titles = lines
        .lines()
        .filter(|line| line.starts_with('#'))
        .map(title_of);
    titles.any(|title| {
        anchor
            .chars()
            .eq(title.replace(' ', "-").chars().filter(is_kept))
    })
}

#[test]
fn no_link_or_page_is_missing() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let root = root.canonicalize().unwrap();
    let docs = root.join("docs");
    let summary = read(&docs.join("SUMMARY.md"));
    let mut missing = Vec::new();
    let all = "docs examples papers crates README.md ARCHITECTURE.md CONTRIBUTING.md CHANGELOG.md";
    for path in all.split(' ').flat_map(|name| files(root.join(name))) {
        let (text, from) = (read(&path), path.parent().unwrap());
        let (mut links, mut base) = (Vec::new(), from);
        if path.extension().is_some_and(|end| end == "md") {
            links.extend(after(&text, "](").chain(after(&text, "]: ")));
            let name = path.strip_prefix(&docs).ok().and_then(Path::to_str);
            let listed = |name: &str| name == "SUMMARY.md" || summary.contains(name);
            missing.extend(name.filter(|name| !listed(name)).map(str::to_owned));
        } else {
            links.extend(after(&text, "docs/").filter(|name| name.ends_with(".md")));
            base = &docs;
        }
        for link in links.into_iter().filter(|link| !link.contains("//")) {
            let (file, title) = link.split_once('#').unwrap_or((link, ""));
            let to = if file.is_empty() {
                path.clone()
            } else {
                base.join(file)
            };
            let within = if path.starts_with(&docs) {
                &docs
            } else {
                &root
            };
            let there = to.canonicalize().is_ok_and(|to| to.starts_with(within));
            if !there || !title.is_empty() && !has_heading(&to, title) {
                missing.push(format!("{}: {link}", path.display()));
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}
