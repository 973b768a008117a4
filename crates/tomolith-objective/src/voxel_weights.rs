//! Where an objective looks, and how closely: what every entry of `[[objectives]]` may have besides its kind.
//!
//! ```toml
//! [[objectives]]
//! bclp = { epsilon = 0.0 }
//! weight = 0.5                                       # ω of the sum
//! region = { of = "part", radius_mm = [0.0, 2.0] }   # voxels elsewhere do not count
//! weights = { void = 2.0, buffer_void_mm = 0.1 }     # w per voxel, times the kind's own
//! tolerance = { part = 0.05, file = "eps.npy" }      # ε per voxel, widens every band on both sides
//! response = { logistic = { steepness = 25 } }       # M of this objective alone
//! ```
//!
//! **Equation** w_v = w(role)·w(file)·Π w(region)·b_v·g_v with b_v = 0 in the buffer and
//!
//! ```text
//! g_v = 1/(1 + (|∇f|_v/edge)²)            central differences, 1/mm; gray targets only
//! ε_v = ε(role) + ε(file) + Σ ε(region)   bands become [lower − ε, upper + ε]
//! ```
//!
//! Product and sum are over the entries of `regions` that hold the voxel; both ends of their ranges belong to them.
//!
//! A buffer of the part is its erosion: part voxels within that distance of a void voxel do not count. A buffer of the void
//! is the dilation of the part. At an edge of a gray target no dose has the wanted step; g takes weight from there, half
//! of it where the gradient is `edge`.
//!
//! **Source** w and ε as fields: Li et al., Additive Manufacturing 94 (2024) 104447, table 2 and figures 8, 9; the weighted sum
//! their section 2.3.1; the buffer: Bhattacharya, Toombs and Taylor, Additive Manufacturing 47 (2021) 102299.
//!
//! **Shapes** files are `.npy` arrays `[z, y, x]` of the optimization's grid, of any number type. **Cost** 8 bytes per voxel
//! more in every pass (12 in place of a label byte).

use super::buffer::near_the_other_kind;
use crate::preset::not_negative;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::path::{Path, PathBuf};
use tomolith_core::dose::DoseLayout;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::kind::Section;
use tomolith_core::parallel::{elements, table};
use tomolith_core::target::{Target, label};
use tomolith_core::units::{Mm, exact};
use tomolith_io::npy::{place_of, read_volume};

/// Weight and tolerance per element of the dose field's species; either may be empty for none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VoxelWeights {
    /// Factor of each voxel's weight.
    pub weight: Vec<f32>,
    /// What each voxel's band is widened by on either side, in units of the response.
    pub tolerance: Vec<f32>,
}

/// What an entry has besides its kind.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Common {
    /// ω: factor of this objective in the sum, 0 or above (default 1)
    pub weight: f64,
    /// Which voxels count (default: all)
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<RegionSpec>,
    /// Weight per voxel (default: 1 everywhere)
    #[serde(skip_serializing_if = "Option::is_none")]
    pub weights: Option<WeightsSpec>,
    /// Tolerance per voxel, in units of the response (default: 0 everywhere)
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<ToleranceSpec>,
    /// Response of this objective, one kind (default: the job's)
    #[serde(skip_serializing_if = "Option::is_none")]
    pub response: Option<Value>,
}

impl Default for Common {
    fn default() -> Self {
        Common {
            weight: 1.0,
            region: None,
            weights: None,
            tolerance: None,
            response: None,
        }
    }
}

/// The keys of [`Common`].
const KEYS: [&str; 5] = ["weight", "region", "weights", "tolerance", "response"];

/// Which voxels are meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Of {
    /// Part and void.
    #[default]
    All,
    /// The part.
    Part,
    /// The void.
    Void,
}

/// A region: voxels that all given keys hold.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct RegionSpec {
    /// "all" (default), "part" or "void"
    pub of: Of,
    /// Distance from the axis, [from, to] mm
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_mm: Option<[Mm; 2]>,
    /// Height, [from, to] mm
    #[serde(skip_serializing_if = "Option::is_none")]
    pub z_mm: Option<[Mm; 2]>,
    /// A mask: voxels that are not 0 count
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
}

