// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text_shape.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/text/letter.h"
#include "core/text/letters.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

namespace trivar {
namespace {

constexpr std::size_t most_letters = 2000, most_faces = 4000000;

// Returns the shape that replaces a letter that the font lacks.
Region frame()
{
    const auto box = [](double x0, double y0, double x1, double y1) {
        const auto u = [](double em) { return static_cast<int>(std::lround(em * em_units)); };
        return Loop{{u(x0), u(y0)}, {u(x1), u(y0)}, {u(x1), u(y1)}, {u(x0), u(y1)}};
    };
    const double width = double(Font::box_width) / em_units, gap = 0.06, line = 0.05;
    Loop hole = box(gap + line, line, width - gap - line, 0.7 - line);
    std::reverse(hole.begin(), hole.end());
    return {box(gap, 0, width - gap, 0.7), hole};
}

// Glyphs holds the bodies of the glyphs of a font; each is made once.
class Glyphs {
public:
    Glyphs(const Font& font, const TextShape& shape)
        : font_(font),
          tolerance_(shape.tolerance * em_units),
          extrusion_{.depth = shape.depth / shape.size,
                     .bevel = shape.bevel / shape.size,
                     .bevel_steps = shape.bevel_steps,
                     .max_edge = shape.max_edge}
    {
    }
    // Returns null if the glyph is empty.
    const Mesh* operator()(unsigned glyph)
    {
        const auto [entry, fresh] = bodies_.try_emplace(glyph);
        if (fresh) entry->second = made(glyph);
        return entry->second.face_count() > 0 ? &entry->second : nullptr;
    }
    bool damaged() const { return damaged_; }

private:
    Mesh made(unsigned glyph)
    {
        if (glyph != 0) {
            const Font::Glyph outline = font_.glyph(glyph, tolerance_);
            if (!outline.damaged) {
                const Region region = united(outline.loops, outline.even_odd);
                if (region.empty()) return {};
                if (auto body = letter_body(region, extrusion_)) return std::move(*body);
            }
            damaged_ = true;
        }
        return letter_body(frame(), extrusion_).value_or(Mesh{});
    }

    const Font& font_;
    double tolerance_;
    Extrusion extrusion_;
    std::map<unsigned, Mesh> bodies_;
    bool damaged_ = false;
};

void append(Mesh& mesh, const Mesh& letter, const glm::dvec2& at, double size,
            std::uint32_t& points)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    for (std::size_t v = 0; v < letter.vertex_count(); ++v) {
        const glm::dvec3 p = (glm::dvec3(letter.positions[v]) + glm::dvec3(at, 0)) * size;
        mesh.positions.push_back(glm::vec3(p) + 0.0f);
        mesh.points.push_back(points + letter.points[v]);
        mesh.uvs[0].push_back(letter.uvs[0][v] * static_cast<float>(size));
    }
    mesh.normals.insert(mesh.normals.end(), letter.normals.begin(), letter.normals.end());
    const auto corners = static_cast<std::uint32_t>(mesh.corners.size());
    for (const std::uint32_t corner : letter.corners) mesh.corners.push_back(first + corner);
    for (std::size_t f = 1; f < letter.face_begin.size(); ++f)
        mesh.face_begin.push_back(corners + letter.face_begin[f]);
    points += static_cast<std::uint32_t>(point_count(letter));
}

// Says whether a letter can be shown in a notice: others may be missing in the font of the window
// too, and a combining mark would join the comma before it.
bool is_drawn_nearly_everywhere(char32_t letter)
{
    constexpr char32_t latin_ends = 0x17F, greek_begins = 0x370, arabic_ends = 0x6FF;
    return letter <= latin_ends || (letter >= greek_begins && letter <= arabic_ends);
}

std::string lacking(const std::u32string& letters, const std::string& title)
{
    constexpr std::size_t named = 6;
    std::string list;
    for (std::size_t i = 0; i < std::min(named, letters.size()); ++i) {
        const std::string number = fmt::format("U+{:04X}", static_cast<std::uint32_t>(letters[i]));
        if (i > 0) list += ", ";
        list += is_drawn_nearly_everywhere(letters[i])
                    ? fmt::format("{} ({})", utf8_of(letters[i]), number)
                    : number;
    }
    if (letters.size() > named) list += " ...";
    return fmt::format("{} lacks {} of the text: {}; a box is shown for each", title,
                       letters.size() == 1 ? "one letter"
                                           : fmt::format("{} letters", with_commas(letters.size())),
                       list);
}

// Adds the letters of a line for which the font has no glyph, each once. Letters that are drawn
// together, such as a letter and its marks, are one cluster, named by its first letter.
void add_missing(std::u32string& missing, const Font& font, std::u32string_view letters,
                 const Font::Line& line)
{
    std::map<std::size_t, bool> clusters{{letters.size(), false}}; // by first letter: any missing
    for (const Font::PlacedGlyph& put : line.glyphs) clusters[put.letter] |= put.glyph == 0;
    const auto add = [&](char32_t letter) {
        if (missing.find(letter) == missing.npos) missing += letter;
    };
    for (auto it = clusters.begin(); std::next(it) != clusters.end(); ++it) {
        if (!it->second) continue;
        bool named = false;
        for (std::size_t i = it->first; i < std::next(it)->first; ++i) {
            if (is_ignorable(letters[i]) || font.has(letters[i])) continue;
            add(letters[i]);
            named = true;
        }
        if (!named) add(letters[it->first]); // removed by the tables of the font
    }
}

} // namespace

