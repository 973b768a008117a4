//! What a run has found: `report.json` for programs, `report.html` for people.
//!
//! *What must it do, and who does it.* [`ReportData`] is everything a report shows, put together by whoever ran the job;
//! [`write_json`] and [`write_html`] write it. The page ([`page`]) is one file without any outside resource.

pub mod ceiling;
pub mod compare;
pub mod json;
pub mod latitude;
pub mod limits;
pub mod maps;
pub mod number;
pub mod objectives;
pub mod page;
mod picture;
pub mod plot;
mod relief;
pub mod scenarios;
pub mod species;
pub mod time;

pub use ceiling::{
    CeilingPoint, CeilingQuality, CeilingReport, FinestTrial, RunPrint, TradeOff, gap_sentence,
    time_sentence,
};
/// What `report.json` says that it is.
pub const SCHEMA: &str = "tomolith.report/1";

pub use latitude::ExposureWindow;
pub use limits::{Cause, Limit, PrintLimits};
pub use objectives::ObjectiveReport;
pub use scenarios::{ScenarioRow, ScenarioTable};
pub use species::{OneExposure, OneMoment};
use std::path::Path;
pub use time::TimeReport;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Patterns, Volume};
use tomolith_io::csv::HistoryRow;
use tomolith_io::mp4::MovieCheck;
use tomolith_io::write_text;
use tomolith_metrics::Evaluation;
use tomolith_metrics::surface::Deviation;
use tomolith_objective::FoundWindow;
use tomolith_optics::exposure::Budget;
use tomolith_optimize::levels::Gain;
use tomolith_optimize::{Gap, KeptIterate};

/// The patterns of one light.
#[derive(Clone, Copy, Debug)]
pub struct LightReport<'a> {
    /// Its name; may be empty when there is only one.
    pub name: &'a str,
    /// What the projector shows: quantized, as pattern values.
    pub patterns: &'a Patterns,
    /// Bit depth.
    pub bits: u32,
    /// The pattern value of the highest level.
    pub full_scale: f32,
    /// Wavelength, when known.
    pub wavelength_nm: Option<f64>,
    /// Columns and rows of the device, when a printer is named.
    pub canvas: Option<[usize; 2]>,
    /// Time, energy and use of the light; those of the job's schedule where it has one.
    pub budget: Budget,
    /// How bright the job's schedule shows it, where it has one.
    pub irradiance: Option<Irradiance>,
}

/// How bright a light shines in a schedule, while it shines.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Irradiance {
    /// Of white, mW/cm².
    pub white_mw_per_cm2: f64,
    /// The most that the printer gives, where the job says so, mW/cm².
    pub peak_mw_per_cm2: Option<f64>,
}

/// A movie that was written, and what a decoder made of it.
#[derive(Clone, Debug)]
pub struct MovieReport {
    /// File name in the run folder.
    pub file: String,
    /// What a decoder makes of it.
    pub check: MovieCheck,
}

/// Wall time of a part of the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Timing {
    /// What took the time; `whole: part` for a part of another one.
    pub name: String,
    /// How long, s.
    pub seconds: f64,
}

/// A property of the printed material.
#[derive(Clone, Copy, Debug)]
pub struct MapReport<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its unit; may be empty.
    pub unit: &'a str,
    /// Whether its scale is logarithmic.
    pub is_logarithmic: bool,
    /// Its values; NaN where nothing is solid.
    pub values: &'a Volume<f32>,
}

impl MapReport<'_> {
    /// Smallest, median and largest value where something is solid; None where nothing is.
    #[must_use]
    pub fn spread(&self) -> Option<[f64; 3]> {
        let mut solid: Vec<f32> = self
            .values
            .values
            .iter()
            .copied()
            .filter(|v| v.is_finite())
            .collect();
        let middle = solid.len() / 2;
        let [low, high] = [f32::min, f32::max].map(|f| solid.iter().copied().reduce(f));
        let (low, high) = (low?, high?);
        let (_, median, _) = solid.select_nth_unstable_by(middle, f32::total_cmp);
        Some([low, *median, high].map(f64::from))
    }
}

