//! Remarks on a job before it runs: a doubtful unit, few angles, choices that no line of the screen shows. Also finds the key that an error belongs to.

use super::goal::Goal;
use super::method::Method;
use super::optics::Optics;
use super::resources::compared;
use crate::error::{Error, Result};
use crate::grid::VolumeGrid;
use crate::io::npy::read_patterns;
use crate::job::spec::{Angles, JobSpec, LightSpec};
use crate::optics::light::Light;
use crate::optics::vial::Medium;
use crate::optimize::Keep;
use crate::optimize::start::given::OfFile;
use crate::report::number::significant;
use crate::target::Shape;
use crate::units::{concise, exact};
use serde_json::Value;
use std::collections::BTreeSet;
use tomolith_material::photopolymer::Curing;

/// The key that says how many voxels there are.
pub(crate) fn grid_key(spec: &JobSpec) -> String {
    let key = if spec.grid.shape.is_some() {
        "grid.shape"
    } else {
        "grid.pitch_mm"
    };
    key.to_owned()
}

/// Finds the key that leads to more voxels than the memory holds.
pub(crate) fn at_grid(spec: &JobSpec, error: Error) -> Error {
    match error {
        Error::Resources {
            what,
            needed_mb,
            available_mb,
            advice,
        } => Error::config(
            grid_key(spec),
            match available_mb {
                Some(mb) => compared(&what, needed_mb, mb),
                None => {
                    format!("{what}: {needed_mb} MB needed, but the system refused to allocate it")
                }
            },
            advice,
        ),
        other => other,
    }
}

/// What cannot be used together, as an error of the section that asks for it.
pub(crate) fn at_section(path: &str, error: Error) -> Error {
    match error {
        Error::Unsupported { what, reason } => {
            let (found, accepted) = reason.split_once("; ").unwrap_or((&reason, "another kind"));
            if what.starts_with("stop.") {
                return Error::config(what, format!("cannot be used here: {found}"), accepted);
            }
            Error::config(path, format!("{what}, but {found}"), accepted)
        }
        other => other,
    }
}

/// Says which key named the file that could not be read.
pub(crate) fn at_target(spec: &JobSpec, error: Error) -> Error {
    let key = match (&spec.target.mesh, &spec.target.stack) {
        (Some(_), _) => "target.mesh",
        (None, Some(_)) => "target.stack",
        (None, None) => "target.image",
    };
    match error {
        Error::Io { .. } => Error::config(key, error.to_string(), "a file that can be read"),
        Error::Mesh { ref accepted, .. } | Error::Format { ref accepted, .. } => {
            let accepted = accepted.clone();
            let text = error.to_string();
            let found = text
                .split("; accepted: ")
                .next()
                .unwrap_or(&text)
                .to_owned();
            Error::config(key, found, accepted)
        }
        other => other,
    }
}

/// A part of a mesh is expected to be no smaller than this share of what the resin holds.
const SMALL: f64 = 0.03;

/// Asks for the unit of a mesh whose part is far too large or small for the vial.
pub(crate) fn ask_for_unit(spec: &JobSpec, optics: &Optics, shape: &dyn Shape) -> Option<String> {
    let across = 2.0 * optics.vial.resin_wall().inscribed_radius();
    let height = |light: &Light| {
        let field = light.pixels.field_mm();
        field[1][1] - field[0][1]
    };
    let room = optics.lights.iter().map(height).fold(across, f64::max);
    let expected = [SMALL * across, room];
    spec.target.ask_for_unit(shape.bounds_mm(), expected)
}

