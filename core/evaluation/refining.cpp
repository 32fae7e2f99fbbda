// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/refining.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

Part in_the_same_volume(const Part& part, const Ref<Mesh>& mesh)
{
    if (mesh == part.before_volume()) return part;
    const Ref<Bent> bent = part.bent;
    const Lazy<Ref<Mesh>> out(
        [=] { return make_ref(deform(*mesh, bent->embedding, *bent->volume)); });
    return {.rest = mesh,
            .bent = make_ref(Bent{bent->embedding, bent->volume, out}),
            .slot = part.slot,
            .bounds = part.bounds};
}

Laid refined(const Laid& laid, const Refining& refining, const Progress& progress)
{
    Laid out = laid;
    try {
        SplitParts made = split(laid.parts,
                                {.tolerance_world = refining.tolerance,
                                 .split = refining.split,
                                 .method = refining.method,
                                 .rule = refining.rule,
                                 .budget = static_cast<std::size_t>(refining.budget)},
                                progress);
        out.refined = std::move(made.refined);
        out.parts = std::move(made.parts);
    } catch (const Rejected& error) {
        out.not_refined = std::string("it is not refined: ") + error.what();
        return out;
    }
    out.not_refined = notice_of(*out.refined, refining);
    return out;
}

} // namespace

SplitParts split(const std::vector<Part>& parts, const RefineOptions& options,
                 const Progress& progress)
{
    std::vector<RefinePart> given;
    for (const Part& part : parts) given.push_back({part.before_volume(), part.bent->embedding});
    SplitParts out;
    out.refined = make_ref(refine(given, *parts.front().bent->volume, options, progress));
    for (std::size_t p = 0; p < parts.size(); ++p)
        out.parts.push_back(in_the_same_volume(parts[p], out.refined->parts[p].mesh));
    return out;
}

std::string notice_of(const Refined& refined, const Refining& refining)
{
    const std::size_t open = refined.not_certified();
    if (open == 0) return {};
    if (refining.rule == RefinementRule::chua_neumann_midpoint)
        return "its triangles are refined by the middles of their edges, which certifies nothing";
    return fmt::format(
        "{} of its {} triangles are not certified to be within {:.3g} m: {}", open,
        refined.triangles(), refining.tolerance,
        refined.out_of_budget ? fmt::format("the budget of {} triangles is spent", refining.budget)
        : std::isfinite(refined.bound) ? "their edges are too short to be split further"
                                       : "the bound says nothing of some of them");
}

Ref<Laid> RefiningLaid::operator()(const Ref<Laid>& laid, const Refining& refining,
                                   Timings& timings, const Progress& progress)
{
    if (laid->parts.empty() || !laid->parts.front().bent) return laid;
    const auto found = std::ranges::find_if(known_, [&](const Known& known) {
        return known.laid == laid && known.refining == refining;
    });
    if (found != known_.end()) {
        std::rotate(known_.begin(), found, found + 1);
    } else {
        Ref<Laid> out =
            timed(timings, "refine", [&] { return make_ref(refined(*laid, refining, progress)); });
        known_.insert(known_.begin(), {laid, refining, std::move(out)});
        constexpr std::size_t kept_results = 3; // as Laying keeps
        if (known_.size() > kept_results) known_.pop_back();
    }
    return known_.front().refined;
}

} // namespace trivar
