//! `tomolith calibrate`: frames for setting a machine up, and fits of what was measured.

use crate::answer::{Answer, Files, percent, with_error};
use crate::arguments::Manner;
use crate::screen::{done, say};
use clap::{Args, Subcommand, ValueEnum};
use serde_json::json;
use std::path::{Path, PathBuf};
use tomolith::columns::{Columns, read_pairs};
use tomolith::error::above_zero;
use tomolith::exposure::{CALIBRATIONS, Calibration, PrinterSpec};
use tomolith::grid::PatternGrid;
use tomolith::io::channel::Channel;
use tomolith::job::Job;
use tomolith::job::export::{calibrate as of_job, draw};
use tomolith::report::number::significant;
use tomolith::response::curve::Curve;
use tomolith::units::concise;
use tomolith::{Error, Result};
use tomolith_planning::absorbance::{self, Attenuation, Coefficient, MediumFit};
use tomolith_planning::discs::{self, Disc, Discs, DoseFit};
use tomolith_planning::gray::{CurveForm, GrayCurve, Polynomial};
use tomolith_planning::kinetics;
use tomolith_planning::measured::csv;
use tomolith_planning::quantity::{AREAL_DOSE, IRRADIANCE};
use tomolith_planning::response::{Axes, ResponseFit};

const CALIBRATE: &str = "\
Examples:
  tomolith calibrate --canvas 1920 1080 --output calibration
  tomolith calibrate --job examples/09-printer.toml siemens_star axis_lines --output calibration
  tomolith calibrate gray examples/calibration/gray-visible.csv --output gray
  tomolith calibrate response examples/calibration/stiffness.csv --log-response --output stiffness
  tomolith calibrate kinetics examples/calibration/balls-uv.csv --at 20 --output balls
  tomolith calibrate absorbance examples/calibration/absorbance.csv --output resin
  tomolith calibrate discs --canvas 1920 1080 --pixel-pitch-mm 0.0138 --irradiance 25 --from 20 --to 400 --output discs
  tomolith calibrate dose examples/calibration/discs.csv --output dose
Frames: border, checkerboard, crosshair, gray_steps, siemens_star, axis_lines, orientation";

#[derive(Debug, Args)]
#[command(after_help = CALIBRATE, args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(crate) struct CalibrateArguments {
    #[command(subcommand)]
    fit: Option<Fit>,
    /// Frames to draw; all of them when left out
    frames: Vec<String>,
    /// Job whose `printer` table and light the frames are drawn for
    #[arg(long, value_name = "JOB", conflicts_with = "canvas")]
    job: Option<PathBuf>,
    /// Pixels of the device, without a job
    #[arg(long, num_args = 2, value_names = ["COLUMNS", "ROWS"], required_unless_present = "job")]
    canvas: Option<Vec<usize>>,
    /// Bit depth, without a job
    #[arg(long, default_value_t = 8, conflicts_with = "job")]
    bits: u32,
    /// Channel of color images that shows the frames, without a job: red, green or blue; gray when left out
    #[arg(long, value_parser = channel, conflicts_with = "job")]
    channel: Option<Channel>,
    /// New folder for the frames, NAME.png each
    #[arg(long, short, value_name = "DIR", required = true)]
    output: Option<PathBuf>,
    #[command(flatten)]
    manner: Manner,
}

#[derive(Debug, Subcommand)]
enum Fit {
    /// Gray curve from a power meter's table: gray value, irradiance
    Gray(GrayArguments),
    /// Response from measured pairs: dose, response
    Response(ResponseArguments),
    /// Inhibitor and kinetics from curing times: irradiance (mW/cm²), time (s)
    Kinetics(KineticsArguments),
    /// Absorption and scattering from a spectrometer's absorbance: path_mm, resin, with_particles
    Absorbance(AbsorbanceArguments),
    /// Images for a calibration print: discs at rising doses in a resin at rest
    Discs(DiscsArguments),
    /// Critical dose and penetration depth from what the discs became: discs.csv with one column filled or several
    Dose(DoseArguments),
}

