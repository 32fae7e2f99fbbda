// SPDX-License-Identifier: GPL-3.0-or-later
// This file builds the nodes of a model as in its source file: bones are found by their names.
#include "core/export/animated_nodes.h"

#include "core/document/parameters.h"

#include <algorithm>

namespace trivar {
namespace {

// Extends a box by a part in the space of its object.
void add_part(Box& box, const Part& part, const glm::dmat4& to_object)
{
    Box own = part.tiles ? part.bounds : bounding_box(*part.rest);
    if (part.posed) own = posed_bounds(own, target_bounds(*part.rest), part.posed->pose);
    if (own.empty()) return;
    for (const glm::dvec3& corner : own.corners())
        box.add(glm::dvec3(to_object * glm::dvec4(corner, 1)));
}

} // namespace

AnimatedNodes::Tree& AnimatedNodes::tree(const FilmStrip& strip)
{
    const auto [known, fresh] = trees_.try_emplace(strip.object);
    Tree& tree = known->second;
    const Object& source = object(document_, strip.object);
    const auto* file = std::get_if<ImportedFile>(&source.source);
    if (!fresh || !file) return tree;
    const Ref<Model> from = assets_.load(*file).model;
    if (!from || (from->nodes.size() < 2 && from->clips.empty() && !strip.posed())) return tree;
    tree.from = from;
    tree.claim.object = strip.object;
    const int parent = group(source.parent);
    const Model before = model_; // cheap: references are shared
    const std::size_t channels = clip_.channels.size();
    tree.object = node(source.name, holder(parent, source.name, shown_at(strip)));
    if (!add_motion_of_object(tree, strip)) {
        model_ = before;
        clip_.channels.resize(channels);
        return tree;
    }
    tree.whole = true;
    tree.first = static_cast<int>(model_.nodes.size());
    for (std::size_t n = 0; n < from->nodes.size(); ++n) {
        Node copy = from->nodes[n];
        if (copy.mesh >= 0) tree.with_mesh.push_back(static_cast<int>(n));
        copy.parent = copy.parent < 0 ? tree.object : tree.first + copy.parent;
        copy.mesh = copy.skin = copy.curves = -1; // attached with its part
        copy.morph_weights.clear();
        model_.nodes.push_back(std::move(copy));
    }
    add_clip(tree, source);
    return tree;
}

bool AnimatedNodes::add_motion_of_object(Tree& tree, const FilmStrip& strip)
{
    std::vector<glm::dmat4> matrices;
    for (const double moment : film_.moments)
        matrices.push_back(to_world(document_at(document_, moment), strip.object));
    const glm::dmat4& first = matrices.front();
    if (std::ranges::all_of(matrices, [&](const glm::dmat4& m) { return m == first; })) {
        model_.nodes[static_cast<std::size_t>(tree.object)].to_parent = first;
        return true;
    }
    Box box;
    for (const FilmStrip& each : film_.strips)
        for (std::size_t i = 0; i < matrices.size() && each.object == strip.object; ++i)
            if (const Part* part = each.shown[i])
                add_part(box, *part, glm::inverse(matrices[i]) * part->to_world);
    return add_motion(tree.object, matrices, box, tree.claim);
}

void AnimatedNodes::add_clip(Tree& tree, const Object& source)
{
    const auto clip = std::ranges::find(tree.from->clips, source.playing.clip, &Clip::name);
    if (clip == tree.from->clips.end()) return;
    const bool as_it_came = std::get<ImportedFile>(source.source).subdivisions > 0;
    const PlayedTime time = played_time(document_, tree.claim.object, *clip, film_.moments);
    for (const Channel& channel : clip->channels) {
        const int mesh = tree.from->nodes[static_cast<std::size_t>(channel.node)].mesh;
        if (channel.of == Channel::Of::morph_weights && (as_it_came || mesh < 0)) continue;
        Channel own = played(channel, time);
        own.node += tree.first;
        tree.claim.keys = std::max(tree.claim.keys, static_cast<int>(own.times_s.size()));
        clip_.channels.push_back(std::move(own));
    }
}

int AnimatedNodes::skin(Tree& tree, int index)
{
    const auto [known, fresh] =
        tree.skins.try_emplace(index, static_cast<int>(model_.skins.size()));
    if (!fresh) return known->second;
    Skin own = tree.from->skins[static_cast<std::size_t>(index)];
    for (int& joint : own.joints) joint += tree.first;
    model_.skins.push_back(std::move(own));
    return known->second;
}

void AnimatedNodes::hang(const FilmStrip& strip, Tree& tree, FilmCertificate::PartClaim& claim)
{
    const int source = tree.with_mesh[static_cast<std::size_t>(strip.key.mesh)];
    const Node& from = tree.from->nodes[static_cast<std::size_t>(source)];
    int at = tree.first + source;
    Mesh mesh = *strip.first().rest;
    const bool skinned = from.skin >= 0 && !mesh.influences.empty();
    // A subdivided mesh is in the space of its object, with its skin already applied.
    if (from.skin >= 0 && !skinned) at = node(from.name, tree.object);
    const bool swells = strip.posed() && std::ranges::any_of(strip.shown, [](const Part* part) {
                            return part && part->posed && !part->posed->pose.morph_weights.empty();
                        });
    if (!swells && std::ranges::none_of(clip_.channels, [&](const Channel& channel) {
            return channel.node == at && channel.of == Channel::Of::morph_weights;
        }))
        mesh.morph_targets.clear();
    claim.keys = std::max(1, tree.claim.keys);
    claim.bound = tree.claim.bound;
    claim.way = tree.claim.keys == 0                     ? "still"
                : skinned || !mesh.morph_targets.empty() ? "skin"
                                                         : "node";
    claim.triangles_before = claim.triangles = triangles(mesh).size();
    claim.node = at;
    std::vector<float> weights = from.morph_weights;
    weights.resize(mesh.morph_targets.size(), 0);
    const int skin_index = skinned ? skin(tree, from.skin) : -1;
    const int index = this->mesh(strip, std::move(mesh));
    Node& here = model_.nodes[static_cast<std::size_t>(at)];
    here.mesh = index;
    here.skin = skin_index;
    here.morph_weights = std::move(weights);
}

} // namespace trivar
