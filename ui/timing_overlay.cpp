// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timing_overlay.h"

#include "core/base/text.h"
#include "ui/timing_graph.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

constexpr float width_px = 340, least_width_px = 150, margin_px = 14, row_px = 20, graph_px = 56,
                gap_px = 8;

struct Group {
    std::string title;
    const Timings& timings;
    Color color = 0;
    bool folded = false; // the heading alone
};

std::string milliseconds(double ms)
{
    return ms < 10 ? fmt::format("{:.2f} ms", ms) : fmt::format("{:.1f} ms", ms);
}

std::string megabytes(std::size_t bytes)
{
    return fmt::format("{:.0f} MB", static_cast<double>(bytes) / (1024 * 1024));
}

// Rows one below the other between two margins.
struct Rows {
    const Theme& theme;
    float y, left, right;
    Rect next()
    {
        const Rect row{{left, y}, {right, y + theme.px(row_px)}};
        y = row.hi.y;
        return row;
    }
};

void draw_group(const Group& group, Rows& rows)
{
    const Theme& theme = rows.theme;
    const Palette& c = theme.color;
    const double total = total_ms(group.timings);
    const Rect head = rows.next();
    paint_text(theme.font.strong, head, c.text, group.title);
    paint_text(theme.font.strong, head, c.text, milliseconds(total), Align::right);
    for (const Timings::Stage& stage : group.timings.stages) {
        if (group.folded) break;
        const Rect r = rows.next();
        const auto share = static_cast<float>(stage.time_ms / std::max(total, 1e-9));
        const float bar_left = rows.left + theme.px(128), bar_right = rows.right - theme.px(72);
        paint_text(theme.font.small, r, c.text_2,
                   elided(theme.font.small, stage.name, theme.px(120)));
        paint_text(theme.font.small, r, c.text, milliseconds(stage.time_ms), Align::right);
        if (bar_left >= bar_right) continue; // there is no room for it
        const Rect bar{{bar_left, r.center().y - theme.px(3)},
                       {bar_right, r.center().y + theme.px(3)}};
        paint_box(bar, c.field, theme.px(3));
        paint_box({bar.lo, {bar.lo.x + std::max(theme.px(2), bar.width() * share), bar.hi.y}},
                  group.color, theme.px(3));
    }
    rows.y += theme.px(gap_px);
}

float height_of(const Theme& theme, const Group& group)
{
    const std::size_t lines = 1 + (group.folded ? 0 : group.timings.stages.size());
    return theme.px(row_px) * static_cast<float>(lines) + theme.px(gap_px);
}

// Draws a row for each way, to be chosen, with its time.
void draw_ways(const std::vector<TimedWay>& ways, Rows& rows, TimingView& view)
{
    const Theme& theme = rows.theme;
    const Palette& c = theme.color;
    const Rect head = rows.next();
    paint_text(theme.font.strong, head, c.text, "Deformed by");
    ImGui::SetCursorScreenPos({head.hi.x - button_width(theme, "Measure"), head.lo.y});
    if (button(theme, "Measure", ButtonKind::quiet, {0, head.height()})) view.measure_ways = true;
    tooltip({"Measure", {}, "Measures every way of deforming the placed objects."});
    for (const TimedWay& way : ways) {
        const Rect r = rows.next();
        ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
        if (ImGui::InvisibleButton(way.name.c_str(), {r.width(), r.height()}) && !way.used)
            view.other_way = static_cast<std::size_t>(&way - ways.data());
        tooltip({way.name, {}, way.sentence});
        if (ImGui::IsItemHovered()) paint_box(r, c.row_hover, theme.size.rounding);
        const glm::vec2 dot(r.lo.x + theme.px(6), r.center().y);
        paint_dot(dot, theme.px(4), way.used ? c.focus : c.field, c.text_3, theme.size.hairline);
        const Rect words{{r.lo.x + theme.px(18), r.lo.y}, r.hi};
        paint_text(theme.font.small, words, way.used ? c.text : c.text_2, way.name);
        const auto cell = [&](float right_px, const std::string& text, Color color) {
            paint_text(theme.font.small, {r.lo, {r.hi.x - theme.px(right_px), r.hi.y}}, color, text,
                       Align::right);
        };
        cell(4, way.off, c.text_2);
        if (!way.time_ms) continue;
        cell(134, milliseconds(*way.time_ms), c.text);
        cell(56, fmt::format("{:.1f} M/s", static_cast<double>(way.vertices) / *way.time_ms / 1000),
             c.text_2);
    }
    rows.y += theme.px(gap_px);
}

