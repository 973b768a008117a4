//! A calibration print: discs at rising doses in a resin that stands still, and what their result says.
//!
//! **What it does** [`Discs`] draws one image per disc: all discs are lit at white, and one after another goes dark, so that doses rise by one factor and do not lean
//! on the gray curve. [`fit`] reads what was measured back.
//!
//! **Equations** (E areal dose, mJ/cm²)
//!
//! ```text
//! cured      E ≥ E_c                          E_c between the highest dose that did not cure and the lowest that did
//! depth      C_d = D_p·ln(E/E_c)              Jacobs, Rapid Prototyping & Manufacturing (SME 1992), ch. 4
//! diameter   d/2 = r₀ + b·ln(E/E_c − 1)       light E/(1 + e^((r − r₀)/b)): an edge blurred by b ≪ r₀
//! ```
//!
//! The dose that gels per volume is E_c/D_p where all that is absorbed is active: mJ/mm³ = mJ/cm²/(100·mm).
//!
//! **Limits** the light is even over the canvas and collimated over the depth that cures.
//!
//! ```
//! use tomolith_planning::discs::fit_depth;
//! let points: Vec<[f64; 2]> = [20.0f64, 40.0, 80.0].iter().map(|e| [*e, 1.5 * (e / 10.0).ln()]).collect();
//! let found = fit_depth(&points).unwrap();
//! assert!((found.critical_mj_per_cm2 - 10.0).abs() < 1e-6 && (found.length_mm - 1.5).abs() < 1e-9);
//! ```

use crate::measured::csv;
use serde::Serialize;
use std::path::{Path, PathBuf};
use tomolith_core::columns::Columns;
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::grid::PatternGrid;
use tomolith_core::least_squares::{Minimum, minimize};
use tomolith_core::units::concise;
use tomolith_core::work::Work;
use tomolith_io::channel::Channel;
use tomolith_io::frames::{FrameSet, write_frames};
use tomolith_io::{must_be_free, write_folder_whole};
use tomolith_report::plot::{Axis, Plot};

/// Radius of a disc over the shorter edge of its field.
const RADIUS: f64 = 0.32;

/// Columns of `discs.csv`.
const COLUMNS: [&str; 9] = [
    "disc",
    "x_mm",
    "z_mm",
    "radius_mm",
    "time_s",
    "dose_mj_per_cm2",
    "cured",
    "depth_mm",
    "diameter_mm",
];

/// How far below the lowest dose that cured the critical one lies at least where widths fix it, in ln E.
const LEAST_BELOW: f64 = 1e-3;

/// Where no curve fits, sizes below so many radii of the light are taken for radii.
const RADII: f64 = 1.3;

/// A calibration print.
#[derive(Clone, Debug, PartialEq)]
pub struct Discs {
    /// Pixels of the device, [columns, rows].
    pub canvas: [usize; 2],
    /// Edge of a pixel at the resin, mm.
    pub pitch_mm: f64,
    /// Discs along and down.
    pub grid: [usize; 2],
    /// Lowest and highest dose, mJ/cm².
    pub doses: [f64; 2],
    /// Irradiance at white, mW/cm².
    pub irradiance: f64,
    /// The channel of color images that shows the discs; gray without.
    pub channel: Option<Channel>,
}

/// A disc.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Disc {
    /// Middle, right and up of the canvas' middle, mm.
    pub at_mm: [f64; 2],
    /// Radius, mm.
    pub radius_mm: f64,
    /// For how long it is lit, s.
    pub seconds: f64,
    /// mJ/cm².
    pub dose: f64,
}

/// Pixels of all images together, at most: 2 GB of levels.
const MOST_PIXELS: usize = 1_000_000_000;

