// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/keys.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {

std::vector<std::size_t> chosen_keys(std::size_t count,
                                     const std::function<bool(std::size_t, std::size_t)>& holds)
{
    std::vector<std::size_t> out{0};
    while (out.back() + 1 < count) {
        const std::size_t from = out.back(), last = count - 1;
        std::size_t good = from + 1, bad = last + 1;
        for (std::size_t way = 2; from + way <= last; way *= 2)
            if (holds(from, from + way)) {
                good = from + way;
            } else {
                bad = from + way;
                break;
            }
        if (bad > last && good < last && holds(from, last)) good = last;
        while (good + 1 < bad && good < last) {
            const std::size_t middle = (good + bad) / 2;
            (holds(from, middle) ? good : bad) = middle;
        }
        out.push_back(good);
    }
    return out;
}

float not_before(double time_s)
{
    const auto out = static_cast<float>(time_s);
    return double{out} < time_s ? std::nextafter(out, std::numeric_limits<float>::infinity()) : out;
}
float not_after(double time_s)
{
    const auto out = static_cast<float>(time_s);
    return double{out} > time_s ? std::nextafter(out, -std::numeric_limits<float>::infinity())
                                : out;
}

NodeTransform between_parts(const NodeTransform& a, const NodeTransform& b, double share)
{
    return {glm::mix(a.translation, b.translation, share),
            glm::normalize(glm::slerp(a.rotation, b.rotation, share)),
            glm::mix(a.scale, b.scale, share)};
}

std::optional<NodeMotion> node_motion(int node, const std::vector<glm::dmat4>& matrices,
                                      const std::vector<float>& times_s, const Box& box,
                                      double tolerance)
{
    std::vector<NodeTransform> placed;
    for (const glm::dmat4& matrix : matrices) {
        const std::optional<NodeTransform> parts = as_parts(matrix);
        if (!parts) return {};
        placed.push_back(*parts);
        if (placed.size() > 1 && glm::dot(placed[placed.size() - 2].rotation, parts->rotation) < 0)
            placed.back().rotation = -placed.back().rotation;
    }
    const auto off_at = [&](std::size_t moment, const glm::dmat4& matrix) {
        double most = 0;
        for (const glm::dvec3& corner : box.corners()) {
            const glm::dvec4 p(corner, 1);
            most = std::max(most, glm::distance(matrix * p, matrices[moment] * p));
        }
        return most;
    };
    const auto off_between = [&](std::size_t from, std::size_t to) {
        double most = 0;
        for (std::size_t i = from; i <= to; ++i) {
            const double share = from == to ? 0
                                            : (double{times_s[i]} - double{times_s[from]}) /
                                                  (double{times_s[to]} - double{times_s[from]});
            most =
                std::max(most, off_at(i, between_parts(placed[from], placed[to], share).matrix()));
        }
        return most;
    };
    NodeMotion out{{}, placed.front()};
    if (std::ranges::all_of(matrices, [&](const auto& m) { return m == matrices.front(); }))
        return out;
    const std::vector<std::size_t> keys =
        chosen_keys(matrices.size(), [&](std::size_t from, std::size_t to) {
            return off_between(from, to) <= tolerance;
        });
    for (std::size_t k = 0; k + 1 < keys.size(); ++k)
        out.off = std::max(out.off, off_between(keys[k], keys[k + 1]));
    out.keys = keys.size();
    const auto add = [&](Channel::Of of, std::size_t components, const auto& value) {
        Channel channel;
        channel.node = node;
        channel.of = of;
        channel.components = components;
        bool changes = false;
        for (const std::size_t key : keys) {
            channel.times_s.push_back(times_s[key]);
            const auto v = value(placed[key]);
            for (int i = 0; i < static_cast<int>(components); ++i)
                channel.values.push_back(static_cast<float>(v[i]));
            changes |= v != value(placed.front());
        }
        if (changes) out.channels.push_back(std::move(channel));
    };
    add(Channel::Of::translation, 3, [](const NodeTransform& p) { return p.translation; });
    add(Channel::Of::rotation, 4, [](const NodeTransform& p) {
        return glm::dvec4(p.rotation.x, p.rotation.y, p.rotation.z, p.rotation.w);
    });
    add(Channel::Of::scale, 3, [](const NodeTransform& p) { return p.scale; });
    return out;
}

} // namespace trivar
