// What is scattered out of a segment of unscattered light, from event to event
const TAU: f32 = 6.2831853;
// In cells: beyond every wall that light meets before it is gone
const FAR: f32 = 1e6;

fn reach(element: u32, deposit: f32) { visit(element, deposit); }

// Four random numbers in (0, 1) of an event
fn uniform4(element: u32, event: u32) -> vec4<f32> {
    var v = vec4(element, event, p.seed_low, p.seed_high) * 1664525u + 1013904223u;
    for (var round = 0u; round < 2u; round++) {
        v.x += v.y * v.w;
        v.y += v.z * v.x;
        v.z += v.x * v.y;
        v.w += v.y * v.z;
        v ^= v >> vec4(16u);
    }
    // 23 bits and a half are a number of 24 bits
    return (vec4<f32>(v >> vec4(9u)) + 0.5) / 8388608.0;
}

// The cosine below which this part of the light goes
fn cosine_of(part: f32) -> f32 {
    if (p.intervals > 0u) {
        let i = min(u32(part * f32(p.intervals)), p.intervals - 1u);
        return mix(table[i], table[i + 1u], part * f32(p.intervals) - f32(i));
    }
    // Henyey and Greenstein's, without the difference that cancels at small g
    let s = 2.0 * part - 1.0;
    let g = p.g;
    let root = 1.0 + g * s;
    return (s + g * (0.5 * (s * s + 3.0) + g * (s + 0.5 * g * (s * s - 1.0)))) / (root * root);
}

// A direction at this angle (its cosine) and azimuth from another
fn deflected(d: vec3<f32>, cosine: f32, azimuth: f32) -> vec3<f32> {
    let size = abs(d);
    let x_or_y = select(vec3(0.0, 1.0, 0.0), vec3(1.0, 0.0, 0.0), size.x <= size.y);
    let least = select(vec3(0.0, 0.0, 1.0), x_or_y, min(size.x, size.y) <= size.z);
    let a = normalize(cross(d, least));
    let b = cross(d, a);
    // Cards may have sine and cosine to 5e-4: the angle is exact all the same
    let turn = normalize(vec2(cos(azimuth), sin(azimuth)));
    let sine = sqrt(max((1.0 - cosine) * (1.0 + cosine), 0.0));
    return normalize(cosine * d + sine * (turn.x * a + turn.y * b));
}

// The way from a point to the wall of the resin
fn to_wall(at: vec3<f32>, d: vec3<f32>) -> f32 {
    var way = FAR;
    if (p.is_round == 1u) {
        let a = dot(d.xy, d.xy);
        let b = dot(at.xy, d.xy);
        let c = max(p.half * p.half - dot(at.xy, at.xy), 0.0);
        let root = sqrt(b * b + a * c);
        // The form that does not cancel
        way = min(way, select((root - b) / max(a, 1e-12), c / max(b + root, 1e-12), b > 0.0));
    } else {
        for (var k = 0u; k < 2u; k++) {
            if (abs(d[k]) > 1e-9) { way = min(way, (p.half - at[k] * sign(d[k])) / abs(d[k])); }
        }
    }
    let end = select(p.low_end, p.high_end, d.z > 0.0);
    if (abs(d.z) > 1e-9) { way = min(way, (end - at.z) / d.z); }
    return max(way, 0.0);
}

// How far light comes that loses `part` of itself: -ln(1 - part), for small parts by the series of the inverse hyperbolic tangent
fn depth_of(part: f32) -> f32 {
    let t = part / (2.0 - part);
    let series = 2.0 * t * (1.0 + t * t * (1.0 / 3.0 + t * t * (0.2 + t * t / 7.0)));
    return select(-log(1.0 - part), series, part < 0.25);
}

fn follow(first: Segment, element: u32, path: u32) {
    let place = vec3(first.at.xy, first.at.z) / p.edge + vec3(0.0, 0.0, p.floor);
    var own = Segment(place, first.rate * p.edge, first.along, first.energy / (p.edge * p.edge), first.span / p.edge);
    for (var order = 0u; order < p.orders; order++) {
        let way = own.span.y - own.span.x;
        let depth = own.rate * way;
        let taken = select(1.0 - exp(-depth), depth * phi(depth), depth < 0.5);
        var energy = p.albedo * own.energy * taken;
        let random = uniform4(element, path * 1024u + order);
        if (energy < p.least) {
            if (random.x * p.least >= energy) { return; }
            energy = p.least;
        }
        let free = min(depth_of(random.y * taken) / own.rate, way);
        let at = own.at + (own.span.x + free) * own.along;
        let along = deflected(own.along, cosine_of(random.z), TAU * (random.w - 0.5));
        own = Segment(at, own.rate, along, energy, vec2(0.0, to_wall(at, along)));
        walk(own);
    }
}
