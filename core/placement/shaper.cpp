// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/shaper.h"

#include "core/base/rejected.h"
#include "core/ffd/repair.h"
#include "core/ffd/resolution.h"
#include "core/placement/finish.h"
#include "core/placement/level_surface.h"
#include "core/placement/shifting.h"
#include "core/placement/warping.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

// Throws Rejected for too many control points, and for knots that are too close or too many in one
// place for a proof.
void check_knots(const Lattice& volume, const AxisKnots& inserted)
{
    constexpr double least_span = 1e-6;
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    double points = 1;
    for (std::size_t a = 0; a < 3; ++a)
        points *= axes[a].count() + static_cast<double>(inserted[a].size());
    if (points > most_control_points)
        throw Rejected("the volume would have more than a million control points");
    for (std::size_t a = 0; a < 3; ++a) {
        std::vector<double> all = axes[a].breaks();
        all.insert(all.end(), inserted[a].begin(), inserted[a].end());
        std::ranges::sort(all);
        for (std::size_t i = 0, next = 0; i < all.size(); i = next) {
            while (next < all.size() && all[next] == all[i]) ++next;
            const int known = axes[a].multiplicity(all[i]);
            const auto further = static_cast<int>(next - i) - (known > 0 ? 1 : 0);
            if (further > 0 && known + further >= axes[a].order())
                throw Rejected("so many knots in one place would tear the volume");
            if (next < all.size() && all[next] - all[i] < least_span)
                throw Rejected("two knots would be less than a millionth apart");
        }
    }
}

LaidVolume with_knots(const LaidVolume& v, const KnotInsertion& insertion)
{
    const AxisKnots knots =
        with_images(*v.volume, {insertion.along, insertion.across, insertion.up});
    check_knots(*v.volume, knots);
    LaidVolume out = with_volume(v, refined(*v.volume, knots));
    out.as_laid = make_ref(refined(*v.as_laid, knots));
    return out;
}

