// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/volumes/tetrahedra.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/edits/entry_tracks.h"
#include "core/commands/objects/group.h"
#include "core/commands/words/changes.h"
#include "core/simplex/cell_displacements.h"
#include "core/tetrahedra/remaining_edits.h"
#include "core/tetrahedra/tetrahedra_layers.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::size_t most_places = 100'000;  // of all creases and refinements
constexpr std::size_t most_balls = 1'000'000; // of all pulls

void check(const TetrahedraEdit& edit)
{
    const int kinds = (edit.pull ? 1 : 0) + (edit.warp ? 1 : 0) + (edit.crease ? 1 : 0) +
                      (edit.refinement ? 1 : 0) + (edit.cloud ? 1 : 0);
    if (kinds != 1)
        throw Rejected(fmt::format(
            "an edit is one of pull, warp, crease, refinement and cloud, not {}", kinds));
    if (edit.crease && edit.crease->places.empty())
        throw Rejected("field \"places\" of the crease is empty");
}

// Checks the totals of all edits.
void check_totals(const TetrahedraShape& shape)
{
    if (shape.edits.size() > most_tetrahedra_edits)
        throw Rejected(fmt::format("field \"edits\" has {} steps; at most {} are allowed",
                                   shape.edits.size(), most_tetrahedra_edits));
    if (shape.functions.size() > most_shown_functions)
        throw Rejected(fmt::format("a volume shows at most {} functions, not {}",
                                   most_shown_functions, shape.functions.size()));
    std::size_t places = 0, balls = 0;
    for (const TetrahedraEdit& edit : shape.edits) {
        if (edit.crease) places += edit.crease->places.size();
        if (edit.refinement) places += edit.refinement->places.size();
        if (edit.pull) balls += edit.pull->also.size() + 1;
    }
    if (places > most_places)
        throw Rejected(
            fmt::format("the creases and refinements of a volume have at most {} places, not {}",
                        with_commas(most_places), with_commas(places)));
    if (balls > most_balls)
        throw Rejected(fmt::format("the pulls of a volume have at most {} balls, not {}",
                                   with_commas(most_balls), with_commas(balls)));
}

// Each refinement, and all together.
void check_layers(const TetrahedraShape& shape)
{
    std::size_t cells = shape.cells.size();
    if (shape.cells.empty())
        cells = static_cast<std::size_t>(6 * shape.boxes.x * shape.boxes.y * shape.boxes.z);
    for (const TetrahedraEdit& edit : shape.edits) {
        if (!edit.refinement) continue;
        cells += cells_near(*edit.refinement).cells.size();
        if (cells > most_cells_in_all)
            throw Rejected(fmt::format("a volume and its refinements have at most {} tetrahedra",
                                       most_cells_in_all));
    }
}

// Knots that were moved by hand may cross.
void check_clouds(const TetrahedraShape& shape)
{
    if (std::ranges::any_of(shape.edits, [](const TetrahedraEdit& e) { return !!e.cloud; }))
        (void)domain_of(shape);
}

// Whether the numbers lie where their fields have them.
bool keeps_rules(const TetrahedraCloud& cloud)
{
    bool out = true;
    each_field(cloud, [&](std::string_view, const auto& value, std::string_view, Rule rule = {}) {
        const auto is_within = [&](double x) { return x >= rule.lo && x <= rule.hi; };
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>)
            out = out && is_within(static_cast<double>(value));
        else
            for (int k = 0; k < 3; ++k) out = out && is_within(value[k]);
    });
    return out;
}

// Adds an edit as the last one. Knots that are moved again where they were moved last take both
// ways in one edit, or none where the second way leads back: hands try, and try again.
void append(std::vector<TetrahedraEdit>& edits, const TetrahedraEdit& edit)
{
    const auto moves_the_same = [&](const TetrahedraEdit& last) {
        return last.cloud && edit.cloud && last.cloud->at == edit.cloud->at &&
               last.cloud->knot == edit.cloud->knot;
    };
    if (edits.empty() || !moves_the_same(edits.back())) return edits.push_back(edit);
    TetrahedraCloud both = *edits.back().cloud;
    both.by = both.by * edit.cloud->factor + edit.cloud->by;
    both.factor *= edit.cloud->factor;
    if (!keeps_rules(both)) return edits.push_back(edit); // each by itself does
    edits.back().cloud = both;
    if (both.by == glm::dvec3(0) && both.factor == 1) edits.pop_back();
}

// "Pull by 0.2 m", "Turn 3 places".
std::string words_of(const TetrahedraPull& pull)
{
    const std::string places =
        pull.also.empty() ? "" : fmt::format(" {} places", pull.also.size() + 1);
    if (pull.by != glm::dvec3(0))
        return fmt::format("Pull{} by {} m", places, number_text(glm::length(pull.by)));
    return (pull.factors != glm::dvec3(1) ? "Scale" : "Turn") + places;
}

