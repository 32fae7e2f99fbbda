// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/import.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/edits/edits.h"
#include "core/document/named_files.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

Document with_file(Document document, Id id, std::string_view field, const ImportedFile& file)
{
    if (file.path.empty()) throw Rejected("field \"path\" names no file");
    if (!std::holds_alternative<ImportedFile>(object(document, id).source))
        throw Rejected(fmt::format("field \"{}\": {} was not imported from a file", field, id));
    return with_changed(std::move(document), id, [&](Object& o) { o.source = file; });
}

Document with_picture(Document document, const RelinkedPicture& picture)
{
    if (picture.image.empty()) throw Rejected("field \"image\" names no picture");
    const Object& before = object(document, picture.object);
    if (std::ranges::none_of(files_named(before), [&](const FileUse& use) {
            return use.kind == FileKind::image && use.mask == picture.mask;
        }))
        throw Rejected(
            picture.mask == 0
                ? fmt::format("field \"pictures\": {} is no sheet of heights", picture.object)
                : fmt::format("field \"pictures\": {} has no mask {} by a picture", picture.object,
                              picture.mask));
    return with_changed(std::move(document), picture.object, [&](Object& o) {
        if (picture.mask == 0) {
            auto& heights = std::get<HeightShape>(o.source);
            heights.image = picture.image;
            heights.image_hash = picture.image_hash;
            return;
        }
        TileMask& mask = o.tiles->masks[static_cast<std::size_t>(picture.mask) - 1];
        mask.image = picture.image;
        mask.image_hash = picture.image_hash;
    });
}

Document with_volume(Document document, const RelinkedVolume& volume)
{
    if (volume.path.empty()) throw Rejected("field \"path\" names no file");
    if (!std::holds_alternative<VoxelShape>(object(document, volume.object).source))
        throw Rejected(fmt::format("field \"volumes\": {} is no volume data", volume.object));
    return with_changed(std::move(document), volume.object, [&](Object& o) {
        auto& shape = std::get<VoxelShape>(o.source);
        shape.path = volume.path;
        shape.hash = volume.hash;
    });
}

} // namespace

Document applied(Document document, const ImportModel& command)
{
    check_transform(command.transform);
    if (command.file.path.empty()) throw Rejected("field \"path\" names no file");
    const std::string own = std::filesystem::path(command.file.path).stem().string();
    return with_added(std::move(document), {.name = !command.name.empty() ? command.name
                                                    : !own.empty()        ? own
                                                                          : command.file.path,
                                            .source = command.file,
                                            .transform = command.transform,
                                            .surfacing = {},
                                            .stroke = {}});
}

StepTitle title(const ImportModel& c, const StepDocuments& step)
{
    const std::filesystem::path file(c.file.path);
    if (step.made() == file.stem().string()) return {"Import " + file.filename().string(), {}};
    return {"Import " + step.made(), "from " + file.filename().string()};
}
Document applied(Document document, const EditImport& command)
{
    return with_file(std::move(document), command.object, "object", command.file);
}

StepTitle title(const EditImport& c, const StepDocuments& step)
{
    const std::string name = name_in(step.before, c.object);
    const Object* object = step.was(c.object);
    const auto* file = object ? std::get_if<ImportedFile>(&object->source) : nullptr;
    if (!file || file->path != c.file.path)
        return {"File of " + name, std::filesystem::path(c.file.path).filename().string()};
    if (file->subdivisions != c.file.subdivisions)
        return {"Subdivision of " + name, fmt::format("{} levels", c.file.subdivisions)};
    return {"Read " + name + (file->hash != c.file.hash ? " again" : " with other settings"), {}};
}
Document applied(Document document, const Relink& command)
{
    if (command.files.size() != command.objects.size())
        throw Rejected(fmt::format("field \"files\" has {} entries for {} objects",
                                   command.files.size(), command.objects.size()));
    for (std::size_t i = 0; i < command.objects.size(); ++i)
        document = with_file(std::move(document), command.objects[i], "objects", command.files[i]);
    for (const RelinkedPicture& each : command.pictures)
        document = with_picture(std::move(document), each);
    for (const RelinkedVolume& each : command.volumes)
        document = with_volume(std::move(document), each);
    return document;
}

StepTitle title(const Relink& c, const StepDocuments& step)
{
    if (c.objects.size() == 1 && c.files.size() == 1 && c.pictures.empty() && c.volumes.empty())
        return title(EditImport{c.objects.front(), c.files.front()}, step);
    if (c.objects.empty() && c.pictures.empty() && c.volumes.size() == 1)
        return {"File of " + name_in(step.before, c.volumes.front().object),
                excerpt(std::filesystem::path(c.volumes.front().path).filename().string())};
    if (c.objects.empty() && c.pictures.size() == 1 && c.volumes.empty())
        return {"Picture of " + name_in(step.before, c.pictures.front().object),
                excerpt(std::filesystem::path(c.pictures.front().image).filename().string())};
    std::vector<Id> all = c.objects;
    const auto add = [&](Id id) {
        if (std::ranges::find(all, id) == all.end()) all.push_back(id);
    };
    for (const RelinkedPicture& each : c.pictures) add(each.object);
    for (const RelinkedVolume& each : c.volumes) add(each.object);
    return {"Files of " + names_in(step.before, all), {}};
}
} // namespace trivar
