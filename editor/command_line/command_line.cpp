// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/command_line.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "core/base/this_program.h"
#include "core/commands/command.h"
#include "editor/command_line/bench.h"
#include "editor/command_line/export.h"
#include "editor/command_line/info.h"
#include "editor/command_line/render.h"
#include "editor/command_line/replay.h"
#include "editor/command_line/silhouette_options.h"
#include "editor/command_line/verify.h"
#include "editor/files/places.h"
#include "editor/help/about.h"
#include "editor/help/tutorial.h"
#include "editor/window/app.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

namespace trivar {
namespace {

struct Choices {
    std::vector<std::string> files;
    std::string shaders;
    bool tell_steps = false;
    ReplayOptions replay;
    RenderOptions render;
    ExportOptions exported;
    VerifyOptions verify;
    InfoOptions info;
    SilhouetteCommand silhouette;
    BenchOptions bench;
    bool commands_json = false, commands_markdown = false;
};

// An optional number without digits would be read as one that was not given.
std::string not_empty(const std::string& value)
{
    return value.empty() ? "must be a number" : "";
}

// An option whose value is called `type` in the help.
template <class Value>
CLI::Option* option(CLI::App& app, const std::string& name, Value& value, const std::string& type,
                    const std::string& help)
{
    return app.add_option(name, value, help)->type_name(type);
}

void add_shaders(CLI::App& app, std::string& checkout)
{
    option(app, "--shaders", checkout, "FOLDER",
           "draw with the shaders of a checkout of Trivar, and reload them\nwhen they change");
}

void add_scene(CLI::App& app, SceneLog& scene)
{
    option(app, "LOG", scene.path, "FILE", "the scene")->required();
    option(app, "--set", scene.relinked, "NAME=FILE",
           "use FILE in place of the file NAME that the scene names")
        ->allow_extra_args(false);
    app.add_flag("--keep-going", scene.keep_going,
                 "leave out models and fonts that cannot be read or are too large; without\nthis "
                 "nothing is written then and the status is 1");
    app.add_flag("--overwrite", scene.overwrite,
                 "allow overwriting files that the scene uses: the scene, models with "
                 "their\nmaterials, pictures and buffers, fonts");
}

void add_drawing(CLI::App& app, DrawingOptions& o)
{
    option(app, "--size", o.size, "WxH", "size of the picture in pixels; 1280x720 by default");
    option(app, "--quality", o.quality, "LEVEL",
           "quality of the picture: draft, standard (the default) or high");
    option(app, "--deform", o.deform, "WHERE",
           "where placed objects are deformed: processor (the default), or on "
           "the\ngraphics card in one_phase or two_phases, or by the ways of the "
           "thesis:\ndifferences, raised or filtered");
    option(app, "--camera", o.camera, "NAME",
           "bookmark to look from; by default the one named picture, or all is in\nview");
    add_shaders(app, o.shaders);
}

void add_threads(CLI::App& app, int& threads)
{
    option(app, "--threads", threads, "N", "use at most N threads")->check(CLI::Range(1, 1024));
}

CLI::App* add_render(CLI::App& app, RenderOptions& o)
{
    CLI::App* render = app.add_subcommand("render", "render the frames of a scene to a folder");
    render->description(
        "Renders frames of a scene (NAME.trivar), one picture per frame, without a window. A "
        "frame\ndepends on no other, and its file appears only when it is complete.");
    render->footer(
        "Examples:\n"
        "  trivar render ants.trivar --frames 1:240 --out ants/ants.####.png --video ants.mp4\n"
        "  trivar render ants.trivar --frames 1:240 --out ants/ants.####.exr --shard 2/4\n"
        "  trivar render ants.trivar --frames 1:240 --out ants/ants.####.png --resume\n"
        "  trivar render ants.trivar --frames 1:240 --sheet 3x2 --size 480x270 --out ants.png\n\n"
        "Ctrl C stops it after the current frame, with status 130.");
    add_scene(*render, o.scene);
    option(*render, "--frames", o.frames, "A:B[:S]", "frames A to B, every Sth")->required();
    option(*render, "--out", o.out, "DIR/name.####.png",
           "a .png or .exr per frame, with its number in place of the #. The folder "
           "is\ncreated if only the last part of its path is missing")
        ->required();
    add_drawing(*render, o.drawing);
    option(*render, "--depth", o.depth, "N", "bits per channel of a .png: 8 (the default) or 16")
        ->check(CLI::IsMember({8, 16}));
    option(*render, "--shard", o.shard, "I/N", "only every Nth frame, starting with the Ith");
    render->add_flag("--resume", o.resume,
                     "keep complete frames of this scene, size and depth; render the rest");
    option(*render, "--video", o.video, "OUT.mp4",
           "make an .mp4, .mov or .mkv with ffmpeg once all frames are rendered");
    option(*render, "--sheet", o.sheet, "COLUMNSxROWS",
           "put that many evenly spaced frames into one picture, OUT")
        ->excludes("--depth", "--shard", "--resume", "--video");
    add_threads(*render, o.threads);
    return render;
}

CLI::App* add_export(CLI::App& app, ExportOptions& o)
{
    CLI::App* verb = app.add_subcommand("export", "export an animated scene for other programs");
    verb->description(
        "Writes the frames of a scene (NAME.trivar) as one animated file: a .glb with nodes, "
        "skins\nand morph targets, certified to be within a tolerance at every time (see trivar "
        "verify);\na .usda; or point caches, .pc2 or .mdd with an .obj, one pair per object.");
    verb->footer("Examples:\n"
                 "  trivar export ants.trivar --to ants.glb --epsilon 0.002\n"
                 "  trivar export ants.trivar --to ants.usda --frames 1:48\n"
                 "  trivar export ants.trivar --to caches/ants.pc2\n\n"
                 "Ctrl C ends it with status 130 and leaves nothing.");
    add_scene(*verb, o.scene);
    option(*verb, "--to", o.to, "OUT", "a .glb, .usda, .pc2 or .mdd")->required();
    option(*verb, "--frames", o.frames, "A:B", "frames A to B; by default all frames of the scene");
    option(*verb, "--epsilon", o.epsilon, "E",
           "how far a .glb, or a tile that --instances unbends, may be from the scene at "
           "any\ntime, in metres; 0.001 by default")
        ->check(not_empty);
    verb->add_flag("--instances", o.instances,
                   "in a .usda, write every tile type and every copied mesh once, with "
                   "point\ninstancers");
    add_threads(*verb, o.threads);
    return verb;
}

CLI::App* add_replay(CLI::App& app, ReplayOptions& o)
{
    CLI::App* replay = app.add_subcommand("replay", "run a scene without a window");
    replay->description(
        "Runs a scene (NAME.trivar) from its first line to its last, without a window, and writes\n"
        "what was asked for.");
    replay->footer(
        "Examples:\n"
        "  trivar head.nrrd                                      look at volume data\n"
        "  trivar replay snake.trivar --image snake.png --size 1920x1080\n"
        "  trivar replay snake.trivar --export snake.glb snake.obj\n"
        "  trivar replay ants.trivar --frame 48 --image ants_048.png\n"
        "  trivar replay snake.trivar --set terrain.obj=/data/alps.obj --image alps.png\n"
        "  trivar replay snake.trivar --epsilon 0.001 --export snake.glb\n"
        "  trivar replay dragon.trivar --instances --export dragon.glb\n"
        "  trivar replay snake.trivar --check          # status 3 if a digest differs\n\n"
        "Every file is complete or not written at all. Ctrl C ends it with status 130.");
    add_scene(*replay, o.scene);
    option(*replay, "--to", o.to, "N", "stop after line N of the file")
        ->check(CLI::Range(1, 1 << 30));
    option(*replay, "--frame", o.frame, "N",
           "evaluate the scene in frame N; the first frame by default")
        ->check(not_empty);
    option(*replay, "--export", o.exports, "OUT",
           "write the result as .glb, .obj, .ply, .stl or .off");
    replay->add_flag("--instances", o.instances,
                     "in a .glb, write every tile type and every copied mesh once, with instances: "
                     "tiles\nunbent where that moves them by at most --epsilon, or 0.001 metres");
    option(*replay, "--image", o.image, "OUT",
           "draw a picture (.png, .jpg, .exr ...), or its lines alone (.svg, .pdf)");
    add_drawing(*replay, o.drawing);
    replay->add_flag(
        "--check", o.check,
        "compare with the digests in the file, and one thread with all threads, and\nsay what is "
        "proven of each volume: where it folds, and where it meets itself");
    replay->add_flag("--digest", o.digest,
                     "print the digests as a line that can be appended to the scene");
    option(*replay, "--epsilon", o.epsilon, "E",
           "split the triangles of all bent objects until their surfaces are "
           "certified\nto be within E metres; a .glb records this, see trivar verify")
        ->check(not_empty);
    option(*replay, "--timings", o.timings, "OUT.json", "write how long each stage took, as JSON");
    add_threads(*replay, o.threads);
    return replay;
}

CLI::App* add_verify(CLI::App& app, VerifyOptions& o)
{
    CLI::App* verify = app.add_subcommand("verify", "check what an exported model claims");
    verify->description(
        "Runs the scene that a .glb was exported from and compares samples of its triangles "
        "with\nthe true surfaces, to check that they are as near as the file claims.");
    verify->footer("Examples:\n"
                   "  trivar verify snake.glb           # status 3 if they are not\n"
                   "  trivar verify out/snake.glb --log snake.trivar");
    option(*verify, "FILE", o.file, "FILE.glb",
           "a file that trivar export or trivar replay --epsilon wrote")
        ->required();
    option(*verify, "--log", o.log, "LOG",
           "the scene; by default the one that the file names, in the same folder");
    option(*verify, "--set", o.relinked, "NAME=FILE",
           "use FILE in place of the file NAME that the scene names")
        ->allow_extra_args(false);
    return verify;
}

CLI::App* add_info(CLI::App& app, InfoOptions& o)
{
    CLI::App* info = app.add_subcommand("info", "describe what is in a file");
    info->description("Describes what is in models, volume data, images and scenes.");
    info->footer("Example:\n  trivar info bunny.obj head.nii.gz ct/ photo.png snake.trivar --json");
    option(*info, "FILE", o.files, "", "models, volume data or folders of it, images, scenes")
        ->required();
    info->add_flag("--json", o.json, "as JSON, for programs");
    return info;
}

CLI::App* add_commands(CLI::App& app, Choices& choices)
{
    CLI::App* commands = app.add_subcommand("commands", "list the commands of a scene file");
    commands->description("Lists every command of a scene file with its fields.");
    auto* as_json = commands->add_flag("--json", choices.commands_json, "as JSON, for programs");
    commands->add_flag("--markdown", choices.commands_markdown, "as docs/commands.md")
        ->excludes(as_json);
    return commands;
}

CLI::App* add_bench(CLI::App& app, BenchOptions& o)
{
    CLI::App* bench = app.add_subcommand("bench", "measure this machine");
    bench->description(
        "Measures how fast vertices are deformed by the processor and, in every way that\nthere "
        "is, by the graphics card, compared with the limits of copying and arithmetic.");
    bench->footer("Example:\n  trivar bench gpu --json > rates.json");
    option(*bench, "WHAT", o.what, "", "gpu")->required()->check(CLI::IsMember({"gpu"}));
    bench->add_flag("--json", o.json, "as JSON, for programs");
    option(*bench, "--vertices", o.vertices, "N", "measure with at most N vertices")
        ->check(CLI::Range(1, 10'000'000));
    option(*bench, "--seconds", o.most_s, "S",
           "leave out what takes longer per run, in seconds; 1 by default")
        ->check(CLI::Range(0.001, 1000.0));
    option(*bench, "--minutes", o.minutes, "M",
           "begin nothing after this many minutes; 8 by default")
        ->check(CLI::Range(0.01, 1000.0));
    return bench;
}

Status list_commands(const Choices& choices, const Streams& streams)
{
    if (choices.commands_json)
        streams.out << commands_json();
    else if (choices.commands_markdown)
        streams.out << commands_markdown();
    else
        streams.out << commands_text();
    return Status::done;
}

std::vector<std::string> sample_scenes_in(const std::string& folder)
{
    std::vector<std::string> scenes;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.path().extension() == ".trivar") scenes.push_back(entry.path().string());
    std::ranges::sort(scenes);
    return scenes;
}

Status dispatch(const std::vector<std::string>& arguments, const Streams& streams)
{
    Choices choices;
    CLI::App app(
        "Trivar lays deformable models on any scene with one stroke.\n\n"
        "Without a command it opens the editor with the scenes, models and volume data\ngiven.",
        "trivar");
    app.footer(
        "Examples:\n"
        "  trivar snake.trivar                                   open a scene\n"
        "  trivar terrain.obj snake.glb                          a new scene with two models\n"
        "  trivar replay snake.trivar --image snake.png          draw it without a window\n"
        "  trivar render ants.trivar --frames 1:240 --out ants/a.####.png      and its frames\n\n"
        "trivar COMMAND --help says more. Exit status: 0 done, 1 rejected, 2 wrong usage,\n"
        "3 a check failed, 130 stopped by Ctrl C.");
    option(app, "FILE", choices.files, "", "scenes (.trivar), models and volume data to open");
    add_shaders(app, choices.shaders);
    app.add_flag("--tell-steps", choices.tell_steps,
                 "write to standard output, before each frame of the window is shown, how\nmany "
                 "steps it shows");
    app.set_version_flag("--version", "Trivar " + program_version(), "print the version and exit");
    app.require_subcommand(0, 1);
    const CLI::App* replay = add_replay(app, choices.replay);
    const CLI::App* render = add_render(app, choices.render);
    const CLI::App* exported = add_export(app, choices.exported);
    const CLI::App* verify = add_verify(app, choices.verify);
    const CLI::App* info = add_info(app, choices.info);
    const CLI::App* silhouette = add_silhouette(app, choices.silhouette);
    const CLI::App* commands = add_commands(app, choices);
    const CLI::App* bench = add_bench(app, choices.bench);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
        return app.exit(error, streams.out, streams.talk) == 0 ? Status::done : Status::usage;
    }
    if (replay->parsed()) return run_replay(choices.replay, streams);
    if (render->parsed()) return run_render(choices.render, streams);
    if (exported->parsed()) return run_export(choices.exported, streams);
    if (verify->parsed()) return run_verify(choices.verify, streams);
    if (info->parsed()) return run_info(choices.info, streams);
    if (silhouette->parsed()) return run_silhouette(choices.silhouette, streams);
    if (commands->parsed()) return list_commands(choices, streams);
    if (bench->parsed()) return run_bench(choices.bench, streams);
    std::error_code error;
    for (const std::filesystem::path file : choices.files)
        if (!file.has_extension() && !std::filesystem::exists(file, error))
            throw WrongUsage(file.string() +
                             ": no command and no file; trivar --help lists the commands");
    EditorOptions options;
    options.files = choices.files;
    options.shaders = choices.shaders;
    options.tell_steps = choices.tell_steps;
    const Places places = places_of(this_program());
    options.samples = sample_scenes_in(places.scenes);
    options.sample_pictures = places.pictures;
    options.manual = places.manual;
    options.models = places.models;
    options.tutorials = tutorials_in(places.tutorials);
    return run_editor(options) == 0 ? Status::done : Status::rejected;
}

} // namespace

Status run_program(const std::vector<std::string>& arguments, const Streams& streams)
{
    try {
        return dispatch(arguments, streams);
    } catch (const WrongUsage& error) {
        streams.talk << "trivar: " << error.what() << "\n";
        return Status::usage;
    } catch (const std::exception& error) {
        streams.talk << "trivar: " << words_of(error) << "\n";
    }
    return Status::rejected;
}

} // namespace trivar
