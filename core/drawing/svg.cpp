// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/svg.h"

#include "core/drawing/line_list.h"
#include "core/drawing/svg_parts.h"
#include "core/drawing/svg_update.h"

#include <fmt/format.h>

namespace trivar {

std::string svg_of(const DrawingSheet& drawing)
{
    const SvgParts parts = svg_parts(drawing);
    if (!drawing.earlier.empty()) return updated_svg(drawing.earlier, parts);
    std::string out =
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"{}\"{}>\n"
                    "<desc id=\"{}\">{}</desc>\n",
                    inkscape_namespace, text_of(parts.size), line_list_id, parts.list);
    if (parts.paper) out += paper_text(*parts.paper);
    for (const SvgLayer& layer : parts.layers) out += text_of(layer);
    return out + "</svg>\n";
}

} // namespace trivar
