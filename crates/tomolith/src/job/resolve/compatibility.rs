//! Whether what a job has built fits together: the target into vial and light, a stored matrix to voxels and frames.

use super::optics::Optics;
use super::refinement::LEAST_ANGLES;
use crate::error::{Error, Result};
use crate::grid::{Volume, VolumeGrid};
use crate::job::spec::JobSpec;
use crate::job::spec::output::LEAST_REFINE;
use crate::optics::light::Light;
use crate::report::number::significant;
use crate::target::{Shape, label};
use crate::units::{concise, counted, exact};
use std::f64::consts::TAU;
use tomolith_core::parallel::{InParallel, table};

/// Part of the target's volume that may lie outside the resin: what rounding to voxels puts there.
const STRAY: f64 = 1e-3;
/// Part of a voxel that a target may reach into a wall where a job does not say how far.
const TOUCH: f64 = 0.01;

/// What a voxel of a gray target holds at least: less is rounding of where its faces lie.
const GRAY: f32 = 1e-6;

/// Pixels across a voxel from which on a part that no voxel sees is a matter of the voxels.
const COARSE: f64 = 2.0;

/// Pixels across a voxel from which on a prediction is rough.
const TOO_COARSE: f64 = 6.0;

/// Lengths of absorption from the wall to the middle of a vial, above which next to no light arrives there: e⁻⁷ is a thousandth.
const DARK_INSIDE: f64 = 7.0;

/// How far the target of a job may reach into a wall, mm.
pub(crate) fn wall_tolerance_mm(spec: &JobSpec, grid: Option<&VolumeGrid>) -> Result<f64> {
    match spec.target.wall_tolerance_mm {
        Some(asked) if !(asked.0.is_finite() && asked.0 >= 0.0) => Err(Error::config(
            "target.wall_tolerance_mm",
            format!("found {asked}"),
            "a length ≥ 0",
        )),
        Some(asked) => Ok(asked.0),
        None => Ok(grid.map_or(0.0, |grid| TOUCH * grid.pitch_mm)),
    }
}

impl Optics {
    /// Refuses an evaluation on voxels or frames for which a stored model has no entries.
    pub(crate) fn must_be_evaluated(&self, spec: &JobSpec) -> Result<()> {
        let evaluate = &spec.evaluate;
        let model = self.model.as_ref();
        let Some(stored) = model.filter(|model| model.capabilities().is_stored) else {
            return Ok(());
        };
        if (evaluate.refine, evaluate.sub_angles) == (Some(1), Some(1)) {
            return Ok(());
        }
        let name = stored.name();
        Err(Error::config(
            "evaluate",
            format!(
                "refine = {} and sub_angles = {}, but a {name} is known for its own voxels and frames only",
                evaluate.refine.unwrap_or(LEAST_REFINE),
                evaluate.sub_angles.unwrap_or(LEAST_ANGLES)
            ),
            format!("refine = 1 and sub_angles = 1 with [model.{name}]"),
        ))
    }

    /// Refuses a target whose box is larger than the vial or the field: known before it is voxelized. Says by how much it touches the
    /// vial's wall.
    pub(crate) fn must_hold(
        &self,
        spec: &JobSpec,
        shape: &dyn Shape,
        wall_tolerance_mm: f64,
    ) -> Result<Vec<String>> {
        let [low, high] = shape.bounds_mm();
        // A shape touches every face of its box, so some of it is this far from the axis
        let out = (0..2).map(|i| high[i].max(-low[i])).fold(0.0, f64::max);
        let resin = self.vial.resin_wall().inscribed_radius();
        let over = out - resin * (1.0 + 1e-9);
        if over > wall_tolerance_mm {
            // With the fewest digits that distinguish the two
            let [reaches, ends] = match [out, resin].map(concise) {
                [reaches, ends] if reaches == ends => [out, resin].map(exact),
                short => short,
            };
            return Err(Error::config(
                "target",
                format!("reaches {reaches} mm from the axis, but the resin ends at {ends} mm"),
                match spec.target.mesh_unit {
                    Some(_) => {
                        "a target that fits into the vial: another target.mesh_unit, target.size_mm, or a larger vial"
                    }
                    None => {
                        "a target that fits into the vial: give target.size_mm or target.offset_mm, or a larger vial; \
                         target.wall_tolerance_mm lets it reach a little into the wall"
                    }
                },
            ));
        }
        let touching = (over > 0.0).then(|| {
            format!(
                "the target reaches {} mm into the wall of the vial, where nothing prints: that much is cut off",
                concise(out - resin)
            )
        });
        self.must_be_in_the_fields(spec, [low, high])?;
        Ok(touching.into_iter().collect())
    }

