// Measures multiply-adds when nothing else is done: 8 x 4 x 256 an invocation.
layout(local_size_x = 64) in;
uniform vec4 factor;
layout(std430, binding = 0) writeonly buffer Sums { vec4 sums[]; };

void main()
{
    vec4 x[8];
    for (int i = 0; i < 8; ++i) x[i] = factor * float(gl_LocalInvocationID.x + i);
    for (int step = 0; step < 256; ++step)
        for (int i = 0; i < 8; ++i) x[i] = x[i] * factor + x[i];
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 8; ++i) sum += x[i];
    sums[gl_GlobalInvocationID.x] = sum;
}
