// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "ui/theme.h"

#include <algorithm>
#include <cmath>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <imgui.h>
#include <imgui_freetype.h>
#include <string>
#include FT_FREETYPE_H

namespace trivar::ui {
namespace {

// The upright file of this family and weight, or nothing. Fontconfig's "closest match" is no use
// here: it would quietly answer with another family. Nor are style names: "Black" is a style of
// Inter's that also calls itself "Regular".
std::string font_file(const char* family, int weight)
{
    FcPattern* pattern =
        FcPatternBuild(nullptr, FC_FAMILY, FcTypeString, family, FC_WEIGHT, FcTypeInteger, weight,
                       FC_SLANT, FcTypeInteger, FC_SLANT_ROMAN, nullptr);
    FcObjectSet* objects = FcObjectSetBuild(FC_FILE, nullptr);
    FcFontSet* found = FcFontList(nullptr, pattern, objects);
    std::string file;
    for (int i = 0; found && i < found->nfont; ++i) {
        FcChar8* name = nullptr;
        if (FcPatternGetString(found->fonts[i], FC_FILE, 0, &name) != FcResultMatch) continue;
        const std::string candidate = reinterpret_cast<const char*>(name);
        if (file.empty() || candidate < file) file = candidate; // the same one on every run
    }
    if (found) FcFontSetDestroy(found);
    FcObjectSetDestroy(objects);
    FcPatternDestroy(pattern);
    return file;
}

// ImGui's FreeType builder rounds every advance up, which sets small text half a pixel too wide a
// letter. This puts back the designed widths, rounded to the nearest pixel so that stems stay
// sharp.
void restore_advances(ImFont* font, const std::string& file, float line_px)
{
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    if (FT_Init_FreeType(&library)) return;
    if (!FT_New_Face(library, file.c_str(), 0, &face)) {
        const float per_unit = line_px / static_cast<float>(face->ascender - face->descender);
        for (ImFontGlyph& g : font->Glyphs) {
            if (g.Codepoint >= 0xF000 && g.Codepoint < 0xF300) continue; // icons
            const FT_UInt index = FT_Get_Char_Index(face, g.Codepoint);
            if (!index || FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE)) continue;
            g.AdvanceX =
                std::round(static_cast<float>(face->glyph->metrics.horiAdvance) * per_unit);
            if (static_cast<int>(g.Codepoint) < font->IndexAdvanceX.Size) {
                font->IndexAdvanceX[g.Codepoint] = g.AdvanceX;
            }
        }
        FT_Done_Face(face);
    }
    FT_Done_FreeType(library);
}

// Gives the ten digits one width, so that numbers do not dance while they are dragged.
void make_figures_tabular(ImFont* font)
{
    float widest = 0;
    for (ImWchar c = '0'; c <= '9'; ++c) {
        if (const ImFontGlyph* g = font->FindGlyphNoFallback(c))
            widest = std::max(widest, g->AdvanceX);
    }
    for (ImFontGlyph& g : font->Glyphs) {
        if (g.Codepoint < '0' || g.Codepoint > '9') continue;
        const float shift = std::floor((widest - g.AdvanceX) / 2);
        g.X0 += shift;
        g.X1 += shift;
        g.AdvanceX = widest;
        if (static_cast<int>(g.Codepoint) < font->IndexAdvanceX.Size)
            font->IndexAdvanceX[g.Codepoint] = widest;
    }
}

} // namespace

Fonts load_fonts(float scale)
{
    const std::string regular = font_file("Inter", FC_WEIGHT_REGULAR);
    const std::string medium = font_file("Inter", FC_WEIGHT_MEDIUM);
    const std::string strong = font_file("Inter", FC_WEIGHT_DEMIBOLD);
    const std::string mono = font_file("DejaVu Sans Mono", FC_WEIGHT_REGULAR);
    const std::string others = font_file("DejaVu Sans", FC_WEIGHT_REGULAR);
    const std::string icons = font_file("FontAwesome", FC_WEIGHT_REGULAR);
    std::string missing;
    if (regular.empty() || medium.empty() || strong.empty()) missing += ", Inter (fonts-inter)";
    if (mono.empty() || others.empty()) missing += ", DejaVu Sans and Mono (fonts-dejavu-core)";
    if (icons.empty()) missing += ", FontAwesome 4.7 (fonts-font-awesome)";
    if (!missing.empty()) throw Rejected("These fonts are not installed:" + missing.substr(1));

    // Latin, Greek, Cyrillic, punctuation, arrows, mathematics, geometric shapes.
    static const ImWchar letters[] = {0x20,   0x17F,  0x370,  0x52F,  0x2010, 0x2044,
                                      0x2070, 0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF,
                                      0x2300, 0x23FF, 0x25A0, 0x25FF, 0};
    // Hebrew and Arabic, which Inter lacks, for what people write themselves.
    static const ImWchar right_to_left[] = {0x590, 0x6FF, 0};
    static const ImWchar pictures[] = {0xF000, 0xF2E0, 0};

    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.TexDesiredWidth = scale > 1.5f ? 4096 : 2048;
    const unsigned hinting =
        scale < 1.5f ? ImGuiFreeTypeBuilderFlags_LightHinting : ImGuiFreeTypeBuilderFlags_NoHinting;

    // `line` is ascent + descent in pixels at scale 1: 16 is Inter at 13 px an em.
    const auto add = [&](const std::string& file, float line, float icon) {
        ImFontConfig text;
        text.FontBuilderFlags = hinting;
        text.RasterizerMultiply = 1.08f; // light text on dark looks thinner than it is
        text.GlyphExtraSpacing.x = 0;
        ImFont* font =
            atlas.AddFontFromFileTTF(file.c_str(), std::round(line * scale), &text, letters);
        if (icon > 0) {
            ImFontConfig merge;
            merge.MergeMode = true;
            merge.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_NoHinting;
            merge.GlyphOffset.y = std::round((icon - line) * 0.5f * scale * 0.5f);
            atlas.AddFontFromFileTTF(icons.c_str(), std::round(icon * scale), &merge, pictures);
        }
        return font;
    };
    // To the font that was added last.
    const auto add_right_to_left = [&](float line) {
        ImFontConfig merge;
        merge.MergeMode = true;
        merge.FontBuilderFlags = hinting;
        atlas.AddFontFromFileTTF(others.c_str(), std::round(line * scale), &merge, right_to_left);
    };
    Fonts f{};
    f.body = add(regular, 16, 14);
    add_right_to_left(16);
    f.strong = add(strong, 16, 14);
    f.small = add(medium, 14, 12);
    add_right_to_left(14);
    f.small_strong = add(strong, 14, 12);
    f.title = add(strong, 20, 16);
    f.display = add(strong, 32, 0);
    f.mono = add(mono, 14, 0);
    f.tool = add(regular, 16, 18);
    f.large_icon = add(regular, 16, 28);
    if (!atlas.Build()) throw Rejected("The font texture could not be built.");
    struct BuiltFont {
        ImFont* font;
        const std::string& file;
        float line;
    };
    for (const BuiltFont& b :
         {BuiltFont{f.body, regular, 16}, BuiltFont{f.strong, strong, 16},
          BuiltFont{f.small, medium, 14}, BuiltFont{f.small_strong, strong, 14},
          BuiltFont{f.title, strong, 20}, BuiltFont{f.display, strong, 32}}) {
        restore_advances(b.font, b.file, std::round(b.line * scale));
        make_figures_tabular(b.font);
    }
    ImGui::GetIO().FontDefault = f.body;
    return f;
}

} // namespace trivar::ui
