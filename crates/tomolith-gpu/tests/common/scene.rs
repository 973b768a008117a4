//! Vials and light that tests of rays and of paths share.

use crate::portable::assert_portable;
use std::collections::BTreeMap;
use std::sync::Arc;
use tomolith_core::Error;
use tomolith_core::check;
use tomolith_core::dose::form::Form;
use tomolith_core::dose::{Accelerator, Work};
use tomolith_core::grid::PatternGrid;
use tomolith_gpu::{Gpu, model_on};
use tomolith_models::rays::Optics;
use tomolith_optics::projector::telecentric::Telecentric;
use tomolith_optics::vial::Vial;
use tomolith_optics::vial::cylinder::Cylinder;
use tomolith_optics::vial::square::Square;

pub(crate) fn glass() -> Box<dyn Vial> {
    Box::new(Cylinder::new(1.5, 1.7, 1.54))
}

pub(crate) fn square() -> Box<dyn Vial> {
    Box::new(Square::new(2.6, 3.0, 1.5))
}

/// A full turn of frames of 21 × 31 pixels.
pub(crate) fn pixels(frames: usize) -> PatternGrid {
    PatternGrid::full_turn(frames, 0.1, 21, 31, 0.1)
}

pub(crate) fn cone() -> Optics {
    Optics {
        projector: Arc::new(Telecentric {
            pixel_pitch_mm: [0.1; 2],
            aperture_radius_mm: 2.0,
            working_distance_mm: 20.0,
            focus_mm: 0.1,
        }),
        ..Optics::collimated(0.1)
    }
}

/// Asserts that every kernel of these models, among them the named ones, can be had in the languages of Metal and DX12.
pub(crate) fn assert_portable_kernels(gpu: &Gpu, forms: &[Form], names: &[&str]) {
    for form in forms {
        let model = &*model_on(gpu, form, &Work::new()).unwrap();
        check::adjoint(model, &check::dose(model, &check::noisy_patterns(model, 1)));
    }
    let sources: BTreeMap<_, _> = gpu.sources().into_iter().collect();
    assert_portable(&sources);
    for &name in names {
        assert!(sources.contains_key(name), "{name}");
    }
}

/// Asserts that a card has no room for a model, and says so.
pub(crate) fn assert_too_large(gpu: &Gpu, form: &Form) {
    let refused = gpu.model(form, &Work::new()).err();
    assert!(
        matches!(refused, Some(Error::Resources { .. })),
        "{refused:?}"
    );
}
