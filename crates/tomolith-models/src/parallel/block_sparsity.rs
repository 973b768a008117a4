//! Block sparsity: which blocks of lanes hold anything but zero. What is zero costs nothing.
//!
//! A band that a voxel keeps gives it no cotangent, and a pixel at its lower bound gives no light: late in a run nine in ten
//! voxels and two in three pixels are exactly 0. Both kernels ask this page before they multiply. What is left out would
//! have added 0, so results are the same to the bit.

use super::TOGETHER;
use super::kernel::{Block, MAX_BLOCK};
use super::tiles::Tile;
use std::ops::Range;
use tomolith_core::field::LANES;
use tomolith_core::parallel::{InParallel, table};

/// Vectors of 16 lanes in a short and in a long block at most. Longer blocks are faster where little is 0 (their weights are read less often), shorter ones
/// are more often empty.
pub(super) const LENGTHS: [usize; 2] = [5, MAX_BLOCK];

/// What a block costs in addition to its vectors, if a vector costs 1: its weights and slots are read once. Vectors of a block of five cost 1.2 to 1.7 times as
/// much as those of one of sixteen (measured).
const COST_OF_BLOCK: f64 = 2.0;

/// Bit of a block of lanes; those from the 64th on share one.
fn bit(block: usize) -> u64 {
    1 << block.min(63)
}

/// Cuts a range of vectors into blocks of nearly equal length, at most `longest`.
fn cut(row: usize, vectors: Range<usize>, longest: usize) -> impl Iterator<Item = Block> {
    let (start, used) = (vectors.start, vectors.len());
    let count = used.div_ceil(longest);
    (0..count).map(move |i| {
        let (first, end) = (start + i * used / count, start + (i + 1) * used / count);
        Block {
            row,
            first,
            count: end - first,
        }
    })
}

/// The first to the last of `used` vectors that hold anything in any row: rows of pixels above and below the part leave the others dark.
fn nonzero_vectors(lanes: &[f32], row: usize, used: usize) -> Range<usize> {
    let holds_any = |&vector: &usize| {
        let range = vector * LANES..(vector + 1) * LANES;
        let parts = lanes.chunks(TOGETHER * row * LANES).par_map(|rows| {
            let mut rows = rows.chunks_exact(row * LANES);
            rows.any(|lanes| is_nonzero(&lanes[range.clone()]))
        });
        parts.contains(&true)
    };
    let Some(first) = (0..used).find(holds_any) else {
        return 0..0;
    };
    let last = (first..used).rev().find(holds_any).unwrap_or(first);
    first..last + 1
}

/// Blocks of each row of lanes that hold anything but 0.
pub(super) struct NonzeroBlocks {
    pub(super) blocks: Vec<Block>,
    /// Their [`bit`]s, row by row.
    rows: Vec<u64>,
}

impl NonzeroBlocks {
    /// Of rows of `row` vectors, of which `used` count; in short blocks where so many of them are empty that it pays.
    pub(super) fn of(lanes: &[f32], row: usize, used: usize, lengths: [usize; 2]) -> Self {
        let [short, long] = Self::in_blocks(lanes, row, used, lengths);
        short.or(long)
    }

    /// The lit blocks of rows, short and long ones, of `lengths` vectors at most. Vectors that are empty in all rows, at either end, are in no block.
    pub(super) fn in_blocks(
        lanes: &[f32],
        row: usize,
        used: usize,
        [shorter, longest]: [usize; 2],
    ) -> [Self; 2] {
        let long: Vec<Block> = cut(row, nonzero_vectors(lanes, row, used), longest).collect();
        let parts = |block: &Block| cut(row, block.first..block.first + block.count, shorter);
        let short: Vec<Block> = long.iter().flat_map(parts).collect();
        let rows = table(lanes.len() / (row * LANES), |i| {
            bits_of(&lanes[i * row * LANES..][..row * LANES], &short)
        });
        // Which bits of short blocks make one of a long one
        let masks: Vec<u64> = long
            .iter()
            .map(|block| {
                let within = short.iter().enumerate().filter(|(_, part)| {
                    (block.first..block.first + block.count).contains(&part.first)
                });
                within.fold(0, |bits, (i, _)| bits | bit(i))
            })
            .collect();
        let of_long = |bits: u64| {
            let nonzero = masks
                .iter()
                .enumerate()
                .filter(|(_, mask)| bits & **mask != 0);
            nonzero.fold(0, |bits, (i, _)| bits | bit(i))
        };
        let rows_of_long = table(rows.len(), |i| of_long(rows[i]));
        [(short, rows), (long, rows_of_long)].map(|(blocks, rows)| NonzeroBlocks { blocks, rows })
    }

