// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/shaper.h"

#include "core/base/rejected.h"
#include "core/ffd/repair.h"
#include "core/ffd/resolution.h"
#include "core/placement/finish.h"
#include "core/spline/iso.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace trivar {
namespace {

LaidVolume with_knots(LaidVolume v, const KnotInsertion& insertion)
{
    for (Lattice* each : {&v.volume, &v.as_laid})
        *each = refined(*each, {insertion.along, insertion.across, insertion.up});
    return v;
}

Coarsened with_fewer(LaidVolume& v, const Coarsening& coarsening)
{
    const int axis = static_cast<int>(coarsening.axis);
    Coarsened fewer = coarsened(v.volume, axis, coarsening.count);
    v.as_laid = coarsened(v.as_laid, axis, coarsening.count).lattice;
    v.volume = fewer.lattice;
    return fewer;
}

const char* words_of(RepairWay way)
{
    switch (way) {
    case RepairWay::smoothed_directions: return "columns were turned toward their neighbours";
    case RepairWay::lowered_heights: return "it was lowered";
    case RepairWay::monotone_columns: return "layers were put back in order";
    case RepairWay::evened: return "points round a fold were evened";
    case RepairWay::relaxed: return "folds were opened";
    }
    return "";
}

// What is done where it folds; throws Rejected where nothing helps.
Shaping mended(LaidVolume& v)
{
    RepairOptions options;
    const Knots& up = v.volume.displacement.axes[2];
    while (options.ground_layer + 1 < up.count() && up.greville(options.ground_layer) < v.ground)
        ++options.ground_layer;
    const Unfolded out = unfolded(v.volume, options);
    if (!out.certified)
        throw Rejected("the volume folds, and no change was found after which it does not; take "
                       "the last steps back, or place it anew");
    v.volume = out.lattice;
    Shaping what;
    what.asked = what.done = out.taken.moved_most;
    what.words = out.moves.empty() ? "nothing folded" : words_of(out.taken.way);
    return what;
}

// Where the points of a shift go; those mirrored the other way across.
std::vector<PointMove> moves_of(const Lattice& volume, const PointShift& shift)
{
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    const glm::ivec3 n(axes[0].count(), axes[1].count(), axes[2].count());
    for (const glm::ivec3& p : shift.points)
        for (int a = 0; a < 3; ++a)
            if (p[a] < 0 || p[a] >= n[a])
                throw Rejected(fmt::format("there is no control point {}, {}, {} any more; the "
                                           "volume has {} x {} x {}",
                                           p.x, p.y, p.z, n.x, n.y, n.z));
    std::map<std::array<int, 3>, glm::dvec3> by; // each point once
    const auto mirrored = [&](const glm::ivec3& p) { return glm::ivec3(p.x, n.y - 1 - p.y, p.z); };
    const auto move = [&](const glm::ivec3& p, const glm::dvec3& world, bool in_middle) {
        const VolumeDirections frame = volume_frame(volume, greville(volume, p));
        const glm::dvec3 across =
            in_middle ? glm::dot(world, frame.across) * frame.across : glm::dvec3(0);
        by.emplace(std::array{p.x, p.y, p.z}, world - across);
    };
    const auto all = [&](bool other_side) {
        const glm::ivec3 first = other_side ? mirrored(shift.points.front()) : shift.points.front();
        const VolumeDirections frame = volume_frame(volume, greville(volume, first));
        const glm::dvec3 world =
            frame.to_world(other_side ? shift.by * glm::dvec3(1, -1, 1) : shift.by);
        for (const glm::ivec3& p : shift.points)
            move(other_side ? mirrored(p) : p, world, shift.mirror && 2 * p.y == n.y - 1);
    };
    if (!shift.points.empty()) all(false);
    if (!shift.points.empty() && shift.mirror) all(true);
    std::vector<PointMove> out;
    for (const auto& [p, world] : by) out.push_back({{p[0], p[1], p[2]}, world});
    return out;
}

// The same press but for its samples, of which the first are those.
bool goes_on(const Press& press, Press so_far)
{
    const auto& known = so_far.samples;
    if (press.samples.size() < known.size() ||
        !std::equal(known.begin(), known.end(), press.samples.begin()))
        return false;
    so_far.samples = press.samples;
    return so_far == press;
}

// The surface that lies on the scene, in the world.
Surface<glm::dvec3> contact_of(const LaidVolume& v)
{
    Surface<glm::dvec3> contact = iso_surface(v.volume.displacement, 2, v.ground);
    for (int i = 0; i < contact.axes[0].count(); ++i)
        for (int j = 0; j < contact.axes[1].count(); ++j) {
            const glm::dvec3 uvw(contact.axes[0].greville(i), contact.axes[1].greville(j),
                                 v.ground);
            contact.points[contact.index(i, j)] += glm::dvec3(v.volume.rest * glm::dvec4(uvw, 1));
        }
    return contact;
}

double least_det(const Lattice& volume, const glm::dvec2& uv)
{
    double least = std::numeric_limits<double>::infinity();
    for (const double w : {0.0, 0.5, 1.0}) {
        const auto [f_u, f_v, f_w] = evaluate(volume, {uv.x, uv.y, w}, 1).first;
        least = std::min(least, glm::dot(glm::cross(f_u, f_v), f_w));
    }
    return least;
}

// The placement as if its stroke had given that volume.
Placement with_volume(Placement placement, const LaidVolume& v)
{
    const Surface<glm::dvec3> laid = std::move(placement.contact);
    placement.volume = v.volume;
    placement.contact = contact_of(v);
    placement.strip = outline(placement.contact);
    placement.embedding.to_rest = v.volume.rest * placement.embedding.to_uvw;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < placement.nodes.size(); ++k) {
        const auto columns = static_cast<std::size_t>(placement.node_columns);
        const glm::dvec2 uv(laid.axes[0].greville(static_cast<int>(k / columns)),
                            laid.axes[1].greville(static_cast<int>(k % columns)));
        StripNode& node = placement.nodes[k];
        node.p_world = evaluate(placement.contact, uv).value;
        const double det = least_det(v.volume, uv);
        node.folds = !(det > 0);
        least = std::min(least, det);
    }
    PlacementReport& r = placement.report;
    if (!placement.nodes.empty())
        r.smallest_jacobian = least / (r.length_world * r.width_world * r.height_world);
    return placement;
}

} // namespace

