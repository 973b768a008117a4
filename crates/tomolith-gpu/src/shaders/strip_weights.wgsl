struct Parameters {
    first_beam: u32, end_beam: u32, beams: u32, first_slot: u32,
    nx: u32, ny: u32, is_pure: u32, tiles: u32,
    rows: u32,
}
struct Strip {
    edges: vec4<f32>, span: vec2<f32>, base: f32, per_row: f32,
    column: u32, upward: u32, is_lit: u32, padding: u32,
}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read> strips: array<Strip>;
// Outer ends, core ends; of the rows along x, then of those along y
@group(0) @binding(2) var<storage, read> resin_rows: array<vec4<f32>>;

// 1 − e^−a, without cancellation where a is small
fn lost(a: f32) -> f32 {
    if (a > 0.25) { return 1.0 - exp(-a); }
    return a * (1.0 - a / 2.0 * (1.0 - a / 3.0 * (1.0 - a / 4.0 * (1.0 - a / 5.0 * (1.0 - a / 6.0 * (1.0 - a / 7.0))))));
}

// A strip in a row of voxels: left and right end within resin, and energy per width; the last is 0 where there is none.
fn in_row(strip: Strip, row: f32, resin: vec4<f32>, origin: f32) -> vec3<f32> {
    let low = max(row, strip.span.x);
    let high = min(row + 1.0, strip.span.y);
    if (!(low < high)) { return vec3(0.0); }
    let way = high - low;
    var energy = strip.base * way;
    if (p.is_pure == 0u) {
        let depth = select(strip.span.y - high, low - strip.span.x, strip.upward == 1u);
        energy = strip.base * lost(strip.per_row * way) * exp(-strip.per_row * depth);
    }
    let middle = 0.5 * (low + high);
    let a = (strip.edges.x - origin) + strip.edges.y * middle;
    let b = (strip.edges.z - origin) + strip.edges.w * middle;
    let outer = resin.xy - origin;
    var left = max(min(a, b), outer.x);
    var right = min(max(a, b), outer.y);
    if (resin.z < resin.w) {
        let core = resin.zw - origin;
        if (left + right <= core.x + core.y) { right = min(right, core.x); } else { left = max(left, core.y); }
    }
    if (!(right - left >= 1e-4)) {
        let at = max(min(0.5 * (left + right), outer.y - 5e-5), outer.x + 5e-5);
        left = at - 5e-5;
        right = at + 5e-5;
    }
    return vec3(left, right, energy / (right - left));
}
