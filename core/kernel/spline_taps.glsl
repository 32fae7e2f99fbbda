// Values and slopes of splines by linear fetches.   GLSL and C++: see tests/casting/cast_ray.cpp
//
// Places are in voxels. Supplied:
//   int order()                     of the spline: 2 linear through the samples, 3 quadratic, 4 cubic
//   bool rough()                    slopes of linear fields by differences forward
//   vec3 last()                     the greatest coordinates of the grid
//   float sample_at(vec3 p)         the samples, linear in between
//   float coefficient_at(vec3 p)    the same of the spline's coefficients, which begin at -1

// Where a spline is the mean of linear fetches, two along each axis [Sigg, Hadwiger 2005]: its value
// is their mix by the share, a slope is the share of their difference.
struct Taps {
    vec3 lower, upper, share;
};

Taps value_taps(vec3 p)
{
    Taps taps;
    if (order() == 4) {
        vec3 i = clamp(floor(p), vec3(0.0f), last() - 1.0f), t = p - i, s = 1.0f - t;
        vec3 w0 = s * s * s / 6.0f, w1 = (t * t * (3.0f * t - 6.0f) + 4.0f) / 6.0f, w3 = t * t * t / 6.0f;
        taps.share = 1.0f - w0 - w1;
        taps.lower = i - 1.0f + w1 / (w0 + w1);
        taps.upper = i + 1.0f + w3 / taps.share;
    } else {
        vec3 i = clamp(floor(p + 0.5f), vec3(0.0f), last()), t = p - i, a = 0.5f - t, b = 0.5f + t;
        vec3 w0 = a * a * 0.5f, w1 = 0.75f - t * t;
        taps.share = b * b * 0.5f;
        taps.lower = i - 1.0f + w1 / (w0 + w1);
        taps.upper = i + 1.0f;
    }
    return taps;
}

Taps slope_taps(vec3 p)
{
    Taps taps;
    if (order() == 4) {
        vec3 i = clamp(floor(p), vec3(0.0f), last() - 1.0f), t = p - i;
        taps.share = 0.5f + t - t * t;
        taps.lower = i - 1.0f + t * (2.0f - 1.5f * t) / taps.share;
        taps.upper = i + 1.0f + 0.5f * t * t / taps.share;
    } else {
        taps.share = vec3(1.0f);
        taps.lower = p - 0.5f;
        taps.upper = p + 0.5f;
    }
    return taps;
}

// Means over two axes at a place of the third.
float mean_yz(float x, Taps v)
{
    float low = mix(coefficient_at(vec3(x, v.lower.y, v.lower.z)),
                    coefficient_at(vec3(x, v.upper.y, v.lower.z)), v.share.y);
    float high = mix(coefficient_at(vec3(x, v.lower.y, v.upper.z)),
                     coefficient_at(vec3(x, v.upper.y, v.upper.z)), v.share.y);
    return mix(low, high, v.share.z);
}
float mean_xz(float y, Taps v)
{
    float low = mix(coefficient_at(vec3(v.lower.x, y, v.lower.z)),
                    coefficient_at(vec3(v.upper.x, y, v.lower.z)), v.share.x);
    float high = mix(coefficient_at(vec3(v.lower.x, y, v.upper.z)),
                     coefficient_at(vec3(v.upper.x, y, v.upper.z)), v.share.x);
    return mix(low, high, v.share.z);
}
float mean_xy(float z, Taps v)
{
    float low = mix(coefficient_at(vec3(v.lower.x, v.lower.y, z)),
                    coefficient_at(vec3(v.upper.x, v.lower.y, z)), v.share.x);
    float high = mix(coefficient_at(vec3(v.lower.x, v.upper.y, z)),
                     coefficient_at(vec3(v.upper.x, v.upper.y, z)), v.share.x);
    return mix(low, high, v.share.y);
}

float value_at(vec3 p)
{
    if (order() == 2) return sample_at(p);
    Taps v = value_taps(p);
    return mix(mean_yz(v.lower.x, v), mean_yz(v.upper.x, v), v.share.x);
}

// Per voxel.
vec3 slope_at(vec3 p)
{
    if (order() == 2) {
        vec3 x = vec3(1.0f, 0.0f, 0.0f), y = vec3(0.0f, 1.0f, 0.0f), z = vec3(0.0f, 0.0f, 1.0f);
        vec3 above = vec3(sample_at(p + x), sample_at(p + y), sample_at(p + z));
        if (rough()) return above - sample_at(p);
        return 0.5f * (above - vec3(sample_at(p - x), sample_at(p - y), sample_at(p - z)));
    }
    Taps v = value_taps(p), d = slope_taps(p);
    return d.share * vec3(mean_yz(d.upper.x, v) - mean_yz(d.lower.x, v),
                          mean_xz(d.upper.y, v) - mean_xz(d.lower.y, v),
                          mean_xy(d.upper.z, v) - mean_xy(d.lower.z, v));
}
