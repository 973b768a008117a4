//! Tables → objects: vial, lights, bodies and the model between them; whether they fit is checked in [`compatibility`](super::compatibility).

use super::card::Card;
use super::point_spread;
use super::selection::selection_of;
use crate::dose::Accelerator;
use crate::error::{Error, Result, in_range};
use crate::exposure::Printer;
use crate::grid::{PatternGrid, VolumeGrid};
use crate::io::mesh::read_mesh;
use crate::io::npy::read_levels;
use crate::job::spec::{
    DoseConvention, JobSpec, LightSpec, MapSpec, Region, ResinSpec, VialCommon,
};
use crate::kind::Section;
use crate::models::{Family, MODELS, ModelKind, OpticalScene, Purpose, planner, rays};
use crate::optics::absorption_map::AbsorptionMap;
use crate::optics::gradient::IndexGradient;
use crate::optics::light::{Light, Selection};
use crate::optics::motion::Motion;
use crate::optics::obstacle::{BodyMaterial, Obstacle};
use crate::optics::phase::{PHASES, Phase, Scattering};
use crate::optics::projector::PROJECTORS;
use crate::optics::resin::Resin;
use crate::optics::surface::{Net, Surface, meeting};
use crate::optics::trace::Bath;
use crate::optics::vial::ended::Ended;
use crate::optics::vial::{CrossSection, VIALS, Vial};
use crate::target::{MeshShape, Placement, Repair, Role, Shape};
use crate::units::{concise, exact};
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;

/// Rounding of a square of an index.
const ROUNDING: f64 = 1e-9;

/// What stands between the projectors and the resin.
pub(crate) struct Optics {
    pub(crate) vial: Box<dyn Vial>,
    /// Its kind's name in a job.
    pub(crate) vial_kind: &'static str,
    /// The names of the projectors' kinds, one per light.
    pub(crate) projector_kinds: Vec<&'static str>,
    /// One per light.
    pub(crate) lights: Vec<Light>,
    /// What stands between each light's pixels and the vial.
    pub(crate) paths: Vec<rays::Optics>,
    /// What people should know of the meshes of vial and obstacles.
    pub(crate) of_meshes: Vec<String>,
    /// Bodies of the job among the obstacles of a path, before the inserts of the target.
    pub(crate) bodies: usize,
    /// How light becomes dose, where the job says so; None: by the cheapest model that is exact.
    pub(crate) model: Option<Family>,
    /// What every dose is multiplied by.
    pub(crate) dose_factor: f64,
    /// Why light that scatters does not go order by order though it could ([`model_probe`](crate::job::dose::model_probe)).
    pub(crate) probe_failed: Option<&'static str>,
    /// Where models are computed; None: the processor.
    pub(crate) card: Option<Card>,
}

impl Optics {
    /// The vial and the lights of a job, as the optimization sees them; `base` is the folder of the job file.
    pub(crate) fn new(spec: &JobSpec, base: &Path) -> Result<Self> {
        Self::with_models(spec, base, &[])
    }