impl Discs {
    /// Checks every number.
    ///
    /// # Errors
    /// [`Error::Config`] with the option that is out of range.
    pub fn check(&self) -> Result<()> {
        let [nx, ny] = self.grid;
        if nx == 0 || ny == 0 || !(4..=100).contains(&(nx * ny)) {
            return Err(Error::config(
                "--grid",
                format!("{nx} × {ny} discs"),
                "4 to 100 discs, along and down",
            ));
        }
        let [columns, rows] = self.canvas;
        if columns > 16_384 || rows > 16_384 || columns < 8 * nx || rows < 8 * ny {
            return Err(Error::config(
                "--canvas",
                format!("{columns} × {rows} pixels for {nx} × {ny} discs"),
                "8 pixels or more for each disc, 16384 at most",
            ));
        }
        // All images are held at once
        if columns * rows * nx * ny > MOST_PIXELS {
            return Err(Error::config(
                "--canvas",
                format!("{columns} × {rows} pixels, {} times", nx * ny),
                format!(
                    "{MOST_PIXELS} pixels in all images at most: a smaller canvas, or fewer discs"
                ),
            ));
        }
        let is_in = self.pitch_mm > 0.0 && self.pitch_mm <= 100.0;
        let accepted = "a length > 0, at most 100 mm";
        in_range(is_in, "--pixel-pitch-mm", self.pitch_mm, accepted)?;
        let [low, high] = self.doses;
        if low >= high {
            return Err(Error::config(
                "--from",
                format!("doses from {} to {} mJ/cm²", concise(low), concise(high)),
                "a lowest dose below the highest",
            ));
        }
        Ok(())
    }

    /// Every disc, row by row from the top, by rising dose.
    #[must_use]
    pub fn discs(&self) -> Vec<Disc> {
        let [nx, ny] = self.grid;
        let [width, height] =
            [0, 1].map(|i| self.canvas[i] as f64 * self.pitch_mm / self.grid[i] as f64);
        let count = nx * ny;
        let [low, high] = self.doses;
        let disc = |j: usize| {
            let dose = low * (high / low).powf(j as f64 / (count - 1) as f64);
            let (column, row) = ((j % nx) as f64, (j / nx) as f64);
            Disc {
                at_mm: [
                    (column + 0.5 - nx as f64 / 2.0) * width,
                    (ny as f64 / 2.0 - row - 0.5) * height,
                ],
                radius_mm: RADIUS * width.min(height),
                seconds: dose / self.irradiance,
                dose,
            }
        };
        (0..count).map(disc).collect()
    }

    /// Writes `frames/`, `schedule.csv` and `discs.csv` into a new folder: image k is shown for its seconds, one after another.
    ///
    /// # Errors
    /// As [`check`](Self::check); [`Error::Config`] for a folder that holds anything; [`Error::Io`].
    pub fn write(&self, folder: &Path) -> Result<()> {
        self.check()?;
        must_be_free("--output", folder)?;
        let discs = self.discs();
        let [columns, rows] = self.canvas;
        let grid = PatternGrid {
            azimuths: vec![0.0; discs.len()],
            frame_arc: 0.0,
            rows,
            columns,
            pitch_mm: [self.pitch_mm; 2],
            offset_mm: [0.0; 2],
        };
        let values = self.images(&discs);
        let shown = |k: usize| discs[k].seconds - if k == 0 { 0.0 } else { discs[k - 1].seconds };
        let schedule: Vec<Vec<f64>> = (0..discs.len())
            .map(|k| vec![k as f64, discs[k].seconds - shown(k), shown(k)])
            .collect();
        let row = |(j, d): (usize, &Disc)| {
            let [x, z] = d.at_mm;
            let known = [j as f64, x, z, d.radius_mm, d.seconds, d.dose];
            [&known[..], &[f64::NAN; 3]].concat()
        };
        let table: Vec<Vec<f64>> = discs.iter().enumerate().map(row).collect();
        write_folder_whole(folder, |aside| {
            let set = FrameSet {
                light: None,
                grid: &grid,
                bits: 8,
                full_scale: 1.0,
                channel: self.channel,
                values: &values,
            };
            write_frames(&aside.join("frames"), &[set], &Work::new())?;
            let schedule = csv(&["frame", "from_s", "for_s"], &schedule);
            std::fs::write(aside.join("schedule.csv"), schedule)?;
            std::fs::write(aside.join("discs.csv"), csv(&COLUMNS, &table))?;
            Ok(())
        })
    }

