// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/command_filling.h"

#include "core/base/rejected.h"
#include "core/commands/objects/import.h"
#include "core/commands/placement/place.h"
#include "editor/editor.h"

namespace trivar {
namespace {

// Files are not read while a path is typed.
bool can_be_shown(const Command& command)
{
    return !command.is<ImportModel>() && !command.is<EditImport>();
}

void select_again(Session& session, const std::vector<Id>& ids)
{
    session.selected.set(ids);
    session.selected.keep_those_in(session.document());
}

// The form with the option taken that stands first in the list.
CommandForm with_option(CommandForm form, const Document& document)
{
    const auto options = options_of(form, document);
    if (const auto taken = taken_option(form, options, document)) take(form, options[*taken]);
    return form;
}

// Returns why the typed text is no value of its field; empty: it is one.
std::string unreadable(const CommandForm& form, const Document& document)
{
    try {
        filled(form, document);
    } catch (const Rejected& why) {
        return why.what();
    }
    return {};
}

// Returns why the filled-in command cannot be done; empty: it can.
std::string refusal(const CommandForm& form, const Document& document)
{
    try {
        const Command command = filled(form, document);
        check_new(document, command);
        after(document, command);
    } catch (const Rejected& why) {
        return why.what();
    }
    return {};
}

} // namespace

void begin_filling(Editor& editor, CommandForm form)
{
    editor.palette.filling = {{std::move(form), editor.session.selected.ids()}};
    editor.palette.fresh = true;
}

void show_filling(Editor& editor)
{
    Session& session = editor.session;
    CommandPalette::Filling& filling = *editor.palette.filling;
    filling.form.trouble.clear();
    try {
        const CommandForm form = with_option(filling.form, session.committed());
        const Command command = filled(form, session.committed());
        show_present(filling.form, command, session.committed());
        if (filling.proposed == command || !can_be_shown(command)) return;
        if (!session.propose_quietly(command)) return;
        filling.proposed = command;
        select_again(session, filling.selected);
    } catch (const Rejected&) { // it may become right yet: the last that was stays
    }
}

bool next_field(Editor& editor, int step)
{
    CommandForm& form = editor.palette.filling->form;
    const Document& document = editor.session.committed();
    form = with_option(std::move(form), document);
    if (step < 0 && form.at == 0) return false;
    CommandForm without = form;
    without.fields[form.at].typed.clear();
    const std::string why = refusal(form, document);
    // Faults of the other fields are reported when the command runs.
    form.trouble = refusal(without, document).empty() ? why : "";
    if (unreadable(without, document).empty() && !unreadable(form, document).empty())
        form.trouble = why;
    editor.palette.fresh = true;
    if (!form.trouble.empty()) return true;
    const std::size_t count = form.fields.size();
    form.at = step < 0 ? form.at - 1 : (form.at + 1) % count;
    form.chosen.reset();
    return true;
}

bool run_filled(Editor& editor)
{
    Session& session = editor.session;
    CommandPalette::Filling& filling = *editor.palette.filling;
    filling.form = with_option(std::move(filling.form), session.committed());
    const Id first = session.committed().next_id;
    const bool empty = session.committed().objects.empty();
    try {
        const Command command =
            prepare(filled(filling.form, session.committed()), *session.assets());
        filling.form.trouble = session.try_run(command);
    } catch (const Rejected& why) {
        filling.form.trouble = why.what();
    }
    if (!filling.form.trouble.empty()) {
        editor.palette.fresh = true; // Enter took the keyboard away
        return false;
    }
    select_again(session, filling.selected);
    if (session.committed().next_id > first) session.select_new(first);
    if (const auto* place = session.scene().history().steps().back().command.as<Place>())
        session.selected = place->object;
    if (empty) session.view.frame_all_when_evaluated = true;
    editor.palette.filling.reset();
    return true;
}

void leave_filling(Editor& editor)
{
    editor.session.cancel();
    select_again(editor.session, editor.palette.filling->selected);
    editor.palette.filling.reset();
}

} // namespace trivar
