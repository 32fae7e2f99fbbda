// Chooses which tiles of a layer are drawn, and how fine, in two dispatches: gpu/tiles/tile_sieve.h.
// CHOOSE: each tile finds its level, and each group how many it has of each. Without: each group
// lists its tiles behind those of the groups before it, so that all are in their order.
const uint GROUP = 256u, LEVELS = 8u, HIDDEN = 8u, KINDS = 9u; // a kind is a level or HIDDEN
const uint BEHIND = 256u;
layout(local_size_x = 256) in;
uniform uint tile_count;
layout(std430, binding = 0) buffer Levels { uint levels[]; }; // 0 unseen, or 1 + level; + BEHIND
layout(std430, binding = 1) buffer Sums { uint sums[]; };     // by group and kind
#ifdef CHOOSE
layout(std140, binding = 2) uniform Rule { // gpu/tiles/tile_rule.h says what is what
    vec4 sides[5];
    vec4 depth;
    vec4 errors[2];
    mat4 to_clip;
    float tolerance;
    int perspective;
    int steady;
    int level_count;
    ivec2 pyramid_px;
} rule;
layout(std430, binding = 2) readonly buffer Hulls { vec4 hulls[]; }; // lo and stretch, hi
layout(std430, binding = 3) readonly buffer Pyramid { float pyramid[]; };
float pyramid_depth(int at) { return pyramid[at]; }
#include "tile_rule.glsl"
shared uint counted[KINDS];

void main()
{
    uint here = gl_LocalInvocationIndex, i = gl_GlobalInvocationID.x;
    if (here < KINDS) counted[here] = 0u;
    memoryBarrierShared();
    barrier();
    if (i < tile_count) {
        vec4 lo = hulls[2u * i], hi = hulls[2u * i + 1u];
        int before = int(levels[i] & (BEHIND - 1u)) - 1;
        int level = chosen_level(lo.xyz, hi.xyz, lo.w, before);
        bool behind = level != UNSEEN && hidden(lo.xyz, hi.xyz);
        levels[i] = uint(level + 1) + (behind ? BEHIND : 0u);
        if (level != UNSEEN) atomicAdd(counted[behind ? HIDDEN : uint(level)], 1u);
    }
    memoryBarrierShared();
    barrier();
    if (here < KINDS) sums[gl_WorkGroupID.x * KINDS + here] = counted[here];
}
#else
uniform uint capacity; // rows of a level
uniform uint command_count;
uniform uint first_total;
layout(std430, binding = 2) writeonly buffer Rows { uint rows[]; };
// Commands for glDrawElementsIndirect, then the level: indices, instances, 3 more, level, 2 unused.
layout(std430, binding = 3) buffer Commands { uint commands[]; };
layout(std430, binding = 4) writeonly buffer Totals { uint totals[]; };
shared uint before[KINDS];         // in the groups before this one
shared uint present[LEVELS * 8u];  // a bit for each tile of the group, by level

uint total(uint kind) { return before[kind] + sums[gl_WorkGroupID.x * KINDS + kind]; }

void main()
{
    uint here = gl_LocalInvocationIndex, i = gl_GlobalInvocationID.x;
    if (here < KINDS) before[here] = 0u;
    if (here < LEVELS * 8u) present[here] = 0u;
    memoryBarrierShared();
    barrier();
    for (uint k = here; k < gl_WorkGroupID.x * KINDS; k += GROUP)
        atomicAdd(before[k % KINDS], sums[k]);
    uint found = i < tile_count ? levels[i] : 0u;
    bool drawn = found != 0u && found < BEHIND;
    uint level = drawn ? found - 1u : 0u, word = here / 32u, bit = 1u << (here % 32u);
    if (drawn) atomicOr(present[8u * level + word], bit);
    memoryBarrierShared();
    barrier();
    if (drawn) {
        uint at = before[level] + uint(bitCount(present[8u * level + word] & (bit - 1u)));
        for (uint w = 0u; w < word; ++w) at += uint(bitCount(present[8u * level + w]));
        rows[level * capacity + at] = i;
    }
    if (gl_WorkGroupID.x + 1u < gl_NumWorkGroups.x) return;
    if (here < KINDS) totals[first_total + here] = total(here);
    for (uint c = here; c < command_count; c += GROUP)
        commands[8u * c + 1u] = total(commands[8u * c + 5u]);
}
#endif
