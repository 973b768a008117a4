//! `tomolith metrics`: all metrics of any dose against any target.

use crate::arguments::{Manner, as_option};
use crate::screen::{done, mutter, say};
use clap::Args;
use serde_json::{Value, json};
use tomolith::error::above_zero;
use tomolith::grid::{Volume, VolumeGrid};
use tomolith::io::array::read_any;
use tomolith::io::npy::place_of;
use tomolith::metrics::print::Print;
use tomolith::metrics::published::unit_systems::{Converted, UnitSystem};
use tomolith::metrics::published::{Options, of_print};
use tomolith::metrics::{Evaluation, METRICS, Published, evaluate};
use tomolith::report::json::evaluation_json;
use tomolith::target::label::{OUTSIDE, PART, VOID};
use tomolith::units::concise;
use tomolith::{Error, Result};

const EXAMPLES: &str = "\
Examples:
  tomolith metrics dose.npy target.npy --pitch-mm 0.02
  tomolith metrics results.npz:dose results.npz:target --region cylinder --json
Arrays are [z, y, x] or [y, x], of any number type; part is where the target is at least one half";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct MetricsArguments {
    /// Dose (or response): FILE.npy, .nrrd or .tif, or FILE.npz:NAME
    dose: String,
    /// Target: inside fraction, 0 and 1, or gray values
    target: String,
    /// Which voxels count: 0 none, 1 void, 2 part, as in dose.vti of a run; in place of the target's half
    #[arg(long, value_name = "ARRAY")]
    labels: Option<String>,
    /// Which voxels count: `box` for all, `cylinder` for the one about z that is inscribed
    #[arg(long, default_value = "box", value_parser = ["box", "cylinder"])]
    region: String,
    /// Edge of a voxel, mm; distances are in voxels when left out
    #[arg(long, value_name = "MM")]
    pitch_mm: Option<f64>,
    /// Dose at which the resin is solid; the one of the best IoU when left out
    #[arg(long)]
    threshold: Option<f64>,
    /// The target's values are gray and to be reproduced
    #[arg(long)]
    gray: bool,
    /// Half width of the band of BCLP's norms
    #[arg(long, default_value_t = 0.05)]
    epsilon: f64,
    /// Per cent left out at each end of each region by the trimmed numbers
    #[arg(long, default_value_t = 0.025)]
    trim_percent: f64,
    /// Absorption of the active species, 1/mm: adds the unit systems of Li et al. 2024, S.9; doses are then mJ/mm³
    #[arg(long, value_name = "PER_MM", requires_all = ["brightest", "exposure_s"])]
    absorption_per_mm: Option<f64>,
    /// Brightest pixel of the patterns, mJ/mm², for the unit systems
    #[arg(long, value_name = "MJ_PER_MM2", requires = "absorption_per_mm")]
    brightest: Option<f64>,
    /// For how long a pixel is lit, s, for the unit systems
    #[arg(long, value_name = "S", requires = "absorption_per_mm")]
    exposure_s: Option<f64>,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

pub(crate) fn metrics(given: &MetricsArguments) -> Result<()> {
    let pitch_mm = given.pitch_mm.unwrap_or(1.0);
    above_zero("--pitch-mm", pitch_mm)?;
    let units = Units::of(given)?;
    let (shape, values) = read_finite(&given.dose)?;
    let grid = VolumeGrid::centered(shape, pitch_mm);
    let dose = Volume::new(grid.clone(), values);
    let target = fractions(&given.target, like(&grid, &given.target)?)?;
    let labels = labels(given, &target)?;
    must_have_part(given, &labels)?;
    let mut print = Print::new(&labels, &dose)?.with_inside(&target)?;
    if given.gray {
        print = print.with_gray(&target, given.epsilon)?;
    }
    if let Some(threshold) = given.threshold {
        print = print.with_threshold(threshold).map_err(as_option)?;
    }
    let evaluation = evaluate(&print);
    let options = Options {
        gray: given.gray,
        epsilon: given.epsilon,
        trim_percent: given.trim_percent,
        ..Options::default()
    };
    let (numbers, slices) = of_print(&print, &target, &options).map_err(as_option)?;
    let systems = units.and_then(|units| units.systems(evaluation.gel_threshold));
    let mut found = json!({
        "evaluation": evaluation_json(&evaluation), "published": numbers, "slices": slices,
    });
    let unit = match given.pitch_mm {
        Some(_) => "mm",
        None => {
            in_voxels(&mut found);
            "voxel"
        }
    };
    found["unit_systems"] = json!(systems);
    found["lengths_in"] = unit.into();
    let warning = of_negative(&given.dose, &dose);
    found["warnings"] = json!(warning.iter().collect::<Vec<_>>());
    done(given.manner, found, || {
        if let Some(text) = &warning {
            mutter(&format!("{:>26} {text}", "warning"));
        }
        show(&evaluation, &numbers, given.pitch_mm.is_some());
        systems.iter().flatten().for_each(show_system);
    });
    Ok(())
}

