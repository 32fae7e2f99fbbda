// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/shared_nodes.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace trivar {
namespace {

int steps_along(const glm::ivec2& counts, int edge)
{
    return edge % 2 == 0 ? counts.x : counts.y;
}

bool comes_first(std::uint32_t chart, int edge, const ChartNet::Side& other)
{
    return other.chart == ChartNet::none ||
           std::pair(chart, edge) < std::pair(other.chart, other.edge);
}

} // namespace

SharedNodes::SharedNodes(const ChartNet& net, std::vector<glm::ivec2> counts)
    : counts_(std::move(counts)),
      points_(net.size()),
      edges_(net.size()),
      inner_(net.size())
{
    const auto charts = static_cast<std::uint32_t>(net.size());
    for (std::uint32_t c = 0; c < charts; ++c) {
        points_[c] = net.chart(c).points;
        for (const std::uint32_t p : points_[c]) size_ = std::max(size_, p + 1);
    }
    for (std::uint32_t c = 0; c < charts; ++c)
        for (int e = 0; e < 4; ++e) {
            const ChartNet::Side& other = net.across(c, e);
            Edge& edge = edges_[c][static_cast<std::size_t>(e)];
            edge.is_point = other.chart == ChartNet::none && net.point(c, e) == net.point(c, e + 1);
            if (edge.is_point) continue;
            if (!comes_first(c, e, other)) {
                edge = edges_[other.chart][static_cast<std::size_t>(other.edge)];
                edge.backwards = true;
                continue;
            }
            edge.first = size_;
            size_ += static_cast<std::uint32_t>(steps_along(counts_[c], e) - 1);
        }
    for (std::uint32_t c = 0; c < charts; ++c) {
        inner_[c] = size_;
        size_ += static_cast<std::uint32_t>((counts_[c].x - 1) * (counts_[c].y - 1));
    }
}

std::uint32_t SharedNodes::on_edge_of(std::uint32_t chart, int edge, int step) const
{
    const int steps = steps_along(counts_[chart], edge);
    const Edge& e = edges_[chart][static_cast<std::size_t>(edge)];
    if (step == 0 || e.is_point) return points_[chart][static_cast<std::size_t>(edge)];
    if (step == steps) return points_[chart][static_cast<std::size_t>((edge + 1) % 4)];
    return e.first + static_cast<std::uint32_t>(e.backwards ? steps - step - 1 : step - 1);
}

std::uint32_t SharedNodes::node(std::uint32_t chart, int i, int j) const
{
    const glm::ivec2& n = counts_[chart];
    if (j == 0) return on_edge_of(chart, 0, i);
    if (i == n.x) return on_edge_of(chart, 1, j);
    if (j == n.y) return on_edge_of(chart, 2, n.x - i);
    if (i == 0) return on_edge_of(chart, 3, n.y - j);
    return inner_[chart] + static_cast<std::uint32_t>((j - 1) * (n.x - 1) + i - 1);
}

std::vector<SurfacePoint> points_at(const ChartSurface& surface, const SharedNodes& nodes,
                                    ShareOfStep share)
{
    const auto charts = static_cast<std::uint32_t>(surface.net().size());
    std::vector<SurfacePoint> out(nodes.size());
    const auto place = [&](std::uint32_t c, int i, int j) {
        const glm::ivec2& n = nodes.counts(c);
        return ChartPlace{c, {share(i, n.x), share(j, n.y)}};
    };
    parallel_blocks(charts, 16, [&](std::size_t begin, std::size_t end) {
        for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c)
            for (int j = 1; j < nodes.counts(c).y; ++j)
                for (int i = 1; i < nodes.counts(c).x; ++i) {
                    const ChartPlace at = place(c, i, j);
                    out[nodes.node(c, i, j)] = {surface.position(at), surface.normal(at)};
                }
    });
    // Finds the nodes that charts share, in order of charts.
    std::vector<char> met(nodes.size(), 0);
    std::vector<glm::dvec3> first_normal(nodes.size());
    std::vector<std::uint32_t> shared;
    for (std::uint32_t c = 0; c < charts; ++c) {
        const glm::ivec2& n = nodes.counts(c);
        const auto meet = [&](int i, int j) {
            const std::uint32_t id = nodes.node(c, i, j);
            const ChartPlace at = place(c, i, j);
            const glm::dvec3 normal = surface.normal(at);
            if (met[id]) {
                out[id].normal += normal;
                return;
            }
            met[id] = 1;
            shared.push_back(id);
            first_normal[id] = normal;
            out[id] = {surface.position(at), normal};
        };
        for (int i = 0; i <= n.x; ++i) {
            meet(i, 0);
            meet(i, n.y);
        }
        for (int j = 1; j < n.y; ++j) {
            meet(0, j);
            meet(n.x, j);
        }
    }
    for (const std::uint32_t id : shared) {
        const double length = glm::length(out[id].normal);
        out[id].normal = length > 1e-3 ? out[id].normal / length : first_normal[id];
    }
    return out;
}

} // namespace trivar
