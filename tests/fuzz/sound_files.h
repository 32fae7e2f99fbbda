// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

namespace trivar::testing {

// Small sound files of a kind, each with those that it names: what our writers make of bodies with
// materials, pictures, colours, a skin, a target and clips, and the seeds of the fuzzers. The kinds
// are obj, ply, ply-text, stl, stl-text, off, glb and gltf, whose buffer and pictures are files.
std::vector<FileSet> sound_files(const std::string& kind);

} // namespace trivar::testing
