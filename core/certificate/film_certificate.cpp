// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/film_certificate.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/base/whole_numbers.h"
#include "core/certificate/certificate.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using FilmJson = nlohmann::ordered_json;
constexpr int film_certificate_version = 1;

FilmJson film_number(double value) // JSON has no infinity
{
    return std::isfinite(value) ? FilmJson(value) : FilmJson(nullptr);
}
double film_number(const FilmJson& value)
{
    return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

} // namespace

std::string part_title(const FilmCertificate::PartClaim& claim)
{
    return fmt::format("{} (part {})", printable(claim.name), claim.part + 1);
}

bool is_proven(const FilmCertificate::PartClaim& claim)
{
    return claim.unproven.empty() && (claim.way == "targets" || claim.way == "still");
}

std::string when_claimed(bool proven, int moments)
{
    if (proven) return "";
    return moments == 1 ? " at every frame" : fmt::format(" at {} moments to a frame", moments);
}

std::vector<std::string> not_certified(const FilmCertificate& certificate)
{
    std::vector<std::string> out;
    std::map<std::pair<Id, std::string>, int> unproven; // parts of an object, by why
    std::map<Id, std::string> names;
    for (const FilmCertificate::PartClaim& part : certificate.parts) {
        names.try_emplace(part.object, printable(part.name)); // of its first piece
        if (!part.unproven.empty()) ++unproven[{part.object, part.unproven}];
        if (!(part.bound <= certificate.tolerance))
            out.push_back(fmt::format("{} is not within {} m: its bound is {}", part_title(part),
                                      number_text(certificate.tolerance), bound_text(part.bound)));
    }
    for (const auto& [of, parts] : unproven)
        out.push_back(
            fmt::format("{} is compared{} and not certified between them: {}", names[of.first],
                        when_claimed(false, certificate.parts.front().moments), of.second));
    return out;
}

std::string to_json(const FilmCertificate& c)
{
    FilmJson parts = FilmJson::array();
    for (const FilmCertificate::PartClaim& p : c.parts) {
        parts.push_back({{"object", p.object},
                         {"part", p.part},
                         {"name", p.name},
                         {"node", p.node},
                         {"way", p.way},
                         {"keys", p.keys},
                         {"moments_per_frame", p.moments},
                         {"triangles_before", p.triangles_before},
                         {"triangles", p.triangles},
                         {"space_m", film_number(p.space)},
                         {"between_m", film_number(p.motion)},
                         {"bound_m", film_number(p.bound)}});
        if (!p.unproven.empty()) parts.back()["unproven"] = p.unproven;
    }
    const FilmJson all{{"version", film_certificate_version},
                       {"tolerance_m", c.tolerance},
                       {"bound_m", film_number(c.bound)},
                       {"frames", {c.first_frame, c.last_frame}},
                       {"frames_per_second", c.frames_per_second},
                       {"log", c.log},
                       {"scene", c.scene},
                       {"parts", std::move(parts)}};
    return FilmJson{{"trivar_animation", all}}.dump(-1, ' ', false,
                                                    FilmJson::error_handler_t::replace);
}

bool has_film_certificate(const std::string& extras)
{
    const FilmJson all = FilmJson::parse(extras, nullptr, false);
    return all.is_object() && all.contains("trivar_animation");
}

FilmCertificate film_certificate_from_json(const std::string& text)
{
    try {
        const FilmJson all = FilmJson::parse(text).at("trivar_animation");
        if (all.at("version") != film_certificate_version)
            throw Rejected("its certificate was written by another version of Trivar");
        FilmCertificate out;
        out.tolerance = all.at("tolerance_m").get<double>();
        out.bound = film_number(all.at("bound_m"));
        out.first_frame = whole_number<int>(all.at("frames").at(0));
        out.last_frame = whole_number<int>(all.at("frames").at(1));
        out.frames_per_second = all.at("frames_per_second").get<double>();
        out.log = all.at("log").get<std::string>();
        out.scene = all.at("scene").get<std::string>();
        if (!(out.tolerance > 0) || !(out.frames_per_second > 0))
            throw Rejected("its certificate has a number that is not above 0");
        if (!(out.tolerance <= most_tolerance))
            throw Rejected(fmt::format("the tolerance of its certificate is {} m, which proves "
                                       "nothing; at most {} m is allowed",
                                       number_text(out.tolerance), number_text(most_tolerance)));
        for (const FilmJson& p : all.at("parts"))
            out.parts.push_back(
                {.object = whole_number<Id>(p.at("object")),
                 .part = whole_number<int>(p.at("part")),
                 .name = p.at("name").get<std::string>(),
                 .node = whole_number<int>(p.at("node")),
                 .way = p.at("way").get<std::string>(),
                 .keys = whole_number<int>(p.at("keys")),
                 .moments = whole_number<int>(p.at("moments_per_frame")),
                 .triangles_before = whole_number<std::size_t>(p.at("triangles_before")),
                 .triangles = whole_number<std::size_t>(p.at("triangles")),
                 .space = film_number(p.at("space_m")),
                 .motion = film_number(p.at("between_m")),
                 .bound = film_number(p.at("bound_m")),
                 .unproven = p.value("unproven", std::string())});
        return out;
    } catch (const FilmJson::exception&) {
        throw Rejected("its certificate cannot be read");
    }
}

} // namespace trivar
