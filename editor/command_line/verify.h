// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/status.h"
#include "editor/command_line/verify_options.h"

namespace trivar {

// trivar verify: what an exported file claims, against the scene. Throws Rejected.
Status run_verify(const VerifyOptions& options, const Streams& streams);

} // namespace trivar
