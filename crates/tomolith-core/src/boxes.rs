//! A tree of boxes: which of many things are near a point, or lie along a ray.
//!
//! **Model** Things are cut in two by a plane, both parts again, and so on, until one to four are left: a leaf. A node has four children, whose
//! boxes have a lane each. A query takes the nearest child first and leaves out what lies beyond the best answer so far.
//!
//! **Limits** Boxes are f32 and rounded outward: a query is given every leaf that it meets in exact numbers, and now and then one that it does
//! not quite meet. Fewer than 2³¹ things.
//!
//! **Cost** On one core of 2024, of 80 000 triangles of a ball: 0.04 s to build [`of`](BoxTree::of) boxes, a sixth of that
//! [`of_small`](BoxTree::of_small) things; 0.2 µs to find the first triangle on a ray.
//!
//! ```
//! use tomolith_core::boxes::{AlignedBox, BoxTree};
//! use tomolith_core::work::Work;
//! // A hundred beads on the x axis, 1 mm apart
//! let boxes: Vec<AlignedBox> = (0..100).map(|i| AlignedBox::around([[f64::from(i), 0.0, 0.0]], 0.1)).collect();
//! let tree = BoxTree::of(&boxes, &Work::new());
//! let mut met = Vec::new();
//! tree.along([42.0, -9.0, 0.0], [0.0, 1.0, 0.0], f64::INFINITY, |places| {
//!     met.extend(&tree.order()[places]);
//!     f64::INFINITY
//! });
//! assert!(met.contains(&42)); // the bead at x = 42
//! assert!(met.len() <= 4); // and the others of its leaf
//! ```

use crate::parallel::{InParallel, table};
use crate::work::Work;
use std::ops::Range;
use wide::f32x4;

/// Things in a leaf, at most.
pub const LEAF: usize = 4;
/// Children of a node.
const SPLIT: usize = 4;
/// Leaves that a thread fills in a row.
const LEAVES_AT_ONCE: usize = 1024;
/// Things from which on a split is done by two threads.
const PARALLEL: usize = 1 << 14;
/// Cuts above each other that are chosen by surface; what is left then is halved, and again, at most 32 times.
const LEVELS: usize = 24;
/// Nodes that wait at most: three for every two cuts above each other, and one.
const WAITING: usize = 3 * (LEVELS + 32) / 2 + 1;
/// Up to so many things are halved: the search costs more than it gains.
const FEW: usize = 8;
/// Parts of an axis between which it may be cut.
const BINS: usize = 16;
/// Rounding of a ray's times, generously: several of f32.
const ROUNDING: f32 = 1e-6;
/// Inverse slopes beyond this are as good as infinite, and make no NaN.
const STEEPEST: f64 = 1e30;

type Point = [f32; 3];

/// A box: its lowest and its highest corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlignedBox {
    low: Point,
    high: Point,
}

impl AlignedBox {
    /// The box of nothing.
    pub const EMPTY: AlignedBox = AlignedBox {
        low: [f32::INFINITY; 3],
        high: [f32::NEG_INFINITY; 3],
    };

    /// The box of some points.
    pub fn of(points: impl IntoIterator<Item = Point>) -> Self {
        let mut bounds = AlignedBox::EMPTY;
        points.into_iter().for_each(|point| bounds.add(point));
        bounds
    }

    /// The box of points, wider by `margin` on all sides and rounded outward.
    pub fn around(points: impl IntoIterator<Item = [f64; 3]>, margin: f64) -> Self {
        let mut bounds = AlignedBox::EMPTY;
        for point in points {
            bounds.low = std::array::from_fn(|i| bounds.low[i].min(below(point[i] - margin)));
            bounds.high = std::array::from_fn(|i| bounds.high[i].max(above(point[i] + margin)));
        }
        bounds
    }

    /// Makes room for a point.
    pub fn add(&mut self, point: Point) {
        self.low = std::array::from_fn(|i| self.low[i].min(point[i]));
        self.high = std::array::from_fn(|i| self.high[i].max(point[i]));
    }

    fn extent(&self) -> Point {
        std::array::from_fn(|i| self.high[i] - self.low[i])
    }

    /// Half of it.
    fn surface(&self) -> f32 {
        let [x, y, z] = self.extent();
        x * y + y * z + z * x
    }

    fn twice_the_middle(&self) -> Point {
        std::array::from_fn(|i| self.low[i] + self.high[i])
    }

