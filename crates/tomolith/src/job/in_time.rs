//! The print in time: the written patterns of a job with a schedule, shown turn by turn to the job's material.
//!
//! Runs and simulations do it beside their evaluation, on the job's own voxels, in the light of the model that judges. Equations and units:
//! `docs/material.md`. Shading makes the light anew every [`ScheduleSpec::shading_every_s`](super::spec::ScheduleSpec).
//!
//! **Limits** Walls are those of the vial, of bodies and of inserts. With `diffusion = "spectral"` and a dose that diffuses walls are those of the
//! grid's box. Straight light in an index-matched vial is shaded along its way; other light that is shaded takes the family that covers an absorption
//! which changes from place to place, most often rays.

use super::doses::lit_rows;
use super::evaluate::measure_at;
use super::outcome::TimeSummary;
use super::refinement::Level;
use super::scene::{Scene, Voxels, at_section};
use super::scheduled::sent_mj;
use super::spec::{Against, Angles, JobSpec, MaterialSpec};
use super::species::{Row, joined};
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::{PatternGrid, Patterns, Volume, VolumeGrid};
use crate::io::frames::FrameSet;
use crate::io::mp4::write_movie;
use crate::metrics::Evaluation;
use crate::models::{Family, HostModel, OpticalScene, Purpose, Run, planner};
use crate::optics::absorption_map::AbsorptionMap;
use crate::optics::light::{Light, Selection};
use crate::report::OneMoment;
use crate::target::{Role, label};
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::{Arc, OnceLock};
use tomolith_material::curves::{CurvePoint, Curves, IdealExposure, Phases};
use tomolith_material::diffused::Diffused;
use tomolith_material::diffusion::Scheme;
use tomolith_material::domain::Domain;
use tomolith_material::frozen::Frozen;
use tomolith_material::mixing::Mixing;
use tomolith_material::photopolymer::{Curing, Network, Params, Photopolymer};
use tomolith_material::print::{LightSource, Moment, PrintRun};
use tomolith_material::printing::Printing;
use tomolith_material::schedule::{Schedule, Turns};
use tomolith_material::shaded::Shaded;
use tomolith_material::{Absorption, Material};

/// What patterns print over time.
pub(crate) struct InTime {
    /// Per network.
    pub(crate) networks: Vec<NetworkInTime>,
}

/// What a network becomes.
pub(crate) struct NetworkInTime {
    pub(crate) name: String,
    pub(crate) points: Vec<CurvePoint>,
    /// Energy that all lights have sent to the vial at each of these moments, mJ.
    pub(crate) sent_mj: Vec<f64>,
    pub(crate) requirement_mj: Option<f64>,
    pub(crate) ideal: IdealExposure,
    pub(crate) phases: Phases,
    /// What is solid then, measured.
    pub(crate) evaluation: Option<Evaluation>,
    /// When each voxel gels, s; ∞ where it does not.
    pub(crate) cure_times: Volume<f32>,
    /// Degree of cure (1 at the gel point) over time.
    pub(crate) snapshots: Vec<(f64, Volume<f32>)>,
    /// Labels of the same voxels.
    pub(crate) labels: Volume<u8>,
    /// The middle slice at every moment: brightness up to the gel point, white beyond it.
    slices: Vec<Vec<u16>>,
}

impl InTime {
    /// What is said of every network at the end.
    pub(super) fn summary(&self) -> Vec<TimeSummary> {
        let of = |network: &NetworkInTime| {
            let best_s = network.phases.curing_end_s;
            let mut moments = network.points.iter().zip(&network.sent_mj);
            let best = best_s.and_then(|best| moments.find(|(p, _)| p.seconds >= best));
            TimeSummary {
                name: network.name.clone(),
                induction_end_s: network.phases.induction_end_s,
                best_s,
                best_jaccard: best.map(|(p, _)| p.jaccard),
                best_mj: best.map(|(_, mj)| *mj),
                ideal_exposure_s: match network.ideal {
                    IdealExposure::At(seconds) => Some(seconds),
                    _ => None,
                },
                largest_share: match network.ideal {
                    IdealExposure::NotReached(share) => Some(share),
                    _ => None,
                },
            }
        };
        self.networks.iter().map(of).collect()
    }

    /// The best moment of several networks.
    pub(super) fn together(&self) -> Option<OneMoment> {
        let of = |network: &NetworkInTime| {
            let points = network.points.iter();
            points.map(|p| [p.seconds, p.jaccard]).collect()
        };
        let networks = self.networks.iter();
        let curves: Vec<(&str, Vec<[f64; 2]>)> =
            networks.map(|n| (n.name.as_str(), of(n))).collect();
        let first = self.networks.first()?;
        let moments = first.points.iter().zip(&first.sent_mj);
        let sent: Vec<[f64; 2]> = moments.map(|(p, mj)| [p.seconds, *mj]).collect();
        OneMoment::of(&curves, &sent)
    }
}

/// Length of the movie of a print, s.
const MOVIE_S: f64 = 8.0;
/// Level of resin that is about to become solid; that of solid resin is 255.
const LIQUID: f32 = 190.0;

impl NetworkInTime {
    /// The middle slice as it grows, 8 s long.
    ///
    /// # Errors
    /// [`Error::Io`], or what an encoder refuses.
    pub(crate) fn write_movie(&self, path: &Path, run: &Run) -> Result<()> {
        let [_, ny, nx] = self.labels.grid.shape;
        let grid = PatternGrid::full_turn(self.slices.len(), 0.0, ny, nx, 1.0);
        let values = self.slices.concat();
        let set = FrameSet {
            light: None,
            grid: &grid,
            bits: 8,
            full_scale: 1.0,
            values: &values,
        };
        write_movie(path, &set, self.slices.len() as f64 / MOVIE_S, &run.aside())
    }
}

