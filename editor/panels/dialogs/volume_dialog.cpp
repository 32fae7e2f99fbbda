// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/voxels/volume_summary.h"
#include "editor/files/volume_slices.h"
#include "editor/panels/dialogs/raw_rows.h"
#include "editor/panels/panels.h"
#include "editor/session/volume_levels.h"
#include "ui/dialog.h"
#include "ui/icons.h"
#include "ui/keys.h"
#include "ui/level_field.h"
#include "ui/sentence.h"

#include <cstdint>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

constexpr std::array<const char*, 3> slice_captions{"From above", "From the front",
                                                    "From the side"};

std::string triple_words(const glm::dvec3& v, const char* unit)
{
    return fmt::format("{} × {} × {} {}", ui::short_number(v.x), ui::short_number(v.y),
                       ui::short_number(v.z), unit);
}

// Three pictures of one height beside each other, on black.
void draw_slices(Editor& editor, const ui::Theme& theme, const VolumeOffer& offer,
                 const ui::Rect& in)
{
    const float gap = theme.px(12), line = theme.px(20);
    const float wide = std::floor((in.width() - 2 * gap) / 3);
    for (std::size_t k = 0; k < offer.slices.size(); ++k) {
        const ui::Rect box = ui::rect_at({in.lo.x + static_cast<float>(k) * (wide + gap), in.lo.y},
                                         {wide, in.height() - line});
        ui::paint_box(box, ui::rgb(0x000000), theme.size.rounding_small);
        const VolumeSlice& slice = offer.slices[k];
        if (!slice.image.rgba.empty()) {
            const auto shape = static_cast<float>(slice.shape);
            glm::vec2 size{box.height() * shape, box.height()};
            if (size.x > box.width()) size = {box.width(), box.width() / shape};
            const glm::vec2 lo = glm::round(box.center() - size / 2.0f);
            const gpu::Texture2D& texture = editor.stored_pictures.given(
                fmt::format("slice {} {}", k, static_cast<int>(offer.up)),
                editor.files.volumes.number(), slice.image);
            ImGui::GetWindowDrawList()->AddImage(
                reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.name())),
                {lo.x, lo.y}, {lo.x + size.x, lo.y + size.y});
        }
        ui::paint_text(theme.font.small, {{box.lo.x, box.hi.y}, {box.hi.x, in.hi.y}},
                       theme.color.text_3, slice_captions[k], ui::Align::center);
    }
}

void draw_facts(const ui::Theme& theme, const VolumeOffer& offer)
{
    const VolumeSummary& s = *offer.summary;
    ui::fact_row(theme, "Size", fmt::format("{} × {} × {} voxels", s.size.x, s.size.y, s.size.z));
    ui::fact_row(theme, "Samples", s.type);
    ui::fact_row(theme, "Spacing", triple_words(s.spacing_mm, "mm"), 0,
                 "How far apart samples are along each axis of the grid.");
    ui::fact_row(theme, "Values",
                 fmt::format("{} to {}", number_text(s.least, {.digits = 6}),
                             value_words(s.greatest, offer.grid->value_unit)));
    ui::fact_row(theme, "Memory", bytes_words(s.bytes), 0, "What the samples take in memory.");
}

void draw_histogram(const ui::Theme& theme, VolumeOffer& offer, float width, float height)
{
    const VolumeSummary& s = *offer.summary;
    std::vector<VoxelLevel>& levels = offer.command.shape.levels;
    std::vector<ui::LevelMark> marks;
    for (const VoxelLevel& level : levels)
        marks.push_back({level.value, theme.color.accent_text,
                         value_words(level.value, offer.grid->value_unit)});
    int none = -1;
    const ui::Edit edit =
        ui::level_field(theme, "histogram", marks, none,
                        {.counts = s.histogram,
                         .lo = s.least,
                         .hi = s.greatest,
                         .ends = {ui::short_number(s.least), ui::short_number(s.greatest)},
                         .height = height / theme.scale},
                        width);
    if (edit == ui::Edit::changed)
        for (std::size_t i = 0; i < marks.size(); ++i)
            if (marks[i].value != levels[i].value)
                levels[i].value = readable_value(marks[i].value, s);
}

