//! Parallel loops over work that is large per item: blocks of a field, tiles, planes, frames.
//!
//! [`InParallel`] gives every iterator of the standard library `par_each` and `par_map`; [`lines`], [`elements`],
//! [`table`] and [`ranges`] are for many small items.
//!
//! **What it does.** The items are listed first, in the calling thread. Rayon then halves the list 0..n among threads, further where one has
//! stolen work, as it does for its own iterators. Results come in the order of the items, so a sum over them is the same number on any
//! count of threads.
//!
//! **Why not rayon's iterators.** Rayon compiles its splitting, stealing and joining anew for every closure and every chain of adaptors: about
//! 2500 lines of LLVM IR each, a third of all that the crates of numbers gave to the compiler. Here it is compiled once, behind `dyn Fn`.
//!
//! **What it costs.** Per item one entry of a list, one lock that nobody else holds and one call through a pointer: tens of nanoseconds, where a block of
//! [`BLOCK`](crate::field::BLOCK) elements takes 10 µs or more. Where an item is one number, take chunks of them.
//!
//! ```
//! use tomolith_core::parallel::InParallel;
//! let (mut sums, terms) = (vec![1.0; 1000], vec![2.0; 1000]);
//! let blocks = sums.chunks_mut(100).zip(terms.chunks(100));
//! let totals: Vec<f64> = blocks.par_map(|(sums, terms)| {
//!     sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
//!     sums.iter().sum()
//! });
//! assert_eq!(totals, [300.0; 10]);
//! ```

use rayon::iter::ParallelIterator;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// Parts per thread into which many small items are put: enough that nobody waits long for the last one.
const PARTS: usize = 32;

/// Loops over the items of an iterator on all threads.
pub trait InParallel: Iterator<Item: Send> + Sized {
    /// Does `work` with each item.
    fn par_each(self, work: impl Fn(Self::Item) + Sync) {
        let items = listed(self);
        each(&items, &work);
    }

    /// As [`par_each`](Self::par_each), with something that is made once for a row of items, such as memory.
    fn par_each_with<S>(
        self,
        make: impl Fn() -> S + Sync,
        work: impl Fn(&mut S, Self::Item) + Sync,
    ) {
        let items = listed(self);
        ranges(items.len(), &|range| {
            let mut scratch = make();
            range.for_each(|i| work(&mut scratch, taken(&items[i])));
        });
    }

    /// What `apply` makes of each item, in their order.
    fn par_map<R: Send>(self, apply: impl Fn(Self::Item) -> R + Sync) -> Vec<R> {
        let items = listed(self);
        map(&items, &apply)
    }

    /// As [`par_map`](Self::par_map), with something that is made once for a row of items, such as memory.
    fn par_map_with<S, R: Send>(
        self,
        make: impl Fn() -> S + Sync,
        apply: impl Fn(&mut S, Self::Item) -> R + Sync,
    ) -> Vec<R> {
        let items = listed(self);
        let results = empty(items.len());
        ranges(items.len(), &|range| {
            let mut scratch = make();
            range.for_each(|i| put(&results[i], apply(&mut scratch, taken(&items[i]))));
        });
        all(results)
    }
}

impl<I: Iterator<Item: Send>> InParallel for I {}

/// Does `work` with parts of 0..count that cover it once: the only loop of which rayon knows.
pub fn ranges(count: usize, work: &(dyn Fn(Range<usize>) + Sync)) {
    let halves = |range: Range<usize>| {
        let middle = range.start + range.len() / 2;
        let splits = range.len() > 1;
        let first = if splits {
            range.start..middle
        } else {
            range.clone()
        };
        (first, splits.then_some(middle..range.end))
    };
    if count > 0 {
        rayon::iter::split(0..count, halves).for_each(work);
    }
}

/// Does `work` with each line of `len` elements (the last may be shorter) and its number, many lines in a row.
pub fn lines<T: Send>(values: &mut [T], len: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    let count = in_a_row(values.len().div_ceil(len));
    let rows = values.chunks_mut(count * len).enumerate();
    rows.par_each(|(row, values)| {
        let lines = values.chunks_mut(len).enumerate();
        lines.for_each(|(i, line)| work(row * count + i, line));
    });
}