/// Weight per voxel.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WeightsSpec {
    /// Weight of part voxels, 0 or above (default 1)
    pub part: f64,
    /// Weight of void voxels, 0 or above (default 1)
    pub void: f64,
    /// Weights per voxel, 0 or above
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
    /// Factors of the weight in regions
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub regions: Vec<RegionValue>,
    /// Part voxels this near to the void do not count, mm (default 0)
    pub buffer_part_mm: Mm,
    /// Void voxels this near to the part do not count, mm (default 0)
    pub buffer_void_mm: Mm,
    /// Gray targets: gradient at which a voxel has half its weight, 1/mm, above 0 (default: none loses any)
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edge_per_mm: Option<f64>,
}

impl Default for WeightsSpec {
    fn default() -> Self {
        WeightsSpec {
            part: 1.0,
            void: 1.0,
            file: None,
            regions: Vec::new(),
            buffer_part_mm: Mm(0.0),
            buffer_void_mm: Mm(0.0),
            edge_per_mm: None,
        }
    }
}

/// Tolerance per voxel.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ToleranceSpec {
    /// In the part, 0 or above (default 0)
    pub part: f64,
    /// In the void, 0 or above (default 0)
    pub void: f64,
    /// Added per voxel, 0 or above
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
    /// Added in regions
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub regions: Vec<RegionValue>,
}

/// A number of the voxels in a region.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RegionValue {
    /// Distance from the axis, [from, to] mm (default: any)
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub radius_mm: Option<[Mm; 2]>,
    /// Height, [from, to] mm (default: any)
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z_mm: Option<[Mm; 2]>,
    /// The factor of the weight there, or the tolerance that is added there; 0 or above
    pub value: f64,
}

/// The voxels that weights are laid on.
#[derive(Clone, Copy)]
pub struct Ground<'a> {
    /// Where the voxels lie in the model's dose field.
    pub layout: &'a DoseLayout,
    /// Label of each voxel, array order.
    pub labels: &'a Volume<u8>,
    /// The target on the same grid.
    pub target: &'a Target,
    /// The folder that files begin in.
    pub base: &'a Path,
}

impl Common {
    /// Takes an entry apart: what every one may have, and the section of its kind.
    ///
    /// # Errors
    /// [`Error::Config`] with the key path of what is unknown or out of range.
    pub fn split(mut section: Section) -> Result<(Common, Section)> {
        let mut own = serde_json::Map::new();
        if let Some(map) = section.value.as_object_mut() {
            for key in KEYS {
                own.extend(map.remove(key).map(|value| (key.to_owned(), value)));
            }
        }
        if let Some(Value::String(of)) = own.get("region").cloned() {
            own.insert("region".to_owned(), serde_json::json!({ "of": of }));
        }
        let common: Common = Section::new(section.path.clone(), Value::Object(own)).parse()?;
        common.validate().map_err(|e| e.under(&section.path))?;
        Ok((common, section))
    }

    fn validate(&self) -> Result<()> {
        not_negative("weight", self.weight)?;
        if let Some(region) = &self.region {
            ascending("region.radius_mm", region.radius_mm)?;
            ascending("region.z_mm", region.z_mm)?;
        }
        if let Some(weights) = &self.weights {
            for (key, value) in [
                ("weights.part", weights.part),
                ("weights.void", weights.void),
                ("weights.buffer_part_mm", weights.buffer_part_mm.0),
                ("weights.buffer_void_mm", weights.buffer_void_mm.0),
            ] {
                not_negative(key, value)?;
            }
            each_in_range("weights.regions", &weights.regions)?;
            if let Some(edge) = weights.edge_per_mm {
                super::preset::positive("weights.edge_per_mm", edge)?;
            }
        }
        if let Some(tolerance) = &self.tolerance {
            not_negative("tolerance.part", tolerance.part)?;
            not_negative("tolerance.void", tolerance.void)?;
            each_in_range("tolerance.regions", &tolerance.regions)?;
        }
        Ok(())
    }

    /// Refuses files that cannot be used on a grid; to be called before any work.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of the file.
    pub fn check_files(&self, grid: &VolumeGrid, base: &Path) -> Result<()> {
        let files = [
            (
                "region.file",
                self.region.as_ref().and_then(|r| r.file.as_ref()),
            ),
            (
                "weights.file",
                self.weights.as_ref().and_then(|w| w.file.as_ref()),
            ),
            (
                "tolerance.file",
                self.tolerance.as_ref().and_then(|t| t.file.as_ref()),
            ),
        ];
        for (key, file) in files {
            if let Some(file) = file {
                read(key, &base.join(file), grid)?;
            }
        }
        Ok(())
    }

