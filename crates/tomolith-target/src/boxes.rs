//! A tree of boxes: which of many things lie along a stretch of line.

/// Things per leaf.
const LEAF: usize = 4;

/// A box `[low, high]`.
pub(super) type Box3 = [[f64; 3]; 2];

/// Boxes, halved again and again along the longest extent of their middles.
pub(super) struct Tree {
    nodes: Vec<Node>,
    items: Vec<(u32, Box3)>,
}

struct Node {
    bounds: Box3,
    kind: NodeKind,
}

enum NodeKind {
    /// Items from the first to before the second number.
    Leaf(usize, usize),
    /// The first child follows at once, the second stands here.
    Inner(usize),
}

impl Tree {
    pub(super) fn new(boxes: &[Box3]) -> Self {
        let mut tree = Tree {
            nodes: Vec::with_capacity(boxes.len()),
            items: (0..).zip(boxes.iter().copied()).collect(),
        };
        if !boxes.is_empty() {
            tree.divide(0, boxes.len());
        }
        tree
    }

    /// Makes the node of the items `from..to`.
    fn divide(&mut self, from: usize, to: usize) {
        let items = &mut self.items[from..to];
        let bounds = items.iter().map(|item| item.1).fold(EMPTY, join);
        let middles = items.iter().map(|item| [middle(&item.1); 2]);
        let [low, high] = middles.fold(EMPTY, join);
        let longest = (0..3).max_by(|&a, &b| (high[a] - low[a]).total_cmp(&(high[b] - low[b])));
        let this = self.nodes.len();
        self.nodes.push(Node {
            bounds,
            kind: NodeKind::Leaf(from, to),
        });
        if let Some(axis) = longest
            && items.len() > LEAF
        {
            let half = items.len() / 2;
            items.select_nth_unstable_by(half, |a, b| {
                let by_place = middle(&a.1)[axis].total_cmp(&middle(&b.1)[axis]);
                by_place.then(a.0.cmp(&b.0))
            });
            self.divide(from, from + half);
            let second = self.nodes.len();
            self.divide(from + half, to);
            self.nodes[this].kind = NodeKind::Inner(second);
        }
    }

    /// Visits every thing whose box the line from one end to the other meets, in an order that depends on the tree alone.
    pub(super) fn for_each_along(&self, [from, to]: [[f64; 3]; 2], mut visit: impl FnMut(u32)) {
        let along: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
        let inverse = along.map(|v| 1.0 / v);
        let mut waiting = vec![];
        let mut next = (!self.nodes.is_empty()).then_some(0);
        while let Some(node) = next {
            next = None;
            if meets(&self.nodes[node].bounds, from, inverse) {
                match self.nodes[node].kind {
                    NodeKind::Inner(second) => {
                        waiting.push(second);
                        next = Some(node + 1);
                    }
                    NodeKind::Leaf(first, end) => {
                        for (item, bounds) in &self.items[first..end] {
                            if meets(bounds, from, inverse) {
                                visit(*item);
                            }
                        }
                    }
                }
            }
            next = next.or_else(|| waiting.pop());
        }
    }
}

const EMPTY: Box3 = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];

fn join(a: Box3, b: Box3) -> Box3 {
    [
        std::array::from_fn(|i| a[0][i].min(b[0][i])),
        std::array::from_fn(|i| a[1][i].max(b[1][i])),
    ]
}

fn middle(bounds: &Box3) -> [f64; 3] {
    std::array::from_fn(|i| (bounds[0][i] + bounds[1][i]) / 2.0)
}

/// Whether a stretch of line meets a box: it lies between all three pairs of planes at once.
fn meets(bounds: &Box3, from: [f64; 3], inverse: [f64; 3]) -> bool {
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    for i in 0..3 {
        if inverse[i].is_finite() {
            let a = (bounds[0][i] - from[i]) * inverse[i];
            let b = (bounds[1][i] - from[i]) * inverse[i];
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        } else if from[i] < bounds[0][i] || from[i] > bounds[1][i] {
            return false;
        }
    }
    enter <= leave
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::noise;

    #[test]
    fn the_same_boxes_are_met_as_by_looking_at_all() {
        let mut random = noise(7, 100_000).into_iter().cycle();
        let mut number = || f64::from(random.next().unwrap().abs());
        let boxes: Vec<Box3> = (0..300)
            .map(|_| {
                let low: [f64; 3] = std::array::from_fn(|_| number());
                [low, low.map(|v| v + 0.1 * number())]
            })
            .collect();
        let tree = Tree::new(&boxes);
        let mut met = 0;
        for _ in 0..300 {
            let from: [f64; 3] = std::array::from_fn(|_| number());
            let mut to: [f64; 3] = std::array::from_fn(|_| number());
            to[1] = from[1]; // along a plane of the axes too
            let mut found = Vec::new();
            tree.for_each_along([from, to], |i| found.push(i as usize));
            found.sort_unstable();
            // A thousand points on the line instead of arithmetic with slabs
            let on_line = |share: f64| -> [f64; 3] {
                std::array::from_fn(|i| from[i] + share * (to[i] - from[i]))
            };
            let holds = |b: &Box3, p: [f64; 3]| (0..3).all(|i| b[0][i] <= p[i] && p[i] <= b[1][i]);
            for (i, b) in boxes.iter().enumerate() {
                let hit = (0..=1000).any(|s| holds(b, on_line(f64::from(s) / 1000.0)));
                assert!(!hit || found.binary_search(&i).is_ok(), "{i}");
            }
            met += found.len();
        }
        assert!(met > 100 && met < 300 * 30, "{met}"); // it finds some, and not all
        Tree::new(&[]).for_each_along([[0.0; 3], [1.0; 3]], |_| panic!("nothing is there"));
    }
}
