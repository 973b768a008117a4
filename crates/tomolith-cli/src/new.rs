//! `tomolith new`: a commented job from a part, a vial, a projector and a resin.
//!
//! What no option says is asked for on a terminal, and elsewhere is the default. The job is tried before it is written.

use crate::arguments::{must_be_a_place, must_end_in};
use crate::screen::{mutter, say};
use clap::Args;
use std::io::{BufRead, IsTerminal, Write};
use std::path::{Path, PathBuf};
use tomolith::io::write_text;
use tomolith::job::{Document, Job, ResolvedJob};
use tomolith::models::Work;
use tomolith::target::build_under;
use tomolith::units::concise;
use tomolith::{Error, Result};

const EXAMPLES: &str = "\
Examples:
  tomolith new gear.toml                                    asks for the rest
  tomolith new part.toml --part part.stl --size-mm 8        a mesh, its longest edge 8 mm
  tomolith new vial.toml --radius-mm 5.4 --wall-mm 0.7      a glass vial in air
  tomolith new - --part gyroid > gyroid.toml                the text alone";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct NewArguments {
    /// The job file to write; `-` prints it
    file: PathBuf,
    /// A mesh (.stl, .obj, .ply, .3mf) next to the job, or a phantom (`tomolith kinds target.phantom`) [default: gear]
    #[arg(long, value_name = "FILE|PHANTOM")]
    part: Option<String>,
    /// Longest edge of the part, mm; a mesh keeps its size without it, a phantom has 5
    #[arg(long, value_name = "MM", value_parser = above_zero)]
    size_mm: Option<f64>,
    /// Radius of the resin in the vial, mm [default: 8]
    #[arg(long, value_name = "MM", value_parser = above_zero)]
    radius_mm: Option<f64>,
    /// Thickness of its glass, mm, in air; 0 is a vial in a bath of the resin's index [default: 0]
    #[arg(long, value_name = "MM", value_parser = zero_or_more)]
    wall_mm: Option<f64>,
    /// Edge of a pixel in the vial, mm [default: 0.05]
    #[arg(long, value_name = "MM", value_parser = above_zero)]
    pixel_mm: Option<f64>,
    /// Angles of a turn [default: 360]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    angles: Option<u32>,
    /// Wavelength of the light, nm [default: 405]
    #[arg(long, value_name = "NM", value_parser = above_zero)]
    wavelength_nm: Option<f64>,
    /// A resin by name (`tomolith profiles`), in place of the next two
    #[arg(long, value_name = "PROFILE", conflicts_with_all = ["index", "depth_mm"])]
    resin: Option<String>,
    /// A machine by name (`tomolith profiles`)
    #[arg(long, value_name = "PROFILE")]
    printer: Option<String>,
    /// Refractive index of the resin [default: 1.5]
    #[arg(long, value_name = "N", value_parser = above_zero)]
    index: Option<f64>,
    /// Depth in the resin at which 1/e of the light is left, mm [default: 20]
    #[arg(long, value_name = "MM", value_parser = above_zero)]
    depth_mm: Option<f64>,
}

fn above_zero(text: &str) -> std::result::Result<f64, String> {
    let value = text
        .parse()
        .ok()
        .filter(|value: &f64| value.is_finite() && *value > 0.0);
    value.ok_or_else(|| "a number above 0 is accepted".to_owned())
}

fn zero_or_more(text: &str) -> std::result::Result<f64, String> {
    match text.parse() {
        Ok(0.0) => Ok(0.0),
        _ => above_zero(text).map_err(|_| "0, or a number above it, is accepted".to_owned()),
    }
}

/// What a job is made of.
struct Answers {
    part: String,
    size_mm: Option<f64>,
    radius_mm: f64,
    wall_mm: f64,
    pixel_mm: f64,
    angles: u32,
    wavelength_nm: f64,
    /// A profile, or index and depth.
    resin: Resin,
    printer: Option<String>,
}

enum Resin {
    Profile(String),
    Measured { index: f64, depth_mm: f64 },
}

/// Writes the job.
pub(crate) fn new(given: &NewArguments) -> Result<()> {
    let prints = given.file.as_os_str() == "-";
    if !prints {
        must_be_a_place("FILE", &given.file)?;
        if given
            .file
            .extension()
            .is_some_and(|extension| extension == "json")
        {
            must_end_in("FILE", &given.file, &["toml"])?;
        }
    }
    let answers = answers(given, !prints)?;
    let text = tried(given, &answers).map_err(at_option)?;
    if prints {
        say(text.trim_end());
        return Ok(());
    }
    write_text(&given.file, &text)?;
    let file = given.file.display();
    say(&format!(
        "{file} is written; `tomolith check {file}` says what it costs, `tomolith run {file}` runs it"
    ));
    Ok(())
}

