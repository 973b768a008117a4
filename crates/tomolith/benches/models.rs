//! Throughput of the dose models: `cargo bench -p tomolith --bench models`.
use std::time::Instant;
use tomolith::field::{Field, HostField};
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::models::parallel::{Light, Parallel};
use tomolith::models::{DoseModel, Run};
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::{Vial, cylinder::Cylinder, index_matched::IndexMatched};

fn main() {
    let cases: Vec<(&str, Box<dyn Vial>, usize, usize, f64, Resin)> = vec![
        (
            "straight 256",
            Box::new(IndexMatched { radius_mm: 6.0 }),
            256,
            360,
            0.025,
            Resin::pure_radon(1.4849),
        ),
        (
            "absorb 256",
            Box::new(IndexMatched { radius_mm: 6.0 }),
            256,
            360,
            0.025,
            Resin::absorbing(1.4849, 0.1),
        ),
        (
            "cylinder 256",
            Box::new(Cylinder {
                inner_radius_mm: 8.0,
                outer_radius_mm: 8.7,
                refractive_index: 1.58,
            }),
            256,
            360,
            0.041,
            Resin::absorbing(1.4849, 0.1),
        ),
    ];
    for (name, vial, n, angles, pitch, resin) in cases {
        let pixels = PatternGrid::full_turn(angles, 0.0, n, n, pitch);
        let light = Light::new(pixels, resin);
        let h = if pitch > 0.03 { 6.4 / n as f64 } else { pitch };
        let start = Instant::now();
        let model = Parallel::new(
            vial.as_ref(),
            vec![light],
            VolumeGrid::centered([n, n, n], h),
        )
        .unwrap();
        let built = start.elapsed();
        let mut x = model.new_patterns().unwrap();
        x.fill(1.0);
        let mut dose = model.new_dose().unwrap();
        let mut grad = x.zeros_like();
        let run = Run::new();
        let updates = model.updates() as f64;
        for (what, adjoint) in [("dose", false), ("adjoint", true)] {
            let mut best = f64::MAX;
            for _ in 0..3 {
                let t = Instant::now();
                if adjoint {
                    model.pullback(&x, &dose, &mut grad, &run).unwrap();
                } else {
                    model.dose(&x, &mut dose, &run).unwrap();
                }
                best = best.min(t.elapsed().as_secs_f64());
            }
            println!(
                "{name:14} {what:8} {best:7.3} s {:6.1} Gupd/s  (updates {:.2e}, built {built:?})",
                updates / best / 1e9,
                updates
            );
        }
        let _: &HostField = &dose;
    }
}
