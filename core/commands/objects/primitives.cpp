// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/primitives.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/field_words.h"

#include <fmt/format.h>
#include <utility>

namespace trivar {

Document with_named(Document document, Object object)
{
    check_transform(object.transform);
    if (object.name.empty()) throw Rejected("field \"name\" is empty");
    return with_added(std::move(document), std::move(object));
}

std::string size_words(const PlaneShape& s)
{
    return fmt::format("{} × {} m", number_text(s.size.x), number_text(s.size.y));
}

std::string size_words(const BoxShape& s)
{
    return fmt::format("{} × {} × {} m", number_text(s.size.x), number_text(s.size.y),
                       number_text(s.size.z));
}

std::string size_words(const TeapotShape& s)
{
    return in_metres(s.height);
}

std::string size_of_radius(double radius)
{
    return "radius " + in_metres(radius);
}

} // namespace trivar