const TetrahedraShape& volume_of(const Document& document, Id id)
{
    const Object& o = object(document, id);
    const auto* shape = std::get_if<TetrahedraShape>(&o.source);
    if (!shape)
        throw Rejected(
            fmt::format("field \"object\": {} is not a volume of tetrahedra", named(id, o)));
    return *shape;
}

Document with_shape(Document document, Id id, TetrahedraShape shape)
{
    return with_changed(std::move(document), id, [&](Object& o) { o.source = std::move(shape); });
}

} // namespace

void check(const TetrahedraShape& shape)
{
    const SimplexMesh<3> mesh = domain_cells(shape);
    if (!shape.cells.empty()) { // the domain with all knots on its vertices
        SimplexDomain<3> bare{1, {}, mesh.cells};
        for (const glm::dvec3& v : mesh.vertices) bare.knots.insert(bare.knots.end(), 2, v);
        check(bare);
    } else if (!shape.vertices.empty())
        throw Rejected("field \"vertices\" has vertices, but \"cells\" no tetrahedra");
    if (const int degree = degree_of(shape.displaced.size(), mesh.cells.size());
        !shape.displaced.empty() && (degree == 0 || degree > shape.degree))
        throw Rejected("what was a lattice keeps its tetrahedra, and at least its degree");
    check_totals(shape);
    for (const TetrahedraEdit& edit : shape.edits) check(edit);
    check_layers(shape);
    check_clouds(shape);
}

std::string size_words(const SimplexSheetShape& shape)
{
    return fmt::format("{} × {} m", number_text(shape.size.x), number_text(shape.size.y));
}

Document applied(Document document, const AddTetrahedra& command)
{
    check(command.shape);
    check_transform(command.transform);
    return with_parent_of(std::move(document), command.objects,
                          {.name = command.name,
                           .source = command.shape,
                           .transform = command.transform,
                           .surfacing = {},
                           .stroke = {}});
}

StepTitle title(const AddTetrahedra& c, const StepDocuments& step)
{
    return {"Put tetrahedra round " + names_in(step.before, c.objects),
            c.shape.cells.empty() ? value_words(c.shape.boxes, any_value)
                                  : std::to_string(c.shape.cells.size())};
}

Document applied(Document document, const EditTetrahedra& command)
{
    TetrahedraShape shape = volume_of(document, command.object);
    check(command.edit);
    append(shape.edits, command.edit);
    check_totals(shape);
    if (command.edit.refinement) check_layers(shape);
    if (command.edit.crease || command.edit.cloud) check_clouds(shape);
    return with_shape(std::move(document), command.object, std::move(shape));
}

std::string words_of(const TetrahedraEdit& edit, int degree)
{
    if (edit.pull) return words_of(*edit.pull);
    if (edit.warp) return "Warp";
    if (edit.cloud)
        return edit.cloud->knot == 0 ? "Move a cloud of knots"
                                     : fmt::format("Move knot {}", edit.cloud->knot);
    if (edit.refinement) return fmt::format("Refine to {} m", number_text(edit.refinement->edge));
    if (!edit.crease) return "Nothing";
    if (edit.crease->depth >= degree) return "Cut";
    if (edit.crease->depth == 0) return "Smooth";
    return edit.crease->depth == degree - 1 ? "Crease" : "Soft crease";
}

StepTitle title(const EditTetrahedra& c, const StepDocuments& step)
{
    const Object* object = step.was(c.object);
    const auto* old = object ? std::get_if<TetrahedraShape>(&object->source) : nullptr;
    return {words_of(c.edit, old ? old->degree : 2) + " in " + name_in(step.before, c.object), {}};
}

Document applied(Document document, const RemoveTetrahedraEdit& command)
{
    const std::size_t index =
        entry_index(document, command.object, volume_of(document, command.object).edits.size(),
                    command.number, "edits");
    return with_changed(std::move(document), command.object, [&](Object& o) {
        auto& shape = std::get<TetrahedraShape>(o.source);
        RemainingEdits remaining = without_edit(std::move(shape.edits), index);
        shape.edits = std::move(remaining.edits);
        o.tracks = without_entries(o.tracks, "shape.edits.", remaining.gone);
        check_clouds(shape);
    });
}

StepTitle title(const RemoveTetrahedraEdit& c, const StepDocuments& step)
{
    return {fmt::format("Remove edit {} of {}", c.number, name_in(step.before, c.object)), {}};
}

} // namespace trivar
