// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/volume_imports.h"

#include "core/commands/objects/voxels.h"
#include "editor/files/volume_offer.h"
#include "editor/files/volume_slices.h"
#include "editor/session/session_facts.h"
#include "editor/words/file_words.h"
#include "ui/camera_control.h"

#include <filesystem>
#include <utility>

namespace trivar {
namespace fs = std::filesystem;
namespace {

// Without a slash at the end, which would leave a folder without a name.
std::string absolute_path(const std::string& path)
{
    const fs::path all = fs::absolute(path).lexically_normal();
    return (all.has_filename() ? all : all.parent_path()).string();
}

} // namespace

VolumeImports::VolumeImports(Session& session) : memory_bytes(volume_memory()), session_(&session)
{
}

VolumeImports::~VolumeImports() = default;

void VolumeImports::leave()
{
    offers_.pop_front();
    ++number_;
}

void VolumeImports::read(const std::string& path, std::function<void(const std::string& why)> done)
{
    const std::string file = absolute_path(path);
    session_->jobs().start(
        {"Reading " + file_name(file),
         [this, file, done, store = session_->assets(),
          memory = memory_bytes](const Progress& progress) -> Jobs::Finish {
             auto offer =
                 std::make_shared<VolumeOffer>(offer_of(file, {}, store, memory, progress));
             return [this, offer, done] {
                 offers_.push_back(std::make_unique<VolumeOffer>(std::move(*offer)));
                 ++number_;
                 done({});
             };
         },
         [file, done](const std::string& why) { done(reason(why, file)); }});
}

void VolumeImports::read_again()
{
    if (offers_.empty()) return;
    const VolumeOffer& now = *offers_.front();
    now.assets->forget(now.path);
    again_ = true;
    session_->jobs().start(
        {"Reading " + file_name(now.path),
         [this, file = now.path, reading = now.command.shape.reading, store = now.assets,
          memory = memory_bytes](const Progress& progress) -> Jobs::Finish {
             auto offer =
                 std::make_shared<VolumeOffer>(offer_of(file, reading, store, memory, progress));
             return [this, offer, reading] {
                 again_ = false;
                 if (offers_.empty() || offers_.front()->path != offer->path) return;
                 const VolumeOffer& was = *offers_.front();
                 // The person went on typing meanwhile.
                 if (was.command.shape.reading != reading) return read_again();
                 offer->up = was.up;
                 offer->scale = was.scale;
                 offer->centered = was.centered;
                 if (offer->grid) offer->slices = turned_slices(*offer);
                 *offers_.front() = std::move(*offer);
                 ++number_;
             };
         },
         [this](const std::string& why) {
             again_ = false;
             if (offers_.empty()) return;
             offers_.front()->grid = nullptr;
             offers_.front()->trouble = why;
             ++number_;
         }});
}

void VolumeImports::add()
{
    if (offers_.empty() || !offers_.front()->grid) return;
    const VolumeOffer offer = std::move(*offers_.front());
    leave();
    AddVoxels command = command_of(offer);
    if (session_->assets() == offer.assets) return run(command);
    // Paths are told from the folder of the scene there is now.
    command.shape.path = offer.path;
    session_->jobs().start(
        {"Reading " + file_name(offer.path),
         [this, command, store = session_->assets()](const Progress& progress) -> Jobs::Finish {
             const auto ready = prepare(command, *store, progress).get<AddVoxels>();
             return [this, ready] { run(ready); };
         },
         [this, path = offer.path](const std::string& why) {
             session_->notices.say(ui::NoticeKind::error, file_first(path) + " was not imported",
                                   reason(why, path));
         }});
}

void VolumeImports::run(const AddVoxels& command)
{
    const Id id = session_->committed().next_id;
    const bool first = session_->committed().objects.empty();
    session_->cancel();
    if (!session_->run(command)) return;
    session_->selected = id;
    session_->level = {id, 0};
    if (first) session_->view.frame_all_when_evaluated = true;
    to_frame_ = first ? 0 : id;
}

void VolumeImports::poll()
{
    if (to_frame_ == 0 || !session_->up_to_date()) return;
    const Id id = std::exchange(to_frame_, 0);
    if (!session_->document().objects.contains(id)) return;
    const std::vector<glm::dvec3> points = points_of(*session_, {id});
    if (!points.empty())
        session_->view.camera = ui::framed(session_->view.camera, points, session_->view.foot_px);
}

} // namespace trivar
