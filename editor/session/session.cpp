// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/session.h"

#include "core/base/rejected.h"
#include "core/commands/keying.h"
#include "core/commands/placement/place.h"
#include "core/document/parameters.h"
#include "core/placement/placement.h"
#include "core/steps/laying/attaching.h"
#include "editor/jobs/background_evaluator.h"
#include "editor/picture/picture.h"
#include "editor/session/level_draft.h"
#include "editor/session/scene_facts.h"
#include "editor/session/scene_names.h"
#include "editor/session/selection.h"
#include "editor/session/topics.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <utility>

namespace trivar {

constexpr const char* of_missing = "what cannot be shown"; // the topic of a notice

Session::Session(std::function<void()> wake, std::string unnamed_folder, OnFailure on_failure)
    : wake_(std::move(wake)),
      on_failure_(on_failure),
      unnamed_folder_(std::move(unnamed_folder)),
      jobs_(wake_),
      quiet_jobs_(wake_)
{
    scene_.keep_in(unnamed_folder_);
    meet_document();
}

Session::~Session() = default;

void Session::meet_document()
{
    evaluator_.reset(); // before the store it reads from
    assets_ = std::make_shared<const AssetStore>(scene_.folder());
    evaluator_ = std::make_unique<BackgroundEvaluator>(assets_, wake_, on_failure_);
    check_.reset();
    asked_ticket_ = evaluated_ticket_ = 0;
    refresh();
}

void Session::refresh()
{
    previewed_.reset();
    const std::optional<Document> draft =
        scene_.history().proposal() ? level_draft(committed(), scene_.document(), evaluated_)
                                    : std::nullopt;
    drafted_ = draft.has_value();
    asked_ticket_ = submit(draft ? *draft : scene_.document());
    look_at_frame();
    selected.keep_those_in(scene_.document());
    std::erase_if(hidden_here, [&](Id id) { return !scene_.document().objects.contains(id); });
    if (scene_.trouble() == told_trouble_) return;
    told_trouble_ = scene_.trouble();
    if (told_trouble_.empty()) return notices.forget(of_saving); // it is on disk now
    notices.say(ui::NoticeKind::error, "Not saved", told_trouble_, of_saving);
    notices.keep(of_saving);
}

long Session::submit(const Document& document)
{
    frame_ = std::clamp(frame_, document.time.first_frame, document.time.last_frame);
    be_at_work(true);
    return evaluator_->submit(document, frame_, deform_on_processor);
}

void Session::look_at_frame()
{
    replaced_.push_back(std::exchange(now_, document_at(scene_.document(), frame_)));
}

Command Session::said(const Command& command) const
{
    return keyed(committed(), command, frame_, auto_key);
}

void Session::show_frame(int frame)
{
    const Document& document = previewed_ ? *previewed_ : scene_.document();
    const int before = frame_;
    frame_ = std::clamp(frame, document.time.first_frame, document.time.last_frame);
    if (frame_ == before || !moves_in_time(document)) return;
    asked_ticket_ = submit(document);
    look_at_frame();
}

template <class Change> bool Session::attempt(Change&& change)
{
    try {
        change();
    } catch (const Rejected& why) {
        notices.say(ui::NoticeKind::warning, why.what(), {}, of_a_step);
        return false;
    }
    refresh();
    return true;
}

void Session::refuse(const Command& command, const std::string& why)
{
    const std::size_t after = scene_.lines().size();
    std::string line = to_json_line(command);
    // A hand that goes on moving asks for the same again and again.
    if (!refused_.empty() && refused_.back().after == after && refused_.back().why == why)
        refused_.back().line = std::move(line);
    else
        refused_.push_back({after, std::move(line), why});
}

bool Session::propose(Command command)
{
    return try_propose(command, false);
}

bool Session::propose_quietly(Command command)
{
    return try_propose(command, true);
}

// A refused command changes nothing, also where it becomes keys of a track.
bool Session::try_propose(const Command& command, bool quietly)
{
    check_.reset();
    try {
        const Command now = said(command);
        if (is_proposed(now)) return true;
        scene_.propose(now);
    } catch (const Rejected& why) {
        if (!quietly) {
            refuse(command, why.what());
            notices.say(ui::NoticeKind::warning, why.what(), {}, of_a_step);
        }
        return false;
    }
    refresh();
    return true;
}

// A hand that rests proposes the same in every frame, which is nothing to be evaluated.
bool Session::is_proposed(const Command& command) const
{
    const std::optional<History::Step>& proposal = scene_.history().proposal();
    return proposal && proposal->command == command;
}

bool Session::commit()
{
    check_.reset();
    return attempt([&] { scene_.commit(); });
}

void Session::commit_if_placed(Id object)
{
    if (!proposing()) return;
    check_ = asked_ticket_;
    checked_ = object;
    finish_check();
}

// Attaches the proposed stroke to the objects on which it was drawn.
void Session::attach_proposal(const EvaluatedObject& laid)
{
    const std::optional<History::Step>& proposal = scene_.history().proposal();
    if (!proposal) return;
    Command command = proposal->command;
    if (auto* place = command.edit<Place>())
        place->attach = attachment_of(laid, place->sketch, place->parameters.skip_back_faces);
    else if (auto* edit = command.edit<EditPlacement>(); edit && edit->sketch)
        edit->attach = attachment_of(laid, *edit->sketch, edit->parameters.skip_back_faces);
    else
        return;
    try {
        scene_.propose(command);
    } catch (const Rejected&) {
        return; // it stays in the world, as it was proposed
    }
    refresh();
}

void Session::finish_check()
{
    if (!check_ || evaluated_ticket_ < *check_) return;
    check_.reset();
    const Id object_id = checked_;
    const auto found = evaluated_.objects.find(object_id);
    if (found == evaluated_.objects.end() || !found->second->placement) {
        std::string why = "The stroke could not be used.";
        if (found != evaluated_.objects.end() && !found->second->notices.empty())
            why = found->second->notices.front();
        if (scene_.history().proposal()) refuse(scene_.history().proposal()->command, why);
        cancel();
        notices.say(ui::NoticeKind::warning, "Nothing was placed", why, of_a_step);
        return;
    }
    const Ref<EvaluatedObject> object_now = found->second;
    const bool laid = scene_.history().proposal()->command.is<Place>();
    attach_proposal(*object_now);
    const Document& proposed = scene_.document();
    if (committed().objects.contains(object_id) && proposed.next_id == committed().next_id &&
        object(proposed, object_id) == object(committed(), object_id))
        return cancel(); // a drag that came back to where it began is no step
    if (!commit()) return;
    notices.forget(of_a_step);
    if (warnings_beside && selected == object_id) return;
    const std::vector<std::string> lines = object_now->stroke_placement()->report.all_notices();
    if (!lines.empty())
        notices.say_all(ui::NoticeKind::warning,
                        name_of(document(), object_id) + (laid ? " was placed" : " was changed"),
                        lines, of_a_step);
}

void Session::cancel()
{
    check_.reset();
    if (!proposing()) return;
    scene_.cancel();
    refresh();
}

bool Session::run(const Command& command)
{
    const std::string why = try_run(command);
    if (!why.empty()) notices.say(ui::NoticeKind::warning, why, {}, of_a_step);
    return why.empty();
}

std::string Session::try_run(const Command& command, const std::string& note)
{
    check_.reset();
    const Document before = committed();
    const std::vector<Id> were = selected.ids();
    try {
        scene_.run(said(command), note);
    } catch (const Rejected& why) {
        refuse(command, why.what());
        return why.what();
    }
    refresh();
    select_freed(before, were);
    return {};
}

void Session::undo()
{
    if (committing()) return cancel(); // the last thing done is what is still being looked at
    const Document before = committed();
    const std::vector<Id> were = selected.ids();
    attempt([&] { scene_.undo(); });
    select_returned(before);
    select_freed(before, were);
}

void Session::redo()
{
    check_.reset();
    const Document before = committed();
    const std::vector<Id> were = selected.ids();
    attempt([&] { scene_.redo(); });
    select_returned(before);
    select_freed(before, were);
}

void Session::select_returned(const Document& before)
{
    std::vector<Id> ids;
    for (const auto& [id, each] : document().objects)
        if (!before.objects.contains(id)) ids.push_back(id);
    // Objects that came back hidden came along with the others.
    if (std::ranges::any_of(ids, [&](Id id) { return visible(document(), id); }))
        std::erase_if(ids, [&](Id id) { return !visible(document(), id); });
    if (!ids.empty()) selected.set(topmost(document(), ids));
}

// Where all that was selected is gone, what it held and that is still there.
void Session::select_freed(const Document& before, const std::vector<Id>& were)
{
    if (selected != 0) return;
    std::vector<Id> ids;
    for (const auto& [id, each] : before.objects)
        if (std::ranges::find(were, each->parent) != were.end() && document().objects.contains(id))
            ids.push_back(id);
    if (!ids.empty()) selected.set(ids);
}

void Session::select_new(Id first)
{
    std::vector<Id> ids;
    for (const auto& [id, each] : document().objects)
        if (id >= first) ids.push_back(id);
    if (!ids.empty()) selected.set(topmost(document(), ids));
}

void Session::go_to_step(std::size_t position)
{
    check_.reset();
    attempt([&] {
        while (scene_.history().position() > position && scene_.undo()) {
        }
        while (scene_.history().position() < position && scene_.redo()) {
        }
    });
}

void Session::go_to_branch(std::size_t branch, std::size_t count)
{
    if (branch >= scene_.history().branches().size()) return;
    const History::Branch wanted = scene_.history().branches()[branch];
    go_to_step(wanted.from);
    if (!run(wanted.steps.front().command)) return;
    go_to_step(wanted.from + count);
}

void Session::preview(const Document* document)
{
    if (committing() || proposing()) return;
    if (!document) {
        if (previewed_) refresh();
        return;
    }
    // Documents that share all objects and settings look alike.
    if (previewed_ && previewed_->render == document->render &&
        previewed_->time == document->time &&
        std::ranges::equal(previewed_->objects, document->objects))
        return;
    previewed_ = *document;
    asked_ticket_ = submit(*document);
}

void Session::look_at_step(std::size_t position)
{
    if (!scene_.as_opened()) return go_to_step(position);
    check_.reset();
    scene_.cancel();
    scene_.look_at(position);
    refresh();
}

void Session::replace_scene(SceneFile scene, std::vector<ui::Notices::Action> offers)
{
    const bool discarded = scene_.path().empty() && !scene_.as_opened();
    scene_ = std::move(scene);
    notices.clear(); // of the scene before
    frame_ = scene_.document().time.first_frame;
    if (discarded && when_discarded) when_discarded();
    ++scenes_;
    scene_.keep_in(unnamed_folder_);
    selected = 0;
    hidden_here.clear();
    refused_.clear();
    evaluated_ = {};
    ++evaluation_;
    told_trouble_.clear();
    opened_ = true;
    take_back_deadly_steps();
    meet_document();
    const auto& kept_views = document().kept_views;
    const auto picture = kept_views.find("picture");
    view.frame_all_when_evaluated = picture == kept_views.end();
    view.go_to.reset();
    view.follows.reset();
    if (picture != kept_views.end()) view.follows = FollowedView{"picture"};
    const std::vector<std::string>& said = scene_.notices();
    if (said.size() == 1)
        notices.say(ui::NoticeKind::warning, said.front(), {}, {}, std::move(offers));
    if (said.size() > 1)
        notices.say_all(ui::NoticeKind::warning, title_of(scene_) + " is open", said);
}

std::vector<Id> Session::not_shown() const
{
    std::vector<Id> out;
    for (const auto& [id, effects] : evaluated_.objects)
        if (effects->shows_nothing() && !effects->placement && !effects->notices.empty())
            out.push_back(id);
    return out;
}

// A scene whose models are gone opens as an empty picture: say why, until they are found.
void Session::tell_what_is_missing()
{
    const std::vector<Id> ids = not_shown();
    const bool first = std::exchange(opened_, false); // else it was told
    if (ids.empty()) notices.forget(of_missing);
    if (ids.empty() || !first) return;
    const std::size_t count = ids.size();
    notices.say(ui::NoticeKind::error,
                count == 1 ? "An object cannot be shown"
                           : std::to_string(count) + " objects cannot be shown",
                name_of(document(), ids.front()) + ": " +
                    evaluated_.objects.at(ids.front())->notices.front() +
                    (count > 1 ? "; select one to see why in the inspector" : ""),
                of_missing, missing_remedies);
}

void Session::poll()
{
    replaced_.clear();
    jobs_.poll();
    quiet_jobs_.poll();
    if (auto result = evaluator_->poll()) {
        evaluated_ticket_ = result->ticket;
        if (result->problem.empty()) {
            if (!result->evaluated.timings.stages.empty()) timings_ = result->evaluated.timings;
            evaluated_ = std::move(result->evaluated);
            ++evaluation_;
        } else {
            check_.reset();
            if (result->mistake) std::rethrow_exception(result->mistake);
            if (result->stopped)
                notices.say(
                    ui::NoticeKind::warning, "Stopped", result->problem, of_a_step,
                    {{"Undo the step", [this] { undo(); }}, {"Continue", [this] { refresh(); }}});
            else
                notices.say(ui::NoticeKind::error, "The scene could not be evaluated",
                            result->problem);
        }
        if (up_to_date()) tell_what_is_missing();
        if (view.frame_all_when_evaluated && up_to_date() && !evaluated_.objects.empty()) {
            view.frame_all_when_evaluated = false;
            view.camera = ui::framed(view.camera, points_of(evaluated_, hidden_here), view.foot_px);
        }
    }
    if (drafted_ && up_to_date()) { // the hand rests
        drafted_ = false;
        asked_ticket_ = submit(scene_.document());
    }
    finish_check();
}

} // namespace trivar
