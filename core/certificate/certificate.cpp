// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/certificate.h"

#include "core/base/finite.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/base/rounded.h"
#include "core/base/text.h"
#include "core/base/whole_numbers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

namespace trivar {
namespace {

using CertificateJson = nlohmann::ordered_json;
constexpr int certificate_version = 1;

// Returns null for infinity and NaN, which JSON cannot write.
CertificateJson finite_or_null(double value)
{
    return std::isfinite(value) ? CertificateJson(value) : CertificateJson(nullptr);
}
double or_infinite(const CertificateJson& value)
{
    return value.is_null() ? infinite : value.get<double>();
}

// Lists the triangles in the order in which a GLB has them.
std::vector<glm::uvec3> by_material(const Mesh& mesh)
{
    std::vector<std::size_t> order(mesh.face_count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!mesh.face_material.empty())
        std::ranges::stable_sort(order, {}, [&](std::size_t f) { return mesh.face_material[f]; });
    const std::vector<glm::uvec3> all = triangles(mesh);
    std::vector<glm::uvec3> out;
    out.reserve(all.size());
    for (const std::size_t f : order) // a face of n corners has n - 2
        for (std::size_t t = mesh.face_begin[f] - 2 * f; t < mesh.face_begin[f + 1] - 2 * (f + 1);
             ++t)
            out.push_back(all[t]);
    return out;
}

} // namespace

std::vector<std::string> not_certified(const Certificate& certificate)
{
    std::vector<std::string> out;
    for (const Certificate::PartClaim& part : certificate.parts) {
        const std::string name = part_title(part);
        if (part.not_certified == 0 && part.bound <= part.tolerance) continue;
        if (part.method.empty())
            out.push_back(name + " is not certified: it is not refined");
        else if (part.not_certified == 0)
            out.push_back(fmt::format("{} is not certified: its bound of {} is above its tolerance "
                                      "of {} m",
                                      name, bound_text(part.bound), number_text(part.tolerance)));
        else
            out.push_back(fmt::format("{} is not certified: {} of its {} triangles may be further "
                                      "off than {} m",
                                      name, with_commas(part.not_certified),
                                      with_commas(part.triangles), number_text(part.tolerance)));
    }
    for (const Certificate::UnlaidObject& object : certificate.not_laid)
        out.push_back(fmt::format("{} is not certified: it does not lie where it should: {}",
                                  printable(object.name), printable(object.why)));
    return out;
}

std::string part_title(const Certificate::PartClaim& claim)
{
    return fmt::format("{} (part {})", printable(claim.name), claim.part + 1);
}

std::string bound_text(double bound)
{
    return std::isfinite(bound) ? number_text(rounded_up(bound, 3)) + " m" : "no bound";
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
    CertificateJson not_laid = CertificateJson::array();
    for (const Certificate::UnlaidObject& n : c.not_laid)
        not_laid.push_back({{"object", n.object}, {"name", n.name}, {"why", n.why}});
    CertificateJson all{{"version", certificate_version},
                        {"tolerance_m", c.tolerance},
                        {"bound_m", finite_or_null(c.bound)},
                        {"frame", c.frame},
                        {"log", c.log},
                        {"lines", c.lines},
                        {"scene", c.scene},
                        {"result", c.result},
                        {"parts", std::move(parts)},
                        {"not_laid", std::move(not_laid)}};
    if (c.instances) all["instances_m"] = *c.instances;
    return CertificateJson{{"trivar_certificate", all}}.dump(
        -1, ' ', false, CertificateJson::error_handler_t::replace);
}

Certificate certificate_from_json(const std::string& text)
{
    try {
        const CertificateJson all = CertificateJson::parse(text).at("trivar_certificate");
        if (all.at("version") != certificate_version)
            throw Rejected("its certificate was written by another version of Trivar");
        Certificate out;
        out.tolerance = all.at("tolerance_m").get<double>();
        out.bound = or_infinite(all.at("bound_m"));
        out.frame = all.at("frame").get<double>();
        out.log = all.at("log").get<std::string>();
        // Early certificates have no lines.
        out.lines = all.contains("lines") ? whole_number<int>(all.at("lines")) : 0;
        if (out.lines < 0 || !(out.tolerance >= 0))
            throw Rejected("its certificate has a number below 0 where only 0 or more is possible");
        if (all.contains("instances_m")) out.instances = all.at("instances_m").get<double>();
        if (out.instances && !(*out.instances > 0))
            throw Rejected("its certificate says that tiles are instances within a distance that "
                           "is not possible");
        out.scene = all.at("scene").get<std::string>();
        out.result = all.at("result").get<std::string>();
        for (const CertificateJson& p : all.at("parts"))
            out.parts.push_back(
                {.object = whole_number<Id>(p.at("object")),
                 .part = whole_number<int>(p.at("part")),
                 .name = p.at("name").get<std::string>(),
                 .node = whole_number<int>(p.at("node")),
                 .triangles_before = whole_number<std::size_t>(p.at("triangles_before")),
                 .triangles = whole_number<std::size_t>(p.at("triangles")),
                 .degenerate = whole_number<std::size_t>(p.at("degenerate")),
                 .not_certified = whole_number<std::size_t>(p.at("not_certified")),
                 .tolerance = p.at("tolerance_m").get<double>(),
                 .bound = or_infinite(p.at("bound_m")),
                 .method = p.at("method").get<std::string>(),
                 .rule = p.at("rule").get<std::string>()});
        for (const CertificateJson& n : all.value("not_laid", CertificateJson::array()))
            out.not_laid.push_back({.object = whole_number<Id>(n.at("object")),
                                    .name = n.at("name").get<std::string>(),
                                    .why = n.at("why").get<std::string>()});
        return out;
    } catch (const CertificateJson::exception&) {
        throw Rejected("it has no certificate; trivar replay LOG --epsilon E --export FILE writes "
                       "one");
    }
}

SampledPart sampled(const Part& part, const std::vector<glm::vec3>& positions,
                    const std::vector<std::uint32_t>& corners, int steps)
{
    const Mesh& flat = *innermost(part).before_volume();
    const std::vector<glm::uvec3> order = by_material(flat);
    SampledPart out;
    out.triangles = order.size();
    out.other_triangles = corners.size() != 3 * order.size();
    if (out.other_triangles) return out;
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
                        const std::uint32_t vertex = order[t][static_cast<glm::length_t>(c)];
                        object += weight[c] * glm::dvec3(flat.positions[vertex]);
                        drawn += weight[c] * glm::dvec3(positions[corners[3 * t + c]]);
                    }
                    const double off = glm::distance(drawn, place_in_world(part, object));
                    if (!(off <= most)) most = std::isfinite(off) ? off : infinite;
                }
    });
    out.samples = order.size() * static_cast<std::size_t>((steps + 1) * (steps + 2) / 2);
    for (const double most : furthest)
        if (!(most <= out.furthest)) out.furthest = most;
    return out;
}

} // namespace trivar
