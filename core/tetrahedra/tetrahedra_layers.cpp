// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/tetrahedra_layers.h"

#include "core/base/box.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/simplex/cell_faces.h"
#include "core/simplex/clouds.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

// Finds out whether a point is within the radius of one of some places: O(number of places that are
// as near along X).
class Nearby {
public:
    Nearby(std::vector<glm::dvec3> places, double radius)
        : places_(std::move(places)),
          radius_(radius)
    {
        std::ranges::sort(places_, {}, &glm::dvec3::x);
    }
    bool holds(const glm::dvec3& p) const
    {
        const double reach = radius_ + 1e-9 * (radius_ + std::abs(p.x)); // more than rounding takes
        for (auto at = std::ranges::lower_bound(places_, p.x - reach, {}, &glm::dvec3::x);
             at != places_.end() && at->x <= p.x + reach; ++at)
            if (glm::distance(*at, p) <= radius_) return true;
        return false;
    }

private:
    std::vector<glm::dvec3> places_;
    double radius_;
};

// Each face once: of two creases the deeper counts, and of two as deep the later one. One of depth
// 0 takes away those before it.
std::vector<Crease<3>> creases(const SimplexMesh<3>& mesh, const std::vector<TetrahedraEdit>& edits)
{
    std::vector<Crease<3>> out;
    std::map<std::array<int, 3>, std::size_t> known;
    std::vector<CellFace<3>> faces; // of all cells, once there is a crease
    for (const TetrahedraEdit& edit : edits) {
        if (!edit.crease) continue;
        if (faces.empty()) faces = sorted_faces(SimplexDomain<3>{1, {}, mesh.cells});
        const Nearby nearby(edit.crease->places, edit.crease->radius);
        for (const CellFace<3>& face : faces) {
            glm::dvec3 middle(0);
            for (const int v : face.vertices)
                middle += mesh.vertices[static_cast<std::size_t>(v)] / 3.0;
            if (!nearby.holds(middle)) continue;
            const Crease<3> crease{face.vertices, edit.crease->depth, edit.crease->seam};
            const auto [found, added] = known.try_emplace(face.vertices, out.size());
            if (added)
                out.push_back(crease);
            else if (crease.depth == 0 || crease.depth >= out[found->second].depth)
                out[found->second] = crease;
        }
    }
    std::erase_if(out, [](const Crease<3>& crease) { return crease.depth == 0; });
    return out;
}

// Returns the moves of knots that the edits ask for. An edit means the vertex within a millionth of
// the domain's size.
std::vector<CloudShift<3>> shifts(const SimplexMesh<3>& mesh,
                                  const std::vector<TetrahedraEdit>& edits)
{
    std::vector<CloudShift<3>> out;
    Box box;
    for (const TetrahedraEdit& edit : edits) {
        if (!edit.cloud) continue;
        if (box.empty())
            for (const glm::dvec3& v : mesh.vertices) box.add(v);
        const auto found = std::ranges::find_if(mesh.vertices, [&](const glm::dvec3& v) {
            return glm::distance(v, edit.cloud->at) <= 1e-6 * glm::length(box.size());
        });
        if (found != mesh.vertices.end())
            out.push_back({static_cast<int>(found - mesh.vertices.begin()), edit.cloud->knot,
                           edit.cloud->by, edit.cloud->factor});
    }
    return out;
}

void check_cells(const TetrahedraShape& shape)
{
    const int vertices = static_cast<int>(shape.vertices.size());
    if (shape.cells.size() > most_cells)
        throw Rejected(fmt::format("a volume has at most {} tetrahedra, not {}",
                                   with_commas(most_cells), with_commas(shape.cells.size())));
    for (const glm::ivec4& cell : shape.cells)
        for (int k = 0; k < 4; ++k)
            if (cell[k] < 0 || cell[k] >= vertices)
                throw Rejected(
                    fmt::format("a tetrahedron names vertex {} of {}", cell[k], vertices));
}

} // namespace

