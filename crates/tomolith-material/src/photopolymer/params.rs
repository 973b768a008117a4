//! Parameters of a photopolymer, and what is refused of them.

use crate::diffusion::Scheme;
use crate::mixing::Mixing;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::kind::check_ranges;
use tomolith_core::units::exact;

/// What a network takes to gel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Curing {
    /// It gels where the dose that inhibitors leave reaches a threshold.
    Threshold {
        /// E_d, mJ/mm³.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        critical_dose_mj_per_mm3: f64,
    },
    /// dC/dt = k e^m (1 − C), e the power that inhibitors leave, mW/mm³.
    RateLaw {
        /// k: rate at 1 mW/mm³, 1/s.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        rate_per_s: f64,
        /// m, from ½: radicals that end in pairs.
        #[schemars(range(min = 0.5, max = 1.0))]
        exponent: f64,
        /// Conversion at the gel point.
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 0.999_999))]
        gel_conversion: f64,
    },
}

impl Curing {
    /// A threshold, mJ/mm³.
    #[must_use]
    pub fn threshold(critical_dose_mj_per_mm3: f64) -> Self {
        Curing::Threshold {
            critical_dose_mj_per_mm3,
        }
    }
}

/// What a state is before the first frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Initial {
    /// One value everywhere.
    Even(f64),
    /// Values at heights `[z in mm, value]`, heights ascending; linear between, constant beyond: an oxygen gradient along the vial.
    Axial(Vec<[f64; 2]>),
}

/// A value at a height from points `[z, value]`, heights ascending: linear between them, even beyond.
#[must_use]
pub fn at_height(points: &[[f64; 2]], z: f64) -> f64 {
    let above = points.partition_point(|p| p[0] <= z);
    match (above.checked_sub(1).map(|i| points[i]), points.get(above)) {
        (Some(a), Some(b)) => a[1] + (b[1] - a[1]) * (z - a[0]) / (b[0] - a[0]),
        (Some(a), None) => a[1],
        (None, b) => b.map_or(0.0, |b| b[1]),
    }
}

impl Initial {
    /// Whether there is none of it anywhere.
    #[must_use]
    pub fn is_none(&self) -> bool {
        match self {
            Initial::Even(value) => *value == 0.0,
            Initial::Axial(points) => points.iter().all(|point| point[1] == 0.0),
        }
    }

    pub(super) fn at(&self, z: f64) -> f64 {
        match self {
            Initial::Even(value) => *value,
            Initial::Axial(points) => at_height(points, z),
        }
    }

    fn validate(&self) -> Result<()> {
        let refuse = |found: String, accepted: &str| Err(Error::config("initial", found, accepted));
        let values: Vec<f64> = match self {
            Initial::Even(value) => vec![*value],
            Initial::Axial(points) => {
                let ascends = points.windows(2).all(|p| p[0][0] < p[1][0]);
                if points.is_empty() || !ascends || points.iter().any(|p| !p[0].is_finite()) {
                    let heights: Vec<f64> = points.iter().map(|p| p[0]).collect();
                    let accepted = "at least one height, finite and ascending, mm";
                    return refuse(format!("heights {heights:?}"), accepted);
                }
                points.iter().map(|p| p[1]).collect()
            }
        };
        match values.iter().find(|v| !(0.0..=1.0).contains(*v)) {
            Some(bad) => refuse(format!("found {}", exact(*bad)), "0 to 1"),
            None => Ok(()),
        }
    }
}

tomolith_core::keys! {
    /// Something that takes drive until it is used up.
    #[derive(PartialEq)]
    pub struct Inhibitor {
        /// Its name.
        pub name: String = "oxygen".to_owned(),
        /// 1/κ: the dose that uses up all of it (from 1 to 0), mJ/mm³.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub capacity_mj_per_mm3: f64 = 1.0,
        /// How much there is, 0 to 1 (1: what air saturates resin with).
        pub initial: Initial = Initial::Even(1.0),
        /// D, mm²/s (10⁻¹⁰ m²/s = 10⁻⁴ mm²/s).
        #[schemars(range(min = 0.0))]
        pub diffusion_mm2_per_s: f64 = 0.0,
        /// Share of D that cured resin has.
        #[schemars(range(min = 0.0, max = 1.0))]
        pub cured_diffusion: f64 = 1.0,
        /// K of the smooth consumption r·O/(O + K); none: of zeroth order.
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1e3))]
        pub half_saturation: Option<f64>,
        /// Whether air on top holds it at 1.
        pub from_air: bool = true,
    }
}

/// A network that cures.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Network {
    /// Its name.
    pub name: String,
    /// What takes its drive first, in this order.
    #[serde(default)]
    pub inhibitors: Vec<Inhibitor>,
    /// What it takes to gel.
    pub curing: Curing,
    /// w: width of the rise of the cured share about the gel point, relative to it; 0: a step.
    #[serde(default = "tenth")]
    #[schemars(range(min = 0.0, max = 2.0))]
    pub gel_width: f64,
    /// b: share of initiator that a dose uses up, mm³/mJ.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub bleaching_mm3_per_mj: f64,
    /// D of the dose, mm²/s: radicals that wander before they react. With a threshold only.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub dose_diffusion_mm2_per_s: f64,
}

