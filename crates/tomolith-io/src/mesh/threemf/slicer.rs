//! What slicers write of the volumes of an object: which are the part, which are taken out of it, and which only change
//! settings.
//!
//! PrusaSlicer numbers the triangles of an object's mesh in `Metadata/Slic3r_PE_model.config`; Bambu Studio and OrcaSlicer
//! name the components of an object in `Metadata/model_settings.config`.

use super::package::Package;
use super::xml::{Tag, Xml};
use std::collections::HashMap;
use std::ops::RangeInclusive;

const PRUSA: &str = "metadata/slic3r_pe_model.config";
const BAMBU: &str = "metadata/model_settings.config";

/// What a volume is there for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Role {
    #[default]
    Part,
    /// Taken out of the part.
    Negative,
    /// Settings, supports: nothing is there.
    Nothing,
}

impl Role {
    fn named(name: &str) -> Self {
        match name {
            "NegativeVolume" | "negative_part" => Role::Negative,
            "ParameterModifier" | "SupportEnforcer" | "SupportBlocker" | "modifier_part"
            | "support_enforcer" | "support_blocker" => Role::Nothing,
            _ => Role::Part,
        }
    }
}

/// The roles of volumes, by object of the root model.
#[derive(Default)]
pub(super) struct Volumes {
    triangles: HashMap<u32, Vec<(RangeInclusive<usize>, Role)>>,
    components: HashMap<(u32, u32), Role>,
}

impl Volumes {
    pub(super) fn read(package: &Package) -> Result<Self, String> {
        let mut volumes = Volumes::default();
        for (part, child) in [(PRUSA, "volume"), (BAMBU, "part")] {
            if let Some(text) = package.texts.get(part) {
                volumes
                    .take(text, child)
                    .map_err(|found| format!("{found} in `{part}`"))?;
            }
        }
        Ok(volumes)
    }

    fn take(&mut self, text: &str, child: &str) -> Result<(), String> {
        let mut xml = Xml::new(text);
        xml.root("config")?;
        xml.children(&mut |xml, tag| {
            if tag.name() != "object" {
                return Ok(());
            }
            let object = tag.needed("id").map_err(|found| xml.at(&found))?;
            xml.children(&mut |xml, tag| match tag.name() {
                "volume" if child == "volume" => self.volume(object, xml, tag),
                "part" if child == "part" => {
                    let role = tag
                        .get("subtype")?
                        .map_or(Role::Part, |name| Role::named(&name));
                    self.components.insert((object, tag.needed("id")?), role);
                    Ok(())
                }
                _ => Ok(()),
            })
        })
    }

    fn volume<'a>(&mut self, object: u32, xml: &mut Xml<'a>, tag: &Tag<'a>) -> Result<(), String> {
        let range = tag.needed("firstid")?..=tag.needed("lastid")?;
        let mut role = Role::Part;
        xml.children(&mut |_, tag| {
            let (key, value) = (tag.get("key")?, tag.get("value")?.unwrap_or_default());
            match key.as_deref() {
                Some("volume_type") => role = Role::named(&value),
                // What older files say instead
                Some("modifier") if &*value == "1" => role = Role::Nothing,
                _ => {}
            }
            Ok(())
        })?;
        self.triangles
            .entry(object)
            .or_default()
            .push((range, role));
        Ok(())
    }

    /// The role of a triangle of an object's own mesh.
    pub(super) fn of_triangle(&self, object: u32, triangle: usize) -> Role {
        let ranges = self.triangles.get(&object).map_or(&[][..], |all| all);
        let found = ranges.iter().find(|(range, _)| range.contains(&triangle));
        found.map_or(Role::Part, |(_, role)| *role)
    }

    pub(super) fn of_component(&self, object: u32, component: u32) -> Role {
        let found = self.components.get(&(object, component));
        found.copied().unwrap_or_default()
    }
}
