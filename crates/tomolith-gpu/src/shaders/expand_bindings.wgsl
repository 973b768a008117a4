struct Parameters {
    slots: u32, lanes: u32, first_slot: u32, taps: u32,
    begin: u32, end: u32, first_frame: u32, end_frame: u32,
    count: u32, has_dark: u32, factor: f32,
}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read_write> lanes: array<f32>;
@group(0) @binding(2) var<storage, read> x: array<f32>;
// First element, lowest row, rows, frame
@group(0) @binding(3) var<storage, read> runs: array<vec4<u32>>;
@group(0) @binding(4) var<storage, read> sources: array<vec2<u32>>;
@group(0) @binding(5) var<storage, read> first: array<u32>;
@group(0) @binding(6) var<storage, read> weights: array<f32>;
@group(0) @binding(7) var<storage, read> lit: array<u32>;

fn light(run: vec4<u32>, lane: u32) -> f32 {
    if (run.x < p.begin || run.x >= p.end || run.w < p.first_frame || run.w >= p.end_frame) { return 0.0; }
    var sum = 0.0;
    for (var tap = 0u; tap < p.taps; tap++) {
        let row = first[lane] + tap;
        if (row >= run.y && row - run.y < run.z) {
            let element = run.x + row - run.y;
            let is_lit = p.has_dark == 0u || ((lit[element / 32u] >> (element % 32u)) & 1u) == 1u;
            sum += select(0.0, weights[tap * p.count + lane] * x[element - p.begin], is_lit);
        }
    }
    return sum;
}
