// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/command_line.h"

#include "core/base/rejected.h"
#include "core/base/this_program.h"
#include "core/commands/command.h"
#include "editor/command_line/bench.h"
#include "editor/command_line/export.h"
#include "editor/command_line/info.h"
#include "editor/command_line/render.h"
#include "editor/command_line/replay.h"
#include "editor/command_line/verify.h"
#include "editor/files/places.h"
#include "editor/help/about.h"
#include "editor/help/tutorial.h"
#include "editor/window/app.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <new>

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
    BenchOptions bench;
    bool commands_json = false, commands_markdown = false;
};

// An optional number without digits would be read as one that was not given.
std::string not_empty(const std::string& value)
{
    return value.empty() ? "must be a number" : "";
}

void add_shaders(CLI::App& app, std::string& checkout)
{
    app.add_option("--shaders", checkout,
                   "draw with the shaders of a checkout of Trivar; the window follows their\n"
                   "changes")
        ->type_name("FOLDER");
}

void add_scene(CLI::App& app, SceneLog& scene)
{
    app.add_option("LOG", scene.path, "the scene")->required()->type_name("FILE");
    app.add_option("--set", scene.relinked, "use FILE where the scene names the file NAME")
        ->type_name("NAME=FILE")
        ->allow_extra_args(false);
    app.add_flag("--keep-going", scene.keep_going,
                 "write without a model or font that cannot be read, or is too large; else\n"
                 "nothing is written and the status is 1");
    app.add_flag("--overwrite", scene.overwrite,
                 "write also over files that the scene is made from: itself, models with their\n"
                 "materials, pictures and buffers, fonts");
}

void add_drawing(CLI::App& app, DrawingOptions& o)
{
    app.add_option("--size", o.size, "of the picture in pixels, 1280x720 if left out")
        ->type_name("WxH");
    app.add_option("--quality", o.quality,
                   "of the picture: draft, standard or high; standard if left out")
        ->type_name("LEVEL");
    app.add_option("--deform", o.deform,
                   "where the picture's placed objects are deformed: processor, one_phase or\n"
                   "two_phases of the graphics card, or there as the thesis has it:\n"
                   "differences, raised or filtered; processor if left out")
        ->type_name("WHERE");
    app.add_option("--camera", o.camera,
                   "kept view to look from; else the one named picture, else all is in view")
        ->type_name("NAME");
    add_shaders(app, o.shaders);
}

void add_threads(CLI::App& app, int& threads)
{
    app.add_option("--threads", threads, "use at most N threads")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
}

CLI::App* add_render(CLI::App& app, RenderOptions& o)
{
    CLI::App* render = app.add_subcommand("render", "draw a scene's frames into a folder");
    render->description(
        "Draws frames of a scene (NAME.trivar), one picture a frame, without a window. A frame\n"
        "depends on no other, and its file stands there when it is whole or not at all.");
    render->footer(
        "Examples:\n"
        "  trivar render ants.trivar --frames 1:240 --out ants/ants.####.png --video ants.mp4\n"
        "  trivar render ants.trivar --frames 1:240 --out ants/ants.####.exr --shard 2/4\n"
        "  trivar render ants.trivar --frames 1:240 --out ants/ants.####.png --resume\n"
        "  trivar render ants.trivar --frames 1:240 --sheet 3x2 --size 480x270 --out ants.png\n\n"
        "Ctrl C stops it after the current frame, with status 130.");
    add_scene(*render, o.scene);
    render->add_option("--frames", o.frames, "from A to B, every Sth")
        ->required()
        ->type_name("A:B[:S]");
    render
        ->add_option("--out", o.out,
                     "a .png or .exr for each; its number stands where the # are. A folder is\n"
                     "made where only the last part of its name is missing")
        ->required()
        ->type_name("DIR/name.####.png");
    add_drawing(*render, o.drawing);
    render->add_option("--depth", o.depth, "bits a channel of a .png: 8, or 16; 8 if left out")
        ->type_name("N")
        ->check(CLI::IsMember({8, 16}));
    render->add_option("--shard", o.shard, "only every Nth of the frames, from the Ith on")
        ->type_name("I/N");
    render->add_flag("--resume", o.resume,
                     "leave what is there, whole, of this scene, size and depth; draw the rest");
    render
        ->add_option("--video", o.video,
                     "make a .mp4, .mov or .mkv by ffmpeg when all frames are there")
        ->type_name("OUT.mp4");
    render
        ->add_option("--sheet", o.sheet,
                     "so many of the frames, evenly, in rows and columns of one picture, OUT")
        ->type_name("COLUMNSxROWS")
        ->excludes("--depth", "--shard", "--resume", "--video");
    add_threads(*render, o.threads);
    return render;
}

