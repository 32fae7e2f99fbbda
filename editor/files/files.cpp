// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/files.h"

#include "core/base/rejected.h"
#include "core/commands/collect.h"
#include "core/drawing/drawing_file.h"
#include "core/export/animated_model.h"
#include "core/export/still_export.h"
#include "core/files/copies.h"
#include "core/files/file_bytes.h"
#include "core/files/write_model.h"
#include "core/scene/files_read.h"
#include "editor/files/relink.h"
#include "editor/files/volume_names.h"
#include "editor/session/scene_facts.h"
#include "editor/session/scene_names.h"
#include "editor/words/file_words.h"
#include "ui/sentence.h"

#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace fs = std::filesystem;
namespace {

// Where the file of an object is looked for, if there is such a folder.
std::optional<fs::path> folder_of(const Session& session, Id id)
{
    const std::string file = file_to_relink(session, id);
    if (file.empty()) return {};
    const fs::path folder = fs::path(file).parent_path();
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) return {};
    return folder;
}

struct ExportWords {
    ui::NoticeKind kind;
    std::string title, body;
};

// Words the notice on an export: the file, and how near it is certified to be to the true surfaces.
ExportWords words_of_export(const std::string& path, const std::string& scene,
                            const std::optional<Certificate>& certificate)
{
    const std::string name = file_name(path);
    if (!certificate) return {ui::NoticeKind::good, "Exported " + name, {}};
    const std::vector<std::string> open = not_certified(*certificate);
    if (!open.empty())
        return {ui::NoticeKind::warning, "Exported " + name + ", not all of it certified",
                open.size() == 1 ? open.front() + "."
                                 : fmt::format("{}, and {} more.", open.front(), open.size() - 1)};
    std::string body = "Certified within " + bound_text(certificate->bound) + ".";
    if (extension_of(path) != ".glb")
        body += " Only a glTF file records this.";
    else if (scene.empty())
        body += " Save the scene next to the file, so that trivar verify finds it.";
    return {ui::NoticeKind::good, "Exported " + name, body};
}

} // namespace

const std::vector<std::string>& model_extensions()
{
    static const std::vector<std::string> extensions{".glb", ".gltf", ".obj",
                                                     ".ply", ".stl",  ".off"};
    return extensions;
}

const std::vector<std::string>& export_extensions()
{
    static const std::vector<std::string> extensions{".glb", ".obj", ".ply", ".stl",
                                                     ".off", ".svg", ".pdf"};
    return extensions;
}

const std::vector<std::string>& image_extensions()
{
    static const std::vector<std::string> extensions{".png",  ".jpg",  ".jpeg", ".exr", ".tif",
                                                     ".tiff", ".webp", ".hdr",  ".tga", ".bmp"};
    return extensions;
}

Files::Files(Session& session, Recovery& recovery)
    : volumes(session),
      session_(&session),
      recovery_(&recovery)
{
    session.missing_remedies = {
        {"Find...", [this] { ask_missing(); }},
        {"Reload", [this] { read_anew(*session_, session_->not_shown()); }}};
}

bool Files::asking() const
{
    return dialog_.is_open() || question_.has_value() || volumes.offering() || opening();
}

void Files::keep_or(std::function<void()> go_on)
{
    const Session& s = *session_;
    if (!s.scene().path().empty() || s.scene().as_opened()) return go_on();
    if (!ask_to_keep && !s.unnamed_folder().empty()) return go_on();
    const std::size_t steps = s.scene().history().steps().size();
    const std::string what = std::to_string(steps) + (steps == 1 ? " step" : " steps");
    question_ = PendingQuestion{
        {"Save this scene?",
         "It has " + what + " and has not been saved. " +
             (s.unnamed_folder().empty()
                  ? "It cannot be recovered once discarded. "
                  : "A recovery copy is kept " + for_days(recovery_->discarded_days) + ". ") +
             "Save it to keep it with your scenes.",
         {{"Discard", ui::ButtonKind::plain, true},
          {"Cancel", ui::ButtonKind::plain},
          {"Save...", ui::ButtonKind::primary}},
         2},
        [this, go_on = std::move(go_on)](int answer) {
            if (answer == 0) go_on();
            if (answer != 2) return;
            ask_save_as();
            after_save_ = go_on;
        }};
}

