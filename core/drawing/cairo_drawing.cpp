// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/cairo_drawing.h"

#include "core/base/rejected.h"
#include "core/drawing/line_list.h"
#include "core/drawing/line_pieces.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <memory>

namespace trivar {
namespace {

struct CairoEnd {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};
using Surface = std::unique_ptr<cairo_surface_t, CairoEnd>;
using Cairo = std::unique_ptr<cairo_t, CairoEnd>;

cairo_status_t keep_bytes(void* out, const unsigned char* data, unsigned length)
{
    for (unsigned i = 0; i < length; ++i)
        static_cast<std::string*>(out)->push_back(static_cast<char>(data[i]));
    return CAIRO_STATUS_SUCCESS;
}

void use_color(cairo_t* cairo, const glm::vec3& color, float opacity)
{
    cairo_set_source_rgba(cairo, color.r, color.g, color.b, opacity);
}

void paint_line(cairo_t* cairo, const InkedLine& line)
{
    for (const LinePiece& piece : pieces_of(line)) {
        use_color(cairo, piece.color, line.opacity);
        if (is_one_stroke(line)) {
            for (const InkedLine::Point& p : piece.points)
                cairo_line_to(cairo, double{p.at.x}, double{p.at.y});
            const double dash = dash_of(line), dashes[2]{dash, dash};
            cairo_set_dash(cairo, dashes, dash > 0 ? 2 : 0, piece.along);
            cairo_set_line_cap(cairo, dash > 0 ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
            cairo_set_line_width(cairo, double{width_of(line)});
            cairo_stroke(cairo);
        } else {
            for (const glm::dvec2& p : outline_of(piece.points)) cairo_line_to(cairo, p.x, p.y);
            cairo_close_path(cairo);
            cairo_fill(cairo);
        }
    }
}

void paint(cairo_surface_t* surface, const DrawingSheet& drawing)
{
    const Cairo cairo(cairo_create(surface));
    if (drawing.paper) {
        use_color(cairo.get(), *drawing.paper, 1);
        cairo_paint(cairo.get());
    }
    cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
    for (const DrawingLayer& layer : drawing.layers)
        for (const bool hidden : {true, false})
            for (const InkedLine& line : layer.lines)
                if (line.hidden == hidden && line.points.size() >= 2) paint_line(cairo.get(), line);
    if (const cairo_status_t status = cairo_status(cairo.get()))
        throw Rejected(std::string("the drawing cannot be painted: ") +
                       cairo_status_to_string(status));
}

} // namespace

std::string pdf_of(const DrawingSheet& drawing)
{
    std::string out;
    {
        const Surface surface(
            cairo_pdf_surface_create_for_stream(keep_bytes, &out, drawing.size.x, drawing.size.y));
        // A date of its own, so that the same drawing gives the same bytes.
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                       "2000-01-01T00:00:00Z");
        paint(surface.get(), drawing);
        cairo_surface_finish(surface.get());
    }
    return out;
}

std::string png_of(const DrawingSheet& drawing)
{
    std::string out;
    const Surface surface(cairo_image_surface_create(
        CAIRO_FORMAT_ARGB32, static_cast<int>(drawing.size.x), static_cast<int>(drawing.size.y)));
    paint(surface.get(), drawing);
    if (const cairo_status_t status =
            cairo_surface_write_to_png_stream(surface.get(), keep_bytes, &out))
        throw Rejected(std::string("the picture cannot be written: ") +
                       cairo_status_to_string(status));
    return out;
}

} // namespace trivar
