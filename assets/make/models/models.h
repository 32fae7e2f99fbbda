// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

// Everything the generator makes. Deformables lie along +x (tail at 0, nose at 1) on y = 0 and are
// symmetric in z; tiles are an exception: they are made with u = x, v = y in [0, 1] and height =
// z, and stand upright on that square in the file.
namespace make {

struct Entry {
    std::string name; // of the file, without its ending
    std::function<Model()> build;
};
std::vector<Entry> catalogue();
Model build(const Entry& entry); // named

Model snake();
Model crocodile();
Model horse();
Model camel();
Model whale();
Model ant();
Model reptile();
Model robot();
Model head();
Model forearm();
Model mask();
Model car();
Model car_blue();
Model car_cream();
Model bulldozer();
Model tree();
Model trunk();
Model terrain();
Model bottle();
Model wine_glass();
Model goblet();
Model jar();
Model pumpkin();
Model dodecahedron();
Model bars();
Model profile();
Model gear();
Model moebius();
Model moebius_lattice();
Model teapot();
Model book();
Model desk();
Model mechanical();
Model bones_hand();
Model bones_jaw();
Model crystal();
Model tile_thorn();
Model tile_flower();
Model tile_chain();
Model tile_mail();
Model tile_hair();
Model tile_hex();
Model tile_brick_a();
Model tile_brick_b();
Model tile_brick_c();
Model tile_brick_hollow();
Model tile_scale();
Model tile_statue();
Model tile_feather();
Model tile_leaf();
Model tile_grass();
Model tile_cobble();
Model tile_shingle();
Model tile_stud();
Model tile_rivet();
Model tile_rope();
Model tile_braid();
Model tile_lock();
Model tile_knit();
Model tile_robot();

} // namespace make
