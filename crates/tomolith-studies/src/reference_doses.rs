//! Doses of fixed patterns next to those of Dr.TVAM: `reference_doses FOLDER`.
//!
//! FOLDER holds `drtvam_patterns_36x64x96.npz` (`patterns` [angle, row, column]) and doses of them, `drtvam_CASE.npz` (`dose_zyx`): 64³
//! voxels over 4 mm, pixels of 0.0625 mm, resin n 1.48 in an index-matched bath of radius 3.5 mm (`im`) or in a cylinder 3.5/4 mm, n
//! 1.52, in air (`cyl`, whose doses lack the factor 1.48²); `center`: one ray through the middle of each pixel, `spp64`: 64 random
//! ones. See docs/validation.md for the table.
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use ndarray::{Array3, Ix3};
use ndarray_npy::NpzReader;
use std::error::Error;
use std::fs::File;
use std::path::Path;
use tomolith::field::HostField;
use tomolith::grid::{PatternGrid, Patterns, Volume, VolumeGrid};
use tomolith::models::parallel::Parallel;
use tomolith::models::rays::{self, Optics, Rays};
use tomolith::models::{DoseModel, Work, monte_carlo, successive_orders};
use tomolith::optics::light::Light;
use tomolith::optics::phase::{Scattering, isotropic::Isotropic};
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::Vial;
use tomolith::optics::vial::cylinder::Cylinder;
use tomolith::optics::vial::index_matched::IndexMatched;

type Model = Box<dyn DoseModel<Field = HostField>>;

const PITCH_MM: f64 = 0.0625;
const INDEX: f64 = 1.48;

fn read(path: &Path, name: &str) -> Result<Array3<f32>, Box<dyn Error>> {
    let mut npz = NpzReader::new(File::open(path)?)?;
    Ok(npz.by_name::<ndarray::OwnedRepr<f32>, Ix3>(name)?)
}

fn vial(is_glass: bool) -> Box<dyn Vial> {
    if is_glass {
        Box::new(Cylinder::new(3.5, 4.0, 1.52))
    } else {
        Box::new(IndexMatched { radius_mm: 3.5 })
    }
}

/// Means over blocks of `edge`³ voxels.
fn blocks(dose: &Volume<f32>, edge: usize) -> Vec<f64> {
    let n = 64 / edge;
    let mut sums = vec![0.0; n * n * n];
    for (i, &value) in dose.values.iter().enumerate() {
        let [z, y, x] = [i / 4096, i / 64 % 64, i % 64].map(|v| v / edge);
        sums[(z * n + y) * n + x] += f64::from(value) / edge.pow(3) as f64;
    }
    sums
}

/// Sum over sum, rms and largest difference over the largest dose.
fn differences(found: &[f64], expected: &[f64]) -> [f64; 3] {
    let most = expected.iter().copied().fold(0.0, f64::max);
    let pairs = || found.iter().zip(expected);
    let squares: f64 = pairs().map(|(a, b)| (a - b).powi(2)).sum();
    let worst = pairs().map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let ratio = found.iter().sum::<f64>() / expected.iter().sum::<f64>();
    [
        ratio - 1.0,
        (squares / found.len() as f64).sqrt() / most,
        worst / most,
    ]
}

struct Bench {
    patterns: Patterns,
    grid: VolumeGrid,
}

impl Bench {
    fn light(&self, mu: f64, albedo: f64) -> Light {
        let mut light = Light::new(
            self.patterns.grid.clone(),
            Resin::absorbing(INDEX, (1.0 - albedo) * mu),
        );
        light.resin.attenuation_per_mm = mu;
        light
    }

    fn rays(&self, vial: &dyn Vial, mu: f64, count: usize) -> Result<Model, Box<dyn Error>> {
        let params = rays::Params {
            rays_per_pixel: count,
            ..rays::Params::default()
        };
        let optics = [Optics::collimated(PITCH_MM)];
        let lights = vec![self.light(mu, 0.0)];
        Ok(Box::new(Rays::new(
            vial,
            lights,
            &optics,
            &params,
            self.grid.clone(),
        )?))
    }

    fn parallel(&self, vial: &dyn Vial, mu: f64) -> Result<Model, Box<dyn Error>> {
        let lights = vec![self.light(mu, 0.0)];
        Ok(Box::new(Parallel::new(vial, lights, self.grid.clone())?))
    }

