// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <optional>
#include <vector>

namespace trivar {

// The body's own axis that a way goes about, at right angles to the plane in which it lies.
enum class RoundAxis { x, y, z };

// Whether a way about its Z axis is known exactly: a cylinder, a sphere, a torus, a Moebius band.
bool has_round_way(const Document& document, Id id);

// The visible bodies round which a way closes and that lie on no stroke themselves: all but the
// model, flat planes, groups and lattices.
std::vector<Id> bodies_to_go_round(const Session& session, Id model);

// A RoundWish is read from the selection: of two objects the model and the body, which is the one
// that has a round way, else the active one; of one the model, and the only body with a round way
// that there is. Nothing: it does not say.
struct RoundWish {
    Id model = 0, around = 0;
    RoundAxis axis = RoundAxis::z;
    std::optional<double> level = {}; // no value: as it lay round the body, or about its middle
};
std::optional<RoundWish> round_wish(const Session& session);

// Returns how an object lies round a body now; nothing: it does not.
std::optional<RoundWish> round_now(const Document& document, Id id);

// The command that lays the model round the body. It lies as it lay, or with its length along the
// way.
Command round_command(const Session& session, const RoundWish& wish);
// Runs it, one step; a notice says why it cannot be.
void lay_round(Session& session, const RoundWish& wish);

} // namespace trivar
