//! Several runs on one page: numbers side by side, histograms and IoU over the threshold laid over each other, loss against
//! model calls and seconds, and which keys of the jobs differ.
//!
//! A run is read from its folder: `report.json`, `history.csv` and `job.toml`. Nothing is computed again, so that runs of
//! other machines and other days can be compared. The page is one file without any outside resource.

use super::figures;
use super::number::{escape, significant};
use super::plot::{Axis, Plot};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_io::npy::read_volume;
use tomolith_io::write_whole;
use tomolith_metrics::{Better, METRICS};

/// Runs on one page, at most: lines of more cannot be told apart.
const MOST: usize = 12;
/// Colors; later runs have them again, dashed.
const COLORS: usize = 6;
/// What a folder must hold.
const ACCEPTED: &str = "the folder of a run of Tomolith, with report.json";

/// A run to be compared.
#[derive(Clone, Debug)]
pub struct ComparedRun {
    /// Its name on the page.
    pub name: String,
    /// `report.json`.
    pub report: Value,
    /// `job.toml`, flat: key path → value.
    pub job: BTreeMap<String, String>,
    /// `dose.npy`, on the job's voxels; None where the folder has none.
    pub dose: Option<Volume<f32>>,
    /// `history.csv`: column → numbers, not a number where there is none; empty for a simulation.
    pub history: BTreeMap<String, Vec<f64>>,
}

impl ComparedRun {
    /// Reads a run folder.
    ///
    /// # Errors
    /// [`Error::Format`] when it is no folder of a run; [`Error::Io`] when its report cannot be read.
    pub fn read(folder: &Path) -> Result<Self> {
        let path = folder.join("report.json");
        let refused = |path: &Path, found: String| Error::Format {
            path: path.to_owned(),
            found,
            accepted: ACCEPTED.to_owned(),
        };
        if let Some(found) = is_no_run(folder) {
            return Err(refused(folder, found.to_owned()));
        }
        let text = std::fs::read_to_string(&path).map_err(|e| Error::io(&path, e))?;
        let bad = |found: String| refused(&path, found);
        let report: Value = serde_json::from_str(&text).map_err(|e| bad(e.to_string()))?;
        if report["schema"] != "tomolith.report/1" {
            return Err(bad(format!("schema {}", report["schema"])));
        }
        let job = std::fs::read_to_string(folder.join("job.toml")).unwrap_or_default();
        let job: Value = toml::from_str(&job).unwrap_or_default();
        let mut flat = BTreeMap::new();
        flatten("", &job, &mut flat);
        flat.remove("output.folder");
        let history = std::fs::read_to_string(folder.join("history.csv")).unwrap_or_default();
        let name = folder.file_name().map_or_else(
            || folder.display().to_string(),
            |name| name.to_string_lossy().into_owned(),
        );
        let dose = dose_of(&folder.join("dose.npy"), &report)?;
        Ok(ComparedRun {
            name,
            report,
            dose,
            job: flat,
            history: columns(&history),
        })
    }

    fn number(&self, pointer: &str) -> Option<f64> {
        self.report.pointer(pointer)?.as_f64()
    }

    fn points(&self, x: impl Fn(usize) -> Option<f64>, column: &str) -> Vec<[f64; 2]> {
        let Some(values) = self.history.get(column) else {
            return Vec::new();
        };
        let point =
            |(i, &y): (usize, &f64)| Some([x(i)?, y]).filter(|p| p.iter().all(|v| v.is_finite()));
        values.iter().enumerate().filter_map(point).collect()
    }

    /// Model calls after row `i` of the history.
    fn calls(&self, i: usize) -> Option<f64> {
        let at = |name: &str| self.history.get(name)?.get(i).copied();
        Some(at("forward_calls")? + at("adjoint_calls")?)
    }

    fn seconds(&self, i: usize) -> Option<f64> {
        self.history.get("seconds")?.get(i).copied()
    }
}

/// Why a path is not the folder of a run; None when it holds a report.
fn is_no_run(folder: &Path) -> Option<&'static str> {
    if !folder.exists() {
        Some("there is no such folder")
    } else if !folder.is_dir() {
        Some("a file, not a folder")
    } else if !folder.join("report.json").is_file() {
        Some("no report.json in it, so no run has ended here")
    } else {
        None
    }
}

fn flatten(path: &str, value: &Value, flat: &mut BTreeMap<String, String>) {
    let below = |key: &str| {
        if path.is_empty() {
            key.to_owned()
        } else {
            format!("{path}.{key}")
        }
    };
    match value {
        Value::Object(map) if !map.is_empty() => map
            .iter()
            .for_each(|(key, value)| flatten(&below(key), value, flat)),
        Value::Array(list) if list.iter().any(Value::is_object) => {
            for (i, value) in list.iter().enumerate() {
                flatten(&format!("{path}[{i}]"), value, flat);
            }
        }
        Value::Null => {}
        Value::Object(_) => drop(flat.insert(path.to_owned(), "(defaults)".to_owned())),
        Value::String(text) => drop(flat.insert(path.to_owned(), text.clone())),
        other => drop(flat.insert(path.to_owned(), other.to_string())),
    }
}

