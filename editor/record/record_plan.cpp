// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/record/record_plan.h"

#include "core/base/digest.h"
#include "core/base/rejected.h"
#include "editor/record/recording_wish.h"
#include "editor/record/sequence.h"
#include "editor/record/video.h"
#include "editor/session/scene_names.h"
#include "editor/words/file_words.h"

#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;

std::string stem_of(const Session& session)
{
    return fs::path(session.scene().path()).stem().string();
}

// Returns the words for a view; a picture that is continued from another one shows none.
std::string view_words(const Camera& camera)
{
    Digest digest;
    for (const glm::dvec3& each : {camera.eye, camera.target, camera.up})
        for (int i = 0; i < 3; ++i) digest.add(each[i]);
    for (const double each : {camera.fov_y, camera.height_world, camera.perspective ? 1.0 : 0.0})
        digest.add(each);
    return " view=" + digest.hex();
}

} // namespace

RecordPlan usual_plan(const Session& session)
{
    RecordPlan plan;
    const fs::path scene = fs::absolute(session.scene().path()).lexically_normal();
    plan.folder = with_short_home((scene.parent_path() / (stem_of(session) + "_frames")).string());
    plan.first = session.document().time.first_frame;
    plan.last = session.document().time.last_frame;
    return plan;
}

FrameNames names_of(const RecordPlan& plan, const Session& session)
{
    const fs::path folder = with_long_home(plan.folder);
    return {(folder / (stem_of(session) + ".")).string(),
            plan.format == RecordPlan::exr ? ".exr" : ".png"};
}

std::string video_of(const RecordPlan& plan, const Session& session)
{
    const fs::path folder = with_long_home(plan.folder);
    return (folder / (stem_of(session) + ".mp4")).string();
}

RecordingWish wish_of(const RecordPlan& plan, const Session& session)
{
    RecordingWish wish;
    if (plan.folder.empty()) throw Rejected("choose a folder for the frames");
    if (plan.width_px < 1 || plan.height_px < 1 || plan.width_px > 16384 || plan.height_px > 16384)
        throw Rejected("pictures are 1 to 16384 pixels wide and high");
    if (plan.last < plan.first) throw Rejected("the last frame comes before the first");
    wish.frames = frames_of(fmt::format("{}:{}:{}", plan.first, plan.last, plan.step));
    wish.document = session.scene().document();
    check_frames(wish.frames, wish.document.time);
    wish.assets = session.assets();
    wish.level = plan.level;
    Sequence& sequence = wish.sequence;
    sequence.names = names_of(plan, session);
    sequence.size_px = {plan.width_px, plan.height_px};
    sequence.depth = plan.format == RecordPlan::png_16 ? 16 : 8;
    std::string text;
    for (const std::string& line : session.scene().lines()) text += line + "\n";
    sequence.log = digest_of_log(text);
    sequence.settings =
        "quality=" + std::string(gpu::level_names[static_cast<std::size_t>(plan.level)]);
    if (!wish.document.kept_views.contains("picture")) {
        wish.camera = session.view.camera;
        sequence.settings += view_words(session.view.camera);
    }
    if (!plan.video) return wish;
    wish.video = video_of(plan, session);
    check_video(wish.video);
    return wish;
}

} // namespace trivar
