//! Every format, whole and damaged.

use super::samples::{cuboid, files, model, package, package_of, ply, stl_binary, stl_text};
use super::*;
use crate::fuzz::{self, Random, mutate};
use std::fmt::Write as _;
use std::time::{Duration, Instant};

fn part() -> Mesh {
    cuboid([0.0, 0.0, 0.0], [1.0, 2.0, 3.0])
}

/// With a quad, a continued line, negative indices, normals and a comment that is not UTF-8.
const OBJ: &[u8] = b"# caf\xe9\nmtllib none.mtl\no part\nv 0 0 0\nv 1 0 0\nv 0 2 0 # y\nv 1 2 0\n\
    v 0 0 3\nv 1 0 3\nv 0 2 3\nv 1 2 3\nvn 0 0 1\nf 1//1 3//1 4//1 2//1\nf 5 6 \\\n8 7\n\
    f 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf -7 -5 -1 -3\n";

fn plain_model() -> String {
    model("millimeter", &part(), "", r#"<item objectid="1"/>"#)
}

/// Files of every kind, and an OBJ that uses more of its format.
fn samples() -> Vec<(&'static str, &'static str, Vec<u8>)> {
    let mut files = files(&part());
    files.push(("rich text", "obj", OBJ.to_vec()));
    files
}

fn parse(bytes: &[u8], extension: &str) -> Result<Mesh> {
    parse_mesh(bytes, extension, Path::new("part"))
}

fn refused(bytes: &[u8], extension: &str) -> String {
    let text = parse(bytes, extension).unwrap_err().to_string();
    assert!(
        text.starts_with("mesh part: ") && text.contains("; accepted: "),
        "{text}"
    );
    text
}

#[test]
fn every_format_gives_the_same_welded_box() {
    for (kind, extension, bytes) in samples() {
        let mesh = parse(&bytes, extension).unwrap();
        assert_eq!(mesh.vertices.len(), 8, "{extension} {kind}");
        assert_eq!(mesh.triangles.len(), 12, "{extension} {kind}");
        assert_eq!(mesh.bounds(), [[0.0; 3], [1.0, 2.0, 3.0]]);
        assert!(
            (mesh.signed_volume() - 6.0).abs() < 1e-12,
            "{extension} {kind}"
        );
        assert!((mesh.area() - 22.0).abs() < 1e-12);
    }
}

#[test]
fn an_ascii_stl_may_hold_several_solids() {
    let far = cuboid([5.0; 3], [6.0; 3]);
    let bytes = [stl_text(&part()), stl_text(&far)].concat();
    assert!((parse(&bytes, "stl").unwrap().signed_volume() - 7.0).abs() < 1e-12);
}

#[test]
fn stl_oddities_of_other_programs_are_read() {
    let text = String::from_utf8(stl_text(&part())).unwrap();
    let capitals = text
        .to_ascii_uppercase()
        .replace("NORMAL 0 0 0", "NORMAL NAN NAN NAN");
    assert_eq!(
        parse(capitals.as_bytes(), "stl").unwrap(),
        parse(text.as_bytes(), "stl").unwrap()
    );
    // Bytes after the last triangle
    let longer = [stl_binary(&part()), vec![0; 7]].concat();
    assert_eq!(parse(&longer, "stl").unwrap().triangles.len(), 12);
}

#[test]
fn ply_polygons_are_cut_into_fans() {
    let text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n\
        element face 5\nproperty list uchar uint vertex_index\nend_header\n\
        0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n4 0 3 2 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
    let pyramid = parse(text.as_bytes(), "ply").unwrap();
    assert_eq!(pyramid.triangles.len(), 6);
    assert!((pyramid.signed_volume() - 1.0 / 3.0).abs() < 1e-15); // base 1, height 1
}

#[test]
fn units_items_and_components_of_3mf_are_applied() {
    let unit = cuboid([0.0; 3], [1.0; 3]);
    // A quarter turn about z (x → y), then 10 along x; components: one as it is, one mirrored in x and 5 along z
    let more = r#"<object id="2" type="model"><components><component objectid="1"/><component objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 5"/></components></object><object id="3" type="support"><components><component objectid="1"/></components></object>"#;
    let build = r#"<item objectid="2" transform="0 1 0 -1 0 0 0 0 1 10 0 0"/><item objectid="3"/>"#;
    let text = model("centimeter", &unit, more, build);
    let mesh = parse(&package(&text), "3mf").unwrap();
    assert_eq!(mesh.triangles.len(), 24); // the support is left out
    assert!((mesh.signed_volume() - 2000.0).abs() < 1e-9); // two cubes of 1 cm³, both outward
    // x: 10 − y, so 9…10 cm; y: x of the cubes, −1…1 cm; z: 0…6 cm
    assert_eq!(mesh.bounds(), [[90.0, -10.0, 0.0], [100.0, 10.0, 60.0]]);
}

#[test]
fn a_3mf_of_several_parts_is_put_together() {
    let production = r#"xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06""#;
    let cube = |low: f64| cuboid([low; 3], [low + 1.0; 3]);
    let part = model("millimeter", &cube(5.0), "", "");
    let more = r#"<object id="2"><components><component p:path="/3D/part.model" objectid="1"/><component objectid="1"/></components></object>"#;
    let build = r#"<item objectid="2"/><item p:path="/3D/part.model" objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 2"/>"#;
    let root = model("millimeter", &cube(0.0), more, build);
    let root = root.replacen("<model ", &format!("<model {production} "), 1);
    let with = |part: &str, root: &str| {
        let parts = [("3D/part.model", part), ("3D/3dmodel.model", root)];
        let parts = parts.map(|(name, text)| (name, text.as_bytes()));
        package_of(&parts[..if root.is_empty() { 1 } else { 2 }])
    };
    let mesh = parse(&with(&part, &root), "3mf").unwrap();
    assert_eq!(mesh.bounds(), [[0.0; 3], [6.0, 6.0, 8.0]]);
    assert!((mesh.signed_volume() - 3.0).abs() < 1e-12); // three cubes of 1 mm³
    assert!(refused(&with(&part, ""), "3mf").contains("no root model `3D/3dmodel.model`"));
    let bad = part.replacen("x=", "y=", 1);
    assert!(refused(&with(&bad, &root), "3mf").contains("x = `missing`"));
    let cut = refused(&with(&part[..part.len() / 2], &root), "3mf");
    assert!(cut.contains("3D/part.model"), "{cut}");
    // Nothing of it is placed: what an archiver leaves behind
    let plain = plain_model();
    let left_behind = with("\0\x05\x16", &plain);
    assert_eq!(parse(&left_behind, "3mf").unwrap().triangles.len(), 12);
}

#[test]
fn endless_components_are_refused() {
    let more = r#"<object id="2"><components><component objectid="2"/></components></object>"#;
    let text = model("millimeter", &part(), more, r#"<item objectid="2"/>"#);
    assert!(refused(&package(&text), "3mf").contains("nested"));
    // 2^25 copies of nothing
    let mut more = String::from(r#"<object id="100"><components/></object>"#);
    for i in 101..=125 {
        let inner = i - 1;
        write!(more, r#"<object id="{i}"><components><component objectid="{inner}"/><component objectid="{inner}"/></components></object>"#).unwrap();
    }
    let text = model("millimeter", &part(), &more, r#"<item objectid="125"/>"#);
    assert!(parse(&package(&text), "3mf").is_err());
}

#[test]
fn damage_is_named() {
    let binary = stl_binary(&part());
    assert!(refused(&binary[..300], "stl").contains("truncated"));
    assert!(refused(&binary[..40], "stl").contains("truncated"));
    assert!(refused(b"", "stl").contains("empty"));
    let text = stl_text(&part());
    assert!(refused(&text[..text.len() - 20], "stl").contains("truncated"));
    for other in [
        &b"Dear colleague,\nthe part is attached."[..],
        b"solid advice\nis hard to find",
        b"ply\nformat ascii 1.0\n",
        b"PK\x03\x04\0\0\0\0",
    ] {
        let found = refused(other, "stl");
        assert!(
            found.contains("neither an ASCII nor a binary STL file")
                && !found.contains("truncated"),
            "{found}"
        );
    }
    let with = |from: &str, to: &str| {
        String::from_utf8(stl_text(&part()))
            .unwrap()
            .replacen(from, to, 1)
            .into_bytes()
    };
    assert!(refused(&with("vertex 1 2 3", "vertex 1 nan 3"), "stl").contains("NaN"));
    assert!(refused(&with("vertex 1 2 3", "vertex 1 2"), "stl").contains("damaged"));
    assert!(refused(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "obj").contains("out of bounds"));
    assert!(refused(b"v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n", "obj").contains("coordinate inf"));
    assert!(refused(b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "obj").contains("no area"));
    assert!(refused(b"v 0 0 0\n", "obj").contains("no triangle"));
    let short = ply(&part(), "binary_little_endian");
    assert!(refused(&short[..short.len() - 9], "ply").contains("truncated"));
    let far = String::from_utf8(ply(&part(), "ascii")).unwrap();
    assert!(
        refused(far.replace("3 0 3 1", "3 0 9 1").as_bytes(), "ply").contains("refers to vertex 9")
    );
    assert!(
        refused(
            far.replace("vertex 8", "vertex 99999999999").as_bytes(),
            "ply"
        )
        .contains("promises")
    );
    let model = plain_model();
    let changed = |from: &str, to: &str| refused(&package(model.replacen(from, to, 1)), "3mf");
    assert!(changed("y=\"2\"", "y=\"two\"").contains("y = `two`"));
    assert!(changed("v3=\"3\"", "v3=\"33\"").contains("refers to vertex 33"));
    assert!(changed("v3=\"3\"", "v3=\"-3\"").contains("v3 = `-3`"));
    assert!(changed("y=\"2\"", "y=\" 2\"").contains("y = ` 2`")); // the reader would take it for 0
    assert!(changed("item objectid=\"1\"", "item objectid=\"7\"").contains("object 7"));
    let whole = package(&model);
    assert!(refused(&whole[..whole.len() / 2], "3mf").contains("damaged"));
    assert!(refused(b"x", "step").contains("`.step` is not known"));
    assert!(refused(b"x", "").contains("no extension"));
}

#[test]
fn a_file_that_ends_too_early_is_never_read_in_part_unless_it_is_an_obj() {
    for (kind, extension, bytes) in samples() {
        let mut partly = 0;
        for end in 0..bytes.len() {
            if let Ok(mesh) = parse(&bytes[..end], extension) {
                // What is missing may be the name after `endsolid`
                partly += usize::from(mesh.triangles.len() < 12);
            }
        }
        // An OBJ has neither counts nor an end: what is left of it is an open mesh
        assert_eq!(partly > 0, extension == "obj", "{extension} {kind}");
    }
}

#[test]
fn a_package_that_promises_more_than_it_holds_is_refused_before_memory_is_reserved() {
    let mut bytes = package(plain_model());
    // The uncompressed size of the last part, in the central directory: 24 bytes after its signature
    let entry = bytes.windows(4).rposition(|w| w == b"PK\x01\x02").unwrap();
    bytes[entry + 24..entry + 28].copy_from_slice(&0xffff_fff0u32.to_le_bytes());
    assert!(refused(&bytes, "3mf").contains("promises"));
}

#[test]
fn missing_files_and_what_was_written_is_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.Stl");
    assert!(matches!(read_mesh(&path), Err(Error::Io { .. })));
    std::fs::create_dir(&path).unwrap();
    let text = read_mesh(&path).unwrap_err().to_string();
    assert!(text.contains("is a folder"), "{text}");
    std::fs::remove_dir(&path).unwrap();
    let mesh = part();
    write_stl_binary(&path, &mesh).unwrap();
    let back = read_mesh(&path).unwrap();
    assert_eq!((back.vertices.len(), back.triangles.len()), (8, 12));
    assert_eq!(back.signed_volume(), mesh.signed_volume());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1); // nothing is left aside
    assert!(write_stl_binary(folder.path().join("none/part.stl"), &mesh).is_err());
}

#[test]
fn mutated_bytes_end_in_a_mesh_or_an_error() {
    let samples = samples();
    let text = plain_model();
    let start = Instant::now();
    let (mut round, mut read) = (0u64, 0u64);
    while start.elapsed() < fuzz::time() {
        let mut random = Random(round);
        let which = random.below(samples.len() + 1);
        let (kind, extension, bytes) = match samples.get(which) {
            Some((kind, extension, bytes)) => {
                let mut bytes = bytes.clone();
                mutate(&mut bytes, &mut random);
                (*kind, *extension, bytes)
            }
            // Checksums would stop most changes of a package: change the model and pack it
            None => {
                let mut model = text.clone().into_bytes();
                mutate(&mut model, &mut random);
                ("model", "3mf", package(&model))
            }
        };
        let one = Instant::now();
        let result = std::panic::catch_unwind(|| parse(&bytes, extension));
        let Ok(result) = result else {
            panic!("{extension} ({kind}), round {round}: the reader panicked")
        };
        if let Ok(mesh) = result {
            read += 1;
            assert!(
                mesh.triangles
                    .iter()
                    .flatten()
                    .all(|&v| (v as usize) < mesh.vertices.len())
            );
            assert!(mesh.vertices.iter().flatten().all(|v| v.is_finite()));
        }
        assert!(
            one.elapsed() < Duration::from_secs(5),
            "{extension} ({kind}), round {round}: slow"
        );
        round += 1;
    }
    // Both ends are reached: harmless changes and fatal ones
    assert!(read > 0 && read < round, "{read} of {round} could be read");
}
