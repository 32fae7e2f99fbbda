// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/deform_rates.h"

#include "core/base/rejected.h"
#include "gpu/context.h"
#include "gpu/ffd/deform_timer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <numbers>

namespace trivar::gpu {
namespace {

// So many vertices of a sphere in the box [0, 1]^3, in rows, as models have them.
Mesh sphere_points(std::size_t count)
{
    const double rows = std::max(1.0, std::sqrt(static_cast<double>(count) / 2));
    Mesh mesh;
    mesh.positions.reserve(count);
    mesh.normals.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double turns = rows * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const double polar = std::numbers::pi * turns / rows, round = 2 * std::numbers::pi * turns;
        const glm::dvec3 n(std::sin(polar) * std::cos(round), std::sin(polar) * std::sin(round),
                           std::cos(polar));
        mesh.normals.emplace_back(n);
        mesh.positions.emplace_back(n * 0.49 + 0.5);
    }
    return mesh;
}

Lattice wavy_lattice(int order, int count)
{
    const Knots knots = Knots::uniform(order, count);
    Lattice lattice = lattice_at_rest({knots, knots, knots}, glm::dmat4(1));
    double at = 0;
    for (glm::dvec3& d : lattice.displacement.points) {
        at += 1;
        d = 0.02 * glm::dvec3(std::sin(at * 12.9898), std::sin(at * 78.233), std::sin(at * 37.719));
    }
    return lattice;
}

class Measuring {
public:
    DeviceFigures device()
    {
        DeviceFigures out;
        out.name = describe_context();
        const std::size_t bytes = std::size_t{is_software() ? 64u : 256u} << 20;
        Buffer from, to;
        from.reserve(bytes);
        to.reserve(bytes);
        const auto copy = [&] {
            glBindBuffer(GL_COPY_READ_BUFFER, from.name());
            glBindBuffer(GL_COPY_WRITE_BUFFER, to.name());
            glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                                static_cast<GLsizeiptr>(bytes));
        };
        const double copy_ms = least_ms([&] { return timer_.timed_ms(copy); }, enough_ms);
        out.copy_bytes_per_s = 2e3 * static_cast<double>(bytes) / copy_ms;

        const unsigned groups = is_software() ? 256 : 16384;
        constexpr double work = 64 * 8 * 4 * 256; // arithmetic.comp.glsl, a group
        const Program& program = programs_.use({"", "", {}, "arithmetic"});
        program.set("factor", glm::vec4(1e-3f, 2e-3f, 3e-3f, 4e-3f));
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, to.name());
        const auto sum = [&] { glDispatchCompute(groups, 1, 1); };
        const double sum_ms = least_ms([&] { return timer_.timed_ms(sum); }, enough_ms);
        out.multiply_adds_per_s = 1e3 * groups * work / sum_ms;
        return out;
    }

    DeformRate rate(const DeformCase& what)
    {
        constexpr std::size_t compared = 200000; // reading back takes its time
        if (!mesh_ || mesh_->vertex_count() != what.vertices)
            mesh_ = make_ref(sphere_points(what.vertices));
        timer_.take(mesh_);
        DeformRate out{what};
        const Stage stage{make_ref(wavy_lattice(what.order, what.lattice)), {}};
        out.time_ms = timer_.time_ms(stage, what.way, what.method, what.passes);
        out.vertices_per_s = 1e3 * static_cast<double>(what.vertices) / out.time_ms;
        const int least = what.way == Way::one_phase ? 1 : 0; // more passes draw the same
        if (what.way != Way::processor && what.passes <= least && what.vertices <= compared) {
            const DeformErrors off = timer_.errors(stage, what.way, what.method);
            out.position_error = off.position;
            if (what.method.normals != NormalsBy::nothing) out.normal_error_deg = off.normal_deg;
        }
        timer_.drop_dead();
        return out;
    }

private:
    static constexpr double enough_ms = 250;
    DeformTimer timer_{enough_ms};
    Programs programs_;
    Ref<Mesh> mesh_;
};

// Whether a smaller case of the kind was so slow that this one would take too long.
bool too_slow(const DeformCase& what, const std::vector<DeformRate>& rates, double most_s)
{
    return std::ranges::any_of(rates, [&](const DeformRate& r) {
        DeformCase like = r.what;
        like.vertices = what.vertices;
        const bool smaller = r.what.vertices < what.vertices;
        return smaller && like == what &&
               static_cast<double>(what.vertices) > most_s * r.vertices_per_s;
    });
}