/// Does `work` with each element and its number, many in a row.
pub fn elements<T: Send>(values: &mut [T], work: impl Fn(usize, &mut T) + Sync) {
    let count = in_a_row(values.len());
    let rows = values.chunks_mut(count).enumerate();
    rows.par_each(|(row, values)| {
        let elements = values.iter_mut().enumerate();
        elements.for_each(|(i, value)| work(row * count + i, value));
    });
}

/// The numbers `value_of(0)`, `value_of(1)`, … up to `count`.
pub fn table<R: Copy + Default + Send>(
    count: usize,
    value_of: impl Fn(usize) -> R + Sync,
) -> Vec<R> {
    let mut values = vec![R::default(); count];
    elements(&mut values, |i, value| *value = value_of(i));
    values
}

/// How many of these items one thread does in a row.
fn in_a_row(items: usize) -> usize {
    items.div_ceil(PARTS * rayon::current_num_threads()).max(1)
}

/// An item until its thread takes it, a result once its thread has put it.
type Slot<T> = Mutex<Option<T>>;

fn each<T: Send>(items: &[Slot<T>], work: &(dyn Fn(T) + Sync)) {
    ranges(items.len(), &|range| {
        range.for_each(|i| work(taken(&items[i])));
    });
}

fn map<T: Send, R: Send>(items: &[Slot<T>], apply: &(dyn Fn(T) -> R + Sync)) -> Vec<R> {
    let results = empty(items.len());
    ranges(items.len(), &|range| {
        range.for_each(|i| put(&results[i], apply(taken(&items[i]))));
    });
    all(results)
}

// Loops where the standard library has `collect`, which compiles to several times as much

fn listed<T>(items: impl Iterator<Item = T>) -> Vec<Slot<T>> {
    let mut slots = Vec::with_capacity(items.size_hint().0);
    for item in items {
        slots.push(Mutex::new(Some(item)));
    }
    slots
}

fn empty<R>(count: usize) -> Vec<Slot<R>> {
    let mut slots = Vec::with_capacity(count);
    slots.resize_with(count, || Mutex::new(None));
    slots
}

fn all<R>(slots: Vec<Slot<R>>) -> Vec<R> {
    let mut results = Vec::with_capacity(slots.len());
    for slot in slots {
        let result = slot.into_inner().unwrap_or_else(PoisonError::into_inner);
        results.extend(result);
    }
    results
}

fn taken<T>(slot: &Slot<T>) -> T {
    let mut slot = slot.lock().unwrap_or_else(PoisonError::into_inner);
    slot.take().expect("ranges do not overlap")
}

fn put<T>(slot: &Slot<T>, value: T) {
    *slot.lock().unwrap_or_else(PoisonError::into_inner) = Some(value);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_done_once_and_results_keep_their_order() {
        for count in [0, 1, 2, 1000, 10_000] {
            assert_eq!((0..count).par_map(|i| i * i), table(count, |i| i * i));
            let mut values = vec![0; count];
            values
                .chunks_mut(7)
                .enumerate()
                .par_each(|(chunk, values)| {
                    (0..)
                        .zip(values)
                        .for_each(|(i, value)| *value += chunk * 7 + i);
                });
            assert!(values.into_iter().eq(0..count));
        }
    }

    #[test]
    fn memory_is_made_for_rows_of_items_not_for_each() {
        let made = Mutex::new(0);
        let make = || {
            *made.lock().unwrap() += 1;
            Vec::new()
        };
        let seen = (0..100_000).par_map_with(make, |row, i| {
            row.push(i);
            *row.last().unwrap()
        });
        assert!(seen.into_iter().eq(0..100_000));
        assert!(*made.lock().unwrap() < 10_000);
        (0..100).par_each_with(String::new, |text, _| text.push('.'));
    }
}