    /// [`new`](Self::new), where the model may also be one of these rows.
    pub(crate) fn with_models(
        spec: &JobSpec,
        base: &Path,
        models: &'static [ModelKind],
    ) -> Result<Self> {
        let (kind, section) = Section::new("vial", spec.vial.kind.clone())
            .based(base)
            .kind(VIALS)?;
        let vial_kind = kind.name;
        let vial = with_ends((kind.build)(&section)?, &spec.vial.common)?;
        let gradient = gradient_of(spec, vial.as_ref())?;
        let read = |value: &Value| {
            let section = Section::new("model", value.clone()).based(base);
            let (kind, section) = section.kind(MODELS.iter().chain(models))?;
            (kind.build.read)(&section)
        };
        let model = spec.model.as_ref().map(read).transpose()?;
        let mut of_meshes = vial.notes().to_vec();
        let obstacles = obstacles_of(spec, base, &mut of_meshes)?;
        let motion = motion_of(spec)?;
        let phase = Section::new("resin.phase", spec.resin.phase.clone()).read(PHASES)?;
        let phase: Arc<dyn Phase> = Arc::from(phase);
        let mut paths = Vec::with_capacity(spec.light.len());
        let mut projector_kinds = Vec::with_capacity(spec.light.len());
        for (i, light) in spec.light.iter().enumerate() {
            let section = Section::new(format!("light[{i}].projector"), light.projector.0.clone());
            let (kind, section) = section.kind(PROJECTORS)?;
            projector_kinds.push(kind.name);
            paths.push(rays::Optics {
                projector: Arc::from((kind.build)(&section)?),
                motion,
                obstacles: obstacles.clone(),
                scattering: scattering_of(&spec.resin_of(i), &phase),
            });
        }
        let bath = bath_of(spec, vial.as_ref())?;
        let maps = maps_of(spec, base)?;
        let mut lights: Vec<Light> = spec
            .light
            .iter()
            .zip(&paths)
            .enumerate()
            .map(|(i, (light, path))| {
                let mut light = Light {
                    bath,
                    map: maps.get(i).cloned(),
                    ..light_of(spec, i, light, path.projector.pixel_pitch_mm())
                };
                light.resin.gradient = gradient;
                light
            })
            .collect();
        for (i, (light, given)) in lights.iter_mut().zip(&spec.light).enumerate() {
            let key = format!("light[{i}].selection");
            let (vial, pixels) = (vial.as_ref(), &light.pixels);
            light.selection = selection_of(&given.selection, &key, base, pixels, vial, &paths[i])?;
            light.selection.has_background = given.bounds.min.unwrap_or(spec.bounds.min) > 0.0;
            light.point_spread = point_spread::of_light(i, given, &light.pixels, base)?;
        }
        let mut optics = Optics {
            vial,
            vial_kind,
            projector_kinds,
            lights,
            paths,
            of_meshes,
            bodies: obstacles.len(),
            model,
            dose_factor: 1.0,
            probe_failed: None,
            card: Card::of(spec.resources.device.as_deref())?,
        };
        if spec.resin.dose_convention == DoseConvention::Drtvam {
            optics.dose_factor = optics.refracted_factor();
        }
        Ok(optics)
    }

