// Lays the light gathered in a volume over the picture. IDS: its id and distance where it hides
// more than half of the background.
#include "frame.glsl"
#include "tonemap.glsl"
in vec2 uv;
uniform vec4 part; // xy the part of the textures that holds the picture
#ifdef IDS
layout(location = 0) out uvec2 out_id_depth;
layout(binding = 7) uniform sampler2D hits;
uniform uint id;
#else
layout(location = 0) out vec4 out_color;
layout(binding = 6) uniform sampler2D gathered;
#endif

void main()
{
#ifdef IDS
    float hit = textureLod(hits, uv * part.xy, 0.0).r;
    if (hit == 0.0) discard;
    float w = frame.eye.w > 0.5 ? hit : 1.0;
    gl_FragDepth = 0.5 + 0.5 * (frame.clip[3].z - frame.clip[2].z * hit) / w;
    out_id_depth = uvec2(id, floatBitsToUint(hit));
#else
    vec4 sum = textureLod(gathered, uv * part.xy, 0.0);
    if (sum.a < 0.001) discard;
    out_color = vec4(tone_mapped(sum.rgb / sum.a), sum.a);
#endif
}