/// The text of a job that can be used.
fn tried(given: &NewArguments, answers: &Answers) -> Result<String> {
    let document = |pixels: [usize; 2]| Document::toml(&given.file, text(answers, pixels, None));
    // The part's size says how many pixels light it
    let trial = Job::from_document(document([64, 64])?)?;
    let shape =
        build_under(&trial.spec.target, &trial.base(), "target", &Work::new()).map_err(|e| {
            match trial.locate(e) {
                unread @ Error::Io { .. } => Error::config(
                    "--part",
                    unread.to_string(),
                    "a phantom, or a mesh that can be read",
                ),
                error => error,
            }
        })?;
    if shape.is_gray() {
        return Err(Error::config(
            "--part",
            format!("`{}` has gray values", answers.part),
            "a part without; for gray values write a job with `[objective.l2]`",
        ));
    }
    let bounds_mm = shape.bounds_mm();
    let mut pixels = pixels(answers, 1.0, bounds_mm);
    let resolve = |pixels| ResolvedJob::new(&Job::from_document(document(pixels)?)?);
    let mut resolved = resolve(pixels)?;
    let widening = widening(&resolved);
    if widening > 1.0 {
        pixels = self::pixels(answers, widening, bounds_mm);
        resolved = resolve(pixels)?;
    }
    resolved.must_print(&Work::new()).map_err(of_voxels)?;
    for warning in resolved.warnings() {
        mutter(&format!("{:>12} {warning}", "warning"));
    }
    Ok(text(answers, pixels, resolved.better_offset_mm()))
}

/// The option that a key of the job is made of; None for one that no option sets.
fn option_of(key: &str) -> Option<&'static str> {
    let options = [
        ("target.size_mm", "--size-mm"),
        ("target.", "--part"),
        ("target", "--size-mm, --radius-mm"),
        ("vial.cylinder.outer_radius_mm", "--wall-mm"),
        ("vial", "--radius-mm"),
        ("resin.refractive_index", "--index"),
        ("resin.absorption_per_mm", "--depth-mm"),
        ("resin", "--resin"),
        ("printer", "--printer"),
        ("light[0].wavelength_nm", "--wavelength-nm"),
        ("light[0].angles", "--angles"),
        ("light[0].pixels", "--pixel-mm"),
        ("light[0].projector", "--pixel-mm"),
    ];
    let found = options.iter().find(|(begin, _)| key.starts_with(begin));
    found.map(|(_, option)| *option)
}

/// A part that is fine but for the voxels, which are as wide as the pixels.
fn of_voxels(mut error: Error) -> Error {
    if let Error::Config { key, found, .. } = &mut error
        && key == "target"
    {
        *found = format!("target: {found}");
        "--size-mm, --pixel-mm".clone_into(key);
    }
    error
}

/// Says which option is at fault, in place of a line of a job that was not written.
fn at_option(mut error: Error) -> Error {
    if let Error::Config {
        key, found, place, ..
    } = &mut error
    {
        *place = None;
        if let Some(option) = option_of(key) {
            *found = format!("{key}: {found}");
            option.clone_into(key);
        }
    }
    match error {
        Error::Several(all) => Error::Several(all.into_iter().map(at_option).collect()),
        error => error,
    }
}

/// How much farther from the axis level light must aim than it passes it: a round vial in air bends it inwards (Snell, with the angle of incidence from
/// the distance of the axis).
fn widening(resolved: &ResolvedJob) -> f64 {
    let light = &resolved.lights()[0];
    let resin = light.resin.refractive_index;
    resin
        / resolved
            .vial()
            .surrounding_index(light.surrounding_index, resin)
}

/// As many pixels as light the part from every side, and eight more; an even number, as projectors have.
fn pixels(answers: &Answers, widening: f64, [low, high]: [[f64; 3]; 2]) -> [usize; 2] {
    let reach = (0..2).map(|i| high[i].max(-low[i])).fold(0.0, f64::hypot);
    // Light meets the axis at the middle row: the higher end counts twice
    let height = 2.0 * high[2].max(-low[2]);
    let count = |mm: f64| (mm / answers.pixel_mm).ceil() as usize + 8;
    [2.0 * reach * widening, height].map(|mm| count(mm).next_multiple_of(2))
}

/// What the options say, what is asked for, or the defaults.
fn answers(given: &NewArguments, may_ask: bool) -> Result<Answers> {
    let asks = may_ask && std::io::stdin().is_terminal() && std::io::stderr().is_terminal();
    let part = match &given.part {
        Some(part) => part.clone(),
        None if asks => asked("part: a mesh file, or a phantom", "gear")?,
        None => "gear".to_owned(),
    };
    let number = |option: Option<f64>, words: &str, default: f64| match option {
        Some(value) => Ok(value),
        None if asks && default == 0.0 => number(words, default, zero_or_more),
        None if asks => number(words, default, above_zero),
        None => Ok(default),
    };
    let size_mm = match given.size_mm {
        None if !is_mesh(&part) => Some(number(None, "its longest edge, mm", 5.0)?),
        size => size,
    };
    Ok(Answers {
        part,
        size_mm,
        radius_mm: number(given.radius_mm, "radius of the resin in the vial, mm", 8.0)?,
        wall_mm: number(
            given.wall_mm,
            "its glass, mm (0: a bath of the resin's index)",
            0.0,
        )?,
        pixel_mm: number(given.pixel_mm, "edge of a pixel in the vial, mm", 0.05)?,
        angles: number(given.angles.map(f64::from), "angles of a turn", 360.0)? as u32,
        wavelength_nm: number(given.wavelength_nm, "wavelength, nm", 405.0)?,
        resin: match &given.resin {
            Some(name) => Resin::Profile(name.clone()),
            None => Resin::Measured {
                index: number(given.index, "refractive index of the resin", 1.5)?,
                depth_mm: number(
                    given.depth_mm,
                    "depth at which 1/e of the light is left, mm",
                    20.0,
                )?,
            },
        },
        printer: given.printer.clone(),
    })
}