    /// The same without what belongs to the grid or the target at hand: files, numbers of regions, and edges of gray targets. For a trial on
    /// a few voxels.
    #[must_use]
    pub fn without_fields(mut self) -> Self {
        self.region.iter_mut().for_each(|r| r.file = None);
        if let Some(tolerance) = &mut self.tolerance {
            tolerance.file = None;
            tolerance.regions.clear();
        }
        if let Some(weights) = &mut self.weights {
            weights.file = None;
            weights.regions.clear();
            weights.edge_per_mm = None;
        }
        self
    }

    /// Whether the tolerance of a voxel is known without a file and its place.
    #[must_use]
    pub fn knows_tolerance(&self) -> bool {
        let is_known = |t: &ToleranceSpec| t.file.is_none() && t.regions.is_empty();
        self.tolerance.as_ref().is_none_or(is_known)
    }

    /// Whether weights or bands differ from voxel to voxel.
    #[must_use]
    pub fn has_fields(&self) -> bool {
        self.region.is_some() || self.weights.is_some() || self.tolerance.is_some()
    }

    /// Weight and tolerance of every element of the dose field.
    ///
    /// # Errors
    /// [`Error::Config`] for a file that cannot be used, or an edge weight for a target that is not gray.
    pub fn voxel_weights(&self, ground: &Ground<'_>) -> Result<VoxelWeights> {
        let cut = ground.layout.cut_voxels();
        if cut.is_empty() {
            return self.on(ground);
        }
        // Outside cells are void and inside cells, which lie behind the voxels, are part
        let labeled = |role: u8| {
            let mut labels = ground.labels.clone();
            for &voxel in &cut {
                let label = &mut labels.values[voxel];
                *label = if *label == label::OUTSIDE {
                    *label
                } else {
                    role
                };
            }
            labels
        };
        let (void, part) = (labeled(label::VOID), labeled(label::PART));
        let mut voxel_weights = self.on(&Ground {
            labels: &void,
            ..*ground
        })?;
        let inside = self.on(&Ground {
            labels: &part,
            ..*ground
        })?;
        for (field, inside) in [
            (&mut voxel_weights.weight, inside.weight),
            (&mut voxel_weights.tolerance, inside.tolerance),
        ] {
            let voxels = field.len().min(ground.layout.voxels());
            field.truncate(voxels);
            field.extend(&inside[voxels..]);
        }
        Ok(voxel_weights)
    }

    /// As [`voxel_weights`](Self::voxel_weights), both cells of a voxel alike.
    fn on(&self, ground: &Ground<'_>) -> Result<VoxelWeights> {
        let mut weight = match &self.weights {
            None => None,
            Some(weights) => Some(weights.field(ground)?),
        };
        if let Some(region) = &self.region {
            let counts = region.mask(ground)?;
            let weight = weight.get_or_insert_with(|| vec![1.0; counts.len()]);
            elements(weight, |i, w| *w = if counts[i] { *w } else { 0.0 });
        }
        let tolerance = match &self.tolerance {
            None => None,
            Some(tolerance) => Some(tolerance.field(ground)?),
        };
        let in_field = |values: Option<Vec<f32>>| {
            values.map_or_else(Vec::new, |values| {
                ground.layout.field_of(&Volume {
                    grid: ground.layout.grid.clone(),
                    values,
                })
            })
        };
        Ok(VoxelWeights {
            weight: in_field(weight),
            tolerance: in_field(tolerance),
        })
    }
}

impl RegionSpec {
    fn mask(&self, ground: &Ground<'_>) -> Result<Vec<bool>> {
        let grid = &ground.layout.grid;
        let file = self
            .file
            .as_ref()
            .map(|f| read("region.file", &ground.base.join(f), grid))
            .transpose()?;
        let labels = &ground.labels.values;
        Ok(table(labels.len(), |i| {
            let of = match self.of {
                Of::All => true,
                Of::Part => labels[i] == label::PART,
                Of::Void => labels[i] == label::VOID,
            };
            of && holds([self.radius_mm, self.z_mm], grid, i)
                && file.as_ref().is_none_or(|f| f[i] != 0.0)
        }))
    }
}

