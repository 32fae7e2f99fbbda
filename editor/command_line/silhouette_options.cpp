// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/silhouette_options.h"

#include <CLI/CLI.hpp>

namespace trivar {

CLI::App* add_silhouette(CLI::App& app, SilhouetteCommand& o)
{
    CLI::App* silhouette =
        app.add_subcommand("silhouette", "draw volume data in lines, as an .svg");
    silhouette->description(
        "Draws the silhouettes of levels of volume data as connected lines: a layer per level in\n"
        "an .svg. It reads DICOM, NRRD, NIfTI, MetaImage, VTK and VTI, stacks of pictures and raw "
        "files.");
    silhouette->footer("Examples:\n"
                       "  trivar silhouette tooth.nrrd --hidden dashed --out tooth.svg\n"
                       "  trivar silhouette ct/ --level -300,226 --view 1,1,-0.2 --out head.svg");
    silhouette->add_option("VOLUME", o.volume, "a file, or a folder with a series of slices")
        ->required()
        ->type_name("");
    silhouette
        ->add_option("--level", o.levels,
                     "values whose surfaces are drawn, X[,Y...]; by default the one that parts\n"
                     "the values best")
        ->delimiter(',')
        ->type_name("X")
        ->allow_extra_args(false);
    silhouette->add_option("--view", o.view, "direction of sight, X,Y,Z; 1,1,-0.5 by default")
        ->delimiter(',')
        ->type_name("X,Y,Z")
        ->allow_extra_args(false);
    silhouette->add_option("--up", o.up, "direction that is up in the drawing, X,Y,Z; Z by default")
        ->delimiter(',')
        ->type_name("X,Y,Z")
        ->allow_extra_args(false);
    silhouette->add_option("--fov", o.fov_deg, "angle of view in degrees; by default parallel")
        ->type_name("DEG")
        ->check(CLI::Range(1.0, 120.0));
    silhouette->add_option("--size", o.size, "of the drawing in pixels; 1000x1000 by default")
        ->type_name("WxH");
    silhouette->add_flag("--below", o.below, "the body is where values are below the level");
    silhouette->add_flag("--smooth", o.smooth,
                         "take the samples as control points: smoother, less exact");
    silhouette->add_option("--blur", o.blur, "smooth the samples that many times before, 0 to 64")
        ->type_name("N")
        ->check(CLI::Range(0, 64));
    silhouette->add_option("--width", o.width, "of lines in pixels; 1.8 by default")
        ->type_name("W")
        ->check(CLI::Range(0.05, 100.0));
    silhouette
        ->add_option("--width-by", o.width_by, "what the width follows: even, slope, depth, bend")
        ->type_name("HOW");
    silhouette
        ->add_option("--color-by", o.color_by,
                     "what the colour follows: plain, slope, depth (red near, blue far), grey")
        ->type_name("HOW");
    silhouette
        ->add_option("--hidden", o.hidden, "how hidden lines are drawn: none, faint, dashed, seen")
        ->type_name("HOW");
    silhouette->add_option("--paper", o.paper, "white, black, none; white by default")
        ->type_name("COLOR");
    silhouette
        ->add_option("--wobble", o.wobble, "greatest distance of a line from its place, in pixels")
        ->type_name("W")
        ->check(CLI::Range(0.0, 100.0));
    silhouette->add_option("--seed", o.seed, "of the wobble")->type_name("N");
    silhouette
        ->add_option("--certified", o.certified,
                     "prove that no line is missing that is larger than 2^-N voxel, 0 to 5")
        ->type_name("N")
        ->check(CLI::Range(0, 5));
    silhouette->add_option("--out", o.out, "the .svg")->required()->type_name("OUT.svg");
    return silhouette;
}

} // namespace trivar
