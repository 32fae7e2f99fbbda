// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/dialogs/raw_rows.h"

#include "ui/widgets.h"

#include <imgui.h>

namespace trivar {
namespace {

using ui::Edit;

// Three fields beside each other, with an axis each.
template <class Value>
bool triple(const ui::Theme& theme, const std::string& label, const std::string& help, Value& value,
            auto&& field)
{
    const float gap = theme.px(4), all = ui::label_row(theme, label, false, help).width;
    const float wide = std::floor((all - 2 * gap) / 3);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    bool changed = false;
    for (int k = 0; k < 3; ++k) {
        ImGui::SetCursorScreenPos({at.x + static_cast<float>(k) * (wide + gap), at.y});
        changed =
            field(label + "XYZ"[k], value[k], std::string(1, "XYZ"[k]), wide) == Edit::changed ||
            changed;
    }
    return changed;
}

// The layouts that give the bytes of the file.
bool layout_row(const ui::Theme& theme, VolumeOffer& offer)
{
    VolumeReading& r = offer.command.shape.reading;
    std::vector<std::string> names;
    int chosen = -1;
    for (const RawGuess& guess : offer.guesses) {
        const RawLayout& l = guess.layout;
        const auto& n = l.block.size;
        if (r.size == glm::ivec3(n[0], n[1], n[2]) && r.type == l.block.type &&
            r.order == l.order && static_cast<std::uint64_t>(r.header_bytes) == l.header_bytes)
            chosen = static_cast<int>(names.size());
        names.push_back(words_of(l));
    }
    if (chosen < 0) names.emplace_back("Another one");
    int at = chosen < 0 ? static_cast<int>(names.size()) - 1 : chosen;
    const ui::Row row =
        ui::label_row(theme, "Layout", false, "Layouts that give exactly the bytes of the file.");
    if (ui::choice(theme, "layout", at, names, row.width) != Edit::changed ||
        at >= static_cast<int>(offer.guesses.size()))
        return false;
    const RawLayout& l = offer.guesses[static_cast<std::size_t>(at)].layout;
    const auto& n = l.block.size;
    r.size = {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2])};
    r.type = l.block.type;
    r.order = l.order;
    r.header_bytes = static_cast<int>(l.header_bytes);
    return true;
}

bool samples_rows(const ui::Theme& theme, VolumeReading& r)
{
    bool edited = triple(theme, "Size", "Samples along each axis.", r.size,
                         [&](const std::string& id, int& value, const std::string& axis, float w) {
                             return ui::integer_field(theme, id, value,
                                                      {.lo = 2, .hi = 1e6, .axis = axis}, w);
                         });
    static const std::vector<std::string> types{
        "unsigned 8 bit", "signed 8 bit",    "unsigned 16 bit", "signed 16 bit", "unsigned 32 bit",
        "signed 32 bit",  "unsigned 64 bit", "signed 64 bit",   "float 32 bit",  "float 64 bit"};
    int type = static_cast<int>(r.type);
    if (ui::choice(theme, "type", type, types,
                   ui::label_row(theme, "Type", false, "Of a sample.").width) == Edit::changed) {
        r.type = static_cast<SampleType>(type);
        edited = true;
    }
    int order = static_cast<int>(r.order);
    if (ui::segments(
            theme, "order", order, {"Little endian", "Big endian"},
            ui::label_row(theme, "Bytes", false, "Which byte of a sample comes first.").width) ==
        Edit::changed) {
        r.order = static_cast<ByteOrder>(order);
        edited = true;
    }
    const float wide = ui::label_row(theme, "Header", false, "Bytes before the samples.").width;
    return ui::integer_field(theme, "header", r.header_bytes, {.lo = 0, .hi = 2e9, .unit = "bytes"},
                             wide) == Edit::changed ||
           edited;
}

} // namespace

bool draw_raw_rows(const ui::Theme& theme, VolumeOffer& offer)
{
    bool edited = false;
    if (offer.raw) {
        edited = layout_row(theme, offer);
        edited = samples_rows(theme, offer.command.shape.reading) || edited;
    }
    return triple(theme, "Spacing", "How far apart samples are, millimetres.",
                  offer.command.shape.reading.spacing_mm,
                  [&](const std::string& id, double& value, const std::string& axis, float w) {
                      return ui::number_field(theme, id, value,
                                              {.lo = 1e-6, .hi = 1e6, .axis = axis}, w);
                  }) ||
           edited;
}

} // namespace trivar
