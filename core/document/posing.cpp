// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/posing.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace trivar {
namespace {

std::string missing_clip(const Model& model, const std::string& name)
{
    std::vector<std::string> there;
    for (const Clip& clip : model.clips) there.push_back(clip.name);
    return there.empty()
               ? fmt::format("it has no clip \"{}\", nor any other", name)
               : fmt::format("it has no clip \"{}\"; it has {}", name, fmt::join(there, ", "));
}

} // namespace

double clip_time_s(const Clip& clip, const Playing& playing, double seconds)
{
    const double length = clip.end_s - clip.begin_s;
    double t = playing.offset + playing.speed * std::max(0.0, seconds);
    if (!(length > 0)) return clip.begin_s;
    if (playing.repeat == Repeat::once)
        t = std::clamp(t, 0.0, length);
    else if (playing.repeat == Repeat::loop)
        t -= std::floor(t / length) * length;
    else {
        t -= std::floor(t / (2 * length)) * 2 * length;
        if (t > length) t = 2 * length - t;
    }
    return clip.begin_s + t;
}

Ref<Shape> Posing::operator()(const Ref<Shape>& rest, const Playing& playing, double seconds)
{
    if (playing.clip.empty()) return rest;
    const auto clip =
        std::ranges::find(rest->model->clips, playing.clip, [](const Clip& c) { return c.name; });
    const bool there = clip != rest->model->clips.end();
    const double time_s = there ? clip_time_s(*clip, playing, seconds) : 0;
    const auto found = std::ranges::find_if(known_, [&](const Known& k) {
        return k.rest == rest && k.clip == playing.clip && k.time_s == time_s;
    });
    if (found != known_.end()) {
        std::rotate(known_.begin(), found, found + 1);
        return known_.front().shape;
    }
    Shape shape = *rest;
    if (there)
        stand(shape, &*clip, time_s);
    else
        shape.notices.push_back(missing_clip(*rest->model, playing.clip));
    known_.insert(known_.begin(), {rest, playing.clip, time_s, make_ref(std::move(shape))});
    constexpr std::size_t kept = 3; // as Laying keeps
    if (known_.size() > kept) known_.pop_back();
    return known_.front().shape;
}

} // namespace trivar
