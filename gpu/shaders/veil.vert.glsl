// See-through helpers: their own colours, no material.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal; // zero: flat
layout(location = 2) in vec4 color;  // linear, a coverage
out vec3 at_scene;
out vec3 at_normal;
out vec4 at_color;

void main()
{
    const float PULL = 4e-5; // what lies on a surface is in front of it
    at_scene = position;
    at_normal = normal;
    at_color = color;
    gl_Position = frame.view_clip * vec4(position, 1.0);
    gl_Position.z -= PULL * gl_Position.w;
}
