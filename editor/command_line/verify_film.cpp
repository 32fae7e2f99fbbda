// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/verify_film.h"

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/certificate/certificate.h"
#include "core/certificate/film_check.h"
#include "core/document/document_digest.h"
#include "core/export/animated_model.h"
#include "core/files/formats.h"
#include "core/files/gltf/glb_differences.h"
#include "core/scene/log.h"
#include "editor/command_line/scene_log.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

class FilmVerification {
public:
    FilmVerification(const VerifyOptions& options, const FilmCertificate& claims,
                     const Streams& streams)
        : options_(options),
          claims_(claims),
          streams_(streams)
    {
    }

    bool holds(const std::string& bytes)
    {
        const std::string name = log_of_export(options_, claims_.log);
        const Log log = read_log(read_text_file(name), name);
        History history;
        for (const LogLine& line : log.lines) apply(history, line, log.name);
        const Document& document = history.document();
        if (digest(document) != claims_.scene)
            wrong(
                fmt::format("{} is not the scene that it was exported from, or was changed", name));
        const Time& time = document.time;
        if (claims_.first_frame < time.first_frame || claims_.last_frame > time.last_frame ||
            claims_.last_frame < claims_.first_frame)
            throw Rejected(fmt::format("{}: the scene has no frames {} to {}", options_.file,
                                       claims_.first_frame, claims_.last_frame));
        const auto assets = std::make_shared<const AssetStore>(
            std::filesystem::absolute(name).lexically_normal().parent_path().string(),
            relinked_files(options_.relinked));
        const AnimatedExport again = exported_again(document, assets);
        for (const std::string& sentence : glb_differences(bytes, write_glb(again.model)))
            wrong(sentence);
        if (!compare_claims(again.certificate)) return false;
        constexpr int times_the_rate = 10;
        tell(sampled_film(again, document, assets, times_the_rate, shown_progress(streams_)));
        for (const std::string& sentence : not_certified(claims_)) wrong(sentence);
        return holds_;
    }

private:
    void wrong(const std::string& sentence)
    {
        clear_progress(streams_);
        streams_.talk << fmt::format("trivar: {}: {}\n", options_.file, sentence);
        holds_ = false;
    }

    AnimatedExport exported_again(const Document& document, const Ref<AssetStore>& assets) const
    {
        try {
            return animated_export({document,
                                    {claims_.first_frame, claims_.last_frame},
                                    claims_.tolerance,
                                    claims_.log},
                                   assets, shown_progress(streams_));
        } catch (const Rejected& error) {
            throw Rejected(fmt::format("{}: the result that it claims cannot be exported: {}",
                                       options_.file, error.what()));
        }
    }

    // Whether it speaks of as many parts as there are.
    bool compare_claims(const FilmCertificate& given)
    {
        if (claims_.frames_per_second != given.frames_per_second)
            wrong("it claims another frame rate than the scene's");
        if (claims_.parts.size() != given.parts.size()) {
            wrong(fmt::format("parts: the scene gives {} and it claims {}", given.parts.size(),
                              claims_.parts.size()));
            return false;
        }
        constexpr double last_bits = 1 - 1e-9;
        for (std::size_t p = 0; p < given.parts.size(); ++p) {
            const FilmCertificate::PartClaim &claim = claims_.parts[p], &part = given.parts[p];
            if (claim.object != part.object || claim.part != part.part || claim.name != part.name ||
                claim.node != part.node || claim.way != part.way || claim.keys != part.keys ||
                claim.moments != part.moments || claim.triangles != part.triangles ||
                claim.triangles_before != part.triangles_before || claim.unproven != part.unproven)
                wrong(part_title(claim) + " is not what the scene gives: " + part_title(part));
            if (!(claim.bound >= last_bits * part.bound))
                wrong(fmt::format("{} claims {} where {} is found", part_title(claim),
                                  bound_text(claim.bound), bound_text(part.bound)));
        }
        double furthest = 0;
        for (const FilmCertificate::PartClaim& claim : claims_.parts)
            furthest = std::max(furthest, claim.bound);
        if (claims_.bound != furthest)
            wrong(fmt::format("it claims {} where the furthest of its parts claims {}",
                              bound_text(claims_.bound), bound_text(furthest)));
        return true;
    }

