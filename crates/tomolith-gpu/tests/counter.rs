//! What the print of a dose is measured from, beside the host: the same numbers, to the last bit.

mod common;

use common::{SMALL, gpu};
use tomolith_core::check::noise;
use tomolith_core::dose::DoseLayout;
use tomolith_core::field::Field;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::target::label::{OUTSIDE, PART, VOID};
use tomolith_gpu::GpuField;
use tomolith_metrics::quick::{quick, quick_of};

#[path = "common/portable.rs"]
mod portable;

/// Doses and labels of a few pieces, and of one.
#[test]
fn the_print_of_a_dose_has_the_numbers_of_the_host_to_the_last_bit() {
    let grid = VolumeGrid::centered([33, 40, 41], 0.1);
    for (most, seed) in [(SMALL, 1), (SMALL, 2), (u64::MAX, 3)] {
        let Some(gpu) = gpu(most) else { return };
        let layout = DoseLayout::new("", grid.clone(), 0);
        let like = GpuField::for_dose(&gpu, &layout);
        let n = layout.voxels();
        assert_eq!(like.to_host().len(), n);
        let mut labels: Vec<u8> = (0..n)
            .map(|i| [OUTSIDE, VOID, PART, VOID, 7][(7 * i + i / 3) % 5])
            .collect();
        let mut dose: Vec<f32> = noise(seed, n);
        let part = |i: usize| if labels[i] == PART { 0.6 } else { 0.0 };
        dose.iter_mut().enumerate().for_each(|(i, v)| *v += part(i));
        let compare = |labels: &[u8], dose: &[f32], what: &str| {
            let mut there = like.zeros_like();
            there.copy_from_host(dose);
            let counter = there.counter(labels).unwrap();
            let found = quick_of(counter.as_ref(), &there);
            gpu.check().unwrap();
            // What is beyond the labels does not count
            let expected = quick(labels, &dose[..labels.len()]);
            assert_eq!(found, expected, "{what}");
            expected
        };
        assert!(compare(&labels, &dose, "noise").is_some());
        let negative: Vec<f32> = dose.iter().map(|v| v - 5.0).collect();
        assert!(compare(&labels, &negative, "below zero").is_some());
        assert!(compare(&labels[..n / 3], &dose, "labels of some elements").is_some());
        assert!(compare(&labels, &vec![0.25; n], "one value").is_some());
        assert!(compare(&labels, &vec![-0.0; n], "dark").is_some());
        // Where nothing counts anything may stand
        let at = |wanted| labels.iter().position(|&label| label == wanted).unwrap();
        let (outside, void, first) = (at(OUTSIDE), at(VOID), at(PART));
        let with = |i: usize, value: f32| {
            let mut dose = dose.clone();
            dose[i] = value;
            dose
        };
        for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert!(compare(&labels, &with(outside, value), "outside").is_some());
            compare(&labels, &with(void, value), "void");
            compare(&labels, &with(first, value), "part");
        }
        assert_eq!(
            compare(&labels, &with(void, f32::INFINITY), "infinite"),
            None
        );
        let no_void: Vec<u8> = labels
            .iter()
            .map(|&l| if l == VOID { OUTSIDE } else { l })
            .collect();
        assert_eq!(
            compare(&no_void, &dose, "no void").unwrap().process_window,
            None
        );
        labels.iter_mut().for_each(|label| *label = VOID);
        assert_eq!(compare(&labels, &dose, "no part"), None);
        portable::assert_portable(gpu.sources().iter().map(|(name, text)| (name, text)));
    }
}
