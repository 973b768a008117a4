//! Every format, whole and damaged.

use super::samples::{
    cuboid, files, model, obj, package, package_of, ply, stl_binary, stl_text, together,
};
use super::*;
use std::fmt::Write as _;
use tomolith_core::check::fuzz::{mutate, rounds};

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

fn read(bytes: &[u8], extension: &str) -> Result<MeshFile> {
    parse_mesh(bytes, extension, Path::new("part"))
}

fn parse(bytes: &[u8], extension: &str) -> Result<Mesh> {
    read(bytes, extension).map(|file| file.mesh)
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
fn ascii_stl_is_read_however_it_is_laid_out() {
    let text = String::from_utf8(stl_text(&part())).unwrap();
    let plain = parse(text.as_bytes(), "stl").unwrap();
    let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let spaced = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    for (what, bytes) in [
        (
            "capitals",
            text.to_uppercase()
                .replace("NORMAL 0 0 0", "NORMAL NAN NAN NAN")
                .into_bytes(),
        ),
        ("blank lines first", format!("\n\n  {text}").into_bytes()),
        ("byte order mark", format!("\u{feff}{text}").into_bytes()),
        ("UTF-16", utf16),
        ("CR", text.replace('\n', "\r").into_bytes()),
        ("one line", spaced(&text).into_bytes()),
        (
            "a word a line",
            spaced(&text).replace(' ', "\n").into_bytes(),
        ),
        ("words in two", text.replace("end", "end ").into_bytes()),
        (
            "words after",
            text.replace("endfacet", "endfacet 12").into_bytes(),
        ),
        ("no name", text.replacen("solid part", "", 1).into_bytes()),
        (
            "a name of keywords",
            text.replacen("solid part", "solid facet vertex", 1)
                .into_bytes(),
        ),
    ] {
        let file = read(&bytes, "stl").unwrap();
        assert_eq!((&file.mesh, file.notes.len()), (&plain, 0), "{what}");
    }
    let cut = read(text.replace("endsolid part", "").as_bytes(), "stl").unwrap();
    assert_eq!(cut.mesh, plain);
    tomolith_core::contains!(cut.notes[0], "without `endsolid`");
    // Nothing of a facet is lost without a word
    for (from, to, found) in [
        (
            "facet normal",
            "facets normal",
            "line 4: a corner outside of a facet",
        ),
        ("vertex", "vertx", "the facet of line 2 has 2 corners"),
        (" endloop\nendfacet", "", "the facet of line 2 has no end"),
    ] {
        let text = refused(text.replacen(from, to, 1).as_bytes(), "stl");
        assert!(text.contains(found), "{text}");
    }
}

#[test]
fn a_wrong_count_in_a_binary_stl_loses_no_triangle() {
    let whole = stl_binary(&part());
    let with = |count: u32, more: &[u8]| {
        let mut bytes = [&whole, more].concat();
        bytes[80..84].copy_from_slice(&count.to_le_bytes());
        bytes
    };
    for count in [0, 5, u32::MAX] {
        let file = read(&with(count, &[]), "stl").unwrap();
        assert_eq!(file.mesh.triangles.len(), 12);
        assert_eq!(
            file.notes,
            [format!(
                "The header promises {count} triangles, the file holds 12: all are read."
            )]
        );
    }
    for (more, notes) in [([0; 7], 0), ([1; 7], 1)] {
        let file = read(&with(12, &more), "stl").unwrap();
        assert_eq!((file.mesh.triangles.len(), file.notes.len()), (12, notes));
    }
    for (count, more) in [(13, &[][..]), (0, &[0; 7])] {
        assert!(
            refused(&with(count, more), "stl").contains(&format!("promises {count} triangles"))
        );
    }
}

#[test]
fn obj_is_read_in_any_encoding_with_colors_and_weights() {
    let text = String::from_utf8(obj(&part())).unwrap();
    let plain = parse(text.as_bytes(), "obj").unwrap();
    let colored = text.replacen("v 0 0 0", "v 0 0 0 0.5 0.5 0.5", 1);
    let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    for bytes in [
        colored.into_bytes(),
        format!("\u{feff}{text}").into_bytes(),
        [&[0xff, 0xfe], &utf16[..]].concat(),
        text.replace('\n', "\r").into_bytes(),
    ] {
        let file = read(&bytes, "obj").unwrap();
        assert_eq!((file.mesh, file.notes.len()), (plain.clone(), 0));
    }
    let weighted = read(text.replacen("v 1 2 3", "v 1 2 3 2.5", 1).as_bytes(), "obj").unwrap();
    assert_eq!(weighted.mesh, plain);
    tomolith_core::contains!(weighted.notes[0], "the first on line 9");
    for (more, found) in [
        ("v 1 2\n", "line 22: `` in place of a coordinate"),
        ("f 1 2 0\n", "line 22: a face refers to vertex `0`"),
        ("f 1 2 -9\n", "line 22: a face refers to vertex `-9`"),
        ("surf 0 1 0 1 1 2 3 4\n", "line 22: a free-form surface"),
    ] {
        let text = refused(format!("{text}{more}").as_bytes(), "obj");
        assert!(text.contains(found), "{text}");
    }
    assert!(refused(b"Dear colleague", "obj").contains("it begins with `Dear colleague`"));
}

#[test]
fn ply_is_read_however_it_is_laid_out() {
    let text = String::from_utf8(ply(&part(), "ascii")).unwrap();
    let plain = parse(text.as_bytes(), "ply").unwrap();
    let (header, body) = text.split_once("end_header\n").unwrap();
    let (points, faces) = body.split_at(body.find("\n3 ").unwrap() + 1);
    let cut = header.find("element face").unwrap();
    let start = header.find("element vertex").unwrap();
    let swapped = [&header[..start], &header[cut..], &header[start..cut]].concat();
    for (what, text) in [
        (
            "blank lines",
            text.replacen("end_header\n", "end_header\n\n", 1)
                .replace("\n3 ", "\n\n3 "),
        ),
        (
            "wrapped",
            format!("{header}end_header\n{}", body.replace(' ', "\n")),
        ),
        (
            "faces first",
            format!("{swapped}end_header\n{faces}{points}"),
        ),
        ("CR", text.replace('\n', "\r")),
        ("CR LF", text.replace('\n', "\r\n")),
        ("byte order mark", format!("\u{feff}{text}")),
        ("another name", text.replace("vertex_indices", "corners")),
        (
            "more",
            format!(
                "{}element edge 1\nproperty int vertex1\nproperty list uchar float w\nend_header\n{body}5 2 0.5 1.5\n",
                header
            ),
        ),
    ] {
        assert_eq!(parse(text.as_bytes(), "ply").unwrap(), plain, "{what}");
    }
    for (from, to, found) in [
        (
            "1 2 3 7",
            "1 2 3 7 9",
            "rows have more numbers than properties",
        ),
        (
            "property float z",
            "property float h",
            "a vertex has no property `z`",
        ),
        (
            "element face",
            "element polygon",
            "no surface: its elements are 8 of `vertex`, 12 of `polygon`",
        ),
        ("list uchar int", "list uchar float", "no list of integers"),
        ("end_header", "", "damaged header: line 12 is `0 0 0 7`"),
    ] {
        let text = refused(text.replacen(from, to, 1).as_bytes(), "ply");
        assert!(text.contains(found), "{text}");
    }
}

#[test]
fn strips_of_a_ply_turn_every_other_triangle() {
    // A tetrahedron: a strip of all its faces, and the same as two strips
    for strips in ["1\n6 0 1 2 3 0 1", "1\n9 0 1 2 3 -1 2 3 0 1"] {
        let text = format!(
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
             element tristrips {}",
            strips.replacen(
                '\n',
                "\nproperty list int int vertex_indices\nend_header\n0 0 0\n0 1 0\n1 0 0\n0 0 1\n",
                1
            )
        );
        let mesh = parse(text.as_bytes(), "ply").unwrap();
        assert_eq!(mesh.triangles.len(), 4);
        assert!(
            (mesh.signed_volume() - 1.0 / 6.0).abs() < 1e-15,
            "{}",
            mesh.signed_volume()
        );
    }
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
    for (name, mm) in [
        ("micron", 1e-3),
        ("inch", 25.4),
        ("foot", 304.8),
        ("meter", 1e3),
    ] {
        let text = model(name, &unit, "", r#"<item objectid="1"/>"#);
        assert_eq!(parse(&package(&text), "3mf").unwrap().bounds()[1], [mm; 3]);
    }
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
    assert!(refused(&with(&part, ""), "3mf").contains("no root model `3d/3dmodel.model`"));
    let bad = part.replacen("x=", "w=", 1);
    assert!(refused(&with(&bad, &root), "3mf").contains("x = `missing`"));
    let cut = refused(&with(&part[..part.len() / 2], &root), "3mf");
    assert!(cut.contains("3d/part.model"), "{cut}");
    // Nothing of it is placed: what an archiver leaves behind
    let plain = plain_model();
    let left_behind = with("\0\x05\x16", &plain);
    assert_eq!(parse(&left_behind, "3mf").unwrap().triangles.len(), 12);
}

/// Two boxes of 6 mm³ in one mesh, the second 10 mm along x.
fn two_boxes() -> Mesh {
    together(&[part(), cuboid([10.0, 0.0, 0.0], [11.0, 2.0, 3.0])])
}

#[test]
fn a_3mf_is_read_however_its_parts_are_named_and_encoded() {
    let text = plain_model();
    let plain = parse(&package(&text), "3mf").unwrap();
    let packed = |name: &str, content: &[u8]| package_of(&[(name, content)]);
    let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let prefixed = text
        .replace('<', "<c:")
        .replace("<c:/", "</c:")
        .replace("<c:?", "<?");
    for bytes in [
        packed("3d/3DModel.MODEL", text.as_bytes()),
        packed("3D/3dmodel%2Emodel", text.as_bytes()),
        packed("3D/3dmodel.model", &[&[0xff, 0xfe], &utf16[..]].concat()),
        package(text.replace(
            "<resources>",
            "<metadata name=\"a\" preserve=\"1\">x</metadata><resources>",
        )),
        package(text.replace("y=\"2\"", "y=\" 2 \"")),
        package(prefixed.replace("xmlns=", "xmlns:c=")),
    ] {
        let file = read(&bytes, "3mf").unwrap();
        assert_eq!((file.mesh, file.notes.len()), (plain.clone(), 0));
    }
}

#[test]
fn extensions_of_3mf_are_read_or_refused_by_name() {
    let requiring = |namespace: &str| {
        let more = format!("<model xmlns:e=\"{namespace}\" requiredextensions=\"e\" ");
        package(plain_model().replacen("<model ", &more, 1))
    };
    let material = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
    assert!(parse(&requiring(material), "3mf").is_ok());
    assert!(refused(&requiring("http://example.org/a"), "3mf").contains("(http://example.org/a)"));
    let stack = r#"<slicestack id="3"><slice ztop="1"><vertices><vertex x="0" y="0"/></vertices></slice></slicestack><object "#;
    let sliced = plain_model().replacen("<object ", stack, 1);
    let with = |attributes: &str| package(sliced.replacen("id=\"1\"", attributes, 1));
    assert!(parse(&with(r#"id="1" s:slicestackid="3""#), "3mf").is_ok());
    let rough = with(r#"id="1" s:slicestackid="3" s:meshresolution="lowres""#);
    assert!(refused(&rough, "3mf").contains("object 1 is given by slices"));
    let other = r#"<object id="2"><b:booleanshape objectid="1"/></object>"#;
    let text = model("millimeter", &part(), other, r#"<item objectid="2"/>"#);
    assert!(refused(&package(text), "3mf").contains("object 2 is a `booleanshape`"));
}

#[test]
fn items_that_are_not_printable_are_left_out_with_a_word() {
    let more = r#"<object id="2"><components><component objectid="1"/></components></object>"#;
    let build = |second: &str| {
        let items = format!(r#"<item objectid="1" printable="1"/><item objectid="2" {second}/>"#);
        package(model("millimeter", &part(), more, &items))
    };
    for no in ["0", "false"] {
        let file = read(&build(&format!("printable=\"{no}\"")), "3mf").unwrap();
        assert_eq!(file.mesh.triangles.len(), 12);
        tomolith_core::contains!(file.notes[0], "1 item of the build, which");
    }
    assert!(refused(&build("printable=\"no\""), "3mf").contains("printable = `no`"));
    let placing = |items: &str| refused(&package(model("millimeter", &part(), "", items)), "3mf");
    let none = placing(r#"<item objectid="1" printable="0"/>"#);
    tomolith_core::contains!(none, "none of the 1 items");
    tomolith_core::contains!(placing(""), "places nothing");
}

#[test]
fn volumes_of_slicers_are_taken_out_or_left_out() {
    let prusa = |role: &str| {
        let text = model("millimeter", &two_boxes(), "", r#"<item objectid="1"/>"#);
        let config = format!(
            r#"<config><object id="1"><volume firstid="0" lastid="11"><metadata type="volume" key="volume_type" value="ModelPart"/></volume><volume firstid="12" lastid="23"><metadata type="volume" key="volume_type" value="{role}"/></volume></object></config>"#
        );
        let parts = [
            ("3D/3dmodel.model", &*text),
            ("Metadata/Slic3r_PE_model.config", &*config),
        ];
        package_of(&parts.map(|(name, text)| (name, text.as_bytes())))
    };
    let bambu = |role: &str| {
        let more = r#"<object id="2"><components><component objectid="1"/><component objectid="1" transform="1 0 0 0 1 0 0 0 1 10 0 0"/></components></object>"#;
        // Two components need two objects: the second is a copy of the first
        let more = more.replacen("objectid=\"1\" transform", "objectid=\"3\" transform", 1);
        let copy = r#"<object id="3"><components><component objectid="1"/></components></object>"#;
        let more = format!("{copy}{more}");
        let text = model("millimeter", &part(), &more, r#"<item objectid="2"/>"#);
        let config = format!(
            r#"<config><object id="2"><part id="1" subtype="normal_part"/><part id="3" subtype="{role}"/></object></config>"#
        );
        let parts = [
            ("3D/3dmodel.model", &*text),
            ("Metadata/model_settings.config", &*config),
        ];
        package_of(&parts.map(|(name, text)| (name, text.as_bytes())))
    };
    for (file, triangles, word) in [
        (prusa("NegativeVolume"), [12, 12], Some("Negative")),
        (prusa("ParameterModifier"), [12, 0], Some("Modifiers")),
        (prusa("ModelPart"), [24, 0], None),
        (bambu("negative_part"), [12, 12], Some("Negative")),
        (bambu("support_blocker"), [12, 0], Some("Modifiers")),
        (bambu("normal_part"), [24, 0], None),
    ] {
        let file = read(&file, "3mf").unwrap();
        assert_eq!(
            [file.mesh.triangles.len(), file.negative.triangles.len()],
            triangles
        );
        assert_eq!(file.mesh.bounds()[0], [0.0; 3]);
        let first = file.notes.iter().map(|note| note.split(' ').next());
        assert!(first.eq(word.map(Some)), "{:?}", file.notes);
    }
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
    assert!(refused(&binary[..82], "stl").contains("truncated"));
    assert!(refused(b"", "stl").contains("empty"));
    let text = stl_text(&part());
    assert!(refused(&text[..text.len() - 30], "stl").contains("truncated"));
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
        let text = String::from_utf8(text.clone()).unwrap();
        refused(text.replacen(from, to, 1).as_bytes(), "stl")
    };
    assert!(with("vertex 1 2 3", "vertex 1 nan 3").contains("NaN"));
    assert!(with("vertex 1 2 3", "vertex 1 2").contains("damaged"));
    for (last, found) in [
        (
            "v 0 1 0\nf 1 2 4\n",
            "line 4: a face refers to vertex 4, but there are 3",
        ),
        ("v 0 inf 0\nf 1 2 3\n", "coordinate inf"),
        ("v 2 0 0\nf 1 2 3\n", "no area"),
        ("", "2 vertices and no face"),
    ] {
        let text = format!("v 0 0 0\nv 1 0 0\n{last}");
        tomolith_core::contains!(refused(text.as_bytes(), "obj"), found);
    }
    let short = ply(&part(), "binary_little_endian");
    assert!(refused(&short[..short.len() - 9], "ply").contains("truncated"));
    let far = String::from_utf8(ply(&part(), "ascii")).unwrap();
    let with = |from: &str, to: &str| refused(far.replace(from, to).as_bytes(), "ply");
    assert!(with("3 0 3 1", "3 0 9 1").contains("refers to vertex 9"));
    assert!(with("vertex 8", "vertex 99999999999").contains("promises"));
    let model = plain_model();
    for (from, to, found) in [
        ("y=\"2\"", "y=\"two\"", "y = `two`"),
        ("v3=\"3\"", "v3=\"33\"", "refers to vertex 33"),
        ("v3=\"3\"", "v3=\"-3\"", "v3 = `-3`"),
        ("y=\"2\"", "y=\" \"", "y = ` `"),
        ("item objectid=\"1\"", "item objectid=\"7\"", "object 7"),
    ] {
        let damaged = package(model.replacen(from, to, 1));
        tomolith_core::contains!(refused(&damaged, "3mf"), found);
    }
    let whole = package(&model);
    assert!(refused(&whole[..whole.len() / 2], "3mf").contains("damaged"));
    assert!(refused(b"x", "step").contains("`.step` is not known"));
    assert!(refused(b"x", "").contains("no extension"));
}

#[test]
fn a_file_that_ends_too_early_is_never_read_in_part_without_a_word_unless_it_is_an_obj() {
    for (kind, extension, bytes) in samples() {
        let mut partly = 0;
        for end in 0..bytes.len() {
            if let Ok(file) = read(&bytes[..end], extension) {
                // What is missing may be the name after `endsolid`
                partly += usize::from(file.mesh.triangles.len() < 12 && file.notes.is_empty());
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
fn files_are_read_and_missing_ones_and_folders_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.Stl");
    assert!(matches!(read_mesh(&path), Err(Error::Io { .. })));
    std::fs::create_dir(&path).unwrap();
    let text = read_mesh(&path).unwrap_err().to_string();
    assert!(text.contains("is a folder"), "{text}");
    std::fs::remove_dir(&path).unwrap();
    std::fs::write(&path, stl_binary(&part())).unwrap();
    let mesh = read_mesh(&path).unwrap().mesh;
    assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (8, 12));
    assert_eq!(mesh.signed_volume(), part().signed_volume());
}

#[test]
fn mutated_bytes_end_in_a_mesh_or_an_error() {
    let (samples, text) = (samples(), plain_model());
    let [read, all] = rounds(1.0, |random| {
        let which = random.below(samples.len() + 1);
        let (extension, bytes) = match samples.get(which) {
            Some((_, extension, bytes)) => {
                let mut bytes = bytes.clone();
                mutate(&mut bytes, random);
                (*extension, bytes)
            }
            // Checksums would stop most changes of a package: change the model and pack it
            None => {
                let mut model = text.clone().into_bytes();
                mutate(&mut model, random);
                ("3mf", package(&model))
            }
        };
        let Ok(mesh) = parse(&bytes, extension) else {
            return false;
        };
        let is_there = |&v: &u32| (v as usize) < mesh.vertices.len();
        assert!(mesh.triangles.iter().flatten().all(is_there));
        assert!(mesh.vertices.iter().flatten().all(|v| v.is_finite()));
        true
    });
    // Both ends are reached: harmless changes and fatal ones
    assert!(read > 0 && read < all, "{read} of {all} could be read");
}
