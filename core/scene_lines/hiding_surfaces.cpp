// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene_lines/hiding_surfaces.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr double touching = 1e-3; // of the lesser size: what lies so near before a line is at it
constexpr double step = 1e-6;     // of the way and the size, past a surface that hides nothing
constexpr int most_passed = 1000; // surfaces on one ray

RayScene ray_scene(const std::vector<HidingSurfaces::Surface>& surfaces)
{
    std::vector<RayScene::Entry> out;
    for (const HidingSurfaces::Surface& each : surfaces)
        out.push_back({each.mesh, each.to_world, each.object});
    return RayScene(std::move(out));
}

bool is_own(const HidingSurfaces::Surface& surface, const HidingSurfaces::Owner& own)
{
    return surface.object == own.object && own.number.value_or(surface.number) == surface.number;
}

} // namespace

HidingSurfaces::HidingSurfaces(std::vector<Surface> surfaces)
    : surfaces_(std::move(surfaces)),
      scene_(ray_scene(surfaces_))
{
}

bool HidingSurfaces::has_others(const Owner& own) const
{
    return !std::ranges::all_of(surfaces_, [&](const Surface& each) { return is_own(each, own); });
}

bool HidingSurfaces::passes(const Hit& hit, const Owner& own) const
{
    const Surface& surface = surfaces_[static_cast<std::size_t>(hit.entry)];
    if (is_own(surface, own)) return true;
    if (hit.distance < touching * std::min(own.size, surface.size)) return true;
    if (!surface.materials) return false;
    const std::vector<std::uint32_t>& of_faces = surface.mesh->mesh().face_material;
    const std::size_t material =
        of_faces.empty() ? 0 : of_faces[static_cast<std::size_t>(hit.face)];
    return material < surface.materials->size() &&
           (*surface.materials)[material].alpha == Material::Alpha::blend;
}

bool HidingSurfaces::hide(const glm::dvec3& p_world, const Owner& own, const Camera& camera) const
{
    const glm::dvec3 to_eye =
        camera.perspective ? camera.eye - p_world : camera.eye - camera.target;
    const double length = glm::length(to_eye), end = camera.perspective ? length : 1e300;
    if (!(length > 0)) return false;
    const Ray ray{p_world, to_eye / length};
    double from = 0;
    for (int i = 0; i < most_passed; ++i) {
        const std::optional<Hit> hit = scene_.hit(ray, from, end);
        if (!hit) return false;
        if (!passes(*hit, own)) return true;
        from = std::max(from, hit->distance) + step * (std::abs(hit->distance) + own.size);
    }
    return false;
}

} // namespace trivar