    /// What light passes, as the planner sees it.
    pub(crate) fn scene(&self) -> OpticalScene<'_> {
        OpticalScene {
            vial: self.vial.as_ref(),
            lights: &self.lights,
            optics: &self.paths,
            solid: None,
            purpose: Purpose::Probe,
            dose_factor: self.dose_factor,
            probe_failed: self.probe_failed,
            accelerator: self.card.as_ref().map(|card| card as &dyn Accelerator),
        }
    }

    /// The family of models that the job names, or the cheapest that covers its light on a grid of whole voxels.
    pub(crate) fn family(&self, grid: &VolumeGrid) -> Result<Family> {
        planner::choose(self.model.as_ref(), &self.scene(), grid)
    }

    /// Leaves pixels dark that the machines of the lights cannot light; says so.
    pub(crate) fn leave_dark(&mut self, printers: &[Printer]) -> Vec<String> {
        let mut notes = Vec::new();
        for (i, (light, printer)) in self.lights.iter_mut().zip(printers).enumerate() {
            if let Some(mask) = printer.lightable() {
                light.selection.masks.push(Arc::new(mask));
                notes.push(format!(
                    "light[{i}]: pixels that lie on dead pixels of the printer stay dark"
                ));
            }
        }
        notes
    }

    /// The bodies of `[[obstacles]]`, without the inserts of the target.
    pub(super) fn obstacles(&self) -> &[Obstacle] {
        let path = self.paths.first();
        path.map_or(&[], |path| &path.obstacles[..self.bodies])
    }

    /// Whether a place lies in one of them.
    pub(super) fn in_obstacle(&self, place: [f64; 3]) -> bool {
        let mut bodies = self.obstacles().iter();
        bodies.any(|body| body.surface.contains(place))
    }

    /// Warns of bodies that reach through a wall of the vial.
    pub(crate) fn through_walls(&self) -> Vec<String> {
        let walls = self.vial.surfaces();
        let met = |(i, body): (usize, &Obstacle)| {
            let Surface::Net(net) = &body.surface else {
                return None;
            };
            let place = walls
                .iter()
                .find_map(|(wall, _)| meeting(net.corners(), wall))?;
            let [x, y, z] = place.map(concise);
            Some(format!(
                "obstacles[{i}] meets a wall of the vial at ({x}, {y}, {z}) mm: it takes the place of wall and resin there; move it \
                 (`offset_mm`) if it should stand clear of the wall"
            ))
        };
        let bodies = self.obstacles().iter().enumerate();
        bodies.filter_map(met).collect()
    }

    /// Puts the inserts of a target into the light.
    pub(crate) fn add_inserts(&mut self, shape: &dyn Shape) -> Result<()> {
        let meshes = shape.body(Role::Insert).map(Shape::meshes);
        for mesh in meshes.into_iter().flatten() {
            let body = Obstacle {
                surface: Surface::Net(Arc::new(Net::new(mesh, "target.body")?)),
                material: BodyMaterial::Black,
            };
            for path in &mut self.paths {
                path.obstacles.push(body.clone());
            }
        }
        Ok(())
    }

    /// The same lights with frames averaged over so many angles.
    pub(crate) fn lights_turning(&self, sub_angles: &[usize]) -> Vec<Light> {
        let turning = |(light, &sub_angles): (&Light, &usize)| Light {
            sub_angles,
            active: None,
            ..light.clone()
        };
        self.lights.iter().zip(sub_angles).map(turning).collect()
    }

    /// All pixels of every light, each frame at its middle.
    pub(crate) fn lights_standing(&self) -> Vec<Light> {
        self.lights_turning(&vec![1; self.lights.len()])
    }

    /// Whether a point (mm) of a grid counts: it is in the resin and in the region.
    pub(crate) fn counts(
        &self,
        region: Region,
        grid: &VolumeGrid,
    ) -> impl Fn([f64; 3]) -> bool + Sync {
        let [low, high] = grid.bounds_mm();
        let inscribed = (0..2)
            .map(|i| high[i].min(-low[i]))
            .fold(f64::INFINITY, f64::min);
        let radius = if region == Region::Cylinder {
            inscribed
        } else {
            f64::INFINITY
        };
        move |[x, y, z]| x.hypot(y) < radius && self.vial.in_resin([x, y, z])
    }

    /// (n_surrounding/n_resin)²: 1 where the bath has the resin's index. Both indices are those of the job, the same for all its lights.
    fn refracted_factor(&self) -> f64 {
        let Some(light) = self.lights.first() else {
            return 1.0;
        };
        let resin = light.resin.refractive_index;
        let surrounding = self.vial.surrounding_index(light.surrounding_index, resin);
        (surrounding / resin).powi(2)
    }

    /// How far the axis leans.
    pub(crate) fn tilt_rad(&self) -> f64 {
        self.paths.first().map_or(0.0, |path| path.motion.tilt_rad)
    }
}

/// The vial between its ends, where it has any.
fn with_ends(vial: Box<dyn Vial>, spec: &VialCommon) -> Result<Box<dyn Vial>> {
    if spec.bottom.is_none() && spec.top.is_none() {
        return Ok(vial);
    }
    Ok(Box::new(Ended::new(vial, spec.bottom, spec.top)?))
}

/// How the resin's index changes, with the chords that suit the vial; refused where the index leaves the range of an even resin, or where a chord is no length.
fn gradient_of(spec: &JobSpec, vial: &dyn Vial) -> Result<Option<IndexGradient>> {
    let Some(params) = &spec.resin.gradient else {
        return Ok(None);
    };
    if let Some(step) = params.step_mm {
        let is_in = (1e-3..=10.0).contains(&step);
        in_range(is_in, "resin.gradient.step_mm", step, "0.001 to 10")?;
    }
    let farthest = vial.resin_wall().circumscribed_radius();
    let gradient = params.within(farthest);
    // n² is a parabola of ρ²: where it is least is an end or its vertex
    let vertex = -0.5 * params.quadratic_per_mm2 / params.quartic_per_mm4;
    let vertex = if (0.0..farthest * farthest).contains(&vertex) {
        vertex.sqrt()
    } else {
        0.0
    };
    for rho in [vertex, farthest] {
        let square = spec.resin.refractive_index.powi(2) * gradient.relative_square(rho);
        if !(1.0 - ROUNDING..=16.0 + ROUNDING).contains(&square) {
            return Err(Error::config(
                "resin.gradient",
                format!(
                    "{} mm from the axis n² is {}",
                    concise(rho),
                    concise(square)
                ),
                "an index from 1 to 4 (n² from 1 to 16) everywhere in the resin",
            ));
        }
    }
    Ok(Some(gradient))
}

