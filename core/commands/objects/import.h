// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/import_fields.h"

namespace trivar {

struct ImportModel {
    static constexpr std::string_view verb = "import", summary = "Add a model from a file.";
    static constexpr CommandNature nature{.icon = CommandIcon::import_model,
                                          .asked = Invocation::by_actions};
    ImportedFile file;
    std::string name;
    Transform transform;
    bool operator==(const ImportModel&) const = default;
    static void fields(auto& c, auto&& field)
    {
        spread(c.file, field);
        field("name", c.name, "name in the outliner; empty: the file's");
        field("transform", c.transform, "its position, rotation and scale");
    }
};
Document applied(Document document, const ImportModel& command);
StepTitle title(const ImportModel& c, const StepDocuments& step);

struct EditImport {
    static constexpr std::string_view verb = "edit_import",
                                      summary =
                                          "Replace a model's file or its import settings in place.";
    Id object = 0;
    ImportedFile file;
    bool operator==(const EditImport&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an imported model", required.names_object());
        spread(c.file, field);
    }
    // The command that changes nothing of the object; none: it has nothing of the kind.
    static std::optional<EditImport> as_it_is(const Object& object, Id id)
    {
        const auto* own = std::get_if<ImportedFile>(&object.source);
        if (!own) return std::nullopt;
        return EditImport{id, *own};
    }
};
Document applied(Document document, const EditImport& command);
StepTitle title(const EditImport& c, const StepDocuments& step);

// A RelinkedPicture is the file of a picture that an object reads as numbers.
struct RelinkedPicture {
    Id object = 0;
    int mask = 0; // number of the mask of its tiles, the first is 1; 0: its heights
    std::string image, image_hash;
    bool operator==(const RelinkedPicture&) const = default;
};
template <> struct FieldsOf<RelinkedPicture> {
    static constexpr std::string_view told_as = "[picture](#picture)",
                                      about = "A picture that a mask or heights read.";
    static void fields(auto& p, auto&& field)
    {
        field("object", p.object, "id of a sheet of heights or a layer of tiles",
              required.names_object());
        field("mask", p.mask, "which of its masks, the first is 1; 0: its heights",
              in_range(0, 1e6));
        field("image", p.image, "file of the picture, relative to the scene file's folder",
              required.names_file(FileKind::image));
        field("image_hash", p.image_hash, "digest of that file's content; empty: any",
              any_value.digest_of_file());
    }
};

// A RelinkedVolume is the file or the folder of volume data of an object.
struct RelinkedVolume {
    Id object = 0;
    std::string path, hash;
    bool operator==(const RelinkedVolume&) const = default;
};
template <> struct FieldsOf<RelinkedVolume> {
    static constexpr std::string_view told_as = "[volume](#volume)",
                                      about = "The file or the folder of volume data.";
    static void fields(auto& v, auto&& field)
    {
        field("object", v.object, "id of volume data", required.names_object());
        field("path", v.path, "its file or folder, relative to the scene file's folder",
              required.names_file(FileKind::volume));
        field("hash", v.hash, "digest of its content; empty: any", any_value.digest_of_file());
    }
};

struct Relink {
    static constexpr std::string_view
        verb = "relink",
        summary =
            "Replace the files of models, one each, or their import settings, the pictures of "
            "masks and heights, and the files of volume data, in place.";
    std::vector<Id> objects;
    std::vector<ImportedFile> files;
    std::vector<RelinkedPicture> pictures = {};
    std::vector<RelinkedVolume> volumes = {};
    bool operator==(const Relink&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of imported models", required.names_object());
        field("files", c.files, "files of the objects, in the same order", required);
        field("pictures", c.pictures, "pictures of masks and heights, each with what has it");
        field("volumes", c.volumes, "files of volume data, each with what has it");
    }
};
Document applied(Document document, const Relink& command);
StepTitle title(const Relink& c, const StepDocuments& step);

} // namespace trivar
