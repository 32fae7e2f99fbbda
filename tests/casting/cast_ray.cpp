// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/casting/cast_ray.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace kernel {
using namespace glm;

// A CastingKernel is the formulas of core/kernel as C++; the shaders include the same text.
struct CastingKernel {
    const Casting& casting;
    const ScalarField<float>& field;
    FieldOrder field_order;

    int order() const { return static_cast<int>(field_order) + 2; }
    bool rough() const { return false; }
    vec3 last() const { return field.end(); }
    float share(float sample) const
    {
        return static_cast<float>(casting.share_of_sample.x * double{sample} +
                                  casting.share_of_sample.y);
    }
    // Linear between what `of` has at whole numbers from `first` to `size`.
    float linear(vec3 p, int first, ivec3 size, auto&& of) const
    {
        p = clamp(p, vec3(static_cast<float>(first)), vec3(size));
        const ivec3 i = clamp(ivec3(floor(p)), ivec3(first), size - 1);
        const vec3 t = p - vec3(i);
        const auto row = [&](int y, int z) {
            return mix(of(i.x, i.y + y, i.z + z), of(i.x + 1, i.y + y, i.z + z), t.x);
        };
        return share(mix(mix(row(0, 0), row(1, 0), t.y), mix(row(0, 1), row(1, 1), t.y), t.z));
    }
    float sample_at(vec3 p) const
    {
        return linear(p, 0, field.size() - 1, [&](int x, int y, int z) {
            return field.at<0>(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z))
                .value;
        });
    }
    float coefficient_at(vec3 p) const
    {
        return linear(p, -1, field.size(),
                      [&](int x, int y, int z) { return field.coefficient(x, y, z); });
    }
    int empty_reach(ivec3 b) const { return casting.empty.of(b); }
    vec4 transfer_before(float u) const { return casting.transfer.before_share(u); }
    vec3 lit(vec3 color, vec3, vec3) const { return color; }

#include "core/kernel/spline_taps.glsl"

#include "core/kernel/casting.glsl"
};

} // namespace kernel

CastLight cast_ray(const Casting& casting, const CastRay& ray, FieldOrder order)
{
    kernel::CastingKernel kernel{casting, casting.field->field(), order};
    glm::vec3 along = ray.along;
    for (int k = 0; k < 3; ++k)
        if (std::abs(along[k]) < 1e-9f) along[k] = 1e-9f;
    const auto gathered =
        kernel.cast_ray(ray.from, along, ray.end, ray.pace, ray.jitter, ray.thickness);
    return {gathered.color, gathered.opacity, gathered.hit};
}

CastValue cast_value(const Casting& casting, const glm::vec3& p, FieldOrder order)
{
    kernel::CastingKernel kernel{casting, casting.field->field(), order};
    return {kernel.value_at(p), kernel.slope_at(p)};
}

} // namespace trivar
