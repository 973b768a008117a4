//! Job file → objects → the whole run.
//!
//! | step | file |
//! |---|---|
//! | text → values that know their lines | [`document`] |
//! | values → typed tables | [`spec`] |
//! | every range and every pair that must fit | [`validate`] |
//! | all keys at fault, and not only the first | `all_errors` |
//! | typed tables → objects, and whether these fit together | `build`, `compatibility` |
//! | every row of every family's table | [`kinds`], [`schema`], [`reference_page`] |
//! | a job as objects, for other programs | [`resolved`] |
//! | patterns to the machine and back, a run for another machine | `device`, [`export`] |
//! | jobs of another program | [`mod@import`] |
//! | what many runs ask of a job | `many` |
//! | the model that judges its own patterns, and serves the next run | `kept` |
//! | one job on several processes | `ranks` |
//! | the folder of a run, what the machine has, what a run says | [`folder`], [`resources`], [`progress`] |

mod all_errors;
mod benchmark;
mod build;
mod card;
mod cells;
mod clip;
mod co_optimize;
mod compatibility;
mod contact;
mod cross_check;
mod device;
pub mod document;
mod doses;
mod doubts;
mod estimate;
mod evaluate;
pub mod export;
mod file_names;
pub mod folder;
mod heights;
pub mod import;
mod in_time;
mod kept;
pub mod kinds;
mod levels;
mod light;
mod limits;
mod many;
mod model_probe;
mod multiresolution;
mod noise;
mod not_finite;
mod objectives;
mod optimize;
mod others;
pub mod outcome;
mod point_spread;
pub mod progress;
mod property;
mod ranks;
mod reach;
pub mod read;
pub mod reference_page;
mod refinement;
mod replace;
mod resolve;
pub mod resolved;
pub mod resources;
mod resume;
mod scenarios;
mod scene;
mod scheduled;
pub mod schema;
mod selection;
pub mod spec;
mod species;
mod stages;
mod time_refusals;
pub mod trace;
pub mod validate;
mod write;

pub use document::Document;
pub use folder::RunFolder;
pub use import::{Files, Imported, import, sinogram};
pub use kept::KeptParts;
pub use many::{JobRequirements, Leaves, requirements, run_here};
pub use outcome::{Plan, Quality, Summary, TimeSummary};
pub use progress::{Event, Progress, Silent};
pub use ranks::run_among;
pub use read::Job;
pub use resolved::{Prediction, ResolvedJob, Task};
pub use spec::*;
pub use stages::{check, run, run_leaving, simulate};

#[cfg(test)]
pub(crate) mod tests {
    use super::build::Optics;
    use super::spec::with_example;
    use super::*;
    use crate::error::Error;
    use std::path::Path;

    /// A job that names nearly every key.
    pub(crate) const FULL: &str = r#"
[target]
phantom = "gear"
size_mm = 5.0

[grid]
pitch_mm = 0.05
region = "cylinder"

[resin]
refractive_index = 1.4849
absorption_per_mm = 0.054
attenuation_per_mm = 0.06

[vial]
surrounding_index = 1.0
[vial.cylinder]
inner_radius_mm = 7.6
outer_radius_mm = "0.83 cm"
refractive_index = 1.58

[[light]]
name = "violet"
wavelength_nm = 405
pixels = [128, 64]
angles = { count = 180, start_deg = 10.0, arc_deg = 360.0 }
sub_angles = 1
rotation = "counterclockwise"
polarization = "s"
projector.collimated = { pixel_pitch_mm = "50 um" }

[objective.threshold]
lower = 0.85
upper = 0.95

[optimizer.lbfgs]
memory = 10

[start.fbp]

[bounds]
min = 0.0
max = 3.0

[stop]
iterations = 40
wall_s = 100.0

[checkpoint]
every_s = 10.0
contents = "all"

[evaluate]
bit_depth = 8

[output]
folder = "out/part"
"#;

    fn read(text: &str) -> Result<JobSpec, Error> {
        JobSpec::from_document(&Document::toml("a.toml", text)?)
    }

