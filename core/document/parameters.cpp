// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/parameters.h"

#include "core/base/rejected.h"
#include "core/document/commands/check.h"
#include "core/document/commands/place.h"
#include "core/document/commands/primitives.h"
#include "core/document/commands/refine.h"
#include "core/document/commands/shape.h"
#include "core/document/commands/text.h"
#include "core/document/commands/view.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Calls leaf(name, number, rule) for the numbers in a value and all that it has inside.
template <class T, class Leaf>
void walk(const std::string& name, T& value, const Rule& rule, Leaf&& leaf)
{
    using V = std::remove_const_t<T>;
    if constexpr (Nested<V>)
        each_field(value,
                   [&](std::string_view inner, auto& v, std::string_view, const Rule& r = {}) {
                       walk(name + "." + std::string(inner), v, r, leaf);
                   });
    else if constexpr (std::is_same_v<V, bool> || std::is_floating_point_v<V>)
        leaf(name, value, rule);
    else if constexpr (is_optional<V>) {
        if (value) walk(name, *value, rule, leaf);
    } else if constexpr (is_list<V>) {
        if constexpr (!std::is_same_v<typename V::value_type, StrokeSample>)
            for (std::size_t i = 0; i < value.size(); ++i)
                walk(name + "." + std::to_string(i), value[i], rule, leaf);
    } else if constexpr (requires { V::length(); }) {
        if constexpr (std::is_floating_point_v<typename V::value_type>)
            for (int i = 0; i < V::length(); ++i) leaf(name + "." + "xyzw"[i], value[i], rule);
    }
}

template <class O, class Leaf> void walk_object(O& object, Leaf&& leaf)
{
    walk("transform", object.transform, {}, leaf);
    leaf("hidden", object.hidden, {});
    std::visit(
        [&]<class S>(S& source) {
            using V = std::remove_const_t<S>;
            if constexpr (!std::is_same_v<V, GroupShape> && !std::is_same_v<V, ImportedFile>)
                walk("shape", source, {}, leaf);
        },
        object.source);
    if (object.surfacing) walk("material", *object.surfacing, {}, leaf);
    if (object.placement) {
        walk("placement", object.placement->parameters, {}, leaf);
        if (object.placement->round) leaf("placement.level", object.placement->level, {});
    }
    for (std::size_t i = 0; i < object.shaping.size(); ++i) {
        const std::string name = "shaping." + std::to_string(i);
        if constexpr (std::is_const_v<O>)
            walk(name, *object.shaping[i], {}, leaf);
        else {
            VolumeEdit edit = *object.shaping[i];
            walk(name, edit, {}, leaf);
            if (edit != *object.shaping[i]) object.shaping[i] = make_ref(std::move(edit));
        }
    }
    leaf("playing.offset", object.playing.offset, between(-1e6, 1e6));
    if (object.refining) leaf("refining.tolerance", object.refining->tolerance, positive);
}

auto gather(std::vector<Parameter>& to)
{
    return [&to](const std::string& name, const auto& value, const Rule& rule) {
        constexpr bool is_switch = std::is_same_v<decltype(value), const bool&>;
        to.push_back({name, static_cast<double>(value), is_switch ? 0 : rule.lo,
                      is_switch ? 1 : rule.hi, is_switch});
    };
}

auto change(const NewValue& to)
{
    return [&to](const std::string& name, auto& value, const Rule& rule) {
        const std::optional<double> number = to(name);
        if (!number) return;
        if constexpr (std::is_same_v<decltype(value), bool&>)
            value = *number >= 0.5;
        else {
            value = static_cast<std::remove_reference_t<decltype(value)>>(
                std::clamp(*number, rule.lo, rule.hi));
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

std::vector<Parameter> parameters(const Object& object)
{
    std::vector<Parameter> out;
    walk_object(object, gather(out));
    return out;
}

std::vector<Parameter> scene_parameters(const Document& document)
{
    std::vector<Parameter> out;
    walk("render", *document.render, {}, gather(out));
    for (const auto& [name, camera] : document.bookmarks)
        walk("camera." + name, camera, {}, gather(out));
    return out;
}

Object with_values(Object object, const NewValue& value)
{
    walk_object(object, change(value));
    return object;
}

Document with_scene_values(Document document, const NewValue& value)
{
    RenderSettings settings = *document.render;
    walk("render", settings, {}, change(value));
    if (settings != *document.render) document.render = make_ref(std::move(settings));
    for (auto& [name, camera] : document.bookmarks) {
        Camera moved = camera;
        walk("camera." + name, moved, {}, change(value));
        try {
            check_view(moved);
            camera = moved;
        } catch (const Rejected&) { // it would look nowhere: it stays
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
