// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaper.h"
#include "editor/session/session.h"

namespace trivar {

inline constexpr const char* allow_folds_action = "Allow folds here";

// The result of the last step that shaped an object's volume, proposed or done; null: none.
const Shaping* last_shaping(const Session& session, Id id);

// Allows folds in some parts; an empty list does nothing.
void allow_folds(Session& session, Id id, const std::vector<VolumePart>& parts);

// A part and, where wanted, the one on the other side of the middle.
std::vector<VolumePart> with_mirrored(const VolumePart& part, bool mirror);

// An amount in metres, without its sign.
std::string amount_words(double metres);

// Tells that the volume of that object would have folded, and how far "The press" came. Offers to
// let it fold in those parts.
void tell_where_it_stopped(Session& session, const Shaping& step, const std::string& what,
                           const std::string& remedy, Id id, const std::vector<VolumePart>& parts);

} // namespace trivar
