// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

namespace make {

std::vector<Entry> catalogue()
{
    return {{"snake", snake},
            {"crocodile", crocodile},
            {"horse", horse},
            {"camel", camel},
            {"whale", whale},
            {"ant", ant},
            {"reptile", reptile},
            {"robot", robot},
            {"head", head},
            {"forearm", forearm},
            {"mask", mask},
            {"car", car},
            {"car_blue", car_blue},
            {"car_cream", car_cream},
            {"bulldozer", bulldozer},
            {"tree", tree},
            {"trunk", trunk},
            {"terrain", terrain},
            {"jar", jar},
            {"pumpkin", pumpkin},
            {"bottle", bottle},
            {"wine_glass", wine_glass},
            {"goblet", goblet},
            {"dodecahedron", dodecahedron},
            {"bars", bars},
            {"profile", profile},
            {"gear", gear},
            {"moebius", moebius},
            {"moebius_lattice", moebius_lattice},
            {"teapot", teapot},
            {"book", book},
            {"desk", desk},
            {"mechanical", mechanical},
            {"bones_hand", bones_hand},
            {"bones_jaw", bones_jaw},
            {"crystal", crystal},
            {"tile_thorn", tile_thorn},
            {"tile_flower", tile_flower},
            {"tile_chain", tile_chain},
            {"tile_mail", tile_mail},
            {"tile_hair", tile_hair},
            {"tile_hex", tile_hex},
            {"tile_brick_a", tile_brick_a},
            {"tile_brick_b", tile_brick_b},
            {"tile_brick_c", tile_brick_c},
            {"tile_brick_hollow", tile_brick_hollow},
            {"tile_scale", tile_scale},
            {"tile_statue", tile_statue},
            {"tile_feather", tile_feather},
            {"tile_leaf", tile_leaf},
            {"tile_grass", tile_grass},
            {"tile_cobble", tile_cobble},
            {"tile_shingle", tile_shingle},
            {"tile_stud", tile_stud},
            {"tile_rivet", tile_rivet},
            {"tile_rope", tile_rope},
            {"tile_braid", tile_braid},
            {"tile_lock", tile_lock},
            {"tile_knit", tile_knit},
            {"tile_robot", tile_robot}};
}

Model build(const Entry& entry)
{
    Model model = entry.build();
    model.name = entry.name;
    model.root().name = entry.name;
    if (entry.name.starts_with("tile_")) // tiles are made lying, with their height along z
        for (Mesh& part : model.root().parts) part.turn(-90, {1, 0, 0});
    return model;
}

} // namespace make
