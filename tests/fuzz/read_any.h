// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "core/files/read_model.h"
#include "core/mesh/pose.h"

#include <cstddef>
#include <string>

namespace trivar::testing {

// Stands the model as it came and in the middle of each clip.
inline void pose_all(const Model& model)
{
    std::vector<const Clip*> clips{nullptr};
    for (const Clip& clip : model.clips) clips.push_back(&clip);
    for (const Clip* clip : clips) {
        const Stance stance =
            stance_at(model, clip, clip ? (clip->begin_s + clip->end_s) / 2 : 0.0);
        for (std::size_t i = 0; i < model.nodes.size(); ++i)
            if (const int mesh = model.nodes[i].mesh; mesh >= 0)
                posed(*model.meshes[static_cast<std::size_t>(mesh)],
                      pose_of(model, static_cast<int>(i), stance));
    }
}

// Checks that a file that was read is sound: every mesh passes its check and can be cut to
// triangles, every clip be played.
inline int read_any(const unsigned char* data, std::size_t size, const std::string& name)
{
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const Model model = read_model_bytes(bytes, name, "");
        for (const Ref<Mesh>& mesh : model.meshes) {
            validate(*mesh, name);
            triangles(*mesh);
        }
        pose_all(model);
    } catch (const Rejected&) {
    }
    return 0;
}

} // namespace trivar::testing
