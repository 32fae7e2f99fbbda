// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/file_actions.h"

#include "core/files/pictures/image.h"
#include "editor/actions/chords.h"
#include "editor/actions/menu.h"
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
    const Menu file(a, "File");
    file("New scene", {ctrl('N')}, [](Editor& e) {
        // Whoever asks for one needs no card that offers it.
        e.files.new_scene([&e] {
            e.start_card = {.left = e.session.scenes()};
            e.choose_tool(0);
        });
    });
    file("Open...", {ctrl('O')}, [](Editor& e) { e.files.ask_open(); });
    file("Recover discarded scenes...", {}, [](Editor& e) { e.files.ask_discarded(); });
    file(
        "Save", {ctrl('S')}, [](Editor& e) { e.files.save(); }, {}, true);
    file("Save as...", {ctrl('S', true)}, [](Editor& e) { e.files.ask_save_as(); });
    file("Save numbered copy", {{.key = 'S', .ctrl = true, .alt = true}},
         [](Editor& e) { e.files.save_numbered_copy(); });
    file("Save without undone steps...", {}, [](Editor& e) { e.files.ask_save_compact(); });
    file(
        import_action, {ctrl('I', true)}, [](Editor& e) { e.files.ask_import(); }, {}, true);
    file(
        "Find missing file...", {}, [](Editor& e) { e.files.ask_missing(); }, something_there());
    file(
        "Reload files", {}, [](Editor& e) { read_anew(e.session, e.session.selected.ids()); },
        something_selected());
    file(
        "Collect files next to scene", {}, [](Editor& e) { e.files.collect(); }, something_there());
    file(
        "Export...", {ctrl('E')}, [](Editor& e) { e.files.ask_export(); }, something_there());
    file(
        "Export frames...", {}, [](Editor& e) { ask_export_frames(e); }, something_there());
    file("Render picture", {{ui::key_f1 + 11}}, render_picture, something_there());
    file(
        record_action, {{.key = ui::key_f1 + 11, .ctrl = true}}, [](Editor& e) { ask_record(e); },
        something_there());
    file(
        "Quit", {ctrl('Q')}, [](Editor& e) { e.files.ask_close(); }, {}, true);
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
