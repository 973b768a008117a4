//! What a model takes over, unchanged, from the one inside it.

/// Methods of a [`DoseModel`](crate::dose::DoseModel) or [`LinearOperator`](crate::dose::LinearOperator) that a model within gives, in the `impl` of the
/// model around it: `forward!(DoseModel, self => *self.model; patterns, outputs);` names the trait of the model within, the model, and the methods.
/// What a wrapper changes it writes; the compiler says which method is missing or there twice.
#[macro_export]
macro_rules! forward {
    ($of:ident, $this:ident => $inner:expr; $($method:ident),+) => {
        $($crate::forward!(@$method $of, $this, $inner);)+
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
    (@memory $($to:tt)+) => { $crate::forward!(@fn memory() -> Option<Self::Field>; $($to)+); };
    (@restore $($to:tt)+) => { $crate::forward!(@fn restore(memory: &Self::Field) -> (); $($to)+); };
    (@is_renewed $($to:tt)+) => { $crate::forward!(@fn is_renewed() -> bool; $($to)+); };
    (@updates $($to:tt)+) => { $crate::forward!(@fn updates() -> u64; $($to)+); };
    (@describe $($to:tt)+) => { $crate::forward!(@fn describe() -> String; $($to)+); };
    (@of_light $($to:tt)+) => {
        $crate::forward!(@fn of_light(i: usize) -> Option<&dyn $crate::dose::DoseModel<Field = Self::Field>>; $($to)+);
    };
    (@fn $method:ident($($value:ident: $kind:ty),*) -> $found:ty; $of:ident, $this:ident, $inner:expr) => {
        fn $method(&$this $(, $value: $kind)*) -> $found {
            $of::$method(&$inner $(, $value)*)
        }
    };
}