/// Refuses shading of light that no model follows through a resin that absorbs differently from place to place.
///
/// # Errors
/// [`Error::Config`] with the model's reason.
pub(super) fn must_be_shaded(scene: &Scene) -> Result<()> {
    let own = scene.spec.material.as_ref();
    let photopolymer = own.and_then(|material| material.photopolymer.as_ref());
    let shading = photopolymer.map_or(&[][..], |params| &params.shading);
    let run = Run::new();
    let lights = Lights::new(scene, &[], &run);
    // Two slices are enough to change along z
    let map = AbsorptionMap::new([2, 1, 1], scene.grid.pitch_mm, vec![0.0; 2], vec![0.0; 2])?;
    let map = Arc::new(map);
    for (i, shading) in shading.iter().enumerate() {
        if lights.is_straight(shading.light)? {
            continue;
        }
        let covered = lights.family(shading.light, Some(&map));
        covered.map_err(|error| at_shading(i, error))?;
    }
    Ok(())
}

/// Blames the shading for a model that does not cover it.
fn at_shading(i: usize, error: Error) -> Error {
    match error {
        Error::Config {
            key,
            found,
            accepted,
            ..
        } => Error::config(
            format!("material.photopolymer.shading[{i}]"),
            format!("cured resin shades, and {key} does not cover that: {found}"),
            accepted,
        ),
        other => other,
    }
}

/// The schedule of a job.
pub(super) fn schedule(spec: &JobSpec) -> Result<Schedule> {
    let given = spec.schedule.clone().unwrap_or_default();
    let turns: Vec<Turns> = spec
        .light
        .iter()
        .map(|light| Turns {
            duty: given.duty,
            power: light.power.unwrap_or(given.power),
            dark_before_s: given.dark_before_s,
            dark_between_s: given.dark_between_s,
            dark_after_s: given.dark_after_s,
            own_patterns: given.own_patterns,
            ..Turns::new(
                light.angles.count(),
                given.seconds_per_turn.unwrap_or(60.0 / spec.output.rpm),
                light.turns.unwrap_or(given.turns),
            )
        })
        .collect();
    Schedule::of_turns(&turns).map_err(|error| at_schedule(spec, error))
}

impl JobSpec {
    /// The angles of all frames of a light: those of a turn, or of all turns where each has patterns of its own.
    pub(crate) fn angles_of(&self, light: usize) -> Angles {
        let angles = &self.light[light].angles;
        let own = self.schedule.as_ref().filter(|given| given.own_patterns);
        own.and_then(|given| angles.turn_after_turn(given.turns as usize))
            .unwrap_or_else(|| angles.clone())
    }
}

/// The turns of its own of a light that an error calls `light[i`.
fn turns_of(spec: &JobSpec, light: &str) -> Option<f64> {
    let i: usize = light.strip_prefix("light[")?.parse().ok()?;
    spec.light.get(i)?.turns
}

/// Names the key of the job.
fn at_schedule(spec: &JobSpec, error: Error) -> Error {
    let Error::Config {
        key,
        found,
        accepted,
        ..
    } = &error
    else {
        return error;
    };
    match key.split_once("].") {
        Some((light, "turns")) if turns_of(spec, light).is_some() => {
            Error::config(format!("{light}].turns"), found, accepted)
        }
        Some((light, "power")) => {
            let i: Option<usize> = light.strip_prefix("light[").and_then(|i| i.parse().ok());
            let own = i.and_then(|i| spec.light.get(i)).and_then(|l| l.power);
            let key = match own {
                Some(_) => format!("{light}].power"),
                None => "schedule.power".to_owned(),
            };
            Error::config(key, found, accepted)
        }
        Some((_, key)) => Error::config(format!("schedule.{key}"), found, accepted),
        None => error.under("schedule"),
    }
}

/// The material of a job: what it says, or a threshold at the resin's critical dose.
pub(super) fn material(
    spec: &JobSpec,
    rows: Option<&[Row]>,
    domain: Domain,
) -> Result<Photopolymer> {
    let names = rows.map_or_else(
        || vec!["resin".to_owned()],
        |rows| rows.iter().map(|(name, _)| name.clone()).collect(),
    );
    let own = spec.material.as_ref();
    let diffusion = own.and_then(|material| material.diffusion);
    let params = match own.and_then(|material| material.photopolymer.clone()) {
        Some(photopolymer) => photopolymer,
        None => {
            let critical = spec.resin.critical_dose_mj_per_mm3.ok_or_else(|| {
                let found = match diffusion {
                    Some(_) => "a dose that diffuses in a resin without resin.critical_dose_mj_per_mm3",
                    None => "a schedule without a material, and a resin without resin.critical_dose_mj_per_mm3",
                };
                Error::config(
                    "material",
                    found,
                    "one of the two: the dose that turns the resin solid, or [material.photopolymer]",
                )
            })?;
            let network = |name: &String| Network {
                dose_diffusion_mm2_per_s: diffusion.map_or(0.0, |d| d.mm2_per_s),
                ..Network::new(name, Curing::threshold(critical))
            };
            Params {
                diffusion: if diffusion.is_some() {
                    Scheme::Spectral
                } else {
                    Scheme::default()
                },
                ..Params::new(names.iter().map(network).collect())
            }
        }
    };
    let matrix = match rows {
        Some(rows) => rows.iter().map(|(_, row)| row.clone()).collect(),
        None => vec![vec![1.0; spec.light.len()]],
    };
    let key = "material.photopolymer";
    Photopolymer::new(params, Mixing::new(matrix)?, domain).map_err(|e| e.under(key))
}

/// Voxels of resin between walls that nothing passes, and air where the job says so.
fn domain(scene: &Scene, grid: &VolumeGrid) -> Result<Domain> {
    let mut domain = Domain::new(grid.clone());
    let own = scene.spec.material.as_ref();
    let photopolymer = own.and_then(|material| material.photopolymer.as_ref());
    if photopolymer.is_some_and(|params| params.diffusion == Scheme::Faces) {
        domain = domain.with_walls(&resin(scene, grid)?)?;
    }
    if own.is_some_and(|material| material.air_on_top) {
        domain = domain.with_air_on_top();
    }
    Ok(domain)
}

