// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/shader_folder.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <fmt/format.h>

namespace trivar::gpu {

namespace fs = std::filesystem;

ShaderFolder::ShaderFolder(const std::string& checkout)
    : folders_{fs::path(checkout) / "gpu" / "shaders", fs::path(checkout) / "core" / "kernel"}
{
    std::error_code ignored;
    for (const fs::path& folder : folders_)
        if (!fs::is_directory(folder, ignored))
            throw Rejected(fmt::format("{}: this is not a checkout of Trivar: it has no folder {}.",
                                       checkout, folder.lexically_relative(checkout).string()));
    look();
}

const Ref<ShaderTexts>& ShaderFolder::texts(double time_s)
{
    if (time_s - looked_s_ >= look_every_s) {
        looked_s_ = time_s;
        look();
    }
    return texts_;
}

ShaderFolder::Stamps ShaderFolder::stamps() const
{
    Stamps out;
    std::error_code ignored; // files come and go while they are looked at
    for (const fs::path& folder : folders_)
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
            if (entry.path().extension() == ".glsl")
                out[entry.path()] = {entry.last_write_time(ignored), entry.file_size(ignored)};
    return out;
}

void ShaderFolder::look()
{
    Stamps now = stamps();
    if (texts_ && now == seen_) return;
    ShaderTexts texts;
    try {
        for (const auto& [path, stamp] : now)
            texts[path.filename().string()] = read_text_file(path.string());
    } catch (const Rejected&) {
        if (texts_) return; // a file went meanwhile: the next look tells
        throw;
    }
    seen_ = std::move(now);
    texts_ = make_ref(std::move(texts));
}

} // namespace trivar::gpu
