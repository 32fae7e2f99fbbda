// Decides which tiles are drawn, and how fine.              GLSL and C++: see gpu/tiles/tile_rule.h
//
// Supplied: rule (TileRule) and float pyramid_depth(int at), the depths of a pyramid, level by
// level, each row by row. Boxes hold tiles, in the space of their patches.

const int UNSEEN = -1;

// The least value of a linear function over a box; with its corners exchanged, the greatest.
float least_over(vec4 f, vec3 lo, vec3 hi)
{
    float x = f.x * (f.x > 0.0f ? lo.x : hi.x);
    float y = f.y * (f.y > 0.0f ? lo.y : hi.y);
    float z = f.z * (f.z > 0.0f ? lo.z : hi.z);
    return x + y + z + f.w;
}

// Whether a box may be in the picture: it is not wholly beyond one of its sides.
bool in_view(vec3 lo, vec3 hi)
{
    for (int i = 0; i < 5; ++i)
        if (least_over(rule.sides[i], hi, lo) < 0.0f) return false;
    return true;
}

// Returns how far a tile may be off; 0 where its box reaches behind the camera.
float tolerance_for(vec3 lo, vec3 hi)
{
    if (rule.perspective == 0) return rule.tolerance;
    return rule.tolerance * max(least_over(rule.depth, lo, hi), 0.0f);
}

// The coarsest level whose error, stretched, is within a tolerance.
int coarsest_within(float stretch, float tolerance)
{
    int level = 0;
    while (level + 1 < rule.level_count &&
           rule.errors[(level + 1) / 4][(level + 1) % 4] * stretch <= tolerance)
        ++level;
    return level;
}

// The same, but a tile that had a level keeps it unless another is better by a third.
int level_for(float stretch, float tolerance, int before)
{
    int best = coarsest_within(stretch, tolerance);
    if (before == UNSEEN || best == before) return best;
    return best > before ? max(coarsest_within(stretch, tolerance * 0.75f), before)
                         : min(coarsest_within(stretch, tolerance * 1.33f), before);
}

// The level by which a tile is drawn if nothing hides it; UNSEEN: it is beside the picture.
int chosen_level(vec3 lo, vec3 hi, float stretch, int before)
{
    if (!in_view(lo, hi)) return UNSEEN;
    return rule.steady == 0 ? 0 : level_for(stretch, tolerance_for(lo, hi), before);
}

// Whether what lies in a box cannot be seen: all that the pyramid has over its place in the picture,
// and a texel round it, is nearer than its nearest corner. False where it reaches behind the camera.
bool hidden(vec3 lo, vec3 hi)
{
    if (rule.pyramid_px.x == 0) return false;
    vec3 least = vec3(1e30f), most = vec3(-1e30f);
    for (int i = 0; i < 8; ++i) {
        float x = (i & 1) == 0 ? lo.x : hi.x, y = (i & 2) == 0 ? lo.y : hi.y,
              z = (i & 4) == 0 ? lo.z : hi.z;
        vec4 p = rule.to_clip[0] * x + rule.to_clip[1] * y + rule.to_clip[2] * z + rule.to_clip[3];
        if (!(p.w > 0.0f)) return false;
        float by_w = 0.5f / p.w;
        vec3 there = vec3(p) * by_w + 0.5f;
        least = min(least, there);
        most = max(most, there);
    }
    if (most.x < 0.0f || most.y < 0.0f || least.x > 1.0f || least.y > 1.0f)
        return true; // it is beside the picture
    vec2 size = vec2(rule.pyramid_px);
    ivec2 first = ivec2(clamp(vec2(least) * size - 1.0f, vec2(0.0f), size - 1.0f));
    ivec2 last = ivec2(clamp(vec2(most) * size + 1.0f, vec2(0.0f), size - 1.0f));
    // The level of which at most four by four depths are compared.
    int level = 0, begin = 0;
    ivec2 there_px = rule.pyramid_px;
    while ((last.x >> level) - (first.x >> level) >= 4 || (last.y >> level) - (first.y >> level) >= 4) {
        begin += there_px.x * there_px.y;
        there_px = (there_px + 1) / 2;
        ++level;
    }
    // Single precision of the depths, and of the way to them.
    float nearest = least.z - 1e-6f;
    for (int y = first.y >> level; y <= last.y >> level; ++y)
        for (int x = first.x >> level; x <= last.x >> level; ++x)
            if (!(pyramid_depth(begin + y * there_px.x + x) < nearest)) return false;
    return true;
}