/// Names lengths in voxels so: `surface_mean_voxel`, `over_voxel3`, `"unit": "voxel"`.
fn in_voxels(value: &mut Value) {
    match value {
        Value::Object(map) => {
            let entries = std::mem::take(map).into_iter();
            map.extend(entries.map(|(key, mut value)| {
                in_voxels(&mut value);
                match (key.as_str(), value.as_str()) {
                    ("unit", Some(unit @ ("mm" | "mm³"))) => {
                        value = json!(unit.replace("mm", "voxel"));
                    }
                    _ if key.ends_with("_mm") || key.ends_with("_mm3") => {
                        return (key.replace("_mm", "_voxel"), value);
                    }
                    _ => {}
                }
                (key, value)
            }));
        }
        Value::Array(list) => list.iter_mut().for_each(in_voxels),
        _ => {}
    }
}

/// What the unit systems need besides the dose: mJ/mm², 1/mm, s.
#[derive(Clone, Copy)]
struct Units {
    brightest: f64,
    absorption_per_mm: f64,
    exposure_s: f64,
}

impl Units {
    fn of(given: &MetricsArguments) -> Result<Option<Self>> {
        let (Some(absorption_per_mm), Some(brightest), Some(exposure_s)) =
            (given.absorption_per_mm, given.brightest, given.exposure_s)
        else {
            return Ok(None);
        };
        for (key, value) in [
            ("--absorption-per-mm", absorption_per_mm),
            ("--brightest", brightest),
            ("--exposure-s", exposure_s),
        ] {
            above_zero(key, value)?;
        }
        Ok(Some(Units {
            brightest,
            absorption_per_mm,
            exposure_s,
        }))
    }

    /// The brightest pixel and the gel dose in every system; none where no threshold prints.
    fn systems(self, gel_dose: Option<f64>) -> Option<[Converted; 4]> {
        let dose = gel_dose?;
        let convert = |s: UnitSystem| {
            s.convert(
                self.brightest,
                dose,
                self.absorption_per_mm,
                self.exposure_s,
            )
        };
        Some(UnitSystem::ALL.map(convert))
    }
}

fn show_system(row: &Converted) {
    let name = json!(row.system);
    say(&format!(
        "{:>26} brightest pixel {} {}, threshold {} {} (Li et al. 2024, S.9)",
        name.as_str().unwrap_or_default(),
        concise(row.pattern.0),
        row.pattern.1,
        concise(row.dose.0),
        row.dose.1
    ));
}

/// An array without NaN and infinity, which no metric could make sense of.
fn read_finite(source: &str) -> Result<([usize; 3], Vec<f32>)> {
    let (shape, values) = read_any(source)?;
    match values.iter().position(|value| !value.is_finite()) {
        Some(i) => Err(Error::format(
            source,
            format!("{} at {}, as [z, y, x]", values[i], place_of(i, &shape)),
            "finite numbers",
        )),
        None => Ok((shape, values)),
    }
}

/// What people should know of doses below 0.
fn of_negative(source: &str, dose: &Volume<f32>) -> Option<String> {
    let below = dose.values.iter().filter(|dose| **dose < 0.0).count();
    let least = dose.values.iter().copied().fold(0.0, f32::min);
    (below > 0).then(|| {
        format!(
            "{source}: {below} of {} doses are below 0, the least {least}: no light gives these; thresholds are looked for from the least one up",
            dose.values.len()
        )
    })
}

