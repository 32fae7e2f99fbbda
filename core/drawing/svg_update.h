// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/svg_parts.h"

#include <string>
#include <string_view>

namespace trivar {

inline constexpr std::string_view inkscape_namespace =
    "http://www.inkscape.org/namespaces/inkscape";

// The text of an .svg that was drawn here, with a drawing in place of the one in it. Each line that
// is still drawn stays where it stands, with the attributes that are a person's; lines that are
// new come after those before them in their layer. Lines that a person does not display stay as
// they are. All else stays byte for byte. What was not drawn here is replaced as a whole: empty.
// Throws Rejected as svg_elements() does.
std::string updated_svg(std::string_view earlier, const SvgParts& parts);

} // namespace trivar
