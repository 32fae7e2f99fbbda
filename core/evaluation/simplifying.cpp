// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/simplifying.h"

#include "core/base/rejected.h"
#include "core/simplify/simplify.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Positions of the vertices of each mesh at some moments of each clip; empty for a mesh that never
// bends.
using Poses = std::vector<std::vector<std::vector<glm::vec3>>>; // #meshes, #moments, #V

Poses poses_of(const Shape& shape)
{
    constexpr std::size_t most_clips = 4;
    constexpr int moments = 4; // per clip
    Poses out(shape.meshes.size());
    const std::vector<Clip>& clips = shape.model->clips;
    for (std::size_t c = 0; c < std::min(most_clips, clips.size()); ++c)
        for (int i = 0; i < moments; ++i) {
            Shape posed = shape;
            stand(posed, &clips[c],
                  clips[c].begin_s + (clips[c].end_s - clips[c].begin_s) * i / moments);
            // Some were left out because they are too large
            if (posed.meshes.size() != shape.meshes.size()) continue;
            for (std::size_t m = 0; m < posed.meshes.size(); ++m)
                if (posed.meshes[m].posed) out[m].push_back(posed.meshes[m].mesh()->positions);
        }
    return out;
}

std::size_t triangles_in(const Mesh& mesh)
{
    return mesh.corners.size() - 2 * mesh.face_count();
}

Stage simplified(const Stage& before, const Simplifying& simplifying, const Progress& progress)
{
    Stage out = before;
    Shape shape = *before.shape;
    const Poses poses = poses_of(shape);
    // Each mesh is simplified once, also if several nodes have it
    std::map<Ref<Mesh>, SimplifiedMesh> done;
    try {
        for (std::size_t m = 0; m < shape.meshes.size(); ++m) {
            Shape::NodeMesh& hung = shape.meshes[m];
            auto found = done.find(hung.rest);
            if (found == done.end()) {
                SimplifyOptions options;
                options.triangles = static_cast<std::size_t>(
                    std::ceil(simplifying.keep * static_cast<double>(triangles_in(*hung.rest))));
                if (simplifying.deviation > 0) {
                    const double stretch = glm::length(glm::dvec3(hung.to_model[0]));
                    options.error = simplifying.deviation / std::max(stretch, 1e-12);
                }
                options.poses = poses[m];
                found = done.emplace(hung.rest, simplified(hung.rest, options, progress)).first;
            }
            out.triangles_before += found->second.triangles_before;
            out.triangles += found->second.triangles;
            if (hung.posed) hung.posed = posed_later(found->second.mesh, hung.posed->pose);
            hung.rest = found->second.mesh;
        }
    } catch (const Rejected& error) {
        out = before;
        out.notices.push_back(std::string("it is not simplified: ") + error.what());
        return out;
    }
    out.shape = make_ref(std::move(shape));
    return out;
}

} // namespace

Ref<Stage> SimplifyingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const std::optional<Simplifying>& simplifying = input.object.simplifying;
    if (!simplifying || before->shape->meshes.empty()) return before;
    return known_({before, *simplifying}, [&] {
        return timed(input.timings, "simplify",
                     [&] { return make_ref(simplified(*before, *simplifying, input.progress)); });
    });
}

} // namespace trivar
