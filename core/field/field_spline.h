// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace trivar {

// The way from samples to the coefficients of a spline. An interpolating spline goes through them;
// a smoothing one takes them as coefficients, as the thesis does (chapter 7).
enum class FieldSpline : std::uint8_t { interpolating, smoothing };

// The pieces of a spline along every axis: linear is of order 2, quadratic of 3, cubic of 4.
enum class FieldOrder : std::uint8_t { linear, quadratic, cubic };

} // namespace trivar
