// Rays through volume data that glow and hold back light.   GLSL and C++: see core/casting/cast_image.cpp
//
// Places are in voxels; values are shares of the range of the data. Supplied:
//   float value_at(vec3 p)          of the data
//   vec3 slope_at(vec3 p)           of the value, per voxel
//   int empty_reach(ivec3 brick)    see EmptyBricks; beyond the grid as at its border
//   vec4 transfer_before(float u)   see TransferTable
//   vec3 lit(vec3 color, vec3 p, vec3 slope)   the colour of what has that slope, in linear light

const float TRANSFER_CELLS = 1024.0f;
const float BRICK = 4.0f;      // cells along each axis
const float OPAQUE = 0.985f;   // what lies behind is not looked at
const float LIT_FROM = 0.01f;  // share of the picture from which light matters
const float SURFACE_FROM = 0.1f; // share of a step that may show a surface
const int MOST_STEPS = 8192;

// The mean of the transfer function over the values from one to another: colour times density, and
// density per voxel.
vec4 transfer_between(float a, float b)
{
    a = clamp(a, 0.0f, 1.0f);
    b = clamp(b, 0.0f, 1.0f);
    float range = max(abs(a - b), 1.0f / TRANSFER_CELLS);
    float least = clamp(0.5f * (a + b - range), 0.0f, 1.0f - range);
    return (transfer_before(least + range) - transfer_before(least)) / range;
}

// The share of a step from one value to another after which half of what it holds back is held back,
// at most what lets half of the light through: there is the surface, if it shows one. `thickness`: of
// the step.
float surface_share(float before, float value, float held, float thickness)
{
    float enough = min(0.5f * held, 0.7f), begin = 0.0f, last = 1.0f;
    for (int i = 0; i < 4; i++) {
        float middle = 0.5f * (begin + last);
        float there = transfer_between(before, mix(before, value, middle)).w * thickness * middle;
        if (there < enough) begin = middle;
        else last = middle;
    }
    return last;
}

int reach_at(vec3 p) { return empty_reach(ivec3(max(p, vec3(0.0f)) / BRICK)); }

// Returns how much farther a ray at p stays in the empty cube of the brick there.
float empty_way(vec3 p, vec3 along, int reach)
{
    vec3 brick = floor(p / BRICK);
    vec3 lower = (brick - float(reach) + 1.0f) * BRICK - p, upper = (brick + float(reach)) * BRICK - p;
    vec3 out_by = max(lower / along, upper / along);
    return max(min(out_by.x, min(out_by.y, out_by.z)), 0.0f);
}

// The sums along a ray.
struct Gathered {
    vec3 color;    // linear, times the opacity
    float opacity;
    float hit;     // where half of the light is held back; the end: it never is
};

// Goes from `from` by along * t, t from 0 to `end`, in steps of `pace` of which the first is the share
// `jitter`, 0..1. `thickness`: length in voxels per t, times the density. No component of `along` is 0.
Gathered cast_ray(vec3 from, vec3 along, float end, float pace, float jitter, float thickness)
{
    Gathered out_of;
    out_of.color = vec3(0.0f);
    out_of.opacity = 0.0f;
    out_of.hit = end;
    float t = 0.0f, next = pace * max(jitter, 0.01f), before = 0.0f;
    bool known = false;
    int reach = reach_at(from);
    for (int i = 0; i < MOST_STEPS; i++) {
        if (t >= end || out_of.opacity >= OPAQUE) break;
        float until = min(next, end);
        vec3 p = from + along * until;
        int reach_there = reach_at(p);
        if (reach > 0 && reach_there > 0) {
            t = until + pace * floor(empty_way(p, along, reach_there) / pace);
            known = false;
        } else {
            if (!known) before = value_at(from + along * t);
            float value = value_at(p);
            vec4 glow = transfer_between(before, value);
            float held = glow.w * thickness * (until - t);
            if (held > 1e-5f) {
                float share = (1.0f - out_of.opacity) * (1.0f - exp(-held));
                vec3 color = vec3(glow.x, glow.y, glow.z) / glow.w;
                if (share > LIT_FROM) {
                    float at = 0.5f;
                    if (share > SURFACE_FROM) at = surface_share(before, value, held, thickness * (until - t));
                    vec3 there = from + along * mix(t, until, at);
                    color = lit(color, there, slope_at(there));
                }
                out_of.color += share * color;
                if (out_of.opacity < 0.5f && out_of.opacity + share >= 0.5f) out_of.hit = until;
                out_of.opacity += share;
            }
            before = value;
            known = true;
            t = until;
        }
        next = t + pace;
        reach = reach_there;
    }
    if (out_of.opacity >= OPAQUE) {
        out_of.color /= out_of.opacity;
        out_of.opacity = 1.0f;
    }
    return out_of;
}