fn bath_of(spec: &JobSpec, vial: &dyn Vial) -> Result<Option<Bath>> {
    let Some(bath) = &spec.bath else {
        return Ok(None);
    };
    let radius = bath.radius_mm.0;
    let walls = vial.walls();
    let outer = walls.first().map(|wall| wall.curve);
    let vial = outer.map_or(0.0, CrossSection::circumscribed_radius);
    if radius < vial {
        return Err(Error::config(
            "bath.radius_mm",
            format!(
                "found {} mm, within the vial, which reaches {} mm",
                exact(radius),
                concise(vial)
            ),
            format!("a radius of at least {} mm", concise(vial)),
        ));
    }
    Ok(Some(Bath {
        absorption_per_mm: bath.absorption_per_mm,
        radius_mm: radius,
    }))
}

/// The absorption map of each light, whose resin may scatter differently; none where the job has none.
fn maps_of(spec: &JobSpec, base: &Path) -> Result<Vec<Arc<AbsorptionMap>>> {
    let Some(map) = &spec.resin.absorption_map else {
        return Ok(Vec::new());
    };
    let mut maps: Vec<(f64, Arc<AbsorptionMap>)> = Vec::new();
    for i in 0..spec.light.len() {
        must_leave_to_map(spec, i, map)?;
        let scattered = spec.resin_of(i).scattering_per_mm;
        let same = maps.iter().find(|(known, _)| *known == scattered);
        let map_of_light = match same {
            Some((_, map)) => Arc::clone(map),
            None => Arc::new(map_of(map, scattered, base)?),
        };
        maps.push((scattered, map_of_light));
    }
    Ok(maps.into_iter().map(|(_, map)| map).collect())
}

/// Refuses numbers of a light in place of which the map of all lights would be used.
fn must_leave_to_map(spec: &JobSpec, i: usize, map: &MapSpec) -> Result<()> {
    let resin = &spec.light[i].resin;
    let has_total = map.attenuation.is_some();
    for (key, given) in [
        ("absorption_per_mm", resin.absorption_per_mm),
        ("attenuation_per_mm", resin.attenuation_per_mm),
        (
            "scattering_per_mm",
            resin.scattering_per_mm.filter(|_| has_total),
        ),
    ] {
        if let Some(value) = given {
            return Err(Error::config(
                format!("light[{i}].resin.{key}"),
                format!(
                    "{} per mm, but resin.absorption_map says how all lights are absorbed",
                    exact(value)
                ),
                "no such key beside a map: lights that are absorbed differently need a job without it",
            ));
        }
    }
    Ok(())
}

/// The absorption map in a resin that scatters so much per mm.
fn map_of(map: &MapSpec, scattered: f64, base: &Path) -> Result<AbsorptionMap> {
    let (shape, active) = read_levels(&base.join(&map.absorption))?;
    let total = match &map.attenuation {
        None => active.iter().map(|a| a + scattered as f32).collect(),
        Some(file) => {
            let (other, total) = read_levels(&base.join(file))?;
            if other != shape {
                return Err(Error::Shape {
                    what: "resin.absorption_map.attenuation".into(),
                    expected: shape.to_vec(),
                    found: other.to_vec(),
                });
            }
            total
        }
    };
    AbsorptionMap::new(shape, map.pitch_mm.0, active, total)
}

/// How the vial moves.
fn motion_of(spec: &JobSpec) -> Result<Motion> {
    let motion = &spec.motion;
    let [x, y] = motion.offset_mm;
    for (key, value, least, most) in [
        ("tilt_deg", motion.tilt_deg, -80.0, 80.0),
        ("offset_mm[0]", x, -1e3, 1e3),
        ("offset_mm[1]", y, -1e3, 1e3),
        ("axis_runout_mm", motion.axis_runout_mm, 0.0, 1e3),
        ("axis_runout_deg", motion.axis_runout_deg, -360.0, 360.0),
    ] {
        let (key, accepted) = (format!("motion.{key}"), format!("{least} to {most}"));
        in_range((least..=most).contains(&value), key, value, accepted)?;
    }
    Ok(Motion {
        tilt_rad: motion.tilt_deg.to_radians(),
        offset_mm: motion.offset_mm,
        axis_runout_mm: motion.axis_runout_mm,
        axis_runout_rad: motion.axis_runout_deg.to_radians(),
    })
}

