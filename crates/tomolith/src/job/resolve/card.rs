//! Where a job is computed: on the processor, or on a graphics card.
//!
//! `resources.device` is `"cpu"`, `"gpu"` (the first real card), `"gpu:NAME"` (one whose name contains this), or `"auto"`: a card where there is one that is
//! large enough, else the processor. What has no form for a card ([`DoseModel::form`](crate::dose::DoseModel::form)) stays on the processor.

use crate::dose::Accelerator;
use crate::error::Result;

/// What `resources.device` takes.
const ACCEPTED: &str = "\"cpu\", \"gpu\", \"gpu:NAME\" (part of a card's name; `tomolith devices` lists them), \"auto\"";

/// The part of a card's name that a key asks for: None for the processor, empty for any card.
fn asked(device: Option<&str>) -> Result<Option<(&str, bool)>> {
    match device {
        None | Some("cpu") => Ok(None),
        Some("gpu") => Ok(Some(("", false))),
        Some("auto") => Ok(Some(("", true))),
        Some(other) => match other.strip_prefix("gpu:") {
            Some(name) if !name.is_empty() => Ok(Some((name, false))),
            _ => Err(crate::Error::config(
                "resources.device",
                format!("found {other:?}"),
                ACCEPTED,
            )),
        },
    }
}

/// What to say where a job asks for a card if there is one, and there is none.
pub(crate) fn none_for(device: Option<&str>, card: Option<&Card>) -> Option<String> {
    (device == Some("auto") && card.is_none()).then(|| {
        "resources.device = \"auto\": no graphics card was found, so the processor computes"
            .to_owned()
    })
}

#[cfg(feature = "gpu")]
pub(crate) use with_gpu::Card;
#[cfg(not(feature = "gpu"))]
pub(crate) use without::Card;
#[cfg(feature = "gpu")]
mod with_gpu {
    use super::{Accelerator, Result};
    use crate::dose::form::Form;
    use crate::error::Error;
    use crate::models::{HostModel, Work};
    use std::sync::{Mutex, PoisonError};
    use tomolith_gpu::{Asked, Gpu};

    /// A graphics card that a job asks for.
    #[derive(Clone, Debug)]
    pub(crate) struct Card {
        gpu: Gpu,
        /// Whether the processor does what the card cannot hold.
        gives_way: bool,
    }

    /// Cards that were opened, by the part of their names: opening takes a while, and a job is resolved more than once.
    static OPENED: Mutex<Vec<(String, Gpu)>> = Mutex::new(Vec::new());

    impl Card {
        /// The card that a key asks for; None for the processor.
        pub(crate) fn of(device: Option<&str>) -> Result<Option<Self>> {
            let Some((name, gives_way)) = super::asked(device)? else {
                return Ok(None);
            };
            match opened(name) {
                Ok(gpu) => Ok(Some(Card { gpu, gives_way })),
                Err(Error::Device { .. }) if gives_way => Ok(None),
                Err(error) => Err(error),
            }
        }

        pub(crate) fn gpu(&self) -> &Gpu {
            &self.gpu
        }

        /// Whether its memory holds so many bytes; false where the processor takes what it cannot hold.
        pub(crate) fn holds(&self, bytes: u64) -> Result<bool> {
            let adapter = self.gpu.adapter();
            match adapter.memory_bytes {
                Some(all) if all < bytes && self.gives_way => Ok(false),
                Some(all) if all < bytes => Err(Error::Resources {
                    what: format!("memory of {}", adapter.name),
                    needed_mb: bytes.div_ceil(1_000_000),
                    available_mb: Some(all / 1_000_000),
                    advice: "use the processor (--device cpu), a smaller optimizer.lbfgs.memory, or fewer voxels, angles or pixels"
                        .to_owned(),
                }),
                _ => Ok(true),
            }
        }

        /// The card and its driver, on which the bits of a run depend.
        pub(crate) fn version(&self) -> String {
            let adapter = self.gpu.adapter();
            format!("{} ({})", adapter.name, adapter.driver)
        }

        /// The most of its memory that was in use at a time since this was asked last, for people; None where nothing was.
        pub(crate) fn memory_used(&self) -> Option<String> {
            let (bytes, adapter) = (self.gpu.most_used(), self.gpu.adapter());
            let of_all = adapter
                .memory_bytes
                .map_or_else(String::new, |all| format!(" of the {} MB", all / 1_000_000));
            let used = bytes.div_ceil(1_000_000);
            (bytes > 0).then(|| format!("{used} MB{of_all} of {}", adapter.name))
        }
    }

    fn opened(name: &str) -> Result<Gpu> {
        let mut all = OPENED.lock().unwrap_or_else(PoisonError::into_inner);
        let known = all
            .iter()
            .find(|(opened, gpu)| opened == name && gpu.check().is_ok());
        if let Some((_, gpu)) = known {
            return Ok(gpu.clone());
        }
        let asked = if name.is_empty() {
            Asked::Any
        } else {
            Asked::Named(name)
        };
        let gpu = Gpu::open(&asked)?;
        all.retain(|(opened, _)| opened != name);
        all.push((name.to_owned(), gpu.clone()));
        Ok(gpu)
    }

    impl Accelerator for Card {
        fn model(&self, form: &Form, work: &Work) -> Result<Option<HostModel>> {
            match self.gpu.model(form, work) {
                Err(Error::Resources { .. } | Error::Unsupported { .. }) if self.gives_way => {
                    Ok(None)
                }
                other => other,
            }
        }
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn a_loop_that_its_memory_does_not_hold_is_refused_or_left_to_the_processor() {
            let Some(adapter) = tomolith_gpu::adapters().into_iter().next() else {
                return;
            };
            let gpu = Gpu::smaller(&Asked::Named(&adapter.name), u64::MAX, 5_000_000).unwrap();
            let asked = Card {
                gpu: gpu.clone(),
                gives_way: false,
            };
            assert!(asked.holds(5_000_000).unwrap());
            let text = asked.holds(5_000_001).unwrap_err().to_string();
            tomolith_core::contains!(text, adapter.name.as_str(), "6 MB", "5 MB", "--device cpu");
            let auto = Card {
                gpu,
                gives_way: true,
            };
            assert!(!auto.holds(5_000_001).unwrap());
        }
    }
}

#[cfg(not(feature = "gpu"))]
mod without {
    use super::{Accelerator, Result};
    use crate::dose::form::Form;
    use crate::error::Error;
    use crate::models::{HostModel, Work};

    /// No graphics card: this program was built without them.
    #[derive(Clone, Debug)]
    pub(crate) enum Card {}

    impl Card {
        /// None: the processor.
        pub(crate) fn of(device: Option<&str>) -> Result<Option<Self>> {
            match super::asked(device)? {
                None | Some((_, true)) => Ok(None),
                Some((name, _)) => Err(Error::Device {
                    name: if name.is_empty() { "gpu".to_owned() } else { format!("gpu:{name}") },
                    found: "this program was built without graphics cards; add `--features gpu` to the `cargo install` that builds it, or leave \
                            resources.device out"
                        .to_owned(),
                }),
            }
        }

        pub(crate) fn memory_used(&self) -> Option<String> {
            match *self {}
        }

        pub(crate) fn holds(&self, _bytes: u64) -> Result<bool> {
            match *self {}
        }

        pub(crate) fn version(&self) -> String {
            match *self {}
        }
    }

    impl Accelerator for Card {
        fn model(&self, _: &Form, _: &Work) -> Result<Option<HostModel>> {
            match *self {}
        }
    }
}
