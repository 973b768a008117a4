//! Dose models as plain data, for a backend that computes them where its fields live.

use super::paths::PathForm;
use super::rays::RayForm;
use super::strips::StripForm;
use super::waves::WaveForm;
use std::sync::Arc;

/// A dose model as plain data.
#[derive(Clone, Debug)]
pub enum Form {
    /// Light in strips, and what is scattered out of it.
    Strips(StripForm),
    /// Rays of any direction.
    Rays(RayForm),
    /// Rays, with random paths of what is scattered.
    Paths(PathForm),
    /// Light that spreads from a focal plane.
    Waves(WaveForm),
}

impl Form {
    /// The form with dark pixels (a mark per pixel, or none at all), and all light times a factor.
    #[must_use]
    pub fn masked(self, dark: &[bool], factor: f32) -> Self {
        match self {
            Form::Strips(form) => Form::Strips(form.masked(dark, factor)),
            Form::Rays(form) => Form::Rays(form.masked(dark, factor)),
            Form::Paths(form) => Form::Paths(form.masked(dark, factor)),
            Form::Waves(form) => Form::Waves(form.masked(dark, factor)),
        }
    }
}

/// A geometry, pixels that stay dark, and a factor of all light: F(D·x) for D = 0 or the factor.
#[derive(Clone, Debug)]
pub struct Masked<G> {
    /// Shared by models that differ in the rest.
    pub geometry: Arc<G>,
    /// One per pixel, or none at all.
    pub dark: Arc<[bool]>,
    /// Of all light.
    pub factor: f32,
}

impl<G> Masked<G> {
    /// All pixels of a geometry, and all of their light.
    #[must_use]
    pub fn new(geometry: G) -> Self {
        Masked {
            geometry: Arc::new(geometry),
            dark: Arc::new([]),
            factor: 1.0,
        }
    }

    fn masked(self, dark: &[bool], factor: f32) -> Self {
        Masked {
            dark: dark.into(),
            factor: factor * self.factor,
            ..self
        }
    }
}
