// Colours that show a number at every vertex: gpu/color_map.h.
in float at_value;
uniform vec4 map_colors[33];
uniform vec4 map_range; // where it begins, 1/length, 1: by the logarithm to base 2

vec3 value_color(float value)
{
    bool folded = map_range.z > 0.5 && value <= 0.0;
    float x = map_range.z > 0.5 ? log2(max(value, 1e-6)) : value;
    float t = saturate((x - map_range.x) * map_range.y) * 32.0;
    int i = min(int(t), 31);
    vec3 color = mix(map_colors[i].rgb, map_colors[i + 1].rgb, t - float(i));
    // A hatch on the screen, which no value has.
    bool stripe = fract((gl_FragCoord.x + gl_FragCoord.y) / 10.0) > 0.5;
    return folded ? (stripe ? vec3(0.90, 0.35, 0.70) : vec3(0.60, 0.0, 0.33)) : color;
}
