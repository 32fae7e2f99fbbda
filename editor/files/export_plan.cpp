// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/export_plan.h"

#include "core/base/rejected.h"
#include "core/document/named_files.h"
#include "core/export/animated_files.h"
#include "core/files/copies.h"
#include "core/files/file_bytes.h"
#include "editor/files/export_wish.h"
#include "editor/session/scene_names.h"
#include "editor/words/file_words.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;

// Whether the scene is made from this file, so that an export over it would destroy its source.
bool is_model_of(const fs::path& file, const Session& session)
{
    std::error_code ignored;
    return std::ranges::any_of(session.committed().objects, [&](const auto& each) {
        return std::ranges::any_of(files_named(*each.second), [&](const FileUse& named) {
            return fs::equivalent(session.assets()->resolve(named.path), file, ignored);
        });
    });
}

bool is_cache(const fs::path& file)
{
    const std::string ending = extension_of(file.string());
    return ending == ".pc2" || ending == ".mdd";
}

// Whether there is what would be written; of caches any with the beginning of their names.
bool is_there(const fs::path& file)
{
    std::error_code ignored;
    if (!is_cache(file)) return fs::exists(file, ignored);
    const std::string begin = file.stem().string() + ".";
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    for (fs::directory_iterator at(folder, ignored), end; at != end; at.increment(ignored))
        if (at->path().filename().string().starts_with(begin) &&
            at->path().extension() == file.extension())
            return true;
    return false;
}

} // namespace

ExportPlan usual_export(const Session& session, const std::string& models_folder)
{
    const std::string& scene = session.scene().path();
    const fs::path folder = scene.empty() ? fs::path(with_long_home(models_folder))
                                          : fs::absolute(scene).lexically_normal().parent_path();
    fs::path file = folder / (stem_of(session.scene()) + animated_extensions().front());
    if (is_model_of(file, session)) file = numbered_name(file.string());
    return {.file = with_short_home(file.string()),
            .first = session.document().time.first_frame,
            .last = session.document().time.last_frame};
}

int kind_of(const ExportPlan& plan)
{
    const auto& all = animated_extensions();
    const auto found = std::ranges::find(all, extension_of(plan.file));
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

void set_kind(ExportPlan& plan, int kind)
{
    const std::string& ending = animated_extensions()[static_cast<std::size_t>(kind)];
    if (kind_of(plan) >= 0)
        plan.file = fs::path(plan.file).replace_extension(ending).string();
    else
        plan.file += ending;
}

ExportWish wish_of(const ExportPlan& plan, const Session& session)
{
    const std::string path = with_long_home(plan.file);
    if (fs::path(path).stem().empty()) throw Rejected("choose a file for the frames");
    check_animated_name(path);
    if (is_model_of(path, session))
        throw Rejected(file_name(path) + " is a model of this scene; choose another name");
    if (plan.last < plan.first) throw Rejected("the last frame comes before the first");
    const SceneFile& scene = session.scene();
    const Document& document = session.committed();
    return {
        .scene = {.document = document,
                  .frames = frame_range(fmt::format("{}:{}", plan.first, plan.last), document.time),
                  .tolerance = plan.tolerance,
                  .log = scene.path().empty() ? scene.original() : scene.path(),
                  .instances = plan.instances && extension_of(path) == ".usda"},
        .assets = session.assets(),
        .path = path};
}

ExportOutlook outlook_of(const ExportPlan& plan, const ExportWish& wish)
{
    const fs::path file(wish.path);
    const int frames = plan.last - plan.first + 1;
    const std::string all = frames == 1 ? "one frame" : fmt::format("{} frames", frames);
    const std::string stem = file.stem().string(), ending = file.extension().string();
    ExportOutlook out;
    if (is_cache(file))
        out.words = fmt::format("{0}.OBJECT{1} per object, the positions of its points in {2}, and "
                                "{0}.OBJECT.obj, its mesh.",
                                stem, ending, all);
    else if (extension_of(wish.path) == ".usda")
        out.words = fmt::format("{}{}, {}: the positions of all points in each, and colours.{}",
                                stem, ending, all,
                                wish.scene.instances ? " Tiles within the tolerance are instances "
                                                       "of one unbent mesh."
                                                     : "");
    else
        out.words = fmt::format("{}{}, {} as one clip, with materials and pictures. Certified "
                                "within the tolerance at all times; exceptions are reported.",
                                stem, ending, all);
    out.replaces = is_there(file);
    if (out.replaces) out.words += " The file exists and will be replaced.";
    return out;
}

} // namespace trivar
