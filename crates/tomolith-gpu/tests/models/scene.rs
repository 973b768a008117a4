//! What the tests of dose models share: cases, vials, lights, and what is asserted of every model.

use crate::common::SMALL;
use crate::portable::assert_portable;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::Error;
use tomolith_core::check::{self, noise};
use tomolith_core::dose::form::Form;
use tomolith_core::dose::{Accelerator, DoseLayout, DoseModel, Work, frames_of};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::{PatternGrid, VolumeGrid};
use tomolith_gpu::{Gpu, GpuField, model_on};
use tomolith_models::rays::Optics;
use tomolith_models::{HostModel, ModelFamily, ModelInput, OpticalScene, Purpose};
use tomolith_optics::light::Light;
use tomolith_optics::phase::{Phase, Scattering};
use tomolith_optics::projector::telecentric::Telecentric;
use tomolith_optics::vial::Vial;
use tomolith_optics::vial::cylinder::Cylinder;
use tomolith_optics::vial::square::Square;
use tomolith_target::Shape;

/// A model of a vial, its lights and voxels; `P`: its family.
pub(crate) struct Case<P> {
    pub(crate) name: &'static str,
    pub(crate) params: P,
    pub(crate) vial: Box<dyn Vial>,
    pub(crate) lights: Vec<Light>,
    pub(crate) optics: Vec<Optics>,
    pub(crate) grid: VolumeGrid,
    pub(crate) purpose: Purpose,
    /// What cuts voxels.
    pub(crate) solid: Option<Arc<dyn Shape>>,
    /// The smallest bindings that it fits.
    pub(crate) binding: u64,
}

impl<P> Case<P> {
    /// Of bindings of [`SMALL`] and without a solid.
    pub(crate) fn new(
        name: &'static str,
        params: P,
        vial: Box<dyn Vial>,
        lights: Vec<Light>,
        optics: Vec<Optics>,
        grid: VolumeGrid,
    ) -> Case<P> {
        Case {
            name,
            params,
            vial,
            lights,
            optics,
            grid,
            purpose: Purpose::Probe,
            solid: None,
            binding: SMALL,
        }
    }

