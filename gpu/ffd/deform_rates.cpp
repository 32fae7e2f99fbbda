// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/deform_rates.h"

#include "core/base/rejected.h"
#include "gpu/context.h"
#include "gpu/framebuffer.h"
#include "gpu/pass_clock.h"
#include "gpu/vertex_array.h"

#include <algorithm>
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

// The least time of some runs, milliseconds; the first run is not counted, for it compiles.
template <class Run> double least_ms(Run&& run)
{
    constexpr double enough_ms = 250;
    constexpr int most_runs = 12;
    run();
    double least = run(), sum = least;
    for (int i = 1; i < most_runs && sum < enough_ms; ++i) {
        const double time_ms = run();
        least = std::min(least, time_ms);
        sum += time_ms;
    }
    return least;
}

struct Errors {
    double position = 0, normal_deg = 0;
};

Errors errors_of(const Deformed& a, const Deformed& exact)
{
    Box box;
    for (const glm::vec3& p : exact.positions) box.add(p);
    Errors out;
    for (std::size_t i = 0; i < exact.positions.size(); ++i)
        out.position =
            std::max(out.position, double{glm::distance(a.positions[i], exact.positions[i])});
    out.position /= glm::length(box.size());
    for (std::size_t i = 0; i < exact.normals.size() && i < a.normals.size(); ++i) {
        const glm::dvec3 n(a.normals[i]), m(exact.normals[i]);
        out.normal_deg =
            std::max(out.normal_deg,
                     glm::degrees(std::atan2(glm::length(glm::cross(n, m)), glm::dot(n, m))));
    }
    return out;
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
        const double copy_ms = least_ms([&] {
            return timed_ms([&] {
                glBindBuffer(GL_COPY_READ_BUFFER, from.name());
                glBindBuffer(GL_COPY_WRITE_BUFFER, to.name());
                glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                                    static_cast<GLsizeiptr>(bytes));
            });
        });
        out.copy_bytes_per_s = 2e3 * static_cast<double>(bytes) / copy_ms;

        const unsigned groups = is_software() ? 256 : 16384;
        constexpr double work = 64 * 8 * 4 * 256; // arithmetic.comp.glsl, a group
        const Program& program = programs_.use({"", "", {}, "arithmetic"});
        program.set("factor", glm::vec4(1e-3f, 2e-3f, 3e-3f, 4e-3f));
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, to.name());
        const double sum_ms =
            least_ms([&] { return timed_ms([&] { glDispatchCompute(groups, 1, 1); }); });
        out.multiply_adds_per_s = 1e3 * groups * work / sum_ms;
        return out;
    }

    DeformRate rate(const DeformCase& what)
    {
        prepare(what.vertices);
        DeformRate out{what};
        const Stage stage{make_ref(wavy_lattice(what.order, what.lattice)), {}};
        out.time_ms = what.way == Way::processor   ? processor_ms(what, stage)
                      : what.way == Way::one_phase ? one_phase_ms(what, stage)
                                                   : two_phases_ms(what, stage, out);
        out.vertices_per_s = 1e3 * static_cast<double>(what.vertices) / out.time_ms;
        deformer_.lattices().drop_dead();
        return out;
    }

private:
    template <class Body> double timed_ms(Body&& body)
    {
        clock_.start_picture();
        clock_.pass("deform", body);
        return clock_.timings().stages.front().time_ms;
    }

    void prepare(std::size_t vertices)
    {
        if (mesh_ && mesh_->vertex_count() == vertices) return;
        mesh_ = make_ref(sphere_points(vertices));
        from_ = uploaded_vertices(*mesh_);
        to_ = {};
    }

    // The mesh with what the method reads.
    Ref<Mesh> mesh(const Method& method) const
    {
        if (method.normals != NormalsBy::nothing) return mesh_;
        Mesh plain;
        plain.positions = mesh_->positions;
        return make_ref(std::move(plain));
    }

    double processor_ms(const DeformCase& what, const Stage& stage) const
    {
        const Deformer deformer(mesh(what.method), stage.embedding,
                                stage.lattice->displacement.axes);
        Deformed out;
        return least_ms([&] {
            Timings timings;
            out = timed(timings, "deform",
                        [&] { return deformer.arrays(*stage.lattice, std::move(out)); });
            return timings.stages.front().time_ms;
        });
    }

    double one_phase_ms(const DeformCase& what, const Stage& stage)
    {
        deformer_.bind(stage, from_.bounds, glm::dvec3(0));
        VertexArray vertices;
        vertices.attribute(0, from_.positions, 3, sizeof(glm::vec3));
        if (what.method.normals != NormalsBy::nothing)
            vertices.attribute(1, from_.normals, 3, sizeof(glm::vec3));
        vertices.bind();
        nowhere_.bind();
        programs_.use(deform_program({{what.order, what.order, what.order},
                                      what.method,
                                      false,
                                      deformer_.reads_texels(),
                                      false}));
        const double least = least_ms([&] {
            return timed_ms([&] { glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(from_.count)); });
        });
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return least;
    }

    double two_phases_ms(const DeformCase& what, const Stage& stage, DeformRate& rate)
    {
        const double least = least_ms([&] {
            return timed_ms(
                [&] { deformer_.deform(from_, to_, std::span(&stage, 1), what.method); });
        });
        constexpr std::size_t compared = 200000; // reading back takes its time
        if (what.vertices > compared) return least;
        const Deformer exact(mesh(what.method), stage.embedding, stage.lattice->displacement.axes);
        const Errors off = errors_of(read_back(to_), exact.arrays(*stage.lattice));
        rate.position_error = off.position;
        if (what.method.normals != NormalsBy::nothing) rate.normal_error_deg = off.normal_deg;
        return least;
    }

    PassClock clock_;
    DeviceDeformer deformer_;
    Programs programs_;
    Framebuffer nowhere_{{}, nullptr};
    Ref<Mesh> mesh_;
    DeviceVertices from_, to_;
};

