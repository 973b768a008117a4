//! Chooses the dose model of a job, and says why.
//!
//! Like the planner of a Fourier-transform library: the cheapest model that is exact for the optics at hand. [`Parallel`]
//! where light is collimated, normal to the axis, and the vial the same at all heights; else [`Rays`]. Where the resin scatters,
//! [`orders`] in light of any direction where resin and vial are the same at all heights and no body is in the way, unless a trial was far off
//! ([`Setup::orders_off`]), else [`scatter`]. A job may ask for one
//! of them, or for a stored matrix; what a model does not cover is refused with the reason.

use super::dimmed::Dimmed;
use super::matrix::{self, MatrixModel};
use super::parallel::{self, Light, Parallel};
use super::rays::kept::Walks;
use super::rays::solid::Solid;
use super::rays::{self, Optics, Rays};
use super::selection::{chosen, contributions, layouts, narrow};
use super::wave::spread::{self, Spread};
use super::wave::{self, Wave};
use super::{Choice, DoseModel, Quantity, Run, orders, scatter};
use std::borrow::Cow;
use std::sync::Arc;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_io::csr::Csr;
use tomolith_optics::vial::Vial;
use tomolith_target::Shape;

/// A dose model, and why it was chosen.
pub struct Plan {
    /// The model.
    pub model: Box<dyn DoseModel<Field = HostField>>,
    /// One sentence for people.
    pub reason: String,
    /// Pixels of the model's fields that stay dark, because of a light's selection; empty when there is none.
    pub dark: Vec<bool>,
    /// Linear surrogate used for initial patterns and pixel selection; None when the model itself is to be used.
    pub straight: Option<Box<dyn DoseModel<Field = HostField>>>,
}

/// What light passes from the projectors to the resin.
#[derive(Clone, Copy)]
pub struct Setup<'a> {
    /// The vial.
    pub vial: &'a dyn Vial,
    /// What stands between each light's pixels and the vial.
    pub optics: &'a [Optics],
    /// The shape whose surface cuts voxels into cells; None: whole voxels.
    pub solid: Option<&'a Arc<dyn Shape>>,
    /// Whether a dose is asked for again and again, as in an optimisation: walks of rays are then kept where they are few.
    pub asked_often: bool,
    /// What every dose is multiplied by: 1, or the factor of another program's doses.
    pub dose_factor: f64,
    /// Why [`orders`] is not to be taken though it covers these optics: what a trial found; None: it may.
    pub orders_off: Option<&'static str>,
}

/// Why whole voxels are not enough.
const CUT: &str = "the target's surface cuts voxels into cells";

