//! Properties of the printed material: responses of species → modulus, index, ….
//!
//! ```text
//! x = response of one species, or its ratio to that of another
//! property = R(x), or 10^R(x)      where a species is solid; nothing elsewhere
//! ```
//!
//! R is any response: a table or a logistic that was fitted to measured pairs (`tomolith calibrate`). Stiffness spans decades, so its
//! logistic is one of log₁₀ (Wang et al. 2022, Supplementary Table 2).

use super::evaluate::Evaluated;
use super::resolve::response;
use super::scene::Scene;
use super::spec::{JobSpec, PropertySpec};
use crate::error::{Error, Result};
use crate::grid::Volume;
use crate::kind::Section;
use crate::response::Response;
use std::path::Path;
use std::sync::Arc;

/// A property on the job's voxels; NaN where nothing is solid.
pub(crate) struct Property {
    pub(crate) name: String,
    pub(crate) unit: String,
    pub(crate) is_logarithmic: bool,
    pub(crate) values: Volume<f32>,
}

/// The map of each property of a job, whose names are checked, too.
///
/// # Errors
/// [`Error::Config`].
pub(super) fn maps(spec: &JobSpec, base: &Path) -> Result<Vec<Arc<dyn Response>>> {
    let map_of = |(i, property): (usize, &PropertySpec)| {
        let key = format!("property[{i}]");
        let names: Vec<&str> = spec.species.iter().map(|s| s.name.as_str()).collect();
        for (part, name) in [("of", &property.of), ("over", &property.over)] {
            if let Some(name) = name.as_deref().filter(|name| !names.contains(name)) {
                return Err(Error::config(
                    format!("{key}.{part}"),
                    format!("no species is called {name:?}"),
                    match names.is_empty() {
                        true => "a job with [[species]], or no such key".to_owned(),
                        false => format!("one of {}", names.join(", ")),
                    },
                ));
            }
        }
        response(&Section::new(format!("{key}.map"), property.map.clone()).based(base))
    };
    spec.property.iter().enumerate().map(map_of).collect()
}

/// The properties of a print.
///
/// # Errors
/// As [`Scene::responses`].
pub(super) fn properties(scene: &Scene, evaluated: &Evaluated) -> Result<Vec<Property>> {
    if scene.spec.property.is_empty() {
        return Ok(Vec::new());
    }
    let doses = std::iter::once((&evaluated.dose, evaluated.evaluation.gel_threshold));
    let others = evaluated
        .others
        .iter()
        .map(|o| (&o.dose, o.evaluation.gel_threshold));
    let mut responses = Vec::new();
    for (scene, (dose, gel)) in scene.species().zip(doses.chain(others)) {
        let gel = gel.map_or(f32::INFINITY, |gel| gel as f32);
        responses.push((scene.responses(dose.clone()), gel));
    }
    let number = |name: &Option<String>| {
        let name = name.as_deref();
        let is_named = |s: &usize| scene.species_name(*s) == name;
        (0..responses.len()).find(is_named)
    };
    let mut properties = Vec::new();
    for (spec, map) in scene.spec.property.iter().zip(&scene.property_maps) {
        let of = &responses[number(&spec.of).unwrap_or(0)].0;
        let over = number(&spec.over).map(|s| &responses[s].0);
        let value = |v: usize| {
            if !responses
                .iter()
                .any(|(response, gel)| response.values[v] >= *gel)
            {
                return f32::NAN;
            }
            let ratio = over.map_or(1.0, |over| over.values[v].max(f32::MIN_POSITIVE));
            let value = map.value(of.values[v] / ratio);
            if spec.log10 { 10f32.powf(value) } else { value }
        };
        properties.push(Property {
            name: spec.name.clone(),
            unit: spec.unit.clone(),
            is_logarithmic: spec.log10,
            values: Volume {
                grid: of.grid.clone(),
                values: (0..of.values.len()).map(value).collect(),
            },
        });
    }
    Ok(properties)
}
