// Normals and tangents under a Jacobian.            GLSL and C++: see core/kernel/volume_kernel.h
//
// Cofactors map normals where J maps tangents: exactly, without a division, and also where J has
// rank 2 (Barr 1984). Where even |cof(J) n| vanishes, the normal stays what it was.
vec3 deformed_normal(mat3 j, vec3 normal)
{
    vec3 n = cross(j[1], j[2]) * normal.x + cross(j[2], j[0]) * normal.y +
             cross(j[0], j[1]) * normal.z;
    float size = dot(j[0], j[0]) + dot(j[1], j[1]) + dot(j[2], j[2]), square = dot(n, n);
    return square > 1e-13f * size * size ? n / sqrt(square) : normal;
}

// Made orthogonal to the deformed normal; the handedness stays.
vec4 deformed_tangent(mat3 j, vec4 tangent, vec3 normal)
{
    vec3 along = j * vec3(tangent);
    vec3 t = along - normal * dot(along, normal);
    if (!(dot(t, t) > 1e-13f * dot(along, along))) {
        vec3 axis = abs(normal.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
        t = axis - normal * dot(axis, normal);
    }
    return vec4(t / sqrt(dot(t, t)), tangent.w);
}
