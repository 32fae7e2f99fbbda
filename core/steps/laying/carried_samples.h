// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/steps/laying/stroke_hosts.h"

namespace trivar {

// Takes each sample of the carriage's stroke along to where its place is now in the space of the
// stroke, and those whose host is not there, or that met none, in between. Says where a part of
// what carries it is not there, and where hosts moved apart so far that the stroke bridges a gap.
// Hosts must know where they stand in that space.
void carry_samples(Carriage& carriage, const StrokeHosts& stroke);

} // namespace trivar