fn scattering_of(resin: &ResinSpec, phase: &Arc<dyn Phase>) -> Option<Scattering> {
    (resin.scattering_per_mm > 0.0).then(|| Scattering {
        per_mm: resin.scattering_per_mm,
        phase: Arc::clone(phase),
    })
}

/// Refuses numbers that no material of a body has.
fn must_be_matter(material: &BodyMaterial) -> Result<()> {
    let index = |key: &str, n: f64| {
        let key = format!("{key}.refractive_index");
        in_range(n.is_finite() && n > 0.0, key, n, "a finite number > 0")
    };
    match *material {
        BodyMaterial::Diffuse { reflectance: part } => {
            let is_part = (0.0..=1.0).contains(&part);
            in_range(is_part, "diffuse.reflectance", part, "0 to 1")
        }
        BodyMaterial::Dielectric { refractive_index } => index("dielectric", refractive_index),
        BodyMaterial::Metal {
            refractive_index,
            extinction_coefficient: k,
        } => {
            index("metal", refractive_index)?;
            let key = "metal.extinction_coefficient";
            in_range(k.is_finite() && k >= 0.0, key, k, "a finite number ≥ 0")
        }
        _ => Ok(()),
    }
}

/// The bodies in the light; notes what was repaired in their meshes.
fn obstacles_of(spec: &JobSpec, base: &Path, notes: &mut Vec<String>) -> Result<Vec<Obstacle>> {
    let mut obstacles = Vec::with_capacity(spec.obstacles.len());
    for (i, obstacle) in spec.obstacles.iter().enumerate() {
        let section = format!("obstacles[{i}]");
        must_be_matter(&obstacle.material).map_err(|e| e.under(&format!("{section}.material")))?;
        let placement = Placement {
            scale: Some(obstacle.scale),
            offset_mm: obstacle.offset_mm,
            center: false,
            ..Placement::default()
        };
        let key = |error: Error| match error {
            Error::Io { .. } | Error::Mesh { .. } | Error::Format { .. } => Error::config(
                format!("{section}.mesh"),
                error.to_string(),
                "a closed mesh that can be read",
            ),
            other => other,
        };
        let file = base.join(&obstacle.mesh);
        let content = read_mesh(&file).and_then(|content| content.whole(&file));
        let content = content.map_err(key)?;
        let shape =
            MeshShape::new(content, &placement, &file, &section, Repair::Safe).map_err(key)?;
        let found = shape.warnings().into_iter();
        notes.extend(found.map(|note| format!("{section}.mesh: {note}")));
        obstacles.push(Obstacle {
            surface: Surface::Net(Arc::new(Net::new(shape.mesh(), &section)?)),
            material: obstacle.material,
        });
    }
    Ok(obstacles)
}