/// Refuses a part smaller than a voxel: by the pixels where voxels are as wide as these, else by the key that says how large it is, unless the voxels are coarse for the pixels.
pub(crate) fn must_be_seen(
    spec: &JobSpec,
    shape: &dyn Shape,
    grid: &VolumeGrid,
    question: Option<&str>,
    is_coarse: bool,
) -> Result<()> {
    let [low, high] = shape.bounds_mm();
    let longest = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    if longest >= grid.pitch_mm || (is_coarse && question.is_none()) {
        return Ok(());
    }
    if spec.grid.pitch_mm.is_none() && spec.grid.shape.is_none() && question.is_none() {
        let (pixel, part) = (concise(grid.pitch_mm), concise(longest));
        return Err(Error::config(
            "light[0].projector",
            format!("a pixel is {pixel} mm wide, the part {part} mm long"),
            "pixels narrower than the part: a pixel_pitch_mm in mm, or a text with its unit, such as \"50 um\"; else a larger target",
        ));
    }
    let key = match &spec.target {
        target if target.size_mm.is_some() => "target.size_mm",
        target if target.mesh_unit.is_some() => "target.mesh_unit",
        _ => "target",
    };
    let found = format!(
        "the part is {} mm long, a voxel of the grid {} mm",
        concise(longest),
        concise(grid.pitch_mm)
    );
    let accepted = match spec.target.mesh {
        Some(_) => {
            "a target larger than a voxel: target.size_mm gives its longest edge, target.mesh_unit the unit of its file"
        }
        None => "a target larger than a voxel: target.size_mm gives its longest edge",
    };
    let error = Error::config(key, found, accepted);
    Err(error.asking(question))
}

/// Says that no finer voxels will be looked at.
pub(crate) fn on_its_own_grid(spec: &JobSpec) -> Option<String> {
    (spec.evaluate.refine == Some(1)).then(|| {
        "evaluate.refine = 1: the print is evaluated on the job's own voxels, where IoU is higher than on finer ones; leave the key out for finer voxels"
            .to_owned()
    })
}

/// Says that the threshold of the evaluation is far from those that patterns are made for, such as one in percent.
pub(crate) fn far_threshold(spec: &JobSpec, goal: &Goal) -> Option<String> {
    let (at, [low, high]) = (spec.evaluate.threshold?, goal.thresholds()?);
    let is_far = at < low / FAR || at > high * FAR;
    is_far.then(|| {
        let [at, low, high] = [at, low, high].map(exact);
        format!(
            "evaluate.threshold = {at} is far from the objective's thresholds {low} and {high}. Patterns are made for a resin that turns solid between these, \
             and the print is predicted at another exposure. Use a dose between them, or leave the key out for the one with the best IoU"
        )
    })
}

/// Says that an objective of degrees of cure asks for none at which the resin is solid.
pub(crate) fn below_gel(spec: &JobSpec, goal: &Goal) -> Option<String> {
    let is_cure = spec.schedule.as_ref()?.optimizes_cure();
    let [_, upper] = goal.thresholds()?;
    (is_cure && upper < 1.0).then(|| {
        let upper = exact(upper);
        format!(
            "the objective asks the part for {upper} or more. With this schedule.optimize that is a degree of cure, and resin is solid at 1: \
             the part may never gel. Use thresholds around 1, such as 0.8 and 1.2"
        )
    })
}

/// Says that a resin needs far more than others, as where a dose per area was taken for one per volume.
pub(crate) fn large_critical_dose(spec: &JobSpec) -> Option<String> {
    let dose = spec.resin.critical_dose_mj_per_mm3?;
    (dose > LARGE_DOSE).then(|| {
        format!(
            "resin.critical_dose_mj_per_mm3 = {0} is {0} J/cm³. Resins of the profiles and examples gel at 0.16 to 0.8, and times and energies follow from this dose. \
             If it is one in mJ/cm², divide it by 100 times the penetration depth in mm",
            exact(dose)
        )
    })
}

/// Ten times the critical dose of the examples' resins and more, mJ/mm³.
const LARGE_DOSE: f64 = 10.0;

/// By how many times a threshold may lie beyond the objective's without a word.
const FAR: f64 = 2.0;

/// Directions from which light comes, below which a part cannot take its shape.
const FEW_ANGLES: usize = 12;

