// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session.h"

namespace trivar {

// What became of the last step that shaped an object's volume, proposed or done; null: none.
const Shaping* last_shaping(const Session& session, Id id);

// As metres, without the sign.
std::string amount_words(double metres);

// Tells that the volume would have folded, and how far "The press" came.
void tell_where_it_stopped(Session& session, const Shaping& step, const std::string& what,
                           const std::string& remedy);

} // namespace trivar
