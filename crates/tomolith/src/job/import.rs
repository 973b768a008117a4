//! Jobs of another program as ours: the JSON files of Dr.TVAM (`vial`, `projector`, `sensor`, `target`, `loss`, …).
//!
//! Every key is mapped, left out with a note that says why, or refused by name; nothing is lost in silence. Where its conventions
//! differ from ours (its fluence in the resin carries a factor (n_surrounding/n_resin)², its `time` multiplies the dose, its
//! `film.resx` counts along y) the notes say so.
//!
//! | theirs | ours |
//! |---|---|
//! | `target` | `[target]`: mesh, size, offset |
//! | `sensor` | `[grid]`: counts and pitch |
//! | `vial`, `vial.medium`, `vial.occlusions` | `[vial]`, `[resin]`, `[[obstacles]]` |
//! | `projector` | `[[light]]`, `[start.patterns]` |
//! | `loss` | `[objective]`, `[[penalties]]` |
//! | `optimizer`, `n_steps` | `[optimizer]`, `[stop]` |
//! | `spp`, `transmission_only` | `[model.rays]` or `[model.monte_carlo]` |
//!
//! ```
//! let theirs = r#"{ "target": { "filename": "part.ply", "size": 4 },
//!   "vial": { "type": "index_matched", "r": 2.9, "medium": { "ior": 1.4, "extinction": 0.1, "albedo": 0.0 } },
//!   "projector": { "type": "collimated", "n_patterns": 200, "resx": 200, "resy": 20, "pixel_size": 0.05, "distance": 20,
//!                  "motion": "circular" },
//!   "sensor": { "type": "dda", "scalex": 5, "scaley": 5, "scalez": 1.25, "film": { "resx": 100, "resy": 100, "resz": 50 } } }"#;
//! let error = tomolith::job::import(theirs).unwrap_err();
//! assert!(error.to_string().contains("sensor")); // 5/100 by 5/100 by 1.25/50 mm: no cubes
//! let job = tomolith::job::import(&theirs.replace("\"resz\": 50", "\"resz\": 25")).unwrap();
//! assert!(job.text.contains("radius_mm = 2.9"));
//! ```

use crate::error::{Error, Result};
use keys::Keys;
use serde_json::{Value, json};

mod keys;

/// A job of another program, translated.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Our job file, TOML.
    pub text: String,
    /// What people should know: keys that have no meaning here, conventions that differ.
    pub notes: Vec<String>,
}

/// Sections of our job, in the order in which people read them.
#[derive(Default)]
struct Ours {
    sections: Vec<(String, Value)>,
    notes: Vec<String>,
}

impl Ours {
    fn add(&mut self, heading: &str, values: Value) {
        self.sections.push((heading.to_owned(), values));
    }

    /// As TOML; a section's values on a line each.
    fn text(&self) -> Result<String> {
        let mut text = String::new();
        for (heading, values) in &self.sections {
            text.push_str(&format!("\n{heading}\n"));
            for (key, value) in values.as_object().into_iter().flatten() {
                let value: toml::Value =
                    serde_json::from_value(value.clone()).map_err(|e| Error::Unsupported {
                        what: key.clone(),
                        reason: e.to_string(),
                    })?;
                text.push_str(&format!("{key} = {value}\n"));
            }
        }
        Ok(text)
    }
}

