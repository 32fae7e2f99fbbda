// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/layered_cap.h"

#include "core/plane/triangulation.h"
#include "core/split/loop_layers.h"

#include <algorithm>
#include <map>
#include <set>

namespace trivar {

PlaneGrid grid_of(const std::vector<const RimLoop*>& loops, const std::vector<glm::dvec2>& places)
{
    glm::dvec2 lo(1e300), hi(-1e300);
    for (const RimLoop* loop : loops)
        for (const std::uint32_t place : *loop) {
            lo = glm::min(lo, places[place]);
            hi = glm::max(hi, places[place]);
        }
    return {lo, hi};
}

namespace {

constexpr std::uint32_t no_vertex = 0xffffffff;

// Makes the vertices and triangles of a cap in layers.
class LayeredCap {
public:
    LayeredCap(const std::vector<const RimLoop*>& loops, const CapOptions& options, FlatCap& cap)
        : options_(options),
          cap_(cap),
          grid_(grid_of(loops, options.places))
    {
        std::vector<std::vector<glm::ivec2>> on_grid;
        for (const RimLoop* loop : loops) {
            std::vector<glm::ivec2>& points = on_grid.emplace_back();
            for (std::size_t i = 0; i < loop->size(); ++i) {
                points.push_back(grid_.at(options.places[(*loop)[i]]));
                edges_.push_back({(*loop)[i], (*loop)[(i + 1) % loop->size()]});
            }
        }
        layers_ = layers_of(on_grid);
    }
    bool make()
    {
        if (!layers_) return false;
        take_places();
        std::set<int> layers;
        for (const auto& steps : layers_->edges)
            for (const LoopLayers::Step& step : steps)
                if (step.layer != 0) layers.insert(step.layer);
        for (const int layer : layers)
            if (!fill(layer)) return false;
        for (std::size_t e = 0; e < edges_.size(); ++e) lead(e);
        join_copies();
        return true;
    }

private:
    using Copy = std::pair<std::uint32_t, int>; // of a point, in a layer

