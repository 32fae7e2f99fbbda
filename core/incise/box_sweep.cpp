// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/box_sweep.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <numeric>

namespace trivar {
namespace {

constexpr std::size_t boxes_per_block = 2048;
constexpr double usual_boxes = 1.5; // width of a strip

struct StepBox {
    glm::uvec3 lo, hi; // steps along the longest axis, the next and the last one
};

// Numbers of elements in the order of their keys, which are below a bound; of equal ones as before.
std::vector<std::uint32_t> by_keys(std::size_t count, std::size_t bound, const auto& key)
{
    std::vector<std::uint32_t> begin(bound + 1, 0), out(count);
    for (std::size_t i = 0; i < count; ++i) ++begin[key(i) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (std::size_t i = 0; i < count; ++i) out[begin[key(i)]++] = static_cast<std::uint32_t>(i);
    return out;
}

std::array<int, 3> axes_by_length(const glm::dvec3& size)
{
    std::array<int, 3> out{0, 1, 2};
    std::ranges::stable_sort(out, [&](int a, int b) { return size[a] > size[b]; });
    return out;
}

} // namespace

std::uint64_t BoxSweep::fields(const std::array<std::uint32_t, 4>& wide, bool x, bool y)
{
    std::uint64_t out = 0;
    for (const std::uint32_t each : wide) out = out << 15 | each;
    return out << 4 | std::uint64_t{x} << 2 | std::uint64_t{y};
}

BoxSweep::BoxSweep(std::span<const Box> boxes, std::span<const char> marked)
{
    Box all;
    for (const Box& box : boxes) all.add(box);
    const std::array<int, 3> axes = axes_by_length(all.size());
    const std::array<std::uint32_t, 3> bits{along_bits, 14, 14};
    std::vector<StepBox> steps(boxes.size());
    parallel_blocks(boxes.size(), boxes_per_block, [&](std::size_t begin, std::size_t end) {
        for (int i = 0; i < 3; ++i) {
            const int axis = axes[static_cast<std::size_t>(i)];
            const double most = (1u << bits[static_cast<std::size_t>(i)]) - 1;
            const double size = all.size()[axis], scale = size > 0 ? most / size : 0;
            const auto step = [&](double x) { // ascends with x, so that no pair is lost
                return static_cast<std::uint32_t>(
                    std::clamp((x - all.lo[axis]) * scale, 0.0, most));
            };
            for (std::size_t b = begin; b < end; ++b) {
                steps[b].lo[i] = step(boxes[b].lo[axis]);
                steps[b].hi[i] = step(boxes[b].hi[axis]);
            }
        }
    });
    std::uint64_t sizes = 0;
    for (const StepBox& box : steps) sizes += box.hi.y - box.lo.y + 1;
    const auto width = static_cast<std::uint32_t>(
        1 + usual_boxes * static_cast<double>(sizes) /
                static_cast<double>(std::max<std::size_t>(1, boxes.size())));

    const std::vector<std::uint32_t> order =
        by_keys(boxes.size(), 1u << along_bits, [&](std::size_t b) { return steps[b].lo.x; });
    std::vector<std::uint32_t> next(most_steps / width + 2, 0); // entry, by strip
    for (const StepBox& box : steps)
        for (std::uint32_t s = box.lo.y / width; s <= box.hi.y / width; ++s) ++next[s + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    entries_.resize(next.back() + 1);
    entries_.back().from = 0xFFFFFFFF;
    for (const std::uint32_t b : order) {
        const auto& [lo, hi] = steps[b];
        const bool mark = marked.empty() || marked[b];
        const std::uint32_t first = lo.y / width, last = hi.y / width;
        for (std::uint32_t s = first; s <= last; ++s)
            entries_[next[s]++] = {
                fields({lo.y, lo.z, most_steps - hi.y, most_steps - hi.z}, s > first, !mark),
                fields({hi.y, hi.z, most_steps - lo.y, most_steps - lo.z}, s == first, mark),
                s << along_bits | lo.x, s << along_bits | hi.x, b};
    }
}

} // namespace trivar
