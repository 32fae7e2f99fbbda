// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/simplifying.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/simplify/simplify.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

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

// Says where borders and the like keep more triangles than were asked for.
void tell_of_kept(Stage& stage, const Simplifying& simplifying, std::size_t left_out)
{
    const double wanted = simplifying.keep * static_cast<double>(stage.triangles_before),
                 most = 1.02 * wanted + 2; // less than that is seen by nobody
    if (simplifying.deviation > 0 || !(static_cast<double>(stage.triangles) > most)) return;
    std::string why = "borders, creases, seams and colours stay";
    if (left_out > 0)
        why += fmt::format(", and {} at edges of more than two faces",
                           left_out == 1 ? "one triangle" : with_commas(left_out) + " triangles");
    stage.notices.push_back(fmt::format("it keeps {} of its {} triangles, where {} were asked for: "
                                        "{}",
                                        with_commas(stage.triangles),
                                        with_commas(stage.triangles_before),
                                        percent_text(simplifying.keep), why));
}

Stage simplified(const Stage& before, const Simplifying& simplifying, const Progress& progress)
{
    Stage out = before;
    Shape shape = *before.shape;
    const Poses poses = poses_of(shape);
    // Each mesh is simplified once, also if several nodes have it
    std::map<Ref<Mesh>, SimplifiedMesh> done;
    std::size_t left_out = 0;
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
            left_out += found->second.left_out;
            if (hung.posed) hung.posed = posed_later(found->second.mesh, hung.posed->pose);
            hung.rest = found->second.mesh;
        }
    } catch (const Rejected& error) {
        out = before;
        out.notices.push_back(std::string("it is not simplified: ") + error.what());
        return out;
    }
    tell_of_kept(out, simplifying, left_out);
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