    fn dose(&self, model: &Model) -> Result<Volume<f32>, Box<dyn Error>> {
        let mut x = model.new_patterns()?;
        model.patterns()[0].fill_field(&self.patterns, x.as_mut_slice());
        let mut dose = model.new_dose()?;
        model.dose(&x, &mut dose, &Work::new())?;
        Ok(model.outputs()[0].volume_of(dose.as_slice()))
    }
}

pub(crate) fn study(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let folder = arguments.first().ok_or("give the folder of the arrays")?;
    let file = |name: &str| Path::new(&folder).join(format!("drtvam_{name}.npz"));
    let patterns = read(&file("patterns_36x64x96"), "patterns")?;
    let bench = Bench {
        patterns: Patterns {
            grid: PatternGrid::full_turn(36, 0.0, 64, 96, PITCH_MM),
            values: patterns.iter().copied().collect(),
        },
        grid: VolumeGrid::centered([64, 64, 64], PITCH_MM),
    };
    println!(
        "case                        model                 blocks   sum − 1     rms/largest  worst/largest"
    );
    let cases = [
        ("im_mu0.01_center", false, 0.01),
        ("im_mu0.3_center", false, 0.3),
        ("im_mu0.01_spp64", false, 0.01),
        ("im_mu0.3_spp64", false, 0.3),
        ("cyl_mu0.01_center", true, 0.01),
        ("cyl_mu0.3_center", true, 0.3),
        ("cyl_mu0.3_spp64", true, 0.3),
    ];
    for (case, is_glass, mu) in cases {
        let vial = vial(is_glass);
        let factor = if is_glass { INDEX * INDEX } else { 1.0 };
        let expected = volume(&read(&file(case), "dose_zyx")?, factor, &bench.grid);
        let is_one = case.ends_with("center");
        let count = if is_one { 1 } else { 64 };
        let rays = bench.rays(vial.as_ref(), mu, count)?;
        let name = format!("rays, {count} a pixel");
        print(case, &name, &bench.dose(&rays)?, &expected);
        if !is_one {
            let parallel = bench.parallel(vial.as_ref(), mu)?;
            print(case, "parallel", &bench.dose(&parallel)?, &expected);
        }
    }
    scattering(&bench, &file("im_mu0.3_albedo0.5_isotropic"))
}

fn volume(values: &Array3<f32>, factor: f64, grid: &VolumeGrid) -> Volume<f32> {
    let scaled = values.iter().map(|v| (f64::from(*v) * factor) as f32);
    Volume::new(grid.clone(), scaled.collect())
}

fn print(case: &str, name: &str, found: &Volume<f32>, expected: &Volume<f32>) {
    for edge in [1, 4] {
        let [sum, rms, worst] = differences(&blocks(found, edge), &blocks(expected, edge));
        println!("{case:27} {name:21} {edge}³       {sum:9.2e}  {rms:9.2e}    {worst:9.2e}");
    }
}

fn scattering(bench: &Bench, file: &Path) -> Result<(), Box<dyn Error>> {
    let expected = volume(&read(file, "dose_zyx")?, 1.0, &bench.grid);
    let vial = vial(false);
    let light = bench.light(0.3, 0.5);
    let grid = || bench.grid.clone();
    let mut optics = [Optics::collimated(PITCH_MM)];
    optics[0].scattering = Some(Scattering::new(0.15, Isotropic {}));
    let orders = successive_orders::model(
        vial.as_ref(),
        vec![light.clone()],
        &optics,
        &successive_orders::Params::default(),
        grid(),
    )?;
    let params = monte_carlo::Params {
        paths_per_pixel: 16,
        ..monte_carlo::Params::default()
    };
    let paths = monte_carlo::model(vial.as_ref(), &[light], &optics, &params, grid())?;
    let case = "im_mu0.3_albedo0.5_isotropic";
    let models: [(&str, Model); 2] = [
        ("successive_orders", Box::new(orders)),
        ("monte_carlo, 16 a pixel", Box::new(paths)),
    ];
    for (name, model) in models {
        print(case, name, &bench.dose(&model)?, &expected);
    }
    Ok(())
}
