layout(location = 0) out vec4 out_color;
in float at_opacity;
uniform vec4 color;
void main() { out_color = vec4(color.rgb, color.a * at_opacity); }
