// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/named_files.h"

#include "core/text/installed_fonts.h"

namespace trivar {

std::vector<NamedFile> files_named(const Object& object)
{
    if (const auto* file = std::get_if<ImportedFile>(&object.source))
        return {{NamedFile::Kind::model, file->path}};
    if (const auto* text = std::get_if<TextShape>(&object.source); text && is_font_path(text->font))
        return {{NamedFile::Kind::font, text->font}};
    return {};
}

} // namespace trivar
