// Light on a surface: one function for the full-screen pass and for what is drawn in front of it.
// GGX metallic-roughness; highlights in closed form from the studio; tone mapped at the end.
layout(binding = 0) uniform sampler2D contact_map;

// Light that comes up from the floor is dimmed by the shadow that the object itself throws there.
float floor_visibility(vec3 p, vec3 n)
{
    if (frame.ground.w < 0.5) return 1.0;
    float seen = textureLod(contact_map, (p.xy - frame.contact.xy) * frame.contact.z, 0.0).r;
    float h = max(p.z - frame.ground.x, 0.0) / (0.25 * frame.scene.x);
    return mix(1.0, seen, (0.5 - 0.5 * n.z) / (1.0 + h * h * 4.0));
}

// Display-linear colour of the surface at p, seen from the eye; `open` is the share of the
// ambient light that reaches it, `visible` that of the key.
vec3 shaded(Surface s, vec3 p, float open, float visible)
{
    if (s.flat_color) return decoded(s.emissive);
    vec3 v = towards_eye(p), n = s.normal;
    float nv = dot(n, v);
    if (nv < 0.02) { // interpolated normals never turn away
        n = normalize(n + v * (0.02 - nv));
        nv = 0.02;
    }
    if (s.back) { // the inside of a single-sided mesh looks like unglazed clay
        s.base = mix(s.base, vec3(0.323, 0.102, 0.065), 0.72);
        s.roughness = min(s.roughness + 0.2, 1.0);
        s.metallic = 0.0;
    }
    open *= s.occlusion * floor_visibility(p, n);

    // The key is an area light: its diffuse horizon is quadratic, no hard terminator.
    float x = dot(n, frame.key_dir.xyz), soft = frame.key_dir.w * 0.9;
    float facing = x > soft ? x : x < -soft ? 0.0 : (x + soft) * (x + soft) / (4.0 * soft);

    float rough = s.roughness, alpha = max(rough * rough, 0.002);
    vec3 f0 = mix(vec3(0.04), s.base, s.metallic), diffuse = s.base * (1.0 - s.metallic);
    // Split sum by Karis' fit (2014) with the gain of multiple scattering (Fdez-Aguera 2019).
    vec4 rk = rough * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a4 = min(rk.x * rk.x, exp2(-9.28 * nv)) * rk.x + rk.y;
    vec2 ab = vec2(-1.04, 1.04) * a4 + rk.zw;
    vec3 specular = f0 * ab.x + ab.y;
    vec3 gain = 1.0 + f0 * (1.0 / max(ab.x + ab.y, 1e-3) - 1.0);
    Reflected mirror = studio_reflected(reflect(-v, n), alpha);
    // Occlusion of reflections (Lagarde, de Rousiers 2014), coloured by bounces (Jimenez 2016).
    float open_mirror = saturate(pow(nv + open, exp2(-16.0 * rough - 1.0)) - 1.0 + open);
    vec3 bounced = ((open * (2.0404 * diffuse - 0.3324) + (-4.7951 * diffuse + 0.6417)) * open
                    + (2.7552 * diffuse + 0.6903)) * open;
    bounced = max(vec3(open), bounced);

    vec3 light = studio_irradiance(n) * bounced + frame.key_light.rgb * (facing * visible);
    // Colours that stand for numbers keep most of theirs, and no tone curve moves them.
    if (s.shown) return s.base * mix(0.62, 1.0, saturate(luma(light) / (1.1 * PI)));
    vec3 color = diffuse * (1.0 - specular * gain) * light / PI
               + specular * gain * (mirror.ambient * open_mirror
                                    + mirror.key * visible * smoothstep(-0.15, 0.1, x));
    return tone_mapped(color + s.emissive);
}
