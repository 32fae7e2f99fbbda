// What a material makes of the point of the mesh that this fragment shows. TEXTURED variants read
// textures; without it the material's numbers and the vertex colour are all there is.
#include "material.glsl"

#ifdef TEXTURED
layout(binding = 8) uniform sampler2D base_color_texture;
layout(binding = 9) uniform sampler2D metallic_roughness_texture;
layout(binding = 10) uniform sampler2D normal_texture;
layout(binding = 11) uniform sampler2D occlusion_texture;
layout(binding = 12) uniform sampler2D emissive_texture;
uniform int texture_use; // 2 bits a texture from base colour on: 1 present, 2 second uv set

vec2 uv_of(int slot) { return ((texture_use >> (slot * 2)) & 2) != 0 ? at_uv.zw : at_uv.xy; }
bool has(int slot) { return ((texture_use >> (slot * 2)) & 1) != 0; }
// Image rows go down, v goes up.
vec4 texel(sampler2D image, int slot) { vec2 uv = uv_of(slot); return texture(image, vec2(uv.x, 1.0 - uv.y)); }

vec3 bumped(vec3 n)
{
    vec2 uv = uv_of(2);
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
    vec3 m = texel(normal_texture, 2).xyz * 2.0 - 1.0;
    m.xy *= emissive_color.a;
    return normalize(t * m.x + b * m.y + n * m.z);
}
#endif

Surface surface_here()
{
    bool away = !gl_FrontFacing;
    Surface s = plain_surface(normalize(at_normal), at_color);
#ifdef TEXTURED
    if (has(0)) {
        vec4 texel_color = texel(base_color_texture, 0);
        s.base *= texel_color.rgb;
        s.alpha *= texel_color.a;
    }
    if (has(1)) {
        vec4 mr = texel(metallic_roughness_texture, 1);
        s.roughness *= mr.g;
        s.metallic *= mr.b;
    }
    if (has(2)) s.normal = bumped(s.normal);
    if (has(3)) s.occlusion = texel(occlusion_texture, 3).r;
    if (has(4)) s.emissive *= texel(emissive_texture, 4).rgb;
#endif
#ifdef MASKED
    if (s.alpha < roughness_metallic.w) discard;
#endif
    if (away) s.normal = -s.normal;
    s.back = shows_back(away);
    return s;
}
