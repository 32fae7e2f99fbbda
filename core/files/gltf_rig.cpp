// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf_rig.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <tiny_gltf.h>

namespace trivar {
namespace {

constexpr std::size_t max_targets = 1024, max_joints = 65536;

// The four largest of a vertex's shares, made to sum to 1; false: it has none.
bool settle(Mesh::Influences& out, std::vector<std::pair<float, std::uint16_t>>& all)
{
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += std::max(0.0, double(all[k].first));
    if (!(sum > 0)) return false;
    for (std::size_t k = 0; k < 4; ++k) {
        const double share = std::max(0.0, double(all[k].first)) / sum;
        out.weights[static_cast<int>(k)] = static_cast<float>(share);
        out.joints[k] = share > 0 ? all[k].second : std::uint16_t{0};
    }
    return true;
}

// Whether a vertex's shares are as far from a sum of 1 as no rounding to bytes brings them.
bool is_off_one(const std::vector<std::pair<float, std::uint16_t>>& all)
{
    constexpr double rounded = 0.02;
    double sum = 0;
    for (const auto& [share, joint] : all) sum += std::max(0.0, double(share));
    return sum > 0 && std::abs(sum - 1) > rounded;
}

// Keys of a rotation that say none: four zeros, as clip.cpp takes them.
std::size_t turnless_keys(const Channel& channel)
{
    if (channel.of != Channel::Of::rotation) return 0;
    const bool cubic = channel.between == Channel::Between::cubic;
    std::size_t out = 0;
    for (std::size_t at = cubic ? 4 : 0; at + 4 <= channel.values.size(); at += cubic ? 12 : 4) {
        double squares = 0;
        for (std::size_t c = 0; c < 4; ++c)
            squares += double(channel.values[at + c]) * double(channel.values[at + c]);
        if (squares < 1e-18) ++out;
    }
    return out;
}

// The name, or the first free one with a number behind it. `given`: those that were, each with the
// last number tried behind it, so that thousands of one name cost no more steps than that.
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

} // namespace

void GltfRig::fail(const std::string& what) const
{
    throw Rejected(fmt::format("{}: {}", name_, what));
}

void GltfRig::add_influences(Mesh& mesh, const tinygltf::Primitive& primitive, std::size_t count)
{
    const std::size_t after = mesh.vertex_count(), before = after - count;
    std::vector<GltfAccessors::Table> joints, weights;
    for (int set = 0;; ++set) {
        const auto j = primitive.attributes.find(fmt::format("JOINTS_{}", set)),
                   w = primitive.attributes.find(fmt::format("WEIGHTS_{}", set));
        const bool no_joints = j == primitive.attributes.end(),
                   no_weights = w == primitive.attributes.end();
        if (set > 0 && no_joints != no_weights) ++halves_;
        if (no_joints || no_weights) break;
        joints.push_back(accessors_.floats(j->second));
        weights.push_back(accessors_.floats(w->second));
        for (const GltfAccessors::Table* each : {&joints.back(), &weights.back()})
            if (each->components != 4 || each->count != count)
                fail(fmt::format("joints and weights {} are not four for each of {} vertices", set,
                                 count));
    }
    if (joints.empty() && mesh.influences.empty()) return;
    mesh.influences.resize(before);
    mesh.influences.resize(after);
    std::vector<std::pair<float, std::uint16_t>> all;
    for (std::size_t v = 0; v < count && !joints.empty(); ++v) {
        all.clear();
        for (std::size_t set = 0; set < joints.size(); ++set)
            for (std::size_t c = 0; c < 4; ++c) {
                const float joint = joints[set].values[4 * v + c];
                if (!(joint >= 0 && joint < float(max_joints)))
                    fail(fmt::format("a vertex names joint {}", double(joint)));
                all.emplace_back(weights[set].values[4 * v + c], static_cast<std::uint16_t>(joint));
            }
        if (std::ranges::any_of(all, [](const auto& each) { return each.first < 0; })) ++negative_;
        if (is_off_one(all)) ++unsummed_;
        if (!settle(mesh.influences[before + v], all)) ++loose_;
        if (all.size() > 4 && all[4].first > 0) ++crowded_;
    }
}

void GltfRig::add_targets(Mesh& mesh, const tinygltf::Primitive& primitive, std::size_t count)
{
    if (primitive.targets.empty() && mesh.morph_targets.empty()) return;
    if (primitive.targets.size() > max_targets)
        fail(fmt::format("a mesh has {} morph targets, more than the {} allowed",
                         primitive.targets.size(), max_targets));
    const std::size_t after = mesh.vertex_count(), before = after - count;
    mesh.morph_targets.resize(std::max(mesh.morph_targets.size(), primitive.targets.size()));
    for (std::size_t t = 0; t < mesh.morph_targets.size(); ++t) {
        const auto append = [&](std::vector<glm::vec3>& values, const char* attribute) {
            GltfAccessors::Table table{0, 0, {}};
            if (t < primitive.targets.size())
                if (const auto at = primitive.targets[t].find(attribute);
                    at != primitive.targets[t].end())
                    table = accessors_.floats(at->second);
            if (table.components == 0 && values.empty()) return;
            if (table.components != 0 && (table.components != 3 || table.count != count))
                fail(fmt::format("{} of morph target {} are not three for each of {} vertices",
                                 attribute, t, count));
            values.resize(before, glm::vec3(0));
            values.resize(after, glm::vec3(0));
            for (std::size_t i = 0; i < table.values.size(); ++i)
                values[before + i / 3][static_cast<int>(i % 3)] = table.values[i];
        };
        append(mesh.morph_targets[t].positions, "POSITION");
        append(mesh.morph_targets[t].normals, "NORMAL");
        append(mesh.morph_targets[t].tangents, "TANGENT");
    }
}

Skin GltfRig::skin(int index, const std::vector<int>& node_of, bool& whole)
{
    const tinygltf::Skin& from = gltf_.skins[static_cast<std::size_t>(index)];
    Skin out;
    if (from.joints.size() > max_joints) fail(fmt::format("skin {} has too many joints", index));
    for (const int joint : from.joints) {
        const bool there = joint >= 0 && static_cast<std::size_t>(joint) < node_of.size() &&
                           node_of[static_cast<std::size_t>(joint)] >= 0;
        whole &= there;
        out.joints.push_back(there ? node_of[static_cast<std::size_t>(joint)] : 0);
    }
    out.mesh_to_joint.assign(out.joints.size(), glm::dmat4(1));
    if (from.inverseBindMatrices < 0) return out;
    const GltfAccessors::Table table = accessors_.floats(from.inverseBindMatrices);
    if (table.components != 16 || table.count < out.joints.size())
        fail(fmt::format("skin {} has no matrix for each of its {} joints", index,
                         out.joints.size()));
    for (std::size_t k = 0; k < out.joints.size(); ++k)
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 3; ++r) // the last row is 0 0 0 1
                out.mesh_to_joint[k][c][r] =
                    double(table.values[16 * k + static_cast<std::size_t>(4 * c + r)]);
    return out;
}

