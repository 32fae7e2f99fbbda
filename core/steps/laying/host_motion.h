// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/steps/laying/stroke_hosts.h"

namespace trivar {

// Whether two motions agree on the points under the stroke, up to rounding.
bool alike(const StrokeHosts& stroke, const glm::dmat4& a, const glm::dmat4& b);

// The motion of a stroke with its main host, which must be there: turn, even scale and shift.
struct HostMotion {
    glm::dmat4 to_world{1}; // exactly 1 where nothing moved
    bool exact = false;     // it is the host's own, to the bits; else the nearest one of the places
};
HostMotion motion_of(const StrokeHosts& stroke);

} // namespace trivar
