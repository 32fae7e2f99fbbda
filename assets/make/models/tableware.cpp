// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/kit.h"
#include "assets/make/models/models.h"
#include "assets/make/texture.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

// A profile whose steps are at most that long, so that bends stay smooth.
std::vector<vec2> in_steps(const std::vector<vec2>& profile, float longest)
{
    std::vector<vec2> out{profile.front()};
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const int n = std::max(
            1, static_cast<int>(std::ceil(glm::distance(profile[i], profile[i - 1]) / longest)));
        for (int k = 1; k <= n; ++k)
            out.push_back(glm::mix(profile[i - 1], profile[i], static_cast<float>(k) / n));
    }
    return out;
}

std::vector<vec2> joined(std::vector<vec2> a, const std::vector<vec2>& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// A paper label with a vineyard's hills between two lines.
vec3 label(vec3 p)
{
    const vec3 cream = srgb(0xefe4c8), red = srgb(0x8c1f28), gold = srgb(0xb58a3a);
    vec3 c = cream * (1 + .03f * noise(p * 60.f));
    const float angle = std::atan2(p.x, p.z), y = p.y - .30f;
    const auto line = [&](float at, float half, vec3 color) {
        c = glm::mix(c, color, smooth_step(half + .002f, half, std::abs(y - at)));
    };
    for (const float side : {-1.f, 1.f}) {
        line(side * .112f, .004f, gold);
        line(side * .102f, .0016f, gold);
    }
    for (int hill = 0; hill < 3; ++hill) {
        const float top =
            .012f - .026f * hill + .020f * std::sin(angle * (2.f + hill) + 1.7f * hill);
        const float inside =
            smooth_step(top + .002f, top - .002f, y) * smooth_step(-.078f, -.074f, y);
        c = glm::mix(c, glm::mix(red, gold, .25f * hill), inside);
    }
    const float sun = glm::length(vec2((angle - .5f) * .13f, y - .062f));
    return glm::mix(c, red, smooth_step(.021f, .019f, sun));
}

} // namespace

Model bottle()
{
    Model m;
    const int glass = m.material("green glass", srgb(0x16301f), .08f),
              paper = m.material("label", vec3(1), .75f),
              foil = m.material("foil", srgb(0x7a1420), .3f, .5f);
    const std::vector<vec2> out = smooth_loop({{.098f, .004f},
                                               {.128f, .022f},
                                               {.134f, .06f},
                                               {.135f, .20f},
                                               {.135f, .40f},
                                               {.135f, .56f},
                                               {.128f, .62f},
                                               {.096f, .68f},
                                               {.058f, .73f},
                                               {.048f, .79f},
                                               {.046f, .90f},
                                               {.046f, .955f}},
                                              6, false);
    auto& parts = m.root().parts;
    parts.push_back(lathe(in_steps(joined({{0, .03f}, {.05f, .022f}, {.085f, .006f}},
                                          joined(out, {{.046f, .97f}, {.0f, .97f}})),
                                   .02f),
                          72)
                        .mat(glass));
    Mesh sheet = lathe(in_steps({{.1362f, .178f},
                                 {.1372f, .18f},
                                 {.1372f, .42f},
                                 {.1362f, .422f},
                                 {.1352f, .42f},
                                 {.1352f, .18f}},
                                .02f),
                       72, true);
    m.materials[static_cast<std::size_t>(paper)].texture = bake(sheet, {1024, 512}, label);
    parts.push_back(sheet.mat(paper));
    parts.push_back(lathe(in_steps({{0, 1.0f},
                                    {.040f, 1.0f},
                                    {.047f, .994f},
                                    {.0485f, .984f},
                                    {.0485f, .962f},
                                    {.0475f, .954f},
                                    {.0495f, .945f},
                                    {.0495f, .82f},
                                    {.0475f, .818f},
                                    {.0465f, .82f},
                                    {.0462f, .96f},
                                    {0, .972f}},
                                   .02f),
                          72)
                        .mat(foil));
    orient_outward(parts.back());
    return m;
}

