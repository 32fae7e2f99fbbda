// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/view_fields.h"

namespace trivar {

struct KeepView {
    static constexpr std::string_view
        verb = "save_camera",
        summary = "Bookmark a view under a name. The one named picture is the render camera.";
    static constexpr CommandNature nature{.icon = CommandIcon::camera};
    std::string name;
    Camera camera;
    bool operator==(const KeepView&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name of the bookmark; an earlier one of that name is replaced",
              required);
        field("camera", c.camera, "the view to keep", required);
    }
};
Document applied(Document document, const KeepView& command);
StepTitle title(const KeepView& c, const StepDocuments& step);

struct ForgetView {
    static constexpr std::string_view verb = "delete_camera", summary = "Delete a bookmarked view.";
    static constexpr CommandNature nature{.icon = CommandIcon::camera};
    std::string name;
    bool operator==(const ForgetView&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("name", c.name, "name of the bookmark", required);
    }
};
Document applied(Document document, const ForgetView& command);
StepTitle title(const ForgetView& c, const StepDocuments& step);

struct SetTime {
    static constexpr std::string_view verb = "set_time",
                                      summary =
                                          "Set the frame range and the frame rate of the scene.";
    Time time;
    bool operator==(const SetTime&) const = default;
    static void fields(auto& c, auto&& field) { spread(c.time, field); }
};
Document applied(Document document, const SetTime& command);
StepTitle title(const SetTime& c, const StepDocuments& step);

struct SetRender {
    static constexpr std::string_view
        verb = "set_render",
        summary = "Set the look, the light and the overlays of the picture.";
    RenderSettings settings;
    bool operator==(const SetRender&) const = default;
    static void fields(auto& c, auto&& field) { spread(c.settings, field); }
};
Document applied(Document document, const SetRender& command);
StepTitle title(const SetRender& c, const StepDocuments& step);

} // namespace trivar
