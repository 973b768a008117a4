//! Properties of the printed material, from the responses of its species.

use crate::grid::Volume;
use crate::job::evaluate::Evaluated;
use crate::job::resolve::ResolvedJob;

/// A property on the job's voxels; NaN where nothing is solid.
pub(crate) struct Property {
    pub(crate) name: String,
    pub(crate) unit: String,
    pub(crate) is_logarithmic: bool,
    pub(crate) values: Volume<f32>,
}

pub(crate) fn properties(job: &ResolvedJob, evaluated: &Evaluated) -> Vec<Property> {
    if job.properties.is_empty() {
        return Vec::new();
    }
    let mut responses = Vec::new();
    for (species, print) in job.species.iter().zip(&evaluated.species) {
        let gel = print.evaluation.gel_threshold;
        let gel = gel.map_or(f32::INFINITY, |gel| gel as f32);
        responses.push((species.goal.responses(print.dose.clone()), gel));
    }
    let mut properties = Vec::new();
    for property in &job.properties {
        let mapped = &responses[property.species].0;
        let over = property.over.map(|s| &responses[s].0);
        let value = |v: usize| {
            if !responses
                .iter()
                .any(|(response, gel)| response.values[v] >= *gel)
            {
                return f32::NAN;
            }
            let ratio = over.map_or(1.0, |over| over.values[v].max(f32::MIN_POSITIVE));
            let value = property.map.value(mapped.values[v] / ratio);
            if property.is_logarithmic {
                10f32.powf(value)
            } else {
                value
            }
        };
        properties.push(Property {
            name: property.name.clone(),
            unit: property.unit.clone(),
            is_logarithmic: property.is_logarithmic,
            values: Volume {
                grid: mapped.grid.clone(),
                values: (0..mapped.values.len()).map(value).collect(),
            },
        });
    }
    properties
}
