//! Voxel-frame updates per second of dose and adjoint on a graphics card: `throughput [CARD] [VOXELS] [ANGLES]`.
//!
//! An absorbing, index-matched cylinder that touches the sides of a cube of voxels, as many columns and rows of pixels as the cube has voxels
//! across and up. Also the bytes per second of y ← y + a·x, which is bound by the card's memory.
#![expect(clippy::print_stdout, reason = "a program for a terminal")]

use std::error::Error;
use std::time::Instant;
use tomolith_core::dose::Run;
use tomolith_core::field::Field;
use tomolith_core::grid::{PatternGrid, VolumeGrid};
use tomolith_gpu::{Asked, Gpu, model_on};
use tomolith_models::rays::Optics;
use tomolith_models::{ModelFamily, ModelInput, OpticalScene, Purpose, parallel};
use tomolith_optics::light::Light;
use tomolith_optics::resin::Resin;
use tomolith_optics::vial::index_matched::IndexMatched;

/// Calls that are timed together.
const CALLS: u32 = 4;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_default();
    let voxels: usize = arguments.next().map_or(Ok(256), |n| n.parse())?;
    let angles: usize = arguments.next().map_or(Ok(360), |n| n.parse())?;
    let gpu = Gpu::open(&if name.is_empty() {
        Asked::Any
    } else {
        Asked::Named(&name)
    })?;
    println!("{:?}", gpu.adapter());
    let pitch = 10.0 / voxels as f64;
    let light = Light::new(
        PatternGrid::full_turn(angles, 0.0, voxels, voxels, pitch),
        Resin::absorbing(1.5, 0.1),
    );
    let (vial, lights) = (IndexMatched { radius_mm: 5.0 }, [light]);
    let optics = [Optics::collimated(pitch)];
    let scene = OpticalScene::new(&vial, &lights, &optics, Purpose::Optimize);
    let run = Run::new();
    let grid = VolumeGrid::centered([voxels; 3], pitch);
    let input = ModelInput::new(scene, &grid, &run)?;
    let begin = Instant::now();
    let form = parallel::Params::default().form(&input)?.ok_or("no form")?;
    println!(
        "geometry on the processor {:.3} s",
        begin.elapsed().as_secs_f64()
    );
    let begin = Instant::now();
    let model = model_on(&gpu, &form, &run)?;
    println!(
        "entries on the card {:.3} s: {}",
        begin.elapsed().as_secs_f64(),
        model.describe()
    );
    let updates = model.updates() as f64;
    println!("{updates:.3e} updates a call");
    let mut x = model.new_patterns()?;
    x.fill(1.0);
    let mut dose = model.new_dose()?;
    let mut grad = x.zeros_like();
    let timed =
        |what: &str, per: f64, unit: &str, work: &mut dyn FnMut() -> Result<(), Box<dyn Error>>| {
            work()?;
            let begin = Instant::now();
            for _ in 0..CALLS {
                work()?;
            }
            let seconds = begin.elapsed().as_secs_f64() / f64::from(CALLS);
            println!("{what} {seconds:.4} s, {:.3e} {unit}/s", per / seconds);
            Ok::<(), Box<dyn Error>>(())
        };
    timed("dose", updates, "updates", &mut || {
        model.dose(&x, &mut dose, &run)?;
        dose.max_abs();
        Ok(())
    })?;
    timed("adjoint", updates, "updates", &mut || {
        model.pullback(&x, &dose, &mut grad, &run)?;
        grad.max_abs();
        Ok(())
    })?;
    let other = dose.clone();
    timed("y + a·x", 12.0 * dose.len() as f64, "bytes", &mut || {
        dose.axpy(0.5, &other);
        dose.dot(&other);
        Ok(())
    })?;
    gpu.check()?;
    Ok(())
}
