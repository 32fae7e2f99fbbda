// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/font.h"

#include "core/base/digest.h"
#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/text/flatten.h"
#include "core/text/font_state.h"

#include <array>
#include <cmath>
#include FT_OUTLINE_H
#include <hb-ot.h>

namespace trivar {
namespace {

constexpr std::size_t most_outline_points = 10000;

// An Outliner collects an outline from FreeType. Its steps return 0 to continue.
struct Outliner {
    double units_per_step = 1, tolerance = 1;
    Region loops = {};
    std::size_t points = 0;
    glm::dvec2 last{0};

    glm::dvec2 units(const FT_Vector* v) const
    {
        return glm::dvec2(static_cast<double>(v->x), static_cast<double>(v->y)) * units_per_step;
    }
    int begin(const FT_Vector* v)
    {
        last = units(v);
        if (!fits(last)) return 1;
        loops.push_back({glm::ivec2(glm::round(last))});
        return ++points > most_outline_points ? 1 : 0;
    }
    template <class... Control> int go(const Control*... control)
    {
        const std::array<glm::dvec2, sizeof...(control) + 1> p{last, units(control)...};
        for (const glm::dvec2& each : p)
            if (!fits(each)) return 1;
        const std::size_t before = loops.back().size();
        if constexpr (p.size() == 2)
            loops.back().emplace_back(glm::round(p[1]));
        else
            append_curve(loops.back(), p, tolerance);
        points += loops.back().size() - before;
        last = p.back();
        return points > most_outline_points ? 1 : 0;
    }
    static bool fits(const glm::dvec2& p)
    {
        return std::abs(p.x) < most_units - 1 && std::abs(p.y) < most_units - 1;
    }
};

Outliner& outliner(void* user)
{
    return *static_cast<Outliner*>(user);
}

constexpr FT_Outline_Funcs walk{
    [](const FT_Vector* to, void* user) { return outliner(user).begin(to); },
    [](const FT_Vector* to, void* user) { return outliner(user).go(to); },
    [](const FT_Vector* c, const FT_Vector* to, void* user) { return outliner(user).go(c, to); },
    [](const FT_Vector* c, const FT_Vector* d, const FT_Vector* to, void* user) {
        return outliner(user).go(c, d, to);
    },
    0,
    0};

} // namespace

FontState::~FontState()
{
    hb_font_destroy(shaper);
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
}

Font::Font(std::string bytes, int face, const std::string& name)
    : state_(std::make_unique<FontState>())
{
    FontState& s = *state_;
    ensure(bytes.size() <= most_bytes, "a font is too large");
    s.bytes = std::move(bytes);
    if (FT_Init_FreeType(&s.library) != 0 ||
        FT_New_Memory_Face(s.library, reinterpret_cast<const FT_Byte*>(s.bytes.data()),
                           static_cast<FT_Long>(s.bytes.size()), face, &s.face) != 0)
        throw Rejected(name + ": this is not a font file that Trivar can read");
    if (!FT_IS_SCALABLE(s.face) || !FT_IS_SFNT(s.face) || s.face->units_per_EM == 0)
        throw Rejected(name + ": the font is not a TrueType or OpenType font with outlines");
    hb_blob_t* blob = hb_blob_create(s.bytes.data(), static_cast<unsigned>(s.bytes.size()),
                                     HB_MEMORY_MODE_READONLY, nullptr, nullptr);
    hb_face_t* tables = hb_face_create(blob, static_cast<unsigned>(face) & 0xFFFFu);
    s.shaper = hb_font_create(tables);
    hb_face_destroy(tables);
    hb_blob_destroy(blob);
    hb_ot_font_set_funcs(s.shaper);
    hb_font_set_scale(s.shaper, em_units, em_units);
    if (const unsigned instance = static_cast<unsigned>(face) >> 16; instance > 0)
        hb_font_set_var_named_instance(s.shaper, instance - 1);
    Digest digest;
    digest.add_text(s.bytes);
    digest.add(face);
    s.digest = digest.hex();
    s.title = printable(s.face->family_name ? s.face->family_name : "a font without a name");
    if (s.face->style_name) s.title += " " + printable(s.face->style_name);
}

Font::~Font() = default;
Font::Font(Font&&) noexcept = default;

Font::Glyph Font::glyph(unsigned index, double tolerance) const
{
    const FT_Face face = state_->face;
    if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) !=
            0 ||
        face->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
        return {.loops = {}, .damaged = true};
    Outliner outliner{.units_per_step = double(em_units) / face->units_per_EM,
                      .tolerance = tolerance};
    if (FT_Outline_Decompose(&face->glyph->outline, &walk, &outliner) != 0)
        return {.loops = {}, .damaged = true};
    return {.loops = std::move(outliner.loops),
            .even_odd = (face->glyph->outline.flags & FT_OUTLINE_EVEN_ODD_FILL) != 0};
}

bool Font::has(char32_t letter) const
{
    hb_codepoint_t glyph = 0;
    return hb_font_get_nominal_glyph(state_->shaper, letter, &glyph) != 0 && glyph != 0;
}

double Font::line_height() const
{
    const double height = double(state_->face->height) / state_->face->units_per_EM;
    return height > 0.1 && height < 10 ? height : 1.2; // a damaged font may give any number
}

const std::string& Font::title() const
{
    return state_->title;
}

const std::string& Font::digest() const
{
    return state_->digest;
}

} // namespace trivar