    fn joined(self, other: AlignedBox) -> AlignedBox {
        AlignedBox {
            low: std::array::from_fn(|i| self.low[i].min(other.low[i])),
            high: std::array::from_fn(|i| self.high[i].max(other.high[i])),
        }
    }
}

/// The next f32 that is not higher.
fn below(v: f64) -> f32 {
    let near = v as f32;
    if f64::from(near) > v {
        near.next_down()
    } else {
        near
    }
}

/// The next f32 that is not lower.
fn above(v: f64) -> f32 {
    -below(-v)
}

/// The boxes of a node's children, coordinate by coordinate.
#[derive(Clone, Copy)]
struct Children {
    low: [f32x4; 3],
    high: [f32x4; 3],
}

impl Children {
    fn new(boxes: &[AlignedBox; SPLIT]) -> Self {
        let lanes =
            |bound_of: &dyn Fn(&AlignedBox) -> f32| f32x4::new(boxes.each_ref().map(bound_of));
        Children {
            low: [0, 1, 2].map(|axis| lanes(&|b| b.low[axis])),
            high: [0, 1, 2].map(|axis| lanes(&|b| b.high[axis])),
        }
    }

    /// Squared distances from a point to the boxes.
    #[inline]
    fn squared_distances(&self, p: [f32x4; 3]) -> [f32; SPLIT] {
        let off = |axis: usize| {
            let outside = (self.low[axis] - p[axis]).fast_max(p[axis] - self.high[axis]);
            outside.fast_max(f32x4::ZERO)
        };
        let [x, y, z] = [off(0), off(1), off(2)];
        (x * x + y * y + z * z).to_array()
    }

    /// When a ray enters the boxes, infinite for those that it does not meet: it is between all three pairs of planes at once.
    #[inline]
    fn times(&self, ray: &Lanes) -> [f32; SPLIT] {
        let (mut enter, mut leave) = (f32x4::ZERO, f32x4::splat(f32::INFINITY));
        for axis in 0..3 {
            let a = (self.low[axis] - ray.from[axis][1]) * ray.inverse[axis];
            let b = (self.high[axis] - ray.from[axis][0]) * ray.inverse[axis];
            enter = enter.fast_max(a.fast_min(b));
            leave = leave.fast_min(a.fast_max(b));
        }
        let met = enter.simd_le(leave * f32x4::splat(1.0 + ROUNDING));
        met.select(enter, f32x4::splat(f32::INFINITY)).to_array()
    }
}

/// A ray in every lane.
struct Lanes {
    /// Where it begins, rounded down and up.
    from: [[f32x4; 2]; 3],
    inverse: [f32x4; 3],
}

impl Lanes {
    fn new(from: [f64; 3], along: [f64; 3]) -> Self {
        Lanes {
            from: from.map(|v| [f32x4::splat(below(v)), f32x4::splat(above(v))]),
            inverse: along.map(|v| f32x4::splat((1.0 / v).abs().min(STEEPEST).copysign(v) as f32)),
        }
    }
}

/// Boxes, split again and again.
pub struct BoxTree {
    /// The children of a node stand behind it.
    nodes: Vec<Node>,
    order: Vec<u32>,
    /// Where the things of each leaf begin in the order, and the last ones end.
    firsts: Vec<u32>,
}

#[derive(Clone)]
struct Node {
    children: Children,
    links: [Link; SPLIT],
}

impl Node {
    const EMPTY: Node = Node {
        children: Children {
            low: [f32x4::ZERO; 3],
            high: [f32x4::ZERO; 3],
        },
        links: [Link::NONE; SPLIT],
    };
}

/// A node's child: the number of a node, of a leaf, or none.
#[derive(Clone, Copy)]
struct Link(u32);

impl Link {
    const NONE: Link = Link(u32::MAX);
    /// What marks a leaf.
    const LEAF: u32 = 1 << 31;

    fn leaf(number: usize) -> Self {
        Link(number as u32 | Self::LEAF)
    }

    /// Its number, of a leaf or of a node.
    fn number(self) -> usize {
        (self.0 & !Self::LEAF) as usize
    }

    fn is_leaf(self) -> bool {
        self.0 & Self::LEAF != 0
    }

    fn is_none(self) -> bool {
        self.0 == u32::MAX
    }
}

