// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/wavefront/wavefront_names.h"

#include "core/files/text_scan.h"

#include <algorithm>
#include <array>

namespace trivar {
namespace {

constexpr int most_words = 16; // of a name after an unknown option

std::string_view without_quotes(std::string_view name)
{
    const bool quoted = name.size() > 2 && name.front() == '"' && name.back() == '"';
    return quoted ? name.substr(1, name.size() - 2) : name;
}

// Splits "a b.mtl c.mtl" into "a b.mtl" and "c.mtl".
std::vector<std::string_view> split_behind_mtl(std::string_view words)
{
    std::vector<std::string_view> names;
    TextScan scan(words);
    std::string_view name = scan.rest(); // to the end of the line, until its end is found
    for (auto word = scan.word(); !word.empty(); word = scan.word()) {
        if (!word.ends_with(".mtl") && !word.ends_with(".MTL")) continue;
        names.push_back(name.substr(0, static_cast<std::size_t>(scan.at - name.data())));
        name = scan.rest();
    }
    if (!name.empty()) names.push_back(name);
    return names;
}

// PictureOptions parses the options of a picture.
class PictureOptions {
public:
    PictureOptions(TextScan& scan, PictureLine& line) : scan_(scan), line_(line) {}

    // Reads up to the name, or up to an unknown option, which is returned.
    std::string_view read()
    {
        for (;;) {
            const TextScan before = scan_;
            const std::string_view option = scan_.word();
            if (option.size() < 2 || option[0] != '-' || !known(option)) {
                scan_ = before;
                return option.starts_with('-') ? option : std::string_view();
            }
        }
    }

private:
    bool known(std::string_view option)
    {
        if (option == "-s") return changes(option, 3, {1, 1, 1});
        if (option == "-o" || option == "-t") return changes(option, 3, {0, 0, 0});
        if (option == "-mm") return changes(option, 2, {0, 1, 0});
        if (option == "-bm") {
            line_.strength = number().value_or(1);
        } else if (option == "-clamp") {
            line_.clamped = on();
        } else if (option == "-cc" || option == "-blendu" || option == "-blendv") {
            on(); // colour correction, blurring beyond edges
        } else if (option == "-boost" || option == "-texres") {
            number(); // sharpness, size of the texture
        } else if (option == "-imfchan" || option == "-type" || option == "-colorspace") {
            scan_.word(); // channel of a gray picture, kind of a reflection, colour space
        } else {
            return false;
        }
        return true;
    }

    // Reads up to `most` numbers of an option and notes it as left out, unless they are its default
    // numbers, which have no effect.
    bool changes(std::string_view option, int most, const std::array<double, 3>& usual)
    {
        bool same = true;
        for (int i = 0; i < most; ++i)
            if (const auto value = number()) same &= *value == usual[static_cast<std::size_t>(i)];
        if (!same) line_.left_out.emplace_back(option);
        return true;
    }

    // Returns the next word if all of it is a number.
    std::optional<double> number()
    {
        TextScan ahead = scan_, word(ahead.word());
        const auto value = word.number();
        if (!value || !word.done()) return {};
        scan_ = ahead;
        return value;
    }

    bool on()
    {
        TextScan ahead = scan_;
        const std::string_view word = ahead.word();
        if (word == "on" || word == "off") scan_ = ahead;
        return word == "on";
    }

    TextScan& scan_;
    PictureLine& line_;
};

} // namespace

NamedLibraries libraries_named(std::string_view words, FolderFiles& files)
{
    NamedLibraries libraries;
    const auto found = [&](std::string_view name) {
        const auto file = files.find(without_quotes(name));
        if (file) libraries.found.push_back(*file);
        return file.has_value();
    };
    if (found(words)) return libraries;
    for (const std::string_view name : split_behind_mtl(words)) {
        if (found(name)) continue;
        bool any = false;
        TextScan scan(name);
        for (std::string_view word = scan.word(); !word.empty(); word = scan.word())
            any |= word.size() < name.size() && found(word);
        if (!any) libraries.missing.push_back(name);
    }
    return libraries;
}

bool names_picture(std::string_view keyword)
{
    constexpr std::array others{"norm", "bump", "disp", "decal", "refl"};
    return keyword.starts_with("map_") || std::ranges::find(others, keyword) != others.end();
}

PictureLine picture_line(std::string_view words, FolderFiles& files)
{
    PictureLine line;
    TextScan scan(words);
    const std::string_view unknown = PictureOptions(scan, line).read();
    line.name = without_quotes(scan.rest());
    line.file = files.find(line.name);
    if (line.file || unknown.empty()) return line;
    // An unknown option may have any number of words: the first rest of the line that is a file is
    // the name.
    line.left_out.emplace_back(unknown);
    for (int i = 0; i < most_words && !line.file; ++i) {
        scan.word();
        const std::string_view rest = without_quotes(scan.rest());
        if (rest.empty()) break;
        if (i == 0) line.name = rest;
        if ((line.file = files.find(rest))) line.name = rest;
    }
    return line;
}

} // namespace trivar
