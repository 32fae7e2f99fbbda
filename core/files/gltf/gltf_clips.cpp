// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_clips.h"

#include "core/base/text.h"
#include "core/files/gltf/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

// Counts the keys of a rotation that are four zeros, which clip.cpp treats as no rotation.
std::size_t turnless_keys(const Channel& channel)
{
    if (channel.of != Channel::Of::rotation) return 0;
    const bool cubic = channel.interpolation == Channel::Interpolation::cubic;
    std::size_t out = 0;
    for (std::size_t at = cubic ? 4 : 0; at + 4 <= channel.values.size(); at += cubic ? 12 : 4) {
        double squares = 0;
        for (std::size_t c = 0; c < 4; ++c)
            squares += double(channel.values[at + c]) * double(channel.values[at + c]);
        if (squares < least_rotation * least_rotation) ++out;
    }
    return out;
}

// Returns the name, or the first free one with a number after it. `given` has the names in use,
// each with the last number tried, so that thousands of equal names take linear time.
std::string free_name(std::string name, std::size_t number, std::map<std::string, int>& given)
{
    if (name.empty()) name = fmt::format("Clip {}", number);
    const auto [entry, fresh] = given.try_emplace(name, 1);
    if (fresh) return name;
    for (;;) {
        std::string tried = fmt::format("{} {}", name, ++entry->second);
        if (given.try_emplace(tried, 1).second) return tried;
    }
}

bool in_reach(const std::vector<float>& values)
{
    return std::ranges::all_of(
        values, [](float value) { return std::abs(value) <= static_cast<float>(most_coordinate); });
}

class ClipReader {
public:
    ClipReader(const Model& model, GltfAccessors& accessors, const std::vector<int>& node_of,
               CountedNotices& notices)
        : model_(model),
          accessors_(accessors),
          node_of_(node_of),
          notices_(notices)
    {
    }

    // Reads a clip. One without channels has nothing to play.
    Clip read(const GltfEntry& animation, std::size_t number)
    {
        Clip clip;
        animation.each("channels", "channel", [&](const GltfEntry& channel) {
            if (auto read = this->channel(animation, channel))
                clip.channels.push_back(std::move(*read));
        });
        if (clip.channels.empty()) {
            notices_.add("one of its animations has no track to play and was left out",
                         "{0} of its animations have no track to play and were left out");
            return clip;
        }
        const std::string name = printable(animation.text("name"));
        clip.name = free_name(name, number, given_);
        if (!name.empty() && clip.name != name)
            notices_.add("one of its animations has the name of another and was given a number",
                         "{0} of its animations have the name of another and were given a number");
        set_times(clip);
        return clip;
    }

private:
    std::optional<Channel> channel(const GltfEntry& animation, const GltfEntry& from)
    {
        const GltfEntry sampler = sampler_of(animation, from);
        const GltfEntry target = from.needed_part("target");
        const std::string_view path = target.needed_text("path");
        const int node = target.index("node");
        Channel out;
        out.node = node >= 0 && static_cast<std::size_t>(node) < node_of_.size()
                       ? node_of_[static_cast<std::size_t>(node)]
                       : -1;
        if (out.node < 0 || !set_property(out, path)) {
            notices_.add("one track of its animations moves nothing that exists and was left out",
                         "{0} tracks of its animations move nothing that exists and were left out");
            return {};
        }
        set_way(out, sampler.text("interpolation"));
        return set_keys(out, sampler) ? std::optional(std::move(out)) : std::nullopt;
    }

    static GltfEntry sampler_of(const GltfEntry& animation, const GltfEntry& channel)
    {
        const std::size_t index = channel.needed_index("sampler"),
                          count = animation.count("samplers");
        if (index >= count)
            channel.fail(fmt::format("'sampler' names sampler {}, which is not there: its "
                                     "animation has {}, counted from 0",
                                     index, count));
        return animation.item("samplers", "sampler", index);
    }

    // Sets the property that a channel moves; false if a node has no such property.
    bool set_property(Channel& out, std::string_view path) const
    {
        if (path == "translation" || path == "scale") {
            out.of = path == "scale" ? Channel::Of::scale : Channel::Of::translation;
            out.components = 3;
        } else if (path == "rotation") {
            out.of = Channel::Of::rotation;
            out.components = 4;
        } else if (path == "weights") {
            const int mesh = model_.nodes[static_cast<std::size_t>(out.node)].mesh;
            out.of = Channel::Of::morph_weights;
            out.components =
                mesh < 0 ? 0 : model_.meshes[static_cast<std::size_t>(mesh)]->morph_targets.size();
        } else {
            return false;
        }
        return out.components > 0;
    }

