// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/frame.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar::gpu {
namespace {

struct DepthRange {
    double near_world, far_world;
};

// Returns the depths that the scene and its helpers occupy along the view direction, with a margin.
DepthRange depth_range(const Picture& picture, const Camera& camera, const Scene& scene)
{
    double lo = 1e300, hi = -1e300;
    const glm::dmat4 view = view_matrix(camera);
    const auto add = [&](const glm::dvec3& p_world) {
        const double depth = -(view * glm::dvec4(p_world, 1)).z;
        if (!std::isfinite(depth)) return;
        lo = std::min(lo, depth);
        hi = std::max(hi, depth);
    };
    for (const SceneItem& item : scene.items)
        for (const glm::dvec3& corner : Box{item.lo, item.hi}.corners())
            add(scene.origin_world + corner);
    for (const CastItem& volume : scene.volumes)
        for (const glm::dvec3 corner : volume.corners) add(scene.origin_world + corner);
    for (const Box& box : scene.curve_boxes)
        for (const glm::dvec3& corner : box.corners()) add(corner);
    const double target = glm::length(camera.target - camera.eye);
    const double reach = 100 * (target + scene.radius); // what leaves it may be cut
    const auto add_helper = [&](const std::vector<glm::vec3>& points) {
        for (const glm::vec3& p : points)
            if (glm::distance(glm::dvec3(p), camera.eye) < reach) add(p);
    };
    for (const Line& line : picture.lines) add_helper(line.points);
    for (const Translucent& veil : picture.translucent) add_helper(veil.points);
    if (lo > hi) lo = target * 0.5, hi = target * 2;
    const double air = 0.01 * (hi - lo) + 1e-4 * target;
    if (!camera.perspective) return {lo - air, hi + air};
    hi = std::max(hi + air, target * 1e-2);
    // A near plane should be far for the sake of depth, but never cut the target.
    const double nearest = std::min(hi * 1e-4, target * 0.02);
    return {std::clamp(lo - air, nearest, hi * 0.99), hi};
}

// The largest 1, 2 or 5 times a power of ten that is not above x.
double round_step(double x)
{
    const double power = std::pow(10.0, std::floor(std::log10(x)));
    return power * (x / power >= 5 ? 5 : x / power >= 2 ? 2 : 1);
}

// World axes along the grid, 0 to 2, and whether the view sees it face to face.
struct GridPlane {
    int u = 0, v = 1;
    bool faced = false;
};

// Z 0, or the plane that an orthographic view along an axis looks at: Z 0 is a line in that.
GridPlane grid_plane(const Camera& camera)
{
    const double nearly = std::cos(glm::radians(1.0));
    const glm::dvec3 view = glm::abs(glm::normalize(camera.target - camera.eye));
    if (camera.perspective || std::max({view.x, view.y, view.z}) < nearly) return {};
    if (view.x > nearly) return {1, 2, true};
    if (view.y > nearly) return {0, 2, true};
    return {0, 1, true};
}

// The grid stays where it is in the world, whatever the middle of the scene.
void set_grid(Frame& f, const GridPlane& plane, const glm::dvec3& origin_world,
              const Backdrop& backdrop, double step)
{
    const std::array axes{backdrop.axis_x, backdrop.axis_y, backdrop.axis_z};
    f.grid_lines = {backdrop.grid, backdrop.grid_major, axes[static_cast<std::size_t>(plane.u)],
                    axes[static_cast<std::size_t>(plane.v)]};
    glm::vec3 u(0), v(0);
    u[plane.u] = v[plane.v] = 1;
    const glm::dvec2 origin(origin_world[plane.u], origin_world[plane.v]);
    f.grid_at = glm::vec4(-glm::mod(origin, 5 * step), -origin);
    f.grid_u = glm::vec4(u, -glm::dot(glm::cross(u, v), glm::vec3(origin_world)));
    f.grid_v = glm::vec4(v, plane.faced ? 1 : 0);
}

} // namespace

