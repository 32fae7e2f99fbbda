// The first of two phases: deforms vertices, one an invocation. The next volume of a stack deforms
// in place: in and out are then the same buffers.
#include "deform_vertex.glsl"
layout(local_size_x = 64) in;
uniform uint vertex_count;
layout(std430, binding = 2) readonly buffer PositionsIn { float positions_in[]; };
layout(std430, binding = 3) writeonly buffer PositionsOut { float positions_out[]; };
#if NORMALS > 0
layout(std430, binding = 4) readonly buffer NormalsIn { float normals_in[]; };
layout(std430, binding = 5) writeonly buffer NormalsOut { float normals_out[]; };
#endif
#ifdef TANGENTS
layout(std430, binding = 6) readonly buffer TangentsIn { vec4 tangents_in[]; };
layout(std430, binding = 7) writeonly buffer TangentsOut { vec4 tangents_out[]; };
#endif

void main()
{
    uint i = gl_GlobalInvocationID.x, at = 3u * i;
    if (i >= vertex_count) return;
    vec3 p = vec3(positions_in[at], positions_in[at + 1u], positions_in[at + 2u]);
    vec3 normal = vec3(0.0);
    vec4 tangent = vec4(0.0);
#if NORMALS > 0
    normal = vec3(normals_in[at], normals_in[at + 1u], normals_in[at + 2u]);
#endif
#ifdef TANGENTS
    tangent = tangents_in[i];
#endif
    DeformedVertex v = deformed_vertex(p, normal, tangent);
    positions_out[at] = v.position.x;
    positions_out[at + 1u] = v.position.y;
    positions_out[at + 2u] = v.position.z;
#if NORMALS > 0
    normals_out[at] = v.normal.x;
    normals_out[at + 1u] = v.normal.y;
    normals_out[at + 2u] = v.normal.z;
#endif
#ifdef TANGENTS
    tangents_out[i] = v.tangent;
#endif
}