impl BoxTree {
    /// The tree of things of any size, each in its box. A part is cut where the surfaces of the two boxes that come of it, each times the number of things in it, have the
    /// least sum (Goldsmith and Salmon, IEEE Comput. Graph. Appl. 7 (5), 14 (1987)); sixteen equal parts of each axis are tried.
    ///
    /// A tree that was not ready when the run was canceled answers wrong.
    #[must_use]
    pub fn of(boxes: &[AlignedBox], work: &Work) -> Self {
        let middle = |i: u32| boxes[i as usize].twice_the_middle();
        let leaf = |things: &[u32]| (joined(boxes, things.iter().copied()), ());
        let split = |keys: &mut [Key]| least_surface(keys, boxes);
        let (tree, _) = Self::build(boxes.len(), middle, &split, leaf, work);
        tree
    }

    /// The tree of `count` small things with these middles (or any multiple of them), halved along the longest edge of the box of their middles: built six times as fast. `leaf` is given the numbers of one to four things, and says which box
    /// they lie in and what is to be kept of them, which comes back in the order of the leaves.
    ///
    /// A tree that was not ready when the run was canceled answers wrong.
    pub fn of_small<L: Send>(
        count: usize,
        middle: impl Fn(u32) -> Point + Sync,
        leaf: impl Fn(&[u32]) -> (AlignedBox, L) + Sync,
        work: &Work,
    ) -> (Self, Vec<L>) {
        Self::build(count, middle, &longest, leaf, work)
    }

    fn build<L: Send>(
        count: usize,
        middle: impl Fn(u32) -> Point + Sync,
        split: &Split<'_>,
        leaf: impl Fn(&[u32]) -> (AlignedBox, L) + Sync,
        work: &Work,
    ) -> (Self, Vec<L>) {
        let mut keys: Vec<Key> = table(count, |i| (middle(i as u32), i as u32));
        let mut cuts = vec![Cut::default(); count];
        let cut = sort(&mut keys, &mut cuts, 0, split, work);
        let mut tree = BoxTree {
            nodes: Vec::new(),
            order: keys.iter().map(|key| key.1).collect(),
            firsts: Vec::new(),
        };
        if count > 0 {
            let to = count as u32;
            tree.add(Part { from: 0, to, cut }, &cuts);
        }
        let leaves = tree.firsts.len();
        tree.firsts.push(count as u32);
        let rows = (0..leaves).step_by(LEAVES_AT_ONCE).par_map(|first| {
            let row = first..(first + LEAVES_AT_ONCE).min(leaves);
            let (mut bounds, mut contents) =
                (Vec::with_capacity(row.len()), Vec::with_capacity(row.len()));
            for (bound, thing) in row.map(|i| leaf(&tree.order[tree.places(i)])) {
                bounds.push(bound);
                contents.push(thing);
            }
            (bounds, contents)
        });
        // Whole rows are moved at once, to memory that never grows
        let (mut bounds, mut contents) = (Vec::with_capacity(leaves), Vec::with_capacity(leaves));
        for (mut of_row, mut things) in rows {
            bounds.append(&mut of_row);
            contents.append(&mut things);
        }
        tree.set_boxes(&bounds);
        (tree, contents)
    }

    /// Adds the node of a part, and all below it.
    fn add(&mut self, part: Part, cuts: &[Cut]) -> Link {
        if part.cut == 0 {
            self.firsts.push(part.from);
            return Link::leaf(self.firsts.len() - 1);
        }
        let number = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        let mut quarters = Vec::with_capacity(SPLIT);
        for half in part.halves(cuts) {
            match half.cut {
                0 => quarters.push(half),
                _ => quarters.extend(half.halves(cuts)),
            }
        }
        for (i, quarter) in quarters.into_iter().enumerate() {
            self.nodes[number].links[i] = self.add(quarter, cuts);
        }
        Link(number as u32)
    }

    /// Puts a box around what is below each node.
    fn set_boxes(&mut self, leaves: &[AlignedBox]) {
        let mut whole = vec![AlignedBox::EMPTY; self.nodes.len()];
        for number in (0..self.nodes.len()).rev() {
            let node = &mut self.nodes[number];
            let boxes = node.links.map(|link| match link {
                none if none.is_none() => AlignedBox::EMPTY,
                leaf if leaf.is_leaf() => leaves[leaf.number()],
                child => whole[child.number()],
            });
            node.children = Children::new(&boxes);
            whole[number] = boxes
                .into_iter()
                .fold(AlignedBox::EMPTY, AlignedBox::joined);
        }
    }

    /// The things' numbers, leaf by leaf.
    #[must_use]
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Where the things of a leaf stand in the order.
    #[must_use]
    pub fn places(&self, leaf: usize) -> Range<usize> {
        self.firsts[leaf] as usize..self.firsts[leaf + 1] as usize
    }

