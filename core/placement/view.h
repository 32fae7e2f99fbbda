// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"

namespace trivar {

// A View is a camera made ready to project many points: project() without setting up the frame each
// time.
class View {
public:
    explicit View(const Camera& camera)
        : world_to_view_(view_matrix(camera)),
          center_px_(camera.size_px / 2.0),
          pixel_at_one_(pixel_size_world(camera, 1)),
          eye_(camera.eye),
          forward_(-world_to_view_[0][2], -world_to_view_[1][2], -world_to_view_[2][2]),
          perspective_(camera.perspective)
    {
    }

    PicturePoint project(const glm::dvec3& p_world) const
    {
        const glm::dvec3 p(world_to_view_ * glm::dvec4(p_world, 1));
        const double pixels = 1 / pixel_size(-p.z);
        return {center_px_ + glm::dvec2(p.x, -p.y) * pixels, -p.z};
    }
    // The ray through a pixel, the same as ray_through() gives.
    Ray ray(glm::dvec2 p_px) const
    {
        const glm::dvec2 offset = (p_px - center_px_) * glm::dvec2(pixel_at_one_, -pixel_at_one_);
        const glm::dvec3 right(world_to_view_[0][0], world_to_view_[1][0], world_to_view_[2][0]);
        const glm::dvec3 up(world_to_view_[0][1], world_to_view_[1][1], world_to_view_[2][1]);
        const glm::dvec3 across = right * offset.x + up * offset.y;
        if (perspective_) return {eye_, glm::normalize(forward_ + across)};
        return {eye_ + across, forward_};
    }
    // The ray on which the camera sees a point in front of it.
    Ray ray_to(const glm::dvec3& p_world) const
    {
        if (perspective_) return {eye_, glm::normalize(p_world - eye_)};
        return {p_world + glm::dot(eye_ - p_world, forward_) * forward_, forward_};
    }
    // The same view for points in an object's space; only project() may be called.
    View of_object(const glm::dmat4& to_world) const
    {
        View out = *this;
        out.world_to_view_ = world_to_view_ * to_world;
        return out;
    }
    // The world length of a pixel at that depth.
    double pixel_size(double depth_world) const
    {
        return perspective_ ? pixel_at_one_ * depth_world : pixel_at_one_;
    }
    // The unit direction from the point to the eye.
    glm::dvec3 toward_eye(const glm::dvec3& p_world) const
    {
        return perspective_ ? glm::normalize(eye_ - p_world) : -forward_;
    }
    const glm::dvec3& forward() const { return forward_; }
    bool perspective() const { return perspective_; }

private:
    glm::dmat4 world_to_view_;
    glm::dvec2 center_px_;
    double pixel_at_one_;
    glm::dvec3 eye_, forward_;
    bool perspective_;
};

} // namespace trivar
