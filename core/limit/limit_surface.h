// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/chart_surface.h"
#include "core/mesh/cage.h"

#include <memory>

namespace trivar {

// A LimitJet holds a position and its derivatives along u and v.
struct LimitJet {
    glm::dvec3 p, u, v, uu, uv, vv;
};

// A SurfaceFrame holds the unit normal with its derivatives (Weingarten's equations), and the
// principal curvatures: k1 >= k2, positive where the surface bends toward the normal.
struct SurfaceFrame {
    glm::dvec3 normal, normal_u, normal_v;
    double k1 = 0, k2 = 0;
};
SurfaceFrame frame_of(const LimitJet& jet);

// Gives a vector of the tangent plane in the coordinates of the chart: the least-squares solution
// of u P_u + v P_v = t.
glm::dvec2 in_chart(const LimitJet& jet, const glm::dvec3& t);

// The largest number of charts of a limit surface. Each takes 0.4 to 13 kilobytes.
inline constexpr std::size_t most_charts = 100'000;

// A LimitSurface is the smooth surface to which Catmull-Clark subdivision of a cage converges, in
// double precision. A chart is a face of the cage; where some face has other than four corners, it
// is a face of the cage after one step of subdivision, which has the same limit. Round
// extraordinary vertices the surface is that of six further steps; charts are continuously
// differentiable over edges except within a 64th of a chart of such a vertex, where the lines of
// their coordinates have kinks. Evaluation by OpenSubdiv's Bfr: 40 to 450 nanoseconds.
class LimitSurface final : public ChartSurface {
public:
    // Throws Rejected where the faces form no surface or there would be too many charts. 3 to 30
    // microseconds per chart.
    explicit LimitSurface(const Cage& cage);
    // Returns the surface after the points of its cage have moved; facts of the faces are shared.
    // About 2 us per chart.
    LimitSurface moved(std::span<const glm::dvec3> cage_points) const;

    const ChartNet& net() const override;
    glm::dvec3 position(const ChartPlace& at) const override;
    glm::dvec3 normal(const ChartPlace& at) const override;
    LimitJet jet(const ChartPlace& at) const;
    // Tells whether the chart is a single bicubic patch; then its coordinates are twice
    // continuously differentiable over all edges that are no creases.
    bool is_regular(std::uint32_t chart) const;
    double diagonal() const { return diagonal_; } // of the box round the cage

private:
    struct Topology;
    LimitSurface(std::shared_ptr<const Topology> topology, std::span<const glm::dvec3> cage_points);
    std::shared_ptr<const Topology> topology_;
    std::vector<glm::dvec3> patch_points_;
    double diagonal_ = 0;
};

} // namespace trivar
