//! Properties of the printed material, from the responses of its species.

use crate::error::Result;
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
///
/// # Errors
/// As [`ResolvedJob::responses`].
pub(crate) fn properties(job: &ResolvedJob, evaluated: &Evaluated) -> Result<Vec<Property>> {
    if job.spec.property.is_empty() {
        return Ok(Vec::new());
    }
    let doses = std::iter::once((&evaluated.dose, evaluated.evaluation.gel_threshold));
    let others = evaluated
        .others
        .iter()
        .map(|o| (&o.dose, o.evaluation.gel_threshold));
    let mut responses = Vec::new();
    for (job, (dose, gel)) in job.species().zip(doses.chain(others)) {
        let gel = gel.map_or(f32::INFINITY, |gel| gel as f32);
        responses.push((job.responses(dose.clone()), gel));
    }
    let number = |name: &Option<String>| {
        let name = name.as_deref();
        let is_named = |s: &usize| job.species_name(*s) == name;
        (0..responses.len()).find(is_named)
    };
    let mut properties = Vec::new();
    for (spec, map) in job.spec.property.iter().zip(&job.property_maps) {
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
