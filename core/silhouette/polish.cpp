// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/polish.h"

#include <cmath>

namespace trivar {
namespace {

constexpr int most_polishing_steps = 8;
constexpr double longest_step = 0.5, longest_way = 1; // voxels
constexpr double touching = 1e-6;                     // squared sine between the two gradients
constexpr double is_quadratic = 0.02; // a step from which the next one is its square

// A Polishing is a place on its way, with the jet of the field at its last step but one.
template <class Real> struct Polishing {
    glm::vec<3, Real> p, begin;
    ScalarJet<Real> jet;
    bool has_come;
};

// Newton's method at some places at once: each waits for the field on its own, and they do their
// sums together. Where one is done, another one takes its lane.
template <class Real, std::size_t lanes> class Polisher {
public:
    using Places = std::span<Polishing<Real>>;

    Polisher(const ScalarField<Real>& field, Real level, const ViewPoint& view, Real tolerance)
        : field_(field),
          level_(level),
          view_(view),
          tolerance2_(tolerance * tolerance),
          least2_(std::min(square(is_quadratic), tolerance))
    {
    }
    void operator()(Places places)
    {
        std::array<Polishing<Real>*, lanes> in{};
        std::array<int, lanes> steps{};
        auto next = places.begin();
        std::size_t moving = 0;
        const auto begin = [&](std::size_t i) {
            in[i] = nullptr;
            if (next == places.end()) return;
            if (places.end() - next > std::ptrdiff_t{lanes}) ask_for(next[lanes].p);
            in[i] = &*next++;
            in[i]->begin = in[i]->p;
            in[i]->has_come = false;
            steps[i] = 0;
            ++moving;
        };
        for (std::size_t i = 0; i < lanes; ++i) begin(i);
        while (moving > 0) {
            for (std::size_t i = 0; i < lanes; ++i)
                if (in[i]) look(*in[i], i);
            find_moves();
            for (std::size_t i = 0; i < lanes; ++i) {
                if (!in[i]) continue;
                const bool is_to_move = move(*in[i], i, steps[i]);
                if (is_to_move && ++steps[i] < most_polishing_steps) continue;
                --moving;
                begin(i);
            }
        }
    }

private:
    using Lanes __attribute__((vector_size(lanes * sizeof(Real)))) = Real;
    using Numbers = std::array<Real, lanes>;
    static constexpr Real square(double of) { return static_cast<Real>(of * of); }
    static Lanes in_lanes(const Numbers& numbers)
    {
        Lanes out;
        std::memcpy(&out, &numbers, sizeof out);
        return out;
    }

    static void keep(const Lanes& from, Numbers& numbers)
    {
        std::memcpy(&numbers, &from, sizeof numbers);
    }
    // Has the coefficients near a place brought from memory.
    void ask_for(const glm::vec<3, Real>& p) const
    {
        const glm::ivec3 cell = glm::min(glm::ivec3(p), field_.size() - 2);
        const Real* const first = &field_.coefficient(cell.x - 1, cell.y - 1, cell.z - 1);
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t j = 0; j < 4; ++j)
                __builtin_prefetch(first + k * field_.plane() + j * field_.row());
    }
    void look(Polishing<Real>& place, std::size_t i)
    {
        place.jet = field_.template at<2>(place.p);
        value_[i] = place.jet.value - level_;
        const glm::vec<3, Real> sight(view_.sight(glm::dvec3(place.p)));
        for (int k = 0; k < 3; ++k) {
            const auto n = static_cast<std::size_t>(k);
            sight_[n][i] = sight[k];
            gradient_[n][i] = place.jet.gradient[n];
        }
        for (std::size_t k = 0; k < 6; ++k) hessian_[k][i] = place.jet.hessian[k];
    }
    // The steps of least norm to the tangent planes of both surfaces.
    void find_moves()
    {
        const Lanes a0 = in_lanes(gradient_[0]), a1 = in_lanes(gradient_[1]),
                    a2 = in_lanes(gradient_[2]);
        const Lanes s0 = in_lanes(sight_[0]), s1 = in_lanes(sight_[1]), s2 = in_lanes(sight_[2]);
        const Lanes xx = in_lanes(hessian_[0]), yy = in_lanes(hessian_[1]),
                    zz = in_lanes(hessian_[2]), xy = in_lanes(hessian_[3]),
                    xz = in_lanes(hessian_[4]), yz = in_lanes(hessian_[5]);
        const Real w = static_cast<Real>(view_.at.w);
        const Lanes f = in_lanes(value_), g = a0 * s0 + a1 * s1 + a2 * s2,
                    b0 = xx * s0 + xy * s1 + xz * s2 + w * a0,
                    b1 = xy * s0 + yy * s1 + yz * s2 + w * a1,
                    b2 = xz * s0 + yz * s1 + zz * s2 + w * a2;
        const Lanes aa = a0 * a0 + a1 * a1 + a2 * a2, ab = a0 * b0 + a1 * b1 + a2 * b2,
                    bb = b0 * b0 + b1 * b1 + b2 * b2, det = aa * bb - ab * ab;
        const Lanes along_a = (ab * g - bb * f) / det, along_b = (ab * f - aa * g) / det;
        const Lanes x = along_a * a0 + along_b * b0, y = along_a * a1 + along_b * b1,
                    z = along_a * a2 + along_b * b2;
        keep(x, moves_[0]);
        keep(y, moves_[1]);
        keep(z, moves_[2]);
        keep(x * x + y * y + z * z, length2_);
        keep(det - static_cast<Real>(touching) * aa * bb, apart_);
    }
    // Whether the place is to move once more.
    bool move(Polishing<Real>& place, std::size_t i, int step)
    {
        using Vec = glm::vec<3, Real>;
        if (!(apart_[i] > 0)) return false;
        const Vec by(moves_[0][i], moves_[1][i], moves_[2][i]);
        place.p += length2_[i] > square(longest_step)
                       ? by * (static_cast<Real>(longest_step) / std::sqrt(length2_[i]))
                       : by;
        const Vec& end = end_;
        for (int k = 0; k < 3; ++k)
            if (!(place.p[k] >= 0 && place.p[k] <= end[k])) return false;
        const Vec way = place.p - place.begin;
        if (glm::dot(way, way) > square(longest_way)) return false;
        place.has_come = length2_[i] < tolerance2_ || (step > 0 && length2_[i] < least2_);
        return !place.has_come;
    }

