// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/round.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/placement/embed.h"
#include "core/placement/finish.h"
#include "core/placement/height_map.h"
#include "core/placement/profile.h"
#include "core/spline/fit.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

constexpr double round_turn = glm::two_pi<double>();
constexpr int chords_round = 720; // for measuring the length round

// A Frame is the surface with its derivatives by the angle and across.
struct Frame {
    glm::dvec3 p, along, across;
};

// Returns the surface of revolution at a distance r(s) from the axis and a height z(s).
Frame revolved(double angle, glm::dvec2 rz, glm::dvec2 rz_s)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {{rz.x * c, rz.x * s, rz.y}, {-rz.x * s, rz.x * c, 0}, {rz_s.x * c, rz_s.x * s, rz_s.y}};
}

Frame frame_of(const Band& band, double angle, double across)
{
    const double r = band.radius, s = band.twisted() ? across : band.level + across;
    switch (band.of) {
    case Band::Of::cylinder: return revolved(angle, {r, s}, {0, 1});
    case Band::Of::sphere: {
        const double c = std::cos(s / r), n = std::sin(s / r);
        return revolved(angle, {r * c, r * n}, {-n, c});
    }
    case Band::Of::torus: {
        const double t = band.tube, c = std::cos(s / t), n = std::sin(s / t);
        return revolved(angle, {r + t * c, t * n}, {-n, c});
    }
    case Band::Of::moebius: break;
    }
    const double c = std::cos(angle / 2), n = std::sin(angle / 2);
    Frame f = revolved(angle, {r + s * c, s * n}, {c, n});
    f.along += glm::dvec3(std::cos(angle), std::sin(angle), 0) * (-s * n / 2) +
               glm::dvec3(0, 0, s * c / 2);
    return f;
}

double length_round(const Band& band)
{
    double sum = 0;
    glm::dvec3 before = band.at(0, 0);
    for (int i = 1; i <= chords_round; ++i) {
        const glm::dvec3 p = band.at(round_turn * i / chords_round, 0);
        sum += glm::distance(before, p);
        before = p;
    }
    return sum;
}

// Returns how far the surface reaches to either side of the path, up to its own other side or a
// pole.
double reach_across(const Band& band)
{
    switch (band.of) {
    case Band::Of::sphere: return glm::half_pi<double>() * band.radius - std::abs(band.level);
    case Band::Of::torus: return glm::pi<double>() * band.tube;
    case Band::Of::cylinder:
    case Band::Of::moebius: break;
    }
    return INFINITY;
}

// Sizes are width and height along the path.
struct Sizes {
    double width;          // in the units of the surface
    double height, ground; // metres; the w of the surface
    Profile width_factor, height_factor, height_across;
    HeightMap height_map;
    Rise rise;
};

// Returns the height over the surface.
double up_at(const Sizes& sizes, glm::dvec3 uvw)
{
    const double share = uvw.x - std::floor(uvw.x);
    return (sizes.rise.at(uvw.z) - sizes.rise.at(sizes.ground)) * sizes.height *
           sizes.height_factor.at(share) * sizes.height_across.at(uvw.y) *
           sizes.height_map.at(share, uvw.y);
}

double across_at(const Sizes& sizes, glm::dvec2 uv)
{
    return (uv.y - 0.5) * sizes.width * sizes.width_factor.at(uv.x - std::floor(uv.x));
}

// A Standing is a place of the surface and its unit normal there.
struct Standing {
    glm::dvec3 p, normal;
};
using GroundAt = std::function<Standing(glm::dvec2 uv)>;

// Values of a function of (u, v, w) at the Greville abscissae, w fastest.
Trivariate<glm::dvec3> interpolated(const GroundAt& ground, const Sizes& sizes,
                                    const std::array<Knots, 3>& axes)
{
    std::vector<glm::dvec3> values;
    for (const double u : greville_sites(axes[0]))
        for (const double v : greville_sites(axes[1])) {
            const Standing on = ground({u, v});
            for (const double w : greville_sites(axes[2]))
                values.push_back(on.p + up_at(sizes, {u, v, w}) * on.normal);
        }
    return interpolate(axes, values);
}

// Returns the smallest det J over the nodes and three heights, relative to the undeformed volume.
double smallest_jacobian(const Lattice& volume, double size)
{
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    double least = INFINITY;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (const double w : {0.0, 0.5, 1.0}) {
                const Jet<glm::dvec3> f =
                    evaluate(volume, {axes[0].greville(i), axes[1].greville(j), w}, 1);
                least = std::min(least,
                                 glm::determinant(glm::dmat3(f.first[0], f.first[1], f.first[2])));
            }
    return least / size;
}

} // namespace

glm::dvec3 Band::at(double angle, double across) const
{
    return glm::dvec3(to_world * glm::dvec4(frame_of(*this, angle, across).p, 1));
}

glm::dvec3 Band::normal(double angle, double across) const
{
    const Frame f = frame_of(*this, angle, across);
    const glm::dmat3 linear(to_world);
    const glm::dvec3 n = glm::cross(linear * f.along, linear * f.across);
    return glm::normalize(n);
}

