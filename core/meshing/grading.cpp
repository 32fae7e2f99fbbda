// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/grading.h"

#include "core/base/finite.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace trivar {
namespace {

constexpr double length_slack =
    1.2; // halving gives lengths in steps, so some are longer than asked
constexpr double least_share_of_domain =
    1e-5; // of the whole domain, so that halves keep their digits
constexpr std::size_t most_balls = 10'000;

struct Edge {
    double length2;
    int a, b; // a < b
    // A total order: the same edge wins in all cells around it.
    bool operator<(const Edge& other) const
    {
        return std::tie(length2, a, b) < std::tie(other.length2, other.a, other.b);
    }
};

class Bisection {
public:
    explicit Bisection(SimplexMesh<3> mesh) : mesh_(std::move(mesh)), stars_(vertex_stars(mesh_)) {}

    GradedCells operator()(const Grading& grading)
    {
        // Halves go to the end, and those of cells that were short enough are so too.
        for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
            while (too_long(c, grading)) {
                if (mesh_.cells.size() >= grading.cell_limit) return {std::move(mesh_), true};
                halve(longest_near(c));
            }
        return {std::move(mesh_), false};
    }

private:
    const glm::dvec3& at(int v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }
    std::vector<int>& star(int v) { return stars_[static_cast<std::size_t>(v)]; }

    bool too_long(std::size_t c, const Grading& grading) const
    {
        Box box;
        for (const int v : mesh_.cells[c]) box.add(at(v));
        return std::sqrt(longest(c).length2) > length_slack * edge_in(grading, box);
    }

    Edge longest(std::size_t c) const
    {
        Edge out{-1, 0, 0};
        const std::array<int, 4>& cell = mesh_.cells[c];
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const auto [a, b] = std::minmax(cell[i], cell[j]);
                const glm::dvec3 d = at(b) - at(a);
                out = std::max(out, Edge{glm::dot(d, d), a, b});
            }
        return out;
    }

    template <class Body> void each_around(const Edge& e, const Body& body)
    {
        for (const int c : star(e.a)) {
            const std::array<int, 4>& cell = mesh_.cells[static_cast<std::size_t>(c)];
            if (std::find(cell.begin(), cell.end(), e.b) != cell.end()) body(c);
        }
    }

    // Walks from the longest edge of a cell to that of a cell around it, until none is longer.
    Edge longest_near(std::size_t c)
    {
        Edge e = longest(c);
        for (;;) {
            Edge longer = e;
            each_around(e, [&](int each) {
                longer = std::max(longer, longest(static_cast<std::size_t>(each)));
            });
            if (!(e < longer)) return e;
            e = longer;
        }
    }

    void halve(const Edge& e)
    {
        const int middle = static_cast<int>(mesh_.vertices.size());
        mesh_.vertices.push_back((at(e.a) + at(e.b)) * 0.5);
        stars_.emplace_back();
        std::vector<int> around;
        each_around(e, [&](int c) { around.push_back(c); });
        for (const int c : around) {
            std::array<int, 4>& cell = mesh_.cells[static_cast<std::size_t>(c)];
            std::array<int, 4> other = cell;
            std::replace(cell.begin(), cell.end(), e.b, middle);
            std::replace(other.begin(), other.end(), e.a, middle);
            std::erase(star(e.b), c);
            star(middle).push_back(c);
            for (const int v : other) star(v).push_back(static_cast<int>(mesh_.cells.size()));
            mesh_.cells.push_back(other);
        }
    }

    SimplexMesh<3> mesh_;
    std::vector<std::vector<int>> stars_;
};

} // namespace

double edge_in(const Grading& grading, const Box& box)
{
    double out = grading.edge;
    for (const FineBall& ball : grading.balls)
        out = std::min(out, ball.edge + grading.growth *
                                            std::max(0.0, box.distance(ball.center) - ball.radius));
    return out;
}

void check(const Grading& grading, double whole)
{
    if (!(grading.growth >= 0.05 && grading.growth <= 2))
        throw Rejected("Edges may grow by 0.05 to 2 times the distance.");
    if (grading.balls.size() > most_balls)
        throw Rejected("Cells can be finer in at most 10,000 balls.");
    double shortest = grading.edge;
    for (const FineBall& ball : grading.balls) {
        if (!finite(ball.center) || !std::isfinite(ball.radius) || !std::isfinite(ball.edge) ||
            ball.radius < 0)
            throw Rejected("A ball of finer cells is not one: its numbers are not finite, or its "
                           "radius is negative.");
        shortest = std::min(shortest, ball.edge);
    }
    if (!(shortest > 0)) throw Rejected("The length of edges must be more than 0.");
    if (shortest < least_share_of_domain * whole)
        throw Rejected("Edges cannot be shorter than 1/100,000 of the whole domain.");
}

GradedCells refined(SimplexMesh<3> mesh, const Grading& grading)
{
    check(mesh);
    Box box;
    for (const glm::dvec3& v : mesh.vertices) box.add(v);
    check(grading, glm::length(box.size()));
    return Bisection(std::move(mesh))(grading);
}

} // namespace trivar