/// Which voxels hold resin: those in the vial, but in no body and no insert.
fn resin(scene: &Scene, grid: &VolumeGrid) -> Result<Volume<bool>> {
    let [_, ny, nx] = grid.shape;
    let optics = &scene.optics;
    let bodies: Vec<_> = optics
        .paths
        .first()
        .into_iter()
        .flat_map(|path| &path.obstacles[..optics.bodies])
        .collect();
    let holds = |i: usize| {
        let place = [grid.x(i % nx), grid.y(i / nx % ny), grid.z(i / (nx * ny))];
        let is_free = || !bodies.iter().any(|body| body.surface.contains(place));
        optics.vial.in_resin(place) && is_free()
    };
    let mut values: Vec<bool> = (0..grid.len()).into_par_iter().map(holds).collect();
    if let Some(insert) = scene.shape.body(Role::Insert) {
        let shares = insert.sample(grid)?.values;
        let pairs = values.iter_mut().zip(shares);
        pairs.for_each(|(resin, share)| *resin &= share < 0.5);
    }
    Ok(Volume {
        grid: grid.clone(),
        values,
    })
}

/// Whether the doses of a job diffuse.
pub(super) fn diffuses(scene: &Scene) -> bool {
    let material = scene.spec.material.as_ref();
    material.is_some_and(|material| material.diffusion.is_some())
}

/// A model whose dose is that at the end of the schedule, where the job's dose diffuses.
///
/// # Errors
/// As [`Diffused::of_schedule`].
pub(super) fn diffused(scene: &Scene, model: HostModel) -> Result<HostModel> {
    let own = scene.spec.material.as_ref();
    let Some(diffusion) = own.and_then(|material| material.diffusion) else {
        return Ok(model);
    };
    let given = scene.spec.schedule.clone().unwrap_or_default();
    let turns = if given.own_patterns {
        given.turns as usize
    } else {
        1
    };
    let arcs = diffusion.arcs.unwrap_or(turns);
    let schedule = schedule(&scene.spec)?;
    let diffused = Diffused::of_schedule(model, diffusion.mm2_per_s, &schedule, arcs);
    Ok(Box::new(
        diffused.map_err(|e| at_section("material.diffusion", e))?,
    ))
}

/// The dose models of a level, joined to what the job is optimized against.
///
/// # Errors
/// [`Error::Config`] where they do not fit.
pub(super) fn planned_in_time(
    scene: &Scene,
    optics: (Option<&Family>, OpticalScene<'_>),
    level: &Level,
    voxels: &[&Voxels],
    run: &Run,
) -> Result<planner::ModelPlan> {
    let rows = scene.rows().unwrap_or_default();
    let given = scene.spec.schedule.clone().unwrap_or_default();
    let join = |models: Vec<HostModel>| -> Result<HostModel> {
        let schedule = schedule(&scene.spec)?;
        let domain = domain(scene, &level.grid)?;
        let material = Box::new(material(&scene.spec, scene.mixing.as_deref(), domain)?);
        Ok(match given.optimize {
            Against::Exact => Box::new(Printing::new(models, schedule, material, given.step_s)?),
            _ => {
                let every = scene.spec.stop.iterations.div_ceil(given.rounds + 1);
                Box::new(Frozen::new(
                    models,
                    schedule,
                    material,
                    given.step_s,
                    every,
                )?)
            }
        })
    };
    let mut plan = joined(&rows, optics, &level.grid, Some(voxels), run, join)?;
    plan.reason = format!("{}; against the degree of cure", plan.reason);
    Ok(plan)
}

/// Whether a job optimizes against a resin with a memory, whose cure is no linear function of the patterns.
pub(super) fn is_optimized(spec: &JobSpec) -> bool {
    let has_memory = |material: &MaterialSpec| material.photopolymer.is_some();
    let against = spec.schedule.as_ref().map(|given| given.optimize);
    against.is_some_and(|against| against != Against::Dose)
        && spec.material.as_ref().is_some_and(has_memory)
}

impl Scene {
    /// Whether patterns are optimized against what they print in time.
    pub(crate) fn is_optimized_in_time(&self) -> bool {
        let given = self.spec.schedule.as_ref();
        given.is_some_and(|schedule| schedule.optimize != Against::Dose)
    }

    /// The factor of patterns of light `i` that would bring a dose of 1, so that species `s` becomes solid at the end of the schedule.
    pub(super) fn dose_needed(&self, s: usize, i: usize) -> Result<f64> {
        if !self.is_optimized_in_time() {
            return Ok(1.0);
        }
        let energies = schedule(&self.spec)?.energies(i);
        let mean = energies.iter().sum::<f64>() / energies.len().max(1) as f64;
        let domain = Domain::new(VolumeGrid::centered([1, 1, 1], 0.1));
        let material = material(&self.spec, self.mixing.as_deref(), domain)?;
        let start = material.start()?;
        let Some(needed) = material.requirement(s) else {
            return Ok(1.0 / mean);
        };
        let of = |&(volume, capacity): &(usize, f64)| {
            capacity * f64::from(start.volumes[volume].as_slice()[0])
        };
        let inhibited: f64 = needed.inhibitors.iter().map(of).sum();
        Ok((needed.dose + inhibited) / mean)
    }
}

/// The light that judges, one model each.
struct Lights<'a> {
    scene: &'a Scene,
    lights: Vec<Light>,
    /// Straight light in resin where nothing has cured, once it is asked for.
    plain: Vec<OnceLock<Option<Arc<tomolith_material::Model>>>>,
    run: &'a Run,
}

impl<'a> Lights<'a> {
    fn new(scene: &'a Scene, patterns: &[Patterns], run: &'a Run) -> Self {
        let mut lights = scene.optics.lights_turning(scene.spec.evaluate.sub_angles);
        for (light, patterns) in lights.iter_mut().zip(patterns) {
            light.active = Some(lit_rows(patterns));
            light.selection = Selection::default();
        }
        let plain = lights.iter().map(|_| OnceLock::new()).collect();
        Lights {
            scene,
            lights,
            plain,
            run,
        }
    }

