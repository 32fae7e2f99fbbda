// A 5 x 5 binomial blur, which takes the noise of the directions away.
in vec2 uv;
layout(location = 0) out vec4 out_open;
layout(binding = 0) uniform sampler2D noisy;

void main()
{
    const float WEIGHTS[3] = float[3](0.375, 0.25, 0.0625);
    vec2 texel = 1.0 / vec2(textureSize(noisy, 0));
    float sum = 0.0;
    for (int y = -2; y <= 2; y++)
        for (int x = -2; x <= 2; x++)
            sum += WEIGHTS[abs(x)] * WEIGHTS[abs(y)] * textureLod(noisy, uv + texel * vec2(x, y), 0.0).r;
    out_open = vec4(sum);
}