    /// Hands out the leaves whose boxes are nearer to a point than the square root of `best`, the nearest first; `leaf` says the least squared distance of its things, and
    /// the least of all is returned.
    pub fn near(&self, point: Point, best: f32, leaf: impl FnMut(usize) -> f32) -> f32 {
        let lanes = point.map(f32x4::splat);
        self.walk(best, |children| children.squared_distances(lanes), leaf)
    }

    /// Hands out the leaves whose boxes a ray meets before the time `reach`, the nearest first: at the time t it is at `from` + t·`along`. `leaf` says up to which time the ray is followed from now
    /// on, or infinity.
    pub fn along(
        &self,
        from: [f64; 3],
        along: [f64; 3],
        reach: f64,
        mut leaf: impl FnMut(Range<usize>) -> f64,
    ) {
        let ray = Lanes::new(from, along);
        let later = |time: f64| time as f32 * (1.0 + ROUNDING);
        let shorter = |i: usize| later(leaf(self.places(i)));
        self.walk(later(reach), |children| children.times(&ray), shorter);
    }

    #[inline]
    fn walk(
        &self,
        mut best: f32,
        measure: impl Fn(&Children) -> [f32; SPLIT],
        mut leaf: impl FnMut(usize) -> f32,
    ) -> f32 {
        if self.nodes.is_empty() {
            return match self.order.is_empty() {
                true => best,
                false => best.min(leaf(0)),
            };
        }
        let mut stack = [(Link(0), 0f32); WAITING];
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let (link, distance) = stack[depth];
            if distance >= best {
                continue;
            }
            if link.is_leaf() {
                best = best.min(leaf(link.number()));
                continue;
            }
            let node = &self.nodes[link.number()];
            // The nearest child comes on top
            let bottom = depth;
            for (link, distance) in node.links.into_iter().zip(measure(&node.children)) {
                if distance < best && !link.is_none() {
                    let mut at = depth;
                    while at > bottom && stack[at - 1].1 < distance {
                        stack[at] = stack[at - 1];
                        at -= 1;
                    }
                    stack[at] = (link, distance);
                    depth += 1;
                }
            }
        }
        best
    }
}

/// Things from one place to before another, which are cut so many places after the first, or make a leaf (0).
#[derive(Clone, Copy)]
struct Part {
    from: u32,
    to: u32,
    cut: u32,
}

impl Part {
    fn halves(self, cuts: &[Cut]) -> [Part; 2] {
        let middle = self.from + self.cut;
        let [low, high] = cuts[middle as usize];
        [
            Part {
                from: self.from,
                to: middle,
                cut: low,
            },
            Part {
                from: middle,
                to: self.to,
                cut: high,
            },
        ]
    }
}

/// Where the two halves of a part are cut, kept at the first place of the second.
type Cut = [u32; 2];

/// A thing's middle, and its number.
type Key = (Point, u32);

/// Brings some things before others, and says how many.
type Split<'a> = dyn Fn(&mut [Key]) -> usize + Sync + 'a;

/// Brings things into the order of the leaves, and says where they are cut.
fn sort(keys: &mut [Key], cuts: &mut [Cut], level: usize, split: &Split<'_>, work: &Work) -> u32 {
    let n = keys.len();
    if n <= LEAF {
        return 0;
    }
    let cut = if work.is_canceled() {
        n / 2 // in no order, but leaves stay as small as users of the tree take them to be
    } else if level < LEVELS && n > FEW {
        split(keys)
    } else {
        longest(keys)
    };
    let (low, high) = keys.split_at_mut(cut);
    let (low_cuts, high_cuts) = cuts.split_at_mut(cut);
    let deeper = |keys, cuts| sort(keys, cuts, level + 1, split, work);
    let below = if n > PARALLEL {
        let halves = [(low, low_cuts), (high, &mut *high_cuts)];
        halves
            .into_iter()
            .par_map(|(keys, cuts)| deeper(keys, cuts))
    } else {
        vec![deeper(low, low_cuts), deeper(high, high_cuts)]
    };
    high_cuts[0] = [below[0], below[1]];
    cut as u32
}

/// Halves along the longest edge of the box of the middles.
fn longest(keys: &mut [Key]) -> usize {
    let extent = AlignedBox::of(keys.iter().map(|key| key.0)).extent();
    let axis = (0..3).fold(0, |a, b| if extent[b] > extent[a] { b } else { a });
    let half = keys.len() / 2;
    keys.select_nth_unstable_by(half, |a, b| a.0[axis].total_cmp(&b.0[axis]));
    half
}