/// What a species prints.
#[derive(Clone, Debug)]
pub struct SpeciesReport<'a> {
    /// Its name; empty where the job names no species.
    pub name: &'a str,
    /// Each light and how strongly it drives the species.
    pub driven_by: Vec<(String, f64)>,
    /// Its numbers: finer grid, written patterns, vial turning.
    pub evaluation: &'a Evaluation,
    /// Labels of the evaluation's voxels ([`tomolith_core::target::label`]).
    pub labels: &'a Volume<u8>,
    /// Its response there.
    pub response: &'a Volume<f32>,
    /// What that is called: `dose` where the material has no response of its own, else `response`.
    pub quantity: &'static str,
    /// Inside fraction, or gray values, of its target there.
    pub inside: &'a Volume<f32>,
    /// Thresholds of its objective `[lower, upper]`, where it has any: void below, part above.
    pub window: Option<[f64; 2]>,
    /// Over which exposures it is nearly as good as at the best one of this species, where this is known.
    pub exposure: Option<ExposureWindow>,
    /// What limits it.
    pub limits: &'a PrintLimits,
}

/// Everything a report shows.
pub struct ReportData<'a> {
    /// Name of the part.
    pub part: &'a str,
    /// Program and version.
    pub program: &'a str,
    /// Date and time, as text; may be empty.
    pub created: &'a str,
    /// Whether the job is a toy: `--toy`.
    pub is_toy: bool,
    /// Short facts for the head of the page: `("Vial", "cylinder, 7.6 mm")`.
    pub facts: Vec<(String, String)>,
    /// What gave the doses: `("optimization", "parallel (…): …")`.
    pub models: Vec<(&'static str, String)>,
    /// The patterns of each light.
    pub lights: Vec<LightReport<'a>>,
    /// What each species prints, first the one that the headline is about.
    pub species: Vec<SpeciesReport<'a>>,
    /// Which of the evaluation's voxels belong to a body that is not printed: [`DARK`], [`INSERT`] or [`OBSTACLE`], else 0. None without
    /// such bodies.
    pub bodies: Option<&'a Volume<u8>>,
    /// The first species on the optimization's grid.
    pub optimization: Option<&'a Evaluation>,
    /// Every one of `objectives` there; empty for a job with `objective`.
    pub objectives: &'a [ObjectiveReport],
    /// Numbers with other authors' signs or normalizations.
    pub published: serde_json::Map<String, serde_json::Value>,
    /// The same species at one exposure, where there are several.
    pub one_exposure: Option<&'a OneExposure>,
    /// The print in time, per network, where the job has a schedule.
    pub time: Vec<&'a TimeReport>,
    /// The best moment of all networks, where there are several.
    pub one_moment: Option<OneMoment>,
    /// Properties of the printed material.
    pub maps: Vec<MapReport<'a>>,
    /// What happened in the optimization.
    pub history: &'a [HistoryRow],
    /// Which of its iterates the patterns are.
    pub kept: Option<KeptIterate>,
    /// How far their loss is from the lowest, where that is known.
    pub gap: Option<Gap>,
    /// The print's surface and how far it is off, where there is one.
    pub deviation: Option<&'a Deviation>,
    /// The same patterns in the job's scenarios, where it has any.
    pub scenarios: Option<&'a ScenarioTable>,
    /// The process window that the optimization reached, where an objective looks for it.
    pub found_window: Option<FoundWindow>,
    /// Parameters of the response that were found with the patterns; empty where none were unknowns.
    pub found_response: &'a [(String, f64)],
    /// What was gained on few levels of the machine, where patterns were improved on them.
    pub levels: Option<Gain>,
    /// The ceiling of the pixels, where the run looked for one.
    pub ceiling: Option<&'a CeilingReport>,
    /// Movies.
    pub movies: Vec<MovieReport>,
    /// Walls, bodies in the light and rays of some pixels.
    pub scene: Option<&'a page::Scene>,
    /// The resolved job.
    pub job_text: &'a str,
    /// Choices that were made, one sentence each.
    pub notes: Vec<String>,
    /// What people should know, one sentence each.
    pub warnings: Vec<String>,
    /// Where the time went.
    pub timings: Vec<Timing>,
}

/// Of [`ReportData::bodies`]: a body that is to stay dark.
pub const DARK: u8 = 1;
/// Of [`ReportData::bodies`]: an insert.
pub const INSERT: u8 = 2;
/// Of [`ReportData::bodies`]: a body in the light that is no part of the target. Its voxels may be labeled as void.
pub const OBSTACLE: u8 = 3;

