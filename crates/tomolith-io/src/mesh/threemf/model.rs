//! A model part: objects, and the build that places them.

use super::package::part_key;
use super::place::Place;
use super::xml::{Tag, Xml};
use std::collections::HashMap;

/// Extensions that may be required: they are read, or do not change what is where.
const EXTENSIONS: [&str; 9] = [
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.3mf.io/3dmanufacturing/production/alternatives/2021/04",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
    "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02",
    "http://schemas.microsoft.com/3dmanufacturing/beamlattice/balls/2020/07",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
    "http://schemas.3mf.io/3dmanufacturing/volumetric/2022/01",
];

/// What is read of a model.
#[derive(Default)]
pub(super) struct Model {
    /// Of its unit, in mm.
    pub(super) length_mm: f64,
    pub(super) objects: HashMap<u32, Object>,
    pub(super) items: Vec<Placed>,
}

#[derive(Default)]
pub(super) struct Object {
    /// Support, or something else that is no part.
    pub(super) is_aside: bool,
    pub(super) content: Content,
}

#[derive(Default)]
pub(super) enum Content {
    Mesh(Triangles),
    Components(Vec<Placed>),
    /// What it is instead.
    Other(String),
    #[default]
    Nothing,
}

#[derive(Default)]
pub(super) struct Triangles {
    pub(super) points: Vec<[f64; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// An object that is placed.
pub(super) struct Placed {
    /// Key of the part that holds it, if it is another one.
    pub(super) part: Option<String>,
    pub(super) object: u32,
    pub(super) place: Place,
    pub(super) is_printable: bool,
}

impl Model {
    pub(super) fn read(text: &str) -> Result<Self, String> {
        let mut xml = Xml::new(text);
        let root = xml.root("model")?;
        refuse_unknown(&root)?;
        let mut model = Model {
            length_mm: millimeters(root.get("unit")?.as_deref())?,
            ..Model::default()
        };
        xml.children(&mut |xml, tag| match tag.name() {
            "resources" => xml.children(&mut |xml, tag| {
                if tag.name() == "object" {
                    let id = tag.needed("id").map_err(|found| xml.at(&found))?;
                    model.objects.insert(id, Object::read(xml, tag)?);
                }
                Ok(())
            }),
            "build" => xml.children(&mut |xml, tag| {
                if tag.name() == "item" {
                    model
                        .items
                        .push(Placed::read(tag).map_err(|found| xml.at(&found))?);
                }
                Ok(())
            }),
            _ => Ok(()),
        })?;
        Ok(model)
    }
}

/// Refuses extensions that are required and not known: what they mean for the geometry is not known either.
fn refuse_unknown(root: &Tag<'_>) -> Result<(), String> {
    let attributes = root.all()?;
    let value = |name: &str| attributes.iter().find(|(key, _)| key == name);
    let required = value("requiredextensions").map_or("", |(_, list)| list);
    for prefix in required.split_whitespace() {
        let namespace = value(&format!("xmlns:{prefix}")).map_or("", |(_, namespace)| namespace);
        if !EXTENSIONS.contains(&namespace) {
            return Err(format!(
                "it requires the extension `{prefix}` ({namespace})"
            ));
        }
    }
    Ok(())
}

fn millimeters(unit: Option<&str>) -> Result<f64, String> {
    Ok(match unit.map(str::trim) {
        None | Some("millimeter") => 1.0,
        Some("micron") => 1e-3,
        Some("centimeter") => 10.0,
        Some("inch") => 25.4,
        Some("foot") => 304.8,
        Some("meter") => 1000.0,
        Some(other) => {
            return Err(format!(
                "unit = `{other}`, which is none of micron, millimeter, centimeter, inch, foot, meter"
            ));
        }
    })
}

impl Object {
    fn read(xml: &mut Xml<'_>, tag: &Tag<'_>) -> Result<Self, String> {
        let kind = tag.get("type")?;
        let mut object = Object {
            is_aside: !matches!(kind.as_deref(), None | Some("model" | "surface")),
            ..Object::default()
        };
        // Slices repeat the mesh, unless it is only a rough one
        let is_rough = tag.get("meshresolution")?.as_deref() == Some("lowres");
        let is_sliced = tag.get("slicestackid")?.is_some();
        xml.children(&mut |xml, tag| {
            match (tag.name(), &object.content) {
                ("mesh", _) => object.content = Content::mesh(xml)?,
                ("components", _) => object.content = Content::components(xml)?,
                ("metadatagroup" | "alternatives", _) => {}
                // A boolean shape, a level set, a displaced mesh
                (other, Content::Nothing) => {
                    object.content = Content::Other(format!("a `{other}`"))
                }
                _ => {}
            }
            Ok(())
        })?;
        let is_empty = match &object.content {
            Content::Mesh(mesh) => mesh.triangles.is_empty(),
            Content::Nothing => true,
            _ => false,
        };
        if is_sliced && (is_rough || is_empty) {
            object.content = Content::Other("given by slices (a slice stack)".to_owned());
        }
        Ok(object)
    }
}

impl Content {
    fn mesh(xml: &mut Xml<'_>) -> Result<Self, String> {
        let mut mesh = Triangles::default();
        let mut other = None;
        xml.children(&mut |xml, tag| match tag.name() {
            "vertices" => xml.children(&mut |xml, tag| mesh.vertex(xml, tag)),
            "triangles" => xml.children(&mut |xml, tag| mesh.triangle(xml, tag)),
            "beamlattice" => {
                other = Some(Content::Other("a mesh with a beam lattice".to_owned()));
                Ok(())
            }
            _ => Ok(()),
        })?;
        Ok(other.unwrap_or(Content::Mesh(mesh)))
    }

    fn components(xml: &mut Xml<'_>) -> Result<Self, String> {
        let mut all = Vec::new();
        xml.children(&mut |xml, tag| {
            if tag.name() == "component" {
                all.push(Placed::read(tag).map_err(|found| xml.at(&found))?);
            }
            Ok(())
        })?;
        Ok(Content::Components(all))
    }
}

impl Triangles {
    fn vertex(&mut self, xml: &Xml<'_>, tag: &Tag<'_>) -> Result<(), String> {
        if tag.name() == "vertex" {
            let refuse = |found| xml.at(&format!("vertex {} has {found}", self.points.len() + 1));
            let [x, y, z] = ["x", "y", "z"].map(|axis| tag.needed(axis).map_err(refuse));
            self.points.push([x?, y?, z?]);
        }
        Ok(())
    }

    fn triangle(&mut self, xml: &Xml<'_>, tag: &Tag<'_>) -> Result<(), String> {
        if tag.name() == "triangle" {
            let count = self.triangles.len() + 1;
            let refuse = |found| xml.at(&format!("triangle {count} has {found}"));
            let [a, b, c] = ["v1", "v2", "v3"].map(|corner| tag.needed(corner).map_err(refuse));
            self.triangles.push([a?, b?, c?]);
        }
        Ok(())
    }
}

impl Placed {
    fn read(tag: &Tag<'_>) -> Result<Self, String> {
        Ok(Placed {
            part: tag.get("path")?.map(|path| part_key(&path)),
            object: tag.needed("objectid")?,
            place: match tag.get("transform")? {
                Some(text) => Place::read(&text).ok_or_else(|| format!("transform = `{text}`"))?,
                None => Place::scaled(1.0),
            },
            is_printable: tag.truth("printable")?.unwrap_or(true),
        })
    }
}
