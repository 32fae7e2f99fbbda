// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simplex/recursion_campaign.h"

#include "core/base/parallel.h"
#include "core/simplex/simplex_basis.h"
#include "tests/simplex/degenerate_domains.h"
#include "tests/simplex/exact_recursion.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::size_t points_each = 20; // of one domain

glm::dvec3 generic(const glm::dvec3&)
{
    return {0.7548776662466927, 0.5698402909980532, 0.3247179572447460};
}
glm::dvec2 generic(const glm::dvec2&)
{
    return {0.7548776662466927, 0.5698402909980532};
}

template <int S> struct Border {
    std::vector<std::pair<std::size_t, std::size_t>> faces; // cell and opposite corner, ascending
};

template <int S> Border<S> border_of(const SimplexDomain<S>& domain)
{
    Border<S> out;
    for (std::size_t c = 0; c < domain.cells.size(); ++c)
        for (std::size_t k = 0; k <= S; ++k) {
            std::array<int, S> face;
            for (std::size_t i = 0, n = 0; i <= S; ++i)
                if (i != k) face[n++] = domain.cells[c][i];
            const bool shared =
                std::any_of(domain.cells.begin(), domain.cells.end(), [&](const auto& other) {
                    return &other != &domain.cells[c] &&
                           std::all_of(face.begin(), face.end(), [&](int v) {
                               return std::find(other.begin(), other.end(), v) != other.end();
                           });
                });
            if (!shared) out.faces.push_back({c, k});
        }
    return out;
}

// The one rule of sides: the fixed direction; on the border, into the first cell that ends there.
template <int S>
glm::vec<S, double> direction_at(const glm::vec<S, double>& x, const SimplexDomain<S>& domain,
                                 const Border<S>& border, ExactRecursion<S>& exact)
{
    for (const auto& [cell, corner] : border.faces) {
        if (!exact.on_plane(cell, corner, x) || !exact.holds(cell, x)) continue;
        glm::vec<S, double> middle(0);
        for (const auto& each : corners(domain, cell)) middle += each;
        return middle / static_cast<double>(S + 1) - x;
    }
    return generic(x);
}

// Outside, within 1e-9 of a cell from the plane of one of its faces on the border: it counts as
// inside of that.
template <int S>
bool counts_as_inside(const glm::vec<S, double>& x, const SimplexDomain<S>& domain,
                      const Border<S>& border)
{
    return std::any_of(border.faces.begin(), border.faces.end(), [&](const auto& face) {
        auto at = corners(domain, face.first);
        const double all = orientation(at);
        at[face.second] = x;
        return std::abs(orientation(at)) < 1e-9 * all;
    });
}

template <int S>
void look_at_domain(std::size_t number, std::size_t points, std::uint32_t seed, double least_share,
                    CampaignClass& out)
{
    std::seed_seq seeds{seed, static_cast<std::uint32_t>(number)};
    std::mt19937 random(seeds);
    const DegenerateDomain<S> made = degenerate_domain<S>(out.degree, least_share, random);
    const SimplexBasis<S> basis(made.domain);
    ExactRecursion<S> exact(made.domain);
    const Border<S> border = border_of(made.domain);
    const std::size_t per_cell = multi_indices<S>(out.degree).size();
    std::vector<BasisValue<S>> values;
    while (out.points < points) {
        const auto kind = static_cast<PointKind>(random() % point_kinds.size());
        const auto x = special_point(made.domain, kind, random);
        bool inside = false;
        for (std::size_t c = 0; c < made.domain.cells.size(); ++c)
            inside = inside || exact.holds(c, x);
        if (!inside && counts_as_inside<S>(x, made.domain, border)) continue;
        basis.values_at(x, false, values);
        const std::vector<double> truth =
            exact.values(x, direction_at<S>(x, made.domain, border, exact));
        std::vector<double> differences(basis.point_count(), 0);
        double sum = -1;
        for (const auto& v : values) {
            differences[static_cast<std::size_t>(v.point)] += v.value;
            sum += v.value;
        }
        for (std::size_t i = 0; i < truth.size(); ++i)
            differences[static_cast<std::size_t>(basis.point_of(i / per_cell, i % per_cell))] -=
                truth[i];
        double worst = 0;
        for (const double each : differences) worst = std::max(worst, std::abs(each));
        const auto where = [&] {
            return fmt::format("{} of {} (domain {}, flatness {:.1e}, {})",
                               point_kinds[static_cast<std::size_t>(kind)], made.kind, number,
                               made.flatness, inside ? "inside" : "outside");
        };
        ++out.points;
        if (worst > out.worst_value) {
            out.worst_value = worst;
            out.worst_value_at = where();
        }
        if (inside) ++out.inside;
        const double off = inside ? std::abs(sum) : 0;
        if (off > out.worst_sum) {
            out.worst_sum = off;
            out.worst_sum_at = where();
        }
        out.missed += worst > 1e-10 || off > 1e-12;
    }
}

void add(CampaignClass& to, const CampaignClass& from)
{
    to.points += from.points;
    to.inside += from.inside;
    to.missed += from.missed;
    if (from.worst_value > to.worst_value) {
        to.worst_value = from.worst_value;
        to.worst_value_at = from.worst_value_at;
    }
    if (from.worst_sum > to.worst_sum) {
        to.worst_sum = from.worst_sum;
        to.worst_sum_at = from.worst_sum_at;
    }
}

} // namespace

std::vector<CampaignClass> recursion_campaign(std::size_t count, std::uint32_t seed,
                                              double least_share)
{
    const std::size_t domains = (count + points_each - 1) / points_each;
    std::vector<CampaignClass> found(domains);
    parallel_blocks(domains, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t d = begin; d < end; ++d) {
            found[d].variables = d % 2 == 0 ? 3 : 2;
            found[d].degree = 1 + static_cast<int>(d / 2 % 3);
            const std::size_t points = std::min(points_each, count - d * points_each);
            if (found[d].variables == 3)
                look_at_domain<3>(d, points, seed, least_share, found[d]);
            else
                look_at_domain<2>(d, points, seed, least_share, found[d]);
        }
    });
    std::vector<CampaignClass> out;
    for (const int variables : {2, 3})
        for (int degree = 1; degree <= 3; ++degree) {
            out.push_back({.variables = variables, .degree = degree});
            for (const CampaignClass& each : found)
                if (each.variables == variables && each.degree == degree) add(out.back(), each);
        }
    return out;
}

} // namespace trivar
