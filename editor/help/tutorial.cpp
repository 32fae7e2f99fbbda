// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/help/tutorial.h"

#include "core/base/smooth_step.h"
#include "core/commands/every_command.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/view.h"
#include "core/commands/placement/place.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

namespace trivar {
namespace {

constexpr double flight_s = 0.6, gesture_s = 1.2;
constexpr std::size_t fewest_samples = 3; // that make a stroke

const Sketch* sketch_of(const Command& command)
{
    if (const auto* place = command.as<Place>()) return &place->sketch;
    const auto* edit = command.as<EditPlacement>();
    return edit && edit->sketch ? &*edit->sketch : nullptr;
}

// Where a hand looked from when it did this, if it says.
const Camera* camera_of(const Command& command)
{
    if (const Sketch* sketch = sketch_of(command)) return &sketch->camera;
    const auto* kept = command.as<KeepView>();
    return kept ? &kept->camera : nullptr;
}

const Camera* last_camera(const History& history, std::size_t position)
{
    for (std::size_t i = std::min(position, history.steps().size()); i-- > 0;)
        if (const Camera* camera = camera_of(history.steps()[i].command)) return camera;
    return nullptr;
}

Sketch begun(const Sketch& sketch, double done)
{
    const auto all = static_cast<double>(sketch.samples.size());
    const auto count = static_cast<std::size_t>(std::ceil(all * std::clamp(done, 0.0, 1.0)));
    Sketch part = sketch;
    part.samples.resize(std::min(std::max(count, fewest_samples), sketch.samples.size()));
    return part;
}

Transform mixed(const Transform& a, const Transform& b, double t)
{
    return {glm::mix(a.translation, b.translation, t), glm::mix(a.rotation_deg, b.rotation_deg, t),
            glm::mix(a.scale, b.scale, t)};
}

Camera mixed(const Camera& a, const Camera& b, double t)
{
    if (a.perspective != b.perspective) return b;
    Camera camera = b;
    camera.eye = glm::mix(a.eye, b.eye, t);
    camera.target = glm::mix(a.target, b.target, t);
    camera.up = glm::normalize(glm::mix(a.up, b.up, t));
    camera.fov_y = std::lerp(a.fov_y, b.fov_y, t);
    camera.height_world = std::lerp(a.height_world, b.height_world, t);
    return camera;
}

// Selects the objects that a step changed, as a hand would have left it.
void select_what_was_done(Session& session, std::size_t step)
{
    const History& history = session.scene().history();
    const History::Step& done = history.steps()[step - 1];
    const Document& before = step == 1 ? history.start() : history.steps()[step - 2].result;
    if (done.result.next_id > before.next_id) return session.select_new(before.next_id);
    visit(
        [&](const auto& c) {
            if constexpr (requires { c.object; })
                session.selected = c.object;
            else if constexpr (requires { c.objects; })
                session.selected.set(c.objects);
        },
        done.command);
}

} // namespace

std::optional<Command> part_of(const Command& command, const Document& before, double done)
{
    const auto transform_of = [&](Id id) { return object(before, id).transform; };
    const double t = smooth_step(done);
    if (const Sketch* sketch = sketch_of(command)) {
        Command part = command;
        if (auto* place = part.edit<Place>())
            place->sketch = begun(*sketch, done);
        else
            part.edit<EditPlacement>()->sketch = begun(*sketch, done);
        return part;
    }
    if (const auto* c = command.as<SetTransform>())
        return SetTransform{c->object, mixed(transform_of(c->object), c->transform, t)};
    if (const auto* c = command.as<Arrange>()) {
        Arrange part = *c;
        for (std::size_t i = 0; i < part.objects.size() && i < part.transforms.size(); ++i)
            part.transforms[i] = mixed(transform_of(part.objects[i]), c->transforms[i], t);
        return part;
    }
    return std::nullopt;
}

void Tutorial::begin(Session& session, std::string title)
{
    title_ = std::move(title);
    scene_ = session.scenes();
    count_ = session.scene().history().steps().size();
    motion_.reset();
    session.view.go_to.reset();
    session.view.follows.reset();
    show(session, std::min<std::size_t>(1, count_));
    session.view.frame_all_when_evaluated = !session.view.go_to;
}

void Tutorial::close(Session& session)
{
    if (runs(session)) finish(session);
    scene_ = -1;
}

bool Tutorial::runs(const Session& session) const
{
    return scene_ == session.scenes();
}

std::size_t Tutorial::step(const Session& session) const
{
    return motion_ ? motion_->to : session.scene().history().position();
}

const std::string& Tutorial::note(const Session& session) const
{
    static const std::string none;
    const auto& steps = session.scene().history().steps();
    const std::size_t at = step(session);
    const bool own = steps.size() != count_ || at == 0 || steps[at - 1].note.empty();
    return own ? none : steps[at - 1].note;
}

void Tutorial::show(Session& session, std::size_t step)
{
    session.look_at_step(step);
    if (const Camera* camera = last_camera(session.scene().history(), step))
        session.view.go_to = *camera;
    if (step > 0) select_what_was_done(session, step);
}

void Tutorial::finish(Session& session)
{
    const std::optional<Motion> motion = std::exchange(motion_, std::nullopt);
    if (!motion) return;
    session.cancel();
    session.look_at_step(motion->to);
    if (motion->goal) session.view.go_to = *motion->goal;
    select_what_was_done(session, motion->to);
}

void Tutorial::next(Session& session, bool at_once)
{
    finish(session);
    const History& history = session.scene().history();
    const std::size_t to = history.position() + 1;
    if (to > history.steps().size()) return;
    if (at_once) return show(session, to);
    motion_ = Motion{.to = to, .began_s = {}, .from = session.view.camera, .set = {}, .goal = {}};
    if (const Camera* camera = camera_of(history.steps()[to - 1].command)) motion_->goal = *camera;
}

void Tutorial::back(Session& session)
{
    finish(session);
    const std::size_t position = session.scene().history().position();
    if (position > 1) show(session, position - 1);
}

bool Tutorial::advance(Session& session, double time_s, bool at_once)
{
    if (!motion_ || !runs(session)) return false;
    Motion& m = *motion_;
    const History& history = session.scene().history();
    if (at_once || m.to > history.steps().size() || history.position() != m.to - 1) {
        finish(session);
        return false;
    }
    if (!m.began_s) {
        m.began_s = time_s;
        m.from = m.set = session.view.camera;
    }
    if (session.view.camera != m.set) m.goal.reset(); // somebody looks round
    const double passed = time_s - *m.began_s;
    if (m.goal) {
        const Camera goal = ui::reshaped(*m.goal, session.view.camera.size_px);
        session.view.camera = mixed(m.from, goal, smooth_step(passed / flight_s));
        session.view.camera.size_px = m.from.size_px;
        m.set = session.view.camera;
        if (passed < flight_s) return true;
    }
    const Command& command = history.steps()[m.to - 1].command;
    const double gone = passed - (camera_of(command) ? flight_s : 0);
    m.done = std::clamp(gone / gesture_s, 0.0, 1.0);
    const std::optional<Command> part = part_of(command, session.committed(), m.done);
    if (!part || m.done == 1) {
        finish(session);
        return false;
    }
    // One piece at a time: the next waits until the last one can be seen.
    if (session.up_to_date()) session.propose_quietly(*part);
    return true;
}

std::vector<glm::dvec2> Tutorial::stroke(const Session& session) const
{
    if (!motion_ || !runs(session) || motion_->done <= 0) return {};
    const auto& steps = session.scene().history().steps();
    if (motion_->to > steps.size()) return {};
    const Sketch* sketch = sketch_of(steps[motion_->to - 1].command);
    if (!sketch) return {};
    std::vector<glm::dvec2> path;
    for (const StrokeSample& sample : begun(*sketch, motion_->done).samples)
        path.push_back(
            project(session.view.camera, ui::point_at_target_depth(sketch->camera, sample.p_px))
                .p_px);
    return path;
}

std::vector<std::string> tutorials_in(const std::string& folder)
{
    constexpr std::array<std::string_view, 5> first{"first_stroke", "one_on_another", "arranging",
                                                    "in_a_lattice", "painting_tiles"};
    const auto rank = [&](const std::string& path) {
        return std::ranges::find(first, std::filesystem::path(path).stem().string()) -
               first.begin();
    };
    std::vector<std::string> found;
    std::error_code ignored;
    for (const auto& each : std::filesystem::directory_iterator(folder, ignored))
        if (each.path().extension() == ".trivar") found.push_back(each.path().string());
    std::ranges::sort(found, [&](const std::string& a, const std::string& b) {
        return rank(a) != rank(b) ? rank(a) < rank(b) : a < b;
    });
    return found;
}

} // namespace trivar
