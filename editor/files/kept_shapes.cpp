// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/kept_shapes.h"

#include "core/commands/objects/group.h"
#include "core/evaluation/evaluate.h"
#include "core/files/copies.h"
#include "core/files/write_model.h"
#include "editor/session/scene_facts.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace trivar {
namespace {

// Turns a name into one that every file system accepts.
std::string as_file_name(std::string name)
{
    constexpr std::size_t longest = 60;
    name.resize(std::min(name.size(), longest));
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != ' '; }, '-');
    return name;
}

} // namespace

bool keeps_shapes(const Session& session)
{
    return !session.scene().path().empty() || !session.unnamed_folder().empty();
}

std::string kept_file(Session& session, const std::string& name)
{
    const std::filesystem::path folder = session.make_shapes_folder();
    return numbered_name((folder / (as_file_name(name) + ".glb")).string());
}

Model kept_model(const EvaluatedObject& object, const Document& then, const glm::dmat4& from_world)
{
    EvaluatedObject there = object;
    for (Part& part : there.parts) {
        part = {.rest = make_ref(transformed(*part.mesh(), from_world * part.to_world)),
                .key = part.key};
    }
    for (CurvePart& part : there.curves) {
        Curves kept = in_world(part);
        kept = transformed(kept, from_world);
        part.curves = make_ref(std::move(kept));
        part.points = {.rest = part.curves->points, .key = part.points.key};
    }
    Evaluation one;
    one.objects.emplace(object.id, make_ref(std::move(there)));
    return model_of(one, then);
}

namespace {

// The file at that path or the next number of it that holds the model; it is written where none
// does.
std::string file_with(const Model& model, const std::string& path)
{
    const std::string made = numbered_name(path);
    write_model(model, made);
    const std::string same =
        numbered_name(path, [&](const std::string& each) { return same_content(each, made); });
    std::error_code ignored;
    if (same != made) std::filesystem::remove(made, ignored);
    return same;
}

} // namespace

Command kept_shapes(Session& session, Id lattice)
{
    KeepShape keep{lattice, {}, {}};
    const Document& document = session.document();
    const Document then = after(document, Ungroup{lattice});
    const std::filesystem::path folder = session.make_shapes_folder();
    for (const auto& [id, each] : session.evaluated().objects) {
        if (id == lattice || each->has_no_geometry() || !belongs_to(document, id, lattice))
            continue;
        const std::filesystem::path file =
            folder / (as_file_name(name_of(document, id) + " kept") + ".glb");
        keep.members.push_back(id);
        const Id parent = then.objects.at(id)->parent;
        const glm::dmat4 from_world =
            parent == 0 ? glm::dmat4(1) : glm::inverse(to_world(then, parent));
        keep.files.emplace_back().path =
            file_with(kept_model(*each, then, from_world), file.string());
    }
    if (keep.members.empty()) return Ungroup{lattice};
    return prepare(std::move(keep), *session.assets());
}

} // namespace trivar