    void set_way(Channel& out, std::string_view way)
    {
        out.interpolation = way == "STEP"          ? Channel::Interpolation::step
                            : way == "CUBICSPLINE" ? Channel::Interpolation::cubic
                                                   : Channel::Interpolation::linear;
        if (out.interpolation == Channel::Interpolation::linear && !way.empty() && way != "LINEAR")
            notices_.add("one track of its animations has an unknown interpolation, in place of "
                         "which a linear one is used",
                         "{0} tracks of its animations have an unknown interpolation, in place of "
                         "which a linear one is used");
    }

    bool set_keys(Channel& out, const GltfEntry& sampler)
    {
        GltfAccessors::Table times = accessors_.floats(sampler, "input"),
                             values = accessors_.floats(sampler, "output");
        if (!accessors_.holds_floats(sampler, "input")) {
            notices_.add("one track of its animations has whole numbers for times, which glTF does "
                         "not allow, and was left out",
                         "{0} tracks of its animations have whole numbers for times, which glTF "
                         "does not allow, and were left out");
            return false;
        }
        const bool ascending = std::adjacent_find(times.values.begin(), times.values.end(),
                                                  std::greater_equal<>()) == times.values.end();
        if (times.count == 0 || times.components != 1 || times.not_finite > 0 || !ascending) {
            notices_.add(
                "one track of its animations has times that do not ascend and was left out",
                "{0} tracks of its animations have times that do not ascend and were left out");
            return false;
        }
        const std::size_t each = out.interpolation == Channel::Interpolation::cubic ? 3 : 1;
        if (values.values.size() != times.count * each * out.components) {
            notices_.add("one track of its animations has more or fewer values than times and was "
                         "left out",
                         "{0} tracks of its animations have more or fewer values than times and "
                         "were left out");
            return false;
        }
        if (values.not_finite > 0 || !in_reach(values.values)) {
            notices_.add("one track of its animations has values that are beyond 1e15 or not "
                         "finite, and was left out",
                         "{0} tracks of its animations have values that are beyond 1e15 or not "
                         "finite, and were left out");
            return false;
        }
        out.times_s = std::move(times.values);
        out.values = std::move(values.values);
        return true;
    }

    void set_times(Clip& clip)
    {
        clip.begin_s = clip.end_s = double(clip.channels.front().times_s.front());
        for (const Channel& channel : clip.channels) {
            clip.begin_s = std::min(clip.begin_s, double(channel.times_s.front()));
            clip.end_s = std::max(clip.end_s, double(channel.times_s.back()));
        }
        constexpr double moment_s = 1e-3;
        std::size_t turnless = 0, shorter = 0;
        for (const Channel& channel : clip.channels) {
            turnless += turnless_keys(channel);
            if (channel.times_s.size() > 1 &&
                (double(channel.times_s.front()) > clip.begin_s + moment_s ||
                 double(channel.times_s.back()) < clip.end_s - moment_s))
                ++shorter;
        }
        notices_.add("one track of its animations begins later or ends earlier than the others; "
                     "what it moves stands still until then or from then on",
                     "{0} tracks of its animations begin later or end earlier than the others; "
                     "what they move stands still until then or from then on",
                     shorter);
        notices_.add("one key of its rotations is all zeros and turns nothing",
                     "{0} keys of its rotations are all zeros and turn nothing", turnless);
    }

    const Model& model_;
    GltfAccessors& accessors_;
    const std::vector<int>& node_of_;
    CountedNotices& notices_;
    std::map<std::string, int> given_; // by name: the last number tried
};

} // namespace

void add_gltf_clips(Model& model, GltfAccessors& accessors, const std::vector<int>& node_of,
                    CountedNotices& notices)
{
    ClipReader reader(model, accessors, node_of, notices);
    std::size_t number = 0;
    accessors.file().root().each("animations", "animation", [&](const GltfEntry& animation) {
        if (Clip clip = reader.read(animation, ++number); !clip.channels.empty())
            model.clips.push_back(std::move(clip));
    });
}

} // namespace trivar
