// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/bending/refining.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"

#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// Lists the volumes that deform a part after the first one.
std::vector<NextVolume> later_volumes(const Part& part)
{
    std::vector<NextVolume> out;
    for (const Part* each = &part; each->bent->inner; each = each->bent->inner.get())
        out.insert(out.begin(), {each->bent->embedding, each->bent->volume});
    return out;
}

Stage refined(const Stage& before, const Refining& refining, const Progress& progress)
{
    Stage out = before;
    try {
        SplitParts made = split(before.parts,
                                {.tolerance_world = refining.tolerance,
                                 .split = refining.split,
                                 .method = refining.method,
                                 .rule = refining.rule,
                                 .budget = static_cast<std::size_t>(refining.budget)},
                                progress);
        out.refined = std::move(made.refined);
        out.parts = std::move(made.parts);
        if (const std::string notice = notice_of(*out.refined, refining); !notice.empty())
            out.notices.push_back(notice);
    } catch (const Rejected& error) {
        out.notices.push_back(std::string("it is not refined: ") + error.what());
    }
    return out;
}

} // namespace

SplitParts split(const std::vector<Part>& parts, const RefineOptions& options,
                 const Progress& progress)
{
    std::vector<RefinePart> given;
    for (const Part& part : parts) {
        const Part& first = innermost(part);
        given.push_back({first.before_volume(), first.bent->embedding});
    }
    SplitParts out;
    out.refined = make_ref(refine(given, *innermost(parts.front()).bent->volume, options, progress,
                                  later_volumes(parts.front())));
    for (std::size_t p = 0; p < parts.size(); ++p)
        if (const Ref<Mesh>& mesh = out.refined->parts[p].mesh;
            mesh == innermost(parts[p]).before_volume())
            out.parts.push_back(parts[p]);
        else
            out.parts.push_back(with_innermost(parts[p], mesh));
    return out;
}

RefinementResult bounded(const Part& part, const RefineOptions& options)
{
    const Part& first = innermost(part);
    return bounded({{first.before_volume(), first.bent->embedding}}, *first.bent->volume, options,
                   {}, later_volumes(part));
}

std::string notice_of(const RefinementResult& refined, const Refining& refining)
{
    const std::size_t open = refined.not_certified();
    if (open == 0) return {};
    if (refining.rule == RefinementRule::chua_neumann_midpoint)
        return "its triangles are refined by the middles of their edges, which certifies nothing";
    return fmt::format(
        "{} of its {} triangles are not certified to be within {} m: {}", with_commas(open),
        with_commas(refined.triangles()), number_text(refining.tolerance),
        refined.out_of_budget
            ? fmt::format("the {} triangles {}", with_commas(refining.budget), spent_budget_words)
        : std::isfinite(refined.bound) ? "their edges are too short to be split further"
                                       : "some of them have no bound");
}

bool lies_in_a_volume(const Stage& stage)
{
    return !stage.parts.empty() && stage.parts.front().bent;
}

Ref<Stage> RefiningStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const std::optional<Refining>& refining = input.object.refining;
    if (!refining || !lies_in_a_volume(*before)) return before;
    return known_({before, *refining}, [&] {
        return timed(input.timings, "refine",
                     [&] { return make_ref(refined(*before, *refining, input.progress)); });
    });
}

} // namespace trivar
