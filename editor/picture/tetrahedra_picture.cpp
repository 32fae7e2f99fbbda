// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/tetrahedra_picture.h"

#include "core/simplex/cell_faces.h"
#include "core/simplex/simplex_rows.h"
#include "core/tetrahedra/pulling.h"
#include "core/tetrahedra/tetrahedra_shaper.h"

#include <algorithm>
#include <map>

namespace trivar {
namespace {

using Edge = std::pair<int, int>; // vertex numbers, ascending

Edge edge_of(int a, int b)
{
    return {std::min(a, b), std::max(a, b)};
}

std::vector<Edge> edges_of(std::span<const std::array<int, 4>> cells)
{
    std::vector<Edge> out;
    for (const auto& cell : cells)
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = a + 1; b < 4; ++b) out.push_back(edge_of(cell[a], cell[b]));
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::vector<Edge> border_edges(const SimplexDomain<3>& domain)
{
    std::vector<Edge> out;
    const std::vector<CellFace<3>> faces = sorted_faces(domain);
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (f + 1 < faces.size() && faces[f].vertices == faces[f + 1].vertices)
            ++f;
        else
            for (std::size_t i = 0; i < 3; ++i)
                out.push_back(edge_of(faces[f].vertices[i], faces[f].vertices[(i + 1) % 3]));
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

// The edges where the volume takes them, in the world.
std::vector<gpu::Line> bent_lines(const TetrahedraEffects& effects, const SimplexDomain<3>& domain,
                                  std::span<const Edge> edges, ui::Color color, float width)
{
    const SimplexVolume& volume = *effects.tetrahedra->volume;
    constexpr std::size_t most_pieces = 6000;
    const int pieces =
        static_cast<int>(std::clamp<std::size_t>(most_pieces / (edges.size() + 1), 1, 16));
    std::vector<glm::vec3> points;
    points.reserve(edges.size() * static_cast<std::size_t>(pieces + 1));
    for (const auto& [a, b] : edges)
        for (int i = 0; i <= pieces; ++i)
            points.emplace_back(
                glm::mix(domain.vertex(a), domain.vertex(b), static_cast<double>(i) / pieces));
    if (std::any_of(volume.displacements.begin(), volume.displacements.end(),
                    [](const glm::dvec3& d) { return d != glm::dvec3(0); }))
        points =
            SimplexRows(volume.layers, points, false).displaced(volume.displacements).positions;
    std::vector<gpu::Line> out;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        gpu::Line line{{}, ui::linear_light(color), width};
        for (int i = 0; i <= pieces; ++i)
            line.points.emplace_back(
                effects.tetrahedra_to_world *
                glm::dvec4(glm::dvec3(points[e * static_cast<std::size_t>(pieces + 1) +
                                             static_cast<std::size_t>(i)]),
                           1));
        out.push_back(std::move(line));
    }
    return out;
}

// The edges where the domain has them.
std::vector<gpu::Line> straight_lines(const SimplexDomain<3>& domain, std::span<const Edge> edges,
                                      const glm::dmat4& to_world, ui::Color color, float width_px)
{
    std::vector<gpu::Line> out;
    for (const auto& [a, b] : edges)
        out.push_back({{glm::dvec3(to_world * glm::dvec4(domain.vertex(a), 1)),
                        glm::dvec3(to_world * glm::dvec4(domain.vertex(b), 1))},
                       ui::linear_light(color),
                       width_px});
    return out;
}

void append(std::vector<gpu::Line>& to, std::vector<gpu::Line> more)
{
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<gpu::Line> edge_lines(const TetrahedraEffects& volume, const ui::Palette& color,
                                  float line_px, bool selected)
{
    std::vector<gpu::Line> out;
    const std::vector<Ref<SimplexBasis<3>>>& layers = volume.tetrahedra->volume->layers;
    const SimplexDomain<3>& domain = layers.front()->domain();
    const std::vector<Edge> border = border_edges(domain);
    append(out, bent_lines(volume, domain, border,
                           ui::faded(color.lattice, selected ? 0.75f : 0.3f), 1.3f * line_px));
    if (!selected) return out;
    std::vector<Edge> inner = edges_of(domain.cells), inside;
    std::set_difference(inner.begin(), inner.end(), border.begin(), border.end(),
                        std::back_inserter(inside));
    append(out, bent_lines(volume, domain, inside, ui::faded(color.lattice, 0.16f), line_px));
    constexpr std::size_t most_edges = 1500; // more are a fog
    for (std::size_t l = 1; l < layers.size(); ++l)
        if (const std::vector<Edge> rim = border_edges(layers[l]->domain());
            rim.size() <= most_edges)
            append(out, bent_lines(volume, layers[l]->domain(), rim,
                                   ui::faded(color.free_node, 0.3f), line_px));
    std::vector<Edge> cuts;
    for (const auto& face : domain.cuts)
        for (std::size_t i = 0; i < 3; ++i) cuts.push_back(edge_of(face[i], face[(i + 1) % 3]));
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    append(out, bent_lines(volume, domain, cuts, color.bad, 1.6f * line_px));
    return out;
}

} // namespace

const std::vector<gpu::Line>& TetrahedraLines::operator()(const TetrahedraEffects& volume,
                                                          const ui::Palette& color, float line_px,
                                                          bool selected)
{
    static const std::vector<gpu::Line> none;
    if (!volume.tetrahedra) return none;
    return known_({volume.tetrahedra, volume.tetrahedra_to_world,
                   Colors{color.lattice, color.free_node, color.bad}, line_px, selected},
                  [&] { return edge_lines(volume, color, line_px, selected); });
}

std::vector<gpu::Line> support_lines(const TetrahedraEffects& volume, const TetrahedraPull& pull,
                                     const ui::Palette& color, float line_px)
{
    if (!volume.tetrahedra) return {};
    const std::vector<Ref<SimplexBasis<3>>>& layers = volume.tetrahedra->volume->layers;
    if (pull.layer >= static_cast<int>(layers.size())) return {};
    const SimplexBasis<3>& layer = *layers[static_cast<std::size_t>(pull.layer)];
    std::vector<bool> moved(layer.point_count(), false);
    for (const glm::dvec3& ball : middles(pull)) {
        const std::vector<bool> reach = reached(layer, ball, pull.radius);
        for (std::size_t i = 0; i < moved.size(); ++i)
            if (reach[i] && glm::distance(layer.rest()[i], ball) < pull.radius) moved[i] = true;
    }
    const std::size_t per_cell = multi_indices<3>(layer.domain().degree).size();
    std::vector<std::array<int, 4>> cells;
    for (std::size_t c = 0; c < layer.domain().cells.size(); ++c)
        for (std::size_t i = 0; i < per_cell; ++i) {
            if (!moved[static_cast<std::size_t>(layer.point_of(c, i))]) continue;
            cells.push_back(layer.domain().cells[c]);
            break;
        }
    return bent_lines(volume, layer.domain(), edges_of(cells), ui::faded(color.sphere, 0.6f),
                      1.4f * line_px);
}

std::vector<gpu::Line> cell_lines(const SimplexDomain<3>& domain, std::span<const int> cells,
                                  const glm::dmat4& to_world, ui::Color color, float width_px)
{
    std::vector<std::array<int, 4>> some;
    for (const int c : cells) some.push_back(domain.cells[static_cast<std::size_t>(c)]);
    return straight_lines(domain, edges_of(some), to_world, color, width_px);
}

std::vector<gpu::Line> domain_lines(const TetrahedraEffects& volume, std::size_t layer,
                                    const ui::Palette& color, float line_px)
{
    if (!volume.tetrahedra || layer >= volume.tetrahedra->volume->layers.size()) return {};
    const SimplexDomain<3>& domain = volume.tetrahedra->volume->layers[layer]->domain();
    const std::vector<Edge> border = border_edges(domain), all = edges_of(domain.cells);
    std::vector<Edge> inside;
    std::set_difference(all.begin(), all.end(), border.begin(), border.end(),
                        std::back_inserter(inside));
    std::vector<gpu::Line> out =
        straight_lines(domain, border, volume.tetrahedra_to_world, color.focus, 1.6f * line_px);
    constexpr std::size_t most_inside = 1500; // more are a fog
    if (inside.size() <= most_inside)
        append(out, straight_lines(domain, inside, volume.tetrahedra_to_world,
                                   ui::faded(color.focus, 0.25f), line_px));
    return out;
}

} // namespace trivar
