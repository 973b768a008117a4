//! The walk in vectors of cells, written once: [`eight`](super::eight) and [`wide`](super::wide) say what a vector is, and name its instructions.

/// One-line functions of vectors.
macro_rules! instructions {
    ($features:literal: $($name:ident($($given:ident: $type:ty),*) -> $result:ty = $do:expr;)*) => {
        $(
            #[target_feature(enable = $features)]
            #[inline]
            fn $name($($given: $type),*) -> $result {
                $do
            }
        )*
    };
}
pub(super) use instructions;

/// What a processor with these features does with `LANES` cells of the major axis at a time. The file that makes it has the instructions that stand here
/// as functions.
macro_rules! walk {
    ($features:literal, $Floats:ident, $Whole:ident, $Mask:ident) => {
        /// A segment, spread over vectors.
        struct Spread {
            offset: [$Floats; 2],
            slope: [$Floats; 2],
            steep: [$Floats; 2],
            low: $Floats,
            high: $Floats,
            enter: $Floats,
            rate: $Floats,
            energy: $Floats,
            opaque: bool,
            thin: bool,
            /// Slope of b, of c is not 0: there are faces to cross.
            crosses: [bool; 2],
        }

        /// Where the cells of a vector are, along one of the other two axes.
        struct Side {
            /// Floats to the first voxel, and to the one behind the face.
            voxel: [$Whole; 2],
            /// Whether those lie in the grid.
            within: [$Mask; 2],
            /// Where the face is crossed; at the end where none is.
            crossing: $Floats,
        }

        /// A segment for a pixel of this value.
        #[target_feature(enable = $features)]
        #[inline]
        fn spread(segment: &Segment, value: f32) -> Spread {
            let all = splat;
            Spread {
                offset: segment.offset.map(|v| all(v)),
                slope: segment.slope.map(|v| all(v)),
                steep: segment.slope.map(|v| all(1.0 / v)),
                low: all(segment.low),
                high: all(segment.high),
                enter: all(segment.enter),
                rate: all(segment.rate),
                energy: all(segment.energy * value),
                opaque: segment.rate.abs() > OPAQUE,
                thin: segment.rate.abs() <= THIN,
                crosses: segment.slope.map(|v| v != 0.0),
            }
        }

        #[target_feature(enable = $features)]
        #[inline]
        fn phi(x: $Floats, thin: bool) -> $Floats {
            let series = |sum, &c: &f32| fused(sum, x, splat(c));
            let (high, low) = PHI.split_at(PHI.len() / 2);
            let sum = match thin {
                true => splat(0.0),
                false => high.iter().fold(splat(0.0), series),
            };
            low.iter().fold(sum, series)
        }

        /// What is left at `a` of what entered.
        #[target_feature(enable = $features)]
        #[inline]
        fn left(s: &Spread, a: $Floats) -> $Floats {
            let depth = mul(s.rate, sub(a, s.enter));
            exp(min(sub(splat(0.0), depth), splat(0.0)))
        }

        /// The voxels between `begin` and `end` of each cell along axis `i` of the other two.
        #[target_feature(enable = $features)]
        #[inline]
        fn side(ways: Ways, s: &Spread, i: usize, begin: $Floats, end: $Floats) -> Side {
            let stride = splat_whole(ways.strides[i + 1]);
            let at = |a| floor(fused(s.slope[i], a, s.offset[i]));
            let voxel = |place| mul_whole(place, stride);
            let is_within = |place| within(place, ways.counts[i + 1]);
            let first = at(begin);
            let place = whole(first);
            if !s.crosses[i] {
                return Side {
                    voxel: [voxel(place); 2],
                    within: [is_within(place); 2],
                    crossing: end,
                };
            }
            let last = at(end);
            let face = max(first, last);
            let meets = mul(sub(face, s.offset[i]), s.steep[i]);
            let meets = min(max(meets, begin), end);
            let behind = whole(last);
            Side {
                voxel: [voxel(place), voxel(behind)],
                within: [is_within(place), is_within(behind)],
                crossing: choose(differ(first, last), meets, end),
            }
        }

        /// Calls `visit(lit, voxels, deposits)` for the pieces, at most three, in the cells from `first` on. Within a piece the voxels
        /// differ: they lie in different cells of the major axis.
        #[target_feature(enable = $features)]
        #[inline]
        fn pieces(
            ways: Ways,
            first: f32,
            s: &Spread,
            mut visit: impl FnMut($Mask, $Whole, $Floats),
        ) {
            let cell = add(splat(first), ramp());
            let begin = max(s.low, cell);
            let end = min(s.high, add(cell, splat(1.0)));
            let lit = above(end, begin);
            if bits(lit) == 0 {
                return;
            }
            let along = mul_whole(whole(cell), splat_whole(ways.strides[0]));
            let [b, c] = [0, 1].map(|i| side(ways, s, i, begin, end));
            let mut power = mul(s.energy, left(s, begin));
            let mut piece = |from, to, within: $Mask, at_b, at_c| {
                let way = sub(to, from);
                let lit = both(lit, above(way, splat(0.0)));
                if bits(lit) == 0 {
                    return;
                }
                let deposit = if s.opaque {
                    let lost = sub(left(s, from), left(s, to));
                    div(mul(s.energy, lost), s.rate)
                } else {
                    let x = mul(s.rate, way);
                    mul(mul(power, way), phi(x, s.thin))
                };
                power = fused_less(s.rate, deposit, power);
                let voxel = add_whole(along, add_whole(at_b, at_c));
                visit(both(lit, within), voxel, deposit);
            };
            // What comes first is where the first voxels of both are, what comes last where the last ones are
            let cut = min(b.crossing, c.crossing);
            let first = both(b.within[0], c.within[0]);
            let last = both(b.within[1], c.within[1]);
            piece(begin, cut, first, b.voxel[0], c.voxel[0]);
            if s.crosses[0] && s.crosses[1] {
                let b_first = above(c.crossing, b.crossing);
                let behind = max(b.crossing, c.crossing);
                let of_b = both(b.within[1], c.within[0]);
                let of_c = both(b.within[0], c.within[1]);
                piece(
                    cut,
                    behind,
                    choose_mask(b_first, of_b, of_c),
                    choose_whole(b_first, b.voxel[1], b.voxel[0]),
                    choose_whole(b_first, c.voxel[0], c.voxel[1]),
                );
                piece(behind, end, last, b.voxel[1], c.voxel[1]);
            } else if s.crosses[0] || s.crosses[1] {
                piece(cut, end, last, b.voxel[1], c.voxel[1]);
            }
        }

        /// Voxel and deposit of every piece in a slab.
        #[target_feature(enable = $features)]
        #[inline]
        fn each_piece(ways: Ways, slab: usize, s: &Spread, mut visit: impl FnMut(usize, f32)) {
            for first in (slab * SLAB..(slab + 1) * SLAB).step_by(LANES) {
                pieces(ways, first as f32, s, |lit, voxel, deposit| {
                    let (mut voxels, mut deposits) = ([0i32; LANES], [0.0f32; LANES]);
                    // SAFETY: as many numbers as a vector has.
                    unsafe {
                        store_whole(voxels.as_mut_ptr().cast(), voxel);
                        store(deposits.as_mut_ptr(), deposit);
                    }
                    let mut lit = bits(lit);
                    while lit != 0 {
                        let k = lit.trailing_zeros() as usize % LANES;
                        visit(voxels[k] as usize, deposits[k]);
                        lit &= lit - 1;
                    }
                });
            }
        }

        /// Calls `visit(voxel, deposit)` for every piece in a slab.
        ///
        /// # Safety
        /// The features.
        #[target_feature(enable = $features)]
        pub(super) unsafe fn for_each(
            ways: Ways,
            slab: usize,
            segment: &Segment,
            visit: &mut impl FnMut(usize, f32),
        ) {
            each_piece(ways, slab, &spread(segment, 1.0), visit);
        }
    };
}
pub(super) use walk;
