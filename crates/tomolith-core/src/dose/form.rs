//! Dose models as plain data, for a backend that computes them where its fields live.

use super::paths::PathForm;
use super::rays::RayForm;
use super::strips::StripForm;
use super::waves::WaveForm;
use super::{DoseLayout, PatternLayout};
use crate::field::Stretch;
use std::ops::Range;
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
    /// Models that act as one, each with its form.
    Joint(Vec<Form>, Arc<Joint>),
}

/// How models act as one: each has some of the joint lights and its dose q, and the joint doses are r = M q.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Of all lights.
    pub patterns: Vec<PatternLayout>,
    /// Of all doses.
    pub outputs: Vec<DoseLayout>,
    /// M, a row per output and a column per model.
    pub matrix: Vec<Vec<f32>>,
    /// Which of the joint lights each model has.
    pub lit: Vec<Range<usize>>,
    /// From the joint patterns to those of each model: pixels that both have.
    pub shown: Vec<Vec<Stretch>>,
    /// Pixels of each model.
    pub pixels: Vec<usize>,
    /// What they are together, of the number of doses and of each model in words.
    pub describe: fn(usize, &[String]) -> String,
}

impl Joint {
    /// Marks of a model's pixels, of those of the joint patterns; none of none.
    fn marks_of(&self, k: usize, marks: &[bool]) -> Vec<bool> {
        if marks.is_empty() {
            return Vec::new();
        }
        let mut taken = vec![false; self.pixels[k]];
        for part in &self.shown[k] {
            taken[part.to..][..part.count].copy_from_slice(&marks[part.from..][..part.count]);
        }
        taken
    }
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
            Form::Joint(forms, joint) => {
                let parts = forms.into_iter().enumerate();
                let masked = parts.map(|(k, form)| form.masked(&joint.marks_of(k, dark), factor));
                Form::Joint(masked.collect(), joint)
            }
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
        let marks = self.dark.len().max(dark.len());
        let is_dark = |marks: &[bool], i: usize| marks.get(i).is_some_and(|dark| *dark);
        let either = |i| is_dark(&self.dark, i) || is_dark(dark, i);
        Masked {
            dark: (0..marks).map(either).collect(),
            factor: factor * self.factor,
            ..self
        }
    }
}
