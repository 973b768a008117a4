//! The processes that an MPI launcher started with this one (feature `mpi`): `mpirun -n 2 tomolith run …`.
//!
//! Without the feature, and where the launcher started one process, there are none. MPI ends when the last holder of the ranks lets go of
//! them: after all output, since a launcher ends all processes when one of them has ended badly.

use std::sync::Arc;
use tomolith::ranks::{Communicator, together};
use tomolith::{Error, Result};

/// What the processes of a command tell each other by.
pub(crate) type Ranks = Arc<dyn Communicator>;

/// The ranks, where there are several.
#[cfg(not(feature = "mpi"))]
pub(crate) fn started(_panic_ends_all: bool) -> Option<Ranks> {
    None
}

/// What a launcher's processes should know that cannot share their work.
#[cfg(not(feature = "mpi"))]
pub(crate) fn remark() -> Option<String> {
    let count = launched()?;
    Some(format!(
        "warning: this is one of {count} processes of a launcher, and does the whole work: the program was built without MPI; build it with --features mpi \
         (docs/ranks.md), or start it once"
    ))
}

/// How launchers tell a process how many they started: OpenMPI, MPICH.
const LAUNCHERS: [&str; 2] = ["OMPI_COMM_WORLD_SIZE", "PMI_SIZE"];

/// How many processes a launcher started, where it started several.
fn launched() -> Option<u32> {
    let size = |name: &&str| std::env::var(name).ok()?.parse::<u32>().ok();
    LAUNCHERS.iter().find_map(size).filter(|&size| size > 1)
}

/// Refuses several processes of a command that has nothing to share: each would say the same and write the same files.
pub(crate) fn must_be_alone(command: &str) -> Result<()> {
    let Some(count) = launched() else {
        return Ok(());
    };
    Err(Error::config(
        format!("tomolith {command}"),
        format!(
            "one of {count} processes of a launcher, which would all do the same and write the same files"
        ),
        match cfg!(feature = "mpi") {
            true => "one process: start it without a launcher; `run` and `sweep` share their work",
            false => "one process: start it without a launcher",
        },
    ))
}

/// Ranks share the work.
#[cfg(feature = "mpi")]
pub(crate) fn remark() -> Option<String> {
    None
}

#[cfg(feature = "mpi")]
pub(crate) use world::started;

/// What this process came to, if no other one failed.
pub(crate) fn agreed<T>(ranks: Option<&Ranks>, result: Result<T>) -> Result<T> {
    match ranks {
        Some(ranks) => together(ranks.as_ref(), result),
        None => result,
    }
}

/// Whether this process is one of several and not the one that speaks.
pub(crate) fn is_silent(ranks: Option<&Ranks>) -> bool {
    ranks.is_some_and(|ranks| !ranks.is_first())
}

#[cfg(feature = "mpi")]
mod world {
    use super::Ranks;
    use crate::REFUSED;
    use mpi::Threading;
    use mpi::collective::SystemOperation;
    use mpi::environment::Universe;
    use mpi::topology::SimpleCommunicator;
    use mpi::traits::{Communicator as _, Destination as _, Equivalence, Root as _, Source as _};
    use std::fmt;
    use std::panic;
    use std::sync::Arc;
    use tomolith::ranks::Communicator;

    /// Numbers of one message: MPI counts them in 32 bits, and a sum needs as much memory again.
    const MESSAGE: usize = 1 << 24;

    /// All processes that the launcher started.
    struct World {
        universe: Universe,
        rank: usize,
        size: usize,
        /// Ranks on this machine.
        on_this_machine: usize,
    }

    impl fmt::Debug for World {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "rank {} of {}", self.rank, self.size)
        }
    }

    /// The ranks, where there are several; whether a panic of one of them ends all, which might wait for it for ever.
    pub(crate) fn started(panic_ends_all: bool) -> Option<Ranks> {
        // The work runs in a separate thread, one call at a time
        let (universe, _) = mpi::initialize_with_threading(Threading::Serialized)?;
        let world = universe.world();
        let (rank, size) = (world.rank() as usize, world.size() as usize);
        if size == 1 {
            return None;
        }
        if panic_ends_all {
            let tell = panic::take_hook();
            panic::set_hook(Box::new(move |what| {
                tell(what);
                SimpleCommunicator::world().abort(i32::from(REFUSED));
            }));
        }
        let on_this_machine = world.split_shared(0).size() as usize;
        Some(Arc::new(World {
            universe,
            rank,
            size,
            on_this_machine,
        }))
    }

    impl World {
        fn sum<T: Equivalence + Copy>(&self, values: &mut [T]) {
            let world = self.universe.world();
            let first = world.process_at_rank(0);
            for message in values.chunks_mut(MESSAGE) {
                if self.is_first() {
                    let copy = message.to_vec();
                    first.reduce_into_root(&copy[..], message, SystemOperation::sum());
                } else {
                    first.reduce_into(&message[..], SystemOperation::sum());
                }
                // The bits are rank 0's
                first.broadcast_into(message);
            }
        }
    }

    impl Communicator for World {
        fn rank(&self) -> usize {
            self.rank
        }

        fn size(&self) -> usize {
            self.size
        }

        fn beside(&self) -> usize {
            self.on_this_machine
        }

        fn all_reduce(&self, values: &mut [f64]) {
            self.sum(values);
        }

        fn all_reduce_f32(&self, values: &mut [f32]) {
            self.sum(values);
        }

        fn gather(&self, values: &[f32]) -> Vec<Vec<f32>> {
            let world = self.universe.world();
            let first = world.process_at_rank(0);
            let count = values.len() as u64;
            if !self.is_first() {
                first.gather_into(&count);
                for message in values.chunks(MESSAGE) {
                    first.send(message);
                }
                return Vec::new();
            }
            let mut counts = vec![0u64; self.size];
            first.gather_into_root(&count, &mut counts[..]);
            let mut all = vec![values.to_vec()];
            for (rank, &count) in (0i32..).zip(&counts).skip(1) {
                let mut received = vec![0.0f32; count as usize];
                for message in received.chunks_mut(MESSAGE) {
                    world.process_at_rank(rank).receive_into(message);
                }
                all.push(received);
            }
            all
        }

        fn broadcast(&self, values: &mut [f32]) {
            let world = self.universe.world();
            let first = world.process_at_rank(0);
            for message in values.chunks_mut(MESSAGE) {
                first.broadcast_into(message);
            }
        }
    }
}
