// What one can see through: blended materials and previews, lit like everything else.
#define READS_MATERIAL
#include "frame.glsl"
#include "mesh_inputs.glsl"
#include "studio.glsl"
#include "tonemap.glsl"
#include "shadow.glsl"
#include "surface.glsl"
#include "shade.glsl"
layout(location = 0) out vec4 out_color;
uniform float opacity;

void main()
{
    Surface s = surface_here();
    float alpha = saturate(s.alpha * opacity);
    if (alpha < 0.004) discard;
    // Glass mirrors more at grazing angles, whatever its opacity.
    float rim = 1.0 - abs(dot(s.normal, towards_eye(at_scene)));
    alpha = mix(alpha, 1.0, 0.5 * rim * rim * rim * rim * (1.0 - s.roughness));
    float visible = key_visibility(at_scene, s.normal, gl_FragCoord.xy);
    out_color = vec4(shaded(s, at_scene, 1.0, visible), alpha);
}
