//! The parts of a package: a zip archive, inflated within bounds.

use super::super::text::decoded;
use super::xml::Xml;
use std::collections::HashMap;
use std::io::{Cursor, Read};

/// Deflate cannot shrink by more than 1032; meshes as text shrink by 5 to 20.
const MOST_INFLATED: u64 = 200;

/// Small packages of constant bytes may do better than that.
const SMALL: u64 = 16 << 20;

/// Parts of a package; printers' project files have hundreds.
const MOST_PARTS: usize = 10_000;

/// What says which part is the root model.
const ROOT_RELATIONSHIPS: &str = "_rels/.rels";

/// The end of the type of its relationship.
const ROOT_TYPE: &str = "/3dmodel";

/// The texts of a package by the [keys](part_key) of their parts.
pub(super) struct Package {
    /// Key of the root model.
    pub(super) root: String,
    /// Models and what slicers write of them.
    pub(super) texts: HashMap<String, String>,
}

impl Package {
    /// Inflates every part within bounds, and keeps those that count.
    pub(super) fn read(bytes: &[u8]) -> Result<Self, String> {
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(|e| damaged(&e))?;
        if archive.len() > MOST_PARTS {
            return Err(format!("a package of {} parts", archive.len()));
        }
        let mut left = MOST_INFLATED * bytes.len() as u64 + SMALL;
        let mut texts = HashMap::new();
        for i in 0..archive.len() {
            let part = archive.by_index(i).map_err(|e| damaged(&e))?;
            let (name, size) = (part.name().to_owned(), part.size());
            if size > left {
                let all = bytes.len();
                return Err(format!(
                    "a package of {all} bytes that promises {size} bytes in `{name}`"
                ));
            }
            let mut content = Vec::new();
            part.take(left)
                .read_to_end(&mut content)
                .map_err(|e| damaged(&e))?;
            if content.len() as u64 != size {
                let read = content.len();
                let found = format!("`{name}` has {read} bytes instead of {size}");
                return Err(damaged(&found));
            }
            left -= size;
            let key = part_key(&name);
            if [".rels", ".model", ".config"]
                .iter()
                .any(|end| key.ends_with(end))
            {
                texts.insert(key, text_of(&content));
            }
        }
        let relationships = texts
            .get(ROOT_RELATIONSHIPS)
            .ok_or_else(|| damaged(&format!("no part `{ROOT_RELATIONSHIPS}`")))?;
        let root = root_of(relationships)
            .map_err(|found| damaged(&format!("{found} in `{ROOT_RELATIONSHIPS}`")))?;
        Ok(Package { root, texts })
    }
}

/// The text of a part; names in another encoding than UTF-8 or UTF-16 do not matter.
fn text_of(content: &[u8]) -> String {
    String::from_utf8_lossy(&decoded(content)).into_owned()
}

pub(super) fn damaged(e: &dyn std::fmt::Display) -> String {
    format!("damaged 3MF: {e}")
}

/// What the names of a part have in common: they are absolute, know no case, and may be written with `%20` and `./`.
pub(super) fn part_key(name: &str) -> String {
    let mut segments = Vec::new();
    for segment in unescaped(name).split(['/', '\\']) {
        match segment {
            "" | "." => {}
            ".." => drop(segments.pop()),
            _ => segments.push(segment.to_lowercase()),
        }
    }
    segments.join("/")
}

/// Percent signs with two hexadecimal digits are bytes.
fn unescaped(name: &str) -> String {
    let mut bytes = Vec::with_capacity(name.len());
    let mut rest = name.as_bytes();
    while let [first, after @ ..] = rest {
        let digits = after.get(..2).filter(|_| *first == b'%');
        let byte = digits
            .and_then(|digits| std::str::from_utf8(digits).ok())
            .and_then(|digits| u8::from_str_radix(digits, 16).ok());
        bytes.push(byte.unwrap_or(*first));
        rest = &after[if byte.is_some() { 2 } else { 0 }..];
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The root model, of the relationships of the package.
fn root_of(text: &str) -> Result<String, String> {
    let mut root = None;
    let mut xml = Xml::new(text);
    xml.root("Relationships")?;
    xml.children(&mut |_, child| {
        let is_root = child
            .get("Type")?
            .is_some_and(|kind| kind.ends_with(ROOT_TYPE));
        if child.name() == "Relationship" && is_root && root.is_none() {
            root = child.get("Target")?.map(|target| part_key(&target));
        }
        Ok(())
    })?;
    root.ok_or_else(|| "no model is named".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_a_part_in_any_writing_have_one_key() {
        for name in [
            "/3D/3dmodel.model",
            "3d/3DModel.model",
            "./3D/3dmodel.model",
            "3D\\3dmodel.model",
            "/3D/x/../3dmodel%2emodel",
            "/3D/3dm%6Fdel.model",
        ] {
            assert_eq!(part_key(name), "3d/3dmodel.model", "{name}");
        }
        assert_eq!(part_key("/3D/my%20part.model"), "3d/my part.model");
        assert_eq!(part_key("/3D/100%.model"), "3d/100%.model");
    }
}
