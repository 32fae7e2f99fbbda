// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/shader_source.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <set>
#include <sstream>

namespace trivar::gpu {
namespace {

using Place = ShaderSource::Place;

std::optional<std::string_view> text_of(std::string_view name, const ShaderTexts* texts)
{
    if (texts)
        if (const auto found = texts->find(name); found != texts->end()) return found->second;
    return shader_file(name);
}

struct Pasting {
    const ShaderTexts* texts;
    ShaderSource out = {};
    std::set<std::string, std::less<>> seen = {};

    void add(const std::string& line, Place place)
    {
        out.text += line + '\n';
        out.places.push_back(std::move(place));
    }
    void paste(const std::string& name, const Place& from)
    {
        if (!seen.insert(name).second) return;
        const auto text = text_of(name, texts);
        if (!text)
            throw Rejected(fmt::format("{}:{}: there is no shader file {}.", from.file, from.line,
                                       printable(name)));
        std::istringstream in{std::string(*text)};
        std::string line;
        for (int number = 1; std::getline(in, line); ++number) {
            if (line.starts_with("#include")) {
                const auto begin = line.find('"') + 1;
                paste(line.substr(begin, line.rfind('"') - begin), {name, number});
            } else {
                add(line, {name, number});
            }
        }
    }
};

std::string in_small_letters(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// The first line that tells of an error, or the first of all.
std::string telling_line(const std::string& log)
{
    std::istringstream in(log.substr(0, log.find('\0')));
    std::string first, line;
    while (std::getline(in, line)) {
        if (in_small_letters(line).find("error") != std::string::npos) return line;
        if (first.empty()) first = line;
    }
    return first;
}

} // namespace

std::vector<ShaderStage> stages(const ProgramName& name)
{
    std::vector<ShaderStage> out;
    const auto add = [&](const std::string& base, const char* kind) {
        if (!base.empty()) out.push_back({kind, base + '.' + kind + ".glsl"});
    };
    add(name.vertex, "vert");
    add(name.geometry, "geom");
    add(name.fragment, "frag");
    add(name.compute, "comp");
    return out;
}

ShaderSource shader_source(const std::string& file, const std::vector<std::string>& defines,
                           const ShaderTexts* texts, int gl_version)
{
    Pasting pasting{texts};
    const Place top{file, 1};
    pasting.add(gl_version < 43 ? "#version 330 core" : "#version 430 core", top);
    if (gl_version < 43)
        for (const std::string name : {"420pack", "packing"})
            pasting.add("#extension GL_ARB_shading_language_" + name + " : require", top);
    for (const std::string& define : defines) pasting.add("#define " + define, top);
    pasting.paste(file, top);
    return std::move(pasting.out);
}

std::string first_error(const std::string& log, const ShaderSource& source)
{
    // "0:12(5): error: what", "ERROR: 0:12: what" or "0(12) : error C1008: what".
    const std::string said = telling_line(log);
    const std::size_t at = std::min(said.find("0:"), said.find("0("));
    std::size_t line = 0;
    if (at == std::string::npos) return said;
    const char* const end = said.data() + said.size();
    const auto read = std::from_chars(said.data() + at + 2, end, line);
    if (line < 1 || line > source.places.size()) return said;
    std::string_view what(read.ptr, end);
    if (what.starts_with('(')) what.remove_prefix(std::min(what.find(')') + 1, what.size()));
    const auto skip_marks = [&] {
        what.remove_prefix(std::min(what.find_first_not_of(" :)"), what.size()));
    };
    skip_marks();
    constexpr std::string_view word = "error";
    if (in_small_letters(std::string(what.substr(0, word.size()))) == word)
        what.remove_prefix(word.size());
    skip_marks();
    const Place& place = source.places[line - 1];
    const std::string& whole = source.places.front().file;
    return fmt::format("{}:{}{}: {}", place.file, place.line,
                       place.file == whole ? "" : " (in " + whole + ")", what);
}

} // namespace trivar::gpu
