// An edge, fainter the shorter it is in the picture: where edges are short they are many, and would
// cover everything.
layout(lines) in;
layout(line_strip, max_vertices = 2) out;
in vec3 end_normal[];
uniform vec2 half_size_px;
uniform vec2 strength; // opacity of a long edge, and of a short one by its length in pixels
uniform float formed;  // 1: edges alone show the form, where they are too short to be told apart
out float at_opacity;

// Shades as if by a lamp over the shoulder; hardly from behind.
float lit(vec3 normal)
{
    vec3 n = normalize(normal);
    return n.z < 0.0 ? 0.08 : 0.12 + 0.88 * max(dot(n, vec3(-0.37, 0.46, 0.81)), 0.0);
}

void main()
{
    const float NEAREST = 1e-4, ONE_BY_ONE_PX = 9.0, TOGETHER_PX = 2.5;
    vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
    float length_px = 1e3; // of what comes from behind the eye
    if (min(a.w, b.w) > NEAREST) length_px = length((a.xy / a.w - b.xy / b.w) * half_size_px);
    float opacity = min(strength.x, strength.y * length_px);
    float shaded = formed * (1.0 - smoothstep(TOGETHER_PX, ONE_BY_ONE_PX, length_px));
    for (int i = 0; i < 2; ++i) {
        gl_Position = gl_in[i].gl_Position;
        at_opacity = opacity * mix(1.0, lit(end_normal[i]), shaded);
        EmitVertex();
    }
    EndPrimitive();
}
