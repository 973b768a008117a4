//! 3MF: a zip archive with the model in XML; what is printed is the *build*, items that place objects.
//!
//! Objects are meshes, or components: other objects with a transform each. Lengths are in the root model's unit and come
//! out in mm. Objects meant as support or for other purposes are skipped. Parts are inflated within bounds, and their numbers are looked at
//! before the reader gets them: it takes what is no number for zero.

use super::{Sink, bad};
use instant_xml::FromXml;
use std::collections::HashMap;
use std::io::{Cursor, Read};
use std::path::Path;
use threemf2::model::domain::model::{Model, Unit};
use threemf2::model::domain::object::{Object, ObjectKind, ObjectType};
use threemf2::model::domain::transform::Transform;
use tomolith_core::error::Result;
use tomolith_core::vector::{cross, dot};

const WANTED: &str = "a 3MF package with a build of mesh objects";

/// Deflate cannot shrink by more than 1032; meshes as text shrink by 5 to 20.
const MOST_INFLATED: u64 = 200;

/// Small packages of constant bytes may do better than that.
const SMALL: u64 = 16 << 20;

/// Parts of a package; printers' project files have hundreds.
const MOST_PARTS: usize = 10_000;

/// Depth of components in components.
const DEEPEST: usize = 32;

/// Placed objects and components: stops packages whose components refer to each other many times over.
const MOST_PLACED: usize = 1 << 20;

pub(super) fn parse(bytes: &[u8], path: &Path, sink: Sink) -> Result<()> {
    let refuse = |found: String| bad(path, found, WANTED);
    let package = Package::read(bytes).map_err(refuse)?;
    let root = package.root().map_err(refuse)?;
    let mut traversal = ComponentTraversal {
        objects: package.objects(),
        package: &package,
        path,
        placed: 0,
        sink,
    };
    let unit = Place::scaled(millimeters(root.unit.as_ref()));
    for item in &root.build.item {
        let place = Place::of(item.transform.as_ref()).then(&unit);
        let part = item
            .path
            .as_ref()
            .map_or(&*package.root, |p| inside(p.as_str()));
        traversal.object(part, item.objectid, &place, 0)?;
    }
    Ok(())
}

/// How many vertices and triangles a model has.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
struct Counted {
    vertices: usize,
    triangles: usize,
}

/// The models of a package, by the names of their parts; those that cannot be read matter only where something of them is placed.
struct Package {
    root: String,
    models: HashMap<String, Result<Model, String>>,
}

impl Package {
    /// Inflates every part within bounds, and reads the models.
    fn read(bytes: &[u8]) -> Result<Self, String> {
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(|e| damaged(&e))?;
        if archive.len() > MOST_PARTS {
            return Err(format!("a package of {} parts", archive.len()));
        }
        let (parts, index) = (archive.len(), archive.index_for_name(ROOT_RELATIONSHIPS));
        let mut left = MOST_INFLATED * bytes.len() as u64 + SMALL;
        let mut inflated = |i: usize| {
            let part = archive.by_index(i).map_err(|e| damaged(&e))?;
            let (name, size) = (part.name().to_owned(), part.size());
            if size > left {
                let all = bytes.len();
                return Err(format!(
                    "a package of {all} bytes that promises {size} bytes in `{name}`"
                ));
            }
            let mut text = Vec::new();
            part.take(left)
                .read_to_end(&mut text)
                .map_err(|e| damaged(&e))?;
            if text.len() as u64 != size {
                let read = text.len();
                let found = format!("`{name}` has {read} bytes instead of {size}");
                return Err(damaged(&found));
            }
            left -= size;
            Ok((name, text))
        };
        let relationships = index
            .ok_or_else(|| damaged(&format!("no part `{ROOT_RELATIONSHIPS}`")))
            .and_then(&mut inflated)?;
        let root = root_of(&String::from_utf8_lossy(&relationships.1))?;
        let mut models = HashMap::new();
        for i in (0..parts).filter(|i| Some(*i) != index) {
            let (name, text) = inflated(i)?;
            if name == root || name.ends_with(".model") {
                let model = model_of(&name, &String::from_utf8_lossy(&text));
                models.insert(name, model);
            }
        }
        Ok(Package { root, models })
    }

    fn root(&self) -> Result<&Model, String> {
        match self.models.get(&self.root) {
            Some(model) => model.as_ref().map_err(String::clone),
            None => Err(damaged(&format!("no root model `{}`", self.root))),
        }
    }

