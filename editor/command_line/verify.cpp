// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/verify.h"

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/certificate/film_certificate.h"
#include "core/document/document_digest.h"
#include "core/export/still_export.h"
#include "core/files/formats.h"
#include "core/files/gltf/glb_content.h"
#include "core/files/gltf/glb_differences.h"
#include "core/files/gltf/second_reader.h"
#include "core/scene/log.h"
#include "editor/command_line/scene_log.h"
#include "editor/command_line/verify_film.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <set>

namespace trivar {
namespace {

// A Verification compares one file with its scene and reports faults as they are found.
class Verification {
public:
    Verification(const VerifyOptions& options, const Streams& streams)
        : options_(options),
          streams_(streams),
          bytes_(read_text_file(options.file)),
          content_(glb_content_of(bytes_, options.file))
    {
        try {
            claims_ = certificate_from_json(content_.extras);
        } catch (const Rejected& error) {
            throw Rejected(options.file + ": " + error.what());
        }
    }
    bool holds()
    {
        evaluate();
        compare_file();
        double furthest = 0;
        std::set<std::pair<Id, int>> claimed;
        for (const Certificate::PartClaim& claim : claims_.parts) {
            check(claim);
            furthest = std::max(furthest, claim.bound);
            if (!claimed.emplace(claim.object, claim.part).second)
                wrong(part_title(claim) + " is claimed twice");
        }
        if (claims_.bound != furthest)
            wrong(fmt::format("it claims {} where the furthest of its parts claims {}",
                              bound_text(claims_.bound), bound_text(furthest)));
        if (given_.parts.size() != claims_.parts.size())
            wrong(fmt::format("parts in volumes: the scene gives {} and it claims {}",
                              given_.parts.size(), claims_.parts.size()));
        for (const Certificate::UnlaidObject& object : given_.not_laid)
            if (std::ranges::find(claims_.not_laid, object.object,
                                  &Certificate::UnlaidObject::object) == claims_.not_laid.end())
                wrong(printable(object.name) +
                      " does not lie where it should, which it leaves out");
        for (const std::string& sentence : not_certified(claims_)) wrong(sentence);
        if (holds_) ask_another_reader();
        return holds_;
    }
    bool claims_nothing() const { return claims_.parts.empty(); }

private:
    void wrong(const std::string& sentence)
    {
        streams_.talk << fmt::format("trivar: {}: {}\n", options_.file, sentence);
        holds_ = false;
    }

    void evaluate()
    {
        const std::string name = log_of_export(options_, claims_.log);
        const Log log = read_log(read_text_file(name), name);
        History history;
        for (const LogLine& line : log.lines) {
            if (claims_.lines > 0 && line.number > claims_.lines) break;
            apply(history, line, log.name);
        }
        const Document& document = history.document();
        if (digest(document) != claims_.scene)
            wrong(
                fmt::format("{} is not the scene that it was exported from, or was changed", name));
        const Time& time = document.time;
        if (!(claims_.frame >= time.first_frame && claims_.frame <= time.last_frame))
            throw Rejected(fmt::format("{}: the scene has no frame {}", options_.file,
                                       shortest(claims_.frame)));
        const std::string folder =
            std::filesystem::absolute(name).lexically_normal().parent_path().string();
        Evaluator evaluator(
            std::make_shared<const AssetStore>(folder, relinked_files(options_.relinked)));
        evaluated_ =
            evaluator(claims_.tolerance > 0 ? refined_to(document, claims_.tolerance) : document,
                      claims_.frame);
        Export again = export_of(
            evaluated_, {document, claims_.tolerance, claims_.frame, {}, 0, claims_.instances});
        given_ = again.certificate.value_or(Certificate{}); // none where nothing is refined
        plain_ = write_glb(again.model, {.instances = claims_.instances.has_value()});
        if (given_.result != claims_.result)
            wrong("the scene gives another result here than the one that was exported; a file "
                  "that it uses may have changed");
    }

    // Other viewers may use more of the file than its triangles, so all of it must be what was
    // written. The comparison must not rest on a mistake of reading that the writer shares.
    void ask_another_reader()
    {
        try {
            if (nodes_by_tinygltf(bytes_) != content_.nodes)
                wrong("another reader, tinygltf, finds other positions or triangles in it");
        } catch (const Rejected& error) {
            wrong(error.what());
        }
    }

