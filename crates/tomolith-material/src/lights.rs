//! The lights of a print, as one dose model sees them: their patterns one after another, a dose per network.

use crate::Model;
use crate::photopolymer::Photopolymer;
use crate::print::must_fit;
use crate::schedule::Schedule;
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::{DoseLayout, Facts, PatternLayout, ZCoupling, frames_of};
use tomolith_core::error::Result;
use tomolith_core::field::HostField;

pub(crate) struct Lights {
    pub(crate) optics: Vec<Arc<Model>>,
    pub(crate) schedule: Schedule,
    pub(crate) patterns: Vec<PatternLayout>,
    pub(crate) outputs: Vec<DoseLayout>,
    /// Elements of each light in the pattern field.
    pub(crate) ranges: Vec<Range<usize>>,
}

impl Lights {
    /// Refuses schedule, mixing matrix, lights and voxels that do not fit each other.
    pub(crate) fn new(
        optics: Vec<Box<Model>>,
        schedule: Schedule,
        material: &Photopolymer,
    ) -> Result<Self> {
        let models: Vec<&Model> = optics.iter().map(AsRef::as_ref).collect();
        must_fit(material, &schedule, &models)?;
        let (mut patterns, mut ranges, mut offset) = (Vec::new(), Vec::new(), 0);
        for model in &optics {
            let len: usize = model.patterns().iter().map(PatternLayout::len).sum();
            for layout in model.patterns() {
                let mut layout = layout.clone();
                layout.offset += offset;
                layout.runs.iter_mut().for_each(|run| run.offset += offset);
                patterns.push(layout);
            }
            ranges.push(offset..offset + len);
            offset += len;
        }
        let layout = material.domain().layout();
        let species = material.species();
        let output = |(s, name): (usize, &String)| {
            DoseLayout::new(name, layout.grid.clone(), s * layout.len())
        };
        Ok(Lights {
            outputs: species.iter().enumerate().map(output).collect(),
            optics: optics.into_iter().map(Arc::from).collect(),
            schedule,
            patterns,
            ranges,
        })
    }

    /// A print is not linear in its patterns, and its voxels may reach each other.
    pub(crate) fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.patterns,
            outputs: &self.outputs,
            z_coupling: ZCoupling::Full,
            is_linear: false,
        }
    }

    pub(crate) fn light(&self, light: usize) -> &Model {
        self.optics[light].as_ref()
    }

    /// The patterns of a light, as a field of its own dose model.
    pub(crate) fn of_light(&self, light: usize, x: &HostField) -> HostField {
        HostField::from_slice(&x.as_slice()[self.ranges[light].clone()])
    }

    /// Which of the frames of each light are among these of all lights.
    pub(crate) fn own_frames(&self, frames: &Range<usize>) -> Vec<Range<usize>> {
        let mut first = 0;
        let mut local_frames = |model: &Model| {
            let end = first + frames_of(model.patterns());
            let local =
                frames.start.clamp(first, end) - first..frames.end.clamp(first, end) - first;
            first = end;
            local
        };
        self.optics
            .iter()
            .map(|model| local_frames(&**model))
            .collect()
    }
}
