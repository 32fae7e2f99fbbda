// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/hands/gesture.h"

#include "core/base/rejected.h"

#include <array>
#include <nlohmann/json.hpp>

namespace trivar::testing {
namespace {

using GestureJson = nlohmann::ordered_json;

constexpr std::array kind_names{"stroke",  "click",   "choose", "wheel", "chord",  "type",  "field",
                                "palette", "command", "drop",   "save",  "resize", "focus", "card"};

// Calls each(name, member of the gesture) for whatever has a plain value.
template <class Gestured, class Each> void each_value(Gestured& g, Each each)
{
    each("tool", g.tool);
    each("in", g.area);
    each("text", g.text);
    each("end", g.end);
    each("number", g.number);
    each("frames", g.frames);
    each("button", g.button);
    each("twice", g.twice);
    each("keeps", g.keeps);
    each("hasty", g.hasty);
    each("blind", g.blind);
    each("held", g.held);
    each("between", g.between);
    each("at", g.at);
}

} // namespace

std::string text_of(const Gesture& gesture)
{
    GestureJson out;
    out["do"] = kind_names[static_cast<std::size_t>(gesture.kind)];
    for (const glm::dvec2& p : gesture.points) out["points"].push_back({p.x, p.y});
    const GestureJson usual = [] {
        GestureJson all;
        const Gesture none;
        each_value(none, [&](const char* name, const auto& value) { all[name] = value; });
        return all;
    }();
    each_value(gesture, [&](const char* name, const auto& value) {
        if (const GestureJson now = value; now != usual[name]) out[name] = now;
    });
    return out.dump(-1, ' ', true);
}

Gesture gesture_from(const std::string& line)
{
    try {
        const GestureJson in = GestureJson::parse(line);
        Gesture out;
        const auto kind = std::ranges::find(kind_names, in.at("do").get<std::string>());
        if (kind == kind_names.end()) throw Rejected("a gesture is of no known kind");
        out.kind = static_cast<Gesture::Kind>(kind - kind_names.begin());
        for (const GestureJson& p : in.value("points", GestureJson::array()))
            out.points.emplace_back(p.at(0).get<double>(), p.at(1).get<double>());
        each_value(out, [&]<class T>(const char* name, T& value) {
            if (in.contains(name)) value = in[name].get<T>();
        });
        return out;
    } catch (const GestureJson::exception&) {
        throw Rejected("a gesture cannot be read");
    }
}

} // namespace trivar::testing