void Files::new_scene(std::function<void()> then)
{
    keep_or([this, then = std::move(then)] {
        session_->replace_scene(SceneFile());
        session_->view.frame_all_when_evaluated = false;
        session_->view.camera = Camera{.size_px = session_->view.camera.size_px};
        if (then) then();
    });
}

void Files::recover()
{
    keep_or([this] { recovery_->take_up_left_scene(); });
}

void Files::ask_for_file(Purpose purpose, ui::FileRequest request)
{
    purpose_ = purpose;
    after_save_ = nullptr;
    const bool of_models = purpose == Purpose::import || purpose == Purpose::write_model;
    std::error_code ignored;
    fs::path start = with_long_home(of_models ? models_folder : scenes_folder);
    // Where scenes were, not where the last model came from.
    if (start.empty())
        start = scene_folder_.empty() ? fs::current_path(ignored) : fs::path(scene_folder_);
    if (!session_->scene().path().empty()) start = session_->scene().folder();
    if (purpose == Purpose::import && !import_folder_.empty()) start = import_folder_;
    if (purpose == Purpose::image && !image_folder_.empty()) start = image_folder_;
    if (purpose == Purpose::take_up) start = session_->unnamed_folder();
    if (purpose == Purpose::relink) start = folder_of(*session_, relinked_).value_or(start);
    dialog_.open(std::move(request), start);
}

void Files::ask_open()
{
    ask_for_file(
        Purpose::open,
        {.title = "Open a scene", .action = "Open", .extensions = {scene_extension}, .name = {}});
}

void Files::ask_discarded()
{
    if (SceneFile::set_aside_in(session_->unnamed_folder()).empty()) {
        if (recovery_->left_scene()) return recover();
        session_->notices.say(ui::NoticeKind::good, "No discarded scenes",
                              "Discarded scenes can be found here " +
                                  for_days(recovery_->discarded_days) + ".");
        return;
    }
    ask_for_file(Purpose::take_up, {.title = "Discarded scenes",
                                    .action = "Recover",
                                    .extensions = {scene_extension},
                                    .name = {}});
}

void Files::ask_import()
{
    std::vector<std::string> extensions = model_extensions();
    extensions.insert(extensions.end(), volume_extensions().begin(), volume_extensions().end());
    ask_for_file(Purpose::import, {.title = "Import a model or volume data",
                                   .action = "Import",
                                   .extensions = std::move(extensions),
                                   .name = {},
                                   .take_folder = "Folder of slices"});
}

void Files::ask_image(const std::string& title, std::function<void(const std::string&)> then)
{
    then_image_ = std::move(then);
    ask_for_file(
        Purpose::image,
        {.title = title, .action = "Use picture", .extensions = image_extensions(), .name = {}});
}

void Files::ask_relink(Id object)
{
    relinked_ = object;
    const FileKind kind = kind_to_relink(*session_, object);
    const bool picture = kind == FileKind::image, volume = kind == FileKind::volume;
    ask_for_file(Purpose::relink,
                 {.title = (picture ? "Choose the picture of " : "Choose the file of ") +
                           name_of(session_->committed(), object),
                  .action = picture ? "Use picture" : "Use file",
                  .extensions = picture  ? image_extensions()
                                : volume ? volume_extensions()
                                         : model_extensions(),
                  .name = {},
                  .take_folder = volume ? "Folder of slices" : ""});
}

void Files::ask_missing()
{
    const std::vector<Id> missing = missing_files(*session_);
    if (!missing.empty()) return ask_relink(missing.front());
    // Objects that are not shown may have their files again without having been read since.
    if (const std::vector<Id> broken = session_->not_shown(); reads_files(*session_, broken))
        return read_anew(*session_, broken);
    session_->notices.say(ui::NoticeKind::good, "No file is missing",
                          "All files that the scene uses were found.");
}

