// Evaluates a material at the point of the mesh that this fragment shows. TEXTURES is the set of
// textures it has, a bit each: software GL reads a branch whether it is taken or not. Without it the
// material's numbers and the vertex colour are all there is.
#include "material.glsl"
#ifdef SOLID
#include "solid.glsl"
#endif
#ifdef VALUES
#include "values.glsl"
#endif

#ifdef TEXTURES
layout(binding = 8) uniform sampler2D base_color_texture;
layout(binding = 9) uniform sampler2D metallic_roughness_texture;
layout(binding = 10) uniform sampler2D normal_texture;
layout(binding = 11) uniform sampler2D occlusion_texture;
layout(binding = 12) uniform sampler2D emissive_texture;
const int BASE = 0, METAL_ROUGH = 1, NORMAL = 2, OCCLUDED = 3, EMISSIVE = 4;
uniform int second_uv; // a bit a texture: reads the second set

vec2 uv_of(int slot) { return ((second_uv >> slot) & 1) != 0 ? at_uv.zw : at_uv.xy; }
// Image rows go down, v goes up.
vec4 texel(sampler2D image, int slot) { vec2 uv = uv_of(slot); return texture(image, vec2(uv.x, 1.0 - uv.y)); }

vec3 bumped(vec3 n)
{
    vec2 uv = uv_of(NORMAL);
    vec3 t = at_tangent.xyz, b;
    if (abs(at_tangent.w) > 0.5) {
        t = normalize(t - n * dot(t, n));
        b = cross(n, t) * at_tangent.w;
    } else { // no tangents given: from how position and uv change over the screen (Mikkelsen 2010)
        vec3 px = dFdx(at_scene), py = dFdy(at_scene);
        vec2 ux = dFdx(uv), uy = dFdy(uv);
        vec3 rx = cross(py, n), ry = cross(n, px);
        t = rx * ux.x + ry * uy.x;
        b = rx * ux.y + ry * uy.y;
        float longest = max(dot(t, t), dot(b, b));
        if (longest < 1e-20) return n;
        t *= inversesqrt(longest);
        b *= inversesqrt(longest);
    }
    vec3 m = texel(normal_texture, NORMAL).xyz * 2.0 - 1.0;
    m.xy *= emissive_color.a;
    return normalize(t * m.x + b * m.y + n * m.z);
}
#endif

Surface surface_here()
{
    bool away = !gl_FrontFacing;
    Surface s = plain_surface(normalize(at_normal), at_color);
#ifdef SOLID
    fill(s);
#endif
#ifdef TEXTURES
#if (TEXTURES & 1) != 0
    vec4 base = texel(base_color_texture, BASE);
    s.base *= base.rgb;
    s.alpha *= base.a;
#endif
#if (TEXTURES & 2) != 0
    vec4 rest = texel(metallic_roughness_texture, METAL_ROUGH);
    s.roughness *= rest.g;
    s.metallic *= rest.b;
#endif
#if (TEXTURES & 4) != 0
    s.normal = bumped(s.normal);
#endif
#if (TEXTURES & 8) != 0
    s.occlusion = texel(occlusion_texture, OCCLUDED).r;
#endif
#if (TEXTURES & 16) != 0
    s.emissive *= texel(emissive_texture, EMISSIVE).rgb;
#endif
#endif
#ifdef MASKED
    if (s.alpha < roughness_metallic.w) discard;
#endif
    if (away) s.normal = -s.normal;
    s.back = shows_back(away);
#ifdef VALUES
    s.base = value_color(at_value);
    s.shown = true;
    s.flat_color = false;
    s.back = false;
#endif
    return s;
}
