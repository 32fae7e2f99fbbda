// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/decimation.h"

#include "core/simplify/collapse_cost.h"
#include "core/simplify/half_edges.h"

#include <limits>
#include <optional>
#include <queue>
#include <tuple>

namespace trivar {
namespace {

// A Collapser applies the rules of OpenMesh for allowed collapses only to the next candidate. The
// decimater of OpenMesh checks all neighbours of a collapse, some 36 times per collapse.
class Collapser : private OpenMesh::Decimater::BaseDecimaterT<HalfEdges> {
public:
    Collapser(FanHalfEdges& surface, CollapseCost cost)
        : BaseDecimaterT(surface.half_edges()),
          surface_(surface),
          half_edges_(surface.half_edges()),
          cost_(std::move(cost)),
          looks_(half_edges_.n_vertices())
    {
    }

    void run(std::size_t triangles, const Progress& progress)
    {
        constexpr std::size_t report_every = 4096;
        const std::size_t before = half_edges_.n_faces();
        std::size_t left = before, collapses = 0;
        for (const auto node : half_edges_.vertices()) look_at(node, false);
        while (left > triangles && !next_.empty()) {
            const Next next = next_.top();
            next_.pop();
            const Look& look = looks_[static_cast<std::size_t>(next.node)];
            if (next.number != look.number) continue; // a newer look exists
            const Collapse c(half_edges_, HalfEdge(look.half_edge));
            const std::optional<double> cost = cost_(c, any_cost);
            if (!is_collapse_legal(c) || !cost || *cost > next.cost) {
                look_at(c.v0, true); // the goal has changed since the look
                continue;
            }
            collapse(c);
            left -= std::size_t{c.fl.is_valid()} + std::size_t{c.fr.is_valid()};
            if (++collapses % report_every == 0)
                report(progress,
                       static_cast<double>(before - left) / static_cast<double>(before - triangles),
                       "Simplifying");
        }
    }

private:
    struct Look {           // the last look at a node
        int half_edge = -1; // the best one to collapse
        std::uint32_t number = 0;
    };
    struct Next {
        double cost;
        int node;
        std::uint32_t number;                   // of the look
        bool operator<(const Next& other) const // the least cost is on top
        {
            return std::tie(other.cost, other.node) < std::tie(cost, node);
        }
    };

    void collapse(const Collapse& c)
    {
        round_.clear();
        for (const auto node : half_edges_.vv_range(c.v0)) round_.push_back(node);
        ++looks_[index(c.v0)].number;
        surface_.collapse(c);
        cost_.after(c);
        for (const HalfEdges::VertexHandle node : round_) look_at(node, false);
    }

    // Queues the best collapse of a node.
    void look_at(HalfEdges::VertexHandle node, bool only_legal)
    {
        Look& look = looks_[index(node)];
        look = {-1, look.number + 1};
        if (half_edges_.status(node).locked()) return;
        double best = any_cost;
        for (const auto h : half_edges_.voh_range(node)) {
            if (half_edges_.status(node).feature() && !surface_.is_rail(h)) continue;
            const Collapse c(half_edges_, h);
            const std::optional<double> cost = cost_(c, best);
            if (!cost || (only_legal && !is_collapse_legal(c))) continue;
            best = *cost;
            look.half_edge = h.idx();
        }
        if (look.half_edge >= 0) next_.push({best, node.idx(), look.number});
    }

    static constexpr double any_cost = std::numeric_limits<double>::infinity();
    FanHalfEdges& surface_;
    HalfEdges& half_edges_;
    CollapseCost cost_;
    std::vector<Look> looks_; // by node
    std::vector<HalfEdges::VertexHandle> round_;
    std::priority_queue<Next> next_;
};

} // namespace

Decimation decimated(const Mesh& mesh, const Fans& fans, const NodePlaces& places,
                     const DecimationTarget& target, const Progress& progress)
{
    FanHalfEdges surface(fans);
    Collapser(surface, CollapseCost(mesh, fans, surface, places, target.tolerance))
        .run(target.triangles, progress);
    return surface.result(fans);
}

} // namespace trivar
