//! A job file, from its text to the files of its run.
//!
//! | layer | what it does |
//! |---|---|
//! | [`spec`] | what the file says: text that knows its lines, typed tables, ranges, schema, other programs' jobs |
//! | [`resolve`] | tables and files → objects that fit together: optics, shape, voxels, species, scenarios, machine, method |
//! | [`dose`] | doses of patterns: models on given voxels, patterns as the machine shows them, processes that share frames |
//! | [`optimize`] | the search for patterns: levels of resolution, start, ceiling of the pixels, checkpoints |
//! | [`evaluate`] | what patterns print: measured, in time, per species and scenario, and what limits it |
//! | [`output`] | the run folder: its files, the summary, patterns for another machine |
//! | [`run`](mod@run) | run, simulate, check: the layers in their order |
//!
//! A file imports from its own layer and from those above it in this table. [`progress`] is what all of them tell the caller.

pub mod dose;
pub mod evaluate;
pub mod optimize;
pub mod output;
pub mod progress;
pub mod resolve;
pub mod run;
pub mod spec;

pub use evaluate::trace;
pub use output::{export, folder, summary};
pub use resolve::resources;
pub use spec::{document, import, kinds, profiles, read, reference_page, schema, validate};

pub use document::Document;
pub use dose::cache::RunCache;
pub use evaluate::in_time::TimeSummary;
pub use evaluate::prediction::Prediction;
pub use folder::RunFolder;
pub use import::{ImportFiles, Imported, import, sinogram};
pub use optimize::task::Task;
pub use output::folder::Leaves;
pub use output::summary::{Plan, Quality, Summary};
pub use progress::{Event, Progress, Silent, Snapshot, SpeciesTarget, Wants};
pub use read::Job;
pub use resolve::ResolvedJob;
pub use run::many::{JobRequirements, requirements, run_here};
pub use run::ranks::run_among;
pub use run::{check, picture, run, run_leaving, simulate};
pub use spec::*;

#[cfg(test)]
pub(crate) mod tests {
    use super::resolve::optics::Optics;
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

    /// A document of this text, with these keys set otherwise.
    pub(crate) fn document_of(text: &str, changes: &[&str]) -> Document {
        let mut document = Document::toml("a.toml", text).unwrap();
        for change in changes {
            document.set(change).unwrap();
        }
        document
    }

    /// A job of this text, with these keys set otherwise.
    pub(crate) fn job_of(text: &str, changes: &[&str]) -> Job {
        let changes: Vec<String> = changes.iter().map(|&change| change.to_owned()).collect();
        Job::changed(Document::toml("job.toml", text).unwrap(), &changes).unwrap()
    }

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
            (None, None, 10.0)
        );
        assert_eq!(spec.grid.region, Region::Cylinder);
    }

    #[test]
    fn a_resolved_job_reads_back_as_itself() {
        let text = read(FULL).unwrap().to_toml().unwrap();
        assert!(text.contains("bit_depth = 8"), "{text}");
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
}
