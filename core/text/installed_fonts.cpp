// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/installed_fonts.h"

#include "core/base/ordinary_file.h"
#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fontconfig/fontconfig.h>
#include <memory>

namespace trivar {
namespace {

constexpr const char* stand_in = "DejaVu Sans";

std::string text_of(FcPattern* font, const char* field, int n = 0)
{
    FcChar8* text = nullptr;
    if (FcPatternGetString(font, field, n, &text) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(text);
}

int number_of(FcPattern* font, const char* field, int otherwise)
{
    double value = otherwise;
    FcPatternGetDouble(font, field, 0, &value); // variable font: a range, `otherwise` stays
    return static_cast<int>(std::lround(value));
}

std::string small_letters(std::string text)
{
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

InstalledFont described(FcPattern* font)
{
    InstalledFont one{.family = text_of(font, FC_FAMILY),
                      .style = text_of(font, FC_STYLE),
                      .path = text_of(font, FC_FILE)};
    FcPatternGetInteger(font, FC_INDEX, 0, &one.face);
    one.plainness = std::abs(number_of(font, FC_WEIGHT, FC_WEIGHT_REGULAR) - FC_WEIGHT_REGULAR) +
                    std::abs(number_of(font, FC_WIDTH, FC_WIDTH_NORMAL) - FC_WIDTH_NORMAL) +
                    number_of(font, FC_SLANT, FC_SLANT_ROMAN);
    return one;
}

Font font_of_file(const std::string& path, int face)
{
    std::unique_ptr<OrdinaryFile> file;
    try {
        file = std::make_unique<OrdinaryFile>(path);
    } catch (const Rejected&) {
        throw Rejected("the font " + printable(path) + " cannot be opened");
    }
    if (file->size() > Font::most_bytes)
        throw Rejected("the font " + printable(path) + " has more than 256 MB");
    std::string bytes(static_cast<std::size_t>(file->size()), ' ');
    try {
        file->read(bytes);
    } catch (const Rejected&) {
        throw Rejected("the font " + printable(path) + " cannot be read completely");
    }
    return {std::move(bytes), face, printable(path)};
}

} // namespace

std::vector<InstalledFont> installed_fonts()
{
    const std::unique_ptr<FcConfig, void (*)(FcConfig*)> config(FcInitLoadConfigAndFonts(),
                                                                FcConfigDestroy);
    const std::unique_ptr<FcPattern, void (*)(FcPattern*)> wanted(FcPatternCreate(),
                                                                  FcPatternDestroy);
    FcPatternAddBool(wanted.get(), FC_OUTLINE, FcTrue);
    FcPatternAddBool(wanted.get(), FC_VARIABLE, FcFalse); // instances are listed
    const std::unique_ptr<FcObjectSet, void (*)(FcObjectSet*)> fields(
        FcObjectSetBuild(FC_FAMILY, FC_STYLE, FC_FILE, FC_INDEX, FC_WEIGHT, FC_WIDTH, FC_SLANT,
                         FC_FONTFORMAT, nullptr),
        FcObjectSetDestroy);
    const std::unique_ptr<FcFontSet, void (*)(FcFontSet*)> set(
        FcFontList(config.get(), wanted.get(), fields.get()), FcFontSetDestroy);
    std::vector<InstalledFont> fonts;
    for (int i = 0; set && i < set->nfont; ++i) {
        FcPattern* font = set->fonts[i];
        const std::string format = text_of(font, FC_FONTFORMAT), path = text_of(font, FC_FILE);
        const bool sfnt = format == "TrueType" || (format == "CFF" && !path.ends_with(".pfb"));
        if (sfnt && !path.ends_with(".t1")) fonts.push_back(described(font));
    }
    std::ranges::sort(fonts, [](const InstalledFont& a, const InstalledFont& b) {
        return std::tuple(a.title(), a.path, a.face) < std::tuple(b.title(), b.path, b.face);
    });
    return fonts;
}

const InstalledFont* named_font(const std::vector<InstalledFont>& fonts, const std::string& name)
{
    const std::string wanted = small_letters(name);
    const InstalledFont* best = nullptr;
    for (const InstalledFont& font : fonts) {
        if (small_letters(font.title()) == wanted) return &font;
        if (small_letters(font.family) == wanted && (!best || font.plainness < best->plainness))
            best = &font;
    }
    return best;
}

bool is_font_path(const std::string& name)
{
    const std::string small = small_letters(name);
    return name.find('/') != name.npos || small.ends_with(".ttf") || small.ends_with(".otf") ||
           small.ends_with(".ttc") || small.ends_with(".otc");
}

FoundFont find_font(const std::string& name)
{
    std::string trouble = "the font \"" + printable(name) + "\" is not on this computer";
    if (is_font_path(name)) try {
            return {font_of_file(name, 0), {}};
        } catch (const Rejected& why) {
            trouble = why.what();
        }
    const std::vector<InstalledFont> fonts = installed_fonts();
    const InstalledFont* font = is_font_path(name) ? nullptr : named_font(fonts, name);
    const bool found = font != nullptr;
    if (!font) font = named_font(fonts, stand_in);
    if (!font && !fonts.empty()) font = &fonts.front();
    if (!font) throw Rejected(trouble + ", and there is no other");
    FoundFont result{font_of_file(font->path, font->face), {}};
    if (!found) result.notices.push_back(trouble + ": " + result.font.title() + " is used instead");
    return result;
}

} // namespace trivar
