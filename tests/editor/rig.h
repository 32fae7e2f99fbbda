// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/primitives.h"
#include "editor/actions/all_actions.h"
#include "editor/editor.h"
#include "editor/panels/panels.h"
#include "editor/window/draw_editor.h"
#include "ui/headless.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace trivar::testing {

// A Rig is the whole editor without a screen, driven by the mouse and keys of nobody. Its pictures
// are drafts of full size, as tests pick in them but hardly look at one; draw_whole() is for those
// that do.
struct Rig {
    explicit Rig(glm::ivec2 size = {720, 520}, const ui::ThemeOptions& options = {},
                 const std::string& unnamed_folder = {}, OnFailure on_failure = OnFailure::pass_on)
        : size_px(size),
          screen(size, options),
          editor([] {}, all_actions(), unnamed_folder, on_failure)
    {
        screen.draw_little();
        editor.preferences.quality = "draft";
    }
    glm::ivec2 size_px;
    ui::HeadlessFrames screen;
    Editor editor;

    ui::DrawFrame body()
    {
        return [this](ui::Frame& frame) { draw_editor(editor, frame); };
    }
    void draw_whole()
    {
        screen.draw_whole();
        editor.preferences.quality = Preferences{}.quality;
    }
    void frames(int count = 3) { screen.frames(count, body()); }
    // Until nothing works in the background any more.
    void wait()
    {
        using namespace std::chrono_literals;
        for (int i = 0; i < 2000; ++i) {
            frames(1);
            if (editor.session.up_to_date() && !editor.session.jobs().status() &&
                !editor.session.quiet_jobs().status() && !editor.session.committing()) {
                frames(2);
                return;
            }
            std::this_thread::sleep_for(5ms);
        }
        ADD_FAILURE() << "something still works in the background after ten seconds";
    }
    void key(const ui::Chord& chord)
    {
        if (chord.ctrl) screen.input().push(ui::press_key(ui::key_left_control));
        if (chord.shift) screen.input().push(ui::press_key(ui::key_left_shift));
        if (chord.alt) screen.input().push(ui::press_key(ui::key_left_alt));
        screen.input().push(ui::press_key(chord.key));
        screen.input().push(ui::press_key(chord.key, false));
        if (chord.alt) screen.input().push(ui::press_key(ui::key_left_alt, false));
        if (chord.shift) screen.input().push(ui::press_key(ui::key_left_shift, false));
        if (chord.ctrl) screen.input().push(ui::press_key(ui::key_left_control, false));
        frames(8);
    }
    void click(glm::vec2 at)
    {
        screen.input().push(ui::move_to(at));
        screen.input().push(ui::press(ui::Button::left));
        screen.input().push(ui::press(ui::Button::left, false));
        frames(4);
    }
    void move(glm::vec2 at)
    {
        screen.input().push(ui::move_to(at));
        frames(2);
    }
    void hold(int key, bool down = true)
    {
        screen.input().push(ui::press_key(key, down));
        frames(2);
    }
    void type(const std::string& text)
    {
        for (const char c : text) screen.input().push(ui::type_text(static_cast<unsigned char>(c)));
        frames(3);
    }
    // Returns the place of a point of the scene in the window.
    glm::vec2 seen_at(const glm::dvec3& p_world) const
    {
        return layout().view.lo + glm::vec2(project(editor.session.view.camera, p_world).p_px);
    }
    void draw(const std::vector<glm::vec2>& path, bool let_go = true)
    {
        screen.input().push(ui::move_to(path.front(), 0));
        screen.input().push(ui::press(ui::Button::left));
        frames(3);
        double time_s = 0;
        for (std::size_t i = 1; i < path.size(); ++i)
            for (int k = 1; k <= 8; ++k) {
                const float t = static_cast<float>(k) / 8;
                screen.input().push(ui::move_to(glm::mix(path[i - 1], path[i], t), time_s += 0.01));
                frames(1);
            }
        if (let_go) screen.input().push(ui::press(ui::Button::left, false));
        frames(3);
    }
    // Makes pictures small too, for tests that pick nothing in them.
    void draw_small()
    {
        editor.preferences.pace = "240";
        editor.preferences.hints = false; // a card of them lies over the view
    }
    Layout layout() const
    {
        return layout_of(screen.theme(), glm::vec2(size_px), editor.preferences,
                         editor.tools.size());
    }
    std::size_t steps() const { return editor.session.scene().history().position(); }

    // A wide plane and a small box above it, seen from the front and above.
    void two_objects()
    {
        AddPlane plane;
        plane.shape.size = {6, 6};
        ASSERT_TRUE(editor.session.run(plane));
        AddBox box;
        box.shape.size = {1.2, 0.3, 0.3};
        box.transform.translation = {0, 0, 1};
        ASSERT_TRUE(editor.session.run(box));
        editor.session.selected = 2;
        editor.session.view.camera.eye = {0.5, -6, 4};
        editor.session.view.camera.target = {0, 0, 0};
        wait();
    }
    std::vector<glm::vec2> stroke() const
    {
        const glm::vec2 c = layout().view.center();
        return {c + glm::vec2(-140, 40), c + glm::vec2(0, 10), c + glm::vec2(140, 40)};
    }
};

} // namespace trivar::testing
