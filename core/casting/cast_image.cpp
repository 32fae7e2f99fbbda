// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/casting/cast_image.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace kernel {
using namespace glm;

// The values of a field by its own sums.
struct SplineValues {
    const ScalarField<float>& field;
    vec2 share;
    float value(vec3 p) const { return share.x * field.at<0>(p).value + share.y; }
    vec3 slope(vec3 p) const
    {
        const std::array<float, 3> g = field.at<1>(p).gradient;
        return share.x * vec3(g[0], g[1], g[2]);
    }
};

// Linear between samples.
template <class Sample> struct LinearValues {
    const Sample* samples;
    ivec3 size;
    vec2 share;
    float value(vec3 p) const
    {
        const ivec3 i = clamp(ivec3(p), ivec3(0), size - 2);
        const vec3 t = clamp(p - vec3(i), vec3(0), vec3(1));
        const std::ptrdiff_t row = size.x, layer = row * size.y;
        const Sample* const s = samples + i.x + row * i.y + layer * i.z;
        const auto along = [&](std::ptrdiff_t at) {
            const auto a = static_cast<float>(s[at]);
            return a + t.x * (static_cast<float>(s[at + 1]) - a);
        };
        const float near = mix(along(0), along(row), t.y),
                    far = mix(along(layer), along(layer + row), t.y);
        return share.x * mix(near, far, t.z) + share.y;
    }
    vec3 slope(vec3 p) const
    {
        const float here = value(p);
        return vec3(value(p + vec3(1, 0, 0)), value(p + vec3(0, 1, 0)), value(p + vec3(0, 0, 1))) -
               here;
    }
};

// A PixelKernel is the formulas of core/kernel as C++; the shaders include the same text.
template <class Values> struct PixelKernel {
    const Casting& casting;
    const Values& values;
    const std::array<vec4, 9>& rays;
    const std::array<vec4, 11>& lights;
    const vec4 &low, &high, &look;
    const mat3& to_normals;
    vec3 toward_eye{0, 0, 1};

    float value_at(vec3 p) const { return values.value(p); }
    vec3 slope_at(vec3 p) const { return values.slope(p); }
    int empty_reach(ivec3 b) const { return casting.empty.of(b); }
    vec4 transfer_before(float u) const { return casting.transfer.before_share(u); }
    float open_at(vec3 brick) const
    {
        const OpenBricks& open = casting.open;
        const vec3 p = clamp(brick - 0.5f, vec3(0), vec3(open.count - 1));
        const ivec3 i(p), next = min(i + 1, open.count - 1);
        const vec3 t = p - vec3(i);
        const auto at = [&](int x, int y, int z) {
            return static_cast<float>(open.share[static_cast<std::size_t>(
                       x + open.count.x * (y + open.count.y * z))]) /
                   255;
        };
        const auto row = [&](int y, int z) { return mix(at(i.x, y, z), at(next.x, y, z), t.x); };
        return mix(mix(row(i.y, i.z), row(next.y, i.z), t.y),
                   mix(row(i.y, next.z), row(next.y, next.z), t.y), t.z);
    }

#include "core/kernel/casting.glsl"

#include "core/kernel/cast_pixel.glsl"
};

} // namespace kernel

namespace {

template <class Values>
CastPixels cast_with(const Values& values, const Casting& casting, const CastView& view,
                     glm::ivec2 size_px, glm::ivec2 lo_px, glm::ivec2 count_px,
                     std::span<const CastSolid> solids)
{
    const auto across = static_cast<std::size_t>(count_px.x),
               rows = static_cast<std::size_t>(count_px.y);
    CastPixels out{std::vector<glm::vec4>(across * rows), std::vector<float>(across * rows)};
    parallel_blocks(rows, 2, [&](std::size_t begin, std::size_t end) {
        kernel::PixelKernel<Values> kernel{casting,  values,    view.rays, view.lights,
                                           view.low, view.high, view.look, view.to_normals};
        for (std::size_t y = begin; y < end; ++y)
            for (std::size_t x = 0; x < across; ++x) {
                const std::size_t i = y * across + x;
                const glm::vec2 p_px = glm::vec2(lo_px) + glm::vec2(x, y) + 0.5f;
                const auto g = kernel.cast_pixel(p_px / glm::vec2(size_px), p_px, solids[i].id,
                                                 solids[i].distance);
                out.gathered[i] = glm::vec4(g.color, g.opacity);
                out.hits[i] = g.hit;
            }
    });
    return out;
}

} // namespace

CastPixels cast_image(const Casting& casting, const CastView& view, glm::ivec2 size_px,
                      glm::ivec2 lo_px, glm::ivec2 count_px, std::span<const CastSolid> solids,
                      bool linear)
{
    const VoxelField& data = *casting.field;
    const glm::vec2 share(casting.share_of_sample);
    const auto with = [&](const auto& values) {
        return cast_with(values, casting, view, size_px, lo_px, count_px, solids);
    };
    if (!linear || !data.goes_through_samples())
        return with(kernel::SplineValues{data.field(), share});
    return std::visit(
        [&]<class Sample>(const std::vector<Sample>& samples) {
            return with(kernel::LinearValues<Sample>{samples.data(), data.grid().size, share});
        },
        data.grid().samples);
}

} // namespace trivar
