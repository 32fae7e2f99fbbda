// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/glb_instances.h"

#include "core/base/box.h"
#include "core/mesh/node_parts.h"

#include <algorithm>

namespace trivar {

WrittenInstances add_instances(GlbAccessors& to, const Model& model, const std::vector<int>& nodes)
{
    Box box;
    std::vector<NodeTransform> all;
    for (const int n : nodes) {
        all.push_back(*as_parts(model.nodes[static_cast<std::size_t>(n)].to_parent));
        box.add(all.back().translation);
    }
    WrittenInstances out{box.center(), {}};
    std::vector<glm::vec3> translations, scales;
    std::vector<glm::vec4> rotations; // x y z w
    for (const NodeTransform& each : all) {
        translations.emplace_back(each.translation - out.middle);
        const glm::dquat& q = each.rotation;
        rotations.emplace_back(q.x, q.y, q.z, q.w);
        scales.emplace_back(each.scale);
    }
    const int no_target = 0;
    out.attributes["TRANSLATION"] = to.add(translations, "VEC3", no_target);
    const auto is_not = [](const auto& neutral) {
        return [neutral](const auto& value) { return value != neutral; };
    };
    if (std::ranges::any_of(rotations, is_not(glm::vec4(0, 0, 0, 1))))
        out.attributes["ROTATION"] = to.add(rotations, "VEC4", no_target);
    if (std::ranges::any_of(scales, is_not(glm::vec3(1))))
        out.attributes["SCALE"] = to.add(scales, "VEC3", no_target);
    return out;
}

} // namespace trivar
