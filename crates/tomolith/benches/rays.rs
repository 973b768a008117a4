//! Throughput of the `rays` model: `cargo bench -p tomolith --bench rays`.
//!
//! One *update* is one voxel that one ray passes. Level, tilted and conical light through glass; where the vial stands off its axis every
//! ray is traced anew in every call. The best of three calls counts.
#![expect(clippy::print_stdout, reason = "a bench prints its table")]

use std::sync::Arc;
use std::time::Instant;
use tomolith::field::Field;
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::models::rays::{Optics, Params, Rays};
use tomolith::models::{DoseModel, Work};
use tomolith::optics::light::Light;
use tomolith::optics::motion::Motion;
use tomolith::optics::projector::telecentric::Telecentric;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::cylinder::Cylinder;

fn optics(name: &str) -> Optics {
    let mut optics = Optics::collimated(0.025);
    match name {
        "tilted by 6.8°" => optics.motion.tilt_rad = 6.8f64.to_radians(),
        "cones of 0.05" => {
            optics.projector = Arc::new(Telecentric {
                pixel_pitch_mm: [0.025; 2],
                aperture_radius_mm: 5.0,
                working_distance_mm: 100.0,
                focus_mm: 0.0,
            });
        }
        "level, off axis" | "tilted, off axis" => {
            optics.motion = Motion {
                offset_mm: [0.2, 0.1],
                tilt_rad: if name == "tilted, off axis" {
                    6.8f64.to_radians()
                } else {
                    0.0
                },
                ..Motion::default()
            };
        }
        _ => {}
    }
    optics
}

fn main() {
    let vial = Cylinder::new(8.0, 8.7, 1.58);
    println!("light, rays, updates, dose s, adjoint s, dose and adjoint 10^6 updates/s");
    let names = [
        "level",
        "level, off axis",
        "tilted by 6.8°",
        "cones of 0.05",
        "tilted, off axis",
    ];
    for name in names {
        let mut light = Light::new(
            PatternGrid::full_turn(8, 0.0, 256, 256, 0.025),
            Resin::absorbing(1.4849, 0.1),
        );
        light.surrounding_index = 1.0;
        let grid = VolumeGrid::centered([256; 3], 0.025);
        let params = Params {
            rays_per_pixel: 1,
            ..Params::default()
        };
        let model = Rays::new(&vial, vec![light], &[optics(name)], &params, grid).expect("a model");
        let (mut x, mut dose) = (
            model.new_patterns().expect("memory"),
            model.new_dose().expect("memory"),
        );
        x.fill(1.0);
        let work = Work::new();
        let best = |f: &mut dyn FnMut()| {
            let time = |f: &mut dyn FnMut()| {
                let start = Instant::now();
                f();
                start.elapsed().as_secs_f64()
            };
            (0..3).map(|_| time(f)).fold(f64::INFINITY, f64::min)
        };
        let forward = best(&mut || model.dose(&x, &mut dose, &work).expect("dose"));
        let mut grad = x.zeros_like();
        let adjoint = best(&mut || {
            model
                .pullback(&x, &dose, &mut grad, &work)
                .expect("adjoint")
        });
        let updates = model.updates() as f64;
        println!(
            "{name}, {}, {:.3e}, {forward:.3}, {adjoint:.3}, {:.0}, {:.0}",
            x.len(),
            updates,
            updates / forward / 1e6,
            updates / adjoint / 1e6
        );
    }
}
