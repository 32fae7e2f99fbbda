// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// The topics of notices. What is told of one step takes the place of what was told of the one
// before; so with saving.
inline constexpr const char* of_a_step = "step";
inline constexpr const char* of_saving = "saving";

} // namespace trivar
