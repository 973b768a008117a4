//! A field whose elements the library cannot see: one of the host behind the trait.
//!
//! Every operation is the host's, so what knows fields by the trait alone gets the host's bits.

use std::sync::Arc;
use tomolith_core::error::Result;
use tomolith_core::field::{
    BandKernel, BandLoss, Bounds, CostKernel, Direction, DirectionSums, Field, HalfRamp,
    HalfRampKernel, HostField, Latest, Pairs, PairsPart, PatternCost, Products, Secant, StepSums,
};

type HostBounds = <HostField as Field>::Bounds;

/// The field.
#[derive(Clone)]
pub(crate) struct SealedField(pub(crate) HostField);

/// What is compiled for such fields: the host's.
pub(crate) struct Sealed<T>(T);

/// Operations that are passed on: arguments that are fields, then those that are not.
macro_rules! pass_on {
    ($($name:ident($($field:ident),*; $($other:ident: $type:ty),*) $(-> $out:ty)?;)*) => {$(
        fn $name(&self $(, $field: &Self)* $(, $other: $type)*) $(-> $out)? {
            self.0.$name($(&$field.0,)* $($other),*)
        }
    )*};
    (mut $($name:ident($($field:ident),*; $($other:ident: $type:ty),*) $(-> $out:ty)?;)*) => {$(
        fn $name(&mut self $(, $field: &Self)* $(, $other: $type)*) $(-> $out)? {
            self.0.$name($(&$field.0,)* $($other),*)
        }
    )*};
}

impl Field for SealedField {
    type Bounds = HostBounds;
    type Pairs = Sealed<<HostField as Field>::Pairs>;
    type Bands = Sealed<<HostField as Field>::Bands>;
    type Costs = Sealed<<HostField as Field>::Costs>;
    type HalfRamp = Sealed<<HostField as Field>::HalfRamp>;

    fn zeros_like(&self) -> Self {
        SealedField(self.0.zeros_like())
    }

    fn axpy(&mut self, a: f32, x: &Self) {
        self.0.axpy(a, &x.0);
    }

    fn mix(&mut self, keep: f32, x: &Self) {
        self.0.mix(keep, &x.0);
    }

    fn mix_squares(&mut self, keep: f32, x: &Self) {
        self.0.mix_squares(keep, &x.0);
    }

    pass_on! {
        len(;) -> usize;
        to_host(;) -> Vec<f32>;
        dot(other;) -> f64;
        max_abs(;) -> f32;
        max_marked(marks;) -> f32;
        lowest(;) -> f32;
        compile_bounds(; bounds: &Bounds) -> HostBounds;
        secant(before, after;) -> Secant;
    }

    pass_on! {
        mut
        copy_from(other;);
        fill(; value: f32);
        write(; begin: usize, values: &[f32]);
        scale(; a: f32);
        shift(; a: f32);
        clamp(; lower: f32, upper: f32);
        multiply(other;);
        keep_positive(marks;);
        divide_by_roots(squares; factor: f32, epsilon: f32);
        logistic_error(target; midpoint: f32, width: f32);
        move_along(step; a: f32, bounds: &HostBounds);
        project_step(x, gradient; t: f32, bounds: &HostBounds) -> StepSums;
        quantize(; levels: u32, bounds: &HostBounds);
        free_gradient(x, gradient; bounds: &HostBounds);
        change_where_moved(step, before, after;);
    }
}

impl<P: Pairs<HostField>> Pairs<SealedField> for Sealed<P>
where
    HostField: Field<Pairs = P>,
{
    const MAX_MEMORY: usize = P::MAX_MEMORY;

    fn new(slots: usize, bounds: &HostBounds) -> Self {
        Sealed(P::new(slots, bounds))
    }

    fn record(
        &mut self,
        slot: usize,
        latest: &Latest<SealedField>,
        bounds: &HostBounds,
    ) -> Products {
        let latest = Latest {
            x: &latest.x.0,
            step: &latest.step.0,
            alpha: latest.alpha,
            gradient: &latest.gradient.0,
            change: &latest.change.0,
            image: &latest.image.0,
        };
        self.0.record(slot, &latest, bounds)
    }

    fn direction(
        &self,
        direction: &Direction,
        x: &SealedField,
        gradient: &SealedField,
        image: &SealedField,
        bounds: &HostBounds,
        out: &mut SealedField,
    ) -> DirectionSums {
        let [x, gradient, image] = [x, gradient, image].map(|field| &field.0);
        self.0
            .direction(direction, x, gradient, image, bounds, &mut out.0)
    }

    fn parts(&self) -> Vec<PairsPart<'_>> {
        self.0.parts()
    }

    fn restore(&mut self, read: &mut dyn FnMut(&str, &mut [u8]) -> Result<()>) -> Result<()> {
        self.0.restore(read)
    }
}

impl<B: BandKernel<HostField>> BandKernel<SealedField> for Sealed<B> {
    fn new(loss: &Arc<BandLoss>, like: &SealedField) -> Self {
        Sealed(B::new(loss, &like.0))
    }

    fn value(&self, dose: &SealedField) -> f64 {
        self.0.value(&dose.0)
    }

    fn value_and_gradient(&self, dose: &SealedField, grad: &mut SealedField) -> f64 {
        self.0.value_and_gradient(&dose.0, &mut grad.0)
    }

    fn slope_along(&self, dose: &SealedField, step: &SealedField, alpha: f32) -> (f64, f64) {
        self.0.slope_along(&dose.0, &step.0, alpha)
    }

    fn advance(&self, dose: &mut SealedField, step: &mut SealedField, alpha: f32) -> f64 {
        self.0.advance(&mut dose.0, &mut step.0, alpha)
    }
}

impl<C: CostKernel<HostField>> CostKernel<SealedField> for Sealed<C> {
    fn new(cost: &Arc<PatternCost>, like: &SealedField) -> Self {
        Sealed(C::new(cost, &like.0))
    }

    fn value(&self, x: &SealedField) -> f64 {
        self.0.value(&x.0)
    }

    fn add_gradient(&self, x: &SealedField, scale: f64, gradient: &mut SealedField) -> f64 {
        self.0.add_gradient(&x.0, scale, &mut gradient.0)
    }

    fn slope_along(&self, x: &SealedField, step: &SealedField, alpha: f32) -> (f64, f64) {
        self.0.slope_along(&x.0, &step.0, alpha)
    }
}

impl<H: HalfRampKernel<HostField>> HalfRampKernel<SealedField> for Sealed<H> {
    fn new(ramp: HalfRamp, like: &SealedField) -> Self {
        Sealed(H::new(ramp, &like.0))
    }

    fn apply(&self, x: &SealedField, out: &mut SealedField) {
        self.0.apply(&x.0, &mut out.0);
    }
}
