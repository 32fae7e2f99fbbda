// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/status.h"
#include "editor/command_line/verify_options.h"

namespace trivar {

// Runs trivar verify, which compares the claims of an exported file with the scene. Throws
// Rejected.
Status run_verify(const VerifyOptions& options, const Streams& streams);

} // namespace trivar
