// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/text/font_state.h"

#include <algorithm>
#include <array>
#include <fribidi.h>

namespace trivar {
namespace {

struct Run {
    std::size_t begin, end; // range of letters in the line
    int level;              // odd: right to left
    hb_script_t script;
};

std::vector<FriBidiLevel> levels_of(std::u32string_view letters)
{
    const auto count = static_cast<FriBidiStrIndex>(letters.size());
    std::vector<FriBidiChar> text(letters.begin(), letters.end());
    std::vector<FriBidiCharType> types(letters.size());
    std::vector<FriBidiBracketType> brackets(letters.size());
    std::vector<FriBidiLevel> levels(letters.size());
    fribidi_get_bidi_types(text.data(), count, types.data());
    fribidi_get_bracket_types(text.data(), count, types.data(), brackets.data());
    FriBidiParType direction = FRIBIDI_PAR_ON; // direction of the first letter that has one
    if (fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), count, &direction,
                                            levels.data()) == 0)
        throw Rejected("there is not enough memory to lay out the text");
    return levels;
}

// Splits a line into runs in reading order. Spaces, marks and signs belong to the script before
// them.
std::vector<Run> runs_of(std::u32string_view letters)
{
    const std::vector<FriBidiLevel> levels = levels_of(letters);
    hb_unicode_funcs_t* unicode = hb_unicode_funcs_get_default();
    std::vector<Run> runs;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const hb_script_t script = hb_unicode_script(unicode, letters[i]);
        const bool of_any = script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED ||
                            script == HB_SCRIPT_UNKNOWN;
        const int level = levels[i];
        if (!runs.empty() && runs.back().level == level) {
            Run& run = runs.back();
            if (run.script == HB_SCRIPT_COMMON && !of_any) run.script = script;
            if (of_any || run.script == script) {
                run.end = i + 1;
                continue;
            }
        }
        runs.push_back({i, i + 1, level, of_any ? HB_SCRIPT_COMMON : script});
    }
    return runs;
}

// Orders runs from left to right: rule L2 of the bidirectional algorithm, over runs instead of
// letters.
void order_by_sight(std::vector<Run>& runs)
{
    int highest = 0;
    for (const Run& run : runs) highest = std::max(highest, run.level);
    for (int level = highest; level > 0; --level)
        for (auto from = runs.begin(); from != runs.end();) {
            const auto in = [level](const Run& run) { return run.level >= level; };
            from = std::find_if(from, runs.end(), in);
            const auto to = std::find_if_not(from, runs.end(), in);
            std::reverse(from, to);
            from = to;
        }
}

void shape(hb_font_t* font, std::u32string_view letters, const Run& run, int spacing,
           Font::Line& line)
{
    hb_buffer_t* buffer = hb_buffer_create();
    static_assert(sizeof(char32_t) == sizeof(std::uint32_t));
    hb_buffer_add_utf32(buffer, reinterpret_cast<const std::uint32_t*>(letters.data()),
                        static_cast<int>(letters.size()), static_cast<unsigned>(run.begin),
                        static_cast<int>(run.end - run.begin));
    hb_buffer_set_direction(buffer, run.level % 2 == 1 ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer, run.script);
    hb_buffer_set_language(buffer, hb_language_from_string("und", -1)); // not the user's
    hb_buffer_set_cluster_level(buffer, HB_BUFFER_CLUSTER_LEVEL_MONOTONE_GRAPHEMES);
    const std::array<hb_feature_t, 2> apart{
        {{HB_TAG('l', 'i', 'g', 'a'), 0, 0, ~0u}, {HB_TAG('c', 'l', 'i', 'g'), 0, 0, ~0u}}};
    hb_shape(font, buffer, apart.data(), spacing != 0 ? 2 : 0);
    unsigned count = 0;
    const hb_glyph_info_t* glyphs = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer, &count);
    constexpr int farthest = 1 << 28; // limit of the pen position for damaged fonts
    for (unsigned i = 0; i < count; ++i) {
        const auto far = [](int step) { return std::clamp(step, -most_units, most_units); };
        line.glyphs.push_back(
            {glyphs[i].codepoint,
             glm::ivec2(line.width + far(places[i].x_offset), far(places[i].y_offset)),
             glyphs[i].cluster});
        const bool last = i + 1 == count || glyphs[i + 1].cluster != glyphs[i].cluster;
        const int advance = glyphs[i].codepoint == 0 ? Font::box_width : far(places[i].x_advance);
        line.width = std::clamp(line.width + advance + (last ? spacing : 0), -farthest, farthest);
    }
    hb_buffer_destroy(buffer);
}

} // namespace

Font::Line Font::line(std::u32string_view letters, int spacing) const
{
    Line line;
    if (letters.empty()) return line;
    std::vector<Run> runs = runs_of(letters);
    order_by_sight(runs);
    for (const Run& run : runs) shape(state_->shaper, letters, run, spacing, line);
    if (!line.glyphs.empty()) line.width -= spacing; // no spacing after the last letter
    return line;
}

} // namespace trivar
