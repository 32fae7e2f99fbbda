// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/every_command.h"
#include "core/document/field.h"
#include "editor/commands/typed_command.h"

namespace trivar {
namespace {

std::vector<std::string> verbs()
{
    std::vector<std::string> words;
    for (const Command& each : every_command()) words.emplace_back(verb(each));
    words.insert(words.end(), {"undo", "redo"});
    return words;
}

std::vector<std::string> fields_of(std::string_view name)
{
    std::vector<std::string> words;
    for (const Command& each : every_command())
        if (verb(each) == name)
            visit(
                [&](const auto& command) {
                    each_field(command, [&](std::string_view field, auto&&...) {
                        words.emplace_back(field);
                        words.back() += '=';
                    });
                },
                each);
    return words;
}

std::vector<std::string> names_of(const Document& document)
{
    std::vector<std::string> words;
    for (const auto& [id, each] : document.objects)
        if (each->name.find_first_of("\"\\") == std::string::npos)
            words.push_back(each->name.find(' ') == std::string::npos ? each->name
                                                                      : '"' + each->name + '"');
    return words;
}

} // namespace

Completion completed(std::string_view text, const Document& document)
{
    const std::size_t blank = text.find_last_of(' ');
    std::size_t begin = blank == text.npos ? 0 : blank + 1;
    std::vector<std::string> words;
    bool verb_here = false;
    if (begin == 0) {
        words = verbs();
        verb_here = true;
    } else if (const std::size_t equals = text.find('=', begin); equals == text.npos) {
        words = fields_of(text.substr(0, text.find(' ')));
        std::erase_if(words, [&](const std::string& field) {
            return text.find(" " + field) != text.npos; // given already
        });
    } else {
        const std::string_view field = text.substr(begin, equals - begin);
        if (names_object(field) || names_objects(field)) words = names_of(document);
        begin = equals + 1;
    }
    const std::string_view typed = text.substr(begin);
    std::erase_if(words, [&](const std::string& word) { return !word.starts_with(typed); });
    Completion result{std::string(text), words};
    if (words.empty()) return result;
    std::string common = words.front();
    for (const std::string& word : words) {
        std::size_t same = 0;
        while (same < common.size() && same < word.size() && common[same] == word[same]) ++same;
        common.resize(same);
    }
    result.text = std::string(text.substr(0, begin)) + common;
    if (words.size() == 1 && (verb_here || !common.ends_with('='))) result.text += ' ';
    return result;
}

} // namespace trivar
