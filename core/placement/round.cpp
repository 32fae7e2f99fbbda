// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/round.h"

#include "core/base/rejected.h"
#include "core/placement/embed.h"
#include "core/placement/finish.h"
#include "core/placement/height_map.h"
#include "core/placement/profile.h"
#include "core/spline/fit.h"

#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

constexpr double turn = glm::two_pi<double>();
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
        const glm::dvec3 p = band.at(turn * i / chords_round, 0);
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

glm::dvec3 at(const Band& band, const Sizes& sizes, glm::dvec3 uvw)
{
    const double share = uvw.x - std::floor(uvw.x), angle = turn * uvw.x;
    const double across = (uvw.y - 0.5) * sizes.width * sizes.width_factor.at(share);
    const double up = (sizes.rise.at(uvw.z) - sizes.rise.at(sizes.ground)) * sizes.height *
                      sizes.height_factor.at(share) * sizes.height_across.at(uvw.y) *
                      sizes.height_map.at(share, uvw.y);
    return band.at(angle, across) + up * band.normal(angle, across);
}

// Interpolates the volume at the Greville abscissae, w fastest.
Trivariate<glm::dvec3> interpolated(const Band& band, const Sizes& sizes,
                                    const std::array<Knots, 3>& axes)
{
    std::vector<glm::dvec3> values;
    for (const double u : greville_sites(axes[0]))
        for (const double v : greville_sites(axes[1]))
            for (const double w : greville_sites(axes[2]))
                values.push_back(at(band, sizes, {u, v, w}));
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
        throw Rejected(fmt::format(
            "a model {:.3g} m wide would overlap itself; reduce its width or its fill", width));
    const std::array<Knots, 3> axes{
        Knots::periodic(p.orders.x, p.grid.x, 0, 1,
                        band.twisted() ? Closure::twisted : Closure::periodic),
        Knots::uniform(p.orders.y, p.grid.y), Knots::uniform(p.orders.z, p.grid.z)};
    const Sizes sizes{width / scale,
                      band.twisted() ? 2 * height : height,
                      band.twisted() ? 0.5 : p.contact_level,
                      Profile(p.width_profile),
                      Profile(p.height_profile),
                      Profile(p.height_across),
                      HeightMap(p.height_map),
                      Rise(p.rise_profile, axes[2])};
    std::vector<glm::dvec3> ground;
    for (const double u : greville_sites(axes[0]))
        for (const double v : greville_sites(axes[1]))
            ground.push_back(at(band, sizes, {u, v, sizes.ground}));
    const Surface<glm::dvec3> contact = interpolate(std::array{axes[0], axes[1]}, ground);
    Placement out{contact,
                  lattice_through(interpolated(band, sizes, axes)),
                  {},
                  {},
                  outline(contact),
                  p.grid.y,
                  sizes.ground,
                  {}};
    out.embedding.to_uvw = model_to_uvw(frame, p);
    if (band.twisted()) // the model stands on the middle
        out.embedding.to_uvw = glm::translate(glm::dmat4(1), {0, 0, sizes.ground}) *
                               glm::scale(glm::dmat4(1), {1, 1, 1 - sizes.ground}) *
                               out.embedding.to_uvw;
    out.embedding.to_rest = out.volume.rest * out.embedding.to_uvw;
    PlacementReport& r = out.report;
    r.length_world = length;
    r.width_world = width;
    r.height_world = height;
    r.contact_share = 1;
    r.smallest_jacobian = smallest_jacobian(out.volume, length * width * sizes.height);
    if (!(r.smallest_jacobian > 0))
        r.folds =
            "the volume folds; make it lower or narrower, or make the object it goes round larger";
    for (int i = 0; i < p.grid.x; ++i)
        for (int j = 0; j < p.grid.y; ++j)
            out.nodes.push_back(
                {evaluate(out.contact, {axes[0].greville(i), axes[1].greville(j)}).value});
    return out;
}

} // namespace trivar