    /// The model of a light in the resin as the job has it, or with this absorption.
    fn model(&self, i: usize, absorption: Option<&Absorption>) -> Result<HostModel> {
        let Some(absorption) = absorption else {
            return self.planned(i, None);
        };
        if let Some(plain) = self.straight(i)? {
            let resin = &self.lights[i].resin;
            let plain_mu = [resin.absorption_per_mm, resin.attenuation_per_mm];
            return Ok(Box::new(Shaded::new(plain, plain_mu, absorption)?));
        }
        let grid = &absorption.active_per_mm.grid;
        let [active, total] = [&absorption.active_per_mm, &absorption.attenuation_per_mm];
        let (active, total) = (active.values.clone(), total.values.clone());
        let map = AbsorptionMap::new(grid.shape, grid.pitch_mm, active, total)?;
        self.planned(i, Some(Arc::new(map.about(grid.center_mm))))
    }

    /// The scene of a light alone.
    fn scene_of<'s>(&'s self, i: usize, light: &'s [Light], purpose: Purpose) -> OpticalScene<'s> {
        let all = self.scene.optics.scene();
        OpticalScene {
            lights: light,
            optics: &all.optics[i..=i],
            purpose,
            ..all
        }
    }

    fn planned(&self, i: usize, map: Option<Arc<AbsorptionMap>>) -> Result<HostModel> {
        let light = [self.mapped(i, map.as_ref())];
        let purpose = if map.is_some() {
            Purpose::Probe
        } else {
            Purpose::Optimize
        };
        let own = self.scene_of(i, &light, purpose);
        let asked = self.scene.optics.model.as_ref();
        let plan = planner::plan(asked, own, &self.scene.grid, None, self.run)?;
        Ok(Box::new(plan.model))
    }

    /// A light in the resin of the job, or in one with this map.
    fn mapped(&self, i: usize, map: Option<&Arc<AbsorptionMap>>) -> Light {
        let mut light = self.lights[i].clone();
        light.map = map.cloned().or(light.map);
        light
    }

    /// The family of models of a light.
    fn family(&self, i: usize, map: Option<&Arc<AbsorptionMap>>) -> Result<Family> {
        let light = [self.mapped(i, map)];
        let own = self.scene_of(i, &light, Purpose::Optimize);
        planner::choose(self.scene.optics.model.as_ref(), &own, &self.scene.grid)
    }

    /// Whether a light runs level and straight through resin that absorbs alike everywhere, cones and waves about such a way among them.
    fn is_straight(&self, i: usize) -> Result<bool> {
        let (light, vial) = (&self.lights[i], self.scene.optics.vial.as_ref());
        let index = light.resin.refractive_index;
        let outside = vial.surrounding_index(light.surrounding_index, index);
        Ok(self.family(i, None)?.capabilities().is_along_frames
            && vial.walls().len() == 1
            && vial.is_round()
            && outside == index
            && light.map.is_none()
            && !light.resin.pure_radon)
    }

    /// The model of the resin in which nothing has cured, where light runs level and straight through it.
    fn straight(&self, i: usize) -> Result<Option<Arc<tomolith_material::Model>>> {
        if let Some(known) = self.plain[i].get() {
            return Ok(known.clone());
        }
        let model = if self.is_straight(i)? {
            Some(Arc::from(self.planned(i, None)?))
        } else {
            None
        };
        Ok(self.plain[i].get_or_init(|| model).clone())
    }
}

/// Patterns before the material of a job.
pub(super) struct Shown<'a> {
    pub(super) material: Photopolymer,
    pub(super) schedule: Schedule,
    lights: Lights<'a>,
    models: Vec<HostModel>,
    fields: Vec<HostField>,
    /// Whether cured resin shades.
    shaded: bool,
}

impl<'a> Shown<'a> {
    /// Models of the light as it is before anything cures.
    pub(super) fn new(scene: &'a Scene, patterns: &[Patterns], run: &'a Run) -> Result<Self> {
        let domain = domain(scene, &scene.grid)?;
        let material = material(&scene.spec, scene.mixing.as_deref(), domain)?;
        let lights = Lights::new(scene, patterns, run);
        let start = material.start()?;
        let mut models = Vec::with_capacity(patterns.len());
        let mut fields = Vec::with_capacity(patterns.len());
        let mut shaded = false;
        for (i, patterns) in patterns.iter().enumerate() {
            let absorption = material.absorption(&start, i);
            shaded |= absorption.is_some();
            let model = lights.model(i, absorption.as_ref())?;
            let mut x = model.new_patterns()?;
            model.patterns()[0].fill_field(patterns, x.as_mut_slice());
            models.push(model);
            fields.push(x);
        }
        Ok(Shown {
            material,
            schedule: schedule(&scene.spec)?,
            lights,
            models,
            fields,
            shaded,
        })
    }

    /// Prints, and shows every moment.
    ///
    /// # Errors
    /// As [`PrintRun::run`].
    pub(super) fn print(&self, look: &mut dyn FnMut(&Moment)) -> Result<()> {
        let given = self.lights.scene.spec.schedule.clone().unwrap_or_default();
        let sources = self.models.iter().zip(&self.fields);
        let sources = sources.map(|(model, patterns)| LightSource {
            model: model.as_ref(),
            patterns,
        });
        let mut print = PrintRun::new(&self.material, &self.schedule, sources.collect())?;
        if let Some(step_s) = given.step_s {
            print = print.with_step_s(step_s).map_err(|e| e.under("schedule"))?;
        }
        let mut renew = |i: usize, absorption: &Absorption| self.lights.model(i, Some(absorption));
        if self.shaded {
            print = print.with_renewal(given.shading_every_s, &mut renew);
        }
        let mut observe = |moment: &Moment| {
            look(moment);
            ControlFlow::Continue(())
        };
        print.run(self.lights.run, &mut observe).map(drop)
    }
}

