//! Several processes that work on one job, each with a share of the frames: who has which, and what they tell each other.
//!
//! **Equation** Rank r has the frames S_r, and of patterns, gradients and a method's vectors the elements x_r of these
//!
//! ```text
//! F(x) = Σ_r F_r(x_r)        (F′(x)ᵀ c)_r = F_r′(x_r)ᵀ c        ⟨x, y⟩ = Σ_r ⟨x_r, y_r⟩
//! ```
//!
//! so a dose is summed over ranks, a gradient stays where it is, and what a field says of all its elements
//! ([`HostField::shared`](crate::field::HostField::shared)) is summed or compared over ranks. Doses are whole on every rank.
//!
//! **Lockstep** All ranks make the same calls in the same order: each decides by numbers that have the same bits everywhere. What only one of
//! them knows (its clock, an error, a request to stop) is shared before anybody acts on it: [`any`](Communicator::any), [`together`].
//!
//! **Shares** A light's frames are cut into as many shares as there are ranks. Opposite frames stay together, since a model may compute both
//! at once; see [`frames_of_rank`].
//!
//! **Implementations** [`Threads`] within a process; one of MPI is in the command (feature `mpi`).
//!
//! ```
//! use tomolith_core::ranks::{Communicator, Threads, frames_of_rank};
//! // Two ranks, each with a number of its own
//! let sums: Vec<f64> = std::thread::scope(|scope| {
//!     let ranks = Threads::ranks(2).into_iter();
//!     let work = |rank: Threads| {
//!         let mut sum = [1.0 + rank.rank() as f64];
//!         rank.all_reduce(&mut sum);
//!         sum[0]
//!     };
//!     let threads: Vec<_> = ranks.map(|rank| scope.spawn(move || work(rank))).collect();
//!     threads.into_iter().map(|thread| thread.join().unwrap()).collect()
//! });
//! assert_eq!(sums, [3.0, 3.0]);
//! // Of eight frames the second of two ranks has a quarter turn and the opposite one
//! assert_eq!(frames_of_rank(8, 1, 2), [2, 3, 6, 7]);
//! ```

use crate::dose::PatternLayout;
use crate::error::{Error, Result};
use std::fmt::Debug;
use std::ops::Range;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

/// One of several ranks, and its way to the others. Every method is called by all ranks, or by none.
pub trait Communicator: Debug + Send + Sync {
    /// Which of the ranks this is, from 0.
    fn rank(&self) -> usize;
    /// How many there are.
    fn size(&self) -> usize;
    /// Each number becomes the sum of those of all ranks, with the same bits on every rank.
    fn all_reduce(&self, values: &mut [f64]);
    /// [`all_reduce`](Self::all_reduce) in single precision.
    fn all_reduce_f32(&self, values: &mut [f32]);
    /// What each rank gives, in the order of ranks, on rank 0; nothing on the others.
    fn gather(&self, values: &[f32]) -> Vec<Vec<f32>>;
    /// Overwrites with what rank 0 has; as many numbers on every rank.
    fn broadcast(&self, values: &mut [f32]);

    /// How many of the ranks run on this one's machine, itself included.
    fn beside(&self) -> usize {
        self.size()
    }

    /// Whether this is the rank that speaks and writes.
    fn is_first(&self) -> bool {
        self.rank() == 0
    }

    /// The largest number of all ranks, NaN if any is.
    fn largest(&self, value: f32) -> f32 {
        let all = self.gather(&[value]);
        let larger = |a: f32, &b: &f32| {
            if a.is_nan() || b.is_nan() {
                f32::NAN
            } else {
                a.max(b)
            }
        };
        let mut largest = [all.iter().flatten().fold(f32::NEG_INFINITY, larger)];
        self.broadcast(&mut largest);
        largest[0]
    }

    /// Whether any rank says yes.
    fn any(&self, yes: bool) -> bool {
        let mut count = [f64::from(u8::from(yes))];
        self.all_reduce(&mut count);
        count[0] > 0.0
    }
}

/// What a rank reports of its work: it is done, got a request to stop, or failed.
fn code<T>(result: &Result<T>) -> f32 {
    match result {
        Ok(_) => 0.0,
        Err(Error::Canceled) => 1.0,
        Err(_) => 2.0,
    }
}

