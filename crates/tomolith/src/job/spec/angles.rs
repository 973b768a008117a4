//! `light.angles`: from where the light of each frame comes.

use crate::error::Result;
use crate::exposure::Rotation;
use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

/// Most frames of a light.
pub(super) const MOST_FRAMES: usize = 100_000;

/// The angles of a light.
#[derive(Clone, Debug, PartialEq)]
pub enum Angles {
    /// `count` frames, evenly over `arc_deg` from `start_deg`; the arc's end is not repeated.
    Even {
        /// Number of frames.
        count: usize,
        /// First azimuth.
        start_deg: f64,
        /// The arc, 360 for the full turn.
        arc_deg: f64,
    },
    /// These azimuths.
    List(Vec<f64>),
}

/// The table form of [`Angles`].
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct AnglesTable {
    /// Number of frames.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = MOST_FRAMES))]
    count: Option<usize>,
    /// First azimuth.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = -360.0, max = 360.0))]
    start_deg: Option<f64>,
    /// The arc over which they are spread; the full turn when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 360.0))]
    arc_deg: Option<f64>,
    /// These azimuths, in place of the others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(inner(range(min = -3600.0, max = 3600.0)))]
    list_deg: Option<Vec<f64>>,
}

impl<'de> Deserialize<'de> for Angles {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct AnglesVisitor;
        impl<'de> Visitor<'de> for AnglesVisitor {
            type Value = Angles;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a count of frames, {count, start_deg, arc_deg} or {list_deg}")
            }
            fn visit_u64<E: serde::de::Error>(self, count: u64) -> Result<Angles, E> {
                let count = usize::try_from(count).unwrap_or(usize::MAX);
                Ok(Angles::Even {
                    count,
                    start_deg: 0.0,
                    arc_deg: 360.0,
                })
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Angles, A::Error> {
                let table = AnglesTable::deserialize(MapAccessDeserializer::new(map))?;
                match (table.count, table.list_deg) {
                    (Some(count), None) => Ok(Angles::Even {
                        count,
                        start_deg: table.start_deg.unwrap_or(0.0),
                        arc_deg: table.arc_deg.unwrap_or(360.0),
                    }),
                    (None, Some(list)) if table.start_deg.is_none() && table.arc_deg.is_none() => {
                        Ok(Angles::List(list))
                    }
                    (None, None) => Err(serde::de::Error::custom(
                        "neither count nor list_deg, expected one of them",
                    )),
                    _ => Err(serde::de::Error::custom(
                        "list_deg together with other keys, expected list_deg alone",
                    )),
                }
            }
        }
        deserializer.deserialize_any(AnglesVisitor)
    }
}

impl Serialize for Angles {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let table = match self.clone() {
            Angles::Even {
                count,
                start_deg,
                arc_deg,
            } => AnglesTable {
                count: Some(count),
                start_deg: Some(start_deg),
                arc_deg: Some(arc_deg),
                list_deg: None,
            },
            Angles::List(list) => AnglesTable {
                count: None,
                start_deg: None,
                arc_deg: None,
                list_deg: Some(list),
            },
        };
        table.serialize(serializer)
    }
}

impl JsonSchema for Angles {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Angles".into()
    }
    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let table = generator.subschema_for::<AnglesTable>();
        schemars::json_schema!({
            "description": "A count of frames (full turn), {count, start_deg, arc_deg} or {list_deg}",
            "anyOf": [{ "type": "integer", "minimum": 1, "maximum": MOST_FRAMES }, table]
        })
    }
}

impl Angles {
    /// The same angles turn after turn, each turn with frames of its own. An arc that is no whole turn cannot be shown so.
    pub(crate) fn turn_after_turn(&self, turns: usize) -> Option<Angles> {
        match self {
            Angles::Even {
                count,
                start_deg,
                arc_deg,
            } => (*arc_deg == 360.0 && *count > 1).then_some(Angles::Even {
                count: count * turns,
                start_deg: *start_deg,
                arc_deg: arc_deg * turns as f64,
            }),
            Angles::List(list) => Some(Angles::List(list.repeat(turns))),
        }
    }

    /// The share of a turn that all frames cover; 1 for a list.
    pub(crate) fn turned(&self) -> f64 {
        match self {
            Angles::Even { arc_deg, .. } => arc_deg / 360.0,
            Angles::List(_) => 1.0,
        }
    }

    /// Number of frames.
    #[must_use]
    pub fn count(&self) -> usize {
        match self {
            Angles::Even { count, .. } => *count,
            Angles::List(list) => list.len(),
        }
    }

    /// Azimuth from which each frame's light arrives (rad), and the arc of one frame (rad; 0 for a list, and for one frame on a whole
    /// turn: it comes from one direction, so the vial stands while it is shown. One pattern on a turning vial is the same frame at
    /// many angles).
    ///
    /// ```
    /// use tomolith::job::{Angles, Rotation};
    /// let angles = Angles::Even { count: 4, start_deg: 0.0, arc_deg: 360.0 };
    /// let (azimuths, arc) = angles.azimuths(Rotation::Clockwise);
    /// assert!((azimuths[1] - std::f64::consts::FRAC_PI_2).abs() < 1e-12); // a quarter turn further
    /// assert!((arc - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    /// // One frame, for which the vial stands
    /// let one = Angles::Even { count: 1, start_deg: 0.0, arc_deg: 360.0 };
    /// assert_eq!(one.azimuths(Rotation::Clockwise), (vec![0.0], 0.0));
    /// let (azimuths, _) = angles.azimuths(Rotation::Counterclockwise);
    /// assert!((azimuths[1] + std::f64::consts::FRAC_PI_2).abs() < 1e-12); // the other way round
    /// ```
    #[must_use]
    pub fn azimuths(&self, rotation: Rotation) -> (Vec<f64>, f64) {
        match self {
            Angles::Even {
                count,
                start_deg,
                arc_deg,
            } => {
                let sense = match rotation {
                    Rotation::Clockwise => 1.0,
                    Rotation::Counterclockwise => -1.0,
                };
                let (start, arc) = (start_deg.to_radians(), arc_deg.to_radians());
                let azimuths = (0..*count)
                    .map(|k| start + sense * arc * k as f64 / *count as f64)
                    .collect();
                if *count == 1 && *arc_deg == 360.0 {
                    return (azimuths, 0.0);
                }
                (azimuths, arc / (*count).max(1) as f64)
            }
            Angles::List(list) => (list.iter().map(|a| a.to_radians()).collect(), 0.0),
        }
    }
}