void Files::ask_export(const std::string& path)
{
    const std::string name =
        path.empty() ? stem_of(session_->scene()) + export_extensions().front() : path;
    ask_for_file(Purpose::write_model,
                 {.title = "Export visible objects",
                  .action = "Export",
                  .extensions = export_extensions(),
                  .saving = true,
                  .name = name,
                  .option = has_tiles(session_->committed()) ? tiles_as_instances : std::string(),
                  .option_on = has_tiles(session_->committed()) && dialog_.option_on()});
}

void Files::save()
{
    if (session_->scene().path().empty()) return ask_save_as();
    if (session_->scene().trouble().empty()) {
        session_->notices.say(ui::NoticeKind::good, "Everything is on disk",
                              "A saved scene is kept up to date as you work.");
        return;
    }
    const std::string path = session_->scene().path();
    write_scene(path, false); // tries again with all that is missing
}

void Files::ask_save_as()
{
    ask_for_file(Purpose::save_as, {.title = "Save the scene as",
                                    .action = "Save",
                                    .extensions = {scene_extension},
                                    .saving = true,
                                    .name = stem_of(session_->scene()) + scene_extension});
}

void Files::ask_save_compact()
{
    question_ = PendingQuestion{
        {"Save without undone steps?",
         "The new file holds only the steps in force. It is smaller, but undone steps cannot be "
         "redone from it.",
         {{"Cancel", ui::ButtonKind::plain},
          {"Save without undone steps...", ui::ButtonKind::primary}},
         0},
        [this](int answer) {
            if (answer != 1) return;
            ask_for_file(Purpose::save_compact,
                         {.title = "Save without undone steps as",
                          .action = "Save",
                          .extensions = {scene_extension},
                          .saving = true,
                          .name = stem_of(session_->scene()) + "_compact" + scene_extension});
        }};
}

void Files::save_numbered_copy()
{
    const std::string& path = session_->scene().path();
    if (path.empty()) return ask_save_as();
    const std::string copy = numbered_name(path);
    try {
        session_->scene().save_copy(copy);
    } catch (const Rejected& why) {
        session_->notices.say(ui::NoticeKind::error, file_name(copy) + " was not saved",
                              reason(why.what(), copy));
        return;
    }
    session_->notices.say(ui::NoticeKind::good, "Saved a copy as " + file_name(copy),
                          "You keep working in " + file_name(path) + ".");
}

void Files::collect()
{
    if (session_->scene().path().empty()) {
        ask_save_as();
        after_save_ = [this] { collect(); };
        return;
    }
    const fs::path scene = fs::absolute(session_->scene().path());
    const std::string folder = (scene.parent_path() / (scene.stem().string() + ".assets")).string();
    session_->jobs().start(
        {"Collecting files",
         [this, folder, document = session_->committed(),
          store = session_->assets()](const Progress& progress) -> Jobs::Finish {
             const Collection done = collect_files(document, *store, folder, progress);
             return [this, done, folder, store] {
                 if (session_->assets() != store) return; // another scene
                 if (!done.command) {
                     session_->notices.say(ui::NoticeKind::good, "Nothing to collect",
                                           "Every file that the scene uses lies in " +
                                               file_name(folder) + " already, or it uses none.");
                     return;
                 }
                 session_->cancel();
                 if (!session_->run(*done.command)) return;
                 const std::size_t count = done.copied + done.reused;
                 std::string words = std::to_string(count) + (count == 1 ? " file" : " files");
                 if (done.reused > 0)
                     words += ", " + std::to_string(done.reused) + " of them there already";
                 session_->notices.say(ui::NoticeKind::good, "Collected in " + file_name(folder),
                                       words + ".");
             };
         },
         [this](const std::string& why) {
             session_->notices.say(ui::NoticeKind::error, "The files were not collected", why);
         }});
}

void Files::ask_close()
{
    keep_or([this] { close_agreed_ = true; });
}

