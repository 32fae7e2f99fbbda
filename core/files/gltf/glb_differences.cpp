// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/glb_differences.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/gltf/glb_chunks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace trivar {
namespace {

using FoundJson = nlohmann::json;

bool is_near(double found, double expected)
{
    return std::abs(found - expected) <= glb_number_tolerance * std::max(1.0, std::abs(expected));
}

// Parses JSON. Throws Rejected if an object has two members of one name, because programs differ in
// which one they read.
FoundJson parsed(const std::string& text)
{
    std::vector<std::set<std::string>> names;
    return FoundJson::parse(text, [&](int, FoundJson::parse_event_t event, const FoundJson& value) {
        if (event == FoundJson::parse_event_t::object_start) names.emplace_back();
        if (event == FoundJson::parse_event_t::object_end) names.pop_back();
        if (event == FoundJson::parse_event_t::key &&
            !names.back().insert(value.get<std::string>()).second)
            throw Rejected("its JSON has a name twice: " + printable(value.get<std::string>()));
        return true;
    });
}

std::string short_text(const FoundJson& value)
{
    constexpr std::size_t most = 40;
    const std::string text =
        printable(value.dump(-1, ' ', false, FoundJson::error_handler_t::replace));
    return text.size() <= most ? text : text.substr(0, most) + "...";
}

class Differences {
public:
    Differences(const std::string& found, const std::string& expected)
        : found_(glb_chunks(found)),
          expected_(glb_chunks(expected)),
          json_(FoundJson::parse(expected_.json))
    {
        if (glb_container(found_) != found) say("it is not two chunks of JSON and data");
        FoundJson read = parsed(found_.json);
        if (read.is_object()) read.erase("extras");
        json_.erase("extras");
        compare(read, json_, {});
        if (sentences.empty()) compare_data();
    }

    std::vector<std::string> sentences;

private:
    static constexpr std::size_t most_sentences = 6;

    bool full() const { return sentences.size() >= most_sentences; }
    void say(std::string sentence)
    {
        if (!full()) sentences.push_back(std::move(sentence));
        if (full()) sentences.back() = "and more is not as the scene gives it";
    }

    void compare(const FoundJson& found, const FoundJson& expected, const std::string& place)
    {
        if (full()) return;
        if (expected.is_object() && found.is_object())
            return compare_entries(found, expected, place);
        if (expected.is_array() && found.is_array()) {
            if (found.size() != expected.size())
                return say(fmt::format("its {} has {} entries, the scene gives {}", place,
                                       with_commas(found.size()), with_commas(expected.size())));
            for (std::size_t i = 0; i < found.size(); ++i)
                compare(found[i], expected[i], fmt::format("{}[{}]", place, i));
            return;
        }
        if (expected.is_number_float() && found.is_number() &&
            is_near(found.get<double>(), expected.get<double>()))
            return;
        if (!expected.is_number_float() && found.type() == expected.type() && found == expected)
            return;
        say(fmt::format("its {} is {}, the scene gives {}", place, short_text(found),
                        short_text(expected)));
    }

    void compare_entries(const FoundJson& found, const FoundJson& expected,
                         const std::string& place)
    {
        const std::string owner = place.empty() ? "it" : "its " + place;
        const std::string inside = place.empty() ? "" : place + ".";
        for (const auto& [name, value] : found.items())
            if (!expected.contains(name))
                say(fmt::format("{} has {}, which the scene does not give it", owner,
                                short_text(name)));
        for (const auto& [name, value] : expected.items())
            if (!found.contains(name))
                say(fmt::format("{} has no {}, which the scene gives it", owner, name));
            else
                compare(found[name], value, inside + name);
    }