    /// Levels of every image: in image k the discs from number k on are white.
    fn images(&self, discs: &[Disc]) -> Vec<u16> {
        let [columns, rows] = self.canvas;
        let mut number = vec![usize::MAX; columns * rows];
        for (i, place) in number.iter_mut().enumerate() {
            let x = ((i % columns) as f64 + 0.5 - columns as f64 / 2.0) * self.pitch_mm;
            let z = (rows as f64 / 2.0 - (i / columns) as f64 - 0.5) * self.pitch_mm;
            let [nx, ny] = self.grid;
            let (column, row) = (i % columns * nx / columns, i / columns * ny / rows);
            let j = row * nx + column;
            if (x - discs[j].at_mm[0]).hypot(z - discs[j].at_mm[1]) <= discs[j].radius_mm {
                *place = j;
            }
        }
        let level = |k: usize, j: usize| if j != usize::MAX && j >= k { 255 } else { 0 };
        (0..discs.len())
            .flat_map(|k| number.iter().map(move |&j| level(k, j)))
            .collect()
    }
}

/// What a disc print says.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DoseFit {
    /// The column that was fitted.
    pub from: &'static str,
    /// E_c, mJ/cm².
    pub critical_mj_per_cm2: f64,
    /// Its standard error; for `cured`, None.
    pub critical_error: Option<f64>,
    /// For `cured`: the two doses between which it lies, lower first.
    pub bracket: Option<[f64; 2]>,
    /// Whether a disc stayed liquid at a dose at which another one cured.
    pub contradicts: bool,
    /// D_p of `depth_mm`, b of `diameter_mm`; NaN for `cured`, mm.
    pub length_mm: f64,
    /// Its standard error.
    pub length_error: Option<f64>,
    /// r₀ of `diameter_mm`.
    pub radius_mm: Option<f64>,
    /// E_c where r₀ is 1 % less and 1 % more, of `diameter_mm`; None where such a width gives none.
    pub of_other_widths: Option<[Option<f64>; 2]>,
    /// Root mean square of what is left, mm.
    pub rms_mm: f64,
    /// Of a fit of sizes beside a filled column `cured`: the doses whose disc cured below the critical dose, or stayed liquid above it, by more than two standard
    /// errors; None without that column.
    pub against_cured: Option<Vec<f64>>,
    #[serde(skip)]
    points: Vec<[f64; 2]>,
}

/// Reads `discs.csv` and fits the filled column that says most: `depth_mm`, else `diameter_mm`, each with three cured discs or more, else `cured`; a fit of sizes
/// is compared with `cured`.
///
/// # Errors
/// [`Error::Format`] for a file without results; [`Error::Config`] for results that fix no dose.
pub fn fit(path: &Path) -> Result<DoseFit> {
    let table = Columns::read(path)?;
    table.only(&COLUMNS)?;
    let refuse = |found: &str| {
        Err(Error::format(
            PathBuf::from(path),
            found,
            "numbers in one of the columns cured, depth_mm and diameter_mm",
        ))
    };
    let dose = "dose_mj_per_cm2";
    let mut filled = Vec::new();
    for name in ["depth_mm", "diameter_mm", "cured"] {
        if table.has(name) {
            filled.push((name, table.pairs(dose, name)?));
        }
    }
    let suffices = |(name, points): &&(&str, Vec<[f64; 2]>)| *name == "cured" || sized(points) >= 3;
    let Some((from, points)) = filled.iter().find(suffices).or(filled.first()) else {
        return refuse("no results");
    };
    let mut fit = match *from {
        "cured" => return fit_cured(points),
        "depth_mm" => fit_depth(points)?,
        _ => {
            let radius = table.pairs("radius_mm", "diameter_mm")?;
            let Some(&[radius, _]) = radius.first() else {
                return refuse("diameters without radius_mm");
            };
            fit_diameter(points, radius)?
        }
    };
    if let Some((_, cured)) = filled.iter().find(|(name, _)| *name == "cured") {
        fit.against_cured = Some(fit.contradicted_by(&cured_or_not(cured)?));
    }
    Ok(fit)
}

