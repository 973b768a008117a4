//! The page: `report.html`, comparisons, what `tomolith view` serves. One file without any outside resource.
//!
//! The file holds its data (JSON; `PageData` of `page/src/data.ts` has every field with its meaning), arrays ([`blob`]) and the program that draws them (`page/` of the repository, TypeScript, built into
//! `page.js` and `page.css` of this crate). Readers without a script see the result in words, warnings, the middle slices and the numbers.
//! Volumes have at most 192 voxels along an edge and fewer where the file would become larger than 15 MB; `reduced` says by how much.

pub mod blob;
mod picture;
mod scene;
mod slices;
mod texts;
mod volumes;

use crate::compare::{ComparedRun, columns};
use crate::number::{escape, significant};
use crate::{ReportData, json};
use blob::{Film, packed};
pub use scene::{FramePaths, LightPath, LightPaths, Scene, SceneOutline};
use serde::Serialize;
use serde_json::{Value, json};
pub use slices::VolumeSlices;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use texts::Texts;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::Volume;
use tomolith_io::csv::history_text;
use tomolith_metrics::surface::Deviation;
use tomolith_metrics::{Better, METRICS};
pub use volumes::{Served, served_response, served_target};
use volumes::{VolumeInfo, volumes};

/// What the data of a page say that they are.
pub const SCHEMA: &str = "tomolith.page/2";

/// Numbers at the head of the page.
const HEADLINE: [&str; 9] = [
    "iou",
    "print_time_mm",
    "pw",
    "ver",
    "gamma",
    "surface_mean_mm",
    "hausdorff_mm",
    "over_mm3",
    "under_mm3",
];

/// Numbers at the head of the page of a gray target.
const GRAY_HEADLINE: [&str; 4] = ["in_band", "rms_error", "max_error_part", "max_error_void"];

/// Bytes of the arrays in one file, as text.
const MOST_BYTES: usize = 12_000_000;

/// What a page is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum PageKind {
    /// A run.
    Report,
    /// Several runs.
    Compare,
    /// A job before it runs.
    Check,
    /// Runs that a server has.
    View,
}

/// Patterns of a light, as the page holds them.
#[derive(Serialize)]
struct FilmInfo<'a> {
    id: String,
    light: &'a str,
    frames: usize,
    rows: usize,
    columns: usize,
    of: [usize; 3],
    every: usize,
    binned: usize,
    angles_deg: Vec<f64>,
    full_scale: f32,
    pitch_mm: [f64; 2],
}

/// The print's surface, as the page holds it.
#[derive(Serialize)]
struct SurfaceInfo {
    id: &'static str,
    vertices: usize,
    triangles: usize,
    low_mm: [f32; 3],
    high_mm: [f32; 3],
    off_um: [f32; 2],
}

#[derive(Serialize)]
struct RunData<'a> {
    name: &'a str,
    state: &'static str,
    report: Value,
    texts: Texts<'a>,
    job: &'a str,
    history: BTreeMap<String, Vec<f64>>,
    volumes: Vec<VolumeInfo>,
    films: Vec<FilmInfo<'a>>,
    scene: Option<&'a Scene>,
    surface: Option<SurfaceInfo>,
}

/// Arrays by name, as text of the page.
pub type Arrays = Vec<(String, String)>;

/// A page before it is text: its data, and its arrays by name.
#[derive(Clone, Debug)]
pub struct Page {
    /// `PageData` of `page/src/data.ts`.
    pub data: Value,
    /// Arrays, as [`blob`] packs them, by the name of their element.
    pub blobs: Arrays,
    /// What readers without a script see, HTML.
    pub plain: String,
}