/// How light becomes dose: what was asked for, or the cheapest that is exact.
enum Way<'a> {
    Stored(&'a matrix::Params),
    Optical(Optical<'a>),
}

/// Of the models that follow light through optics.
enum Optical<'a> {
    Parallel,
    Rays(Cow<'a, rays::Params>),
    Scatter(Cow<'a, scatter::Params>),
    Orders(Cow<'a, orders::Params>),
    Wave(&'a wave::Params),
    Spread(&'a spread::Params),
}

impl Setup<'_> {
    /// The walks of rays that are kept where they are few ([`Rays::keeping`]); None where none ever are.
    pub fn walks(&self, choice: &Choice, lights: &[Light], grid: &VolumeGrid) -> Option<Walks> {
        if !self.asked_often {
            return None;
        }
        match self.way(choice, lights, grid).ok()? {
            Way::Optical(Optical::Rays(params)) => {
                let optics = (self.vial, lights, self.optics);
                Some(Rays::walks(optics, &params, (grid, self.solid.is_some())))
            }
            Way::Optical(Optical::Orders(_)) => self.beyond_straight(lights).map(|_| Walks::SINGLE),
            _ => None,
        }
    }

    /// Whether the kernel runs along the rows of pixels where these are fewer than slices of voxels.
    pub fn runs_along_rows(&self, choice: &Choice, lights: &[Light], grid: &VolumeGrid) -> bool {
        let way = self.way(choice, lights, grid);
        matches!(way, Ok(Way::Optical(Optical::Parallel)))
    }

    /// Refuses a model that does not cover these optics; to be called before any work. Returns what is to be said of one that does.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of the model, or of numbers that contradict each other.
    pub fn must_be_covered(
        &self,
        choice: &Choice,
        lights: &[Light],
        grid: &VolumeGrid,
    ) -> Result<Vec<String>> {
        match self.way(choice, lights, grid)? {
            Way::Optical(Optical::Wave(params)) => wave::must_fit(lights, params, grid),
            Way::Optical(Optical::Spread(_)) => spread::must_fit(lights, grid).map(|()| Vec::new()),
            _ => Ok(Vec::new()),
        }
    }

    /// Memory that frames at work take beside patterns and doses, MB: where each is computed at many depths; 0 where that is little.
    ///
    /// # Errors
    /// As [`plan`].
    pub fn working_mb(&self, choice: &Choice, lights: &[Light], grid: &VolumeGrid) -> Result<f64> {
        let bytes = match self.way(choice, lights, grid)? {
            Way::Optical(Optical::Wave(params)) => {
                wave::working_bytes(self.vial, lights, params, grid, self.asked_often)?
            }
            Way::Optical(Optical::Spread(params)) => {
                spread::working_bytes(self.vial, lights, params, grid)?
            }
            _ => 0,
        };
        Ok(bytes as f64 / 1e6)
    }

    fn way<'a>(&self, choice: &'a Choice, lights: &[Light], grid: &VolumeGrid) -> Result<Way<'a>> {
        let refused =
            |key: &str, found: &str, accepted: &str| Err(Error::config(key, found, accepted));
        let other = "another model, or no [model] for the cheapest that is exact";
        Ok(Way::Optical(match (choice, self.beyond_parallel(lights)) {
            (Choice::Matrix(_), _) if self.solid.is_some() => {
                return refused("model.matrix", "a stored matrix knows whole voxels", other);
            }
            (Choice::Matrix(params), _) => return Ok(Way::Stored(params)),
            (Choice::Parallel(_), Some(reason)) => return refused("model.parallel", reason, other),
            (Choice::Rays(_), _) if self.scatters() => {
                let accepted = "[model.scatter], or no [model]";
                return refused("model.rays", self.what_scatters(), accepted);
            }
            (Choice::Rays(params), _) => Optical::Rays(Cow::Borrowed(params)),
            (Choice::Scatter(params), _) => Optical::Scatter(Cow::Borrowed(params)),
            (Choice::Orders(params), _) => match self.beyond_orders(lights, grid) {
                Some(reason) => return refused("model.orders", reason, other),
                None => Optical::Orders(Cow::Borrowed(params)),
            },
            (Choice::Wave(params), _) => match self.beyond_waves(lights) {
                Some(reason) => return refused("model.wave", reason, other),
                None => Optical::Wave(params),
            },
            (Choice::Spread(params), _) => match self.beyond_waves(lights) {
                Some(reason) => return refused("model.spread", reason, other),
                None => Optical::Spread(params),
            },
            (Choice::Cheapest, _) if self.scatters() => {
                if self.beyond_orders(lights, grid).is_none() {
                    Optical::Orders(Cow::default())
                } else {
                    Optical::Scatter(Cow::default())
                }
            }
            (Choice::Cheapest, Some(_)) => Optical::Rays(Cow::default()),
            (Choice::Parallel(_) | Choice::Cheapest, None) => Optical::Parallel,
        }))
    }

    /// Why this way was taken, for people.
    fn why(
        &self,
        way: &Optical<'_>,
        choice: &Choice,
        lights: &[Light],
        grid: &VolumeGrid,
    ) -> String {
        match (choice, way, self.beyond_parallel(lights)) {
            (Choice::Rays(_), _, None) => {
                "as asked; [model.parallel] covers these optics too and is faster".into()
            }
            (Choice::Scatter(_), _, None) => "as asked; nothing scatters".into(),
            (Choice::Wave(_) | Choice::Spread(_), _, _) => "as asked".into(),
            (_, Optical::Scatter(_), Some(reason)) => match self.beyond_orders(lights, grid) {
                Some(other) => format!("{reason} and {other}"),
                None => format!("{reason}; as asked, [model.orders] covers it without noise"),
            },
            (_, _, Some(reason)) => reason.into(),
            (_, _, None) => {
                "collimated light and a vial that does not change along z, so one slice's geometry serves all heights".into()
            }
        }
    }

    /// Whether light is scattered anywhere.
    #[must_use]
    pub fn scatters(&self) -> bool {
        self.optics.iter().any(Optics::scatters)
    }

    fn what_scatters(&self) -> &'static str {
        if self.optics.iter().any(|o| o.scattering.is_some()) {
            "the resin scatters"
        } else {
            "a diffuse body scatters light"
        }
    }

    /// Why [`Parallel`] does not cover it; None when it does.
    #[must_use]
    pub fn beyond_parallel(&self, lights: &[Light]) -> Option<&'static str> {
        if self.scatters() {
            Some(self.what_scatters())
        } else {
            self.beyond_straight(lights)
        }
    }

    /// Why [`orders`] does not cover it with these lights on this grid; None when it does.
    #[must_use]
    pub fn beyond_orders(&self, lights: &[Light], grid: &VolumeGrid) -> Option<&'static str> {
        match self.solid {
            Some(_) => Some(CUT),
            None => orders::beyond(self.vial, lights, self.optics, grid).or(self.orders_off),
        }
    }

    /// Why [`Wave`] does not cover it; None when it does.
    #[must_use]
    pub fn beyond_waves(&self, lights: &[Light]) -> Option<&'static str> {
        self.beyond_parallel(lights)
            .or_else(|| wave::beyond(self.vial, lights))
    }

    /// Why [`Parallel`] does not cover its straight light.
    fn beyond_straight(&self, lights: &[Light]) -> Option<&'static str> {
        if !self.vial.is_invariant() {
            Some("the vial changes along z")
        } else if let Some(reason) = self.optics.iter().find_map(Optics::beyond_level) {
            Some(reason)
        } else if self.optics.iter().any(|o| !o.obstacles.is_empty()) {
            Some("bodies stand in the light")
        } else if self.solid.is_some() {
            Some(CUT)
        } else {
            lights
                .iter()
                .find_map(|light| parallel::beyond(light, self.vial))
        }
    }
}

