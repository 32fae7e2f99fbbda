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

struct ImportModel {
    static constexpr std::string_view verb = "import", summary = "Add a model from a file.";
    ImportedFile file;
    std::string name;
    Transform transform;
    bool operator==(const ImportModel&) const = default;
    static void fields(auto& c, auto&& field)
    {
        FieldsOf<ImportedFile>::fields(c.file, field);
        field("name", c.name, "name in the outliner; empty: the file's");
        field("transform", c.transform, "where it stands");
    }
};

struct EditImport {
    static constexpr std::string_view verb = "edit_import",
                                      summary = "Take a model from another file, or read it "
                                                "otherwise. It stays where it is.";
    Id object = 0;
    ImportedFile file;
    bool operator==(const EditImport&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an imported model", required);
        FieldsOf<ImportedFile>::fields(c.file, field);
    }
};

struct Relink {
    static constexpr std::string_view verb = "relink",
                                      summary = "Take models from other files, one each, or read "
                                                "them otherwise. They stay where they are.";
    std::vector<Id> objects;
    std::vector<ImportedFile> files;
    bool operator==(const Relink&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of imported models", required);
        field("files", c.files, "of the objects, in the same order", required);
    }
};

} // namespace trivar
