// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/parameters.h"

#include "core/base/rejected.h"
#include "core/document/check_view.h"
#include "core/document/fields/object_fields.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Calls leaf(name, number, rule) for the numbers, choices and switches in a value, nested ones
// included, that can have keys. The name is one string that grows and shrinks on the way.
template <class T, class Leaf> void walk(std::string& name, T& value, const Rule& rule, Leaf&& leaf)
{
    [[maybe_unused]] const std::size_t length = name.size();
    using V = std::remove_const_t<T>;
    if (rule.fixed) return;
    if constexpr (Nested<V>)
        each_field(value, [&](std::string_view inner, auto& v, std::string_view,
                              const Rule& inner_rule = {}) {
            if (!inner_rule.inlined) name.append(name.empty() ? "" : ".").append(inner);
            walk(name, v, inner_rule, leaf);
            name.resize(length);
        });
    else if constexpr (std::is_arithmetic_v<V> || std::is_enum_v<V>)
        leaf(name, value, rule);
    else if constexpr (std::is_same_v<V, std::string>) {
        if (!rule.choices.empty()) leaf(name, value, rule);
    } else if constexpr (is_optional<V>) {
        if (value) walk(name, *value, rule, leaf);
    } else if constexpr (is_choice<V>) {
        std::visit([&](auto& chosen) { walk(name, chosen, rule, leaf); }, value);
    } else if constexpr (is_ref<V>) {
        if constexpr (std::is_const_v<T>)
            walk(name, *value, rule, leaf);
        else {
            std::remove_const_t<typename V::element_type> changed = *value;
            walk(name, changed, rule, leaf);
            if (changed != *value) value = make_ref(std::move(changed));
        }
    } else if constexpr (is_list<V>) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            walk(name.append(".").append(std::to_string(i)), value[i], rule, leaf);
            name.resize(length);
        }
    } else if constexpr (requires { V::length(); })
        for (int i = 0; i < V::length(); ++i) {
            leaf(name.append(".").append(1, "xyzw"[i]), value[i], rule);
            name.resize(length);
        }
}

template <class T, class Leaf> void walk_from(std::string name, T& value, Leaf&& leaf)
{
    walk(name, value, {}, leaf);
}

std::vector<std::string_view> choices_in(std::string_view listed) // the list is separated by |
{
    std::vector<std::string_view> out;
    for (std::size_t at = 0; at <= listed.size();) {
        const std::size_t end = std::min(listed.find('|', at), listed.size());
        out.push_back(listed.substr(at, end - at));
        at = end + 1;
    }
    return out;
}

// Makes the parameter of a value, without its name.
template <class T> Parameter parameter_of(const std::string& name, const T& value, const Rule& rule)
{
    using Kind = Parameter::Kind;
    Parameter out{.name = name,
                  .lo = rule.lo,
                  .hi = rule.hi,
                  .unit = rule.unit,
                  .yes = rule.yes,
                  .no = rule.no};
    const auto choose = [&out](std::size_t chosen, std::vector<std::string_view> choices) {
        out.value = static_cast<double>(chosen);
        out.lo = 0;
        out.hi = static_cast<double>(choices.size() - 1);
        out.kind = Kind::choice;
        out.choices = std::move(choices);
    };
    if constexpr (std::is_enum_v<T>)
        choose(static_cast<std::size_t>(value), {choice_names<T>.begin(), choice_names<T>.end()});
    else if constexpr (std::is_same_v<T, std::string>) {
        const std::vector<std::string_view> all = choices_in(rule.choices);
        const auto at = std::ranges::find(all, value);
        choose(at == all.end() ? 0 : static_cast<std::size_t>(at - all.begin()), all);
    } else {
        out.value = static_cast<double>(value);
        const bool quarters = name.ends_with(".roll_deg");
        out.kind = std::is_same_v<T, bool>             ? Kind::on_off
                   : std::is_integral_v<T> || quarters ? Kind::whole
                                                       : Kind::number;
        if (out.kind == Kind::on_off) {
            out.lo = 0;
            out.hi = 1;
        }
    }
    return out;
}

auto gather(std::vector<Parameter>& to)
{
    return [&to](const std::string& name, const auto& value, const Rule& rule) {
        to.push_back(parameter_of(name, value, rule));
    };
}

auto change(const NewValue& to)
{
    return [&to]<class T>(const std::string& name, T& value, const Rule& rule) {
        const std::optional<double> number = to(name);
        if (!number) return;
        const Parameter range = parameter_of(name, value, rule);
        double taken = std::clamp(*number, range.lo, range.hi);
        if (range.stays()) taken = std::round(taken);
        if constexpr (std::is_same_v<T, std::string>)
            value = range.choices[static_cast<std::size_t>(taken)];
        else if constexpr (std::is_enum_v<T>)
            value = static_cast<T>(static_cast<int>(taken));
        else
            value = static_cast<T>(taken);
        if constexpr (std::is_floating_point_v<T>) {
            constexpr float least_scale = 1e-6f;
            if (value == 0 && name.starts_with("transform.scale.")) value = least_scale;
        }
    };
}

NewValue values_at(const std::vector<Track>& tracks, double frame)
{
    return [&tracks, frame](const std::string& name) -> std::optional<double> {
        const auto found = std::ranges::lower_bound(tracks, name, {}, &Track::parameter);
        if (found == tracks.end() || found->parameter != name) return {};
        return value_at(*found, frame);
    };
}

} // namespace

Track as_taken(Track track, const Parameter& parameter)
{
    if (parameter.stays())
        for (Key& key : track.keys) {
            key.value = std::round(key.value);
            key.tween = Tween::step;
        }
    return track;
}

std::vector<Parameter> parameters(const Object& object)
{
    std::vector<Parameter> out;
    walk_from("", object, gather(out));
    return out;
}

std::vector<Parameter> scene_parameters(const Document& document)
{
    std::vector<Parameter> out;
    walk_from("render", *document.render, gather(out));
    for (const auto& [name, camera] : document.kept_views)
        walk_from("camera." + name, camera, gather(out));
    return out;
}

Object with_values(Object object, const NewValue& value)
{
    walk_from("", object, change(value));
    return object;
}

Document with_scene_values(Document document, const NewValue& value)
{
    RenderSettings settings = *document.render;
    walk_from("render", settings, change(value));
    if (settings != *document.render) document.render = make_ref(std::move(settings));
    for (auto& [name, camera] : document.kept_views) {
        Camera moved = camera;
        walk_from("camera." + name, moved, change(value));
        try {
            check_view(moved);
            camera = moved;
        } catch (const Rejected&) { // the view would have no direction; it keeps its value
        }
    }
    return document;
}

Document document_at(const Document& document, double frame)
{
    Document out = document;
    for (const auto& [id, object] : document.objects)
        if (!object->tracks.empty()) {
            Object moved = with_values(*object, values_at(object->tracks, frame));
            if (moved != *object) out.objects.set(id, make_ref(std::move(moved)));
        }
    if (!document.tracks->empty())
        out = with_scene_values(std::move(out), values_at(*document.tracks, frame));
    return out;
}

} // namespace trivar