void GltfRig::add_skins(Model& model, const std::vector<int>& node_of)
{
    std::vector<bool> whole;
    for (std::size_t i = 0; i < gltf_.skins.size(); ++i) {
        bool all_there = true;
        model.skins.push_back(skin(static_cast<int>(i), node_of, all_there));
        whole.push_back(all_there && !model.skins.back().joints.empty());
    }
    for (std::size_t i = 0; i < gltf_.nodes.size(); ++i) {
        const int at = i < node_of.size() ? node_of[i] : -1;
        const int skin = gltf_.nodes[i].skin;
        if (at < 0 || skin < 0) continue;
        Node& node = model.nodes[static_cast<std::size_t>(at)];
        if (static_cast<std::size_t>(skin) >= model.skins.size())
            fail(fmt::format("node {} names skin {}, which is not there", i, skin));
        if (node.mesh < 0) continue;
        const Mesh& mesh = *model.meshes[static_cast<std::size_t>(node.mesh)];
        if (mesh.influences.empty() || !whole[static_cast<std::size_t>(skin)]) {
            ++skins_left_out_;
            continue;
        }
        const std::size_t joints = model.skins[static_cast<std::size_t>(skin)].joints.size();
        for (const Mesh::Influences& by : mesh.influences)
            for (const std::uint16_t joint : by.joints)
                if (joint >= joints)
                    fail(fmt::format("a vertex names joint {}, its skin has {}", joint, joints));
        node.skin = skin;
    }
}

