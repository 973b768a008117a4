// A thread follows the rays of one pixel of a slot, a column of pixels in a frame, through the voxels `low` to `high` of a grid
// Nearest point and rate, direction and energy, span
@group(0) @binding(1) var<storage, read> segments: array<vec2<f32>>;
// First segment of each pixel, and before them the cosine and sine of each azimuth
@group(0) @binding(2) var<storage, read> starts: array<u32>;
// First element, lowest row, rows, frame
@group(0) @binding(3) var<storage, read> runs: array<vec4<u32>>;
@group(0) @binding(4) var<storage, read> lit: array<u32>;

// A straight piece of a ray: a point of its line, attenuation, direction, deposit right behind its begin, begin and end
struct Segment { at: vec3<f32>, rate: f32, along: vec3<f32>, energy: f32, span: vec2<f32> }

// (1 - exp(-x))/x for |x| up to 0.5, to 1e-8
fn phi(x: f32) -> f32 {
    return ((((((-x / 40320.0 + 1.0 / 5040.0) * x - 1.0 / 720.0) * x + 1.0 / 120.0) * x - 1.0 / 24.0) * x + 1.0 / 6.0) * x - 0.5) * x + 1.0;
}

// The major axis first, then the others, x before y before z
fn by_axis(v: vec3<f32>, axis: u32) -> vec3<f32> {
    return select(select(v.zxy, v.yxz, axis == 1u), v, axis == 0u);
}

// What is left of light after such a way with such a rate
fn left(rate: f32, way: f32) -> f32 {
    return exp(min(-rate * way, 0.0));
}

// A stored segment as seen from an azimuth
fn segment(i: u32, turn: vec2<f32>) -> Segment {
    let nearest = segments[5u * i];
    let height = segments[5u * i + 1u];
    let flat = segments[5u * i + 2u];
    let rise = segments[5u * i + 3u];
    let at = vec3(turn.x * nearest.x - turn.y * nearest.y, turn.y * nearest.x + turn.x * nearest.y, height.x);
    let along = vec3(turn.x * flat.x - turn.y * flat.y, turn.y * flat.x + turn.x * flat.y, rise.x);
    return Segment(at, height.y, along, rise.y, segments[5u * i + 4u]);
}

// Calls `reach` with the voxels that a segment passes, and what a pixel of value 1 leaves in each
fn walk(own: Segment) {
    let size = abs(own.along);
    let axis = select(select(2u, 1u, size.y >= size.z), 0u, size.x >= size.y && size.x >= size.z);
    let place = by_axis(own.at, axis);
    let direction = by_axis(own.along, axis);
    // The lowest faces of the grid; coordinates count from the axis of the vial, where f32 are finest
    let corner = by_axis(vec3(p.corner_x, p.corner_y, 0.0), axis);
    let counts = by_axis(vec3(f32(p.nx), f32(p.ny), f32(p.nz)), axis);
    let steps = vec3(p.row, p.row * p.nx, 1u);
    let strides = select(select(steps.zxy, steps.yxz, axis == 1u), steps, axis == 0u);
    // Over a cell of the major axis
    let step = 1.0 / abs(direction.x);
    let rate = own.rate * select(-step, step, direction.x > 0.0);
    let energy = own.energy * step;
    let slope = direction.yz / direction.x;
    let offset = place.yz - slope * place.x;
    let ends = place.x + own.span * direction.x;
    var low = max(min(ends.x, ends.y), corner.x);
    var high = min(max(ends.x, ends.y), corner.x + counts.x);
    // Where the others are in the grid; hardly any slope changes nothing
    for (var k = 0u; k < 2u; k++) {
        if (abs(slope[k]) < 1e-9) { continue; }
        let faces = (corner[k + 1u] - offset[k] + vec2(0.0, counts[k + 1u])) / slope[k];
        low = max(low, min(faces.x, faces.y));
        high = min(high, max(faces.x, faces.y));
    }
    if (low >= high) { return; }
    let is_opaque = abs(rate) > 0.5;
    let last = min(i32(ceil(high - corner.x)), i32(counts.x));
    for (var cell = max(i32(floor(low - corner.x)), 0); cell < last; cell++) {
        let begin = max(low, f32(cell) + corner.x);
        let end = min(high, f32(cell) + corner.x + 1.0);
        if (end <= begin) { continue; }
        let before = floor(slope * begin + offset - corner.yz);
        let after = floor(slope * end + offset - corner.yz);
        // Where faces of the others are crossed; at the end where none is
        let faces = clamp((max(before, after) + corner.yz - offset) / slope, vec2(begin), vec2(end));
        let crossing = select(faces, vec2(end), before == after);
        let is_first = crossing.x < crossing.y;
        let middle = select(vec2(before.x, after.y), vec2(after.x, before.y), is_first);
        let cuts = vec4(begin, min(crossing.x, crossing.y), max(crossing.x, crossing.y), end);
        var power = energy * left(rate, begin - ends.x);
        for (var piece = 0u; piece < 3u; piece++) {
            let way = cuts[piece + 1u] - cuts[piece];
            var deposit = power * way * phi(rate * way);
            if (is_opaque) {
                deposit = energy * (left(rate, cuts[piece] - ends.x) - left(rate, cuts[piece + 1u] - ends.x)) / rate;
            }
            power -= rate * deposit;
            let other = select(select(after, middle, piece == 1u), before, piece == 0u);
            if (way > 0.0 && all(other >= vec2(0.0)) && all(other < counts.yz)) {
                reach(u32(cell) * strides.x + u32(other.x) * strides.y + u32(other.y) * strides.z, deposit);
            }
        }
    }
}

// A pixel: its element, the first of its segments and the one behind the last, and its frame
struct Pixel { element: u32, first: u32, end: u32, frame: u32 }

// The pixel of a thread; no element where there is none
fn pixel(t: u32) -> Pixel {
    let none = Pixel(0xffffffffu, 0u, 0u, 0u);
    if (t / p.rows >= p.slots) { return none; }
    let slot = p.first_slot + t / p.rows;
    let frame = slot / p.columns;
    let column = slot % p.columns;
    let run = runs[frame * p.all_columns + p.first_column + column];
    let i = t % p.rows;
    let element = run.x + i;
    if (i >= run.z || element < p.begin || element >= p.end) { return none; }
    let k = select(column * p.image_rows + run.y + i, element - p.first_pixel, p.image_rows == 0u);
    return Pixel(element, starts[p.first_start + k], starts[p.first_start + k + 1u], frame);
}

// Follows some of the segments of a pixel, counted through all azimuths of its frame
fn follow_all(found: Pixel) {
    let count = found.end - found.first;
    for (var i = p.first_segment; i < min(p.end_segment, p.turns * count); i++) {
        let turn = 2u * (found.frame * p.turn_step + i / count);
        let azimuth = bitcast<vec2<f32>>(vec2(starts[turn], starts[turn + 1u]));
        follow(segment(found.first + i % count, azimuth), found.element, i);
    }
}
