// Ambient shadow on the floor from two height maps, the lowest and the highest surface over each
// floor texel. In every direction the columns met block an interval of sin^2(elevation); a 32-bit
// mask collects them, and the mean of the free bits is the cosine-weighted visibility.
#include "frame.glsl"
#include "bits.glsl"
in vec2 uv;
layout(location = 0) out vec4 out_open;
layout(binding = 0) uniform sampler2D lowest;  // share of the height, 1: empty
layout(binding = 1) uniform sampler2D highest; // 1 - share of the height, 1: empty
uniform float height; // world

void main()
{
    const int DIRECTIONS = 16, STEPS = 12;
    const float REACH = 0.42; // of the map's side
    float open = 0.0;
    for (int k = 0; k < DIRECTIONS; k++) {
        float a = 6.2831853 * (float(k) + noise_at(gl_FragCoord.xy, 0.0)) / float(DIRECTIONS);
        vec2 towards = vec2(cos(a), sin(a));
        uint blocked = 0u;
        for (int j = 0; j < STEPS; j++) {
            float u = (float(j) + 0.5) / float(STEPS);
            u *= u * REACH;
            vec2 q = uv + towards * u;
            float z = textureLod(lowest, q, 0.0).r;
            if (z >= 1.0 || any(lessThan(q, vec2(0.0))) || any(greaterThan(q, vec2(1.0)))) continue;
            float d = u * frame.contact.w, lo = z * height;
            float hi = max((1.0 - textureLod(highest, q, 0.0).r) * height, lo);
            float from = lo * lo / (lo * lo + d * d + 1e-12), to = hi * hi / (hi * hi + d * d + 1e-12);
            int first = int(from * 32.0), last = int(ceil(to * 32.0));
            blocked |= last - first >= 32 ? 0xFFFFFFFFu
                                          : ((1u << uint(max(last - first, 0))) - 1u) << uint(first);
        }
        open += 1.0 - float(bits_set(blocked)) / 32.0;
    }
    out_open = vec4(open / float(DIRECTIONS));
}
