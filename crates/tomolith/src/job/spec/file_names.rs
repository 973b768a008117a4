//! Files of a run that are named after something in the job: no two of them may be the same file.
//!
//! Case does not tell names apart, because it does not on every system.

use crate::error::{Error, Result};
use crate::exposure::movie_name;
use crate::job::spec::{JobSpec, MovieCoding};
use crate::text::file_name;

/// Name of the file that says how frames and movies are to be shown.
pub(crate) const EXPOSURE: &str = "exposure.json";

/// What a run may leave in addition to what is named after something in the job.
pub(crate) const OUTPUTS: &[&str] = &[
    "patterns.npz",
    "frames",
    "frames.npz",
    "dose.npy",
    "dose.vti",
    "evaluation",
    "volumes",
    "print.stl",
    "print.ply",
    "history.csv",
    "report.html",
    EXPOSURE,
    "time.csv",
    "cure_time.npy",
];

/// Beginnings and ends of what is named after a part, a light, a species or a network.
pub(crate) const OUTPUTS_NAMED: &[(&str, &str)] = &[
    ("", ".mp4"),
    ("", ".mov"),
    ("dose_", ".npy"),
    ("cure_time_", ".npy"),
    ("time_", ".csv"),
];

/// A file, and what it is named after: the key, and the name there.
type Named = (String, String, String);

/// The end of the name of a network's files, where there are several networks.
pub(crate) fn of_network(name: &str) -> String {
    format!("_{}", file_name(name, '_'))
}

/// Refuses a name whose file another name, or every run, has.
pub(crate) fn must_differ(spec: &JobSpec) -> Result<()> {
    let of_every_run = OUTPUTS
        .iter()
        .map(|&file| (file.to_owned(), "every run".to_owned()));
    let of_every_run = of_every_run.chain(volumes(spec));
    let mut taken: Vec<(String, String)> = of_every_run.chain(movies(spec)).collect();
    for (file, key, name) in named(spec) {
        let is_same = |(other, _): &&(String, String)| other.eq_ignore_ascii_case(&file);
        let Some((_, owner)) = taken.iter().find(is_same) else {
            taken.push((file, key));
            continue;
        };
        let (before, after) = file.split_once(name.as_str()).unwrap_or(("", ""));
        let of_this_kind = |(other, _): &(String, String)| {
            let rest = other.strip_prefix(before)?.strip_suffix(after)?;
            Some(rest.to_owned())
        };
        let names: Vec<String> = taken.iter().filter_map(of_this_kind).collect();
        return Err(Error::config(
            key,
            format!("found {name:?}: `{file}` is a file of {owner}"),
            format!("another name; taken: {}", names.join(", ")),
        ));
    }
    Ok(())
}

/// Names of the lights for files: none when there is only one.
pub(crate) fn of_lights(spec: &JobSpec) -> Vec<Option<&str>> {
    let several = spec.light.len() > 1;
    spec.light
        .iter()
        .map(|light| light.name.as_deref().filter(|_| several))
        .collect()
}

/// Names that `volumes/` takes besides those of arrays in the run folder.
fn volumes(spec: &JobSpec) -> impl Iterator<Item = (String, String)> {
    let names = ["target.npy", "label.npy"].into_iter();
    let names = names.filter(|_| !spec.output.volumes.is_empty());
    names.map(|name| (name.to_owned(), "output.volumes".to_owned()))
}

/// The movie of every light, in the format that the movies of networks have.
fn movies(spec: &JobSpec) -> Vec<(String, String)> {
    if spec.output.movie != MovieCoding::H264 {
        return Vec::new();
    }
    let file = |light| movie_name(&spec.target.name(), light, spec.output.rpm, "mp4");
    let of_light = |light| (file(light), "the movie of the patterns".to_owned());
    let lights = of_lights(spec).into_iter().enumerate();
    let lights = lights.filter(|(i, _)| spec.channel_of(*i).is_none());
    lights.map(|(_, light)| of_light(light)).collect()
}

/// The files of properties, species and networks.
fn named(spec: &JobSpec) -> Vec<Named> {
    let species = spec.species.iter().enumerate().skip(1).map(|(s, species)| {
        let file = format!("dose_{}.npy", species.name);
        (file, format!("species[{s}].name"), species.name.clone())
    });
    let networks = spec.networks();
    let several = networks.iter().enumerate().filter(|_| networks.len() > 1);
    let networks = several.flat_map(|(n, network)| {
        let end = of_network(&network.name);
        let key = format!("material.photopolymer.networks[{n}].name");
        [format!("cure_time{end}.npy"), format!("print{end}.mp4")]
            .map(|file| (file, key.clone(), end[1..].to_owned()))
    });
    let properties = spec.property.iter().enumerate().map(|(i, property)| {
        let key = format!("property[{i}].name");
        (format!("{}.npy", property.name), key, property.name.clone())
    });
    species.chain(networks).chain(properties).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::tests::{FULL, document_of};

    fn refusal(changes: &[&str]) -> Result<(), String> {
        let spec = JobSpec::from_document(&document_of(FULL, changes)).unwrap();
        must_differ(&spec).map_err(|error| error.to_string())
    }

    #[test]
    fn no_name_takes_the_file_of_another() {
        let property = |name: &str| format!("{{ name = \"{name}\", map = {{ logistic = {{}} }} }}");
        let properties = |names: &[&str]| {
            let tables: Vec<String> = names.iter().map(|name| property(name)).collect();
            format!("property=[{}]", tables.join(", "))
        };
        refusal(&[&properties(&["modulus", "index", "dose_b"])]).unwrap();
        for (names, key, found) in [
            (&["modulus", "dose"][..], "property[1].name", "`dose.npy`"),
            (&["cure_time"], "property[0].name", "`cure_time.npy`"),
            (&["modulus", "Modulus"], "property[1].name", "property[0]"),
        ] {
            let error = refusal(&[&properties(names)]).unwrap_err();
            assert!(error.contains(key) && error.contains(found), "{error}");
            assert!(error.contains("taken: dose, cure_time"), "{error}");
        }
        let label = properties(&["label"]);
        refusal(&[&label]).unwrap();
        let error = refusal(&[&label, "output.volumes=[\"nrrd\"]"]).unwrap_err();
        tomolith_core::contains!(error, "`label.npy` is a file of output.volumes");
        let species = "species=[{ name = \"a\" }, { name = \"b\" }]";
        let error = refusal(&[species, &properties(&["dose_b"])]).unwrap_err();
        tomolith_core::contains!(error, "`dose_b.npy` is a file of species[1].name");
        assert!(error.contains("taken: dose, cure_time, dose_b"), "{error}");
    }

    #[test]
    fn networks_whose_files_become_one_are_refused() {
        let network = |name: &str| {
            format!(
                "{{ name = \"{name}\", curing = {{ threshold = {{ critical_dose_mj_per_mm3 = 0.5 }} }} }}"
            )
        };
        let refusal = |names: [&str; 2], part: &str| {
            let [a, b] = names.map(network);
            let change = format!("material={{ photopolymer = {{ networks = [{a}, {b}] }} }}");
            refusal(&[&format!("target.name={part:?}"), &change])
        };
        refusal(["soft", "10rpm"], "gear").unwrap();
        let error = refusal(["soft", "10rpm"], "print").unwrap_err();
        tomolith_core::contains!(
            error,
            "`print_10rpm.mp4` is a file of the movie of the patterns",
            "networks[1].name"
        );
        let error = refusal(["a b", "a/b"], "gear").unwrap_err();
        tomolith_core::contains!(error, "networks[1].name", "taken: a_b");
    }
}
