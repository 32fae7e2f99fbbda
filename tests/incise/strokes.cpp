// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/incise/strokes.h"

#include <algorithm>
#include <cmath>

namespace trivar::testing {

SkinPlace RandomHand::place()
{
    for (;;) {
        const auto t = static_cast<std::uint32_t>(
            number(0, static_cast<double>(skin_.triangle_count()) - 1e-6));
        if (!(glm::length(skin_.area_normal(t)) > 0)) continue;
        double b = number(), c = number();
        if (b + c > 1) b = 1 - b, c = 1 - c;
        return {t, {1 - b - c, b, c}};
    }
}

glm::dvec3 RandomHand::direction(std::uint32_t triangle)
{
    const glm::dvec3 n = normal(triangle);
    const glm::dvec3 any = std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return turned(triangle, glm::normalize(glm::cross(n, any)), number(0, 6.283185307));
}

glm::dvec3 RandomHand::turned(std::uint32_t triangle, const glm::dvec3& d, double angle) const
{
    return std::cos(angle) * d + std::sin(angle) * glm::cross(normal(triangle), d);
}

glm::dvec3 RandomHand::position(const SkinPlace& at) const
{
    const glm::uvec3& p = skin_.triangle(at.triangle);
    return at.weights.x * skin_.position(p.x) + at.weights.y * skin_.position(p.y) +
           at.weights.z * skin_.position(p.z);
}

bool RandomHand::move(SkinPlace& at, glm::dvec3& d, double distance)
{
    for (int crossed = 0; crossed < 200; ++crossed) {
        const std::uint32_t t = at.triangle;
        const glm::uvec3& p = skin_.triangle(t);
        const glm::dvec3 e1 = skin_.position(p.y) - skin_.position(p.x);
        const glm::dvec3 e2 = skin_.position(p.z) - skin_.position(p.x);
        if (!(glm::length(skin_.area_normal(t)) > 0)) return false;
        const glm::dvec3 n = normal(t);
        d = glm::normalize(d - glm::dot(d, n) * n);
        const double a11 = glm::dot(e1, e1), a12 = glm::dot(e1, e2), a22 = glm::dot(e2, e2);
        const double det = a11 * a22 - a12 * a12, r1 = glm::dot(d, e1), r2 = glm::dot(d, e2);
        if (!(det > 0)) return false;
        const double db = (a22 * r1 - a12 * r2) / det, dc = (a11 * r2 - a12 * r1) / det;
        const glm::dvec3 rate(-db - dc, db, dc);
        double far = distance;
        int out = -1; // the corner whose weight ends first
        for (int i = 0; i < 3; ++i)
            if (rate[i] < 0 && at.weights[i] / -rate[i] < far) {
                far = std::max(0.0, at.weights[i] / -rate[i]);
                out = i;
            }
        at.weights = glm::max(at.weights + far * rate, glm::dvec3(0));
        at.weights /= at.weights.x + at.weights.y + at.weights.z;
        if (out < 0) return true;
        distance -= far;
        const std::uint32_t side = 3 * t + static_cast<std::uint32_t>((out + 1) % 3);
        const std::uint32_t other = skin_.across(side);
        if (other == SlitSkin::none || !(glm::length(skin_.area_normal(other / 3)) > 0))
            return false;
        const glm::dvec3 along =
            glm::normalize(skin_.position(skin_.to(side)) - skin_.position(skin_.from(side)));
        const double share = std::clamp(at.weights[(out + 2) % 3], 0.02, 0.98); // at its end
        const glm::dvec3 into = glm::cross(normal(other / 3), -along);
        const double straight = glm::dot(d, along);
        d = glm::normalize(straight * along +
                           std::max(0.05, std::sqrt(std::max(0.0, 1 - straight * straight))) *
                               into);
        constexpr double inside = 1e-4;
        const int i = static_cast<int>(other % 3); // where the other side begins: this one's end
        at.triangle = other / 3;
        at.weights[i] = share * (1 - inside);
        at.weights[(i + 1) % 3] = (1 - share) * (1 - inside);
        at.weights[(i + 2) % 3] = inside;
    }
    return false;
}

std::vector<SkinPlace> RandomHand::path(const SkinPlace& at, const glm::dvec3& direction,
                                        const Path& path)
{
    const double step = std::min(path.length / 6, 0.6 * skin_.usual_edge());
    const auto drawn = [&](glm::dvec3 d, double length, double curvature,
                           std::vector<SkinPlace>& out) {
        SkinPlace now = at;
        for (double done = 0; done < length;) {
            const double next = std::min(step, length - done);
            d = turned(now.triangle, d, curvature * next + path.tremble * number(-0.5, 0.5));
            if (!move(now, d, next)) return false;
            out.push_back(now);
            done += next;
        }
        return true;
    };
    std::vector<SkinPlace> before, after;
    if (path.back > 0 && !drawn(-direction, path.length * path.back, -path.curvature, before))
        return {};
    if (path.back < 1 && !drawn(direction, path.length * (1 - path.back), path.curvature, after))
        return {};
    std::ranges::reverse(before);
    before.push_back(at);
    before.insert(before.end(), after.begin(), after.end());
    return before;
}

std::vector<SurfacePoint> RandomHand::stroke(const std::vector<SkinPlace>& path) const
{
    std::vector<SurfacePoint> out;
    for (const SkinPlace& at : path) out.push_back({position(at), normal(at.triangle)});
    return out;
}

Incision random_single(const SlitSkin& skin, RandomHand& hand, bool loop)
{
    const double edge = skin.usual_edge();
    double length = edge * std::exp(std::log(0.4) + hand.number() * std::log(40 / 0.4));
    length = std::min(length, 0.5 * skin.diagonal());
    double curvature = hand.number(-2, 2) / length;
    if (loop) {
        length = std::max(length, 12 * edge);
        curvature = 8.2 / length;
    }
    Incision out;
    for (int tries = 0; tries < 20 && out.stroke.empty(); ++tries) {
        SkinPlace at = hand.place();
        if (hand.number() < 0.1) at = hand.at_point(at.triangle);
        out.stroke = hand.stroke(
            hand.path(at, hand.direction(at.triangle),
                      {length, curvature, hand.number() < 0.3 ? 0.5 : 0.1, hand.number()}));
    }
    out.depth = edge * hand.number(0.3, 4.3);
    out.width = std::min(0.18 * length, edge * hand.number(0.2, 3.2));
    if (loop) out.width = std::min(out.width, 0.04 * length);
    out.floor = hand.number() < 0.5 ? Incision::Floor::u : Incision::Floor::v;
    out.floor_width = hand.number(0.1, 1);
    return out;
}

namespace {

// Along edges of the skin from a point, always the one that runs most straight on.
std::vector<SkinPlace> along_edges(const SlitSkin& skin, std::uint32_t point, const glm::dvec3& d)
{
    std::vector<SkinPlace> out;
    std::uint32_t last = SlitSkin::none;
    for (int i = 0; i < 8; ++i) {
        double best = -2;
        std::uint32_t next = SlitSkin::none, here = SlitSkin::none;
        skin.around(point, [&](std::uint32_t side) {
            here = side;
            const std::uint32_t to = skin.to(side);
            const double ahead =
                glm::dot(d, glm::normalize(skin.position(to) - skin.position(point)));
            if (to == last || ahead <= best) return;
            best = ahead;
            next = to;
        });
        if (next == SlitSkin::none) return {};
        SkinPlace at{here / 3, glm::dvec3(0)};
        at.weights[static_cast<int>(here % 3)] = 1;
        out.push_back(at);
        last = point;
        point = next;
    }
    return out;
}

std::vector<std::vector<SkinPlace>> crossing_paths(const SlitSkin& skin, RandomHand& hand,
                                                   std::size_t kind)
{
    const double edge = skin.usual_edge();
    const double length = std::min(edge * hand.number(5, 30), 0.4 * skin.diagonal());
    const double bend = hand.number(-1, 1) / length;
    SkinPlace at = hand.place();
    if (kind == 2) at = hand.at_point(at.triangle);
    const glm::dvec3 d = hand.direction(at.triangle);
    const auto turned = [&](double angle) { return hand.turned(at.triangle, d, angle); };
    std::vector<std::vector<SkinPlace>> out;
    const auto add = [&](const SkinPlace& from, const glm::dvec3& along, double l, double curvature,
                         double back) {
        out.push_back(hand.path(from, along, {l, curvature, 0.05, back}));
    };
    switch (kind) {
    case 1:
        add(at, d, length, bend, 0.5);
        add(at, turned(hand.number(0.3, 2.8)), 0.6 * length, bend, 0);
        break;
    case 3: {
        add(at, d, length, bend, 0.5);
        SkinPlace beside = at;
        glm::dvec3 across = turned(1.57);
        if (!hand.move(beside, across, edge * std::pow(10, hand.number(-4, 0)))) return {};
        add(beside, turned(hand.number(-0.01, 0.01)), length, bend, hand.number(0.3, 0.7));
        break;
    }
    case 4: {
        add(at, d, length, bend, 0.5);
        if (out[0].empty()) return {};
        std::vector<SkinPlace> again(out[0].begin() + static_cast<long>(out[0].size() / 3),
                                     out[0].end());
        if (hand.number() < 0.5) std::ranges::reverse(again);
        const SkinPlace end = again.back();
        const auto more = hand.path(end, hand.direction(end.triangle), {0.3 * length, 0, 0, 0});
        if (!more.empty()) again.insert(again.end(), more.begin() + 1, more.end());
        out.push_back(std::move(again));
        break;
    }
    case 5:
        add(at, d, length, 3.5 / length, 0.5);
        add(at, turned(0.45), length, -3.5 / length, 0.3);
        break;
    case 6: {
        const double t = hand.number();
        add(at, d, length, bend, 0.5);
        add(at, turned(0.6 + 0.6 * t), length, -bend, 0.4);
        add(at, turned(1.8 + 0.6 * t), 0.8 * length, bend, 0.6);
        break;
    }
    case 7:
        for (int i = 0; i < 5; ++i) {
            SkinPlace near = at;
            glm::dvec3 any = hand.direction(at.triangle);
            if (!hand.move(near, any, 0.2 * length * hand.number())) return {};
            add(near, turned(hand.number(0, 6.28)), length * hand.number(0.5, 1), bend, 0.5);
        }
        break;
    case 8:
        out.push_back(along_edges(skin, skin.triangle(at.triangle).x, d));
        out.push_back(along_edges(skin, skin.triangle(at.triangle).y, turned(1.5)));
        break;
    default:
        add(at, d, length, bend, hand.number(0.2, 0.8));
        add(at, turned(hand.number(0.05, 3.09)), length * hand.number(0.4, 1.4), bend,
            hand.number(0.2, 0.8));
    }
    for (const auto& path : out)
        if (path.empty()) return {};
    return out;
}

} // namespace

std::vector<Incision> random_set(const SlitSkin& skin, RandomHand& hand, std::size_t kind)
{
    std::vector<std::vector<SkinPlace>> paths;
    for (int tries = 0; tries < 30 && paths.empty(); ++tries)
        paths = crossing_paths(skin, hand, kind);
    std::vector<Incision> out;
    const double edge = skin.usual_edge();
    for (const std::vector<SkinPlace>& path : paths) {
        Incision cut;
        cut.stroke = hand.stroke(path);
        double length = 0;
        for (std::size_t i = 1; i < path.size(); ++i)
            length += glm::distance(cut.stroke[i].p, cut.stroke[i - 1].p);
        cut.depth = edge * hand.number(0.5, 3.5);
        if (!out.empty() && kind != 9 && hand.number() < 0.5) cut.depth = out[0].depth;
        cut.width = std::min(0.15 * length, edge * hand.number(0.2, 2.2));
        if (kind == 7) cut.width *= 0.5;
        cut.floor = hand.number() < 0.5 ? Incision::Floor::u : Incision::Floor::v;
        cut.floor_width = hand.number(0.1, 0.9);
        out.push_back(std::move(cut));
    }
    return out;
}

} // namespace trivar::testing
