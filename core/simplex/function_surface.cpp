// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/function_surface.h"

#include "core/base/parallel.h"
#include "core/simplex/box_domain.h"
#include "core/simplex/level_ring.h"

#include <algorithm>
#include <map>

namespace trivar {
namespace {

struct Value {
    double value = 0;
    glm::dvec3 gradient{0};
};

class Function {
public:
    Function(const SimplexBasis<3>& basis, int point) : basis_(basis), point_(point)
    {
        const SimplexDomain<3>& domain = basis.domain();
        const auto indices = multi_indices<3>(domain.degree);
        for (std::size_t c = 0; c < domain.cells.size(); ++c)
            for (std::size_t i = 0; i < indices.size(); ++i)
                if (basis.point_of(c, i) == point)
                    for (std::size_t k = 0; k < 4; ++k)
                        for (int j = 0; j <= indices[i][k]; ++j) {
                            const glm::dvec3& knot = domain.knot(domain.cells[c][k], j);
                            lo = glm::min(lo, knot);
                            hi = glm::max(hi, knot);
                        }
    }
    Value operator()(const glm::dvec3& x, bool gradient) const
    {
        std::vector<BasisValue<3>> values;
        basis_.values_at(x, gradient, values);
        Value out;
        for (const BasisValue<3>& each : values)
            if (each.point == point_) {
                out.value += each.value;
                out.gradient += each.gradient;
            }
        return out;
    }
    glm::dvec3 lo{1e300}, hi{-1e300}; // of its knots

private:
    const SimplexBasis<3>& basis_;
    int point_;
};

struct Samples {
    SimplexMesh<3> grid;
    std::vector<double> values;
};

Samples sampled(const Function& f, int steps)
{
    const glm::dvec3 size = (f.hi - f.lo) * 1.02, middle = (f.lo + f.hi) / 2.0;
    Samples out{box_cells(size, glm::ivec3(steps)), {}};
    for (glm::dvec3& v : out.grid.vertices) v += middle;
    out.values.resize(out.grid.vertices.size());
    parallel_blocks(out.values.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            out.values[i] = f(out.grid.vertices[i], false).value;
    });
    return out;
}

// Moves a point along the gradient onto the surface, at most as far as that.
glm::dvec3 polished(const Function& f, glm::dvec3 x, double value, double most)
{
    const glm::dvec3 from = x;
    for (int step = 0; step < 5; ++step) {
        const Value at = f(x, true);
        const double square = glm::dot(at.gradient, at.gradient);
        if (square < 1e-12) return from;
        x += at.gradient * ((value - at.value) / square);
    }
    return glm::distance(x, from) <= most ? x : from;
}

} // namespace

double greatest_value(const SimplexBasis<3>& basis, int point, int steps)
{
    const Samples samples = sampled(Function(basis, point), steps);
    return *std::max_element(samples.values.begin(), samples.values.end());
}

Mesh function_surface(const SimplexBasis<3>& basis, int point, double value, int steps)
{
    const Function f(basis, point);
    const Samples samples = sampled(f, steps);
    Mesh mesh;
    std::vector<glm::dvec3> places;
    std::map<std::pair<int, int>, std::uint32_t> made;
    const auto vertex = [&](int a, int b) { // between a sample above and one below
        const auto [known, added] =
            made.try_emplace({a, b}, static_cast<std::uint32_t>(places.size()));
        if (added) {
            const double at = samples.values[static_cast<std::size_t>(a)],
                         below = samples.values[static_cast<std::size_t>(b)];
            places.push_back(glm::mix(samples.grid.vertices[static_cast<std::size_t>(a)],
                                      samples.grid.vertices[static_cast<std::size_t>(b)],
                                      (at - value) / (at - below)));
        }
        return known->second;
    };
    for (const auto& cell : samples.grid.cells) {
        std::array<bool, 4> is_above{};
        for (std::size_t k = 0; k < 4; ++k)
            is_above[k] = samples.values[static_cast<std::size_t>(cell[k])] >= value;
        const LevelRing cut = level_ring(is_above);
        std::array<std::uint32_t, 4> ring{};
        for (std::size_t i = 0; i < cut.size; ++i)
            ring[i] = vertex(cell[cut.edges[i].above], cell[cut.edges[i].below]);
        const auto place = [&](std::size_t k) {
            return samples.grid.vertices[static_cast<std::size_t>(cell[k])];
        };
        const glm::dvec3 toward = place(cut.edges[0].below) - place(cut.edges[0].above);
        for (std::size_t i = 1; i + 1 < cut.size; ++i) {
            std::array<std::uint32_t, 3> triangle{ring[0], ring[i], ring[i + 1]};
            const glm::dvec3 normal = glm::cross(places[triangle[1]] - places[triangle[0]],
                                                 places[triangle[2]] - places[triangle[0]]);
            if (glm::dot(normal, toward) < 0) std::swap(triangle[1], triangle[2]);
            add_face(mesh, triangle);
        }
    }
    mesh.positions.resize(places.size());
    mesh.normals.resize(places.size());
    const double most = glm::length(f.hi - f.lo) / steps;
    parallel_blocks(places.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec3 at = polished(f, places[i], value, most);
            const glm::dvec3 down = -f(at, true).gradient;
            mesh.positions[i] = glm::vec3(at);
            mesh.normals[i] =
                glm::length(down) > 0 ? glm::vec3(glm::normalize(down)) : glm::vec3(0, 0, 1);
        }
    });
    return mesh;
}

} // namespace trivar
