// Strip and axis, slot after slot
@group(0) @binding(3) var<storage, read> by_slot: array<vec2<u32>>;
@group(0) @binding(4) var<storage, read> slots: array<u32>;
