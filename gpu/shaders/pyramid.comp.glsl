// A level of a pyramid of depths: FIRST, those of a depth buffer, or the greatest of each four of
// the level before. gpu/tiles/depth_pyramid.h says how they lie.
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) buffer Pyramid { float pyramid[]; };
uniform int width;  // of the level
uniform int height;
uniform int begin;
#ifdef FIRST
layout(binding = 0) uniform sampler2D depths;
float depth_at(ivec2 p) { return texelFetch(depths, p, 0).r; }
#else
uniform int fine_width; // of the level before
uniform int fine_height;
uniform int fine_begin;
float fine_at(int x, int y) { return pyramid[fine_begin + y * fine_width + x]; }
float depth_at(ivec2 p)
{
    ivec2 lo = 2 * p, hi = min(lo + 1, ivec2(fine_width, fine_height) - 1);
    return max(max(fine_at(lo.x, lo.y), fine_at(hi.x, lo.y)),
               max(fine_at(lo.x, hi.y), fine_at(hi.x, hi.y)));
}
#endif

void main()
{
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (p.x < width && p.y < height) pyramid[begin + p.y * width + p.x] = depth_at(p);
}
