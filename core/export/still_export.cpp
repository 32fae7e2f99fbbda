// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/still_export.h"

#include "core/base/finite.h"
#include "core/commands/objects/refine.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/evaluation/pattern_colors.h"
#include "core/files/gltf/repeated_nodes.h"
#include "core/refinement/refine.h"

#include <algorithm>
#include <filesystem>

namespace trivar {
namespace {

template <class E> std::string chosen_name(E value)
{
    return std::string(choice_names<E>.at(static_cast<std::size_t>(value)));
}

std::string why_not_laid(const EvaluatedObject& object)
{
    if (!object.notices.empty()) return object.notices.front(); // the first notice is the cause
    return object.rejected.empty() ? "it has no shape" : object.rejected;
}

// Says whether an object lies on its stroke: some part is bent, or it is a lattice, which has no
// parts.
bool lies_on_its_stroke(const EvaluatedObject& object)
{
    return object.lattice_stroke ||
           std::ranges::any_of(with_points(object.parts, object.curves),
                               [](const Part& part) { return part.bent != nullptr; });
}

// Makes the certificate of a model: `document` is the result of the log, `shown` is the document as
// evaluated into `model` by model_of().
Certificate certificate_of(const Document& document, const Document& shown,
                           const Evaluation& evaluated, const Model& model)
{
    Certificate out;
    out.scene = digest(document);
    int mesh = 0; // model_of() makes one mesh per part, in this order
    for (const auto& [id, ref] : evaluated.objects) {
        const Object& source = object(shown, id);
        if (source.stroke && !lies_on_its_stroke(*ref))
            out.not_laid.push_back({id, source.name, why_not_laid(*ref)});
        for (std::size_t p = 0; p < ref->parts.size(); ++p, ++mesh) {
            if (!ref->parts[p].bent) continue;
            const auto node = std::ranges::find(model.nodes, mesh, &Node::mesh);
            Certificate::PartClaim claim;
            claim.object = id;
            claim.part = static_cast<int>(p);
            claim.name = source.name;
            claim.node = static_cast<int>(node - model.nodes.begin());
            claim.triangles = claim.triangles_before = triangles(*ref->parts[p].rest).size();
            claim.bound = infinite;
            claim.not_certified = claim.triangles;
            const Refining refining = source.refining.value_or(Refining{});
            if (ref->refined) {
                const RefinedPart& refined = ref->refined->parts.at(p);
                claim.triangles_before = refined.triangles_before;
                claim.triangles = refined.triangles;
                claim.degenerate = refined.degenerate;
                claim.not_certified = refined.not_certified.size();
                claim.bound = refined.bound;
                claim.tolerance = refining.tolerance;
                claim.method = chosen_name(refining.method);
                claim.rule = chosen_name(refining.rule);
            }
            out.bound = std::max(out.bound, claim.bound);
            out.parts.push_back(std::move(claim));
        }
    }
    return out;
}

} // namespace

Document refined_to(Document document, double tolerance)
{
    std::vector<Id> bent;
    for (const auto& [id, object] : document.objects)
        if (object->stroke || !lattices_round(document, id).empty()) bent.push_back(id);
    for (const Id id : bent) {
        Object changed = object(document, id);
        Refining refining = changed.refining.value_or(Refining{});
        refining.tolerance = tolerance;
        refining.budget = std::max(refining.budget, 20000000);
        if (refining.rule == RefinementRule::chua_neumann_midpoint)
            refining.rule = RefinementRule::edge_driven;
        changed.refining = refining;
        document.objects.set(id, make_ref(std::move(changed)));
    }
    return document;
}

Export export_of(const Evaluation& evaluated, const ExportedScene& scene)
{
    Export out;
    RigidScene written{PatternColors()(evaluated), {}};
    if (scene.instances) {
        written = with_rigid_tiles(written.evaluated, scene.document, *scene.instances);
        out.tiles = std::move(written.counts);
    }
    out.model = model_of(written.evaluated, scene.document);
    if (scene.instances) out.model = with_repeated_last(std::move(out.model));
    if (const auto camera = scene.document.kept_views.find("picture");
        camera != scene.document.kept_views.end()) {
        out.model.cameras = {document_at(scene.document, scene.frame).kept_views.at("picture")};
        out.model.nodes.push_back(
            {.name = "Render camera",
             .to_parent = glm::inverse(view_matrix(out.model.cameras.front())),
             .camera = 0});
    }
    const bool refining = std::ranges::any_of(evaluated.objects, [&](const auto& each) {
        return object(scene.document, each.first).refining.has_value();
    });
    if (!refining && !(scene.tolerance > 0)) return out;
    const Document shown =
        scene.tolerance > 0 ? refined_to(scene.document, scene.tolerance) : scene.document;
    Certificate certificate = certificate_of(scene.document, shown, written.evaluated, out.model);
    certificate.result = digest(evaluated);
    certificate.tolerance = scene.tolerance;
    certificate.instances = scene.instances;
    certificate.frame = scene.frame;
    certificate.lines = scene.lines;
    certificate.log = std::filesystem::path(scene.log).filename().string();
    out.model.extras = to_json(certificate);
    out.certificate = std::move(certificate);
    return out;
}

} // namespace trivar
