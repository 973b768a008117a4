//! `vial` and `vial.medium` as `[vial]` and `[resin]`.

use super::bodies::occlusions;
use super::keys::Keys;
use crate::error::Result;
use crate::job::spec::import::Ours;
use serde_json::{Value, json};

/// What the rest of the job needs to know of the vial.
pub(crate) struct Passed {
    /// Whether light goes on in random directions, in the resin or at a body.
    pub(crate) scatters: bool,
    /// Half the outer width of a square vial.
    pub(crate) half_width_mm: Option<f64>,
}

/// The vial and what is in it.
pub(crate) fn vial(mut keys: Keys, reflections: bool, ours: &mut Ours) -> Result<Passed> {
    let kind = keys.need_text("type")?;
    let medium = keys.need_table("medium")?;
    let surrounding = keys.number_or("ior_surrounding", 1.0)?;
    let bodies = keys.take("occlusions");
    let (heading, walls) = walls(&kind, &mut keys, ours)?;
    let half_width_mm = walls["outer_width_mm"].as_f64().map(|width| width / 2.0);
    keys.leave_out(
        &["height"],
        "walls are as high as light reaches",
        &mut ours.notes,
    );
    keys.finish(&mut ours.notes);
    let (resin, scatters) = medium_of(medium, &mut ours.notes)?;
    let index = resin["refractive_index"].as_f64().unwrap_or(1.0);
    ours.add("[resin]", resin);
    ours.add("[vial]", json!({ "surrounding_index": surrounding }));
    ours.add(heading, walls);
    if kind != "index_matched" {
        let factor = (surrounding / index).powi(2);
        ours.note(format!(
            "doses of Dr.TVAM contain a factor (n_surrounding/n_resin)² = {factor:.6} that an energy does not: pattern values here are \
             {factor:.6} of those there for the same dose thresholds; resin.dose_convention = \"drtvam\" takes the factor along"
        ));
    }
    let diffuse = occlusions(bodies, reflections, ours)?;
    Ok(Passed {
        scatters: scatters || diffuse,
        half_width_mm,
    })
}

/// Numbers that must rise.
fn rising<const N: usize>(keys: &mut Keys, names: [&'static str; N]) -> Result<[f64; N]> {
    let mut numbers = [0.0; N];
    for (i, name) in names.into_iter().enumerate() {
        numbers[i] = keys.need_positive(name)?;
        if i > 0 && numbers[i] <= numbers[i - 1] {
            let accepted = format!("more than the {} of {}", names[i - 1], numbers[i - 1]);
            return keys.wrong(name, numbers[i], &accepted);
        }
    }
    Ok(numbers)
}

fn walls(kind: &str, keys: &mut Keys, ours: &Ours) -> Result<(&'static str, Value)> {
    Ok(match kind {
        "index_matched" => (
            "[vial.index_matched]",
            json!({ "radius_mm": keys.need_positive("r")? }),
        ),
        "cylindrical" => {
            let [inner, outer] = rising(keys, ["r_int", "r_ext"])?;
            let walls = json!({
                "inner_radius_mm": inner,
                "outer_radius_mm": outer,
                "refractive_index": keys.need_positive("ior")?,
            });
            ("[vial.cylinder]", walls)
        }
        "square" => {
            let [inner, outer] = rising(keys, ["w_int", "w_ext"])?;
            let walls = json!({
                "inner_width_mm": inner,
                "outer_width_mm": outer,
                "refractive_index": keys.need_positive("ior")?,
            });
            ("[vial.square]", walls)
        }
        "double_cylindrical" => {
            let names = ["r_int_inner", "r_ext_inner", "r_int_outer", "r_ext_outer"];
            let [inner, resin_inner, resin_outer, outer] = rising(keys, names)?;
            let walls = json!({
                "outer_radius_mm": outer,
                "resin_outer_radius_mm": resin_outer,
                "resin_inner_radius_mm": resin_inner,
                "inner_radius_mm": inner,
                "outer_refractive_index": keys.need_positive("ior_outer")?,
                "inner_refractive_index": keys.need_positive("ior_inner")?,
                "core_refractive_index": keys.need_positive("ior_inside_inner")?,
            });
            ("[vial.double_tube]", walls)
        }
        "custom" => (
            "[vial.mesh]",
            json!({
                "outer": (ours.files.path)(&keys.need_text("filename_vial_outer")?),
                "inner": (ours.files.path)(&keys.need_text("filename_vial_inner")?),
                "refractive_index": keys.need_positive("ior")?,
            }),
        ),
        other => {
            return keys.wrong(
                "type",
                other,
                "index_matched, cylindrical, square, double_cylindrical or custom",
            );
        }
    })
}

fn medium_of(mut keys: Keys, notes: &mut Vec<String>) -> Result<(Value, bool)> {
    let index = keys.need_number("ior")?;
    let extinction = keys.need_number("extinction")?;
    let albedo = keys.need_number("albedo")?;
    if !(0.0..1.0).contains(&albedo) {
        return keys.wrong("albedo", albedo, "0 or above, below 1");
    }
    let phase = keys.table("phase")?;
    let mut resin = json!({
        "refractive_index": index,
        "absorption_per_mm": (1.0 - albedo) * extinction,
    });
    if albedo > 0.0 {
        resin["scattering_per_mm"] = json!(albedo * extinction);
        let given = keys.needed("phase", phase)?;
        resin["phase"] = phase_of(given, notes)?;
    } else if phase.is_some() {
        notes.push("vial.medium.phase is left out: the resin does not scatter".into());
    }
    keys.finish(notes);
    Ok((resin, albedo > 0.0))
}

fn phase_of(mut keys: Keys, notes: &mut Vec<String>) -> Result<Value> {
    let phase = match keys.need_text("type")?.as_str() {
        "rayleigh" => json!({ "rayleigh": {} }),
        "isotropic" => json!({ "isotropic": {} }),
        "hg" => json!({ "henyey_greenstein": { "g": keys.number_or("g", 0.8)? } }),
        other => {
            return keys.wrong(
                "type",
                other,
                "rayleigh, isotropic or hg; write [resin.phase.mixture] or [resin.phase.table] yourself",
            );
        }
    };
    keys.finish(notes);
    Ok(phase)
}
