// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/animated_files.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/certificate/certificate.h"
#include "core/export/point_cache.h"
#include "core/export/usd_writer.h"
#include "core/files/file_bytes.h"
#include "core/files/write_model.h"
#include "core/steps/lacking.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

bool has_faces(const FilmStrip& strip)
{
    return strip.first().rest->face_count() > 0;
}

} // namespace

const std::vector<std::string>& animated_extensions()
{
    static const std::vector<std::string> extensions{".glb", ".usda", ".pc2", ".mdd"};
    return extensions;
}

void check_animated_name(const std::string& path)
{
    if (std::ranges::find(animated_extensions(), extension_of(path)) == animated_extensions().end())
        throw Rejected(path + ": animations are written as .glb, .usda, .pc2 and .mdd");
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
        throw Rejected(fmt::format("{}: there is no folder {}", path, folder.string()));
}

AnimatedFile write_animated(const AnimatedScene& scene, const Ref<AssetStore>& assets,
                            const std::string& path, const Progress& progress,
                            const SourceFiles& sources)
{
    check_animated_name(path);
    sources.check(path);
    AnimatedFile out;
    out.frames = scene.frames.last - scene.frames.first + 1;
    out.files = {path};
    if (extension_of(path) == ".glb") {
        AnimatedExport made = animated_export(scene, assets, progress);
        report(progress, 1, "writing");
        write_model(made.model, path, sources);
        out.lacks = lacks(made.film, scene.document);
        out.left_out = std::move(made.left_out);
        out.certificate = std::move(made.certificate);
        return out;
    }
    const double per_second = scene.document.time.frames_per_second;
    const Film film =
        film_of(scene.document, assets, moments_of(scene.frames, 1), part_of(progress, 0, 0.2));
    out.lacks = lacks(film, scene.document);
    if (scene.whole) check_whole(out.lacks);
    const bool usd = extension_of(path) == ".usda";
    const std::vector<CurveStrip> curves = curve_strips(film, scene.document);
    if (std::ranges::none_of(film.strips, has_faces) && !(usd && !curves.empty()))
        throw Rejected(path + ": there are no faces to write, so nothing is written");
    const Progress writing = part_of(progress, 0.2, 1);
    if (usd) {
        InstancedFilm shown{film.strips, {}, {}, {}};
        const double tolerance = scene.tolerance > 0 ? scene.tolerance : default_tolerance;
        if (scene.instances) shown = instanced(film, tolerance, part_of(progress, 0.2, 0.3));
        out.tiles = sentences(shown.counts, tolerance);
        write_usda(film, shown, curves, per_second, path, writing);
        return out;
    }
    out.files =
        write_caches(film, extension_of(path) == ".pc2" ? CacheFormat::pc2 : CacheFormat::mdd,
                     per_second, path, writing, sources);
    std::vector<std::string> names;
    for (const CurveStrip& strip : curves) names.push_back(strip.name);
    out.left_out =
        which_curves_are_left_out(names, extension_of(path) + " files are of meshes alone");
    return out;
}

std::vector<std::string> summary(const FilmCertificate& c)
{
    struct Kind {
        std::size_t parts = 0, triangles = 0, before = 0;
        int keys = 0;
        double bound = 0;
        bool proven = true; // for all times, not only for the moments
    };
    Kind bent, moving;
    for (const FilmCertificate::PartClaim& part : c.parts) {
        if (part.way == "still" && part.bound == 0) continue;
        Kind& kind = part.way == "targets" || part.way == "still" ? bent : moving;
        ++kind.parts;
        kind.triangles += part.triangles;
        kind.before += part.triangles_before;
        kind.keys = std::max(kind.keys, part.keys);
        kind.bound = std::max(kind.bound, part.bound);
        kind.proven = kind.proven && is_proven(part);
    }
    const auto within = [&](const Kind& kind) {
        return bound_text(kind.bound) + when_claimed(kind.proven, c.parts.front().moments);
    };
    const auto keys = [](const Kind& kind) {
        return kind.keys == 1 ? "one key" : fmt::format("{} keys", with_commas(kind.keys));
    };
    std::vector<std::string> out;
    if (bent.parts > 0)
        out.push_back(fmt::format(
            "{} part{} in volumes: {} triangles where there were {}, {} at most, within {}",
            bent.parts, bent.parts == 1 ? "" : "s", with_commas(bent.triangles),
            with_commas(bent.before), keys(bent), within(bent)));
    if (moving.parts > 0)
        out.push_back(fmt::format("{} part{} by nodes and skins: {} at most, within {}",
                                  moving.parts, moving.parts == 1 ? "" : "s", keys(moving),
                                  within(moving)));
    return out;
}

} // namespace trivar
