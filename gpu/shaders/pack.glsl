// A surface in four words, for the targets of surfaces.frag: octahedral normal (Cigolle et al.
// 2014); base colour (square root, 8 bits a channel) and roughness; emissive light with a shared
// exponent; metallic, occlusion and flags.
vec2 signs(vec2 v) { return vec2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0); }

uint packed_normal(vec3 n)
{
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    return packSnorm2x16(n.z < 0.0 ? (1.0 - abs(p.yx)) * signs(p) : p);
}
vec3 unpacked_normal(uint word)
{
    vec2 p = unpackSnorm2x16(word);
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * signs(n.xy);
    return normalize(n);
}

uint packed_light(vec3 c)
{
    float peak = max(c.r, max(c.g, c.b));
    if (peak <= 0.0) return 0u;
    float e = clamp(ceil(log2(peak)), -100.0, 100.0);
    return packUnorm4x8(vec4(c * exp2(-e), (e + 128.0) / 255.0));
}
vec3 unpacked_light(uint word)
{
    if (word == 0u) return vec3(0.0);
    vec4 c = unpackUnorm4x8(word);
    return c.rgb * exp2(round(c.a * 255.0) - 128.0);
}

const uint BACK = 255u << 16; // in the last word

// Packs the material without the normal.
uvec3 packed_material(Surface s)
{
    uint light = s.flat_color ? packUnorm4x8(vec4(s.emissive, 0.0)) : packed_light(s.emissive);
    float kind = s.shown ? 0.0 : s.flat_color ? 0.5 : 1.0;
    return uvec3(packUnorm4x8(vec4(sqrt(s.base), s.roughness)), light,
                 packUnorm4x8(vec4(s.metallic, s.occlusion, s.back ? 1.0 : 0.0, kind)));
}
Surface unpacked_surface(uvec4 words)
{
    vec4 base = unpackUnorm4x8(words.y), rest = unpackUnorm4x8(words.w);
    Surface s;
    s.normal = unpacked_normal(words.x);
    s.base = base.rgb * base.rgb;
    s.roughness = base.a;
    s.flat_color = abs(rest.w - 0.5) < 0.25;
    s.emissive = s.flat_color ? unpackUnorm4x8(words.z).rgb : unpacked_light(words.z);
    s.metallic = rest.x;
    s.occlusion = rest.y;
    s.back = rest.z > 0.5;
    s.shown = rest.w < 0.25;
    s.alpha = 1.0;
    return s;
}