/// The model that a job asks for.
///
/// With `wanted` (file order `[z, y, x]`, not 0 where something is to be printed), only pixels whose light meets such a
/// voxel become unknowns; the others stay dark, as do those that the selection of a light leaves out.
///
/// # Errors
/// As [`Parallel::new`], [`Rays::new`], [`orders::model`], [`Solid::new`], [`Csr::read`] and [`MatrixModel::new`]; [`Error::Config`] for
/// optics that the model asked for does not cover; [`Error::Cancelled`].
pub fn plan(
    choice: &Choice,
    setup: Setup<'_>,
    mut lights: Vec<Light>,
    grid: VolumeGrid,
    wanted: Option<&Volume<u8>>,
    run: &Run,
) -> Result<Plan> {
    let way = match setup.way(choice, &lights, &grid)? {
        Way::Stored(params) => {
            return stored(params, setup.dose_factor, &lights, grid, wanted, run);
        }
        Way::Optical(way) => way,
    };
    let solid = setup.solid.map(|shape| Solid::new(shape, &grid));
    let solid = solid.transpose()?.map(Arc::new);
    let mut dark = Vec::new();
    if lights.iter().any(|light| light.selection.is_any()) {
        let all = layouts(&lights);
        dark = narrow(&mut lights, &all, None);
    }
    if let Some(wanted) = wanted {
        let straight = straight(
            &way,
            setup,
            lights.clone(),
            grid.clone(),
            solid.as_ref(),
            run,
        )?;
        let brought = contributions(straight.as_ref(), wanted, run)?;
        dark = narrow(&mut lights, straight.patterns(), Some(brought.as_slice()));
    }
    let why = setup.why(&way, choice, &lights, &grid);
    let beside = match way {
        Optical::Wave(_) | Optical::Spread(_) if setup.asked_often => {
            let (lights, grid) = (lights.clone(), grid.clone());
            let model = straight(&way, setup, lights, grid, solid.as_ref(), run)?;
            Some(dimmed(model, &dark, setup.dose_factor))
        }
        _ => None,
    };
    let model = optical(&way, setup, lights, grid, solid.as_ref(), run)?;
    let model = dimmed(model, &dark, setup.dose_factor);
    Ok(Plan {
        reason: format!("{}: {why}", model.describe()),
        model,
        dark,
        straight: beside,
    })
}

/// A model some of whose pixels stay dark, and all of whose doses have a factor, if there are such.
fn dimmed(
    mut model: Box<dyn DoseModel<Field = HostField>>,
    dark: &[bool],
    factor: f64,
) -> Box<dyn DoseModel<Field = HostField>> {
    if factor != 1.0 {
        // A factor of energies: of amplitudes its root
        let is_amplitude = model
            .patterns()
            .iter()
            .any(|p| p.quantity == Quantity::Amplitude);
        let factor = if is_amplitude { factor.sqrt() } else { factor };
        model = Box::new(Dimmed::by(model, factor as f32));
    }
    if !dark.is_empty() {
        model = Box::new(Dimmed::new(model, dark));
    }
    model
}