/// What a rank has, if all ranks have theirs: where one failed, all stop. Called by all ranks.
///
/// # Errors
/// This rank's own; [`Error::Rank`] where another failed, and where rank 0 failed too, which then speaks for all; [`Error::Canceled`] where
/// another got a request to stop.
pub fn together<T>(ranks: &dyn Communicator, result: Result<T>) -> Result<T> {
    let all = ranks.gather(&[code(&result)]);
    let mut codes: Vec<f32> = all.into_iter().flatten().collect();
    codes.resize(ranks.size(), 0.0);
    ranks.broadcast(&mut codes);
    let failed = codes.iter().position(|&code| code > 1.0);
    match (result, failed) {
        (Err(error), _) if ranks.is_first() => Err(error),
        (_, Some(0)) => Err(Error::Rank { rank: 0 }),
        (Err(error), _) => Err(error),
        (Ok(_), Some(rank)) => Err(Error::Rank { rank }),
        (Ok(_), None) if codes.iter().any(|&code| code > 0.0) => Err(Error::Canceled),
        (Ok(value), None) => Ok(value),
    }
}

/// The frames of a rank, of so many frames of a light: of an even number a part of the first half and what is opposite to it, else neighbors.
/// Every frame belongs to one rank; no rank is without frames where there are as many as ranks.
#[must_use]
pub fn frames_of_rank(frames: usize, rank: usize, size: usize) -> Vec<usize> {
    let part = |count: usize| rank * count / size..(rank + 1) * count / size;
    let half = frames / 2;
    if frames.is_multiple_of(2) && half >= size {
        return part(half)
            .chain(part(half).map(|frame| half + frame))
            .collect();
    }
    part(frames).collect()
}

/// Where the elements of each rank lie in the pattern field of the whole job.
#[derive(Clone, Debug)]
pub struct Shares {
    ranks: Arc<dyn Communicator>,
    /// Elements of every rank in the whole field, in the order in which the rank has them.
    pieces: Vec<Vec<Range<usize>>>,
}

impl Shares {
    /// Of lights with so many frames in all, and with these layouts on this rank. Called by all ranks.
    #[must_use]
    pub fn new(ranks: Arc<dyn Communicator>, frames: &[usize], layouts: &[PatternLayout]) -> Self {
        let mut lengths = vec![0.0; frames.iter().sum()];
        let mut first = 0;
        for (&frames, layout) in frames.iter().zip(layouts) {
            let chosen = frames_of_rank(frames, ranks.rank(), ranks.size());
            for (i, frame) in chosen.into_iter().enumerate() {
                lengths[first + frame] = layout.elements_of(i..i + 1).len() as f64;
            }
            first += frames;
        }
        ranks.all_reduce(&mut lengths);
        let mut ends = vec![0];
        for length in lengths {
            ends.push(ends[ends.len() - 1] + length as usize);
        }
        let of_rank = |rank: usize| {
            let mut pieces = Vec::new();
            let mut first = 0;
            for &frames in frames {
                let chosen = frames_of_rank(frames, rank, ranks.size()).into_iter();
                pieces.extend(chosen.map(|frame| ends[first + frame]..ends[first + frame + 1]));
                first += frames;
            }
            pieces
        };
        Shares {
            pieces: (0..ranks.size()).map(of_rank).collect(),
            ranks,
        }
    }

    /// The ranks.
    #[must_use]
    pub fn ranks(&self) -> &Arc<dyn Communicator> {
        &self.ranks
    }

    /// Elements of the whole field.
    #[must_use]
    pub fn len(&self) -> usize {
        self.pieces.iter().flatten().map(Range::len).sum()
    }

    /// Whether there is no element.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The whole field on rank 0, nothing on the others. Called by all ranks, each with its own elements.
    #[must_use]
    pub fn whole(&self, local: &[f32]) -> Vec<f32> {
        let all = self.ranks.gather(local);
        if !self.ranks.is_first() {
            return Vec::new();
        }
        let mut whole = vec![0.0; self.len()];
        for (mut values, pieces) in all.iter().map(Vec::as_slice).zip(&self.pieces) {
            for piece in pieces {
                let part = values.split_off(..piece.len()).unwrap_or_default();
                whole[piece.clone()].copy_from_slice(part);
            }
        }
        whole
    }

    /// This rank's elements of a whole field.
    ///
    /// # Panics
    /// When the field is shorter than [`len`](Self::len).
    #[must_use]
    pub fn own(&self, whole: &[f32]) -> Vec<f32> {
        let pieces = self.pieces[self.ranks.rank()].iter();
        pieces
            .flat_map(|piece| whole[piece.clone()].iter().copied())
            .collect()
    }
}

