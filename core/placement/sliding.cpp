// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/sliding.h"

#include "core/placement/attachment.h"
#include "core/placement/sketch.h"
#include "core/placement/view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

// Returns two unit directions that span the plane across a third one.
std::array<glm::dvec3, 2> tangents(const glm::dvec3& normal)
{
    const glm::dvec3 other = std::abs(normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 a = glm::normalize(glm::cross(other, normal));
    return {a, glm::cross(normal, a)};
}

glm::dvec3 in_plane(const glm::dvec3& v, const glm::dvec3& normal)
{
    return v - normal * glm::dot(v, normal);
}

// Returns the normal toward the side from which the ray came, because thin sheets have no outside.
glm::dvec3 seen_normal(const Hit& hit)
{
    return hit.back_face ? -hit.normal : hit.normal;
}

// Shoots a ray down along the normal, from above the place to below it.
std::optional<Hit> under(const RayScene& scene, const Ground& near, const glm::dvec3& offset,
                         double reach)
{
    return scene.hit({near.p + offset + near.normal * reach, -near.normal}, 0, 2 * reach);
}

// Returns the rotation about a unit axis, by Rodrigues' formula.
glm::dmat3 turn_by(const glm::dvec3& axis, double cosine, double sine)
{
    const glm::dvec3& a = axis;
    const glm::dmat3 cross(0, a.z, -a.y, -a.z, 0, a.x, a.y, -a.x, 0);
    return glm::dmat3(cosine) + sine * cross + (1 - cosine) * glm::outerProduct(a, a);
}

// Returns the smallest rotation that takes one unit direction to another.
glm::dmat3 least_turn(const glm::dvec3& from, const glm::dvec3& to)
{
    const glm::dvec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis), cosine = glm::dot(from, to);
    if (sine > 1e-12) return turn_by(axis / sine, cosine, sine);
    if (cosine > 0) return glm::dmat3(1);
    return turn_by(tangents(from)[0], -1, 0);
}

// Returns the transform with this linear part that takes p to `to`.
glm::dmat4 about_place(const glm::dvec3& p, const glm::dmat3& linear, const glm::dvec3& to)
{
    glm::dmat4 out(linear);
    out[3] = glm::dvec4(to - linear * p, 1);
    return out;
}

// Finds where the rays of samples meet the scene; a miss is at the depth of the last hit.
std::vector<glm::dvec3> places_of(const Sketch& sketch, const RayScene& scene, double depth)
{
    const View view(sketch.camera);
    std::vector<Ray> rays;
    for (const StrokeSample& sample : sketch.samples) rays.push_back(view.ray(sample.p_px));
    const auto hits = scene.hits(rays);
    const auto first = std::ranges::find_if(hits, [](const auto& hit) { return hit.has_value(); });
    if (first != hits.end()) depth = (*first)->distance;
    std::vector<glm::dvec3> out;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i]) depth = hits[i]->distance;
        out.push_back(rays[i].origin + depth * rays[i].direction);
    }
    return out;
}

// Says whether something is clearly in front of at least a tenth of the places.
bool hidden(const Camera& camera, const std::vector<glm::dvec3>& places, const RayScene& scene,
            double slack)
{
    const View view(camera);
    std::vector<Ray> rays;
    std::vector<double> to;
    for (const glm::dvec3& p : places) {
        rays.push_back(view.ray_to(p));
        to.push_back(std::max(0.0, glm::distance(p, rays.back().origin) - slack));
    }
    const auto hits = scene.hits(rays, false, to);
    const auto covered =
        std::ranges::count_if(hits, [](const auto& hit) { return hit.has_value(); });
    return static_cast<std::size_t>(covered) * 10 > places.size();
}

// Sees all places in a parallel view from above, in a picture of the same height in pixels.
Sketch from_above(const Sketch& sketch, const std::vector<glm::dvec3>& places, const Ground& above,
                  double distance, const glm::dvec3& up)
{
    Sketch out = sketch;
    Camera& camera = out.camera;
    glm::dvec2 lo(1e300), hi(-1e300);
    const glm::dvec3 right = glm::cross(up, above.normal);
    for (const glm::dvec3& p : places) {
        const glm::dvec2 at(glm::dot(p - above.p, right), glm::dot(p - above.p, up));
        lo = glm::min(lo, at);
        hi = glm::max(hi, at);
    }
    const glm::dvec2 middle = (lo + hi) / 2.0, size = hi - lo;
    constexpr double margin = 2; // for what the strip has to both sides of the stroke
    const double aspect = camera.size_px.x / camera.size_px.y;
    camera.perspective = false;
    camera.height_world = margin * std::max({size.y, size.x / aspect, 1e-9});
    camera.target = above.p + right * middle.x + up * middle.y;
    camera.eye = camera.target + above.normal * distance;
    camera.up = up;
    const View view(camera);
    for (std::size_t i = 0; i < places.size(); ++i)
        out.samples[i].p_px = view.project(places[i]).p_px;
    const auto ends = [](const Sketch& s) {
        return glm::distance(s.samples.front().p_px, s.samples.back().p_px);
    };
    if (ends(sketch) <= ring_closing_px) out.samples.back().p_px = out.samples.front().p_px;
    return out;
}

} // namespace

