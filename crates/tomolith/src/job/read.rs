//! A job that was read and whose every number is in its range.

use super::document::Document;
use super::kinds::{Family, families, with_defaults};
use super::spec::JobSpec;
use super::validate;
use crate::error::{Error, Result};
use std::path::{Path, PathBuf};

/// A job: its tables, and the text they came from.
#[derive(Clone, Debug)]
pub struct Job {
    /// The text, for messages that say where.
    pub document: Document,
    /// The tables.
    pub spec: JobSpec,
}

impl Job {
    /// Reads a job file, applies overrides (`stop.iterations=10`) and checks every range.
    ///
    /// # Errors
    /// [`Error::Io`]; [`Error::Config`] with key path, file and line, or the override's name.
    pub fn read(file: &Path, overrides: &[String]) -> Result<Self> {
        let mut document = Document::read(file)?;
        overrides
            .iter()
            .try_for_each(|assignment| document.set(assignment))?;
        Self::from_document(document)
    }

    /// A job from a document.
    ///
    /// # Errors
    /// [`Error::Config`] with key path, file and line, or the override's name.
    pub fn from_document(document: Document) -> Result<Self> {
        let spec = JobSpec::from_document(&document)?;
        validate::ranges(&spec).map_err(|e| document.locate(e))?;
        Ok(Job { document, spec })
    }

    /// Its name: the file's, without ending.
    #[must_use]
    pub fn name(&self) -> String {
        let stem = self
            .document
            .file
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned());
        stem.unwrap_or_else(|| "job".to_owned())
    }

    /// The folder that paths of meshes and images are relative to.
    #[must_use]
    pub fn base(&self) -> PathBuf {
        self.document
            .file
            .parent()
            .map(Path::to_owned)
            .unwrap_or_default()
    }

    /// The run folder.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        self.spec
            .output
            .folder
            .clone()
            .unwrap_or_else(|| Path::new("out").join(self.name()))
    }

    /// The job with every default written out, kinds' parameters included, that runs identically from any folder.
    #[must_use]
    pub fn resolved(&self) -> JobSpec {
        let families = families();
        let pages = |name: &str| {
            families
                .iter()
                .find(|f| f.name == name)
                .map_or(&[][..], |f: &Family| &f.kinds)
        };
        let mut spec = self.spec.clone();
        spec.vial.kind = with_defaults(pages("vial"), &spec.vial.kind);
        spec.response = with_defaults(pages("response"), &spec.response);
        spec.optimizer = with_defaults(pages("optimizer"), &spec.optimizer);
        spec.start = with_defaults(pages("start"), &spec.start);
        for objective in spec
            .objective
            .iter_mut()
            .chain(spec.objectives.iter_mut().flatten())
        {
            *objective = with_defaults(pages("objective"), objective);
        }
        spec.output.folder =
            Some(std::path::absolute(self.folder()).unwrap_or_else(|_| self.folder()));
        spec
    }

    /// Adds file and line to an error about one of this job's keys.
    #[must_use]
    pub fn locate(&self, error: Error) -> Error {
        self.document.locate(error)
    }
}
