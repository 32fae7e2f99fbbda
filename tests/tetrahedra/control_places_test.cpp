// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/control_places.h"
#include "core/tetrahedra/tetrahedra_shaper.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace trivar {
namespace {

const TetrahedraShape two_by_two{.size = glm::dvec3(2), .boxes = glm::ivec3(2)};

// The same with the plane x = 0 cut.
TetrahedraShape cut_box()
{
    TetrahedraShape out = two_by_two;
    TetrahedraCrease cut{.radius = 0.01, .depth = 2};
    for (const glm::dvec3& at : {glm::dvec3(0, 1. / 3, 2. / 3), {0, 2. / 3, 1. / 3}})
        for (int side = 0; side < 4; ++side)
            cut.places.push_back(at - glm::dvec3(0, side % 2, side / 2));
    out.edits.push_back({.crease = cut});
    return out;
}

Ref<SimplexVolume> shaped(const TetrahedraShape& shape)
{
    return TetrahedraShaper()(shape).volume;
}

// The control points that a pull moves.
std::vector<int> moved_by(TetrahedraPull pull, const SimplexVolume& volume)
{
    pull.by = {0, 0, 1};
    const std::vector<glm::dvec3> change = change_by(pull, volume);
    std::vector<int> out;
    for (std::size_t i = 0; i < change.size(); ++i)
        if (change[i] != glm::dvec3(0)) out.push_back(static_cast<int>(i));
    return out;
}

TEST(ControlPlaces, AreOnePerVertexAndPerPointOfAnEdge)
{
    for (const auto& [degree, count] : {std::pair(1, 27), {2, 27 + 98}, {3, 27 + 2 * 98 + 120}}) {
        TetrahedraShape shape = two_by_two;
        shape.degree = degree;
        const Ref<SimplexVolume> volume = shaped(shape);
        const std::vector<ControlPlace> places = control_places(*volume->layers[0]);
        EXPECT_EQ(places.size(), static_cast<std::size_t>(count)) << degree;
        std::set<int> points;
        for (const ControlPlace& place : places)
            points.insert(place.points.begin(), place.points.end());
        EXPECT_EQ(points.size(), volume->layers[0]->point_count()); // each once
    }
}

TEST(ControlPlaces, AreMovedEachAloneByTheirPull)
{
    for (const TetrahedraShape& shape : {two_by_two, cut_box()}) {
        const Ref<SimplexVolume> volume = shaped(shape);
        const std::vector<ControlPlace> places = control_places(*volume->layers[0]);
        for (std::size_t i = 0; i < places.size(); ++i)
            EXPECT_EQ(moved_by(pull_of(places, {static_cast<int>(i)}), *volume), places[i].points)
                << i;
    }
}

TEST(ControlPlaces, AreMovedTogetherByOnePull)
{
    const Ref<SimplexVolume> volume = shaped(two_by_two);
    const std::vector<ControlPlace> places = control_places(*volume->layers[0]);
    std::vector<int> expected = places[3].points;
    expected.insert(expected.end(), places[50].points.begin(), places[50].points.end());
    std::ranges::sort(expected);
    EXPECT_EQ(moved_by(pull_of(places, {50, 3}), *volume), expected);
}

TEST(ControlPlaces, ArePartedWhereFacesAreCut)
{
    const Ref<SimplexVolume> volume = shaped(cut_box());
    const std::vector<ControlPlace> places = control_places(*volume->layers[0]);
    int parted = 0;
    for (const ControlPlace& place : places)
        if (place.inward != glm::dvec3(0)) {
            ++parted;
            EXPECT_LE(std::abs(place.rest.x), 1e-9);
            EXPECT_GE(std::abs(place.inward.x), 0.01); // to its own side
        }
    EXPECT_EQ(parted, 2 * (9 + 16)); // of the vertices and edges in the plane, two each
}

TEST(ControlPlaces, TurnAndScaleAboutTheMiddleOfWhereTheyAre)
{
    TetrahedraShape shape = two_by_two;
    const std::vector<ControlPlace> places = control_places(*shaped(shape)->layers[0]);
    TetrahedraPull away = pull_of(places, {0, 9}), turn = pull_of(places, {0, 9});
    away.by = {0.3, 0.1, 0};
    turn.rotation_deg = {0, 0, 180};
    turn.factors = {0.5, 0.5, 1};
    turn.guard = away.guard = false;
    shape.edits = {{.pull = away}, {.pull = turn}};
    const Ref<SimplexVolume> volume = shaped(shape);
    const glm::dvec3 a = places[0].rest + away.by, b = places[9].rest + away.by,
                     center = (a + b) / 2.0;
    for (const auto& [place, from] : {std::pair(0, a), {9, b}}) {
        const glm::dvec3 expected = center + (from - center) * glm::dvec3(-0.5, -0.5, 1);
        for (const int p : places[static_cast<std::size_t>(place)].points)
            EXPECT_LE(glm::distance(place_of(*volume, 0, static_cast<std::size_t>(p)), expected),
                      1e-9);
    }
}

} // namespace
} // namespace trivar
