// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/every_program.h"

#include "gpu/ffd/blind_draw.h"
#include "gpu/ffd/device_poser.h"
#include "gpu/passes/cast.h"
#include "gpu/passes/lines.h"
#include "gpu/passes/sample.h"
#include "gpu/passes/wire.h"
#include "gpu/tiles/tile_sieve.h"

#include <fmt/format.h>

namespace trivar::gpu::testing {
namespace {

using Defines = std::vector<std::string>;

Defines with(Defines defines, const Defines& more)
{
    defines.insert(defines.end(), more.begin(), more.end());
    return defines;
}

// Whatever deforms by lattices of these orders.
std::vector<ProgramName> deforming_programs(const std::array<int, 3>& orders)
{
    std::vector<ProgramName> out;
    for (const bool texels : {true, false}) {
        const Defines volume = volume_defines(orders, texels);
        for (const bool tangents : {true, false})
            out.push_back(deform_program({orders, {}, tangents, texels}));
        for (const Sum sum : {Sum::nested, Sum::raised, Sum::filtered})
            for (const NormalsBy normals : {NormalsBy::nothing, NormalsBy::differences})
                out.push_back(deform_program({orders, {sum, normals}, false, texels}));
        for (const VertexOutputs outputs :
             {VertexOutputs::positions, VertexOutputs::normals, VertexOutputs::tangents})
            out.push_back(vertex_program(volume, outputs));
        out.push_back(bounds_program(volume));
    }
    for (const char* own : {"PLAIN", "TEXTURES 31"})
        out.push_back({"mesh", "surfaces", with(volume_defines(orders, true), {own})});
    return out;
}

} // namespace

std::vector<ProgramName> every_program()
{
    std::vector<ProgramName> out;
    for (const bool skinned : {true, false})
        for (int kinds = 0; kinds < 4; ++kinds)
            for (const bool tangents : {true, false})
                out.push_back(pose_program(skinned, kinds, true, tangents));
    for (const char* solid : {"SOLID 1", "SOLID 2"})
        out.push_back({"mesh", "ghost", {"LAYER_DEPTHS", solid}});
    const std::vector<Defines> materials{{},
                                         {"COPIES"},
                                         {"MASKED"},
                                         {"MASKED", "COPIES"},
                                         {"TEXTURES 1", "MASKED"},
                                         {"TEXTURES 1"},
                                         {"TEXTURES 14"},
                                         {"TEXTURES 31"},
                                         {"TEXTURES 31", "COPIES"},
                                         {"COPIES", "TILES"},
                                         {"MASKED", "COPIES", "TILES"},
                                         {"TEXTURES 31", "COPIES", "TILES"}};
    for (const Defines& material : materials) {
        for (const char* fragment : {"depth", "ids", "mask"})
            out.push_back({"mesh", fragment, material});
        out.push_back({"mesh", "surfaces", material});
        out.push_back({"mesh", "ghost", with({"LAYER_DEPTHS"}, material)});
        out.push_back({"mesh", "surfaces", with({"CLAY"}, material)});
    }
    for (const char* own : {"PLAIN", "VALUES", "SOLID 1", "SOLID 2"})
        for (const Defines& look : {Defines{}, Defines{"CLAY"}})
            for (const Defines& more : {Defines{}, Defines{"COPIES"}, Defines{"COPIES", "TILES"}})
                out.push_back({"mesh", "surfaces", with(with(look, {own}), more)});
    for (const Quality& quality : {quality_for(1, true), quality_for(1, false),
                                   quality_for(4, false), quality_for(16, false)}) {
        const Defines shadow = quality.shadow_defines();
        const Defines lit =
            quality.ghost_defines(quality.layers_at_once ? Defines{"LAYERS_AT_ONCE"} : Defines{});
        for (const Defines& material : materials)
            out.push_back({"mesh", "ghost", with(lit, material)});
        for (const char* solid : {"SOLID 1", "SOLID 2"})
            out.push_back({"mesh", "ghost", with(lit, {solid})});
        for (const int slices : {0, quality.occlusion_slices}) {
            Quality q = quality;
            q.occlusion_slices = slices;
            out.push_back(full_screen_program("occlusion", q.occlusion_defines()));
        }
    }
    for (const Defines& more : {Defines{}, Defines{"GRID"}, Defines{"DEEP"}})
        out.push_back(full_screen_program("backdrop", more));
    for (const char* fragment : {"shade", "occlusion_blur", "contact", "contact_blur", "average",
                                 "outline", "layers_over"})
        out.push_back(full_screen_program(fragment));
    out.push_back(full_screen_program("outline", {"DRAFT"}));
    out.push_back(full_screen_program("occlusion_blur", quality_for(1, true).blur_defines()));
    out.push_back(full_screen_program("layers_over", {"LAYERS_AT_ONCE"}));
    for (const FieldOrder order : {FieldOrder::linear, FieldOrder::quadratic, FieldOrder::cubic})
        for (const bool rough : {true, false}) out.push_back(cast_program(order, rough));
    for (const bool ids : {true, false}) out.push_back(cast_over_program(ids));
    for (const Defines& defines :
         {Defines{}, Defines{"HELPERS"}, Defines{"IDS"}, Defines{"IDS", "WHOLE"}, Defines{"MASK"},
          Defines{"COVER"}, Defines{"BEFORE_OWN"}, Defines{"BEFORE_OWN", "COVER"}})
        out.push_back(line_program(defines));
    for (const Defines& more : {Defines{}, Defines{"LAYER_DEPTHS"}})
        out.push_back({"veil", "veil", more});
    for (const Defines& placing : {Defines{}, Defines{"COPIES"}, Defines{"COPIES", "TILES"}})
        out.push_back(wire_program(placing));
    out.push_back({"mesh", "mask", {"COPIES", "TILES", "FOOTPRINTS"}});
    out.push_back({"", "", {}, "arithmetic"});
    for (const ProgramName& name : TileSieve::programs()) out.push_back(name);
    for (const ProgramName& name : pyramid_programs()) out.push_back(name);
    for (const VertexOutputs outputs :
         {VertexOutputs::positions, VertexOutputs::normals, VertexOutputs::tangents})
        out.push_back(vertex_program({}, outputs));
    out.push_back(bounds_program({}));
    for (const std::array<int, 3>& orders :
         {std::array{3, 3, 3}, std::array{4, 3, 2}}) // the others are the same text
        for (const ProgramName& name : deforming_programs(orders)) out.push_back(name);
    return out;
}

} // namespace trivar::gpu::testing
