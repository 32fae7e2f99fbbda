// Poses vertices by morph targets and a skin; see core/mesh/pose.h. The rig is
// uploaded once a mesh: of each vertex four joints and four weights where it has them, then each
// target's differences of positions, normals and tangents, as many of these as KINDS says. The pose
// is uploaded for each: a matrix a joint, then a weight a target.
#include "vertex_buffers.glsl"
uniform uint first_vertex; // of this slice
uniform int all_vertices, differences_at, joint_count, target_count;
layout(std430, binding = 0) readonly buffer Rig { float rig[]; };
layout(std430, binding = 1) readonly buffer Pose { float pose[]; };

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
    uint i = gl_GlobalInvocationID.x;
    if (i >= vertex_count) return;
    PosedVertex v =
        posed_vertex(int(first_vertex + i), position_in(i), normal_in(i), tangent_in(i));
    put_vertex(i, v.position, v.normal, v.tangent);
}
