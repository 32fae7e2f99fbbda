// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/import.h"
#include "editor/actions/remedies.h"

#include "core/commands/tiles/tiles.h"
#include "core/steps/tiles/covers.h"
#include "core/tiles/cell_counts.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

namespace trivar {
namespace {

// A pyramid without UVs that is covered by its texture square.
struct Covered : testing::Rig {
    Covered()
    {
        testing::write_file(folder.file("pyramid.obj"),
                            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\n"
                            "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
        ImportModel import;
        import.file.path = folder.file("pyramid.obj");
        EXPECT_TRUE(editor.session.run(prepare(import, *editor.session.assets())));
        EXPECT_TRUE(editor.session.run(AddBox{}));
        EXPECT_TRUE(editor.session.run(CoverWithTiles{2, 1, {.pattern = TilePattern::texture}}));
        wait();
    }
    const std::vector<std::string>& notices() const
    {
        return editor.session.evaluated().objects.at(2)->notices;
    }
    testing::TemporaryFolder folder;
};

TEST(Remedies, UnwrapWhatIsCoveredAndLacksUvs)
{
    Covered rig;
    ASSERT_EQ(rig.notices().size(), 1u);
    const auto remedy = remedy_of(rig.editor.session.document(), 2, rig.notices().front());
    ASSERT_TRUE(remedy);
    EXPECT_TRUE(remedy->words.starts_with("Unwrap"));
    ASSERT_TRUE(rig.editor.session.run(remedy->command));
    rig.wait();
    for (const std::string& notice : rig.notices())
        EXPECT_EQ(notice.find(lacks_uvs_words), notice.npos) << notice;
    EXPECT_FALSE(rig.editor.session.evaluated().objects.at(2)->parts.empty());
}

TEST(Remedies, SimplifyWhatIsTooFineByHalfAtATime)
{
    Covered rig;
    for (const double keep : {0.5, 0.25}) {
        const auto remedy = remedy_of(rig.editor.session.document(), 2,
                                      std::string("so ") + std::string(too_many_faces_words));
        ASSERT_TRUE(remedy);
        ASSERT_TRUE(rig.editor.session.run(remedy->command));
        EXPECT_EQ(object(rig.editor.session.document(), 1).simplifying->keep, keep);
    }
    EXPECT_TRUE(remedy_of(rig.editor.session.document(), 2, too_heavy_tiles_words));
    EXPECT_FALSE(remedy_of(rig.editor.session.document(), 1, "it is a sheet where it is cut"));
}

} // namespace
} // namespace trivar
