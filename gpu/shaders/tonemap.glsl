// Scene-linear to display-linear Rec. 709 by Khronos PBR Neutral (2024): base colours under full
// light come out within a few percent of what was picked; only highlights are compressed.
vec3 tone_mapped(vec3 c)
{
    const float F90 = 0.04, START = 0.8 - F90, DESATURATE = 0.15;
    c = max(c, 0.0) * frame.scene.y;
    float x = min(c.r, min(c.g, c.b));
    c -= x < 2.0 * F90 ? x - x * x / (4.0 * F90) : F90;
    float peak = max(c.r, max(c.g, c.b));
    if (peak <= START) return saturate(c);
    float pressed = 1.0 - (1.0 - START) * (1.0 - START) / (peak + 1.0 - 2.0 * START);
    float grey = 1.0 / (DESATURATE * (peak - pressed) + 1.0);
    return saturate(mix(vec3(pressed), c * (pressed / peak), grey));
}
