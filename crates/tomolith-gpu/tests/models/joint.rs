//! Models that act as one: lights that drive species, and scenarios.

use crate::common::{SMALL, gpu};
use crate::portable::assert_portable;
use crate::scene::{
    Case, assert_doses_and_pullbacks, assert_near, assert_one_matrix, glass, pixels, some_dark,
    with_dark_ends,
};
use std::collections::BTreeMap;
use std::sync::Arc;
use tomolith_core::check;
use tomolith_core::dose::{Accelerator, DoseModel, Work};
use tomolith_core::grid::VolumeGrid;
use tomolith_gpu::{Gpu, model_on};
use tomolith_models::masked::MaskedModel;
use tomolith_models::rays::Optics;
use tomolith_models::{Family, HostModel, parallel, scenarios, spectral};
use tomolith_optics::light::Light;
use tomolith_optics::resin::Resin;

fn case(frames: usize, absorption: f64, has_dark_ends: bool) -> Case<Family> {
    let light = Light::new(pixels(frames), Resin::absorbing(1.4849, absorption));
    let light = if has_dark_ends {
        with_dark_ends(light)
    } else {
        light
    };
    let family: Family = Arc::new(parallel::Params::default());
    let grid = VolumeGrid::centered([18, 27, 28], 0.1);
    let optics = vec![Optics::collimated(0.1)];
    Case::new("one of several", family, glass(), vec![light], optics, grid)
}

/// The same case on the processor and on a card.
fn both(gpu: &Gpu, case: &Case<Family>) -> [HostModel; 2] {
    let form = case.form_of(&*case.params).unwrap();
    let card = gpu.model(&form, &Work::new()).unwrap().unwrap();
    [case.host_of(&*case.params), card]
}

/// Several models that act as one, on the processor; and what acts as one on the card.
fn joined(
    gpu: &Gpu,
    cases: &[Case<Family>],
    join: &dyn Fn(Vec<HostModel>) -> HostModel,
) -> [MaskedModel; 2] {
    let pairs = cases.iter().map(|case| both(gpu, case).into());
    let (hosts, cards): (Vec<_>, Vec<_>) = pairs.unzip();
    [hosts, cards].map(|models| {
        let joint = join(models);
        let dark = some_dark(joint.new_patterns().unwrap().as_slice().len());
        MaskedModel::new(joint, dark, 0.7)
    })
}

#[test]
fn species_and_scenarios_on_a_card_are_those_of_the_processor() {
    let Some(gpu) = gpu(SMALL) else { return };
    // Two lights of one species each; both; against each other; and what no light drives
    let rows = [[1.0, 0.25], [0.0, 2.0], [1.5, -1.0], [0.0, 0.0]];
    let species: Vec<_> = rows.map(|row| (String::new(), row.to_vec())).into();
    let lights = [case(8, 0.2, true), case(5, 0.5, false)];
    let mixed = |models| Box::new(spectral::mixed(models, &species).unwrap()) as HostModel;
    // One with the pixels of the job, one in which the ends of columns light nothing
    let others = [case(8, 0.2, false), case(8, 0.4, false), case(8, 0.3, true)];
    let scenarios = |mut models: Vec<HostModel>| {
        let first = models.remove(0).into();
        Box::new(scenarios::joined(first, models).unwrap()) as HostModel
    };
    let species = joined(&gpu, &lights, &mixed);
    let scenarios = joined(&gpu, &others, &scenarios);
    for ([host, doses_there], what) in [(species, "species"), (scenarios, "scenarios")] {
        let form = doses_there.form().unwrap();
        let card = gpu.model(&form, &Work::new()).unwrap().unwrap();
        let x = check::noisy_patterns(&host, 7);
        // Frames of both lights
        assert_doses_and_pullbacks([&host, &*card], &x, 3..10, |found, expected| {
            assert_near(found, expected, 3e-6, what);
        });
        let model = model_on(&gpu, &form, &Work::new()).unwrap();
        let dark = some_dark(x.as_slice().len());
        assert_one_matrix(&*model, &dark, 1e-6, what);
        assert!(model.outputs().len() > 2 && model.is_linear());
    }
    let sources: BTreeMap<_, _> = gpu.sources().into_iter().collect();
    assert_portable(&sources);
    assert!(sources.contains_key("add stretches") && sources.contains_key("set stretches"));
}