    #[test]
    fn lengths_take_units_and_defaults_are_filled_in() {
        let spec = read(FULL).unwrap();
        let optics = Optics::new(&spec, Path::new("")).unwrap();
        assert_eq!(optics.lights[0].pixels.pitch_mm, [0.05; 2]);
        assert_eq!(spec.light[0].angles.count(), 180);
        assert_eq!(
            (
                spec.evaluate.sub_angles,
                spec.evaluate.refine,
                spec.output.rpm
            ),
            (4, None, 10.0)
        );
        assert_eq!(spec.grid.region, Region::Cylinder);
    }

    #[test]
    fn a_resolved_job_reads_back_as_itself() {
        let text = read(FULL).unwrap().to_toml().unwrap();
        assert!(text.contains("sub_angles = 4"), "{text}");
        assert_eq!(read(&text).unwrap().to_toml().unwrap(), text);
    }

    #[test]
    fn every_required_key_has_an_example_for_its_message() {
        let full: toml::Table = FULL.parse().unwrap();
        for table in ["target", "resin", "vial", "light"] {
            let mut without = full.clone();
            without.remove(table);
            let message = read(&without.to_string()).unwrap_err().to_string();
            let start = format!("{table}: the table is missing; accepted: a table [");
            assert!(message.starts_with(&start), "{message}");
        }
        let schema = schema::schema();
        for (name, table) in schema["$defs"].as_object().unwrap() {
            let keys = table["required"].as_array().into_iter().flatten();
            for key in keys.map(|key| key.as_str().unwrap()) {
                let path = match name.as_str() {
                    "LightSpec" => format!("light.{key}"),
                    "BathSpec" => format!("bath.{key}"),
                    "MapSpec" => format!("resin.absorption_map.{key}"),
                    "ObstacleSpec" => format!("obstacles.{key}"),
                    _ => continue, // kinds have examples of their own
                };
                let missing = with_example(Error::config(path.clone(), crate::kind::MISSING, ""));
                let message = missing.to_string();
                assert!(message.contains("for example"), "{path}: {message}");
            }
        }
    }

    #[test]
    fn slips_are_named_with_key_line_and_neighbor() {
        for (from, to, mark, expected) in [
            (
                "iterations = 40",
                "iteratons = 40",
                "iteratons",
                ["stop.iteratons", "did you mean `iterations`?"],
            ),
            (
                "[resin]",
                "[resn]",
                "[resn",
                ["resn", "did you mean `resin`?"],
            ),
            (
                "count = 180",
                "cuont = 180",
                "cuont",
                ["light[0].angles.cuont", "did you mean `count`?"],
            ),
            (
                "\"s\"",
                "\"q\"",
                "\"q\"",
                ["light[0].polarization", "unpolarized, s, p"],
            ),
            (
                "0.95",
                "0.95\n[multiresolution]\nlevles = 3",
                "levles",
                ["multiresolution.levles", "did you mean `levels`?"],
            ),
            (
                "iterations = 40",
                "iterations = -1",
                "= -1",
                ["stop.iterations", "a whole number, 0 or more"],
            ),
            (
                "pitch_mm = 0.05",
                "pitch_mm = \"50 kg\"",
                "50 kg",
                ["grid.pitch_mm", "unknown unit of length `kg`"],
            ),
            (
                "\n[vial]",
                "\n[vial.bottom]\n[vial]",
                "[vial.bottom",
                ["vial.bottom.z_mm: the key is missing", "z_mm = -10.0"],
            ),
            (
                "= 1.0",
                "= \"air\"",
                "\"air\"",
                ["vial.surrounding_index: found \"air\"", "a number"],
            ),
            (
                "[128, 64]",
                "[128]",
                "[128]",
                ["light[0].pixels", "a list of 2"],
            ),
        ] {
            let text = FULL.replacen(from, to, 1);
            let line = 1 + text[..text.find(mark).unwrap()].matches('\n').count();
            let message = read(&text).unwrap_err().to_string();
            for part in expected
                .into_iter()
                .chain([format!("(a.toml, line {line})").as_str()])
            {
                assert!(message.contains(part), "{part} is not in: {message}");
            }
        }
    }
}
