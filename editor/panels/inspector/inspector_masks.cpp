// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_masks.h"

#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "editor/actions/mask_actions.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/session/scene_facts.h"
#include "editor/session/scene_names.h"
#include "editor/tools/tiles/mask.h"
#include "editor/words/file_words.h"
#include "ui/icons.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

struct OpenMask { // whose rows are shown
    Id layer = 0;
    std::size_t mask = 0;
};

std::string words_of_mask(const Session& session, const TileMask& mask)
{
    const std::string drives =
        choices_in_words<MaskDrives>()[static_cast<std::size_t>(mask.drives)];
    switch (mask.from) {
    case MaskFrom::image: return drives + " by " + file_name(mask.image);
    case MaskFrom::line: return drives + " along a line";
    case MaskFrom::point: return drives + " round a point";
    case MaskFrom::curve: break;
    }
    const std::string name = name_of(session.document(), mask.curve);
    return drives + " round " + (name.empty() ? "a lost curve" : name);
}

// A mask with buttons that turn it off and remove it; a click on its name opens its rows.
void mask_row(Editor& editor, const ui::Theme& theme, Id id, std::size_t k, const TileMask& mask,
              OpenMask& open)
{
    Session& session = editor.session;
    const int number = static_cast<int>(k) + 1;
    const bool shown = open.layer == id && open.mask == k;
    ImGui::PushID(number);
    const std::optional<int> pressed =
        ui::list_row(theme,
                     {.name = words_of_mask(session, mask),
                      .color = mask.hidden ? theme.color.text_3 : theme.color.text,
                      .icon = shown ? ui::icon::open : ui::icon::closed,
                      .tip = ui::Tip{shown ? "Hide its numbers" : "Show its numbers"}},
                     {{"mask off",
                       mask.hidden ? ui::icon::hidden : ui::icon::eye,
                       {mask.hidden ? "Turn this mask on" : "Turn this mask off", {}, {}}},
                      {"remove mask",
                       ui::icon::trash,
                       {"Remove this mask", {}, "Tiles are where they were without it."}}});
    ImGui::PopID();
    if (pressed == -1) open = shown ? OpenMask{} : OpenMask{id, k};
    if (pressed == 0) {
        TileMask other = mask;
        other.hidden = !other.hidden;
        session.run(MaskTiles{id, number, std::move(other)});
    }
    if (pressed == 1) session.run(RemoveTileMasks{id, {number}});
}

void picture_row(const ui::Theme& theme, const std::string& image, const std::string& help,
                 auto&& ask)
{
    const ui::Row at = ui::label_row(theme, "Picture", false, help);
    if (ui::button(theme, image.empty() ? "Choose..." : file_name(image), ui::ButtonKind::plain,
                   {at.width, theme.size.row}))
        ask();
}

void curve_row(Editor& editor, ValueRows& rows, TileMask& mask)
{
    const Session& session = editor.session;
    std::vector<Id> ids = curve_objects(session);
    if (std::ranges::find(ids, mask.curve) == ids.end()) ids.insert(ids.begin(), mask.curve);
    std::vector<std::string> names;
    for (const Id id : ids) {
        const std::string name = name_of(session.document(), id);
        names.push_back(name.empty() ? "none" : name);
    }
    int chosen = static_cast<int>(std::ranges::find(ids, mask.curve) - ids.begin());
    const ui::Row at =
        ui::label_row(rows.theme, "Curve of", false, facts_of(&TileMask::curve).help);
    rows.take(ui::choice(rows.theme, "curve", chosen, names, at.width));
    mask.curve = ids[static_cast<std::size_t>(chosen)];
}

void wide_choice(ValueRows& rows, const std::string& label, auto& value, const std::string& help)
{
    using Choice = std::remove_reference_t<decltype(value)>;
    int chosen = static_cast<int>(value);
    const ui::Row at = ui::label_row(rows.theme, label, false, help);
    rows.take(ui::choice(rows.theme, label, chosen, choices_in_words<Choice>(), at.width));
    value = static_cast<Choice>(chosen);
}

