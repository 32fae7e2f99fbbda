// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/phantom.h"

#include "core/base/parallel.h"

namespace make {

Tissue& Tissue::part()
{
    parts_.emplace_back();
    return *this;
}

Tissue& Tissue::join(const Solid& solid, float blend)
{
    if (parts_.empty()) part();
    parts_.back().push_back({solid, blend, false});
    return *this;
}

Tissue& Tissue::cut(const Solid& solid, float blend)
{
    parts_.back().push_back({solid, blend, true});
    return *this;
}

// The steps of a tissue that matter in a box.
class NearTissue {
public:
    NearTissue(const Tissue& tissue, vec3 lo, vec3 hi)
    {
        for (const auto& part : tissue.parts_) {
            std::vector<const Tissue::Step*> near;
            bool joined = false;
            for (const Tissue::Step& step : part) {
                const float far = phantom_reach_mm + step.blend;
                if (glm::any(glm::lessThan(step.solid.hi + far, lo)) ||
                    glm::any(glm::greaterThan(step.solid.lo - far, hi)))
                    continue;
                near.push_back(&step);
                joined = joined || !step.cuts;
            }
            if (joined) parts_.push_back(std::move(near));
        }
    }
    bool empty() const { return parts_.empty(); }
    float operator()(vec3 p) const
    {
        float least = 2 * phantom_reach_mm;
        for (const auto& part : parts_) {
            float d = 4 * phantom_reach_mm;
            for (const Tissue::Step* step : part) {
                const float own = step->solid.distance(p);
                d = step->cuts ? smax(d, -own, step->blend) : smin(d, own, step->blend);
            }
            least = std::min(least, d);
        }
        return least;
    }

private:
    std::vector<std::vector<const Tissue::Step*>> parts_;
};

namespace {

constexpr int brick_side = 8;

vec3 warped(vec3 p, float by)
{
    if (by == 0) return p;
    const vec3 q = p / 23.f;
    return p + by * vec3(noise(q), noise(q + 31.7f), noise(q - 57.3f));
}

void sample_brick(const Phantom& phantom, glm::ivec3 begin, std::vector<float>& out)
{
    const glm::ivec3 end = glm::min(begin + brick_side, phantom.size);
    const vec3 lo = phantom.lo + vec3(begin) * phantom.step - phantom.warp,
               hi = phantom.lo + vec3(end) * phantom.step + phantom.warp;
    std::vector<NearTissue> near;
    for (const Tissue& tissue : phantom.tissues) near.emplace_back(tissue, lo, hi);
    std::vector<float> distances(near.size(), 2 * phantom_reach_mm);
    for (int z = begin.z; z < end.z; ++z)
        for (int y = begin.y; y < end.y; ++y)
            for (int x = begin.x; x < end.x; ++x) {
                const vec3 p = warped(phantom.lo + vec3(x, y, z) * phantom.step, phantom.warp);
                for (std::size_t i = 0; i < near.size(); ++i)
                    if (!near[i].empty()) distances[i] = near[i](p);
                out[std::size_t(x) +
                    std::size_t(phantom.size.x) *
                        (std::size_t(y) + std::size_t(phantom.size.y) * std::size_t(z))] =
                    phantom.value(p, distances);
            }
}

} // namespace

float inside(float distance, float width)
{
    const float t = saturate(.5f - distance / width);
    return t * t * t * (t * (6 * t - 15) + 10);
}

std::vector<float> sampled(const Phantom& phantom)
{
    const glm::ivec3 bricks = (phantom.size + brick_side - 1) / brick_side;
    std::vector<float> out(std::size_t(phantom.size.x) * std::size_t(phantom.size.y) *
                           std::size_t(phantom.size.z));
    trivar::parallel_blocks(
        std::size_t(bricks.x * bricks.y * bricks.z), 16, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const int at = int(i);
                sample_brick(phantom,
                             brick_side * glm::ivec3(at % bricks.x, at / bricks.x % bricks.y,
                                                     at / bricks.x / bricks.y),
                             out);
            }
        });
    return blurred(out, phantom.size);
}

std::vector<float> blurred(const std::vector<float>& samples, glm::ivec3 size)
{
    std::vector<float> from = samples, to(samples.size());
    std::size_t stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto count = std::size_t(size[axis]);
        for (std::size_t i = 0; i < from.size(); ++i) {
            const std::size_t at = i / stride % count;
            const float before = from[at == 0 ? i : i - stride],
                        after = from[at + 1 == count ? i : i + stride];
            to[i] = .25f * (before + after) + .5f * from[i];
        }
        std::swap(from, to);
        stride *= count;
    }
    return from;
}

} // namespace make
