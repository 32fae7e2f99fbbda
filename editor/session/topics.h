// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// These are the topics of notices. A notice of a step replaces that of the step before; the same
// holds for saving.
inline constexpr const char* of_a_step = "step";
inline constexpr const char* of_saving = "saving";
inline constexpr const char* of_left_scene = "left scene"; // that an ended program left

} // namespace trivar
