// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/models/face.h"

#include <algorithm>
#include <cmath>

namespace make {

Model head()
{
    Model m;
    int skin = m.material("skin", vec3(1), .55f),
        white = m.material("eye_white", srgb(0xf3efe8), .15f),
        iris = m.material("iris", srgb(0x4c7a8c), .1f),
        pupil = m.material("pupil", srgb(0x0c0d10), .05f);
    Mesh b = surface([](vec3 p) { return face(p, true); }, {-.42f, -.02f, -.42f},
                     {.42f, 1.08f, .42f}, {.0135f, true, 10});
    wrap_about_y(b, {-.02f, 0});
    auto& P = m.root().parts;
    P.push_back(b.mat(skin));
    vec3 E(.232f, .612f, .108f);
    both(P, ball_mesh(.0500f, 10).move(E).mat(white));
    Mesh ir = ball_mesh(.0235f, 7).scale({.35f, 1, 1}).move({.0445f, 0, 0}),
         pu = ball_mesh(.0105f, 5).scale({.3f, 1, 1}).move({.0516f, 0, 0});
    both(P, ir.turn(-4, {0, 1, 0}).move(E).mat(iris));
    both(P, pu.turn(-4, {0, 1, 0}).move(E).mat(pupil));
    return m;
}

} // namespace make
