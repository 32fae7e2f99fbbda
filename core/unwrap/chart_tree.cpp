// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unwrap/chart_tree.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <queue>
#include <tuple>

namespace trivar {

// Joins pairs of neighbours, the best ones first, for as long as the rules allow.
class ChartTree::Joining {
public:
    Joining(ChartTree& tree, const ManifoldSurface& surface, const ChartRules& rules,
            const Progress& progress)
        : nodes_(tree.nodes_),
          surface_(surface),
          least_straight_(std::pow(std::cos(rules.spread / 2), 2)),
          node_of_face_(surface.mesh().face_count(), none),
          seen_(surface.vertex_count(), none),
          progress_(progress)
    {
        take_faces();
        take_seams(rules);
        for (std::uint32_t node = 0, faces = count(); node < faces; ++node) {
            now_and_then(1);
            offer(node);
        }
        while (!best_.empty()) {
            const auto [cost, a, b] = best_.top();
            best_.pop();
            now_and_then(1 + nodes_[a].sides.size() + nodes_[b].sides.size());
            if (!nodes_[a].joined && !nodes_[b].joined && share_one_piece(a, b)) join(a, b);
        }
    }

private:
    // Reports after so much work: about a millisecond.
    void now_and_then(std::size_t work)
    {
        constexpr std::size_t between = 4096;
        if ((done_ += work) < between) return;
        done_ = 0;
        const auto all = 2 * static_cast<double>(surface_.mesh().face_count());
        report(progress_, static_cast<double>(nodes_.size()) / all, "charts");
    }
    std::uint32_t count() const { return static_cast<std::uint32_t>(nodes_.size()); }

    glm::dvec3 position(std::uint32_t corner) const
    {
        return surface_.mesh().positions[surface_.mesh().corners[corner]];
    }
    double length(std::uint32_t side) const
    {
        return glm::distance(position(side), position(surface_.adjacency().next(side)));
    }