void draw_stand(const ui::Theme& theme, VolumeOffer& offer)
{
    int up = static_cast<int>(offer.up);
    const ui::Row row =
        ui::label_row(theme, "Up", false, "Which direction of the data points up in the scene.");
    const ui::Edit turned = ui::choice(
        theme, "up", up,
        {"Z, as in the file", "Z, upside down", "Y", "Y, upside down", "X", "X, upside down"},
        row.width);
    offer.up = static_cast<DataUp>(up);
    if (turned == ui::Edit::changed) offer.slices = turned_slices(offer);
    ui::number_field(
        theme, "scale", offer.scale, {.lo = 1e-6, .hi = 1e6, .unit = "×"},
        ui::label_row(theme, "Scale", false, "Metres in the scene per metre of the data.").width);
    double& level = offer.command.shape.levels.front().value;
    ui::number_field(
        theme, "level", level,
        {.lo = offer.summary->least, .hi = offer.summary->greatest, .unit = offer.grid->value_unit},
        ui::label_row(theme, "Level", false,
                      "The value of the first surface; drag it in the histogram, too.")
            .width);
    ui::fact_row(theme, "In the scene", triple_words(size_of(offer), "m"));
    ui::label_row(theme, "Place", false,
                  "Else it lies where its file says, beside other data of the same body.");
    ui::check_box(theme, "centered", offer.centered, "on the ground, in the middle");
}

// Edits how much of the data is kept, in words for each way. Returns whether they are to be read
// again.
bool kept_row(const ui::Theme& theme, VolumeOffer& offer)
{
    int& coarsen = offer.command.shape.reading.coarsen;
    std::vector<std::string> names;
    int at = 0;
    for (const Keeping& each : offer.keepings) {
        if (each.coarsen <= coarsen) at = static_cast<int>(names.size());
        names.push_back(words_of(each));
    }
    const ui::Row row =
        ui::label_row(theme, "Kept", false,
                      fmt::format("How many voxels become one, their mean, while the data are "
                                  "read. With what the window makes of them they may take {}.",
                                  bytes_words(offer.memory_bytes)));
    if (ui::choice(theme, "kept", at, names, row.width) != ui::Edit::changed) return false;
    coarsen = offer.keepings[static_cast<std::size_t>(at)].coarsen;
    return true;
}

// Notices of the reader, or why it cannot be read.
void draw_notes(const ui::Theme& theme, const VolumeOffer& offer, const ui::Rect& in)
{
    const float line = theme.px(18);
    float y = in.lo.y;
    const auto say = [&](const std::string& text, ui::Color color) {
        for (const std::string& words :
             ui::wrapped(theme.font.small, ui::sentence(text), in.width() - theme.px(20))) {
            if (y + line > in.hi.y) return;
            ui::paint_text(
                theme.font.small,
                ui::rect_at({in.lo.x + theme.px(20), y}, {in.width() - theme.px(20), line}),
                theme.color.text_2, words);
            if (words ==
                ui::wrapped(theme.font.small, ui::sentence(text), in.width() - theme.px(20))
                    .front())
                ui::paint_text(theme.font.small, ui::rect_at({in.lo.x, y}, {theme.px(20), line}),
                               color, ui::icon::warning);
            y += line;
        }
    };
    if (!offer.trouble.empty()) return say(offer.trouble, theme.color.bad);
    for (const std::string& notice : offer.notices) say(notice, theme.color.warn);
}

} // namespace

