// The point of the ground that a place of the picture shows, and its distance along the view
// direction; not seen where the view does not meet the ground or that has faded.
struct Ground { vec3 at; float depth, away; bool seen; };
Ground ground_behind(vec2 uv)
{
    bool perspective = frame.eye.w > 0.5;
    vec3 from = (frame.from_view * vec4(perspective ? vec3(0.0) : view_point(uv, 0.0), 1.0)).xyz;
    vec3 d = normalize(mat3(frame.from_view) * (perspective ? view_point(uv, 1.0) : vec3(0.0, 0.0, -1.0)));
    Ground g;
    g.at = from + d * ((frame.ground.x - from.z) / (abs(d.z) > 1e-5 ? d.z : 1e-5));
    g.depth = -(frame.view * vec4(g.at, 1.0)).z;
    g.away = length(g.at.xy - frame.centre.xy) / frame.ground.z;
    g.seen = d.z < -1e-4 && from.z > frame.ground.x && g.away < 1.0;
    return g;
}
