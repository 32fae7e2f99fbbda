// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/drawing_file.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/drawing/cairo_drawing.h"
#include "core/drawing/line_list.h"
#include "core/drawing/svg.h"

#include <fmt/format.h>
#include <iterator>

namespace trivar {
namespace {

constexpr std::array<std::string_view, 4> endings{".svg", ".pdf", ".png", ".obj"};

// The lines in space: an object per layer, metres.
std::string obj_of(const DrawingSheet& drawing)
{
    std::string out;
    std::size_t first = 1;
    const std::vector<std::string> ids = layer_ids(drawing.layers);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        fmt::format_to(std::back_inserter(out), "o {}\n", ids[i]);
        for (const InkedLine& line : drawing.layers[i].lines) {
            if (line.points.size() < 2) continue;
            for (const InkedLine::Point& point : line.points) {
                const glm::dvec3 p(drawing.to_metres * glm::dvec4(point.p, 1));
                fmt::format_to(std::back_inserter(out), "v {:.7g} {:.7g} {:.7g}\n", p.x, p.y, p.z);
            }
            fmt::format_to(std::back_inserter(out), "g {}\nl", line_id(ids[i], line));
            for (std::size_t k = 0; k < line.points.size(); ++k)
                fmt::format_to(std::back_inserter(out), " {}", first + k);
            out += '\n';
            first += line.points.size();
        }
    }
    return out;
}

} // namespace

bool is_line_sheet(std::string_view path)
{
    return path.ends_with(".svg") || path.ends_with(".pdf");
}

DrawingFormat drawing_format(std::string_view path)
{
    for (std::size_t i = 0; i < endings.size(); ++i)
        if (path.size() > endings[i].size() && path.ends_with(endings[i]))
            return static_cast<DrawingFormat>(i);
    throw Rejected(fmt::format("\"{}\": a drawing is written as {}", excerpt(std::string(path)),
                               fmt::join(endings, ", ")));
}

std::string drawing_bytes(const DrawingSheet& drawing, DrawingFormat format)
{
    switch (format) {
    case DrawingFormat::svg: return svg_of(drawing);
    case DrawingFormat::pdf: return pdf_of(drawing);
    case DrawingFormat::png: return png_of(drawing);
    case DrawingFormat::obj: return obj_of(drawing);
    }
    return {};
}

} // namespace trivar