/// The page of a run.
///
/// # Errors
/// [`Error::Shape`] when the volumes do not belong together.
pub fn report_page(data: &ReportData<'_>) -> Result<Page> {
    data.check()?;
    let mut blobs = Vec::new();
    let films = films(data, &mut blobs);
    let surface = (data.deviation).map(|deviation| surface(deviation, &mut blobs));
    let taken: usize = blobs.iter().map(|(_, text)| text.len()).sum();
    let (infos, arrays) = volumes(data, MOST_BYTES.saturating_sub(taken));
    blobs.extend(arrays);
    let texts = Texts::of(data);
    let plain = plain(data, &texts.lead);
    let run = RunData {
        name: data.part,
        state: "done",
        report: json::report_json(data),
        texts,
        job: data.job_text,
        history: columns(&history_text(data.history)),
        volumes: infos,
        films,
        scene: data.scene,
        surface,
    };
    let data = page_data(PageKind::Report, data.part, data.program, vec![json!(run)]);
    let blobs = (blobs.into_iter())
        .map(|(name, text)| (format!("blob-0-{name}"), text))
        .collect();
    Ok(Page { data, blobs, plain })
}

/// The page of a job before it runs: its target on voxels, and its machine.
#[must_use]
pub fn check_page(
    part: &str,
    program: &str,
    job: &str,
    target: &Volume<f32>,
    labels: &Volume<u8>,
    scene: &Scene,
) -> Page {
    let (infos, arrays) = volumes::target(target, labels);
    let mut run = bare_run(part, "check", job);
    run["volumes"] = json!(infos);
    run["scene"] = json!(scene);
    let blobs = arrays.into_iter();
    Page {
        data: page_data(PageKind::Check, part, program, vec![run]),
        blobs: blobs
            .map(|(name, text)| (format!("blob-0-{name}"), text))
            .collect(),
        plain: format!("<h1>{}</h1><p>This page needs a script.</p>", escape(part)),
    }
}

/// What a page knows of a run before there are any results of it.
#[must_use]
pub fn bare_run(name: &str, state: &str, job: &str) -> Value {
    json!({
        "name": name,
        "state": state,
        "report": null,
        "texts": null,
        "job": job,
        "history": {},
        "volumes": [],
        "films": [],
        "scene": null,
        "surface": null,
    })
}

/// The data of a page with these runs.
#[must_use]
pub fn page_data(kind: PageKind, title: &str, program: &str, runs: Vec<Value>) -> Value {
    let metrics: Vec<Value> = METRICS
        .iter()
        .map(|kind| {
            json!({ "name": kind.name, "title": kind.title, "summary": kind.summary, "unit": kind.unit, "better": word(kind.better) })
        })
        .collect();
    json!({
        "schema": SCHEMA,
        "kind": kind,
        "title": title,
        "program": program,
        "served": null,
        "metrics": metrics,
        "headline": HEADLINE,
        "gray_headline": GRAY_HEADLINE,
        "compare": null,
        "sweep": null,
        "runs": runs,
    })
}

/// Which way a number is better, as pages and programs read it.
pub(crate) fn word(better: Better) -> &'static str {
    match better {
        Better::Higher => "higher",
        Better::Lower => "lower",
        Better::Neutral => "none",
    }
}

/// Pixels of all frames of all lights that a page holds, at most.
const FILM_PIXELS: usize = 3_000_000;

fn films<'a>(data: &ReportData<'a>, blobs: &mut Vec<(String, String)>) -> Vec<FilmInfo<'a>> {
    let most = FILM_PIXELS / data.lights.len().max(1);
    let film_of = |(i, light): (usize, &crate::LightReport<'a>)| {
        let grid = &light.patterns.grid;
        let film = Film::of(light.patterns, light.full_scale, most);
        let id = format!("film{i}");
        blobs.push((id.clone(), packed(&film.codes)));
        FilmInfo {
            id,
            light: light.name,
            frames: film.frames.len(),
            rows: film.rows,
            columns: film.columns,
            of: grid.shape(),
            every: film.frames.get(1).copied().unwrap_or(1),
            binned: film.binned,
            angles_deg: (film.frames.iter())
                .map(|&k| grid.azimuths[k].to_degrees())
                .collect(),
            full_scale: light.full_scale,
            pitch_mm: grid.pitch_mm,
        }
    };
    data.lights.iter().enumerate().map(film_of).collect()
}

