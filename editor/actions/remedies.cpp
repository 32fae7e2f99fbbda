// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/remedies.h"

#include "core/commands/objects/refine.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/objects/unwrap.h"
#include "core/steps/bending/refining.h"
#include "core/steps/tiles/covers.h"
#include "core/tiles/cell_counts.h"
#include "editor/session/scene_facts.h"

#include <algorithm>

namespace trivar {
namespace {

// To half of the triangles that it has now.
Remedy simplified(const Document& document, Id id)
{
    Simplifying now = object(document, id).simplifying.value_or(Simplifying{.keep = 1});
    now.keep /= 2;
    return {"Simplify " + name_of(document, id) + " to half", Simplify{{id}, now}};
}

} // namespace

std::optional<Remedy> remedy_of(const Document& document, Id id, std::string_view notice)
{
    const Object& o = object(document, id);
    const auto says = [&](std::string_view words) { return notice.find(words) != notice.npos; };
    if (o.tiles && says(too_heavy_tiles_words)) return simplified(document, id);
    const Id base = o.tiles && document.objects.contains(o.tiles->base) ? o.tiles->base : 0;
    if (base != 0 && says(lacks_uvs_words))
        return Remedy{"Unwrap " + name_of(document, base), Unwrap{{base}, {}}};
    if (base != 0 && says(too_many_faces_words)) return simplified(document, base);
    if (o.refining && says(spent_budget_words)) {
        Refining more = *o.refining;
        more.budget = std::min(2 * more.budget, 20'000'000);
        return Remedy{"Allow twice the triangles", Refine{{id}, more, {}}};
    }
    return std::nullopt;
}

} // namespace trivar