/// Shows patterns to the material of a job; None where it has no schedule.
///
/// # Errors
/// [`Error::Config`] where models, schedule and material do not fit; [`Error::Canceled`].
pub(super) fn print_in_time(
    scene: &Scene,
    voxels: &[&Voxels],
    patterns: &[Patterns],
    run: &Run,
) -> Result<Option<InTime>> {
    let Some(given) = &scene.spec.schedule else {
        return Ok(None);
    };
    let shown = Shown::new(scene, patterns, run)?;
    let material = &shown.material;
    let end = shown.schedule.end_s();
    let times: Vec<f64> = (1..=given.snapshots)
        .map(|i| end * i as f64 / given.snapshots as f64)
        .collect();
    let mut watched = Vec::with_capacity(voxels.len());
    for (s, voxels) in voxels.iter().enumerate() {
        watched.push(Watched::new(material, s, voxels, &times)?);
    }
    shown.print(&mut |moment| watched.iter_mut().for_each(|watched| watched.look(moment)))?;
    let names = Material::species(material);
    let mut networks = Vec::with_capacity(names.len());
    for ((watched, name), (scene, voxels)) in watched
        .into_iter()
        .zip(names)
        .zip(scene.species().zip(voxels))
    {
        let mut network = watched.finish(material, name, scene, voxels, patterns)?;
        let seconds: Vec<f64> = network.points.iter().map(|p| p.seconds).collect();
        network.sent_mj = sent_mj(&shown.schedule, patterns, &seconds);
        networks.push(network);
    }
    Ok(Some(InTime { networks }))
}

/// The curves of a network, and its state at the best moment so far.
struct Watched {
    curves: Curves,
    best: f64,
    readout: HostField,
    slices: Vec<Vec<u16>>,
    middle: usize,
}

impl Watched {
    fn new(material: &Photopolymer, s: usize, voxels: &Voxels, times: &[f64]) -> Result<Self> {
        let curves = Curves::new(material, s, &voxels.labels)?
            .with_cure_times(material)
            .with_snapshots(times);
        Ok(Watched {
            curves,
            best: 0.0,
            readout: material.domain().zeros(),
            slices: Vec::new(),
            middle: middle_of(&voxels.labels),
        })
    }

    fn look(&mut self, moment: &Moment) {
        self.curves.watch(moment);
        self.slices.push(self.slice(moment));
        let jaccard = self.curves.points().last().map_or(0.0, |p| p.jaccard);
        if jaccard > self.best {
            self.best = jaccard;
            let readout = moment.material.readout(self.curves.species());
            self.readout
                .copy_from(&moment.state.volumes[readout.volume]);
        }
    }

    /// The middle slice, row 0 = +y.
    fn slice(&self, moment: &Moment) -> Vec<u16> {
        let readout = moment.material.readout(self.curves.species());
        let values = moment.state.volumes[readout.volume].as_slice();
        let layout = moment.material.domain().layout();
        let [_, ny, nx] = layout.grid.shape;
        let level = |i: usize| {
            let (row, column) = (i / nx, i % nx);
            let degree = readout.scale * values[layout.index(self.middle, ny - 1 - row, column)];
            match degree >= readout.gel {
                true => 255,
                false => (LIQUID * (degree / readout.gel).clamp(0.0, 1.0)) as u16,
            }
        };
        (0..nx * ny).map(level).collect()
    }

    fn finish(
        self,
        material: &Photopolymer,
        name: String,
        scene: &Scene,
        voxels: &Voxels,
        patterns: &[Patterns],
    ) -> Result<NetworkInTime> {
        let Watched {
            curves,
            best,
            mut readout,
            slices,
            ..
        } = self;
        let own = material.readout(curves.species());
        readout.scale(own.scale);
        let mut snapshots = curves.snapshots().to_vec();
        let evaluation = match curves.phases().curing_end_s {
            Some(seconds) if best > 0.0 => {
                let degree = material.domain().layout().volume_of(readout.as_slice());
                let gel = f64::from(own.gel);
                let evaluation = measure_at(scene, voxels, &degree, gel, patterns)?;
                with_moment(&mut snapshots, seconds, degree);
                Some(evaluation)
            }
            _ => None,
        };
        let no_time = || Volume::filled(scene.grid.clone(), f32::INFINITY);
        Ok(NetworkInTime {
            name,
            requirement_mj: curves.requirement_mj(),
            ideal: curves.ideal_exposure(),
            phases: curves.phases(),
            evaluation,
            cure_times: curves.cure_times(material).unwrap_or_else(no_time),
            snapshots,
            points: curves.points().to_vec(),
            sent_mj: Vec::new(),
            labels: voxels.labels.clone(),
            slices,
        })
    }
}

/// Puts a moment among others, unless one of them is it.
fn with_moment(snapshots: &mut Vec<(f64, Volume<f32>)>, seconds: f64, degree: Volume<f32>) {
    let at = snapshots.partition_point(|(before, _)| *before < seconds);
    if snapshots.get(at).is_none_or(|(next, _)| *next > seconds) {
        snapshots.insert(at, (seconds, degree));
    }
}