impl<'a> ReportData<'a> {
    /// The species of the headline.
    fn first(&self) -> &SpeciesReport<'a> {
        &self.species[0]
    }

    /// Quality against time, where the run looked for a ceiling of its pixels.
    fn trade_off(&self) -> Vec<TradeOff> {
        let prints = self.species.iter().map(|species| RunPrint {
            evaluation: species.evaluation,
            exposure: species.exposure.as_ref(),
        });
        let prints: Vec<RunPrint<'_>> = prints.collect();
        let scales = self.lights.iter().map(|light| f64::from(light.full_scale));
        let brightest = scales.fold(0.0, f64::max);
        let rows_of = |ceiling: &CeilingReport| ceiling.trade_off(&prints, brightest);
        self.ceiling.map_or_else(Vec::new, rows_of)
    }

    /// Whether volumes belong together.
    fn check(&self) -> Result<()> {
        let (first, bodies) = (self.first(), self.bodies);
        let expected = first.labels.grid.len();
        let lengths = [
            ("labels", first.labels.values.len()),
            ("response", first.response.values.len()),
            ("inside fraction", first.inside.values.len()),
            ("bodies", bodies.map_or(expected, |v| v.values.len())),
        ];
        for (what, found) in lengths {
            if found != expected {
                return Err(Error::shape(
                    format!("{what} of the report"),
                    first.labels.grid.shape,
                    vec![found],
                ));
            }
        }
        Ok(())
    }
}

/// Writes `report.json`; see [`json`].
///
/// # Errors
/// [`Error::Io`].
pub fn write_json(path: &Path, data: &ReportData<'_>) -> Result<()> {
    write_text(path, &format!("{:#}\n", json::report_json(data)))
}

/// Writes `print.ply`: the print's surface in mm, with colors, and `deviation_um` at each corner (positive where the print is too large).
///
/// # Errors
/// [`Error::Io`].
pub fn write_print(path: &Path, part: &str, deviation: &Deviation) -> Result<()> {
    relief::write(path, part, deviation)
}

