// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/steps/laying/stroke_hosts.h"

namespace trivar {

// Moves each sample of the stroke_motion's stroke along to the present place of its point in the
// space of the stroke, and samples whose host is missing, or that met none, in between. Adds
// notices where a part of a host is missing, and where hosts moved apart so far that the stroke
// bridges a gap. Hosts must know where they stand in that space.
void carry_samples(StrokeMotion& stroke_motion, const StrokeHosts& stroke);

} // namespace trivar
