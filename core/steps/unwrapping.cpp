// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/unwrapping.h"

#include "core/base/mean_scale.h"
#include "core/base/rejected.h"
#include "core/base/watched.h"
#include "core/unwrap/unwrap.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

namespace trivar {
namespace {

bool has_texture(const Material& material)
{
    return std::ranges::any_of(std::array{&material.base_color_texture,
                                          &material.metallic_roughness_texture,
                                          &material.normal_texture, &material.occlusion_texture,
                                          &material.emissive_texture},
                               [](const Texture* texture) { return texture->image != nullptr; });
}

UnwrapOptions options_of(const Unwrapping& unwrapping)
{
    return {.method = unwrapping.method,
            .seam_angle = glm::radians(unwrapping.seam_angle_deg),
            .spread = glm::radians(unwrapping.spread_deg),
            .margin = unwrapping.margin};
}

} // namespace

Ref<Stage> UnwrappingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const std::optional<Unwrapping>& unwrapping = input.object.unwrapping;
    if (!unwrapping || before->shape->meshes.empty()) return before;
    return known_({before, *unwrapping, input.object.surfacing.has_value()}, [&] {
        Meshes meshes; // each once, also if several nodes have it
        for (const Shape::NodeMesh& hung : before->shape->meshes)
            if (std::ranges::find(meshes, hung.rest, &Meshes::value_type::first) == meshes.end())
                meshes.emplace_back(hung.rest, mean_scale(hung.to_model));
        const Ref<Unwraps> unwraps = unwraps_({meshes, *unwrapping}, [&] {
            return timed(input.timings, "unwrap", [&] {
                Unwraps out;
                std::vector<UnwrapInput> all;
                for (const auto& [mesh, size] : meshes) all.push_back({mesh, size});
                try {
                    Unwrapped flat = unwrapped(all, options_of(*unwrapping), input.progress);
                    for (std::size_t m = 0; m < all.size(); ++m)
                        out.to[all[m].mesh] =
                            watched([mesh = all[m].mesh, uvs = std::move(flat.uvs[m])](
                                        const Progress&) { return make_ref(with_uvs(*mesh, uvs)); },
                                    input.progress);
                    out.facts = flat.facts;
                } catch (const Rejected& error) {
                    out.trouble = std::string("it is not unwrapped: ") + error.what();
                }
                return make_ref(std::move(out));
            });
        });
        Stage out = *before;
        if (!unwraps->trouble.empty()) {
            out.notices.push_back(unwraps->trouble);
            return make_ref(std::move(out));
        }
        Shape shape = *before->shape;
        for (Shape::NodeMesh& hung : shape.meshes) {
            hung.rest = unwraps->to.at(hung.rest);
            if (hung.posed) hung.posed = posed_later(hung.rest, hung.posed->pose);
        }
        out.unwrapped = make_ref(unwraps->facts);
        if (const std::size_t faces = unwraps->facts.left_out; faces > 0)
            out.notices.push_back(
                fmt::format("{} left out of its UVs, because {} a point twice",
                            faces == 1 ? "1 face is" : fmt::format("{} faces are", faces),
                            faces == 1 ? "it uses" : "they use"));
        if (shape.materials && !input.object.surfacing &&
            std::ranges::any_of(*shape.materials, has_texture))
            out.notices.emplace_back(
                "its textures were made for the UVs of its file, which are replaced");
        out.shape = make_ref(std::move(shape));
        return make_ref(std::move(out));
    });
}

} // namespace trivar
