// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/chart_surface.h"
#include "core/mesh/cage.h"

#include <memory>

namespace trivar {

// A FacetSurface is a mesh as it is, over charts: each four-cornered face is a bilinear patch, with
// normals that are weighted by angle at its points and go from one to the next. A triangle is such
// a patch with one edge of no length, at the corner where most triangles meet: the pole of a
// sphere. Where some face has more corners, all are cut as one step of subdivision would cut them,
// and stay where they are.
class FacetSurface final : public ChartSurface {
public:
    // Throws Rejected where there would be more than most_facets charts. O(#C log #C).
    explicit FacetSurface(const Cage& cage);
    // Gives the same charts after the points of the mesh have moved. O(#C).
    FacetSurface moved(std::span<const glm::dvec3> points) const;

    const ChartNet& net() const override { return *net_; }
    glm::dvec3 position(const ChartPlace& at) const override;
    glm::dvec3 normal(const ChartPlace& at) const override;

    static constexpr std::size_t most_facets = 1'000'000;

private:
    struct Mean { // a point in the middle of others
        std::uint32_t first, count;
    };
    void place(std::span<const glm::dvec3> points);

    std::vector<Mean> means_;            // of the points that cutting adds
    std::vector<std::uint32_t> members_; // of all means
    std::shared_ptr<const ChartNet> net_;
    std::vector<glm::dvec3> points_, normals_;
};

} // namespace trivar
