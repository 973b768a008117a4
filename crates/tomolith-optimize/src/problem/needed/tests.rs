//! Searches that leave voxels out, beside those that do not.

use super::*;
use crate::checkpoint::Params;
use crate::lbfgs::{self, Lbfgs};
use crate::{Checkpoints, Limits, Outcome, StepReport, Stop, run};
use serde_json::json;
use std::ops::{ControlFlow, Range};
use std::sync::Arc;
use tomolith_core::check;
use tomolith_core::dose::{DoseModel, Facts, Space};
use tomolith_core::field::HostField;
use tomolith_core::grid::{PatternGrid, Volume, VolumeGrid};
use tomolith_core::kind::Section;
use tomolith_core::response::Identity;
use tomolith_core::target::{Target, label_voxels};
use tomolith_models::rays::Optics;
use tomolith_models::{HostModel, ModelInput, OpticalScene, Purpose, parallel};
use tomolith_objective::{OBJECTIVES, Objective, ObjectiveInput};
use tomolith_optics::light::Light;
use tomolith_optics::resin::Resin;
use tomolith_optics::vial::index_matched::IndexMatched;

/// A model with regions, or the same without.
struct Watched {
    model: HostModel,
    has_regions: bool,
}

impl Watched {
    fn new(has_regions: bool) -> Self {
        let pixels = PatternGrid::full_turn(44, 0.0, 50, 50, 0.1);
        let lights = [Light::new(pixels, Resin::absorbing(1.5, 0.1))];
        let optics = [Optics::collimated(0.1)];
        let vial = IndexMatched { radius_mm: 3.0 };
        let scene = OpticalScene::new(&vial, &lights, &optics, Purpose::Optimize);
        let (grid, work) = (VolumeGrid::centered([48, 40, 40], 0.1), Work::new());
        let input = ModelInput::new(scene, &grid, &work).unwrap();
        let family = parallel::KIND.build.unasked.unwrap()();
        Watched {
            model: family.build(&input).unwrap(),
            has_regions,
        }
    }

    /// A threshold loss of a thin cylinder that stands off the axis.
    fn objective(&self) -> Box<dyn Objective<HostField>> {
        let layout = &self.model.outputs()[0];
        let is_part = |[x, y, z]: [f64; 3]| (x - 0.6).hypot(y) < 0.4 && z.abs() < 1.0;
        let target = Target {
            name: "pin".to_owned(),
            inside: Volume::from_fn(layout.grid.clone(), |at| f32::from(is_part(at))),
            gray: false,
        };
        let labels = label_voxels(&target, |[x, y, _]| x.hypot(y) < 1.9);
        let input = ObjectiveInput {
            layout,
            labels: &labels,
            target: &target,
            response: Arc::new(Identity),
        };
        let section = Section::new("objective", json!({ "threshold": {} }));
        section.read(OBJECTIVES).unwrap().make(&input).unwrap()
    }

    /// Runs to an iteration with what watches each step; its patterns.
    fn go(
        &self,
        until: usize,
        checkpoints: Option<&mut Checkpoints>,
        watch: &mut dyn FnMut(&StepReport<HostField>),
    ) -> (HostField, Outcome) {
        let (objective, flag) = (self.objective(), Work::new());
        let limits = Limits { min: 0.0, max: 0.2 };
        let mut problem = Problem::new(self, &*objective, &[limits], &flag).unwrap();
        let mut x = check::even_patterns(self, 0.02);
        let mut see = |report: &StepReport<HostField>| {
            watch(report);
            ControlFlow::Continue(())
        };
        let method = &mut Lbfgs::new(lbfgs::Params::default()).unwrap();
        let stop = Stop::after(until);
        let observers: &mut [&mut dyn crate::Observer<HostField>] = &mut [&mut see];
        let outcome = run(&mut problem, method, &mut x, &stop, checkpoints, observers);
        (x, outcome.unwrap())
    }
}

impl DoseModel for Watched {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        self.model.facts()
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        self.model.new_field(space)
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        self.model.dose_of(frames, x, dose, work)
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        self.model.pullback_of(frames, x, cotangent, grad, work)
    }

    fn regions(&self) -> Option<&dyn Regions<HostField>> {
        self.model.regions().filter(|_| self.has_regions)
    }

    fn updates(&self) -> u64 {
        self.model.updates()
    }

    fn describe(&self) -> String {
        self.model.describe()
    }
}

#[test]
fn a_run_that_leaves_voxels_out_takes_the_same_steps() {
    let [some, all] = [true, false].map(Watched::new);
    let mut left_out = 0;
    let (x, outcome) = some.go(14, None, &mut |report| {
        let whole = report.dose.whole().unwrap();
        let expected = check::dose(&some, report.patterns);
        let off = check::largest_difference(whole.as_slice(), expected.as_slice());
        assert!(off < 1e-5, "{off}");
        let (known, from) = report.dose.known();
        let each = known.as_slice().iter().zip(whole.as_slice());
        let unknown = each.filter(|(known, whole)| known != whole);
        for (known, whole) in unknown {
            assert!(*known < from && *whole < from, "{known} {whole} {from}");
            left_out += 1;
        }
    });
    let (same, expected) = all.go(14, None, &mut |report| {
        assert_eq!(report.dose.known().1, f32::NEG_INFINITY);
    });
    assert!(left_out > 100_000, "{left_out}");
    assert_eq!(outcome.history.len(), expected.history.len());
    for (row, expected) in outcome.history.iter().zip(&expected.history) {
        let off = (row.loss / expected.loss - 1.0).abs();
        assert!(off < 1e-4, "{} {}", row.loss, expected.loss);
    }
    assert!(check::largest_difference(x.as_slice(), same.as_slice()) < 1e-3);
}

#[test]
fn a_resumed_run_has_the_bits_of_one_that_left_the_same_voxels_out() {
    let model = Watched::new(true);
    let (x, outcome) = model.go(14, None, &mut |_| {});
    let folder = tempfile::tempdir().unwrap();
    let params = Params {
        every_s: Some(1e-9),
        ..Params::default()
    };
    let checkpoints = || Checkpoints::new(folder.path(), 7, &params).unwrap();
    model.go(6, Some(&mut checkpoints()), &mut |_| {});
    let mut resumed = checkpoints();
    let (again, after) = model.go(14, Some(&mut resumed), &mut |_| {});
    assert_eq!(again.as_slice(), x.as_slice());
    assert_eq!(after.loss, outcome.loss);
}
