//! Compares the kernels of pure Radon with arrays of ASTRA: `astra_kernels FILE`.
//!
//! FILE is an `.npz` with `phantom` [row, column] (pixel size 1, rows fall with y), `angles_rad`, and for each kernel
//! `sino_KIND` [angle, detector] and `bp_KIND` (the transpose applied to `sino_KIND`), detector coordinate
//! s = x·cos a + y·sin a. See docs/validation.md for the table.
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use ndarray::{Array1, Array2};
use ndarray_npy::NpzReader;
use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::fs::File;
use tomolith::field::HostField;
use tomolith::grid::{PatternGrid, Patterns, Volume, VolumeGrid};
use tomolith::models::parallel::{Kernel, Parallel};
use tomolith::models::{DoseModel, LinearOperator, Run};
use tomolith::optics::light::Light;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;

/// Largest difference over the largest value, and ‖a − b‖/‖b‖.
fn differences(found: &[f32], expected: &[f32]) -> [f64; 2] {
    let both = || {
        found
            .iter()
            .zip(expected)
            .map(|(&a, &b)| (f64::from(a), f64::from(b)))
    };
    let largest = both().fold(0.0, |m: f64, (_, b)| m.max(b.abs()));
    let worst = both().fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
    let square = |f: &dyn Fn((f64, f64)) -> f64| both().map(|p| f(p).powi(2)).sum::<f64>();
    let norm = (square(&|(a, b)| a - b) / square(&|(_, b)| b)).sqrt();
    [worst / largest, norm]
}

pub(crate) fn study(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let path = arguments.first().ok_or("give the .npz")?;
    let mut npz = NpzReader::new(File::open(path)?)?;
    let phantom: Array2<f32> = npz.by_name("phantom")?;
    let angles: Array1<f64> = npz.by_name("angles_rad")?;
    let n = phantom.nrows();
    let grid = VolumeGrid::centered([1, n, n], 1.0);
    let upside_down =
        |values: &[f32]| -> Vec<f32> { values.chunks(n).rev().flatten().copied().collect() };
    println!("kernel   detectors  call     worst/largest  ‖difference‖/‖expected‖");
    for kernel in [Kernel::Line, Kernel::Linear, Kernel::Strip] {
        for suffix in ["", "_det192"] {
            let name = |what: &str| format!("{what}_{}{suffix}", kernel.name());
            let sino: Array2<f32> = npz.by_name(&name("sino"))?;
            let back: Array2<f32> = npz.by_name(&name("bp"))?;
            // Our columns grow along (−sin α, cos α)
            let pixels = PatternGrid {
                azimuths: angles.iter().map(|a| a - FRAC_PI_2).collect(),
                frame_arc: 0.0,
                rows: 1,
                columns: sino.ncols(),
                pitch_mm: [1.0; 2],
                offset_mm: [0.0; 2],
            };
            let light = Light::new(pixels.clone(), Resin::pure_radon(1.5));
            let vial = IndexMatched {
                radius_mm: 2.0 * n as f64,
            };
            let model = Parallel::under(&vial, vec![light], kernel, grid.clone(), &Run::new())?;
            let (run, layout) = (Run::new(), &DoseModel::outputs(&model)[0]);
            let image = Volume {
                grid: grid.clone(),
                values: upside_down(&phantom.iter().copied().collect::<Vec<_>>()),
            };
            let mut x = DoseModel::new_patterns(&model)?;
            let cotangent = HostField::from_slice(&layout.field_of(&image));
            model.adjoint(&cotangent, &mut x, &run)?;
            let patterns = &DoseModel::patterns(&model)[0];
            let expected: Vec<f32> = sino.iter().copied().collect();
            let found = patterns.patterns_of(x.as_slice()).values;
            let report = |call: &str, [worst, norm]: [f64; 2]| {
                println!(
                    "{:8} {:9}  {call:8} {worst:13.1e}  {norm:.1e}",
                    kernel.name(),
                    sino.ncols()
                );
            };
            report("adjoint", differences(&found, &expected));
            let shown = Patterns {
                grid: pixels,
                values: expected,
            };
            patterns.fill_field(&shown, x.as_mut_slice());
            let mut dose = DoseModel::new_dose(&model)?;
            model.dose(&x, &mut dose, &run)?;
            let found = upside_down(&layout.volume_of(dose.as_slice()).values);
            let expected: Vec<f32> = back.iter().copied().collect();
            report("dose", differences(&found, &expected));
        }
    }
    Ok(())
}