    /// Whether there is resin within the tolerance of a point (mm) that is in none.
    fn touches(&self, [x, y, z]: [f64; 3], far: f64) -> bool {
        const AROUND: usize = 16;
        let is_resin = |at: [f64; 3]| self.vial.in_resin(at);
        far > 0.0
            && !is_resin([x, y, z])
            && ((0..AROUND).any(|i| {
                let (sin, cos) = (TAU * i as f64 / AROUND as f64).sin_cos();
                is_resin([x + far * cos, y + far * sin, z])
            }) || [-far, far].iter().any(|up| is_resin([x, y, z + up])))
    }

    /// Warns of voxels many pixels wide.
    pub(crate) fn coarse_voxels(&self, grid: &VolumeGrid) -> Option<String> {
        let pixels = self.lights.iter().map(|light| light.pixels.pitch_mm[0]);
        let finest = pixels.fold(f64::INFINITY, f64::min);
        (grid.pitch_mm > TOO_COARSE * finest).then(|| {
            format!(
                "a voxel is {} mm wide, a pixel {} mm: the print is predicted on voxels that follow from the job's, and the prediction is rough; lower grid.pitch_mm",
                concise(grid.pitch_mm),
                concise(finest)
            )
        })
    }

    /// Warns of pixels that a part fits into.
    pub(crate) fn coarse(&self, shape: &dyn Shape) -> Vec<String> {
        let [low, high] = shape.bounds_mm();
        let across = (high[0] - low[0]).max(high[1] - low[1]);
        let pitches = self.lights.iter().map(|light| light.pixels.pitch_mm[0]);
        let too_large = pitches.enumerate().filter(|(_, pitch)| *pitch > across);
        too_large
            .map(|(i, pitch)| {
                format!(
                    "light[{i}]: a pixel is {} mm wide, the part {} mm: no pattern gives it its shape; lower \
                     light[{i}].projector's pixel_pitch_mm (numbers, and text without a unit, are in mm)",
                    concise(pitch),
                    concise(across)
                )
            })
            .collect()
    }

    /// Warns of a resin that takes nearly all light before it reaches the middle of the vial.
    pub(crate) fn dark_inside(&self) -> Vec<String> {
        let radius = self.vial.resin_wall().inscribed_radius();
        // Scattered light goes on
        let scatters = |i: usize| {
            self.paths
                .get(i)
                .is_some_and(|path| path.scattering.is_some())
        };
        let lengths = |(i, light): (usize, &Light)| match light.map {
            None if light.resin.pure_radon => (i, 0.0),
            None if scatters(i) => (i, light.resin.absorption_per_mm * radius),
            None => (i, light.resin.attenuation_per_mm * radius),
            _ => (i, 0.0),
        };
        let deep = self.lights.iter().enumerate().map(lengths);
        deep.filter(|&(_, lengths)| lengths > DARK_INSIDE)
            .map(|(i, lengths)| {
                format!(
                    "light[{i}]: from the wall to the middle of the vial are {} mm, {} lengths of attenuation (resin.absorption_per_mm, or attenuation_per_mm where it is given): next to \
                     no light arrives there, and the resin at the wall cures first; with {} per mm it is one length",
                    concise(radius),
                    significant(lengths, 2),
                    significant(1.0 / radius, 2),
                )
            })
            .collect()
    }