LaidVolume with_fewer(const LaidVolume& v, const Coarsening& coarsening, double& deviation)
{
    const int axis = static_cast<int>(coarsening.axis);
    CoarserLattice fewer = coarsened(*v.volume, axis, coarsening.count);
    deviation = fewer.deviation;
    LaidVolume out = with_volume(v, std::move(fewer.lattice));
    out.as_laid = make_ref(coarsened(*v.as_laid, axis, coarsening.count).lattice);
    return out;
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

// Repairs folds; throws Rejected if nothing helps.
LaidVolume mended(const LaidVolume& v, Shaping& what, const Progress& progress)
{
    RepairOptions options;
    options.guard = v.guard();
    const Knots& up = v.volume->displacement.axes[2];
    while (options.ground_layer + 1 < up.count() && up.greville(options.ground_layer) < v.ground)
        ++options.ground_layer;
    const UnfoldedLattice out = unfolded(*v.volume, options, progress);
    if (!out.certified)
        throw Rejected("no way to repair the folds was found; undo the last edits of the volume, "
                       "or place the model again");
    what.asked = what.done = out.taken.moved_most;
    what.words = out.moves.empty() ? "nothing folded" : words_of(out.taken.way);
    return with_volume(v, out.lattice);
}

LaidVolume allowing(LaidVolume v, const std::vector<VolumePart>& boxes)
{
    std::vector<VolumePart> all = v.may_fold;
    if (boxes.empty()) all.clear();
    all.insert(all.end(), boxes.begin(), boxes.end());
    if (constexpr std::size_t most = 256; all.size() > most) // each cell is compared with each
        throw Rejected(fmt::format("folds can be allowed in at most {} parts of a volume", most));
    return allowing_folds(std::move(v), std::move(all));
}

// Says whether a press continues the one so far: equal except for further samples.
bool goes_on(const Press& press, Press so_far)
{
    const auto& known = so_far.samples;
    if (press.samples.size() < known.size() ||
        !std::equal(known.begin(), known.end(), press.samples.begin()))
        return false;
    so_far.samples = press.samples;
    return so_far == press;
}

// Returns the smallest det J over a node, where folds are not allowed.
double least_det(const Lattice& volume, const std::vector<Box>& may_fold, const glm::dvec2& uv)
{
    double least = std::numeric_limits<double>::infinity();
    for (const double w : {0.0, 0.5, 1.0}) {
        const glm::dvec3 uvw(uv, w);
        if (std::ranges::any_of(may_fold, [&](const Box& b) { return b.distance(uvw) == 0; }))
            continue;
        const auto [f_u, f_v, f_w] = evaluate(volume, uvw, 1).first;
        least = std::min(least, glm::dot(glm::cross(f_u, f_v), f_w));
    }
    return least;
}

// Returns the placement as if its stroke had this volume.
Placement as_shaped(Placement placement, const LaidVolume& v)
{
    const Surface<glm::dvec3> laid = std::move(placement.contact);
    placement.volume = *v.volume;
    placement.contact = level_surface(*v.volume, v.ground);
    placement.strip = outline(placement.contact);
    placement.embedding.to_rest = v.volume->rest * placement.embedding.to_uvw;
    const std::vector<Box> may_fold = v.guard().excepted;
    double least = std::numeric_limits<double>::infinity();
    double below = 0; // below its place on the stroke, along its normals
    for (std::size_t k = 0; k < placement.nodes.size(); ++k) {
        const auto columns = static_cast<std::size_t>(placement.node_columns);
        const glm::dvec2 uv(laid.axes[0].greville(static_cast<int>(k / columns)),
                            laid.axes[1].greville(static_cast<int>(k % columns)));
        StripNode& node = placement.nodes[k];
        const auto then = evaluate(laid, uv, 1);
        node.p_world = evaluate(placement.contact, uv).value;
        const glm::dvec3 up = glm::cross(then.u, then.v);
        if (const double length = glm::length(up); length > 0)
            below = std::max(below, glm::dot(then.value - node.p_world, up) / length);
        const double det = least_det(*v.volume, may_fold, uv);
        node.folds = !(det > 0);
        least = std::min(least, det);
    }
    PlacementReport& r = placement.report;
    const double laid_volume = r.length_world * r.width_world * r.height_world;
    if (!placement.nodes.empty()) // as undeformed where all may fold
        r.smallest_jacobian = std::isfinite(least) ? least / laid_volume : 1;
    if (r.height_world > 0) r.penetration = std::max(r.penetration, below / r.height_world);
    // The report of the stroke was before the edits.
    r.folds = r.smallest_jacobian > 0 ? "" : "the volume folds; repair the folds";
    return placement;
}

} // namespace

Shaper::Done Shaper::pressed(const Ref<VolumeEdit>& edit, const Ref<LaidVolume>& before,
                             const Progress& progress)
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
        const std::size_t known = press_.samples.size();
        report(progress, static_cast<double>(known) / static_cast<double>(press.samples.size()),
               "pressing");
        const glm::dvec4 sample = press.samples[known];
        so_far_.asked += sample.w;
        const Pressing::BallMotion came = pressing_->add(sample);
        so_far_.done += came.metres;
        so_far_.would_fold = so_far_.would_fold || came.would_fold;
        press_.samples.push_back(sample);
    }
    if (press.samples.size() > 1)
        so_far_.done = std::copysign(pressing_->farthest(), so_far_.asked);
    return {edit, make_ref(with_volume(*before, pressing_->volume(), pressing_->verdicts())),
            so_far_};
}

