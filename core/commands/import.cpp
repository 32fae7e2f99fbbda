// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/import.h"

#include "core/base/rejected.h"
#include "core/commands/edits.h"

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
    return document;
}

StepTitle title(const Relink& c, const StepDocuments& step)
{
    if (c.objects.size() == 1 && c.files.size() == 1)
        return title(EditImport{c.objects.front(), c.files.front()}, step);
    return {"Files of " + names_in(step.before, c.objects), {}};
}
} // namespace trivar
