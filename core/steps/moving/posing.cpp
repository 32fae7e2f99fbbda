// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/moving/posing.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace trivar {
namespace {

std::string missing_clip(const Model& model, const std::string& name)
{
    constexpr std::size_t most_named = 4;
    if (model.clips.empty())
        return fmt::format("it has no clip \"{}\", nor any other", excerpt(name));
    std::vector<std::string> there;
    for (std::size_t i = 0; i < std::min(most_named, model.clips.size()); ++i)
        there.push_back(excerpt(model.clips[i].name));
    std::string text =
        fmt::format("it has no clip \"{}\"; it has {}", excerpt(name), fmt::join(there, ", "));
    if (model.clips.size() > most_named)
        text += fmt::format(" and {} more", model.clips.size() - most_named);
    return text;
}

// Says whether a channel has the same value at all times.
bool is_still(const Channel& channel)
{
    const std::size_t n = channel.components;
    const bool cubic = channel.interpolation == Channel::Interpolation::cubic;
    for (std::size_t i = 0; i < channel.values.size(); ++i) {
        const bool tangent = cubic && i / n % 3 != 1;
        if (channel.values[i] != (tangent ? 0 : channel.values[i % n + (cubic ? n : 0)]))
            return false;
    }
    return true;
}

// Says why the clip shows no motion; empty if something moves.
std::string stillness(const Clip& clip)
{
    if (!(clip.end_s > clip.begin_s))
        return fmt::format("\"{}\" has no length: it shows the pose of its only keys",
                           excerpt(clip.name));
    if (std::ranges::all_of(clip.channels, is_still))
        return fmt::format("nothing moves in \"{}\", which holds one pose: all its keys are equal",
                           excerpt(clip.name));
    return {};
}

} // namespace

double clip_time_s(const Clip& clip, const Playing& playing, double seconds)
{
    const double length = clip.end_s - clip.begin_s;
    if (!(length > 0)) return clip.begin_s;
    const double gone = playing.offset + playing.speed * std::max(0.0, seconds);
    return clip.begin_s + folded(playing.repeat, gone, length);
}

Ref<Shape> Posing::at(const Ref<Shape>& rest, const Clip& clip, double time_s,
                      const Ref<Gait>& gait)
{
    return poses_({rest, clip.name, time_s, gait}, [&] {
        Shape shape = *rest;
        if (gait)
            stand(shape, planted(*rest->model, clip, *gait, time_s));
        else
            stand(shape, &clip, time_s);
        if (const std::string words = stillness(clip); !words.empty())
            shape.notices.push_back(words);
        return make_ref(std::move(shape));
    });
}

Ref<Shape> Posing::operator()(const Ref<Shape>& rest, const Playing& playing, double seconds)
{
    if (playing.clip.empty()) return rest;
    const auto clip =
        std::ranges::find(rest->model->clips, playing.clip, [](const Clip& c) { return c.name; });
    if (clip != rest->model->clips.end())
        return at(rest, *clip, clip_time_s(*clip, playing, seconds));
    return poses_({rest, playing.clip, 0, nullptr}, [&] {
        Shape shape = *rest;
        shape.notices.push_back(missing_clip(*rest->model, playing.clip));
        return make_ref(std::move(shape));
    });
}

} // namespace trivar