/// Cuts where the surfaces of the two boxes, each times the number of things in it, have the least sum; halves what lies at one point.
fn least_surface(keys: &mut [Key], boxes: &[AlignedBox]) -> usize {
    let middles = AlignedBox::of(keys.iter().map(|key| key.0));
    let extent = middles.extent();
    let bin = |key: &Key, axis: usize| {
        let share = (key.0[axis] - middles.low[axis]) / extent[axis];
        ((share * BINS as f32) as usize).min(BINS - 1)
    };
    let mut best = (f32::INFINITY, 0, 0);
    for axis in (0..3).filter(|&axis| extent[axis] > 0.0) {
        let mut bins = [(AlignedBox::EMPTY, 0usize); BINS];
        for key in keys.iter() {
            let (bounds, count) = &mut bins[bin(key, axis)];
            *bounds = bounds.joined(boxes[key.1 as usize]);
            *count += 1;
        }
        let both = |a: (AlignedBox, usize), b: (AlignedBox, usize)| (a.0.joined(b.0), a.1 + b.1);
        let cost = |part: (AlignedBox, usize)| part.0.surface() * part.1 as f32;
        for cut in 1..BINS {
            let [low, high] = [&bins[..cut], &bins[cut..]]
                .map(|side| side.iter().copied().fold((AlignedBox::EMPTY, 0), both));
            if low.1 > 0 && high.1 > 0 && cost(low) + cost(high) < best.0 {
                best = (cost(low) + cost(high), axis, cut);
            }
        }
    }
    let (cost, axis, cut) = best;
    if cost == f32::INFINITY {
        return longest(keys);
    }
    keys.sort_unstable_by_key(|key| bin(key, axis) >= cut);
    keys.partition_point(|key| bin(key, axis) < cut)
}

