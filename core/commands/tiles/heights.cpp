// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/tiles/heights.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/edits/edits.h"
#include "core/commands/tiles/tiles.h"

#include <filesystem>
#include <fmt/format.h>

namespace trivar {

void check(const HeightShape& shape)
{
    if (shape.image.empty()) throw Rejected("field \"image\" names no picture");
}

std::string size_words(const HeightShape& shape)
{
    return excerpt(std::filesystem::path(shape.image).filename().string());
}

Document applied(Document document, const SetHeights& command)
{
    if (!std::holds_alternative<HeightShape>(object(document, command.object).source))
        throw Rejected(fmt::format("field \"object\": {} is no sheet of heights", command.object));
    check(command.shape);
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.source = command.shape; });
}

StepTitle title(const SetHeights& c, const StepDocuments& step)
{
    const std::string name = name_in(step.before, c.object);
    const Object* object = step.was(c.object);
    const auto* old = object ? std::get_if<HeightShape>(&object->source) : nullptr;
    if (old && old->image != c.shape.image) return {"Picture of " + name, size_words(c.shape)};
    return {"Shape of " + name, {}};
}

Document applied(Document document, const Displace& command)
{
    check(command.shape);
    const Object& base = object(document, command.base);
    const Id sheet = document.next_id;
    Object heights{.name = excerpt(base.name) + " displaced",
                   .source = command.shape,
                   .transform = {},
                   .surfacing = command.material ? command.material : base.surfacing,
                   .stroke = {}};
    document = with_named(std::move(document), std::move(heights));
    document = applied(std::move(document), CoverWithTiles{sheet,
                                                           command.base,
                                                           {.pattern = TilePattern::grid,
                                                            .size = command.shape.size,
                                                            .per_face = command.per_face,
                                                            .even_height = true}});
    return with_changed(std::move(document), command.base, [](Object& o) { o.hidden = true; });
}

StepTitle title(const Displace& c, const StepDocuments& step)
{
    return {"Displace " + name_in(step.before, c.base), "by " + size_words(c.shape)};
}

} // namespace trivar