/// Our job for one of Dr.TVAM's, given as JSON text. Files it names keep their paths.
///
/// # Errors
/// [`Error::Config`] for a key that cannot be mapped, [`Error::Unsupported`] for text that is no JSON.
pub fn import(theirs: &str) -> Result<Imported> {
    let value: Value = serde_json::from_str(theirs).map_err(|e| Error::Unsupported {
        what: "the job to import".to_owned(),
        reason: format!("it is no JSON ({e}), as jobs of Dr.TVAM are"),
    })?;
    let mut root = Keys::new("", value)?;
    let mut ours = Ours::default();
    let resolution = sensor(root.need_table("sensor")?, "sensor")?;
    target(root.need_table("target")?, &mut ours)?;
    let [shape, pitch] = resolution;
    ours.add("[grid]", json!({ "shape": shape, "pitch_mm": pitch }));
    let (scatters, half_width) = vial(root.need_table("vial")?, &mut ours)?;
    let corner = root.table("filter_corner")?;
    let corner = corner.map(|keys| filter_corner(keys, half_width));
    projector(
        root.need_table("projector")?,
        corner.transpose()?,
        &mut ours,
    )?;
    loss(root.table("loss")?, &mut ours)?;
    optimizer(root.table("optimizer")?, &mut ours)?;
    model(&mut root, scatters, &mut ours)?;
    if let Some(fine) = root.table("final_sensor")? {
        sensor(fine, "final_sensor")?;
        ours.notes
            .push("final_sensor is left out: [evaluate] uses finer voxels by default".into());
    }
    ours.add(
        "[stop]",
        json!({ "iterations": root.count("n_steps", 40)? }),
    );
    if let Some(folder) = root.text("output")? {
        ours.add("[output]", json!({ "folder": folder }));
    }
    let time = root.number_or("time", 1.0)?;
    if time != 1.0 {
        ours.notes.push(format!(
            "time = {time} multiplies every dose there; here a pattern value is the energy of the whole exposure"
        ));
    }
    root.leave_out(
        &["filter_radon", "spp_filter_radon"],
        "pixels whose light misses the part always stay dark here",
        &mut ours.notes,
    );
    root.leave_out(
        &["surface_aware"],
        "at this place Dr.TVAM ignores it, too (it reads film.surface_aware); use objective.surface = \"cells\"",
        &mut ours.notes,
    );
    root.leave_out(
        &["export_wasserstein_distance", "progressive"],
        "there is no such switch here",
        &mut ours.notes,
    );
    root.finish()?;
    Ok(Imported {
        text: ours.text()?.trim_start().to_owned(),
        notes: ours.notes,
    })
}

/// Counts [x, y, z] and edge of the voxels.
fn sensor(mut keys: Keys, name: &str) -> Result<[Value; 2]> {
    keys.take("type");
    let size = [
        keys.number_or("scalex", 1.0)?,
        keys.number_or("scaley", 1.0)?,
        keys.number_or("scalez", 1.0)?,
    ];
    keys.take("majorant");
    let mut film = keys.need_table("film")?;
    film.take("type");
    // `resx` counts along y there, `resy` along x
    let (along_y, along_x) = (film.count("resx", 256)?, film.count("resy", 256)?);
    let counts = [along_x, along_y, film.count("resz", 256)?];
    if film.flag("surface_aware", false)? {
        return film.wrong(
            "surface_aware",
            true,
            "false; ask for cells by `surface` in the objective here",
        );
    }
    film.finish()?;
    keys.finish()?;
    let pitch: Vec<f64> = size
        .iter()
        .zip(counts)
        .map(|(size, count)| size / count as f64)
        .collect();
    if pitch.iter().any(|p| (p / pitch[0] - 1.0).abs() > 1e-6) {
        return Err(Error::config(
            name,
            format!(
                "voxels of {} × {} × {} mm (film.resx counts along y)",
                pitch[0], pitch[1], pitch[2]
            ),
            "cubes",
        ));
    }
    Ok([json!(counts), json!(pitch[0])])
}

fn target(mut keys: Keys, ours: &mut Ours) -> Result<()> {
    let file = keys.need_text("filename")?;
    let size = keys.number_or("size", 1.0)?;
    let middle = [
        keys.number_or("box_center_x", 0.0)?,
        keys.number_or("box_center_y", 0.0)?,
        keys.number_or("box_center_z", 0.0)?,
    ];
    let placed = if keys.flag("scale_and_center", true)? {
        json!({ "mesh": file, "size_mm": size, "offset_mm": middle })
    } else {
        json!({ "mesh": file, "center": false })
    };
    ours.add("[target]", placed);
    keys.finish()
}

