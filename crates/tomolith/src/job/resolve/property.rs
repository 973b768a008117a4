//! Properties of the printed material: responses of species → modulus, index, ….
//!
//! ```text
//! x = response of one species, or its ratio to that of another
//! property = R(x), or 10^R(x)      where a species is solid; nothing elsewhere
//! ```
//!
//! R is any response: a table or a logistic that was fitted to measured pairs (`tomolith calibrate`). Stiffness spans decades, so its
//! logistic is one of log₁₀ (Wang et al. 2022, Supplementary Table 2).

use super::goal::response;
use crate::error::{Error, Result};
use crate::job::spec::{JobSpec, PropertySpec};
use crate::kind::Section;
use crate::response::Response;
use std::path::Path;
use std::sync::Arc;

/// What the responses of species become.
pub(crate) struct PropertyMap {
    pub(crate) name: String,
    pub(crate) unit: String,
    /// The species whose response is mapped, and the one by whose response that is divided first, where there is one.
    pub(crate) species: usize,
    pub(crate) over: Option<usize>,
    pub(crate) map: Arc<dyn Response>,
    /// Whether the map gives the decimal logarithm.
    pub(crate) is_logarithmic: bool,
}

pub(crate) fn of_job(spec: &JobSpec, base: &Path) -> Result<Vec<PropertyMap>> {
    let names: Vec<&str> = spec.species.iter().map(|s| s.name.as_str()).collect();
    let number = |key: String, name: Option<&str>| {
        let Some(name) = name else { return Ok(None) };
        let found = names.iter().position(|species| *species == name);
        found.map(Some).ok_or_else(|| {
            let accepted = match names.is_empty() {
                true => "a job with [[species]], or no such key".to_owned(),
                false => format!("one of {}", names.join(", ")),
            };
            Error::config(key, format!("no species is called {name:?}"), accepted)
        })
    };
    let map_of = |(i, property): (usize, &PropertySpec)| {
        let key = format!("property[{i}]");
        let map = Section::new(format!("{key}.map"), property.map.clone()).based(base);
        let species = match (
            number(format!("{key}.of"), property.of.as_deref())?,
            names.len(),
        ) {
            (None, 2..) => {
                let accepted = format!("one of {}", names.join(", "));
                return Err(Error::config(
                    format!("{key}.of"),
                    "the key is missing",
                    accepted,
                ));
            }
            (found, _) => found.unwrap_or(0),
        };
        Ok(PropertyMap {
            species,
            over: number(format!("{key}.over"), property.over.as_deref())?,
            map: response(&map)?,
            name: property.name.clone(),
            unit: property.unit.clone(),
            is_logarithmic: property.log10,
        })
    };
    spec.property.iter().enumerate().map(map_of).collect()
}