void GltfRig::add_channel(Clip& clip, const Model& model, int animation, int index,
                          const std::vector<int>& node_of)
{
    const tinygltf::Animation& from = gltf_.animations[static_cast<std::size_t>(animation)];
    const tinygltf::AnimationChannel& channel = from.channels[static_cast<std::size_t>(index)];
    const int target = channel.target_node;
    if (target < 0 || static_cast<std::size_t>(target) >= node_of.size() ||
        node_of[static_cast<std::size_t>(target)] < 0) {
        ++channels_left_out_;
        return;
    }
    if (channel.sampler < 0 || static_cast<std::size_t>(channel.sampler) >= from.samplers.size())
        fail(fmt::format("animation {} names a sampler that is not there", animation));
    const tinygltf::AnimationSampler& sampler =
        from.samplers[static_cast<std::size_t>(channel.sampler)];
    Channel out;
    out.node = node_of[static_cast<std::size_t>(target)];
    const std::string& path = channel.target_path;
    out.of = path == "translation" ? Channel::Of::translation
             : path == "rotation"  ? Channel::Of::rotation
             : path == "scale"     ? Channel::Of::scale
                                   : Channel::Of::morph_weights;
    const std::string& between = sampler.interpolation;
    out.between = between == "STEP"          ? Channel::Between::step
                  : between == "CUBICSPLINE" ? Channel::Between::cubic
                                             : Channel::Between::linear;
    const bool unknown_way =
        !between.empty() && between != "STEP" && between != "CUBICSPLINE" && between != "LINEAR";
    GltfAccessors::Table times = accessors_.floats(sampler.input),
                         values = accessors_.floats(sampler.output);
    const std::size_t keys = times.count;
    const std::size_t each = out.between == Channel::Between::cubic ? 3 : 1;
    if (out.of == Channel::Of::morph_weights) {
        const int mesh = model.nodes[static_cast<std::size_t>(out.node)].mesh;
        out.components =
            mesh < 0 ? 0 : model.meshes[static_cast<std::size_t>(mesh)]->morph_targets.size();
    } else
        out.components = out.of == Channel::Of::rotation ? 4 : 3;
    const bool ascending = std::adjacent_find(times.values.begin(), times.values.end(),
                                              std::greater_equal<>()) == times.values.end();
    const bool known =
        path == "translation" || path == "rotation" || path == "scale" || path == "weights";
    if (!known || out.components == 0) {
        ++channels_left_out_;
        return;
    }
    if (gltf_.accessors[static_cast<std::size_t>(sampler.input)].componentType !=
        TINYGLTF_COMPONENT_TYPE_FLOAT) {
        ++whole_times_;
        return;
    }
    if (keys == 0 || times.components != 1 || !ascending) {
        ++untimely_;
        return;
    }
    if (values.values.size() != keys * each * out.components) {
        ++uneven_;
        return;
    }
    if (unknown_way) ++unknown_ways_;
    out.times_s = std::move(times.values);
    out.values = std::move(values.values);
    clip.channels.push_back(std::move(out));
}

