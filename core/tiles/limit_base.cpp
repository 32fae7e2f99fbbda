// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/limit_base.h"

#include "core/limit/geodesic.h"
#include "core/limit/shared_nodes.h"

#include <algorithm>

namespace trivar {
namespace {

// The cells of charts are as many as keep the triangles below this number.
constexpr std::size_t most_limit_triangles = 400'000;

double even_share(int step, int count)
{
    return static_cast<double>(step) / count;
}

// Returns the face of a cage for each chart: the chart itself, or, where charts are the corners of
// faces, the face that has the corner.
std::vector<std::uint32_t> faces_of_charts(const Mesh& cage, std::size_t charts)
{
    std::vector<std::uint32_t> out;
    for (std::uint32_t f = 0; f < cage.face_count(); ++f)
        out.insert(out.end(),
                   charts == cage.face_count() ? 1 : cage.face_begin[f + 1] - cage.face_begin[f],
                   f);
    return out;
}

// The triangles of some charts. Vertices lie chart by chart, row by row.
Mesh triangles_on(const LimitSurface& surface, std::uint32_t first, std::uint32_t last, int cells)
{
    const SharedNodes nodes(surface.net(),
                            std::vector<glm::ivec2>(surface.net().size(), glm::ivec2(cells)));
    Mesh mesh;
    std::vector<std::uint32_t> number(nodes.size(), ~0u);
    std::uint32_t points = 0;
    std::vector<glm::vec3> point_position;
    for (std::uint32_t c = first; c < last; ++c)
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                std::uint32_t& point = number[nodes.node(c, i, j)];
                if (point == ~0u) {
                    point = points++;
                    point_position.emplace_back(
                        surface.position({c, {even_share(i, cells), even_share(j, cells)}}));
                }
                mesh.points.push_back(point);
                mesh.positions.push_back(point_position[point]);
            }
    const auto row = static_cast<std::uint32_t>(cells + 1);
    for (std::uint32_t c = 0; c < last - first; ++c)
        for (std::uint32_t j = 0; j + 1 < row; ++j)
            for (std::uint32_t i = 0; i + 1 < row; ++i) {
                const std::uint32_t v = (c * row + j) * row + i;
                add_face(mesh, std::array{v, v + 1, v + row + 1});
                add_face(mesh, std::array{v, v + row + 1, v + row});
            }
    return mesh;
}

} // namespace

LimitBase::LimitBase(std::span<const Piece> pieces)
    : LimitBase(pieces, [&] {
          std::vector<Mesh> out;
          for (const Piece& piece : pieces) out.push_back(ready_to_subdivide(*piece.cage));
          return out;
      }())
{
}

LimitBase::LimitBase(std::span<const Piece> pieces, const std::vector<Mesh>& ready)
    : cages_([&] {
          std::vector<Cage> each;
          for (std::size_t k = 0; k < pieces.size(); ++k)
              each.push_back(cage_of(ready[k], pieces[k].to_model));
          return joined(each);
      }()),
      surface_(cages_.cage)
{
    for (cells_ = 8; cells_ > 1; cells_ /= 2)
        if (surface_.net().size() * 2 * static_cast<std::size_t>(cells_ * cells_) <=
            most_limit_triangles)
            break;
    std::vector<TileBase::Piece> on_it;
    const auto per_chart = static_cast<std::size_t>(2 * cells_ * cells_);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const std::uint32_t first = cages_.first_chart[k], last = cages_.first_chart[k + 1];
        Mesh mesh = triangles_on(surface_, first, last, cells_);
        std::vector<std::uint32_t> faces;
        for (const std::uint32_t face : faces_of_charts(ready[k], last - first))
            faces.insert(faces.end(), per_chart, face);
        if (!ready[k].face_material.empty())
            for (const std::uint32_t face : faces)
                mesh.face_material.push_back(ready[k].face_material[face]);
        on_it.push_back({std::make_shared<const RayMesh>(make_ref(std::move(mesh))), glm::dmat4(1),
                         make_ref(std::move(faces))});
    }
    triangles_ = std::make_unique<const TileBase>(std::move(on_it));
}

ChartPlace LimitBase::place(const SurfacePlace& at) const
{
    const std::uint32_t piece = triangles_->piece_of(at.triangle);
    const glm::uvec3& vertices =
        triangles_->pieces()[piece]
            .mesh->triangles()[at.triangle - triangles_->first_triangle(piece)];
    const auto row = static_cast<std::uint32_t>(cells_ + 1);
    ChartPlace near{cages_.first_chart[piece] + vertices.x / (row * row)};
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = vertices[k] % (row * row);
        near.uv += at.weights[k] * glm::dvec2(v % row, v / row) / static_cast<double>(cells_);
    }
    near.uv = glm::clamp(near.uv, 0.0, 1.0);
    const double tolerance = 1e-9 * surface_.diagonal();
    return foot_point(surface_, near, triangles_->position(at), tolerance).at;
}

} // namespace trivar
