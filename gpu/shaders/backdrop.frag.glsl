// Backdrop, shadows on the ground and grid, where no surface is. The floor has the colour of the
// backdrop behind it, an endless cyclorama: only what falls on it shows.
#include "frame.glsl"
#include "ground.glsl"
#include "open.glsl"
in vec2 uv;
layout(location = 0) out vec4 out_color;
layout(binding = 0) uniform sampler2D contact_map;

#ifdef GRID
// Lines of constant width in pixels, a spacing apart, that fade before they get too dense.
float grid_line(vec2 p, float spacing, float width_px)
{
    vec2 q = p / spacing, w = max(fwidth(q), 1e-5), d = abs(fract(q - 0.5) - 0.5) / w;
    vec2 line = (1.0 - smoothstep(width_px * 0.5 - 0.5, width_px * 0.5 + 0.5, d)) * smoothstep(0.5, 0.08, w);
    return max(line.x, line.y);
}
vec2 axis_lines(vec2 p, float width_px)
{
    vec2 d = abs(p) / max(fwidth(p), 1e-9);
    return 1.0 - smoothstep(width_px * 0.5 - 0.5, width_px * 0.5 + 0.5, d);
}
// The point of the grid's plane, along u and v, that a place of the picture shows.
struct Grid { vec2 at; bool seen; };
Grid grid_behind(vec2 uv)
{
    bool perspective = frame.eye.w > 0.5;
    vec3 from = (frame.from_view * vec4(perspective ? vec3(0.0) : view_point(uv, 0.0), 1.0)).xyz;
    vec3 d = normalize(mat3(frame.from_view) * (perspective ? view_point(uv, 1.0) : vec3(0.0, 0.0, -1.0)));
    vec3 normal = cross(frame.grid_u.xyz, frame.grid_v.xyz);
    float towards = dot(d, normal);
    float along = (frame.grid_u.w - dot(from, normal)) / (abs(towards) > 1e-5 ? towards : 1e-5);
    vec3 p = from + d * along;
    return Grid(vec2(dot(p, frame.grid_u.xyz), dot(p, frame.grid_v.xyz)),
                abs(towards) > 1e-4 && (along > 0.0 || !perspective));
}
// Mixed as colours look, by the square root of light, in which `color` is.
vec3 with_line(vec3 color, vec4 line, float share) { return mix(color, sqrt(line.rgb), line.a * share); }
#endif

void main()
{
    vec3 color = mix(frame.backdrop[2].rgb, frame.backdrop[1].rgb, smoothstep(0.0, 0.62, uv.y));
    color = mix(color, frame.backdrop[0].rgb, smoothstep(0.50, 1.08, uv.y));
    vec2 aside = (uv - vec2(0.5, 0.55)) * vec2(1.0, 0.7); // a light pool behind the subject
    color *= 1.0 - frame.backdrop[0].w * dot(aside, aside);

    Ground g = ground_behind(uv);
#ifdef GRID // derivatives stay outside branches
    Grid grid = grid_behind(uv);
    vec2 on_grid = grid.at - frame.grid_at.xy;
    float width_px = frame.centre.w;
    float fine = grid_line(on_grid, frame.ground.y, width_px);
    float coarse = grid_line(on_grid, frame.ground.y * 5.0, 1.35 * width_px);
    vec2 axes = axis_lines(grid.at - frame.grid_at.zw, 1.6 * width_px);
#endif
    if (g.seen && frame.ground.w > 0.5) {
        float fade = 1.0 - smoothstep(0.35, 1.0, g.away);
        vec2 at = (g.at.xy - frame.contact.xy) * frame.contact.z;
        vec2 inside = smoothstep(0.0, 0.06, at) * smoothstep(0.0, 0.06, 1.0 - at);
        float open = mix(1.0, textureLod(contact_map, at, 0.0).r, inside.x * inside.y);
        float visible = open_share(-g.depth).y;
        // The ratio of light with and without the objects on a white floor.
        vec3 lit = mix(vec3(visible), vec3(open), frame.ground_share.rgb);
        color *= mix(vec3(1.0), lit, fade);
    }
#ifdef GRID
    if (grid.seen) {
        vec2 middle = vec2(dot(frame.centre.xyz, frame.grid_u.xyz), dot(frame.centre.xyz, frame.grid_v.xyz));
        float away = length(grid.at - middle) / frame.ground.z;
        float fade = 1.0 - smoothstep(0.08, 0.80, away) * (1.0 - frame.grid_v.w);
        vec3 root = sqrt(color);
        root = with_line(root, frame.grid_lines[0], fine * fade);
        root = with_line(root, frame.grid_lines[1], coarse * fade);
        root = with_line(root, frame.grid_lines[2], axes.y * fade);
        root = with_line(root, frame.grid_lines[3], axes.x * fade);
        color = root * root;
    }
#endif
#ifndef DEEP
    color = dithered(color, gl_FragCoord.xy, frame.scene.w);
#endif
    out_color = vec4(color, 1.0);
}