    /// The one that costs less.
    pub(super) fn or(self, other: Self) -> Self {
        if self.cost() < other.cost() {
            self
        } else {
            other
        }
    }

    /// Of rows that hold `parts` of these rows, `part` vectors each, one after the other: which ones says `of_rows`, row by row. The cheapest of a
    /// block or several for each part, and of blocks of several parts where such are short.
    pub(super) fn side_by_side(
        [short, long]: &[Self; 2],
        row: usize,
        parts: usize,
        part: usize,
        of_rows: &[usize],
    ) -> Self {
        let repeated =
            |blocks: &Self, together| blocks.repeated(row, parts, part, together, of_rows);
        // A short block that is a long one is no choice
        let apart = if short.blocks.len() == long.blocks.len() {
            repeated(short, 1)
        } else {
            repeated(short, 1).or(repeated(long, 1))
        };
        let fits =
            |together: &usize| parts.is_multiple_of(*together) && together * part <= MAX_BLOCK;
        match ([4, 2].into_iter().find(fits), long.blocks.as_slice()) {
            (Some(together), [whole]) if whole.first == 0 && whole.count == part => {
                apart.or(repeated(long, together))
            }
            _ => apart,
        }
    }

    /// The blocks of these rows again for every part, those of so many parts as one.
    fn repeated(
        &self,
        row: usize,
        parts: usize,
        part: usize,
        together: usize,
        of_rows: &[usize],
    ) -> Self {
        let count = self.blocks.len();
        let of_part = |i: usize| {
            self.blocks.iter().map(move |block| Block {
                row,
                first: block.first + i * part,
                count: block.count + (together - 1) * part,
            })
        };
        let blocks: Vec<Block> = (0..parts).step_by(together).flat_map(of_part).collect();
        let shares_a_bit = blocks.len() > u64::BITS as usize;
        let bits = |(i, &of_row): (usize, &usize)| match self.rows[of_row] {
            0 => 0,
            _ if shares_a_bit => u64::MAX,
            bits => bits << (i / together * count),
        };
        let rows = of_rows.chunks_exact(parts);
        let rows = rows.map(|rows| rows.iter().enumerate().map(bits).fold(0, |a, b| a | b));
        NonzeroBlocks {
            rows: rows.collect(),
            blocks,
        }
    }

    /// What reading all blocks that hold anything costs, if a vector costs 1.
    fn cost(&self) -> f64 {
        self.cost_of_blocks(self.rows.iter())
    }

    /// The cost of these rows alone.
    pub(super) fn cost_of(&self, rows: &[usize]) -> f64 {
        self.cost_of_blocks(rows.iter().map(|&row| &self.rows[row]))
    }

    fn cost_of_blocks<'a>(&self, rows: impl Iterator<Item = &'a u64>) -> f64 {
        let nonzero: u64 = rows.map(|bits| u64::from(bits.count_ones())).sum();
        let vectors: usize = self.blocks.iter().map(|block| block.count).sum();
        let of_block = vectors as f64 / self.blocks.len().max(1) as f64 + COST_OF_BLOCK;
        nonzero as f64 * of_block
    }

    /// Whether anything is in this row at all.
    pub(super) fn any(&self, row: usize) -> bool {
        self.rows[row] != 0
    }

    /// Whether anything is in this block of the row.
    pub(super) fn any_in(&self, row: usize, block: usize) -> bool {
        self.rows[row] & bit(block) != 0
    }

    /// The blocks of a row that hold anything.
    pub(super) fn blocks_of(&self, row: usize) -> impl Iterator<Item = &Block> {
        let blocks = self.blocks.iter().enumerate();
        let nonzero = blocks.filter(move |(i, _)| self.any_in(row, *i));
        nonzero.map(|(_, block)| block)
    }

    /// Of the voxels of a tile, in a plane of `nx` voxels a row.
    pub(super) fn of_tile(&self, tile: &Tile, nx: usize) -> NonzeroTile {
        let of_line = |y: usize| {
            let first = (tile.start[1] + y) * nx + tile.start[0];
            self.rows[first..first + tile.size[0]].iter()
        };
        let rows = (0..tile.size[1]).flat_map(of_line);
        NonzeroTile(rows.fold(0, |all, bits| all | bits))
    }
}