fn joined(boxes: &[AlignedBox], things: impl Iterator<Item = u32>) -> AlignedBox {
    things.fold(AlignedBox::EMPTY, |all, i| all.joined(boxes[i as usize]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::noise;

    /// Numbers between 0 and 1.
    fn random() -> impl FnMut() -> f64 {
        let mut numbers = noise(7, 100_000).into_iter().cycle();
        move || f64::from(numbers.next().unwrap().abs())
    }

    /// Boxes of every size and shape, some flat, some alike, some far away.
    fn boxes(count: usize) -> Vec<[[f64; 3]; 2]> {
        let mut random = random();
        let each = (0..count).map(|i| {
            let far = if i % 11 == 0 { 1e3 } else { 1.0 };
            let low: [f64; 3] = std::array::from_fn(|_| far * random());
            let size: [f64; 3] = std::array::from_fn(|axis| match (i + axis) % 5 {
                0 => 0.0,
                1 => random(),
                _ => 0.1 * random(),
            });
            match i % 7 {
                0 => [[0.5; 3]; 2],
                _ => [low, std::array::from_fn(|axis| low[axis] + size[axis])],
            }
        });
        each.collect()
    }

    fn tree(boxes: &[[[f64; 3]; 2]]) -> BoxTree {
        let bounds: Vec<AlignedBox> = boxes.iter().map(|&b| AlignedBox::around(b, 0.0)).collect();
        BoxTree::of(&bounds, &Work::new())
    }

    #[test]
    fn every_thing_is_in_one_leaf() {
        for count in [0, 1, 4, 5, 16, 17, 1000, 40_000] {
            let tree = tree(&boxes(count));
            let mut order = tree.order().to_vec();
            order.sort_unstable();
            assert!(order.into_iter().eq(0..count as u32));
            let leaves = tree.firsts.len() - 1;
            let mut next = 0;
            for leaf in 0..leaves {
                let places = tree.places(leaf);
                assert!(places.start == next && (1..=LEAF).contains(&places.len()));
                next = places.end;
            }
            assert_eq!(next, count);
        }
    }

    #[test]
    fn leaves_of_a_canceled_run_are_as_small_as_others() {
        let work = Work::new();
        work.cancel();
        let at = |i: u32| [i as f32, 0.0, 0.0];
        let leaf = |things: &[u32]| (AlignedBox::of(things.iter().map(|&i| at(i))), things.len());
        let (_, counts) = BoxTree::of_small(40_000, at, leaf, &work);
        assert_eq!(counts.iter().sum::<usize>(), 40_000);
        assert!(counts.into_iter().all(|count| (1..=LEAF).contains(&count)));
    }

    /// A plain twin of [`BoxTree::along`], in f64: a part of the ray, shorter than any box, lies between three pairs of planes.
    fn meets([low, high]: [[f64; 3]; 2], from: [f64; 3], along: [f64; 3], reach: f64) -> bool {
        let (mut enter, mut leave) = (0.0f64, reach);
        for axis in 0..3 {
            if along[axis] == 0.0 {
                if from[axis] < low[axis] || from[axis] > high[axis] {
                    return false;
                }
                continue;
            }
            let a = (low[axis] - from[axis]) / along[axis];
            let b = (high[axis] - from[axis]) / along[axis];
            (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
        }
        enter <= leave
    }

    #[test]
    fn a_ray_meets_what_it_meets_beside_every_box() {
        let boxes = boxes(3000);
        let tree = tree(&boxes);
        let mut random = random();
        let (mut met, mut given) = (0, 0);
        for i in 0..600 {
            let from: [f64; 3] = std::array::from_fn(|_| 3.0 * random() - 1.0);
            let at = boxes[i % boxes.len()][i % 2]; // through a corner
            let mut along: [f64; 3] = std::array::from_fn(|axis| at[axis] - from[axis]);
            if i % 3 == 0 {
                along[i % 2] = 0.0; // in a plane of two axes
            }
            let reach = if i % 5 == 0 { 0.7 } else { f64::INFINITY };
            let mut found = vec![false; boxes.len()];
            tree.along(from, along, reach, |places| {
                given += places.len();
                tree.order()[places]
                    .iter()
                    .for_each(|&k| found[k as usize] = true);
                f64::INFINITY
            });
            for (k, &b) in boxes.iter().enumerate() {
                let meets = meets(b, from, along, reach);
                assert!(!meets || found[k], "ray {i}, box {k}");
                met += usize::from(meets);
            }
        }
        assert!(met > 1000 && given < 40 * met, "{met} of {given}"); // it leaves out most of 1.8 million
    }

    #[test]
    fn the_nearest_leaf_comes_first_and_a_shorter_reach_ends_the_search() {
        let wall = |i: usize| [[i as f64, -1.0, -1.0], [i as f64 + 0.1, 1.0, 1.0]];
        let boxes: Vec<_> = (0..1000).map(wall).collect();
        let tree = tree(&boxes);
        let mut given = 0;
        let mut first = f64::INFINITY;
        tree.along(
            [700.5, 0.0, 0.0],
            [-1.0, 0.1e-3, 0.0],
            f64::INFINITY,
            |places| {
                for &i in &tree.order()[places] {
                    given += 1;
                    if (i as f64) < 700.0 {
                        first = first.min(700.5 - boxes[i as usize][1][0]);
                    }
                }
                first
            },
        );
        assert!(
            (first - 1.4).abs() < 1e-9 && given <= 2 * LEAF,
            "{first} {given}"
        ); // wall 699 ends at 699.1
    }

    #[test]
    fn trees_of_both_kinds_find_the_nearest_thing() {
        let mut random = random();
        let points: Vec<Point> = (0..500).map(|_| [0; 3].map(|_| random() as f32)).collect();
        let point_of = |i: &u32| points[*i as usize];
        let work = Work::new();
        let leaf = |things: &[u32]| (AlignedBox::of(things.iter().map(point_of)), things.to_vec());
        let (small, contents) = BoxTree::of_small(points.len(), |i| point_of(&i), leaf, &work);
        let bounds: Vec<AlignedBox> = points.iter().map(|&p| AlignedBox::of([p])).collect();
        let any = BoxTree::of(&bounds, &work);
        let squared = |a: Point, b: Point| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f32>();
        for _ in 0..200 {
            let p: Point = [0; 3].map(|_| 2.0 * random() as f32 - 0.5);
            let least = |all: &mut dyn Iterator<Item = &u32>| {
                all.map(|i| squared(p, point_of(i)))
                    .fold(f32::INFINITY, f32::min)
            };
            let all: Vec<u32> = (0..points.len() as u32).collect();
            let nearest = least(&mut all.iter());
            let found = small.near(p, f32::INFINITY, |i| least(&mut contents[i].iter()));
            assert_eq!(found, nearest);
            let things = |i| any.order()[any.places(i)].iter();
            let found = any.near(p, nearest.next_up(), |i| least(&mut things(i)));
            assert_eq!(found, nearest);
        }
    }
}
