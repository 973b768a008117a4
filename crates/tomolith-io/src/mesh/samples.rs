//! Small closed meshes for tests, and as files.

use super::Mesh;
use std::fmt::Write as _;
use std::io::Write as _;
use tomolith_core::vector::{cross, dot};

/// A box, outward.
#[must_use]
pub fn cuboid(low: [f64; 3], high: [f64; 3]) -> Mesh {
    let corner = |i: usize| std::array::from_fn(|axis| [low, high][i >> axis & 1][axis]);
    let vertices = (0..8).map(corner).collect();
    let quads: [[u32; 4]; 6] = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let triangles = quads
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .collect();
    Mesh {
        vertices,
        triangles,
    }
}

/// A ball of 20·4^`levels` triangles with its corners on the sphere, outward.
#[must_use]
pub fn ball(center: [f64; 3], radius: f64, levels: usize) -> Mesh {
    let g = (1.0 + 5f64.sqrt()) / 2.0;
    let mut points: Vec<[f64; 3]> = Vec::new();
    for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
        points.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    // Faces of the icosahedron: three corners at distance 2 of each other
    let near = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>() < 4.1;
    let mut faces = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                let [a, b, c] = [points[i], points[j], points[k]];
                if near(a, b) && near(b, c) && near(a, c) {
                    let outward = dot(a, cross(b, c)) > 0.0;
                    faces.push(if outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    let middle = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| (a[i] + b[i]) / 2.0);
    for _ in 0..levels {
        faces = faces
            .iter()
            .flat_map(|&[a, b, c]| {
                let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    let on_sphere = |p: [f64; 3]| {
        let scale = radius / dot(p, p).sqrt();
        std::array::from_fn(|i| center[i] + scale * p[i])
    };
    let mut welder = super::Welder::default();
    for face in faces {
        welder.push(face.map(on_sphere));
    }
    welder.mesh
}

/// Several meshes in one, not welded.
#[must_use]
pub fn together(meshes: &[Mesh]) -> Mesh {
    let mut all = Mesh::default();
    for mesh in meshes {
        let first = all.vertices.len() as u32;
        all.vertices.extend(&mesh.vertices);
        all.triangles
            .extend(mesh.triangles.iter().map(|t| t.map(|v| v + first)));
    }
    all
}

/// The same surface inside out.
#[must_use]
pub fn inverted(mut mesh: Mesh) -> Mesh {
    mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    mesh
}

/// A text STL file.
///
/// # Panics
/// Never: writing to memory does not fail.
#[must_use]
pub fn stl_text(mesh: &Mesh) -> Vec<u8> {
    let mut text = String::from("solid part\n");
    for t in 0..mesh.triangles.len() {
        text += "facet normal 0 0 0\n outer loop\n";
        for [x, y, z] in mesh.corners(t) {
            writeln!(text, "  vertex {x} {y} {z}").unwrap();
        }
        text += " endloop\nendfacet\n";
    }
    text += "endsolid part\n";
    text.into_bytes()
}

/// A binary STL file.
///
/// # Panics
/// Never: writing to memory does not fail.
#[must_use]
pub fn stl_binary(mesh: &Mesh) -> Vec<u8> {
    // A name that begins like an ASCII file, as some programs write it
    let mut bytes = b"solid part".to_vec();
    bytes.resize(80, b' ');
    bytes.extend((mesh.triangles.len() as u32).to_le_bytes());
    for t in 0..mesh.triangles.len() {
        bytes.extend([0; 12]);
        for value in mesh.corners(t).into_iter().flatten() {
            bytes.extend((value as f32).to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// A PLY file: `ascii`, `binary_little_endian` or `binary_big_endian`.
///
/// # Panics
/// Never: writing to memory does not fail.
#[must_use]
pub fn ply(mesh: &Mesh, encoding: &str) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat {encoding} 1.0\ncomment made by a test\nelement vertex {}\nproperty float x\n\
         property float y\nproperty float z\nproperty uchar red\nelement face {}\n\
         property list uchar int vertex_indices\nend_header\n",
        mesh.vertices.len(),
        mesh.triangles.len()
    )
    .into_bytes();
    // A number of four bytes by its bits
    let stored = |bits: u32| match encoding {
        "binary_little_endian" => bits.to_le_bytes(),
        _ => bits.to_be_bytes(),
    };
    for &[x, y, z] in &mesh.vertices {
        if encoding == "ascii" {
            writeln!(bytes, "{x} {y} {z} 7").unwrap();
        } else {
            bytes.extend(
                [x, y, z]
                    .map(|v| stored((v as f32).to_bits()))
                    .as_flattened(),
            );
            bytes.push(7);
        }
    }
    for &[a, b, c] in &mesh.triangles {
        if encoding == "ascii" {
            writeln!(bytes, "3 {a} {b} {c}").unwrap();
        } else {
            bytes.push(3);
            bytes.extend([a, b, c].map(stored).as_flattened());
        }
    }
    bytes
}

const TYPES: &str = r#"<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>"#;
const RELATIONS: &str = r#"<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>"#;

/// The 3MF package of a model.
///
/// # Panics
/// Never: writing to memory does not fail.
#[must_use]
pub fn package(model: impl AsRef<[u8]>) -> Vec<u8> {
    package_of(&[("3D/3dmodel.model", model.as_ref())])
}

/// A 3MF package of several models; `3D/3dmodel.model` is its root.
///
/// # Panics
/// Never: writing to memory does not fail.
#[must_use]
pub fn package_of(models: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default();
    let about = [
        ("[Content_Types].xml", TYPES.as_bytes()),
        ("_rels/.rels", RELATIONS.as_bytes()),
    ];
    for (name, content) in about.iter().chain(models) {
        zip.start_file(*name, options).unwrap();
        zip.write_all(content).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// The model of a 3MF package in a unit, with further objects and what is built of them.
///
/// # Panics
/// Never: writing to memory does not fail.
#[must_use]
pub fn model(unit: &str, mesh: &Mesh, more: &str, build: &str) -> String {
    let mut text = format!(
        r#"<?xml version="1.0"?><model unit="{unit}" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices>"#
    );
    for [x, y, z] in &mesh.vertices {
        write!(text, r#"<vertex x="{x}" y="{y}" z="{z}"/>"#).unwrap();
    }
    text += "</vertices><triangles>";
    for [a, b, c] in &mesh.triangles {
        write!(text, r#"<triangle v1="{a}" v2="{b}" v3="{c}"/>"#).unwrap();
    }
    write!(
        text,
        "</triangles></mesh></object>{more}</resources><build>{build}</build></model>"
    )
    .unwrap();
    text
}

/// An OBJ file.
///
/// # Panics
/// Never: writing to memory does not fail.
#[must_use]
pub fn obj(mesh: &Mesh) -> Vec<u8> {
    let mut text = String::from("o part\n");
    for [x, y, z] in &mesh.vertices {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| v + 1);
        writeln!(text, "f {a} {b} {c}").unwrap();
    }
    text.into_bytes()
}

/// The mesh in a file of every kind: what it is called, its extension, its bytes.
#[must_use]
pub fn files(mesh: &Mesh) -> Vec<(&'static str, &'static str, Vec<u8>)> {
    let model = model("millimeter", mesh, "", r#"<item objectid="1"/>"#);
    vec![
        ("text", "stl", stl_text(mesh)),
        ("binary", "STL", stl_binary(mesh)),
        ("text", "obj", obj(mesh)),
        ("text", "ply", ply(mesh, "ascii")),
        ("little endian", "ply", ply(mesh, "binary_little_endian")),
        ("big endian", "ply", ply(mesh, "binary_big_endian")),
        ("package", "3mf", package(&model)),
    ]
}
