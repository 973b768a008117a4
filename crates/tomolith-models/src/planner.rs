//! Chooses the dose model of a job, and says why.
//!
//! Like the planner of a Fourier-transform library: the rows of [`MODELS`] are tried in the order of what they cost, and the first one
//! that covers the optics is taken. A job may name a family instead; what it does not cover is refused with the reason.

use super::blurred::{Spreads, widened};
use super::masked::MaskedModel;
use super::selection::{chosen, contributions, layouts, narrow};
use super::{
    DoseModel, Family, HostModel, MODELS, ModelFamily, ModelInput, OpticalScene, Purpose, Refines,
    Work,
};
use std::sync::Arc;
use tomolith_core::dose::form::Form;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::grid::{Volume, VolumeGrid};

/// What is said of a model that stays on the processor of a job with a card.
const NO_FORM: &str = "; computed on the processor: it has no form for the card";
const TOO_LARGE: &str = "; computed on the processor: it is too large for the card";

/// A dose model, and why it was chosen.
pub struct ModelPlan {
    /// The model, with its dark pixels and the factor of its doses.
    pub model: MaskedModel,
    /// One sentence for people.
    pub reason: String,
    /// Pixels of the model's fields that stay dark, because of a light's selection; empty when there is none.
    pub dark: Vec<bool>,
    /// Linear surrogate used for initial patterns and pixel selection; None when the model itself is to be used.
    pub surrogate: Option<HostModel>,
    /// Whether a card computes its doses.
    pub is_on_card: bool,
}

/// The families that are tried where a job names none, cheapest first.
fn unasked() -> impl Iterator<Item = Family> {
    MODELS.iter().filter_map(|row| Some((row.build.unasked?)()))
}

/// The family that a job names, or the cheapest that covers a scene on a grid.
///
/// # Errors
/// [`Error::Config`] with the key of a model that does not cover it.
pub fn choose(
    asked: Option<&Family>,
    scene: &OpticalScene<'_>,
    grid: &VolumeGrid,
) -> Result<Family> {
    let Some(family) = asked else {
        let covers = |family: &Family| unsupported(family.as_ref(), scene, grid).is_none();
        let none = || Error::config("model", "no model covers these optics", "other optics");
        return unasked().find(covers).ok_or_else(none);
    };
    match unsupported(family.as_ref(), scene, grid) {
        None => Ok(Arc::clone(family)),
        Some(reason) => Err(Error::config(
            format!("model.{}", family.name()),
            reason,
            family.instead(),
        )),
    }
}

/// Why a family does not cover a scene on a grid: the family's reason, or voxels that are no cubes.
fn unsupported(
    family: &dyn ModelFamily,
    scene: &OpticalScene<'_>,
    grid: &VolumeGrid,
) -> Option<&'static str> {
    let takes_any = family.capabilities().refines == Refines::Voxels;
    let not_cubes = || {
        let is_cube = (grid.height_mm - grid.pitch_mm).abs() <= 1e-9 * grid.pitch_mm;
        (!takes_any && !is_cube)
            .then_some("its voxels are cubes, and these are not as high as wide")
    };
    family.unsupported(scene, grid).or_else(not_cubes)
}