namespace {

Sizes sizes_of(const PlacementParameters& p, const Knots& upward, double width, double height,
               double ground)
{
    return {width,
            height,
            ground,
            Profile(p.width_profile),
            Profile(p.height_profile),
            Profile(p.height_across),
            HeightMap(p.height_map),
            Rise(p.rise_profile, upward)};
}

std::array<Knots, 3> axes_of(const PlacementParameters& p, Closure closure)
{
    return {Knots::periodic(p.orders.x, p.grid.x, 0, 1, closure),
            Knots::uniform(p.orders.y, p.grid.y), Knots::uniform(p.orders.z, p.grid.z)};
}

// Makes the placement of a volume over a contact surface, with its report. Lengths are in the
// world.
Placement standing_on(const Surface<glm::dvec3>& contact, Trivariate<glm::dvec3> volume,
                      const Sizes& sizes, const std::array<Knots, 3>& axes,
                      const PlacementReport& measures, const PlacementParameters& p)
{
    Placement out{contact,
                  lattice_through(std::move(volume)),
                  {},
                  measures,
                  outline(contact),
                  p.grid.y,
                  sizes.ground,
                  {}};
    PlacementReport& r = out.report;
    r.contact_share = 1;
    r.smallest_jacobian =
        smallest_jacobian(out.volume, r.length_world * r.width_world * sizes.height);
    if (!(r.smallest_jacobian > 0))
        r.folds =
            "the volume folds; make it lower or narrower, or make the object it goes round larger";
    for (int i = 0; i < p.grid.x; ++i)
        for (int j = 0; j < p.grid.y; ++j)
            out.nodes.push_back(
                {evaluate(out.contact, {axes[0].greville(i), axes[1].greville(j)}).value});
    return out;
}

Standing on_contact(const Surface<glm::dvec3>& contact, glm::dvec2 uv)
{
    const SurfaceJet<glm::dvec3> jet = evaluate(contact, uv, 1);
    return {jet.value, glm::normalize(glm::cross(jet.u, jet.v))};
}

// Says which nodes stand off the body.
void tell_gaps(Placement& out, const std::vector<double>& gaps, double height)
{
    constexpr double least = 0.05; // of the height: less is not seen
    for (std::size_t k = 0; k < gaps.size(); ++k) {
        if (!(gaps[k] > least * height)) continue;
        out.nodes[k].contact = Contact::bridges;
        out.report.largest_gap = std::max(out.report.largest_gap, gaps[k]);
        out.report.contact_share -= 1 / static_cast<double>(gaps.size());
    }
}

// Adds to the control points of the contact surface others along the normals above them.
Trivariate<glm::dvec3> raised(const Surface<glm::dvec3>& contact, const Sizes& sizes,
                              const std::array<Knots, 3>& axes)
{
    Trivariate<glm::dvec3> out{axes, {}};
    auto below = contact.points.begin();
    for (const double u : greville_sites(axes[0]))
        for (const double v : greville_sites(axes[1])) {
            const glm::dvec3 normal = on_contact(contact, {u, v}).normal;
            for (const double w : greville_sites(axes[2]))
                out.points.push_back(*below + up_at(sizes, {u, v, w}) * normal);
            ++below;
        }
    return out;
}

struct DrawnRound {
    Surface<glm::dvec3> contact;
    std::vector<double> gaps; // of its nodes: metres down to the section
    double left = 0;          // metres by which the section still protrudes
};

// Makes the surface with the places of the section as control points, so that it is concave only
// where the section is, moved outward until the body protrudes by no more than the tolerance.
DrawnRound drawn_round(const Section& section, const Sizes& sizes, const std::array<Knots, 2>& axes,
                       double tolerance)
{
    constexpr int looks = 4;  // per node along each axis
    constexpr int rounds = 8; // of lifting: each leaves a fraction of the rest
    const std::vector<double> us = greville_sites(axes[0]), vs = greville_sites(axes[1]);
    const auto places_of = [&](const std::vector<double>& along,
                               const std::vector<double>& across) {
        std::vector<glm::dvec3> out;
        for (const double u : along) {
            const Section::Column column = section.column(u);
            for (const double v : across) out.push_back(place_at(column, across_at(sizes, {u, v})));
        }
        return out;
    };
    const std::vector<glm::dvec3> nodes = places_of(us, vs);
    std::vector<glm::dvec3> through = nodes;
    std::vector<double> fine_u, fine_v;
    const std::size_t nu = us.size() * looks, nv = (vs.size() - 1) * looks;
    for (std::size_t i = 0; i < nu; ++i)
        fine_u.push_back(static_cast<double>(i) / static_cast<double>(nu));
    for (std::size_t j = 0; j <= nv; ++j)
        fine_v.push_back(static_cast<double>(j) / static_cast<double>(nv));
    const std::vector<glm::dvec3> body = places_of(fine_u, fine_v);
    const double near_u = 1.0 / static_cast<double>(us.size()),
                 near_v = 1.0 / static_cast<double>(vs.size() - 1);
    for (int round = 0;; ++round) {
        const Surface<glm::dvec3> contact{axes, through};
        std::vector<double> missing(through.size(), 0);
        double left = 0;
        for (std::size_t i = 0; i < fine_u.size(); ++i)
            for (std::size_t j = 0; j < fine_v.size(); ++j) {
                const Standing on = on_contact(contact, {fine_u[i], fine_v[j]});
                const double out = glm::dot(body[i * fine_v.size() + j] - on.p, on.normal);
                left = std::max(left, out);
                if (out <= tolerance) continue;
                for (std::size_t a = 0; a < us.size(); ++a) {
                    const double du = std::abs(us[a] - fine_u[i] - std::round(us[a] - fine_u[i]));
                    for (std::size_t b = 0; b < vs.size() && du <= near_u; ++b)
                        if (std::abs(vs[b] - fine_v[j]) <= near_v)
                            missing[a * vs.size() + b] = std::max(missing[a * vs.size() + b], out);
                }
            }
        if (left <= tolerance || round == rounds) {
            std::vector<double> gaps;
            for (const double u : us)
                for (const double v : vs) {
                    const Standing on = on_contact(contact, {u, v});
                    gaps.push_back(glm::dot(on.p - nodes[gaps.size()], on.normal));
                }
            return {contact, std::move(gaps), left};
        }
        for (std::size_t k = 0; k < through.size(); ++k)
            if (missing[k] > 0)
                through[k] +=
                    missing[k] * on_contact(contact, {us[k / vs.size()], vs[k % vs.size()]}).normal;
    }
}

} // namespace