/// How many discs have a size.
fn sized(points: &[[f64; 2]]) -> usize {
    points.iter().filter(|p| p[1] > 0.0).count()
}

/// Doses above 0, in rising order.
fn sorted(points: &[[f64; 2]]) -> Result<Vec<[f64; 2]>> {
    let mut points = points.to_vec();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    match points.iter().find(|p| p[0] <= 0.0) {
        Some(p) => Err(Error::refused("dose_mj_per_cm2", p[0], "doses above 0")),
        None => Ok(points),
    }
}

/// Doses in rising order and whether the disc cured (1) or not (0).
fn cured_or_not(points: &[[f64; 2]]) -> Result<Vec<[f64; 2]>> {
    let points = sorted(points)?;
    match points.iter().find(|p| p[1] != 0.0 && p[1] != 1.0) {
        Some(p) => Err(Error::refused("cured", p[1], "0 or 1")),
        None => Ok(points),
    }
}

/// Of doses and whether the disc cured (1) or not (0).
///
/// # Errors
/// [`Error::Config`] when all or none cured, or for other numbers.
pub fn fit_cured(points: &[[f64; 2]]) -> Result<DoseFit> {
    let points = cured_or_not(points)?;
    let highest_liquid = points.iter().rev().find(|p| p[1] == 0.0);
    let lowest_solid = points.iter().find(|p| p[1] == 1.0);
    let (Some(&[liquid, _]), Some(&[solid, _])) = (highest_liquid, lowest_solid) else {
        let [first, last] = [points.first(), points.last()].map(|p| p.map_or(0.0, |p| p[0]));
        let found = if lowest_solid.is_some() {
            format!(
                "every disc cured: the critical dose is below {} mJ/cm²",
                concise(first)
            )
        } else {
            format!(
                "no disc cured: the critical dose is above {} mJ/cm²",
                concise(last)
            )
        };
        return Err(Error::config(
            "cured",
            found,
            "discs on both sides of the critical dose",
        ));
    };
    Ok(DoseFit {
        from: "cured",
        critical_mj_per_cm2: (liquid * solid).sqrt(),
        critical_error: None,
        bracket: Some([liquid.min(solid), liquid.max(solid)]),
        contradicts: liquid >= solid,
        length_mm: f64::NAN,
        length_error: None,
        radius_mm: None,
        of_other_widths: None,
        rms_mm: 0.0,
        against_cured: None,
        points,
    })
}

/// Of doses and depths, mm; discs without depth count as not measured.
///
/// # Errors
/// [`Error::Config`] for fewer than three cured discs or depths that do not rise.
pub fn fit_depth(points: &[[f64; 2]]) -> Result<DoseFit> {
    let points = with_sizes("depth_mm", points)?;
    let n = points.len();
    // A line in ln E: depth = D_p·ln E − D_p·ln E_c
    let middle = points.iter().map(|p| p[0].ln()).sum::<f64>() / n as f64;
    let found = minimize(&[1.0, middle - 1.0], n, |t, i, slopes| {
        let rise = points[i][0].ln() - t[1];
        slopes.copy_from_slice(&[rise, -t[0]]);
        t[0] * rise - points[i][1]
    });
    let errors = found.errors(0.0, n);
    with_errors("depth_mm", &found, errors, points, None)
}

