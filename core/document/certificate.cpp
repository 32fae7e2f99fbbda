// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/certificate.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/document/commands/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

namespace trivar {
namespace {

using CertificateJson = nlohmann::ordered_json;
constexpr int certificate_version = 1;
constexpr double infinite = std::numeric_limits<double>::infinity();

template <class E> std::string chosen_name(E value)
{
    return std::string(choice_names<E>.at(static_cast<std::size_t>(value)));
}

// JSON knows no infinity.
CertificateJson finite_or_null(double value)
{
    return std::isfinite(value) ? CertificateJson(value) : CertificateJson(nullptr);
}
double or_infinite(const CertificateJson& value)
{
    return value.is_null() ? infinite : value.get<double>();
}

// The triangles in the order in which a GLB has them.
std::vector<std::size_t> by_material(const Mesh& mesh)
{
    std::vector<std::size_t> order(mesh.face_count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!mesh.face_material.empty())
        std::ranges::stable_sort(order, {}, [&](std::size_t f) { return mesh.face_material[f]; });
    return order;
}

} // namespace

Document refined_to(Document document, double tolerance)
{
    std::vector<Id> placed;
    for (const auto& [id, object] : document.objects)
        if (object->placement) placed.push_back(id);
    for (const Id id : placed) {
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

Certificate certificate_of(const Document& document, const Document& shown,
                           const Evaluated& evaluated, const Model& model, double frame)
{
    Certificate out;
    out.frame = frame;
    out.scene = digest(document);
    out.result = digest(evaluated);
    int mesh = 0; // model_of() makes one a part, in this order
    for (const auto& [id, ref] : evaluated.objects)
        for (std::size_t p = 0; p < ref->parts.size(); ++p, ++mesh) {
            if (!ref->parts[p].bent) continue;
            const auto node = std::ranges::find(model.nodes, mesh, &Node::mesh);
            Certificate::PartClaim claim;
            claim.object = id;
            claim.part = static_cast<int>(p);
            claim.name = object(shown, id).name;
            claim.node = static_cast<int>(node - model.nodes.begin());
            claim.triangles = claim.triangles_before = triangles(*ref->parts[p].rest).size();
            claim.bound = infinite;
            claim.not_certified = claim.triangles;
            const Refining refining = object(shown, id).refining.value_or(Refining{});
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
    return out;
}

std::string to_json(const Certificate& c)
{
    CertificateJson parts = CertificateJson::array();
    for (const Certificate::PartClaim& p : c.parts)
        parts.push_back({{"object", p.object},
                         {"part", p.part},
                         {"name", p.name},
                         {"node", p.node},
                         {"triangles_before", p.triangles_before},
                         {"triangles", p.triangles},
                         {"degenerate", p.degenerate},
                         {"not_certified", p.not_certified},
                         {"tolerance_m", p.tolerance},
                         {"bound_m", finite_or_null(p.bound)},
                         {"method", p.method},
                         {"rule", p.rule}});
    const CertificateJson all{{"version", certificate_version},
                              {"tolerance_m", c.tolerance},
                              {"bound_m", finite_or_null(c.bound)},
                              {"frame", c.frame},
                              {"log", c.log},
                              {"lines", c.lines},
                              {"scene", c.scene},
                              {"result", c.result},
                              {"parts", std::move(parts)}};
    return CertificateJson{{"trivar_certificate", all}}.dump(
        -1, ' ', false, CertificateJson::error_handler_t::replace);
}

Certificate certificate_from_json(const std::string& text)
{
    try {
        const CertificateJson all = CertificateJson::parse(text).at("trivar_certificate");
        if (all.at("version") != certificate_version)
            throw Rejected("its certificate is of another version of Trivar");
        Certificate out;
        out.tolerance = all.at("tolerance_m").get<double>();
        out.bound = or_infinite(all.at("bound_m"));
        out.frame = all.at("frame").get<double>();
        out.log = all.at("log").get<std::string>();
        out.lines = all.value("lines", 0); // not in the first ones
        out.scene = all.at("scene").get<std::string>();
        out.result = all.at("result").get<std::string>();
        for (const CertificateJson& p : all.at("parts"))
            out.parts.push_back({.object = p.at("object").get<Id>(),
                                 .part = p.at("part").get<int>(),
                                 .name = p.at("name").get<std::string>(),
                                 .node = p.at("node").get<int>(),
                                 .triangles_before = p.at("triangles_before").get<std::size_t>(),
                                 .triangles = p.at("triangles").get<std::size_t>(),
                                 .degenerate = p.at("degenerate").get<std::size_t>(),
                                 .not_certified = p.at("not_certified").get<std::size_t>(),
                                 .tolerance = p.at("tolerance_m").get<double>(),
                                 .bound = or_infinite(p.at("bound_m")),
                                 .method = p.at("method").get<std::string>(),
                                 .rule = p.at("rule").get<std::string>()});
        return out;
    } catch (const CertificateJson::exception&) {
        throw Rejected("it has no certificate; trivar replay LOG --epsilon E --export FILE writes "
                       "one");
    }
}

SampledPart sampled(const Part& part, const std::vector<glm::vec3>& positions,
                    const std::vector<std::uint32_t>& corners, int steps)
{
    const Mesh& flat = *part.before_volume();
    SampledPart out;
    out.other_triangles =
        corners.size() != 3 * flat.face_count() || flat.corners.size() != corners.size();
    if (out.other_triangles) return out;
    const std::vector<std::size_t> order = by_material(flat);
    constexpr std::size_t block = 256;
    std::vector<double> furthest((order.size() + block - 1) / block, 0);
    parallel_blocks(order.size(), block, [&](std::size_t begin, std::size_t end) {
        double& most = furthest[begin / block];
        for (std::size_t t = begin; t < end; ++t)
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; i + j <= steps; ++j) {
                    const std::array<double, 3> weight{static_cast<double>(i) / steps,
                                                       static_cast<double>(j) / steps,
                                                       static_cast<double>(steps - i - j) / steps};
                    glm::dvec3 object(0), drawn(0);
                    for (std::size_t c = 0; c < 3; ++c) {
                        const std::uint32_t vertex = flat.corners[3 * order[t] + c];
                        object += weight[c] * glm::dvec3(flat.positions[vertex]);
                        drawn += weight[c] * glm::dvec3(positions[corners[3 * t + c]]);
                    }
                    const double off = glm::distance(
                        drawn,
                        deform(object, part.bent->embedding, *part.bent->volume).position_world);
                    if (!(off <= most)) most = std::isfinite(off) ? off : infinite;
                }
    });
    out.samples = order.size() * static_cast<std::size_t>((steps + 1) * (steps + 2) / 2);
    for (const double most : furthest)
        if (!(most <= out.furthest)) out.furthest = most;
    return out;
}

} // namespace trivar
