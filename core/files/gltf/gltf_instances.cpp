// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_instances.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// Largest number of vertices of all instances; placed on a stroke, each is a vertex of its own.
constexpr std::size_t most_instanced_vertices = 64'000'000;

// The places of the instances of one node, attribute by attribute.
class Places {
public:
    Places(const GltfEntry& attributes, GltfAccessors& accessors)
        : attributes_(attributes),
          accessors_(accessors),
          translations_(table("TRANSLATION", 3)),
          rotations_(table("ROTATION", 4)),
          scales_(table("SCALE", 3))
    {
    }

    std::size_t count() const { return count_.value_or(0); }

    // Sets the transform of a node to that of an instance; false if its rotation is four zeros.
    bool place(Node& to, std::size_t instance) const
    {
        const auto number = [&](const GltfAccessors::Table& from, std::size_t c) {
            return static_cast<double>(from.values[instance * from.components + c]);
        };
        const auto three = [&](const GltfAccessors::Table& from) {
            return glm::dvec3(number(from, 0), number(from, 1), number(from, 2));
        };
        bool turns = true;
        if (translations_.count > 0) to.rest.translation = three(translations_);
        if (scales_.count > 0) to.rest.scale = three(scales_);
        if (rotations_.count > 0) {
            const glm::dquat turn(number(rotations_, 3), number(rotations_, 0),
                                  number(rotations_, 1), number(rotations_, 2));
            turns = glm::length(turn) > least_rotation;
            if (turns) to.rest.rotation = glm::normalize(turn);
        }
        to.to_parent = to.rest.matrix();
        return turns;
    }

private:
    GltfAccessors::Table table(const char* name, std::size_t components)
    {
        if (!attributes_.has(name)) return {};
        GltfAccessors::Table out = accessors_.floats(attributes_, name);
        if (out.components != components)
            attributes_.fail(fmt::format("'{}' has {} numbers per instance, but must have {}", name,
                                         out.components, components));
        if (out.not_finite > 0)
            attributes_.fail(fmt::format("'{}' has a number that is not finite", name));
        for (const float value : out.values)
            if (!(std::abs(static_cast<double>(value)) <= most_coordinate))
                attributes_.fail(fmt::format("'{}' has the number {}, but numbers up to {} are "
                                             "allowed",
                                             name, number_text(value),
                                             number_text(most_coordinate)));
        if (count_.value_or(out.count) != out.count)
            attributes_.fail(fmt::format("'{}' places {} instances, another attribute {}; all must "
                                         "place as many",
                                         name, out.count, *count_));
        count_ = out.count;
        return out;
    }

    const GltfEntry& attributes_;
    GltfAccessors& accessors_;
    std::optional<std::size_t> count_; // before the tables, which set it
    GltfAccessors::Table translations_, rotations_, scales_;
};

} // namespace

std::size_t add_gltf_instances(GltfNodes& nodes, GltfAccessors& accessors, CountedNotices& notices)
{
    const std::size_t before = nodes.nodes.size();
    std::size_t turnless = 0;
    accessors.file().root().each(
        "nodes", "node", [&, i = std::size_t{0}](const GltfEntry& from) mutable {
            const int at = nodes.node_of.at(i++);
            if (at < 0 || from.index("mesh") < 0) return;
            const auto extensions = from.part("extensions");
            const auto instancing =
                extensions ? extensions->part("EXT_mesh_gpu_instancing") : std::nullopt;
            if (!instancing) return;
            if (from.index("skin") >= 0)
                return notices.add("instances of a mesh with a skin are shown once",
                                   "instances of {0} meshes with skins are shown once");
            const GltfEntry attributes = instancing->needed_part("attributes");
            const Places places(attributes, accessors);
            if (places.count() == 0)
                return notices.add("one node has instances without places: its mesh is shown once",
                                   "{0} nodes have instances without places: their meshes are "
                                   "shown once");
            Node shown = nodes.nodes[static_cast<std::size_t>(at)]; // the list grows
            constexpr std::size_t node_bytes = 800; // including the memory of posing
            accessors.file().account(*instancing, places.count(), "instances",
                                     node_bytes + sizeof(float) * shown.morph_weights.size());
            Node& parent = nodes.nodes[static_cast<std::size_t>(at)];
            parent.mesh = -1;
            parent.morph_weights.clear();
            shown.parent = at;
            shown.outer = glm::dmat4(1);
            for (std::size_t k = 0; k < places.count(); ++k) {
                shown.rest = {};
                if (!places.place(shown, k)) ++turnless;
                nodes.nodes.push_back(shown);
            }
        });
    notices.add("the rotation of one instance is all zeros and turns nothing",
                "the rotations of {0} instances are all zeros and turn nothing", turnless);
    return nodes.nodes.size() - before;
}

void check_instances(const Model& model, std::size_t instances, const std::string& file_name)
{
    std::size_t vertices = 0;
    for (std::size_t n = model.nodes.size() - instances; n < model.nodes.size(); ++n)
        if (const int mesh = model.nodes[n].mesh; mesh >= 0)
            vertices += model.meshes[static_cast<std::size_t>(mesh)]->vertex_count();
    if (vertices > most_instanced_vertices)
        throw Rejected(fmt::format("{}: its {} instances show {} vertices, but at most {} are "
                                   "allowed; use fewer instances or a simpler mesh",
                                   file_name, with_commas(instances), with_commas(vertices),
                                   with_commas(most_instanced_vertices)));
}

} // namespace trivar
