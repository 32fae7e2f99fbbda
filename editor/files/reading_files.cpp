// SPDX-License-Identifier: GPL-3.0-or-later
// What comes in: scenes that are opened, models that are imported, files that are dropped.
#include "core/base/rejected.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/shade.h"
#include "core/files/file_bytes.h"
#include "core/mesh/shading.h"
#include "editor/files/files.h"
#include "editor/files/volume_names.h"
#include "editor/session/scene_facts.h"
#include "editor/session/scene_names.h"
#include "editor/session/session_facts.h"
#include "editor/words/file_words.h"
#include "ui/camera_control.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <utility>

namespace trivar {
namespace fs = std::filesystem;

bool is_model(const std::string& path)
{
    const auto& known = model_extensions();
    return std::find(known.begin(), known.end(), extension_of(path)) != known.end();
}

bool is_picture(const std::string& path)
{
    const auto& known = image_extensions();
    return std::find(known.begin(), known.end(), extension_of(path)) != known.end();
}

// Reads a scene in whose reading the program may end: then the third time all but its last lines.
SceneFile Files::read_scene(const std::string& path, bool copy) const
{
    LifeSign reading(session_->unnamed_folder(), path + reading_sign, 0, true);
    const std::size_t too_many = reading.steps_too_many();
    if (too_many == 0) return copy ? SceneFile::copy_of(path) : SceneFile(path);
    reading.take_back(0);
    return SceneFile::copy_of(path, too_many);
}

void Files::open_scene(const std::string& path)
{
    std::error_code ignored;
    const bool sample = std::ranges::any_of(
        samples, [&](const std::string& each) { return fs::equivalent(each, path, ignored); });
    open(path, sample, nullptr);
}

void Files::open_copy(const std::string& path, std::function<void()> then)
{
    open(path, true, std::move(then));
}

void Files::open(const std::string& path, bool copy, std::function<void()> then)
{
    keep_or([this, path, copy, then = std::move(then)] {
        const auto since = std::make_shared<const Present>(present());
        opening_ = since;
        session_->jobs().start(
            {"Opening " + file_name(path),
             [this, since, path, copy, then](const Progress&) -> Jobs::Finish {
                 // The scene is shared, since a function that is copied cannot hold a value that
                 // can only be moved.
                 auto scene = std::make_shared<SceneFile>(read_scene(path, copy));
                 return [this, since, scene, then] {
                     if (opening_.lock() == since) opening_.reset();
                     take_opened(*since, scene, then);
                 };
             },
             [this, path](const std::string& why) {
                 opening_.reset();
                 session_->notices.say(ui::NoticeKind::error, file_name(path) + " was not opened",
                                       reason(why, path));
             }});
    });
}

void Files::take_opened(const Present& since, const std::shared_ptr<SceneFile>& scene,
                        const std::function<void()>& then)
{
    const auto go_on = [this, scene, then] {
        if (scene->in_use()) return ask_how_to_open(scene);
        show(std::move(*scene));
        if (then) then();
    };
    if (since == present())
        go_on();
    else
        keep_or(go_on); // a model that was being read may have come
}

void Files::show(SceneFile scene)
{
    if (!scene.path().empty()) scene_folder_ = scene.folder();
    const bool copy = scene.path().empty() && !scene.original().empty();
    std::vector<ui::Notices::Action> offers;
    if (copy) offers.push_back({"Save as...", [this] { ask_save_as(); }});
    session_->replace_scene(std::move(scene), std::move(offers));
}

void Files::ask_how_to_open(const std::shared_ptr<SceneFile>& copy)
{
    const std::string path = copy->original();
    question_ = PendingQuestion{
        {file_name(path) + " is open in another window",
         "Open it read-only and follow the changes live, or work on an unsaved copy.",
         {{"Cancel", ui::ButtonKind::plain},
          {"Open a copy", ui::ButtonKind::plain},
          {"Open read-only", ui::ButtonKind::primary}},
         2},
        [this, copy, path](int answer) {
            if (answer == 1) show(std::move(*copy));
            if (answer != 2) return;
            try {
                session_->replace_scene(SceneFile::looked_at(path));
            } catch (const Rejected& why) {
                session_->notices.say(ui::NoticeKind::error, file_name(path) + " was not opened",
                                      reason(why.what(), path));
            }
        }};
}

void Files::read_in_background(const std::string& path, const std::string& name,
                               std::function<bool(const ImportModel&)> take,
                               std::function<void(const std::string& why)> lost)
{
    session_->jobs().start(
        {"Reading " + file_name(path),
         [this, path, name, take, lost,
          store = session_->assets()](const Progress& progress) -> Jobs::Finish {
             ImportModel import;
             import.file.path = fs::absolute(path).string();
             import.name = name;
             const ImportModel ready = prepare(import, *store, progress).get<ImportModel>();
             const AssetStore::LoadedModel loaded = store->load(ready.file, progress);
             if (!loaded.model)
                 throw Rejected(loaded.notices.empty() ? "It cannot be read."
                                                       : loaded.notices.front());
             return [this, path, name, take, lost, ready, store, said = loaded.notices] {
                 // Paths are told from the folder of the scene there is now.
                 if (session_->assets() != store) return read_in_background(path, name, take, lost);
                 if (take(ready) && !said.empty())
                     session_->notices.say_all(ui::NoticeKind::warning,
                                               file_name(path) + " was imported", said);
             };
         },
         [path, lost](const std::string& why) { lost(reason(why, path)); }});
}

void Files::read_model_of(const std::string& path, bool frame_all,
                          const std::shared_ptr<Batch>& batch)
{
    const auto take = [this, frame_all, batch](const ImportModel& import) {
        tell_lost(*batch);
        const Id id = session_->committed().next_id;
        const bool first = session_->committed().objects.empty();
        session_->cancel();
        if (!session_->run(import)) return false;
        session_->selected = id;
        if (first || frame_all) session_->view.frame_all_when_evaluated = true;
        to_measure_.push_back(id);
        if (batch->then) batch->then(id);
        return true;
    };
    read_in_background(path, batch->name, take, [this, path, batch](const std::string& why) {
        batch->lost.push_back({file_name(path), why});
        tell_lost(*batch);
    });
}

void Files::read_volume_of(const std::string& path, const std::shared_ptr<Batch>& batch)
{
    volumes.read(path, [this, path, batch](const std::string& why) {
        if (!why.empty()) batch->lost.push_back({file_name(path), why});
        tell_lost(*batch);
    });
}

void Files::import(const std::string& path, bool frame_all, std::function<void(Id)> then,
                   std::string name)
{
    const auto batch = std::make_shared<Batch>(Batch{1, {}, std::move(then), std::move(name)});
    if (!is_model(path) && is_volume(path))
        read_volume_of(path, batch);
    else
        read_model_of(path, frame_all, batch);
}

void Files::read_model(const std::string& path, std::function<void(const ImportModel&)> take,
                       std::string name)
{
    read_in_background(
        path, name,
        [take](const ImportModel& import) {
            take(import);
            return true;
        },
        [this, path](const std::string& why) {
            session_->notices.say(ui::NoticeKind::error, file_first(path) + " was not imported",
                                  why);
        });
}

namespace {

// Whether a person sees any part of a box.
bool is_seen(const Camera& camera, const Box& box)
{
    constexpr double least_px = 6;
    if (box.distance(camera.eye) <= 0) return false;
    const PicturePoint middle = project(camera, box.center());
    if (!(middle.depth_world > 0)) return false;
    const glm::dvec2 p = middle.p_px, size = camera.size_px;
    const double px = glm::length(box.size()) / pixel_size_world(camera, middle.depth_world);
    return px >= least_px && p.x > -px / 2 && p.y > -px / 2 && p.x < size.x + px / 2 &&
           p.y < size.y + px / 2;
}

} // namespace

void Files::measure_imported()
{
    Session& s = *session_;
    if (to_measure_.empty() || !s.up_to_date() || s.proposing()) return;
    const std::vector<Id> fresh = std::exchange(to_measure_, {});
    tell_of_facets(fresh);
    for (auto each = fresh.begin(); each != fresh.end(); ++each) {
        const Id id = *each;
        const auto& objects = s.document().objects;
        if (!objects.contains(id)) continue;
        if (objects.at(id)->tiles) continue; // tiles have their own size
        std::vector<Id> others;              // those that were there before
        for (const auto& [other, ref] : objects)
            if (other != id && visible(s.document(), other) &&
                std::find(each, fresh.end(), other) == fresh.end())
                others.push_back(other);
        const Box box = bounds_of(s, id);
        const double own = glm::length(box.size());
        const double all = others.empty() ? 0 : glm::length(bounds_of(s, others).size());
        if (!(own > 0) || !(all > 0) || tell_of_sizes(id, own, all)) continue;
        if (s.view.frame_all_when_evaluated || is_seen(s.view.camera, box)) continue;
        s.notices.say(
            ui::NoticeKind::warning, name_of(s.document(), id) + " cannot be seen from here",
            "It is out of view, tiny, or all around the camera.", "place of a model",
            {{"Frame it", [&s, id] {
                  s.view.go_to = ui::framed(s.view.camera, points_of(s, {id}), s.view.foot_px);
              }}});
    }
}

bool Files::tell_of_sizes(Id id, double own_m, double scene_m)
{
    constexpr double odd = 30; // times as large or small as the rest: hardly ever meant
    const double ratio = own_m / scene_m;
    if (ratio < odd && ratio > 1 / odd) return false;
    const double factor = std::pow(10.0, -std::round(std::log10(ratio)));
    const std::string name = name_of(session_->document(), id);
    session_->notices.say(
        ui::NoticeKind::warning,
        fmt::format("{} is about {} times {} than the rest of the scene", name,
                    ui::short_number(ratio > 1 ? 1 / factor : factor),
                    ratio > 1 ? "larger" : "smaller"),
        fmt::format("It measures {} m, the rest {} m. Its file may be in another unit.",
                    ui::short_number(own_m), ui::short_number(scene_m)),
        "size of a model",
        {{fmt::format("Scale it by {}", ui::short_number(factor)), [this, id, factor] {
              if (!session_->committed().objects.contains(id)) return;
              Transform t = object(session_->committed(), id).transform;
              t.scale *= factor;
              if (session_->run(SetTransform{id, t}))
                  session_->view.frame_all_when_evaluated = true;
          }}});
    return true;
}

void Files::tell_of_facets(std::vector<Id> fresh)
{
    std::erase_if(fresh, [&](Id id) {
        const auto effects = session_->evaluated().objects.find(id);
        return effects == session_->evaluated().objects.end() ||
               std::ranges::none_of(effects->second->shape->meshes,
                                    [](const auto& hung) { return looks_smooth(*hung.rest); });
    });
    if (fresh.empty()) return;
    const std::string names = names_in(session_->document(), fresh);
    session_->notices.say(
        ui::NoticeKind::warning, names + (fresh.size() == 1 ? " is" : " are") + " shaded flat",
        "A file without normals. Its faces are many and meet at small angles, as in a scan.",
        "facets of a model", {{"Shade by angle", [this, fresh]() mutable {
                                   std::erase_if(fresh, [&](Id id) {
                                       return !session_->committed().objects.contains(id);
                                   });
                                   if (!fresh.empty())
                                       session_->run(Shade{fresh, {ShadingWay::by_angle}});
                               }}});
}

void Files::tell_lost(Batch& batch)
{
    if (batch.coming > 0) --batch.coming;
    if (batch.coming > 0 || batch.lost.empty()) return;
    constexpr std::size_t most = 4;
    const std::size_t count = batch.lost.size();
    if (count == 1) {
        session_->notices.say(ui::NoticeKind::error,
                              file_first(batch.lost[0].name) + " was not imported",
                              batch.lost[0].why);
        return;
    }
    std::string words;
    for (std::size_t i = 0; i < std::min(most, count); ++i)
        words += (i == 0 ? "" : "\n") + batch.lost[i].name + ": " + batch.lost[i].why;
    if (count > most) words += "\nand " + std::to_string(count - most) + " more";
    session_->notices.say(ui::NoticeKind::error, std::to_string(count) + " files were not imported",
                          words);
}

void Files::drop(const std::vector<std::string>& paths)
{
    waiting_.insert(waiting_.end(), paths.begin(), paths.end());
}

void Files::take_dropped(const std::vector<std::string>& paths)
{
    std::vector<std::string> scenes, models, volume_data, images;
    const auto batch = std::make_shared<Batch>();
    for (const std::string& path : paths)
        if (extension_of(path) == scene_extension)
            scenes.push_back(path);
        else if (is_model(path))
            models.push_back(path);
        else if (is_volume(path))
            volume_data.push_back(path);
        else if (is_picture(path) && use_dropped_image)
            images.push_back(path);
        else
            batch->lost.push_back(
                {file_name(path),
                 "Trivar reads scenes (.trivar), models (glTF, OBJ, PLY, STL, OFF) and volume data "
                 "(NRRD, NIfTI, MetaImage, VTK, DICOM, raw, and folders of slices)"});
    for (std::size_t i = 0; i + 1 < scenes.size(); ++i)
        batch->lost.push_back({file_name(scenes[i]), "only one scene is open at a time"});
    batch->coming = models.size() + volume_data.size();
    const bool fresh = session_->committed().objects.empty();
    for (const std::string& path : models) read_model_of(path, fresh, batch);
    for (const std::string& path : volume_data) read_volume_of(path, batch);
    if (batch->coming == 0) tell_lost(*batch);
    if (!images.empty()) use_dropped_image(images.back());
    if (!scenes.empty()) open_scene(scenes.back());
}

} // namespace trivar