/// The vial and what is in it; whether it scatters, and half the outer width of a square one.
fn vial(mut keys: Keys, ours: &mut Ours) -> Result<(bool, Option<f64>)> {
    let kind = keys.need_text("type")?;
    let medium = keys.need_table("medium")?;
    let surrounding = keys.number_or("ior_surrounding", 1.0)?;
    let obstacles = keys.take("occlusions");
    let (heading, walls) = walls(&kind, &mut keys)?;
    let half_width = walls["outer_width_mm"].as_f64().map(|width| width / 2.0);
    keys.leave_out(
        &["height"],
        "walls are as high as light reaches",
        &mut ours.notes,
    );
    keys.finish()?;
    let (resin, scatters) = medium_of(medium, &mut ours.notes)?;
    let index = resin["refractive_index"].as_f64().unwrap_or(1.0);
    ours.add("[resin]", resin);
    ours.add("[vial]", json!({ "surrounding_index": surrounding }));
    ours.add(heading, walls);
    if kind != "index_matched" {
        let factor = (surrounding / index).powi(2);
        ours.notes.push(format!(
            "doses of Dr.TVAM contain a factor (n_surrounding/n_resin)² = {factor:.6} that an energy does not: pattern values here are \
             {factor:.6} of those there for the same dose thresholds; resin.dose_convention = \"drtvam\" takes the factor along"
        ));
    }
    occlusions(obstacles, ours)?;
    Ok((scatters, half_width))
}

