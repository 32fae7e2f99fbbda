// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/embed.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

constexpr double flat_share = 1e-9; // share of the largest edge: a thinner model is flat
// Share of the stroke's length, if the model has no size there
constexpr double flat_size = 1.0 / 20;

double metres_per_unit(const ModelFrame& frame, const PlacementParameters& p, double length)
{
    const glm::dvec3 size = frame.box.size();
    const double along = frame.flat.x ? std::max(size.y, size.z) : size.x;
    return length * p.fill / along;
}

// The columns are the images of the axes. A quarter turn about x takes y to z and z to -y.
glm::dmat3 turn_of(LengthAxis along, long rolls, bool reverse)
{
    const glm::dmat3 quarter(1, 0, 0, 0, 0, 1, 0, -1, 0);
    glm::dmat3 out(1);
    if (along == LengthAxis::y) out = glm::dmat3(0, -1, 0, 1, 0, 0, 0, 0, 1); // its top stays up
    if (along == LengthAxis::z)
        out = glm::dmat3(0, 0, -1, 0, 1, 0, 1, 0, 0); // it lies on its front
    for (long i = 0; i < ((rolls % 4) + 4) % 4; ++i) out = quarter * out;
    if (reverse) out = glm::dmat3(-1, 0, 0, 0, -1, 0, 0, 0, 1) * out;
    return out;
}

glm::dmat3 turn_of(const PlacementParameters& p)
{
    return turn_of(p.along, std::lround(p.roll_deg / 90), p.reverse);
}

glm::dmat3 turn_of(const Lying& lying)
{
    const int side = static_cast<int>(lying.on);
    glm::dmat3 out = side < 4 ? turn_of(LengthAxis::x, side, false)
                              : turn_of(LengthAxis::z, lying.on == Underside::back ? 2 : 0, false);
    for (int i = 0; i < lying.quarters; ++i) out = glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1) * out;
    return out;
}

} // namespace

Lying lying_of(const PlacementParameters& parameters)
{
    const glm::dmat3 turn = turn_of(parameters);
    for (int side = 0; side < 6; ++side)
        for (int quarters = 0; quarters < 4; ++quarters)
            if (const Lying lying{static_cast<Underside>(side), quarters}; turn_of(lying) == turn)
                return lying;
    return {};
}

PlacementParameters with_lying(PlacementParameters parameters, const Lying& lying)
{
    const glm::dmat3 turn = turn_of(lying);
    for (const LengthAxis along : {LengthAxis::x, LengthAxis::y, LengthAxis::z})
        for (const bool reverse : {false, true})
            for (int roll = 0; roll < 4; ++roll)
                if (turn_of(along, roll, reverse) == turn) {
                    parameters.along = along;
                    parameters.roll_deg = 90.0 * roll;
                    parameters.reverse = reverse;
                }
    return parameters;
}

bool looks_back(const PlacementParameters& parameters)
{
    return parameters.reverse != (parameters.along == LengthAxis::y);
}

PlacementParameters lengthwise(PlacementParameters parameters, const Box& model)
{
    constexpr double clearly = 1.2;
    const glm::dvec3 size = model.size();
    if (size.y > clearly * size.x && size.x >= 0) {
        parameters.along = LengthAxis::y;
        parameters.reverse = true;
    }
    return parameters;
}

ModelFrame model_frame(const PlacementParameters& parameters, const Box& model)
{
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(model.size()[axis]) || !std::isfinite(model.lo[axis]))
            throw Rejected("the model has vertices whose coordinates are not finite numbers");
    if (model.empty() || model.size() == glm::dvec3(0))
        throw Rejected("the model is empty or a single point; choose another one");

    ModelFrame out;
    out.turn = turn_of(parameters);
    out.box.add(out.turn * model.lo);
    out.box.add(out.turn * model.hi);
    const glm::dvec3 size = out.box.size();
    const double largest = std::max({size.x, size.y, size.z});
    out.flat = glm::lessThanEqual(size, glm::dvec3(flat_share * largest));
    return out;
}

double strip_width(const ModelFrame& frame, const PlacementParameters& parameters, double length)
{
    if (parameters.width > 0) return parameters.width;
    if (frame.flat.y) return flat_size * length;
    return frame.box.size().y * metres_per_unit(frame, parameters, length);
}

double volume_height(const ModelFrame& frame, const PlacementParameters& parameters, double length)
{
    if (parameters.height > 0) return parameters.height;
    if (frame.flat.z) return flat_size * length;
    return frame.box.size().z * metres_per_unit(frame, parameters, length);
}

glm::dmat4 model_to_uvw(const ModelFrame& frame, const PlacementParameters& parameters)
{
    const glm::dvec3 size = frame.box.size();
    const glm::dvec3 extent(parameters.fill, 1, 1);
    glm::dvec3 scale(0), origin(parameters.start, 0, 0);
    for (int axis = 0; axis < 3; ++axis) {
        if (!frame.flat[axis]) {
            scale[axis] = extent[axis] / size[axis];
            continue;
        }
        // A flat model lies on the contact surface, and in the middle of the strip.
        if (axis < 2) origin[axis] += extent[axis] / 2;
    }
    glm::dmat4 out(1);
    out = glm::translate(out, origin);
    out = glm::scale(out, scale);
    out = glm::translate(out, -frame.box.lo);
    return out * glm::dmat4(frame.turn);
}

} // namespace trivar