    void take_faces()
    {
        const Mesh& mesh = surface_.mesh();
        nodes_.reserve(2 * mesh.face_count());
        for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
            if (!surface_.takes_part(f)) continue;
            now_and_then(1);
            Node node;
            node.face = f;
            node.turned = area_normal(mesh, f) / 2.0;
            node.area = glm::length(node.turned);
            for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
                node.sides.push_back(c);
                node.rim += length(c);
            }
            node_of_face_[f] = count();
            nodes_.push_back(std::move(node));
        }
        top_.resize(nodes_.size());
        for (std::uint32_t k = 0; k < count(); ++k) top_[k] = k;
    }

    void take_seams(const ChartRules& rules)
    {
        const Mesh& mesh = surface_.mesh();
        const double least = std::cos(rules.seam_angle);
        seam_.assign(mesh.corners.size(), 0);
        for (std::uint32_t s = 0; s < seam_.size(); ++s) {
            now_and_then(1);
            if (surface_.behind(s) == ManifoldSurface::none) continue;
            const std::uint32_t f = surface_.adjacency().face(s),
                                g = surface_.adjacency().face(surface_.behind(s));
            const Node &a = nodes_[node_of_face_[f]], &b = nodes_[node_of_face_[g]];
            const bool other_material =
                !mesh.face_material.empty() && mesh.face_material[f] != mesh.face_material[g];
            seam_[s] = other_material || glm::dot(a.turned, b.turned) < least * a.area * b.area;
        }
    }

    // The node that holds the face of a side now.
    std::uint32_t holder(std::uint32_t side)
    {
        std::uint32_t node = node_of_face_[surface_.adjacency().face(side)];
        while (top_[node] != node) node = top_[node] = top_[top_[node]];
        return node;
    }
    std::uint32_t behind(std::uint32_t side)
    {
        const std::uint32_t other = surface_.behind(side);
        return other == ManifoldSurface::none ? none : holder(other);
    }

    // Offers a node to its neighbours of smaller numbers.
    void offer(std::uint32_t node)
    {
        struct Common {
            std::uint32_t neighbour;
            double length;
            bool passable;
        };
        std::vector<Common> common;
        for (const std::uint32_t s : nodes_[node].sides)
            if (const std::uint32_t other = behind(s); other != none && other < node)
                common.push_back({other, length(s), !seam_[s]});
        std::ranges::stable_sort(common, {}, &Common::neighbour);
        for (std::size_t i = 0; i < common.size();) {
            const std::uint32_t other = common[i].neighbour;
            double shared = 0;
            bool passable = false;
            for (; i < common.size() && common[i].neighbour == other; ++i) {
                shared += common[i].length;
                passable |= common[i].passable;
            }
            if (passable) offer(other, node, shared);
        }
    }

    void offer(std::uint32_t a, std::uint32_t b, double shared)
    {
        // Worth of a round rim beside that of flatness.
        constexpr double round = 0.1;
        const double area = nodes_[a].area + nodes_[b].area;
        const double straight = glm::length(nodes_[a].turned + nodes_[b].turned);
        if (straight < least_straight_ * area) return;
        const double rim = nodes_[a].rim + nodes_[b].rim - 2 * shared;
        const double bent = area > 0 ? area - straight * straight / area : 0;
        best_.push({bent + round * (rim * rim / (4 * glm::pi<double>()) - area), a, b});
    }

    // Whether two disks have one piece of their rims in common, points included: the shared part
    // has one vertex more than edges.
    bool share_one_piece(std::uint32_t a, std::uint32_t b)
    {
        for (const std::uint32_t s : nodes_[a].sides) seen_[surface_.vertex(s)] = stamp_;
        int pieces = 0;
        for (const std::uint32_t s : nodes_[b].sides) {
            pieces += seen_[surface_.vertex(s)] == stamp_;
            pieces -= behind(s) == a;
        }
        ++stamp_;
        return pieces == 1;
    }

    void join(std::uint32_t a, std::uint32_t b)
    {
        Node node;
        node.left = a;
        node.right = b;
        node.turned = nodes_[a].turned + nodes_[b].turned;
        node.area = nodes_[a].area + nodes_[b].area;
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
            for (const std::uint32_t s : nodes_[from].sides)
                if (behind(s) != to) {
                    node.sides.push_back(s);
                    node.rim += length(s);
                }
        for (const std::uint32_t part : {a, b}) {
            nodes_[part].joined = true;
            nodes_[part].sides = {};
            top_[part] = count();
        }
        top_.push_back(count());
        nodes_.push_back(std::move(node));
        offer(count() - 1);
    }

    using Offer = std::tuple<double, std::uint32_t, std::uint32_t>; // cost and both nodes
    struct Later {
        bool operator()(const auto& x, const auto& y) const { return x > y; }
    };
    std::vector<Node>& nodes_;
    const ManifoldSurface& surface_;
    double least_straight_;
    std::vector<std::uint32_t> node_of_face_;
    std::vector<std::uint32_t> top_;  // by node: one that holds it, or itself
    std::vector<std::uint32_t> seen_; // by vertex: when it was seen last
    std::uint32_t stamp_ = 0;
    std::vector<char> seam_; // by side
    const Progress& progress_;
    std::size_t done_ = 0; // since the last report
    std::priority_queue<Offer, std::vector<Offer>, Later> best_;
};

ChartTree::ChartTree(const ManifoldSurface& surface, const ChartRules& rules,
                     const Progress& progress)
{
    Joining(*this, surface, rules, progress);
    for (std::uint32_t node = 0; node < nodes_.size(); ++node)
        if (!nodes_[node].joined) charts_.push_back(node);
}

std::vector<std::uint32_t> ChartTree::faces(std::uint32_t node) const
{
    std::vector<std::uint32_t> out;
    std::vector<std::uint32_t> open{node};
    while (!open.empty()) {
        const Node& each = nodes_[open.back()];
        open.pop_back();
        if (each.left == none)
            out.push_back(each.face);
        else
            open.insert(open.end(), {each.left, each.right});
    }
    std::ranges::sort(out);
    return out;
}

} // namespace trivar