/// Corners of a surface that a page holds, at most: 14 bytes each, and 24 of its two triangles, before they are packed.
const CORNERS: usize = 250_000;

/// Corners in 16 bits of their box, their deviations in 16 bits of the largest, and triangles; without triangles where there are too many.
fn surface(deviation: &Deviation, blobs: &mut Vec<(String, String)>) -> SurfaceInfo {
    let whole = &deviation.surface;
    let is_few = whole.corners.len() <= CORNERS;
    let corners = if is_few {
        whole.corners.as_slice()
    } else {
        &[]
    };
    let triangles = if is_few {
        whole.triangles.as_slice()
    } else {
        &[]
    };
    let end = |pick: fn(f32, f32) -> f32, from: f32| -> [f32; 3] {
        std::array::from_fn(|axis| {
            corners
                .iter()
                .fold(from, |end, corner| pick(end, corner[axis]))
        })
    };
    let (low, high) = match corners.is_empty() {
        true => ([0.0; 3], [0.0; 3]),
        false => (
            end(f32::min, f32::INFINITY),
            end(f32::max, f32::NEG_INFINITY),
        ),
    };
    let largest = deviation
        .off_um
        .iter()
        .fold(0.0f32, |most, off| most.max(off.abs()));
    let code = |value: f32, from: f32, to: f32| match to > from {
        true => (f32::from(u16::MAX) * (value - from) / (to - from)).round() as u16,
        false => 0,
    };
    let places = corners
        .iter()
        .flat_map(|corner| (0..3).map(|axis| code(corner[axis], low[axis], high[axis])));
    let off =
        |off: &f32| (f32::from(i16::MAX) * off / largest.max(f32::MIN_POSITIVE)).round() as i16;
    let mut bytes: Vec<u8> = places.flat_map(u16::to_le_bytes).collect();
    bytes.extend(
        deviation.off_um[..corners.len()]
            .iter()
            .flat_map(|v| off(v).to_le_bytes()),
    );
    bytes.extend(
        triangles
            .as_flattened()
            .iter()
            .flat_map(|i| i.to_le_bytes()),
    );
    blobs.push(("surface".to_owned(), packed(&bytes)));
    SurfaceInfo {
        id: "surface",
        vertices: corners.len(),
        triangles: triangles.len(),
        low_mm: low,
        high_mm: high,
        off_um: [-largest, largest],
    }
}

/// What readers without a script see.
fn plain(data: &ReportData<'_>, lead: &str) -> String {
    let evaluation = data.first().evaluation;
    let mut out = format!("<h1>{}</h1><p>{}</p>", escape(data.part), escape(lead));
    for warning in data.warnings.iter().chain(&evaluation.notes) {
        // Writing into a string cannot fail
        let _ = write!(out, "<p>{}</p>", escape(warning));
    }
    out.push_str(&picture::slices(data));
    out.push_str("<table>");
    for (kind, value) in METRICS
        .iter()
        .filter_map(|kind| Some((kind, evaluation.measures.get(kind.name)?)))
    {
        let (title, value) = (escape(kind.title), significant(value, 4));
        let _ = write!(
            out,
            "<tr><td>{title}</td><td>{value} {}</td></tr>",
            kind.unit
        );
    }
    out + "</table>"
}

impl Page {
    /// The page as a file.
    #[must_use]
    pub fn html(&self) -> String {
        let title = self.data["title"].as_str().unwrap_or_default();
        let kind = self.data["kind"].as_str().unwrap_or_default();
        // What looks like markup within JSON could end the element
        let data = self.data.to_string().replace('<', "\\u003c");
        let blobs: String = (self.blobs.iter())
            .map(|(id, text)| {
                format!(
                    "<script type=\"text/plain\" id=\"{}\">{text}</script>\n",
                    escape(id)
                )
            })
            .collect();
        format!(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">{}<title>{} · Tomolith</title>\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>{}</style></head><body>\n\
             <div id=\"app\"><p>Where this line stays, the file was cut or changed, or the browser runs no scripts.</p></div>\n<noscript>{}</noscript>\n<script type=\"application/json\" id=\"data\">{data}</script>\n{blobs}\
             <script>{}</script></body></html>\n",
            made_as(kind),
            escape(title),
            include_str!("../../page/page.css"),
            self.plain,
            include_str!("../../page/page.js"),
        )
    }