/// Writes `report.html`; see [`page`].
///
/// # Errors
/// [`Error::Io`], or [`Error::Shape`] when the volumes do not belong together.
pub fn write_html(path: &Path, data: &ReportData<'_>) -> Result<()> {
    write_text(path, &page::report_page(data)?.html())
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::{PatternGrid, VolumeGrid};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};
    use tomolith_metrics::evaluate;
    use tomolith_metrics::print::{PatternStats, Print};

    /// A disc in a blurred dose, with everything a report can hold.
    pub(crate) struct Sample {
        labels: Volume<u8>,
        response: Volume<f32>,
        inside: Volume<f32>,
        patterns: Patterns,
        history: Vec<HistoryRow>,
        limits: PrintLimits,
    }

    impl Sample {
        pub(crate) fn new() -> Self {
            let grid = VolumeGrid::centered([6, 20, 22], 0.1);
            let radius = |[x, y, _]: [f64; 3]| (x.powi(2) + y.powi(2)).sqrt();
            let label = |middle| match radius(middle) {
                r if r > 1.0 => OUTSIDE,
                r if r > 0.5 => VOID,
                _ => PART,
            };
            let mut patterns = Patterns::dark(PatternGrid::full_turn(9, 0.0, 4, 6, 0.1));
            let values = patterns.values.iter_mut().enumerate();
            values.for_each(|(i, v)| *v = (i % 7) as f32);
            let row = |i: usize| HistoryRow {
                iteration: i,
                loss: 10.0 / (1 + i) as f64,
                projected_gradient: (i > 0).then_some(1.0),
                step: (i > 0).then_some(1.0),
                forward_calls: 2 * i,
                adjoint_calls: i,
                seconds: i as f64,
                iou: Some(1.0 - 0.5f64.powi(1 + i as i32)),
                process_window: i.is_multiple_of(2).then_some(0.01 * i as f64),
                response: vec![("steepness".to_owned(), 10.0 + i as f64)],
            };
            Sample {
                labels: Volume::from_fn(grid.clone(), label),
                response: Volume::from_fn(grid.clone(), |middle| (1.3 - radius(middle)) as f32),
                inside: Volume::from_fn(grid, |middle| f32::from(label(middle) == PART)),
                patterns,
                history: (0..5).map(row).collect(),
                limits: PrintLimits {
                    spoiled: None,
                    sentence: "Predicted IoU 1.".to_owned(),
                    causes: vec![Limit {
                        cause: Cause::Turning,
                        measure: "iou",
                        loss: 0.25,
                        key: "light.angles".to_owned(),
                        advice: "It turns. Raise `light.angles`.".to_owned(),
                    }],
                },
            }
        }

        pub(crate) fn evaluation(&self) -> Evaluation {
            let print = Print::new(&self.labels, &self.response).unwrap();
            evaluate(&print.with_patterns(PatternStats::of([&self.patterns])))
        }

        pub(crate) fn data<'a>(&'a self, evaluation: &'a Evaluation) -> ReportData<'a> {
            ReportData {
                part: "disc <script>alert(1)</script>",
                program: "Tomolith",
                created: "",
                is_toy: false,
                facts: vec![("Vial".to_owned(), "\"none\"".to_owned())],
                models: vec![("evaluation", "parallel: one slice serves all".to_owned())],
                lights: vec![LightReport {
                    name: "",
                    patterns: &self.patterns,
                    bits: 8,
                    full_scale: 6.0,
                    wavelength_nm: None,
                    canvas: Some([32, 20]),
                    budget: Budget {
                        light_used: 0.25,
                        white_mj_per_mm2: Some(40.0),
                        time_s: Some(75.0),
                        turns: Some(12.5),
                        energy_per_turn_mj: Some(3.0),
                        energy_mj: Some(37.5),
                    },
                    irradiance: None,
                }],
                species: vec![SpeciesReport {
                    name: "",
                    driven_by: Vec::new(),
                    evaluation,
                    labels: &self.labels,
                    response: &self.response,
                    quantity: "dose",
                    inside: &self.inside,
                    window: Some([0.7, 0.9]),
                    exposure: None,
                    limits: &self.limits,
                }],
                bodies: None,
                optimization: None,
                objectives: &[],
                published: serde_json::Map::new(),
                one_exposure: None,
                maps: Vec::new(),
                time: Vec::new(),
                one_moment: None,
                history: &self.history,
                kept: None,
                gap: None,
                scenarios: None,
                found_window: None,
                found_response: &[],
                deviation: None,
                levels: None,
                ceiling: None,
                movies: Vec::new(),
                scene: None,
                job_text: "a = \"</pre><b>\"",
                notes: vec!["z is moved".to_owned()],
                warnings: vec!["x < y".to_owned()],
                timings: vec![Timing {
                    name: "optimizing".to_owned(),
                    seconds: 2.0,
                }],
            }
        }
    }

    #[test]
    fn json_holds_the_numbers_and_no_others_change_between_runs() {
        let sample = Sample::new();
        let evaluation = sample.evaluation();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("report.json");
        write_json(&path, &sample.data(&evaluation)).unwrap();
        let json: serde_json::Value =
            serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
        assert_eq!(json["schema"], "tomolith.report/1");
        for (name, value) in &evaluation.measures.0 {
            assert_eq!(json["evaluation"][name].as_f64(), *value, "{name}");
        }
        assert!((json["evaluation"]["iou"].as_f64().unwrap() - 1.0).abs() < 1e-12);
        assert_eq!(json["optimization"], serde_json::Value::Null);
        assert_eq!(json["published"], serde_json::json!({}));
        let farthest = evaluation.farthest.unwrap();
        let place = &json["evaluation"]["farthest"];
        assert_eq!(place["at_xyz_mm"], serde_json::json!(farthest.at_mm));
        assert_eq!(place["side"], serde_json::json!(farthest.side));
        let models = &json["run"]["models"];
        assert_eq!(models["evaluation"], "parallel: one slice serves all");
        assert_eq!(json["history"]["forward_calls"], 8);
        assert_eq!(json["run"]["timings_s"]["optimizing"], 2.0);
        assert_eq!(json["lights"][0]["budget"]["turns"], 12.5);
        assert_eq!(json["lights"][0]["canvas"], serde_json::json!([32, 20]));
        let limit = serde_json::json!({
            "cause": "turning", "loss_in_iou": 0.25, "key": "light.angles",
            "advice": "It turns. Raise `light.angles`.",
        });
        assert_eq!(json["limits"], serde_json::json!([limit]));
        assert_eq!(json["exposure"], serde_json::Value::Null);
        let mut other = sample.data(&evaluation);
        (other.created, other.timings[0].seconds) = ("tomorrow", 9.0);
        let mut other = json::report_json(&other);
        assert_ne!(other, json);
        other["run"] = json["run"].clone();
        assert_eq!(other, json);
    }

    #[test]
    fn the_page_in_docs_has_every_key_of_the_report() {
        let page = include_str!("../../../docs/report.md");
        let sample = Sample::new();
        let json = json::report_json(&sample.data(&sample.evaluation()));
        let is_metric = |key: &str| tomolith_metrics::METRICS.iter().any(|m| m.name == key);
        for part in [&json, &json["evaluation"]] {
            for key in part.as_object().unwrap().keys() {
                assert!(
                    is_metric(key) || page.contains(&format!("`{key}`")),
                    "{key}"
                );
            }
        }
    }

    /// A page without the program that draws it.
    fn text_of(page: &str) -> &str {
        &page[..page.rfind("<script>").unwrap()]
    }

    /// The page of a sample: its text, and it itself.
    fn page_of(data: &ReportData<'_>) -> (String, page::Page) {
        let page = page::report_page(data).unwrap();
        (text_of(&page.html()).to_owned(), page)
    }

    #[test]
    fn the_page_is_whole_and_nothing_gets_out_of_its_text() {
        let sample = Sample::new();
        let evaluation = sample.evaluation();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("report.html");
        write_html(&path, &sample.data(&evaluation)).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.starts_with("<!doctype html>") && text.ends_with("</html>\n"));
        let text = text_of(&text);
        for bad in ["<script>alert", "</pre><b>", "x < y", "NaN", "src=\"/"] {
            assert!(!text.contains(bad), "{bad}");
        }
        assert!(text.contains("<p>x &lt; y</p>") && text.contains("&lt;script&gt;"));
        // Target, dose and error for readers without a script
        assert_eq!(text.matches("data:image/png;base64,").count(), 3);
        // The file is read again as it was
        let (_, page) = page_of(&sample.data(&evaluation));
        let read = page::Page::read(&path).unwrap();
        assert_eq!(read.data, page.data);
        assert_eq!((&read.blobs, &read.plain), (&page.blobs, &page.plain));
        let report = &page.data["runs"][0]["report"];
        assert_eq!(report["part"], "disc <script>alert(1)</script>");
        std::fs::write(&path, "<html></html>").unwrap();
        assert!(matches!(page::Page::read(&path), Err(Error::Io { .. })));
    }

    #[test]
    fn volumes_films_and_surface_of_the_page_are_those_of_the_run() {
        let sample = Sample::new();
        let evaluation = sample.evaluation();
        let print = Print::new(&sample.labels, &sample.response).unwrap();
        let deviation = print.deviation().unwrap();
        let mut data = sample.data(&evaluation);
        data.deviation = Some(&deviation);
        let (_, page) = page_of(&data);
        let run = &page.data["runs"][0];
        let bytes = |id: &serde_json::Value| {
            let name = format!("blob-0-{}", id.as_str().unwrap());
            let (_, text) = page.blobs.iter().find(|(id, _)| *id == name).unwrap();
            page::blob::unpacked(text).unwrap()
        };
        let volume = |kind: &str| {
            let mut all = run["volumes"].as_array().unwrap().iter();
            all.find(|info| info["kind"] == kind).unwrap().clone()
        };
        let labels = volume("labels");
        assert_eq!(bytes(&labels["id"]), sample.labels.values);
        let response = volume("response");
        assert_eq!(response["shape_zyx"], serde_json::json!([6, 20, 22]));
        let [low, high] = ["low", "high"].map(|end| response[end].as_f64().unwrap());
        for (code, value) in bytes(&response["id"]).iter().zip(&sample.response.values) {
            let back = low + f64::from(*code) / 255.0 * (high - low);
            assert!((back - f64::from(*value)).abs() <= 0.51 * (high - low) / 255.0);
        }
        let film = &run["films"][0];
        assert_eq!([&film["frames"], &film["every"]], [9, 1]);
        assert_eq!(film["of"], serde_json::json!([9, 4, 6]));
        assert_eq!(bytes(&film["id"])[6], 255);
        let surface = &deviation.surface;
        let expected = 8 * surface.corners.len() + 12 * surface.triangles.len();
        assert_eq!(bytes(&run["surface"]["id"]).len(), expected);
        assert_eq!(run["history"]["process_window"][1], serde_json::Value::Null);
        assert_eq!(run["history"]["response.steepness"][2], 12.0);
    }

    #[test]
    fn many_lights_share_the_room_for_patterns() {
        let sample = Sample::new();
        let evaluation = sample.evaluation();
        let mut patterns = Patterns::dark(PatternGrid::full_turn(200, 0.0, 100, 100, 0.1));
        let values = patterns.values.iter_mut().enumerate();
        values.for_each(|(i, v)| *v = (i * 7919 % 10007) as f32);
        let mut data = sample.data(&evaluation);
        data.lights[0].patterns = &patterns;
        data.lights = vec![data.lights[0]; 8];
        let (text, page) = page_of(&data);
        assert!(text.len() < 6_000_000, "{} bytes", text.len());
        let info = &page.data["runs"][0]["films"][7];
        let found = [&info["frames"], &info["binned"], &info["rows"]];
        assert_eq!(found, [200, 3, 34]);
        // The volumes keep their own
        assert_eq!(page.data["runs"][0]["volumes"][0]["reduced"], 1);
    }

    #[test]
    fn large_volumes_are_reduced_until_they_fit() {
        let sample = Sample::new();
        let evaluation = sample.evaluation();
        let grid = VolumeGrid::centered([4, 300, 400], 0.1);
        let noise = |i: usize| (i * 7919 % 10007) as f32;
        let response = Volume::new(grid.clone(), (0..grid.len()).map(noise).collect());
        let labels = Volume::filled(grid, PART);
        let mut data = sample.data(&evaluation);
        let first = &mut data.species[0];
        (first.labels, first.response, first.inside) = (&labels, &response, &response);
        let (_, page) = page_of(&data);
        for info in page.data["runs"][0]["volumes"].as_array().unwrap() {
            assert_eq!(info["reduced"], 3);
            assert_eq!(info["shape_zyx"], serde_json::json!([2, 100, 134]));
        }
    }

    #[test]
    fn the_time_to_print_is_the_sum_of_lights_or_the_longest_of_a_schedule() {
        let sample = Sample::new();
        let evaluation = sample.evaluation();
        let mut data = sample.data(&evaluation);
        let time_of = |data: &ReportData<'_>| json::report_json(data)["time_to_print_s"].clone();
        let mut second = data.lights[0];
        second.budget.time_s = Some(25.0);
        data.lights.push(second);
        assert_eq!(time_of(&data), 100.0);
        let irradiance = Irradiance {
            white_mw_per_cm2: 4.0,
            peak_mw_per_cm2: None,
        };
        for light in &mut data.lights {
            light.irradiance = Some(irradiance);
        }
        assert_eq!(time_of(&data), 75.0);
        data.lights[1].budget.time_s = None;
        assert!(time_of(&data).is_null());
    }

    #[test]
    fn a_gray_target_is_judged_by_its_errors() {
        let sample = Sample::new();
        let mut wanted = sample.response.clone();
        wanted.values.iter_mut().for_each(|v| *v += 0.04);
        let print = || Print::new(&sample.labels, &sample.response).unwrap();
        let evaluation = evaluate(&print().with_gray(&wanted, 0.05).unwrap());
        let mut data = sample.data(&evaluation);
        data.species[0].inside = &wanted;
        let (page, _) = page_of(&data);
        tomolith_core::contains!(page, "100 % of the voxels lies within ±0.05");
        let json = json::report_json(&data);
        let rms = json["evaluation"]["rms_error"].as_f64().unwrap();
        assert!((rms - 0.04).abs() < 1e-6, "{rms}");
        assert_eq!(json["evaluation"]["band_half_width"], 0.05);
    }

    #[test]
    fn an_empty_print_still_has_a_page() {
        let mut sample = Sample::new();
        sample.response.values.fill(0.0);
        sample.history.clear();
        let evaluation = sample.evaluation();
        let (page, _) = page_of(&sample.data(&evaluation));
        assert!(page.contains("No threshold prints any of the part.") && !page.contains("NaN"));
        let json = json::report_json(&sample.data(&evaluation));
        assert_eq!(json["evaluation"]["iou"], 0.0);
        assert!(json["evaluation"]["hausdorff_mm"].is_null());
    }

    #[test]
    fn volumes_that_do_not_belong_together_are_refused() {
        let sample = Sample::new();
        let evaluation = sample.evaluation();
        let mut data = sample.data(&evaluation);
        let small = Volume::filled(VolumeGrid::centered([1, 1, 1], 1.0), 0.0f32);
        data.species[0].inside = &small;
        let refused = write_html(Path::new("r.html"), &data);
        assert!(matches!(refused, Err(Error::Shape { .. })));
    }
}
