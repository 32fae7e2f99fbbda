// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/source.h"

#include <optional>

namespace trivar {

struct Band;

// The way round an object's axis, `level` metres from its widest circle; empty unless the source is
// a cylinder, a sphere, a torus or a Moebius band.
std::optional<Band> band_round(const Source& source, double level, const glm::dmat4& to_world);

} // namespace trivar
