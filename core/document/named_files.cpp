// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/named_files.h"

#include "core/text/installed_fonts.h"

namespace trivar {

std::vector<NamedFile> files_named(const Object& object)
{
    std::vector<NamedFile> out;
    if (const auto* file = std::get_if<ImportedFile>(&object.source))
        out.push_back({NamedFile::Kind::model, file->path});
    if (const auto* text = std::get_if<TextShape>(&object.source); text && is_font_path(text->font))
        out.push_back({NamedFile::Kind::font, text->font});
    if (const auto* heights = std::get_if<HeightShape>(&object.source))
        out.push_back({NamedFile::Kind::image, heights->image});
    if (object.tiles)
        for (const TileMask& mask : object.tiles->masks)
            if (mask.from == MaskFrom::image && !mask.image.empty())
                out.push_back({NamedFile::Kind::image, mask.image});
    return out;
}

} // namespace trivar