    /// Reads a file that [`html`](Self::html) made.
    ///
    /// # Errors
    /// [`Error::Io`], and [`Error::Format`](Error) for a file that is no such page.
    pub fn read(path: &Path) -> Result<Self> {
        let text = std::fs::read_to_string(path).map_err(|e| Error::io(path, e))?;
        let no_page = || {
            let text = "the file is no page of Tomolith; a run of this version writes one";
            Error::io(
                path,
                std::io::Error::new(std::io::ErrorKind::InvalidData, text),
            )
        };
        let element = |text: &'_ str, kind: &str| -> Vec<(String, String)> {
            let open = format!("<script type=\"{kind}\" id=\"");
            (text.split(open.as_str()).skip(1))
                .filter_map(|rest| {
                    let (id, rest) = rest.split_once("\">")?;
                    let (body, _) = rest.split_once("</script>")?;
                    Some((id.to_owned(), body.to_owned()))
                })
                .collect()
        };
        let data = element(&text, "application/json")
            .into_iter()
            .find(|(id, _)| id == "data");
        let data = data.and_then(|(_, json)| serde_json::from_str::<Value>(&json).ok());
        let data = data
            .filter(|data| data["schema"] == SCHEMA)
            .ok_or_else(no_page)?;
        let plain = text
            .split_once("<noscript>")
            .and_then(|(_, rest)| rest.split_once("</noscript>"));
        Ok(Page {
            data,
            blobs: element(&text, "text/plain"),
            plain: plain.map_or_else(String::new, |(plain, _)| plain.to_owned()),
        })
    }
}

/// What a file that is a page says in its first line of what it is about.
pub(crate) fn made_as(kind: &str) -> String {
    format!("<meta name=\"generator\" content=\"Tomolith {kind}\">")
}

/// What a comparison holds of each run, and its arrays.
pub(crate) fn compared(runs: &[ComparedRun]) -> Result<(Vec<Value>, Arrays)> {
    let mut blobs = Vec::new();
    let most = MOST_BYTES / runs.len().max(1);
    let run_of = |(i, run): (usize, &ComparedRun)| {
        let first = run.page.as_ref().map(|page| &page.data["runs"][0]);
        let texts = first.map_or(Value::Null, |first| first["texts"].clone());
        let mut infos = Vec::new();
        if let Some(dose) = run.read_dose()? {
            let (info, text) = volumes::dose(&dose, most);
            blobs.push((format!("blob-{i}-response"), text));
            infos.push(json!(info));
        }
        let target = run.page.as_ref().and_then(|page| page.volume("target"));
        if let Some((mut info, text)) = target.filter(|(_, text)| text.len() < most) {
            info["id"] = "target".into();
            blobs.push((format!("blob-{i}-target"), text));
            infos.push(info);
        }
        let mut data = run.bare();
        data["texts"] = texts;
        data["volumes"] = infos.into();
        Ok(data)
    };
    let all = runs.iter().enumerate().map(run_of).collect::<Result<_>>()?;
    Ok((all, blobs))
}

impl Page {
    /// The first volume of a kind of the first run, and its array.
    fn volume(&self, kind: &str) -> Option<(Value, String)> {
        let volumes = self.data["runs"][0]["volumes"].as_array()?;
        let info = volumes.iter().find(|info| info["kind"] == kind)?;
        let name = format!("blob-0-{}", info["id"].as_str()?);
        let (_, text) = self.blobs.iter().find(|(id, _)| *id == name)?;
        Some((info.clone(), text.clone()))
    }
}
