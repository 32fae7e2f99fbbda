// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<ImportedFile> {
    static void fields(auto& f, auto&& field)
    {
        field("path", f.path, "file, relative to the scene file's folder", required);
        field("hash", f.hash, "digest of the content that was meant; empty: any");
        field("up", f.up, "axis that points up in the file; auto: Y in glTF and OBJ, else Z");
        field("scale", f.scale, "file units to metres", between(1e-9, 1e9));
        field("subdivisions", f.subdivisions,
              "how often Catmull-Clark makes its cage finer and smoother", between(0, 6));
    }
};

} // namespace trivar