/// A table that is fitted, and what becomes of it.
#[derive(Debug, Args)]
struct Measured {
    /// CSV file
    table: PathBuf,
    #[command(flatten)]
    files: Files,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum GrayForm {
    Monotone,
    Line,
    Quadratic,
}

#[derive(Debug, Args)]
struct GrayArguments {
    #[command(flatten)]
    measured: Measured,
    /// Gray value of white
    #[arg(long, default_value_t = 255.0)]
    top: f64,
    /// The curve that is written; the others are fitted for comparison
    #[arg(long, value_enum, default_value = "monotone")]
    form: GrayForm,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum ResponseForm {
    Logistic,
    Table,
}

#[derive(Debug, Args)]
struct ResponseArguments {
    #[command(flatten)]
    measured: Measured,
    /// What is laid through the points
    #[arg(long, value_enum, default_value = "logistic")]
    form: ResponseForm,
    /// Also fit the logistic's asymmetry
    #[arg(long)]
    asymmetry: bool,
    /// Fit against the decimal logarithm of the dose
    #[arg(long)]
    log_dose: bool,
    /// Fit the decimal logarithm of the response
    #[arg(long)]
    log_response: bool,
}

#[derive(Debug, Args)]
struct KineticsArguments {
    #[command(flatten)]
    measured: Measured,
    /// Also say the curing time at this irradiance, `20` or `"0.2 mW/mm2"`
    #[arg(long, value_name = "IRRADIANCE")]
    at: Option<String>,
}

#[derive(Debug, Args)]
struct AbsorbanceArguments {
    #[command(flatten)]
    measured: Measured,
    /// Share of what the particles take that they scatter; 1 when left out, as titania at 405 nm
    #[arg(long)]
    albedo: Option<f64>,
}

#[derive(Debug, Args)]
struct DiscsArguments {
    /// Pixels of the device
    #[arg(long, num_args = 2, value_names = ["COLUMNS", "ROWS"], required = true)]
    canvas: Vec<usize>,
    /// Edge of a pixel at the resin
    #[arg(long, value_name = "MM")]
    pixel_pitch_mm: f64,
    /// Discs along and down
    #[arg(long, num_args = 2, value_names = ["ALONG", "DOWN"], default_values_t = [5, 5])]
    grid: Vec<usize>,
    /// Irradiance at white, mW/cm² (or with its unit)
    #[arg(long)]
    irradiance: String,
    /// Lowest dose, mJ/cm² (or with its unit)
    #[arg(long)]
    from: String,
    /// Highest dose
    #[arg(long)]
    to: String,
    /// Channel of color images that shows the discs: red, green or blue; gray when left out
    #[arg(long, value_parser = channel)]
    channel: Option<Channel>,
    /// New folder for frames, schedule.csv and discs.csv
    #[arg(long, short, value_name = "DIR")]
    output: PathBuf,
    #[command(flatten)]
    manner: Manner,
}

#[derive(Debug, Args)]
struct DoseArguments {
    #[command(flatten)]
    measured: Measured,
    /// Penetration depth, where depths did not give it: makes the critical dose one per volume
    #[arg(long, value_name = "MM")]
    penetration_mm: Option<f64>,
}

impl CalibrateArguments {
    pub(crate) fn manner(&self) -> Manner {
        match &self.fit {
            None => self.manner,
            Some(Fit::Gray(given)) => given.measured.files.manner,
            Some(Fit::Response(given)) => given.measured.files.manner,
            Some(Fit::Kinetics(given)) => given.measured.files.manner,
            Some(Fit::Absorbance(given)) => given.measured.files.manner,
            Some(Fit::Discs(given)) => given.manner,
            Some(Fit::Dose(given)) => given.measured.files.manner,
        }
    }
}

pub(crate) fn calibrate(given: &CalibrateArguments) -> Result<()> {
    match &given.fit {
        None => frames(given),
        Some(Fit::Gray(given)) => gray(given),
        Some(Fit::Response(given)) => response(given),
        Some(Fit::Kinetics(given)) => of_times(given),
        Some(Fit::Absorbance(given)) => of_absorbance(given),
        Some(Fit::Discs(given)) => print_of_discs(given),
        Some(Fit::Dose(given)) => dose(given),
    }
}

fn gray(given: &GrayArguments) -> Result<()> {
    above_zero("--top", given.top)?;
    let path = &given.measured.table;
    let table = points(path, ["gray value", "irradiance (mW/cm²)"])?;
    let form = match given.form {
        GrayForm::Monotone => CurveForm::Monotone,
        GrayForm::Line => CurveForm::Line,
        GrayForm::Quadratic => CurveForm::Quadratic,
    };
    let found = GrayCurve::new(&table, given.top, form).map_err(|e| in_file(e, path))?;
    let mut answer = Answer::default();
    answer.line("points", table.doses.len().to_string());
    let mut fits = Vec::new();
    for (degree, name) in [(1, "line"), (2, "quadratic")] {
        let Ok(fit) = Polynomial::fit(&table, degree) else {
            continue;
        };
        let residuals = fit.residuals(&table);
        // A share of nothing is no number: black points of 0
        let known = residuals.iter().filter(|r| r.is_finite());
        let worst = known.fold(0.0f64, |worst, r| worst.max(r.abs()));
        let usable = fit.usable(given.top);
        let range = match usable {
            Some([low, high]) => format!("usable from gray {low:.1} to {high:.1}"),
            None => "usable nowhere".to_owned(),
        };
        answer.line(
            name,
            format!("{}, off by up to {}, {range}", fit.text(), percent(worst)),
        );
        answer.set(
            name,
            json!({ "coefficients": fit.coefficients, "residuals": residuals, "usable": usable }),
        );
        fits.push((name, fit));
    }
    found
        .notes
        .iter()
        .for_each(|note| answer.warn(note.as_str()));
    answer.set("form", form);
    let of_job = "printer.gray_curve_file takes the gray_curve.csv of --output";
    answer.line("in a job", of_job.to_owned());
    answer.set("points", found.points());
    let fits: Vec<(&str, &Polynomial)> = fits.iter().map(|(name, fit)| (*name, fit)).collect();
    let files = [
        ("gray_curve.csv", found.file("mW/cm2")),
        ("gray_curve.svg", found.plot(&table, &fits)),
    ];
    answer.finish(&given.measured.files, &files)
}

/// The points of a table whose columns, with these names, are no dose and response.
fn points(path: &Path, [first, second]: [&str; 2]) -> Result<Curve> {
    let pairs = read_pairs(path, &format!("{first} and {second}"))?;
    Curve::of_pairs(&pairs).map_err(|mut error| {
        // Of finite pairs, there can only be too few
        if let Error::Config { key, .. } = &mut error {
            *key = first.to_owned();
        }
        in_file(error, path)
    })
}

/// Names the file in errors of what it holds.
fn in_file(error: Error, path: &Path) -> Error {
    match error {
        Error::Config {
            key,
            found,
            accepted,
            ..
        } if !key.starts_with("--") => Error::format(path, format!("{key}: {found}"), accepted),
        other => other,
    }
}

fn response(given: &ResponseArguments) -> Result<()> {
    let path = &given.measured.table;
    let pairs = read_pairs(path, "dose and response")?;
    let axes = Axes {
        log_dose: given.log_dose,
        log_response: given.log_response,
    };
    let fit = match given.form {
        ResponseForm::Logistic => ResponseFit::logistic(&pairs, axes, given.asymmetry),
        ResponseForm::Table if given.log_dose || given.asymmetry => Err(Error::config(
            "--form",
            "a table with --log-dose or --asymmetry",
            "the form logistic, or a table without them: it follows the points on any axis",
        )),
        ResponseForm::Table => ResponseFit::table(&pairs, given.log_response),
    };
    let fit = fit.map_err(|e| in_file(e, path))?;
    let mut answer = Answer::default();
    answer.line("points", pairs.len().to_string());
    if let Some(found) = &fit.logistic {
        let p = &found.params;
        let names = ["lower", "upper", "steepness", "midpoint", "asymmetry"];
        let values = [p.lower, p.upper, p.steepness, p.midpoint, p.asymmetry];
        for (i, (name, value)) in names.into_iter().zip(values).enumerate() {
            let error = found.errors.map(|errors| errors[i]);
            if i < 4 || given.asymmetry {
                answer.line(name, with_error(value, error));
            }
            answer.set(name, json!({ "value": value, "error": error }));
        }
        let errors = found.errors.as_ref().map(|errors| &errors[2..]);
        let advice = match given.asymmetry {
            true => "more doses where the response rises, or leave out --asymmetry",
            false => "more doses where the response rises",
        };
        let mut sizes = values;
        if given.log_dose {
            // A midpoint in decades may be 0: a factor of e counts
            sizes[3] = std::f64::consts::LOG10_E;
        }
        warn_of_loose(&mut answer, &names[2..], &sizes[2..], errors, advice);
        answer.set("measured_rise", fit.measured_rise());
        if let Some([first, last]) = fit.measured_rise()
            && (first > PLATEAU || last < 1.0 - PLATEAU)
        {
            answer.warn(format!(
                "the measured doses cover {} to {} of the rise that was fitted: what the response does outside of them is a guess; measure lower and higher doses, until it hardly changes",
                percent(first),
                percent(last)
            ));
        }
    }
    if let Some(width) = fit.width_10_90() {
        answer.line(
            "10 % to 90 %",
            format!("over {} on the dose axis", significant(width, 3)),
        );
        answer.set("width_10_90", width);
    }
    let unit = if given.log_response { " decades" } else { "" };
    answer.line("left over (rms)", significant(fit.rms, 3) + unit);
    answer.set("rms", fit.rms);
    answer.set("job_table", fit.job_table());
    if given.measured.files.output.is_none() {
        for line in fit.job_table().lines() {
            answer.line("|", line);
        }
    }
    let files = [
        ("response.toml", fit.job_table()),
        ("response.svg", fit.plot()),
    ];
    answer.finish(&given.measured.files, &files)
}

/// Warns of parameters that the points do not fix: any where there are no standard errors, else those whose error is larger than their size.
fn warn_of_loose(
    answer: &mut Answer,
    names: &[&str],
    sizes: &[f64],
    errors: Option<&[f64]>,
    advice: &str,
) {
    let Some(errors) = errors else {
        answer.warn("the points do not fix every parameter: there are no standard errors");
        return;
    };
    let loose = names.iter().zip(sizes).zip(errors);
    let loose: Vec<_> = (loose.filter(|((_, size), error)| **error > size.abs()))
        .map(|((name, _), _)| *name)
        .collect();
    if !loose.is_empty() {
        answer.warn(format!(
            "the points do not fix {}, whose standard error is too large; measure {advice}",
            loose.join(" and ")
        ));
    }
}

/// Warns of kinetics that the points leave open: a range wider than a factor of e, or than two thirds of the orders.
fn warn_of_wide(answer: &mut Answer, ranges: Option<&[[f64; 2]; 4]>) {
    let Some([irradiance, supply, cure, order]) = ranges else {
        answer.warn("the points are too few: there are no ranges");
        return;
    };
    let is_wide = |[low, high]: &[f64; 2]| high / low > std::f64::consts::E;
    let loose: Vec<&str> = [
        ("the lowest irradiance", is_wide(irradiance)),
        ("the inhibitor that flows back", is_wide(supply)),
        ("the cure", is_wide(cure)),
        ("the order of the cure", order[1] - order[0] > 2.0 / 3.0),
    ]
    .into_iter()
    .filter_map(|(name, is_wide)| is_wide.then_some(name))
    .collect();
    if !loose.is_empty() {
        answer.warn(format!(
            "the points do not fix {}: numbers within the ranges in brackets fit about as well; measure more points, and at lower irradiances, at which the inhibitor takes most of the time",
            loose.join(" and ")
        ));
    }
}

fn of_times(given: &KineticsArguments) -> Result<()> {
    let path = &given.measured.table;
    let at = given.at.as_ref();
    let at = at.map(|text| IRRADIANCE.parse("--at", text)).transpose()?;
    let table = points(path, ["irradiance (mW/cm²)", "time (s)"])?;
    let fit = kinetics::fit(&table).map_err(|e| in_file(e, path))?;
    let resin = &fit.kinetics;
    let mut answer = Answer::default();
    let values = [
        ("lowest irradiance", resin.min_irradiance, "mW/cm²"),
        ("inhibitor flows back", resin.supply_per_s, "per s"),
        ("cure at the highest", resin.cure_s, "s"),
        ("order of the cure", resin.order, ""),
    ];
    for (i, (name, value, unit)) in values.into_iter().enumerate() {
        let range = fit.ranges.map_or_else(String::new, |ranges| {
            let [low, high] = ranges[i].map(|end| match end.is_finite() {
                true => significant(end, 3),
                false => "any".to_owned(),
            });
            format!("(68 %: {low} to {high})")
        });
        let words = [significant(value, 4), unit.to_owned(), range];
        let words: Vec<String> = words.into_iter().filter(|w| !w.is_empty()).collect();
        answer.line(name, words.join(" "));
    }
    answer.number("inhibitor used by", resin.inhibitor_dose(), 4, "mJ/cm²");
    answer.line("off by up to", percent(fit.worst()));
    warn_of_wide(&mut answer, fit.ranges.as_ref());
    if fit.is_order_at_end {
        answer.warn(format!(
            "the best order of the cure is at the end of its range, 0 to 1, or beyond it; within it, {} is best",
            concise(resin.order)
        ));
    }
    if fit.worst() > POOR_FIT {
        answer.warn(format!(
            "the fit misses a measured time by {}: its numbers say little; look for outliers, and whether the columns are irradiance and curing time",
            percent(fit.worst())
        ));
    }
    answer.line(
        "one critical dose",
        format!(
            "differs by {} over these irradiances",
            percent(fit.dose_spread)
        ),
    );
    if let Some(at) = at {
        let lowest = fit
            .ranges
            .map_or(resin.min_irradiance, |ranges| ranges[0][0]);
        let time = resin.time_s(at);
        if time.is_none() && at > lowest {
            answer.warn(format!(
                "{} mW/cm² may cure this resin or may not: the lowest irradiance that does is not known better than from {} mW/cm² on; measure curing times there",
                concise(at),
                significant(lowest, 3)
            ));
        } else if time.is_none() {
            return Err(Error::config(
                "--at",
                format!(
                    "{} mW/cm² never cures this resin: it uses up {} of its inhibitor at most",
                    concise(at),
                    percent(resin.inhibitor_used(at))
                ),
                format!("more than {} mW/cm²", concise(resin.min_irradiance)),
            ));
        }
        if let Some(time) = time {
            let text = format!("{} s at {} mW/cm²", significant(time, 4), concise(at));
            answer.line("curing time", text);
        }
        answer.set("time_s", time);
        if at < table.doses[0] || at > table.doses[table.doses.len() - 1] {
            answer.warn(format!(
                "{} mW/cm² is outside what was measured",
                concise(at)
            ));
        }
    }
    answer.set("kinetics", resin);
    answer.set("ranges", fit.ranges);
    answer.set("inhibitor_dose_mj_per_cm2", resin.inhibitor_dose());
    answer.set("residuals", &fit.residuals);
    answer.set("dose_spread", fit.dose_spread);
    let rows: Vec<Vec<f64>> = (0..table.doses.len())
        .map(|i| {
            let (x, y) = (table.doses[i], table.responses[i]);
            vec![x, y, y * (1.0 + fit.residuals[i]), fit.residuals[i]]
        })
        .collect();
    let names = ["irradiance_mw_per_cm2", "time_s", "fitted_s", "residual"];
    let files = [
        ("kinetics.csv", csv(&names, &rows)),
        ("kinetics.svg", kinetics::plot(&table, &fit)),
    ];
    answer.finish(&given.measured.files, &files)
}

/// Absorbance from which on stray light inside a spectrometer decides what it shows.
const STRAY_LIGHT: f64 = 3.0;

/// Attenuation above which nothing is printed in a vial, 1/mm: it halves light within 35 µm.
const MOST_PER_MM: f64 = 20.0;

/// How far below 0 a spectrometer's zero may lie.
const ZERO_LINE: f64 = 0.02;

fn of_absorbance(given: &AbsorbanceArguments) -> Result<()> {
    let path = &given.measured.table;
    let table = Columns::read(path)?;
    table.only(&["path_mm", "resin", "with_particles"])?;
    let liquid = |column: &'static str| {
        let readings = table.pairs("path_mm", column)?;
        Attenuation::fit(column, &readings).map_err(|e| in_file(e, path))
    };
    let resin = liquid("resin")?;
    let turbid = table
        .has("with_particles")
        .then(|| liquid("with_particles"));
    let turbid = turbid.transpose()?;
    if given.albedo.is_some() && turbid.is_none() {
        return Err(Error::config(
            "--albedo",
            format!(
                "an albedo, and no readings in `with_particles` of {}",
                path.display()
            ),
            "readings of the resin with particles, or no --albedo",
        ));
    }
    let medium = MediumFit::new(&resin, turbid.as_ref(), given.albedo.unwrap_or(1.0));
    let medium = medium.map_err(|e| in_file(e, path))?;
    let mut liquids = vec![("resin", &resin)];
    liquids.extend(turbid.as_ref().map(|turbid| ("with particles", turbid)));
    let mut answer = Answer::default();
    let per_mm = |c: Coefficient| format!("{} per mm", with_error(c.per_mm, c.error));
    let mut job_table = format!(
        "# Fitted by `tomolith calibrate absorbance`\n[resin]\nabsorption_per_mm = {}\n",
        concise(medium.absorption.per_mm)
    );
    let key = |text: String, key: &str| format!("{text} (resin.{key})");
    let found = per_mm(medium.absorption);
    answer.line("absorption", key(found, "absorption_per_mm"));
    if let Some(scattering) = medium.scattering {
        answer.line("scattering", key(per_mm(scattering), "scattering_per_mm"));
        let line = format!("scattering_per_mm = {}\n", concise(scattering.per_mm));
        job_table.push_str(&line);
    }
    for (name, liquid) in &liquids {
        if let Some(cuvette) = liquid.cuvette {
            let cuvette = significant(cuvette, 3);
            answer.line(name, format!("shows {cuvette} with no path: the cuvette"));
        }
        let highest = liquid.readings.iter().map(|r| r[1]).fold(0.0, f64::max);
        if highest > STRAY_LIGHT {
            answer.warn(format!(
                "an absorbance of {} ({name}): stray light makes such readings too small; take a shorter path",
                concise(highest)
            ));
        }
        let slip = "look whether the columns path_mm and resin are swapped, and whether the paths are in mm, not in cm";
        if liquid.total.per_mm > MOST_PER_MM {
            answer.warn(format!(
                "{} per mm ({name}): light hardly enters such a liquid; {slip}",
                significant(liquid.total.per_mm, 3)
            ));
        }
        let known_to = 2.0 * liquid.cuvette_error.unwrap_or(0.0);
        if let Some(shown) = liquid.cuvette
            && shown < -known_to.max(ZERO_LINE)
        {
            answer.warn(format!(
                "a cuvette that shows {} ({name}) gives light; {slip}",
                significant(shown, 3)
            ));
        }
    }
    answer.set("absorption", medium.absorption);
    answer.set("scattering", medium.scattering);
    answer.set("resin", &resin);
    answer.set("with_particles", &turbid);
    let files = [
        ("resin.toml", job_table),
        ("absorbance.svg", absorbance::plot(&liquids)),
    ];
    answer.finish(&given.measured.files, &files)
}

fn print_of_discs(given: &DiscsArguments) -> Result<()> {
    let print = Discs {
        canvas: [given.canvas[0], given.canvas[1]],
        pitch_mm: given.pixel_pitch_mm,
        grid: [given.grid[0], given.grid[1]],
        doses: [
            AREAL_DOSE.parse("--from", &given.from)?,
            AREAL_DOSE.parse("--to", &given.to)?,
        ],
        irradiance: IRRADIANCE.parse("--irradiance", &given.irradiance)?,
        channel: given.channel,
    };
    print.write(&given.output)?;
    let discs = print.discs();
    let (first, last) = (&discs[0], &discs[discs.len() - 1]);
    let mut answer = Answer::default();
    answer.line(
        "discs",
        format!(
            "{}, {} mm across",
            discs.len(),
            significant(2.0 * first.radius_mm, 3)
        ),
    );
    answer.range("doses", [first.dose, last.dose], 4, "mJ/cm²");
    answer.range("times", [first.seconds, last.seconds], 3, "s");
    warn_of_discs(&mut answer, &discs);
    answer.line(
        "written",
        format!(
            "frames, schedule.csv and discs.csv in {}",
            given.output.display()
        ),
    );
    answer.set("discs", discs);
    answer.set("folder", &given.output);
    answer.tell(given.manner);
    Ok(())
}

/// Time for which a projector shows an image at least, of 60 a second, s.
const SHORTEST_S: f64 = 1.0 / 60.0;

/// Time of a calibration print from which on resin does not keep still, s.
const LONGEST_S: f64 = 1800.0;

/// Width of a disc above which pixels are given in another unit, mm.
const WIDEST_MM: f64 = 50.0;

/// Warns of images that no projector shows, and of units that cannot be meant.
fn warn_of_discs(answer: &mut Answer, discs: &[Disc]) {
    let times: Vec<f64> = discs.iter().map(|disc| disc.seconds).collect();
    let steps = times.windows(2).map(|pair| pair[1] - pair[0]);
    let shortest = steps.fold(times[0], f64::min);
    let longest = times.iter().copied().fold(0.0, f64::max);
    if shortest < SHORTEST_S {
        answer.warn(format!(
            "an image is shown for {} ms, and a projector shows 60 a second: use less light (--irradiance), or higher doses",
            significant(1e3 * shortest, 3)
        ));
    }
    if longest > LONGEST_S {
        answer.warn(format!(
            "the print takes {} h, and resin keeps still for minutes: look at the units of --irradiance, --from and --to",
            significant(longest / 3600.0, 3)
        ));
    }
    let across = 2.0 * discs[0].radius_mm;
    if across > WIDEST_MM {
        answer.warn(format!(
            "discs {} mm across: look whether --pixel-pitch-mm is in mm",
            significant(across, 3)
        ));
    }
}

/// Share of a fitted rise that may lie outside the measured doses at either end.
const PLATEAU: f64 = 0.15;

/// Misfit of curing times above which a fit says little.
const POOR_FIT: f64 = 0.25;

/// Penetration depths above which a resin is clear across any vial: lengths in another unit, mm.
const DEEPEST_MM: f64 = 300.0;

fn dose(given: &DoseArguments) -> Result<()> {
    above_zero("--penetration-mm", given.penetration_mm.unwrap_or(1.0))?;
    let path = &given.measured.table;
    let fit = discs::fit(path).map_err(|e| in_file(e, path))?;
    let mut answer = Answer::default();
    answer.line("fitted", fit.from);
    tell_against_cured(&mut answer, &fit);
    warn_of_scatter(&mut answer, &fit);
    let critical = with_error(fit.critical_mj_per_cm2, fit.critical_error);
    answer.line("critical dose", format!("{critical} mJ/cm² at the face"));
    if let Some([low, high]) = fit.bracket {
        answer.line(
            "between",
            format!(
                "{} and {} mJ/cm²",
                significant(low, 4),
                significant(high, 4)
            ),
        );
        if fit.contradicts {
            answer.warn(format!(
                "a disc cured at {} mJ/cm² and another one stayed liquid at {}: the discs contradict each other, and the critical dose may be anywhere between; look whether the light is even over the canvas, or print again with more discs",
                significant(low, 4),
                significant(high, 4)
            ));
        }
    } else {
        let name = if fit.penetration_mm().is_some() {
            "penetration depth"
        } else {
            "edge blurred by"
        };
        answer.line(
            name,
            format!("{} mm", with_error(fit.length_mm, fit.length_error)),
        );
        answer.number("left over (rms)", fit.rms_mm, 3, "mm");
        tell_other_widths(&mut answer, &fit);
    }
    let depth = fit.penetration_mm().or(given.penetration_mm);
    if let (Some(fitted), Some(asked)) = (fit.penetration_mm(), given.penetration_mm) {
        answer.warn(format!(
            "--penetration-mm {} is not used: the depths of the table give {} mm; leave it out, or the depths",
            significant(asked, 4),
            significant(fitted, 4)
        ));
    }
    let mut files = vec![("dose.svg", fit.plot())];
    if let Some(depth) = depth {
        if depth > DEEPEST_MM {
            answer.warn(format!(
                "light goes {} mm deep, farther than through any vial: look whether the depths of the table are in mm",
                significant(depth, 3)
            ));
        }
        let volumetric = fit.critical_mj_per_mm3(depth);
        let unit = "mJ/mm³, where all absorbed light is active";
        answer.number("per volume", volumetric, 4, unit);
        answer.set("critical_dose_mj_per_mm3", volumetric);
        let table = format!(
            "# Fitted by `tomolith calibrate dose`\n[resin]\nabsorption_per_mm = {}\ncritical_dose_mj_per_mm3 = {}\n",
            concise(1.0 / depth),
            concise(volumetric)
        );
        files.push(("resin.toml", table));
    }
    answer.set("fit", &fit);
    answer.finish(&given.measured.files, &files)
}

/// Part of a critical dose that a hundredth of a width may be worth without a word.
const KNOWN: f64 = 0.05;

/// How far a critical dose of widths moves with the width of the light.
fn tell_other_widths(answer: &mut Answer, fit: &DoseFit) {
    let Some(others) = fit.of_other_widths else {
        return;
    };
    let is_near = |dose: Option<f64>| {
        dose.is_some_and(|dose| (dose / fit.critical_mj_per_cm2 - 1.0).abs() < KNOWN)
    };
    if others.into_iter().all(is_near) {
        return;
    }
    let text = |dose: Option<f64>| dose.map_or_else(|| "none".to_owned(), |d| significant(d, 3));
    let [narrow, wide] = others.map(text);
    answer.warn(format!(
        "the critical dose is {narrow} or {wide} mJ/cm² where discs of light are 1 % narrower or wider than radius_mm says, which its error leaves out: \
         measure pixel pitch and magnification as well, or take depths, or which discs cured"
    ));
}

/// Whether the discs cured at the doses at which a fit of their sizes says so.
fn tell_against_cured(answer: &mut Answer, fit: &DoseFit) {
    let Some(against) = &fit.against_cured else {
        return;
    };
    if against.is_empty() {
        answer.line("cured", "agrees with the critical dose");
        return;
    }
    let doses: Vec<String> = against.iter().map(|dose| significant(*dose, 4)).collect();
    answer.warn(format!(
        "the column cured does not agree with the critical dose that {} gives, at {} mJ/cm²: look at these discs again",
        fit.from,
        doses.join(", ")
    ));
}

/// Standard error over its value above which a fit of discs says little.
const LOOSE: f64 = 0.2;

/// Warns of standard errors that are too large for good measurements.
fn warn_of_scatter(answer: &mut Answer, fit: &DoseFit) {
    let named = ["critical dose", "penetration depth"]
        .into_iter()
        .zip(fit.relative_errors());
    let loose: Vec<String> = named
        .filter_map(|(name, error)| Some((name, error.filter(|error| *error > LOOSE)?)))
        .map(|(name, error)| format!("{} of the {name}", percent(error)))
        .collect();
    if !loose.is_empty() {
        answer.warn(format!(
            "the standard error is {}: look whether dose_mj_per_cm2 and {} are swapped or in other units, and for outliers",
            loose.join(" and "),
            fit.from
        ));
    }
}

fn channel(name: &str) -> Result<Channel, String> {
    let known = Channel::ALL.into_iter();
    let mut found = known.filter(|channel| channel.name() == name);
    found.next().ok_or_else(|| "red, green or blue".to_owned())
}

/// Frames for setting a machine up.
fn frames(given: &CalibrateArguments) -> Result<()> {
    let names: Vec<&str> = match given.frames.as_slice() {
        [] => CALIBRATIONS
            .iter()
            .map(|calibration| calibration.0)
            .collect(),
        asked => asked.iter().map(String::as_str).collect(),
    };
    let Some(output) = &given.output else {
        return Err(Error::config(
            "--output",
            "no folder",
            "a new folder for the frames",
        ));
    };
    let files = match (&given.job, &given.canvas) {
        (Some(job), _) => of_job(&Job::read(job, &[])?, &names, output)?,
        (None, Some(canvas)) => {
            let spec = PrinterSpec {
                canvas: Some([canvas[0], canvas[1]]),
                channel: given.channel,
                ..PrinterSpec::default()
            };
            spec.ranges()?;
            // The patterns fill the device; a pixel is the unit of length
            let field = PatternGrid::full_turn(1, 0.0, canvas[1], canvas[0], 1.0);
            let calibration = Calibration::new(&spec, &field, given.bits).map_err(|e| match e {
                Error::Config {
                    key,
                    found,
                    accepted,
                    ..
                } if key.ends_with("bit_depth") => Error::config("--bits", found, accepted),
                other => other,
            })?;
            draw(&calibration, &names, output)?
        }
        (None, None) => {
            return Err(Error::config(
                "--canvas",
                "neither a job nor a canvas",
                "one of the two",
            ));
        }
    };
    done(given.manner, json!({ "files": files }), || {
        files
            .iter()
            .for_each(|file| say(&file.display().to_string()));
    });
    Ok(())
}
