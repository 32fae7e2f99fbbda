// The first of two phases: deforms vertices. The next volume of a stack deforms in place: in and out
// are then the same buffers.
#include "deform_vertex.glsl"
#include "vertex_buffers.glsl"

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= vertex_count) return;
    DeformedVertex v = deformed_vertex(position_in(i), normal_in(i), tangent_in(i));
    put_vertex(i, v.position, v.normal, v.tangent);
}
