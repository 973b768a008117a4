//! `loss` and `optimizer` as `[objective]`, `[[penalties]]` and `[optimizer]`.

use super::keys::Keys;
use crate::error::Result;
use crate::job::spec::import::Ours;
use serde_json::{Value, json};

/// The loss of a job, on so many voxels; `surface_aware` is a key of its film.
pub(crate) fn loss(
    keys: Option<Keys>,
    surface_aware: bool,
    voxels: f64,
    ours: &mut Ours,
) -> Result<()> {
    let mut keys = match keys {
        Some(keys) => keys,
        None => Keys::new("loss", json!({ "type": "threshold" }))?,
    };
    let kind = keys.need_text("type")?;
    let is_mean = match keys.text("reduction")?.as_deref() {
        None | Some("sum") => false,
        Some("mean") => true,
        Some(other) => return keys.wrong("reduction", other, "\"sum\" or \"mean\""),
    };
    let mut sparsity = keys.number_or("weight_sparsity", 0.0)?;
    let power = keys.positive_or("M", 4.0)?;
    match kind.as_str() {
        "threshold" => threshold(&mut keys, surface_aware, ours)?,
        "l2" => {
            ours.add("[objective.l2]", with_cells(json!({}), surface_aware));
            if sparsity > 0.0 && !surface_aware {
                ours.note("loss.weight_sparsity is left out: Dr.TVAM multiplies it by 0 in l2");
                sparsity = 0.0;
            }
        }
        other => {
            return keys.wrong(
                "type",
                other,
                "threshold or l2; `tomolith kinds objective` lists what may stand in its place",
            );
        }
    }
    keys.finish(&mut ours.notes);
    if sparsity > 0.0 {
        let weight = if is_mean {
            ours.note(format!(
                "loss.reduction: means over {voxels} voxels and over pixels become sums, so weight_sparsity is multiplied by the voxels per pixel"
            ));
            sparsity * voxels / pixels(ours)
        } else {
            sparsity
        };
        ours.add(
            "[[penalties]]",
            json!({ "sparsity": { "exponent": power }, "weight": weight }),
        );
    }
    Ok(())
}

/// Pixels of all frames of the light that was added.
fn pixels(ours: &Ours) -> f64 {
    let light = ours
        .sections
        .iter()
        .find(|(heading, _)| heading == "[[light]]");
    let number = |value: &Value| value.as_f64().unwrap_or(1.0);
    light.map_or(1.0, |(_, light)| {
        number(&light["pixels"][0]) * number(&light["pixels"][1]) * number(&light["angles"])
    })
}

fn with_cells(mut objective: Value, surface_aware: bool) -> Value {
    if surface_aware {
        objective["surface"] = json!("cells");
    }
    objective
}

/// The threshold loss; where the part's two sides have different weights, the band with the smaller weight and a second objective that
/// counts the heavier side once more.
fn threshold(keys: &mut Keys, surface_aware: bool, ours: &mut Ours) -> Result<()> {
    let (part, void, limit) = (
        keys.number_or("weight_object", 1.0)?,
        keys.number_or("weight_void", 1.0)?,
        keys.number_or("weight_limit", 1.0)?,
    );
    let (lower, upper) = (keys.number_or("tl", 0.9)?, keys.number_or("tu", 0.95)?);
    let exponent = keys.positive_or("K", 2.0)?;
    let values = json!({
        "lower": lower,
        "upper": upper,
        "exponent": exponent,
        "part_weight": part.min(limit),
        "void_weight": void,
    });
    let values = with_cells(values, surface_aware);
    if part == limit {
        ours.add("[objective.threshold]", values);
        return Ok(());
    }
    let once_more = if part > limit {
        let values = json!({
            "d_l": lower, "d_h": upper, "p": exponent, "rho_1": part - limit, "rho_2": 0.0, "surface": "fraction",
        });
        json!({ "pm": with_cells(values, surface_aware) })
    } else {
        // No dose is below 0, so of this band the ceiling alone counts
        let values = json!({
            "lower": -2.0, "upper": -1.0, "exponent": exponent, "part_weight": limit - part, "void_weight": 0.0,
        });
        json!({ "threshold": with_cells(values, surface_aware) })
    };
    ours.add("[[objectives]]", json!({ "threshold": values }));
    ours.add("[[objectives]]", once_more);
    ours.note(format!(
        "loss: weight_object = {part} and weight_limit = {limit} are the two sides of the part's band: a second objective counts the heavier one once more"
    ));
    Ok(())
}

pub(crate) fn optimizer(keys: Option<Keys>, ours: &mut Ours) -> Result<()> {
    let mut keys = match keys {
        Some(keys) => keys,
        None => Keys::new("optimizer", json!({ "type": "lbfgs" }))?,
    };
    match keys.need_text("type")?.as_str() {
        "lbfgs" => ours.add("[optimizer.lbfgs]", json!({})),
        "adam" => {
            keys.must_be_off(&["mask_updates", "uniform", "amsgrad"])?;
            let values = json!({
                "step": keys.need_number("lr")?,
                "beta_1": keys.number_or("beta_1", 0.9)?,
                "beta_2": keys.number_or("beta_2", 0.999)?,
                "epsilon": keys.number_or("epsilon", 1e-8)?,
            });
            ours.add("[optimizer.adam]", values);
        }
        "sgd" => {
            keys.must_be_off(&["mask_updates", "nesterov"])?;
            let momentum = keys.number_or("momentum", 0.0)?;
            let step = keys.need_number("lr")?;
            ours.add(
                "[optimizer.gradient]",
                json!({ "step": step, "momentum": momentum }),
            );
        }
        other => return keys.wrong("type", other, "lbfgs, adam or sgd"),
    }
    keys.finish(&mut ours.notes);
    Ok(())
}