/// Directions that light comes from, in thousandths of a degree from 0 to 360°, each once.
fn directions(spec: &JobSpec) -> BTreeSet<u64> {
    let azimuths = spec.light.iter().flat_map(|light| {
        let (azimuths, _) = light.angles.azimuths(light.rotation);
        azimuths
            .into_iter()
            .map(|azimuth| (azimuth.to_degrees().rem_euclid(360.0) * 1e3).round() as u64 % TURN)
    });
    azimuths.collect()
}

/// A turn in thousandths of a degree.
const TURN: u64 = 360_000;

/// Warns of light that comes from a handful of directions.
pub(crate) fn few_angles(spec: &JobSpec) -> Option<String> {
    let count = directions(spec).len();
    (count < FEW_ANGLES).then(|| {
        let from = if count == 1 { "one direction".to_owned() } else { format!("{count} directions") };
        format!(
            "light.angles: light comes from {from} only, so doses add up along stripes and no part takes its shape; \
             use some hundred angles"
        )
    })
}

/// Arc below which edges are missing, in thousandths of a degree: about half a turn.
const WHOLE_ARC: u64 = 175_000;

/// Warns of light from many directions that leave more than half of a turn out.
pub(crate) fn narrow_arc(spec: &JobSpec) -> Option<String> {
    let directions = directions(spec);
    let (first, last) = (*directions.first()?, *directions.last()?);
    let gaps = directions.iter().zip(directions.iter().skip(1));
    let widest = gaps.map(|(a, b)| b - a).max().unwrap_or(0);
    let count = directions.len() as u64;
    // A frame stands for the step that follows it, too
    let arc = (TURN - widest.max(first + TURN - last)) * count / count.saturating_sub(1).max(1);
    (directions.len() >= FEW_ANGLES && arc < WHOLE_ARC).then(|| {
        format!(
            "light.angles: light comes from an arc of {}°, so edges along which no light runs stay blurred; use half a turn or more",
            significant(arc as f64 / 1e3, 3)
        )
    })
}

/// Share of the resin's refractive index below which what is in the resin reflects a part of the light totally that is felt.
const REFLECTING: f64 = 0.99;

/// Warns of a tube in the resin that reflects light totally, where the model drops that light.
pub(crate) fn lost_reflections(spec: &JobSpec, optics: &Optics) -> Option<String> {
    let walls = optics.vial.walls();
    let in_resin = walls.iter().skip_while(|wall| wall.inside != Medium::Resin);
    let indices = in_resin.filter_map(|wall| match wall.inside {
        Medium::Clear(index) => Some(index),
        _ => None,
    });
    let least = indices.reduce(f64::min)?;
    let resins = optics
        .lights
        .iter()
        .map(|light| light.resin.refractive_index);
    let resin = resins.fold(0.0, f64::max);
    let mut kinds = spec
        .model
        .iter()
        .filter_map(Value::as_object)
        .flat_map(|kind| kind.values());
    let follows = kinds.any(|kind| kind["reflections"] == true);
    (least < REFLECTING * resin && !follows).then(|| {
        format!(
            "the tube in the resin reflects light totally: its refractive index is {}, that of the resin {}. The model drops that light, so the resin gets more dose than \
             predicted and gels earlier (in example 04 by 6 %). [model.rays] with reflections = true follows it",
            concise(least),
            concise(resin)
        )
    })
}

/// Frames for a machine or a print in time that cover a part of a turn, which its time to print and its movie count as one pass.
pub(crate) fn part_of_a_turn(spec: &JobSpec) -> Option<String> {
    let is_shown = |i: usize| spec.printer_of(i).is_some() || spec.schedule.is_some();
    let arc = |(i, light): (usize, &LightSpec)| match light.angles {
        Angles::Even { arc_deg, .. } if arc_deg < 360.0 && is_shown(i) => Some(arc_deg),
        _ => None,
    };
    let arc = spec.light.iter().enumerate().find_map(arc)?;
    let arc = significant(arc, 4);
    Some(format!(
        "light.angles: the frames cover {arc}° of a turn. Times and turns count passes of {arc}°, one after the other, and so does the movie; \
         where the vial turns on, the next pass comes from other sides. Give it a whole turn, or bring the vial back in the dark"
    ))
}