    // Where one place is all that lies at a point, in one layer, it is its copy
    // in that layer.
    void take_places()
    {
        struct Found {
            std::set<std::uint32_t> places;
            std::set<int> layers;
            std::size_t arriving = 0;
        };
        std::vector<Found> at(layers_->points.size());
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const std::vector<LoopLayers::Step>& steps = layers_->edges[e];
            for (const LoopLayers::Step& step : steps) {
                at[step.from].layers.insert(step.layer);
                at[step.to].layers.insert(step.layer);
                ++at[step.to].arriving;
            }
            if (steps.empty()) continue;
            at[steps.front().from].places.insert(edges_[e].first);
            at[steps.back().to].places.insert(edges_[e].second);
        }
        for (std::uint32_t p = 0; p < at.size(); ++p)
            if (at[p].places.size() == 1 && at[p].layers.size() == 1 && at[p].arriving == 1)
                copies_[{p, *at[p].layers.begin()}] = *at[p].places.begin();
    }
    std::uint32_t add_inside(const glm::dvec2& parameters)
    {
        cap_.inside.push_back(parameters);
        return static_cast<std::uint32_t>(options_.places.size() + cap_.inside.size() - 1);
    }
    std::uint32_t copy(std::uint32_t point, int layer)
    {
        const auto [found, is_new] = copies_.try_emplace({point, layer}, no_vertex);
        if (is_new) found->second = add_inside(grid_.point(layers_->points[point]));
        return found->second;
    }
    glm::dvec2 parameters(std::uint32_t vertex) const
    {
        return vertex < options_.places.size() ? options_.places[vertex]
                                               : cap_.inside[vertex - options_.places.size()];
    }
    // Triangulates a layer.
    bool fill(int layer)
    {
        Triangulation plane;
        std::vector<std::uint32_t> vertices; // by point of the plane
        std::map<std::uint32_t, int> known;
        const auto point = [&](std::uint32_t p) {
            const auto [found, is_new] = known.try_emplace(p, 0);
            if (is_new) {
                found->second = plane.insert(layers_->points[p]);
                vertices.push_back(copy(p, layer));
            }
            return found->second;
        };
        std::vector<std::pair<int, int>> rim; // what is inside lies to the left
        for (const auto& steps : layers_->edges)
            for (const LoopLayers::Step& step : steps) {
                if (step.layer != layer) continue;
                const int from = point(step.from), to = point(step.to);
                rim.push_back(layer > 0 ? std::pair(from, to) : std::pair(to, from));
            }
        for (const auto& [a, b] : rim)
            if (plane.join(a, b) != Triangulation::JoinResult::one_edge) return false;
        if (!plane.fill(rim)) return false;
        FlatTriangles flat;
        for (const std::uint32_t v : vertices) flat.points.push_back(parameters(v));
        for (const auto& [a, b, c] : plane.inside())
            flat.corners.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                    static_cast<std::uint32_t>(c)});
        if (options_.coarseness) make_fine_enough(flat, options_.coarseness, grid_.size / 1000);
        for (std::size_t p = vertices.size(); p < flat.points.size(); ++p)
            vertices.push_back(add_inside(flat.points[p]));
        for (const auto& t : flat.corners) {
            const std::uint32_t a = vertices[t[0]], b = vertices[t[1]], c = vertices[t[2]];
            cap_.triangles.push_back(layer > 0 ? std::array{a, b, c} : std::array{a, c, b});
        }
        return true;
    }
    // Slivers between an edge of the rim and its way through the layers.
    void lead(std::size_t edge)
    {
        std::vector<std::uint32_t> way{edges_[edge].first};
        std::uint32_t at = no_vertex; // the point of the last vertex
        const auto go = [&](std::uint32_t vertex, std::uint32_t point) {
            if (way.back() == vertex) return void(at = point);
            if (at == point) changes_[point].emplace_back(way.back(), vertex);
            way.push_back(vertex);
            at = point;
        };
        const std::vector<LoopLayers::Step>& steps = layers_->edges[edge];
        if (steps.empty()) { // all of it at one point
            const std::uint32_t point = point_of(edges_[edge].first);
            changes_[point].emplace_back(edges_[edge].first, edges_[edge].second);
            return;
        }
        at = steps.front().from;
        for (const LoopLayers::Step& step : steps) {
            go(copy(step.from, step.layer), step.from);
            go(copy(step.to, step.layer), step.to);
        }
        go(edges_[edge].second, steps.back().to);
        for (std::size_t i = way.size() - 1; i > 1; --i)
            cap_.triangles.push_back({way[0], way[i], way[i - 1]});
    }
    std::uint32_t point_of(std::uint32_t place) const
    {
        const glm::ivec2 at = grid_.at(options_.places[place]);
        return static_cast<std::uint32_t>(std::ranges::find(layers_->points, at) -
                                          layers_->points.begin());
    }
    // At each point the ways change from copy to copy. As many come to each copy
    // as leave it, so they are rings, which are filled by triangles without area;
    // those of two need none.
    void join_copies()
    {
        for (auto& [point, changes] : changes_) {
            std::multimap<std::uint32_t, std::uint32_t> leaving;
            for (const auto& [from, to] : changes) leaving.emplace(from, to);
            while (!leaving.empty()) {
                std::vector<std::uint32_t> way{leaving.begin()->first};
                while (true) {
                    const auto next = leaving.find(way.back());
                    if (next == leaving.end()) break; // it cannot be
                    const std::uint32_t to = next->second;
                    leaving.erase(next);
                    const auto before = std::ranges::find(way, to);
                    if (before == way.end()) {
                        way.push_back(to);
                        continue;
                    }
                    for (auto i = before + 1; i + 1 < way.end(); ++i)
                        cap_.triangles.push_back({*before, *i, *(i + 1)});
                    way.erase(before + 1, way.end());
                    if (way.size() == 1) break;
                }
            }
        }
    }

    const CapOptions& options_;
    FlatCap& cap_;
    PlaneGrid grid_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_; // of the rim, by places
    std::optional<LoopLayers> layers_;
    std::map<Copy, std::uint32_t> copies_; // vertices of the cap
    std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> changes_;
};

} // namespace

bool close_in_layers(const std::vector<const RimLoop*>& loops, const CapOptions& options,
                     FlatCap& cap)
{
    const FlatCap before{{}, cap.inside};
    const std::size_t triangles = cap.triangles.size();
    if (LayeredCap(loops, options, cap).make()) return true;
    cap.triangles.resize(triangles);
    cap.inside = before.inside;
    return false;
}

} // namespace trivar
