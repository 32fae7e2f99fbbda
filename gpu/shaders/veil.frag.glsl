// A layer of a see-through helper: unlit, brighter and denser towards its rim where it is curved.
#include "frame.glsl"
#include "encode.glsl"
in vec3 at_scene;
in vec3 at_normal;
in vec4 at_color;
#include "layers.glsl"

void main()
{
    const float BACK = 0.55; // of the coverage of a face seen from behind
    float rim = 0.0;
    if (dot(at_normal, at_normal) > 1e-8) {
        rim = 1.0 - abs(dot(normalize(at_normal), towards_eye(at_scene)));
        rim *= rim * rim;
    }
    float coverage = at_color.a * (gl_FrontFacing ? 1.0 : BACK) * (1.0 + 1.8 * rim);
    vec3 color = mix(at_color.rgb, vec3(1.0), 0.25 * rim);
    add_layer(encoded(color), past_solids(coverage), -(frame.view * vec4(at_scene, 1.0)).z);
}
