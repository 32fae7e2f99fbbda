layout(location = 0) out vec4 out_color;
uniform float opacity;
void main() { out_color = vec4(0.012, 0.014, 0.02, opacity); }
