// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/commands/objects/shape.h"
#include "core/ffd/resolution.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/panels.h"
#include "editor/picture/volume_facts.h"
#include "editor/words/volume_words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

constexpr std::array<const char*, 3> of_a_stroke{"Along", "Across", "Up"}, of_a_box{"X", "Y", "Z"};

// The middle of every span of an axis.
std::vector<double> span_middles(const Knots& axis)
{
    const std::vector<double> breaks = axis.breaks();
    std::vector<double> out;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        out.push_back((breaks[i] + breaks[i + 1]) / 2);
    return out;
}

// Control points along one axis, and buttons for more and for fewer. Fewer says beforehand how far
// it moves anything; null: it is not known.
void density_row(Editor& editor, const ui::Theme& theme, Id id, int axis, const Knots& knots,
                 const double* deviation)
{
    const bool box = is_lattice(editor.session.document(), id);
    ui::label_row(theme, (box ? of_a_box : of_a_stroke)[static_cast<std::size_t>(axis)]);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = theme.size.row;
    ui::paint_text(theme.font.body, ui::rect_at({at.x, at.y}, {theme.px(80), side}),
                   theme.color.text, fmt::format("{} points", knots.count()));
    ImGui::PushID(axis);
    ImGui::SetCursorScreenPos({at.x + theme.px(84), at.y});
    const bool open = knots.closure() == Closure::open;
    KnotInsertion finer;
    (axis == 0 ? finer.along : axis == 1 ? finer.across : finer.up) = span_middles(knots);
    if (ui::icon_button(theme, "finer", ui::icon::add, {side, side},
                        {"Finer", {}, "Adds a control point to each span; the shape stays."}))
        editor.session.run(InsertKnots{id, finer});
    ImGui::SetCursorScreenPos({at.x + theme.px(88) + side, at.y});
    const int fewer = fewer_points(knots);
    const std::string off = deviation ? " No point moves further than " +
                                            ui::short_number(rounded_up(*deviation, 3)) + " m."
                                      : "";
    if (ui::icon_button(theme, "coarser", ui::icon::minus, {side, side},
                        {"Coarser", {}, fmt::format("{} control points remain.{}", fewer, off)},
                        {.enabled = open && fewer < knots.count()}))
        editor.session.run(CoarsenVolume{id, {static_cast<VolumeAxis>(axis), fewer}});
    ImGui::PopID();
    ImGui::SetCursorScreenPos({at.x, at.y + side + theme.px(4)});
    ImGui::Dummy({1, 0});
}

void verdict_row(const ui::Theme& theme, const CellVerdicts* verdicts)
{
    const auto tell = [&](const std::string& words, ui::Color color) {
        ui::fact_row(theme, "Folds", words, color,
                     "whether the volume turns inside out anywhere, as far as that is proven");
    };
    if (!verdicts) return tell("being looked for", theme.color.text_2);
    const auto count = [&](Verdict of) { return std::ranges::count(verdicts->of, of); };
    if (const auto bad = count(Verdict::proven_bad); bad > 0)
        return tell(fmt::format("{} of {} cells", bad, verdicts->of.size()), theme.color.bad);
    if (const auto unknown = count(Verdict::unknown); unknown > 0)
        return tell(fmt::format("{} cells unproven", unknown), theme.color.warn);
    const bool allowed = count(Verdict::excepted) > 0;
    tell(allowed ? "only where allowed, proven" : "nowhere, proven", theme.color.good);
}

// In how many parts it may fold, with a button that takes that back.
void allowance_row(Session& session, const ui::Theme& theme, Id id, std::size_t parts)
{
    const std::string words =
        fmt::format("May fold in {} {}", parts, parts == 1 ? "part" : "parts");
    if (ui::list_row(theme, {.name = words},
                     {{"fold nowhere",
                       ui::icon::trash,
                       {"Allow folds nowhere", {}, "Edits made so far stay."}}}))
        session.run(AllowFolds{id, {}});
}

} // namespace

void overlap_row(Editor& editor, const ui::Theme& theme, const EvaluatedObject* placed)
{
    const auto tell = [&](const std::string& words, ui::Color color) {
        ui::fact_row(theme, "Crosses itself", words, color,
                     "whether far parts of the volume meet, as far as that is proven");
    };
    // Not of every moment of a drag.
    const Overlap* overlap = !placed || editor.session.proposing()
                                 ? nullptr
                                 : editor.viewport.volume_facts().overlap(*placed);
    if (!overlap) return tell("being looked for", theme.color.text_2);
    if (overlap->verdict == Verdict::proven_good) return tell("nowhere, proven", theme.color.good);
    if (overlap->verdict == Verdict::unknown) return tell("not known", theme.color.warn);
    const glm::dvec3 &a = overlap->one, &b = overlap->other;
    tell(fmt::format("{} along meets {}", percent_text(a.x), percent_text(b.x)), theme.color.bad);
}

void draw_shaping(Editor& editor, const ui::Theme& theme, Id id)
{
    Session& session = editor.session;
    const auto found = session.evaluated().objects.find(id);
    const bool box = is_lattice(session.document(), id);
    if (!ui::section(theme, box ? "Control points" : "Lattice", box)) return;
    if (found == session.evaluated().objects.end() || !found->second->placement) return;
    const Ref<Placement> placement = found->second->placement;
    VolumeFacts& facts = editor.viewport.volume_facts();
    const CellVerdicts* verdicts = facts.verdicts(*found->second);
    verdict_row(theme, verdicts);
    if (box) overlap_row(editor, theme, found->second.get()); // of a stroke it is among the checks
    if (const Ref<ShapedVolume>& shaped = found->second->shaped;
        shaped && !shaped->volume->may_fold.empty())
        allowance_row(session, theme, id, shaped->volume->may_fold.size());
    const VolumeFacts::Deviations* deviations = facts.deviations(*found->second);
    const VolumeFacts::Deviations off = deviations ? *deviations : VolumeFacts::Deviations{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        density_row(editor, theme, id, axis, placement->volume.displacement.axes[a],
                    off[a] ? &*off[a] : nullptr);
    }
    const std::vector<Ref<VolumeEdit>> steps = object(session.document(), id).shaping;
    const Ref<ShapedVolume> shaped = found->second->shaped;
    const auto done = [&](std::size_t i) { // a proposal may be ahead of what was evaluated
        return shaped && i < shaped->steps.size() ? shaped->steps[i] : Shaping{};
    };
    for (std::size_t i = 0; i < steps.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ui::list_row(theme,
                         {.name = fmt::format("{}  {}", i + 1, words_of(*steps[i], box, done(i))),
                          .color = theme.color.text_2},
                         {{"take back",
                           ui::icon::trash,
                           {"Remove this step", {}, "The other steps stay."}}}))
            session.run(Unshape{id, {static_cast<int>(i) + 1}});
        ImGui::PopID();
    }
    ui::gap(theme, 4);
    const bool folds = verdicts && !verdicts->good();
    ui::rows_if(theme, folds, "It folds nowhere.", [&] {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::SetCursorScreenPos({at.x + theme.size.padding, at.y});
        if (ui::button(theme, mend_action, ui::ButtonKind::primary, {theme.px(160), 0},
                       ui::icon::guard, key_text(action(editor, mend_action))))
            action(editor, mend_action).run(editor);
    });
    ui::gap(theme, 8);
}

} // namespace trivar
