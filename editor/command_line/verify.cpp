// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/verify.h"

#include "core/base/rounded.h"
#include "core/base/text.h"
#include "core/document/certificate.h"
#include "core/document/log.h"
#include "core/files/glb_content.h"
#include "editor/command_line/scene_log.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <set>

namespace trivar {
namespace {

// One file against its scene; what is wrong is said as it is found.
class Verification {
public:
    Verification(const VerifyOptions& options, const Streams& streams)
        : options_(options),
          streams_(streams),
          content_(glb_content(options.file))
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
        double furthest = 0;
        std::set<std::pair<Id, int>> claimed;
        for (const Certificate::PartClaim& claim : claims_.parts) {
            check(claim);
            furthest = std::max(furthest, claim.bound);
            if (!claimed.emplace(claim.object, claim.part).second)
                wrong(title(claim) + " is claimed twice");
        }
        if (claims_.bound != furthest)
            wrong(fmt::format("it claims {:.3g} m where the furthest of its parts claims {:.3g} m",
                              claims_.bound, furthest));
        std::size_t bent = 0;
        for (const auto& [id, object] : evaluated_.objects)
            bent += static_cast<std::size_t>(std::ranges::count_if(
                object->parts, [](const Part& part) { return part.bent != nullptr; }));
        if (bent != claims_.parts.size())
            wrong(fmt::format("{} parts lie in volumes and {} are claimed", bent,
                              claims_.parts.size()));
        return holds_;
    }

private:
    static std::string title(const Certificate::PartClaim& claim)
    {
        return fmt::format("{} (part {})", printable(claim.name), claim.part + 1);
    }

    void wrong(const std::string& sentence)
    {
        streams_.talk << fmt::format("trivar: {}: {}\n", options_.file, sentence);
        holds_ = false;
    }

    std::string log_file() const
    {
        if (!options_.log.empty()) return options_.log;
        const std::filesystem::path beside = std::filesystem::path(options_.file).parent_path() /
                                             std::filesystem::path(claims_.log).filename();
        if (!std::filesystem::is_regular_file(beside))
            throw Rejected(fmt::format("{}: its scene {} is not beside it; say where with --log",
                                       options_.file, printable(claims_.log)));
        return beside.string();
    }

    void evaluate()
    {
        const std::string name = log_file();
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
        shown_ = claims_.tolerance > 0 ? refined_to(document, claims_.tolerance) : document;
        evaluated_ = evaluator(shown_, claims_.frame);
        if (digest(evaluated_) != claims_.result)
            wrong("the scene gives another result here than the one that was exported; a file "
                  "that it uses may have changed");
    }

    void check(const Certificate::PartClaim& claim)
    {
        const std::string name = title(claim);
        const auto object = evaluated_.objects.find(claim.object);
        const auto part = static_cast<std::size_t>(claim.part);
        if (object == evaluated_.objects.end() || claim.part < 0 ||
            part >= object->second->parts.size() || !object->second->parts[part].bent)
            return wrong(name + " lies in no volume of the scene");
        const auto node_index = static_cast<std::size_t>(claim.node);
        if (claim.node < 0 || node_index >= content_.nodes.size())
            return wrong(name + " is not in the file");
        const GlbContent::Node& node = content_.nodes[node_index];
        const glm::dmat4 z_to_y({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1});
        if (node.to_file != z_to_y) return wrong(name + " was moved in the file");
        const Part& truth = object->second->parts[part];
        constexpr std::size_t many = 100000;
        const SampledPart found =
            sampled(truth, node.positions, node.corners, node.corners.size() / 3 < many ? 4 : 2);
        if (found.other_triangles)
            return wrong(fmt::format("{} has {} triangles, the scene gives {}", name,
                                     node.corners.size() / 3, truth.before_volume()->face_count()));
        const std::string figures = fmt::format(
            "{}: {} triangles, {} samples, the furthest off by {:.3g} m, claimed {:.3g} m", name,
            claim.triangles, found.samples, found.furthest, rounded_up(claim.bound, 3));
        streams_.out << figures << "\n";
        if (!(found.furthest <= claim.bound)) wrong(name + " is further off than it claims");
        if (!object->second->refined) return wrong(name + " is not certified: it is not refined");
        const RefinedPart& refined = object->second->refined->parts.at(part);
        if (claim.triangles != refined.triangles ||
            claim.triangles_before != refined.triangles_before ||
            claim.degenerate != refined.degenerate ||
            claim.not_certified != refined.not_certified.size())
            wrong(name + " claims other numbers of triangles than the scene gives");
        const double asked = trivar::object(shown_, claim.object).refining->tolerance;
        if (!(claim.tolerance <= asked))
            wrong(fmt::format("{} claims to be within {:.3g} m where {:.3g} m were asked for", name,
                              claim.tolerance, asked));
        const double proven = refined.bound;
        if (!(claim.bound >= proven))
            wrong(fmt::format("{} claims {:.3g} m where {:.3g} m are proven", name, claim.bound,
                              proven));
        if (!(claim.bound <= claim.tolerance) || claim.not_certified > 0)
            wrong(fmt::format("{} of the triangles of {} are not certified to be within {:.3g} m",
                              claim.not_certified, name, claim.tolerance));
    }

    const VerifyOptions& options_;
    const Streams& streams_;
    GlbContent content_;
    Certificate claims_;
    Document shown_; // as it was refined for the export
    Evaluated evaluated_;
    bool holds_ = true;
};

} // namespace

Status run_verify(const VerifyOptions& options, const Streams& streams)
{
    if (!Verification(options, streams).holds()) return Status::check_failed;
    streams.talk << "trivar: " << options.file << ": what it claims holds\n";
    return Status::done;
}

} // namespace trivar
