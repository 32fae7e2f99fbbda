// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/commands/field.h"

namespace trivar {

struct ImportModel {
    static constexpr std::string_view verb = "import", summary = "Add a model from a file.";
    std::string path, hash, name;
    UpAxis up = UpAxis::automatic;
    double scale = 1;
    int subdivisions = 0;
    Transform transform;
    bool operator==(const ImportModel&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("path", c.path, "file, relative to the scene file's folder", required);
        field("hash", c.hash, "digest of the content that was meant; empty: any");
        field("name", c.name, "name in the outliner; empty: the file's");
        field("up", c.up, "axis that points up in the file; auto: Y in glTF and OBJ, else Z");
        field("scale", c.scale, "file units to metres", between(1e-9, 1e9));
        field("subdivisions", c.subdivisions, "Catmull-Clark levels", between(0, 6));
        field("transform", c.transform, "where it stands");
    }
};

} // namespace trivar
