//! `tomolith analyze`: what a printer and a resin allow, from formulas.

use crate::answer::{Answer, Files, percent};
use crate::arguments::Manner;
use clap::{Args, Subcommand};
use serde_json::json;
use tomolith::Result;
use tomolith::error::{above_zero, in_range};
use tomolith::report::number::significant;
use tomolith::report::plot::{Axis, Plot};
use tomolith::units::concise;
use tomolith_planning::buildup::{TurningVial, wall_rate};
use tomolith_planning::impulse::Post;
use tomolith_planning::measured::csv;
use tomolith_planning::plan::LONGEST_S;
use tomolith_planning::quantity::{IRRADIANCE, VOLUMETRIC_DOSE};
use tomolith_planning::voxel::{FASTEST_DEG_PER_S, Setup};

const EXAMPLES: &str = "\
Examples:
  tomolith analyze voxel --pixels 1000 --fps 60 --penetration-mm 10 --dose-time-s 5 --radius-mm 8
  tomolith analyze buildup --radius-mm 8 --penetration-mm 0.8 --turn-deg-per-s 5 --dose-time-s 10 --output buildup
  tomolith analyze impulse --width 1 5 --step-deg 1 2 --output impulse
Equations: docs/analysis.md";

/// Points of a curve.
const POINTS: usize = 200;

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct AnalyzeArguments {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Effective voxel size, and the radius at which pixel and angle step cross
    Voxel(VoxelArguments),
    /// Dose over time and curing time at any radius of an absorbing resin
    Buildup(BuildupArguments),
    /// How wide a square post comes out, plain and corrected
    Impulse(ImpulseArguments),
}

#[derive(Debug, Args)]
struct VoxelArguments {
    /// Pixels across the vial
    #[arg(long)]
    pixels: f64,
    /// Frames a second
    #[arg(long)]
    fps: f64,
    /// Depth at which the light has fallen to 1/e
    #[arg(long, value_name = "MM")]
    penetration_mm: f64,
    /// Time in which unattenuated light cures the resin: critical dose over absorbed power
    #[arg(long, value_name = "S", required_unless_present = "critical_dose")]
    dose_time_s: Option<f64>,
    /// In its place: dose at which the resin gels, mJ/mm³ (or with its unit)
    #[arg(
        long,
        value_name = "DOSE",
        requires = "irradiance",
        conflicts_with = "dose_time_s"
    )]
    critical_dose: Option<String>,
    /// And irradiance at the vial, mW/cm² (or with its unit)
    #[arg(long, value_name = "IRRADIANCE", requires = "critical_dose")]
    irradiance: Option<String>,
    /// Speed of the stage; fast enough when left out
    #[arg(long, value_name = "DEG_PER_S")]
    turn_deg_per_s: Option<f64>,
    /// Inner radius of the vial
    #[arg(long, value_name = "MM", default_value_t = 8.0)]
    radius_mm: f64,
    #[command(flatten)]
    files: Files,
}

#[derive(Debug, Args)]
struct BuildupArguments {
    /// Inner radius of the vial
    #[arg(long, value_name = "MM")]
    radius_mm: f64,
    /// Depth at which the light has fallen to 1/e
    #[arg(long, value_name = "MM")]
    penetration_mm: f64,
    /// Speed of the stage; 0 is a vial at rest
    #[arg(long, value_name = "DEG_PER_S", default_value_t = 5.0)]
    turn_deg_per_s: f64,
    /// Radii in units of the vial's, 0 to 1
    #[arg(long, num_args = 1.., default_values_t = [0.0, 0.5, 1.0])]
    at: Vec<f64>,
    /// Where the points begin, degrees behind the side that faces the light
    #[arg(long, value_name = "DEG", default_value_t = 0.0)]
    phase_deg: f64,
    /// Time in which unattenuated light cures the resin: also says the curing times
    #[arg(long, value_name = "S")]
    dose_time_s: Option<f64>,
    /// Until when the curves go
    #[arg(long, value_name = "S", default_value_t = 72.0)]
    seconds: f64,
    #[command(flatten)]
    files: Files,
}

