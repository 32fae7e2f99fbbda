// The one phase of mesh.vert alone, to be measured and captured: all is clipped away.
#include "deform_vertex.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
out vec3 to_position;
out vec3 to_normal;
out vec4 to_tangent;

void main()
{
    DeformedVertex v = deformed_vertex(position, normal, tangent);
    to_position = v.position;
    to_normal = v.normal;
    to_tangent = v.tangent;
    gl_Position = vec4(v.position + v.normal + v.tangent.xyz, -1.0);
}
