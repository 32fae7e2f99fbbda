// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"
#include "assets/make/write_model.h"

#include <cmath>

namespace make {

// coarse quad cages for subdivision, as OBJ
void write_cages(const std::string& dir)
{
    Mesh jar_cage = lathe({{.08f, 0},
                           {.17f, 0},
                           {.24f, .16f},
                           {.36f, .50f},
                           {.25f, .78f},
                           {.14f, .88f},
                           {.16f, .97f},
                           {.22f, 1.0f},
                           {.19f, 1.01f},
                           {.12f, .95f},
                           {.11f, .88f},
                           {.22f, .76f},
                           {.32f, .50f},
                           {.21f, .18f},
                           {.08f, .05f}},
                          10, true);
    jar_cage.uvs.clear();
    write_obj(jar_cage, dir + "/jar_ring_cage.obj");
    write_obj(bevel_box({.5f, .5f, .5f}, .08f, 1, {1, 1, 1}), dir + "/rounded_cube_cage.obj");
    write_obj(ball_mesh(.5f, 2), dir + "/ball_cage.obj");
    Mesh ring;
    {
        std::vector<vec4> q;
        for (int i = 0; i < 10; i++) {
            float a = 2 * pi * i / 10;
            q.push_back({.36f * std::cos(a), .14f, .36f * std::sin(a), .14f});
        }
        ring = tube(q, 6, true);
        ring.uvs.clear();
    }
    write_obj(ring, dir + "/torus_cage.obj");
}

} // namespace make
