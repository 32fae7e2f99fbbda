// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "core/files/read_model.h"

#include <cstddef>
#include <string>

namespace trivar::testing {

// What is read must be sound: every mesh passes its check and can be cut to triangles.
inline int read_any(const unsigned char* data, std::size_t size, const std::string& name)
{
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const Model model = read_model_bytes(bytes, name, "");
        for (const Ref<Mesh>& mesh : model.meshes) {
            validate(*mesh, name);
            triangles(*mesh);
        }
    } catch (const Rejected&) {
    }
    return 0;
}

} // namespace trivar::testing