impl WeightsSpec {
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn field(&self, ground: &Ground<'_>) -> Result<Vec<f32>> {
        let labels = &ground.labels.values;
        let mut field = by_role(labels, self.part as f32, self.void as f32);
        if let Some(file) = &self.file {
            let factors = read("weights.file", &ground.base.join(file), &ground.layout.grid)?;
            elements(&mut field, |i, w| *w *= factors[i]);
        }
        for region in &self.regions {
            region.each_voxel(&ground.layout.grid, &mut field, |w, factor| *w *= factor);
        }
        for (role, distance) in [
            (label::PART, self.buffer_part_mm.0),
            (label::VOID, self.buffer_void_mm.0),
        ] {
            if distance > 0.0 {
                let near = near_the_other_kind(ground.target, distance);
                elements(&mut field, |i, w| {
                    if labels[i] == role && near[i] {
                        *w = 0.0;
                    }
                });
            }
        }
        if let Some(edge) = self.edge_per_mm {
            if !ground.target.gray {
                return Err(Error::config(
                    "weights.edge_per_mm",
                    "the target is not gray",
                    "buffer_part_mm and buffer_void_mm for the surface of a part",
                ));
            }
            let steepness = gradients(&ground.target.inside);
            elements(&mut field, |i, w| {
                *w *= (1.0 / (1.0 + (steepness[i] / edge).powi(2))) as f32;
            });
        }
        Ok(field)
    }
}

impl ToleranceSpec {
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn field(&self, ground: &Ground<'_>) -> Result<Vec<f32>> {
        let mut field = by_role(&ground.labels.values, self.part as f32, self.void as f32);
        if let Some(file) = &self.file {
            let more = read(
                "tolerance.file",
                &ground.base.join(file),
                &ground.layout.grid,
            )?;
            elements(&mut field, |i, e| *e += more[i]);
        }
        for region in &self.regions {
            region.each_voxel(&ground.layout.grid, &mut field, |e, more| *e += more);
        }
        Ok(field)
    }
}

impl RegionValue {
    /// Does `change` with the voxels of the region and its number.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn each_voxel(
        &self,
        grid: &VolumeGrid,
        field: &mut [f32],
        change: impl Fn(&mut f32, f32) + Sync,
    ) {
        let value = self.value as f32;
        elements(field, |i, voxel| {
            if holds([self.radius_mm, self.z_mm], grid, i) {
                change(voxel, value);
            }
        });
    }
}

/// Whether a voxel lies in ranges of the distance from the axis and of the height.
fn holds([radius_mm, z_mm]: [Option<[Mm; 2]>; 2], grid: &VolumeGrid, i: usize) -> bool {
    let [_, ny, nx] = grid.shape;
    let within =
        |range: Option<[Mm; 2]>, v: f64| range.is_none_or(|[low, high]| v >= low.0 && v <= high.0);
    within(radius_mm, grid.x(i % nx).hypot(grid.y(i / nx % ny)))
        && within(z_mm, grid.z(i / (nx * ny)))
}

/// Refuses a range whose ends are not in order.
fn ascending(key: &str, range: Option<[Mm; 2]>) -> Result<()> {
    match range.filter(|[low, high]| low.0 >= high.0) {
        Some([low, high]) => Err(Error::config(
            key,
            format!("from {} to {}", exact(low.0), exact(high.0)),
            "[from, to] with from < to",
        )),
        None => Ok(()),
    }
}

/// Refuses numbers and ranges of regions that are out of range.
fn each_in_range(key: &str, regions: &[RegionValue]) -> Result<()> {
    regions.iter().enumerate().try_for_each(|(i, region)| {
        not_negative(&format!("{key}[{i}].value"), region.value)?;
        ascending(&format!("{key}[{i}].radius_mm"), region.radius_mm)?;
        ascending(&format!("{key}[{i}].z_mm"), region.z_mm)
    })
}

/// A number per role, 0 for voxels that do not count.
fn by_role(labels: &[u8], part: f32, void: f32) -> Vec<f32> {
    table(labels.len(), |i| match labels[i] {
        label::PART => part,
        label::VOID => void,
        _ => 0.0,
    })
}

