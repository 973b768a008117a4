//! `tomolith voxelize` and `tomolith phantom`: parts as voxels, for anybody's use.

use crate::arguments::{Manner, as_option, must_be_a_place, must_end_in};
use crate::screen::{done, say};
use clap::Args;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use tomolith::grid::{PatternGrid, Volume, VolumeGrid};
use tomolith::io::frames::{FrameSet, write_picture};
use tomolith::io::stl::write_stl;
use tomolith::io::volume::{ENDINGS, Values, VolumeFileFormat, write_values};
use tomolith::job::Document;
use tomolith::job::resources::{available_disk_mb, memory_budget_mb, require};
use tomolith::kind::Section;
use tomolith::models::Work;
use tomolith::target::clip::{cut_off, cuts};
use tomolith::target::{
    LONG_MM, MeshUnit, PHANTOMS, Repair, Resolution, Target, TargetSpec, build_under, default_grid,
    voxelize_under,
};
use tomolith::units::concise;
use tomolith::{Error, Result};

const VOXELIZE: &str = "\
Examples:
  tomolith voxelize part.stl --pitch-mm 0.05 --output part.npy
  tomolith voxelize part.stl --shape 200 200 260 --size-mm 12 --binary --output part.vti --json
  tomolith voxelize part.obj --mesh-unit m --pitch-mm 0.1 --output part.npy --save-mesh repaired.stl";

const PHANTOM: &str = "\
Examples:
  tomolith phantom gear --pitch-mm 0.05 --output gear.npy
  tomolith phantom gear --pitch-mm 0.05 --shape 128 128 1 --clip --output one-slice.npy
  tomolith phantom gyroid --set size_mm=4 --set cells=2 --pitch-mm 0.02 --output slices.png
`tomolith kinds target.phantom` lists the phantoms and their parameters";

/// What both commands ask for.
#[derive(Debug, Args)]
pub(crate) struct Sampling {
    /// Edge of a voxel, mm; without a shape there is a margin of a tenth of the part, at least 4 voxels, on each side
    #[arg(long, value_name = "MM", required_unless_present = "shape")]
    pitch_mm: Option<f64>,
    /// Voxels along x, y and z; the pitch follows from the part, unless it is given too
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"])]
    shape: Option<Vec<usize>>,
    /// Go on when a given shape and pitch cut the part: what lies outside is lost
    #[arg(long, requires = "shape")]
    clip: bool,
    /// Longest edge of the part, mm; true size when left out
    #[arg(long, value_name = "MM")]
    size_mm: Option<f64>,
    /// Angles about x, y and z, degrees
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_hyphen_values = true)]
    rotate_deg: Option<Vec<f64>>,
    /// 1 where at least half of the voxel is inside, else 0, in place of the inside fraction
    #[arg(long)]
    binary: bool,
    /// New file: .npy [z, y, x], .vti for ParaView, .nrrd for 3D Slicer, .tif for ImageJ, .ome.zarr for napari, or .png with all slices from low z to high z side by side
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

#[derive(Debug, Args)]
#[command(after_help = VOXELIZE)]
pub(crate) struct VoxelizeArguments {
    /// Mesh: .stl, .obj, .ply or .3mf
    mesh: PathBuf,
    /// How far repairs may go: `safe`, or `force` for flaws whose repair is a guess
    #[arg(long, value_name = "HOW", value_parser = ["safe", "force"], default_value = "safe")]
    repair: String,
    /// Unit of the numbers in the file: mm (default), um, cm, m or inch; a .3mf file states its own
    #[arg(long, value_name = "UNIT", value_parser = ["um", "mm", "cm", "m", "inch"])]
    mesh_unit: Option<String>,
    /// Also save the mesh as it is voxelized, repaired and placed, in mm: a new binary .stl
    #[arg(long, value_name = "FILE")]
    save_mesh: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) sampling: Sampling,
}

#[derive(Debug, Args)]
#[command(after_help = PHANTOM)]
pub(crate) struct PhantomArguments {
    /// Its name, for example `gear`
    name: String,
    /// A parameter: `--set teeth=16` (repeatable)
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    pub(crate) sampling: Sampling,
}