    // Returns the distance that a sample may be off beyond the claim for a part at every time: the
    // rounding of the file to single precision, and of places that are far out.
    static double single_precision(const FilmSample& sample)
    {
        return std::max(glb_number_tolerance, 0x1p-21 * sample.reach);
    }

    void check(const FilmCertificate::PartClaim& claim, const FilmSample& sample)
    {
        constexpr double last_bits = 1 + 2e-9;
        const bool proven = is_proven(claim);
        const auto off = [&](double found, double allowed, const std::string& where) {
            wrong(fmt::format("{} is {} m off {}, further than {}", part_title(claim),
                              number_text(found), where, bound_text(allowed)));
        };
        if (!proven && !(sample.furthest_at_moments <= last_bits * claim.bound))
            off(sample.furthest_at_moments, claim.bound, "at a moment");
        const double allowed = proven ? claim.bound : claims_.tolerance;
        if (!(sample.furthest <= allowed + single_precision(sample)))
            off(sample.furthest, allowed, "at frame " + shortest(sample.at_frame));
    }

    // Prints one line for each object: the measured distance, and the claim. A proven part must
    // keep to its own claim; the others to it at the moments, and to the tolerance.
    void tell(const std::vector<FilmSample>& samples)
    {
        clear_progress(streams_);
        for (std::size_t p = 0; p < samples.size();) {
            const Id object = claims_.parts[p].object;
            const std::string name = printable(claims_.parts[p].name);
            std::size_t count = 0, parts = 0;
            bool all_proven = true;
            FilmSample all;
            double bound = 0, more = 0; // more: than claimed
            for (; p < samples.size() && claims_.parts[p].object == object; ++p, ++parts) {
                const FilmCertificate::PartClaim& claim = claims_.parts[p];
                const FilmSample& sample = samples[p];
                check(claim, sample);
                const bool proven = is_proven(claim);
                all_proven = all_proven && proven;
                count += sample.samples;
                bound = std::max(bound, claim.bound);
                if (proven && sample.furthest > claim.bound)
                    more = std::max(more, single_precision(sample));
                all.furthest_at_moments = std::max(
                    all.furthest_at_moments, proven ? sample.furthest : sample.furthest_at_moments);
                if (sample.furthest > all.furthest || parts == 0) {
                    all.furthest = sample.furthest;
                    all.at_frame = sample.at_frame;
                }
            }
            std::string claimed =
                bound_text(bound) + when_claimed(all_proven, claims_.parts.front().moments);
            if (!all_proven && claims_.first_frame < claims_.last_frame)
                claimed += fmt::format(", where it is {} m off at most, and {} in between",
                                       number_text(all.furthest_at_moments),
                                       bound_text(claims_.tolerance));
            if (more > 0)
                claimed +=
                    fmt::format(", and at most {} m more for single precision", number_text(more));
            streams_.out << fmt::format(
                "{}: {} {}, {} samples at ten times the frame rate, the furthest off by {} "
                "m at frame {}, claimed: {}\n",
                name, parts, parts == 1 ? "part" : "parts", with_commas(count),
                number_text(all.furthest), shortest(all.at_frame), claimed);
        }
    }

    const VerifyOptions& options_;
    const FilmCertificate& claims_;
    const Streams& streams_;
    bool holds_ = true;
};

} // namespace

std::string log_of_export(const VerifyOptions& options, const std::string& named)
{
    if (!options.log.empty()) return options.log;
    if (named.empty()) throw Rejected(options.file + ": it names no scene; name it with --log");
    const std::filesystem::path beside =
        std::filesystem::path(options.file).parent_path() / std::filesystem::path(named).filename();
    if (!std::filesystem::is_regular_file(beside))
        throw Rejected(
            fmt::format("{}: its scene {} is not in the same folder; give its path with --log",
                        options.file, printable(named)));
    return beside.string();
}

Status verify_film(const VerifyOptions& options, const std::string& bytes,
                   const std::string& extras, const Streams& streams)
{
    FilmCertificate claims;
    try {
        claims = film_certificate_from_json(extras);
    } catch (const Rejected& error) {
        throw Rejected(options.file + ": " + error.what());
    }
    if (!FilmVerification(options, claims, streams).holds(bytes)) return Status::check_failed;
    streams.talk << "trivar: " << options.file << ": what it claims holds\n";
    return Status::done;
}

} // namespace trivar
