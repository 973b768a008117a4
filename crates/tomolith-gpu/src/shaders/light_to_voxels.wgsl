    let t = group * 256u + thread;
    let lane = t % p.lanes;
    if (t / p.lanes >= p.count) { return; }
    let column = p.first + t / p.lanes;
    if (in_resin[column] == 0u) { return; }
    let ix = i32(column % p.nx);
    let iy = i32(column / p.nx);
    var sums = array<vec4<f32>, 4>(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    for (var frame = 0u; frame < p.frames; frame++) {
        for (var sub = 0u; sub < p.subs; sub++) {
            let voxel = met((p.frame + frame) * p.subs + sub, ix, iy);
            var across = array<f32, 16>();
            for (var b = 0; b < p.across_taps; b++) { across[b] = weight_across(voxel.across, b); }
            for (var a = 0; a < p.along_taps; a++) {
                let k = voxel.along.first + a;
                let depth = u32(select(k, -1 - k, k < 0));
                let weight = voxel.weight * weight_along(voxel.along, a);
                let row = (frame * p.depths + depth) * p.width + u32(voxel.across.first);
                for (var b = 0; b < p.across_taps; b++) {
                    let at = (row + u32(b)) * 4u * p.lanes + lane;
                    let both = weight * across[b];
                    for (var i = 0u; i < 4u; i++) { sums[i] += both * samples[at + i * p.lanes]; }
                }
            }
        }
    }
    let to = (column - p.begin) * 4u * p.lanes + lane;
    for (var i = 0u; i < 4u; i++) { dose[to + i * p.lanes] += sums[i]; }