    void compare_file()
    {
        for (const std::string& sentence : differences()) wrong(sentence);
    }
    std::vector<std::string> differences() const
    {
        try {
            return glb_differences(bytes_, plain_);
        } catch (const Rejected& error) {
            throw Rejected(options_.file + ": " + error.what());
        }
    }

    void check(const Certificate::PartClaim& claim)
    {
        const std::string name = part_title(claim);
        const auto known =
            std::ranges::find_if(given_.parts, [&](const Certificate::PartClaim& part) {
                return part.object == claim.object && part.part == claim.part;
            });
        if (known == given_.parts.end()) return wrong(name + " lies in no volume of the scene");
        check_claim(claim, *known);
        const auto node_index = static_cast<std::size_t>(claim.node);
        if (claim.node != known->node || node_index >= content_.nodes.size())
            return wrong(name + " is not the part of the file that it claims to be");
        const GlbContent::Node& node = content_.nodes[node_index];
        const glm::dmat4 z_to_y({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1});
        if (node.to_file != z_to_y) return wrong(name + " was moved in the file");
        const Part& truth =
            evaluated_.objects.at(claim.object)->parts.at(static_cast<std::size_t>(claim.part));
        constexpr std::size_t many = 100000;
        const SampledPart found =
            sampled(truth, node.positions, node.corners, node.corners.size() / 3 < many ? 4 : 2);
        if (found.other_triangles)
            return wrong(fmt::format("{} has {} triangles, the scene gives {}", name,
                                     with_commas(node.corners.size() / 3),
                                     with_commas(found.triangles)));
        streams_.out << fmt::format(
            "{}: {} triangle{}, {} samples, the furthest off by {} m, claimed: {}\n", name,
            with_commas(claim.triangles), claim.triangles == 1 ? "" : "s",
            with_commas(found.samples), number_text(found.furthest), bound_text(claim.bound));
        if (!(found.furthest <= claim.bound)) wrong(name + " is further off than it claims");
    }

    // Compares the claim for a part with the one that the scene gives.
    void check_claim(const Certificate::PartClaim& claim, const Certificate::PartClaim& given)
    {
        const std::string name = part_title(claim);
        if (claim.name != given.name)
            wrong(fmt::format("{} is called {} in the scene", name, printable(given.name)));
        if (claim.method != given.method || claim.rule != given.rule)
            wrong(fmt::format("{} claims {} and {} where the scene has {} and {}", name,
                              printable(claim.method), printable(claim.rule), given.method,
                              given.rule));
        if (claim.triangles != given.triangles ||
            claim.triangles_before != given.triangles_before ||
            claim.degenerate != given.degenerate || claim.not_certified != given.not_certified)
            wrong(name + " claims other numbers of triangles than the scene gives");
        if (claim.tolerance != given.tolerance)
            wrong(fmt::format("{} claims to be within {} m where {} m were asked for", name,
                              number_text(claim.tolerance), number_text(given.tolerance)));
        if (!(claim.bound >= given.bound))
            wrong(fmt::format("{} claims {} where {} is proven", name, bound_text(claim.bound),
                              bound_text(given.bound)));
    }

    const VerifyOptions& options_;
    const Streams& streams_;
    std::string bytes_, plain_; // the file, and the one that the scene gives
    GlbContent content_;
    Certificate claims_, given_; // what the file says, and what its scene does
    Evaluation evaluated_;
    bool holds_ = true;
};

} // namespace

Status run_verify(const VerifyOptions& options, const Streams& streams)
{
    const std::string bytes = read_text_file(options.file);
    if (const std::string extras = glb_extras(bytes, options.file); has_film_certificate(extras))
        return verify_film(options, bytes, extras, streams);
    Verification verification(options, streams);
    if (!verification.holds()) return Status::check_failed;
    streams.talk << "trivar: " << options.file
                 << (verification.claims_nothing()
                         ? ": nothing lies in a volume, it claims nothing\n"
                         : ": what it claims holds\n");
    return Status::done;
}

} // namespace trivar