std::optional<Rect> draw_card(const Theme& theme, const Rect& room, const TimingSources& s,
                              TimingView& view)
{
    const Palette& c = theme.color;
    const glm::vec2 at = room.lo;
    const float width = std::min(theme.px(width_px), room.width()), max_height = room.height();
    float foot_height = theme.px(24);
    const float graph_height = theme.px(row_px + graph_px + gap_px);
    if (width < theme.px(least_width_px) || max_height < graph_height + theme.px(2 * margin_px))
        return {};
    const glm::vec2 graph_at = at + theme.px(margin_px) + glm::vec2(0, theme.px(row_px));
    const Rect graph = rect_at(graph_at, {width - theme.px(2 * margin_px), theme.px(graph_px)});

    // The shown picture has to be known before the card is drawn under it.
    ImGui::SetCursorScreenPos({graph.lo.x, graph.lo.y});
    const bool clicked = ImGui::InvisibleButton("graph", {graph.width(), graph.height()});
    const long under =
        ImGui::IsItemHovered() ? picture_at(s.history, graph, ImGui::GetIO().MousePos.x) : 0;
    if (clicked) view.held = view.held != under ? under : 0;
    if (!s.history.find(view.held)) view.held = 0; // it has left the graph
    const long chosen = under > 0 ? under : view.held;

    std::vector<Group> groups;
    const auto add = [&groups](const char* title, const Timings& timings, Color color) {
        if (!timings.stages.empty()) groups.push_back({title, timings, color});
    };
    if (const TimedPicture* picture = s.history.find(chosen)) {
        add("Evaluation", picture->evaluation, c.cpu);
        add("Picture", picture->passes, c.gpu);
    } else {
        add("Evaluation", s.evaluation, c.cpu);
        if (s.history.count() > 0)
            add("Picture while moving", s.history.pictures().back().passes, c.gpu);
        add("Picture at rest", s.at_rest, c.gpu);
    }
    float ways_height =
        s.ways.empty() ? 0 : theme.px(row_px) * static_cast<float>(s.ways.size() + 1);
    const std::vector<std::string_view> drawn = trimmed_lines(s.drawn);
    float drawn_height = s.drawn.empty() ? 0 : theme.px(row_px) * static_cast<float>(drawn.size());
    const auto height = [&] {
        float sum =
            drawn_height + ways_height + graph_height + foot_height + theme.px(2 * margin_px);
        for (const Group& group : groups) sum += height_of(theme, group);
        return sum;
    };
    for (std::size_t i = groups.size(); i-- > 0 && height() > max_height;) groups[i].folded = true;
    for (float* part : {&ways_height, &drawn_height, &foot_height})
        if (height() > max_height) *part = 0;
    while (!groups.empty() && height() > max_height) groups.pop_back();

    const Rect card = rect_at(at, {width, std::min(height(), max_height)});
    paint_box(card, faded(c.raised, 0.94f), theme.size.rounding_card);
    paint_rim(card, c.raised_rim, theme.size.rounding_card, theme.size.hairline);
    lower_area("card", card);
    ImGui::PushClipRect({card.lo.x, card.lo.y}, {card.hi.x, card.hi.y}, true);
    Rows rows{theme, card.lo.y + theme.px(margin_px - 4), graph.lo.x, graph.hi.x};
    const Rect head = rows.next();
    const std::string title = chosen > 0
                                  ? fmt::format("{} before the newest", s.history.count() - chosen)
                                  : "Last pictures";
    const char* note =
        chosen > 0 && chosen == view.held ? "held, click to let go" : "16.7 and 33 ms";
    paint_text(theme.font.strong, head, c.text, title);
    if (text_width(theme.font.strong, title) + text_width(theme.font.small, note) <
        head.width() - theme.px(8))
        paint_text(theme.font.small, head, c.text_2, note, Align::right);
    draw_timing_graph(theme, s.history, graph, chosen);
    rows.y = graph.hi.y + theme.px(gap_px);
    if (drawn_height > 0)
        for (const std::string_view line : drawn) {
            const Rect row = rows.next();
            paint_text(theme.font.small, row, c.text_2,
                       elided(theme.font.small, std::string(line), row.width()));
        }
    if (ways_height > 0)
        draw_ways(s.ways, rows, view); // first: what is below has more or less rows
    for (const Group& group : groups) draw_group(group, rows);

    ImGui::PopClipRect();
    if (foot_height == 0) return card;
    const Rect foot{{rows.left, card.hi.y - foot_height - theme.px(margin_px - 4)},
                    {rows.right, card.hi.y - theme.px(margin_px - 4)}};
    std::string facts = megabytes(s.program_bytes) + ", " + megabytes(s.uploaded_bytes) + " drawn";
    for (const Timings::Stage& stage : s.evaluation.stages)
        if (stage.vertices > 0 && stage.time_ms > 0)
            facts = fmt::format("{:.1f} M vertices/s, ",
                                static_cast<double>(stage.vertices) / stage.time_ms / 1000) +
                    facts;
    const float words = foot.width() - button_width(theme, "Copy");
    paint_text(theme.font.small, foot, c.text_2, elided(theme.font.small, facts, words));
    ImGui::SetCursorScreenPos({foot.hi.x - button_width(theme, "Copy"), foot.lo.y});
    if (button(theme, "Copy", ButtonKind::quiet, {0, foot.height()}))
        ImGui::SetClipboardText(timing_text(s).c_str());
    tooltip({"Copy as text", {}, "All of these times, with the names --timings writes."});
    return card;
}

} // namespace

std::optional<Rect> draw_timing(const Theme& theme, const Rect& room, const TimingSources& sources,
                                TimingView& view, const std::string& key)
{
    const glm::vec2 at = room.lo;
    std::optional<Rect> card;
    view.other_way.reset();
    view.measure_ways = false;
    const double median = sources.history.median_ms();
    ImGui::SetCursorScreenPos({at.x, at.y});
    ImGui::PushID("timing");
    const Chip pill{milliseconds(median), timing_color(theme, median)};
    const float width = text_width(theme.font.small, pill.text) + theme.px(30);
    if (ImGui::InvisibleButton("pill", {width, theme.size.row})) view.open = !view.open;
    tooltip({"Timing", key, "Median frame time while something moved, with what was drawn."});
    paint_chip(theme, at, pill);
    if (view.open)
        card = draw_card(theme, {at + glm::vec2(0, theme.px(28)), room.hi}, sources, view);
    ImGui::PopID();
    return card;
}

} // namespace trivar::ui
