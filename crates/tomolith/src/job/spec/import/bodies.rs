//! `vial.occlusions` as `[[obstacles]]`.
//!
//! With `transmission_only` light there ends at every body that lets none through, whatever its surface; else metals reflect by Fresnel's
//! formulas. Roughness has no place here: rough surfaces become smooth ones, with a note.

use super::keys::Keys;
use crate::error::{Error, Result};
use crate::job::spec::import::Ours;
use serde_json::{Value, json};

/// Adds the bodies; whether one of them sends light back in all directions.
pub(crate) fn occlusions(list: Option<Value>, reflections: bool, ours: &mut Ours) -> Result<bool> {
    let list = match list {
        None => return Ok(false),
        Some(Value::Array(list)) => list,
        Some(other) => {
            return Err(Error::config(
                "vial.occlusions",
                format!("found {other}"),
                "a list",
            ));
        }
    };
    let mut diffuse = false;
    for (i, value) in list.into_iter().enumerate() {
        let mut keys = Keys::new(&format!("vial.occlusions[{i}]"), value)?;
        let file = (ours.files.path)(&keys.need_text("filename")?);
        keys.take("face_normals");
        let material = match keys.table("bsdf")? {
            None => Some(json!("black")),
            Some(bsdf) => material_of(bsdf, reflections, &mut ours.notes)?,
        };
        keys.finish(&mut ours.notes);
        if let Some(material) = material {
            diffuse |= material.get("diffuse").is_some();
            ours.add(
                "[[obstacles]]",
                json!({ "mesh": file, "material": material }),
            );
        }
    }
    Ok(diffuse)
}

/// What a body does to light; None: nothing.
fn material_of(
    mut keys: Keys,
    reflections: bool,
    notes: &mut Vec<String>,
) -> Result<Option<Value>> {
    let kind = keys.need_text("type")?;
    let material = match kind.as_str() {
        "null" => None,
        "twosided" | "bumpmap" | "normalmap" => {
            let nested = keys.table("bsdf")?;
            return material_of(keys.needed("bsdf", nested)?, reflections, notes);
        }
        "dielectric" | "roughdielectric" => {
            keys.take("ext_ior");
            let index = keys.number_or("int_ior", 1.5046)?;
            Some(json!({ "dielectric": { "refractive_index": index } }))
        }
        "diffuse" => Some(match reflectance(&mut keys)? {
            0.0 => json!("black"),
            share => json!({ "diffuse": { "reflectance": share } }),
        }),
        "conductor" | "roughconductor" => Some(metal(&mut keys, notes)?),
        other => {
            return keys.wrong(
                "type",
                other,
                "nothing (black), diffuse, conductor, roughconductor, dielectric or roughdielectric; give the body the nearest of these",
            );
        }
    };
    keys.leave_out(
        &[
            "alpha",
            "alpha_u",
            "alpha_v",
            "distribution",
            "sample_visible",
        ],
        "surfaces are smooth here",
        notes,
    );
    let is_opaque = !matches!(kind.as_str(), "null" | "dielectric" | "roughdielectric");
    let material = match material {
        Some(material) if is_opaque && !reflections && material != "black" => {
            notes.push(format!(
                "{}: the body is black, as it is there without reflections (transmission_only)",
                keys.key("type")
            ));
            Some(json!("black"))
        }
        other => other,
    };
    keys.finish(notes);
    Ok(material)
}

/// Of a diffuse surface: a number, or the table of an even spectrum.
fn reflectance(keys: &mut Keys) -> Result<f64> {
    let share = match keys.take("reflectance") {
        None => Some(0.5),
        Some(Value::Object(spectrum)) => spectrum.get("value").and_then(Value::as_f64),
        Some(value) => value.as_f64(),
    };
    match share.filter(|share| (0.0..=1.0).contains(share)) {
        Some(share) => Ok(share),
        None => keys.wrong(
            "reflectance",
            "no number from 0 to 1",
            "one number for all light",
        ),
    }
}

/// A metal by its complex index; one that is named, or that has no index, reflects everything.
fn metal(keys: &mut Keys, notes: &mut Vec<String>) -> Result<Value> {
    if let Some(name) = keys.text("material")?.filter(|name| name != "none") {
        notes.push(format!(
            "{}: {name} reflects all light here; give its index with material.metal in [[obstacles]]",
            keys.key("material")
        ));
    }
    Ok(match (keys.number("eta")?, keys.number("k")?) {
        (Some(n), Some(k)) => {
            json!({ "metal": { "refractive_index": n, "extinction_coefficient": k } })
        }
        (None, None) => json!("mirror"),
        _ => return keys.wrong("eta", "one of eta and k", "both or neither"),
    })
}
