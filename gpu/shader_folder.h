// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "gpu/shader_source.h"

#include <filesystem>

namespace trivar::gpu {

// A ShaderFolder watches the shader files of a checkout, for developers: gpu/shaders and
// core/kernel.
class ShaderFolder {
public:
    // throws Rejected where it is not a checkout
    explicit ShaderFolder(const std::string& checkout);

    // The present texts: another Ref as soon as the time stamp or size of a file has changed, or a
    // file has come or gone. The files are looked at most four times per second.
    const Ref<ShaderTexts>& texts(double time_s);
    static constexpr double look_every_s = 0.25;

private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t bytes = 0;
        bool operator==(const Stamp&) const = default;
    };
    using Stamps = std::map<std::filesystem::path, Stamp>;
    Stamps stamps() const;
    void look();
    std::vector<std::filesystem::path> folders_;
    Stamps seen_;
    Ref<ShaderTexts> texts_;
    double looked_s_ = -1e9;
};

} // namespace trivar::gpu
