// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/animated_nodes.h"

#include "core/export/keys.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {

AnimatedNodes::AnimatedNodes(const Film& film, const Document& document, std::vector<float> times_s,
                             double tolerance)
    : film_(film),
      document_(document),
      times_s_(std::move(times_s)),
      tolerance_(tolerance)
{
    node("Scene", -1); // the only root: what moves below it is not turned upright itself
}

int AnimatedNodes::node(const std::string& name, int parent)
{
    Node made;
    made.name = name;
    made.parent = parent;
    model_.nodes.push_back(std::move(made));
    return static_cast<int>(model_.nodes.size()) - 1;
}

int AnimatedNodes::group(Id id)
{
    if (id == 0) return 0;
    if (const auto found = groups_.find(id); found != groups_.end()) return found->second;
    const Object& each = object(document_, id);
    const int parent = group(each.parent);
    return groups_[id] = node(each.name, parent);
}

int AnimatedNodes::holder(const FilmStrip& strip)
{
    const int parent = group(object(document_, strip.object).parent);
    if (std::ranges::none_of(strip.shown, [](const Part* part) { return part == nullptr; }))
        return parent;
    const int out = node(strip.name + " shown", parent);
    Channel channel;
    channel.node = out;
    channel.of = Channel::Of::scale;
    channel.between = Channel::Between::step;
    for (std::size_t i = 0; i < strip.shown.size(); ++i) {
        const float scale = strip.shown[i] ? 1 : 0;
        if (!channel.values.empty() && channel.values.back() == scale) continue;
        channel.times_s.push_back(times_s_[i]);
        channel.values.insert(channel.values.end(), 3, scale);
    }
    model_.nodes[static_cast<std::size_t>(out)].rest.scale = glm::dvec3(strip.shown[0] ? 1 : 0);
    clip_.channels.push_back(std::move(channel));
    return out;
}

int AnimatedNodes::mesh(const FilmStrip& strip, Mesh mesh)
{
    const auto [first, fresh] = first_material_.try_emplace(
        strip.materials, static_cast<std::uint32_t>(model_.materials.size()));
    if (fresh)
        model_.materials.insert(model_.materials.end(), strip.materials->begin(),
                                strip.materials->end());
    if (first->second > 0) {
        mesh.face_material.resize(mesh.face_count(), 0);
        for (std::uint32_t& material : mesh.face_material) material += first->second;
    }
    model_.meshes.push_back(make_ref(std::move(mesh)));
    return static_cast<int>(model_.meshes.size()) - 1;
}

template <class Value>
std::vector<Value> AnimatedNodes::each_moment(const FilmStrip& strip, const auto& value) const
{
    std::vector<Value> out;
    const Part* last = &strip.first();
    for (const Part* part : strip.shown) {
        if (part) last = part;
        out.push_back(value(*last));
    }
    return out;
}

bool AnimatedNodes::add_motion(int node, const std::vector<glm::dmat4>& matrices, const Box& box,
                               FilmCertificate::PartClaim& claim)
{
    // Half of it is for what is between the moments.
    std::optional<NodeMotion> motion = node_motion(node, matrices, times_s_, box, tolerance_ / 2);
    if (!motion) return false;
    Node& moved = model_.nodes[static_cast<std::size_t>(node)];
    moved.rest = motion->first;
    moved.to_parent = motion->channels.empty() ? matrices.front() : motion->first.matrix();
    claim.keys = std::max(claim.keys, static_cast<int>(motion->keys));
    claim.bound = std::max(claim.bound, motion->off);
    for (Channel& channel : motion->channels) clip_.channels.push_back(std::move(channel));
    return true;
}

// Each joint stands in the middle of what it moves, and its own matrix at every moment is that of
// the pose: no bone of the model has to be known for that.
int AnimatedNodes::skin(const FilmStrip& strip, Mesh& mesh, FilmCertificate::PartClaim& claim)
{
    const Part& first = strip.first();
    std::vector<Box> boxes(first.posed->pose.joints.size());
    std::vector<int> used(boxes.size(), -1);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        for (int k = 0; k < 4; ++k)
            if (mesh.influences[v].weights[k] > 0)
                boxes[mesh.influences[v].joints[static_cast<std::size_t>(k)]].add(
                    glm::dvec3(mesh.positions[v]));
    const int parent = node(strip.name + " joints", 0);
    Skin out;
    for (std::size_t j = 0; j < boxes.size(); ++j) {
        if (boxes[j].empty()) continue;
        used[j] = static_cast<int>(out.joints.size());
        const int joint =
            node(strip.name + " joint " + std::to_string(out.joints.size() + 1), parent);
        const glm::dmat4 from_middle = glm::translate(glm::dmat4(1), boxes[j].center());
        const auto matrices = each_moment<glm::dmat4>(strip, [&](const Part& part) {
            const bool posed = part.posed && j < part.posed->pose.joints.size();
            return part.to_world *
                   (posed ? glm::dmat4(part.posed->pose.joints[j]) : glm::dmat4(1)) * from_middle;
        });
        Box box;
        box.add(boxes[j].lo - boxes[j].center());
        box.add(boxes[j].hi - boxes[j].center());
        if (!add_motion(joint, matrices, box, claim)) return -1;
        out.joints.push_back(joint);
        out.mesh_to_joint.push_back(glm::inverse(from_middle));
    }
    for (Mesh::Influences& each : mesh.influences)
        for (int k = 0; k < 4; ++k) {
            std::uint16_t& joint = each.joints[static_cast<std::size_t>(k)];
            joint =
                each.weights[k] > 0 ? static_cast<std::uint16_t>(used[joint]) : std::uint16_t{0};
        }
    model_.skins.push_back(std::move(out));
    return static_cast<int>(model_.skins.size()) - 1;
}