/// Asks for a line; the default where it is empty.
fn asked(words: &str, default: &str) -> Result<String> {
    let failed = |e| Error::io(Path::new("standard input"), e);
    let mut error = std::io::stderr();
    let _ = write!(error, "{words} [{default}]: ");
    let _ = error.flush();
    let mut line = String::new();
    std::io::stdin()
        .lock()
        .read_line(&mut line)
        .map_err(failed)?;
    let line = line.trim();
    Ok(if line.is_empty() { default } else { line }.to_owned())
}

/// Asks for a number until there is one that is accepted.
fn number(
    words: &str,
    default: f64,
    accepted: fn(&str) -> std::result::Result<f64, String>,
) -> Result<f64> {
    loop {
        match accepted(&asked(words, &concise(default))?) {
            Ok(value) => return Ok(value),
            Err(what) => mutter(&what),
        }
    }
}

fn is_mesh(part: &str) -> bool {
    Path::new(part).extension().is_some()
}

fn text(answers: &Answers, [columns, rows]: [usize; 2], offset_mm: Option<[f64; 2]>) -> String {
    let quoted = |text: &str| serde_json::Value::from(text).to_string();
    let size = answers.size_mm.map(concise);
    let target = match (is_mesh(&answers.part), size) {
        (true, Some(size)) => format!(
            "mesh = {}          # next to this file\nsize_mm = {size}                  # its longest edge; leave it out for the size of the file",
            quoted(&answers.part)
        ),
        (true, None) => format!(
            "mesh = {}          # next to this file\n# mesh_unit = \"inch\"            # where the file's numbers are no mm",
            quoted(&answers.part)
        ),
        (false, size) => format!(
            "phantom = {}            # or mesh = \"part.stl\"\nsize_mm = {}                  # its longest edge",
            quoted(&answers.part),
            size.unwrap_or_else(|| "5.0".to_owned())
        ),
    };
    let [radius, outer] = [answers.radius_mm, answers.radius_mm + answers.wall_mm].map(concise);
    let vial = match answers.wall_mm > 0.0 {
        true => format!(
            "[vial]\nsurrounding_index = 1.0        # air\n\n[vial.cylinder]\ninner_radius_mm = {radius}\nouter_radius_mm = {outer}\nrefractive_index = 1.52        # glass"
        ),
        false => format!(
            "# A vial in a bath of the resin's index. In air: [vial.cylinder], see `tomolith kinds vial`\n[vial.index_matched]\nradius_mm = {radius}"
        ),
    };
    let resin = match &answers.resin {
        Resin::Profile(name) => format!(
            "profile = {}          # `tomolith profiles {name}` says where it is from",
            quoted(name)
        ),
        Resin::Measured { index, depth_mm } => format!(
            "refractive_index = {}\nabsorption_per_mm = {}        # 1/mm: light falls to 1/e within {} mm",
            concise(*index),
            concise(1.0 / depth_mm),
            concise(*depth_mm)
        ),
    };
    let printer = match &answers.printer {
        Some(name) => format!("[printer]\nprofile = {}", quoted(name)),
        None => "# [printer]                      # a machine's canvas, gray curve and power: `tomolith kinds printer`".to_owned(),
    };
    let [pixel, wavelength] = [answers.pixel_mm, answers.wavelength_nm].map(concise);
    let angles = answers.angles;
    let offset = offset_mm.map_or_else(String::new, |mm| {
        let [across, up] = mm.map(concise);
        format!(
            "offset_mm = [{across}, {up}]        # flat faces of the part end with rows of pixels\n"
        )
    });
    format!(
        r#"# A job of Tomolith: `tomolith check` says what it costs, `tomolith run` runs it, `tomolith kinds` lists what it can choose from.
# Editors complete its keys with the line `#:schema job.schema.json` here, and that file from `tomolith schema`.

[target]
{target}

{vial}

[resin]
{resin}
# critical_dose_mj_per_mm3 = 0.5   # where it is known, the report says seconds and mJ

[[light]]
wavelength_nm = {wavelength}
pixels = [{columns}, {rows}]           # columns, rows: as many as light the part
{offset}angles = {angles}                   # frames of a turn
projector.collimated = {{ pixel_pitch_mm = {pixel} }}

# Where they are left out: objective and optimizer, the bound of the pixels (as low as prints as well), 45 iterations
# [stop]
# iterations = 45
{printer}
"#
    )
}
