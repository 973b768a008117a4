//! What sampling costs in accuracy.

use super::twin::{Gather, Savings, Twin};
use super::{EDGES, random_pixels, sampling_of, savings_of, tight_window};
use tomolith::Error;
use tomolith::field::Field;
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::models::wave::{Params, Wave};
use tomolith::models::{DoseModel, Run};
use tomolith::optics::light::Light;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;

/// Dose of one frame of a pattern from an azimuth, in a vial with room to spare: the model, and its dose at `[z, y, x]`.
fn frame(
    grid: VolumeGrid,
    (x, pitch, azimuth): (&[f64], f64, f64),
    params: &Params,
) -> Result<(Wave, impl Fn([usize; 3]) -> f64), Error> {
    let n = x.len().isqrt();
    let light = Light::new(
        PatternGrid::full_turn(1, azimuth, n, n, pitch),
        Resin::pure_radon(1.5),
    );
    let vial = IndexMatched {
        radius_mm: pitch * n as f64,
    };
    let model = Wave::new(&vial, vec![light], params, grid)?;
    let mut field = model.new_patterns()?;
    let values: Vec<f32> = x.iter().map(|&v| v as f32).collect();
    field.copy_from_host(&values);
    let mut dose = model.new_dose()?;
    model.dose(&field, &mut dose, &Run::new())?;
    let layout = model.outputs()[0].clone();
    let at = move |[z, y, x]: [usize; 3]| f64::from(dose.as_slice()[layout.index(z, y, x)]);
    Ok((model, at))
}

/// |ψ|² `[x][u][z]` at some depths of n³ voxels, `off` voxels beside their planes.
fn light_of_twin(n: usize, pitch: f64, savings: Savings, x: &[f64], off: f64) -> Vec<Vec<f64>> {
    let twin = Twin::<f64>::new(n, pitch, savings);
    let planes = (0..n).step_by(5);
    planes
        .map(|k| twin.intensity(x, twin.depth(k) - off * pitch))
        .collect()
}

/// The same by the model, which is described: light from +x, so depth falls with x.
fn light_of_model(
    n: usize,
    pitch: f64,
    (params, off): (&Params, f64),
    x: &[f64],
) -> Result<(String, Vec<Vec<f64>>), Error> {
    let grid = VolumeGrid {
        center_mm: [off * pitch, 0.0, 0.0],
        ..VolumeGrid::centered([n, n, n], pitch)
    };
    let (model, at) = frame(grid, (x, pitch, 0.0), params)?;
    let plane = |k: usize| (0..n * n).map(|i| at([i % n, i / n, n - 1 - k])).collect();
    Ok((sampling_of(&model), (0..n).step_by(5).map(plane).collect()))
}

/// Relative L2, and the largest difference over the largest value.
fn distance(a: &[Vec<f64>], b: &[Vec<f64>]) -> [f64; 2] {
    let (mut error, mut square, mut worst, mut most) = (0.0, 0.0, 0.0f64, 0.0f64);
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        error += (a - b).powi(2);
        square += b * b;
        worst = worst.max((a - b).abs());
        most = most.max(b.abs());
    }
    [(error / square).sqrt(), worst / most]
}

/// |ψ|² of patterns of random pixels before rotation: the published window, and the model, against a window eight times as wide.
pub(super) fn errors() -> Result<(), Error> {
    let n = 64;
    let wide = Savings {
        one_transform: true,
        window: 8.0,
        soft_edge: 0.25,
        ..Savings::NONE
    };
    let x = random_pixels(n * n);
    println!(
        "| edge, mm | edge of the band | window 2N: L2 | largest | tight window: L2 | largest |"
    );
    println!("|---|---|---|---|---|---|");
    for edge in EDGES {
        for soft_edge in [0.0, 0.25] {
            let pitch = edge / 550.0;
            let light = |window: f64| {
                let savings = Savings {
                    window,
                    soft_edge,
                    ..wide
                };
                light_of_twin(n, pitch, savings, &x, 0.3)
            };
            let exact = light(8.0);
            let [double, tight] = [2.0, tight_window(pitch)]
                .map(|window| distance(&light(window), &exact))
                .map(|[l2, largest]| format!("{l2:.1e} | {largest:.1e}"));
            println!("| {edge} | {soft_edge} | {double} | {tight} |");
        }
    }
    println!("\n| edge, mm | asked | on planes: L2 | largest | between: L2 | largest | sampling |");
    println!("|---|---|---|---|---|---|---|");
    for edge in EDGES {
        // The pixels of the article, N = 550, of which a corner
        let pitch = edge / 550.0;
        for asked in [1e-2, 1e-3, 1e-4] {
            let params = Params {
                relative_error: asked,
                rotation_error: 1e-5,
                ..Params::default()
            };
            let mut found = Vec::new();
            let mut described = String::new();
            for off in [0.0, 0.5] {
                let light;
                (described, light) = light_of_model(n, pitch, (&params, off), &x)?;
                found.push(distance(&light, &light_of_twin(n, pitch, wide, &x, off)));
            }
            let [on, between] = [found[0], found[1]];
            println!(
                "| {edge} | {asked:.0e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {} |",
                on[0], on[1], between[0], between[1], described
            );
        }
    }
    Ok(())
}