void draw_volume_dialog(Editor& editor, const ui::Theme& theme)
{
    VolumeImports& imports = editor.files.volumes;
    VolumeOffer* offer = imports.offered();
    if (!offer) return;
    // Data read while another dialog is open wait for it to close.
    if (!ImGui::IsPopupOpen("volume data") && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup))
        return;
    const float pad = theme.px(24), foot = theme.px(60), rowed = theme.px(188.0f / 6);
    const int raw_rows = offer->raw ? raw_row_count : offer->says_no_spacing ? 1 : 0;
    const float notes = offer->notices.empty() && offer->trouble.empty() ? 0 : theme.px(44);
    const bool keeps = asks_what_is_kept(*offer);
    const float facts = std::round((keeps ? 6 : 5) * rowed),
                form = std::round(rowed * static_cast<float>(raw_rows));
    const float stand = std::round(5 * rowed), slices = theme.px(190);
    const std::string title = "Import " + offer->command.name;
    const ui::Rect r =
        ui::begin_dialog(theme, "volume data",
                         {theme.px(720), theme.px(56) + theme.px(16) + slices + theme.px(16) +
                                             facts + form + stand + notes + theme.px(12) + foot});
    const bool typing = ImGui::IsAnyItemActive(); // these keys end that first
    const bool escape = !typing && ImGui::IsKeyPressed(ui::key_escape, false);
    const bool enter = !typing && (ImGui::IsKeyPressed(ui::key_enter, false) ||
                                   ImGui::IsKeyPressed(ui::key_keypad_enter, false));
    float y = ui::draw_dialog_head(theme, r, "");
    ui::paint_text(theme.font.title, {r.lo + glm::vec2(pad, 0), {r.hi.x - pad, y}},
                   theme.color.text, ui::elided(theme.font.title, title, r.width() - 2 * pad));
    y += theme.px(16);
    const float y1 = r.hi.y - foot;
    // In a small window the pictures give way first.
    const float rest = theme.px(16) + facts + form + stand + notes + theme.px(12);
    const float tall = std::clamp(y1 - y - rest, theme.px(60), slices);
    draw_slices(editor, theme, *offer, {{r.lo.x + pad, y}, {r.hi.x - pad, y + tall}});
    y += tall + theme.px(12);
    const float half = std::floor((r.width() - 2 * pad) / 2);
    const float skip = theme.px(12), past = theme.px(ui::key_gutter);
    // Rows begin 12 px in and end before the gutter of keys, which nothing has here.
    ImGui::SetCursorScreenPos({r.lo.x + pad - skip, y});
    const float all = std::max(theme.px(40), y1 - y - notes - theme.px(8));
    ImGui::BeginChild("facts", {half + past, all}, false,
                      all < facts + form + stand ? 0 : ImGuiWindowFlags_NoScrollbar);
    bool edited = false;
    if (raw_rows > 0) edited = draw_raw_rows(theme, *offer);
    if (offer->grid) {
        draw_facts(theme, *offer);
        if (keeps) edited = kept_row(theme, *offer) || edited;
        draw_stand(theme, *offer);
    }
    ImGui::EndChild();
    if (offer->grid) {
        const float left = r.lo.x + pad + half + theme.px(12);
        ImGui::SetCursorScreenPos({left, y});
        const float high = std::min(all, theme.px(172));
        draw_histogram(theme, *offer, r.hi.x - pad - left, high);
        ui::paint_text(theme.font.small,
                       {{left, y + high + theme.px(2)}, {r.hi.x - pad, y + high + theme.px(20)}},
                       theme.color.text_3,
                       imports.reading_again() ? "Reading again..."
                                               : "How often values occur; drag the level");
    }
    if (notes > 0)
        draw_notes(theme, *offer, {{r.lo.x + pad, y1 - notes}, {r.hi.x - pad, y1 - theme.px(4)}});
    ui::paint_box({{r.lo.x, y1}, {r.hi.x, y1 + theme.size.hairline}}, theme.color.line_soft);
    const glm::vec2 size(theme.px(96), theme.px(32));
    const float row = std::round(y1 + (foot - size.y) / 2);
    ImGui::SetCursorScreenPos({r.hi.x - pad - 2 * size.x - theme.px(8), row});
    const bool cancelled = ui::button(theme, "Cancel", ui::ButtonKind::plain, size) || escape;
    ImGui::SetCursorScreenPos({r.hi.x - pad - size.x, row});
    const bool sense = offer->grid && !imports.reading_again();
    ImGui::BeginDisabled(!sense);
    const bool added = (ui::button(theme, "Add", ui::ButtonKind::primary, size) || enter) && sense;
    ImGui::EndDisabled();
    if (edited && !imports.reading_again()) imports.read_again();
    if (cancelled || added) ImGui::CloseCurrentPopup();
    ui::end_dialog();
    if (cancelled)
        imports.leave();
    else if (added)
        imports.add();
}

} // namespace trivar