#[derive(Debug, Args)]
struct ImpulseArguments {
    /// Pixels across the disc
    #[arg(long, default_value_t = 64)]
    pixels: usize,
    /// Edges of the post, pixels
    #[arg(long, num_args = 1.., default_values_t = [1.0, 5.0])]
    width: Vec<f64>,
    /// Radii of its corner, in units of the disc's
    #[arg(long, num_args = 1.., default_values_t = [0.0, 0.5, 0.9])]
    radius: Vec<f64>,
    /// Angle steps, degrees
    #[arg(long, num_args = 1.., default_values_t = [1.0])]
    step_deg: Vec<f64>,
    #[command(flatten)]
    files: Files,
}

impl AnalyzeArguments {
    pub(crate) fn manner(&self) -> Manner {
        match &self.what {
            What::Voxel(given) => given.files.manner,
            What::Buildup(given) => given.files.manner,
            What::Impulse(given) => given.files.manner,
        }
    }
}

pub(crate) fn analyze(given: &AnalyzeArguments) -> Result<()> {
    match &given.what {
        What::Voxel(given) => voxel(given),
        What::Buildup(given) => buildup(given),
        What::Impulse(given) => impulse(given),
    }
}

/// Even steps over a range.
fn steps(from: f64, to: f64) -> impl Iterator<Item = f64> {
    (0..=POINTS).map(move |i| from + (to - from) * i as f64 / POINTS as f64)
}

fn voxel(given: &VoxelArguments) -> Result<()> {
    above_zero("--radius-mm", given.radius_mm)?;
    above_zero("--penetration-mm", given.penetration_mm)?;
    let dose_time_s = match (given.dose_time_s, &given.critical_dose, &given.irradiance) {
        (None, Some(dose), Some(irradiance)) => {
            let dose = VOLUMETRIC_DOSE.parse("--critical-dose", dose)?;
            let absorbed =
                IRRADIANCE.parse("--irradiance", irradiance)? / 100.0 / given.penetration_mm;
            dose / absorbed
        }
        (time, ..) => time.unwrap_or(0.0),
    };
    let setup = Setup {
        pixels: given.pixels,
        fps: given.fps,
        dose_time_s,
        penetration_mm: given.penetration_mm,
        turn_deg_per_s: given.turn_deg_per_s,
    };
    setup.check()?;
    let (size, printed) = (
        setup.corrected(given.radius_mm),
        setup.printed(given.radius_mm),
    );
    let mut answer = Answer::default();
    let um = |mm: f64| format!("{} µm", significant(1e3 * mm, 4));
    answer.line(
        "voxel",
        format!(
            "{} at R = {} mm",
            um(size.voxel_mm()),
            significant(given.radius_mm, 4)
        ),
    );
    answer.line("pixel", um(size.pixel_mm));
    answer.line(
        "angle step at rim",
        format!(
            "{} ({} angles in a half turn)",
            um(size.step_mm),
            significant(size.angles, 4)
        ),
    );
    let curing = if size.curing_s.is_finite() {
        format!("{} s on the axis", significant(size.curing_s, 4))
    } else {
        answer.warn("no light reaches the axis, which never cures: a resin with a larger penetration depth, or a narrower vial");
        "never on the axis".to_owned()
    };
    answer.line("curing time", curing);
    if size.step_mm > printed.step_mm * 1.001 {
        answer.line(
            "as published",
            format!(
                "{}: counts frames that repeat after a half turn",
                um(printed.step_mm)
            ),
        );
    }
    if size.covered < 1.0 {
        answer.warn(format!(
            "the axis cures after {} of a half turn: not every angle is shown by then; a faster stage, or less light",
            percent(size.covered)
        ));
    }
    let crossing = setup.corrected_crossing_mm();
    answer.line(
        "crossing",
        match (crossing, setup.crossing_mm()) {
            (Some(radius), _) => format!(
                "R* = {} mm: above it the pixel decides",
                significant(radius, 4)
            ),
            (None, Some(radius)) => format!(
                "none: the angle step decides at every radius (as published: R* = {} mm)",
                significant(radius, 4)
            ),
            (None, None) if size.step_mm > size.pixel_mm => {
                "none: the angle step decides at every radius".to_owned()
            }
            (None, None) => "none: the pixel decides at every radius".to_owned(),
        },
    );
    answer.set("at_radius", size);
    answer.set("as_published", printed);
    answer.set("voxel_mm", size.voxel_mm());
    answer.set("crossing_mm", crossing);
    answer.set("crossing_as_published_mm", setup.crossing_mm());
    let files = voxel_files(given, &setup);
    answer.finish(&given.files, &files)
}

