// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_nodes.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// Throws Rejected for numbers so large that their products would overflow.
void check_range(const GltfEntry& node, const char* name, const std::vector<double>& values)
{
    for (const double value : values)
        if (!(std::abs(value) <= most_coordinate))
            node.fail(fmt::format("'{}' has the number {}, but numbers up to {} are allowed", name,
                                  number_text(value), number_text(most_coordinate)));
}

glm::dmat4 affine_matrix(const GltfEntry& node, const std::vector<double>& values)
{
    glm::dmat4 out;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) out[c][r] = values[static_cast<std::size_t>(4 * c + r)];
    constexpr double rounded = 1e-6;
    for (int c = 0; c < 4; ++c) {
        const double wanted = c == 3 ? 1 : 0;
        if (!(std::abs(out[c][3] - wanted) <= rounded))
            node.fail("'matrix' is not affine: its numbers 3, 7, 11 and 15, counted from 0, must "
                      "be 0, 0, 0 and 1");
        out[c][3] = wanted;
    }
    return out;
}

// Sets the transform of a node; false if its rotation is four zeros, which is no rotation.
bool place(Node& to, const GltfEntry& from)
{
    const std::vector<double> matrix = from.numbers("matrix", 16);
    check_range(from, "matrix", matrix);
    if (!matrix.empty()) {
        to.to_parent = to.outer = affine_matrix(from, matrix);
        return true;
    }
    const auto read = [&](const char* name, std::size_t count) {
        std::vector<double> values = from.numbers(name, count);
        check_range(from, name, values);
        return values;
    };
    if (const auto t = read("translation", 3); !t.empty()) to.rest.translation = {t[0], t[1], t[2]};
    if (const auto s = read("scale", 3); !s.empty()) to.rest.scale = {s[0], s[1], s[2]};
    bool turns = true;
    if (const auto r = read("rotation", 4); !r.empty()) {
        const glm::dquat turn(r[3], r[0], r[1], r[2]);
        turns = glm::length(turn) > least_rotation;
        if (turns) to.rest.rotation = glm::normalize(turn);
    }
    to.to_parent = to.rest.matrix();
    return turns;
}

class NodeReader {
public:
    NodeReader(GltfFile& file, CountedNotices& notices)
        : file_(file),
          root_(file.root()),
          notices_(notices)
    {
    }

    GltfNodes read()
    {
        constexpr std::size_t node_bytes = 800; // including the memory of posing
        file_.account(root_, root_.count("nodes") + root_.count("meshes"), "nodes and meshes",
                      node_bytes);
        GltfNodes out = that_show_something();
        notices_.add("the rotation of one node is all zeros and turns nothing",
                     "the rotations of {0} nodes are all zeros and turn nothing", turnless_);
        notices_.add("one weight of a morph target is beyond a million, and counts as none",
                     "{0} weights of morph targets are beyond a million, and count as none",
                     heavy_);
        return out;
    }

private:
    GltfNodes that_show_something()
    {
        const std::size_t meshes = root_.count("meshes"), scenes = root_.count("scenes");
        GltfNodes out = below(scenes > 0 ? roots_of_scene() : parentless());
        if (shows_a_mesh(out) || meshes == 0) return out;
        if (scenes > 0)
            if (GltfNodes all = below(parentless()); shows_a_mesh(all)) {
                notices_.say("its scene shows no mesh: all of its nodes were read instead");
                return all;
            }
        for (std::size_t m = 0; m < meshes; ++m) {
            Node& node = out.nodes.emplace_back();
            node.name = root_.item("meshes", "mesh", m).text("name");
            node.mesh = static_cast<int>(m);
        }
        notices_.add(
            "none of its nodes shows its mesh, so the mesh was added without a node",
            "none of its nodes shows any of its {0} meshes, so the meshes were added without nodes",
            meshes);
        return out;
    }