/// Columns of a table with a header; a cell that cannot be read as a number becomes NaN.
fn columns(text: &str) -> BTreeMap<String, Vec<f64>> {
    let mut lines = text.lines();
    let names: Vec<&str> = lines
        .next()
        .unwrap_or_default()
        .split(',')
        .filter(|name| !name.is_empty())
        .collect();
    let mut table: BTreeMap<String, Vec<f64>> = names
        .iter()
        .map(|name| ((*name).to_owned(), Vec::new()))
        .collect();
    for line in lines {
        for (name, cell) in names.iter().zip(line.split(',')) {
            if let Some(column) = table.get_mut(*name) {
                column.push(cell.parse().unwrap_or(f64::NAN));
            }
        }
    }
    table
}

/// Reads run folders; folders of the same name are called by their whole path.
///
/// # Errors
/// As [`ComparedRun::read`]; [`Error::Config`] when there are none or too many.
pub fn read_runs(folders: &[impl AsRef<Path>]) -> Result<Vec<ComparedRun>> {
    if folders.is_empty() || folders.len() > MOST {
        return Err(Error::config(
            "RUN",
            format!("{} runs", folders.len()),
            format!("1 to {MOST} run folders"),
        ));
    }
    let mut runs = folders
        .iter()
        .map(|folder| ComparedRun::read(folder.as_ref()))
        .collect::<Result<Vec<_>>>()?;
    let names: Vec<String> = runs.iter().map(|run| run.name.clone()).collect();
    for (i, run) in runs.iter_mut().enumerate() {
        if names.iter().filter(|name| **name == run.name).count() > 1 {
            run.name = folders[i].as_ref().display().to_string();
        }
    }
    Ok(runs)
}

/// Every number of every run, as `tomolith compare --json` prints it.
#[must_use]
pub fn compare_json(runs: &[ComparedRun]) -> Value {
    let rows: Vec<Value> = rows(runs)
        .iter()
        .map(|row| json!({ "key": row.key, "name": row.name, "unit": row.unit, "values": runs.iter().map(|run| (row.value)(run)).collect::<Vec<_>>() }))
        .collect();
    let differing: Vec<Value> = differing(runs)
        .into_iter()
        .map(|(key, values)| json!({ "key": key, "values": values }))
        .collect();
    json!({
        "schema": "tomolith.compare/1",
        "runs": runs.iter().map(|run| &run.name).collect::<Vec<_>>(),
        "numbers": rows,
        "differing_keys": differing,
    })
}

/// Writes the page.
///
/// # Errors
/// [`Error::Io`].
pub fn write_compare(path: &Path, runs: &[ComparedRun]) -> Result<()> {
    let page = compare_html(runs);
    write_whole(path, |file| Ok(file.write_all(page.as_bytes())?))
}

/// The page.
#[must_use]
pub fn compare_html(runs: &[ComparedRun]) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{} runs · Tomolith</title>\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>{}{}</style></head><body>",
        runs.len(),
        include_str!("style.css"),
        include_str!("compare.css")
    );
    let _ = write!(page, "{}<main>", head(runs));
    let plots = [
        (
            "Loss against model calls",
            "Dose and adjoint calls. Compare methods by model calls, not by iterations.",
            history(runs, "loss", ComparedRun::calls, "model calls"),
        ),
        (
            "Loss against time",
            "On the machine of each run.",
            history(runs, "loss", ComparedRun::seconds, "seconds"),
        ),
        (
            "Dose of part and void",
            "Share of the voxels per unit of the response; part in full lines, void in dotted ones.",
            histograms(runs),
        ),
        (
            "IoU over the gel threshold",
            "A broad plateau tolerates errors of exposure.",
            curves(runs),
        ),
        (
            "IoU against model calls",
            "On the grid of each optimization, where it was measured.",
            history(runs, "iou", ComparedRun::calls, "model calls"),
        ),
        (
            "IoU against time",
            "The same, on the machine of each run.",
            history(runs, "iou", ComparedRun::seconds, "seconds"),
        ),
    ];
    page.push_str(&warnings(runs));
    page.push_str(&numbers(runs));
    page.push_str(&pictures(runs));
    page.push_str("<div class=\"two\">");
    for (title, note, plot) in plots {
        let plot =
            plot.unwrap_or_else(|| "<p class=\"note\">No run holds these numbers.</p>".to_owned());
        let _ = write!(
            page,
            "<section><h2>{title}</h2><p class=\"muted\">{note}</p>{}{plot}</section>",
            key(runs)
        );
    }
    page.push_str("</div>");
    page.push_str(&keys(runs));
    page.push_str(
        "</main><footer>Tomolith · Numbers are predictions of a model, not measurements. Doses are relative unless the job says otherwise.\
         </footer></body></html>\n",
    );
    page
}