pub(crate) fn voxelize(given: &VoxelizeArguments, work: &Work) -> Result<()> {
    let unit = |name: &String| MeshUnit::ALL.into_iter().find(|unit| unit.name() == name);
    if let Some(file) = &given.save_mesh {
        must_end_in("--save-mesh", file, &["stl"])?;
        must_be_a_place("--save-mesh", file)?;
    }
    let spec = TargetSpec {
        mesh: Some(given.mesh.clone()),
        mesh_unit: given.mesh_unit.as_ref().and_then(unit),
        repair: (given.repair == "force").then_some(Repair::Force),
        ..TargetSpec::default()
    };
    sample(spec, &given.sampling, given.save_mesh.as_deref(), work)
}

/// `tomolith phantom`.
pub(crate) fn phantom(given: &PhantomArguments, work: &Work) -> Result<()> {
    // The name is looked up first, so that a slip in it is named as such
    let named = Section::new("phantom", Value::String(given.name.clone())).kind(PHANTOMS);
    named.map_err(|mut error| {
        if let Error::Config { key, .. } = &mut error {
            *key = "NAME".to_owned();
        }
        error
    })?;
    let mut table = Document::toml("command line", "")?;
    given
        .set
        .iter()
        .try_for_each(|assignment| table.set(assignment))?;
    let spec = TargetSpec {
        phantom: Some(json!({ given.name.as_str(): table.root })),
        ..TargetSpec::default()
    };
    sample(spec, &given.sampling, None, work)
}

fn sample(mut spec: TargetSpec, given: &Sampling, save: Option<&Path>, work: &Work) -> Result<()> {
    let kind = Kind::of(&given.output)?;
    must_be_a_place("--output", &given.output)?;
    spec.size_mm = given.size_mm.map(tomolith::units::Mm);
    spec.rotate_deg = given.rotate_deg.as_ref().map(|r| [r[0], r[1], r[2]]);
    let shape = build_under(&spec, Path::new(""), "target", work).map_err(as_target_option)?;
    let question = spec.ask_for_unit(shape.bounds_mm(), EXPECTED_MM);
    let question = question.map(|text| {
        text.replace("set target.mesh_unit = ", "give --mesh-unit ")
            .replace("set target.size_mm = ", "give --size-mm ")
    });
    let grid = grid_of(given, shape.bounds_mm()).map_err(|e| e.asking(question.as_deref()))?;
    must_be_written(given, kind, &grid).map_err(|e| e.asking(question.as_deref()))?;
    // The inside fraction, what is written of it, labels
    let needed_mb = (grid.len() as u64).saturating_mul(9) / 1_000_000;
    let fewer = "fewer voxels: a larger --pitch-mm, a smaller --shape";
    require(
        "--pitch-mm",
        "memory for the voxels",
        needed_mb,
        memory_budget_mb(None),
        fewer,
    )
    .map_err(|e| e.asking(question.as_deref()))?;
    let mut target = voxelize_under(shape.as_ref(), &spec.name(), &grid, work)?;
    let part = (0..grid.len()).filter(|&i| target.is_part(i)).count();
    if given.binary {
        target.inside.values = (0..grid.len())
            .map(|i| f32::from(u8::from(target.is_part(i))))
            .collect();
    }
    // Of what is written
    let written = target.inside.values.iter().map(|&v| f64::from(v));
    let volume_mm3 = written.sum::<f64>() * grid.voxel_mm3();
    write(&given.output, kind, &target, given.binary, work)?;
    let mut warnings = shape.warnings();
    let saved = match (save, &shape.meshes()[..]) {
        (Some(file), [mesh]) => {
            let corners: Vec<[f32; 3]> =
                mesh.vertices.iter().map(|p| p.map(|v| v as f32)).collect();
            write_stl(file, &spec.name(), &corners, &mesh.triangles)?;
            save
        }
        (Some(file), _) => {
            warnings.push(format!(
                "{} is not written: negative volumes are taken out of the voxels, not of the mesh",
                file.display()
            ));
            None
        }
        (None, _) => None,
    };
    let [nz, ny, nx] = grid.shape;
    let exact = shape.volume_mm3();
    warnings.extend(question);
    if part == 0 {
        let text = "no voxel is at least half inside: the voxels are too large for this part";
        warnings.insert(0, text.to_owned());
    }
    let lost = cut_off(&grid, shape.as_ref(), work)?;
    warnings.extend(lost.map(|lost| {
        let percent = (1000.0 * lost).round() / 10.0;
        format!("the grid cuts the part: {percent} % of its volume is lost")
    }));
    let found = json!({
        "file": given.output, "part": target.name, "shape_zyx": grid.shape, "pitch_mm": grid.pitch_mm,
        "center_xyz_mm": grid.center_mm, "part_voxels": part, "volume_mm3": volume_mm3, "exact_volume_mm3": exact,
        "lost_share": lost, "mesh_file": saved, "warnings": warnings,
    });
    done(given.manner, found, || {
        let exact = exact.map_or(String::new(), |exact| {
            format!(" (exactly {} mm³)", concise(exact))
        });
        say(&format!(
            "{:>10} {nx} × {ny} × {nz} voxels of {} mm",
            "grid",
            concise(grid.pitch_mm)
        ));
        say(&format!(
            "{:>10} {part} voxels, {} mm³{exact}",
            "part",
            concise(volume_mm3)
        ));
        warnings
            .iter()
            .for_each(|text| say(&format!("{:>10} {text}", "warning")));
        for file in std::iter::once(given.output.as_path()).chain(saved) {
            say(&format!("{:>10} {}", "written", file.display()));
        }
    });
    Ok(())
}

