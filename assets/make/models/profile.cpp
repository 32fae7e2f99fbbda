// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

namespace make {

// A column whose section is a head seen from the side: it looks along +x, its crown toward -z.
Model profile()
{
    // The outline from the nape over the crown and down the face; x forward, y up.
    const std::vector<vec2> face = {
        {-.165f, .000f}, {-.165f, .090f}, {-.180f, .160f}, {-.235f, .235f}, {-.285f, .330f},
        {-.310f, .450f}, {-.300f, .580f}, {-.250f, .690f}, {-.165f, .765f}, {-.055f, .795f},
        {.060f, .780f},  {.150f, .730f},  {.205f, .655f},  {.226f, .575f},  {.224f, .520f},
        {.214f, .480f},  {.236f, .436f},  {.272f, .385f},  {.302f, .345f},  {.288f, .314f},
        {.240f, .300f},  {.262f, .262f},  {.258f, .234f},  {.232f, .221f},  {.254f, .204f},
        {.250f, .176f},  {.222f, .158f},  {.230f, .124f},  {.214f, .078f},  {.160f, .062f},
        {.096f, .066f},  {.078f, .040f},  {.070f, .000f}};
    Model m;
    const int brass = m.material("brass", srgb(0xb98a3c), .28f, .9f);
    Mesh column = prism_mesh(smooth_loop(face, 4, false), .5f, .006f, 12);
    column.turn(-90, {1, 0, 0}).move({0, .5f, .4f});
    m.root().parts.push_back(column.mat(brass));
    return m;
}

} // namespace make
