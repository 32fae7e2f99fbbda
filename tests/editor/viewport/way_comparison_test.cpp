// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/way_comparison.h"
#include "tests/editor/rig.h"

#include <algorithm>

namespace trivar {
namespace {

using testing::Rig;

TEST(WayComparison, MeasuresAllWaysOfWhatWasPlaced)
{
    Rig rig({1000, 800});
    rig.two_objects();
    const auto rows = [&] {
        return rig.editor.viewport.ways().rows(rig.editor.session.evaluated(),
                                               gpu::DeformBy::one_phase);
    };
    EXPECT_TRUE(rows().empty());
    rig.key({'D'});
    rig.draw(rig.stroke());
    rig.wait();
    ASSERT_EQ(rows().size(), deform_words.size());
    EXPECT_TRUE(
        std::ranges::none_of(rows(), [](const auto& row) { return row.time_ms.has_value(); }));
    rig.editor.viewport.ways().begin();
    for (int i = 0; i < 20 && rig.editor.viewport.ways().running(); ++i) rig.frames(1);
    for (const ui::TimedWay& row : rows()) {
        EXPECT_EQ(row.used, row.name == "One phase");
        EXPECT_TRUE(row.time_ms) << row.name << row.sentence;
    }
}

TEST(TimingCard, LetsNoClickThroughToTheScene)
{
    Rig rig({1000, 800});
    rig.two_objects();
    rig.editor.timing.open = true;
    rig.frames();
    const glm::vec2 on_card = rig.layout().view.lo + glm::vec2(200, 150);
    Camera& camera = rig.editor.session.view.camera; // the plane is everywhere
    camera.eye = {0, 0, 2.5};
    camera.up = {0, 1, 0};
    rig.wait();
    rig.move(on_card);
    rig.click(on_card);
    EXPECT_EQ(rig.editor.session.selected, 2);
    rig.editor.timing.open = false;
    rig.frames();
    rig.click(on_card);
    EXPECT_NE(rig.editor.session.selected, 2);
}

} // namespace
} // namespace trivar
