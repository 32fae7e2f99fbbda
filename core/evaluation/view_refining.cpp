// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/view_refining.h"

#include "core/base/finite.h"
#include "core/base/rejected.h"
#include "core/steps/bending/refining.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

std::size_t triangles_of(const EvaluatedObject& object)
{
    std::size_t count = 0;
    for (const Part& part : object.parts)
        count += part.rest->corners.size() - 2 * part.rest->face_count();
    return count;
}

EvaluatedObject with_split_parts(const EvaluatedObject& object, RefineOptions options,
                                 const Progress& progress)
{
    EvaluatedObject out = object;
    // If the camera is nearer than the precision of the coordinates, triangles are as fine as
    // possible.
    constexpr int most_doublings = 24;
    for (int i = 0; i < most_doublings; ++i, options.tolerance_world *= 2) {
        try {
            SplitParts made = split(object.parts, options, progress);
            out.refined = std::move(made.refined);
            out.parts = std::move(made.parts);
            break;
        } catch (const Rejected&) {
            continue;
        }
    }
    return out;
}

} // namespace

double view_tolerance(const Camera& camera, const Box& bounds, double tolerance_px)
{
    if (bounds.empty()) return infinite;
    const glm::dmat4 view = view_matrix(camera);
    const double pixel = pixel_size_world(camera, 1); // at depth 1, or everywhere
    const glm::dvec2 half = pixel * camera.size_px / 2.0;
    // Number of corners outside of each side of the picture, and behind the eye.
    std::array<int, 5> outside{};
    double least = infinite;
    for (const glm::dvec3& corner : bounds.corners()) {
        const glm::dvec3 p(view * glm::dvec4(corner, 1));
        const double depth = -p.z, wide = camera.perspective ? depth : 1;
        least = std::min(least, depth);
        outside[0] += p.x > half.x * wide;
        outside[1] += p.x < -half.x * wide;
        outside[2] += p.y > half.y * wide;
        outside[3] += p.y < -half.y * wide;
        outside[4] += depth < 0;
    }
    if (std::ranges::find(outside, 8) != outside.end()) return infinite;
    double tolerance = tolerance_px * pixel;
    if (camera.perspective) {
        const double depth = std::max(least, glm::length(bounds.size()) / 100),
                     slant = std::sqrt(1 + glm::dot(half, half)); // 1 / cos a
        tolerance = tolerance_px * depth / (slant / pixel + tolerance_px);
    }
    return std::exp2(std::floor(2 * std::log2(tolerance)) / 2);
}

SeenEffects ViewRefining::operator()(const Evaluation& evaluated, const Camera& camera,
                                     double tolerance_px, const Progress& progress,
                                     std::size_t budget)
{
    std::erase_if(known_, [&](const KnownView& known) {
        const auto there = evaluated.objects.find(known.object->id);
        return there == evaluated.objects.end() || there->second != known.object;
    });
    std::size_t laid = 0;
    for (const auto& [id, object] : evaluated.objects) laid += lies_in_a_volume(*object);
    SeenEffects out{.evaluated = evaluated};
    for (auto& [id, seen] : out.evaluated.objects) {
        const Ref<EvaluatedObject> object = seen;
        if (!lies_in_a_volume(*object)) continue;
        const double tolerance = view_tolerance(camera, *object->bounds, tolerance_px);
        const bool out_of_sight = std::isinf(tolerance);
        const bool fine_already = object->refined && object->refined->bound <= tolerance;
        const std::size_t share = std::max(budget / laid, triangles_of(*object));
        const auto found = std::ranges::find_if(known_, [&](const KnownView& known) {
            return known.object == object &&
                   (out_of_sight || (known.tolerance == tolerance && known.budget == share));
        });
        if (found != known_.end()) {
            seen = found->seen;
            std::rotate(known_.begin(), found, found + 1);
        } else if (!out_of_sight && !fine_already) {
            seen = make_ref(with_split_parts(
                *object, {.tolerance_world = tolerance, .budget = share}, progress));
            known_.insert(known_.begin(), {object, tolerance, share, seen});
            constexpr std::ptrdiff_t kept_results = 2; // undo and redo may switch between two
            std::ptrdiff_t of_this = 0;
            std::erase_if(known_, [&](const KnownView& known) {
                return known.object == object && ++of_this > kept_results;
            });
        }
        out.triangles += triangles_of(*seen);
        if (out_of_sight || (seen->refined && seen->refined->bound <= tolerance)) continue;
        out.open += std::max<std::size_t>(1, seen->refined ? seen->refined->not_certified() : 0);
    }
    return out;
}

} // namespace trivar
