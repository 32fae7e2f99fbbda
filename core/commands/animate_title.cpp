// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/keying.h"
#include "core/commands/objects/animate.h"
#include "core/commands/words/field_words.h"
#include "core/commands/words/number_words.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <set>

namespace trivar {
namespace {

// Names the changed numbers, as "Position Z"; several by their common part, as "Position".
std::string numbers_in(const Animate& c)
{
    std::set<std::string> names, rows;
    for (const auto& [id, tracks] : c.of)
        for (const Track& track : tracks) {
            const std::string& name = track.parameter;
            names.insert(name);
            const bool axis = name.size() > 2 && name[name.size() - 2] == '.' &&
                              std::isdigit(static_cast<unsigned char>(name.back())) == 0;
            rows.insert(axis ? name.substr(0, name.size() - 2) : name);
        }
    if (names.size() == 1) return words_of_number(*names.begin()).label;
    if (rows.size() == 1) return words_of_number(*rows.begin()).label;
    return fmt::format("{} values", names.size());
}

// Describes the one key that changed, if there is exactly one: its value and its frame.
std::string key_in(const Document& before, const Animate& c)
{
    if (c.of.size() != 1 || c.of[0].tracks.size() != 1) return {};
    const auto& [id, tracks] = c.of[0];
    const bool known = id == 0 || before.objects.contains(id);
    const Track* had = known ? track_of(before, id, tracks[0].parameter) : nullptr;
    std::vector<Key> others = had ? had->keys : std::vector<Key>{}, changed;
    for (const Key& key : tracks[0].keys)
        if (std::erase(others, key) == 0) changed.push_back(key);
    if (changed.size() != 1 || others.size() > 1) return {};
    const std::vector<Parameter> all = id == 0 ? scene_parameters(before)
                                       : known ? parameters(*before.objects.at(id))
                                               : std::vector<Parameter>{};
    const auto number = std::ranges::find(all, tracks[0].parameter, &Parameter::name);
    if (number == all.end()) return {};
    return fmt::format("{} in frame {}", words_of_value(*number, changed[0].value),
                       number_text(changed[0].frame));
}

} // namespace

StepTitle title(const Animate& c, const StepDocuments& step)
{
    std::vector<Id> ids;
    bool clears = true;
    for (const auto& [id, tracks] : c.of) {
        ids.push_back(id);
        for (const Track& track : tracks) clears = clears && track.keys.empty();
    }
    const bool scene = ids.size() == 1 && ids.front() == 0;
    std::string what = numbers_in(c) + " of " + (scene ? "the scene" : names_in(step.before, ids));
    what[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(what[0])));
    return {(clears ? "Clear keys of " : "Animate ") + what, key_in(step.before, c)};
}

} // namespace trivar
