// A vertex of a tile, bent over the patch of its place: core/patches/placed_tile.h says how. A tile
// is 26 texels: its origin and scale, four rows of coefficients for each component, and its tint.
// FOOTPRINTS: beyond the unit square the tile goes on as it bends at its rim.
layout(location = 13) in uint tile;
layout(binding = 14) uniform samplerBuffer tile_patches;
#if __VERSION__ >= 400
#define PRECISE precise // the same bits in every pass
#else
#define PRECISE
#endif

struct TileVertex {
    vec3 position, normal, tangent;
};

#ifdef FOOTPRINTS
// The second derivatives of one component: x by x, y by x and y, z by y.
vec3 tile_bends(int row, vec2 at)
{
    vec4 value, slope, bend;
    for (int j = 0; j < 4; ++j) {
        vec4 c = texelFetch(tile_patches, row + j);
        value[j] = ((c.w * at.x + c.z) * at.x + c.y) * at.x + c.x;
        slope[j] = (3.0 * c.w * at.x + 2.0 * c.z) * at.x + c.y;
        bend[j] = 6.0 * c.w * at.x + 2.0 * c.z;
    }
    return vec3(((bend.w * at.y + bend.z) * at.y + bend.y) * at.y + bend.x,
                (3.0 * slope.w * at.y + 2.0 * slope.z) * at.y + slope.y,
                6.0 * value.w * at.y + 2.0 * value.z);
}
#endif

// One component, with its derivatives: x the value, y by x, z by y.
vec3 tile_component(int row, vec2 at)
{
    vec4 value, slope;
    for (int j = 0; j < 4; ++j) {
        vec4 c = texelFetch(tile_patches, row + j);
        PRECISE float along = ((c.w * at.x + c.z) * at.x + c.y) * at.x + c.x;
        value[j] = along;
        slope[j] = (3.0 * c.w * at.x + 2.0 * c.z) * at.x + c.y;
    }
    PRECISE float here = ((value.w * at.y + value.z) * at.y + value.y) * at.y + value.x;
    return vec3(here, ((slope.w * at.y + slope.z) * at.y + slope.y) * at.y + slope.x,
                (3.0 * value.w * at.y + 2.0 * value.z) * at.y + value.y);
}

vec3 unit_or_up(vec3 v)
{
    float square = dot(v, v);
    return square > 1e-36 ? v * inversesqrt(square) : vec3(0.0, 0.0, 1.0);
}

// The factor of the colour, and the share by which it takes the place of that of the vertex.
vec4 tile_tint() { return texelFetch(tile_patches, 26 * int(tile) + 25); }

// The derivatives of T by x and y, without the factor of the tile.
void tile_directions(int first, vec3 p, out vec3 by_x, out vec3 by_y, out vec3 by_z)
{
    for (int k = 0; k < 3; ++k) {
        vec3 base = tile_component(first + 1 + 4 * k, p.xy);
        vec3 up = tile_component(first + 13 + 4 * k, p.xy);
        by_x[k] = base.y + p.z * up.y;
        by_y[k] = base.z + p.z * up.z;
        by_z[k] = up.x;
    }
}

TileVertex tile_vertex(vec3 p, vec3 normal, vec3 tangent)
{
    int first = 26 * int(tile);
    vec4 place = texelFetch(tile_patches, first);
    vec2 at = p.xy;
#ifdef FOOTPRINTS
    at = clamp(at, 0.0, 1.0);
#endif
    PRECISE vec3 there;
    vec3 by_x, by_y, by_z;
    for (int k = 0; k < 3; ++k) {
        vec3 base = tile_component(first + 1 + 4 * k, at);
        vec3 up = tile_component(first + 13 + 4 * k, at);
        there[k] = base.x + p.z * up.x;
        by_x[k] = base.y + p.z * up.y;
        by_y[k] = base.z + p.z * up.z;
        by_z[k] = up.x;
    }
#ifdef FOOTPRINTS
    vec2 beyond = p.xy - at;
    vec3 straight = beyond.x * by_x + beyond.y * by_y, bent;
    for (int k = 0; k < 3; ++k) {
        vec3 bends = tile_bends(first + 1 + 4 * k, at);
        bent[k] = 0.5 * (beyond.x * beyond.x * bends.x + beyond.y * beyond.y * bends.z) +
                  beyond.x * beyond.y * bends.y;
    }
    // At a sharp edge the bend says nothing of the ground beyond it.
    float most = 0.7 * length(straight), much = length(bent);
    there += straight + (much > most ? most / much : 1.0) * bent;
#endif
    TileVertex v;
    PRECISE vec3 position = place.xyz + place.w * there;
    v.position = position;
    // Where a side of the patch has no length: core/patches/pinch.h.
    float xx = dot(by_x, by_x), yy = dot(by_y, by_y);
    if (min(xx, yy) < 1e-8 * max(xx, yy))
        tile_directions(first, vec3(mix(at, vec2(0.5), 1.0 / 64.0), p.z), by_x, by_y, by_z);
    v.normal = unit_or_up(normal.x * cross(by_y, by_z) + normal.y * cross(by_z, by_x) +
                          normal.z * cross(by_x, by_y));
    v.tangent = unit_or_up(tangent.x * by_x + tangent.y * by_y + tangent.z * by_z);
    return v;
}
