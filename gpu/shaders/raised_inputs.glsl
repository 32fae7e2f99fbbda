// The inputs of raised.glsl. FILTERED: the device's filter looks up between control points, whose
// fractions have 8 bits on graphics cards: a preview.
#include "volume_inputs.glsl"
vec3 lattice_between(int first, vec3 at);
#include "raised.glsl"
#ifdef FILTERED
layout(binding = 0) uniform sampler3D lattice_texture; // w runs along its x
vec3 lattice_between(int first, vec3 at)
{
    int plane = first % volume.stride[0];
    vec3 low = vec3(first / volume.stride[0], plane / volume.stride[1], plane % volume.stride[1]);
    return textureLod(lattice_texture, ((low + at).zyx + 0.5) / vec3(textureSize(lattice_texture, 0)),
                      0.0).xyz;
}
#else
vec3 lattice_between(int first, vec3 at) { return lerped_between(first, at); }
#endif
