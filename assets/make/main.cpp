// SPDX-License-Identifier: GPL-3.0-or-later
// trivar-make FOLDER [NAME...]: writes FOLDER/NAME.glb for each model named, or for all of them;
// "volumes", "volumes/NAME", "cages" and "pictures" are names too. --preview FOLDER adds four
// shaded views of each;
// --quiet prints nothing of them.
#include "assets/make/check.h"
#include "assets/make/models/cages.h"
#include "assets/make/models/models.h"
#include "assets/make/models/pictures.h"
#include "assets/make/preview.h"
#include "assets/make/volumes/volumes.h"
#include "assets/make/write_model.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

namespace {

struct Order {
    std::string folder, preview_folder;
    bool quiet = false;
    std::vector<std::string> names;
    bool wants(const std::string& name) const
    {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    }
};

Order parse(const std::vector<std::string>& words)
{
    Order order;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--preview" && i + 1 < words.size()) {
            order.preview_folder = words[++i];
        } else if (words[i] == "--quiet") {
            order.quiet = true;
        } else if (order.folder.empty()) {
            order.folder = words[i];
        } else {
            order.names.push_back(words[i]);
        }
    }
    return order;
}

void print(const std::string& name, const make::Report& r)
{
    std::printf("%-18s %6d vertices %6d faces %3d%% quads %3d pieces %4d open %d shared edges, "
                "%4.1f%% under 20 degrees, %.2f x %.2f x %.2f\n",
                name.c_str(), r.vertices, r.faces, 100 * r.quads / std::max(1, r.faces), r.pieces,
                r.open, r.nonmanifold, double(r.under_20_deg), double(r.hi.x - r.lo.x),
                double(r.hi.y - r.lo.y), double(r.hi.z - r.lo.z));
}

void write_volumes(const Order& order)
{
    for (const make::NamedVolume& volume : make::volumes()) {
        if (!order.wants("volumes") && !order.wants("volumes/" + volume.name)) continue;
        std::filesystem::create_directories(order.folder + "/volumes");
        make::write_nrrd(volume.build(), order.folder + "/volumes/" + volume.name + ".nrrd");
    }
}

void run(const Order& order)
{
    std::filesystem::create_directories(order.folder);
    write_volumes(order);
    if (order.wants("pictures")) make::write_pictures(order.folder + "/pictures");
    if (order.wants("cages")) make::write_cages(order.folder + "/cages");
    for (const make::Entry& entry : make::catalogue()) {
        if (!order.wants(entry.name)) continue;
        const make::Model model = make::build(entry);
        make::write_glb(model, order.folder + "/" + entry.name + ".glb");
        if (!order.quiet) print(entry.name, make::check(model));
        if (!order.preview_folder.empty()) {
            make::write_preview(model, order.preview_folder + "/" + entry.name + ".ppm");
        }
    }
}

} // namespace

int main(int argc, char** argv)
{
    const Order order = parse({argv + 1, argv + argc});
    if (order.folder.empty()) {
        std::fprintf(stderr, "usage: trivar-make FOLDER [NAME...] [--preview FOLDER] [--quiet]\n");
        return 2;
    }
    try {
        run(order);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "trivar-make: %s\n", error.what());
        return 1;
    }
    return 0;
}
