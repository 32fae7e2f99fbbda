// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<ImportedFile> {
    static constexpr std::string_view told_as = "[file](#file)",
                                      about = "An imported model's file, and how it is read.",
                                      copied = "file";
    static void fields(auto& f, auto&& field)
    {
        field("path", f.path, "file, relative to the scene file's folder",
              required.without_keys().names_file(FileKind::model));
        field("hash", f.hash, "digest of the file's content when it was imported; empty: any",
              any_value.without_keys().digest_of_file());
        field("up", f.up, "axis that points up in the file; auto: Y in glTF and OBJ, else Z",
              any_value.without_keys());
        field("scale", f.scale, "file units to metres", in_range(1e-9, 1e9).without_keys());
        field("subdivisions", f.subdivisions,
              "levels of Catmull-Clark subdivision, which smooths the mesh", in_range(0, 6));
    }
};

} // namespace trivar
