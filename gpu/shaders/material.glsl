// Applies a material to a point of a mesh, without textures.
struct Surface {
    vec3 normal; // scene, towards the eye's side
    vec3 base, emissive;
    float metallic, roughness, occlusion, alpha;
    bool back; // the inside of a single-sided mesh
    bool shown; // the base colour is shown as it is, hardly shaded
    bool flat_color; // `emissive` is its colour, as sRGB: it takes no light
};

#ifdef READS_MATERIAL
uniform vec4 base_color;         // linear, a opacity
uniform vec4 emissive_color;     // linear, a strength of the normal map
uniform vec4 roughness_metallic; // roughness (-1: a flat colour), metallic, 1: both sides alike, alpha cutoff (or -1)

Surface plain_surface(vec3 normal, vec4 color)
{
    Surface s;
    vec4 base = base_color * color;
    s.normal = normal;
    s.base = saturate(base.rgb);
    s.alpha = base.a;
    s.emissive = emissive_color.rgb;
    s.roughness = roughness_metallic.x;
    s.metallic = roughness_metallic.y;
    s.occlusion = 1.0;
    s.back = s.shown = false;
    s.flat_color = s.roughness < 0.0;
    return s;
}

bool shows_back(bool away) { return away && roughness_metallic.z < 0.5; }

uniform vec4 clay_color;

// Returns the surface as clay, which shows form alone.
Surface as_clay(Surface s)
{
    if (s.flat_color) return s;
    s.base = clay_color.rgb;
    s.roughness = 0.58;
    s.metallic = 0.0;
    s.emissive = vec3(0.0);
    return s;
}
#endif
