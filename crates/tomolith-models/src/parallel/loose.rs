//! Single entries that a slice needs, found once.
//!
//! Most tiles of a slice are lit by uniform strips and chains ([`plane`](super::plane)). Where strips begin or end within a tile, or a
//! resin wall cuts it, entries are found one by one: two tiles in a hundred took a third of the time of a slice. A model that is called
//! again and again stores them, of a light about [`MOST`] bytes at most, and finds the rest in each call. Sums along them have the same order, and so the
//! same bits.

use super::Parallel;
use super::plan::LightPlan;
use super::tiles::{Local, Meeting, TILE, TileEntries};
use crate::Work;
use tomolith_core::error::Result;
use tomolith_core::parallel::InParallel;
use tomolith_optics::light::Light;

/// Most bytes that are stored of a light, by [`OF_MEETING`].
pub(super) const MOST: usize = 256 << 20;

/// Bytes of a tile and a beam, roughly: three columns cross a voxel at most times, each with a slot and a weight.
pub(super) const OF_MEETING: usize = 3 * TILE * TILE * (size_of::<u32>() + size_of::<f32>());

/// Most bytes that are stored of these lights in a slice of so many voxels.
pub(super) fn bytes(lights: &[Light], voxels: usize) -> f64 {
    let of_light = |light: &Light| {
        let beams = light.pixels.frames() * light.sub_angles.max(1);
        (voxels.div_ceil(TILE * TILE) * beams * OF_MEETING).min(MOST)
    };
    lights.iter().map(of_light).sum::<usize>() as f64
}

/// The entries of a light, of all tiles and beams that have no other way.
pub(super) struct Loose {
    /// `[tile][beam]`, one more than where they stand in `found`; 0 for none.
    at: Vec<u32>,
    found: Vec<TileEntries>,
}

impl Loose {
    /// Finds those that take at most so many bytes, by [`OF_MEETING`].
    pub(super) fn of(model: &Parallel, plan: &LightPlan, most: usize, work: &Work) -> Result<Self> {
        let beams = plan.beams.len();
        let needed = |&at: &usize| model.is_loose(plan, at % beams, plan.meetings[at]);
        let places = (0..plan.meetings.len()).filter(needed);
        let places: Vec<usize> = places.take(most / OF_MEETING).collect();
        let mut at = vec![0; plan.meetings.len()];
        let find = |&at: &usize| {
            let mut found = TileEntries::default();
            if !work.is_canceled() {
                model.enumerate_loose(plan, at / beams, at % beams, &mut found);
            }
            found
        };
        let found = places.iter().par_map(find);
        work.check()?;
        for (i, &place) in places.iter().enumerate() {
            at[place] = i as u32 + 1;
        }
        Ok(Loose { at, found })
    }

    /// Bytes of slots and weights.
    #[cfg(test)]
    pub(super) fn bytes(&self) -> usize {
        let entries: usize = self.found.iter().map(|found| found.slots.len()).sum();
        entries * (size_of::<u32>() + size_of::<f32>())
    }

    fn at(&self, place: usize) -> Option<&TileEntries> {
        self.found.get((self.at[place] as usize).checked_sub(1)?)
    }
}

impl Parallel {
    /// Whether a beam lights a tile entry by entry.
    fn is_loose(&self, plan: &LightPlan, beam: usize, meeting: Meeting) -> bool {
        let is_uniform_strips = meeting.uniform_strips && plan.uniform_strips[beam].is_some();
        let is_chain = meeting.chain && self.path.wide.is_some();
        meeting.end > meeting.first && !(is_uniform_strips || is_chain)
    }

    fn enumerate_loose(&self, plan: &LightPlan, tile: usize, beam: usize, found: &mut TileEntries) {
        found.clear();
        let major = plan.beams[beam].major;
        let local = Local::new(&self.tiles[tile], major);
        plan.enumerate(self.path, beam, plan.meeting(tile, beam), &local, found);
    }

    /// Entries of a tile and a beam: the stored ones, or those found anew in `scratch`.
    pub(super) fn loose_entries<'a>(
        &self,
        plan: &LightPlan,
        stored: Option<&'a Loose>,
        tile: usize,
        beam: usize,
        scratch: &'a mut TileEntries,
    ) -> &'a TileEntries {
        let place = tile * plan.beams.len() + beam;
        if let Some(entries) = stored.and_then(|stored| stored.at(place)) {
            return entries;
        }
        self.enumerate_loose(plan, tile, beam, scratch);
        scratch
    }
}