/// |ψ|² of random patterns of single pixels on all planes, of the twin with each saving alone against the twin in f64 without; all of them with a soft
/// edge of the band, as windows do not agree without.
pub(super) fn savings(sizes: &[usize]) -> Result<(), Error> {
    println!("| N | edge, mm | saving | L2 | largest |");
    println!("|---|---|---|---|---|");
    for &n in sizes {
        for edge in EDGES {
            let pitch = edge / n as f64;
            let x = random_pixels(n * n);
            let single: Vec<f32> = x.iter().map(|&v| v as f32).collect();
            let soft = |savings: Savings| Savings {
                soft_edge: 0.25,
                ..savings
            };
            let published = Twin::<f64>::new(n, pitch, soft(Savings::NONE));
            let twin = published.light(&x);
            let show = |name: &str, light: Vec<f64>| {
                let [l2, largest] = distance(&[light], std::slice::from_ref(&twin));
                println!("| {n} | {edge} | {name} | {l2:.1e} | {largest:.1e} |");
            };
            let of_light = |(_, savings): &(_, Savings)| savings.gather != Gather::Planes;
            let alone = savings_of(n, pitch).into_iter().skip(1);
            for (name, savings) in alone.filter(of_light) {
                show(name, Twin::<f64>::new(n, pitch, soft(savings)).light(&x));
            }
            // What voxels read is the same, after the rotation
            let gather = soft(Savings {
                gather: Gather::Planes,
                ..Savings::NONE
            });
            let dose = Twin::<f64>::new(n, pitch, gather).dose(&x, 0.4);
            let [l2, largest] = distance(&[dose], &[published.dose(&x, 0.4)]);
            println!("| {n} | {edge} | gather, dose of a frame | {l2:.1e} | {largest:.1e} |");
            for (name, whole_phase) in [("f32", false), ("f32, whole phase", true)] {
                let savings = Savings {
                    whole_phase,
                    ..soft(Savings::NONE)
                };
                let light = Twin::<f32>::new(n, pitch, savings).light(&single);
                show(name, light.into_iter().map(f64::from).collect());
            }
        }
    }
    Ok(())
}

/// Dose of one frame of random pixels on voxels that have turned by 0.4 rad: as the model is by default, and as a bilinear rotation of all planes at the
/// pixels makes it, against lateral samples and depths to 1e-5; on voxels of a pixel's size and on those half as large.
pub(super) fn rotation() -> Result<(), Error> {
    println!("| edge, mm | voxels | bilinear: L2 | largest | Tomolith: L2 | largest |");
    println!("|---|---|---|---|---|---|");
    let n = 64;
    let x = random_pixels(n * n);
    for edge in EDGES {
        let pitch = edge / 550.0;
        let soft = Savings {
            soft_edge: 0.25,
            one_transform: true,
            ..Savings::NONE
        };
        let twin = Twin::<f64>::new(n, pitch, soft);
        let volume = twin.light(&x);
        for finer in [1, 2] {
            // What turns within the planes, at the heights of rows
            let across = 2 * (n * finer / 3);
            let grid = VolumeGrid {
                center_mm: [0.0, 0.0, 0.5 * pitch * (1.0 - 1.0 / finer as f64)],
                ..VolumeGrid::centered([across, across, 16 * finer], pitch / finer as f64)
            };
            let bilinear: Vec<f64> = places(&grid, finer)
                .map(|[iz, iy, ix]| {
                    let at = [grid.x(ix) / pitch, grid.y(iy) / pitch];
                    let z = (grid.z(iz) / pitch + (n as f64 - 1.0) / 2.0).round() as usize;
                    let parts = twin.neighbors(at, 0.4f64.sin_cos());
                    let value = |(k, j, w): (usize, usize, f64)| w * volume[(k * n + j) * n + z];
                    parts.map(value).iter().sum()
                })
                .collect();
            let exact = Params {
                relative_error: 1e-5,
                rotation_error: 1e-5,
                ..Params::default()
            };
            let exact = turned(&grid, pitch, &exact, (&x, finer))?;
            let ours = turned(&grid, pitch, &Params::default(), (&x, finer))?;
            let [theirs, ours] = [bilinear, ours]
                .map(|light| distance(&[light], std::slice::from_ref(&exact)))
                .map(|[l2, largest]| format!("{l2:.1e} | {largest:.1e}"));
            println!("| {edge} | 1/{finer} of a pixel | {theirs} | {ours} |");
        }
    }
    Ok(())
}

/// Voxels [iz, iy, ix] of a grid at the heights of rows.
fn places(grid: &VolumeGrid, finer: usize) -> impl Iterator<Item = [usize; 3]> + use<> {
    let [nz, ny, nx] = grid.shape;
    (0..nz)
        .step_by(finer)
        .flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [z, y, x])))
}

/// Dose of one frame from azimuth 0.4 at the heights of rows.
fn turned(
    grid: &VolumeGrid,
    pitch: f64,
    params: &Params,
    (x, finer): (&[f64], usize),
) -> Result<Vec<f64>, Error> {
    let (_, at) = frame(grid.clone(), (x, pitch, 0.4), params)?;
    Ok(places(grid, finer).map(at).collect())
}
