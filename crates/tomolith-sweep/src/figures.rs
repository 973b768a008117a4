//! Pictures of a study over several of its runs: histograms of their reports, or numbers of their slices, side by side.

use crate::plan::SweepPlan;
use crate::study::{Study, StudySpec};
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use tomolith::io::write_text;
use tomolith::report::json::read as read_report;
use tomolith::report::maps::histograms::{HistogramPanel, histograms};
use tomolith::report::maps::profiles::{ProfilePanel, profiles};
use tomolith::{Error, Result};

/// Tables of a report that hold a range and counts per bin.
const HISTOGRAMS: [&str; 4] = [
    "evaluation.errors",
    "evaluation.histogram",
    "optimization.errors",
    "optimization.histogram",
];
/// Keys of such a table that are no counts.
const NO_COUNTS: [&str; 2] = ["range", "band"];

/// Numbers that a report has of every slice, on the voxels of the print.
const OF_SLICES: [&str; 5] = ["pw", "ipdr", "ver", "pw_trimmed", "ipdr_trimmed"];

/// Curves that a panel tells apart.
const COLORS: usize = 4;

/// Histograms or slices of several runs, side by side.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FigureSpec {
    /// Its file among the results, without `.svg`.
    pub(crate) name: String,
    /// What stands above it.
    pub(crate) title: String,
    /// What stands below it.
    #[serde(default)]
    pub(crate) caption: String,
    /// The histogram of each run's report.
    pub(crate) histogram: Option<String>,
    /// Or numbers of its slices, as curves over z.
    #[serde(default)]
    pub(crate) slices: Vec<String>,
    /// Whose, from left to right.
    pub(crate) panels: Vec<PanelSpec>,
}

/// The run of a job, or all runs of a sweep.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PanelSpec {
    /// A name of `runs`.
    pub(crate) of: String,
    /// What stands above a job's; those of a sweep have their values.
    pub(crate) name: Option<String>,
}

/// Refuses figures of what no report has, of no run, and of one file.
pub(crate) fn check(spec: &StudySpec) -> Result<()> {
    for (i, figure) in spec.figures.iter().enumerate() {
        let refuse = |key: &str, found: String, accepted: &str| {
            Err(Error::config(
                format!("figures[{i}].{key}"),
                found,
                accepted,
            ))
        };
        let is_plain = |c: char| c.is_alphanumeric() || "_-".contains(c);
        let is_taken = spec.figures[..i].iter().any(|f| f.name == figure.name);
        if figure.name.is_empty() || !figure.name.chars().all(is_plain) || is_taken {
            let accepted =
                "letters, digits, `_` and `-`, each name once: it is the name of its file";
            return refuse("name", format!("found {:?}", figure.name), accepted);
        }
        let histogram = figure.histogram.as_deref();
        if histogram.is_some() != figure.slices.is_empty() {
            let found = match histogram {
                Some(_) => "together with slices".to_owned(),
                None => "neither it nor slices".to_owned(),
            };
            return refuse("histogram", found, "either a histogram or slices");
        }
        if let Some(path) = histogram.filter(|path| !HISTOGRAMS.contains(path)) {
            let found = format!("`{path}` is no histogram of report.json");
            return refuse("histogram", found, &HISTOGRAMS.join(", "));
        }
        if figure.slices.len() > COLORS {
            let found = format!("{} numbers", figure.slices.len());
            return refuse("slices", found, "at most four: each has a color");
        }
        let is_unknown = |name: &&String| !OF_SLICES.contains(&name.as_str());
        if let Some(name) = figure.slices.iter().find(is_unknown) {
            let found = format!("`{name}` is no number of a slice");
            return refuse("slices", found, &OF_SLICES.join(", "));
        }
        if figure.panels.is_empty() {
            let accepted = "at least one { of = \"NAME\" }";
            return refuse("panels", "an empty list".to_owned(), accepted);
        }
        for (k, panel) in figure.panels.iter().enumerate() {
            let run = spec.runs.get(&panel.of);
            if run.is_none_or(|run| run.command.is_some()) {
                let found = format!("`{}` is no sweep or job of this study", panel.of);
                return refuse(&format!("panels[{k}].of"), found, &jobs(spec));
            }
            if panel.name.is_some() && run.is_some_and(|run| run.sweep.is_some()) {
                let found = format!("a name for all runs of the sweep `{}`", panel.of);
                let accepted = "no name: each run of a sweep has its values";
                return refuse(&format!("panels[{k}].name"), found, accepted);
            }
        }
    }
    Ok(())
}

fn jobs(spec: &StudySpec) -> String {
    let jobs = spec.runs.iter().filter(|(_, run)| run.command.is_none());
    let names: Vec<&str> = jobs.map(|(name, _)| name.as_str()).collect();
    names.join(", ")
}

/// Draws all figures; one without any panel is left out.
pub(crate) fn write(
    study: &Study,
    plans: &BTreeMap<&str, &SweepPlan>,
    output: &Path,
) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for figure in &study.spec.figures {
        let reports = || {
            let reports_of = |panel: &PanelSpec| of_run(panel, plans.get(panel.of.as_str()));
            figure.panels.iter().flat_map(reports_of)
        };
        let svg = match &figure.histogram {
            Some(path) => of_histograms(figure, path, reports()),
            None => of_slices(figure, reports()),
        };
        let Some(svg) = svg else { continue };
        let file = output.join(format!("{}.svg", figure.name));
        write_text(&file, &svg)?;
        files.push(file);
    }
    Ok(files)
}

