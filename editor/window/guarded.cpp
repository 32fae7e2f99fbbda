// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/guarded.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "editor/help/about.h"
#include "editor/session/scene_facts.h"
#include "editor/session/topics.h"
#include "ui/closing.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fmt/chrono.h>
#include <vector>

namespace trivar {
namespace {

constexpr const char* of_mistake = "mistake"; // the topic of a notice

void remove_old(const std::filesystem::path& folder)
{
    constexpr std::size_t most = 20; // reports
    std::error_code ignored;
    std::vector<std::filesystem::path> all;
    for (const auto& each : std::filesystem::directory_iterator(folder, ignored))
        if (each.path().filename().string().starts_with("mistake ")) all.push_back(each.path());
    std::ranges::sort(all); // by their times
    for (std::size_t i = 0; i + most < all.size(); ++i) std::filesystem::remove(all[i], ignored);
}

// Writes a report, unless one with these words was written. Returns a sentence that says where.
std::string write_report(Editor& editor, const std::string& words)
{
    auto& reports = editor.memory.of<MistakeReports>();
    if (reports.folder.empty() || !reports.written.insert(words).second) return {};
    std::string text =
        about_text("") + "\n" + words + "\n\n" + editor.session.scene().path() + "\n";
    for (const std::string& line : editor.session.scene().lines()) text += line + "\n";
    const std::string path = fmt::format("{}/mistake {:%Y-%m-%d %H.%M.%S}.txt", reports.folder,
                                         fmt::localtime(std::time(nullptr)));
    try {
        std::filesystem::create_directories(reports.folder);
        write_bytes(path, text);
        remove_old(reports.folder);
        return "\nA report for the developers is in " + path + ".";
    } catch (const std::exception&) { // a full disk, for example
        return {};
    }
}

void tell_of(Editor& editor, const std::exception& trouble)
{
    const std::string words = words_of(trouble);
    if (!is_mistake(trouble))
        return editor.session.notices.say(ui::NoticeKind::warning, words, {}, of_a_step);
    editor.session.notices.say(ui::NoticeKind::error, words,
                               "The scene is as it was before." + write_report(editor, words),
                               of_mistake);
}

void let_go(Editor& editor)
{
    const auto attempt = [](auto&& work) {
        try {
            work();
        } catch (const std::exception&) { // it was told
        }
    };
    attempt([&] { editor.active_tool().cancel(editor.session); });
    attempt([&] { editor.session.cancel(); });
    if (editor.tool == 0) editor.session.selected = 0;
    editor.tool = 0;
    editor.inspecting = false;
}

} // namespace

bool do_guarded(Editor& editor, const std::function<void()>& part)
{
    if (editor.on_failure == OnFailure::pass_on) return part(), true;
    try {
        ui::draw_closing(part);
        return true;
    } catch (const Cancelled&) {
    } catch (const std::exception& trouble) {
        tell_of(editor, trouble);
    }
    let_go(editor);
    return false;
}

void tell_failed_steps(Editor& editor)
{
    Session& session = editor.session;
    auto& reports = editor.memory.of<MistakeReports>();
    if (std::exchange(reports.told_evaluation, session.evaluation()) == session.evaluation())
        return;
    const std::vector<FailedStep>& failed = session.evaluated().failed;
    if (failed.empty()) return session.notices.forget(of_mistake);
    for (const FailedStep& each : failed) {
        const std::string name = name_of(session.document(), each.object);
        std::string body = name + " is shown without the step, which is kept.";
        if (each.mistake)
            body += write_report(editor, fmt::format("{}: {} ({})", name, each.words, each.step));
        session.notices.say(ui::NoticeKind::error, each.words, body, of_mistake);
    }
}

} // namespace trivar
