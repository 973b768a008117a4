//! Jobs of another program as ours: the JSON files of Dr.TVAM (`vial`, `projector`, `sensor`, `target`, `loss`, …).
//!
//! Every key is mapped, left out with a note that says why, or refused with what to change; nothing is lost in silence. Where its
//! conventions differ from ours (its fluence in the resin carries a factor (n_surrounding/n_resin)², its `time` multiplies the dose,
//! its `film.resx` counts along y) the notes say so. What comes out is read once as a job before it is returned.
//!
//! | theirs | ours | file |
//! |---|---|---|
//! | `target`, `sensor` | `[target]`, `[grid]` | here |
//! | `vial`, `vial.medium` | `[vial]`, `[resin]` | `vial.rs` |
//! | `vial.occlusions` | `[[obstacles]]` | `bodies.rs` |
//! | `projector`, `filter_corner` | `[[light]]`, `[start.patterns]` | `light.rs` |
//! | `loss`, `optimizer`, `n_steps` | `[objective]`, `[[penalties]]`, `[optimizer]`, `[stop]` | `search.rs` |
//! | `spp`, `transmission_only` | `[model.rays]` or `[model.monte_carlo]` | here |
//!
//! ```
//! let theirs = r#"{ "target": { "filename": "part.ply", "size": 4 },
//!   "vial": { "type": "index_matched", "r": 2.9, "medium": { "ior": 1.4, "extinction": 0.1, "albedo": 0.0 } },
//!   "projector": { "type": "collimated", "n_patterns": 200, "resx": 200, "resy": 20, "pixel_size": 0.05, "distance": 20,
//!                  "motion": "circular" },
//!   "sensor": { "type": "dda", "scalex": 5, "scaley": 5, "scalez": 1.25, "film": { "resx": 100, "resy": 100, "resz": 50 } } }"#;
//! let job = tomolith::job::import(theirs, &tomolith::job::ImportFiles::unread()).unwrap();
//! assert!(job.text.contains("radius_mm = 2.9"));
//! assert!(job.text.contains("pitch_mm = 0.025")); // voxels of 0.05 × 0.05 × 0.025 mm become cubes
//! ```

use super::document::Document;
use super::read::Job;
use crate::error::{Error, Result};
use crate::units::concise;
use keys::Keys;
use search::{loss, optimizer};
use serde_json::{Value, json};
pub use sinogram::sinogram;
use vial::vial;

mod bodies;
mod keys;
mod light;
mod search;
mod sinogram;
#[cfg(test)]
mod tests;
mod vial;

/// A job of another program, translated.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Our job file, TOML, that begins with the notes.
    pub text: String,
    /// What people should know: keys that have no meaning here, conventions that differ.
    pub notes: Vec<String>,
}

/// Sections of our job, in the order in which people read them.
struct Ours<'a> {
    sections: Vec<(String, Value)>,
    notes: Vec<String>,
    files: &'a ImportFiles<'a>,
}

/// The files that a job names.
pub struct ImportFiles<'a> {
    /// The path that our job has for a file of theirs.
    pub path: &'a dyn Fn(&str) -> String,
    /// The box of a mesh of theirs, lowest and highest corner, where it can be read.
    pub bounds: &'a dyn Fn(&str) -> Option<[[f64; 3]; 2]>,
}

impl ImportFiles<'_> {
    /// Files whose paths stay as they are, and which are not read.
    #[must_use]
    pub fn unread() -> ImportFiles<'static> {
        ImportFiles {
            path: &|file| file.to_owned(),
            bounds: &|_| None,
        }
    }
}

impl Ours<'_> {
    fn add(&mut self, heading: &str, values: Value) {
        self.sections.push((heading.to_owned(), values));
    }

    fn note(&mut self, note: impl Into<String>) {
        self.notes.push(note.into());
    }

    /// As TOML: the notes, then the sections, a value on a line each.
    fn text(&self) -> Result<String> {
        let mut text = String::new();
        for note in &self.notes {
            text.push_str(&format!("# {}\n", note.replace(['\r', '\n'], " ")));
        }
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
        Ok(text.trim_start().to_owned())
    }
}

