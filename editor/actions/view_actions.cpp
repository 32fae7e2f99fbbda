// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/view_actions.h"

#include "core/commands/objects/view.h"
#include "editor/actions/chords.h"
#include "editor/actions/menu.h"
#include "editor/editor.h"
#include "editor/session/session_facts.h"
#include "ui/camera_control.h"

#include <array>

namespace trivar {
namespace {

constexpr ui::Chord keypad(int digit, bool with_ctrl = false)
{
    return {.key = ui::key_keypad_0 + digit, .ctrl = with_ctrl};
}

constexpr ui::Chord alt_shift(int key)
{
    return {.key = key, .shift = true, .alt = true};
}

void open_tab(Editor& e, Editor::Tab tab)
{
    e.tab = tab;
    e.preferences.show_dock = true;
    e.only_view = false;
}

// Adds the tolerances with which the window shows placed objects; the scene and its pictures know
// nothing of them.
void add_view_tolerances(std::vector<Action>& a)
{
    const Menu detail(a, "Detail");
    const auto tolerance = [&](const char* name, const char* value) {
        detail(name, {}, [value](Editor& e) { e.preferences.view_tolerance = value; },
               {[value](const Editor& e) { return e.preferences.view_tolerance != value; },
                "already on"})
            .on = [value](const Editor& e) { return e.preferences.view_tolerance == value; };
    };
    tolerance("Original triangles", "off");
    tolerance("Triangles within 2 px", "2");
    tolerance("Triangles within 1 px", "1");
    tolerance("Triangles within 0.5 px", "0.5");
}

} // namespace

void add_view_actions(std::vector<Action>& a)
{
    const Menu view(a, "View");
    const Menu shading_menu(a, "Shading");
    const Menu viewpoint(a, "Viewpoint");
    constexpr std::array digits{'1', '3', '7'};
    for (std::size_t i = 0; i < viewpoints().size(); ++i) {
        const int digit = digits[i % digits.size()];
        const bool opposite = i >= digits.size();
        viewpoint(viewpoints()[i].name,
                  {opposite ? alt_shift(digit) : alt(digit), keypad(digit - '0', opposite)},
                  [i](Editor& e) { e.session.view.look_from(viewpoints()[i].from); });
    }
    viewpoint("Perspective", {alt('5'), keypad(5)}, [](Editor& e) {
        Camera& camera = e.session.view.camera;
        camera = ui::with_perspective(camera, !camera.perspective);
        e.session.view.flat_till_turned = false;
    }).on = [](const Editor& e) { return e.session.view.camera.perspective; };
    viewpoint("Render camera", {keypad(0)},
              [](Editor& e) { e.session.view.follows = FollowedView{"picture"}; },
              {[](const Editor& e) { return e.session.document().kept_views.contains("picture"); },
               "there is no render camera"});
    const auto shading = [&](const char* name, const ui::Chord& key, bool Shading::*part) {
        shading_menu(name, {key}, [part](Editor& e) { e.shading.*part = !(e.shading.*part); }).on =
            [part](const Editor& e) { return e.shading.*part; };
    };
    shading("Wireframe", {'Z'}, &Shading::wireframe);
    shading("X-ray", alt('Z'), &Shading::see_through);
    shading("Edges over surfaces", {.key = 'Z', .shift = true}, &Shading::edges);
    const auto colored_by = [&](const char* name, ColorBy by) {
        const auto so = [by](const Editor& e) {
            return e.session.document().render->color_by == by;
        };
        shading_menu(name, {},
                     [by](Editor& e) {
                         RenderSettings settings = *e.session.document().render;
                         settings.color_by = by;
                         e.session.run(SetRender{settings});
                     },
                     {[so](const Editor& e) { return !so(e); }, "already on"})
            .on = so;
    };
    colored_by("Colour by material", ColorBy::material);
    a.back().group_begins = true;
    colored_by("Colour by stretch", ColorBy::stretch);
    colored_by("Colour by error", ColorBy::error);
    colored_by("Colour by UV angles", ColorBy::uv_angles);
    colored_by("Colour by UV areas", ColorBy::uv_areas);
    colored_by("UV checker", ColorBy::uv_checker);
    add_view_tolerances(a);
    view(
        "Frame selection", {{ui::key_period}, {'F'}},
        [](Editor& e) {
            e.session.view.camera =
                ui::framed(e.session.view.camera, points_of(e.session, e.session.selected.ids()),
                           e.session.view.foot_px);
        },
        something_there());
    view(
        "Frame all", {{ui::key_home}},
        [](Editor& e) {
            if (e.timeline.hovered)
                e.timeline.shown.reset();
            else
                e.session.view.camera = ui::framed(e.session.view.camera, points_of(e.session, {}),
                                                   e.session.view.foot_px);
        },
        something_there());
    view(
        "Bookmark view", {},
        [](Editor& e) {
            std::string name;
            int n = 1;
            do name = "View " + std::to_string(n++);
            while (e.session.document().kept_views.contains(name));
            if (e.session.run(KeepView{name, e.session.view.camera}))
                e.session.notices.say(ui::NoticeKind::good, name + " was bookmarked",
                                      "It is in the View menu.");
        },
        {}, true);
    view("Set render camera to view", {}, [](Editor& e) {
        if (e.session.run(KeepView{"picture", camera_for_pictures(e.session)}))
            e.session.notices.say(ui::NoticeKind::good, "View bookmarked",
                                  "Replayed pictures and this scene open in it.");
    });
}

void add_window_actions(std::vector<Action>& a)
{
    const Menu interface(a, "Interface");
    const Menu view(a, "View");
    view(
        "Side panels", {{'N'}},
        [](Editor& e) { e.preferences.show_dock = !e.preferences.show_dock; }, {}, true)
        .on = [](const Editor& e) { return e.preferences.show_dock; };
    view("History", {}, [](Editor& e) { open_tab(e, Editor::Tab::history); });
    view("Log", {}, [](Editor& e) { open_tab(e, Editor::Tab::log); });
    view("Next panel", {{ui::key_f1 + 5}}, [](Editor& e) {
        using Panel = Editor::Panel;
        e.show_focus = true;
        e.preferences.show_dock = true;
        e.only_view = false;
        e.panel = e.panel == Panel::view       ? Panel::outliner
                  : e.panel == Panel::outliner ? Panel::dock
                                               : Panel::view;
    });
    view("Viewport only", {{.key = ui::key_space, .ctrl = true}}, [](Editor& e) {
        e.only_view = !e.only_view;
    }).on = [](const Editor& e) { return e.only_view; };
    view("Full screen", {{ui::key_f1 + 10}}, [](Editor& e) { e.full_screen = !e.full_screen; }).on =
        [](const Editor& e) { return e.full_screen; };
    const auto scaled = [](int direction) {
        return [direction](Editor& e) {
            double& scale = e.preferences.scale;
            scale = direction == 0 ? 1 : next_scale(scale, direction);
        };
    };
    interface("Larger interface",
              {ctrl(ui::key_plus), ctrl(ui::key_equal), ctrl(ui::key_equal, true),
               ctrl(ui::key_plus, true), ctrl(ui::key_keypad_plus)},
              scaled(1),
              {[](const Editor& e) { return e.preferences.scale < interface_scales.back(); },
               "it is the largest"});
    interface("Smaller interface", {ctrl(ui::key_minus), ctrl(ui::key_keypad_minus)}, scaled(-1),
              {[](const Editor& e) { return e.preferences.scale > interface_scales.front(); },
               "it is the smallest"});
    interface("Reset interface size", {ctrl(ui::key_0)}, scaled(0),
              {[](const Editor& e) { return e.preferences.scale != 1; }, "it is at 100 %"});
    interface(
        "Timing", {{ui::key_f1 + 9}}, [](Editor& e) { e.timing.open = !e.timing.open; }, {}, true)
        .on = [](const Editor& e) { return e.timing.open; };
}

} // namespace trivar
