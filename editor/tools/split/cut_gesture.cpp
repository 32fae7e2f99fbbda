// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/split/cut_gesture.h"

#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/session.h"
#include "editor/session/topics.h"
#include "ui/paint.h"

#include <algorithm>

namespace trivar {

CutThrough with_cut(const Session& session, Id id, PlainCut cut, const Cutting& settings)
{
    const std::optional<Cutting>& known = object(session.committed(), id).cutting;
    CutThrough out{{id}, known.value_or(settings)};
    if (!known) out.cutting.cuts.clear();
    out.cutting.cuts.push_back(std::move(cut));
    return out;
}

bool CutGesture::begin(Session& session, const ViewportInput& input, bool straight)
{
    const Id id = session.selected;
    const auto shown = session.evaluated().objects.find(id);
    if (shown == session.evaluated().objects.end() ||
        !kind_of(session.document(), id).has_surface || shown->second->parts.empty())
        return false;
    object_ = id;
    under_ = input.under;
    straight_ = straight;
    const std::optional<Cutting>& known = object(session.committed(), id).cutting;
    const EvaluatedObject& seen = *shown->second;
    way_ = DrawnWay{{}, session.view.camera, seen.own_to_world, seen.bounds->center()};
    way_->parted = seen.split_apart;
    if (known) {
        // In the order in which they are made: nothing that parted pieces are cut by comes before
        way_->parted |= std::ranges::any_of(known->cuts, &PlainCut::parted);
        way_->opened = seen.cuts_open;
        way_->opened.resize(std::min(way_->opened.size(), known->cuts.size()));
        if (std::ranges::all_of(way_->opened, [](auto& off) { return off == glm::dvec3(0); }))
            way_->opened.clear();
    }
    session.notices.forget(of_a_step);
    return true;
}

std::optional<PlainCut> CutGesture::cut(const PlainCut& one, std::string* why) const
{
    std::optional<PlainCut> out =
        straight_ ? cut_along_line(*way_, why) : cut_along_way(*way_, why);
    if (!out) return {};
    out->keep = one.keep;
    out->gap = one.gap;
    return out;
}

void CutGesture::go_on(Session& session, const ViewportInput& input, const PlainCut& one,
                       const Cutting& settings)
{
    std::vector<glm::dvec2>& points = way_->points_px;
    if (points.empty() && input.moves.empty()) points.push_back(input.mouse);
    const std::size_t before = points.size();
    for (const StrokeSample& move : input.moves)
        if (points.empty() || points.back() != move.p_px) points.push_back(move.p_px);
    if (!session.document().objects.contains(object_)) return cancel(session);
    std::string why;
    const std::optional<PlainCut> drawn = cut(one, &why);
    if (!input.released && input.down) {
        if (drawn && points.size() != before && session.up_to_date())
            session.propose_quietly(with_cut(session, object_, *drawn, settings));
        return;
    }
    const bool clicked = std::ranges::all_of(points, [&](const glm::dvec2& p) {
        return glm::distance(p, points.front()) <= click_slip_px;
    });
    const Id object = object_, under = under_;
    way_.reset();
    if (drawn && session.propose(with_cut(session, object, *drawn, settings))) {
        session.commit();
        return;
    }
    session.cancel();
    if (clicked)
        select_by_click(session, under);
    else if (!drawn)
        session.notices.say(ui::NoticeKind::warning, "This cuts nothing", why, of_a_step);
}

void CutGesture::cancel(Session& session)
{
    if (!way_) return;
    way_.reset();
    session.cancel();
}

void CutGesture::paint(const ui::Theme& theme, const ViewportInput& input) const
{
    if (!way_ || way_->points_px.size() < 2) return;
    std::vector<glm::vec2> path;
    for (const glm::dvec2& p : way_->points_px) path.push_back(input.rect.lo + glm::vec2(p));
    if (straight_) path = {path.front(), path.back()};
    ui::paint_path(path, theme.color.halo, theme.line(3.5f));
    ui::paint_path(path, theme.color.incision, theme.line(1.8f));
}

} // namespace trivar
