// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/pressing.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double least_gap = 0.02; // of the distance as laid

glm::ivec3 counts(const Lattice& lattice)
{
    const std::array<Knots, 3>& axes = lattice.displacement.axes;
    return {axes[0].count(), axes[1].count(), axes[2].count()};
}

} // namespace

LaidVolume laid_volume(Lattice volume, double ground)
{
    LaidVolume laid{nullptr, make_ref(volume), ground};
    return with_volume(std::move(laid), std::move(volume));
}

LaidVolume with_volume(LaidVolume laid, Lattice volume, std::optional<CellVerdicts> verdicts)
{
    laid.volume = make_ref(std::move(volume));
    if (!verdicts) return allowing_folds(laid, laid.may_fold);
    laid.verdicts = Lazy<CellVerdicts>([known = std::move(*verdicts)] { return known; });
    (void)*laid.verdicts; // computed now, so that readers need not
    return laid;
}

GuardOptions LaidVolume::guard() const
{
    GuardOptions out;
    out.sign = 1; // volumes on strokes have this sign
    for (const VolumePart& part : may_fold) out.excepted.push_back({part.lo, part.hi});
    return out;
}

LaidVolume allowing_folds(LaidVolume laid, std::vector<VolumePart> boxes)
{
    laid.may_fold = std::move(boxes);
    laid.verdicts = Lazy<CellVerdicts>(
        [now = laid.volume, guard = laid.guard()] { return judge(*now, guard); });
    return laid;
}

bool at_scene(const Lattice& volume, double ground, const glm::dvec3& uvw)
{
    return ground == 0 && uvw.z < volume.displacement.axes[2].greville(1) / 2;
}

Pressing::Pressing(const LaidVolume& begun, const Press& press)
    : volume_(*begun.volume),
      guard_(begun.guard()),
      press_(press),
      ground_(begun.ground),
      start_(*begun.volume)
{
    if (press_.guard) verdicts_ = *begun.verdicts;
    const glm::ivec3 n = counts(volume_);
    for (int k = 0; k < n.z; ++k) {
        const double side = volume_.displacement.axes[2].greville(k) - ground_;
        toward_scene_.push_back(side > 1e-9 ? -1 : side < -1e-9 ? 1 : 0);
    }
    points_.reserve(volume_.displacement.points.size());
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j) {
            for (int k = 0; k < n.z; ++k) {
                points_.push_back(control_point(start_, i, j, k));
                const double laid = k == 0
                                        ? 0
                                        : glm::length(control_point(*begun.as_laid, i, j, k) -
                                                      control_point(*begun.as_laid, i, j, k - 1));
                gap_.push_back(least_gap * laid);
            }
            const glm::dvec3& foot = points_[points_.size() - static_cast<std::size_t>(n.z)];
            const glm::dvec3 column = points_.back() - foot;
            const double height = glm::length(column);
            up_.push_back(height > 0 ? column / height
                                     : volume_directions(start_, greville(start_, {i, j, 0})).up);
            on_scene_.push_back(glm::dot(control_point(*begun.as_laid, i, j, 0), up_.back()));
        }
}

double Pressing::height(std::size_t point, const glm::dvec3& up) const
{
    const glm::dvec3 moved = volume_.displacement.points[point] - start_.displacement.points[point];
    return glm::dot(points_[point] + moved, up);
}

// Returns the weight of the ball at each control point; if the ball reaches it twice, the larger
// one.
std::vector<double> Pressing::weights(const glm::dvec4& sample) const
{
    std::vector<double> out(points_.size(), 0.0);
    const auto at = [&](const glm::dvec3& uvw) {
        const glm::dvec3 center = evaluate(start_, uvw).value;
        const double reach = press_.radius * press_.radius;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const glm::dvec3 off = points_[i] - center;
            const double far = glm::dot(off, off);
            if (far < reach)
                out[i] = std::max(out[i], decay(press_.decay, std::sqrt(far) / press_.radius));
        }
    };
    at(glm::dvec3(sample));
    if (press_.mirror) at({sample.x, 1 - sample.y, sample.z});
    return out;
}

std::vector<PointMove> Pressing::moves(const glm::dvec4& sample) const
{
    return moves(sample, weights(sample));
}

std::vector<PointMove> Pressing::moves(const glm::dvec4& sample, const std::vector<double>& w) const
{
    return at_scene(volume_, ground_, glm::dvec3(sample)) ? on_columns(w, sample.w)
                                                          : on_layers(w, sample.w);
}

