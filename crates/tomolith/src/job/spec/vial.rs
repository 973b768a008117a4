//! `[vial]`, `[bath]`, `[motion]` and `[[obstacles]]`: what stands in the way of the light, and how it turns.

use crate::error::Result;
use crate::optics::obstacle::BodyMaterial;
use crate::optics::vial::ended::End;
use crate::units::Mm;
use schemars::JsonSchema;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};
use std::path::PathBuf;

/// What surrounds the vial and absorbs, up to a round wall.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BathSpec {
    /// Napierian absorption, 1/mm.
    #[schemars(range(min = 0.0, max = 100.0))]
    pub absorption_per_mm: f64,
    /// Its outer radius, about the axis; larger than the vial's.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub radius_mm: Mm,
}

/// The vial: one kind, `[vial.KIND]`, and what is said of every kind.
#[derive(Clone, Debug, PartialEq)]
pub struct VialSpec {
    /// Keys of every kind.
    pub common: VialCommon,
    /// The kind and its parameters, `{cylinder: {…}}`.
    pub kind: Value,
}

tomolith_core::keys! {
    /// Keys of `[vial]` besides its kind.
    #[derive(PartialEq)]
    pub struct VialCommon {
        /// Refractive index of what surrounds the vial: 1 for air, the bath's for a bath.
        #[schemars(range(min = 1.0, max = 4.0))]
        pub surrounding_index: f64 = 1.0,
        /// The lower end of the resin; without it the resin has no end.
        pub bottom: Option<End>,
        /// The upper end of the resin.
        pub top: Option<End>,
    }
}

/// How the vial moves: it turns about its own axis, normal to the light, unless something else is said here.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MotionSpec {
    /// Light comes from above by this angle: −80 to 80.
    pub tilt_deg: f64,
    /// Axis of the vial [x, y], seen from the rotation axis, in the frame that turns with it.
    pub offset_mm: [f64; 2],
    /// Largest run-out of the rotation axis along the columns.
    pub axis_runout_mm: f64,
    /// Azimuth of the light at which the run-out is largest.
    pub axis_runout_deg: f64,
}

/// A body in the light: a closed mesh in the frame of the vial, mm.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObstacleSpec {
    /// Mesh file, relative to the job.
    pub mesh: PathBuf,
    /// What it does to light: "black", "mirror", { metal = { refractive_index = 1.5, extinction_coefficient = 2.8 } }, { dielectric = { refractive_index = 1.5 } }, or
    /// { diffuse = { reflectance = 0.5 } }.
    #[serde(default)]
    pub material: BodyMaterial,
    /// Millimeters per unit of the file.
    #[serde(default = "unity")]
    pub scale: f64,
    /// Position of the file's origin [x, y, z].
    #[serde(default)]
    pub offset_mm: [f64; 3],
}

fn unity() -> f64 {
    1.0
}

impl<'de> Deserialize<'de> for VialSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct VialVisitor;
        impl<'de> Visitor<'de> for VialVisitor {
            type Value = VialSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a table [vial.KIND]; `tomolith kinds vial` lists the kinds")
            }
            fn visit_str<E: serde::de::Error>(self, name: &str) -> Result<VialSpec, E> {
                Ok(VialSpec {
                    common: VialCommon::default(),
                    kind: Value::String(name.to_owned()),
                })
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<VialSpec, A::Error> {
                let (mut common, mut kind) = (VialCommon::default(), Map::new());
                while let Some(key) = map.next_key::<String>()? {
                    match key.as_str() {
                        "surrounding_index" => common.surrounding_index = map.next_value()?,
                        "bottom" => common.bottom = map.next_value()?,
                        "top" => common.top = map.next_value()?,
                        _ => drop(kind.insert(key, map.next_value()?)),
                    }
                }
                Ok(VialSpec {
                    common,
                    kind: Value::Object(kind),
                })
            }
        }
        deserializer.deserialize_any(VialVisitor)
    }
}

impl Serialize for VialSpec {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let common = serde_json::to_value(&self.common).map_err(serde::ser::Error::custom)?;
        let mut map = common.as_object().cloned().unwrap_or_default();
        match &self.kind {
            Value::Object(kind) => map.extend(kind.clone()),
            Value::String(name) => drop(map.insert(name.clone(), Value::Object(Map::new()))),
            _ => {}
        }
        map.serialize(serializer)
    }
}

impl JsonSchema for VialSpec {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "VialSpec".into()
    }
    /// Keys of every kind; those of the kinds come from the table of vials, see `super::schema`.
    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let mut common = VialCommon::json_schema(generator);
        common.remove("additionalProperties");
        common
    }
}
