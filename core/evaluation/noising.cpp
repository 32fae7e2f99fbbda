// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/noising.h"

#include <random>

namespace trivar {

Ref<Stage> Noising::operator()(const Ref<Stage>& before, const StepInput& input)
{
    if (!input.object.noise) return before;
    return known_({before, *input.object.noise}, [&] {
        Stage stage = *before;
        const Noise& noise = *input.object.noise;
        for (Part& part : stage.parts) {
            Mesh mesh = *part.mesh();
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                std::minstd_rand random(static_cast<unsigned>(noise.seed) +
                                        48271u * mesh.point(static_cast<std::uint32_t>(v)));
                std::uniform_real_distribution<float> one(-1, 1);
                const glm::vec3 by(one(random), one(random), one(random));
                mesh.positions[v] += static_cast<float>(noise.amount / 2) * by;
            }
            part = {.rest = make_ref(std::move(mesh)), .to_world = part.to_world, .key = part.key};
        }
        return make_ref(std::move(stage));
    });
}

} // namespace trivar