// Counts the multiply-adds of one evaluation. The sum is contracted over w, then v, then u; a
// look-up of order raising is seven lerps, unless the device's filter does them.
double sum_multiply_adds(int order, const Method& method)
{
    const double o = order, below = o - 1;
    const double value = method.sum == Sum::nested   ? 3 * (o * o * o + o * o + o)
                         : method.sum == Sum::raised ? below * below * below * 24
                                                     : below * below * below * 3;
    if (method.normals == NormalsBy::nothing) return value;
    if (method.normals == NormalsBy::differences) return 3 * value;
    constexpr double frame = 75; // J, cofactors, length
    return 3 * (2 * o * o * o + 3 * o * o + 4 * o) + frame;
}

// OmittedCases counts the cases left out, by reason.
struct OmittedCases {
    std::size_t slow = 0, late = 0;
};

void add_notices(DeformReport& report, const OmittedCases& left_out, const DeformBudget& budget)
{
    if (left_out.slow > 0)
        report.notices.push_back(
            fmt::format("{} of the cases were left out: a run of one takes more than {:g} s here.",
                        left_out.slow, budget.run_s));
    if (left_out.late > 0)
        report.notices.push_back(
            fmt::format("{} of the cases were left out: {:g} minutes were over.", left_out.late,
                        budget.all_s / 60));
}

} // namespace

double bytes_a_vertex(const DeformCase& what)
{
    constexpr double array = 12;
    const double drawn = what.method.normals == NormalsBy::nothing ? array : 2 * array;
    const int passes = what.way == Way::one_phase ? std::max(what.passes, 1) : what.passes;
    const double deformed = what.way == Way::one_phase ? 0 : 2 * drawn; // read and written
    return deformed + (passes > 0 ? drawn + (passes - 1) * array : 0);
}

double multiply_adds(const DeformCase& what)
{
    const Method plain{what.method.sum, NormalsBy::nothing};
    const int again = what.way == Way::one_phase ? std::max(what.passes - 1, 0) : 0;
    return sum_multiply_adds(what.order, what.method) +
           again * sum_multiply_adds(what.order, plain);
}

std::vector<DeformCase> every_deform_case()
{
    const Method plain{Sum::nested, NormalsBy::nothing}, exact{};
    std::vector<DeformCase> out;
    for (const std::size_t vertices : {100'000, 1'000'000, 10'000'000}) {
        for (const Way way : {Way::processor, Way::one_phase, Way::two_phases}) {
            const int least = way == Way::one_phase ? 1 : 0;
            for (const int order : {2, 3, 4})
                for (const Method& method : {plain, exact})
                    out.push_back({way, method, order, 8, vertices, least});
            for (const int lattice : {4, 16, 32})
                out.push_back({way, exact, 3, lattice, vertices, least});
            if (way == Way::processor) continue;
            for (const int order : {2, 3, 4})
                for (int passes = least + 1; passes <= 3; ++passes)
                    out.push_back({way, exact, order, 8, vertices, passes});
        }
        for (const int order : {2, 3, 4})
            for (const Sum sum : {Sum::nested, Sum::raised, Sum::filtered})
                for (const NormalsBy normals : {NormalsBy::nothing, NormalsBy::differences})
                    if (sum != Sum::nested || normals != NormalsBy::nothing)
                        out.push_back({Way::two_phases, {sum, normals}, order, 8, vertices, 0});
    }
    return out;
}

DeformReport deform_rates(const std::vector<DeformCase>& cases, const DeformBudget& budget,
                          const Progress& progress)
{
    const auto begin = std::chrono::steady_clock::now();
    const auto late = [&] {
        return std::chrono::steady_clock::now() - begin >
               std::chrono::duration<double>(budget.all_s);
    };
    DeformReport out;
    Measuring measuring;
    report(progress, 0, "copy and arithmetic");
    out.device = measuring.device();
    OmittedCases left_out;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const DeformCase& what = cases[i];
        report(progress, static_cast<double>(i) / static_cast<double>(cases.size()),
               fmt::format("{} vertices", what.vertices));
        if (late()) {
            left_out.late = cases.size() - i;
            break;
        }
        if (too_slow(what, out.rates, budget.run_s)) {
            ++left_out.slow;
            continue;
        }
        try {
            DeformRate rate = measuring.rate(what);
            if (what.way != Way::processor) {
                rate.copy_allows_per_s = out.device.copy_bytes_per_s / bytes_a_vertex(what);
                rate.arithmetic_allows_per_s = out.device.multiply_adds_per_s / multiply_adds(what);
            }
            out.rates.push_back(rate);
        } catch (const Rejected& error) {
            if (std::ranges::find(out.notices, error.what()) == out.notices.end())
                out.notices.emplace_back(error.what());
        }
    }
    add_notices(out, left_out, budget);
    return out;
}

} // namespace trivar::gpu
