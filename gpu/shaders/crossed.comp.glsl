// Lists the triangles of a level's mesh in which the product of the normal and the view changes its
// sign, as core/silhouette/silhouette_finder.cpp does: the same numbers, rounded alike. One group
// per run of 32 triangles; see gpu/silhouette/device_silhouettes.h.
layout(local_size_x = 32) in;
struct Run {
    vec4 least, greatest; // of (n, -<p - middle, n>) over the corners
    vec3 middle;
    uint first;           // triangle
    uint end, unused0, unused1, unused2;
};
layout(std430, binding = 0) readonly buffer Normals { vec4 normals[]; }; // n, -<p, n>
layout(std430, binding = 1) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 2) readonly buffer Runs { Run runs[]; };
layout(std430, binding = 3) buffer Found { uint found_count, found[]; };
uniform vec4 view;
uniform uint run_count;
uniform uint room; // in found

shared uint here, begin;

// Products and sums in this order, none of them fused, so that signs are those of the processor.
bool is_above(uint corner)
{
    vec4 n = normals[corner];
    precise float x = n.x * view.x, y = n.y * view.y, z = n.z * view.z, w = n.w * view.w;
    precise float xy = x + y;
    precise float xyz = xy + z;
    precise float sum = xyz + w;
    return sum >= 0.0;
}

bool may_change(Run run)
{
    precise vec3 moved = view.w * run.middle;
    precise vec3 u = view.xyz - moved;
    vec4 v = vec4(u, view.w);
    precise vec4 p = v * run.least, q = v * run.greatest;
    precise vec4 lo = min(p, q), hi = max(p, q);
    precise float least = lo.x + lo.y;
    least = least + lo.z;
    least = least + lo.w;
    precise float greatest = hi.x + hi.y;
    greatest = greatest + hi.z;
    greatest = greatest + hi.w;
    return least <= 0.0 && greatest >= 0.0;
}

void main()
{
    uint number = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    if (number >= run_count) return; // the whole group
    Run run = runs[number];
    if (!may_change(run)) return; // the whole group
    if (gl_LocalInvocationID.x == 0u) here = 0u;
    barrier();
    uint triangle = run.first + gl_LocalInvocationID.x, own = 0u;
    bool crossed = false;
    if (triangle < run.end) {
        bool a = is_above(corners[3u * triangle]), b = is_above(corners[3u * triangle + 1u]),
             c = is_above(corners[3u * triangle + 2u]);
        crossed = a != b || b != c;
    }
    if (crossed) own = atomicAdd(here, 1u);
    barrier();
    if (gl_LocalInvocationID.x == 0u) begin = atomicAdd(found_count, here);
    barrier();
    if (crossed && begin + own < room) found[begin + own] = triangle;
}
