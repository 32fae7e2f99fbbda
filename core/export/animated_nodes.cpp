// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/animated_nodes.h"

#include "core/certificate/keys.h"
#include "core/certificate/motion_bound.h"
#include "core/document/parameters.h"
#include "core/mesh/mesh_materials.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {

std::vector<bool> shown_at(const FilmStrip& strip)
{
    std::vector<bool> shown;
    for (const Part* part : strip.shown) shown.push_back(part != nullptr);
    return shown;
}

AnimatedNodes::AnimatedNodes(const Film& film, const Document& document, const AssetStore& assets,
                             std::vector<float> times_s, double tolerance)
    : film_(film),
      document_(document),
      assets_(assets),
      times_s_(std::move(times_s)),
      tolerance_(tolerance)
{
    node("Scene", -1); // the only root; nodes below it are not turned to Y up themselves
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

int AnimatedNodes::home(Id id)
{
    const auto parts = std::ranges::equal_range(film_.strips, id, {}, &FilmStrip::object);
    return group(parts.size() > 1 ? id : object(document_, id).parent);
}

std::string AnimatedNodes::name_of(const FilmStrip& strip) const
{
    const auto first = std::ranges::find_if(strip.shown, std::identity());
    const Evaluation& then = film_.evaluated[static_cast<std::size_t>(first - strip.shown.begin())];
    const Object& source = object(document_, strip.object);
    return name_of_part(*then.objects.at(strip.object), source, strip.key) +
           strip.name.substr(source.name.size());
}

int AnimatedNodes::holder(int parent, const std::string& name, const std::vector<bool>& shown)
{
    if (std::ranges::find(shown, false) == shown.end()) return parent;
    const int out = node(name + " shown", parent);
    Channel channel;
    channel.node = out;
    channel.of = Channel::Of::scale;
    channel.interpolation = Channel::Interpolation::step;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const float scale = shown[i] ? 1 : 0;
        if (!channel.values.empty() && channel.values.back() == scale) continue;
        channel.times_s.push_back(not_after((film_.moments[i] - film_.moments.front()) /
                                            document_.time.frames_per_second));
        channel.values.insert(channel.values.end(), 3, scale);
    }
    model_.nodes[static_cast<std::size_t>(out)].rest.scale = glm::dvec3(shown[0] ? 1 : 0);
    clip_.channels.push_back(std::move(channel));
    return out;
}

std::uint32_t AnimatedNodes::first_material(const Ref<std::vector<Material>>& materials)
{
    const auto [first, fresh] =
        first_material_.try_emplace(materials, static_cast<std::uint32_t>(model_.materials.size()));
    if (fresh)
        model_.materials.insert(model_.materials.end(), materials->begin(), materials->end());
    return first->second;
}

