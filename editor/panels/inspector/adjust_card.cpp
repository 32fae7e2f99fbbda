// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "core/commands/every_command.h"
#include "core/commands/placement/place.h"
#include "core/placement/placement.h"
#include "editor/panels/foot_cards.h"
#include "editor/panels/inspector/field_cells.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/value_rows.h"
#include "editor/panels/panels.h"
#include "editor/session/done_titles.h"
#include "editor/words/field_words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

// Rows for the numbers of a command, from its list of fields.
class CardRows {
public:
    CardRows(const ui::Theme& theme, const PlacementReport* report) : theme_(theme), report_(report)
    {
    }
    ui::Edit edit = ui::Edit::none;

    void operator()(std::string_view name, double& value, std::string_view help, Rule rule = {})
    {
        const double factor = shown_factor(rule.unit);
        const float width = row_of(name, help, rule);
        double shown = value * factor;
        const ui::Edit one = ui::number_field(theme_, std::string(name), shown,
                                              number_style(rule, false, {}), width);
        if (one == ui::Edit::changed || one == ui::Edit::cancelled) value = shown / factor;
        take(one);
    }
    void operator()(std::string_view name, float& value, std::string_view help, Rule rule = {})
    {
        double number = value;
        (*this)(name, number, help, rule);
        value = static_cast<float>(number);
    }
    void operator()(std::string_view name, glm::vec4& color, std::string_view help, Rule rule = {})
    {
        take(ui::color_field(theme_, std::string(name), color, row_of(name, help, rule)));
    }
    void operator()(std::string_view name, glm::dvec3& value, std::string_view help, Rule rule = {})
    {
        ui::NumberStyle style{.lo = rule.lo, .hi = rule.hi};
        style.unit = unit_text(rule.unit);
        take(axis_fields(theme_, row_of(name, help, rule), style,
                         [&](int axis, const ui::NumberStyle& own, float width) {
                             return ui::number_field(theme_, std::string(name) + own.axis,
                                                     value[axis], own, width);
                         }));
    }
    void operator()(std::string_view name, int& value, std::string_view help, Rule rule = {})
    {
        if (name == "object" || name == "step") return;
        const float width = row_of(name, help, rule);
        take(ui::integer_field(theme_, std::string(name), value, {.lo = rule.lo, .hi = rule.hi},
                               width));
    }
    template <int n, class T>
    void operator()(std::string_view name, glm::vec<n, T>& value, std::string_view help,
                    Rule rule = {})
    {
        const FieldCells cells(theme_, row_of(name, help, rule), n);
        const float width = cells.width;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        for (int i = 0; i < n; ++i) {
            ImGui::SetCursorScreenPos({at.x + cells.offset(i).x, at.y + cells.offset(i).y});
            const std::string id = std::string(name) + std::to_string(i);
            const ui::NumberStyle style{.lo = rule.lo, .hi = rule.hi};
            if constexpr (std::is_same_v<T, int>)
                take(ui::integer_field(theme_, id, value[i], style, width));
            else if constexpr (std::is_same_v<T, double>)
                take(ui::number_field(theme_, id, value[i], style, width));
        }
    }
    void operator()(std::string_view, PlacementParameters& p, std::string_view, Rule = {})
    {
        each_field(
            p, [&](std::string_view name, auto& value, std::string_view help, Rule rule = {}) {
                if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, double>) {
                    if (name == "width" || name == "height")
                        size(name, value, help);
                    else if (name == "offset" || name == "start" || name == "fill" ||
                             name == "clearance")
                        (*this)(name, value, help, rule);
                }
            });
    }
    void operator()(std::string_view, Transform& t, std::string_view, Rule = {})
    {
        (*this)("translation", t.translation, "where it is",
                any_value.called("Position").in(Unit::metres));
    }
    void operator()(std::string_view, auto&, std::string_view, Rule = {}) {} // no number

private:
    float row_of(std::string_view name, std::string_view help, const Rule& rule) const
    {
        return ui::label_row(theme_, label_of(name, rule), false, std::string(help)).width;
    }
    void size(std::string_view name, double& value, std::string_view help)
    {
        const double present = !report_           ? 0
                               : name == "height" ? report_->height_world
                                                  : report_->width_world;
        ValueRows rows{theme_};
        rows.size(in_words(name), value, present, std::string(help));
        take(rows.edit);
    }
    void take(ui::Edit one)
    {
        if (one != ui::Edit::none) edit = one;
    }
    const ui::Theme& theme_;
    const PlacementReport* report_; // of what the command laid; null: of nothing
};