bool same_kind(const DeformCase& a, const DeformCase& b)
{
    return a.way == b.way && a.method == b.method && a.order == b.order && a.lattice == b.lattice;
}

// Whether a smaller case of the kind was so slow that this one would take too long.
bool too_slow(const DeformCase& what, const std::vector<DeformRate>& rates, double most_s)
{
    return std::ranges::any_of(rates, [&](const DeformRate& r) {
        return same_kind(r.what, what) &&
               r.what
                   .vertices<what.vertices&& static_cast<double>(what.vertices) / r.vertices_per_s>
                       most_s;
    });
}

} // namespace

double bytes_a_vertex(const Method& method)
{
    return method.normals == NormalsBy::nothing ? 24 : 48;
}

double multiply_adds(int order, const Method& method)
{
    const double o = order, below = o - 1;
    // Contracted over w, then v, then u; a look-up of order raising is seven lerps.
    const double value =
        method.sum == Sum::nested ? 3 * (o * o * o + o * o + o) : below * below * below * 24;
    if (method.normals == NormalsBy::nothing) return value;
    if (method.normals == NormalsBy::differences) return 3 * value;
    constexpr double frame = 75; // J, cofactors, length
    return 3 * (2 * o * o * o + 3 * o * o + 4 * o) + frame;
}

std::vector<DeformCase> every_deform_case()
{
    const Method plain{Sum::nested, NormalsBy::nothing}, exact{};
    std::vector<DeformCase> out;
    for (const std::size_t vertices : {100'000, 1'000'000, 10'000'000}) {
        for (const Way way : {Way::processor, Way::one_phase, Way::two_phases}) {
            for (const int order : {2, 3, 4})
                for (const Method& method : {plain, exact})
                    out.push_back({way, method, order, 8, vertices});
            for (const int lattice : {4, 16, 32}) out.push_back({way, exact, 3, lattice, vertices});
        }
        const Method differences{Sum::nested, NormalsBy::differences};
        for (const int order : {3, 4}) {
            for (const Sum sum : {Sum::raised, Sum::filtered})
                out.push_back({Way::two_phases, {sum, NormalsBy::nothing}, order, 8, vertices});
            out.push_back({Way::two_phases, differences, order, 8, vertices});
        }
    }
    return out;
}

DeformReport deform_rates(const std::vector<DeformCase>& cases, double most_s,
                          const Progress& progress)
{
    DeformReport out;
    Measuring measuring;
    report(progress, 0, "copy and arithmetic");
    out.device = measuring.device();
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const DeformCase& what = cases[i];
        report(progress, static_cast<double>(i) / static_cast<double>(cases.size()),
               fmt::format("{} vertices", what.vertices));
        if (too_slow(what, out.rates, most_s)) {
            ++left_out;
            continue;
        }
        try {
            DeformRate rate = measuring.rate(what);
            if (what.way != Way::processor) {
                rate.copy_allows_per_s = out.device.copy_bytes_per_s / bytes_a_vertex(what.method);
                rate.arithmetic_allows_per_s =
                    out.device.multiply_adds_per_s / multiply_adds(what.order, what.method);
            }
            out.rates.push_back(rate);
        } catch (const Rejected& error) {
            if (std::ranges::find(out.notices, error.what()) == out.notices.end())
                out.notices.emplace_back(error.what());
        }
    }
    if (left_out > 0)
        out.notices.push_back(
            fmt::format("{} of the cases were left out: a run of one takes more than {:g} s here.",
                        left_out, most_s));
    return out;
}

} // namespace trivar::gpu
