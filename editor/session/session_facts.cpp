// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/session_facts.h"

#include "editor/picture/picture.h"
#include "editor/session/scene_facts.h"
#include "ui/camera_control.h"

namespace trivar {

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
    if (ids.empty()) return points_of(session.evaluated(), session.hidden_here);
    const Members members(session.document(), ids);
    std::vector<glm::dvec3> points;
    for (const auto& [id, object] : session.evaluated().objects)
        if (members.contain(id)) add_seen_points(points, *object);
    return points;
}

Camera camera_for_pictures(const Session& session)
{
    const auto kept = session.document().kept_views.find("picture");
    if (kept == session.document().kept_views.end()) return session.view.camera;
    if (session.view.follows && session.view.follows->name == "picture" &&
        session.view.follows->shown == session.view.camera)
        return kept->second;
    return ui::reshaped(session.view.camera, kept->second.size_px);
}

Id heights_in_hand(const Session& session)
{
    if (!session.proposing() || session.selected == 0) return 0;
    const Id id = session.selected;
    const auto before = session.committed().objects.find(id),
               now = session.scene().history().document().objects.find(id);
    if (before == session.committed().objects.end() ||
        now == session.scene().history().document().objects.end())
        return 0;
    const std::optional<Tiling>&was = before->second->tiles, &is = now->second->tiles;
    if (!was || !is || was == is) return 0;
    if (was->look.height != is->look.height) return id;
    for (std::size_t i = 0; i < is->strokes.size(); ++i) {
        const TileStroke& stroke = *is->strokes[i];
        const bool other = i >= was->strokes.size() ? stroke.brush == TileBrush::raise
                                                    : stroke.height != was->strokes[i]->height;
        if (other) return id;
    }
    return 0;
}

} // namespace trivar
