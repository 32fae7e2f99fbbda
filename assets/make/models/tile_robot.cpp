// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/kit.h"

#include <algorithm>
#include <cmath>

namespace make {

// A small brother of the robot, of few vertices, in the middle of a step along +x.
Model tile_robot()
{
    Model m;
    const int white = m.material("shell", srgb(0xe9e6dd), .35f),
              orange = m.material("accent", srgb(0xe5762a), .4f),
              dark = m.material("joint", srgb(0x33383f), .5f),
              glass = m.material("visor", srgb(0x161c26), .08f),
              glow = m.material("glow", srgb(0x66e6ff), .2f);
    std::vector<Mesh>& parts = m.root().parts;
    const auto add = [&](Mesh mesh, int material) { parts.push_back(mesh.mat(material)); };
    const auto rod = [](vec3 from, vec3 to, float r) {
        return tube({{from, r}, {glm::mix(from, to, .5f), r}, {to, r}}, 8, false, 1);
    };
    // about the middle of the cell, standing on z = 0
    add(bevel_box({.135f, .185f, .145f}, .07f, 2, {2, 3, 2}).move({.0f, 0, .475f}), white);
    add(bevel_box({.045f, .12f, .09f}, .03f, 1, {1, 2, 2}).move({-.155f, 0, .49f}), orange);
    add(cylinder(.055f, .05f, .035f, .01f, 12).turn(90, {0, 1, 0}).move({.122f, 0, .505f}), glow);
    add(cylinder(.07f, .075f, .08f, .012f, 12).turn(90, {1, 0, 0}).move({0, 0, .60f}), dark);
    add(bevel_box({.135f, .165f, .125f}, .085f, 2, {2, 2, 2}).move({.015f, 0, .765f}), white);
    add(bevel_box({.03f, .125f, .07f}, .055f, 2, {1, 2, 1}).move({.135f, 0, .77f}), glass);
    add(rod({.0f, 0, .88f}, {-.03f, 0, .955f}, .009f), dark);
    add(ball_mesh(.026f, 3).move({-.032f, 0, .972f}), glow);
    for (const float s : {1.f, -1.f}) {
        add(ball_mesh(.022f, 3).scale({.5f, .8f, 1.35f}).move({.160f, s * .055f, .775f}), glow);
        add(cylinder(.055f, .045f, .035f, .01f, 12)
                .turn(s * -90, {1, 0, 0})
                .move({.01f, s * .155f, .77f}),
            orange);
        // an arm swings against its leg
        const vec3 shoulder(-.005f, s * .225f, .555f), elbow(-.03f - s * .075f, s * .262f, .435f),
            hand(.05f - s * .115f, s * .255f, .345f);
        add(ball_mesh(.062f, 4).move(shoulder), orange);
        add(rod(shoulder, elbow, .031f), dark);
        add(tube({{elbow, .052f}, {glm::mix(elbow, hand, .5f), .056f}, {hand, .060f}}, 10, false,
                 2),
            white);
        add(ball_mesh(.042f, 3).move(hand + .55f * (hand - elbow)), dark);
        const vec3 hip(0, s * .09f, .34f), knee(.055f + s * .075f, s * .098f, .205f),
            ankle(s * .125f - (s < 0 ? .045f : .0f), s * .10f, s > 0 ? .085f : .115f);
        add(rod(hip, knee, .040f), dark);
        add(tube({{knee, .058f}, {glm::mix(knee, ankle, .5f), .064f}, {ankle, .070f}}, 10, false,
                 2),
            white);
        Mesh foot = bevel_box({.105f, .075f, .042f}, .035f, 2, {2, 1, 1});
        Mesh sole = bevel_box({.112f, .080f, .016f}, .012f, 1, {2, 2, 1}).move({0, 0, -.036f});
        const vec3 at =
            s > 0 ? vec3(ankle.x + .03f, ankle.y, .052f) : vec3(ankle.x + .02f, ankle.y, .088f);
        const float pitch = s > 0 ? 0.f : 24.f; // the rear heel is up
        add(foot.turn(pitch, {0, 1, 0}).move(at), white);
        add(sole.turn(pitch, {0, 1, 0}).move(at), orange);
    }
    for (Mesh& part : parts) part.move({.5f, .5f, 0});
    return m;
}

} // namespace make
