// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/hands/hand_laws.h"

#include "core/base/finite.h"
#include "core/base/text.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/scene/log.h"
#include "tests/fuzz/campaign.h"
#include "tests/fuzz/hands/closed_bodies.h"
#include "tests/fuzz/log_use.h"
#include "tests/fuzz/promises.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <sstream>

namespace trivar::testing {
namespace {

constexpr std::size_t most_vertices = 300000; // of shapes that are looked at one by one

std::size_t vertices_of(const EvaluatedObject& object)
{
    std::size_t count = 0;
    for (const Part& part : object.parts) count += part.vertex_count();
    return count;
}

std::size_t vertices_of(const Evaluation& shown)
{
    std::size_t count = 0;
    for (const auto& [id, object] : shown.objects) count += vertices_of(*object);
    return count;
}

void check_lines(const std::string& text)
{
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) check_sentences({line});
}

void expect_same(const std::string& now, const std::string& then, const char* what)
{
    if (now != then) throw Broken(what);
}

// The shapes of all that is shown, by its own evaluation.
std::map<Id, std::string> digests_of(const Evaluation& shown)
{
    std::map<Id, std::string> out;
    for (const auto& each : shown.objects) {
        Evaluation one;
        one.objects.insert(each);
        out.emplace(each.first, digest(one));
    }
    return out;
}

} // namespace

HandLaws::HandLaws(Hand& hand) : hand_(hand)
{
    check(false);
}

std::optional<HandLaws::Shapes> HandLaws::shapes() const
{
    const Session& session = hand_.editor().session;
    const bool as_committed = !session.previewing() && !session.proposing();
    if (!session.up_to_date() || !as_committed || hand_.editor().playback.playing() ||
        vertices_of(session.evaluated()) > most_vertices)
        return {};
    return digests_of(session.evaluated());
}

void HandLaws::expect_shapes(const std::optional<Shapes>& then, const std::string& what) const
{
    const std::optional<Shapes> now = shapes();
    if (!now || !then || *now == *then) return;
    std::string which;
    for (const auto& [id, each] : *then)
        if (!now->contains(id) || now->at(id) != each) which += fmt::format(" {}", id);
    for (const auto& [id, each] : *now)
        if (!then->contains(id)) which += fmt::format(" {}", id);
    throw Broken(fmt::format("{}: objects{}", what, which));
}

void HandLaws::check(bool thoroughly)
{
    check_words();
    check_at_rest();
    check_document();
    check_shapes();
    check_way_back();
    check_past();
    if (thoroughly) check_evaluation();
}

void HandLaws::check_words() const
{
    const Session& session = hand_.editor().session;
    for (const ui::Notices::Notice& each : session.notices.all()) {
        check_lines(each.title);
        check_lines(each.body);
    }
    for (const auto& [id, object] : session.evaluated().objects) check_sentences(object->notices);
}

// A proposal belongs to a gesture, a field or a dialog that has not ended.
void HandLaws::check_at_rest() const
{
    Editor& editor = hand_.editor();
    const bool popup =
        ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (!editor.session.proposing() || editor.active_tool().busy() || popup ||
        ImGui::IsAnyItemActive() || editor.palette.open || editor.files.asking() ||
        editor.timeline.keys.gesture.by_key ||
        editor.active_tool().name() == "Split") // which shows what a click would do
        return;
    const auto& proposal = editor.session.scene().history().proposal();
    throw Broken(fmt::format("{} is proposed, and nothing is going on", verb(proposal->command)));
}

void HandLaws::check_document() const
{
    const SceneFile& scene = hand_.editor().session.scene();
    check_history(scene.history());
    std::string lines;
    for (const std::string& line : scene.lines()) lines += line + '\n';
    const std::string now = digest(scene.history().committed());
    const auto check = [&](const std::string& text, const char* what) {
        promised(what,
                 [&] { expect_same(digest(replay(read_log(text, "log")).document()), now, what); });
    };
    check(lines, "the lines of the scene give another document");
    if (!scene.path().empty() && scene.trouble().empty() && std::filesystem::exists(scene.path()))
        check(read_text_file(scene.path()), "the scene's file gives another document");
}

void HandLaws::check_past()
{
    const Session& session = hand_.editor().session;
    const History& history = session.scene().history();
    if (std::exchange(scene_, session.scenes()) != session.scenes()) known_.clear(), start_.clear();
    const std::string start = digest(history.start());
    if (!start_.empty()) expect_same(start, start_, "the beginning of the scene has changed");
    start_ = start;
    std::vector<KnownStep> now;
    bool same = true;
    for (std::size_t i = 0; i < history.position(); ++i) {
        const History::Step& step = history.steps()[i];
        now.push_back({step.command, digest(step.result)});
        same = same && i < known_.size() && known_[i].command == step.command;
        if (same) expect_same(now[i].digest, known_[i].digest, "a step of the past has changed");
    }
    known_ = std::move(now);
    shapes_ = shapes();
    frame_ = session.frame();
}

void HandLaws::check_shapes() const
{
    const Session& session = hand_.editor().session;
    for (const auto& [id, object] : session.evaluated().objects) {
        if (vertices_of(*object) > most_vertices) continue;
        for (const Part& part : object->parts)
            if (!std::ranges::all_of(part.mesh()->positions, finite<glm::vec3>))
                throw Broken("what is shown has positions that are not finite");
        const auto found = session.shown().objects.find(id);
        if (found == session.shown().objects.end()) continue;
        if (const std::string open = open_part(*found->second, *object); !open.empty())
            throw Broken(open);
    }
}

// Undoes the steps that came since the last check, and does them again.
void HandLaws::check_way_back()
{
    constexpr std::size_t most_steps = 20;
    Session& session = hand_.editor().session;
    const History& history = session.scene().history();
    const std::size_t before = known_.size(), now = history.position();
    const auto is_known = [&](std::size_t i) {
        return history.steps()[i].command == known_[i].command;
    };
    if (scene_ != session.scenes() || now <= before || now - before > most_steps ||
        session.scene().look_only() || session.scene().history().proposal())
        return;
    for (std::size_t i = 0; i < before; ++i)
        if (!is_known(i)) return;
    const bool still = frame_ == session.frame();
    const std::string after = digest(history.committed());
    const std::optional<Shapes> shapes_after = shapes();
    for (std::size_t i = before; i < now; ++i) session.undo();
    if (history.position() != before) throw Broken("a step is not undone");
    hand_.settle();
    expect_same(digest(history.committed()), before > 0 ? known_.back().digest : start_,
                "undo gives another document than there was");
    if (still && session.frame() == frame_)
        expect_shapes(shapes_, "undo gives other shapes than there were");
    for (std::size_t i = before; i < now; ++i) session.redo();
    if (history.position() != now) throw Broken("a step is not done again");
    hand_.settle();
    expect_same(digest(history.committed()), after, "redo gives another document than there was");
    if (still && session.frame() == frame_)
        expect_shapes(shapes_after, "redo gives other shapes than there were");
}

void HandLaws::check_evaluation() const
{
    const Session& session = hand_.editor().session;
    if (!shapes()) return;
    Evaluator anew(session.assets());
    expect_shapes(digests_of(anew(session.shown(), session.frame())),
                  "a new evaluation gives other shapes");
}

} // namespace trivar::testing
