// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/apply.h"

#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

template <class Shape> Document added(Document document, const AddShape<Shape>& command)
{
    check_transform(command.transform);
    if constexpr (std::is_same_v<Shape, TextShape>) check_text(command.shape);
    if (command.name.empty()) throw Rejected("field \"name\" is empty");
    return with_added(std::move(document), {.name = command.name,
                                            .source = command.shape,
                                            .transform = command.transform,
                                            .surfacing = command.material,
                                            .placement = {}});
}

Document with_file(Document document, Id id, std::string_view field, const ImportedFile& file)
{
    if (file.path.empty()) throw Rejected("field \"path\" names no file");
    if (!std::holds_alternative<ImportedFile>(object(document, id).source))
        throw Rejected(fmt::format("field \"{}\": {} comes from no file", field, id));
    return with_changed(std::move(document), id, [&](Object& o) { o.source = file; });
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
                                            .placement = {}});
}
Document applied(Document document, const EditImport& command)
{
    return with_file(std::move(document), command.object, "object", command.file);
}
Document applied(Document document, const Relink& command)
{
    if (command.files.size() != command.objects.size())
        throw Rejected(fmt::format("field \"files\" has {} entries for {} objects",
                                   command.files.size(), command.objects.size()));
    for (std::size_t i = 0; i < command.objects.size(); ++i)
        document = with_file(std::move(document), command.objects[i], "objects", command.files[i]);
    return document;
}
Document applied(Document document, const AddPlane& command)
{
    return added(std::move(document), command);
}
Document applied(Document document, const AddBox& command)
{
    return added(std::move(document), command);
}
Document applied(Document document, const AddSphere& command)
{
    return added(std::move(document), command);
}
Document applied(Document document, const AddCylinder& command)
{
    return added(std::move(document), command);
}
Document applied(Document document, const AddTorus& command)
{
    return added(std::move(document), command);
}
Document applied(Document document, const AddMoebius& command)
{
    return added(std::move(document), command);
}
Document applied(Document document, const AddTeapot& command)
{
    return added(std::move(document), command);
}
Document applied(Document document, const AddText& command)
{
    return added(std::move(document), command);
}
Document applied(Document document, const SetText& command)
{
    if (!std::holds_alternative<TextShape>(object(document, command.object).source))
        throw Rejected(fmt::format("field \"object\": {} is no text", command.object));
    check_text(command.shape);
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.source = command.shape; });
}

} // namespace trivar
