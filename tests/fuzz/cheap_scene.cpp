// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/cheap_scene.h"

#include <limits>

namespace trivar::testing {
namespace {

constexpr double too_much = std::numeric_limits<double>::infinity();

struct VerticesOf {
    double operator()(const GroupShape&) const { return 0; }
    double operator()(const ImportedFile& s) const { return s.subdivisions > 0 ? too_much : 1000; }
    double operator()(const PlaneShape& s) const { return 1.0 * s.segments.x * s.segments.y; }
    double operator()(const BoxShape& s) const
    {
        const glm::dvec3 n(s.segments);
        return 2 * (n.x * n.y + n.y * n.z + n.z * n.x);
    }
    double operator()(const SphereShape& s) const { return 1.0 * s.segments * s.rings; }
    double operator()(const CylinderShape& s) const { return 1.0 * s.segments * s.stacks; }
    double operator()(const TorusShape& s) const { return 1.0 * s.segments.x * s.segments.y; }
    double operator()(const MoebiusShape& s) const { return 1.0 * s.segments.x * s.segments.y; }
    double operator()(const TeapotShape& s) const { return 32.0 * s.resolution * s.resolution; }
    double operator()(const TextShape&) const { return too_much; }
    double operator()(const VoxelShape& s) const
    {
        return 1e6 * static_cast<double>(s.levels.size());
    }
    double operator()(const HeightShape& s) const { return 1.0 * s.segments * s.segments; }
    double operator()(const SimplexSheetShape& s) const
    {
        return 10.0 * s.segments * s.segments + 1000.0 * s.boxes.x * s.boxes.y;
    }
    double operator()(const TetrahedraShape& s) const
    {
        return 1000.0 * s.boxes.x * s.boxes.y * s.boxes.z +
               1000.0 * static_cast<double>(s.cells.size());
    }
    double operator()(const LatticeShape& s) const { return 10.0 * s.grid.x * s.grid.y * s.grid.z; }
};

double control_points(const PlacementParameters& p)
{
    return 1.0 * p.grid.x * p.grid.y * p.grid.z;
}

double work_of(const Object& object)
{
    double work = std::visit(VerticesOf{}, object.source) * (1.0 + object.travel.followers);
    if (object.stroke) work += 10 * control_points(object.stroke->parameters);
    if (object.refining) work = too_much;
    return work + 100.0 * static_cast<double>(object.shaping.size());
}

} // namespace

bool is_cheap(const Document& document)
{
    double work = 0;
    for (const auto& [id, object] : document.objects) work += work_of(*object);
    return work <= 10000;
}

} // namespace trivar::testing
