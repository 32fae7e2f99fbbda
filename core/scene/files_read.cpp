// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files_read.h"

#include "core/base/digest.h"
#include "core/base/rejected.h"
#include "core/evaluation/shapes.h"

namespace trivar {
namespace {

std::string content_of(const ImportedFile& file, const AssetStore& assets)
{
    const AssetStore::Loaded loaded = assets.load(file);
    if (loaded.hash.empty())
        throw Rejected(loaded.notices.empty() ? file.path + ": cannot be read"
                                              : loaded.notices.front());
    return loaded.content;
}

std::string content_of(const TextShape& text, const AssetStore& assets)
{
    try {
        return font_of(text, assets).font.digest();
    } catch (const Rejected&) { // said of the object, which has no shape
        return {};
    }
}

} // namespace

std::string digest_of_files(const Document& document, const AssetStore& assets)
{
    std::map<std::string, std::string> contents; // by name in the scene
    for (const auto& [id, object] : document.objects)
        if (const auto* file = std::get_if<ImportedFile>(&object->source)) {
            if (!contents.contains(file->path)) contents[file->path] = content_of(*file, assets);
        } else if (const auto* text = std::get_if<TextShape>(&object->source)) {
            contents["font " + text->font] = content_of(*text, assets);
        }
    if (contents.empty()) return {};
    Digest digest;
    for (const auto& [name, content] : contents) {
        digest.add_text(name);
        digest.add_text(content);
    }
    return digest.hex();
}

} // namespace trivar