/// The grid of the options: round the part, or exactly so many voxels of this edge about its middle.
fn grid_of(given: &Sampling, bounds: [[f64; 3]; 2]) -> Result<VolumeGrid> {
    // The pitch alone says whether it can be used
    let from_pitch = |pitch| default_grid(bounds, Resolution::Pitch(pitch)).map_err(as_option);
    match (&given.shape, given.pitch_mm) {
        (Some(n), Some(pitch_mm)) => {
            if n.iter().any(|n| !(1..=65536).contains(n)) {
                return Err(Error::config(
                    "--shape",
                    format!("{n:?}"),
                    "three whole numbers from 1 to 65536",
                ));
            }
            let grid = VolumeGrid {
                shape: [n[2], n[1], n[0]],
                ..from_pitch(pitch_mm)?
            };
            if cuts(&grid, bounds) && !given.clip {
                let box_of = |[low, high]: [[f64; 3]; 2]| {
                    let [x, y, z] = [0, 1, 2].map(|i| concise(high[i] - low[i]));
                    format!("{x} × {y} × {z} mm")
                };
                return Err(Error::config(
                    "--shape",
                    format!(
                        "a grid of {} cuts the part, which is {}",
                        box_of(grid.bounds_mm()),
                        box_of(bounds)
                    ),
                    "a grid that holds the part, or --clip to lose what lies outside",
                ));
            }
            Ok(grid)
        }
        (Some(n), None) => {
            let shape = Resolution::Shape([n[0], n[1], n[2]]);
            default_grid(bounds, shape).map_err(as_option)
        }
        (None, pitch) => from_pitch(pitch.unwrap_or_default()),
    }
}

/// Longest edges of parts for which nobody asks whether the file has another unit, mm.
const EXPECTED_MM: [f64; 2] = [0.05, LONG_MM];

/// Largest file that a pitch alone makes, MB: what is larger is more often a slip of a unit than meant.
const LARGEST_MB: u64 = 2000;