    /// Checks the voxels: refuses a target that lies outside the resin or the grid, up to a tolerance, and tells what is beyond the reach.
    pub(crate) fn warnings(
        &self,
        inside: &Volume<f32>,
        labels: &Volume<u8>,
        gray: bool,
        wall_tolerance_mm: f64,
    ) -> Result<Vec<String>> {
        let grid = &labels.grid;
        let [_, ny, nx] = grid.shape;
        let size = (nx * ny).max(1);
        let of_slice = |(iz, (labels, inside)): (usize, (&[u8], &[f32]))| {
            let [mut part, mut stray, mut cut] = [0u64; 3];
            for (i, (&label, &inside)) in labels.iter().zip(inside).enumerate() {
                if !is_part(inside, gray) {
                    continue;
                }
                part += 1;
                if label == label::OUTSIDE {
                    let middle = grid.middle(iz * size + i);
                    let touches = self.touches(middle, wall_tolerance_mm);
                    cut += u64::from(touches);
                    stray += u64::from(!touches);
                }
            }
            [part, stray, cut]
        };
        let slices = labels
            .values
            .chunks(size)
            .zip(inside.values.chunks(size))
            .enumerate();
        let [part, stray, cut] = (slices.par_map(of_slice).into_iter())
            .fold([0; 3], |a: [u64; 3], b| {
                std::array::from_fn(|i| a[i] + b[i])
            });
        let mm3 = |voxels: u64| concise(voxels as f64 * grid.voxel_mm3());
        if part == 0 {
            return Err(self.unseen(inside));
        }
        let mut warnings = Vec::new();
        if stray as f64 > STRAY * part as f64 {
            return Err(Error::config(
                "target",
                format!(
                    "{} of {} mm³ lie outside the resin or the region that counts",
                    mm3(stray),
                    mm3(part)
                ),
                "a target inside the resin: give target.size_mm or target.offset_mm, another vial or grid.region; \
                 target.wall_tolerance_mm lets it reach a little into a wall",
            ));
        } else if stray > 0 {
            warnings.push(format!(
                "{} mm³ of the target lie outside the resin and will not print",
                mm3(stray)
            ));
        }
        if cut > 0 {
            warnings.push(format!(
                "the target touches a wall of the vial: {} of its {} mm³ lie in it, no deeper than {} mm \
                 (target.wall_tolerance_mm), and will not print",
                mm3(cut),
                mm3(part),
                concise(wall_tolerance_mm)
            ));
        }
        let hidden = self.in_bodies(inside, labels, gray);
        if hidden > 0 {
            warnings.push(format!(
                "{} of {} mm³ of the target lie inside [[obstacles]], where there is no resin",
                mm3(hidden),
                mm3(part)
            ));
        }
        warnings.extend(
            self.unreached(inside, gray)
                .map(|unreached| unreached.warning()),
        );
        warnings.extend(self.missed(inside, gray).map(|missed| missed.warning()));
        Ok(warnings)
    }

    /// Whether voxels, and not pixels, are too coarse for a part that none of them sees.
    pub(crate) fn are_coarse(&self, grid: &VolumeGrid) -> bool {
        let pixels = self.lights.iter().map(|light| light.pixels.pitch_mm[0]);
        grid.pitch_mm > COARSE * pixels.fold(f64::INFINITY, f64::min)
    }

    /// The error of a target that fills half of no voxel.
    fn unseen(&self, inside: &Volume<f32>) -> Error {
        let pitch = inside.grid.pitch_mm;
        let touched = inside.values.iter().filter(|inside| **inside > 0.0).count();
        let key = match touched > 0 && self.are_coarse(&inside.grid) {
            true => "grid.pitch_mm",
            false => "target",
        };
        let found = match touched {
            0 => format!(
                "nothing of it is solid in the grid, whose voxels are {} mm wide",
                concise(pitch)
            ),
            _ => format!(
                "no voxel of the grid is half filled by the target, which reaches into {} of {} mm",
                counted(touched, "voxel"),
                concise(pitch)
            ),
        };
        Error::config(
            key,
            found,
            "a target (of an image, bright pixels) that lies in the grid and is larger than a voxel: a larger target.size_mm, \
             another target.mesh_unit, or a smaller grid.pitch_mm",
        )
    }

    /// Voxels of the target whose middle is in a body of the job.
    fn in_bodies(&self, inside: &Volume<f32>, labels: &Volume<u8>, gray: bool) -> u64 {
        if self.obstacles().is_empty() {
            return 0;
        }
        let grid = &labels.grid;
        let hidden = |i: usize| is_part(inside.values[i], gray) && self.in_obstacle(grid.middle(i));
        table(grid.len(), hidden)
            .iter()
            .filter(|hidden| **hidden)
            .count() as u64
    }
}