CLI::App* add_export(CLI::App& app, ExportOptions& o)
{
    CLI::App* verb = app.add_subcommand("export", "write a scene that moves for other programs");
    verb->description(
        "Writes the frames of a scene (NAME.trivar) as one file that moves: a .glb with nodes,\n"
        "skins and morph targets, certified to be within a tolerance at every time, see trivar\n"
        "verify; a .usda; or point caches, .pc2 or .mdd with an .obj, a pair for every object.");
    verb->footer("Examples:\n"
                 "  trivar export ants.trivar --to ants.glb --epsilon 0.002\n"
                 "  trivar export ants.trivar --to ants.usda --frames 1:48\n"
                 "  trivar export ants.trivar --to caches/ants.pc2\n\n"
                 "Ctrl C ends it with status 130 and leaves nothing.");
    add_scene(*verb, o.scene);
    verb->add_option("--to", o.to, "a .glb, .usda, .pc2 or .mdd")->required()->type_name("OUT");
    verb->add_option("--frames", o.frames, "from A to B; all of the scene's if left out")
        ->type_name("A:B");
    verb->add_option("--epsilon", o.epsilon,
                     "how far a .glb may be from the scene at any time, in metres; 0.001 if left\n"
                     "out")
        ->type_name("E")
        ->check(not_empty);
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
        "  trivar replay snake.trivar --image snake.png --size 1920x1080\n"
        "  trivar replay snake.trivar --export snake.glb snake.obj\n"
        "  trivar replay ants.trivar --frame 48 --image ants_048.png\n"
        "  trivar replay snake.trivar --set terrain.obj=/data/alps.obj --image alps.png\n"
        "  trivar replay snake.trivar --epsilon 0.001 --export snake.glb\n"
        "  trivar replay snake.trivar --check          # status 3 if a digest differs\n\n"
        "Every file is whole or not there. Ctrl C ends it with status 130.");
    add_scene(*replay, o.scene);
    replay->add_option("--to", o.to, "stop after line N of the file")
        ->type_name("N")
        ->check(CLI::Range(1, 1 << 30));
    replay->add_option("--frame", o.frame, "what moves as it is in frame N; the first if left out")
        ->type_name("N")
        ->check(not_empty);
    replay->add_option("--export", o.exports, "write the result as .glb, .obj, .ply, .stl or .off")
        ->type_name("OUT");
    replay->add_option("--image", o.image, "draw a picture (.png, .jpg, .exr ...)")
        ->type_name("OUT");
    add_drawing(*replay, o.drawing);
    replay->add_flag(
        "--check", o.check,
        "compare with the digests in the file, and one thread with all of them, and\n"
        "say what is proven of each volume: where it folds, and where it meets itself");
    replay->add_flag("--digest", o.digest, "print the digests as a line to append to the scene")
        ->excludes("--frame");
    replay
        ->add_option("--epsilon", o.epsilon,
                     "split the triangles of all that lies in a volume until the surface is\n"
                     "certified to be within E metres; a .glb says so, see trivar verify")
        ->type_name("E")
        ->check(not_empty);
    replay->add_option("--timings", o.timings, "write how long each stage took, as JSON")
        ->type_name("OUT.json");
    add_threads(*replay, o.threads);
    return replay;
}