fn light_of(spec: &JobSpec, i: usize, light: &LightSpec, pitch_mm: [f64; 2]) -> Light {
    let (azimuths, frame_arc) = spec.angles_of(i).azimuths(light.rotation);
    let [columns, rows] = light.pixels;
    let resin = spec.resin_of(i);
    let absorption = resin.active_per_mm();
    Light {
        pixels: PatternGrid {
            azimuths,
            frame_arc,
            rows,
            columns,
            pitch_mm,
            offset_mm: light.offset_mm.map(|mm| mm.0),
        },
        resin: Resin {
            refractive_index: resin.refractive_index,
            gradient: None,
            absorption_per_mm: absorption,
            attenuation_per_mm: if resin.pure_radon {
                0.0
            } else {
                let known = absorption + resin.scattering_per_mm;
                resin.attenuation_per_mm.unwrap_or(known)
            },
            pure_radon: resin.pure_radon,
        },
        wavelength_nm: light.wavelength_nm,
        surrounding_index: spec.vial.common.surrounding_index,
        map: None,
        bath: None,
        point_spread: None,
        polarization: light.polarization,
        sub_angles: light.sub_angles.unwrap_or(1),
        active: None,
        selection: Selection::default(),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::job::tests::{FULL, document_of};
    use crate::kind::Section;

    pub(crate) fn spec(changes: &[&str]) -> JobSpec {
        JobSpec::from_document(&document_of(FULL, changes)).unwrap()
    }

    /// A target as a table of a job says it.
    pub(crate) fn shape(table: serde_json::Value) -> Box<dyn crate::target::Shape> {
        let spec: crate::target::TargetSpec = Section::new("target", table).parse().unwrap();
        crate::target::build(&spec, Path::new(""), "target").unwrap()
    }

    pub(crate) fn key(error: Error) -> String {
        match error {
            Error::Config { key, .. } => key,
            other => panic!("{other}"),
        }
    }

    #[test]
    fn the_convention_of_another_program_is_a_factor_of_every_dose() {
        let run = crate::models::Work::new();
        let dose = |convention: &str| {
            let spec = spec(&[
                &format!("resin.dose_convention=\"{convention}\""),
                "vial.surrounding_index=1.2",
            ]);
            let optics = Optics::new(&spec, Path::new(".")).unwrap();
            let grid = VolumeGrid::centered([4, 8, 8], 0.2);
            let plan = planner::plan(None, optics.scene(), &grid, None, &run);
            let model = plan.unwrap().model;
            let dose = crate::check::dose(&model, &crate::check::even_patterns(&model, 1.0));
            let sum: f64 = dose.as_slice().iter().map(|&d| f64::from(d)).sum();
            (sum, (1.2 / spec.resin.refractive_index).powi(2))
        };
        let ((energy, factor), (theirs, _)) = (dose("energy"), dose("drtvam"));
        assert!((theirs / energy / factor - 1.0).abs() < 1e-5);
    }

    #[test]
    fn a_body_that_meets_a_wall_is_warned_of() {
        let folder = tempfile::tempdir().unwrap();
        let body = crate::io::mesh::samples::cuboid([-0.5; 3], [0.5; 3]);
        let bytes = crate::io::mesh::samples::stl_binary(&body);
        std::fs::write(folder.path().join("body.stl"), bytes).unwrap();
        let at = |x: f64| {
            let change = format!("obstacles=[{{ mesh = \"body.stl\", offset_mm = [{x}, 0, 0] }}]");
            let optics = Optics::new(&spec(&[&change]), folder.path()).unwrap();
            optics.through_walls().len()
        };
        // Resin to 7.6 mm, glass to 8.3: corners at (x ± ½, ½)
        assert_eq!([7.0, 7.2, 8.0, 9.0].map(at), [0, 1, 1, 0]);
    }

    #[test]
    fn repairs_of_a_body_are_told() {
        let folder = tempfile::tempdir().unwrap();
        let mut body = crate::io::mesh::samples::cuboid([-0.5; 3], [0.5; 3]);
        let notes = |body: &crate::io::mesh::Mesh| {
            let bytes = crate::io::mesh::samples::stl_binary(body);
            std::fs::write(folder.path().join("body.stl"), bytes).unwrap();
            let spec = spec(&["obstacles=[{ mesh = \"body.stl\" }]"]);
            Optics::new(&spec, folder.path()).unwrap().of_meshes
        };
        assert!(notes(&body).is_empty());
        body.triangles.pop();
        let notes = notes(&body);
        assert_eq!(notes.len(), 1, "{notes:?}");
        assert!(notes[0].starts_with("obstacles[0].mesh: "), "{notes:?}");
        assert!(notes[0].contains("hole"), "{notes:?}");
    }

    #[test]
    fn an_index_that_ends_in_the_resin_is_refused() {
        let refused = |gradient: &str| {
            let spec = spec(&[&format!("resin.gradient={gradient}")]);
            key(Optics::new(&spec, Path::new("")).err().unwrap())
        };
        // 7.6 mm: n² = 1 − 0.02·57.76 < 0 at the wall; with + 4e-4 ρ⁴ its least is 1 − 1/4 at ρ² = 25, but for 2e-3 it is below 0 there
        assert_eq!(refused("{ quadratic_per_mm2 = -0.02 }"), "resin.gradient");
        let hollow = "{ quadratic_per_mm2 = -0.1, quartic_per_mm4 = 2e-3 }";
        assert_eq!(refused(hollow), "resin.gradient");
        assert_eq!(refused("{ step_mm = 0.0 }"), "resin.gradient.step_mm");
        let spec = spec(&["resin.gradient={ quadratic_per_mm2 = -0.02, quartic_per_mm4 = 4e-4 }"]);
        let optics = Optics::new(&spec, Path::new("")).unwrap();
        assert!(
            optics
                .lights
                .iter()
                .all(|light| light.resin.gradient.is_some())
        );
    }

    #[test]
    fn a_projector_without_pixels_is_refused() {
        let spec = spec(&["light.projector.collimated.pixel_pitch_mm=0"]);
        let refused = key(Optics::new(&spec, Path::new("")).err().unwrap());
        assert_eq!(refused, "light[0].projector.collimated.pixel_pitch_mm");
    }

    #[test]
    fn a_bath_reaches_every_light_and_must_hold_the_vial() {
        let bath = |radius: &str| {
            let change = format!("bath={{ absorption_per_mm = 0.1, radius_mm = {radius} }}");
            Optics::new(&spec(&[&change]), Path::new(""))
        };
        let lights = bath("20").unwrap().lights;
        let expected = Bath {
            absorption_per_mm: 0.1,
            radius_mm: 20.0,
        };
        assert!(lights.iter().all(|light| light.bath == Some(expected)));
        assert_eq!(key(bath("8.2").err().unwrap()), "bath.radius_mm"); // the vial reaches 8.3
    }

    #[test]
    fn a_map_is_read_beside_the_job_and_met_by_rays_where_light_bends() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mu.npy");
        let map = ndarray::array![[0.1f64, 0.2, 0.3], [0.1, 0.1, 0.1]];
        ndarray_npy::write_npy(&path, &map).unwrap();
        let spec = spec(&["resin.absorption_map={ absorption = \"mu.npy\", pitch_mm = 1.0 }"]);
        let optics = Optics::new(&spec, folder.path()).unwrap();
        let values = vec![0.1, 0.2, 0.3, 0.1, 0.1, 0.1];
        let expected = AbsorptionMap::new([1, 2, 3], 1.0, values.clone(), values).unwrap();
        assert_eq!(optics.lights[0].map.as_deref(), Some(&expected));
        let grid = VolumeGrid::centered([2, 4, 4], 0.1);
        let run = crate::models::Work::new();
        let planned = planner::plan(optics.model.as_ref(), optics.scene(), &grid, None, &run);
        // Light bends in this vial: rays know the map too
        let reason = planned.unwrap().reason;
        assert!(
            reason.starts_with("rays") && reason.contains("across the plane"),
            "{reason}"
        );
    }

    #[test]
    fn what_is_scattered_is_attenuated_beside_what_a_map_absorbs() {
        let folder = tempfile::tempdir().unwrap();
        let map = ndarray::array![[0.1f64, 0.25, 0.5]];
        ndarray_npy::write_npy(folder.path().join("mu.npy"), &map).unwrap();
        let spec = spec(&[
            "resin.absorption_map={ absorption = \"mu.npy\", pitch_mm = 1.0 }",
            "resin.scattering_per_mm=0.5",
        ]);
        let optics = Optics::new(&spec, folder.path()).unwrap();
        let (active, total) = (vec![0.1, 0.25, 0.5], vec![0.6, 0.75, 1.0]);
        let expected = AbsorptionMap::new([1, 1, 3], 1.0, active, total).unwrap();
        assert_eq!(optics.lights[0].map.as_deref(), Some(&expected));
    }

    #[test]
    fn a_light_has_no_absorption_of_its_own_beside_a_map() {
        let spec = spec(&[
            "resin.absorption_map={ absorption = \"mu.npy\", pitch_mm = 1.0 }",
            "light.resin.absorption_per_mm=0.3",
        ]);
        let message = Optics::new(&spec, Path::new("."))
            .err()
            .unwrap()
            .to_string();
        tomolith_core::contains!(message, "light[0].resin.absorption_per_mm", "0.3 per mm");
    }
}
