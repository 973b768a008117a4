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
use crate::preset::{HIGHEST_POWER, LARGEST};
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

tomolith_core::keys! {
    /// What an entry has besides its kind.
    pub struct Common {
        /// ω: factor of this objective in the sum
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub weight: f64 = 1.0,
        /// Which voxels count (default: all)
        pub region: Option<RegionSpec>,
        /// Weight per voxel (default: 1 everywhere)
        pub weights: Option<WeightsSpec>,
        /// Tolerance per voxel, in units of the response (default: 0 everywhere)
        pub tolerance: Option<ToleranceSpec>,
        /// Response of this objective, one kind (default: the job's)
        pub response: Option<Value>,
    }
}

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

tomolith_core::keys! {
    /// A region: voxels that all given keys hold.
    pub struct RegionSpec {
        /// "all", "part" or "void"
        pub of: Of = Of::default(),
        /// Distance from the axis, [from, to] mm
        pub radius_mm: Option<[Mm; 2]>,
        /// Height, [from, to] mm
        pub z_mm: Option<[Mm; 2]>,
        /// A mask: voxels that are not 0 count
        pub file: Option<PathBuf>,
    }
}

tomolith_core::keys! {
    /// Weight per voxel.
    pub struct WeightsSpec {
        /// Weight of part voxels
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub part: f64 = 1.0,
        /// Weight of void voxels
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub void: f64 = 1.0,
        /// Weights per voxel, 0 or above
        pub file: Option<PathBuf>,
        /// Factors of the weight in regions
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub regions: Vec<RegionValue> = Vec::new(),
        /// Part voxels this near to the void do not count, mm
        #[schemars(extend("minimum" = 0.0, "maximum" = LARGEST))]
        pub buffer_part_mm: Mm = Mm(0.0),
        /// Void voxels this near to the part do not count, mm
        #[schemars(extend("minimum" = 0.0, "maximum" = LARGEST))]
        pub buffer_void_mm: Mm = Mm(0.0),
        /// Gray targets: gradient at which a voxel has half its weight, 1/mm (default: none loses any)
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = HIGHEST_POWER))]
        pub edge_per_mm: Option<f64>,
    }
}

tomolith_core::keys! {
    /// Tolerance per voxel.
    pub struct ToleranceSpec {
        /// In the part
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub part: f64 = 0.0,
        /// In the void
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub void: f64 = 0.0,
        /// Added per voxel, 0 or above
        pub file: Option<PathBuf>,
        /// Added in regions
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub regions: Vec<RegionValue> = Vec::new(),
    }
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
    /// The factor of the weight there, or the tolerance that is added there
    #[schemars(range(min = 0.0, max = LARGEST))]
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

/// Whether a table says no more than its defaults.
fn is_default<T: Serialize + Default>(table: &T) -> bool {
    serde_json::to_value(table).ok() == serde_json::to_value(T::default()).ok()
}

impl Common {
    /// Takes an entry apart: what every one may have, and the section of its kind.
    ///
    /// # Errors
    /// [`Error::Config`] with the key path of what is unknown or out of range.
    pub fn split(mut section: Section) -> Result<(Common, Section)> {
        let mut taken = serde_json::Map::new();
        if let Some(map) = section.value.as_object_mut() {
            for key in KEYS {
                taken.extend(map.remove(key).map(|value| (key.to_owned(), value)));
            }
        }
        if let Some(Value::String(region)) = taken.get("region").cloned() {
            taken.insert("region".to_owned(), serde_json::json!({ "of": region }));
        }
        let mut common: Common =
            Section::new(section.path.clone(), Value::Object(taken)).parse()?;
        common.validate().map_err(|e| e.under(&section.path))?;
        // What changes nothing must not keep the optimization from finer voxels
        common.region.take_if(|region| is_default(region));
        common.weights.take_if(|weights| is_default(weights));
        common.tolerance.take_if(|tolerance| is_default(tolerance));
        Ok((common, section.without(&KEYS)))
    }

    fn validate(&self) -> Result<()> {
        if let Some(region) = &self.region {
            ascending("region.radius_mm", region.radius_mm)?;
            ascending("region.z_mm", region.z_mm)?;
        }
        let factors = self.weights.as_ref().map(|weights| &weights.regions);
        let added = self.tolerance.as_ref().map(|tolerance| &tolerance.regions);
        for (key, regions) in [("weights", factors), ("tolerance", added)] {
            for (i, region) in regions.into_iter().flatten().enumerate() {
                ascending(&format!("{key}.regions[{i}].radius_mm"), region.radius_mm)?;
                ascending(&format!("{key}.regions[{i}].z_mm"), region.z_mm)?;
            }
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

    /// Keys of regions that hold no voxel that counts, so that they change nothing.
    ///
    /// # Errors
    /// [`Error::Config`] for a file that cannot be used.
    pub fn empty_regions(&self, ground: &Ground<'_>) -> Result<Vec<String>> {
        let (grid, labels) = (&ground.layout.grid, &ground.labels.values);
        let counts = |i: usize| labels[i] != label::OUTSIDE;
        let mut empty = Vec::new();
        if let Some(region) = &self.region {
            let mask = region.mask(ground)?;
            if !(0..mask.len()).any(|i| mask[i] && counts(i)) {
                empty.push("region".to_owned());
            }
        }
        let factors = self.weights.as_ref().map(|weights| &weights.regions);
        let added = self.tolerance.as_ref().map(|tolerance| &tolerance.regions);
        for (key, regions) in [("weights", factors), ("tolerance", added)] {
            for (at, region) in regions.into_iter().flatten().enumerate() {
                let ranges = [region.radius_mm, region.z_mm];
                if !(0..labels.len()).any(|i| counts(i) && holds(ranges, grid, i)) {
                    empty.push(format!("{key}.regions[{at}]"));
                }
            }
        }
        Ok(empty)
    }

    /// The parameters without what belongs to the grid or the target at hand: files, numbers of regions, and edges of gray targets. For a trial on
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
                ground
                    .layout
                    .field_of(&Volume::new(ground.layout.grid.clone(), values))
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
            let is_wanted = match self.of {
                Of::All => true,
                Of::Part => labels[i] == label::PART,
                Of::Void => labels[i] == label::VOID,
            };
            is_wanted
                && holds([self.radius_mm, self.z_mm], grid, i)
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
    let [x, y, z] = grid.middle(i);
    let within =
        |range: Option<[Mm; 2]>, v: f64| range.is_none_or(|[low, high]| v >= low.0 && v <= high.0);
    within(radius_mm, x.hypot(y)) && within(z_mm, z)
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
    let (shape, values) = read_volume(path).map_err(|e| e.of_file(key))?;
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
mod tests;
