// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/cages.h"
#include "assets/make/models/models.h"
#include "assets/make/models/pictures.h"
#include "assets/make/volumes/volumes.h"
#include "core/base/text.h"
#include "core/document/document_digest.h"
#include "core/document/named_files.h"
#include "core/scene/log.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace {

class EveryScene : public testing::TestWithParam<std::string> {
protected:
    trivar::Log log() const
    {
        const std::string path = TRIVAR_SOURCE_DIR "/assets/scenes/" + GetParam() + ".trivar";
        return trivar::read_log(trivar::read_text_file(path), path);
    }
    trivar::History history() const
    {
        const trivar::Log log = this->log();
        trivar::History result;
        for (const trivar::LogLine& line : log.lines) trivar::apply(result, line, log.name);
        return result;
    }
};

TEST_P(EveryScene, UsesOnlyModelsThatAFreshBuildMakes)
{
    const trivar::History replayed = history();
    const std::vector<make::NamedPicture> made = make::pictures();
    for (const auto& [id, object] : replayed.document().objects) {
        for (const trivar::FileUse& each : trivar::files_named(*object))
            if (each.kind == trivar::FileKind::image) {
                const std::filesystem::path path(each.path);
                EXPECT_EQ(path.parent_path(), "../../build/assets/models/pictures");
                EXPECT_TRUE(std::ranges::any_of(made, [&](const make::NamedPicture& picture) {
                    return picture.name == path.stem();
                })) << path;
            }
        if (const auto* data = std::get_if<trivar::VoxelShape>(&object->source)) {
            const std::filesystem::path path(data->path);
            EXPECT_EQ(path.parent_path(), "../../build/assets/models/volumes");
            EXPECT_TRUE(std::ranges::any_of(make::volumes(), [&](const make::NamedVolume& volume) {
                return volume.name == path.stem();
            })) << path;
        }
        const auto* file = std::get_if<trivar::ImportedFile>(&object->source);
        if (!file) continue;
        const std::filesystem::path path(file->path);
        if (path.extension() == ".obj") {
            EXPECT_EQ(path.parent_path(), "../../build/assets/models/cages");
            EXPECT_TRUE(std::ranges::any_of(make::cages(), [&](const make::Cage& cage) {
                return cage.name == path.stem();
            })) << path;
            continue;
        }
        EXPECT_EQ(path.parent_path(), "../../build/assets/models");
        EXPECT_TRUE(std::ranges::any_of(make::catalogue(), [&](const make::Entry& entry) {
            return entry.name == path.stem();
        })) << path;
    }
}

TEST_P(EveryScene, ChangesSomethingAndSaysWhereItsPictureIsTakenFrom)
{
    const trivar::Document document = history().document();
    EXPECT_TRUE(document.kept_views.contains("picture"));
    EXPECT_TRUE(std::ranges::any_of(document.objects, [](const auto& entry) {
        return entry.second->stroke || entry.second->tiles || entry.second->splitting ||
               entry.second->cutting || entry.second->incising ||
               std::holds_alternative<trivar::LatticeShape>(entry.second->source) ||
               std::holds_alternative<trivar::TetrahedraShape>(entry.second->source) ||
               std::holds_alternative<trivar::SimplexSheetShape>(entry.second->source) ||
               std::holds_alternative<trivar::VoxelShape>(entry.second->source);
    }));
}

// A field that commands get later must leave the digests of logs without it as they were.
TEST_P(EveryScene, HasTheDigestThatItsFileSays)
{
    const trivar::Log log = this->log();
    trivar::History replayed;
    bool said = false;
    for (const trivar::LogLine& line : log.lines) {
        trivar::apply(replayed, line, log.name);
        if (line.digest.empty()) continue;
        EXPECT_EQ(digest(replayed.document()), line.digest) << "line " << line.number;
        said = true;
    }
    EXPECT_TRUE(said);
}

INSTANTIATE_TEST_SUITE_P(
    Of, EveryScene,
    testing::Values(
        "first_placement", "lattice_bend", "goblet_twist", "dragon_ring", "snake_bridge",
        "crocodile_on_horse", "stacked", "f1_f2", "ants", "ants_moebius", "whales", "car",
        "variable_width", "cube_refined", "edges", "crocodile_pressed", "pressing_tools",
        "fold_and_repair", "ants_terrain", "cars_over_obstacle", "text_teapot", "bulldozer_parks",
        "reptiles", "rider", "wreath", "tea_cosy", "feathered_serpent", "tower", "mail_and_bricks",
        "thorn_to_flower", "robots_teapot", "face_thorns", "ruin", "camel_chains", "horse_hair",
        "face_hexagons", "brick_wall", "teapot_statues", "robot_bars", "robot_bars_tilted",
        "bulldozer_tree", "sphere_cylinder", "sphere_cylinder_stitched", "sphere_cylinder_ends",
        "part_profile", "bunny_cylinder", "sliced", "pineapple", "crossing_cuts", "face_incisions",
        "forearm_layers", "pumpkin_carved", "jaw_silhouette", "jaw_overlay", "neck_levels",
        "foot_skin_bone", "iron_protein_levels", "iron_protein_volume", "iron_protein_widths",
        "crystal_chromadepth", "foot_chromadepth", "knee_gradient", "density_fans",
        "anatomical_plate", "dms_surface", "goblet_dms", "dms_refined", "dms_cut", "dms_density"),
    [](const auto& scene) { return scene.param; });

TEST(Stacked, PlacesSnakesOnWhatWasPlacedBefore)
{
    const std::string path = TRIVAR_SOURCE_DIR "/assets/scenes/stacked.trivar";
    const trivar::Log log = trivar::read_log(trivar::read_text_file(path), path);
    trivar::History history;
    for (const trivar::LogLine& line : log.lines) trivar::apply(history, line, log.name);
    const auto& objects = history.document().objects;
    EXPECT_TRUE(std::ranges::any_of(objects, [&](const auto& entry) {
        const auto& placed = entry.second->stroke;
        return placed && std::ranges::any_of(placed->onto, [&](trivar::Id below) {
                   return objects.at(below)->stroke.has_value();
               });
    }));
}

} // namespace