/// Whether whole vectors of lanes hold anything but 0.
pub(super) fn is_nonzero(lanes: &[f32]) -> bool {
    // Without a way out in the middle of a vector, so that it becomes one comparison
    let is_nonzero = |vector: &[f32]| vector.iter().fold(false, |any, &v| any | (v != 0.0));
    lanes.chunks_exact(LANES).any(is_nonzero)
}

/// [`bit`]s of the blocks of a row that hold anything but 0.
fn bits_of(lanes: &[f32], blocks: &[Block]) -> u64 {
    let nonzero = blocks.iter().enumerate().filter(|(_, block)| {
        let range = block.first * LANES..(block.first + block.count) * LANES;
        is_nonzero(&lanes[range])
    });
    nonzero.fold(0, |bits, (i, _)| bits | bit(i))
}

/// [`bit`]s of blocks in which any voxel of a tile holds anything but 0.
pub(super) struct NonzeroTile(u64);

impl NonzeroTile {
    pub(super) fn is_empty(&self) -> bool {
        self.0 == 0
    }

    pub(super) fn any_in(&self, block: usize) -> bool {
        self.0 & bit(block) != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn little_light_takes_short_blocks_and_much_takes_long_ones() {
        // Rows of 21 vectors, of which 20 count: two blocks of 10, or four of 5
        let (row, used) = (21, 20);
        let nonzero = |lit: &dyn Fn(usize, usize) -> bool| {
            let mut lanes = vec![0.0; 50 * row * LANES];
            for i in 0..50 {
                for vector in 0..used {
                    if lit(i, vector) {
                        lanes[(i * row + vector) * LANES + 3] = -1.0;
                    }
                }
            }
            NonzeroBlocks::of(&lanes, row, used, LENGTHS)
        };
        let counts = |nonzero: &NonzeroBlocks| -> Vec<usize> {
            nonzero.blocks.iter().map(|b| b.count).collect()
        };
        let all = nonzero(&|_, _| true);
        assert_eq!(counts(&all), [10, 10]);
        assert!(all.any_in(49, 0) && all.any_in(0, 1));
        // A row that is lit at both ends, and few that are lit between
        let is_lit = |i, vector| match i {
            0 => vector == 0 || vector == 19,
            _ => i % 7 == 3 && vector == 12,
        };
        let few = nonzero(&is_lit);
        assert_eq!(counts(&few), [5; 4]);
        for i in 1..50 {
            for block in 0..4 {
                assert_eq!(
                    few.any_in(i, block),
                    i % 7 == 3 && block == 2,
                    "{i} {block}"
                );
            }
            assert_eq!(few.any(i), i % 7 == 3);
        }
    }

    #[test]
    fn vectors_that_are_dark_in_all_rows_are_in_no_block() {
        let (row, used) = (5, 4);
        let lit = |places: &[[usize; 2]]| {
            let mut lanes = vec![0.0; 3 * row * LANES];
            for [i, vector] in places {
                lanes[(i * row + vector) * LANES + 15] = 1.0;
            }
            let nonzero = NonzeroBlocks::of(&lanes, row, used, LENGTHS);
            let ranges = nonzero.blocks.iter().map(|b| b.first..b.first + b.count);
            (ranges.collect::<Vec<_>>(), nonzero.any(1))
        };
        let one = |range: Range<usize>| [range].to_vec();
        assert_eq!(lit(&[[0, 1], [2, 2]]), (one(1..3), false));
        assert_eq!(lit(&[[1, 3]]), (one(3..4), true));
        assert_eq!(lit(&[[1, 0]]), (one(0..1), true));
        // The fifth vector is padding
        assert_eq!(lit(&[[1, 4]]), (Vec::new(), false));
    }

    #[test]
    fn padding_and_blocks_beyond_the_sixty_fourth_lose_nothing() {
        // 70 short blocks: the last seven share a bit
        let (row, used) = (352, 350);
        let mut lanes = vec![0.0; 3 * row * LANES];
        lanes[351 * LANES] = 1.0;
        lanes[(row + 349) * LANES] = f32::NAN;
        lanes[2 * row * LANES] = 1.0;
        let nonzero = NonzeroBlocks::of(&lanes, row, used, LENGTHS);
        assert!(
            !nonzero.any(0),
            "what lies beyond the lanes in use does not count"
        );
        let last = nonzero.blocks.len() - 1;
        assert!(nonzero.any_in(1, last) && !nonzero.any_in(1, 0));
        let covered: usize = nonzero.blocks.iter().map(|b| b.count).sum();
        assert_eq!(covered, used);
    }
}