/// Ranks within a process, a thread each.
///
/// Where a rank ends while another waits for it, the other one panics.
#[derive(Debug)]
pub struct Threads {
    rank: usize,
    size: usize,
    shared: Arc<(Mutex<Exchange>, Condvar)>,
}

/// What the ranks of a process tell each other.
#[derive(Debug, Default)]
struct Exchange {
    sent: Vec<Option<Vec<f64>>>,
    /// What all have reported in the last round.
    heard: Arc<Vec<Vec<f64>>>,
    rounds: usize,
    is_left: bool,
}

impl Threads {
    /// So many ranks, each for a separate thread.
    #[must_use]
    pub fn ranks(size: usize) -> Vec<Self> {
        let sent = vec![None; size];
        let exchange = Exchange {
            sent,
            ..Exchange::default()
        };
        let shared = Arc::new((Mutex::new(exchange), Condvar::new()));
        let thread_of = |rank| Threads {
            rank,
            size,
            shared: Arc::clone(&shared),
        };
        (0..size).map(thread_of).collect()
    }

    fn lock(&self) -> MutexGuard<'_, Exchange> {
        self.shared.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What every rank tells, once all have.
    fn exchange(&self, values: Vec<f64>) -> Arc<Vec<Vec<f64>>> {
        let mut exchange = self.lock();
        let round = exchange.rounds;
        exchange.sent[self.rank] = Some(values);
        if exchange.sent.iter().all(Option::is_some) {
            let heard = exchange.sent.iter_mut().filter_map(Option::take).collect();
            exchange.heard = Arc::new(heard);
            exchange.rounds += 1;
            self.shared.1.notify_all();
        }
        while exchange.rounds == round {
            assert!(!exchange.is_left, "another rank has ended");
            exchange = (self.shared.1.wait(exchange)).unwrap_or_else(PoisonError::into_inner);
        }
        Arc::clone(&exchange.heard)
    }
}

impl Drop for Threads {
    fn drop(&mut self) {
        self.lock().is_left = true;
        self.shared.1.notify_all();
    }
}

fn wide(values: &[f32]) -> Vec<f64> {
    values.iter().copied().map(f64::from).collect()
}

fn narrow(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}

impl Communicator for Threads {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn all_reduce(&self, values: &mut [f64]) {
        let all = self.exchange(values.to_vec());
        for (i, value) in values.iter_mut().enumerate() {
            *value = all.iter().map(|local| local[i]).sum();
        }
    }

    fn all_reduce_f32(&self, values: &mut [f32]) {
        let all = self.exchange(wide(values));
        for (i, value) in values.iter_mut().enumerate() {
            *value = all.iter().map(|local| local[i] as f32).sum();
        }
    }

    fn gather(&self, values: &[f32]) -> Vec<Vec<f32>> {
        let all = self.exchange(wide(values));
        match self.is_first() {
            true => all.iter().map(|local| narrow(local)).collect(),
            false => Vec::new(),
        }
    }

