// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/picture_to_file.h"

#include "core/base/rejected.h"
#include "core/files/copies.h"
#include "core/files/pictures/image.h"
#include "editor/picture/still.h"
#include "editor/session/scene_names.h"
#include "editor/session/session_facts.h"
#include "editor/words/file_words.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace trivar {
namespace fs = std::filesystem;
namespace {

// Returns the folder for pictures of a scene without a file: the person's pictures.
fs::path pictures_folder()
{
    const char* home = std::getenv("HOME");
    const fs::path at_home = home ? fs::path(home) : fs::temp_directory_path();
    std::error_code ignored;
    return fs::is_directory(at_home / "Pictures", ignored) ? at_home / "Pictures" : at_home;
}

std::string free_path(const Session& session)
{
    const std::string& scene = session.scene().path();
    const fs::path file = scene.empty() ? pictures_folder() / stem_of(session.scene())
                                        : fs::absolute(scene).replace_extension();
    return numbered_name(file.string() + ".png");
}

void tell_failed(Session& session, const std::string& path, const std::string& why)
{
    session.notices.say(ui::NoticeKind::error, file_name(path) + " was not written",
                        reason(why, path), "picture");
}

} // namespace

PictureToFile::PictureToFile() = default;
PictureToFile::~PictureToFile() = default;

void PictureToFile::begin(const Session& session, glm::ivec2 size_px)
{
    path_ = free_path(session);
    wanted_px_ = size_px_ = size_px;
}

void PictureToFile::forget_gpu()
{
    if (still_) wanted_px_ = size_px_;
    still_.reset();
}

void PictureToFile::stop()
{
    still_.reset();
    wanted_px_.reset();
    lines_of_ = nullptr;
    lines_ = nullptr;
}

void PictureToFile::draw(const Session& session, const Camera& camera,
                         const Ref<gpu::ShaderTexts>& shaders)
{
    path_ = free_path(session); // something may have been written meanwhile
    const glm::ivec2 size_px = *std::exchange(wanted_px_, std::nullopt);
    still_ = std::make_unique<Still>();
    if (lines_of_) still_->give_lines(*lines_of_, lines_);
    lines_of_ = nullptr;
    lines_ = nullptr;
    still_->begin(session.evaluated(), session.document(), camera,
                  {.size_px = size_px, .level = gpu::Level::high, .shaders = shaders});
}

bool PictureToFile::has_lines(Session& session, const Camera& camera)
{
    const Ref<LineScene> scene =
        make_ref(line_scene(session.evaluated(), session.document(), camera));
    const bool asked = lines_of_ && *lines_of_ == *scene;
    if (scene->is_simple() || (lines_ && asked)) return true;
    if (asked) { // the job was cancelled
        stop();
        return false;
    }
    lines_of_ = scene;
    lines_ = nullptr;
    session.jobs().start(
        {"Drawing lines",
         [this, scene](const Progress& progress) -> Jobs::Finish {
             return [this, lines = make_ref(LineDrawer()(*scene, {.progress = progress}))] {
                 lines_ = lines;
             };
         },
         [this, &session](const std::string& why) {
             stop();
             tell_failed(session, path_, why);
         }});
    return false;
}

bool PictureToFile::is_whole(Session& session, ui::Frame& frame,
                             const Ref<gpu::ShaderTexts>& shaders)
{
    constexpr double budget_ms = 40; // as for the window's own picture
    if (wanted_px_) {
        frame.again_in(0.05);
        if (!session.up_to_date() || session.jobs().status()) return false;
        const Camera camera = ui::reshaped(camera_for_pictures(session), glm::dvec2(*wanted_px_));
        if (has_lines(session, camera)) draw(session, camera, shaders);
    }
    if (!still_) return false;
    frame.again_in(0);
    return still_->advance(budget_ms);
}

void PictureToFile::advance(Session& session, ui::Frame& frame,
                            const Ref<gpu::ShaderTexts>& shaders)
{
    Ref<Image> image;
    try {
        if (!is_whole(session, frame, shaders)) return;
        image = make_ref(still_->image());
    } catch (const Rejected& error) {
        stop();
        tell_failed(session, path_, error.what());
        return;
    }
    still_.reset();
    session.jobs().start(
        {"Writing " + file_name(path_),
         [&session, image, path = path_](const Progress&) -> Jobs::Finish {
             write_image(*image, path);
             return [&session, path] {
                 session.notices.say(ui::NoticeKind::good, file_name(path) + " was written",
                                     "It is in " + fs::path(path).parent_path().string() + ".",
                                     "picture");
             };
         },
         [&session, path = path_](const std::string& why) { tell_failed(session, path, why); }});
}

} // namespace trivar