    // Compares the data. From here on both files have the layout of the expected one, which is
    // trusted.
    void compare_data()
    {
        if (found_.binary.size() != expected_.binary.size())
            return say(fmt::format("it has {} bytes of data, the scene gives {}",
                                   with_commas(found_.binary.size()),
                                   with_commas(expected_.binary.size())));
        std::set<FoundJson> seen; // accessors
        for (const FoundJson& mesh : json_.value("meshes", FoundJson::array()))
            for (const FoundJson& primitive : mesh.at("primitives")) {
                const std::string whose = printable(mesh.value("name", std::string()));
                for (const auto& [name, accessor] : primitive.at("attributes").items())
                    if (seen.insert(accessor).second) compare_values(accessor, name, whose);
                if (!primitive.contains("indices")) continue; // a line
                seen.insert(primitive.at("indices"));
                compare_values(primitive.at("indices"), "indices", whose);
                std::size_t number = 0;
                for (const FoundJson& target : primitive.value("targets", FoundJson::array())) {
                    ++number;
                    for (const auto& [name, accessor] : target.items())
                        if (seen.insert(accessor).second)
                            compare_values(accessor, fmt::format("{} in target {}", name, number),
                                           whose);
                }
            }
        const FoundJson accessors = json_.value("accessors", FoundJson::array());
        for (std::size_t a = 0; a < accessors.size(); ++a) // of animations and skins
            if (seen.insert(a).second) compare_values(a, "keys", {});
        for (const FoundJson& image : json_.value("images", FoundJson::array()))
            if (!same_bytes(image.at("bufferView")))
                say(fmt::format("its image {} is another than the scene's",
                                printable(image.value("name", std::string()))));
    }

    const FoundJson& view(const FoundJson& index) const
    {
        return json_.at("bufferViews").at(index.get<std::size_t>());
    }

    bool same_bytes(const FoundJson& view_index) const
    {
        const FoundJson& range = view(view_index);
        const auto begin = range.at("byteOffset").get<std::size_t>(),
                   size = range.at("byteLength").get<std::size_t>();
        return found_.binary.compare(begin, size, expected_.binary, begin, size) == 0;
    }

    void compare_values(const FoundJson& index, const std::string& name, const std::string& whose)
    {
        const FoundJson& accessor = json_.at("accessors").at(index.get<std::size_t>());
        const bool floats = accessor.at("componentType") == 5126;
        if (accessor.contains("bufferView"))
            compare_numbers(accessor.at("bufferView"), floats, name, whose);
        if (!accessor.contains("sparse")) return;
        const FoundJson& sparse = accessor.at("sparse");
        compare_numbers(sparse.at("indices").at("bufferView"), false, name, whose);
        compare_numbers(sparse.at("values").at("bufferView"), floats, name, whose);
    }

    void compare_numbers(const FoundJson& view_index, bool floats, const std::string& name,
                         const std::string& whose)
    {
        if (same_bytes(view_index)) return;
        const FoundJson& range = view(view_index);
        const auto begin = range.at("byteOffset").get<std::size_t>(),
                   end = begin + range.at("byteLength").get<std::size_t>();
        std::size_t others = 0;
        for (std::size_t at = begin; at + 4 <= end; at += 4) {
            float now, then;
            std::memcpy(&now, found_.binary.data() + at, 4);
            std::memcpy(&then, expected_.binary.data() + at, 4);
            const bool same = found_.binary.compare(at, 4, expected_.binary, at, 4) == 0;
            if (!same && (!floats || !is_near(now, then))) ++others;
        }
        if (others > 0)
            say(fmt::format("{} of the {} numbers of {}'s {} are not the scene's",
                            with_commas(others), with_commas((end - begin) / 4),
                            whose.empty() ? "a mesh" : whose, name));
    }

    GlbChunks found_, expected_;
    FoundJson json_; // the expected one
};

} // namespace

std::vector<std::string> glb_differences(const std::string& found, const std::string& expected)
{
    try {
        return Differences(found, expected).sentences;
    } catch (const FoundJson::exception&) {
        throw Rejected("this is not a GLB file as Trivar writes them");
    }
}

} // namespace trivar
