// Poses vertices by morph targets and a skin, one an invocation; see core/mesh/pose.h. The rig is
// uploaded once a mesh: of each vertex four joints and four weights where it has them, then each
// target's differences of positions, normals and tangents, as many of these as KINDS says. The pose
// is uploaded for each: a matrix a joint, then a weight a target.
layout(local_size_x = 64) in;
uniform uint vertex_count, first_vertex; // of this slice
uniform int all_vertices, differences_at, joint_count, target_count;
layout(std430, binding = 0) readonly buffer Rig { float rig[]; };
layout(std430, binding = 1) readonly buffer Pose { float pose[]; };
layout(std430, binding = 2) readonly buffer PositionsIn { float positions_in[]; };
layout(std430, binding = 3) writeonly buffer PositionsOut { float positions_out[]; };
#ifdef NORMALS
layout(std430, binding = 4) readonly buffer NormalsIn { float normals_in[]; };
layout(std430, binding = 5) writeonly buffer NormalsOut { float normals_out[]; };
#endif
#ifdef TANGENTS
layout(std430, binding = 6) readonly buffer TangentsIn { vec4 tangents_in[]; };
layout(std430, binding = 7) writeonly buffer TangentsOut { vec4 tangents_out[]; };
#endif

int morph_count() { return target_count; }
float morph_weight(int target) { return pose[16 * joint_count + target]; }
vec3 morph_difference(int target, int what, int vertex)
{
#if KINDS > 0
    if (what >= KINDS) return vec3(0.0);
    int at = differences_at + 3 * (all_vertices * (target * KINDS + what) + vertex);
    return vec3(rig[at], rig[at + 1], rig[at + 2]);
#else
    return vec3(0.0);
#endif
}
mat4 vertex_matrix(int vertex)
{
#ifdef SKINNED
    mat4 sum = mat4(0.0);
    for (int k = 0; k < 4; ++k) {
        float weight = rig[8 * vertex + 4 + k];
        if (weight == 0.0) continue;
        int at = 16 * int(rig[8 * vertex + k]);
        for (int c = 0; c < 4; ++c)
            sum[c] += weight * vec4(pose[at + 4 * c], pose[at + 4 * c + 1], pose[at + 4 * c + 2],
                                    pose[at + 4 * c + 3]);
    }
    return sum;
#else
    return mat4(1.0);
#endif
}
#include "normal.glsl"
#include "pose.glsl"

void main()
{
    uint i = gl_GlobalInvocationID.x, at = 3u * i;
    if (i >= vertex_count) return;
    vec3 p = vec3(positions_in[at], positions_in[at + 1u], positions_in[at + 2u]);
    vec3 normal = vec3(0.0, 0.0, 1.0);
    vec4 tangent = vec4(1.0, 0.0, 0.0, 1.0);
#ifdef NORMALS
    normal = vec3(normals_in[at], normals_in[at + 1u], normals_in[at + 2u]);
#endif
#ifdef TANGENTS
    tangent = tangents_in[i];
#endif
    PosedVertex v = posed_vertex(int(first_vertex + i), p, normal, tangent);
    positions_out[at] = v.position.x;
    positions_out[at + 1u] = v.position.y;
    positions_out[at + 2u] = v.position.z;
#ifdef NORMALS
    normals_out[at] = v.normal.x;
    normals_out[at + 1u] = v.normal.y;
    normals_out[at + 2u] = v.normal.z;
#endif
#ifdef TANGENTS
    tangents_out[i] = v.tangent;
#endif
}
