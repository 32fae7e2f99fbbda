// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"
#include "editor/jobs/job.h"
#include "gpu/texture.h"

#include <map>
#include <string>

namespace trivar {

// Pictures of files for panels: read on a thread of their own the first time they are asked for,
// made as wide as they are shown, and kept. Needs the window's OpenGL context.
class StoredPictures {
public:
    explicit StoredPictures(std::function<void()> wake) : jobs_(std::move(wake)) {}

    // Nothing while it is being read, and where it cannot be.
    const gpu::Texture2D* of(const std::string& path, int width_px);
    // Width over height once it is there; else as most pictures are.
    double shape(const std::string& path, int width_px);
    void forget_gpu() { pictures_.clear(); } // before the context goes
    void poll() { jobs_.poll(); }            // once a frame
    bool reading() const { return jobs_.status().has_value(); }

private:
    std::map<std::pair<std::string, int>, std::optional<gpu::Texture2D>> pictures_;
    Jobs jobs_;
};

// The picture with sides that many times smaller that it is as wide as asked, or not much wider.
Image shrunk(const Image& image, int width_px);

} // namespace trivar