/// Our job for one of Dr.TVAM's, given as JSON text.
///
/// # Errors
/// [`Error::Config`] for a value that cannot be mapped, [`Error::Unsupported`] for text that is no JSON.
pub fn import(theirs: &str, files: &ImportFiles<'_>) -> Result<Imported> {
    let value: Value = serde_json::from_str(theirs).map_err(|e| Error::Unsupported {
        what: "the job to import".to_owned(),
        reason: format!("it is no JSON ({e}), as jobs of Dr.TVAM are"),
    })?;
    let mut root = Keys::new("", value)?;
    let mut ours = Ours {
        sections: Vec::new(),
        notes: Vec::new(),
        files,
    };
    if let Some(kind) = root.take("physical_model") {
        return root.wrong(
            "physical_model",
            kind,
            "a job without it: [material.photopolymer] models inhibition here, so import the rest and add that table",
        );
    }
    let rays = Rays::of(&mut root, &mut ours)?;
    let film = sensor(root.need_table("sensor")?, &mut ours)?;
    let reach = target(root.need_table("target")?, &mut ours)?;
    let mut grid = json!({ "pitch_mm": film.pitch_mm });
    let half = film.shape.map(|count| count as f64 * film.pitch_mm / 2.0);
    if reach.is_some_and(|reach| (0..3).any(|i| reach[i] > half[i] * (1.0 + 1e-6))) {
        ours.note(
            "sensor: the part reaches beyond it, where Dr.TVAM computes no dose; the grid follows the part here",
        );
    } else {
        grid["shape"] = json!(film.shape);
    }
    ours.add("[grid]", grid);
    let passed = vial(root.need_table("vial")?, rays.reflections, &mut ours)?;
    let corner = root.table("filter_corner")?;
    let corner = corner.map(|keys| light::filter_corner(keys, passed.half_width_mm, &mut ours));
    light::projector(
        root.need_table("projector")?,
        corner.transpose()?.flatten(),
        &mut ours,
    )?;
    let voxels = film.theirs as f64;
    loss(root.table("loss")?, film.surface_aware, voxels, &mut ours)?;
    optimizer(root.table("optimizer")?, &mut ours)?;
    rays.model(passed.scatters, &mut ours);
    ours.add(
        "[stop]",
        json!({ "iterations": root.count("n_steps", 40)? }),
    );
    if let Some(folder) = root.text("output")? {
        ours.add("[output]", json!({ "folder": folder }));
    }
    let time = root.number_or("time", 1.0)?;
    if time != 1.0 {
        ours.note(format!(
            "time = {time} multiplies every dose there; here a pattern value is the energy of the whole exposure"
        ));
    }
    let left_out: [(&[&'static str], &str); 5] = [
        (
            &["filter_radon", "spp_filter_radon"],
            "pixels whose light misses the part always stay dark here",
        ),
        (&["final_sensor"], "[evaluate] uses finer voxels by default"),
        (
            &["surface_aware"],
            "at this place Dr.TVAM ignores it, too (it reads film.surface_aware); use objective.KIND.surface = \"cells\"",
        ),
        (
            &["export_wasserstein_distance", "progressive"],
            "there is no such switch here",
        ),
        (
            &["psf_analysis"],
            "it traces these pixels and optimizes nothing; `tomolith trace` follows rays here",
        ),
    ];
    for (keys, why) in left_out {
        root.leave_out(keys, why, &mut ours.notes);
    }
    root.finish(&mut ours.notes);
    let text = ours.text()?;
    // What our own reader refuses is no translation
    Job::from_document(Document::toml("the imported job", &text)?)?;
    Ok(Imported {
        text,
        notes: ours.notes,
    })
}

/// What a sensor asks for.
struct Film {
    /// Counts [x, y, z] of our voxels, and their edge.
    shape: [u64; 3],
    pitch_mm: f64,
    /// How many voxels there are there.
    theirs: u64,
    surface_aware: bool,
}

/// Cubes in place of other boxes have at most so many times as many voxels.
const MORE_VOXELS: f64 = 4.0;

fn sensor(mut keys: Keys, ours: &mut Ours) -> Result<Film> {
    keys.take("type");
    let mut size = [0.0; 3];
    for (size, key) in size.iter_mut().zip(["scalex", "scaley", "scalez"]) {
        *size = keys.positive_or(key, 1.0)?;
    }
    keys.take("majorant");
    let mut film = keys.need_table("film")?;
    film.take("type");
    // `resx` counts along y there, `resy` along x
    let (along_y, along_x) = (film.count("resx", 256)?, film.count("resy", 256)?);
    let counts = [along_x, along_y, film.count("resz", 256)?];
    let surface_aware = film.flag("surface_aware", false)?;
    if counts.contains(&0) {
        return keys.wrong(
            "film",
            format!("{counts:?} voxels"),
            "at least one along each axis",
        );
    }
    film.finish(&mut ours.notes);
    keys.finish(&mut ours.notes);
    let edges: [f64; 3] = std::array::from_fn(|i| size[i] / counts[i] as f64);
    let (pitch_mm, shape) = cubes(size, edges, counts);
    if shape != counts {
        let [x, y, z] = edges.map(concise);
        ours.note(format!(
            "sensor: voxels of {x} × {y} × {z} mm (film.resx counts along y) become cubes of {} mm, {} times as many; \
             grid.pitch_mm and grid.shape choose others",
            concise(pitch_mm),
            concise(count(shape) / count(counts)),
        ));
    }
    Ok(Film {
        shape,
        pitch_mm,
        theirs: counts.iter().product(),
        surface_aware,
    })
}

fn count(shape: [u64; 3]) -> f64 {
    shape.iter().map(|&n| n as f64).product()
}

/// Cubes that fill a box of voxels with these edges: as fine as their shortest edge, unless that would be too many.
fn cubes(size: [f64; 3], edges: [f64; 3], counts: [u64; 3]) -> (f64, [u64; 3]) {
    if edges
        .iter()
        .all(|edge| (edge / edges[0] - 1.0).abs() < 1e-6)
    {
        return (edges[0], counts);
    }
    let shortest = edges.iter().copied().fold(f64::INFINITY, f64::min);
    let affordable = (edges.iter().product::<f64>() / MORE_VOXELS).cbrt();
    let pitch = if affordable > shortest * (1.0 + 1e-6) {
        affordable
    } else {
        shortest
    };
    (pitch, size.map(|size| (size / pitch - 1e-6).ceil() as u64))
}

/// Adds the target; how far it reaches from the origin along each axis, where its mesh can be read.
fn target(mut keys: Keys, ours: &mut Ours) -> Result<Option<[f64; 3]>> {
    let file = keys.need_text("filename")?;
    let mesh = (ours.files.path)(&file);
    let bounds = (ours.files.bounds)(&file);
    let (placed, reach) = if keys.flag("scale_and_center", true)? {
        let middle = [
            keys.number_or("box_center_x", 0.0)?,
            keys.number_or("box_center_y", 0.0)?,
            keys.number_or("box_center_z", 0.0)?,
        ];
        let size = keys.positive_or("size", 1.0)?;
        let reach = bounds.map(|[low, high]| {
            let edges: [f64; 3] = std::array::from_fn(|i| high[i] - low[i]);
            let longest = edges.iter().copied().fold(0.0, f64::max);
            std::array::from_fn(|i| middle[i].abs() + 0.5 * size * edges[i] / longest)
        });
        let placed = json!({ "mesh": mesh, "size_mm": size, "offset_mm": middle });
        (placed, reach)
    } else {
        let reach = bounds.map(|[low, high]| std::array::from_fn(|i| high[i].max(-low[i])));
        (json!({ "mesh": mesh, "center": false }), reach)
    };
    ours.add("[target]", placed);
    keys.finish(&mut ours.notes);
    Ok(reach)
}

/// How light is followed there.
struct Rays {
    per_pixel: u64,
    reflections: bool,
}

impl Rays {
    fn of(root: &mut Keys, ours: &mut Ours) -> Result<Self> {
        let per_pixel = root.count("spp", 4)?;
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
        Ok(Rays {
            per_pixel: if regular { 1 } else { per_pixel },
            reflections: !root.flag("transmission_only", true)?,
        })
    }

    /// A model by name where reflections are followed; else the planner chooses.
    fn model(&self, scatters: bool, ours: &mut Ours) {
        let spp = self.per_pixel;
        match (self.reflections, scatters) {
            (true, true) => ours.add(
                "[model.monte_carlo]",
                json!({ "paths_per_pixel": spp, "reflections": true }),
            ),
            (true, false) => ours.add(
                "[model.rays]",
                json!({ "rays_per_pixel": spp, "reflections": true }),
            ),
            (false, _) => {
                let what = if scatters { "paths" } else { "rays" };
                ours.note(format!(
                    "spp = {spp} {what} per pixel: the planner chooses the cheapest exact model; say [model.rays] or [model.monte_carlo] for another"
                ));
            }
        }
    }
}
