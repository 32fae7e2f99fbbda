// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/preferences/preferences.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "editor/preferences/renamed_actions.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* whole_file = "the whole file";
constexpr std::size_t longest_list = most_remembered, longest_text = 4096,
                      largest_file = std::size_t{1} << 20, most_keys = 1000, longest_name = 60;

using OneOf = std::initializer_list<std::string_view>;

// A Reading is the one list of the preferences, for writing and for reading.
struct Reading {
    const Json& from;
    std::vector<std::string>& odd;

    // Returns the value of that name, if it is of the wanted kind.
    const Json* value_of(const char* name, bool (Json::*wanted)() const noexcept) const
    {
        const auto found = from.find(name);
        if (found == from.end()) return nullptr;
        if (((*found).*wanted)()) return &*found;
        odd.emplace_back(name);
        return nullptr;
    }
    void operator()(const char* name, double& value, double lo, double hi) const
    {
        const Json* found = value_of(name, &Json::is_number);
        if (!found) return;
        const auto number = found->get<double>();
        if (!(number >= lo && number <= hi)) odd.emplace_back(name);
        if (std::isfinite(number)) value = std::clamp(number, lo, hi);
    }
    void operator()(const char* name, bool& value) const
    {
        if (const Json* found = value_of(name, &Json::is_boolean)) value = found->get<bool>();
    }
    void operator()(const char* name, std::string& value, OneOf choices) const
    {
        const Json* found = value_of(name, &Json::is_string);
        if (!found) return;
        const auto& text = found->get_ref<const std::string&>();
        if (std::ranges::find(choices, text) != choices.end())
            value = text;
        else
            odd.emplace_back(name);
    }
    void operator()(const char* name, std::string& value) const
    {
        const Json* found = value_of(name, &Json::is_string);
        if (!found) return;
        const auto& text = found->get_ref<const std::string&>();
        if (text.size() <= longest_text)
            value = text;
        else
            odd.emplace_back(name);
    }
    void operator()(const char* name, std::vector<std::string>& value) const
    {
        const Json* found = value_of(name, &Json::is_array);
        if (!found) return;
        bool all = found->size() <= longest_list;
        for (const Json& each : *found) {
            if (value.size() == longest_list) break;
            const auto* text = each.get_ptr<const std::string*>();
            if (text && text->size() <= longest_text && !text->empty())
                value.push_back(*text);
            else
                all = false;
        }
        if (!all) odd.emplace_back(name);
    }
    void operator()(const char* name, KeyMap& value) const
    {
        const Json* found = value_of(name, &Json::is_object);
        if (!found) return;
        for (const auto& [action, keys] : found->items()) {
            const std::string now(present_action(action));
            if (now != action && found->contains(now)) continue; // the older one says less
            if (value.size() == most_keys || !read_chords(keys, value, now))
                odd.push_back(std::string(name) + ", " + action.substr(0, longest_name));
        }
    }
    // Whether all keys of an action could be read; what is no list leaves it its usual ones.
    static bool read_chords(const Json& keys, KeyMap& value, const std::string& action)
    {
        if (!keys.is_array()) return false;
        std::vector<ui::Chord>& chords = value[action];
        for (const Json& each : keys) {
            const auto* text = each.get_ptr<const std::string*>();
            const auto chord = text ? ui::chord_from(*text) : std::nullopt;
            if (chord && chords.size() < longest_list) chords.push_back(*chord);
        }
        return chords.size() == keys.size();
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
    field("timeline", p.timeline, 160.0, 4000.0);
    field("timeline_open", p.timeline_open);
    field("loop", p.loop);
    field("light", p.look.light);
    field("high_contrast", p.look.high_contrast);
    field("lines", p.look.lines, 1.0, 3.0);
    field("tooltip_s", p.look.tooltip_s, 0.0, 5.0);
    field("other_hues", p.look.other_hues);
    field("click_holds", p.look.click_holds);
    field("show_dock", p.show_dock);
    field("hints", p.hints);
    field("at_start", p.at_start, OneOf{"card", "last", "empty"});
    field("ask_to_keep", p.ask_to_keep);
    field("reduced_motion", p.reduced_motion);
    field("backdrop_as_in_pictures", p.backdrop_as_in_pictures);
    field("grid", p.grid);
    field("show_axes", p.show_axes);
    field("show_timing", p.show_timing);
    field("quality", p.quality, OneOf{"automatic", "draft", "standard", "high"});
    field("pace", p.pace, OneOf{"automatic", "60", "30", "15"});
    field("deform", p.deform,
          OneOf{"automatic", "processor", "one_phase", "two_phases", "differences", "raised",
                "filtered"});
    field("view_tolerance", p.view_tolerance, OneOf{"off", "2", "1", "0.5"});
    field("threads", p.threads, 0.0, 1024.0);
    field("mouse_device", p.mouse.device, OneOf{"automatic", "mouse", "trackpad"});
    field("mouse_emulation", p.mouse.emulation, OneOf{"alt", "super", "space", "none"});
    field("orbit_about", p.mouse.orbit_about, OneOf{"cursor", "selection", "origin"});
    field("zoom_to_cursor", p.mouse.zoom_to_cursor);
    field("reversed_zoom", p.mouse.reversed_zoom);
    field("orbit_speed", p.mouse.orbit, 0.1, 10.0);
    field("pan_speed", p.mouse.pan, 0.1, 10.0);
    field("zoom_speed", p.mouse.zoom, 0.1, 10.0);
    field("double_click_s", p.look.double_click_s, 0.1, 2.0);
    field("keys", p.keys);
    field("discarded_days", p.discarded_days, 1.0, 3650.0);
    field("most_recent", p.most_recent, 0.0, static_cast<double>(most_remembered));
    field("scenes_folder", p.scenes_folder);
    field("models_folder", p.models_folder);
    field("recent_commands", p.recent_commands);
    field("recent_scenes", p.recent_scenes);
    field("library_tiles", p.library_tiles);
    field("recent_views", p.recent_views);
    field("closed_hints", p.closed_hints);
}

// Empty where it is none that could be one; nothing where it cannot be read, as a folder cannot.
std::optional<std::string> read_small_file(const std::string& path)
{
    std::error_code why;
    const fs::file_status there = fs::status(path, why);
    if (there.type() == fs::file_type::not_found) return text_of(Preferences());
    if (!fs::is_regular_file(there)) return std::nullopt;
    if (fs::file_size(path, why) > largest_file || why) return std::string();
    try {
        return read_text_file(path);
    } catch (const Rejected&) {
        return std::nullopt;
    }
}

// The first name with .odd after it that no other file has.
std::string odd_name(const std::string& path)
{
    constexpr int most = 1000;
    std::error_code ignored;
    std::string name = path + ".odd";
    for (int i = 2; i < most && fs::exists(fs::symlink_status(name, ignored)); ++i)
        name = path + ".odd" + std::to_string(i);
    return name;
}

std::string words_of_odd(const std::string& path, const std::vector<std::string>& odd)
{
    if (odd.empty()) return {};
    if (odd.front() == whole_file) {
        const std::string kept = odd_name(path);
        std::error_code trouble;
        fs::rename(path, kept, trouble);
        return path + " cannot be understood, so the default preferences are used." +
               (trouble ? "" : " It is kept as " + fs::path(kept).filename().string() + ".");
    }
    const std::string more =
        odd.size() > 1 ? " and " + std::to_string(odd.size() - 1) + " more" : "";
    return path + " has invalid values (" + odd.front() + more +
           "): the nearest valid ones are used.";
}

} // namespace

