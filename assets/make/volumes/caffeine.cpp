// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/volumes/density.h"

namespace make {
namespace {

struct Atom {
    int electrons;
    vec3 at;
};

// A flat pair of rings with two oxygen caffeine_atoms and three methyl groups; Angstrom.
constexpr Atom caffeine_atoms[]{
    {8, {.47f, 2.569f, 0}},          {8, {-3.127f, -.444f, 0}},     {7, {-.969f, -1.313f, 0}},
    {7, {2.218f, .141f, 0}},         {7, {-1.348f, 1.08f, 0}},      {7, {1.412f, -1.937f, 0}},
    {6, {.858f, .259f, 0}},          {6, {.39f, -1.026f, 0}},       {6, {.031f, 1.422f, 0}},
    {6, {-1.906f, -.25f, 0}},        {6, {2.503f, -1.2f, 0}},       {6, {-1.428f, -2.696f, 0}},
    {6, {3.193f, 1.206f, 0}},        {6, {-2.297f, 2.188f, 0}},     {1, {3.516f, -1.579f, 0}},
    {1, {-1.045f, -3.197f, -.895f}}, {1, {-2.519f, -2.76f, 0}},     {1, {-1.045f, -3.196f, .895f}},
    {1, {4.199f, .78f, 0}},          {1, {3.047f, 1.809f, -.9f}},   {1, {3.047f, 1.808f, .9f}},
    {1, {-1.809f, 3.165f, 0}},       {1, {-2.932f, 2.103f, .888f}}, {1, {-2.935f, 2.102f, -.885f}}};

} // namespace

Volume caffeine()
{
    Density out({100, 92, 64}, {-5.4f, -5.5f, -3.8f}, .12f);
    for (const Atom& a : caffeine_atoms) {
        out.add(a.at, a.electrons == 1 ? .8f : float(a.electrons) - 2,
                a.electrons == 1 ? .42f : .52f);
        if (a.electrons > 1)
            out.add(a.at, 1.2f, .24f); // what is left of the core at this resolution
        for (const Atom& b : caffeine_atoms) {
            const float length = glm::distance(a.at, b.at);
            const bool bound =
                length > .1f && length < (a.electrons == 1 || b.electrons == 1 ? 1.25f : 1.65f);
            if (&a < &b && bound && a.electrons + b.electrons > 2)
                out.add_bond(a.at, b.at, 1, .5f, .36f);
        }
    }
    return out.scaled(1000);
}

} // namespace make