Frame frame_of(const Picture& picture, const Camera& camera, const Scene& scene, const Look& look,
               const Studio& studio)
{
    const glm::dvec3 forward = camera.target - camera.eye;
    const double target = glm::length(forward);
    if (!(target > 0) || !std::isfinite(target) || !(camera.fov_y > 0 && camera.fov_y < 3.1) ||
        !(camera.height_world > 0) || !std::isfinite(camera.height_world))
        throw Rejected("The camera looks nowhere: its eye and its target must differ.");
    const DepthRange depth = depth_range(picture, camera, scene);
    const glm::dmat4 view =
        glm::translate(view_matrix(camera), scene.origin_world); // scene -> view
    const glm::dmat4 clip = projection_matrix(camera, depth.near_world, depth.far_world);

    Frame f{};
    f.view = view;
    f.clip = clip;
    f.view_clip = clip * view;
    f.from_view = glm::inverse(view);
    f.eye = camera.perspective ? glm::vec4(glm::vec3(camera.eye - scene.origin_world), 1)
                               : glm::vec4(glm::vec3(-forward / target), 0);
    const glm::vec2 size(camera.size_px);
    f.size_px = glm::vec4(size, 1.0f / size);
    f.key_dir = glm::vec4(studio.boxes[0].direction, studio.boxes[0].half_size.x);
    f.key_light = glm::vec4(studio.key_irradiance, picture.settings.shadows ? 1 : 0);
    for (std::size_t k = 0; k < 9; ++k) f.ambient[k] = glm::vec4(studio.ambient[k], 0);
    for (std::size_t i = 0; i < 3; ++i) {
        const Studio::Box& box = studio.boxes[i];
        f.box_dir[i] = glm::vec4(box.direction, 0);
        f.box_right[i] = glm::vec4(box.right, box.half_size.x);
        f.box_up[i] = glm::vec4(box.up, box.half_size.y);
        f.box_light[i] = glm::vec4(box.radiance, box.softness);
    }
    const Backdrop& backdrop = picture.backdrop ? *picture.backdrop : look.backdrop;
    f.backdrop = {glm::vec4(backdrop.top, backdrop.corners), glm::vec4(backdrop.middle, 0),
                  glm::vec4(backdrop.bottom, 0)};
    f.zenith = glm::vec4(studio.zenith, 0);
    f.horizon = glm::vec4(studio.horizon, 0);
    f.floor_light = glm::vec4(studio.floor, 0);

    // Lengths of the shading follow the scene, but no more than what the picture shows of it.
    const double shown = 0.6 * pixel_size_world(camera, target) * glm::length(camera.size_px);
    const double radius = std::min<double>(scene.radius, shown);
    const float exposure = static_cast<float>(std::exp2(picture.settings.exposure));
    f.scene = glm::vec4(radius, exposure, 0.22 * radius, 0);
    const bool ground = picture.settings.ground && !scene.items.empty();
    const double step = round_step(radius / 4);
    f.ground = glm::vec4(scene.ground_z, step, 6 * scene.radius, ground ? 1 : 0);
    set_grid(f, grid_plane(camera), scene.origin_world, backdrop, step);
    const float line_px = backdrop.line_px * static_cast<float>(picture.scale);
    f.centre = glm::vec4((scene.lo + scene.hi) * 0.5f, line_px);
    // Upwards the harmonics of bands 1 and 2 that count are z and 3 z^2 - 1.
    const glm::vec3 ambient = studio.ambient[0] + studio.ambient[2] + 2.0f * studio.ambient[6];
    const glm::vec3 key = studio.key_irradiance * std::max(studio.boxes[0].direction.z, 0.0f);
    f.ground_share = glm::vec4(ambient / glm::max(ambient + key, glm::vec3(1e-6f)), 0);
    const glm::vec3 extent = scene.hi - scene.lo;
    const float side = std::max({std::max(extent.x, extent.y) + 1.6f * extent.z, 1e-6f});
    f.contact = glm::vec4(glm::vec2(f.centre) - side / 2, 1 / side, side);
    return f;
}

Frame sample_of(const Frame& frame, int index, int count)
{
    if (count <= 1) return frame;
    float reversed = 0, half = 0.5f; // radical inverse in base 2
    for (int bits = index; bits > 0; bits >>= 1, half /= 2)
        if (bits & 1) reversed += half;
    const auto n = static_cast<float>(count);
    const glm::vec2 shift_px((static_cast<float>(index) + 0.5f) / n - 0.5f,
                             reversed + 0.5f / n - 0.5f);
    Frame f = frame;
    const glm::vec2 shift = shift_px * 2.0f * glm::vec2(frame.size_px.z, frame.size_px.w);
    f.clip = glm::translate(glm::mat4(1), glm::vec3(shift, 0)) * frame.clip;
    f.view_clip = f.clip * f.view;
    f.scene.w = static_cast<float>(index);
    return f;
}

} // namespace trivar::gpu
