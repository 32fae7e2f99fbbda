// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_sections.h"

#include "editor/panels/inspector/inspector_cuts.h"
#include "editor/panels/inspector/inspector_incisions.h"
#include "editor/panels/inspector/inspector_line_drawing.h"
#include "editor/panels/inspector/inspector_masks.h"
#include "editor/panels/inspector/inspector_simplify.h"
#include "editor/panels/inspector/inspector_split.h"
#include "editor/panels/inspector/inspector_tetrahedra.h"
#include "editor/panels/inspector/inspector_tiles.h"
#include "editor/panels/inspector/inspector_unwrap.h"
#include "editor/panels/panels.h"
#include "editor/session/scene_facts.h"

namespace trivar {
namespace {

template <class Shape> bool is_made_of(const Document& document, Id id)
{
    return made_of<Shape>(document, id) != nullptr;
}

bool is_placed(const Document& document, Id id)
{
    return object(document, id).stroke.has_value();
}

bool has_a_volume(const Document& document, Id id)
{
    return is_placed(document, id) || kind_of(document, id).has_cage;
}

// Placed objects have these rows among those of their placement.
bool is_bent_by_lattices_alone(const Document& document, Id id)
{
    return !is_placed(document, id) && kind_of(document, id).has_surface &&
           !lattices_round(document, id).empty();
}

bool has_triangles(const Document& document, Id id)
{
    return kind_of(document, id).has_surface;
}

bool has_clips(const Document& document, Id id)
{
    return kind_of(document, id).has_clips;
}

bool is_parted(const Document& document, Id id)
{
    return object(document, id).splitting.has_value();
}

bool is_cut(const Document& document, Id id)
{
    return object(document, id).cutting.has_value();
}

bool is_incised(const Document& document, Id id)
{
    return object(document, id).incising.has_value();
}

bool always(const Document&, Id)
{
    return true;
}

} // namespace

const std::vector<InspectorSection>& inspector_sections()
{
    static const std::vector<InspectorSection> all{
        {is_placed, draw_placement},
        {is_tile_layer, draw_tiles},
        {is_incised, draw_incisions},
        {is_cut, draw_cuts},
        {is_parted, draw_split},
        {is_made_of<LatticeShape>, draw_lattice},
        {is_made_of<TetrahedraShape>, draw_tetrahedra},
        {is_made_of<SimplexSheetShape>, draw_simplex_sheet},
        {has_a_volume, draw_shaping},
        {has_clips,
         [](Editor& editor, const ui::Theme& theme, Id id) { draw_clip(editor, theme, {id}); }},
        {is_made_of<VoxelShape>, draw_volume_data},
        {is_made_of<TextShape>, draw_text},
        {is_made_of<HeightShape>, draw_heights},
        {is_bent_by_lattices_alone, [](Editor& editor, const ui::Theme& theme,
                                       Id id) { draw_refinement(editor, theme, {id}); }},
        {always, draw_transform},
        {always, draw_material},
        {has_triangles,
         [](Editor& editor, const ui::Theme& theme, Id id) { draw_shading(editor, theme, {id}); }},
        {has_triangles, draw_simplify},
        {has_triangles, draw_unwrap},
        {has_triangles, draw_line_drawing},
        {always, draw_other_numbers},
    };
    return all;
}

} // namespace trivar