/// Of doses and diameters, mm, of discs with a radius, mm.
///
/// # Errors
/// As [`fit_depth`].
pub fn fit_diameter(points: &[[f64; 2]], radius_mm: f64) -> Result<DoseFit> {
    let of_width = |share: f64| fit_width(points, share * radius_mm);
    let of_other = |share| of_width(share).ok().map(|fit| fit.critical_mj_per_cm2);
    Ok(DoseFit {
        of_other_widths: Some([0.99, 1.01].map(of_other)),
        ..of_width(1.0)?
    })
}

fn fit_width(points: &[[f64; 2]], radius_mm: f64) -> Result<DoseFit> {
    let points = with_sizes("diameter_mm", points)?;
    let n = points.len();
    let lowest = points[0][0].ln();
    let starts = [0.02, 0.2, 1.0, 3.0].map(|below: f64| {
        // ln E_c stays below that of the lowest dose: it is e^θ below
        minimize(&[0.05 * radius_mm, below.ln()], n, |t, i, slopes| {
            let below = t[1].exp();
            let ratio = (points[i][0].ln() - lowest + below).exp();
            let log = (ratio - 1.0).ln();
            slopes.copy_from_slice(&[log, t[0] * ratio / (ratio - 1.0) * below]);
            radius_mm + t[0] * log - points[i][1] / 2.0
        })
    });
    let best = starts
        .into_iter()
        .filter(|m| m.cost.is_finite())
        .min_by(|a, b| a.cost.total_cmp(&b.cost));
    let widest = points.iter().map(|p| p[1]).fold(0.0, f64::max);
    let refused = || {
        if widest < RADII * radius_mm {
            return radii(widest, radius_mm, "diameters, not radii");
        }
        if widest < 2.0 * radius_mm {
            return radii(widest, radius_mm, OF_ONE_SCALE);
        }
        rises("diameter_mm")
    };
    let mut found = best.ok_or_else(refused)?;
    // From θ to ln E_c, whose error follows
    let below = found.parameters[1].exp();
    if below < LEAST_BELOW {
        return Err(radii(widest, radius_mm, OF_ONE_SCALE));
    }
    let errors = found.errors(0.0, n).map(|e| vec![e[0], e[1] * below]);
    found.parameters[1] = lowest - below;
    with_errors("diameter_mm", &found, errors, points, Some(radius_mm)).map_err(|_| refused())
}

/// What widths of discs must be to fix a dose.
const OF_ONE_SCALE: &str = "diameters and radius_mm on one scale (pixel pitch, magnification, shrinkage): discs far above the critical dose are wider than their light. \
     Depths, and which discs cured, need no such scale";

/// Widths that do not go with those of the light.
fn radii(widest: f64, radius_mm: f64, accepted: &str) -> Error {
    Error::config(
        "diameter_mm",
        format!(
            "{} mm at most, of discs of light {} mm wide",
            concise(widest),
            concise(2.0 * radius_mm)
        ),
        accepted,
    )
}

/// The discs that have a size, by rising dose; refuses fewer than three.
fn with_sizes(column: &str, points: &[[f64; 2]]) -> Result<Vec<[f64; 2]>> {
    let points: Vec<[f64; 2]> = sorted(points)?.into_iter().filter(|p| p[1] > 0.0).collect();
    if points.len() >= 3 {
        return Ok(points);
    }
    let found = format!("{} cured discs", points.len());
    let accepted = "three or more with a size above 0";
    Err(Error::config(column, found, accepted))
}

fn rises(column: &str) -> Error {
    Error::config(
        column,
        "sizes that fall with the dose or stay the same",
        "sizes that rise with the dose, noise apart",
    )
}

