//! 3MF: a zip archive with the model in XML; what is printed is the *build*, items that place objects.
//!
//! Objects are meshes, or components: other objects with a transform each. Lengths are in the root model's unit and come
//! out in mm. Objects meant as support or for other purposes, and items that are not printable, are skipped. What slicers
//! take out of a part goes to [`MeshFile::negative`](super::MeshFile). Geometry that is no mesh is refused by its name.

mod model;
mod package;
mod place;
mod slicer;
mod xml;

use super::Collector;
use model::{Content, Model, Placed, Triangles};
use package::{Package, damaged};
use place::Place;
use slicer::{Role, Volumes};
use std::collections::HashMap;
use tomolith_core::error::Result;
use tomolith_core::units::counted;

const WANTED: &str = "a 3MF package with a build of mesh objects";

/// Depth of components in components.
const DEEPEST: usize = 32;

/// Placed objects and components: stops packages whose components refer to each other many times over.
const MOST_PLACED: usize = 1 << 20;

pub(super) fn parse(bytes: &[u8], out: &mut Collector) -> Result<()> {
    let refuse = |found: String| out.refusal(found, WANTED);
    let package = Package::read(bytes).map_err(refuse)?;
    let volumes = Volumes::read(&package).map_err(refuse)?;
    let mut models = HashMap::new();
    for (key, text) in &package.texts {
        if key.ends_with(".model") || *key == package.root {
            let model = Model::read(text);
            models.insert(
                key.as_str(),
                model.map_err(|e| damaged(&format!("{e} in `{key}`"))),
            );
        }
    }
    let root = match models.get(&*package.root) {
        Some(Ok(model)) => model,
        Some(Err(found)) => return Err(refuse(found.clone())),
        None => {
            return Err(refuse(damaged(&format!(
                "no root model `{}`",
                package.root
            ))));
        }
    };
    let mut build = Build {
        root: &package.root,
        models: &models,
        volumes: &volumes,
        placed: 0,
        negative: 0,
        nothing: 0,
        out,
    };
    let unit = Place::scaled(root.length_mm);
    let (printed, skipped): (Vec<_>, Vec<_>) = root.items.iter().partition(|i| i.is_printable);
    for item in &printed {
        let part = item.part.as_deref().unwrap_or(&package.root);
        build.object(part, item, &unit, Role::Part, 0)?;
    }
    build.say(printed.len(), skipped.len())
}

/// The objects of the build, placed one after the other.
struct Build<'a, 'b, 'c> {
    root: &'a str,
    /// By the keys of their parts; those that cannot be read matter only where something of them is placed.
    models: &'a HashMap<&'a str, Result<Model, String>>,
    volumes: &'a Volumes,
    placed: usize,
    /// Triangles of negative volumes, and of those where nothing is.
    negative: usize,
    nothing: usize,
    out: &'b mut Collector<'c>,
}

impl Build<'_, '_, '_> {
    /// Places an object of a part; `around` is where what holds it stands.
    fn object(
        &mut self,
        part: &str,
        placed: &Placed,
        around: &Place,
        role: Role,
        depth: usize,
    ) -> Result<()> {
        self.placed += 1;
        if depth > DEEPEST || self.placed > MOST_PLACED {
            let found = format!(
                "components nested deeper than {DEEPEST}, or more than {MOST_PLACED} of them"
            );
            return Err(self.out.refusal(found, WANTED));
        }
        let id = placed.object;
        let model = match self.models.get(part) {
            Some(Err(reason)) => return Err(self.out.refusal(reason, WANTED)),
            Some(Ok(model)) => Some(model),
            None => None,
        };
        let Some(object) = model.and_then(|model| model.objects.get(&id)) else {
            let found = format!("object {id} is placed but not there");
            return Err(self.out.refusal(found, WANTED));
        };
        if object.is_aside {
            return Ok(());
        }
        let place = placed.place.then(around);
        match &object.content {
            Content::Mesh(mesh) => self.mesh(mesh, part, id, &place, role),
            Content::Components(components) => {
                for component in components {
                    let inner = component.part.as_deref().unwrap_or(part);
                    let role = match self.volumes.of_component(id, component.object) {
                        Role::Part => role,
                        other if part == self.root => other,
                        _ => role,
                    };
                    self.object(inner, component, &place, role, depth + 1)?;
                }
                Ok(())
            }
            Content::Other(what) => {
                let found = format!("object {id} is {what}, which is not read");
                Err(self.out.refusal(found, WANTED))
            }
            Content::Nothing => {
                let found = format!("object {id} is neither a mesh nor made of components");
                Err(self.out.refusal(found, WANTED))
            }
        }
    }

    fn mesh(
        &mut self,
        mesh: &Triangles,
        part: &str,
        id: u32,
        place: &Place,
        role: Role,
    ) -> Result<()> {
        // A mesh placed many times must not grow without bounds either
        self.placed += mesh.triangles.len() / 100;
        for (t, triangle) in mesh.triangles.iter().enumerate() {
            let mut corners = [[0.0; 3]; 3];
            for (corner, &index) in corners.iter_mut().zip(triangle) {
                let Some(point) = mesh.points.get(index as usize) else {
                    let found = format!(
                        "a triangle of object {id} refers to vertex {index}, but there are {}",
                        mesh.points.len()
                    );
                    let accepted = "indices from 0 to the number of vertices − 1";
                    return Err(self.out.refusal(found, accepted));
                };
                *corner = place.apply(*point);
            }
            if place.mirrors() {
                corners.swap(1, 2);
            }
            let role = match role {
                Role::Part if part == self.root => self.volumes.of_triangle(id, t),
                role => role,
            };
            match role {
                Role::Part => self.out.triangle(corners)?,
                Role::Negative => {
                    self.negative += 1;
                    self.out.negative(corners)?;
                }
                Role::Nothing => self.nothing += 1,
            }
        }
        Ok(())
    }

    /// Says what the build leaves out, or why nothing is left.
    fn say(self, printed: usize, skipped: usize) -> Result<()> {
        if self.out.read == 0 {
            let found = match (printed, skipped) {
                (0, 0) => "its build places nothing".to_owned(),
                (0, _) => format!("none of the {skipped} items of its build is printable"),
                _ => "the objects of its build have no triangle".to_owned(),
            };
            return Err(self.out.refusal(found, WANTED));
        }
        if skipped > 0 {
            let items = counted(skipped, "item");
            self.out.note(format!(
                "Left out: {items} of the build, which the file marks as not printable."
            ));
        }
        if self.negative > 0 {
            self.out.note(
                "Negative volumes are taken out of the part, as the slicer's settings in the file say.".to_owned(),
            );
        }
        if self.nothing > 0 {
            self.out.note(
                "Modifiers and supports are left out, as the slicer's settings in the file say."
                    .to_owned(),
            );
        }
        Ok(())
    }
}