CLI::App* add_verify(CLI::App& app, VerifyOptions& o)
{
    CLI::App* verify = app.add_subcommand("verify", "check what an exported model claims");
    verify->description(
        "Runs the scene that a .glb was exported from and samples the file's triangles against\n"
        "the true surfaces: whether they are as near as the file says.");
    verify->footer("Examples:\n"
                   "  trivar verify snake.glb           # status 3 if they are not\n"
                   "  trivar verify out/snake.glb --log snake.trivar");
    verify->add_option("FILE", o.file, "as trivar export or replay --epsilon wrote it")
        ->required()
        ->type_name("FILE.glb");
    verify
        ->add_option("--log", o.log,
                     "the scene; the one that the file names, beside it, if left out")
        ->type_name("LOG");
    verify->add_option("--set", o.relinked, "use FILE where the scene names the file NAME")
        ->type_name("NAME=FILE")
        ->allow_extra_args(false);
    return verify;
}

CLI::App* add_info(CLI::App& app, InfoOptions& o)
{
    CLI::App* info = app.add_subcommand("info", "say what is in a file");
    info->description("Says what is in models, images and scenes.");
    info->footer("Example:\n  trivar info bunny.obj photo.png snake.trivar --json");
    info->add_option("FILE", o.files, "models, images, scenes")->required()->type_name("");
    info->add_flag("--json", o.json, "as JSON, for programs");
    return info;
}

CLI::App* add_commands(CLI::App& app, Choices& choices)
{
    CLI::App* commands = app.add_subcommand("commands", "list what a scene file may say");
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
        "Measures how fast vertices are deformed: by the processor and, in every way\n"
        "there is, by the graphics card, beside what copying and arithmetic allow.");
    bench->footer("Example:\n  trivar bench gpu --json > rates.json");
    bench->add_option("WHAT", o.what, "gpu")
        ->required()
        ->type_name("")
        ->check(CLI::IsMember({"gpu"}));
    bench->add_flag("--json", o.json, "as JSON, for programs");
    bench->add_option("--vertices", o.vertices, "measure with at most N vertices")
        ->type_name("N")
        ->check(CLI::Range(1, 10'000'000));
    bench->add_option("--seconds", o.most_s, "leave out what takes longer a run; 1 if left out")
        ->type_name("S")
        ->check(CLI::Range(0.001, 1000.0));
    bench->add_option("--minutes", o.minutes, "begin nothing later than this; 8 if left out")
        ->type_name("M")
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
    CLI::App app("Trivar lays deformable models on any scene with one stroke.\n\n"
                 "Without a command it opens the editor with the scenes and models given.",
                 "trivar");
    app.footer(
        "Examples:\n"
        "  trivar snake.trivar                                   open a scene\n"
        "  trivar terrain.obj snake.glb                          a new scene with two models\n"
        "  trivar replay snake.trivar --image snake.png          draw it without a window\n"
        "  trivar render ants.trivar --frames 1:240 --out ants/a.####.png      and its frames\n\n"
        "trivar COMMAND --help says more. Exit status: 0 done, 1 rejected, 2 wrong usage,\n"
        "3 a check failed, 130 stopped by Ctrl C.");
    app.add_option("FILE", choices.files, "scenes (.trivar) and models to open")->type_name("");
    add_shaders(app, choices.shaders);
    app.add_flag("--tell-steps", choices.tell_steps,
                 "say on standard output, before each frame of the window is shown, how many\n"
                 "steps it shows");
    app.set_version_flag("--version", "Trivar " + program_version(), "print the version and exit");
    app.require_subcommand(0, 1);
    const CLI::App* replay = add_replay(app, choices.replay);
    const CLI::App* render = add_render(app, choices.render);
    const CLI::App* exported = add_export(app, choices.exported);
    const CLI::App* verify = add_verify(app, choices.verify);
    const CLI::App* info = add_info(app, choices.info);
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
    } catch (const std::bad_alloc&) {
        streams.talk << "trivar: there is not enough memory for this\n";
    } catch (const std::exception& error) {
        streams.talk << "trivar: " << error.what() << "\n";
    }
    return Status::rejected;
}

} // namespace trivar
