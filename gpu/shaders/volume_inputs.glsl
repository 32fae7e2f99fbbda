// A volume as core/kernel wants it. The variant defines ORDER_U, ORDER_V and ORDER_W, 2 to 4 each,
// and TEXELS to read it from texel buffers.
const int order_u = ORDER_U, order_v = ORDER_V, order_w = ORDER_W;

layout(std140, binding = 1) uniform Volume { // core/kernel/volume_kernel.h says what is what
    mat4 x_by_p;
    mat4 rest_by_p;
    vec4 x_middle;
    vec4 rest_middle;
    ivec4 cell_begin;
    ivec4 cell_count;
    ivec4 closure;
    ivec4 stride;
    float jacobian_scale;
    float difference_step;
} volume;
#ifdef TEXELS // software GL reads these four times as fast as storage
layout(binding = 14) uniform samplerBuffer points;
layout(binding = 15) uniform samplerBuffer cells;
vec3 lattice_point(int at) { return texelFetch(points, at).xyz; }
vec4 cell_row(int cell, int row) { return texelFetch(cells, cell * 10 + row); }
#else
layout(std430, binding = 0) readonly buffer Points { vec4 points[]; };
layout(std430, binding = 1) readonly buffer Cells { vec4 cells[]; };
vec3 lattice_point(int at) { return points[at].xyz; }
vec4 cell_row(int cell, int row) { return cells[cell * 10 + row]; }
#endif

#include "axis.glsl"
#include "volume.glsl"
#include "normal.glsl"
#include "deform.glsl"