fn tenth() -> f64 {
    0.1
}

impl Network {
    /// A network without inhibitor and bleaching.
    #[must_use]
    pub fn new(name: &str, curing: Curing) -> Self {
        Network {
            name: name.to_owned(),
            inhibitors: Vec::new(),
            curing,
            gel_width: tenth(),
            bleaching_mm3_per_mj: 0.0,
            dose_diffusion_mm2_per_s: 0.0,
        }
    }
}

/// How a light's absorption changes as a network cures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Shading {
    /// Which light.
    pub light: usize,
    /// Which network.
    #[serde(default)]
    pub network: usize,
    /// Active absorption before and after, 1/mm.
    pub active_per_mm: [f64; 2],
    /// Total attenuation before and after, 1/mm, at least the active absorption.
    pub attenuation_per_mm: [f64; 2],
}

/// Parameters of a photopolymer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// One per row of the mixing matrix.
    pub networks: Vec<Network>,
    /// At most one per light.
    #[serde(default)]
    pub shading: Vec<Shading>,
    /// How diffusion is stepped.
    #[serde(default)]
    pub diffusion: Scheme,
}

impl Params {
    /// Networks without shading.
    #[must_use]
    pub fn new(networks: Vec<Network>) -> Self {
        Params {
            networks,
            shading: Vec::new(),
            diffusion: Scheme::default(),
        }
    }

    /// The same with diffusion by this scheme.
    #[must_use]
    pub fn diffusing_by(self, diffusion: Scheme) -> Self {
        Params { diffusion, ..self }
    }

    /// The same with a light that is shaded.
    #[must_use]
    pub fn shaded(mut self, shading: Shading) -> Self {
        self.shading.push(shading);
        self
    }

    pub(super) fn validate(&self, mixing: &Mixing) -> Result<()> {
        if self.networks.len() != mixing.species() {
            return Err(Error::config(
                "networks",
                format!("{} networks", self.networks.len()),
                format!("{}, one for each species", mixing.species()),
            ));
        }
        for (i, network) in self.networks.iter().enumerate() {
            let checked = check_network(network);
            checked.map_err(|e| e.under(&format!("networks[{i}]")))?;
        }
        for (i, shading) in self.shading.iter().enumerate() {
            let others = &self.shading[..i];
            let checked = check_shading(shading, mixing, others);
            checked.map_err(|e| e.under(&format!("shading[{i}]")))?;
        }
        self.check_bleached_lights(mixing)?;
        check_ranges("", self)
    }

    /// The initiator that a light was computed with is one number per voxel: all lights of a network that bleaches are shaded, or none.
    fn check_bleached_lights(&self, mixing: &Mixing) -> Result<()> {
        for (s, network) in self.networks.iter().enumerate() {
            let is_shaded = |light: usize| {
                let mut all = self.shading.iter();
                all.any(|shading| shading.light == light && shading.network == s)
            };
            let driving = (0..mixing.lights()).filter(|&l| mixing.row(s)[l] != 0.0);
            let plain: Vec<usize> = driving.clone().filter(|&l| !is_shaded(l)).collect();
            let mixed = !plain.is_empty() && plain.len() < driving.count();
            if network.bleaching_mm3_per_mj > 0.0 && mixed {
                return Err(Error::config(
                    "shading",
                    format!(
                        "light {} drives networks[{s}], which bleaches, and is not shaded by it",
                        plain[0]
                    ),
                    "an entry for every light that drives this network, or for none",
                ));
            }
        }
        Ok(())
    }
}

fn check_network(network: &Network) -> Result<()> {
    let wandering = network.dose_diffusion_mm2_per_s;
    if wandering != 0.0 && matches!(network.curing, Curing::RateLaw { .. }) {
        return Err(Error::config(
            "dose_diffusion_mm2_per_s",
            format!("found {} with a rate law", exact(wandering)),
            "0: a network does not wander; a dose that does takes curing.threshold",
        ));
    }
    for (i, inhibitor) in network.inhibitors.iter().enumerate() {
        let initial = inhibitor.initial.validate();
        initial.map_err(|e| e.under(&format!("inhibitors[{i}]")))?;
    }
    Ok(())
}

fn check_shading(shading: &Shading, mixing: &Mixing, others: &[Shading]) -> Result<()> {
    let number = |key: &str, value: usize, count: usize| {
        if value < count {
            return Ok(());
        }
        Err(Error::refused(key, value, format!("0 to {}", count - 1)))
    };
    number("light", shading.light, mixing.lights())?;
    number("network", shading.network, mixing.species())?;
    if others.iter().any(|other| other.light == shading.light) {
        return Err(Error::config(
            "light",
            format!("light {} a second time", shading.light),
            "one entry per light",
        ));
    }
    let pairs = shading.active_per_mm.iter().zip(shading.attenuation_per_mm);
    for (&active, total) in pairs {
        let from = |key, value: f64, least: f64| {
            let accepted = format!("a finite number from {}", exact(least));
            in_range((least..=f64::MAX).contains(&value), key, value, accepted)
        };
        from("active_per_mm", active, 0.0)?;
        from("attenuation_per_mm", total, active)?;
    }
    Ok(())
}
