// Brings the results of occlusion.frag from half size to full size.
layout(binding = 1) uniform sampler2D occlusion_map; // open share, signed distance, key's share

// Each sample of the picture looks at another pixel of every 2 x 2.
ivec2 looked_at() { return ivec2(frame.scene.w) >> ivec2(0, 1) & 1; }

// Share of the ambient light and of the key that reach the pixel, by bilinear weights times
// likeness of distance, so that nothing leaks over silhouettes; the ground has negative ones.
vec2 open_share(float depth)
{
    vec2 p = (gl_FragCoord.xy - 0.5 - vec2(looked_at())) * 0.5, f = fract(p);
    ivec2 i = ivec2(floor(p)), last = textureSize(occlusion_map, 0) - 1;
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int k = 0; k < 4; k++) {
        ivec2 o = ivec2(k & 1, k >> 1);
        vec3 a = texelFetch(occlusion_map, clamp(i + o, ivec2(0), last), 0).rgb;
        float w = mix(1.0 - f.x, f.x, float(o.x)) * mix(1.0 - f.y, f.y, float(o.y));
        w = (w + 0.02) * exp2(-abs(a.g - depth) * 60.0 / frame.scene.x);
        sum += a.rb * w;
        weights += w;
    }
    return weights > 1e-5 ? sum / weights
                          : texelFetch(occlusion_map, clamp(ivec2(p + 0.5), ivec2(0), last), 0).rb;
}