Placement place_round(const Band& band, const PlacementParameters& p, const Box& model)
{
    const double det = glm::determinant(glm::dmat3(band.to_world));
    if (!(det > 0))
        throw Rejected(
            "the object it goes round is mirrored by a negative scale; rotate that object instead");
    if (band.twisted() &&
        !(p.height_across.empty() && p.height_map.empty() && p.rise_profile.empty()))
        throw Rejected("one round of a Moebius band swaps left and right, top and bottom; remove "
                       "the height across, the height map and the height distribution");
    const ModelFrame frame = model_frame(p, model);
    const double length = length_round(band);
    const double width = strip_width(frame, p, length), height = volume_height(frame, p, length);
    const double scale = std::cbrt(det);
    if (width * Profile(p.width_profile).largest() / scale > 2 * reach_across(band))
        throw Rejected(
            fmt::format("a model {} m wide would overlap itself; reduce its width or its fill",
                        number_text(width)));
    const std::array<Knots, 3> axes =
        axes_of(p, band.twisted() ? Closure::twisted : Closure::periodic);
    const Sizes sizes = sizes_of(p, axes[2], width / scale, band.twisted() ? 2 * height : height,
                                 band.twisted() ? 0.5 : p.contact_level);
    const GroundAt ground = [&](glm::dvec2 uv) {
        const double angle = round_turn * uv.x, across = across_at(sizes, uv);
        return Standing{band.at(angle, across), band.normal(angle, across)};
    };
    std::vector<glm::dvec3> places;
    for (const double u : greville_sites(axes[0]))
        for (const double v : greville_sites(axes[1])) places.push_back(ground({u, v}).p);
    PlacementReport measures;
    measures.length_world = length;
    measures.width_world = width;
    measures.height_world = height;
    Placement out = standing_on(interpolate(std::array{axes[0], axes[1]}, places),
                                interpolated(ground, sizes, axes), sizes, axes, measures, p);
    out.embedding.to_uvw = model_to_uvw(frame, p);
    if (band.twisted()) // the model stands on the middle of the strip
        out.embedding.to_uvw = glm::translate(glm::dmat4(1), {0, 0, sizes.ground}) *
                               glm::scale(glm::dmat4(1), {1, 1, 1 - sizes.ground}) *
                               out.embedding.to_uvw;
    out.embedding.to_rest = out.volume.rest * out.embedding.to_uvw;
    return out;
}

Placement place_round(Section section, const PlacementParameters& p, const Box& model)
{
    const ModelFrame frame = model_frame(p, model);
    PlacementReport measures;
    measures.length_world = section.length();
    measures.width_world = strip_width(frame, p, section.length());
    measures.height_world = volume_height(frame, p, section.length());
    const std::array<Knots, 3> axes = axes_of(p, Closure::periodic);
    const Sizes sizes =
        sizes_of(p, axes[2], measures.width_world, measures.height_world, p.contact_level);
    section.widen(sizes.width * sizes.width_factor.largest() / 2);
    const DrawnRound drawn =
        drawn_round(section, sizes, {axes[0], axes[1]}, p.lift_tolerance * sizes.height);
    measures.penetration = drawn.left / sizes.height;
    Placement out =
        standing_on(drawn.contact, raised(drawn.contact, sizes, axes), sizes, axes, measures, p);
    tell_gaps(out, drawn.gaps, sizes.height);
    out.embedding.to_uvw = model_to_uvw(frame, p);
    out.embedding.to_rest = out.volume.rest * out.embedding.to_uvw;
    return out;
}

} // namespace trivar
