// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/synonyms.h"

#include <algorithm>
#include <cctype>

namespace trivar {

const std::vector<Synonym>& synonyms()
{
    static const std::vector<Synonym> all{
        {"align", {"Place"}},
        {"animate", {"Insert key", "Auto-key", "Timeline"}},
        {"apply", {"Apply shape...", "Delete lattice, keep shape"}},
        {"array", {"Set travel", "Duplicate"}},
        {"autosave", {"Save", "Preferences..."}},
        {"background", {"Picture settings"}},
        {"bake", {"Export frames...", "Apply shape...", "Delete lattice, keep shape"}},
        {"bend", {"Lattice", "Place", "Press"}},
        {"bisect", {"Split"}},
        {"boolean", {"Split"}},
        {"bump", {"Displace by image..."}},
        {"cage", {"Add Lattice round selection", "Lattice"}},
        {"camera", {"Render camera", "Set render camera to view", "Bookmark view"}},
        {"checker", {"UV checker"}},
        {"clone", {"Duplicate"}},
        {"color", {"Set material", "Colour by material"}},
        {"colour", {"Set material", "Colour by material"}},
        {"copies", {"Set travel", "Duplicate"}},
        {"ct", {"Import model..."}},
        {"curve", {"Place", "Import model..."}},
        {"cut", {"Split", "Incise"}},
        {"decimate", {"Simplify"}},
        {"deform", {"Lattice", "Add Lattice round selection", "Press", "Place"}},
        {"detach", {"Remove from stroke"}},
        {"dicom", {"Import model..."}},
        {"displacement", {"Displace by image..."}},
        {"drape", {"Place"}},
        {"environment", {"Picture settings"}},
        {"export", {"Export...", "Export frames..."}},
        {"exposure", {"Picture settings"}},
        {"facet", {"Shade flat", "Shade by angle"}},
        {"fade", {"Mask", "Mask tiles by curve"}},
        {"ffd", {"Add Lattice round selection", "Lattice"}},
        {"fix", {"Repair folds", "Find missing file..."}},
        {"flap", {"Incise"}},
        {"flow", {"Place", "Set travel"}},
        {"follow", {"Place", "Set travel"}},
        {"glass", {"Set material"}},
        {"grab", {"Move"}},
        {"gradient", {"Mask", "Mask tiles by curve"}},
        {"heal", {"Incise"}},
        {"heightmap", {"Displace by image..."}},
        {"help", {"Manual", "Keys and mouse"}},
        {"hole", {"Split", "Incise"}},
        {"iso-surface", {"Silhouettes", "Import model..."}},
        {"isosurface", {"Silhouettes", "Import model..."}},
        {"keyframe", {"Insert key", "Auto-key"}},
        {"knife", {"Split", "Incise"}},
        {"lamp", {"Picture settings"}},
        {"letters", {"Add Text"}},
        {"light", {"Picture settings"}},
        {"link", {"Group", "Find missing file..."}},
        {"load", {"Open...", "Import model..."}},
        {"material", {"Set material"}},
        {"measure", {"Timing", "Colour by stretch"}},
        {"mend volume", {"Repair folds"}},
        {"merge", {"Group"}},
        {"mesh", {"Import model...", "Add Box", "Add Sphere"}},
        {"mirror", {"Transform", "Scale"}},
        {"model", {"Import model..."}},
        {"morph", {"Add Lattice round selection", "Export frames..."}},
        {"movie", {"Record..."}},
        {"mug", {"Add Cylinder"}},
        {"normals", {"Shade smooth", "Shade by angle", "Shade flat"}},
        {"opacity", {"Set material"}},
        {"options", {"Preferences..."}},
        {"ortho", {"Perspective", "Front", "Right", "Top"}},
        {"orthographic", {"Perspective", "Front", "Right", "Top"}},
        {"paper", {"Picture settings", "Export..."}},
        {"parallel", {"Perspective"}},
        {"parent", {"Group"}},
        {"path", {"Place", "Set travel"}},
        {"peel", {"Incise"}},
        {"pivot", {"Transform"}},
        {"project", {"Place"}},
        {"reduce", {"Simplify"}},
        {"render", {"Render picture", "Record..."}},
        {"reset", {"Transform", "Reset interface size"}},
        {"resize", {"Scale"}},
        {"ring", {"Add Torus"}},
        {"sculpt", {"Press"}},
        {"section", {"Incise", "Split"}},
        {"see through", {"X-ray"}},
        {"settings", {"Preferences...", "Picture settings"}},
        {"shadow", {"Picture settings"}},
        {"sharp", {"Shade flat", "Shade by angle"}},
        {"shortcut", {"Keys and mouse"}},
        {"shrinkwrap", {"Place"}},
        {"sky", {"Picture settings"}},
        {"slice", {"Split", "Import model..."}},
        {"slide", {"Set travel", "Edit placement"}},
        {"smooth", {"Shade smooth", "Shade by angle", "Edit import", "Refine"}},
        {"snap", {"Place"}},
        {"soft selection", {"Proportional editing"}},
        {"solo", {"Isolate"}},
        {"subdivide", {"Edit import", "Refine"}},
        {"sun", {"Picture settings"}},
        {"svg", {"Export..."}},
        {"texture", {"Set material", "Import model...", "Unwrap"}},
        {"theme", {"Preferences..."}},
        {"tooltip", {"Show hints again"}},
        {"transparency", {"Set material", "X-ray"}},
        {"transparent", {"Set material", "X-ray"}},
        {"turntable", {"Set travel", "Insert key"}},
        {"twist", {"Lattice", "Add Lattice round selection", "Rotate"}},
        {"unlink", {"Ungroup", "Remove from stroke"}},
        {"unparent", {"Ungroup"}},
        {"uv", {"Unwrap", "UV checker", "Colour by UV angles", "Colour by UV areas"}},
        {"video", {"Record..."}},
        {"walk", {"Play clip", "Set travel"}},
        {"warp", {"Lattice", "Add Lattice round selection"}},
        {"wrap", {"Place", "Place round"}},
        {"zip", {"Incise"}},
        {"zoom", {"Frame selection", "Frame all"}},
    };
    return all;
}

std::vector<std::string> names_meant_by(std::string_view typed)
{
    constexpr std::size_t least = 2;
    std::string word(typed.substr(0, 64));
    std::ranges::transform(word, word.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    while (word.ends_with(' ')) word.pop_back();
    std::vector<std::string> names;
    if (word.size() < least) return names;
    for (const Synonym& each : synonyms())
        if (each.word.starts_with(word))
            for (const std::string_view name : each.names)
                if (std::ranges::find(names, name) == names.end()) names.emplace_back(name);
    return names;
}

} // namespace trivar
