//! Fields that calls borrow and give back.
//!
//! Memory that was used lately costs less than memory that the system hands out anew, page by page: a field of 5 million elements takes some 10 ms to come.
//!
//! ```
//! use tomolith_core::field::{Field, scratch::Scratch};
//! let scratch = Scratch::default();
//! let norm = scratch.lend(4, |field| {
//!     field.fill(2.0);
//!     field.norm()
//! });
//! assert_eq!(norm, 4.0); // √(4·2²)
//! ```

use super::{Field, HostField};
use std::sync::{Mutex, PoisonError};

/// See the [module page](self). What a borrowed field holds is what its last user left.
#[derive(Debug)]
pub struct Scratch<F = HostField>(Mutex<Vec<F>>);

impl<F> Default for Scratch<F> {
    fn default() -> Self {
        Scratch(Mutex::default())
    }
}

impl<F: Field> Scratch<F> {
    /// A field of so many elements, to be [given back](Self::give_back); None where none waits.
    pub fn take(&self, len: usize) -> Option<F> {
        let mut pool = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let found = pool.iter().position(|field| field.len() == len);
        found.map(|i| pool.swap_remove(i))
    }

    /// Takes a field back.
    pub fn give_back(&self, field: F) {
        let mut pool = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        pool.push(field);
    }
}

impl Scratch {
    /// A field of so many elements, to be [given back](Self::give_back).
    #[must_use]
    pub fn borrow(&self, len: usize) -> HostField {
        self.take(len).unwrap_or_else(|| HostField::zeros(len))
    }

    /// What comes of a field of so many elements, which is given back after that.
    pub fn lend<R>(&self, len: usize, with: impl FnOnce(&mut HostField) -> R) -> R {
        let mut field = self.borrow(len);
        let found = with(&mut field);
        self.give_back(field);
        found
    }
}
