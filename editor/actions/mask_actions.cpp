// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/mask_actions.h"

#include "core/base/rejected.h"
#include "core/base/rounded.h"
#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/stages/tiled_base.h"
#include "editor/actions/menu.h"
#include "editor/commands/new_material.h"
#include "editor/editor.h"
#include "editor/session/scene_facts.h"
#include "editor/tools/tiles/mask.h"
#include "editor/words/file_words.h"

#include <algorithm>
#include <filesystem>

namespace trivar {
namespace {

bool selects_layer(const Editor& e)
{
    return is_tile_layer(e.session.document(), e.session.selected);
}

bool selects_surface(const Editor& e)
{
    const auto found = e.session.document().objects.find(e.session.selected);
    return found != e.session.document().objects.end() && kind_of(*found->second).has_surface &&
           !found->second->tiles;
}

// Whether an object has texture coordinates as shown.
bool shows_uvs(const Session& session, Id id)
{
    const auto shown = session.evaluated().objects.find(id);
    return shown != session.evaluated().objects.end() && !shown->second->parts.empty() &&
           !shown->second->parts.front().rest->uvs.empty();
}

// Runs a command that names a picture; what cannot be read is told and changes nothing.
bool run_with_image(Session& session, const Command& command, const std::string& path)
{
    try {
        return session.run(prepare(command, *session.assets()));
    } catch (const Rejected& why) {
        session.notices.say(ui::NoticeKind::error, file_name(path) + " is not used",
                            reason(why.what(), path));
        return false;
    }
}

void mask_by_image(Editor& e, Id layer, int number, const std::string& path)
{
    Session& session = e.session;
    if (!is_tile_layer(session.document(), layer)) return;
    const Tiling& tiling = *object(session.document(), layer).tiles;
    MaskTiles command{layer, number, {}};
    if (number > 0 && static_cast<std::size_t>(number) <= tiling.masks.size())
        command.mask = tiling.masks[static_cast<std::size_t>(number) - 1];
    else
        command.mask.lies =
            shows_uvs(session, tiling.base) ? MaskLies::uv : MaskLies::from_six_sides;
    command.mask.from = MaskFrom::image;
    command.mask.image = std::filesystem::absolute(path).string();
    if (run_with_image(session, command, path)) session.selected = layer;
}

double face_count(const EvaluatedObject& shown)
{
    double faces = 0;
    for (const Part& part : shown.parts) faces += static_cast<double>(part.rest->face_count());
    return std::max(1.0, faces);
}

// The heights of a displacement at first, for what an object shows: over its UVs where it has some.
// Metres on its model, lower where a picture lies over faces that are small; sheets are as fine as
// the faces are few.
HeightShape usual_heights(const Session& session, Id base)
{
    constexpr double share = 0.03, share_of_face = 0.25; // of the largest side, of that of a face
    constexpr double vertices = 400'000;
    HeightShape out;
    const auto found = session.evaluated().objects.find(base);
    if (found == session.evaluated().objects.end() || found->second->parts.empty()) return out;
    const EvaluatedObject& shown = *found->second;
    const double faces = face_count(shown);
    out.segments = std::clamp(static_cast<int>(std::sqrt(vertices / faces)), 2, 256);
    const Part& part = shown.parts.front();
    const glm::dvec3 size = shown.bounds->size();
    const double side = std::max({size.x, size.y, size.z, 1e-6});
    const double scale =
        RestToWorld(part, mesh_to_model(shown, object(session.document(), base), part))
            .scale({0, 0, 0});
    if (shows_uvs(session, base)) out.lies = HeightsLie::uv;
    const double height = out.lies == HeightsLie::uv
                              ? share * side
                              : std::min(share * side, share_of_face * side / std::sqrt(faces));
    out.height = rounded(scale > 0 ? height / scale : height, 2);
    return out;
}

void displace_by(Editor& e, Id base, const std::string& path)
{
    Session& session = e.session;
    if (!session.document().objects.contains(base)) return;
    const Id id = session.committed().next_id;
    Displace command{.base = base, .shape = usual_heights(session, base)};
    command.shape.image = std::filesystem::absolute(path).string();
    if (!object(session.document(), base).surfacing) command.material = new_material;
    if (run_with_image(session, command, path)) session.selected = id;
}

void ask_displacement(Editor& e)
{
    e.files.ask_image("Choose a picture of heights",
                      [&e, base = Id(e.session.selected)](const std::string& path) {
                          displace_by(e, base, path);
                      });
}

void mask_by_curve(Editor& e)
{
    const Id layer = e.session.selected, curve = e.session.selected.but_the_active().front();
    MaskTiles command{layer, 0, {}};
    command.mask.from = MaskFrom::curve;
    command.mask.curve = curve;
    command.mask.stop = usual_reach(e.session, layer);
    if (e.session.run(command)) e.session.selected = layer;
}

} // namespace

void use_image(Editor& editor, const std::string& path)
{
    if (selects_layer(editor)) return mask_by_image(editor, editor.session.selected, 0, path);
    if (selects_surface(editor)) return displace_by(editor, editor.session.selected, path);
    editor.session.notices.say(ui::NoticeKind::warning, file_name(path) + " is not used",
                               "Select an object to displace by it, or a layer of tiles to mask, "
                               "then drop the picture again.");
}

void change_heights_image(Editor& editor, int id, const std::string& path)
{
    const auto* shape = made_of<HeightShape>(editor.session.document(), id);
    if (!shape) return;
    SetHeights command{id, *shape};
    command.shape.image = std::filesystem::absolute(path).string();
    run_with_image(editor.session, command, path);
}

void ask_mask_image(Editor& editor, int layer, int number)
{
    editor.files.ask_image("Choose a picture for the mask",
                           [&editor, layer, number](const std::string& path) {
                               mask_by_image(editor, layer, number, path);
                           });
}

void add_mask_actions(std::vector<Action>& actions)
{
    const Menu tools(actions, "Tools");
    tools("Mask tiles by image...", {}, [](Editor& e) { ask_mask_image(e, e.session.selected); },
          {selects_layer, "select a layer of tiles first"});
    tools("Mask tiles by curve", {}, mask_by_curve,
          {[](const Editor& e) { return e.session.selected.size() == 2 && selects_layer(e); },
           "select an object on a stroke or with lines first, and the layer of tiles last"});
    tools("Displace by image...", {}, ask_displacement,
          {selects_surface, "select an object with a surface first"});
}

} // namespace trivar