/// The dose of a run on its job's voxels, which lie in the box of those that it was judged on.
///
/// # Errors
/// As [`read_volume`].
fn dose_of(path: &Path, report: &Value) -> Result<Option<Volume<f32>>> {
    if !path.exists() {
        return Ok(None);
    }
    let (shape, values) = read_volume(path)?;
    let number = |pointer: &str| report.pointer(pointer).and_then(Value::as_f64);
    let (Some(fine), Some(pitch)) = (
        number("/evaluation/grid/shape_zyx/2"),
        number("/evaluation/grid/pitch_mm"),
    ) else {
        return Ok(None);
    };
    let center = |axis: usize| number(&format!("/evaluation/grid/center_xyz_mm/{axis}"));
    let grid = VolumeGrid {
        shape,
        pitch_mm: pitch * fine / shape[2].max(1) as f64,
        height_mm: pitch * fine / shape[2].max(1) as f64,
        center_mm: std::array::from_fn(|axis| center(axis).unwrap_or(0.0)),
    };
    Ok((!grid.is_empty()).then_some(Volume { grid, values }))
}

/// Doses beside each other.
fn pictures(runs: &[ComparedRun]) -> String {
    let doses: Vec<(&str, &Volume<f32>)> = runs
        .iter()
        .filter_map(|run| Some((run.name.as_str(), run.dose.as_ref()?)))
        .collect();
    let [(first, dose), others @ ..] = &doses[..] else {
        return String::new();
    };
    if others.is_empty() {
        return String::new();
    }
    let (alike, unlike): (Vec<_>, Vec<_>) =
        (others.iter()).partition(|(_, other)| other.grid == dose.grid);
    let names = |runs: &[&(&str, &Volume<f32>)]| {
        let names: Vec<String> = runs.iter().map(|(name, _)| escape(name)).collect();
        names.join(", ")
    };
    let mut notes = String::new();
    if !alike.is_empty() {
        let _ = write!(
            notes,
            " Below, where the dose of {} is higher (red) or lower (blue) than that of {}: gray up to 5 % of the largest dose, full color from 20 %.",
            names(&alike),
            escape(first)
        );
    }
    if !unlike.is_empty() {
        let _ = write!(
            notes,
            " No difference is drawn for {}: its voxels differ from those of {}.",
            names(&unlike),
            escape(first)
        );
    }
    format!(
        "<section><h2>Doses</h2><p class=\"muted\">Written patterns, vial turning, on each job's voxels and one scale.{notes}</p>{}</section>",
        figures::doses(&doses)
    )
}

fn head(runs: &[ComparedRun]) -> String {
    let parts: BTreeSet<&str> = runs
        .iter()
        .filter_map(|run| run.report["part"].as_str())
        .collect();
    let parts: Vec<String> = parts.into_iter().map(escape).collect();
    format!(
        "<header><div class=\"brand\">Tomolith comparison</div><h1>{} runs</h1><p class=\"lead\">Part: {}</p></header>",
        runs.len(),
        parts.join(", ")
    )
}

/// Color class of a run.
fn class(i: usize) -> String {
    format!(
        "run{}{}",
        i % COLORS,
        if i < COLORS { "" } else { " again" }
    )
}

fn key(runs: &[ComparedRun]) -> String {
    let one = |(i, run): (usize, &ComparedRun)| {
        format!(
            "<span><svg viewBox=\"0 0 22 8\" aria-hidden=\"true\"><path class=\"s-{}\" d=\"M1 4H21\"/></svg>{}</span>",
            class(i),
            escape(&run.name)
        )
    };
    format!(
        "<div class=\"runs\">{}</div>",
        runs.iter().enumerate().map(one).collect::<String>()
    )
}

