// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/kept_shapes.h"

#include "core/commands/group.h"
#include "core/files/write_model.h"
#include "editor/files/files.h"
#include "editor/session/scene_facts.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace trivar {
namespace {

// What every file system takes as a name.
std::string as_file_name(std::string name)
{
    constexpr std::size_t longest = 60;
    name.resize(std::min(name.size(), longest));
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != ' '; }, '-');
    return name;
}

// In the space of what is its parent then.
Model model_then(const EvaluatedObject& object, const Document& then)
{
    EvaluatedObject there = object;
    const Id parent = then.objects.at(object.id)->parent;
    const glm::dmat4 from_world =
        parent == 0 ? glm::dmat4(1) : glm::inverse(to_world(then, parent));
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

} // namespace

Command kept_shapes(const Session& session, Id lattice)
{
    KeepShape keep{lattice, {}, {}};
    const Document& document = session.document();
    const Document then = after(document, Ungroup{lattice});
    const std::filesystem::path folder = session.assets()->folder();
    for (const auto& [id, each] : session.evaluated().objects) {
        if (id == lattice || each->shows_nothing() || !belongs_to(document, id, lattice)) continue;
        const std::filesystem::path file =
            folder / (as_file_name(name_of(document, id) + " kept") + ".glb");
        const std::string path = numbered_name(file.string());
        write_model(model_then(*each, then), path);
        keep.members.push_back(id);
        keep.files.emplace_back().path = path;
    }
    if (keep.members.empty()) return Ungroup{lattice};
    return prepare(std::move(keep), *session.assets());
}

} // namespace trivar