bool has_letters(const std::string& text)
{
    return !std::ranges::all_of(letters_of(text), is_blank);
}

void check(const TextShape& shape)
{
    const std::u32string letters = letters_of(shape.text);
    if (std::ranges::all_of(letters, is_blank)) throw Rejected("the text has no letters");
    if (letters.size() > most_letters)
        throw Rejected(fmt::format("the text has {} letters but at most {} are allowed",
                                   with_commas(letters.size()), with_commas(most_letters)));
    for (const char32_t letter : letters)
        if (is_control(letter) && !is_blank(letter))
            throw Rejected(fmt::format("the text holds the control character U+{:04X}; only line "
                                       "breaks and tabs are allowed",
                                       static_cast<unsigned>(letter)));
    if (!(shape.depth <= 20 * shape.size))
        throw Rejected("the depth of a text is at most 20 times its size");
}

TextBody text_body(const TextShape& shape, const Font& font)
{
    check(shape);
    TextBody body;
    body.mesh.uvs.resize(1);
    Glyphs glyphs(font, shape);
    std::u32string missing;
    std::uint32_t points = 0;
    const auto spacing = static_cast<int>(std::lround(shape.letter_spacing * em_units));
    double y = 0;
    for (const std::u32string& letters : lines_of(letters_of(shape.text))) {
        const Font::Line line = font.line(letters, spacing);
        add_missing(missing, font, letters, line);
        const double part = shape.align == TextAlign::left     ? 0
                            : shape.align == TextAlign::center ? 0.5
                                                               : 1;
        const double x = -part * line.width / em_units;
        for (const Font::PlacedGlyph& put : line.glyphs) {
            const Mesh* letter = glyphs(put.glyph);
            if (!letter) continue;
            if (body.mesh.face_count() + letter->face_count() > most_faces)
                throw Rejected(fmt::format("the text would have more than {} faces; use longer "
                                           "edges or a larger tolerance",
                                           with_commas(most_faces)));
            append(body.mesh, *letter, glm::dvec2(put.at) / double(em_units) + glm::dvec2(x, y),
                   shape.size, points);
        }
        y -= font.line_height() * shape.line_spacing;
    }
    if (!missing.empty()) body.notices.push_back(lacking(missing, font.title()));
    if (glyphs.damaged())
        body.notices.push_back("a letter of " + font.title() +
                               " has no outline that can be read; a box is shown instead");
    if (body.mesh.face_count() == 0) body.notices.emplace_back("the text has no visible letters");
    if (!shape.font_digest.empty() && shape.font_digest != font.digest())
        body.notices.push_back("the font " + font.title() + std::string(other_font_words));
    return body;
}

} // namespace trivar