    /// Objects by part and number.
    fn objects(&self) -> HashMap<(&str, u32), &Object> {
        let mut objects = HashMap::new();
        for (part, model) in &self.models {
            let own = model.iter().flat_map(|model| &model.resources.object);
            objects.extend(own.map(|object| ((part.as_str(), object.id), object)));
        }
        objects
    }

    /// Why an object that is placed was not found.
    fn missing(&self, part: &str, id: u32) -> String {
        match self.models.get(part) {
            Some(Err(reason)) => reason.clone(),
            _ => format!("object {id} is placed but not there"),
        }
    }
}

/// What says which part is the root model.
const ROOT_RELATIONSHIPS: &str = "_rels/.rels";

/// The end of the type of its relationship.
const ROOT_TYPE: &str = "/3dmodel";

fn damaged(e: &dyn std::fmt::Display) -> String {
    format!("damaged 3MF: {e}")
}

/// A part's name within the archive; paths are absolute.
fn inside(path: &str) -> &str {
    path.trim_start_matches('/')
}

/// The relationships of a package.
#[derive(FromXml)]
#[xml(ns("http://schemas.openxmlformats.org/package/2006/relationships"))]
struct Relationships {
    all: Vec<Relationship>,
}

#[derive(FromXml)]
#[xml(ns("http://schemas.openxmlformats.org/package/2006/relationships"))]
struct Relationship {
    #[xml(attribute, rename = "Type")]
    kind: String,
    #[xml(attribute, rename = "Target")]
    target: String,
}

/// The root model, of the relationships of the package.
fn root_of(text: &str) -> Result<String, String> {
    let read: Relationships = instant_xml::from_str(text)
        .map_err(|e| damaged(&format!("{e} in `{ROOT_RELATIONSHIPS}`")))?;
    let root = read.all.iter().find(|one| one.kind.ends_with(ROOT_TYPE));
    let root = root.map(|one| inside(&one.target).to_owned());
    root.ok_or_else(|| damaged(&format!("no model is named in `{ROOT_RELATIONSHIPS}`")))
}

/// Reads a model. The reader skips elements that it does not understand: no vertex and no triangle may be missing.
fn model_of(part: &str, text: &str) -> Result<Model, String> {
    let counted = examine_model(text).map_err(|found| format!("{found} in `{part}`"))?;
    let model: Model =
        instant_xml::from_str(text).map_err(|e| damaged(&format!("{e} in `{part}`")))?;
    let read = count(&model);
    if read != counted {
        return Err(format!(
            "of `{part}` only {} vertices and {} triangles can be read",
            read.vertices, read.triangles
        ));
    }
    Ok(model)
}

/// Counts vertices and triangles and refuses coordinates and indices that are no numbers.
fn examine_model(text: &str) -> Result<Counted, String> {
    let mut counted = Counted::default();
    for tag in text.split('<').skip(1) {
        let end = tag
            .find(|c: char| c.is_ascii_whitespace() || c == '/' || c == '>')
            .unwrap_or(tag.len());
        let (name, attributes) = tag.split_at(end);
        match name.rsplit(':').next() {
            Some("vertex") => {
                counted.vertices += 1;
                for axis in ["x", "y", "z"] {
                    let value = attribute(attributes, axis).unwrap_or("missing");
                    if !value.parse::<f64>().is_ok_and(f64::is_finite) {
                        return Err(format!(
                            "vertex {} has {axis} = `{value}`",
                            counted.vertices
                        ));
                    }
                }
            }
            Some("triangle") => {
                counted.triangles += 1;
                for corner in ["v1", "v2", "v3"] {
                    let value = attribute(attributes, corner).unwrap_or("missing");
                    if value.parse::<u32>().is_err() {
                        return Err(format!(
                            "triangle {} has {corner} = `{value}`",
                            counted.triangles
                        ));
                    }
                }
            }
            _ => {}
        }
    }
    Ok(counted)
}

/// The value of an attribute in the inside of a tag.
fn attribute<'a>(attributes: &'a str, name: &str) -> Option<&'a str> {
    let mut rest = attributes;
    loop {
        let (key, after) = rest.split_once('=')?;
        let after = after.trim_start();
        let quote = after.chars().next().filter(|c| matches!(c, '"' | '\''))?;
        let (value, next) = after[1..].split_once(quote)?;
        if key.trim() == name {
            return Some(value);
        }
        rest = next;
    }
}

fn count(model: &Model) -> Counted {
    let mut counted = Counted::default();
    for mesh in model.resources.object.iter().filter_map(Object::get_mesh) {
        counted.vertices += mesh.vertices.vertex.len();
        counted.triangles += mesh.triangles.triangle.len();
    }
    counted
}