SimplexMesh<3> domain_cells(const TetrahedraShape& shape)
{
    if (shape.cells.empty()) {
        const double cells = 6.0 * shape.boxes.x * shape.boxes.y * shape.boxes.z;
        if (cells > static_cast<double>(most_cells))
            throw Rejected(fmt::format("a volume has at most {} tetrahedra, not {}",
                                       with_commas(most_cells), number_text(cells)));
        return box_cells(shape.size, shape.boxes);
    }
    check_cells(shape);
    SimplexMesh<3> out{shape.vertices, {}};
    for (const glm::ivec4& cell : shape.cells)
        out.cells.push_back({cell.x, cell.y, cell.z, cell.w});
    return out;
}

SimplexMesh<3> cells_near(const TetrahedraRefinement& refinement)
{
    if (refinement.places.empty()) throw Rejected("a refinement needs a place");
    glm::dvec3 lo(1e300), hi(-1e300);
    for (const glm::dvec3& place : refinement.places) {
        lo = glm::min(lo, place - refinement.radius);
        hi = glm::max(hi, place + refinement.radius);
    }
    // Far from the origin a radius may be lost to rounding.
    const glm::dvec3 boxes = glm::max(glm::ceil((hi - lo) / refinement.edge), glm::dvec3(1));
    if (!(boxes.x * boxes.y * boxes.z * 6 <= 50.0 * static_cast<double>(most_cells)))
        throw Rejected("the edges of the refinement are too short for its size");
    const glm::dvec3 size = boxes * refinement.edge;
    SimplexMesh<3> all = box_cells(size, glm::ivec3(boxes)), out;
    const glm::dvec3 middle = (lo + hi) / 2.0;
    const Nearby nearby(refinement.places, refinement.radius);
    std::vector<int> number(all.vertices.size(), -1);
    for (auto cell : all.cells) {
        glm::dvec3 at = middle;
        for (const int v : cell) at += all.vertices[static_cast<std::size_t>(v)] / 4.0;
        if (!nearby.holds(at)) continue;
        for (int& v : cell) {
            int& known = number[static_cast<std::size_t>(v)];
            if (known < 0) {
                known = static_cast<int>(out.vertices.size());
                out.vertices.push_back(all.vertices[static_cast<std::size_t>(v)] + middle);
            }
            v = known;
        }
        out.cells.push_back(cell);
    }
    if (out.cells.empty()) throw Rejected("the edges of the refinement are longer than its radius");
    if (out.cells.size() > most_cells)
        throw Rejected(fmt::format("a refinement has at most {} tetrahedra, not {}",
                                   with_commas(most_cells), with_commas(out.cells.size())));
    return out;
}

SimplexDomain<3> domain_of(const TetrahedraShape& shape)
{
    const SimplexMesh<3> mesh = domain_cells(shape);
    return with_clouds<3>(mesh.vertices, mesh.cells, shape.degree, {.spread = shape.spread},
                          creases(mesh, shape.edits), shifts(mesh, shape.edits));
}

std::vector<Ref<SimplexBasis<3>>> layers_of(const TetrahedraShape& shape)
{
    const auto made = [](SimplexDomain<3> domain) {
        return make_ref(SimplexBasis<3>(std::move(domain)));
    };
    std::vector<Ref<SimplexBasis<3>>> out;
    out.push_back(made(domain_of(shape)));
    for (const TetrahedraEdit& edit : shape.edits) {
        if (!edit.refinement) continue;
        const SimplexMesh<3> near = cells_near(*edit.refinement);
        out.push_back(made(with_clouds<3>(near.vertices, near.cells, shape.degree,
                                          {shape.spread, CloudBorder::free})));
    }
    return out;
}

glm::dvec3 size_of(const TetrahedraShape& shape)
{
    if (shape.cells.empty()) return shape.size;
    glm::dvec3 out(0);
    for (const glm::dvec3& v : shape.vertices) out = glm::max(out, glm::abs(v) * 2.0);
    return out;
}

} // namespace trivar
