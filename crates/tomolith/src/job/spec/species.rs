//! What `[[species]]` and `[[light]]` say together: which light sees which resin, which species each drives, and the job of each species.

use crate::error::{Error, Result, in_range};
use crate::job::spec::{JobSpec, ResinSpec};

/// A species by name, and its row of M.
pub(crate) type Row = (String, Vec<f64>);

impl JobSpec {
    /// The resin as light `i` sees it.
    pub(crate) fn resin_of(&self, i: usize) -> ResinSpec {
        let of_light = &self.light[i].resin;
        let mut resin = self.resin.clone();
        if let Some(index) = of_light.refractive_index {
            resin.refractive_index = index;
        }
        if of_light.absorption_per_mm.is_some() || of_light.scattering_per_mm.is_some() {
            resin.attenuation_per_mm = None;
        }
        resin.absorption_per_mm = of_light.absorption_per_mm.or(resin.absorption_per_mm);
        resin.scattering_per_mm = of_light
            .scattering_per_mm
            .unwrap_or(resin.scattering_per_mm);
        resin.attenuation_per_mm = of_light.attenuation_per_mm.or(resin.attenuation_per_mm);
        resin
    }

    /// The job of one species alone: its target, objective and response in place of the whole job's.
    pub(crate) fn of_species(&self, s: usize) -> JobSpec {
        let mut spec = self.clone();
        let Some(species) = self.species.get(s) else {
            return spec;
        };
        if let Some(target) = &species.target {
            spec.target = target.clone();
        }
        if let Some(objective) = &species.objective {
            (spec.objective, spec.objectives) = (Some(objective.clone()), None);
        }
        if let Some(response) = &species.response {
            spec.response = response.clone();
        }
        spec
    }

    /// M, a row per species; None where all lights drive one species alike.
    /// Refuses names that are missing, unknown or used twice, and factors that are no numbers.
    pub(crate) fn mixing(&self) -> Result<Option<Vec<Row>>> {
        if self.species.is_empty() {
            return Ok(None);
        }
        let names: Vec<&str> = self
            .light
            .iter()
            .map(|l| l.name.as_deref().unwrap_or("light"))
            .collect();
        let mut rows: Vec<Row> = Vec::with_capacity(self.species.len());
        for (s, species) in self.species.iter().enumerate() {
            let key = format!("species[{s}]");
            if rows.iter().any(|(name, _)| *name == species.name) {
                let found = format!("found {:?} a second time", species.name);
                return Err(Error::config(
                    format!("{key}.name"),
                    found,
                    "names that differ",
                ));
            }
            let row = match &species.driven_by {
                None => vec![1.0; names.len()],
                Some(given) => {
                    for (light, factor) in given {
                        let key = format!("{key}.driven_by.{light}");
                        if !names.contains(&light.as_str()) {
                            let accepted = format!("the name of a light: {}", names.join(", "));
                            return Err(Error::config(key, "no light has this name", accepted));
                        }
                        in_range(factor.is_finite(), key, *factor, "a number")?;
                    }
                    let factor = |name: &&str| given.get(*name).copied().unwrap_or(0.0);
                    names.iter().map(factor).collect()
                }
            };
            if !row.iter().any(|&m| m > 0.0) {
                return Err(Error::config(
                    format!("{key}.driven_by"),
                    "no light drives it",
                    "a factor above 0 for one light at least",
                ));
            }
            rows.push((species.name.clone(), row));
        }
        if let Some(i) = (0..names.len()).find(|&i| rows.iter().all(|(_, row)| row[i] == 0.0)) {
            return Err(Error::config(
                format!("light[{i}]"),
                format!("{} drives no species", names[i]),
                "a factor for it in species.driven_by, or no such light",
            ));
        }
        Ok(Some(rows))
    }
}

/// Names the table of a species where a key of the whole job is blamed that the species sets itself.
pub(crate) fn at_species(spec: &JobSpec, s: usize, error: Error) -> Error {
    let Some(species) = spec.species.get(s) else {
        return error;
    };
    let sets = |key: &str| {
        let table = key.split(['.', '[']).next();
        match table {
            Some("target") => species.target.is_some(),
            Some("objective") => species.objective.is_some(),
            Some("response") => species.response.is_some(),
            _ => false,
        }
    };
    match error {
        Error::Config { ref key, .. } if sets(key) => error.under(&format!("species[{s}]")),
        other => other,
    }
}