/// Refuses a volume that the disk does not hold, and a large one whose voxels nobody counted with `--shape`.
fn must_be_written(given: &Sampling, kind: Kind, grid: &VolumeGrid) -> Result<()> {
    if kind == Kind::Picture {
        return Ok(());
    }
    let bytes = if given.binary { 1 } else { 4 };
    let needed_mb = (grid.len() as u64).saturating_mul(bytes) / 1_000_000;
    let [nz, ny, nx] = grid.shape;
    if given.shape.is_none() && needed_mb > LARGEST_MB {
        let smaller = match !given.binary && needed_mb / 4 <= LARGEST_MB {
            true => "a larger --pitch-mm, --binary,",
            false => "a larger --pitch-mm,",
        };
        return Err(Error::config(
            "--pitch-mm",
            format!("{nx} × {ny} × {nz} voxels, a file of {needed_mb} MB"),
            format!(
                "at most {LARGEST_MB} MB: {smaller} or --shape {nx} {ny} {nz} if that many are meant"
            ),
        ));
    }
    let smaller = "fewer voxels, or a folder on another disk";
    let disk_mb = available_disk_mb(&given.output);
    require(
        "--output",
        "disk for the voxels",
        needed_mb,
        disk_mb,
        smaller,
    )
}

/// An error about a key of the target, as one about the option where it has one.
fn as_target_option(error: Error) -> Error {
    let is_option =
        |key: &str| ["target.mesh_unit", "target.size_mm", "target.rotate_deg"].contains(&key);
    match &error {
        Error::Config { key, .. } if is_option(key) => as_option(error),
        _ => error,
    }
}

/// What a file name asks for.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Volume,
    Picture,
}

impl Kind {
    pub(crate) fn of(path: &Path) -> Result<Self> {
        if VolumeFileFormat::of(path).is_some() {
            return Ok(Kind::Volume);
        }
        match path.extension() {
            Some(extension) if extension.eq_ignore_ascii_case("png") => Ok(Kind::Picture),
            _ => Err(Error::config(
                "--output",
                format!("`{}` has another ending", path.display()),
                format!("a file name ending in .png, {ENDINGS}"),
            )),
        }
    }
}

fn write(path: &Path, kind: Kind, target: &Target, binary: bool, work: &Work) -> Result<()> {
    let Volume { grid, values } = &target.inside;
    if kind == Kind::Volume && binary {
        let bytes: Vec<u8> = values.iter().map(|&v| v as u8).collect();
        return write_values(path, "inside", grid, Values::U8(&bytes), work);
    }
    write_volume(path, kind, "inside", &target.inside, work)
}

/// Values as they are; in a picture, from 0 (black) to 1 (white).
pub(crate) fn write_volume(
    path: &Path,
    kind: Kind,
    name: &str,
    volume: &Volume<f32>,
    work: &Work,
) -> Result<()> {
    match kind {
        Kind::Volume => {
            let values = Values::F32(&volume.values);
            write_values(path, name, &volume.grid, values, work)
        }
        Kind::Picture => write_slices(path, volume),
    }
}

/// All slices side by side in rows, low z first, +y on top.
fn write_slices(path: &Path, volume: &Volume<f32>) -> Result<()> {
    let [nz, ny, nx] = volume.grid.shape;
    let across = (nz as f64 * ny as f64 / nx as f64)
        .sqrt()
        .ceil()
        .clamp(1.0, nz as f64) as usize;
    let mut sheet = PatternGrid::full_turn(
        1,
        0.0,
        nz.div_ceil(across) * ny,
        across * nx,
        volume.grid.pitch_mm,
    );
    sheet.frame_arc = 0.0;
    let mut levels = vec![0u16; sheet.len()];
    for (i, &value) in volume.values.iter().enumerate() {
        let (z, y, x) = (i / (nx * ny), i / nx % ny, i % nx);
        let (row, column) = (z / across * ny + ny - 1 - y, z % across * nx + x);
        levels[row * sheet.columns + column] = (value.clamp(0.0, 1.0) * 255.0).round() as u16;
    }
    let set = FrameSet {
        light: None,
        grid: &sheet,
        bits: 8,
        full_scale: 1.0,
        channel: None,
        values: &levels,
    };
    write_picture(path, &set)
}