/// The straight light of a model: which pixels meet a voxel. Scattered light, and waves to some extent, meet all of them.
fn straight(
    way: &Optical<'_>,
    setup: Setup<'_>,
    lights: Vec<Light>,
    grid: VolumeGrid,
    solid: Option<&Arc<Solid>>,
    run: &Run,
) -> Result<Box<dyn DoseModel<Field = HostField>>> {
    match way {
        Optical::Wave(_) | Optical::Spread(_) => {
            Ok(Box::new(Parallel::under(setup.vial, lights, grid, run)?))
        }
        Optical::Orders(params) => {
            orders::unscattered(setup.vial, lights, setup.optics, params, grid)
        }
        Optical::Scatter(params) => {
            let model = scatter::straight(setup.vial, &lights, setup.optics, params, grid)?;
            Ok(boxed(model, solid))
        }
        // Asked once: nothing to keep
        Optical::Rays(params) => {
            let model = Rays::new(setup.vial, lights, setup.optics, params, grid)?;
            Ok(boxed(model, solid))
        }
        Optical::Parallel => optical(way, setup, lights, grid, solid, run),
    }
}

/// A stored matrix as a model. All its pixels are unknowns, but those that the selection of a light leaves out.
fn stored(
    matrix: &matrix::Params,
    factor: f64,
    lights: &[Light],
    grid: VolumeGrid,
    wanted: Option<&Volume<u8>>,
    run: &Run,
) -> Result<Plan> {
    let pixels = lights.iter().map(|light| light.pixels.clone()).collect();
    let model = MatrixModel::new(&Csr::read(&matrix.file)?, pixels, grid)?;
    let mut dark = Vec::new();
    if lights.iter().any(|light| light.selection.is_any()) {
        let selections: Vec<_> = lights.iter().map(|l| l.selection.clone()).collect();
        let brought = wanted.map(|wanted| contributions(&model, wanted, run));
        let brought = brought.transpose()?;
        let brought = brought.as_ref().map(HostField::as_slice);
        let patterns = DoseModel::patterns(&model);
        dark = chosen(patterns, &selections, brought)
            .into_iter()
            .map(|chosen| !chosen)
            .collect();
    }
    let model = dimmed(Box::new(model), &dark, factor);
    Ok(Plan {
        reason: format!("{} from {}", model.describe(), matrix.file.display()),
        model,
        dark,
        straight: None,
    })
}

/// Rays, with cells where a surface cuts voxels.
fn boxed(model: Rays, solid: Option<&Arc<Solid>>) -> Box<dyn DoseModel<Field = HostField>> {
    match solid {
        Some(solid) => Box::new(model.with_cells(Arc::clone(solid))),
        None => Box::new(model),
    }
}