Shaper::Done Shaper::shifted(const Ref<VolumeEdit>& edit, const Ref<LaidVolume>& before)
{
    const PointShift& shift = *edit->shift;
    const std::vector<PointMove> wanted = moves_of(*before->volume, shift);
    std::vector<PointMove> moves = wanted;
    std::optional<CellVerdicts> verdicts;
    double share = 1;
    if (shift.guard) {
        CertifiedShare proven =
            certified_share(*before->volume, *before->verdicts, moves, before->guard());
        share = proven.share;
        moves = scaled(moves, share);
        verdicts = std::move(proven.after);
    }
    double asked = glm::length(shift.by);
    if (shift.rotation_deg != glm::dvec3(0) || shift.factors != glm::dvec3(1)) {
        asked = 0;
        for (const PointMove& move : wanted) asked = std::max(asked, glm::length(move.by));
    }
    return {edit,
            make_ref(with_volume(*before, moved(*before->volume, moves), std::move(verdicts))),
            {.asked = asked, .done = share * asked, .would_fold = share < 1}};
}

Shaper::Done Shaper::done(const Ref<VolumeEdit>& edit, const Ref<LaidVolume>& before,
                          const Progress& progress)
{
    try {
        if (edit->press) return pressed(edit, before, progress);
        if (edit->shift) return shifted(edit, before);
        LaidVolume after = *before;
        Shaping what;
        if (edit->insertion) after = with_knots(after, *edit->insertion);
        if (edit->coarsening) {
            after = with_fewer(after, *edit->coarsening, what.done);
            what.asked = what.done;
        }
        if (edit->mending) after = mended(after, what, progress);
        if (edit->warp) {
            WarpedVolume bent = warped(after, *edit->warp);
            after = std::move(bent.volume);
            what.done = bent.moved;
            what.asked = bent.share > 0 ? bent.moved / bent.share : bent.moved;
            what.would_fold = bent.share < 1;
        }
        if (edit->allowance) after = allowing(std::move(after), edit->allowance->boxes);
        return {edit, make_ref(std::move(after)), what};
    } catch (const Rejected& error) {
        return {edit, before, {.notice = error.what()}};
    }
}

// Forgets volumes that are long ago: the one after step i is kept for 4 * 2^z more steps, where 2^z
// divides i.
void Shaper::forget()
{
    const std::size_t n = done_.size();
    for (std::size_t i = 1; i <= n; ++i)
        if (const std::size_t ago = n - i; ago >= 4 * (i & (~i + 1))) done_[i - 1].after = nullptr;
}

std::size_t Shaper::remembered() const
{
    return static_cast<std::size_t>(
        std::ranges::count_if(done_, [](const Done& step) { return step.after != nullptr; }));
}

Ref<ShapedVolume> Shaper::operator()(const Ref<Placement>& laid,
                                     const std::vector<Ref<VolumeEdit>>& edits,
                                     const Progress& progress)
{
    if (laid != laid_) {
        laid_ = laid;
        begun_ = make_ref(laid_volume(laid->volume, laid->ground));
        done_.clear();
        last_ = nullptr;
    }
    std::size_t same = 0;
    while (same < edits.size() && same < done_.size() &&
           (edits[same] == done_[same].edit || *edits[same] == *done_[same].edit))
        ++same;
    if (last_ && same == edits.size() && same == done_.size()) return last_;
    last_ = nullptr;
    done_.resize(same);
    // Steps that are not remembered are done again.
    while (!done_.empty() && !done_.back().after) done_.pop_back();
    const auto share = [&](std::size_t step) {
        return static_cast<double>(step) / static_cast<double>(edits.size());
    };
    while (done_.size() < edits.size()) {
        const std::size_t step = done_.size();
        report(progress, share(step), "shaping");
        done_.push_back(done(edits[step], done_.empty() ? begun_ : done_.back().after,
                             part_of(progress, share(step), share(step + 1))));
        forget();
    }
    const Ref<LaidVolume> after = done_.empty() ? begun_ : done_.back().after;
    ShapedVolume out{edits.empty() ? laid : make_ref(as_shaped(*laid, *after)), after, {}};
    for (const Done& step : done_) out.steps.push_back(step.what);
    last_ = make_ref(std::move(out));
    return last_;
}

} // namespace trivar