int AnimatedNodes::mesh(const FilmStrip& strip, Mesh mesh)
{
    model_.meshes.push_back(
        make_ref(with_materials_from(std::move(mesh), first_material(strip.materials))));
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
    // The other half of the tolerance is for the motion between moments.
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

// Pieces that a split or a cut made of a part move by themselves, and several of them would have
// one node of the model.
bool AnimatedNodes::is_of_its_model(const FilmStrip& strip) const
{
    if (strip.key.piece != 0) return false;
    if (std::ranges::any_of(strip.shown,
                            [](const Part* part) { return part && part->before_split; }))
        return false;
    return std::ranges::count_if(film_.strips, [&](const FilmStrip& other) {
               return other.object == strip.object && other.key == strip.key;
           }) == 1;
}

bool AnimatedNodes::add_moving(const FilmStrip& strip, FilmCertificate::PartClaim& claim)
{
    if (is_of_its_model(strip)) {
        if (Tree& known = tree(strip); known.from) {
            if (known.whole) hang(strip, known, claim);
            return known.whole;
        }
    } else if (strip.posed()) {
        return false;
    }
    const int parent = home(strip.object);
    const Model before = model_; // cheap: references are shared
    const std::size_t channels = clip_.channels.size();
    Mesh mesh = *strip.first().rest;
    mesh.influences.clear();
    mesh.morph_targets.clear();
    const int at = node(name_of(strip), holder(parent, name_of(strip), shown_at(strip)));
    if (!add_motion(at, each_moment<glm::dmat4>(strip, [](const Part& p) { return p.to_world; }),
                    bounding_box(mesh), claim)) {
        model_ = before;
        clip_.channels.resize(channels);
        return false;
    }
    const bool rests = clip_.channels.size() == channels; // unchanged at all moments
    claim.way = rests && why_unproven(document_, strip.object).empty() ? "still" : "node";
    claim.triangles_before = claim.triangles = triangles(mesh).size();
    claim.node = at;
    const int index = this->mesh(strip, std::move(mesh));
    model_.nodes[static_cast<std::size_t>(at)].mesh = index;
    return true;
}

void AnimatedNodes::add_targets(const FilmStrip& strip, TargetKeys&& keys,
                                FilmCertificate::PartClaim& claim)
{
    const int at =
        node(name_of(strip), holder(home(strip.object), name_of(strip), shown_at(strip)));
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

bool AnimatedNodes::add_curves(const CurveStrip& strip)
{
    const CurvePart& first = strip.first();
    if (!strip.rests() && !strip.is_rigid()) return false;
    const int parent = home(strip.object);
    const Model before = model_; // cheap: references are shared
    const std::size_t channels = clip_.channels.size();
    std::vector<bool> shown;
    std::vector<glm::dmat4> matrices;
    const CurvePart* last = &first;
    for (const CurvePart* part : strip.shown) {
        shown.push_back(part != nullptr);
        if (part) last = part;
        matrices.push_back(last->points.to_world);
    }
    Curves curves{first.points.mesh(), first.curves->begin, first.curves->material};
    const int at = node(strip.name, holder(parent, strip.name, shown));
    FilmCertificate::PartClaim nobody_reads;
    if (strip.rests()) {
        model_.nodes[static_cast<std::size_t>(at)].to_parent = first.points.to_world;
    } else if (!add_motion(at, matrices, bounding_box(*curves.points), nobody_reads)) {
        model_ = before;
        clip_.channels.resize(channels);
        return false;
    }
    curves.material.resize(curves.line_count(), 0);
    const std::uint32_t first_one = first_material(strip.materials);
    for (std::uint32_t& material : curves.material) material += first_one;
    model_.nodes[static_cast<std::size_t>(at)].curves = static_cast<int>(model_.curves.size());
    model_.curves.push_back(make_ref(std::move(curves)));
    return true;
}

std::string AnimatedNodes::add_camera()
{
    const auto camera = document_.kept_views.find("picture");
    if (camera == document_.kept_views.end()) return {};
    const int at = node("Render camera", 0);
    model_.nodes[static_cast<std::size_t>(at)].camera = 0;
    std::vector<glm::dmat4> matrices;
    Box seen; // from the eye to the picture's corners where it looks: these stay in their places
    seen.add(glm::dvec3(0));
    bool zooms = false;
    for (const double moment : film_.moments) {
        const Camera now = document_at(document_, moment).kept_views.at("picture");
        if (matrices.empty()) model_.cameras = {now};
        matrices.push_back(glm::inverse(view_matrix(now)));
        const double away = glm::distance(now.eye, now.target);
        const double half = now.perspective ? away * std::tan(now.fov_y / 2) : now.height_world / 2;
        for (const double sign : {-1.0, 1.0}) seen.add({sign * half, sign * half, -away});
        const Camera& first = model_.cameras.front();
        zooms |= now.fov_y != first.fov_y || now.height_world != first.height_world;
    }
    FilmCertificate::PartClaim nobody_reads;
    add_motion(at, matrices, seen, nobody_reads);
    return zooms ? "the render camera keeps the angle of its first frame: glTF has no keys for it"
                 : "";
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
