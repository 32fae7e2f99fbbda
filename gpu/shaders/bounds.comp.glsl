// The box of positions, of deformed ones where the variant defines a volume. A float's bits grow with
// it once the sign is turned, so that integers can be compared.
#ifdef ORDER_U
#include "volume_inputs.glsl"
#endif
layout(local_size_x = 64) in;
uniform uint vertex_count;
layout(std430, binding = 2) readonly buffer PositionsIn { float positions_in[]; };
layout(std430, binding = 3) buffer Bounds { uint least[3], most[3]; };

uint ordered(float x)
{
    uint bits = floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

void main()
{
    vec3 lo = vec3(3e38), hi = vec3(-3e38);
    uint step = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint i = gl_GlobalInvocationID.x; i < vertex_count; i += step) {
        vec3 p = vec3(positions_in[3u * i], positions_in[3u * i + 1u], positions_in[3u * i + 2u]);
#ifdef ORDER_U
        p = deformed_point(p).position;
#endif
        lo = min(lo, p);
        hi = max(hi, p);
    }
    for (int axis = 0; axis < 3; ++axis) {
        atomicMin(least[axis], ordered(lo[axis]));
        atomicMax(most[axis], ordered(hi[axis]));
    }
}