/// |∇f| of every voxel, 1/mm: central differences, one-sided at the faces of the grid.
fn gradients(volume: &Volume<f32>) -> Vec<f64> {
    let [nz, ny, nx] = volume.grid.shape;
    let along = |i: usize, at: usize, n: usize, stride: usize| {
        let (back, on) = (usize::from(at > 0), usize::from(at + 1 < n));
        if back + on == 0 {
            return 0.0;
        }
        let rise =
            f64::from(volume.values[i + on * stride]) - f64::from(volume.values[i - back * stride]);
        rise / ((back + on) as f64 * volume.grid.pitch_mm)
    };
    table(volume.values.len(), |i| {
        let (x, y, z) = (i % nx, i / nx % ny, i / (nx * ny));
        along(i, x, nx, 1)
            .hypot(along(i, y, ny, nx))
            .hypot(along(i, z, nz, nx * ny))
    })
}

/// Numbers per voxel from a file, 0 or above.
fn read(key: &str, path: &Path, grid: &VolumeGrid) -> Result<Vec<f32>> {
    let (shape, values) = read_volume(path).map_err(|e| match e {
        Error::Format {
            path,
            found,
            accepted,
        } => Error::config(key, format!("{}: {found}", path.display()), accepted),
        _ => Error::config(key, e.to_string(), "a file that can be read"),
    })?;
    if shape != grid.shape {
        return Err(Error::config(
            key,
            format!("{}: shape {shape:?}", path.display()),
            format!("the shape of the grid, {:?} [z, y, x]", grid.shape),
        ));
    }
    if let Some(i) = values.iter().position(|v| !(*v >= 0.0 && v.is_finite())) {
        let at = place_of(i, &shape);
        return Err(Error::config(
            key,
            format!(
                "{}: holds {} at {at}, as [z, y, x]",
                path.display(),
                values[i]
            ),
            "finite numbers, 0 or above",
        ));
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check;
    use crate::{OBJECTIVES, Objective, ObjectiveInput};
    use std::sync::Arc;
    use tomolith_core::check::small::SmallModel;
    use tomolith_core::dose::Run;
    use tomolith_core::field::{Field, HostField};
    use tomolith_core::response::Identity;
    use tomolith_io::npy::write_volume;

    struct Room {
        layout: DoseLayout,
        labels: Volume<u8>,
        target: Target,
    }

    fn row(inside: &[f32], gray: bool) -> Room {
        let grid = VolumeGrid::centered([1, 1, inside.len()], 0.5);
        let target = Target {
            name: "row".into(),
            inside: Volume {
                grid: grid.clone(),
                values: inside.to_vec(),
            },
            gray,
        };
        let labels = tomolith_core::target::label_voxels(&target, |_| true);
        Room {
            layout: DoseLayout::new("dose", grid, 0),
            labels,
            target,
        }
    }

    impl Room {
        fn ground<'a>(&'a self, base: &'a Path) -> Ground<'a> {
            Ground {
                layout: &self.layout,
                labels: &self.labels,
                target: &self.target,
                base,
            }
        }

        fn array(&self, field: Vec<f32>) -> Vec<f32> {
            self.layout.volume_of(&field).values
        }
    }

    fn common(json: Value) -> Common {
        let (common, rest) = Common::split(Section::new("objectives[0]", json)).unwrap();
        assert!(rest.value.as_object().unwrap().keys().all(|k| k == "bclp"));
        common
    }

    fn build(kind: &str, json: Value, room: &Room) -> Box<dyn Objective<HostField>> {
        let input = ObjectiveInput {
            layout: &room.layout,
            labels: &room.labels,
            target: &room.target,
            response: Arc::new(Identity),
        };
        let row = OBJECTIVES.iter().find(|row| row.name == kind).unwrap();
        (row.build)(&Section::new("objective", json))
            .unwrap()
            .make(&input)
            .unwrap()
    }

    #[test]
    fn weights_by_role_buffer_region_and_file() {
        let room = row(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], false);
        let folder = tempfile::tempdir().unwrap();
        let factors = Volume {
            grid: room.layout.grid.clone(),
            values: vec![1.0f32, 2.0, 3.0, 4.0, 5.0, 6.0],
        };
        write_volume(&folder.path().join("w.npy"), &factors, &Run::new()).unwrap();
        let ground = room.ground(folder.path());
        let weight = |json: Value| room.array(common(json).voxel_weights(&ground).unwrap().weight);
        assert_eq!(
            weight(serde_json::json!({"weights": {"part": 0.5, "void": 2.0}})),
            [2.0, 2.0, 2.0, 0.5, 0.5, 0.5]
        );
        // Voxels of 0.5 mm: erosion by 0.5 mm takes the first part voxel, dilation by 1 mm two of the void
        let buffer =
            serde_json::json!({"weights": {"buffer_part_mm": 0.5, "buffer_void_mm": "1 mm"}});
        assert_eq!(weight(buffer), [1.0, 0.0, 0.0, 0.0, 1.0, 1.0]);
        // Centers at ±0.25, ±0.75, ±1.25 mm; the second region lies in the first
        let regions = serde_json::json!([{"radius_mm": [0.0, 1.0], "value": 2.0}, {"radius_mm": [0.0, 0.5], "value": 1.5}]);
        assert_eq!(
            weight(serde_json::json!({"weights": {"void": 0.5, "regions": regions}})),
            [0.5, 1.0, 1.5, 3.0, 2.0, 1.0]
        );
        let tolerance = serde_json::json!({"tolerance": {"part": 0.25, "regions": regions}});
        let tolerance = common(tolerance).voxel_weights(&ground).unwrap().tolerance;
        assert_eq!(room.array(tolerance), [0.0, 2.0, 3.5, 3.75, 2.25, 0.25]);
        let file = serde_json::json!({"weights": {"file": "w.npy"}, "region": "void"});
        assert_eq!(weight(file), [1.0, 2.0, 3.0, 0.0, 0.0, 0.0]);
        assert_eq!(
            weight(serde_json::json!({"region": {"radius_mm": [0.5, 1.0]}})),
            [0.0, 1.0, 0.0, 0.0, 1.0, 0.0]
        );
        assert_eq!(
            weight(serde_json::json!({"region": {"z_mm": [0.1, 1.0]}})),
            [0.0; 6]
        );
        assert_eq!(
            common(serde_json::json!({"bclp": {}}))
                .voxel_weights(&ground)
                .unwrap(),
            VoxelWeights::default()
        );
    }

    #[test]
    fn cells_are_weighed_by_what_they_are() {
        let mut room = row(&[0.0, 0.4, 1.0], false);
        let cells = tomolith_core::dose::cells::Cells::new(&room.layout, &room.target.inside);
        room.layout = room.layout.with_cells(Arc::new(cells));
        let json =
            serde_json::json!({"weights": {"part": 3.0, "void": 2.0}, "tolerance": {"part": 0.5}});
        let voxel_weights = common(json)
            .voxel_weights(&room.ground(Path::new("")))
            .unwrap();
        // Three voxels, the middle one with its outside cell, and the inside cell behind them
        assert_eq!(voxel_weights.weight, [2.0, 2.0, 3.0, 3.0]);
        assert_eq!(voxel_weights.tolerance, [0.0, 0.0, 0.5, 0.5]);
        let json = serde_json::json!({"region": "part"});
        let voxel_weights = common(json)
            .voxel_weights(&room.ground(Path::new("")))
            .unwrap();
        assert_eq!(voxel_weights.weight, [0.0, 0.0, 1.0, 1.0]);
        // On top of the shares: L = 3·0.4·(1 − 0.25)² inside and 2·0.6·0.25² outside
        let mut l2 = build("l2", serde_json::json!({"surface": "cells"}), &room);
        let weights = serde_json::json!({"weights": {"part": 3.0, "void": 2.0}});
        let voxel_weights = common(weights)
            .voxel_weights(&room.ground(Path::new("")))
            .unwrap();
        l2.set_voxel_weights(&voxel_weights).unwrap();
        let dose = HostField::from_slice(&[0.0, 0.25, 1.0, 0.25]);
        let expected = 3.0 * 0.4 * 0.75f64.powi(2) + 2.0 * 0.6 * 0.25f64.powi(2);
        assert!((l2.value(&dose) - expected).abs() < 1e-6);
    }

    #[test]
    fn edges_of_gray_targets_lose_weight() {
        let room = row(&[0.0, 0.0, 0.5, 1.0, 1.0], true);
        let field = common(serde_json::json!({"weights": {"edge_per_mm": 1.0}}))
            .voxel_weights(&room.ground(Path::new("")))
            .unwrap();
        // Gradients 0, 0.5, 1, 0.5, 0 per mm
        assert_eq!(room.array(field.weight), [1.0, 0.8, 0.5, 0.8, 1.0]);
        let part = row(&[0.0, 1.0], false);
        let refused = common(serde_json::json!({"weights": {"edge_per_mm": 1.0}}))
            .voxel_weights(&part.ground(Path::new("")));
        assert!(matches!(refused, Err(Error::Config { key, .. }) if key == "weights.edge_per_mm"));
    }

    #[test]
    fn a_tolerance_widens_and_a_weight_scales_every_kind_of_band() {
        let part = [1.0f32, 1.0, 0.0, 0.0, 0.75];
        let voxel_weights = VoxelWeights {
            weight: vec![],
            tolerance: vec![],
        };
        let dose = [0.5f32, 1.5, 0.25, 0.0, 0.5];
        for (json, gray) in [
            (serde_json::json!({}), false),
            (serde_json::json!({}), true),
            (serde_json::json!({"surface": "fraction"}), false),
        ] {
            let room = row(&part, gray);
            let field = |values: &[f32]| {
                room.layout.field_of(&Volume {
                    grid: room.layout.grid.clone(),
                    values: values.to_vec(),
                })
            };
            let dose = HostField::from_slice(&field(&dose));
            let plain = build("l2", json.clone(), &room);
            let mut gradient = dose.zeros_like();
            plain.value_and_gradient(&dose, &mut gradient);
            let scale = [1.0f32, 2.0, 0.0, 1.0, 0.5];
            let mut scaled = build("l2", json.clone(), &room);
            scaled
                .set_voxel_weights(&VoxelWeights {
                    weight: field(&scale),
                    ..voxel_weights.clone()
                })
                .unwrap();
            let mut slopes = dose.zeros_like();
            scaled.value_and_gradient(&dose, &mut slopes);
            let [plain, slopes] =
                [gradient, slopes].map(|g| room.layout.volume_of(g.as_slice()).values);
            for i in 0..5 {
                assert!(
                    (slopes[i] - scale[i] * plain[i]).abs() < 1e-6,
                    "{json} {gray}: {slopes:?} {plain:?}"
                );
            }
            // Bands [f − ½, f + ½]: doses 0.5 and 1.5 are in the part's, 0.25 and 0 in the void's
            let mut wide = build("l2", json, &room);
            wide.set_voxel_weights(&VoxelWeights {
                tolerance: field(&[0.5; 5]),
                ..voxel_weights.clone()
            })
            .unwrap();
            assert_eq!(wide.value(&dose), 0.0);
            assert!(
                wide.set_voxel_weights(&VoxelWeights {
                    weight: vec![1.0; 3],
                    ..voxel_weights.clone()
                })
                .is_err()
            );
        }
    }

    #[test]
    fn a_band_that_no_dose_reaches_is_refused_unless_it_is_widened() {
        let room = row(&[1.0, 0.0], false);
        let params = tomolith_core::response::logistic::Params {
            upper: 0.8,
            ..Default::default()
        };
        let response = Arc::new(tomolith_core::response::Logistic::new(params).unwrap());
        let input = ObjectiveInput {
            layout: &room.layout,
            labels: &room.labels,
            target: &room.target,
            response,
        };
        for surface in ["voxel", "fraction"] {
            let kind = OBJECTIVES.iter().find(|row| row.name == "l2").unwrap();
            let section = Section::new("objective.l2", serde_json::json!({"surface": surface}));
            let mut objective = (kind.build)(&section).unwrap().make(&input).unwrap();
            let text = objective.must_be_reached().unwrap_err().to_string();
            assert!(
                text.contains("from 1 to 1") && text.contains("0 to 0.8"),
                "{text}"
            );
            let tolerance = vec![0.25; room.layout.len()];
            objective
                .set_voxel_weights(&VoxelWeights {
                    weight: vec![],
                    tolerance,
                })
                .unwrap();
            objective.must_be_reached().unwrap();
        }
    }

    #[test]
    fn every_row_with_fields_passes_the_check() {
        let model = SmallModel::new(18, 2, 21);
        let (target, labels) = model.ring();
        let layout = model.layout().clone();
        let noise = tomolith_core::check::noise(11, layout.len());
        let voxel_weights = VoxelWeights {
            weight: noise
                .iter()
                .map(|v| if *v < -0.5 { 0.0 } else { 1.0 + v })
                .collect(),
            tolerance: noise.iter().map(|v| 0.05 * (1.0 + v)).collect(),
        };
        // A process window has no bands that could be wider
        let without_tolerance = VoxelWeights {
            weight: voxel_weights.weight.clone(),
            tolerance: Vec::new(),
        };
        let values: Vec<f32> = tomolith_core::check::noise(5, layout.len())
            .iter()
            .map(|v| 0.6 + 0.8 * v)
            .collect();
        let dose = HostField::from_slice(&values);
        let input = ObjectiveInput {
            layout: &layout,
            labels: &labels,
            target: &target,
            response: Arc::new(Identity),
        };
        for row in OBJECTIVES {
            for surface in ["voxel", "fraction"] {
                let mut section = tomolith_core::check::example(row);
                section.value["surface"] = surface.into();
                let mut objective = (row.build)(&section).unwrap().make(&input).unwrap();
                if row.name == crate::process_window::NAME {
                    assert!(objective.set_voxel_weights(&voxel_weights).is_err());
                    objective.set_voxel_weights(&without_tolerance).unwrap();
                } else {
                    objective.set_voxel_weights(&voxel_weights).unwrap();
                }
                check::objective(&*objective, &dose)
                    .unwrap_or_else(|e| panic!("{} ({surface}): {e}", row.name));
            }
        }
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (json, key) in [
            (serde_json::json!({"weight": -1}), "objectives[0].weight"),
            (
                serde_json::json!({"region": "inside"}),
                "objectives[0].region.of",
            ),
            (
                serde_json::json!({"region": {"radius_mm": [2, 1]}}),
                "objectives[0].region.radius_mm",
            ),
            (
                serde_json::json!({"weights": {"part": -1}}),
                "objectives[0].weights.part",
            ),
            (
                serde_json::json!({"weights": {"edges": 1}}),
                "objectives[0].weights.edges",
            ),
            (
                serde_json::json!({"tolerance": {"void": -0.1}}),
                "objectives[0].tolerance.void",
            ),
            (
                serde_json::json!({"tolerance": {"regions": [{"value": 0.1}, {"value": -0.1}]}}),
                "objectives[0].tolerance.regions[1].value",
            ),
            (
                serde_json::json!({"weights": {"regions": [{"value": 2, "z_mm": [1, 1]}]}}),
                "objectives[0].weights.regions[0].z_mm",
            ),
        ] {
            let Err(Error::Config { key: found, .. }) =
                Common::split(Section::new("objectives[0]", json))
            else {
                panic!("{key} was accepted")
            };
            assert_eq!(found, key);
        }
        let folder = tempfile::tempdir().unwrap();
        let grid = VolumeGrid::centered([1, 1, 2], 0.5);
        let write = |name: &str, values: &[f32]| {
            let grid = VolumeGrid::centered([1, 1, values.len()], 0.5);
            write_volume(
                &folder.path().join(name),
                &Volume {
                    grid,
                    values: values.to_vec(),
                },
                &Run::new(),
            )
            .unwrap();
        };
        write("good.npy", &[0.0, 2.0]);
        write("long.npy", &[0.0, 2.0, 1.0]);
        write("bad.npy", &[0.0, -2.0]);
        std::fs::write(folder.path().join("text.npy"), "no array").unwrap();
        for (file, says) in [
            ("good.npy", None),
            ("long.npy", Some("shape [1, 1, 3]")),
            ("bad.npy", Some("holds -2 at [")),
            ("text.npy", Some("a 3D .npy array")),
            ("none.npy", Some("a file that can be read")),
        ] {
            let common = common(serde_json::json!({"weights": {"file": file}}));
            let checked = common.check_files(&grid, folder.path());
            match says {
                None => checked.unwrap(),
                Some(says) => {
                    let text = checked.unwrap_err().to_string();
                    assert!(
                        text.starts_with("weights.file") && text.contains(says),
                        "{text}"
                    );
                }
            }
        }
    }
}
