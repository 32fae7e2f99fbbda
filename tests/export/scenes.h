// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film_check.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/play.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/export/animated_model.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"
#include "tests/support/scenes/commands.h"

namespace trivar::testing {

// A box 1, a sphere 2, a teapot 3 on both, a group 4 with the box, and a bar 5 with a skin, morph
// targets and the clips "bend" and "swell", in half a second at twelve frames a second.
class ExportedScenes : public ::testing::Test {
protected:
    ExportedScenes()
    {
        write_file(folder_.file("bar.gltf"), gltf_text(rigged_model()));
        ImportModel import;
        import.file.path = "bar.gltf";
        import.file.up = UpAxis::z;
        import.file.scale = 0.2;
        import.name = "Bar";
        import.transform.translation = {0, 0, 2};
        still_ = after(small_document(), import);
        still_.time = {.first_frame = 1, .last_frame = 7, .frames_per_second = 12};
        assets_ = std::make_shared<const AssetStore>(folder_.path().string());
    }
    // The bar on the table.
    Document laid() const
    {
        PlacementParameters p;
        p.fill = 0.4;
        return after(still_, Place{5, small_sketch(), p, {1}});
    }
    // The bar round a Moebius band 6, with two behind it.
    Document round() const
    {
        AddMoebius band;
        band.shape = {.radius = 1, .width = 0.5};
        PlaceRound place;
        place.object = 5;
        place.around = 6;
        place.parameters.fill = 0.1;
        place.parameters.width = 0.3;
        place.parameters.height = 0.2;
        return after(after(still_, band), place);
    }
    Document travelling(const Document& document, const Travel& travel) const
    {
        return after(document, SetTravel{{5}, travel});
    }
    Document playing(const Document& document, const Playing& playing) const
    {
        return after(document, PlayClip{{5}, playing});
    }
    static Document keyed(const Document& document, Id id, const std::string& parameter,
                          std::vector<Key> keys)
    {
        Animate command;
        command.of.push_back({id, {{.parameter = parameter, .keys = std::move(keys)}}});
        return after(document, command);
    }
    AnimatedExport exported(const Document& document, double tolerance = 2e-3) const
    {
        return animated_export({document, {1, document.time.last_frame}, tolerance, "a.trivar"},
                               assets_);
    }
    // Proven parts keep to their own bound at ten times the frame rate, all others to the
    // tolerance.
    void expect_holds(const Document& document, const AnimatedExport& made,
                      int per_frame = 10) const
    {
        const std::vector<FilmSample> found = sampled_film(made, document, assets_, per_frame);
        for (std::size_t p = 0; p < found.size(); ++p) {
            const FilmCertificate::PartClaim& claim = made.certificate.parts[p];
            EXPECT_GT(found[p].samples, 0u);
            constexpr double rounding = 1e-6; // of single precision
            EXPECT_LE(found[p].furthest,
                      is_proven(claim) ? claim.bound + rounding : made.certificate.tolerance)
                << claim.name << " " << claim.way << " at frame " << found[p].at_frame << " "
                << claim.unproven;
        }
    }
    static std::vector<FilmCertificate::PartClaim> of(const AnimatedExport& made, Id object)
    {
        std::vector<FilmCertificate::PartClaim> out;
        for (const FilmCertificate::PartClaim& claim : made.certificate.parts)
            if (claim.object == object) out.push_back(claim);
        return out;
    }
    TemporaryFolder folder_;
    Document still_;
    Ref<AssetStore> assets_;
};

} // namespace trivar::testing