const PlacementReport* report_of(const Session& session, const Command& command)
{
    const auto* laid = command.as<Place>();
    const auto* laid_again = command.as<EditPlacement>();
    if (!laid && !laid_again) return nullptr;
    const auto found = session.evaluated().objects.find(laid ? laid->object : laid_again->object);
    return found != session.evaluated().objects.end() && found->second->placement
               ? &found->second->stroke_placement()->report
               : nullptr;
}

} // namespace

void draw_adjustment(Editor& editor, const ui::Theme& theme, const FootCards& foot)
{
    Adjustment& a = editor.adjustment;
    Session& session = editor.session;
    const History& history = session.scene().history();
    if (a.step == 0 || editor.active_tool().busy() || session.committing()) return;
    const std::size_t at = a.running ? history.position() : a.step - 1;
    if (at >= history.steps().size()) return;
    const History::Step& step = history.steps()[at];
    const Document& before = at == 0 ? history.start() : history.steps()[at - 1].result;
    Command command = session.proposing() && a.running ? history.proposal()->command : step.command;
    const StepTitle title = done_title(session, step.command, before, step.result);
    const float pad = theme.px(12), head = theme.px(32);
    ui::Rect view = foot.view();
    const float end = session.notices.all().empty() ? view.hi.x : ui::Notices::left_of(theme, view);
    const float width = std::min(theme.px(a.open ? 320 : 260), end - pad - (view.lo.x + pad));
    if (width < theme.px(160)) return;
    const float body = a.open ? std::max(a.height_px, theme.px(28)) + theme.px(8) : 0;
    view = foot.above(view.lo.x + pad, view.lo.x + pad + width);
    const ui::Rect card =
        ui::rect_at({view.lo.x + pad, view.hi.y - pad - head - body}, {width, head + body});
    if (card.lo.y < view.lo.y + theme.px(80)) return;
    ui::paint_card(theme, card);
    ui::lower_area("adjustment", card); // takes the clicks beside its fields
    const std::string key = key_text(action(editor, "Adjust last"));
    const float key_width = ui::text_width(theme.font.small, key) + theme.px(12);
    ImGui::SetCursorScreenPos({card.lo.x, card.lo.y});
    if (ImGui::InvisibleButton("adjust", {width, head})) a.open = !a.open;
    ui::tooltip({title.text(), key, "The numbers of the last step; changing one replaces it."});
    if (ImGui::IsItemHovered())
        ui::paint_box({card.lo, {card.hi.x, card.lo.y + head}}, theme.color.row_hover,
                      theme.size.rounding_card);
    const ui::Rect line = {card.lo + glm::vec2(pad, 0), {card.hi.x - pad, card.lo.y + head}};
    ui::paint_text(theme.font.body, line, theme.color.text_2,
                   a.open ? ui::icon::open : ui::icon::closed);
    ui::paint_text(theme.font.small, line, theme.color.text_2, key, ui::Align::right);
    const ui::Rect words = {line.lo + glm::vec2(theme.px(18), 0),
                            line.hi - glm::vec2(key_width, 0)};
    ui::paint_text(theme.font.strong, words, theme.color.text,
                   ui::elided(theme.font.strong, title.text(), words.width()));
    if (!a.open) return;
    ImGui::SetCursorScreenPos({card.lo.x, card.lo.y + head});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::BeginChild("adjusted", {width, body}, false, ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    const float top = ImGui::GetCursorScreenPos().y;
    CardRows rows(theme, report_of(session, command));
    change(command, [&](auto& c) { each_field(c, rows); });
    a.height_px = ImGui::GetCursorScreenPos().y - top;
    ImGui::EndChild();
    if (rows.edit == ui::Edit::changed) propose_instead(a, session, command);
    if (rows.edit == ui::Edit::cancelled)
        finish_adjusting(a, session, true);
    else if (a.running && !ImGui::IsAnyItemActive())
        finish_adjusting(a, session, false);
}

} // namespace trivar