fn walls(kind: &str, keys: &mut Keys) -> Result<(&'static str, Value)> {
    Ok(match kind {
        "index_matched" => (
            "[vial.index_matched]",
            json!({ "radius_mm": keys.need_number("r")? }),
        ),
        "cylindrical" => (
            "[vial.cylinder]",
            json!({
                "inner_radius_mm": keys.need_number("r_int")?,
                "outer_radius_mm": keys.need_number("r_ext")?,
                "refractive_index": keys.need_number("ior")?,
            }),
        ),
        "square" => (
            "[vial.square]",
            json!({
                "inner_width_mm": keys.need_number("w_int")?,
                "outer_width_mm": keys.need_number("w_ext")?,
                "refractive_index": keys.need_number("ior")?,
            }),
        ),
        "double_cylindrical" => (
            "[vial.double_tube]",
            json!({
                "outer_radius_mm": keys.need_number("r_ext_outer")?,
                "resin_outer_radius_mm": keys.need_number("r_int_outer")?,
                "resin_inner_radius_mm": keys.need_number("r_ext_inner")?,
                "inner_radius_mm": keys.need_number("r_int_inner")?,
                "outer_refractive_index": keys.need_number("ior_outer")?,
                "inner_refractive_index": keys.need_number("ior_inner")?,
                "core_refractive_index": keys.need_number("ior_inside_inner")?,
            }),
        ),
        "custom" => (
            "[vial.mesh]",
            json!({
                "outer": keys.need_text("filename_vial_outer")?,
                "inner": keys.need_text("filename_vial_inner")?,
                "refractive_index": keys.need_number("ior")?,
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
        resin["phase"] = phase_of(given)?;
    } else if phase.is_some() {
        notes.push("vial.medium.phase is left out: the resin does not scatter".into());
    }
    keys.finish()?;
    Ok((resin, albedo > 0.0))
}

fn phase_of(mut keys: Keys) -> Result<Value> {
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
    keys.finish()?;
    Ok(phase)
}

fn occlusions(list: Option<Value>, ours: &mut Ours) -> Result<()> {
    let list = match list {
        None => return Ok(()),
        Some(Value::Array(list)) => list,
        Some(other) => {
            return Err(Error::config(
                "vial.occlusions",
                format!("found {other}"),
                "a list",
            ));
        }
    };
    for (i, value) in list.into_iter().enumerate() {
        let mut keys = Keys::new(&format!("vial.occlusions[{i}]"), value)?;
        let file = keys.need_text("filename")?;
        keys.take("face_normals");
        let material = match keys.table("bsdf")? {
            None => json!("black"),
            Some(bsdf) => material_of(bsdf)?,
        };
        keys.finish()?;
        ours.add(
            "[[obstacles]]",
            json!({ "mesh": file, "material": material }),
        );
    }
    Ok(())
}

fn material_of(mut keys: Keys) -> Result<Value> {
    let material = match keys.need_text("type")?.as_str() {
        "diffuse" => match keys.take("reflectance") {
            Some(value) if value.as_f64() == Some(0.0) => json!("black"),
            Some(value) => return keys.wrong("reflectance", value, "0 (black)"),
            None => return keys.wrong("reflectance", "no value, which is 0.5 there", "0 (black)"),
        },
        "conductor" => json!("mirror"),
        "dielectric" => {
            keys.take("ext_ior");
            json!({ "dielectric": { "refractive_index": keys.number_or("int_ior", 1.5046)? } })
        }
        other => {
            return keys.wrong(
                "type",
                other,
                "nothing (black), diffuse of reflectance 0 (black), conductor (a mirror) or dielectric",
            );
        }
    };
    keys.finish()?;
    Ok(material)
}

/// The radius about the corners of a square vial.
fn filter_corner(mut keys: Keys, half_width: Option<f64>) -> Result<f64> {
    let (distance, radius) = (keys.need_number("dist")?, keys.number_or("radius", 0.1)?);
    match half_width {
        Some(half) if (distance - half).abs() < 1e-6 * half => {}
        Some(half) => {
            let accepted =
                format!("{half}, half of vial.w_ext: corners are those of the vial here");
            return keys.wrong("dist", distance, &accepted);
        }
        None => {
            return keys.wrong(
                "dist",
                distance,
                "a square vial: corners are those of the vial here",
            );
        }
    }
    keys.finish()?;
    Ok(radius)
}

/// The first and the count of the pixels of a crop along one axis; None for all of them.
fn crop(
    keys: &mut Keys,
    [size, offset]: [&'static str; 2],
    whole: u64,
) -> Result<Option<[u64; 2]>> {
    let (count, first) = (keys.count(size, whole)?, keys.count(offset, 0)?);
    if count == 0 || first.saturating_add(count) > whole {
        return keys.wrong(
            size,
            format!("{count} from {first} on"),
            &format!("a crop within the {whole} pixels"),
        );
    }
    Ok((count < whole).then_some([first, count]))
}

fn projector(mut keys: Keys, corner: Option<f64>, ours: &mut Ours) -> Result<()> {
    let kind = keys.need_text("type")?;
    let patterns = keys.text("patterns")?;
    keys.leave_out(
        &["filter_nonzero"],
        "pixels that are dark at the start may be lit later here",
        &mut ours.notes,
    );
    let (columns, rows) = (keys.count("resx", 256)?, keys.count("resy", 256)?);
    let frames = keys.count("n_patterns", 1000)?;
    let mut selection = json!({});
    let crops = [
        (
            "columns",
            crop(&mut keys, ["cropx", "crop_offset_x"], columns)?,
        ),
        ("rows", crop(&mut keys, ["cropy", "crop_offset_y"], rows)?),
    ];
    for (key, crop) in crops {
        if let Some(crop) = crop {
            selection[key] = json!(crop);
        }
    }
    if selection != json!({}) {
        ours.notes.push(
            "patterns keep all pixels, those beyond the crop are dark: a light of the crop's pixels with offset_mm is the same in \
             smaller files"
                .into(),
        );
    }
    if let Some(radius) = corner {
        selection["corner_radius_mm"] = json!(radius);
    }
    keys.take("sampler");
    let motion = keys.need_text("motion")?;
    if motion != "circular" {
        return keys.wrong("motion", motion, "\"circular\"");
    }
    let distance = keys.need_number("distance")?;
    // The projector goes round there, the vial turns here
    let sense = if keys.flag("clockwise", false)? {
        "counter-clockwise"
    } else {
        "clockwise"
    };
    if keys.number("tilt")?.is_some_and(|tilt| tilt != 0.0) {
        let name = keys.key("tilt");
        ours.notes.push(format!(
            "{name} is left out: it is read there and never used; `motion.tilt_deg` tilts the axis here"
        ));
    }
    let optics = optics(&kind, &mut keys, (columns, distance))?;
    keys.finish()?;
    let mut light = json!({ "pixels": [columns, rows], "angles": frames, "rotation": sense, "projector": optics });
    if selection != json!({}) {
        light["selection"] = selection;
    }
    ours.add("[[light]]", light);
    if let Some(file) = patterns {
        ours.add("[start.patterns]", json!({ "file": file }));
    } else {
        ours.notes
            .push("it starts from dark patterns there, from filtered back-projection here".into());
    }
    Ok(())
}

fn optics(kind: &str, keys: &mut Keys, (columns, distance): (u64, f64)) -> Result<Value> {
    Ok(match kind {
        "collimated" => {
            json!({ "collimated": { "pixel_pitch_mm": keys.need_number("pixel_size")? } })
        }
        "telecentric" => {
            let focus = keys.need_number("focus_distance")?;
            json!({ "telecentric": {
                "pixel_pitch_mm": keys.need_number("pixel_size")?,
                "aperture_radius_mm": keys.need_number("aperture_radius")?,
                "working_distance_mm": focus,
                "focus_mm": distance - focus,
            } })
        }
        "lens" => {
            let focus = keys.need_number("focus_distance")?;
            let pitch = match (keys.number("pixel_size")?, keys.number("fov")?) {
                (Some(pitch), None) => pitch,
                (None, Some(fov)) => 2.0 * focus * (fov.to_radians() / 2.0).tan() / columns as f64,
                _ => return keys.wrong("fov", "both or neither", "one of fov and pixel_size"),
            };
            json!({ "lens": {
                "pixel_pitch_mm": pitch,
                "aperture_radius_mm": keys.need_number("aperture_radius")?,
                "distance_mm": distance,
                "focus_distance_mm": focus,
            } })
        }
        other => return keys.wrong("type", other, "collimated, telecentric or lens"),
    })
}

fn loss(keys: Option<Keys>, ours: &mut Ours) -> Result<()> {
    let mut keys = match keys {
        Some(keys) => keys,
        None => Keys::new("loss", json!({ "type": "threshold" }))?,
    };
    let kind = keys.need_text("type")?;
    let reduction = keys.text("reduction")?.unwrap_or_else(|| "sum".into());
    if reduction != "sum" {
        return keys.wrong("reduction", reduction, "\"sum\"");
    }
    let (part, void) = (
        keys.number_or("weight_object", 1.0)?,
        keys.number_or("weight_void", 1.0)?,
    );
    let sparsity = keys.number_or("weight_sparsity", 0.0)?;
    let power = keys.number_or("M", 4.0)?;
    match kind.as_str() {
        "threshold" => {
            let limit = keys.number_or("weight_limit", 1.0)?;
            if limit != part {
                return keys.wrong(
                    "weight_limit",
                    limit,
                    "weight_object: one weight for the part",
                );
            }
            ours.add(
                "[objective.threshold]",
                json!({
                    "lower": keys.number_or("tl", 0.9)?,
                    "upper": keys.number_or("tu", 0.95)?,
                    "exponent": keys.number_or("K", 2.0)?,
                    "part_weight": part,
                    "void_weight": void,
                }),
            );
        }
        "l2" => ours.add(
            "[objective.l2]",
            json!({ "part_weight": part, "void_weight": void }),
        ),
        other => return keys.wrong("type", other, "threshold or l2"),
    }
    keys.finish()?;
    if sparsity > 0.0 {
        ours.add(
            "[[penalties]]",
            json!({ "sparsity": { "exponent": power }, "weight": sparsity }),
        );
    }
    Ok(())
}

fn optimizer(keys: Option<Keys>, ours: &mut Ours) -> Result<()> {
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
    keys.finish()
}

/// Rays per pixel and reflections, where a model of rays is used.
fn model(root: &mut Keys, scatters: bool, ours: &mut Ours) -> Result<()> {
    let rays = root.count("spp", 4)?;
    let reflections = !root.flag("transmission_only", true)?;
    let regular = root.flag("regular_sampling", false)?;
    root.leave_out(
        &["spp_grad", "spp_ref"],
        "dose and gradient use the same rays here, and results are evaluated with more",
        &mut ours.notes,
    );
    root.leave_out(
        &["max_depth", "max_depth_ref", "rr_depth", "rr_depth_ref"],
        "light is followed until too little of it is left to matter",
        &mut ours.notes,
    );
    if reflections {
        let rays = if regular { 1 } else { rays };
        ours.add(
            "[model.rays]",
            json!({ "rays_per_pixel": rays, "reflections": true }),
        );
    } else {
        let what = if scatters { "paths" } else { "rays" };
        ours.notes.push(format!(
            "spp = {rays} {what} per pixel: the planner chooses the cheapest exact model; say [model.rays] or [model.monte_carlo] for another"
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const THEIRS: &str = r#"{
        "vial": { "type": "square", "w_int": 10.191, "w_ext": 12.408, "ior": 1.54, "medium": {
            "ior": 1.347, "extinction": 0.09, "albedo": 0.9, "phase": { "type": "rayleigh" } },
            "occlusions": [{ "filename": "rod.ply" }, { "filename": "lens.ply", "bsdf": { "type": "dielectric", "int_ior": 1.52 } }] },
        "projector": { "type": "lens", "n_patterns": 200, "resx": 200, "resy": 20,
            "cropx": 120, "crop_offset_x": 30, "fov": 5.0, "aperture_radius": 0.5,
            "focus_distance": 150, "distance": 152, "motion": "circular", "clockwise": true },
        "sensor": { "type": "dda", "scalex": 5, "scaley": 4, "scalez": 1.25, "film": { "type": "vfilm", "resx": 80, "resy": 100, "resz": 25 } },
        "target": { "filename": "box_hole.ply", "size": 4.0, "box_center_x": 0.5 },
        "loss": { "type": "threshold", "tl": 0.35, "tu": 0.55, "weight_sparsity": 0.1 },
        "filter_radon": true, "filter_corner": { "dist": 6.204, "radius": 0.2 }, "spp": 4, "spp_grad": 16, "max_depth": 6, "n_steps": 30, "output": "out/theirs" }"#;

    #[test]
    fn every_key_of_a_job_finds_its_place() {
        let found = import(THEIRS).unwrap();
        let job: Value = toml::from_str(&found.text).unwrap();
        let at = |pointer: &str| job.pointer(pointer).cloned().unwrap_or(Value::Null);
        assert_eq!(at("/grid/shape"), json!([100, 80, 25])); // resx counts along y
        assert_eq!(at("/grid/pitch_mm"), json!(0.05));
        assert_eq!(at("/resin/scattering_per_mm"), json!(0.9 * 0.09));
        assert_eq!(at("/vial/square/outer_width_mm"), json!(12.408));
        assert_eq!(
            at("/obstacles/1/material/dielectric/refractive_index"),
            json!(1.52)
        );
        assert_eq!(at("/light/0/rotation"), json!("counter-clockwise"));
        let pitch = at("/light/0/projector/lens/pixel_pitch_mm")
            .as_f64()
            .unwrap();
        assert!((pitch - 300.0 * 2.5f64.to_radians().tan() / 200.0).abs() < 1e-12);
        let selection = json!({ "columns": [30, 120], "corner_radius_mm": 0.2 });
        assert_eq!(at("/light/0/selection"), selection);
        assert_eq!(at("/objective/threshold/upper"), json!(0.55));
        assert_eq!(at("/penalties/0/sparsity/exponent"), json!(4.0));
        assert_eq!(at("/stop/iterations"), json!(30));
        let notes = found.notes.join("\n");
        for part in ["filter_radon", "spp_grad", "max_depth", "0.551144"] {
            assert!(notes.contains(part), "{part}: {notes}");
        }
    }

    #[test]
    fn what_has_no_place_is_refused_by_name() {
        let refused = |from: &str, to: &str| {
            assert!(THEIRS.contains(from), "{from}");
            import(&THEIRS.replace(from, to)).unwrap_err().to_string()
        };
        for (from, to, named) in [
            ("\"n_steps\"", "\"n_step\"", "n_step"),
            ("\"tl\"", "\"tL\"", "loss.tL"),
            (
                "\"type\": \"lens\"",
                "\"type\": \"conebeam\"",
                "projector.type",
            ),
            ("\"albedo\": 0.9", "\"albedo\": 1.1", "vial.medium.albedo"),
            ("\"scalez\": 1.25", "\"scalez\": 1.0", "sensor"),
            (
                "\"crop_offset_x\": 30",
                "\"crop_offset_x\": 81",
                "projector.cropx",
            ),
            ("\"dist\": 6.204", "\"dist\": 6.1", "filter_corner.dist"),
            (
                "\"type\": \"dielectric\"",
                "\"type\": \"roughconductor\"",
                "bsdf.type",
            ),
            ("\"rayleigh\"", "\"sggx\"", "phase.type"),
        ] {
            let text = refused(from, to);
            assert!(text.contains(named), "{named}: {text}");
        }
        assert!(refused("\"n_steps\"", "\"n_step\"").contains("did you mean `n_steps`"));
    }

    #[test]
    fn keys_with_their_default_values_change_nothing() {
        let plain = import(THEIRS).unwrap();
        for (from, to) in [
            ("\"n_steps\"", "\"surface_aware\": false, \"n_steps\""),
            (
                "\"type\": \"vfilm\"",
                "\"type\": \"vfilm\", \"surface_aware\": false",
            ),
            (
                "\"n_steps\"",
                "\"progressive\": false, \"export_wasserstein_distance\": false, \"n_steps\"",
            ),
            (
                "\"n_steps\"",
                "\"time\": 1, \"transmission_only\": true, \"regular_sampling\": false, \"n_steps\"",
            ),
            (
                "\"n_steps\"",
                "\"psf_analysis\": null, \"physical_model\": null, \"final_sensor\": null, \"n_steps\"",
            ),
            (
                "\"distance\"",
                "\"tilt\": 0.0, \"filter_nonzero\": false, \"cropy\": 20, \"crop_offset_y\": 0, \"distance\"",
            ),
            (
                "\"tl\"",
                "\"reduction\": \"sum\", \"K\": 2, \"M\": 4, \"weight_limit\": 1, \"weight_object\": 1.0, \"tl\"",
            ),
            (
                "\"n_steps\"",
                "\"optimizer\": { \"type\": \"lbfgs\" }, \"n_steps\"",
            ),
            (
                "\"size\"",
                "\"scale_and_center\": true, \"box_center_z\": 0, \"size\"",
            ),
            (
                "\"rod.ply\"",
                "\"rod.ply\", \"bsdf\": { \"type\": \"diffuse\", \"reflectance\": 0 }",
            ),
        ] {
            assert!(THEIRS.contains(from), "{from}");
            let found = import(&THEIRS.replacen(from, to, 1)).unwrap();
            assert_eq!(found, plain, "{to}");
        }
        let optimizer = |keys: &str| {
            let with = format!("\"optimizer\": {{ \"lr\": 0.1, {keys} }}, \"n_steps\"");
            import(&THEIRS.replace("\"n_steps\"", &with))
        };
        assert!(optimizer("\"type\": \"adam\", \"amsgrad\": false, \"uniform\": false").is_ok());
        assert!(
            optimizer("\"type\": \"sgd\", \"nesterov\": false, \"mask_updates\": false").is_ok()
        );
        // What would change something is told or refused
        let text = optimizer("\"type\": \"adam\", \"amsgrad\": true")
            .unwrap_err()
            .to_string();
        assert!(
            text.starts_with("optimizer.amsgrad: found true; accepted: false"),
            "{text}"
        );
        let found =
            import(&THEIRS.replace("\"n_steps\"", "\"surface_aware\": true, \"n_steps\"")).unwrap();
        assert!(
            found
                .notes
                .iter()
                .any(|note| note.starts_with("surface_aware is left out"))
        );
        let gray = THEIRS.replace(
            "\"rod.ply\"",
            "\"rod.ply\", \"bsdf\": { \"type\": \"diffuse\" }",
        );
        assert!(
            import(&gray)
                .unwrap_err()
                .to_string()
                .contains("bsdf.reflectance: found no value, which is 0.5")
        );
    }
}
