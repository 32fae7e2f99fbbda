// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/shape.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/changes.h"
#include "core/commands/words/field_words.h"
#include "core/placement/pressing.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

const char* axis_name(VolumeAxis axis, bool box)
{
    static constexpr std::array<const char*, 3> of_box{"along X", "along Y", "along Z"},
        of_stroke{"along the stroke", "across it", "upward"};
    return (box ? of_box : of_stroke)[static_cast<std::size_t>(axis)];
}

} // namespace

Document with_step(Document document, Id id, VolumeEdit edit)
{
    const Object& o = object(document, id);
    check_has_volume(o, id);
    if (o.shaping.size() >= most_shaping_steps)
        throw Rejected(
            fmt::format("{} is shaped in {} steps already, which is the most; remove some first",
                        named(id, o), most_shaping_steps));
    return with_changed(std::move(document), id, [&](Object& changed) {
        changed.shaping.push_back(make_ref(std::move(edit)));
    });
}

void check(const VolumeEdit& edit)
{
    const int kinds = int{edit.press.has_value()} + int{edit.shift.has_value()} +
                      int{edit.insertion.has_value()} + int{edit.coarsening.has_value()} +
                      int{edit.mending.has_value()} + int{edit.allowance.has_value()} +
                      int{edit.warp.has_value()};
    if (kinds != 1) throw Rejected("a step of shaping must be exactly one of the seven kinds");
    if (edit.press) check(*edit.press);
    if (edit.shift && edit.shift->points.empty())
        throw Rejected("field \"points\" is empty; name the control points that move");
    if (edit.shift)
        for (const glm::ivec3& p : edit.shift->points)
            if (p.x < 0 || p.y < 0 || p.z < 0)
                throw Rejected(fmt::format("field \"points\" names {}, {}, {}, but control points "
                                           "are numbered from 0",
                                           p.x, p.y, p.z));
    if (edit.shift && !edit.shift->weights.empty() &&
        edit.shift->weights.size() != edit.shift->points.size())
        throw Rejected(fmt::format("field \"weights\" has {} numbers for {} points; give one for "
                                   "each, or none",
                                   edit.shift->weights.size(), edit.shift->points.size()));
    if (edit.allowance)
        for (const VolumePart& box : edit.allowance->boxes)
            for (int i = 0; i < 3; ++i)
                if (!(box.lo[i] >= 0 && box.lo[i] < box.hi[i] && box.hi[i] <= 1))
                    throw Rejected("field \"boxes\": a box lies between 0 and 1 along u, v and w, "
                                   "with lo below hi");
    if (edit.insertion) {
        const KnotInsertion& k = *edit.insertion;
        if (k.along.empty() && k.across.empty() && k.up.empty())
            throw Rejected("fields \"along\", \"across\" and \"up\" are empty; say where "
                           "control points are wanted");
        for (const std::vector<double>& at : {k.along, k.across, k.up})
            for (const double t : at)
                if (!(t > 0 && t < 1))
                    throw Rejected("fields \"along\", \"across\" and \"up\" must lie between "
                                   "0 and 1, ends excluded");
    }
}

Document applied(Document document, const PressVolume& command)
{
    VolumeEdit edit{.press = command.press};
    check(edit);
    return with_step(std::move(document), command.object, std::move(edit));
}

StepTitle title(const PressVolume& c, const StepDocuments& step)
{
    double amount = 0;
    for (const glm::dvec4& sample : c.press.samples) amount += sample.w;
    static constexpr std::array<const char*, 4> decays{"Gaussian", "Hat", "Box", "Smooth"};
    return {(amount < 0 ? "Pull " : "Press ") + name_in(step.before, c.object),
            fmt::format("{} {}", decays[static_cast<std::size_t>(c.press.decay)],
                        in_metres(c.press.radius))};
}

Document applied(Document document, const MovePoints& command)
{
    VolumeEdit edit{.shift = command.shift};
    check(edit);
    return with_step(std::move(document), command.object, std::move(edit));
}

StepTitle title(const MovePoints& c, const StepDocuments& step)
{
    const PointShift& s = c.shift;
    const auto held = std::ranges::count_if(s.weights, [](double w) { return w == 1; });
    const std::size_t count = held > 0 ? static_cast<std::size_t>(held) : s.points.size();
    const std::string points =
        (count == 1 ? "a control point" : fmt::format("{} control points", with_commas(count))) +
        " of " + name_in(step.before, c.object);
    if (s.rotation_deg != glm::dvec3(0))
        return {"Turn " + points, value_words(s.rotation_deg, any_value.in(Unit::degrees))};
    if (s.factors != glm::dvec3(1))
        return {"Scale " + points, value_words(s.factors, any_value.in(Unit::times))};
    return {"Move " + points, in_metres(glm::length(s.by))};
}

Document applied(Document document, const InsertKnots& command)
{
    VolumeEdit edit{.insertion = command.insertion};
    check(edit);
    return with_step(std::move(document), command.object, std::move(edit));
}

StepTitle title(const InsertKnots& c, const StepDocuments& step)
{
    const std::size_t more =
        c.insertion.along.size() + c.insertion.across.size() + c.insertion.up.size();
    return {"Refine the volume of " + name_in(step.before, c.object),
            fmt::format("{} {}", more, more == 1 ? "knot" : "knots")};
}

Document applied(Document document, const CoarsenVolume& command)
{
    return with_step(std::move(document), command.object, {.coarsening = command.coarsening});
}

StepTitle title(const CoarsenVolume& c, const StepDocuments& step)
{
    return {"Coarsen the volume of " + name_in(step.before, c.object),
            fmt::format("to {} points {}", c.coarsening.count,
                        axis_name(c.coarsening.axis, is_lattice(step.before, c.object)))};
}

Document applied(Document document, const MendVolume& command)
{
    return with_step(std::move(document), command.object, {.mending = Mending{}});
}

StepTitle title(const MendVolume& c, const StepDocuments& step)
{
    return {"Repair folds in " + name_in(step.before, c.object), {}};
}

Document applied(Document document, const AllowFolds& command)
{
    VolumeEdit edit{.allowance = command.allowance};
    check(edit);
    return with_step(std::move(document), command.object, std::move(edit));
}

StepTitle title(const AllowFolds& c, const StepDocuments& step)
{
    const std::string name = name_in(step.before, c.object);
    if (c.allowance.boxes.empty()) return {"Let " + name + " fold nowhere", {}};
    return {"Let " + name + " fold in places", {}};
}

Document applied(Document document, const Unshape& command)
{
    const Object& o = object(document, command.object);
    check_has_volume(o, command.object);
    std::vector<Ref<VolumeEdit>> left;
    for (const int step : command.steps)
        if (static_cast<std::size_t>(step) > o.shaping.size())
            throw Rejected(
                fmt::format("field \"steps\": {} is shaped in {} steps; there is no step {}",
                            o.name, o.shaping.size(), step));
    const std::set<int> gone(command.steps.begin(), command.steps.end());
    for (std::size_t i = 0; i < o.shaping.size(); ++i)
        if (!gone.empty() && !gone.contains(static_cast<int>(i) + 1)) left.push_back(o.shaping[i]);
    return with_changed(std::move(document), command.object,
                        [&](Object& changed) { changed.shaping = std::move(left); });
}

StepTitle title(const Unshape& c, const StepDocuments& step)
{
    return {"Take back the shaping of " + name_in(step.before, c.object), {}};
}

} // namespace trivar
