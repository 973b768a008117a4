//! Patterns → absorbed dose: what a model of light is, whoever computes it.
//!
//! A [`DoseModel`] is F of the one equation; [`Facts`] say whether it is linear (rays are; coherent waves are not).
//! *Forward is the printer's direction: light goes from patterns to dose* (computed tomography calls that back-projection).
//! Layouts say which pixel and which voxel an element of a field is.

pub mod cells;
pub mod form;
pub mod layout;
pub mod paths;
pub mod rays;
pub mod regions;
pub mod scattered;
pub mod strips;
pub mod waves;

use crate::error::Result;
use crate::field::{Field, HostField};
use crate::grid::VolumeGrid;
pub use crate::work::{Steps, Work};
use form::Form;
pub use layout::{DoseLayout, PatternLayout, Quantity, elements_of, frames_of, own_frames};
pub use regions::Regions;
use std::ops::Range;
use std::sync::Arc;

/// How far along z a pattern row reaches: whether a job may be cut into z slabs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ZCoupling {
    /// Rows light their own heights only.
    None,
    /// Rows light heights up to this distance, mm.
    Halo(f64),
    /// No bound.
    Full,
}

impl ZCoupling {
    /// The coupling that reaches farthest of several; none of none.
    pub fn widest(all: impl IntoIterator<Item = ZCoupling>) -> ZCoupling {
        let wider = |a, b| match (a, b) {
            (ZCoupling::Full, _) | (_, ZCoupling::Full) => ZCoupling::Full,
            (ZCoupling::Halo(a), ZCoupling::Halo(b)) => ZCoupling::Halo(a.max(b)),
            (ZCoupling::None, other) | (other, ZCoupling::None) => other,
        };
        all.into_iter().fold(ZCoupling::None, wider)
    }
}

/// What a field of a model holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// The patterns of all lights.
    Patterns,
    /// The doses of all species.
    Dose,
}

/// What a dose model is, apart from its work. A model around another changes what differs: `Facts { is_linear: false, ..inner.facts() }`.
#[derive(Clone, Copy, Debug)]
pub struct Facts<'a> {
    /// The layout of the patterns of each light.
    pub patterns: &'a [PatternLayout],
    /// The layout of the dose of each species.
    pub outputs: &'a [DoseLayout],
    /// How far a row reaches along z.
    pub z_coupling: ZCoupling,
    /// Whether F is linear, so that F(x + αd) = F(x) + αF(d): one dose call serves a whole line search.
    pub is_linear: bool,
}

impl Facts<'_> {
    /// Numbers of a field.
    #[must_use]
    pub fn len(&self, space: Space) -> usize {
        match space {
            Space::Patterns => self.patterns.iter().map(PatternLayout::len).sum(),
            Space::Dose => self.outputs.iter().map(DoseLayout::len).sum(),
        }
    }

    /// Zeros in the memory of the host.
    #[must_use]
    pub fn host_field(&self, space: Space) -> HostField {
        HostField::zeros(self.len(space))
    }
}

/// How a map becomes another one between iterations: it draws other Monte Carlo paths, or simulates a print anew.
pub trait Renewal<F> {
    /// Before the step of an iteration (the first is 1) from patterns `x`: renews the map where the model's schedule wants it, and says whether
    /// it did.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled), and what refuses a simulation.
    fn renew(&self, iteration: usize, x: &F, work: &Work) -> Result<bool>;
    /// What earlier patterns have left in the map, where the number of the iteration does not tell: checkpoints keep it.
    fn memory(&self) -> Option<F> {
        None
    }
    /// Makes the map that which had this [memory](Self::memory).
    fn restore(&self, _memory: &F) {}
}

/// A map from patterns to dose with its exact derivative.
///
/// Patterns of all lights lie one after the other in one field, and so do the doses of all species; the layouts say
/// where. The field layouts are the model's own; [`PatternLayout`] and [`DoseLayout`] translate to array order.
pub trait DoseModel: Send + Sync {
    /// Where the numbers live.
    type Field: Field;

