// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/selection.h"

#include "core/commands/keying.h"
#include "editor/picture.h"
#include "editor/recent_scenes.h"
#include "editor/samples.h"
#include "editor/session.h"

#include <algorithm>
#include <filesystem>

namespace trivar {

Selection& Selection::operator=(Id id)
{
    ids_.clear();
    if (id != 0) ids_.push_back(id);
    return *this;
}

bool Selection::contains(Id id) const
{
    return std::find(ids_.begin(), ids_.end(), id) != ids_.end();
}

void Selection::set(const std::vector<Id>& ids)
{
    ids_.clear();
    add(ids);
}

void Selection::add(const std::vector<Id>& ids)
{
    for (const Id id : ids) {
        if (id == 0) continue;
        std::erase(ids_, id);
        ids_.push_back(id);
    }
}

void Selection::toggle(Id id)
{
    if (std::erase(ids_, id) == 0 && id != 0) ids_.push_back(id);
}

void Selection::keep_those_in(const Document& document)
{
    std::erase_if(ids_, [&](Id id) { return !document.objects.contains(id); });
}

Members::Members(const Document& document, const std::vector<Id>& ids)
    : document_(&document),
      ids_(ids)
{
    std::sort(ids_.begin(), ids_.end());
}

bool Members::contain(Id id) const
{
    while (id != 0) {
        if (std::binary_search(ids_.begin(), ids_.end(), id)) return true;
        const auto found = document_->objects.find(id);
        id = found == document_->objects.end() ? 0 : found->second->parent;
    }
    return false;
}

std::vector<Id> topmost(const Document& document, const std::vector<Id>& ids)
{
    const Members members(document, ids);
    std::vector<Id> result;
    for (const Id id : ids) {
        const auto found = document.objects.find(id);
        if (found != document.objects.end() && !members.contain(found->second->parent))
            result.push_back(id);
    }
    return result;
}

Box bounds_of(const Session& session, Id id)
{
    Box box;
    for (const auto& [each, object] : session.evaluated().objects)
        if (belongs_to(session.document(), each, id)) box.add(*object->bounds);
    return box;
}

Box bounds_of(const Session& session, const std::vector<Id>& ids)
{
    const Members members(session.document(), ids);
    Box box;
    for (const auto& [id, object] : session.evaluated().objects)
        if (members.contain(id)) box.add(*object->bounds);
    return box;
}

std::vector<glm::dvec3> points_of(const Session& session, const std::vector<Id>& ids)
{
    const Members members(session.document(), ids);
    std::vector<glm::dvec3> points;
    for (const auto& [id, object] : session.evaluated().objects)
        if (ids.empty() ? !std::ranges::binary_search(session.aside, id) : members.contain(id))
            add_points(points, *object);
    return points;
}

bool belongs_to(const Document& document, Id id, Id group)
{
    while (id != group && id != 0) {
        const auto found = document.objects.find(id);
        id = found == document.objects.end() ? 0 : found->second->parent;
    }
    return id == group;
}

std::string title_of(const SceneFile& scene)
{
    if (scene.look_only()) return stem_of(scene) + " (look only)";
    if (!scene.path().empty()) return std::filesystem::path(scene.path()).filename().string();
    if (scene.original().empty()) return "Untitled";
    const std::string sample = sample_title(scene.original());
    return sample.empty() ? stem_of(scene) + " (copy)" : sample;
}

std::string stem_of(const SceneFile& scene)
{
    const std::string& path = scene.path().empty() ? scene.original() : scene.path();
    return path.empty() ? "untitled" : std::filesystem::path(path).stem().string();
}

std::vector<Id> travelling(const Document& document)
{
    std::vector<Id> ids = in_row_order(document);
    std::erase_if(ids, [&](Id id) {
        const Object& each = object(document, id);
        return !each.placement || each.travel.speed == 0;
    });
    return ids;
}

bool moves_in_time(const Document& document)
{
    return !travelling(document).empty() || !animated_ids(document).empty() ||
           std::ranges::any_of(document.objects,
                               [](const auto& o) { return !o.second->playing.clip.empty(); });
}

std::string name_of(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found == document.objects.end() ? std::string() : found->second->name;
}

} // namespace trivar