void mask_fields(Editor& editor, const ui::Theme& theme, Id id, std::size_t k,
                 const TileMask& before, const KeyGutter& keys)
{
    TileMask mask = before;
    const int number = static_cast<int>(k) + 1;
    ValueRows rows{theme, &keys};
    FieldRows<TileMask> fields(rows, mask, fmt::format("tiles.masks.{}", k));
    fields(&TileMask::drives);
    wide_choice(rows, "From", mask.from, facts_of(&TileMask::from).help);
    fields(&TileMask::low);
    fields(&TileMask::high);
    fields(&TileMask::inverted);
    const auto only_from = [&](std::initializer_list<MaskFrom> kinds, const char* why_not,
                               const std::function<void()>& draw) {
        ui::rows_if(theme, std::ranges::count(kinds, before.from) > 0, why_not, draw);
    };
    using From = MaskFrom;
    only_from({From::image}, "The mask is not from a picture.", [&] {
        picture_row(theme, mask.image, "the file of the picture",
                    [&] { ask_mask_image(editor, id, number); });
        wide_choice(rows, "Lies", mask.lies, facts_of(&TileMask::lies).help);
        fields(&TileMask::repeat_u);
        fields(&TileMask::repeat_v);
        fields(&TileMask::shift_u);
        fields(&TileMask::shift_v);
    });
    only_from({From::line, From::point}, "The mask is not along a line or round a point.",
              [&] { fields(&TileMask::begin); });
    only_from({From::line}, "The mask is not along a line.", [&] { fields(&TileMask::end); });
    only_from({From::curve}, "The mask is not round a curve.",
              [&] { curve_row(editor, rows, mask); });
    only_from({From::point, From::curve}, "The mask is not round a point or a curve.", [&] {
        fields(&TileMask::start);
        fields(&TileMask::stop);
    });
    only_from({From::line, From::point, From::curve}, "The mask is from a picture.",
              [&] { wide_choice(rows, "Easing", mask.easing, facts_of(&TileMask::easing).help); });
    // A mask becomes one by a picture when there is one.
    if (mask.from == MaskFrom::image && mask.image.empty()) {
        if (rows.edit != ui::Edit::none) ask_mask_image(editor, id, number);
        return;
    }
    propose_edit(editor, rows.edit, [&] { return MaskTiles{id, number, mask}; });
}

} // namespace

void draw_masks(Editor& editor, const ui::Theme& theme, Id id, const Tiling& tiling,
                const KeyGutter& keys)
{
    auto& open = editor.memory.of<OpenMask>();
    for (std::size_t k = 0; k < tiling.masks.size(); ++k) {
        mask_row(editor, theme, id, k, tiling.masks[k], open);
        if (open.layer != id || open.mask != k) continue;
        ImGui::PushID(static_cast<int>(k));
        mask_fields(editor, theme, id, k, tiling.masks[k], keys);
        ImGui::PopID();
    }
    const ui::Row at = ui::label_row(
        theme, "Add a mask", false,
        "where there are more tiles, larger or higher ones: by a picture, or by a gradient that is "
        "dragged over the tiles");
    const float half = (at.width - theme.px(6)) / 2;
    if (ui::button(theme, "Image...", ui::ButtonKind::plain, {half, theme.size.row}))
        ask_mask_image(editor, id);
    ImGui::SameLine(0, theme.px(6));
    if (ui::button(theme, "Gradient", ui::ButtonKind::plain, {half, theme.size.row}))
        editor.choose_tool("Mask");
}

void draw_heights(Editor& editor, const ui::Theme& theme, Id id)
{
    if (!ui::section(theme, "Heights")) return;
    HeightShape shape = *made_of<HeightShape>(editor.session.document(), id);
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    FieldRows<HeightShape> fields(rows, shape, "shape");
    picture_row(theme, shape.image, "the file of the picture", [&] {
        editor.files.ask_image(
            "Choose a picture of heights",
            [&editor, id](const std::string& path) { change_heights_image(editor, id, path); });
    });
    fields(&HeightShape::lies);
    fields(&HeightShape::height);
    fields(&HeightShape::level);
    fields(&HeightShape::segments);
    fields(&HeightShape::repeats);
    fields(&HeightShape::size);
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return SetHeights{id, shape}; });
}

} // namespace trivar