/// What stands above a panel, and the report of its run.
type Titled = (String, Value);

fn of_histograms(
    figure: &FigureSpec,
    path: &str,
    reports: impl Iterator<Item = Titled>,
) -> Option<String> {
    let (panels, missing) = panels(reports, |title, report| histogram(report, path, title));
    let x = match path.ends_with("errors") {
        true => "response − gray value",
        false => "response",
    };
    let caption = caption(figure, "a histogram", &missing);
    (!panels.is_empty()).then(|| histograms(&figure.title, x, &panels, &caption))
}

fn of_slices(figure: &FigureSpec, reports: impl Iterator<Item = Titled>) -> Option<String> {
    let (panels, missing) = panels(reports, |title, report| {
        slices(report, &figure.slices, title)
    });
    let caption = caption(figure, "slices", &missing);
    let names = ["z, mm", "value"];
    (!panels.is_empty()).then(|| profiles(&figure.title, names, &panels, &caption))
}

/// Panels, and the titles of reports that have none.
fn panels<P>(
    reports: impl Iterator<Item = Titled>,
    panel_of: impl Fn(&str, &Value) -> Option<P>,
) -> (Vec<P>, Vec<String>) {
    let (mut panels, mut missing) = (Vec::new(), Vec::new());
    for (title, report) in reports {
        match panel_of(&title, &report) {
            Some(panel) => panels.push(panel),
            None => missing.push(title),
        }
    }
    (panels, missing)
}

fn caption(figure: &FigureSpec, what: &str, missing: &[String]) -> String {
    let text = figure.caption.trim();
    let missing = match missing {
        [] => String::new(),
        all => format!(" Without {what}: {}.", all.join(", ")),
    };
    format!("{text}{missing}").trim().to_owned()
}

/// The reports of a panel's runs, in the order of the sweep.
fn of_run(panel: &PanelSpec, plan: Option<&&SweepPlan>) -> Vec<Titled> {
    let panel_name = || panel.name.clone().unwrap_or_else(|| panel.of.clone());
    let Some(plan) = plan else {
        return vec![(panel_name(), Value::Null)];
    };
    let of_index = |i: usize| {
        let title = match plan.words(i) {
            words if words.is_empty() => panel_name(),
            words => words,
        };
        (title, read_report(&plan.run_folder(i)).unwrap_or_default())
    };
    (0..plan.runs.len()).map(of_index).collect()
}

/// Numbers of a report's slices as curves; slices without part or void have none.
fn slices(report: &Value, names: &[String], title: &str) -> Option<ProfilePanel> {
    let slices = report["published"]["slices"].as_array()?;
    let curve = |name: &String| {
        let point = |slice: &Value| Some([slice["z_mm"].as_f64()?, slice[name].as_f64()?]);
        (name.clone(), slices.iter().filter_map(point).collect())
    };
    Some(ProfilePanel {
        title: title.to_owned(),
        series: names.iter().map(curve).collect(),
    })
}

/// A table of a report as a histogram.
fn histogram(report: &Value, path: &str, title: &str) -> Option<HistogramPanel> {
    let (section, name) = path.split_once('.')?;
    let table = report[section][name].as_object()?;
    let numbers = |value: &Value| {
        let list = value.as_array()?.iter().map(Value::as_f64);
        list.collect::<Option<Vec<f64>>>()
    };
    let pair = |key: &str| <[f64; 2]>::try_from(numbers(table.get(key)?)?).ok();
    let counts = table
        .iter()
        .filter(|(key, _)| !NO_COUNTS.contains(&key.as_str()));
    let counts = counts.filter_map(|(key, value)| Some((key.clone(), numbers(value)?)));
    Some(HistogramPanel {
        title: title.to_owned(),
        range: pair("range")?,
        band: pair("band"),
        series: counts.collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_counts_are_series_and_the_band_is_shaded() {
        let errors = serde_json::json!({ "range": [-1.0, 1.0], "band": [-0.1, 0.1], "part": [1, 2], "void": [3, 4], "band_edge_peak": 1.5 });
        let report = serde_json::json!({ "optimization": { "errors": errors, "histogram": null } });
        let found = histogram(&report, "optimization.errors", "a").unwrap();
        assert_eq!((found.range, found.band), ([-1.0, 1.0], Some([-0.1, 0.1])));
        let series = [("part", [1.0, 2.0]), ("void", [3.0, 4.0])];
        let series = series.map(|(name, counts)| (name.to_owned(), counts.to_vec()));
        assert_eq!(found.series, series);
        assert!(histogram(&report, "optimization.histogram", "a").is_none());
        assert!(histogram(&report, "evaluation.errors", "a").is_none());
    }

    #[test]
    fn slices_are_curves_over_their_heights() {
        let slice = |z: f64, pw: Option<f64>| serde_json::json!({ "z_mm": z, "pw": pw });
        let slices_of = [
            slice(-0.1, Some(0.2)),
            slice(0.0, None),
            slice(0.1, Some(0.3)),
        ];
        let report = serde_json::json!({ "published": { "slices": slices_of } });
        let found = slices(&report, &["pw".to_owned()], "a").unwrap();
        assert_eq!(
            found.series,
            [("pw".to_owned(), vec![[-0.1, 0.2], [0.1, 0.3]])]
        );
        assert!(slices(&Value::Null, &[], "a").is_none());
    }
}