std::optional<Ground> ground_under(const RayScene& scene, const Ground& near, double reach)
{
    const auto middle = under(scene, near, glm::dvec3(0), reach);
    if (!middle) return {};
    Ground out{middle->p_world, seen_normal(*middle)};
    constexpr int spokes = 8;
    const std::array<glm::dvec3, 2> axes = tangents(near.normal);
    glm::dvec3 sum = out.normal;
    for (const double share : {0.5, 1.0})
        for (int i = 0; i < spokes; ++i) {
            const double angle = glm::two_pi<double>() * i / spokes;
            const glm::dvec3 offset =
                (axes[0] * std::cos(angle) + axes[1] * std::sin(angle)) * (share * reach);
            if (const auto hit = under(scene, near, offset, reach)) sum += seen_normal(*hit);
        }
    if (glm::length(sum) > 1e-6) out.normal = glm::normalize(sum);
    return out;
}

std::optional<Ground> ground_hit(const RayScene& scene, const Ray& ray, double reach)
{
    const auto hit = scene.hit(ray);
    if (!hit) return {};
    const Ground met{hit->p_world, seen_normal(*hit)};
    const auto smooth = ground_under(scene, met, reach);
    return Ground{met.p, smooth ? smooth->normal : met.normal};
}

Ground walked(const RayScene& scene, Ground at, const glm::dvec3& along, double distance,
              double reach)
{
    glm::dvec3 way = in_plane(along, at.normal);
    if (!(glm::length(way) > 0) || distance == 0) return at;
    way = glm::normalize(way) * (distance < 0 ? -1.0 : 1.0);
    const double length = std::abs(distance);
    const int steps = std::clamp(static_cast<int>(std::ceil(4 * length / reach)), 1, 400);
    for (int i = 0; i < steps; ++i) {
        const Ground ahead{at.p + way * (length / steps), at.normal};
        const auto met = ground_under(scene, ahead, reach);
        if (!met) {
            at.p = ahead.p;
            continue;
        }
        // A step along a slope is as long as one on the level.
        const glm::dvec3 step = met->p - at.p;
        const double longer = glm::length(step) * steps / length;
        at.p = longer > 0 ? at.p + step / longer : ahead.p;
        const glm::dmat3 turn = least_turn(at.normal, met->normal);
        at.normal = met->normal;
        way = glm::normalize(in_plane(turn * way, at.normal));
    }
    return at;
}

glm::dmat4 slid(const Ground& from, const Ground& to)
{
    const glm::dmat3 least = least_turn(from.normal, to.normal);
    const glm::dvec3 z(0, 0, 1);
    const glm::dvec3 up_then = in_plane(z, from.normal), up_now = in_plane(z, to.normal);
    // Measures of steepness, from level to upright: between 20 and 45 degrees the one becomes the
    // other.
    constexpr double level = 0.34, steep = 0.71;
    const double least_steep = std::min(glm::length(up_then), glm::length(up_now));
    const double share = std::clamp((least_steep - level) / (steep - level), 0.0, 1.0);
    if (share == 0) return about_place(from.p, least, to.p);
    const glm::dvec3 led = glm::normalize(least * up_then), wanted = glm::normalize(up_now);
    const double angle =
        share * std::atan2(glm::dot(to.normal, glm::cross(led, wanted)), glm::dot(led, wanted));
    const glm::dmat3 upright = turn_by(to.normal, std::cos(angle), std::sin(angle));
    return about_place(from.p, angle == 0 ? least : upright * least, to.p);
}

glm::dmat4 turned_on(const Ground& ground, double angle_deg)
{
    const double angle = glm::radians(angle_deg);
    return about_place(ground.p, turn_by(ground.normal, std::cos(angle), std::sin(angle)),
                       ground.p);
}

glm::dmat4 grown_on(const Ground& ground, double factor)
{
    return about_place(ground.p, glm::dmat3(factor), ground.p);
}

Sketch moved_stroke(const Sketch& sketch, const glm::dmat4& by, const RayScene& before,
                    const RayScene& scene, const Ground& above)
{
    Sketch out{carried(sketch.camera, by), sketch.samples};
    const double depth = glm::distance(sketch.camera.eye, sketch.camera.target);
    std::vector<glm::dvec3> places = places_of(sketch, before, depth);
    Box box;
    for (glm::dvec3& p : places) {
        p = glm::dvec3(by * glm::dvec4(p, 1));
        box.add(p);
    }
    const double size = glm::length(box.size());
    // The surface may well rise by half of the stroke's length toward the camera.
    if (!hidden(out.camera, places, scene, size / 2)) return out;
    const glm::dvec3 up = in_plane(carried(sketch.camera, by).up, above.normal);
    return from_above(out, places, above, size / 2,
                      glm::length(up) > 1e-6 ? glm::normalize(up) : tangents(above.normal)[0]);
}

} // namespace trivar