/// Why numbers of runs may not be comparable.
fn warnings(runs: &[ComparedRun]) -> String {
    let differ = |what: &dyn Fn(&ComparedRun) -> String| {
        runs.iter().map(what).collect::<BTreeSet<_>>().len() > 1
    };
    let mut said = Vec::new();
    if differ(&|run| run.report["part"].to_string()) {
        said.push("The runs print parts of different names.".to_owned());
    }
    if differ(&|run| run.report["evaluation"]["grid"].to_string()) {
        said.push("The runs were evaluated on different voxels: distances and error rates depend on them.".to_owned());
    }
    for run in runs.iter().filter(|run| !prints(run)) {
        said.push(format!(
            "Nothing of the part turns solid in {}: none of its numbers is marked as the best.",
            escape(&run.name)
        ));
    }
    if differ(&|run| run.job.get("objective").cloned().unwrap_or_default() + &objective(run)) {
        said.push(
            "The runs minimize different losses, whose numbers cannot be compared.".to_owned(),
        );
    }
    if runs
        .iter()
        .any(|run| run.report["evaluation"]["iou_curve"].is_null())
    {
        said.push("Reports of earlier versions hold no curves: run `tomolith simulate` on their patterns to get them.".to_owned());
    }
    if said.is_empty() {
        return String::new();
    }
    let items: String = said.iter().map(|text| format!("<li>{text}</li>")).collect();
    format!("<section class=\"warn\"><h2>Please note</h2><ul>{items}</ul></section>")
}

/// The keys of a run that say what is minimized.
fn objective(run: &ComparedRun) -> String {
    let keys = run
        .job
        .iter()
        .filter(|(key, _)| key.starts_with("objective"));
    keys.map(|(key, value)| format!("{key}={value};")).collect()
}

/// Reads a number of a run, where it has one.
type ValueOf = Box<dyn Fn(&ComparedRun) -> Option<f64>>;

/// A row of numbers.
struct Row {
    /// What programs call it, the same in every version.
    key: String,
    name: String,
    unit: &'static str,
    better: Better,
    value: ValueOf,
}

/// Every number that the page lists.
fn rows(runs: &[ComparedRun]) -> Vec<Row> {
    let pointer = |key: &str, name: &str, unit, better, pointer: &'static str| Row {
        key: key.to_owned(),
        name: name.to_owned(),
        unit,
        better,
        value: Box::new(move |run| run.number(pointer)),
    };
    let mut rows: Vec<Row> = METRICS
        .iter()
        .map(|kind| {
            let place = format!("/evaluation/{}", kind.name);
            Row {
                key: kind.name.to_owned(),
                name: kind.title.to_owned(),
                unit: kind.unit,
                better: kind.better,
                value: Box::new(move |run| run.number(&place)),
            }
        })
        .collect();
    let last = |column: &'static str| {
        move |run: &ComparedRun| {
            run.history
                .get(column)?
                .iter()
                .rev()
                .copied()
                .find(|v| v.is_finite())
        }
    };
    rows.extend([
        pointer(
            "evaluation_pitch_mm",
            "Edge of the evaluation's voxels",
            "mm",
            Better::Neutral,
            "/evaluation/grid/pitch_mm",
        ),
        pointer(
            "loss",
            "Loss, at the end",
            "",
            Better::Neutral,
            "/history/loss",
        ),
        pointer(
            "iterations",
            "Iterations",
            "",
            Better::Neutral,
            "/history/iterations",
        ),
        Row {
            key: "model_calls".to_owned(),
            name: "Model calls".to_owned(),
            unit: "",
            better: Better::Lower,
            value: Box::new(|run| {
                run.calls(run.history.get("forward_calls")?.len().checked_sub(1)?)
            }),
        },
        Row {
            key: "optimization_s".to_owned(),
            name: "Time of the optimization".to_owned(),
            unit: "s",
            better: Better::Lower,
            value: Box::new(last("seconds")),
        },
        pointer(
            "time_to_print_s",
            "Time to print",
            "s",
            Better::Lower,
            "/lights/0/budget/time_s",
        ),
        pointer(
            "energy_per_turn_mj",
            "Energy per turn",
            "mJ",
            Better::Neutral,
            "/lights/0/budget/energy_per_turn_mj",
        ),
        pointer(
            "light_used",
            "Share of the light that is used",
            "",
            Better::Higher,
            "/lights/0/budget/light_used",
        ),
        pointer(
            "best_jaccard",
            "IoU of the print in time, at its best",
            "",
            Better::Higher,
            "/time/0/best_jaccard",
        ),
        pointer(
            "best_s",
            "The best moment of the print in time",
            "s",
            Better::Neutral,
            "/time/0/best_s",
        ),
        Row {
            key: "window_s".to_owned(),
            name: "How long the print in time stays within 0.01 of its best IoU".to_owned(),
            unit: "s",
            better: Better::Higher,
            value: Box::new(|run| {
                let end = |i: usize| run.number(&format!("/time/0/window_s/{i}"));
                Some(end(1)? - end(0)?)
            }),
        },
        pointer(
            "worst_iou",
            "The least IoU over scenarios, at the job's threshold",
            "",
            Better::Higher,
            "/scenarios/worst_iou",
        ),
        pointer(
            "scenarios_pw",
            "Window over scenarios, trimmed",
            "",
            Better::Higher,
            "/scenarios/window",
        ),
    ]);
    rows.extend(scenarios(runs).into_iter().map(of_scenario));
    rows
}

