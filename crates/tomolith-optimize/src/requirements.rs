//! What a method needs of a problem, so that a pair that does not fit is refused with its reason before any work.

use super::Problem;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::Field;

/// Requirements of a method; each is None, or the reason for it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Requirements {
    /// The method's name in job files.
    pub name: &'static str,
    /// Why the model must be linear.
    pub linear: Option<&'static str>,
    /// Why the objective must be convex in the dose.
    pub convex: Option<&'static str>,
    /// Why patterns must not be rounded in every step.
    pub continuous: Option<&'static str>,
    /// Why there must be no penalties on the patterns.
    pub unpenalized: Option<&'static str>,
    /// Why the method must know the target itself.
    pub target: Option<&'static str>,
    /// Why the method must know which voxels lie at the part's surface.
    pub edges: Option<&'static str>,
    /// Why the void of a target of part and void must be allowed some dose; a job tries that before any work.
    pub tolerant: Option<&'static str>,
}

/// Methods that take a model that is not linear, as what is accepted instead.
const NONLINEAR: &str = "; lbfgs, gradient, adam, pm or bclp";

impl Requirements {
    /// A method that takes every problem.
    #[must_use]
    pub fn of(name: &'static str) -> Self {
        Requirements {
            name,
            ..Requirements::default()
        }
    }

    /// Refuses a problem that lacks something.
    ///
    /// # Errors
    /// [`Error::Unsupported`] naming the method, the other key, and why they do not go together.
    pub fn check<F: Field>(&self, problem: &Problem<F>) -> Result<()> {
        let model = problem.model();
        let lacks = [
            (
                self.linear.filter(|_| !model.is_linear()),
                format!("a model that is not linear ({})", model.describe()),
                NONLINEAR,
            ),
            (
                self.convex.filter(|_| !problem.objective().is_convex()),
                "`objective` and `response`, which are not convex together".to_owned(),
                "",
            ),
            (
                self.continuous.filter(|_| problem.levels().is_some()),
                "`bounds.bits`".to_owned(),
                "",
            ),
            (
                self.unpenalized.filter(|_| !problem.penalties().is_empty()),
                "`penalties`".to_owned(),
                "",
            ),
            (
                self.target.filter(|_| problem.target().is_err()),
                "a problem without a target".to_owned(),
                "",
            ),
            (
                self.edges.filter(|_| problem.edges().is_err()),
                "a problem without marks at the surface".to_owned(),
                "",
            ),
        ];
        for (reason, other, instead) in lacks {
            if let Some(reason) = reason {
                return Err(Error::unsupported(
                    format!("optimizer.{} with {other}", self.name),
                    format!("{reason}{instead}"),
                ));
            }
        }
        Ok(())
    }
}
