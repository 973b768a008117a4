// First strip, first slot, axis, view
@group(0) @binding(3) var<storage, read> beams: array<vec4<u32>>;
// First strip and the one behind the last, from the beam's first on, of each tile and beam
@group(0) @binding(4) var<storage, read> meetings: array<u32>;
// First voxel, number of voxels
@group(0) @binding(5) var<storage, read> tiles: array<vec4<u32>>;