/// Of parameters length and ln E_c.
fn with_errors(
    from: &'static str,
    found: &Minimum,
    errors: Option<Vec<f64>>,
    points: Vec<[f64; 2]>,
    radius_mm: Option<f64>,
) -> Result<DoseFit> {
    let (length_mm, critical) = (found.parameters[0], found.parameters[1].exp());
    if !(length_mm > 0.0 && critical.is_finite() && critical > 0.0) {
        return Err(rises(from));
    }
    Ok(DoseFit {
        from,
        critical_mj_per_cm2: critical,
        critical_error: errors.as_ref().map(|e| e[1] * critical),
        bracket: None,
        contradicts: false,
        length_mm,
        length_error: errors.map(|e| e[0]),
        radius_mm,
        of_other_widths: None,
        rms_mm: (found.cost / points.len() as f64).sqrt(),
        against_cured: None,
        points,
    })
}

impl DoseFit {
    /// D_p, where depths gave it.
    #[must_use]
    pub fn penetration_mm(&self) -> Option<f64> {
        (self.from == "depth_mm").then_some(self.length_mm)
    }

    /// Doses at which a disc cured below the critical dose, or did not above it, by more than two standard errors.
    fn contradicted_by(&self, cured: &[[f64; 2]]) -> Vec<f64> {
        let near = 2.0 * self.critical_error.unwrap_or(0.0);
        let is_against = |&&[dose, cured]: &&[f64; 2]| {
            let above = dose - self.critical_mj_per_cm2;
            above.abs() > near && (above > 0.0) != (cured == 1.0)
        };
        let doses = cured.iter().filter(is_against);
        doses.map(|p| p[0]).collect()
    }

    /// Standard errors over their values: of the critical dose, and of the penetration depth where depths gave it.
    #[must_use]
    pub fn relative_errors(&self) -> [Option<f64>; 2] {
        let of = |error: Option<f64>, value: f64| error.map(|error| error / value);
        let depth = self.penetration_mm();
        [
            of(self.critical_error, self.critical_mj_per_cm2),
            depth.and_then(|depth| of(self.length_error, depth)),
        ]
    }

    /// The dose that gels, mJ/mm³, at the face of a resin with this penetration depth.
    #[must_use]
    pub fn critical_mj_per_mm3(&self, penetration_mm: f64) -> f64 {
        self.critical_mj_per_cm2 / (100.0 * penetration_mm)
    }

    /// Results and fit.
    #[must_use]
    pub fn plot(&self) -> String {
        let doses: Vec<f64> = self.points.iter().map(|p| p[0]).collect();
        let (first, last) = (doses[0], doses[doses.len() - 1]);
        let most = self.points.iter().map(|p| p[1]).fold(0.0, f64::max);
        let low = first.min(0.8 * self.critical_mj_per_cm2);
        let label = match self.from {
            "cured" => "cured (1) or not (0)",
            "depth_mm" => "depth, mm",
            _ => "diameter, mm",
        };
        let mut plot = Plot::new(
            Axis::log("dose, mJ/cm²", low, last),
            Axis::linear(label, 0.0, 1.1 * most),
        );
        let at = |i: i32| low * (last / low).powf(f64::from(i) / 400.0);
        let size = |dose: f64| match (self.from, self.radius_mm) {
            ("cured", _) => f64::from(u8::from(dose >= self.critical_mj_per_cm2)),
            (_, Some(radius)) => {
                2.0 * (radius + self.length_mm * (dose / self.critical_mj_per_cm2 - 1.0).ln())
            }
            _ => self.length_mm * (dose / self.critical_mj_per_cm2).ln(),
        };
        let line = (0..=400).map(|i| [at(i), size(at(i))]);
        let line: Vec<[f64; 2]> = line.filter(|p| p[1] >= 0.0).collect();
        plot.line_at(self.critical_mj_per_cm2, "still", "critical dose");
        plot.line(&line, "accent", "fit");
        plot.dots(&self.points, "gel", "measured");
        plot.file("Result of the discs against their dose")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `discs.csv` with cells for cured, depth and diameter.
    fn fitted(rows: &[(f64, &str)]) -> Result<DoseFit> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("discs.csv");
        let lines = rows
            .iter()
            .map(|(dose, cells)| format!("0.6,{dose},{cells}\n"));
        let head = "radius_mm,dose_mj_per_cm2,cured,depth_mm,diameter_mm\n".to_owned();
        std::fs::write(&path, head + &lines.collect::<String>()).unwrap();
        fit(&path)
    }

