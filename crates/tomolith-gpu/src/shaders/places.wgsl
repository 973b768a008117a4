// Samples around a place, as the form has them
struct Taps { taps: i32, lower: i32, last: i32, is_turned: u32 }

// The first of the samples that a place sees, where its row of weights begins, and how far it lies on the way to the next row
struct Seen { first: i32, at: i32, share: f32, is_turned: bool }

// Where light of an azimuth meets a voxel, and its weight
struct Met { along: Seen, across: Seen, weight: f32 }

fn seen(whole: i32, rest: f32, taps: Taps) -> Seen {
    let carry = floor(rest);
    let sum = whole + i32(carry);
    var below = sum >> 14u;
    var share = (f32(sum & 16383) + (rest - carry)) / 16384.0;
    let is_turned = taps.is_turned == 1u && 2.0 * (f32(below) + share) < f32(taps.last);
    if (is_turned) {
        below = taps.last - below;
        if (share > 0.0) { below -= 1; share = 1.0 - share; }
    }
    let half = taps.taps / 2;
    let lower = clamp(below + half - taps.last, 0, taps.lower);
    let row = share * f32(p.rows);
    let index = min(i32(row), i32(p.rows) - 1);
    var first = below + 1 - half - lower;
    if (is_turned) { first = taps.last - (first + taps.taps - 1); }
    return Seen(first, (lower * (i32(p.rows) + 1) + index) * taps.taps, row - f32(index), is_turned);
}

fn weight_along(near: Seen, tap: i32) -> f32 {
    let at = near.at + select(tap, p.along_taps - 1 - tap, near.is_turned);
    let low = table_along[at];
    return low + near.share * (table_along[at + p.along_taps] - low);
}

fn weight_across(near: Seen, tap: i32) -> f32 {
    let at = near.at + select(tap, p.across_taps - 1 - tap, near.is_turned);
    let low = table_across[at];
    return low + near.share * (table_across[at + p.across_taps] - low);
}

fn met(turn: u32, ix: i32, iy: i32) -> Met {
    let way = vec2<f32>(f32(ix), f32(iy));
    let parts = bitcast<vec4<i32>>(turns[4u * turn]);
    let rests = bitcast<vec4<f32>>(turns[4u * turn + 1u]);
    let cos_sin = vec2<f32>(bitcast<f32>(parts.w), rests.w);
    var whole = parts.x + ix * parts.y + iy * parts.z;
    var rest = rests.x + dot(way, rests.yz);
    // Depths before the focal plane are mirror images of those behind it
    if (f32(whole) + rest < 0.0) { whole = -whole; rest = -rest; }
    let along = seen(whole - p.start_parts, rest - p.start_rest, Taps(p.along_taps, p.along_lower, p.along_last, p.along_turned));
    let parts_u = bitcast<vec4<i32>>(turns[4u * turn + 2u]);
    let rests_u = bitcast<vec4<f32>>(turns[4u * turn + 3u]);
    let of_across = Taps(p.across_taps, p.across_lower, p.across_last, p.across_turned);
    let across = seen(parts_u.x + ix * parts_u.y + iy * parts_u.z, rests_u.x + dot(way, rests_u.yz), of_across);
    var weight = p.active_part;
    if (p.attenuation > 0.0) {
        let place = vec2<f32>(p.x, p.y) + p.pitch * way;
        let depth = -dot(place, cos_sin);
        let u = place.y * cos_sin.x - place.x * cos_sin.y;
        var enter = p.entrance;
        if (p.wall >= 0.0) { enter = -sqrt(max(p.wall * p.wall - u * u, 0.0)); }
        weight *= exp(-p.attenuation * max(depth - enter, 0.0));
    }
    return Met(along, across, weight);
}

// Voxels of a row whose place, `step` further with each, lies between two bounds relative to voxel 0: the first, and the one behind the last
fn row_in(bounds: vec2<f32>, step: f32) -> vec2<f32> {
    if (abs(step) < 1e-5) { return vec2(0.0, f32(p.nx)); }
    let ends = bounds / step;
    let low = floor(min(ends.x, ends.y));
    let high = ceil(max(ends.x, ends.y)) + 1.0;
    return clamp(vec2(low, high), vec2(0.0), vec2(f32(p.nx)));
}