/// A target's values from 0 to 1; those of a mask of 0 and one other number are 0 and 1.
fn fractions(source: &str, mut target: Volume<f32>) -> Result<Volume<f32>> {
    let Some(&beyond) = (target.values.iter()).find(|v| !(0.0..=1.0).contains(*v)) else {
        return Ok(target);
    };
    if beyond < 0.0 || target.values.iter().any(|&v| v != 0.0 && v != beyond) {
        return Err(Error::format(
            source,
            format!("a value of {beyond}"),
            "values from 0 to 1 (divide 8-bit values by 255), or a mask of 0 and one other number",
        ));
    }
    target.values.iter_mut().for_each(|value| *value /= beyond);
    Ok(target)
}

/// An array of the dose's shape.
fn like(grid: &VolumeGrid, source: &str) -> Result<Volume<f32>> {
    let (shape, values) = read_finite(source)?;
    if shape != grid.shape {
        return Err(Error::shape(source, grid.shape, shape));
    }
    Ok(Volume::new(grid.clone(), values))
}

fn labels(given: &MetricsArguments, target: &Volume<f32>) -> Result<Volume<u8>> {
    let grid = &target.grid;
    let [_, ny, nx] = grid.shape;
    let radius = if given.region == "cylinder" {
        nx.min(ny) as f64 * grid.pitch_mm / 2.0
    } else {
        f64::INFINITY
    };
    let asked = given
        .labels
        .as_ref()
        .map(|source| like(grid, source))
        .transpose()?;
    let label = |i: usize| {
        let label = match &asked {
            None if target.values[i] >= 0.5 => PART,
            None => VOID,
            Some(labels) => match labels.values[i] {
                0.0 => OUTSIDE,
                1.0 => VOID,
                2.0 => PART,
                other => {
                    return Err(Error::config(
                        "--labels",
                        format!("a label of {other}"),
                        "0 outside, 1 void, 2 part",
                    ));
                }
            },
        };
        let [x, y, _] = grid.middle(i);
        Ok(if x.hypot(y) < radius { label } else { OUTSIDE })
    };
    Ok(Volume::new(
        grid.clone(),
        (0..grid.len()).map(label).collect::<Result<_>>()?,
    ))
}

/// Refuses arrays without a voxel of the part: such a print has no metrics.
fn must_have_part(given: &MetricsArguments, labels: &Volume<u8>) -> Result<()> {
    if labels.values.contains(&PART) {
        return Ok(());
    }
    let (path, accepted) = match &given.labels {
        Some(source) => (source, "an array with labels of 2, the part"),
        None => (
            &given.target,
            "an array with values of at least one half, the part",
        ),
    };
    let [z, y, x] = labels.grid.shape;
    Err(Error::format(
        path,
        format!("no voxel of the part in the region that counts ({z} × {y} × {x} voxels)"),
        accepted,
    ))
}

fn show(evaluation: &Evaluation, numbers: &[Published], scaled: bool) {
    let number = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), concise);
    let unit = |unit: &str| match unit {
        "mm" | "mm³" if !scaled => unit.replace("mm", "voxel"),
        other => other.to_owned(),
    };
    // Lengths in voxels are no lengths in mm, whatever the key says
    let name = |key: &'static str| {
        let bare = key.strip_suffix("_mm").or_else(|| key.strip_suffix("_mm3"));
        bare.filter(|_| !scaled).unwrap_or(key)
    };
    for kind in METRICS {
        let value = evaluation.measures.get(kind.name);
        if value.is_some() {
            say(&format!(
                "{:>26} {:>14} {:<8} {}",
                name(kind.name),
                number(value),
                unit(kind.unit),
                kind.summary
            ));
        }
    }
    // Surfaces that are the same are nowhere apart
    let apart = evaluation
        .measures
        .get("hausdorff_mm")
        .is_some_and(|mm| mm > 0.0);
    if let Some(farthest) = evaluation.farthest.filter(|_| apart) {
        let [x, y, z] = farthest.at_mm.map(concise);
        let (side, unit) = (farthest.side.words(), unit("mm"));
        say(&format!(
            "{:>26} ({x}, {y}, {z}) {unit}: {side}",
            format!("{} is at", name("hausdorff_mm"))
        ));
    }
    say("");
    say("as published:");
    for one in numbers {
        say(&format!(
            "{:>26} {:>14} {:<8} {} ({})",
            one.name,
            number(one.value),
            unit(one.unit),
            one.note,
            one.source
        ));
    }
    evaluation
        .notes
        .iter()
        .for_each(|note| say(&format!("{:>26} {note}", "note")));
}