/// The height in the middle of what is part.
fn middle_of(labels: &Volume<u8>) -> usize {
    let [nz, ny, nx] = labels.grid.shape;
    let is_part =
        |iz: &usize| labels.values[iz * ny * nx..(iz + 1) * ny * nx].contains(&label::PART);
    let first = (0..nz).find(is_part);
    let last = (0..nz).rfind(is_part);
    first
        .zip(last)
        .map_or(nz / 2, |(a, b)| usize::midpoint(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Document, Job, ResolvedJob, Silent};
    use serde_json::Value;

    const DISC: &str = r#"
        target = { phantom = { sphere = {} }, size_mm = 1.2 }
        grid = { pitch_mm = 0.1 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        light = [{ pixels = [24, 20], angles = 24, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        stop = { iterations = 12 }
        evaluate = { refine = 1, sub_angles = 1 }
        schedule = { seconds_per_turn = 5.0, turns = 8, power = { energy_per_turn_mj_per_mm2 = 0.25 }, snapshots = 2 }
        [[material.photopolymer.networks]]
        name = "resin"
        curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } }
        inhibitors = [{ capacity_mj_per_mm3 = 0.25, diffusion_mm2_per_s = 1e-4 }]
    "#;

    fn job(changes: &[&str]) -> Result<Job> {
        let mut document = Document::toml("a.toml", DISC).unwrap();
        for change in changes {
            document.set(change).unwrap();
        }
        Job::from_document(document)
    }

    /// The report of a run, and its folder.
    fn report(changes: &[&str]) -> (Value, tempfile::TempDir) {
        let folder = tempfile::tempdir().unwrap();
        let job = job(changes).unwrap();
        let job = job.with_folder(&folder.path().join("run"), "--output");
        crate::job::run(&job, false, &mut Silent, &Run::new()).unwrap();
        let text = std::fs::read(folder.path().join("run/report.json")).unwrap();
        (serde_json::from_slice(&text).unwrap(), folder)
    }

    #[test]
    fn a_job_with_a_schedule_prints_in_time() {
        let (report, folder) = report(&[]);
        let time = &report["time"][0];
        let number = |key: &str| time[key].as_f64().unwrap();
        // Nothing is solid before oxygen is used up: 0.75 of the dose that is asked for in all, of 2 that are sent
        let (begin, best) = (number("induction_end_s"), number("best_s"));
        assert!(
            begin > 5.0 && best >= begin && best <= 40.0,
            "{begin} {best}"
        );
        assert!(number("best_jaccard") > 0.7, "{time}");
        let iou = time["evaluation"]["iou"].as_f64().unwrap();
        assert!((iou - number("best_jaccard")).abs() < 1e-9);
        // The page shows that moment, too
        let html = std::fs::read_to_string(folder.path().join("run/report.html")).unwrap();
        assert!(html.contains("type=\"range\"") && html.contains(" s, best</label>"));
        for file in ["time.csv", "cure_time.npy", "print.mp4"] {
            assert!(folder.path().join("run").join(file).exists(), "{file}");
        }
    }

    #[test]
    fn a_print_that_ends_too_soon_says_how_far_it_came() {
        let share = |turns: &str, who: &str| {
            let folder = tempfile::tempdir().unwrap();
            let job = job(&[turns, "stop.iterations=4"]).unwrap();
            let job = job.with_folder(&folder.path().join("run"), "--output");
            let summary = crate::job::run(&job, false, &mut Silent, &Run::new()).unwrap();
            let own = &summary.in_time[0];
            let share = own.largest_share.unwrap();
            assert!(own.ideal_exposure_s.is_none());
            let percent = crate::report::number::significant(100.0 * share, 3);
            let said = format!("{who} {percent} % of what the part needs");
            assert!(own.to_string().contains(&said), "{own}");
            share
        };
        // Half of the light leaves half of the dose
        let one = share("schedule.turns=1", "the part absorbs");
        let half = share("schedule.turns=0.5", "the part absorbs");
        assert!(
            one > 0.1 && one < 0.5 && (one / half - 2.0).abs() < 0.1,
            "{one} {half}"
        );
    }

    #[test]
    fn shaded_light_and_two_networks_print_too() {
        let (report, folder) = report(&[
            "species=[{ name = \"soft\" }, { name = \"hard\", driven_by = { light = 0.5 } }]",
            "material.photopolymer.networks=[{ name = \"soft\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } } }, { name = \"hard\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } } }]",
            "material.photopolymer.shading=[{ light = 0, active_per_mm = [0.1, 0.1], attenuation_per_mm = [0.1, 0.5] }]",
        ]);
        let begin = |i: usize| report["time"][i]["induction_end_s"].as_f64().unwrap();
        // Half the drive takes twice as long, and a little more behind what is solid by then
        let ratio = begin(1) / begin(0);
        assert!((1.8..2.6).contains(&ratio), "{ratio}");
        assert!(folder.path().join("run/time_hard.csv").exists());
    }

    #[test]
    fn patterns_against_the_degree_of_cure_end_at_the_gel_point() {
        for against in ["frozen", "exact"] {
            let change = format!("schedule.optimize=\"{against}\"");
            let (report, _folder) = report(&[&change, "schedule.turns=4"]);
            let time = &report["time"][0];
            let last = time["curves"]["jaccard"]
                .as_array()
                .unwrap()
                .last()
                .unwrap();
            let last = last.as_f64().unwrap();
            let best = time["best_jaccard"].as_f64().unwrap();
            assert!(last > 0.8 && last > best - 0.05, "{against}: {last} {best}");
        }
    }

    #[test]
    fn a_dose_that_diffuses_is_that_of_every_model_spread() {
        let task = |change: &str, diffusion: &str| {
            let diffusion = format!("material={{ diffusion = {{ mm2_per_s = {diffusion} }} }}");
            let changes = [&diffusion, change, "resin.critical_dose_mj_per_mm3=0.8"];
            let job = ResolvedJob::new(&job(&changes).unwrap()).unwrap();
            job.task(&Run::new()).unwrap()
        };
        for change in [
            "model=\"parallel\"",
            "model=\"rays\"",
            "light[0].projector={ telecentric = { pixel_pitch_mm = 0.1, aperture_radius_mm = 1.0, working_distance_mm = 100.0 } }",
            "species=[{ name = \"a\", driven_by = { light = 0.7 } }]",
        ] {
            let (sharp, blurred) = (task(change, "0"), task(change, "5e-4"));
            let of = |task: &crate::job::Task| {
                let mut dose = task.model.new_dose().unwrap();
                task.model
                    .dose(&sharp.start, &mut dose, &Run::new())
                    .unwrap();
                let sum = dose.as_slice().iter().map(|v| f64::from(*v)).sum::<f64>();
                (sum, dose.dot(&dose))
            };
            // What diffuses stays in the box; 40 s at 5e-4 mm²/s spread it by 0.14 mm
            let ((all, squares), (spread, lower)) = (of(&sharp), of(&blurred));
            assert!(
                (spread / all - 1.0).abs() < 1e-4,
                "{change}: {all} {spread} {}",
                sharp.start.max_abs()
            );
            assert!(lower < 0.995 * squares, "{change}: {squares} {lower}");
            let model = blurred.model.describe();
            assert!(model.contains("diffused at 0.0005 mm²/s"), "{model}");
        }
    }

    #[test]
    fn a_job_whose_dose_diffuses_runs_to_its_report() {
        let iou = |diffusion: &str| {
            let material = format!("material={{ diffusion = {{ mm2_per_s = {diffusion} }} }}");
            let changes = [
                &material,
                "resin.critical_dose_mj_per_mm3=0.8",
                "schedule.power={ energy_mj_per_mm2 = 1.2 }",
                "target={ phantom = \"gear\", size_mm = 1.8 }",
            ];
            let (report, folder) = report(&changes);
            assert!(folder.path().join("run/time.csv").exists());
            let time = &report["time"][0];
            assert!(time["best_jaccard"].as_f64().unwrap() > 0.5, "{time}");
            report["evaluation"]["iou"].as_f64().unwrap()
        };
        // The headline sees the diffusion: σ = √(DT) is three voxels
        let (sharp, blurred) = (iou("0"), iou("2e-3"));
        assert!(blurred < sharp - 0.005, "{sharp} {blurred}");
    }

    #[test]
    fn turns_with_patterns_of_their_own_are_optimized_and_printed() {
        let own = [
            "schedule.optimize=\"exact\"",
            "schedule.turns=2",
            "schedule.power={ energy_per_turn_mj_per_mm2 = 1.0 }",
            "light[0].angles=12",
        ];
        let loss = |folder: &tempfile::TempDir| {
            let text = std::fs::read_to_string(folder.path().join("run/history.csv")).unwrap();
            let row = |line: &str| line.split(',').nth(1).unwrap().parse::<f64>().unwrap();
            let rows: Vec<f64> = text.lines().skip(1).map(row).collect();
            (rows[0], rows[rows.len() - 1])
        };
        let (_, folder) = report(&own);
        let (start, repeated) = loss(&folder);
        let (time, folder) = report(&[&own[..], &["schedule.own_patterns=true"]].concat());
        let (same, apart) = loss(&folder);
        assert!((same / start - 1.0).abs() < 0.01, "{same} {start}");
        assert!(apart < 1.01 * repeated, "{apart} {repeated}");
        assert!(time["time"][0]["best_jaccard"].as_f64().unwrap() > 0.7);
    }

    #[test]
    fn heights_are_done_together_where_rows_are_rescaled() {
        // Oxygen rises from a fifth at the bottom to all at the top
        let axial = "material.photopolymer.networks=[{ name = \"resin\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }, inhibitors = [{ capacity_mj_per_mm3 = 0.4, initial = { axial = [[-0.6, 0.2], [0.6, 1.0]] } }] }]";
        // When half of the voxels about the axis are solid, in the upper part over the lower one
        let ratio = |change: &str| {
            let (_, folder) = report(&[axial, change]);
            let file = folder.path().join("run/cure_time.npy");
            let ([nz, ny, nx], times) = crate::io::npy::read_volume(&file).unwrap();
            let median = |slices: std::ops::Range<usize>| {
                let near = |i: &usize| {
                    let (y, x) = (i / nx % ny, i % nx);
                    y.abs_diff(ny / 2) < 3 && x.abs_diff(nx / 2) < 3
                };
                let own = (slices.start * ny * nx..slices.end * ny * nx).filter(near);
                let mut own: Vec<f32> = own.map(|i| times[i]).collect();
                own.sort_by(f32::total_cmp);
                own[own.len() / 2]
            };
            median(nz / 2 + 2..nz / 2 + 5) / median(nz / 2 - 5..nz / 2 - 2)
        };
        let (before, after) = (
            ratio("schedule.level_heights=false"),
            ratio("schedule.level_heights=true"),
        );
        assert!(
            before > 1.15 && (after - 1.0).abs() < 0.05,
            "{before} {after}"
        );
    }

    #[test]
    fn bodies_and_inserts_are_walls() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/11-bodies.toml");
        let mut document = Document::read(&file).unwrap();
        for change in [
            "target.body[1].role=\"insert\"",
            "grid.pitch_mm=0.2",
            "schedule={ turns = 2 }",
            "material={ photopolymer = { networks = [{ name = \"resin\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }, inhibitors = [{ capacity_mj_per_mm3 = 0.4, diffusion_mm2_per_s = 1e-3 }] }] } }",
        ] {
            document.set(change).unwrap();
        }
        let scene = Scene::new(&Job::from_document(document).unwrap(), &Run::new()).unwrap();
        let held = resin(&scene, &scene.grid).unwrap();
        let walls = held.values.iter().filter(|v| !**v).count();
        assert!(walls > 20 && walls < held.values.len() / 4, "{walls}");
        // Light uses oxygen up in half of the box; what flows stays in the resin
        let domain = domain(&scene, &scene.grid).unwrap();
        let material = material(&scene.spec, None, domain).unwrap();
        let mut state = material.start().unwrap();
        let layout = material.domain().layout().clone();
        let half = Volume {
            values: (0..scene.grid.len())
                .map(|i| 0.2 * f32::from(u8::from(i % 2 == 0)))
                .collect(),
            grid: scene.grid.clone(),
        };
        let light = layout.field_of(&half);
        material.step(&mut state, &[&light], 1.0).unwrap();
        let oxygen = |state: &tomolith_material::State| {
            let content = layout.volume_of(state.volumes[0].as_slice()).values;
            let of = |resin: bool| {
                let own = content
                    .iter()
                    .zip(&held.values)
                    .filter(|(_, r)| **r == resin);
                own.map(|(v, _)| f64::from(*v)).sum::<f64>()
            };
            (of(true), of(false), content)
        };
        let (before, inside, then) = oxygen(&state);
        for _ in 0..20 {
            material
                .step(&mut state, &[&[]], material.longest_step_s().min(5.0))
                .unwrap();
        }
        let (after, still, now) = oxygen(&state);
        assert!((after / before - 1.0).abs() < 1e-5, "{before} {after}");
        assert_eq!((inside, still), (0.0, 0.0));
        assert!(then.iter().zip(&now).any(|(a, b)| (a - b).abs() > 0.1));
    }

    #[test]
    fn what_cannot_be_printed_in_time_is_refused_by_its_key() {
        let refused = |changes: &[&str]| {
            let found = job(changes).and_then(|job| ResolvedJob::new(&job).map(drop));
            match found.unwrap_err() {
                Error::Config { key, .. } => key,
                other => panic!("{other}"),
            }
        };
        for (change, key) in [
            ("schedule.turns=0", "schedule.turns"),
            ("schedule.duty=1.5", "schedule.duty"),
            ("schedule.step_s=0", "schedule.step_s"),
            ("schedule.step_s=1e-9", "schedule.step_s"),
            ("schedule.snapshots=101", "schedule.snapshots"),
            ("schedule.shading_every_s=-1", "schedule.shading_every_s"),
            (
                "material.photopolymer.shading=[{ light = 0, active_per_mm = [0.2, 0.2], attenuation_per_mm = [0.2, 0.5] }]",
                "material.photopolymer.shading[0].active_per_mm",
            ),
            (
                "material.photopolymer.shading=[{ light = 0, active_per_mm = [0.1, 0.2], attenuation_per_mm = [0.2, 0.5] }]",
                "material.photopolymer.shading[0].attenuation_per_mm",
            ),
            (
                "schedule.power={ irradiance_mw_per_mm2 = -1 }",
                "schedule.power",
            ),
            (
                "light[0].power={ irradiance_mw_per_mm2 = -1 }",
                "light[0].power",
            ),
            ("schedule.own_patterns=true", "schedule.own_patterns"),
            ("material={}", "material"),
            ("material={ diffusion = { mm2_per_s = 1e-4 } }", "material"),
            (
                "material={ diffusion = { mm2_per_s = -1 } }",
                "material.diffusion.mm2_per_s",
            ),
            (
                "species=[{ name = \"resin\", driven_by = { light = -1.0 } }]",
                "species[0].driven_by",
            ),
            // 0.1²/(6·10⁻⁴) is 16.7 s
            ("schedule.step_s=100", "schedule.step_s"),
            (
                "material.photopolymer.networks=[]",
                "material.photopolymer.networks",
            ),
            (
                "material.photopolymer.networks=[{ name = \"resin\", curing = { threshold = { critical_dose_mj_per_mm3 = -1 } } }]",
                "material.photopolymer.networks[0].curing",
            ),
        ] {
            let found = refused(&[change]);
            assert!(found.starts_with(key), "{change}: {found}");
        }
        // What a light is to inhibit needs something that it makes
        let lights = "light=[{ name = \"a\", pixels = [24, 20], angles = 24, projector = { collimated = { pixel_pitch_mm = 0.1 } } }, \
                      { name = \"b\", pixels = [24, 20], angles = 24, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]";
        let species = "species=[{ name = \"resin\", driven_by = { a = 1.0, b = -0.5 } }]";
        let bare = "material.photopolymer.networks=[{ name = \"resin\", curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } } }]";
        assert!(ResolvedJob::new(&job(&[lights, species]).unwrap()).is_ok());
        assert_eq!(
            refused(&[lights, species, bare]),
            "material.photopolymer.networks[0].inhibitors"
        );
        assert_eq!(
            refused(&[bare, "schedule.optimize=\"frozen\""]),
            "schedule.optimize"
        );
        assert_eq!(
            refused(&[
                "material={ diffusion = { mm2_per_s = 1e-4 }, air_on_top = true }",
                "resin.critical_dose_mj_per_mm3=0.8"
            ]),
            "material.air_on_top"
        );
        assert_eq!(
            refused(&[
                "material.photopolymer.diffusion=\"spectral\"",
                "material.air_on_top=true"
            ]),
            "material.photopolymer.diffusion"
        );
        let rate_law = "material.photopolymer.networks=[{ name = \"resin\", curing = { rate_law = { rate_per_s = 1.0, exponent = 0.5, gel_conversion = 0.2 } } }]";
        for (change, key) in [
            ("schedule.optimize=\"frozen\"", "schedule.optimize"),
            ("schedule.level_heights=true", "schedule.level_heights"),
        ] {
            assert_eq!(refused(&[rate_law, change]), key);
        }
        // An inhibitor of which there is none is none, unless air or a light brings it
        let empty = "material.photopolymer.networks[0].inhibitors[0].initial={ even = 0.0 }";
        let frozen = "schedule.optimize=\"frozen\"";
        assert_eq!(refused(&[empty, frozen]), "schedule.optimize");
        let aired = job(&[empty, frozen, "material.air_on_top=true"]).unwrap();
        assert!(ResolvedJob::new(&aired).is_ok());
        // Waves are weakened along their way, scattered light has no single one; cells know nothing that flows between them
        let shades = "material.photopolymer.shading=[{ light = 0, active_per_mm = [0.1, 0.1], attenuation_per_mm = [0.1, 0.5] }]";
        assert!(ResolvedJob::new(&job(&[shades]).unwrap()).is_ok());
        let waves = "model={ wave = {} }";
        assert!(ResolvedJob::new(&job(&[shades, waves]).unwrap()).is_ok());
        let scatters = [
            "resin.scattering_per_mm=0.1",
            "material.photopolymer.shading=[{ light = 0, active_per_mm = [0.1, 0.1], attenuation_per_mm = [0.2, 0.5] }]",
            "model={ successive_orders = {} }",
        ];
        assert_eq!(refused(&scatters), "material.photopolymer.shading[0]");
        let cells = "objective={ threshold = { surface = \"cells\" } }";
        assert_eq!(
            refused(&[cells, "schedule.optimize=\"exact\""]),
            "objective.threshold.surface"
        );
        // Air on top takes a seventh in place of a sixth: 14.3 s
        let step = "schedule.step_s=15";
        assert!(ResolvedJob::new(&job(&[step]).unwrap()).is_ok());
        let open = ["material.air_on_top=true", step];
        assert_eq!(refused(&open), "schedule.step_s");
        let without = "schedule={ turns = 2 }";
        let mut document =
            Document::toml("a.toml", DISC.split("[[material").next().unwrap()).unwrap();
        document.set(without).unwrap();
        let found = Job::from_document(document).map(drop).unwrap_err();
        assert!(matches!(found, Error::Config { key, .. } if key == "material"));
    }
}
