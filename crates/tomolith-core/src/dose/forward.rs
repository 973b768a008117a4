//! What a model takes over, unchanged, from the one inside it.

/// In the `impl` of a model round another, what that one says of itself: `forward!(self => *self.model; all but describe);` hands all methods of
/// [`DoseModel`](crate::dose::DoseModel) through but those that are named, and those that give light. A method that is named and not written has the
/// default of the trait. The compiler says which one is missing or there twice.
///
/// The model around writes `dose_of` and `pullback_of`. `dose`, `pullback` and `along` follow from these, unless it knows better; so nothing passes it by.
///
/// A model that takes over little names it, and the trait of the model within: `forward!(LinearOperator, self => *self.model; patterns, outputs);`.
///
/// What joins `DoseModel` joins `all` and gets its two lines below: all models round others hand it through then.
#[macro_export]
macro_rules! forward {
    ($this:ident => $inner:expr; all $(but $($own:ident),+)?) => {
        $crate::forward!(@all [$($($own)+)?] $this, $inner; patterns outputs new_patterns new_dose z_coupling is_linear renew is_renewed memory restore updates describe);
    };
    ($of:ident, $this:ident => $inner:expr; $($method:ident),+) => {
        $($crate::forward!(@$method $of, $this, $inner);)+
    };
    (@all $own:tt $this:ident, $inner:expr; $($method:ident)+) => {
        $($crate::forward!(@but $own $method DoseModel, $this, $inner);)+
    };
    (@fn $method:ident($($value:ident: $kind:ty),*) -> $found:ty; $of:ident, $this:ident, $inner:expr) => {
        fn $method(&$this $(, $value: $kind)*) -> $found {
            $of::$method(&$inner $(, $value)*)
        }
    };
    (@patterns $($to:tt)+) => { $crate::forward!(@fn patterns() -> &[$crate::dose::PatternLayout]; $($to)+); };
    (@outputs $($to:tt)+) => { $crate::forward!(@fn outputs() -> &[$crate::dose::DoseLayout]; $($to)+); };
    (@new_patterns $($to:tt)+) => { $crate::forward!(@fn new_patterns() -> $crate::error::Result<Self::Field>; $($to)+); };
    (@new_dose $($to:tt)+) => { $crate::forward!(@fn new_dose() -> $crate::error::Result<Self::Field>; $($to)+); };
    (@z_coupling $($to:tt)+) => { $crate::forward!(@fn z_coupling() -> $crate::dose::ZCoupling; $($to)+); };
    (@is_linear $($to:tt)+) => { $crate::forward!(@fn is_linear() -> bool; $($to)+); };
    (@renew $($to:tt)+) => {
        $crate::forward!(@fn renew(iteration: usize, x: &Self::Field, run: &$crate::dose::Run) -> $crate::error::Result<bool>; $($to)+);
    };
    (@is_renewed $($to:tt)+) => { $crate::forward!(@fn is_renewed() -> bool; $($to)+); };
    (@memory $($to:tt)+) => { $crate::forward!(@fn memory() -> Option<Self::Field>; $($to)+); };
    (@restore $($to:tt)+) => { $crate::forward!(@fn restore(memory: &Self::Field) -> (); $($to)+); };
    (@updates $($to:tt)+) => { $crate::forward!(@fn updates() -> u64; $($to)+); };
    (@strips $($to:tt)+) => { $crate::forward!(@fn strips() -> Option<$crate::dose::strips::StripForm>; $($to)+); };
    (@describe $($to:tt)+) => { $crate::forward!(@fn describe() -> String; $($to)+); };
    (@of_light $($to:tt)+) => { $crate::forward!(@fn of_light(i: usize) -> Option<std::sync::Arc<dyn $crate::dose::DoseModel<Field = Self::Field>>>; $($to)+); };
    // What the model around writes is left out
    (@but [patterns $($own:ident)*] patterns $($to:tt)+) => {};
    (@but [outputs $($own:ident)*] outputs $($to:tt)+) => {};
    (@but [new_patterns $($own:ident)*] new_patterns $($to:tt)+) => {};
    (@but [new_dose $($own:ident)*] new_dose $($to:tt)+) => {};
    (@but [z_coupling $($own:ident)*] z_coupling $($to:tt)+) => {};
    (@but [is_linear $($own:ident)*] is_linear $($to:tt)+) => {};
    (@but [renew $($own:ident)*] renew $($to:tt)+) => {};
    (@but [is_renewed $($own:ident)*] is_renewed $($to:tt)+) => {};
    (@but [memory $($own:ident)*] memory $($to:tt)+) => {};
    (@but [restore $($own:ident)*] restore $($to:tt)+) => {};
    (@but [updates $($own:ident)*] updates $($to:tt)+) => {};
    (@but [describe $($own:ident)*] describe $($to:tt)+) => {};
    (@but [$other:ident $($own:ident)*] $($to:tt)+) => { $crate::forward!(@but [$($own)*] $($to)+); };
    (@but [] $($to:tt)+) => { $crate::forward!(@$($to)+); };
}

/// In the `impl` of a model that holds its layouts, these and new fields of the host for them:
/// `host_fields!(self => self.patterns, self.outputs);`.
#[macro_export]
macro_rules! host_fields {
    ($this:ident => $patterns:expr, $outputs:expr) => {
        fn patterns(&$this) -> &[$crate::dose::PatternLayout] {
            &$patterns
        }
        fn outputs(&$this) -> &[$crate::dose::DoseLayout] {
            &$outputs
        }
        fn new_patterns(&$this) -> $crate::error::Result<$crate::field::HostField> {
            let lengths = $patterns.iter().map($crate::dose::PatternLayout::len);
            Ok($crate::field::HostField::zeros(lengths.sum()))
        }
        fn new_dose(&$this) -> $crate::error::Result<$crate::field::HostField> {
            let lengths = $outputs.iter().map($crate::dose::DoseLayout::len);
            Ok($crate::field::HostField::zeros(lengths.sum()))
        }
    };
}