fn millimeters(unit: Option<&Unit>) -> f64 {
    match unit {
        None | Some(Unit::Millimeter) => 1.0,
        Some(Unit::Micron) => 1e-3,
        Some(Unit::Centimeter) => 10.0,
        Some(Unit::Inch) => 25.4,
        Some(Unit::Foot) => 304.8,
        Some(Unit::Meter) => 1000.0,
    }
}

/// A transform as 3MF writes it: a row vector (x, y, z, 1) times four rows of three numbers.
#[derive(Clone, Copy)]
struct Place([[f64; 3]; 4]);

impl Place {
    fn of(transform: Option<&Transform>) -> Self {
        transform.map_or(Place::scaled(1.0), |t| {
            Place(std::array::from_fn(|row| {
                std::array::from_fn(|column| t.0[3 * row + column])
            }))
        })
    }

    fn scaled(s: f64) -> Self {
        Place([[s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s], [0.0; 3]])
    }

    /// First this, then `next`.
    fn then(&self, next: &Place) -> Place {
        let mut rows = self
            .0
            .map(|row| std::array::from_fn(|c| (0..3).map(|k| row[k] * next.0[k][c]).sum::<f64>()));
        for (value, shift) in rows[3].iter_mut().zip(next.0[3]) {
            *value += shift;
        }
        Place(rows)
    }

    fn apply(&self, p: [f64; 3]) -> [f64; 3] {
        let [a, b, c, shift] = self.0;
        std::array::from_fn(|i| p[0] * a[i] + p[1] * b[i] + p[2] * c[i] + shift[i])
    }

    /// Whether it turns a surface inside out.
    fn mirrors(&self) -> bool {
        let [a, b, c, _] = self.0;
        dot(a, cross(b, c)) < 0.0
    }
}

struct ComponentTraversal<'a, 'b> {
    objects: HashMap<(&'a str, u32), &'a Object>,
    package: &'a Package,
    path: &'b Path,
    placed: usize,
    sink: Sink<'b>,
}

impl<'a> ComponentTraversal<'a, '_> {
    fn object(&mut self, part: &str, id: u32, place: &Place, depth: usize) -> Result<()> {
        self.placed += 1;
        if depth > DEEPEST || self.placed > MOST_PLACED {
            return Err(bad(
                self.path,
                format!(
                    "components nested deeper than {DEEPEST}, or more than {MOST_PLACED} of them"
                ),
                WANTED,
            ));
        }
        let Some(&object) = self.objects.get(&(part, id)) else {
            return Err(bad(self.path, self.package.missing(part, id), WANTED));
        };
        if !matches!(
            object.objecttype,
            None | Some(ObjectType::Model | ObjectType::Surface)
        ) {
            return Ok(());
        }
        match &object.kind {
            Some(ObjectKind::Mesh(mesh)) => self.mesh(mesh, id, place),
            Some(ObjectKind::Components(components)) => {
                for component in &components.component {
                    let inner = Place::of(component.transform.as_ref()).then(place);
                    let part = component.path.as_ref().map_or(part, |p| inside(p.as_str()));
                    self.object(part, component.objectid, &inner, depth + 1)?;
                }
                Ok(())
            }
            _ => Err(bad(
                self.path,
                format!("object {id} is neither a mesh nor made of components"),
                WANTED,
            )),
        }
    }

    fn mesh(
        &mut self,
        mesh: &'a threemf2::model::domain::mesh::Mesh,
        id: u32,
        place: &Place,
    ) -> Result<()> {
        let points = &mesh.vertices.vertex;
        // A mesh placed many times must not grow without bounds either
        self.placed += mesh.triangles.triangle.len() / 100;
        for triangle in &mesh.triangles.triangle {
            let mut corners = [[0.0; 3]; 3];
            for (corner, index) in corners
                .iter_mut()
                .zip([triangle.v1, triangle.v2, triangle.v3])
            {
                let Some(point) = points.get(index as usize) else {
                    return Err(bad(
                        self.path,
                        format!(
                            "a triangle of object {id} refers to vertex {index}, but there are {}",
                            points.len()
                        ),
                        "indices from 0 to the number of vertices − 1",
                    ));
                };
                *corner = place.apply([point.x.value(), point.y.value(), point.z.value()]);
            }
            if place.mirrors() {
                corners.swap(1, 2);
            }
            (self.sink)(corners)?;
        }
        Ok(())
    }
}