void GltfRig::add_clips(Model& model, const std::vector<int>& node_of)
{
    std::map<std::string, int> given;
    for (std::size_t i = 0; i < gltf_.animations.size(); ++i) {
        const tinygltf::Animation& from = gltf_.animations[i];
        Clip clip;
        for (std::size_t c = 0; c < from.channels.size(); ++c)
            add_channel(clip, model, static_cast<int>(i), static_cast<int>(c), node_of);
        if (clip.channels.empty()) {
            ++empty_clips_;
            continue;
        }
        const std::string name = printable(from.name);
        clip.name = free_name(name, i + 1, given);
        if (!name.empty() && clip.name != name) ++renamed_;
        for (const Channel& channel : clip.channels) turnless_ += turnless_keys(channel);
        clip.begin_s = double(clip.channels.front().times_s.front());
        clip.end_s = clip.begin_s;
        for (const Channel& channel : clip.channels) {
            clip.begin_s = std::min(clip.begin_s, double(channel.times_s.front()));
            clip.end_s = std::max(clip.end_s, double(channel.times_s.back()));
        }
        constexpr double moment_s = 1e-3;
        for (const Channel& channel : clip.channels)
            if (channel.times_s.size() > 1 &&
                (double(channel.times_s.front()) > clip.begin_s + moment_s ||
                 double(channel.times_s.back()) < clip.end_s - moment_s))
                ++short_;
        model.clips.push_back(std::move(clip));
    }
}

void GltfRig::add_notices(Model& model) const
{
    const auto say = [&](std::size_t count, const char* one, const char* many) {
        if (count > 0)
            model.notices.push_back(fmt::format(
                "{}: {}", name_, count == 1 ? one : fmt::format(fmt::runtime(many), count)));
    };
    say(loose_, "one vertex of a skin has no weight and goes with its first joint",
        "{} vertices of a skin have no weight and go with its first joint");
    say(crowded_,
        "one vertex goes with more than four joints: the four with the largest weights count",
        "{} vertices go with more than four joints: the four with the largest weights count");
    say(unsummed_, "one vertex of a skin has weights that do not sum to 1, and were made to",
        "{} vertices of a skin have weights that do not sum to 1, and were made to");
    say(negative_, "one vertex of a skin has a negative weight, which counts as none",
        "{} vertices of a skin have a negative weight, which counts as none");
    say(halves_,
        "one part of a mesh has further joints without weights, or weights without joints, which "
        "were left out",
        "{} parts of meshes have further joints without weights, or weights without joints, which "
        "were left out");
    say(skins_left_out_, "one skin lacks joints or weights and was left out",
        "{} skins lack joints or weights and were left out");
    say(channels_left_out_,
        "one track of its animations moves nothing that is there and was left out",
        "{} tracks of its animations move nothing that is there and were left out");
    say(whole_times_,
        "one track of its animations has whole numbers for times, which no glTF has, and was left "
        "out",
        "{} tracks of its animations have whole numbers for times, which no glTF has, and were "
        "left out");
    say(untimely_, "one track of its animations has no ascending times and was left out",
        "{} tracks of its animations have no ascending times and were left out");
    say(uneven_, "one track of its animations has more or fewer values than times and was left out",
        "{} tracks of its animations have more or fewer values than times and were left out");
    say(unknown_ways_,
        "one track of its animations goes between its keys in a way that is unknown, and was made "
        "to go straight",
        "{} tracks of its animations go between their keys in a way that is unknown, and were made "
        "to go straight");
    say(empty_clips_, "one of its animations has no track to play and was left out",
        "{} of its animations have no track to play and were left out");
    say(short_,
        "one track of its animations begins later or ends sooner than the others: what it moves "
        "stands still meanwhile",
        "{} tracks of its animations begin later or end sooner than the others: what they move "
        "stands still meanwhile");
    say(turnless_, "one key of its rotations is all zeros and turns nothing",
        "{} keys of its rotations are all zeros and turn nothing");
    say(renamed_, "one of its animations has the name of another and was given a number",
        "{} of its animations have the name of another and were given a number");
}

} // namespace trivar
