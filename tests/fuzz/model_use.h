// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <string>

namespace trivar::testing {

// Uses a model's file like the program: reads it, from memory and with the files beside it, asks
// which files it names, checks it, poses it by its clips, writes it in every format and reads that
// again. Throws Rejected if the file is refused and Broken if a promise does not hold.
void use_model(const std::string& path);

// Every mesh passes its check, can be cut to triangles and has finite positions, also in the middle
// and at the ends of each clip; what was repaired is told in sound sentences. Throws Broken.
void check_model(const Model& model, const std::string& name);

// Written to files beside `path` and read back it is accepted, unless a writer refuses it. Throws
// Broken.
void check_written(const Model& model, const std::string& path);

} // namespace trivar::testing
