// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/clipboard.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/paste.h"
#include "core/document/asset_store.h"
#include "core/document/each_name.h"
#include "core/document/fields/object_fields.h"
#include "core/scene/log.h"
#include "editor/commands/run_lines.h"
#include "editor/session/scene_facts.h"
#include "editor/session/session_facts.h"
#include "ui/sentence.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace trivar {
namespace {

// The commands of a text whose every line is one of a scene file. Throws Rejected.
std::vector<Command> commands_in(std::string_view text)
{
    std::vector<Command> commands;
    for (const std::string_view line : trimmed_lines(text)) {
        if (is_no_step(line)) continue;
        const LogLine read = read_log_line(line);
        if (const auto* command = std::get_if<Command>(&read.what)) commands.push_back(*command);
    }
    return commands;
}

bool same_place(const glm::dmat4& a, const glm::dmat4& b)
{
    constexpr double slack = 1e-9;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k)
            if (std::abs(a[i][k] - b[i][k]) > slack * (1 + std::abs(a[i][k]))) return false;
    return true;
}

// Files may be named from the root and from the scene's folder.
bool same_shape(Source a, Source b, const std::string& folder)
{
    for (Source* each : {&a, &b})
        each_file(*each, [&](const auto& file, auto&) {
            file.path = (std::filesystem::path(folder) / file.path).lexically_normal().string();
            file.digest.clear();
        });
    return a == b;
}

// Returns the objects below `first` that hide one added from there on: same place, same shape.
std::vector<Id> hidden_in(const Document& document, Id first, const std::string& folder)
{
    const auto stands = [](const Object& each) {
        return !each.stroke && kind_of(each).has_surface;
    };
    std::vector<std::pair<glm::dmat4, const Source*>> added;
    for (const auto& [id, each] : document.objects)
        if (id >= first && stands(*each)) added.emplace_back(to_world(document, id), &each->source);
    std::vector<Id> found;
    for (const auto& [id, each] : document.objects) {
        if (id >= first || !stands(*each)) continue;
        const glm::dmat4 at = to_world(document, id);
        const Source& source = each->source;
        if (std::ranges::any_of(added, [&](const auto& one) {
                return same_place(one.first, at) && same_shape(*one.second, source, folder);
            }))
            found.push_back(id);
    }
    return found;
}

// Moves the copies aside, in whole steps, till none stands in its original. Returns whether it had
// to.
bool step_aside(Paste& paste, const Session& session)
{
    constexpr int most = 100;
    constexpr double gap = 1.1;
    const Document& document = session.committed();
    double step = 0;
    for (int i = 0; i < most; ++i) {
        const std::vector<Id> hiding =
            hidden_in(after(document, paste), document.next_id, session.assets()->folder());
        if (hiding.empty()) break;
        if (step == 0) step = gap * bounds_of(session, hiding).size().x;
        if (!(step > 0)) step = 1; // not evaluated yet
        for (CopiedObject& copy : paste.copies)
            if (copy.value.parent == 0) copy.value.transform.translation.x += step;
    }
    return step > 0;
}

// Words how placed objects lie here, if that is worth a word.
std::string placed_words(const Document& before, const Document& document, const Paste& paste)
{
    std::size_t straight = 0, elsewhere = 0, in_place = 0;
    for (std::size_t i = 0; i < paste.copies.size(); ++i) {
        const CopiedObject& copy = paste.copies[i];
        if (!copy.value.stroke) continue;
        const auto& laid = object(document, before.next_id + static_cast<Id>(i)).stroke;
        const auto is_here = [&](Id base) {
            return std::ranges::find(laid->onto, base) != laid->onto.end() &&
                   name_of(before, base) == known(copy.names, base).name;
        };
        const auto on_it = [&](const auto& entry) { return entry.second->stroke == laid; };
        if (!laid)
            ++straight;
        else if (std::ranges::any_of(copy.value.stroke->onto, is_here))
            in_place += std::ranges::any_of(before.objects, on_it) ? 1 : 0;
        else if (std::ranges::none_of(laid->onto, [&](Id id) { return id >= before.next_id; }))
            ++elsewhere;
    }
    if (straight > 0) return "Its host is not in this scene, so it has its original shape.";
    if (elsewhere > 0) return "Its host is not in this scene, so it lies on the objects here.";
    if (in_place > 0)
        return "It lies on the same stroke as the original. Draw another stroke to move it.";
    return {};
}

void paste_copies(Session& session, Paste paste)
{
    const Document before = session.committed();
    Command command;
    bool aside = false;
    try {
        command = prepare(std::move(paste), *session.assets());
        aside = step_aside(*command.edit<Paste>(), session);
    } catch (const Rejected& why) {
        session.notices.say(ui::NoticeKind::warning, "Nothing was pasted", ui::sentence(why.what()),
                            of_clipboard);
        return;
    }
    if (!session.run(command)) return;
    session.select_new(before.next_id);
    if (before.objects.empty()) session.view.frame_all_when_evaluated = true;
    const std::vector<Id>& ids = session.selected.ids();
    std::string words = placed_words(before, session.committed(), command.get<Paste>());
    if (words.empty() && aside) words = "It was moved aside, because its place is taken.";
    session.notices.say(ui::NoticeKind::good,
                        said_of(session.document(), ids) +
                            (ids.size() == 1 ? " was pasted" : " were pasted"),
                        words, of_clipboard);
}

} // namespace

std::string said_of(const Document& document, const std::vector<Id>& ids)
{
    return ids.size() == 1 ? name_of(document, ids.front())
                           : std::to_string(ids.size()) + " objects";
}

std::string clipboard_text(const Session& session, const std::vector<Id>& ids)
{
    return to_json_line(copied(session.committed(), ids, session.assets()->folder())) + "\n";
}

void paste_text(Session& session, std::string_view text)
{
    std::vector<Command> commands;
    std::string why = "The clipboard holds no objects. Copy some first.";
    try {
        commands = commands_in(text);
    } catch (const Rejected& refused) {
        if (text.find("{\"do\":") != text.npos) why = ui::sentence(refused.what());
        commands.clear();
    }
    if (commands.empty())
        session.notices.say(ui::NoticeKind::warning, "Nothing was pasted", why, of_clipboard);
    else if (auto* paste = commands.front().edit<Paste>(); paste && commands.size() == 1)
        paste_copies(session, std::move(*paste));
    else
        run_lines(session, text);
}

} // namespace trivar
