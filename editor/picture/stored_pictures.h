// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"
#include "editor/jobs/job.h"
#include "gpu/texture.h"

#include <map>
#include <string>

namespace trivar {

// StoredPictures gives pictures of files to panels: they are read on a thread of their own when
// they are first asked for, scaled to the shown width, and kept. Needs the window's OpenGL context.
class StoredPictures {
public:
    explicit StoredPictures(std::function<void()> wake) : jobs_(std::move(wake)) {}

    // Null while the picture is being read, and where it cannot be read.
    const gpu::Texture2D* of(const std::string& path, int width_px);
    // Width over height once it is read; before that the usual ratio.
    double shape(const std::string& path, int width_px);
    // A picture that is in memory already, under a name; another version takes its place.
    const gpu::Texture2D& given(const std::string& name, long version, const Image& image);
    void forget_gpu() // before the context goes
    {
        pictures_.clear();
        given_.clear();
    }
    void poll() { jobs_.poll(); } // once a frame
    bool reading() const { return jobs_.status().has_value(); }

private:
    std::map<std::pair<std::string, int>, std::optional<gpu::Texture2D>> pictures_;
    std::map<std::string, std::pair<long, gpu::Texture2D>> given_;
    Jobs jobs_;
};

// The picture, made smaller by a whole factor until it is as wide as asked, or slightly wider.
Image shrunk(const Image& image, int width_px);

} // namespace trivar