Shaper::Done Shaper::pressed(const Ref<VolumeEdit>& edit, const Ref<LaidVolume>& before)
{
    const Press& press = *edit->press;
    check(press);
    if (!pressing_ || pressed_from_ != before || !goes_on(press, press_)) {
        pressing_.emplace(*before, press);
        pressed_from_ = before;
        so_far_ = {};
        press_ = press;
        press_.samples.clear();
    }
    while (press_.samples.size() < press.samples.size()) {
        const glm::dvec4 sample = press.samples[press_.samples.size()];
        so_far_.asked += sample.w;
        so_far_.done += pressing_->add(sample);
        press_.samples.push_back(sample);
    }
    LaidVolume after = *before;
    after.volume = pressing_->volume();
    return {edit, make_ref(std::move(after)), so_far_};
}

Shaper::Done Shaper::done(const Ref<VolumeEdit>& edit, const Ref<LaidVolume>& before)
{
    try {
        if (edit->press) return pressed(edit, before);
        LaidVolume after = *before;
        Shaping what;
        if (edit->shift) {
            std::vector<PointMove> moves = moves_of(before->volume, *edit->shift);
            const double share = edit->shift->guard ? certified_share(after.volume, moves) : 1;
            for (PointMove& move : moves) move.by *= share;
            after.volume = moved(std::move(after.volume), moves);
            what.asked = glm::length(edit->shift->by);
            what.done = share * what.asked;
        }
        if (edit->insertion) after = with_knots(std::move(after), *edit->insertion);
        if (edit->coarsening)
            what.asked = what.done = with_fewer(after, *edit->coarsening).deviation;
        if (edit->mending) what = mended(after);
        return {edit, make_ref(std::move(after)), what};
    } catch (const Rejected& error) {
        return {edit, before, {.notice = error.what()}};
    }
}

Ref<ShapedVolume> Shaper::operator()(const Ref<Placement>& laid,
                                     const std::vector<Ref<VolumeEdit>>& edits)
{
    if (laid != laid_) {
        laid_ = laid;
        begun_ = make_ref(LaidVolume{laid->volume, laid->volume, laid->ground});
        done_.clear();
        last_ = nullptr;
    }
    std::size_t same = 0;
    while (same < edits.size() && same < done_.size() &&
           (edits[same] == done_[same].edit || *edits[same] == *done_[same].edit))
        ++same;
    if (last_ && same == edits.size() && same == done_.size()) return last_;
    done_.resize(same);
    while (done_.size() < edits.size())
        done_.push_back(done(edits[done_.size()], done_.empty() ? begun_ : done_.back().after));
    const Ref<LaidVolume>& after = done_.empty() ? begun_ : done_.back().after;
    ShapedVolume out{edits.empty() ? laid : make_ref(with_volume(*laid, *after)), after, {}};
    for (const Done& step : done_) out.steps.push_back(step.what);
    last_ = make_ref(std::move(out));
    return last_;
}

} // namespace trivar
