// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/composed_bounds.h"

#include "core/base/finite.h"

#include <algorithm>

namespace trivar {
namespace {

// Relative rounding error of sums and products of several bounds.
constexpr double rounding_of_sums = 1e-12;

double bound_of(ErrorBounds& bounds, const std::array<ErrorBounds::Corner, 2>& edge,
                BoundMethod method)
{
    return bounds.edge(edge, method);
}
double bound_of(ErrorBounds& bounds, const std::array<ErrorBounds::Corner, 3>& triangle,
                BoundMethod method)
{
    return bounds.triangle(triangle, method);
}

// Returns the parameters of all points within a distance of a simplex.
template <std::size_t corners>
std::array<glm::dvec3, 2>
reached_parameters(const std::array<ErrorBounds::Corner, corners>& simplex, double distance_world,
                   const glm::dmat4& to_uvw)
{
    glm::dvec3 least(simplex[0].uvw), most(simplex[0].uvw), reach;
    for (const ErrorBounds::Corner& corner : simplex) {
        least = glm::min(least, corner.uvw);
        most = glm::max(most, corner.uvw);
    }
    for (int a = 0; a < 3; ++a)
        reach[a] =
            distance_world * glm::length(glm::dvec3(to_uvw[0][a], to_uvw[1][a], to_uvw[2][a]));
    return {least - reach, most + reach};
}

} // namespace

ComposedCells::ComposedCells(const Lattice& first, std::vector<NextVolume> next)
    : first_(std::make_shared<const DisplacementCells>(first.displacement)),
      next_(std::move(next))
{
    for (const NextVolume& each : next_) {
        cells_.push_back(std::make_shared<const DisplacementCells>(each.lattice->displacement));
        stretch_.emplace_back(*cells_.back(), each.embedding);
    }
}

double ComposedCells::most_stretch() const
{
    double product = 1;
    for (const StretchBound& each : stretch_) product *= each.most();
    return product;
}

ComposedBounds::ComposedBounds(const ComposedCells& cells) : cells_(cells), first_(cells.first())
{
    for (const Ref<DisplacementCells>& each : cells.cells_) next_.emplace_back(each);
}

// Shares are the parts that each volume adds to a bound, and where it moves the corners.
template <std::size_t corners> struct ComposedBounds::Shares {
    double bound = 0;
    std::size_t worst = 0; // 0: the first volume
    std::array<Corner, corners> worst_corners;
};

template <std::size_t corners>
ComposedBounds::Shares<corners> ComposedBounds::shares(const Simplex<corners>& simplex,
                                                       BoundMethod method)
{
    Shares<corners> out{bound_of(first_, simplex.by_first, method), 0, simplex.by_first};
    double greatest = out.bound; // largest share of a volume
    std::array<glm::dvec3, corners> world = simplex.world;
    for (std::size_t n = 0; n < next_.size() && out.bound < infinite; ++n) {
        const Embedding& embedding = cells_.next_[n].embedding;
        std::array<Corner, corners> there;
        for (std::size_t c = 0; c < corners; ++c) {
            const glm::dvec4 p(world[c], 1);
            there[c] = next_[n].corner(glm::dvec3(embedding.to_uvw * p));
            world[c] = glm::dvec3(embedding.to_rest * p) + there[c].displacement;
        }
        const auto [least, most] = reached_parameters(there, out.bound, embedding.to_uvw);
        const double stretch = out.bound > 0 ? cells_.stretch_[n].over(least, most) : 0,
                     own = bound_of(next_[n], there, method);
        out.bound = (stretch * out.bound + own) * (1 + rounding_of_sums);
        greatest *= stretch;
        if (own > greatest) {
            greatest = own;
            out.worst = n + 1;
            out.worst_corners = there;
        }
    }
    return out;
}

double ComposedBounds::operator()(const Simplex<2>& edge, BoundMethod method)
{
    if (next_.empty()) return first_.edge(edge.by_first, method);
    return shares(edge, method).bound;
}

double ComposedBounds::operator()(const Simplex<3>& triangle, BoundMethod method)
{
    if (next_.empty()) return first_.triangle(triangle.by_first, method);
    return shares(triangle, method).bound;
}

ComposedBounds::WorstPart ComposedBounds::worst_part(const Simplex<2>& edge, BoundMethod method)
{
    if (next_.empty()) return {first_, edge.by_first};
    const Shares<2> found = shares(edge, method);
    return {found.worst == 0 ? first_ : next_[found.worst - 1], found.worst_corners};
}

} // namespace trivar
