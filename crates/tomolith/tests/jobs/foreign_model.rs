//! A dose model of another crate in a job: everything that a new model needs, and a test that it is run, evaluated and refused like those of the house.
//!
//! **Model** a toy in which every pixel lights every voxel alike: q_v = mean of the pixels of all frames.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::sync::Arc;
use tomolith::dose::{
    DoseLayout, DoseModel, Facts, PatternLayout, Space, Work, ZCoupling, elements_of,
};
use tomolith::error::Result;
use tomolith::field::HostField;
use tomolith::grid::{Volume, VolumeGrid};
use tomolith::job::{Document, Job, ResolvedJob, Silent, run};
use tomolith::kind::schema_of;
use tomolith::models::{
    Capabilities, HostModel, MakeFamily, ModelFamily, ModelInput, ModelKind, OpticalScene,
};

/// Keys of `[model.uniform]`.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
struct Params {}

/// The rows that the crate adds.
static ROWS: [ModelKind; 1] = [ModelKind {
    name: "uniform",
    summary: "A toy: every pixel lights every voxel alike.",
    example: "[model.uniform]\n",
    schema: schema_of::<Params>,
    build: MakeFamily {
        read: |section| Ok(Arc::new(section.parse::<Params>()?)),
        // Jobs that name it get it, and no others
        unasked: None,
    },
}];

impl ModelFamily for Params {
    fn name(&self) -> &'static str {
        "uniform"
    }

    fn capabilities(&self) -> Capabilities {
        Capabilities {
            fills: true,
            ..Capabilities::default()
        }
    }

    fn unsupported(&self, scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> Option<&'static str> {
        scene.beyond_slices()
    }

    fn build(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        let mut offset = 0;
        let layout = |light: &tomolith::optics::light::Light| {
            let layout = light.layout(offset);
            offset += layout.len();
            layout
        };
        let output = DoseLayout::new("dose", input.grid.clone(), 0);
        Ok(Box::new(Uniform {
            patterns: input.scene.lights.iter().map(layout).collect(),
            // 1 in voxels, 0 in what pads the field
            voxels: output.field_of(&Volume::filled(input.grid.clone(), 1.0)),
            outputs: [output],
        }))
    }
}

struct Uniform {
    patterns: Vec<PatternLayout>,
    outputs: [DoseLayout; 1],
    voxels: Vec<f32>,
}

impl Uniform {
    fn weight(&self) -> f32 {
        1.0 / self.patterns.iter().map(PatternLayout::len).sum::<usize>() as f32
    }
}

impl DoseModel for Uniform {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.patterns,
            outputs: &self.outputs,
            z_coupling: ZCoupling::Full,
            is_linear: true,
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        _: &Work,
    ) -> Result<()> {
        let lit = elements_of(&self.patterns, &frames);
        let light: f32 = lit.flat_map(|(range, _)| &x.as_slice()[range]).sum();
        let voxels = dose.as_mut_slice().iter_mut().zip(&self.voxels);
        voxels.for_each(|(dose, voxel)| *dose += self.weight() * light * voxel);
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        _x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        _: &Work,
    ) -> Result<()> {
        let voxels = cotangent.as_slice().iter().zip(&self.voxels);
        let sum: f32 = voxels.map(|(c, voxel)| c * voxel).sum();
        for (range, _) in elements_of(&self.patterns, &frames) {
            grad.as_mut_slice()[range].fill(self.weight() * sum);
        }
        Ok(())
    }

    fn updates(&self) -> u64 {
        self.voxels.len() as u64
    }

    fn describe(&self) -> String {
        "uniform".to_owned()
    }
}

fn document(keys: &str) -> Document {
    let text = format!(
        r#"
        target = {{ phantom = "cylinder", size_mm = 2.0 }}
        grid = {{ pitch_mm = 0.2 }}
        resin = {{ refractive_index = 1.5, absorption_per_mm = 0.1 }}
        vial = {{ index_matched = {{ radius_mm = 4.0 }} }}
        light = [{{ pixels = [24, 12], angles = 12, projector = {{ collimated = {{ pixel_pitch_mm = 0.2 }} }} }}]
        model = {{ uniform = {{ {keys} }} }}
        stop = {{ iterations = 3 }}
        evaluate = {{ refine = 1 }}
        "#
    );
    Document::toml("job.toml", &text).unwrap()
}

#[test]
fn a_job_may_name_a_model_of_another_crate() {
    let unknown = Job::from_document(document("")).and_then(|job| ResolvedJob::new(&job));
    let unknown = unknown.err().unwrap().to_string();
    assert!(unknown.contains("unknown kind `uniform`"), "{unknown}");

    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().join("run");
    let job = Job::with_models(document(""), &ROWS).unwrap();
    let job = job.with_folder(&folder, "--output");
    run(&job, false, &mut Silent, &Work::new()).unwrap();
    let (_, dose) = tomolith::io::npy::read_volume(&folder.join("dose.npy")).unwrap();
    let lit: Vec<f32> = dose.into_iter().filter(|&q| q > 0.0).collect();
    let most = lit.iter().copied().fold(0.0, f32::max);
    assert!(!lit.is_empty() && lit.iter().all(|&q| q > 0.9999 * most));
}

#[test]
fn its_keys_are_checked_as_those_of_the_house() {
    let job = Job::with_models(document("rays = 3"), &ROWS).unwrap();
    let error = ResolvedJob::new(&job).err().unwrap().to_string();
    assert!(error.contains("model.uniform.rays"), "{error}");
}
