// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/every_command.h"
#include "core/commands/words/field_words.h"
#include "editor/panels/inspector/field_rows.h"
#include "ui/headless.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

template <class T> void expect_labels_fit(const ui::Theme& theme)
{
    const T value{};
    each_field(value, [&](std::string_view name, const auto&, std::string_view, Rule rule = {}) {
        const std::string label = label_of(name, rule);
        EXPECT_LE(ui::text_width(theme.font.small, label), theme.size.label - theme.px(8)) << label;
    });
}

// A row shows a long label in small letters, and cuts what does not fit then.
TEST(Labels, OfRowsFitTheirColumn)
{
    for (const float scale : {1.0f, 2.0f}) {
        ui::HeadlessFrames screen({200, 200}, {.scale = scale});
        const ui::Theme& theme = screen.theme();
        expect_labels_fit<TileLook>(theme);
        expect_labels_fit<TileStroke>(theme);
        expect_labels_fit<TileCover>(theme);
        expect_labels_fit<TileMask>(theme);
        expect_labels_fit<PlacementParameters>(theme);
        expect_labels_fit<RenderSettings>(theme);
        expect_labels_fit<Refining>(theme);
        expect_labels_fit<Simplifying>(theme);
        expect_labels_fit<Unwrapping>(theme);
        expect_labels_fit<FaceShading>(theme);
        expect_labels_fit<Travel>(theme);
        expect_labels_fit<Playing>(theme);
        expect_labels_fit<HeightShape>(theme);
        expect_labels_fit<Warp>(theme);
        expect_labels_fit<NamedIncision>(theme);
        expect_labels_fit<Incising>(theme);
    }
}

} // namespace
} // namespace trivar