/// Whether a voxel of so much inside belongs to the part: half of it, or, of a gray target, more than rounding.
pub(crate) fn is_part(inside: f32, gray: bool) -> bool {
    match gray {
        true => inside > GRAY,
        false => inside >= 0.5,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::resolve::optics::tests::{key, shape, spec};
    use crate::optics::vial::{double_tube::DoubleTube, index_matched::IndexMatched};
    use std::path::Path;

    fn gear() -> Box<dyn crate::target::Shape> {
        shape(serde_json::json!({ "phantom": { "gear": { "size_mm": 5.0, "height_mm": 3.0 } } }))
    }

    #[test]
    fn a_resin_too_dark_for_the_middle_of_its_vial_is_told() {
        let warned = |changes: &[&str]| {
            let optics = Optics::new(&spec(changes), Path::new("")).unwrap();
            optics.dark_inside().join("\n")
        };
        assert_eq!(warned(&[]), "");
        let vial = "vial={ index_matched = { radius_mm = 4.0 } }";
        // e^−16 of the light is left after 16 lengths
        let dark = warned(&[vial, "resin.attenuation_per_mm=4.0"]);
        assert!(dark.contains("4 mm, 16 lengths of attenuation"), "{dark}");
        assert!(dark.contains("with 0.25 per mm it is one length"), "{dark}");
        assert_eq!(warned(&[vial, "resin.attenuation_per_mm=0.8"]), "");
    }

    #[test]
    fn what_of_the_target_is_within_a_body_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let body = crate::io::mesh::samples::cuboid([-0.5; 3], [0.5; 3]);
        let bytes = crate::io::mesh::samples::stl_binary(&body);
        std::fs::write(folder.path().join("body.stl"), bytes).unwrap();
        let warned = |changes: &[&str]| {
            let optics = Optics::new(&spec(changes), folder.path()).unwrap();
            // Middles at ±0.25 and ±0.75 mm: eight of them in the body, 1/8 mm³ each
            let grid = VolumeGrid::centered([4, 4, 4], 0.5);
            let inside = Volume::filled(grid.clone(), 1.0f32);
            let labels = Volume::filled(grid, label::PART);
            optics
                .warnings(&inside, &labels, false, 0.0)
                .unwrap()
                .join("\n")
        };
        let text = warned(&["obstacles=[{ mesh = \"body.stl\" }]"]);
        tomolith_core::contains!(text, "1 of 8 mm³ of the target lie inside");
        assert!(!warned(&[]).contains("lie inside [[obstacles]]"));
    }

    #[test]
    fn a_part_that_touches_an_inner_tube_by_microns_is_cut_there_and_that_is_said() {
        let mut optics = Optics::new(&spec(&[]), Path::new("")).unwrap();
        optics.vial = Box::new(DoubleTube::new([4.4, 4.0, 1.0, 0.8], [1.5, 1.5, 1.33]));
        // A ring from 0.99 mm on about a tube of 1 mm: voxels of 5 µm whose middles lie within the tube
        let grid = VolumeGrid {
            shape: [1, 300, 300],
            pitch_mm: 0.005,
            height_mm: 0.005,
            center_mm: [0.75, 0.75, 0.0],
        };
        let inside = Volume::from_fn(grid.clone(), |[x, y, _]| f32::from(x.hypot(y) > 0.99));
        let labels = Volume::from_fn(grid.clone(), |middle| {
            [label::OUTSIDE, label::PART][usize::from(optics.vial.in_resin(middle))]
        });
        let warned = |tolerance_mm| optics.warnings(&inside, &labels, false, tolerance_mm);
        assert!(warned(0.0).is_err() && warned(0.005).is_err());
        let warnings = warned(0.0102).unwrap();
        // A quarter of a ring from 0.99 to 1 mm, 5 µm high: 0.0000781 mm³
        let text = warnings
            .iter()
            .find(|w| w.contains("touches a wall"))
            .unwrap();
        tomolith_core::contains!(text, "7.8625e-5", "0.0102 mm");
    }

    #[test]
    fn a_tolerance_of_the_wall_is_a_hundredth_of_a_voxel_or_what_the_job_says() {
        let grid = VolumeGrid::centered([2, 2, 2], 0.05);
        let tolerance_of = |changes: &[&str]| wall_tolerance_mm(&spec(changes), Some(&grid));
        assert_eq!(tolerance_of(&[]).unwrap(), 0.0005);
        let asked = "target.wall_tolerance_mm=\"3 um\"";
        assert!((tolerance_of(&[asked]).unwrap() - 0.003).abs() < 1e-12);
        let refused = tolerance_of(&["target.wall_tolerance_mm=-1.0"]).unwrap_err();
        assert_eq!(key(refused), "target.wall_tolerance_mm");
        // The gear of 5 mm in a vial of 2.499 mm
        let gear = gear();
        let job = spec(&[]);
        let mut optics = Optics::new(&job, Path::new("")).unwrap();
        let held = |optics: &Optics, far| optics.must_hold(&job, gear.as_ref(), far);
        assert!(held(&optics, 0.0).unwrap().is_empty());
        optics.vial = Box::new(IndexMatched { radius_mm: 2.499 });
        assert_eq!(key(held(&optics, 0.0005).unwrap_err()), "target");
        let text = held(&optics, 0.002).unwrap().join("");
        assert!(text.contains("0.001 mm into the wall"), "{text}");
    }

    #[test]
    fn an_image_beside_the_axis_reaches_as_far_as_its_nearer_edge_and_lights_as_far_as_its_farther_one()
     {
        let optics = |changes: &[&str]| Optics::new(&spec(changes), Path::new("")).unwrap();
        // 128 columns of 0.05 mm reach 3.2 mm to each side; 2.5 mm are left on one
        let (expected, _) = optics(&["light.pixels=[100, 64]"]).reach_mm();
        for change in [
            "light.offset_mm=[0.7, 0]",
            "light.offset_mm=[-0.7, 0.1]",
            "light.selection.columns=[14, 114]",
        ] {
            let (reach, _) = optics(&[change]).reach_mm();
            tomolith_core::near!(reach, expected, 1e-9, "{change}");
        }
        let gear = gear();
        let held = |changes: &[&str]| optics(changes).must_hold(&spec(changes), gear.as_ref(), 0.0);
        // 60 columns reach 1.5 mm to each side, the gear 2.5 mm
        assert_eq!(
            key(held(&["light.pixels=[60, 64]"]).unwrap_err()),
            "light[0].pixels"
        );
        held(&["light.pixels=[60, 64]", "light.offset_mm=[1.01, 0]"]).unwrap();
        // 64 rows reach 1.6 mm up and down, the gear 1.5 mm; half a pixel may be missing
        held(&["light.offset_mm=[0, -0.09]"]).unwrap();
        for (change, blamed) in [
            ("light.offset_mm=[0, 0.13]", "light[0].offset_mm"),
            ("light.selection.rows=[3, 61]", "light[0].selection"),
            ("light.pixels=[128, 50]", "light[0].pixels"),
        ] {
            assert_eq!(key(held(&[change]).unwrap_err()), blamed, "{change}");
        }
    }

    #[test]
    fn a_matrix_is_judged_on_its_own_voxels_only() {
        let matrix = "model={ matrix = { file = \"m.npz\" } }";
        let changes = ["evaluate.refine=1", "evaluate.sub_angles=1", matrix];
        let optics = |spec: &JobSpec| Optics::new(spec, Path::new("/jobs")).unwrap();
        let (finer, coarse) = (spec(&changes[2..]), spec(&changes));
        assert_eq!(
            key(optics(&finer).must_be_evaluated(&finer).unwrap_err()),
            "evaluate"
        );
        optics(&coarse).must_be_evaluated(&coarse).unwrap();
        // The file is looked for in the folder of the job
        let grid = VolumeGrid::centered([2, 2, 2], 0.1);
        let found = optics(&coarse);
        let missing = found.family(&grid).unwrap().check(&found.scene(), &grid);
        let text = missing.unwrap_err().to_string();
        assert!(text.contains("/jobs/m.npz"), "{text}");
    }
}
