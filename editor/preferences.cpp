// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/preferences.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t longest_list = 16, longest_text = 4096, largest_file = std::size_t{1} << 20,
                      most_keys = 1000;

// One list of what is kept and what may be read.
struct Reading {
    const Json& from;
    void operator()(const char* name, double& value, double lo, double hi) const
    {
        const auto found = from.find(name);
        if (found == from.end() || !found->is_number()) return;
        const auto number = found->get<double>();
        if (std::isfinite(number)) value = std::clamp(number, lo, hi);
    }
    void operator()(const char* name, bool& value) const
    {
        const auto found = from.find(name);
        if (found != from.end() && found->is_boolean()) value = found->get<bool>();
    }
    void operator()(const char* name, std::string& value,
                    std::initializer_list<std::string_view> choices) const
    {
        const auto found = from.find(name);
        if (found == from.end() || !found->is_string()) return;
        const auto& text = found->get_ref<const std::string&>();
        if (std::ranges::find(choices, text) != choices.end()) value = text;
    }
    void operator()(const char* name, std::vector<std::string>& value) const
    {
        const auto found = from.find(name);
        if (found == from.end() || !found->is_array()) return;
        for (const Json& each : *found) {
            if (value.size() == longest_list) return;
            if (!each.is_string()) continue;
            const auto& text = each.get_ref<const std::string&>();
            if (text.size() <= longest_text && !text.empty()) value.push_back(text);
        }
    }
    void operator()(const char* name, KeyMap& value) const
    {
        const auto found = from.find(name);
        if (found == from.end() || !found->is_object()) return;
        for (const auto& [action, keys] : found->items()) {
            if (!keys.is_array() || value.size() == most_keys) continue;
            std::vector<ui::Chord>& chords = value[action];
            for (const Json& each : keys)
                if (each.is_string() && chords.size() < longest_list)
                    if (const auto chord = ui::chord_from(each.get_ref<const std::string&>()))
                        chords.push_back(*chord);
        }
    }
};
Json written(const auto& value)
{
    return value;
}
Json written(const KeyMap& map)
{
    Json object = Json::object();
    for (const auto& [name, keys] : map) {
        object[name] = Json::array();
        for (const ui::Chord& chord : keys) object[name].push_back(ui::text_of(chord));
    }
    return object;
}
struct Writing {
    Json& to;
    void operator()(const char* name, const auto& value, auto...) const
    {
        to[name] = written(value);
    }
};
void each_preference(auto& p, const auto& field)
{
    field("scale", p.scale, interface_scales.front(), interface_scales.back());
    field("dock", p.dock, 280.0, 480.0);
    field("outliner", p.outliner, 120.0, 4000.0);
    field("timeline", p.timeline, 160.0, 296.0);
    field("timeline_open", p.timeline_open);
    field("loop", p.loop);
    field("light", p.look.light);
    field("high_contrast", p.look.high_contrast);
    field("other_hues", p.look.other_hues);
    field("show_dock", p.show_dock);
    field("hints", p.hints);
    field("reduced_motion", p.reduced_motion);
    field("backdrop_as_in_pictures", p.backdrop_as_in_pictures);
    field("quality", p.quality,
          std::initializer_list<std::string_view>{"automatic", "draft", "standard", "high"});
    field("deform", p.deform,
          std::initializer_list<std::string_view>{"processor", "one_phase", "two_phases"});
    field("keys", p.keys);
    field("recent_commands", p.recent_commands);
    field("recent_scenes", p.recent_scenes);
}

std::string read_small_file(const std::string& path)
{
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) > largest_file)
        return {};
    try {
        return read_text_file(path);
    } catch (const Rejected&) {
        return {};
    }
}

} // namespace

Preferences preferences_from(std::string_view text)
{
    constexpr int deepest = 4; // so that brackets cannot exhaust the stack
    const auto shallow = [](int depth, Json::parse_event_t, Json&) { return depth <= deepest; };
    Preferences preferences;
    const Json object = Json::parse(text, shallow, false);
    if (object.is_object()) each_preference(preferences, Reading{object});
    return preferences;
}

std::string text_of(const Preferences& preferences)
{
    Json object = Json::object();
    each_preference(preferences, Writing{object});
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void remember(std::vector<std::string>& recent, const std::string& what)
{
    std::erase(recent, what);
    recent.insert(recent.begin(), what);
    if (recent.size() > longest_list) recent.resize(longest_list);
}

double next_scale(double scale, int direction)
{
    constexpr double nearly = 1e-6;
    if (direction > 0) {
        for (const double each : interface_scales)
            if (each > scale + nearly) return each;
        return interface_scales.back();
    }
    double lower = interface_scales.front();
    for (const double each : interface_scales)
        if (each < scale - nearly) lower = each;
    return lower;
}

PreferencesFile::PreferencesFile(std::string path)
    : path_(std::move(path)),
      kept_(path_.empty() ? Preferences() : preferences_from(read_small_file(path_)))
{
}

std::string PreferencesFile::keep(const Preferences& preferences)
{
    if (preferences == kept_) return {};
    kept_ = preferences;
    if (path_.empty()) return {};
    std::error_code error;
    fs::create_directories(fs::path(path_).parent_path(), error);
    const std::string beside = path_ + ".new"; // so that a crash leaves the old one whole
    std::ofstream file(beside, std::ios::binary | std::ios::trunc);
    file << text_of(preferences);
    file.close();
    if (file) fs::rename(beside, path_, error);
    const bool well = file && !error;
    if (well || failed_) return {};
    failed_ = true;
    return path_ + " cannot be written. The arrangement of this window is gone when it closes.";
}

} // namespace trivar