    fn broadcast(&self, values: &mut [f32]) {
        let all = self.exchange(wide(values));
        values.copy_from_slice(&narrow(&all[0]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dose::Quantity;
    use crate::field::{Field, HostField};
    use crate::grid::PatternGrid;
    use std::thread;

    /// What `work` gives on each of so many ranks.
    fn on_ranks<T: Send>(size: usize, work: impl Fn(Arc<dyn Communicator>) -> T + Sync) -> Vec<T> {
        thread::scope(|scope| {
            let run = |rank: Threads| scope.spawn(|| work(Arc::new(rank)));
            let threads: Vec<_> = Threads::ranks(size).into_iter().map(run).collect();
            let joined = threads.into_iter().map(|thread| thread.join());
            joined.map(|found| found.unwrap()).collect()
        })
    }

    #[test]
    fn every_frame_belongs_to_one_rank_and_opposite_ones_to_the_same() {
        for (frames, size) in [(12, 1), (12, 2), (12, 5), (7, 3), (4, 4), (6, 4), (300, 16)] {
            let shares: Vec<Vec<usize>> = (0..size)
                .map(|rank| frames_of_rank(frames, rank, size))
                .collect();
            let mut all = shares.concat();
            all.sort_unstable();
            assert!(all.iter().copied().eq(0..frames), "{frames} {size}");
            assert!(
                shares.iter().all(|share| !share.is_empty()),
                "{frames} {size}"
            );
            if frames.is_multiple_of(2) && frames / 2 >= size {
                let opposite = |share: &Vec<usize>| {
                    let opposite = |frame: &usize| share.contains(&((frame + frames / 2) % frames));
                    share.iter().all(opposite)
                };
                assert!(shares.iter().all(opposite), "{frames} {size}");
            }
        }
    }

    #[test]
    fn a_shared_field_speaks_of_the_elements_of_all_ranks() {
        let whole = [3.0f32, -1.0, 0.5, 4.0, -7.0, 2.0];
        let all = HostField::from_slice(&whole);
        let found = on_ranks(2, |ranks| {
            let local = &whole[ranks.rank() * 3..][..3];
            let local = HostField::from_slice(local).shared(ranks);
            let step = local.zeros_like().max_abs();
            let sums = (local.dot(&local), local.norm(), local.total(2.0));
            (
                sums,
                local.max_abs(),
                local.lowest(),
                local.secant(&local, &local),
                step,
            )
        });
        for (sums, largest, lowest, secant, nothing) in found {
            assert_eq!(sums, (all.dot(&all), all.norm(), 4.0));
            assert_eq!((largest, lowest, nothing), (7.0, -7.0, 0.0));
            assert_eq!(secant, all.secant(&all, &all));
        }
    }

    #[test]
    fn a_whole_field_is_put_together_from_shares_and_cut_into_them() {
        // Two lights with 6 and 3 frames of two columns; of frame k of light l the first column has k + 1 rows, the second l
        let grids = [6, 3].map(|frames| PatternGrid::full_turn(frames, 0.0, 9, 2, 0.1));
        let layouts = |chosen: &dyn Fn(usize) -> Vec<usize>| {
            let mut offset = 0;
            let of_light = |(l, grid): (usize, &PatternGrid)| {
                let frames = chosen(grid.frames());
                let rows = |frame: usize| [(0, frame as u32 + 1), (2, l as u32)];
                let active: Vec<_> = frames.iter().flat_map(|&frame| rows(frame)).collect();
                let mut local = grid.clone();
                local.azimuths = frames.iter().map(|&frame| grid.azimuths[frame]).collect();
                let layout = PatternLayout::new(local, Quantity::Energy, offset, &active);
                offset += layout.len();
                layout
            };
            grids.iter().enumerate().map(of_light).collect::<Vec<_>>()
        };
        let all = layouts(&|frames| (0..frames).collect());
        let values: Vec<f32> = (0..30).map(|i| i as f32).collect();
        let found = on_ranks(3, |ranks| {
            let local = layouts(&|frames| frames_of_rank(frames, ranks.rank(), ranks.size()));
            let shares = Shares::new(ranks.clone(), &[6, 3], &local);
            let cut = shares.own(&values);
            // What a frame of the share holds is what it holds in the whole
            for (light, whole) in local.iter().zip(&all) {
                let frames = frames_of_rank(whole.grid.frames(), ranks.rank(), 3);
                for (i, frame) in frames.into_iter().enumerate() {
                    let expected = &values[whole.elements_of(frame..frame + 1)];
                    assert_eq!(&cut[light.elements_of(i..i + 1)], expected);
                }
            }
            shares.whole(&cut)
        });
        assert_eq!(found[0], values);
        assert!(found[1].is_empty() && found[2].is_empty());
    }

    #[test]
    fn where_one_rank_fails_all_stop_and_one_says_why() {
        let failed = || Err(Error::config("key", "found", "accepted"));
        let ended = |results: fn(usize) -> Result<()>| {
            on_ranks(3, move |ranks| {
                together(ranks.as_ref(), results(ranks.rank())).map_err(|e| e.to_string())
            })
        };
        assert!(ended(|_| Ok(())).iter().all(Result::is_ok));
        let failure = failed().map_err(|e: Error| e.to_string());
        let other = |rank| Err(Error::Rank { rank }.to_string());
        let one = ended(|rank| match rank {
            1 => Err(Error::config("key", "found", "accepted")),
            _ => Ok(()),
        });
        assert_eq!(one, [other(1), failure.clone(), other(1)]);
        let all = ended(|_| Err(Error::config("key", "found", "accepted")));
        assert_eq!(all, [failure, other(0), other(0)]);
        let asked = ended(|rank| match rank {
            2 => Err(Error::Canceled),
            _ => Ok(()),
        });
        let canceled = || Err(Error::Canceled.to_string());
        assert_eq!(asked, [canceled(), canceled(), canceled()]);
    }

    #[test]
    #[should_panic(expected = "another rank has ended")]
    fn nobody_waits_for_a_rank_that_has_ended() {
        let mut ranks = Threads::ranks(2);
        drop(ranks.pop());
        ranks[0].all_reduce(&mut [1.0]);
    }
}