/// A model of the optics, not a stored one.
fn optical(
    way: &Optical<'_>,
    setup: Setup<'_>,
    lights: Vec<Light>,
    grid: VolumeGrid,
    solid: Option<&Arc<Solid>>,
    run: &Run,
) -> Result<Box<dyn DoseModel<Field = HostField>>> {
    let rays = |params: &rays::Params| {
        let (vial, optics) = (setup.vial, setup.optics);
        Rays::new(vial, lights.clone(), optics, params, grid.clone())
            .map(|model| {
                if setup.asked_often {
                    model.keeping()
                } else {
                    model
                }
            })
            .map(|model| boxed(model, solid))
    };
    let scatter = |params| {
        scatter::model(setup.vial, &lights, setup.optics, params, grid.clone())
            .map(|model| boxed(model, solid))
    };
    match way {
        Optical::Scatter(params) => scatter(params),
        Optical::Orders(params) => {
            let model = orders::model(setup.vial, lights, setup.optics, params, grid)?;
            Ok(Box::new(if setup.asked_often {
                model.keeping()
            } else {
                model
            }))
        }
        Optical::Rays(params) => rays(params),
        Optical::Wave(params) => Ok(Box::new(Wave::new(setup.vial, lights, params, grid)?)),
        Optical::Spread(params) => Ok(Box::new(Spread::new(setup.vial, lights, params, grid)?)),
        Optical::Parallel => Ok(Box::new(Parallel::under(setup.vial, lights, grid, run)?)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::PatternGrid;
    use tomolith_core::kind::Section;
    use tomolith_optics::motion::Motion;
    use tomolith_optics::phase::henyey_greenstein::HenyeyGreenstein;
    use tomolith_optics::phase::{Phase, Scattering, rayleigh::Rayleigh};
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;
    use tomolith_target::Placement;
    use tomolith_target::phantom::Phantom;

    const VIAL: IndexMatched = IndexMatched { radius_mm: 2.0 };

    fn light() -> Light {
        let pixels = PatternGrid::full_turn(6, 0.1, 12, 16, 0.1);
        Light::new(pixels, Resin::absorbing(1.48, 0.2))
    }

    /// The reason, or the key of a refusal.
    /// Optics around the vial of these tests, of a model that is asked often.
    fn setup<'a>(optics: &'a [Optics], solid: Option<&'a Arc<dyn Shape>>) -> Setup<'a> {
        Setup {
            vial: &VIAL,
            optics,
            solid,
            asked_often: true,
            dose_factor: 1.0,
            orders_off: None,
        }
    }

    fn planned(choice: &Choice, setup: Setup<'_>, light: Light) -> String {
        let grid = VolumeGrid::centered([6, 8, 8], 0.1);
        match plan(choice, setup, vec![light], grid, None, &Run::new()) {
            Ok(plan) => plan.reason,
            Err(Error::Config { key, .. }) => key,
            Err(other) => panic!("{other}"),
        }
    }

    #[test]
    fn the_cheapest_model_is_exact_and_one_that_is_not_is_refused_by_its_key() {
        let level = [Optics::collimated(0.1)];
        let leaning = [Optics {
            motion: Motion {
                tilt_rad: 0.1,
                ..Motion::default()
            },
            ..level[0].clone()
        }];
        let section = Section::new("target.phantom", serde_json::json!("sphere"));
        let placement = Placement {
            size_mm: Some(0.8),
            ..Placement::default()
        };
        let ball: Arc<dyn Shape> =
            Arc::new(Phantom::build(&section, &placement, "target").unwrap());
        let [parallel, rays] = [
            Choice::Parallel(crate::parallel::Params::default()),
            Choice::Rays(rays::Params::default()),
        ];
        let wave = Choice::Wave(crate::wave::Params::default());
        let spread = Choice::Spread(spread::Params::default());
        let any = Choice::Cheapest;
        for (choice, setup, expected) in [
            (&any, setup(&level, None), "collimated light"),
            (
                &any,
                setup(&leaning, None),
                "light is not normal to the axis",
            ),
            (
                &any,
                setup(&level, Some(&ball)),
                "the target's surface cuts voxels into cells",
            ),
            (
                &rays,
                setup(&level, None),
                "as asked; [model.parallel] covers",
            ),
            (&parallel, setup(&leaning, None), "model.parallel"),
            (&wave, setup(&level, None), "wave ("),
            (&wave, setup(&leaning, None), "model.wave"),
            (&spread, setup(&level, None), "spread ("),
            (&spread, setup(&leaning, None), "model.spread"),
            (&wave, setup(&level, Some(&ball)), "model.wave"),
            (&parallel, setup(&level, Some(&ball)), "model.parallel"),
        ] {
            let found = planned(choice, setup, light());
            assert!(found.contains(expected), "{found} instead of {expected}");
        }
    }

    #[test]
    fn light_that_spreads_has_straight_light_for_starts_and_shadows() {
        let grid = VolumeGrid::centered([6, 8, 8], 0.1);
        let optics = [Optics::collimated(0.1)];
        for choice in [
            Choice::Wave(crate::wave::Params::default()),
            Choice::Spread(spread::Params {
                half_angle_deg: 5.0,
                ..spread::Params::default()
            }),
        ] {
            let setup = setup(&optics, None);
            let plan = plan(
                &choice,
                setup,
                vec![light()],
                grid.clone(),
                None,
                &Run::new(),
            );
            let straight = plan.unwrap().straight.unwrap();
            // One pixel meets the voxels of a chord, of the one height of its row: cones and waves meet others, too
            let mut x = straight.new_patterns().unwrap();
            let layout = &straight.patterns()[0];
            x.as_mut_slice()[layout.runs[6].offset + layout.runs[6].count as usize / 2] = 1.0;
            let mut dose = straight.new_dose().unwrap();
            straight.dose(&x, &mut dose, &Run::new()).unwrap();
            let dose = straight.outputs()[0].volume_of(dose.as_slice());
            let lit = |z: usize| (0..64).any(|i| *dose.at(z, i / 8, i % 8) > 1e-4);
            assert_eq!((0..6).filter(|z| lit(*z)).count(), 1);
            assert_eq!(straight.patterns()[0].quantity, Quantity::Energy);
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
            let setup = Setup {
                orders_off: off,
                ..setup(&optics, None)
            };
            let lights = vec![light];
            let wanted = Some(&wanted);
            let any = Choice::Cheapest;
            let plan = plan(&any, setup, lights, grid.clone(), wanted, &Run::new()).unwrap();
            (plan.model.patterns()[0].len(), plan.reason)
        };
        let pixels = |phase, leaning| planned(phase, leaning, None);
        let rayleigh = || Some(Arc::new(Rayleigh {}) as Arc<dyn Phase>);
        let (level, _) = pixels(None, false);
        let (orders, reason) = pixels(rayleigh(), false);
        assert!(
            orders == level && reason.starts_with("orders"),
            "{orders} {level} {reason}"
        );
        let (leaning, _) = pixels(None, true);
        let (orders, reason) = pixels(rayleigh(), true);
        assert!(
            orders == leaning && reason.starts_with("orders (rays, 4"),
            "{orders} {leaning} {reason}"
        );
        let peaked = Some(Arc::new(HenyeyGreenstein { g: 0.8 }) as Arc<dyn Phase>);
        let (paths, reason) = pixels(peaked, true);
        assert!(
            paths == leaning && reason.starts_with("rays, 4"),
            "{paths} {leaning} {reason}"
        );
        let why = "the resin scatters and much light is scattered into a narrow forward lobe";
        assert!(reason.ends_with(why), "{reason}");
        let (_, reason) = planned(rayleigh(), false, Some("a trial was too far off"));
        let why = "the resin scatters and a trial was too far off";
        assert!(
            reason.starts_with("rays, 4") && reason.ends_with(why),
            "{reason}"
        );
    }

    #[test]
    fn a_resin_that_scatters_and_differs_from_place_to_place_is_followed_by_random_paths() {
        use tomolith_optics::absorption_map::AbsorptionMap;
        use tomolith_optics::gradient::Gradient;
        let mut milk = light();
        milk.resin.attenuation_per_mm = 0.5;
        let mut optics = [Optics::collimated(0.1)];
        optics[0].scattering = Some(Scattering {
            per_mm: 0.3,
            phase: Arc::new(Rayleigh {}),
        });
        let setup = setup(&optics, None);
        let mapped = |total: f32| {
            let map = AbsorptionMap::new([1, 1, 2], 1.0, vec![0.2, 0.1], vec![total; 2]);
            let mut light = milk.clone();
            light.map = Some(Arc::new(map.unwrap()));
            planned(&Choice::Cheapest, setup, light)
        };
        let reason = mapped(0.5);
        assert!(
            reason.ends_with("the resin scatters and the absorption changes across the plane"),
            "{reason}"
        );
        // 0.2 absorbed and 0.3 scattered per mm are more than 0.4
        assert_eq!(mapped(0.4), "resin.map.attenuation");
        let mut bent = milk.clone();
        bent.resin.gradient = Some(Gradient {
            quadratic_per_mm2: -0.01,
            quartic_per_mm4: 0.0,
            step_mm: 0.1,
        });
        let reason = planned(&Choice::Cheapest, setup, bent);
        assert!(
            reason
                .ends_with("the resin scatters and the resin's index changes from place to place"),
            "{reason}"
        );
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
        let setup = Setup {
            vial: &VIAL,
            optics: &optics,
            solid: Some(&ball),
            asked_often: true,
            dose_factor: 1.0,
            orders_off: None,
        };
        let nothing = Volume::filled(grid.clone(), 0u8);
        let any = Choice::Cheapest;
        let plan = plan(
            &any,
            setup,
            vec![light()],
            grid,
            Some(&nothing),
            &Run::new(),
        )
        .unwrap();
        let layout = &plan.model.outputs()[0];
        assert_eq!(layout.cells.as_ref().map(|cells| cells.len()), Some(8));
        // In six frames the columns and rows at ±0.05 mm, with rays at ±0.025 and ±0.075, meet the ball
        assert_eq!(plan.model.patterns()[0].len(), 6 * 4);
    }
}