    const ScalarField<Real>& field_;
    Real level_;
    const ViewPoint& view_;
    Real tolerance2_, least2_; // squared lengths: of a last step, and of a last one but the first
    glm::vec<3, Real> end_{field_.size() - 1};
    // One entry per lane; finished lanes are ignored.
    Numbers value_{}, length2_{}, apart_{};
    std::array<Numbers, 3> gradient_{}, sight_{}, moves_{};
    std::array<Numbers, 6> hessian_{};
};

void set_shape(const ViewPoint& view, const ScalarJet<float>& jet, SilhouettePoint& point)
{
    const glm::vec3 sight(view.sight(glm::dvec3(point.p)));
    point.slope = glm::length(gradient_of(jet));
    const float scale = glm::dot(sight, sight) * (point.slope > 0 ? point.slope : 1);
    point.bend = scale > 0 ? glm::dot(sight, hessian_of(jet) * sight) / scale : 0;
}

} // namespace

template <class Real>
bool polish(const ScalarField<Real>& field, Real level, const ViewPoint& view, glm::vec<3, Real>& p,
            ScalarJet<Real>& jet, Real tolerance)
{
    Polishing<Real> place;
    place.p = p;
    Polisher<Real, 2>(field, level, view, tolerance)(std::span(&place, 1));
    p = place.p;
    jet = place.jet;
    return place.has_come;
}

template bool polish(const ScalarField<float>&, float, const ViewPoint&, glm::vec3&,
                     ScalarJet<float>&, float);
template bool polish(const ScalarField<double>&, double, const ViewPoint&, glm::dvec3&,
                     ScalarJet<double>&, double);

void finish(const ScalarField<float>& field, float level, const ViewPoint& view, bool polished,
            std::span<SilhouettePoint> points)
{
    constexpr std::size_t lanes = 8;
    constexpr float tolerance = 1e-4f;
    std::vector<Polishing<float>> places(polished ? points.size() : 0);
    for (std::size_t i = 0; i < places.size(); ++i) places[i].p = points[i].p;
    Polisher<float, lanes>(field, level, view, tolerance)(places);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].polished = polished && places[i].has_come;
        if (points[i].polished) points[i].p = places[i].p;
        set_shape(view, points[i].polished ? places[i].jet : field.at<2>(points[i].p), points[i]);
    }
}

} // namespace trivar