ReadPreferences read_preferences(std::string_view text)
{
    constexpr int deepest = 4; // so that brackets cannot exhaust the stack
    const auto shallow = [](int depth, Json::parse_event_t, Json&) { return depth <= deepest; };
    ReadPreferences read;
    const Json object = Json::parse(text, shallow, false);
    if (object.is_object())
        each_preference(read.preferences, Reading{object, read.odd});
    else
        read.odd.emplace_back(whole_file);
    return read;
}

std::string text_of(const Preferences& preferences)
{
    Json object = Json::object();
    each_preference(preferences, Writing{object});
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void remember(std::vector<std::string>& recent, const std::string& what, std::size_t most)
{
    std::erase(recent, what);
    recent.insert(recent.begin(), what);
    if (recent.size() > most) recent.resize(most);
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

PreferencesFile::PreferencesFile(std::string path) : path_(std::move(path))
{
    if (path_.empty()) return;
    const std::optional<std::string> text = read_small_file(path_);
    if (!text) {
        trouble_ = path_ + " cannot be read, so the default preferences are used. The file stays "
                           "as it is; changes that you make now are lost when the window closes.";
        path_.clear(); // in memory
        return;
    }
    ReadPreferences read = read_preferences(*text);
    kept_ = std::move(read.preferences);
    trouble_ = words_of_odd(path_, read.odd);
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
    return path_ + " cannot be written. Your changes are lost when the window closes.";
}

} // namespace trivar