/// Two doses at which resin gels: that of plans by dose alone, and that of the print in time.
pub(crate) fn two_critical_doses(spec: &JobSpec) -> Option<String> {
    let of_resin = spec.resin.critical_dose_mj_per_mm3?;
    let photopolymer = spec.photopolymer()?;
    let of_networks = photopolymer
        .networks
        .iter()
        .filter_map(|network| match network.curing {
            Curing::Threshold {
                critical_dose_mj_per_mm3,
            } => Some(critical_dose_mj_per_mm3),
            Curing::RateLaw { .. } => None,
        });
    let doses: Vec<f64> = of_networks.collect();
    let other = *doses.first().filter(|_| !doses.contains(&of_resin))?;
    Some(format!(
        "resin.critical_dose_mj_per_mm3 = {} counts where dose alone is looked at (time to print, `tomolith expose`), and the print in time gels at {} mJ/mm³: \
         give both the same, or leave the first out",
        concise(of_resin),
        concise(other)
    ))
}

/// What a job chooses of its method that no line of the screen shows.
pub(crate) fn chosen(spec: &JobSpec, method: &Method) -> Vec<String> {
    let edges = method.requirements.edges.map(|_|
        "optimizer.osmo.edges = true: each step ends with two more halves, at the part's surface",
    );
    let last = (spec.stop.keep == Keep::Last).then_some(
        "stop.keep = \"last\": the patterns are those of the last iteration, the best ones or not",
    );
    let lights = spec.light.iter().enumerate();
    let lists =
        lights.filter(|(_, light)| matches!(&light.angles, Angles::List(list) if list.len() > 1));
    let standing = lists.map(|(i, _)| format!(
        "light[{i}].angles.list_deg: the vial stands during each of these frames, so nothing is averaged over a turn (sub_angles) and no movie is written; \
         {{ count, start_deg, arc_deg }} is for a vial that turns"
    ));
    let of_method = [edges, last].into_iter().flatten().map(str::to_owned);
    of_method.chain(standing).collect()
}

/// Refuses patterns to start from that cannot be read or are of other lights; says where their shape is another one.
pub(crate) fn given_patterns(method: &Method, optics: &Optics) -> Result<Vec<String>> {
    let Some(files) = method.start.files() else {
        return Ok(Vec::new());
    };
    let lights = optics.lights.len();
    let accepted = format!(
        "patterns.npz of a run, or an .npz with an array `patterns` [angle, row, column]; of {lights} light(s)"
    );
    let read = |key: &str, file: &OfFile| {
        let arrays = read_patterns(&file.0)
            .map_err(|error| Error::config(key, error.to_string(), accepted.as_str()))?;
        if arrays.len() != lights {
            let found = format!("patterns of {} lights", arrays.len());
            return Err(Error::config(key, found, accepted.as_str()));
        }
        Ok(arrays)
    };
    let key = "start.patterns.file";
    let arrays = read(key, &files.first)?;
    // The last one of a step is no start by itself
    let from = files.step.iter().map(|[from, _]| from);
    for (i, file) in files.or.iter().chain(from).enumerate() {
        read(&format!("start.patterns.or[{i}]"), file)?;
    }
    let others = arrays.iter().zip(&optics.lights).filter_map(|(array, light)| {
        let (found, expected) = (array.shape, light.pixels.shape());
        (found != expected).then(|| {
            format!("{key}: patterns of {found:?} [angle, row, column] are resampled to {expected:?} over the same field of view")
        })
    });
    Ok(others.collect())
}