void Files::write_scene(const std::string& path, bool compact, bool from_dialog)
{
    try {
        if (compact)
            session_->save_compact(path);
        else
            session_->save_as(path);
    } catch (const Rejected& why) {
        const std::string what = file_name(path) + " was not saved",
                          because = reason(why.what(), path);
        if (from_dialog)
            dialog_.ask_again(what + ". " + ui::sentence(because));
        else
            session_->notices.say(ui::NoticeKind::error, what, because);
        return;
    }
    scene_folder_ = fs::path(path).parent_path().string();
    session_->notices.say(ui::NoticeKind::good, "Saved as " + file_name(path),
                          "Changes are now saved automatically.");
    if (const auto go_on = std::exchange(after_save_, nullptr)) go_on();
}

void Files::write_model_to(const std::string& path, bool instances)
{
    if (is_line_sheet(path)) return write_lines_to(path);
    const bool by_instances = instances && extension_of(path) == ".glb";
    const SceneFile& scene = session_->scene();
    const ExportedScene exported{
        .document = session_->committed(),
        .frame = static_cast<double>(session_->frame()),
        .log = scene.path().empty() ? scene.original() : scene.path(),
        .lines = static_cast<int>(scene.lines().size()),
        .instances = by_instances ? std::optional(default_tolerance) : std::nullopt,
    };
    // Takes the scene as it is shown, if that is the state that the file will hold.
    std::optional<Evaluation> seen;
    if (session_->up_to_date() && !session_->proposing() && !session_->previewing())
        seen = session_->evaluated();
    session_->jobs().start(
        {"Writing " + file_name(path),
         [this, path, exported, seen, instances,
          assets = session_->assets()](const Progress& progress) -> Jobs::Finish {
             report(progress, 0.1, "gathering");
             const Evaluation evaluated =
                 seen ? *seen : Evaluator(assets)(exported.document, exported.frame, progress);
             const Export result = export_of(evaluated, exported);
             report(progress, 0.3, "writing");
             write_model(result.model, path, source_files(exported.document, *assets, exported.log),
                         {exported.instances.has_value()});
             ExportWords words = words_of_export(path, exported.log, result.certificate);
             if (const std::string out = what_is_lost(result.model, path); !out.empty()) {
                 words.kind = ui::NoticeKind::warning;
                 words.body += (words.body.empty() ? "" : " ") + out + ".";
             }
             std::vector<std::string> more;
             if (exported.instances) more = sentences(result.tiles, *exported.instances);
             if (instances && !exported.instances) more = {"Only a glTF file has instances"};
             for (const std::string& each : more)
                 words.body += (words.body.empty() ? "" : " ") + each + ".";
             return [this, words] { session_->notices.say(words.kind, words.title, words.body); };
         },
         [this, path](const std::string& why) {
             session_->notices.say(ui::NoticeKind::error, file_name(path) + " was not written",
                                   reason(why, path), {},
                                   {{"Try again...", [this, path] { ask_export(path); }}});
         }});
}

void Files::use_file(const std::string& path)
{
    switch (purpose_) {
    case Purpose::open: return open_scene(path);
    case Purpose::take_up: recovery_->take_up(path); return;
    case Purpose::import:
        import_folder_ = fs::path(path).parent_path().string();
        return import(path);
    case Purpose::image:
        image_folder_ = fs::path(path).parent_path().string();
        if (then_image_) then_image_(path);
        return;
    case Purpose::relink: return relink(*session_, relinked_, path);
    case Purpose::write_model: return write_model_to(path, dialog_.option_on());
    case Purpose::save_as: return write_scene(path, false, true);
    case Purpose::save_compact: return write_scene(path, true, true);
    }
}

void Files::draw(const ui::Theme& theme)
{
    measure_imported();
    volumes.poll();
    const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    if (!waiting_.empty() && !asking() && !popup) take_dropped(std::exchange(waiting_, {}));
    if (question_) {
        const std::optional<int> answer = ui::ask(theme, question_->question);
        if (!answer) return;
        const auto reply = std::exchange(question_, std::nullopt)->answer;
        reply(*answer); // may ask the next thing
        return;
    }
    if (const std::optional<std::string> path = dialog_.draw(theme)) use_file(*path);
}

} // namespace trivar
