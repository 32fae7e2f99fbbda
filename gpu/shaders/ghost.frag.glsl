// Draws see-through surfaces: blended materials and previews, lit like everything else.
#define READS_MATERIAL
#include "frame.glsl"
#include "mesh_inputs.glsl"
#include "surface.glsl"
#include "layers.glsl"
#ifndef LAYER_DEPTHS
#include "studio.glsl"
#include "tonemap.glsl"
#include "encode.glsl"
#include "shadow.glsl"
#include "shade.glsl"
#endif
uniform float opacity;

void main()
{
    Surface s = surface_here();
    float alpha = saturate(s.alpha * opacity);
    // Glass mirrors more at grazing angles, whatever its opacity.
    float rim = 1.0 - abs(dot(s.normal, towards_eye(at_scene)));
    float coverage = mix(alpha, 1.0, 0.5 * rim * rim * rim * rim * (1.0 - s.roughness));
    coverage = past_solids(coverage);
    // Only double-sided surfaces show their backs.
    if (alpha < 0.004 || s.back || coverage <= 0.0) discard;
#ifdef LAYER_DEPTHS
    vec3 color = vec3(0.0);
#else
    vec3 color = shaded(s, at_scene, 1.0, key_visibility(at_scene, s.normal, gl_FragCoord.xy));
#endif
    add_layer(color, coverage, distance_here());
}
