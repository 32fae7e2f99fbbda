// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/deform_findings.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar::gpu {
namespace {

constexpr Method exact_normals{}, no_normals{Sum::nested, NormalsBy::nothing},
    by_differences{Sum::nested, NormalsBy::differences};

class Rates {
public:
    Rates(const std::vector<DeformRate>& rates, int order, std::size_t vertices)
        : rates_(rates),
          order_(order),
          vertices_(vertices)
    {
    }
    const DeformRate* find(Way way, const Method& method, int passes) const
    {
        const DeformCase what{way, method, order_, 8, vertices_, passes};
        const auto found = std::ranges::find(rates_, what, &DeformRate::what);
        return found == rates_.end() ? nullptr : &*found;
    }
    // Milliseconds, or -1.
    double operator()(Way way, const Method& method, int passes) const
    {
        const DeformRate* found = find(way, method, passes);
        return found ? found->time_ms : -1;
    }

private:
    const std::vector<DeformRate>& rates_;
    int order_;
    std::size_t vertices_;
};

std::string of_passes(const Rates& ms)
{
    std::array<double, 3> one, two;
    for (int i = 0; i < 3; ++i) {
        one[static_cast<std::size_t>(i)] = ms(Way::one_phase, exact_normals, i + 1);
        two[static_cast<std::size_t>(i)] = ms(Way::two_phases, exact_normals, i + 1);
    }
    if (std::ranges::min(one) < 0 || std::ranges::min(two) < 0) return {};
    std::size_t from = 3;
    while (from > 0 && two[from - 1] < one[from - 1]) --from;
    constexpr std::array<const char*, 4> verdicts{
        "two phases cost less from the first pass on", "two phases cost less from the second on",
        "two phases cost less from the third on", "two phases cost more"};
    return fmt::format("drawn in 1, 2 and 3 passes, one phase takes {:.3g}, {:.3g} and {:.3g} ms, "
                       "two phases {:.3g}, {:.3g} and {:.3g} ms: {}.",
                       one[0], one[1], one[2], two[0], two[1], two[2], verdicts[from]);
}

std::string of_normals(const Rates& ms)
{
    const double plain = ms(Way::two_phases, no_normals, 0),
                 exact = ms(Way::two_phases, exact_normals, 0),
                 differences = ms(Way::two_phases, by_differences, 0);
    if (plain < 0 || exact < 0 || differences < 0) return {};
    return fmt::format("exact normals take {:.2f} times as long as positions alone, normals by "
                       "differences {:.2f} times.",
                       exact / plain, differences / plain);
}

std::string of_bound(const Rates& rates)
{
    const DeformRate* two = rates.find(Way::two_phases, exact_normals, 0);
    if (!two) return {};
    return fmt::format(
        "two phases with exact normals reach {:.3g} million vertices a second, {:.0f} % of what {} "
        "allows.",
        two->vertices_per_s / 1e6, 100 * two->vertices_per_s / allowed_per_s(*two), bound_by(*two));
}

} // namespace

double allowed_per_s(const DeformRate& rate)
{
    return std::min(rate.copy_allows_per_s, rate.arithmetic_allows_per_s);
}

const char* bound_by(const DeformRate& rate)
{
    return rate.copy_allows_per_s < rate.arithmetic_allows_per_s ? "copying" : "arithmetic";
}

std::vector<std::string> findings(const DeformReport& report)
{
    std::vector<std::string> out;
    for (const int order : {2, 3, 4})
        for (const auto of : {of_bound, of_normals, of_passes})
            for (const std::size_t vertices : {10'000'000, 1'000'000, 100'000}) {
                const std::string sentence = of(Rates(report.rates, order, vertices));
                if (sentence.empty()) continue;
                out.push_back(fmt::format("Order {}, {} vertices: {}", order, vertices, sentence));
                break;
            }
    return out;
}

} // namespace trivar::gpu