Model wine_glass()
{
    Model m;
    const int glass = m.material("clear glass", srgb(0xe6eef0), .04f),
              wine = m.material("wine", srgb(0x7a1024), .08f);
    m.materials[static_cast<std::size_t>(glass)].alpha = .14f;
    const std::vector<vec2> outside = smooth_loop({{.010f, .30f},
                                                   {.030f, .318f},
                                                   {.085f, .36f},
                                                   {.122f, .43f},
                                                   {.128f, .50f},
                                                   {.116f, .59f},
                                                   {.100f, .66f}},
                                                  6, false),
                            inside = smooth_loop({{.096f, .66f},
                                                  {.112f, .59f},
                                                  {.124f, .50f},
                                                  {.118f, .432f},
                                                  {.082f, .366f},
                                                  {.030f, .330f}},
                                                 6, false);
    std::vector<vec2> profile{{0, 0},        {.10f, .0f},   {.108f, .003f}, {.108f, .007f},
                              {.06f, .014f}, {.018f, .03f}, {.0085f, .06f}, {.0075f, .18f}};
    profile = joined(joined(profile, outside), {{.098f, .664f}});
    profile = joined(joined(profile, inside), {{0, .326f}});
    auto& parts = m.root().parts;
    parts.push_back(lathe(in_steps(profile, .016f), 64).mat(glass));
    const std::vector<vec2> side =
        smooth_loop({{.028f, .332f}, {.080f, .3675f}, {.1165f, .433f}, {.1205f, .470f}}, 6, false);
    parts.push_back(
        lathe(in_steps(joined(joined({{0, .328f}}, side), {{.1205f, .474f}, {0, .474f}}), .016f),
              64)
            .mat(wine));
    return m;
}

Model goblet()
{
    Model m;
    const int gold = m.material("gold", srgb(0xc9a04a), .22f, .95f),
              enamel = m.material("enamel", srgb(0x1d3f7a), .25f);
    const std::vector<vec2> outside = smooth_loop({{.052f, .44f},
                                                   {.11f, .452f},
                                                   {.185f, .51f},
                                                   {.222f, .61f},
                                                   {.228f, .74f},
                                                   {.232f, .88f},
                                                   {.246f, .985f}},
                                                  8, false),
                            inside = smooth_loop({{.234f, .992f},
                                                  {.220f, .88f},
                                                  {.216f, .74f},
                                                  {.209f, .615f},
                                                  {.172f, .522f},
                                                  {.10f, .468f}},
                                                 8, false);
    std::vector<vec2> profile{{0, 0},         {.20f, 0},      {.212f, .006f}, {.214f, .018f},
                              {.17f, .040f},  {.09f, .075f},  {.052f, .12f},  {.043f, .17f},
                              {.050f, .205f}, {.082f, .235f}, {.090f, .262f}, {.082f, .29f},
                              {.050f, .32f},  {.042f, .36f},  {.044f, .41f}};
    profile = joined(joined(profile, outside), {{.241f, 1.0f}});
    profile = joined(joined(profile, inside), {{0, .462f}});
    Mesh body = lathe(in_steps(profile, .011f), 192);
    // Sixteen flutes on the bowl, and as many on the foot.
    body.warp([](vec3 p) {
        const float r = glm::length(vec2(p.x, p.z));
        const bool bowl = p.y > .46f && p.y < .80f && r > .10f;
        if (!bowl && p.y > .12f) return p;
        const float depth =
            bowl ? .014f * smooth_step(.46f, .55f, p.y) * smooth_step(.80f, .74f, p.y)
                 : .010f * smooth_step(.002f, .03f, p.y) * smooth_step(.12f, .06f, p.y);
        const float wave = std::abs(std::sin(8 * std::atan2(p.z, p.x)));
        const float scale = 1 + depth * (wave - .5f) / std::max(r, .05f);
        return vec3(p.x * scale, p.y, p.z * scale);
    });
    auto& parts = m.root().parts;
    parts.push_back(body.mat(gold));
    for (const float height : {.845f, .955f})
        parts.push_back(lathe({{.2290f + .06f * (height - .845f), height - .011f},
                               {.2375f + .06f * (height - .845f), height - .007f},
                               {.2395f + .06f * (height - .845f), height},
                               {.2375f + .06f * (height - .845f), height + .007f},
                               {.2290f + .06f * (height - .845f), height + .011f}},
                              192, true)
                            .mat(enamel));
    for (int k = 0; k < 16; ++k) {
        Mesh stone = ball_mesh(.019f, 8);
        stone.scale({1, 1.25f, .7f}).move({0, .90f, .238f}).turn(22.5f * k, {0, 1, 0});
        parts.push_back(stone.mat(enamel));
    }
    return m;
}

} // namespace make
