// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

namespace trivar {

// The incision that a hand works on. It belongs to the person, as the selection does.
struct ChosenIncision {
    Id object = 0;
    int number = 0; // the first is 1
    bool operator==(const ChosenIncision&) const = default;
};

// The incision that is chosen in an object of the document; null: none is, or it is gone.
inline const NamedIncision* chosen_in(const Document& document, Id id, const ChosenIncision& chosen)
{
    const auto found = document.objects.find(id);
    if (id == 0 || chosen.object != id || found == document.objects.end()) return nullptr;
    const std::optional<Incising>& incising = found->second->incising;
    if (!incising || chosen.number < 1 ||
        static_cast<std::size_t>(chosen.number) > incising->cuts.size())
        return nullptr;
    return &incising->cuts[static_cast<std::size_t>(chosen.number) - 1];
}

} // namespace trivar