    static bool shows_a_mesh(const GltfNodes& nodes)
    {
        return std::ranges::any_of(nodes.nodes, [](const Node& node) { return node.mesh >= 0; });
    }

    std::vector<int> roots_of_scene()
    {
        const std::size_t count = root_.count("scenes"), named = root_.size("scene");
        if (named >= count)
            notices_.say(fmt::format(
                "the default scene, {}, does not exist: the first of its {} scenes was read", named,
                count));
        else if (count > 1 && root_.has("scene"))
            notices_.say(
                fmt::format("of its {} scenes only number {} was read, which is the default one",
                            count, named + 1));
        else if (count > 1)
            notices_.say(fmt::format("of its {} scenes only the first was read", count));
        return root_.item("scenes", "scene", named < count ? named : 0).indices("nodes");
    }

    std::vector<int> parentless() const
    {
        std::vector<bool> child(root_.count("nodes"), false);
        root_.each("nodes", "node", [&](const GltfEntry& node) {
            for (const int index : node.indices("children"))
                if (index >= 0 && static_cast<std::size_t>(index) < child.size())
                    child[static_cast<std::size_t>(index)] = true;
        });
        std::vector<int> out;
        for (std::size_t i = 0; i < child.size(); ++i)
            if (!child[i]) out.push_back(static_cast<int>(i));
        return out;
    }

    // Visits nodes depth first, without recursion, so that a parent comes before its children.
    GltfNodes below(const std::vector<int>& roots)
    {
        struct Visit {
            int node, parent;
        };
        std::vector<Visit> stack;
        const auto push = [&](const std::vector<int>& nodes, int parent, const std::string& where) {
            for (std::size_t i = nodes.size(); i-- > 0;) {
                if (nodes[i] < 0 || static_cast<std::size_t>(nodes[i]) >= root_.count("nodes"))
                    root_.fail(fmt::format("{} names node {}, which is not there: it has {}", where,
                                           nodes[i], root_.count("nodes")));
                stack.push_back({nodes[i], parent});
            }
        };
        turnless_ = heavy_ = 0;
        push(roots, -1, "its scene");
        GltfNodes out;
        out.node_of.assign(root_.count("nodes"), -1);
        out.nodes.reserve(root_.count("nodes"));
        while (!stack.empty()) {
            const Visit visit = stack.back();
            stack.pop_back();
            const auto index = static_cast<std::size_t>(visit.node);
            const GltfEntry from = root_.item("nodes", "node", index);
            if (out.node_of[index] >= 0)
                from.fail("it has two parents or is its own ancestor, but nodes must form trees");
            const int self = static_cast<int>(out.nodes.size());
            out.node_of[index] = self;
            out.nodes.push_back(node_of(from, visit.parent));
            push(from.indices("children"), self, from.place());
        }
        return out;
    }

    Node node_of(const GltfEntry& from, int parent)
    {
        Node out;
        out.name = from.text("name");
        out.parent = parent;
        if (!place(out, from)) ++turnless_;
        out.mesh = from.index("mesh");
        if (out.mesh < 0) return out;
        const GltfEntry mesh = file_.named(from, "mesh", "meshes", "mesh");
        if (out.name.empty()) out.name = mesh.text("name");
        constexpr double most = 1e6;
        for (const double weight : (from.count("weights") > 0 ? from : mesh).numbers("weights")) {
            const bool light = std::abs(weight) <= most;
            out.morph_weights.push_back(light ? static_cast<float>(weight) : 0.0f);
            if (!light) ++heavy_;
        }
        return out;
    }

    GltfFile& file_;
    const GltfEntry& root_;
    CountedNotices& notices_;
    std::size_t turnless_ = 0, heavy_ = 0; // of the nodes that were read last
};

} // namespace

GltfNodes gltf_nodes(GltfFile& file, CountedNotices& notices)
{
    return NodeReader(file, notices).read();
}

} // namespace trivar
