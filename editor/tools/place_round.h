// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <optional>
#include <vector>

namespace trivar {

// The visible bodies round which a way closes and that lie on no stroke themselves: cylinders,
// spheres, tori and Moebius bands other than the model.
std::vector<Id> bodies_to_go_round(const Session& session, Id model);

// What the selection says about going round: of two objects the model and the body, which is the
// active one where both could be it; of one the model, and the only body that there is. Nothing: it
// does not say.
struct RoundWish {
    Id model = 0, around = 0;
};
std::optional<RoundWish> round_wish(const Session& session);

// Lays the model round the body, one step; a notice says why it cannot be. It lies as it lay, or
// with its length along the way.
void lay_round(Session& session, const RoundWish& wish);

} // namespace trivar
