// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/control_places.h"

#include "core/base/joined_sets.h"
#include "core/simplex/cell_faces.h"

#include <algorithm>
#include <tuple>

namespace trivar {
namespace {

// The vertices whose knots a function takes, each as often as it takes them, ascending.
using Taken = std::array<int, max_simplex_degree>;

Taken taken(const std::array<int, 4>& cell, const MultiIndex<3>& index)
{
    Taken out;
    out.fill(-1);
    for (std::size_t k = 0; k < 4; ++k)
        for (int i = 0; i < index[k]; ++i) {
            std::size_t n = out.size() - 1; // the least comes first, after what is not taken
            while (n > 0 && out[n] > cell[k]) --n;
            for (std::size_t m = 0; m < n; ++m) out[m] = out[m + 1];
            out[n] = cell[k];
        }
    return out;
}

struct PlacedFunction {
    Taken taken;
    std::uint32_t part; // of the cells that take it: those joined by faces that are not cut
    int cell, point;
    auto key() const { return std::tie(taken, part, cell); }
};

bool has_all(const std::array<int, 3>& face, const Taken& taken)
{
    return std::ranges::all_of(
        taken, [&](int v) { return v < 0 || std::ranges::find(face, v) != face.end(); });
}

// Where nothing is cut, all cells that take the same knots are one part.
std::vector<PlacedFunction> functions_of(const SimplexBasis<3>& layer)
{
    const SimplexDomain<3>& domain = layer.domain();
    const auto indices = multi_indices<3>(domain.degree);
    std::vector<PlacedFunction> out;
    out.reserve(domain.cells.size() * indices.size());
    for (std::size_t c = 0; c < domain.cells.size(); ++c)
        for (std::size_t i = 0; i < indices.size(); ++i)
            out.push_back(
                {taken(domain.cells[c], indices[i]), 0, static_cast<int>(c), layer.point_of(c, i)});
    if (domain.cuts.empty()) return out;
    JoinedSets sets(out.size());
    const std::vector<CellFace<3>> faces = sorted_faces(domain);
    for (std::size_t f = 0; f + 1 < faces.size(); ++f) {
        if (faces[f].vertices != faces[f + 1].vertices ||
            std::binary_search(domain.cuts.begin(), domain.cuts.end(), faces[f].vertices))
            continue;
        const std::size_t a = faces[f].cell * indices.size(),
                          b = faces[f + 1].cell * indices.size();
        for (std::size_t i = 0; i < indices.size(); ++i)
            if (has_all(faces[f].vertices, out[a + i].taken))
                for (std::size_t j = 0; j < indices.size(); ++j)
                    if (out[b + j].taken == out[a + i].taken)
                        sets.join(static_cast<std::uint32_t>(a + i),
                                  static_cast<std::uint32_t>(b + j));
    }
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i].part = sets.root(static_cast<std::uint32_t>(i));
    return out;
}

// Also sorts and thins out the numbers of its points.
void finish(ControlPlace& place, const SimplexBasis<3>& layer)
{
    std::sort(place.points.begin(), place.points.end());
    place.points.erase(std::unique(place.points.begin(), place.points.end()), place.points.end());
    place.rest = layer.rest()[static_cast<std::size_t>(place.points.front())];
    const SimplexDomain<3>& domain = layer.domain();
    const std::size_t per_cell = multi_indices<3>(domain.degree).size();
    double edge = 1e300, spacing = 1e300;
    for (const int cell : place.cells) {
        const auto corner = corners(domain, static_cast<std::size_t>(cell));
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = a + 1; b < 4; ++b)
                edge = std::min(edge, glm::distance(corner[a], corner[b]));
        for (std::size_t i = 0; i < per_cell; ++i) {
            const int point = layer.point_of(static_cast<std::size_t>(cell), i);
            const double away =
                glm::distance(place.rest, layer.rest()[static_cast<std::size_t>(point)]);
            if (away > 1e-6 * edge) spacing = std::min(spacing, away);
        }
    }
    place.spacing = spacing < 1e300 ? spacing : edge;
}

glm::dvec3 into_cells(const ControlPlace& place, const SimplexDomain<3>& domain)
{
    const auto corner = corners(domain, static_cast<std::size_t>(place.cells.front()));
    return glm::normalize((corner[0] + corner[1] + corner[2] + corner[3]) / 4.0 - place.rest);
}

} // namespace

std::vector<ControlPlace> control_places(const SimplexBasis<3>& layer)
{
    std::vector<PlacedFunction> functions = functions_of(layer);
    std::ranges::sort(functions, {}, &PlacedFunction::key);
    std::vector<ControlPlace> out;
    std::size_t same_knots = 0; // the first place with the same knots
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const PlacedFunction& f = functions[i];
        const bool other_knots = i == 0 || f.taken != functions[i - 1].taken;
        if (other_knots || f.part != functions[i - 1].part) {
            if (other_knots) same_knots = out.size();
            out.emplace_back();
        }
        out.back().points.push_back(f.point);
        out.back().cells.push_back(f.cell);
        const bool last = i + 1 == functions.size() || functions[i + 1].taken != f.taken;
        if (!last) continue;
        for (std::size_t p = same_knots; p < out.size(); ++p) {
            finish(out[p], layer);
            if (out.size() - same_knots > 1) out[p].inward = into_cells(out[p], layer.domain());
        }
    }
    return out;
}

TetrahedraPull pull_of(const std::vector<ControlPlace>& places, const std::vector<int>& chosen,
                       double radius)
{
    std::vector<bool> among(places.size(), false);
    for (const int i : chosen) among[static_cast<std::size_t>(i)] = true;
    double nearest = 1e300;
    for (const int i : chosen) {
        const ControlPlace& one = places[static_cast<std::size_t>(i)];
        nearest = std::min(nearest, one.spacing);
        for (std::size_t j = 0; j < places.size(); ++j)
            if (const double away = glm::distance(one.rest, places[j].rest);
                !among[j] && away > 1e-6 * one.spacing)
                nearest = std::min(nearest, away);
    }
    constexpr double alone = 0.4, off = 1e-4; // of the distance to the nearest other place
    TetrahedraPull out{.radius = radius > 0 ? radius : alone * nearest, .decay = Decay::box};
    for (const int i : chosen) {
        const ControlPlace& one = places[static_cast<std::size_t>(i)];
        out.also.push_back(one.rest + one.inward * (off * std::min(nearest, out.radius)));
    }
    out.at = out.also.front();
    out.also.erase(out.also.begin());
    return out;
}

} // namespace trivar