/// Why a family was taken, for people.
fn why(family: &dyn ModelFamily, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> String {
    if !unasked().any(|other| other.name() == family.name()) {
        return family.merit();
    }
    let mut reasons = Vec::new();
    for other in unasked().take_while(|other| other.name() != family.name()) {
        match unsupported(other.as_ref(), scene, grid) {
            Some(reason) if reasons.contains(&reason) => {}
            Some(reason) => reasons.push(reason),
            None => return family.despite(other.name(), scene),
        }
    }
    if reasons.is_empty() {
        family.merit()
    } else {
        reasons.join(" and ")
    }
}

/// The model that a job asks for.
///
/// With `wanted` (file order `[z, y, x]`, not 0 where something is to be printed), only pixels whose light meets such a
/// voxel become unknowns; the others stay dark, as do those that the selection of a light leaves out.
///
/// # Errors
/// As [`choose`] and [`ModelFamily::build`]; [`Error::Canceled`].
pub fn plan(
    asked: Option<&Family>,
    scene: OpticalScene<'_>,
    grid: &VolumeGrid,
    wanted: Option<&Volume<u8>>,
    work: &Work,
) -> Result<ModelPlan> {
    let family = choose(asked, &scene, grid)?;
    let input = ModelInput::new(scene, grid, work)?;
    if family.capabilities().is_stored {
        return stored(family.as_ref(), &input, wanted);
    }
    let mut lights = scene.lights.to_vec();
    let mut dark = Vec::new();
    if lights.iter().any(|light| light.selection.is_any()) {
        let all = layouts(&lights);
        dark = narrow(&mut lights, &all, None);
    }
    if let Some(wanted) = wanted {
        let (unscattered, _) = built(
            &input.lit_by(&lights),
            &|input| family.unscattered_form(input),
            &|input| family.unscattered(input),
        )?;
        let brought = contributions(unscattered.as_ref(), wanted, work)?;
        dark = narrow(
            &mut lights,
            unscattered.patterns(),
            Some(brought.as_slice()),
        );
    }
    let input = input.lit_by(&lights);
    let factor = scene.dose_factor;
    let surrogate = (family.capabilities().has_surrogate && scene.purpose == Purpose::Optimize)
        .then(|| family.unscattered(&input))
        .transpose()?
        .map(|model| Box::new(MaskedModel::new(model, dark.clone(), factor)) as HostModel);
    let (model, place) = if lights.iter().any(|light| light.point_spread.is_some()) {
        let model = family.build(&input.lit_by(&widened(&lights)))?;
        let spreads = Spreads::new(layouts(&lights), &lights);
        let model = MaskedModel::new(model, Vec::new(), factor).with_spreads(spreads);
        (model, scene.accelerator.map(|_| NO_FORM))
    } else {
        let (model, place) = built(&input, &|input| family.form(input), &|input| {
            family.build(input)
        })?;
        (MaskedModel::new(model, Vec::new(), factor), place)
    };
    let model = model.and_dark(dark.clone());
    let why = why(family.as_ref(), &input.scene, grid);
    let is_on_card = scene.accelerator.is_some() && place.is_none();
    let place = place.unwrap_or_default();
    Ok(ModelPlan {
        is_on_card,
        reason: format!("{}: {why}{place}", model.describe()),
        model,
        dark,
        surrogate,
    })
}

/// A model, where the scene says that it is computed: of its `form` there, or of what `build` builds on the processor, and why it is left there.
fn built(
    input: &ModelInput<'_>,
    form: &dyn Fn(&ModelInput<'_>) -> Result<Option<Form>>,
    build: &dyn Fn(&ModelInput<'_>) -> Result<HostModel>,
) -> Result<(HostModel, Option<&'static str>)> {
    let here = |why| build(input).map(|model| (model, why));
    let Some(accelerator) = input.scene.accelerator else {
        return here(None);
    };
    let Some(form) = form(input)? else {
        return here(Some(NO_FORM));
    };
    let is_evaluated = matches!(input.scene.purpose, Purpose::Evaluate { .. });
    match accelerator.model(&form, input.work) {
        Ok(Some(model)) => Ok((model, None)),
        Ok(None) => here(Some(TOO_LARGE)),
        // Patterns that took long to find are evaluated anyway
        Err(Error::Resources { .. } | Error::Unsupported { .. }) if is_evaluated => {
            here(Some(TOO_LARGE))
        }
        Err(error) => Err(error),
    }
}

/// A model whose pixels are those of a file. Those that miss the part, or that the selection of a light leaves out, stay dark.
fn stored(
    family: &dyn ModelFamily,
    input: &ModelInput<'_>,
    wanted: Option<&Volume<u8>>,
) -> Result<ModelPlan> {
    let model = family.build(input)?;
    let lights = input.scene.lights;
    let mut dark = Vec::new();
    if wanted.is_some() || lights.iter().any(|light| light.selection.is_any()) {
        let selections: Vec<_> = lights.iter().map(|l| l.selection.clone()).collect();
        let brought = wanted.map(|wanted| contributions(model.as_ref(), wanted, input.work));
        let brought = brought.transpose()?;
        let brought = brought.as_ref().map(HostField::as_slice);
        dark = chosen(model.patterns(), &selections, brought)
            .into_iter()
            .map(|chosen| !chosen)
            .collect();
    }
    let model = MaskedModel::new(model, dark.clone(), input.scene.dose_factor);
    Ok(ModelPlan {
        is_on_card: false,
        reason: format!("{} {}", model.describe(), family.merit()),
        model,
        dark,
        surrogate: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::monte_carlo;
    use crate::parallel;
    use crate::rays::{self, Optics};
    use crate::wave::{self, incoherent_cone};
    use tomolith_core::check;
    use tomolith_core::dose::Accelerator;
    use tomolith_core::grid::PatternGrid;
    use tomolith_core::kind::Section;
    use tomolith_optics::light::Light;
    use tomolith_optics::phase::henyey_greenstein::HenyeyGreenstein;
    use tomolith_optics::phase::{Phase, Scattering, rayleigh::Rayleigh};
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;
    use tomolith_target::Placement;
    use tomolith_target::Shape;
    use tomolith_target::phantom::Phantom;

    const VIAL: IndexMatched = IndexMatched { radius_mm: 2.0 };

    fn light() -> Light {
        let pixels = PatternGrid::full_turn(6, 0.1, 12, 16, 0.1);
        Light::new(pixels, Resin::absorbing(1.48, 0.2))
    }

    /// Optics around the vial of these tests, without lights, for an optimization.
    fn around<'a>(optics: &'a [Optics], solid: Option<&'a Arc<dyn Shape>>) -> OpticalScene<'a> {
        OpticalScene {
            vial: &VIAL,
            lights: &[],
            optics,
            solid,
            purpose: Purpose::Optimize,
            dose_factor: 1.0,
            probe_failed: None,
            accelerator: None,
        }
    }

    /// The reason, or the key of a refusal.
    fn planned(asked: Option<&Family>, scene: OpticalScene<'_>, light: Light) -> String {
        let grid = VolumeGrid::centered([6, 8, 8], 0.1);
        let lights = &[light];
        let scene = scene.lit_by(lights);
        match plan(asked, scene, &grid, None, &Work::new()) {
            Ok(plan) => plan.reason,
            Err(Error::Config { key, .. }) => key,
            Err(other) => panic!("{other}"),
        }
    }

    /// A card too small for any model.
    #[derive(Debug)]
    struct TooSmall;

    impl Accelerator for TooSmall {
        fn model(&self, _: &Form, _: &Work) -> Result<Option<HostModel>> {
            Err(Error::Resources {
                what: "entries on a card".to_owned(),
                needed_mb: 2,
                available_mb: Some(1),
                advice: "fewer pixels".to_owned(),
            })
        }
    }

    #[test]
    fn what_a_card_cannot_hold_of_an_evaluation_is_said_to_be_on_the_processor() {
        let level = [Optics::collimated(0.1)];
        let evaluated = OpticalScene {
            purpose: Purpose::Evaluate { refine: 1 },
            ..around(&level, None)
        };
        let beside_card = |scene| OpticalScene {
            accelerator: Some(&TooSmall),
            ..scene
        };
        let with = planned(None, beside_card(evaluated), light());
        assert_eq!(with, planned(None, evaluated, light()) + TOO_LARGE);
        let (grid, lights) = (VolumeGrid::centered([6, 8, 8], 0.1), [light()]);
        // So are waves, whose data say how a card would compute them
        let wave: Family = Arc::new(wave::Params::default());
        let scene = beside_card(evaluated).lit_by(&lights);
        let waves = plan(Some(&wave), scene, &grid, None, &Work::new()).unwrap();
        assert!(waves.reason.ends_with(TOO_LARGE) && waves.model.form().is_none());
        let optimized = beside_card(around(&level, None)).lit_by(&lights);
        let refused = plan(None, optimized, &grid, None, &Work::new());
        assert!(matches!(refused, Err(Error::Resources { .. })));
    }

    #[test]
    fn the_cheapest_model_is_exact_and_one_that_is_not_is_refused_by_its_key() {
        let level = [Optics::collimated(0.1)];
        let leaning = [level[0].clone().tilted(0.1)];
        let section = Section::new("target.phantom", serde_json::json!("sphere"));
        let placement = Placement {
            size_mm: Some(0.8),
            ..Placement::default()
        };
        let ball: Arc<dyn Shape> =
            Arc::new(Phantom::build(&section, &placement, "target").unwrap());
        let parallel: Option<Family> = Some(Arc::new(parallel::Params::default()));
        let rays: Option<Family> = Some(Arc::new(rays::Params::default()));
        let wave: Option<Family> = Some(Arc::new(wave::Params::default()));
        let spread: Option<Family> = Some(Arc::new(incoherent_cone::Params::default()));
        let scatter: Option<Family> = Some(Arc::new(monte_carlo::Params::default()));
        let (level, leaning) = (around(&level, None), around(&leaning, None));
        let cut = OpticalScene {
            solid: Some(&ball),
            ..level
        };
        for (asked, scene, expected) in [
            (&None, level, "collimated light"),
            (&None, leaning, ": light is not normal to the axis"),
            (&None, cut, ": the target's surface cuts voxels into cells"),
            (
                &rays,
                level,
                ": as the job names it; [model.parallel] covers",
            ),
            (&scatter, level, ": as the job names it; nothing scatters"),
            (&parallel, leaning, "model.parallel"),
            (&wave, level, "wave ("),
            (&wave, level, ": as the job names it"),
            (&wave, leaning, "model.wave"),
            (&spread, level, "incoherent_cone ("),
            (&spread, leaning, "model.incoherent_cone"),
            (&wave, cut, "model.wave"),
            (&parallel, cut, "model.parallel"),
        ] {
            let found = planned(asked.as_ref(), scene, light());
            assert!(found.contains(expected), "{found} instead of {expected}");
        }
    }

    #[test]
    fn voxels_that_are_no_cubes_are_for_parallel_light_alone() {
        let grid = VolumeGrid::centered([6, 8, 8], 0.1).divided(2, 1);
        let level = [Optics::collimated(0.1)];
        let scene = OpticalScene {
            lights: &[light()],
            ..around(&level, None)
        };
        let planned = |asked: Option<&Family>| plan(asked, scene, &grid, None, &Work::new());
        assert!(planned(None).unwrap().reason.starts_with("parallel"));
        let families: [Family; 4] = [
            Arc::new(rays::Params::default()),
            Arc::new(monte_carlo::Params::default()),
            Arc::new(wave::Params::default()),
            Arc::new(incoherent_cone::Params::default()),
        ];
        for family in families {
            let refusal = planned(Some(&family)).map(drop).unwrap_err().to_string();
            assert!(refusal.contains("not as high as wide"), "{refusal}");
        }
    }

    #[test]
    fn light_that_spreads_has_straight_light_for_starts_and_shadows() {
        let grid = VolumeGrid::centered([6, 8, 8], 0.1);
        let optics = [Optics::collimated(0.1)];
        let scene = OpticalScene {
            lights: &[light()],
            ..around(&optics, None)
        };
        let wave: Family = Arc::new(wave::Params::default());
        let spread: Family = Arc::new(incoherent_cone::Params {
            half_angle_deg: 5.0,
            ..incoherent_cone::Params::default()
        });
        for family in [wave, spread] {
            let plan = plan(Some(&family), scene, &grid, None, &Work::new());
            let straight = plan.unwrap().surrogate.unwrap();
            // One pixel meets the voxels of a chord, of the one height of its row: cones and waves meet others, too
            let mut x = straight.new_patterns().unwrap();
            let layout = &straight.patterns()[0];
            x.as_mut_slice()[layout.runs[6].offset + layout.runs[6].count as usize / 2] = 1.0;
            let dose = check::dose(&*straight, &x);
            let dose = straight.outputs()[0].volume_of(dose.as_slice());
            let lit = |z: usize| (0..64).any(|i| *dose.at(z, i / 8, i % 8) > 1e-4);
            assert_eq!((0..6).filter(|z| lit(*z)).count(), 1);
            assert_eq!(straight.patterns()[0].quantity, crate::Quantity::Energy);
        }
    }

    #[test]
    fn scattering_adds_no_unknowns_to_the_silhouette_and_goes_order_by_order_where_it_can() {
        let grid = VolumeGrid::centered([6, 8, 8], 0.15);
        let mut wanted = Volume::filled(grid.clone(), 0u8);
        wanted.values[grid.index(3, 4, 4)] = 1;
        let planned = |phase: Option<Arc<dyn Phase>>, leaning: bool, off| {
            let mut optics = [Optics::collimated(0.1)];
            let mut light = light();
            if let Some(phase) = phase {
                light.resin.attenuation_per_mm = 0.5;
                optics[0].scattering = Some(Scattering { per_mm: 0.3, phase });
            }
            if leaning {
                optics[0].motion.tilt_rad = 0.05;
            }
            let scene = OpticalScene {
                lights: &[light],
                probe_failed: off,
                ..around(&optics, None)
            };
            let plan = plan(None, scene, &grid, Some(&wanted), &Work::new()).unwrap();
            (plan.model.patterns()[0].len(), plan.reason)
        };
        let pixels = |phase, leaning| planned(phase, leaning, None);
        let rayleigh = || Some(Arc::new(Rayleigh {}) as Arc<dyn Phase>);
        let (level, _) = pixels(None, false);
        let (orders, reason) = pixels(rayleigh(), false);
        assert!(
            orders == level && reason.starts_with("successive_orders"),
            "{orders} {level} {reason}"
        );
        let (leaning, _) = pixels(None, true);
        let (orders, reason) = pixels(rayleigh(), true);
        assert!(
            orders == leaning && reason.starts_with("successive_orders (rays, 4"),
            "{orders} {leaning} {reason}"
        );
        let peaked = Some(Arc::new(HenyeyGreenstein { g: 0.8 }) as Arc<dyn Phase>);
        let (paths, reason) = pixels(peaked, true);
        assert!(
            paths == leaning && reason.starts_with("monte_carlo, 4"),
            "{paths} {leaning} {reason}"
        );
        let why = "the resin scatters and too much of the scattered light goes into a narrow forward peak";
        assert!(reason.ends_with(why), "{reason}");
        let (_, reason) = planned(rayleigh(), false, Some("a trial was too far off"));
        let why = "the resin scatters and a trial was too far off";
        assert!(
            reason.starts_with("monte_carlo, 4") && reason.ends_with(why),
            "{reason}"
        );
    }

    #[test]
    fn a_resin_that_scatters_and_differs_from_place_to_place_is_followed_by_monte_carlo_paths() {
        use tomolith_optics::absorption_map::AbsorptionMap;
        use tomolith_optics::gradient::IndexGradient;
        let mut milk = light();
        milk.resin.attenuation_per_mm = 0.5;
        let mut optics = [Optics::collimated(0.1)];
        optics[0].scattering = Some(Scattering::new(0.3, Rayleigh {}));
        let scene = around(&optics, None);
        let mapped = |total: f32| {
            let map = AbsorptionMap::new([1, 1, 2], 1.0, vec![0.2, 0.1], vec![total; 2]);
            let mut light = milk.clone();
            light.map = Some(Arc::new(map.unwrap()));
            planned(None, scene, light)
        };
        let reason = mapped(0.5);
        assert!(
            reason.ends_with("the resin scatters and the absorption changes across the plane"),
            "{reason}"
        );
        // 0.2 absorbed and 0.3 scattered per mm are more than 0.4
        assert_eq!(mapped(0.4), "resin.absorption_map.attenuation");
        let mut bent = milk.clone();
        bent.resin.gradient = Some(IndexGradient {
            quadratic_per_mm2: -0.01,
            quartic_per_mm4: 0.0,
            step_mm: 0.1,
        });
        let reason = planned(None, scene, bent);
        assert!(
            reason
                .ends_with("the resin scatters and the resin's index changes from place to place"),
            "{reason}"
        );
    }

    #[test]
    fn a_row_reads_the_family_of_its_name() {
        for row in MODELS {
            let family = (row.build.read)(&tomolith_core::check::example(row)).unwrap();
            assert_eq!(family.name(), row.name);
            if let Some(family) = row.build.unasked {
                assert_eq!(family().name(), row.name);
            }
        }
    }

    #[test]
    fn what_judges_patterns_is_sharper_than_what_optimizes_them() {
        let mut light = light();
        light.resin.attenuation_per_mm = 0.5;
        let mut milk = Optics::collimated(0.1);
        milk.motion.tilt_rad = 0.05;
        let clear = [milk.clone()];
        milk.scattering = Some(Scattering::new(0.3, Rayleigh {}));
        let milk = [milk];
        let scatter: Family = Arc::new(monte_carlo::Params::default());
        // As many rays for each of the finer voxels, and sixteen times as many paths
        for (asked, optics, sharp) in [
            (None, &clear, "rays, 16 per pixel"),
            (None, &milk, "successive_orders (rays, 16 per pixel"),
            (Some(&scatter), &milk, "monte_carlo, 64 per pixel"),
        ] {
            let plan_of = |purpose| {
                let scene = OpticalScene {
                    purpose,
                    ..around(optics, None)
                };
                planned(asked, scene, light.clone())
            };
            let [optimize, probe] = [Purpose::Optimize, Purpose::Probe].map(plan_of);
            assert!(
                optimize.contains(", 4 per pixel") && optimize == probe,
                "{optimize}"
            );
            let found = plan_of(Purpose::Evaluate { refine: 2 });
            assert!(found.starts_with(sharp), "{found}");
        }
        let redrawn = scatter.monte_carlo_paths().unwrap();
        assert_eq!((redrawn.optimizing, redrawn.evaluating), (4, 64));
    }

    #[test]
    fn a_sliver_of_the_part_is_wanted_where_voxels_are_cut() {
        // A ball that fills less than half of each of the eight voxels about the middle
        let section = Section::new("target.phantom", serde_json::json!("sphere"));
        let placement = Placement {
            size_mm: Some(0.2),
            ..Placement::default()
        };
        let ball: Arc<dyn Shape> =
            Arc::new(Phantom::build(&section, &placement, "target").unwrap());
        let grid = VolumeGrid::centered([6, 8, 8], 0.15);
        let optics = [Optics::collimated(0.1)];
        let scene = OpticalScene {
            lights: &[light()],
            ..around(&optics, Some(&ball))
        };
        let nothing = Volume::filled(grid.clone(), 0u8);
        let plan = plan(None, scene, &grid, Some(&nothing), &Work::new()).unwrap();
        let layout = &plan.model.outputs()[0];
        assert_eq!(layout.cells.as_ref().map(|cells| cells.len()), Some(8));
        // In six frames the columns and rows at ±0.05 mm, with rays at ±0.025 and ±0.075, meet the ball
        assert_eq!(plan.model.patterns()[0].len(), 6 * 4);
    }
}
