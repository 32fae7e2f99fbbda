// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/file_actions.h"

#include "core/files/pictures/image.h"
#include "editor/actions/chords.h"
#include "editor/editor.h"
#include "editor/files/relink.h"

namespace trivar {
namespace {

// The frames that are meant still, of those that the scene has now.
void keep_frames_of(const Time& time, int& first, int& last)
{
    first = std::clamp(first, time.first_frame, time.last_frame);
    last = std::clamp(last, first, time.last_frame);
}

// Returns the size of recordings: a single picture is one of their frames.
glm::ivec2 picture_size(Editor& e)
{
    const RecordPlan& plan = e.memory.of<RecordDialog>().plan;
    return {plan.width_px, plan.height_px};
}

void render_picture(Editor& e)
{
    if (!e.picture_to_file.running()) e.picture_to_file.begin(e.session, picture_size(e));
}

} // namespace

void add_file_actions(std::vector<Action>& a)
{
    a.push_back({"File", "New scene", {ctrl('N')}, [](Editor& e) {
                     // Whoever asks for one needs no card that offers it.
                     e.files.new_scene([&e] {
                         e.start_card = {.left = e.session.scenes()};
                         e.choose_tool(0);
                     });
                 }});
    a.push_back({"File", "Open...", {ctrl('O')}, [](Editor& e) { e.files.ask_open(); }});
    a.push_back(
        {"File", "Recover discarded scenes...", {}, [](Editor& e) { e.files.ask_discarded(); }});
    a.push_back({"File", "Save", {ctrl('S')}, [](Editor& e) { e.files.save(); }, {}, true});
    a.push_back(
        {"File", "Save as...", {ctrl('S', true)}, [](Editor& e) { e.files.ask_save_as(); }});
    a.push_back(
        {"File", "Save numbered copy", {{.key = 'S', .ctrl = true, .alt = true}}, [](Editor& e) {
             e.files.save_numbered_copy();
         }});
    a.push_back({"File", "Save without undone steps...", {}, [](Editor& e) {
                     e.files.ask_save_compact();
                 }});
    a.push_back({"File",
                 import_action,
                 {ctrl('I', true)},
                 [](Editor& e) { e.files.ask_import(); },
                 {},
                 true});
    a.push_back({"File",
                 "Find missing file...",
                 {},
                 [](Editor& e) { e.files.ask_missing(); },
                 something_there()});
    a.push_back({"File",
                 "Reload files",
                 {},
                 [](Editor& e) { read_anew(e.session, e.session.selected.ids()); },
                 something_selected()});
    a.push_back({"File",
                 "Collect files next to scene",
                 {},
                 [](Editor& e) { e.files.collect(); },
                 something_there()});
    a.push_back({"File",
                 "Export...",
                 {ctrl('E')},
                 [](Editor& e) { e.files.ask_export(); },
                 something_there()});
    a.push_back({"File",
                 "Export frames...",
                 {},
                 [](Editor& e) { ask_export_frames(e); },
                 something_there()});
    a.push_back({"File", "Render picture", {{ui::key_f1 + 11}}, render_picture, something_there()});
    a.push_back({"File",
                 record_action,
                 {{.key = ui::key_f1 + 11, .ctrl = true}},
                 [](Editor& e) { ask_record(e); },
                 something_there()});
    a.push_back({"File", "Quit", {ctrl('Q')}, [](Editor& e) { e.files.ask_close(); }, {}, true});
}

void ask_export_frames(Editor& editor)
{
    const Session& session = editor.session;
    auto& dialog = editor.memory.of<ExportDialog>();
    const std::string& scene = session.scene().path();
    if (dialog.of != scene || dialog.plan == ExportPlan())
        dialog.plan = usual_export(session, editor.files.models_folder);
    dialog.of = scene;
    keep_frames_of(session.document().time, dialog.plan.first, dialog.plan.last);
    dialog.open = true;
}

void ask_record(Editor& editor)
{
    Session& session = editor.session;
    auto& dialog = editor.memory.of<RecordDialog>();
    if (editor.recording.running()) {
        dialog.card_hidden = !dialog.card_hidden;
        return;
    }
    if (session.scene().path().empty()) {
        session.notices.say(ui::NoticeKind::warning, "The scene is not saved yet",
                            "Frames are saved next to the scene file. Save the scene first.",
                            "picture", {{"Save as...", [&editor] { editor.files.ask_save_as(); }}});
        return;
    }
    if (dialog.of != session.scene().path()) dialog.plan = usual_plan(session);
    dialog.of = session.scene().path();
    dialog.there.reset();
    keep_frames_of(session.document().time, dialog.plan.first, dialog.plan.last);
    dialog.open = true;
}

} // namespace trivar
