// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/this_program.h"

#include <filesystem>
#include <string>

namespace trivar {

// The sample models are no files of the checkout: the program trivar-make makes them, into
// assets/models beside the program. A build for a first look makes two of them; the others are made
// when a scene first asks for them.

// `program` is the one that trivar-make stands beside.

// Whether a file is a sample model that is missing and can be made.
bool can_be_made(const std::string& path, const std::filesystem::path& program = this_program());

// Makes such a model, which takes up to a few seconds; does nothing for any other file. Throws
// Cancelled. Where it fails the file is missing as before. Thread-safe, also between programs.
void make_sample_model(const std::string& path, const Progress& progress = {},
                       const std::filesystem::path& program = this_program());

} // namespace trivar
