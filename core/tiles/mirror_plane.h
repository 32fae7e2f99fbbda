// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/tile_base.h"
#include "core/tiles/tile_stroke.h"

#include <optional>

namespace trivar {

// A MirrorPlane is the plane across one axis through the origin of a base's model.
struct MirrorPlane {
    int axis = 0;
    glm::dvec3 across(glm::dvec3 v) const // its mirror image; of a point or a direction
    {
        v[axis] = -v[axis];
        return v;
    }
    glm::dvec3 onto(glm::dvec3 v) const
    {
        v[axis] = 0;
        return v;
    }
};

inline std::optional<MirrorPlane> plane_of(TileMirror mirror)
{
    if (mirror == TileMirror::none) return std::nullopt;
    return MirrorPlane{static_cast<int>(mirror) - static_cast<int>(TileMirror::x)};
}

// The place where a base has the mirror image of another one, at most `reach` away from it, metres;
// nothing: it is not so symmetrical.
inline std::optional<SurfacePlace> mirrored(const MirrorPlane& plane, const TileBase& base,
                                            const SurfacePlace& at, double reach)
{
    const SurfacePoint image{plane.across(base.position(at)), plane.across(base.normal(at))};
    return base.locate({&image, 1}, reach).front();
}

} // namespace trivar
