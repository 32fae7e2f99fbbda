// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/silhouette_options.h"

#include <CLI/CLI.hpp>

namespace trivar {

CLI::App* add_silhouette(CLI::App& app, SilhouetteCommand& o)
{
    CLI::App* silhouette =
        app.add_subcommand("silhouette", "draw volume data in lines, as .svg, .pdf, .png or .obj");
    silhouette->description(
        "Draws the silhouettes of levels of volume data as connected lines: a layer per level.\n"
        "It reads DICOM, NRRD, NIfTI, MetaImage, VTK and VTI, stacks of pictures and raw "
        "files.");
    silhouette->footer("Examples:\n"
                       "  trivar silhouette tooth.nrrd --hidden dashed --out tooth.svg\n"
                       "  trivar silhouette ct/ --level -300,226 --view 1,1,-0.2 --out head.svg");
    silhouette->add_option("VOLUME", o.volume, "a file, or a folder with a series of slices")
        ->required()
        ->type_name("");
    silhouette
        ->add_option("--level,--iso", o.levels,
                     "values whose surfaces are drawn, X[,Y...]; by default the one that parts\n"
                     "the values best")
        ->delimiter(',')
        ->type_name("X")
        ->allow_extra_args(false);
    silhouette
        ->add_option(
            "--name", o.names,
            "what the layers of the levels are called, NAME[,NAME...]; by default level 1,\n"
            "level 2 and so on")
        ->delimiter(',')
        ->type_name("NAME")
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
    silhouette->add_flag("--frame-grid", o.whole_grid,
                         "frame the whole grid, the same for any level; by default what is drawn");
    silhouette
        ->add_option(
            "--spacing", o.spacing,
            "mm between samples along each axis, of files that do not say it; 1 by default")
        ->delimiter(',')
        ->type_name("X,Y,Z")
        ->allow_extra_args(false);
    silhouette
        ->add_option(
            "--time", o.time,
            "which of the volumes in a file, or of the slices at one place, from 1: times,\n"
            "echoes, layers; the first by default")
        ->type_name("N")
        ->check(CLI::Range(1, 1'000'000));
    silhouette->add_flag("--below", o.below, "the body is where values are below the level");
    silhouette->add_flag("--smooth", o.smooth,
                         "take the samples as control points: smoother, less exact");
    silhouette->add_option("--blur", o.blur, "smooth the samples that many times before, 0 to 64")
        ->type_name("N")
        ->check(CLI::Range(0, 64));
    silhouette->add_flag("--hide-each-other", o.hide_each_other,
                         "what is behind another level is hidden, too");
    silhouette
        ->add_option("--style", o.style,
                     "plain; gradient (hue by slope), fans, grey (width and grey by slope),\n"
                     "chroma (hue by depth); pencil, ink. What follows changes it")
        ->type_name("NAME");
    silhouette->add_option("--color", o.colors, "of the lines of each level, RRGGBB[,RRGGBB...]")
        ->delimiter(',')
        ->type_name("COLOR")
        ->allow_extra_args(false);
    silhouette
        ->add_option("--coarsen", o.coarsen,
                     "make one sample of that many along each axis before, 1 to 64")
        ->type_name("N")
        ->check(CLI::Range(1, 64));
    silhouette
        ->add_option("--crop", o.crop,
                     "only the data in a box, as shares of the grid along its axes, 0 to 1")
        ->delimiter(',')
        ->type_name("X,Y,Z,X,Y,Z")
        ->allow_extra_args(false);
    silhouette
        ->add_option(
            "--memory", o.memory_mb,
            "MB that samples and coefficients may take, by default half of the machine's:\n"
            "larger data are drawn slab by slab, with the same lines")
        ->type_name("MB")
        ->check(CLI::Range(1, 1 << 30));
    silhouette->add_option("--width", o.width, "of lines in pixels; 1.8 by default")
        ->type_name("W")
        ->check(CLI::Range(0.05, 100.0));
    silhouette
        ->add_option(
            "--taper", o.taper,
            "pixels over which loose ends become fine; 0 by default, which keeps lines of\n"
            "one width strokes that a hand can edit")
        ->type_name("W")
        ->check(CLI::Range(0.0, 1000.0));
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
    silhouette->add_option("--paper", o.paper, "white, black, none or RRGGBB; white by default")
        ->type_name("COLOR");
    silhouette
        ->add_option("--wobble", o.wobble, "greatest distance of a line from its place, in pixels")
        ->type_name("W")
        ->check(CLI::Range(0.0, 100.0));
    silhouette
        ->add_option("--pencil", o.pencil,
                     "how far lines are like a pencil's, 0 to 1; 0.8 is 80 % in the\n"
                     "window")
        ->type_name("S")
        ->check(CLI::Range(0.0, 1.0));
    silhouette
        ->add_option("--fans", o.fans,
                     "pixels between fans that tell how steeply the data fall off; 0: none")
        ->type_name("STEP")
        ->check(CLI::Range(0.0, 1000.0));
    silhouette->add_option("--seed", o.seed, "of the wobble and the pencil")->type_name("N");
    silhouette
        ->add_option(
            "--dashes", o.dashes,
            "unconnected dashes by a lookup table of that many rows, as in the thesis, to\n"
            "compare with; parallel views")
        ->type_name("ROWS")
        ->check(CLI::Range(1, 65536));
    silhouette->add_flag("--suggestive", o.suggestive,
                         "also suggestive contours: outlines of views nearby");
    silhouette->add_flag("--ridges", o.ridges, "also lines where the surface is bent most outward");
    silhouette->add_flag("--valleys", o.valleys, "also lines where it is bent most inward");
    silhouette->add_flag("--parabolic", o.parabolic,
                         "also lines between what is bent like a ball and like a saddle");
    silhouette->add_option("--isophotes", o.isophotes, "also N lines of equal light, 0 to 64")
        ->type_name("N")
        ->check(CLI::Range(0, 64));
    silhouette->add_option("--light", o.light, "direction toward the light of --isophotes, X,Y,Z")
        ->delimiter(',')
        ->type_name("X,Y,Z")
        ->allow_extra_args(false);
    silhouette
        ->add_option("--smoothing", o.smoothing,
                     "voxels over which the data are smoothed for these lines, 0 to 5; 2.4 by "
                     "default")
        ->type_name("S")
        ->check(CLI::Range(0.0, 5.0));
    silhouette
        ->add_option("--detail", o.detail, "2: lines half as distinct are drawn, too; 1 by default")
        ->type_name("D")
        ->check(CLI::Range(0.05, 20.0));
    silhouette
        ->add_option("--amount", o.amount,
                     "share of all lines that is drawn, 0 to 1: those that tell most")
        ->type_name("SHARE")
        ->check(CLI::Range(0.0, 1.0));
    silhouette
        ->add_option("--certified", o.certified,
                     "prove that no line is missing that is larger than 2^-N voxel, 0 to 5")
        ->type_name("N")
        ->check(CLI::Range(0, 5));
    silhouette
        ->add_option("--edited", o.edited,
                     "an .svg of before that was edited by hand: what was deleted, made thicker\n"
                     "or coloured there is done again, also from another view near it")
        ->type_name("OLD.svg");
    silhouette->add_option("--out", o.out, "the .svg, .pdf, .png, or .obj (lines in space)")
        ->required()
        ->type_name("OUT");
    return silhouette;
}

} // namespace trivar
