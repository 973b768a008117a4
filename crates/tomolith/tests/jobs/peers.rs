//! Dose volumes of another program, when they are at hand: `TOMOLITH_REFERENCE=folder cargo test --release --test jobs peers --
//! --ignored`. The numbers of a run are in docs/validation.md.

#![expect(
    clippy::print_stderr,
    reason = "prints the numbers that go into docs/validation.md"
)]

use ndarray_npy::NpzReader;
use std::fs::File;
use std::path::PathBuf;
use tomolith::field::HostField;
use tomolith::grid::{PatternGrid, Patterns, VolumeGrid};
use tomolith::models::parallel::Parallel;
use tomolith::models::{DoseModel, Work};
use tomolith::optics::light::Light;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::{Vial, cylinder::Cylinder, index_matched::IndexMatched};

fn array(file: &str, name: &str) -> ndarray::Array3<f64> {
    let folder = std::env::var("TOMOLITH_REFERENCE")
        .expect("TOMOLITH_REFERENCE names the folder with the arrays");
    let path = PathBuf::from(folder).join(file);
    let mut npz = NpzReader::new(File::open(&path).expect("reference file")).expect("npz");
    npz.by_name::<_, ndarray::Ix3>(name)
        .map(|a: ndarray::Array3<f32>| a.mapv(f64::from))
        .or_else(|_| npz.by_name::<ndarray::OwnedRepr<f64>, ndarray::Ix3>(name))
        .expect("array")
}

/// Relative difference of totals, and rms difference relative to the rms of the reference.
fn compare(vial: &dyn Vial, mu: f64, file: &str, factor: f64, refine: usize) -> (f64, f64) {
    let pixels = PatternGrid::full_turn(36, 0.0, 64, 96, 0.0625);
    let images = array("drtvam_patterns_36x64x96.npz", "patterns");
    let patterns = Patterns {
        grid: pixels.clone(),
        values: images.iter().map(|&v| v as f32).collect(),
    };
    let light = Light::new(pixels, Resin::absorbing(1.48, mu));
    let model = Parallel::new(
        vial,
        vec![light],
        VolumeGrid::centered([64, 64, 64], 0.0625).refined(refine),
    )
    .expect("model");
    let mut x = model.new_patterns().expect("patterns");
    model.patterns()[0].fill_field(&patterns, x.as_mut_slice());
    let mut dose: HostField = model.new_dose().expect("dose");
    model.dose(&x, &mut dose, &Work::new()).expect("dose");
    let fine = model.outputs()[0].volume_of(dose.as_slice());
    // Mean of the fine voxels of each voxel of the reference
    let mut ours = vec![0.0; 64 * 64 * 64];
    for iz in 0..64 * refine {
        for iy in 0..64 * refine {
            for ix in 0..64 * refine {
                ours[((iz / refine) * 64 + iy / refine) * 64 + ix / refine] +=
                    f64::from(*fine.at(iz, iy, ix)) / refine.pow(3) as f64;
            }
        }
    }
    let theirs = array(file, "dose_zyx");
    let (mut total, mut reference, mut squares, mut size) = (0.0, 0.0, 0.0, 0.0);
    for (&a, b) in ours.iter().zip(theirs.iter()) {
        let b = b * factor;
        total += a;
        reference += b;
        squares += (a - b).powi(2);
        size += b * b;
    }
    (total / reference - 1.0, (squares / size).sqrt())
}

#[test]
#[ignore = "slow"]
fn doses_agree_with_dr_tvam() {
    if std::env::var_os("TOMOLITH_REFERENCE").is_none() {
        return eprintln!("skipped: TOMOLITH_REFERENCE names no folder with the arrays of Dr.TVAM");
    }
    let matched = IndexMatched { radius_mm: 3.5 };
    let cylinder = Cylinder::new(3.5, 4.0, 1.52);
    // 64 random rays a pixel: noise below 1 %. Its refracting doses lack the factor n² (docs/validation.md).
    let cases: [(&dyn Vial, f64, &str, f64); 3] = [
        (&matched, 0.01, "drtvam_im_mu0.01_spp64.npz", 1.0),
        (&matched, 0.3, "drtvam_im_mu0.3_spp64.npz", 1.0),
        (&cylinder, 0.3, "drtvam_cyl_mu0.3_spp64.npz", 1.48 * 1.48),
    ];
    for (vial, mu, file, factor) in cases {
        // The patterns are white noise, pixel by pixel, and the reference carries the noise of its 64 rays a pixel: what
        // refinement does not remove is that
        for (refine, bound) in [(1, 2.6e-2), (2, 2.5e-2), (4, 2.5e-2)] {
            let (total, rms) = compare(vial, mu, file, factor, refine);
            eprintln!("{file} / {refine}: total {total:+.2e}, rms {rms:.2e}");
            assert!(total.abs() < 1e-3, "{file}: total {total}");
            assert!(rms < bound, "{file}: rms {rms}");
        }
    }
}
