    let t = group * 256u + thread;
    let lane = t % p.lanes;
    if (t / p.lanes >= p.count) { return; }
    let row = p.first + t / p.lanes;
    let j = i32(row % p.width);
    let k = i32(row / p.width % p.depths);
    let frame = row / (p.width * p.depths);
    // Places that see this sample, and a little more: errors of f32 are below that
    let more = 0.02;
    let half = vec2<f32>(f32(p.along_taps), f32(p.across_taps)) / 2.0 + more;
    let across = vec2<f32>(f32(j) - half.y, f32(j) + half.y);
    var along = vec2<f32>(f32(k) - half.x, f32(k) + half.x);
    // Samples at an end serve all places there
    if (p.along_lower > 0 && k > p.along_last - p.along_taps) { along.y = f32(p.along_last) + 2.0; }
    if (p.along_turned == 1u && k < p.along_taps) { along.x = -2.0; }
    along += vec2(p.start);
    var sums = array<vec4<f32>, 4>(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    for (var sub = 0u; sub < p.subs; sub++) {
        let turn = (p.frame + frame) * p.subs + sub;
        // Places of voxels: those of voxel 0, steps along x and along y
        let of_along = (vec4<f32>(bitcast<vec4<i32>>(turns[4u * turn])) + bitcast<vec4<f32>>(turns[4u * turn + 1u])).xyz / 16384.0;
        let of_across = (vec4<f32>(bitcast<vec4<i32>>(turns[4u * turn + 2u])) + bitcast<vec4<f32>>(turns[4u * turn + 3u])).xyz / 16384.0;
        let det = of_along.y * of_across.z - of_along.z * of_across.y;
        let y_across = (across - of_across.x) * of_along.y / det;
        // Before and behind the focal plane, in one where they meet
        for (var side = 0; side < 2; side++) {
            var strip = along;
            if (along.x <= 0.0) { strip.x = -along.y; } else if (side == 1) { strip = -along.yx; }
            if (side == 1 && along.x <= 0.0) { break; }
            let y_along = -(strip - of_along.x) * of_across.y / det;
            let low_y = min(y_across.x, y_across.y) + min(y_along.x, y_along.y);
            let high_y = max(y_across.x, y_across.y) + max(y_along.x, y_along.y);
            let begin_y = i32(clamp(floor(low_y) - 1.0, 0.0, f32(p.ny)));
            let end_y = i32(clamp(ceil(high_y) + 2.0, 0.0, f32(p.ny)));
            for (var iy = begin_y; iy < end_y; iy++) {
                let row_along = row_in(strip - of_along.x - f32(iy) * of_along.z, of_along.y);
                let row_across = row_in(across - of_across.x - f32(iy) * of_across.z, of_across.y);
                let begin_x = i32(max(row_along.x, row_across.x));
                let end_x = i32(min(row_along.y, row_across.y));
                for (var ix = begin_x; ix < end_x; ix++) {
                    let column = u32(iy) * p.nx + u32(ix);
                    if (column < p.begin || column >= p.end || in_resin[column] == 0u) { continue; }
                    let voxel = met(turn, ix, iy);
                    let b = j - voxel.across.first;
                    if (b < 0 || b >= p.across_taps) { continue; }
                    let a = k - voxel.along.first;
                    let image = -1 - k - voxel.along.first;
                    var weight = 0.0;
                    if (a >= 0 && a < p.along_taps) { weight += weight_along(voxel.along, a); }
                    if (image >= 0 && image < p.along_taps) { weight += weight_along(voxel.along, image); }
                    if (weight == 0.0) { continue; }
                    weight *= voxel.weight * weight_across(voxel.across, b);
                    let at = (column - p.begin) * 4u * p.lanes + lane;
                    for (var i = 0u; i < 4u; i++) { sums[i] += weight * cotangent[at + i * p.lanes]; }
                }
            }
        }
    }
    let to = row * 4u * p.lanes + lane;
    for (var i = 0u; i < 4u; i++) { samples[to + i * p.lanes] += sums[i]; }