/// The scenarios of all runs, each name once.
fn scenarios(runs: &[ComparedRun]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let rows = |run: &ComparedRun| run.report.pointer("/scenarios/rows")?.as_array().cloned();
    for row in runs.iter().filter_map(rows).flatten() {
        let name = row["name"].as_str().unwrap_or_default().to_owned();
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// The IoU of a scenario.
fn of_scenario(name: String) -> Row {
    let word = |c: char| {
        if c.is_ascii_alphanumeric() {
            c.to_ascii_lowercase()
        } else {
            '_'
        }
    };
    Row {
        key: format!("iou_in_{}", name.chars().map(word).collect::<String>()),
        name: format!("IoU in {name}, at the job's threshold"),
        unit: "",
        better: Better::Higher,
        value: Box::new(move |run| {
            let rows = run.report.pointer("/scenarios/rows")?.as_array()?;
            rows.iter().find(|row| row["name"] == name)?["iou_at_threshold"].as_f64()
        }),
    }
}

/// Name of the model that gave the dose that a run is judged by.
fn judge_of(run: &ComparedRun) -> Option<&str> {
    let model = run.report.pointer("/run/models/evaluation");
    let model = model.and_then(Value::as_str)?;
    // "2 species by 2 lights, each alone: parallel (…"
    let model = model.rsplit("each alone: ").next()?;
    model.split([' ', ',', ':']).next()
}

/// The same under a run's name.
fn judge(run: &ComparedRun) -> String {
    judge_of(run).map_or_else(String::new, |name| {
        format!(
            "<br><span class=\"muted\">judged by {}</span>",
            escape(name)
        )
    })
}

/// Whether some of the part turns solid in a run; of gray targets, which have no IoU, and earlier reports it is not asked.
fn prints(run: &ComparedRun) -> bool {
    run.number("/evaluation/iou") != Some(0.0) && run.number("/evaluation/part/max") != Some(0.0)
}

fn numbers(runs: &[ComparedRun]) -> String {
    let heads: String = runs
        .iter()
        .enumerate()
        .map(|(i, run)| {
            format!(
                "<th><i class=\"dot c-{}\"></i>{}{}</th>",
                class(i),
                escape(&run.name),
                judge(run)
            )
        })
        .collect();
    let mut body = String::new();
    let prints: Vec<bool> = runs.iter().map(prints).collect();
    // What one model says of a print is no better than what another says
    let is_fair = (runs.windows(2)).all(|pair| judge_of(&pair[0]) == judge_of(&pair[1]));
    for row in rows(runs) {
        let values: Vec<Option<f64>> = runs.iter().map(|run| (row.value)(run)).collect();
        // Nothing is good of a print that is not there
        let of_prints = values.iter().zip(&prints).filter(|(_, prints)| **prints);
        let known = of_prints.filter_map(|(value, _)| *value);
        let best = match row.better {
            _ if runs.len() < 2 || !is_fair => None,
            Better::Higher => known.reduce(f64::max),
            Better::Lower => known.reduce(f64::min),
            Better::Neutral => None,
        };
        if values.iter().all(Option::is_none) {
            continue;
        }
        let (factor, unit) = if row.unit == "mm" {
            (1e3, "µm")
        } else {
            (1.0, row.unit)
        };
        let unit = if unit == "response" { "" } else { unit };
        let arrow = match row.better {
            Better::Higher => " ↑",
            Better::Lower => " ↓",
            Better::Neutral => "",
        };
        let _ = write!(
            body,
            "<tr><td>{}{arrow} <span class=\"unit\">{unit}</span></td>",
            escape(&row.name)
        );
        for (value, prints) in values.into_iter().zip(&prints) {
            let text = value.map_or("–".to_owned(), |value| significant(value * factor, 4));
            let class = if *prints && best.is_some() && value == best {
                " class=\"head\""
            } else {
                ""
            };
            let _ = write!(body, "<td{class}>{text}</td>");
        }
        body.push_str("</tr>");
    }
    let best = if is_fair {
        "the best is bold."
    } else {
        "the best is not marked, because the runs were evaluated by different models: compare only columns with the same one."
    };
    format!(
        "<section><h2>Numbers</h2><p class=\"muted\">Written patterns, vial turning, on the voxels of each evaluation. ↑ larger is better, ↓ smaller is better; \
         {best}</p><div class=\"scroll\"><table><thead><tr><th></th>{heads}</tr></thead><tbody>{body}</tbody></table></div></section>"
    )
}

/// Keys of the jobs that are not the same in all runs, with their values.
fn differing(runs: &[ComparedRun]) -> Vec<(String, Vec<Option<String>>)> {
    let keys: BTreeSet<&String> = runs.iter().flat_map(|run| run.job.keys()).collect();
    keys.into_iter()
        .map(|key| {
            (
                key.clone(),
                runs.iter()
                    .map(|run| run.job.get(key).cloned())
                    .collect::<Vec<_>>(),
            )
        })
        .filter(|(_, values)| values.iter().any(|value| *value != values[0]))
        .collect()
}

fn keys(runs: &[ComparedRun]) -> String {
    let differing = differing(runs);
    if differing.is_empty() {
        return "<section><h2>What differs in the jobs</h2><p class=\"muted\">Nothing.</p></section>".to_owned();
    }
    let heads: String = runs
        .iter()
        .map(|run| format!("<th>{}</th>", escape(&run.name)))
        .collect();
    let body: String = differing
        .iter()
        .map(|(key, values)| {
            let cells: String = values
                .iter()
                .map(|value| {
                    format!(
                        "<td>{}</td>",
                        value.as_ref().map_or("–".to_owned(), |value| escape(value))
                    )
                })
                .collect();
            format!("<tr><td>{}</td>{cells}</tr>", escape(key))
        })
        .collect();
    format!(
        "<section><h2>What differs in the jobs</h2><div class=\"scroll\"><table class=\"keys\"><thead><tr><th></th>{heads}</tr></thead>\
         <tbody>{body}</tbody></table></div></section>"
    )
}

/// A column of the histories against calls or seconds.
fn history(
    runs: &[ComparedRun],
    column: &str,
    x: fn(&ComparedRun, usize) -> Option<f64>,
    label: &str,
) -> Option<String> {
    let lines: Vec<Vec<[f64; 2]>> = runs
        .iter()
        .map(|run| run.points(|i| x(run, i), column))
        .collect();
    let all = || lines.iter().flatten();
    let most = all().map(|p| p[0]).reduce(f64::max)?;
    let positive = || all().map(|p| p[1]).filter(|y| *y > 0.0);
    let axis = match (
        column,
        positive().reduce(f64::min),
        positive().reduce(f64::max),
    ) {
        ("loss", Some(low), Some(high)) if all().any(|p| p[1] <= 0.0) => {
            Axis::log_with_zero("loss", low, high)
        }
        ("loss", Some(low), Some(high)) => Axis::log("loss", low, high),
        _ => Axis::linear("IoU", all().map(|p| p[1]).fold(1.0, f64::min), 1.0),
    };
    let mut plot = Plot::new(Axis::linear(label, 0.0, most), axis);
    for (i, line) in lines
        .iter()
        .enumerate()
        .filter(|(_, line)| !line.is_empty())
    {
        plot.line(line, &class(i), "");
        plot.zeros(line, &class(i));
    }
    Some(plot.svg(&format!("{column} against {label}")))
}

fn numbers_of(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_f64)
        .collect()
}

fn curves(runs: &[ComparedRun]) -> Option<String> {
    let curve = |run: &ComparedRun| -> Vec<[f64; 2]> {
        let points = run.report["evaluation"]["iou_curve"]
            .as_array()
            .into_iter()
            .flatten();
        points
            .filter_map(|point| numbers_of(point).try_into().ok())
            .collect()
    };
    let lines: Vec<Vec<[f64; 2]>> = runs.iter().map(curve).collect();
    let most = lines.iter().flatten().map(|p| p[0]).reduce(f64::max)?;
    let mut plot = Plot::new(
        Axis::linear("gel threshold", 0.0, most),
        Axis::linear("IoU", 0.0, 1.0),
    );
    for (i, line) in lines
        .iter()
        .enumerate()
        .filter(|(_, line)| !line.is_empty())
    {
        plot.line(line, &class(i), "");
    }
    Some(plot.svg("IoU against the gel threshold"))
}

/// Outline of a histogram as shares of all its voxels, per unit of the response.
fn outline(histogram: &Value, of: &str) -> Vec<[f64; 2]> {
    let (range, counts) = (numbers_of(&histogram["range"]), numbers_of(&histogram[of]));
    let total: f64 = counts.iter().sum();
    let (&[low, high], true) = (range.as_slice(), total > 0.0) else {
        return Vec::new();
    };
    let width = (high - low) / counts.len() as f64;
    let step = |(i, n): (usize, &f64)| {
        let (left, height) = (low + i as f64 * width, n / (total * width));
        [[left, height], [left + width, height]]
    };
    counts.iter().enumerate().flat_map(step).collect()
}

/// Least share of the voxels per unit of response that the axis shows, against the largest.
const FAINTEST: f64 = 1e-6;

fn histograms(runs: &[ComparedRun]) -> Option<String> {
    let lines: Vec<[Vec<[f64; 2]>; 2]> = runs
        .iter()
        .map(|run| ["part", "void"].map(|of| outline(&run.report["evaluation"]["histogram"], of)))
        .collect();
    let all = || lines.iter().flatten().flatten();
    let (right, most) = (
        all().map(|p| p[0]).reduce(f64::max)?,
        all().map(|p| p[1]).reduce(f64::max)?,
    );
    let least = all()
        .map(|p| p[1])
        .filter(|y| *y > 0.0)
        .reduce(f64::min)?
        .max(FAINTEST * most);
    let mut plot = Plot::new(
        Axis::linear("response to the dose", 0.0, right),
        Axis::log_with_zero("share per unit", least, most),
    );
    for (i, [part, void]) in lines.iter().enumerate() {
        plot.line(part, &class(i), "");
        plot.line(void, &format!("{} dotted", class(i)), "");
    }
    Some(plot.svg("Histograms of the dose in part and void"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(name: &str, iou: f64, memory: &str) -> ComparedRun {
        let mut flat = BTreeMap::new();
        let job: Value = toml::from_str(&format!(
            "[optimizer.lbfgs]\nmemory = {memory}\n[[light]]\npixels = [3, 4]"
        ))
        .unwrap();
        flatten("", &job, &mut flat);
        ComparedRun {
            name: name.to_owned(),
            report: json!({
                "schema": "tomolith.report/1", "part": "gear <b>",
                "evaluation": {
                    "iou": iou, "ver": 0.1, "surface_mean_mm": 0.012,
                    "iou_curve": [[0.0, 0.2], [0.5, iou], [1.0, 0.0]],
                    "histogram": { "range": [0.0, 1.0], "part": [0, 1, 9], "void": [8, 2, 0] },
                },
                "lights": [{ "budget": { "time_s": null, "light_used": 0.2 } }],
                "time": [{ "best_jaccard": iou, "best_s": 40.0, "window_s": [39.5, 41.0] }],
                "history": { "loss": 0.5, "iterations": 2 },
            }),
            job: flat,
            dose: None,
            history: columns(
                "iteration,loss,forward_calls,adjoint_calls,seconds,iou\n0,4,1,0,0.1,\n1,2,2,1,0.2,0.8\n2,0.5,4,2,0.4,\n",
            ),
        }
    }

    #[test]
    fn doses_lie_beside_each_other_and_their_differences_below() {
        let mut runs = [run("rays", 0.99, "10"), run("waves", 0.9, "10")];
        assert!(!compare_html(&runs).contains("<h2>Doses"));
        let of =
            |shape: [usize; 3], value: f32| Volume::filled(VolumeGrid::centered(shape, 0.1), value);
        runs[0].dose = Some(of([3, 4, 5], 0.5));
        runs[1].dose = Some(of([3, 4, 5], 1.0));
        let figures = |runs: &[ComparedRun]| compare_html(runs).matches("<figure>").count();
        // Two planes of two doses and one difference
        assert_eq!(figures(&runs), 6);
        assert!(compare_html(&runs).contains("<figcaption>waves, less rays</figcaption>"));
        assert!(compare_html(&runs).contains("Below, where the dose of waves is higher"));
        // No difference of other voxels, and none is announced
        runs[1].dose = Some(of([3, 4, 6], 1.0));
        assert_eq!(figures(&runs), 4);
        let page = compare_html(&runs);
        assert!(!page.contains("Below, what"), "{page}");
        assert!(
            page.contains(
                "No difference is drawn for waves: its voxels differ from those of rays."
            )
        );
    }

    #[test]
    fn nothing_is_best_of_a_run_that_prints_nothing() {
        let mut runs = [run("rays", 0.99, "10"), run("dark", 0.99, "10")];
        runs[1].report["lights"][0]["budget"]["light_used"] = 0.9.into();
        let best =
            |runs: &[ComparedRun]| compare_html(runs).contains("<td class=\"head\">0.9</td>");
        assert!(best(&runs));
        runs[1].report["evaluation"]["part"] = json!({ "max": 0.0 });
        assert!(!best(&runs));
        assert!(compare_html(&runs).contains("Nothing of the part turns solid in dark"));
    }

    #[test]
    fn the_page_names_the_model_that_judged() {
        let mut runs = [run("rays", 0.99, "10"), run("waves", 0.9, "10")];
        runs[1].report["run"] = json!({ "models": { "evaluation": "wave (4 depths): as asked" } });
        let page = compare_html(&runs);
        assert_eq!(page.matches("judged by").count(), 1);
        assert!(page.contains("waves<br><span class=\"muted\">judged by wave</span>"));
        // What one model says is no better than what another says
        assert!(page.contains("the best is not marked") && !page.contains("<td class=\"head\">"));
        let alone = "2 species by 2 lights, each alone: parallel (distance-driven kernel)";
        runs[1].report["run"]["models"]["evaluation"] = alone.into();
        assert!(compare_html(&runs).contains("judged by parallel"));
    }

    #[test]
    fn scenarios_have_rows_in_runs_that_have_them() {
        let mut runs = [run("a", 0.9, "10"), run("b", 0.95, "5"), run("c", 0.9, "5")];
        assert!(!compare_html(&runs).contains("scenario"));
        let row = |name: &str, iou: f64| json!({ "name": name, "iou_at_threshold": iou });
        runs[0].report["scenarios"] = json!({
            "worst_iou": 0.91, "window": -0.02, "rows": [row("the job", 0.99), row("Wide vial", 0.91)]
        });
        runs[1].report["scenarios"] = json!({
            "worst_iou": 0.93, "window": -0.03, "rows": [row("the job", 0.98), row("pale", 0.93)]
        });
        let json = compare_json(&runs);
        let of = |key: &str| {
            let rows = json["numbers"].as_array().unwrap();
            rows.iter().find(|row| row["key"] == key).unwrap()["values"].clone()
        };
        assert_eq!(of("worst_iou"), json!([0.91, 0.93, null]));
        assert_eq!(of("scenarios_pw"), json!([-0.02, -0.03, null]));
        assert_eq!(of("iou_in_wide_vial"), json!([0.91, null, null]));
        assert_eq!(of("iou_in_pale"), json!([null, 0.93, null]));
        assert!(compare_html(&runs).contains("IoU in Wide vial, at the job"));
    }

    #[test]
    fn numbers_stand_side_by_side_and_the_best_is_marked() {
        let runs = [run("a", 0.9, "10"), run("b", 0.95, "5")];
        let json = compare_json(&runs);
        let row = |name: &str| {
            let rows = json["numbers"].as_array().unwrap();
            rows.iter().find(|row| row["name"] == name).unwrap()["values"].clone()
        };
        assert_eq!(
            row("How long the print in time stays within 0.01 of its best IoU"),
            json!([1.5, 1.5])
        );
        assert_eq!(row("Model calls"), json!([6.0, 6.0]));
        let keys = json["numbers"].as_array().unwrap().iter();
        let keys: Vec<&str> = keys.map(|row| row["key"].as_str().unwrap()).collect();
        assert!(
            keys.contains(&"iou") && keys.contains(&"optimization_s"),
            "{keys:?}"
        );
        let is_snake = |key: &&str| {
            key.chars()
                .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
        };
        assert!(keys.iter().all(is_snake), "{keys:?}");
        assert_eq!(row("Time of the optimization"), json!([0.4, 0.4]));
        assert_eq!(
            json["differing_keys"],
            json!([{ "key": "optimizer.lbfgs.memory", "values": ["10", "5"] }])
        );
        let page = compare_html(&runs);
        assert!(
            page.contains("<td>0.9</td><td class=\"head\">0.95</td>")
                || page.contains("<td class=\"head\">0.9500</td>"),
            "{page}"
        );
        assert!(page.contains("gear &lt;b&gt;") && !page.contains("gear <b>"));
        assert_eq!(page.matches("<svg class=\"plot\"").count(), 6);
        for tag in ["section", "svg", "table", "div"] {
            assert_eq!(
                page.matches(&format!("<{tag}")).count(),
                page.matches(&format!("</{tag}>")).count(),
                "{tag}"
            );
        }
        for bad in ["NaN", "inf\"", "http:", "https:", "<script"] {
            assert!(!page.contains(bad), "{bad}");
        }
    }

    #[test]
    fn outlines_have_area_one() {
        let outline = outline(
            &json!({ "range": [0.5, 2.5], "part": [1, 0, 3, 4] }),
            "part",
        );
        let area: f64 = outline
            .chunks(2)
            .map(|step| (step[1][0] - step[0][0]) * step[0][1])
            .sum();
        assert!((area - 1.0).abs() < 1e-12, "{outline:?}");
        assert_eq!((outline[0], outline[7][0]), ([0.5, 0.25], 2.5));
    }

    #[test]
    fn runs_without_history_or_curves_still_make_a_page() {
        let mut bare = run("bare", 0.5, "1");
        bare.history.clear();
        bare.report["evaluation"] = json!({ "iou": 0.5 });
        let page = compare_html(&[bare]);
        assert!(page.contains("No run holds these numbers.") && page.contains("hold no curves"));
    }

    #[test]
    fn folders_that_are_no_runs_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let empty = read_runs(&[folder.path()]).unwrap_err().to_string();
        assert!(empty.contains("no report.json in it"), "{empty}");
        std::fs::write(folder.path().join("report.json"), "{\"schema\": \"other\"}").unwrap();
        assert!(matches!(
            read_runs(&[folder.path()]),
            Err(Error::Format { .. })
        ));
        assert!(matches!(
            read_runs(&[] as &[&Path]),
            Err(Error::Config { .. })
        ));
    }
}
