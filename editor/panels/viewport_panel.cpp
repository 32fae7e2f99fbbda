// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/commands/objects/import.h"
#include "core/commands/tiles/tile_files.h"
#include "editor/hands/model_tool.h"
#include "editor/panels/panels.h"
#include "editor/picture/volume_facts.h"
#include "editor/viewport/lines_at_rest.h"
#include "editor/viewport/refined_view.h"
#include "editor/viewport/way_comparison.h"
#include "gpu/renderer.h"

#include "core/base/memory.h"
#include "core/base/text.h"
#include "editor/actions/model_actions.h"
#include "editor/actions/start_card.h"
#include "editor/panels/camera_frame.h"
#include "editor/panels/foot_cards.h"
#include "editor/picture/captions.h"
#include "editor/picture/tetrahedra_picture.h"
#include "editor/picture/volume_picture.h"
#include "editor/record/record_plan.h"
#include "editor/session/scene_facts.h"
#include "editor/session/session_facts.h"
#include "editor/words/file_words.h"
#include "ui/icons.h"
#include "ui/timing_overlay.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <optional>

namespace trivar {
namespace {

// Adds the edges of lattices, which have no surface, and the sides of selected ones.
void add_lattices(std::vector<gpu::Line>& lines, const Session& session, const ui::Theme& theme)
{
    constexpr std::size_t most_points = 20000; // the sides of more are no net any more
    constexpr ShellLook selected, many{.sides = 0}, other{.edges = 0.3f, .sides = 0};
    for (const auto& [id, each] : session.evaluated().objects) {
        if (!each->placement || !is_lattice(session.document(), id) ||
            std::ranges::binary_search(session.hidden_here, id))
            continue;
        const Ref<Lattice> cage = each->seen_cage();
        const Lattice& volume = *cage;
        const ShellLook& look = !session.selected.contains(id)                    ? other
                                : volume.displacement.points.size() > most_points ? many
                                                                                  : selected;
        std::ranges::move(shell_lines(volume, theme.color.lattice, theme.line(1), look),
                          std::back_inserter(lines));
    }
}

// Nor have tetrahedra: all edges while they are selected, else those of the border.
void add_tetrahedra(std::vector<gpu::Line>& lines, Editor& editor, const ui::Theme& theme)
{
    const Session& session = editor.session;
    auto& lines_of = editor.memory.of<TetrahedraLines>();
    for (const auto& [id, each] : session.evaluated().objects)
        if (each->tetrahedra && !std::ranges::binary_search(session.hidden_here, id))
            std::ranges::copy(
                lines_of(*each, theme.color, theme.line(1), session.selected.contains(id)),
                std::back_inserter(lines));
}

// Where the picture shows volumes it shows those of lattices too.
bool picture_shows_volumes(const Session& session)
{
    return session.document().render->volumes || session.shown().render->volumes;
}

// The selected object whose volume is seen; null: there is none.
const EvaluatedObject* with_shown_volume(const Editor& editor)
{
    const Session& session = editor.session;
    const ToolState tool = editor.active_tool().state();
    const auto found = session.evaluated().objects.find(session.selected);
    if (found == session.evaluated().objects.end() || !found->second->placement ||
        (tool.busy && !tool.shows_volume_at_work) ||
        std::ranges::binary_search(session.hidden_here, found->first))
        return nullptr;
    return found->second.get();
}

// Returns the helper lines of the selection and of the tool at work.
Helpers helpers_of(Editor& editor, const ui::Theme& theme)
{
    Helpers helpers = editor.active_tool().helpers(editor.session, theme);
    if (!picture_shows_volumes(editor.session)) {
        add_lattices(helpers.lines, editor.session, theme);
        add_tetrahedra(helpers.lines, editor, theme);
    }
    const EvaluatedObject* const found = with_shown_volume(editor);
    if (!found || picture_shows_volumes(editor.session)) return helpers;
    const Placement& placement = *found->placement;
    if (is_lattice(editor.session.document(), found->id)) {
        helpers.veils.push_back(shell_veil(*found->seen_cage(), theme.color));
    } else {
        std::ranges::move(placement_lines(placement, theme.color, theme.line(1)),
                          std::back_inserter(helpers.lines));
        helpers.veils.push_back(placement_veil(placement, theme.color));
    }
    for (const gpu::Translucent& veil : editor.viewport.volume_facts().folds(*found, theme.color))
        helpers.veils.push_back(veil);
    for (gpu::Translucent& veil : editor.viewport.volume_facts().meeting(*found, theme.color))
        helpers.veils.push_back(std::move(veil));
    return helpers;
}

// Words how many tiles are seen, with how many vertices, and by which levels of detail, from the
// finest on: a line each; empty: there are none.
std::string drawn_words(const gpu::TileCounts& counts)
{
    if (counts.tiles == 0) return {};
    std::string levels;
    for (const std::size_t drawn : counts.by_level)
        levels += (levels.empty() ? "" : " / ") + with_commas(drawn);
    return fmt::format("{} of {} tiles seen, {} hidden, {} outside\n"
                       "{} of {} vertices\n"
                       "By level of detail: {}",
                       with_commas(counts.drawn), with_commas(counts.tiles),
                       with_commas(counts.hidden), with_commas(counts.outside()),
                       with_commas(counts.vertices), with_commas(counts.all_vertices), levels);
}

// Says that most of the scene is left out, and how it comes back.
std::string hidden_here_words(const Editor& editor)
{
    const Session& session = editor.session;
    if (session.hidden_here.empty()) return {};
    std::vector<Id> shown;
    for (const auto& [id, each] : session.evaluated().objects)
        if (!each->shows_nothing() && !std::ranges::binary_search(session.hidden_here, id))
            shown.push_back(id);
    const std::string key = key_text(action(editor, isolate_action));
    const std::string back = "  ·  " + (key.empty() ? "Isolate" : key) + " to exit";
    if (shown.empty()) return "The isolated objects are hidden" + back;
    const std::string what = shown.size() == 1 ? name_of(session.document(), shown.front())
                                               : std::to_string(shown.size()) + " objects";
    return "Isolated: " + what + back;
}

gpu::DeformBy deform_by(const Preferences& preferences)
{
    return gpu::deform_named(preferences.deform).value_or(gpu::usual_deform_by());
}

// Returns where the card of times lies, if it does.
std::optional<ui::Rect> labels(Editor& editor, const ui::Theme& theme, ui::Frame& frame,
                               const FootCards& foot)
{
    const ui::Rect& view = foot.view();
    const Session& session = editor.session;
    const std::string name = name_of(session.document(), session.selected);
    const Camera& camera = session.view.camera;
    const Viewpoint* side = camera.perspective ? nullptr : viewpoint_of(camera);
    std::string label = camera.perspective ? "Perspective"
                        : side             ? std::string(side->name) + " orthographic"
                                           : "Orthographic";
    const auto add = [&](const std::string& words) { label += "  ·  " + words; };
    if (session.view.follows && session.view.follows->shown)
        add(session.view.follows->name == "picture" ? "Render camera" : session.view.follows->name);
    if (editor.shading.wireframe)
        add("Wireframe");
    else if (editor.shading.see_through)
        add("X-ray");
    if (editor.shading.edges && !editor.shading.wireframe) add("Edges");
    if (session.previewing())
        add("Preview of a step");
    else if (!name.empty())
        add(name);
    if (const std::string words = editor.viewport.refined().words(frame.time_s); !words.empty())
        add(words);
    if (const std::string words = editor.viewport.lines_at_rest().words(); !words.empty())
        add(words);
    glm::vec2 at = view.lo + theme.px(12);
    // The axes stand at the right.
    const float room = view.width() - theme.px(has_room_for_axes(theme, view) ? 12 + 130 : 40);
    ui::paint_chip(theme, at, {ui::elided(theme.font.small, label, room)});
    at.y += theme.px(28);
    if (const std::string words = hidden_here_words(editor); !words.empty()) {
        ui::paint_chip(theme, at, {ui::elided(theme.font.small, words, room)});
        at.y += theme.px(28);
    }
    Viewport& shown = editor.viewport;
    if (const EvaluatedObject* volume = with_shown_volume(editor))
        for (const FoldMark& mark : shown.volume_facts().fold_marks(*volume, theme.color)) {
            ui::paint_chip(theme, at, {ui::elided(theme.font.small, mark.words, room), mark.color});
            at.y += theme.px(28);
        }
    if (shown.drafts().count() == 0) return {};
    if (!editor.preferences.show_timing && !editor.timing.open) return {};
    ui::TimingSources sources{shown.drafts(), session.timings(), shown.full_timings()};
    if (const gpu::Renderer* renderer = shown.renderer()) {
        sources.uploaded_bytes = renderer->uploaded_bytes();
        sources.drawn = drawn_words(renderer->tile_counts());
    }
    if (editor.timing.open) {
        sources.program_bytes = resident_bytes();
        sources.ways = shown.ways().rows(session.evaluated(), deform_by(editor.preferences));
    }
    const float edge = theme.px(12);
    const ui::Rect above_cards = foot.above(at.x, at.x + theme.px(340));
    const std::optional<ui::Rect> card =
        ui::draw_timing(theme, {at, above_cards.hi - edge}, sources, editor.timing,
                        key_text(action(editor, "Timing")));
    if (editor.timing.other_way)
        editor.preferences.deform = gpu::deform_names[*editor.timing.other_way];
    if (editor.timing.measure_ways) shown.ways().begin();
    shown.ways().advance(session.evaluated(), session.document(), shown.shaders());
    if (shown.ways().running() || editor.timing.measure_ways) frame.again_in(0);
    return card;
}

// The notice about what is wrong with the picture, as long as it is.
void tell(ui::Notices& notices, const std::optional<std::string>& trouble, const char* title)
{
    if (!trouble) return;
    notices.forget(title); // a topic of its own
    if (trouble->empty()) return;
    notices.say(ui::NoticeKind::error, title, *trouble, title);
    notices.keep(title);
}

constexpr double patience_s = 0.25; // quick work does not flicker

ui::ProgressCard progress_card(const ui::Theme& theme, const FootCards& foot,
                               const std::string& what, const std::string& stage, double fraction)
{
    const ui::Rect across = ui::progress_place(theme, foot.view());
    const ui::Rect room = foot.above(across.lo.x, across.hi.x);
    const bool ends = fraction >= 1; // what was read is taken in
    return ui::draw_progress(theme, room, what, ends ? "Finishing" : stage, ends ? -1 : fraction);
}

std::optional<ui::Rect> export_progress(Editor& editor, ui::Frame& frame, const FootCards& foot)
{
    const auto job = editor.frames_export.status();
    if (!job) return {};
    frame.again_in(patience_s);
    if (job->seconds <= patience_s) return {};
    const ui::ProgressCard card =
        progress_card(frame.theme, foot, job->what, job->stage, job->fraction);
    if (card.cancelled) editor.frames_export.stop();
    return card.rect;
}

// Long work is said after a moment. Where, if it is.
std::optional<ui::Rect> progress(Editor& editor, ui::Frame& frame, const FootCards& foot)
{
    const auto draw = [&](const std::string& what, const std::string& stage, double fraction) {
        return progress_card(frame.theme, foot, what, stage, fraction);
    };
    editor.picture_to_file.advance(editor.session, frame, editor.viewport.shaders());
    if (editor.picture_to_file.running()) {
        const std::string name = file_name(editor.picture_to_file.path());
        const ui::ProgressCard card = draw("Rendering " + name, {}, -1);
        if (card.cancelled) editor.picture_to_file.stop();
        return card.rect;
    }
    if (const auto job = editor.session.jobs().status()) {
        frame.again_in(patience_s);
        if (job->seconds <= patience_s) return {};
        const ui::ProgressCard card = draw(job->what, job->stage, job->fraction);
        if (card.cancelled) editor.session.jobs().cancel();
        return card.rect;
    }
    const BackgroundEvaluator::Status status = editor.session.evaluator().status();
    if (!status.busy) return {};
    frame.again_in(patience_s);
    if (status.seconds <= progress_shown_s || editor.active_tool().busy()) return {};
    const ui::ProgressCard card = draw("Working on the scene", status.stage, status.fraction);
    if (card.cancelled) editor.session.evaluator().cancel();
    return card.rect;
}

constexpr const char* viewport_menu = "viewport menu";

// Opens the menu of the object under the mouse, which is selected for it, or of the selection that
// holds it.
void open_menu(Session& session, const ViewportInput& input)
{
    const std::vector<Id> under = input.seen_in(input.mouse, input.mouse);
    const Id id = under.empty() ? 0 : under.front();
    if (id == 0 || !session.selected.contains(id)) session.selected = id;
    ImGui::OpenPopup(viewport_menu);
}

// A hand that begins something of its own, or pictures that come slowly, end what is being shown.
void show_tutorial(Editor& editor, ui::Frame& frame)
{
    constexpr double slow_ms = 300;
    const bool at_once = editor.preferences.reduced_motion || editor.active_tool().busy() ||
                         editor.viewport.drafts().median_ms() > slow_ms;
    if (editor.tutorial.advance(editor.session, frame.time_s, at_once)) frame.again_in(0);
}

} // namespace

void draw_viewport(Editor& editor, ui::Frame& frame, const Layout& layout)
{
    const ui::Theme& theme = frame.theme;
    const ui::Rect& view = layout.view;
    Session& session = editor.session;
    begin_panel("viewport", view, theme.color.sky_bottom);
    const glm::ivec2 size_px = glm::max(glm::ivec2(view.size()), 1);
    const ImVec2 lo{view.lo.x, view.lo.y}, hi{view.hi.x, view.hi.y};

    ui::lower_area("picture", view,
                   ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                       ImGuiButtonFlags_MouseButtonRight);
    show_tutorial(editor, frame);
    const RecordPlan& plan = editor.memory.of<RecordDialog>().plan;
    session.view.picture_px = {plan.width_px, plan.height_px};
    Tool& tool = editor.active_tool();
    const ViewportInput input = editor.viewport.take_input(session, frame, view, tool);
    if (!editor.files.asking()) tool.use(session, input);
    ModelTool* models = tool.models();
    if (const auto file = models ? models->take_wanted() : std::nullopt) {
        const OwnModel* own = own_model_named_as(editor.files, *file);
        editor.files.read_model(
            *file,
            [models, &session](const ImportModel& import) {
                models->take_read(session, {import.file, import.name});
            },
            own ? own->name : "");
    }
    const ToolState state = tool.state();
    if ((input.down && state.busy) || editor.viewport.moves_camera()) ui::hands().may_hold_on();
    if (session.committing() || state.waits) ui::hands().hold_back(input.hovered);
    if (input.hovered && state.crosshair) ImGui::SetMouseCursor(ImGuiMouseCursor_NotAllowed);
    // A small window's picture must not jump: the picture is drawn after the camera moved.
    const bool moving = state.busy || editor.inspecting || !session.up_to_date() ||
                        (editor.playback.playing() && moves_in_time(session.shown()));
    VolumeFacts& facts = editor.viewport.volume_facts();
    const int shown =
        ((static_cast<int>(editor.tool) * 2 + (state.busy ? 1 : 0)) * 4 + facts.known()) * 0x10000 +
        state.mode;
    const bool as_in_pictures = editor.preferences.backdrop_as_in_pictures;
    const ui::Theme over = theme_over_picture(theme, *session.document().render, as_in_pictures);
    ViewportStyle style = viewport_style(over, as_in_pictures);
    style.level = gpu::level_named(editor.preferences.quality).value_or(gpu::Level::standard);
    style.deform_by = deform_by(editor.preferences);
    session.deform_on_processor = style.deform_by == gpu::DeformBy::processor;
    style.grid = editor.preferences.grid;
    const std::optional<double> pace = parse_number(editor.preferences.pace); // pictures a second
    style.draft_ms = pace ? 1000 / *pace : 0;
    style.shading = editor.shading;
    style.at_limits = heights_in_hand(session);
    editor.viewport.set_style(style);
    RefinedView& refined = editor.viewport.refined();
    refined.follow(session, parse_number(editor.preferences.view_tolerance).value_or(0), moving,
                   frame.time_s);
    constexpr double look_again_s = 0.3;
    if (!refined.up_to_date()) frame.again_in(look_again_s);
    const unsigned texture = editor.viewport.draw(session, frame, size_px, moving, shown,
                                                  [&] { return helpers_of(editor, over); });
    if (const std::string notice = editor.viewport.new_notice(); !notice.empty())
        session.notices.say(ui::NoticeKind::warning, "Deformed by the processor", notice);
    tell(session.notices, editor.viewport.new_trouble(), "The picture is out of date");
    tell(session.notices, editor.viewport.new_shader_trouble(), "A shader could not be updated");
    constexpr double soon_s = 0.05;
    if (facts.busy()) frame.again_in(soon_s);
    const auto name = static_cast<std::uintptr_t>(texture);
    if (texture != 0)
        ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(name), lo, hi, {0, 1},
                                             {1, 0});
    draw_camera_frame(editor, over, view);
    if (session.shown().render->captions) { // they count the triangles of the document
        std::vector<Id> hidden_here = refined.split(session.evaluated());
        hidden_here.insert(hidden_here.end(), session.hidden_here.begin(),
                           session.hidden_here.end());
        std::ranges::sort(hidden_here);
        paint_captions(captions_of(session.evaluated(), session.shown(), hidden_here), view,
                       session.view.camera, over);
    }
    tool.overlay(session, over, input);
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Right)) {
        if (input.hovered && !tool.busy() && !editor.right_cancelled) open_menu(session, input);
        editor.right_cancelled = false;
    }
    draw_object_menu(editor, theme, viewport_menu);
    draw_add_menu(editor, theme);
    draw_bind_menu(editor, theme);
    const bool welcome = !editor.tutorial.runs(session) && shows_welcome(editor);
    FootCards foot(view);
    if (editor.tutorial.runs(session))
        foot.add(draw_tutorial(editor, frame, view));
    else if (welcome)
        draw_welcome(editor, theme, view);
    else {
        const std::optional<ui::Rect> hint = draw_hint_card(editor, theme, view);
        // While a model comes in there is no card, and what comes is framed above the next one.
        if (hint || (!session.jobs().status() && session.up_to_date()))
            session.view.foot_px = hint ? view.hi.y - hint->lo.y : 0;
        foot.add(hint);
    }
    editor.recording.advance(frame, editor.viewport.shaders());
    foot.add(draw_recording(editor, theme, foot));
    foot.add(export_progress(editor, frame, foot));
    foot.add(progress(editor, frame, foot));
    if (!welcome) foot.add(draw_tile_library(editor, theme, foot));
    foot.add(draw_legend(session, theme, foot));
    draw_adjustment(editor, theme, foot);
    std::optional<ui::Rect> times;
    if (!welcome) times = labels(editor, theme, frame, foot);
    if (editor.preferences.show_axes && !welcome) draw_navigation(editor, theme, view, times);
    if (session.auto_key) ui::paint_rim(view, theme.color.bad, 0, 2 * theme.scale);
    ImGui::End();
    const float notices = ui::Notices::left_of(theme, view); // cover no card's buttons
    session.notices.draw(frame, foot.above(notices, view.hi.x));
}

} // namespace trivar
