// SPDX-License-Identifier: GPL-3.0-or-later
// The crocodile of assets/scenes/rider.trivar is on the horse in the file of its film, too.
#include "core/base/text.h"
#include "core/certificate/film_check.h"
#include "core/commands/command.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/play.h"
#include "core/evaluation/evaluate.h"
#include "core/export/animated_model.h"
#include "core/files/formats.h"
#include "core/scene/log.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/lying.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>

namespace trivar {
namespace {

constexpr Id ridden_horse = 2, riding_crocodile = 3;
constexpr FrameRange exported_frames{20, 24};
constexpr double film_tolerance = 5e-3; // metres

struct RiderFilm {
    Document scene;
    std::shared_ptr<const AssetStore> assets;
    AnimatedExport made;
};

const RiderFilm& rider_film()
{
    static const RiderFilm film = [] {
        const std::string folder = TRIVAR_SOURCE_DIR "/assets/scenes",
                          path = folder + "/rider.trivar";
        std::map<std::string, std::string> models;
        for (const auto& entry :
             std::filesystem::directory_iterator(TRIVAR_BINARY_DIR "/assets/models"))
            models[entry.path().filename()] = entry.path();
        RiderFilm out{replay(read_log(read_text_file(path), path)).document(),
                      std::make_shared<const AssetStore>(folder, models),
                      {}};
        out.made =
            animated_export({out.scene, exported_frames, film_tolerance, "rider"}, out.assets);
        return out;
    }();
    return film;
}

// An object carried by a walking one has no bound between the moments, and the export says so.
TEST(RiderFilm, ShowsTheSceneInEveryFrame)
{
    const auto& [scene, assets, made] = rider_film();
    const std::vector<FilmSample> found = sampled_film(made, scene, assets, 1);
    std::map<Id, int> parts;
    for (std::size_t p = 0; p < found.size(); ++p) {
        const FilmCertificate::PartClaim& claim = made.certificate.parts[p];
        EXPECT_LE(found[p].furthest, film_tolerance) << claim.name << " at " << found[p].at_frame;
        ++parts[claim.object];
        if (claim.object != riding_crocodile) continue;
        EXPECT_EQ(claim.way, "targets") << claim.name;
        EXPECT_FALSE(is_proven(claim)) << claim.name;
        EXPECT_GE(found[p].samples, 4u) << claim.name;
    }
    EXPECT_GT(parts[ridden_horse], 0);
    EXPECT_GT(parts[riding_crocodile], 0);
}

// Returns the part of the file that belongs to one object of the scene.
EvaluatedObject only_of(const EvaluatedObject& read, const AnimatedExport& made, Id object)
{
    EvaluatedObject out = read;
    std::erase_if(out.parts, [&](const Part& part) {
        const auto hung =
            std::ranges::find(read.shape->meshes, part.key.mesh, &Shape::NodeMesh::slot);
        return std::ranges::none_of(made.certificate.parts, [&](const auto& claim) {
            return claim.object == object && claim.node == hung->node;
        });
    });
    return out;
}

// Read as any other program reads it: what touches the back in the first frame touches it in all.
TEST(RiderFilm, HasTheCrocodileOnTheBackOfTheHorse)
{
    const AnimatedExport& made = rider_film().made;
    const testing::TemporaryFolder folder;
    std::ofstream(folder.file("rider.glb"), std::ios::binary) << write_glb(made.model);
    ImportModel import;
    import.file.path = folder.file("rider.glb");
    Document document = after(Document{}, import);
    document = after(document, PlayClip{{1}, {.clip = made.model.clips.at(0).name}});
    Evaluator evaluate(std::make_shared<const AssetStore>("/"));
    constexpr double touches = 0.01, stays = 0.02; // metres
    std::vector<std::size_t> feet;                 // vertices of the crocodile on the back
    glm::dvec3 first(0);
    for (int frame = 1; frame <= 1 + exported_frames.last - exported_frames.first; ++frame) {
        const EvaluatedObject read = *evaluate(document, frame).objects.at(1);
        const EvaluatedObject horse = only_of(read, made, ridden_horse);
        const std::vector<glm::dvec3> crocodile =
            testing::world_points(only_of(read, made, riding_crocodile));
        ASSERT_FALSE(crocodile.empty());
        const testing::NearestOn back(horse);
        if (frame == 1) {
            for (std::size_t v = 0; v < crocodile.size(); v += 7)
                if (back(crocodile[v]).off < touches) feet.push_back(v);
            ASSERT_GT(feet.size(), 50u);
            first = crocodile[feet.front()];
        }
        for (const std::size_t v : feet) ASSERT_LT(back(crocodile[v]).off, stays) << frame;
        if (frame > 1) {
            EXPECT_GT(glm::distance(crocodile[feet.front()], first), 0.01 * (frame - 1));
        }
    }
}

} // namespace
} // namespace trivar
