// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/status.h"
#include "editor/command_line/verify_options.h"

namespace trivar {

// Runs trivar verify for a file that moves: exports the scene again, compares the file with the
// result, and samples it at ten times the frame rate. Throws Rejected.
Status verify_film(const VerifyOptions& options, const std::string& bytes,
                   const std::string& extras, const Streams& streams);

// The scene that a file names, beside it; or the one that --log gives.
std::string log_of_export(const VerifyOptions& options, const std::string& named);

} // namespace trivar