std::vector<PointMove> Pressing::on_layers(const std::vector<double>& weights, double amount) const
{
    const glm::ivec3 n = counts(volume_);
    std::vector<PointMove> out;
    std::vector<double> before, after;
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j) {
            const std::size_t first = volume_.displacement.index(i, j, 0);
            const auto column = std::span(weights).subspan(first, static_cast<std::size_t>(n.z));
            if (std::ranges::none_of(column, [](double w) { return w > 0; })) continue;
            const glm::dvec3& up = up_[static_cast<std::size_t>(i * n.y + j)];
            before.clear();
            after.clear();
            for (int k = 0; k < n.z; ++k) {
                const auto layer = static_cast<std::size_t>(k);
                before.push_back(height(first + layer, up));
                after.push_back(before.back() + toward_scene_[layer] * amount * column[layer]);
            }
            if (press_.guard) {
                const auto at = [](int k) { return static_cast<std::size_t>(k); };
                for (int k = 1; k < n.z; ++k) // points that go down stay above the one below
                    after[at(k)] =
                        std::max(after[at(k)],
                                 std::min(before[at(k)], after[at(k - 1)] + gap_[first + at(k)]));
                for (int k = n.z - 2; k >= 0; --k)
                    after[at(k)] = std::min(
                        after[at(k)],
                        std::max(before[at(k)], after[at(k + 1)] - gap_[first + at(k + 1)]));
            }
            if (!press_.into_scene) { // no point goes below the first one of its column
                const double floor = on_scene_[static_cast<std::size_t>(i * n.y + j)];
                for (std::size_t k = 0; k < after.size(); ++k)
                    after[k] = std::max(after[k], std::min(before[k], floor));
            }
            for (int k = 0; k < n.z; ++k) {
                const double by =
                    after[static_cast<std::size_t>(k)] - before[static_cast<std::size_t>(k)];
                if (by != 0) out.push_back({{i, j, k}, by * up});
            }
        }
    return out;
}

std::vector<PointMove> Pressing::on_columns(const std::vector<double>& weights, double amount) const
{
    const glm::ivec3 n = counts(volume_);
    std::vector<PointMove> out;
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j) {
            const double weight = weights[volume_.displacement.index(i, j, 0)];
            if (!(weight > 0)) continue;
            const auto column = static_cast<std::size_t>(i * n.y + j);
            double by = amount * weight;
            if (by < 0 && !press_.into_scene) {
                const double now = height(volume_.displacement.index(i, j, 0), up_[column]);
                by = std::max(by, std::min(0.0, on_scene_[column] - now));
            }
            if (by == 0) continue;
            for (int k = 0; k < n.z; ++k) out.push_back({{i, j, k}, by * up_[column]});
        }
    return out;
}

Pressing::BallMotion Pressing::add(const glm::dvec4& sample)
{
    const std::vector<double> w = weights(sample);
    std::vector<PointMove> taken = moves(sample, w);
    bool would_fold = false;
    if (press_.guard) {
        CertifiedShare proven = certified_share(volume_, verdicts_, taken, guard_);
        taken = scaled(taken, proven.share);
        would_fold = proven.share < 1;
        verdicts_ = std::move(proven.after);
    }
    const bool at_layers = !at_scene(volume_, ground_, glm::dvec3(sample));
    double weight = 0, far = 0; // of points that can follow the ball
    for (std::size_t i = 0; i < w.size(); ++i)
        if (!at_layers || toward_scene_[i % toward_scene_.size()] != 0)
            weight = std::max(weight, w[i]);
    for (const PointMove& move : taken) far = std::max(far, glm::length(move.by));
    volume_ = moved(std::move(volume_), taken);
    if (!(weight > 0)) return {};
    const double metres = far / weight;
    // Some layers are as near to each other as allowed.
    constexpr double nearly_all = 0.98;
    would_fold =
        would_fold || (press_.guard && at_layers && metres < nearly_all * std::abs(sample.w));
    return {std::copysign(metres, sample.w), would_fold};
}

double Pressing::farthest() const
{
    double far = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
        far = std::max(
            far, glm::distance(volume_.displacement.points[i], start_.displacement.points[i]));
    return far;
}

void check(const Press& press)
{
    if (!(press.radius > 0)) throw Rejected("field \"radius\" must be above 0");
    if (press.samples.empty())
        throw Rejected("field \"samples\" is empty; say where the ball presses");
    for (const glm::dvec4& s : press.samples)
        for (int i = 0; i < 3; ++i)
            if (!(s[i] >= 0 && s[i] <= 1))
                throw Rejected("field \"samples\": u, v and w lie between 0 and 1");
}

} // namespace trivar
