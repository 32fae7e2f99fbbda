// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/helpers.h"
#include "editor/hands/tool.h"
#include "editor/hands/viewport_input.h"
#include "editor/preferences/mouse_manners.h"
#include "editor/viewport/viewport_style.h"
#include "gpu/shader_folder.h"

#include <memory>
#include <optional>

namespace trivar::gpu {
class Renderer;
}
namespace trivar::ui {
class TimingHistory;
}

namespace trivar {

class LinesAtRest;
class RefinedView;
class VolumeFacts;
struct PictureInputs;
struct ViewportDrawn;
class WayComparison;

// A Viewport is the picture in the middle: it moves the camera, draws the scene when something
// changed, and tells what lies under the mouse. Needs the window's OpenGL context.
class Viewport {
public:
    Viewport();
    ~Viewport();
    Viewport(const Viewport&) = delete;
    Viewport& operator=(const Viewport&) = delete;

    // Takes the mouse over `rect` (ImGui's last item is the area): it uses the camera's share and
    // returns the rest for the tool.
    ViewportInput take_input(Session& session, const ui::Frame& frame, const ui::Rect& rect,
                             const Tool& tool);
    void set_manners(const MouseManners& manners) { manners_ = manners; }
    bool moves_camera() const { return move_ != Move::none; } // by a button that is held
    // The scene's picture as a texture, drawn anew only if it would differ. While things move it is
    // a draft; a moment after they rest it is drawn in full, one piece per frame, for which it asks
    // for frames. The draft stays until the full picture is complete. What cannot be drawn leaves
    // the picture unchanged: see new_trouble(). 0: there has been no picture.
    unsigned draw(const Session& session, ui::Frame& frame, glm::ivec2 size_px, bool moving,
                  int state, const std::function<Helpers()>& helpers);
    void forget_gpu(); // before the context goes; the next frame makes all of it again
    void set_style(const ViewportStyle& style);
    // Draws with a developer's shaders from now on, and follows changes of their files.
    void follow(gpu::ShaderFolder folder) { shader_folder_ = std::move(folder); }
    const Ref<gpu::ShaderTexts>& shaders() const { return shaders_; }
    unsigned texture() const; // the picture that is shown
    WayComparison& ways();
    RefinedView& refined(); // the effects of the session as they are drawn
    const LinesAtRest& lines_at_rest() const;
    VolumeFacts& volume_facts(); // of the volume that is shown
    const ui::TimingHistory& drafts() const;
    double draft_scale() const;            // of the next draft's size
    const Timings& full_timings() const;   // of the last full picture
    const gpu::Renderer* renderer() const; // null: nothing was drawn
    long pictures() const;                 // begun so far
    // Returns what the renderer could not do as asked, each sentence once; empty: nothing new.
    std::string new_notice();
    // Return why the present scene has no picture, and the renderer's shader_trouble(), if they
    // changed since the last call; an empty text: there is no trouble any more.
    std::optional<std::string> new_trouble();
    std::optional<std::string> new_shader_trouble();

private:
    void draw_wanted(const PictureInputs& wanted, const Session& session, ui::Frame& frame,
                     const std::function<Helpers()>& helpers);
    enum class Move { none, orbit, pan, zoom };
    void navigate(Session& session, const ViewportInput& input, glm::dvec2 drag_px);
    void scroll(Session& session, const ui::Frame& frame, const ViewportInput& input);
    void zoom(Session& session, glm::dvec2 mouse_px, double factor);
    bool emulates_middle() const; // what makes the left button the middle one is held
    std::optional<glm::dvec3> anchor_under(const Session& session, glm::dvec2 p_px);
    glm::dvec3 point_under(const Session& session, glm::dvec2 p_px); // or at the target's depth
    glm::dvec3 orbit_center(const Session& session, glm::dvec2 mouse_px);

    ViewportStyle style_;
    std::optional<gpu::ShaderFolder> shader_folder_;
    Ref<gpu::ShaderTexts> shaders_;
    std::unique_ptr<ViewportDrawn> drawn_;

    MouseManners manners_;
    double fine_scroll_s_ = -1e9; // when the wheel last turned as no wheel of a mouse does
    Move move_ = Move::none;
    glm::dvec3 anchor_{0};
    glm::dvec2 last_mouse_{0};
    double hand_s_ = 0; // when the mouse last moved or a button did
    bool left_down_ = false;
};

// Whether a turn of the wheel has fractional or sideways parts, as only fingers make them.
bool is_fine_scroll(glm::dvec2 steps);

// Returns the first point at which a ray meets an object. It tries the triangles one after another:
// for one click.
std::optional<glm::dvec3> first_hit(const EvaluatedObject& object, const Ray& ray);

} // namespace trivar
