// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/cutting/incise.h"
#include "core/commands/objects/primitives.h"
#include "editor/tools/incise/incise.h"
#include "tests/editor/rig.h"

#include <gtest/gtest.h>

namespace trivar::testing {

// A ball before the camera, and the tool.
struct InciseRig : Rig {
    explicit InciseRig(const Transform& transform = {}) : Rig({900, 640})
    {
        EXPECT_TRUE(editor.session.run(AddSphere{
            .shape = {.radius = 1, .segments = 64, .rings = 32}, .transform = transform}));
        editor.session.selected = 1;
        editor.session.view.camera.eye = {0, -5, 0.5};
        editor.session.view.camera.target = {0, 0, 0};
        key({'C'});
        wait();
    }
    InciseTool& tool() { return dynamic_cast<InciseTool&>(editor.active_tool()); }
    void drag(const std::vector<glm::vec2>& way, bool let_go = true)
    {
        std::vector<glm::vec2> path;
        for (const glm::vec2& p : way) path.push_back(layout().view.center() + p);
        move(path.front());
        wait();
        draw(path, let_go);
        wait();
    }
    void cut() { drag({{-90, 10}, {0, -20}, {90, 10}}); }
    const std::optional<Incising>& incising() const
    {
        return object(editor.session.committed(), 1).incising;
    }
    const NamedIncision& one(std::size_t k = 0) const { return incising()->cuts.at(k); }
    const IncisingEffects::OfIncision& outcome(std::size_t k = 0) const
    {
        return editor.session.evaluated().objects.at(1)->incisions.at(k);
    }
    std::size_t vertices() const
    {
        return editor.session.evaluated().objects.at(1)->parts.front().vertex_count();
    }
    Handle handle(std::string_view kind)
    {
        for (const Handle& each : tool().handles(editor.session, 1))
            if (each.key.kind == kind) return each;
        ADD_FAILURE() << "there is no such handle";
        return {};
    }
    glm::vec2 in_window(const Handle& handle) const { return in_window(handle.p_px); }
    void pull(std::string_view kind, const glm::vec2& by, bool let_go = true)
    {
        const glm::vec2 at = in_window(handle(kind));
        move(at);
        draw({at, at + by}, let_go);
        wait();
    }
    // The same, so many pixels along the way of the handle.
    void pull_along(std::string_view kind, float by, bool let_go = true)
    {
        pull(kind, by * glm::vec2(handle(kind).way_px), let_go);
    }
    glm::vec2 in_window(const glm::dvec2& p_px) const { return layout().view.lo + glm::vec2(p_px); }
};

} // namespace trivar::testing