    pub(crate) fn with<T>(&self, with: impl FnOnce(&ModelInput<'_>) -> T) -> T {
        let scene = OpticalScene {
            solid: self.solid.as_ref(),
            ..OpticalScene::new(&*self.vial, &self.lights, &self.optics, self.purpose)
        };
        let work = Work::new();
        with(&ModelInput::new(scene, &self.grid, &work).unwrap())
    }

    /// The model of the processor.
    pub(crate) fn host_of(&self, family: &dyn ModelFamily) -> HostModel {
        self.with(|input| family.build(input).unwrap())
    }

    pub(crate) fn form_of(&self, family: &dyn ModelFamily) -> Option<Form> {
        self.with(|input| family.form(input).unwrap())
    }

    /// Pixels that stay dark in the tests of masked models.
    pub(crate) fn some_dark(&self) -> Vec<bool> {
        let pixels = self.lights.iter().map(|light| light.layout(0).len()).sum();
        some_dark(pixels)
    }
}

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

/// Noise on the voxels of doses, 0 in what fills up their rows.
pub(crate) fn noise_of(outputs: &[DoseLayout], seed: u64) -> HostField {
    let mut values = noise(seed, outputs.iter().map(DoseLayout::len).sum());
    for layout in outputs {
        let nz = layout.grid.shape[0];
        let rows = values[layout.offset..][..layout.voxels()].chunks_mut(layout.row);
        rows.for_each(|row| row[nz..].fill(0.0));
    }
    HostField::from_slice(&values)
}

pub(crate) fn assert_near(found: &[f32], expected: &[f32], tolerance: f32, what: &str) {
    let most = expected.iter().fold(0.0f32, |m, v| m.max(v.abs()));
    assert!(most > 0.0 && found.len() == expected.len(), "{what}");
    let worst = (found.iter().zip(expected).enumerate())
        .max_by(|a, b| (a.1.0 - a.1.1).abs().total_cmp(&(b.1.0 - b.1.1).abs()))
        .unwrap();
    let (i, (found, expected)) = worst;
    assert!(
        (found - expected).abs() <= tolerance * most,
        "{what}: element {i} is {found} instead of {expected}, the largest {most}"
    );
}

/// A light whose pixels are not all active: columns end early.
pub(crate) fn with_dark_ends(mut light: Light) -> Light {
    let [frames, rows, columns] = light.pixels.shape();
    let run = |i: usize| ((i % 3) as u32, (rows - 3 - i % 4) as u32);
    light.active = Some((0..frames * columns).map(run).collect());
    light
}

/// Collimated light that the resin scatters.
pub(crate) fn scattering(phase: impl Phase + 'static, per_mm: f64) -> Optics {
    Optics {
        scattering: Some(Scattering::new(per_mm, phase)),
        ..Optics::collimated(0.1)
    }
}

/// Pixels that stay dark in the tests of masked models.
pub(crate) fn some_dark(pixels: usize) -> Vec<bool> {
    (0..pixels).map(|i| i % 11 == 3).collect()
}

pub(crate) fn pullback(
    model: &dyn DoseModel<Field = HostField>,
    x: &HostField,
    c: &HostField,
) -> HostField {
    let mut grad = model.new_patterns().unwrap();
    model.pullback(x, c, &mut grad, &Work::new()).unwrap();
    grad
}

/// Asserts that a dose, one with that of some frames added, and a pullback on a card are those of the processor, as `alike` finds them.
pub(crate) fn assert_doses_and_pullbacks(
    [host, card]: [&dyn DoseModel<Field = HostField>; 2],
    x: &HostField,
    frames: Range<usize>,
    alike: impl Fn(&[f32], &[f32]),
) {
    let [expected, found] = [host, card].map(|model| check::dose(model, x));
    alike(found.as_slice(), expected.as_slice());
    let before = 0.1 * expected.max_abs();
    let [expected, found] = [host, card].map(|model| {
        let (mut dose, work) = (model.new_dose().unwrap(), Work::new());
        dose.fill(before);
        model.dose_of(frames.clone(), x, &mut dose, &work).unwrap();
        dose
    });
    alike(found.as_slice(), expected.as_slice());
    let cotangent = noise_of(host.outputs(), 2);
    let [expected, found] = [host, card].map(|model| pullback(model, x, &cotangent));
    alike(found.as_slice(), expected.as_slice());
}

/// Asserts that dose and adjoint are one matrix to `tolerance`, whose columns of dark pixels are 0; that a call again has the same bits; and
/// that frames one by one add up. The patterns that it took, and their dose.
pub(crate) fn assert_one_matrix(
    model: &dyn DoseModel<Field = GpuField>,
    dark: &[bool],
    tolerance: f64,
    what: &str,
) -> [GpuField; 2] {
    let x = check::noisy_patterns(model, 3);
    let mut c = model.new_dose().unwrap();
    c.copy_from_host(noise_of(model.outputs(), 4).as_slice());
    let (dose, grad) = (check::dose(model, &x), check::adjoint(model, &c));
    let (left, right) = (dose.dot(&c), grad.dot(&x));
    let size = dose.norm() * c.norm();
    assert!(
        (left - right).abs() < tolerance * size,
        "{what}: {left} {right} of {size}"
    );
    let marks = dark.iter().zip(grad.to_host());
    assert!(marks.into_iter().all(|(&dark, grad)| !dark || grad == 0.0));
    assert_eq!(check::dose(model, &x).to_host(), dose.to_host(), "{what}");
    assert_eq!(
        check::adjoint(model, &c).to_host(),
        grad.to_host(),
        "{what}"
    );
    let (mut sum, mut alone) = (model.new_dose().unwrap(), grad.zeros_like());
    let work = Work::new();
    for frame in 0..frames_of(model.patterns()) {
        let frame = frame..frame + 1;
        model.dose_of(frame.clone(), &x, &mut sum, &work).unwrap();
        model.pullback_of(frame, &x, &c, &mut alone, &work).unwrap();
    }
    assert_near(&sum.to_host(), &dose.to_host(), 1e-6, what);
    assert_eq!(alone.to_host(), grad.to_host(), "{what}");
    [x, dose]
}
