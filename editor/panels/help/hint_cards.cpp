// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/hint_steps.h"
#include "editor/actions/model_actions.h"
#include "editor/panels/help/welcome.h"
#include "editor/panels/panels.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {

namespace {

// The offers on the card, at scale 1: pictures of models in a row, and below them links.
constexpr glm::vec2 tile_size{80, 66};
constexpr float tile_gap = 8, row_gap = 10, link_height = 22;

struct Offers {
    std::vector<const OwnModel*> models;
    std::vector<const Action*> links;
    float height = 0;
};

// Chooses as many of the models as fit.
Offers offers_of(Editor& editor, const ui::Theme& theme, const HintCard& card,
                 const glm::vec2& room)
{
    Offers out;
    const float pitch = theme.px(tile_size.x + tile_gap);
    const bool high = room.y > theme.px(4 * tile_size.y);
    for (const std::string& name : card.offers) {
        const auto model = std::ranges::find(own_models(), name, &OwnModel::name);
        if (model == own_models().end())
            out.links.push_back(&action(editor, name));
        else if (high && static_cast<float>(out.models.size() + 1) * pitch <= room.x)
            out.models.push_back(&*model);
    }
    if (!out.models.empty()) out.height += theme.px(tile_size.y + row_gap);
    if (!out.links.empty()) out.height += theme.px(link_height);
    return out;
}

void draw_offers(Editor& editor, const ui::Theme& theme, const Offers& offers, glm::vec2 at)
{
    const Action* chosen = nullptr;
    const glm::vec2 tile = theme.px(1) * tile_size;
    for (std::size_t i = 0; i < offers.models.size(); ++i) {
        const glm::vec2 lo = at + glm::vec2(static_cast<float>(i) * (tile.x + theme.px(tile_gap)),
                                            theme.px(row_gap) / 2);
        if (draw_model(editor, theme, ui::rect_at(lo, tile), *offers.models[i]))
            chosen = &action(editor, offers.models[i]->name);
    }
    if (!offers.models.empty()) at.y += tile.y + theme.px(row_gap);
    for (const Action* each : offers.links) {
        const std::string key = key_text(*each);
        const glm::vec2 size{ui::text_width(theme.font.body, each->name), theme.px(link_height)};
        if (text_link(editor, theme, ui::rect_at(at, size), each->name)) chosen = each;
        at.x += size.x + theme.px(8);
        ui::paint_text(theme.font.small, ui::rect_at(at, size), theme.color.text_3, key);
        at.x += ui::text_width(theme.font.small, key) + theme.px(20);
    }
    if (chosen) chosen->run(editor);
}

} // namespace

std::optional<ui::Rect> draw_hint_card(Editor& editor, const ui::Theme& theme, const ui::Rect& view)
{
    const auto card = hint_card(editor);
    if (!card) return {};
    const ui::Palette& c = theme.color;
    const float left = theme.px(58), right = theme.px(16), line = theme.px(18), top = theme.px(10);
    const std::string count = card->number > 0 ? fmt::format("{} of 3", card->number) : "";
    const float beside = ui::text_width(theme.font.small, count) + theme.px(48); // and the cross
    // Where there is room it stands beside notices whether there are any or not, so that it stays
    // where it is as they come and go.
    const float beside_notices = ui::Notices::left_of(theme, view);
    const bool room = beside_notices - view.lo.x > theme.px(440);
    const bool notices = room || !editor.session.notices.all().empty();
    const float end = notices ? beside_notices : view.hi.x;
    const float widest = end - view.lo.x - theme.px(24);
    if (widest < theme.px(240)) return {};
    const Offers offers = offers_of(editor, theme, *card, {widest - left - right, view.height()});
    const std::string& body =
        offers.models.empty() || card->with_models.empty() ? card->body : card->with_models;
    const float row = static_cast<float>(offers.models.size()) * theme.px(tile_size.x + tile_gap) -
                      theme.px(tile_gap);
    const float most = std::min(std::max(theme.px(440), left + row + right), widest);
    const float title = ui::text_width(theme.font.strong, card->title) + beside;
    const float body_width = ui::text_width(theme.font.body, body) + right;
    const float width = std::min(most, left + std::max({title, body_width, row + right}));
    const auto lines = ui::wrapped(theme.font.body, body, width - left - right);
    const glm::vec2 size{width,
                         theme.px(46) + line * static_cast<float>(lines.size()) + offers.height};
    float x = std::round(view.center().x - width / 2);
    if (notices) x = std::min(x, end - theme.px(12) - width);
    const ui::Rect r = ui::rect_at({x, view.hi.y - size.y - theme.px(16)}, size);
    ui::paint_card(theme, r);
    ui::lower_area("hint", r); // takes the clicks
    const float upper = r.height() - offers.height;
    ui::paint_text(theme.font.large_icon,
                   {r.lo + glm::vec2(theme.px(16), 0), {r.hi.x, r.lo.y + upper}}, c.stroke,
                   ui::icon::place);
    const ui::Rect head = {{r.lo.x + left, r.lo.y + top},
                           {r.hi.x - theme.px(40), r.lo.y + top + theme.px(22)}};
    ui::paint_text(theme.font.strong, head, c.text,
                   ui::elided(theme.font.strong, card->title, width - left - beside));
    ui::paint_text(theme.font.small, head, c.text_3, count, ui::Align::right);
    float y = head.hi.y + theme.px(2);
    for (const std::string& each : lines) {
        ui::paint_text(theme.font.body, {{r.lo.x + left, y}, {r.hi.x, y + line}}, c.text_2, each);
        y += line;
    }
    ImGui::SetCursorScreenPos({r.hi.x - theme.px(34), r.lo.y + theme.px(8)});
    if (ui::icon_button(theme, "close hint", ui::icon::close, glm::vec2(theme.size.icon_button),
                        {"Close this hint", {}, "Help brings it back."}))
        close_hint(editor, card->name);
    draw_offers(editor, theme, offers, {r.lo.x + left, y});
    return r;
}

} // namespace trivar
