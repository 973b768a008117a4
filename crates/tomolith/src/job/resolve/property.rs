//! Properties of the printed material: responses of species → modulus, index, ….
//!
//! ```text
//! x = response of one species, or its ratio to that of another
//! property = R(x), or 10^R(x)      where a species is solid; nothing elsewhere
//! ```
//!
//! R is any response: a table or a logistic that was fitted to measured pairs (`tomolith calibrate`). Stiffness spans decades, so its
//! logistic is one of log₁₀ (Wang et al. 2022, Supplementary Table 2).

use super::method::response;
use crate::error::{Error, Result};
use crate::job::spec::{JobSpec, PropertySpec};
use crate::kind::Section;
use crate::response::Response;
use std::path::Path;
use std::sync::Arc;

/// The map of each property of a job, whose names are checked, too.
///
/// # Errors
/// [`Error::Config`].
pub(crate) fn maps(spec: &JobSpec, base: &Path) -> Result<Vec<Arc<dyn Response>>> {
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
