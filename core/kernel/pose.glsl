// A vertex under morph targets and a skin.           GLSL and C++: see core/mesh/pose.cpp
//
//   p' = M (p + sum_t a_t d_t),     M = sum_k w_k J_k over its joints,     n' = cof(M) n / |..|
//
// Supplied: int morph_count(); float morph_weight(int target); vec3 morph_difference(int target,
// int what, int vertex), what: 0 position, 1 normal, 2 tangent; mat4 vertex_matrix(int vertex).

struct PosedVertex {
    vec3 position, normal;
    vec4 tangent;
};

vec3 morphed(int what, int vertex, vec3 value)
{
    for (int t = 0; t < morph_count(); ++t)
        if (morph_weight(t) != 0.0f)
            value += morph_weight(t) * morph_difference(t, what, vertex);
    return value;
}

PosedVertex posed_vertex(int vertex, vec3 p, vec3 normal, vec4 tangent)
{
    mat4 m = vertex_matrix(vertex);
    mat3 j = mat3(m);
    PosedVertex v;
    v.position = j * morphed(0, vertex, p) + vec3(m[3]);
    v.normal = deformed_normal(j, morphed(1, vertex, normal));
    v.tangent =
        deformed_tangent(j, vec4(morphed(2, vertex, vec3(tangent)), tangent.w), v.normal);
    return v;
}
