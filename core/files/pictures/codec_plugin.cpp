// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/codec_plugin.h"

#include "core/base/rejected.h"
#include "core/base/this_program.h"

#include <dlfcn.h>
#include <fmt/format.h>

namespace trivar {

const Codec& picture_codec()
{
    constexpr const char* file = "trivar-codec.so";
    const std::filesystem::path path = part_of(this_program(), file);
    if (path.empty())
        throw Rejected(fmt::format("cannot be read or written: {}, a part of Trivar, is neither "
                                   "beside the program nor in lib/trivar; install Trivar again",
                                   file));
    // The system loads the library once and counts its uses; it is never closed.
    void* const opened = ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const codec = opened ? ::dlsym(opened, "trivar_codec") : nullptr;
    if (!codec)
        throw Rejected(fmt::format("cannot be read or written: {} does not open ({})",
                                   path.string(), ::dlerror()));
    return *static_cast<const Codec*>(codec);
}

} // namespace trivar
