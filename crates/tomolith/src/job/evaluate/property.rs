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

/// The properties of a print.
pub(crate) fn properties(job: &ResolvedJob, evaluated: &Evaluated) -> Vec<Property> {
    if job.properties.is_empty() {
        return Vec::new();
    }
    let mut responses = Vec::new();
    for (own, print) in job.species.iter().zip(&evaluated.species) {
        let gel = print.evaluation.gel_threshold;
        let gel = gel.map_or(f32::INFINITY, |gel| gel as f32);
        responses.push((own.goal.responses(print.dose.clone()), gel));
    }
    let mut properties = Vec::new();
    for own in &job.properties {
        let of = &responses[own.of].0;
        let over = own.over.map(|s| &responses[s].0);
        let value = |v: usize| {
            if !responses
                .iter()
                .any(|(response, gel)| response.values[v] >= *gel)
            {
                return f32::NAN;
            }
            let ratio = over.map_or(1.0, |over| over.values[v].max(f32::MIN_POSITIVE));
            let value = own.map.value(of.values[v] / ratio);
            if own.is_logarithmic {
                10f32.powf(value)
            } else {
                value
            }
        };
        properties.push(Property {
            name: own.name.clone(),
            unit: own.unit.clone(),
            is_logarithmic: own.is_logarithmic,
            values: Volume {
                grid: of.grid.clone(),
                values: (0..of.values.len()).map(value).collect(),
            },
        });
    }
    properties
}