/// Sizes against the radius of the vial, as a table and a plot.
fn voxel_files(given: &VoxelArguments, setup: &Setup) -> [(&'static str, String); 2] {
    let most = (2.0 * given.radius_mm).max(1.3 * setup.crossing_mm().unwrap_or(0.0));
    let rows: Vec<Vec<f64>> = steps(0.0, most)
        .skip(1)
        .map(|radius| {
            let (size, printed) = (setup.corrected(radius), setup.printed(radius));
            vec![
                radius,
                size.pixel_mm,
                size.step_mm,
                printed.step_mm,
                size.voxel_mm(),
                size.curing_s,
                size.covered,
            ]
        })
        .collect();
    let names = [
        "radius_mm",
        "pixel_mm",
        "step_mm",
        "step_as_published_mm",
        "voxel_mm",
        "curing_s",
        "covered",
    ];
    let column =
        |c: usize| -> Vec<[f64; 2]> { rows.iter().map(|row| [row[0], 1e3 * row[c]]).collect() };
    let high = rows.iter().map(|row| 1e3 * row[4]).fold(0.0, f64::max);
    let mut plot = Plot::new(
        Axis::linear("radius of the vial, mm", 0.0, most),
        Axis::linear("size, µm", 0.0, 1.1 * high),
    );
    plot.line(&column(3), "still", "angle step, as published");
    plot.line(&column(2), "void", "angle step");
    plot.line(&column(1), "part", "pixel");
    if let Some(crossing) = setup.corrected_crossing_mm() {
        plot.line_at(crossing, "gel", "R*");
    }
    let plot = plot.file("Pixel and angle step against the radius");
    [("voxel.csv", csv(&names, &rows)), ("voxel.svg", plot)]
}

/// Refuses numbers of a turning vial that cannot be.
fn must_turn(given: &BuildupArguments) -> Result<()> {
    for (key, value) in [
        ("--radius-mm", given.radius_mm),
        ("--penetration-mm", given.penetration_mm),
        ("--dose-time-s", given.dose_time_s.unwrap_or(1.0)),
        ("--seconds", given.seconds),
    ] {
        above_zero(key, value)?;
    }
    for (key, seconds) in [
        ("--dose-time-s", given.dose_time_s.unwrap_or(1.0)),
        ("--seconds", given.seconds),
    ] {
        let accepted = format!("at most {} s", concise(LONGEST_S));
        in_range(seconds <= LONGEST_S, key, seconds, accepted)?;
    }
    let (turn, phase) = (given.turn_deg_per_s, given.phase_deg);
    let may_turn = (0.0..=FASTEST_DEG_PER_S).contains(&turn);
    let accepted = format!("0 to {} degrees a second", concise(FASTEST_DEG_PER_S));
    in_range(may_turn, "--turn-deg-per-s", turn, accepted)?;
    let is_angle = (-360.0..=360.0).contains(&phase);
    in_range(is_angle, "--phase-deg", phase, "-360 to 360 degrees")?;
    given.at.iter().try_for_each(|&r| {
        let accepted = "radii in units of the vial's, 0 to 1";
        in_range((0.0..=1.0).contains(&r), "--at", r, accepted)
    })
}

fn buildup(given: &BuildupArguments) -> Result<()> {
    must_turn(given)?;
    let vial = TurningVial {
        radius_mm: given.radius_mm,
        penetration_mm: given.penetration_mm,
        turn_deg_per_s: given.turn_deg_per_s,
    };
    let phase = given.phase_deg.to_radians();
    let mut answer = Answer::default();
    let mut found = Vec::new();
    for &r in &given.at {
        let rate = vial.lasting_rate(r, phase);
        let dose = vial.dose(r, phase, given.seconds);
        let mut text = format!(
            "mean rate {}, dose {} s after {} s",
            significant(rate, 5),
            significant(dose, 4),
            significant(given.seconds, 4)
        );
        let cured = given.dose_time_s.map(|dose| vial.curing_s(r, phase, dose));
        if let Some(cured) = cured {
            text += &cured.map_or_else(
                || ", never cured".to_owned(),
                |s| format!(", cured after {} s", significant(s, 4)),
            );
        }
        answer.line(&format!("r/R = {}", significant(r, 3)), text);
        found.push(
            json!({ "r": r, "mean_rate": rate, "dose_s": dose, "curing_s": cured.flatten() }),
        );
    }
    answer.set("points", found);
    if given.turn_deg_per_s > 0.0 {
        let kappa = given.radius_mm / given.penetration_mm;
        let ratio = wall_rate(kappa) / (-kappa).exp();
        answer.line(
            "wall over axis",
            format!("{} (in closed form)", significant(ratio, 4)),
        );
        answer.set("wall_over_axis", ratio);
    }
    let [dose, dose_plot] = over_time(given, &vial);
    let [rate, rate_plot] = over_radius(given, &vial);
    let files = [
        ("buildup.csv", dose),
        ("buildup.svg", dose_plot),
        ("radial.csv", rate),
        ("radial.svg", rate_plot),
    ];
    answer.finish(&given.files, &files)
}

/// Doses at the radii of `--at` against time, as a table and a plot.
fn over_time(given: &BuildupArguments, vial: &TurningVial) -> [String; 2] {
    let phase = given.phase_deg.to_radians();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for t in steps(0.0, given.seconds) {
        let doses = given.at.iter().map(|r| vial.dose(*r, phase, t));
        rows.push(std::iter::once(t).chain(doses).collect());
    }
    let names: Vec<String> = given.at.iter().map(|r| format!("dose_s_at_{r}")).collect();
    let names: Vec<&str> = std::iter::once("time_s")
        .chain(names.iter().map(String::as_str))
        .collect();
    let high = rows
        .iter()
        .flat_map(|row| row[1..].iter().copied())
        .fold(0.0, f64::max);
    let mut plot = Plot::new(
        Axis::linear("time, s", 0.0, given.seconds),
        Axis::linear("dose, s of unattenuated light", 0.0, 1.05 * high),
    );
    for (i, r) in given.at.iter().enumerate() {
        let line: Vec<[f64; 2]> = rows.iter().map(|row| [row[0], row[i + 1]]).collect();
        plot.line(
            &line,
            ["part", "void", "accent", "gel", "still"][i % 5],
            &format!("r/R = {r}"),
        );
    }
    [csv(&names, &rows), plot.file("Dose against time")]
}

/// Mean rate and curing time against the radius, as a table and a plot.
fn over_radius(given: &BuildupArguments, vial: &TurningVial) -> [String; 2] {
    let phase = given.phase_deg.to_radians();
    let across: Vec<Vec<f64>> = steps(0.0, 1.0)
        .map(|r| {
            let cured = given
                .dose_time_s
                .and_then(|dose| vial.curing_s(r, phase, dose));
            vec![r, vial.lasting_rate(r, phase), cured.unwrap_or(f64::NAN)]
        })
        .collect();
    let [low, high] = (across.iter()).fold([f64::INFINITY, 0.0f64], |[low, high], row| {
        [low.min(row[1]), high.max(row[1])]
    });
    let mut radial = Plot::new(
        Axis::linear("r/R", 0.0, 1.0),
        Axis::log("mean rate", low, high),
    );
    let line: Vec<[f64; 2]> = across.iter().map(|row| [row[0], row[1]]).collect();
    if given.turn_deg_per_s > 0.0 {
        radial.line(&line, "accent", "mean over a turn");
        let kappa = given.radius_mm / given.penetration_mm;
        let closed = [[0.0, (-kappa).exp()], [1.0, wall_rate(kappa)]];
        radial.dots(&closed, "gel", "closed forms");
    } else {
        radial.line(&line, "accent", "at rest");
    }
    let table = csv(&["r", "mean_rate", "curing_s"], &across);
    [table, radial.file("Mean rate against the radius")]
}

fn impulse(given: &ImpulseArguments) -> Result<()> {
    let mut posts = Vec::new();
    for &step_deg in &given.step_deg {
        for &width in &given.width {
            for &radius in &given.radius {
                let post = Post {
                    pixels: given.pixels,
                    width,
                    radius,
                    step_deg,
                };
                post.check()?;
                posts.push(post);
            }
        }
    }
    let mut answer = Answer::default();
    let mut rows = Vec::new();
    let mut profiles: Vec<(String, String)> = Vec::new();
    // Names of as many digits each, so that sorted names are in order
    let digits = posts.len().saturating_sub(1).to_string().len();
    for (i, post) in posts.iter().enumerate() {
        let (plain, corrected) = (post.plain(), post.corrected());
        let ([px, py], [cx, cy]) = (plain.fwhm(), corrected.fwhm());
        answer.line(
            &format!("w {} r/R {} δθ {}°", post.width, post.radius, post.step_deg),
            format!(
                "FWHM/w plain {} × {}, corrected {} × {}",
                significant(px / post.width, 3),
                significant(py / post.width, 3),
                significant(cx / post.width, 3),
                significant(cy / post.width, 3)
            ),
        );
        rows.push(vec![post.width, post.radius, post.step_deg, px, py, cx, cy]);
        if given.files.output.is_some() {
            let (a, b) = (plain.profile(true), corrected.profile(true));
            profiles.push((
                format!("profile_{i:0digits$}.svg"),
                profile_plot(post, &a, &b),
            ));
        }
    }
    let names = [
        "width",
        "radius",
        "step_deg",
        "plain_x",
        "plain_y",
        "corrected_x",
        "corrected_y",
    ];
    answer.set("columns", names);
    answer.set("fwhm", &rows);
    let mut files = vec![("impulse.csv", csv(&names, &rows))];
    files.extend(
        profiles
            .iter()
            .map(|(name, text)| (name.as_str(), text.clone())),
    );
    answer.finish(&given.files, &files)
}

/// Both profiles, each divided by its largest value.
fn profile_plot(post: &Post, plain: &[[f64; 2]], corrected: &[[f64; 2]]) -> String {
    let normal = |profile: &[[f64; 2]]| -> Vec<[f64; 2]> {
        let most = profile
            .iter()
            .map(|p| p[1])
            .fold(f64::MIN_POSITIVE, f64::max);
        profile.iter().map(|[s, d]| [*s, d / most]).collect()
    };
    let reach = plain.last().map_or(1.0, |p| p[0]);
    let half = post.width / 2.0;
    let mut plot = Plot::new(
        Axis::linear("pixels from the middle of the post", -reach, reach),
        Axis::linear("dose over its largest value", 0.0, 1.1),
    );
    plot.band(-half, half, "window", "post");
    plot.line(&normal(plain), "void", "plain");
    plot.line(&normal(corrected), "accent", "corrected");
    plot.file("Profile of a post along x")
}
