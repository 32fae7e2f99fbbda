// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/formats.h"

#include <memory>

namespace tinygltf {
class Model;
}

namespace trivar {

struct LoadedGltf {
    std::shared_ptr<tinygltf::Model> gltf; // images hold their encoded bytes
    std::vector<std::string> notices;
};

// The file's structure through tinygltf, after the container, the nesting and the buffers' sizes
// were checked. Buffers and images are read from inside the file's folder only; a picture that is
// not there is a notice. Throws Rejected.
LoadedGltf load_gltf(const FileText& file, bool binary);

} // namespace trivar