void AnimatedNodes::add_morph_weights(const FilmStrip& strip, int node, const Mesh& mesh,
                                      FilmCertificate::PartClaim& claim)
{
    const std::size_t targets = mesh.morph_targets.size();
    const auto weights = each_moment<std::vector<float>>(strip, [&](const Part& part) {
        std::vector<float> out = part.posed ? part.posed->pose.morph_weights : std::vector<float>{};
        out.resize(targets, 0);
        return out;
    });
    Channel channel;
    channel.node = node;
    channel.of = Channel::Of::morph_weights;
    channel.components = targets;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const bool same = i > 0 && i + 1 < weights.size() && weights[i] == weights[i - 1] &&
                          weights[i] == weights[i + 1];
        if (same) continue;
        channel.times_s.push_back(times_s_[i]);
        channel.values.insert(channel.values.end(), weights[i].begin(), weights[i].end());
    }
    claim.keys = std::max(claim.keys, static_cast<int>(channel.times_s.size()));
    model_.nodes[static_cast<std::size_t>(node)].morph_weights = weights.front();
    clip_.channels.push_back(std::move(channel));
}

bool AnimatedNodes::add_moving(const FilmStrip& strip, FilmCertificate::PartClaim& claim)
{
    const Model before = model_; // references are shared, so that is cheap
    const std::size_t channels = clip_.channels.size();
    const Part& first = strip.first();
    Mesh mesh = *first.rest;
    const int at = node(strip.name, holder(strip));
    const bool skinned = std::ranges::any_of(
        strip.shown, [](const Part* p) { return p && p->posed && !p->posed->pose.joints.empty(); });
    const bool morphs = std::ranges::any_of(strip.shown, [](const Part* p) {
        return p && p->posed && !p->posed->pose.morph_weights.empty();
    });
    if (!morphs) mesh.morph_targets.clear();
    claim.way = skinned || morphs ? "skin" : "node";
    bool whole = true;
    if (skinned) {
        const int skin_index = skin(strip, mesh, claim);
        model_.nodes[static_cast<std::size_t>(at)].skin = skin_index;
        whole = skin_index >= 0;
    } else {
        mesh.influences.clear();
        whole =
            add_motion(at, each_moment<glm::dmat4>(strip, [](const Part& p) { return p.to_world; }),
                       bounding_box(mesh), claim);
    }
    if (!whole) {
        model_ = before;
        clip_.channels.resize(channels);
        return false;
    }
    if (morphs) add_morph_weights(strip, at, mesh, claim);
    if (clip_.channels.size() == channels) claim.way = "still";
    claim.triangles_before = claim.triangles = triangles(mesh).size();
    claim.node = at;
    const int index = this->mesh(strip, std::move(mesh));
    model_.nodes[static_cast<std::size_t>(at)].mesh = index;
    return true;
}

void AnimatedNodes::add_targets(const FilmStrip& strip, TargetKeys&& keys,
                                FilmCertificate::PartClaim& claim)
{
    const int at = node(strip.name, holder(strip));
    claim.node = at;
    claim.keys = static_cast<int>(keys.keys.size());
    claim.way = keys.weights.times_s.empty() ? "still" : "targets";
    claim.triangles = keys.mesh.face_count();
    const int index = mesh(strip, std::move(keys.mesh));
    model_.nodes[static_cast<std::size_t>(at)].mesh = index;
    if (keys.weights.times_s.empty()) return;
    keys.weights.node = at;
    model_.nodes[static_cast<std::size_t>(at)].morph_weights.assign(keys.weights.components, 0);
    clip_.channels.push_back(std::move(keys.weights));
}

Model AnimatedNodes::finished()
{
    if (model_.materials.empty()) model_.materials.emplace_back();
    clip_.name = "Scene";
    clip_.end_s = times_s_.back();
    if (!clip_.channels.empty()) model_.clips.push_back(std::move(clip_));
    return std::move(model_);
}

} // namespace trivar
