// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/mesh/polyline.h"

#include <cstdint>

namespace trivar::gpu {

// HiddenParts says how those parts of a curve are drawn that something solid hides.
enum class HiddenParts { dashed, faint, left_out, as_seen };

// A CurveStyle says how a polyline is drawn.
struct CurveStyle {
    float width_px = 2;
    // above 0: used in place of width_px, so that a curve further away is thinner
    float width_world = 0;
    // Shares of the length over which the width grows from 0 at the beginning and at the end.
    glm::vec2 taper{0};
    HiddenParts hidden = HiddenParts::dashed;
    // above 0: dashes with flat ends all along the curve, and the gaps after them; each so long
    float dash_px = 0;
    // World units: a surface of the same id that lies less far before the curve does not hide it.
    // 0: each surface before the curve does.
    float own_reach_world = 0;
    // It is drawn as files of drawings have it: what it covers of a pixel looks as if encoded
    // colours were mixed, in place of linear light, where dark lines on white look thinner.
    bool as_ink = false;
    bool operator==(const CurveStyle&) const = default;
};

// This bit is set in the ids of a picture's pixels where a curve shows, to tell curves from
// surfaces.
inline constexpr std::uint32_t curve_id_bit = 1u << 31;

// A Curve is a polyline that is part of the scene as surfaces are: it hides what is behind it and
// can be picked. It is not lit and casts no shadow. Every picture uploads its curves: O(#points).
struct Curve {
    Ref<Polyline> line = {};
    glm::dmat4 to_world{1};
    CurveStyle style = {};
    int id = 0;               // what pick() returns; 0: not pickable
    bool highlighted = false; // has an outline
};

} // namespace trivar::gpu