    #[test]
    fn halves_of_diameters_are_taken_for_radii() {
        // r₀ + b·ln(E/E_c − 1) with b = 0.05 and E_c = 10 is the radius, half of the diameter; half of that lies below r₀
        let sizes = |share: f64| {
            let size = |e: f64| share * (0.6 + 0.05 * (e / 10.0 - 1.0).ln());
            let rows = [12.0, 20.0, 40.0, 80.0].map(|e| (e, format!("1,,{}", size(e))));
            fitted(&rows.each_ref().map(|(e, cells)| (*e, cells.as_str())))
        };
        assert!((sizes(2.0).unwrap().critical_mj_per_cm2 - 10.0).abs() < 1e-3);
        let message = sizes(1.0).unwrap_err().to_string();
        tomolith_core::contains!(message, "of light 1.2 mm wide", "diameters, not radii");
    }

    /// r₀ + b·ln(E/E_c − 1) with b = 0.03 and E_c = 38, measured on another scale.
    #[test]
    fn widths_on_another_scale_than_their_light_fix_no_dose() {
        let fit = |scale: f64| {
            let points: Vec<[f64; 2]> = (0..19)
                .map(|j| 42.3 * 1.13f64.powi(j))
                .map(|e| [e, 2.0 * scale * (0.95 + 0.03 * (e / 38.0 - 1.0).ln())])
                .collect();
            fit_diameter(&points, 0.95)
        };
        let found = fit(1.0).unwrap();
        assert!((found.critical_mj_per_cm2 - 38.0).abs() < 1e-3);
        // A hundredth of the width is a third of b
        let [narrow, wide] = found.of_other_widths.unwrap();
        assert!(narrow.unwrap() < 35.0 && wide.is_none_or(|wide| wide > 40.0));
        for scale in [0.95, 0.9] {
            let message = fit(scale).unwrap_err().to_string();
            tomolith_core::contains!(message, "of light 1.9 mm wide", "on one scale");
        }
    }

    /// Depths of 1.5 mm·ln(E/20).
    #[test]
    fn of_several_columns_depths_are_fitted_and_compared_with_what_cured() {
        let rows = [
            (10.0, "0,0,"),
            (15.0, "1,,"),
            (40.0, "1,1.0397208,1.1"),
            (80.0, "0,2.0794415,1.2"),
            (160.0, "1,3.1191623,1.3"),
        ];
        let found = fitted(&rows).unwrap();
        assert_eq!(found.from, "depth_mm");
        assert!((found.critical_mj_per_cm2 - 20.0).abs() < 1e-4);
        assert_eq!(found.against_cured, Some(vec![15.0, 80.0]));
        // Two depths fix nothing, and three diameters do
        let rows = rows.map(|(dose, cells)| (dose, cells.replace("1.0397208", "")));
        let rows = rows.each_ref().map(|(dose, cells)| (*dose, cells.as_str()));
        assert_eq!(fitted(&rows).unwrap().from, "diameter_mm");
    }

    #[test]
    fn doses_and_depths_that_are_swapped_have_large_errors() {
        let depths = [0.3, 1.0, 2.0, 3.0, 4.0];
        let rows = depths.map(|depth: f64| (depth, format!(",{},", 20.0 * (depth / 1.5).exp())));
        let rows = rows.each_ref().map(|(dose, cells)| (*dose, cells.as_str()));
        let errors = fitted(&rows).unwrap().relative_errors();
        assert!(
            errors.iter().all(|error| error.unwrap() > 0.2),
            "{errors:?}"
        );
    }
}
