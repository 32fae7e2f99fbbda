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

StepTitle title_of_change(const HeightShape* before, const HeightShape& now,
                          const std::string& name)
{
    if (before && before->image != now.image) return {"Picture of " + name, size_words(now)};
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
