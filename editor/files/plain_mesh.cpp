// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/plain_mesh.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/rounded.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/refine.h"
#include "core/commands/placement/apply_shape.h"
#include "core/document/parameters.h"
#include "core/evaluation/evaluate.h"
#include "core/files/write_model.h"
#include "core/steps/bending/refining.h"
#include "core/steps/laying/attaching.h"
#include "editor/files/kept_shapes.h"
#include "editor/session/scene_facts.h"
#include "ui/widgets.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

namespace trivar {
namespace {

// A PlainMeshJob is all that the job needs, as it was when it was asked for.
struct PlainMeshJob {
    PlainMeshWish wish;
    Document document;
    double frame = 1;
    Ref<AssetStore> assets;
    std::string path; // of the file, as the scene's folder for shapes was
};

std::string plain_name(const PlainMeshJob& asked)
{
    return name_of(asked.document, asked.wish.object) + " plain";
}

// A PlainMesh is the result of the job: a model, with what is proven of it.
struct PlainMesh {
    Transform transform = {}; // where the model of the file stands to its parent, or in the world
    std::size_t triangles = 0;
    double bound = 0;
    std::string open = {}; // what is not certified; empty: everything is
    std::shared_ptr<const Model> model = {};
    bool written = false; // at the path that was asked for
};

glm::dmat4 parent_to_world(const Document& document, const PlainMeshWish& wish)
{
    const Id parent = wish.in_place ? object(document, wish.object).parent : 0;
    return parent == 0 ? glm::dmat4(1) : to_world(document, parent);
}

// Its origin in the middle of it, in round numbers.
Transform standing_at(const Box& bounds, const glm::dmat4& from_world)
{
    const glm::dvec3 middle(from_world * glm::dvec4(bounds.center(), 1));
    return {.translation = {rounded(middle.x, 4), rounded(middle.y, 4), rounded(middle.z, 4)}};
}

// Runs beside the window.
PlainMesh made(const PlainMeshJob& asked, const Progress& progress)
{
    const PlainMeshWish& wish = asked.wish;
    const Document finer = after(asked.document, Refine{{wish.object}, wish.refining});
    Evaluator evaluate(asked.assets);
    const Evaluation all = evaluate(finer, asked.frame, progress);
    const auto found = all.objects.find(wish.object);
    if (found == all.objects.end()) throw Rejected("it is hidden; show it first");
    const EvaluatedObject& shown = *found->second;
    if (!shown.placement || shown.has_no_geometry())
        throw Rejected(shown.rejected.empty() ? "it is empty" : shown.rejected);
    const Document document = document_at(finer, asked.frame);
    const glm::dmat4 from_world = glm::inverse(parent_to_world(document, wish));
    PlainMesh out{standing_at(*shown.bounds, from_world)};
    const glm::dmat4 to_own =
        glm::translate(glm::dmat4(1), -out.transform.translation) * from_world;
    out.model = std::make_shared<const Model>(kept_model(shown, finer, to_own));
    try {
        write_model(*out.model, asked.path);
        out.written = true;
    } catch (const Rejected&) { // the folder may have gone as the scene got a name
    }
    if (!shown.refined) return out; // curves alone
    out.triangles = shown.refined->triangles();
    out.bound = shown.refined->bound;
    out.open = notice_of(*shown.refined, wish.refining);
    return out;
}

// Keeps the strokes on the object attached to it, by the transform of its new model.
void keep_riders(const Session& session, ApplyShape& command)
{
    const Document& document = session.document();
    const PlainMeshWish wish{command.object, {}, true};
    const glm::dmat4 stands = parent_to_world(document, wish) * command.transform.matrix();
    for (const auto& [id, laid] : session.evaluated().objects) {
        const auto there = document.objects.find(id);
        if (there == document.objects.end() || !there->second->stroke) continue;
        const PlacementStep& step = *there->second->stroke;
        auto hosts = hosts_now(*laid, step);
        if (!hosts) continue;
        const auto host = std::ranges::find(hosts->hosts, command.object, &AttachedHost::object);
        if (host == hosts->hosts.end()) continue;
        if (std::ranges::find(step.attach->hosts, command.object, &AttachedHost::object) ==
            step.attach->hosts.end())
            continue;
        *host = attached_host(command.object, glm::inverse(stroke_to_world(*laid)) * stands,
                              host->touched);
        command.riders.push_back(id);
        command.strokes.push_back(stroke_now(*laid, step));
        command.attach.push_back(std::move(*hosts));
    }
}

std::string words_of(const PlainMesh& made, const PlainMeshWish& wish)
{
    if (made.triangles == 0) return "Its curves keep their shape.";
    const std::string count = with_commas(made.triangles) + " triangles";
    if (!made.open.empty()) return count + "; " + made.open + ".";
    return fmt::format("{}, certified to be within {} m of the bent surface; at most {} m off.",
                       count, ui::short_number(wish.refining.tolerance),
                       ui::short_number(rounded_up(made.bound, 3)));
}

// The file in the scene's present folder for shapes; it is written where it is not there yet.
std::string file_of(Session& session, const PlainMeshJob& asked, const PlainMesh& made)
{
    namespace fs = std::filesystem;
    const fs::path folder = session.make_shapes_folder();
    if (made.written && fs::path(asked.path).parent_path() == folder) return asked.path;
    const std::string path = kept_file(session, plain_name(asked));
    write_model(*made.model, path);
    std::error_code ignored;
    if (made.written) fs::remove(asked.path, ignored);
    return path;
}

void take(Session& session, const PlainMeshJob& asked, const PlainMesh& made)
{
    const PlainMeshWish& wish = asked.wish;
    const std::string name = name_of(asked.document, wish.object);
    ImportedFile file;
    file.path = file_of(session, asked, made);
    Command command = ImportModel{file, plain_name(asked), made.transform};
    if (wish.in_place) {
        ApplyShape apply{wish.object, file, made.transform};
        if (made.triangles > 0 && made.open.empty()) apply.tolerance = wish.refining.tolerance;
        keep_riders(session, apply);
        command = std::move(apply);
    }
    const Id added = session.committed().next_id;
    if (!session.run(prepare(std::move(command), *session.assets()))) return;
    session.selected = wish.in_place ? wish.object : added;
    session.notices.say(made.open.empty() ? ui::NoticeKind::good : ui::NoticeKind::warning,
                        wish.in_place
                            ? name + " is a plain mesh now"
                            : name + " was copied as a plain mesh, where " + name + " lies",
                        words_of(made, wish));
}

} // namespace

Id laid_shape(const Session& session)
{
    const Document& document = session.document();
    const Id id = session.selected;
    if (session.selected.size() != 1 || locked(document, id)) return 0;
    const auto shown = session.evaluated().objects.find(id);
    const auto there = document.objects.find(id);
    if (shown == session.evaluated().objects.end() || there == document.objects.end()) return 0;
    const bool laid = there->second->stroke && shown->second->placement;
    if (!laid || shown->second->has_no_geometry() || !kind_of(*there->second).has_surface) return 0;
    return id;
}

PlainMeshWish usual_plain_mesh(const Session& session, bool in_place)
{
    const Id id = laid_shape(session);
    if (id == 0) return {};
    return {id, object(session.document(), id).refining.value_or(Refining{}), in_place};
}

void make_plain_mesh(Session& session, const PlainMeshWish& wish)
{
    const std::string name = name_of(session.document(), wish.object);
    const auto lost = [&session, name](const std::string& why) {
        session.notices.say(ui::NoticeKind::error, "No plain mesh of " + name + " was made", why);
    };
    auto wanted = std::make_shared<PlainMeshJob>(PlainMeshJob{
        wish, session.committed(), static_cast<double>(session.frame()), session.assets(), {}});
    try {
        wanted->path = kept_file(session, plain_name(*wanted));
    } catch (const Rejected& why) {
        return lost(why.what());
    }
    const std::shared_ptr<const PlainMeshJob> asked = std::move(wanted);
    const long scene = session.scenes();
    session.jobs().start(
        {.what = "Making a plain mesh of " + name,
         .work = [&session, asked, scene, lost](const Progress& progress) -> Jobs::Finish {
             const PlainMesh result = made(*asked, progress);
             return [&session, asked, scene, lost, result] {
                 // Another scene, or it is another shape by now.
                 const auto& now = session.committed().objects;
                 const auto found = now.find(asked->wish.object);
                 if (session.scenes() != scene) return;
                 if (found == now.end() ||
                     found->second->stroke != object(asked->document, asked->wish.object).stroke)
                     return lost("it was changed meanwhile; try again");
                 try {
                     take(session, *asked, result);
                 } catch (const Rejected& why) {
                     lost(why.what());
                 }
             };
         },
         .when_lost = lost});
}

} // namespace trivar
