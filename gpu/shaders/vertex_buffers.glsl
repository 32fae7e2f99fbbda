// Vertices from buffers to buffers, one an invocation: gpu/ffd/device_deformer.h, dispatch_vertices().
// The variant says NORMALS 0 or more, and TANGENTS; what it has none of is 0 and is not written.
layout(local_size_x = 64) in;
uniform uint vertex_count; // of this slice
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

vec3 position_in(uint i)
{
    return vec3(positions_in[3u * i], positions_in[3u * i + 1u], positions_in[3u * i + 2u]);
}
vec3 normal_in(uint i)
{
#if NORMALS > 0
    return vec3(normals_in[3u * i], normals_in[3u * i + 1u], normals_in[3u * i + 2u]);
#else
    return vec3(0.0);
#endif
}
vec4 tangent_in(uint i)
{
#ifdef TANGENTS
    return tangents_in[i];
#else
    return vec4(0.0);
#endif
}
void put_vertex(uint i, vec3 position, vec3 normal, vec4 tangent)
{
    uint at = 3u * i;
    positions_out[at] = position.x;
    positions_out[at + 1u] = position.y;
    positions_out[at + 2u] = position.z;
#if NORMALS > 0
    normals_out[at] = normal.x;
    normals_out[at + 1u] = normal.y;
    normals_out[at + 2u] = normal.z;
#endif
#ifdef TANGENTS
    tangents_out[i] = tangent;
#endif
}
