//! `projector` and `filter_corner` as `[[light]]`.

use super::keys::Keys;
use crate::error::Result;
use crate::exposure::Rotation;
use crate::job::spec::import::Ours;
use crate::units::concise;
use serde_json::{Value, json};

/// The radius about the edges of a square vial within which pixels stay dark; None where none do.
///
/// There the place where a ray meets a face, at `half` from the axis, must lie within `radius` of (`dist`, `dist`): along the face that
/// is a strip about `dist` of half width √(radius² − (dist − half)²). Rays meet it up to the edge, so ours ends where that strip begins.
pub(crate) fn filter_corner(
    mut keys: Keys,
    half: Option<f64>,
    ours: &mut Ours,
) -> Result<Option<f64>> {
    let (distance, radius) = (keys.need_number("dist")?, keys.number_or("radius", 0.1)?);
    keys.finish(&mut ours.notes);
    let Some(half) = half else {
        ours.note("filter_corner is left out: this vial is not square");
        return Ok(None);
    };
    let strip = (radius.powi(2) - (distance - half).powi(2)).max(0.0).sqrt();
    let ours_mm = half - distance + strip;
    if strip == 0.0 || ours_mm <= 0.0 {
        ours.note(format!(
            "filter_corner is left out: no face of the vial, {} mm from the axis, comes within {} mm of ({distance}, {distance})",
            concise(half),
            concise(radius)
        ));
        return Ok(None);
    }
    if distance + strip < half {
        ours.note(format!(
            "filter_corner: the {} mm between its pixels and the edge stay dark, too",
            concise(half - distance - strip)
        ));
    }
    Ok(Some(ours_mm))
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

/// Which pixels of [columns, rows] may be lit.
fn selection(
    keys: &mut Keys,
    [columns, rows]: [u64; 2],
    corner: Option<f64>,
    ours: &mut Ours,
) -> Result<Option<Value>> {
    let mut selection = serde_json::Map::new();
    let crops = [
        ("columns", crop(keys, ["cropx", "crop_offset_x"], columns)?),
        ("rows", crop(keys, ["cropy", "crop_offset_y"], rows)?),
    ];
    for (key, crop) in crops {
        if let Some(crop) = crop {
            selection.insert(key.into(), json!(crop));
        }
    }
    if !selection.is_empty() {
        ours.note(
            "patterns keep all pixels, those beyond the crop are dark: a light of the crop's pixels with offset_mm is the same in \
             smaller files",
        );
    }
    if let Some(radius) = corner {
        selection.insert("corner_radius_mm".into(), json!(radius));
    }
    Ok((!selection.is_empty()).then_some(Value::Object(selection)))
}

pub(crate) fn projector(mut keys: Keys, corner: Option<f64>, ours: &mut Ours) -> Result<()> {
    let kind = keys.need_text("type")?;
    let patterns = keys.text("patterns")?;
    keys.leave_out(
        &["filter_nonzero"],
        "pixels that are dark at the start may be lit later here",
        &mut ours.notes,
    );
    let pixels = [keys.count("resx", 256)?, keys.count("resy", 256)?];
    let frames = keys.count("n_patterns", 1000)?;
    let selection = selection(&mut keys, pixels, corner, ours)?;
    keys.take("sampler");
    let motion = keys.need_text("motion")?;
    if motion != "circular" {
        return keys.wrong("motion", motion, "\"circular\"");
    }
    let distance = keys.need_positive("distance")?;
    // The projector goes round there, the vial turns here
    let rotation = if keys.flag("clockwise", false)? {
        Rotation::Counterclockwise
    } else {
        Rotation::Clockwise
    };
    if keys.number("tilt")?.is_some_and(|tilt| tilt != 0.0) {
        ours.note(format!(
            "{} is left out: it is read there and never used; `motion.tilt_deg` tilts the axis here",
            keys.key("tilt")
        ));
    }
    let optics = optics(&kind, &mut keys, pixels[0], distance)?;
    keys.finish(&mut ours.notes);
    let mut light =
        json!({ "pixels": pixels, "angles": frames, "rotation": rotation, "projector": optics });
    if let Some(selection) = selection {
        light["selection"] = selection;
    }
    ours.add("[[light]]", light);
    match patterns {
        Some(file) => {
            let file = (ours.files.path)(&file);
            ours.add("[start.patterns]", json!({ "file": file }));
        }
        None => {
            ours.note("it starts from dark patterns there, from filtered back-projection here");
        }
    }
    Ok(())
}

fn optics(kind: &str, keys: &mut Keys, columns: u64, distance: f64) -> Result<Value> {
    Ok(match kind {
        "collimated" => {
            json!({ "collimated": { "pixel_pitch_mm": keys.need_positive("pixel_size")? } })
        }
        "telecentric" => {
            let focus = keys.need_positive("focus_distance")?;
            json!({ "telecentric": {
                "pixel_pitch_mm": keys.need_positive("pixel_size")?,
                "aperture_radius_mm": keys.need_positive("aperture_radius")?,
                "working_distance_mm": focus,
                "focus_mm": distance - focus,
            } })
        }
        "lens" => {
            let focus = keys.need_positive("focus_distance")?;
            let pitch = match (keys.number("pixel_size")?, keys.number("fov")?) {
                (Some(pitch), None) if pitch > 0.0 => pitch,
                (Some(pitch), None) => return keys.wrong("pixel_size", pitch, "a number > 0"),
                (None, Some(fov)) if !(fov > 0.0 && fov < 180.0) => {
                    return keys.wrong("fov", fov, "degrees, between 0 and 180");
                }
                (None, Some(fov)) => 2.0 * focus * (fov.to_radians() / 2.0).tan() / columns as f64,
                _ => return keys.wrong("fov", "both or neither", "one of fov and pixel_size"),
            };
            json!({ "lens": {
                "pixel_pitch_mm": pitch,
                "aperture_radius_mm": keys.need_positive("aperture_radius")?,
                "distance_mm": distance,
                "focus_distance_mm": focus,
            } })
        }
        other => return keys.wrong("type", other, "collimated, telecentric or lens"),
    })
}