    /// What the model is, apart from its work.
    fn facts(&self) -> Facts<'_>;
    /// The layouts of its patterns: [`Facts::patterns`].
    fn patterns(&self) -> &[PatternLayout] {
        self.facts().patterns
    }
    /// The layouts of its doses: [`Facts::outputs`].
    fn outputs(&self) -> &[DoseLayout] {
        self.facts().outputs
    }
    /// [`Facts::z_coupling`].
    fn z_coupling(&self) -> ZCoupling {
        self.facts().z_coupling
    }
    /// [`Facts::is_linear`].
    fn is_linear(&self) -> bool {
        self.facts().is_linear
    }
    /// What the unknowns of all lights are.
    fn quantity(&self) -> Quantity {
        self.patterns()[0].quantity
    }
    /// The voxels that all doses are on.
    fn grid(&self) -> &VolumeGrid {
        &self.outputs()[0].grid
    }
    /// Zeros as patterns or as a dose.
    ///
    /// # Errors
    /// When there is not enough memory.
    fn new_field(&self, space: Space) -> Result<Self::Field>;
    /// Dark patterns.
    ///
    /// # Errors
    /// When there is not enough memory.
    fn new_patterns(&self) -> Result<Self::Field> {
        self.new_field(Space::Patterns)
    }
    /// Zero dose.
    ///
    /// # Errors
    /// When there is not enough memory.
    fn new_dose(&self) -> Result<Self::Field> {
        self.new_field(Space::Dose)
    }
    /// F(x); overwrites `dose`. By default that of all frames.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn dose(&self, x: &Self::Field, dose: &mut Self::Field, work: &Work) -> Result<()> {
        dose.fill(0.0);
        self.dose_of(0..frames_of(self.patterns()), x, dose, work)
    }
    /// F′(x)ᵀ c; overwrites `grad`. By default that of all frames.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn pullback(
        &self,
        x: &Self::Field,
        cotangent: &Self::Field,
        grad: &mut Self::Field,
        work: &Work,
    ) -> Result<()> {
        self.pullback_of(0..frames_of(self.patterns()), x, cotangent, grad, work)
    }
    /// Dose of some frames only, *added* to `dose`: printing in time, streaming, sharding by angle.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &Self::Field,
        dose: &mut Self::Field,
        work: &Work,
    ) -> Result<()>;
    /// The elements of F′(x)ᵀ c that belong to some frames: *overwrites* these of `grad` and leaves all others. Linear models do not look at x.
    ///
    /// # Errors
    /// As [`pullback`](Self::pullback).
    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &Self::Field,
        cotangent: &Self::Field,
        grad: &mut Self::Field,
        work: &Work,
    ) -> Result<()>;
    /// α ↦ F(x + α d) − F(x) as coefficient fields of α, α² … (`[F(d)]` for linear models), or None where it is no polynomial: the default of
    /// models that are not linear. Searches know F(x).
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled), or not enough memory.
    fn along(
        &self,
        _x: &Self::Field,
        d: &Self::Field,
        work: &Work,
    ) -> Result<Option<Vec<Self::Field>>> {
        if !self.is_linear() {
            return Ok(None);
        }
        let mut term = self.new_dose()?;
        self.dose(d, &mut term, work)?;
        Ok(Some(vec![term]))
    }
    /// How the map changes between iterations, if it ever does.
    fn renewal(&self) -> Option<&dyn Renewal<Self::Field>> {
        None
    }
    /// Voxel-angle updates of one dose call after all masks: what throughput is counted in.
    fn updates(&self) -> u64;
    /// The model of light `i` alone, with one output, where the doses of the lights are computed one by one; None where they are not.
    fn of_light(&self, _i: usize) -> Option<Arc<dyn DoseModel<Field = Self::Field>>> {
        None
    }
    /// What it is on a card, as data; None where it is computed by the processor.
    fn form(&self) -> Option<Form> {
        None
    }
    /// Regions of voxels whose doses can be left out; None where the model cannot tell them apart.
    fn regions(&self) -> Option<&dyn Regions<Self::Field>> {
        None
    }
    /// One line for people: which model, which kernel.
    fn describe(&self) -> String;
}

/// Where dose models are computed in place of the processor.
pub trait Accelerator: std::fmt::Debug + Send + Sync {
    /// The model of a form, whose fields are the host's: they are copied there and back. None where the processor is to do it.
    ///
    /// # Errors
    /// [`Error::Device`](crate::Error::Device), [`Error::Canceled`](crate::Error::Canceled); [`Error::Resources`](crate::Error::Resources) where it is
    /// too small.
    fn model(
        &self,
        form: &Form,
        work: &Work,
    ) -> Result<Option<Box<dyn DoseModel<Field = crate::field::HostField>>>>;
}
