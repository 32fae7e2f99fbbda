// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/bind.h"
#include "core/commands/cutting/cut.h"
#include "core/commands/cutting/incise.h"
#include "core/commands/cutting/peel.h"
#include "core/commands/cutting/split.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/keep_shape.h"
#include "core/commands/objects/line_drawing.h"
#include "core/commands/objects/material.h"
#include "core/commands/objects/play.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/shade.h"
#include "core/commands/objects/shape.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/objects/text.h"
#include "core/commands/objects/unwrap.h"
#include "core/commands/objects/view.h"
#include "core/commands/objects/voxels.h"
#include "core/commands/paste.h"
#include "core/commands/placement/apply_shape.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/commands/volumes/convert_lattice.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/tetrahedra.h"
#include "core/commands/volumes/warp.h"
#include "core/document/asset_store.h"

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace trivar {

template <class T, class Variant> inline constexpr bool is_one_of = false;
template <class T, class... All>
inline constexpr bool is_one_of<T, std::variant<All...>> = (std::is_same_v<T, All> || ...);

using AnyCommand = std::variant<
    ImportModel, EditImport, Relink, AddPlane, AddBox, AddSphere, AddCylinder, AddTorus, AddMoebius,
    AddTeapot, AddText, SetText, SetTransform, Arrange, SetMaterial, ClearMaterial, Rename, Hide,
    Show, Lock, Unlock, Delete, Duplicate, Group, Ungroup, Reorder, Place, PlaceRound,
    EditPlacement, Unplace, SetTravel, PlayClip, Animate, Refine, ClearRefine, PressVolume,
    MovePoints, InsertKnots, CoarsenVolume, MendVolume, AllowFolds, Unshape, Paste, KeepView,
    ForgetView, SetRender, SetTime, AddLattice, SetLattice, ConvertLattice, AddTetrahedra,
    SetTetrahedra, EditTetrahedra, RemoveTetrahedraEdit, AddSimplexSheet, SetSimplexSheet,
    WarpVolume, KeepShape, Simplify, ClearSimplify, SetWarp, Attach, SetParent, ApplyShape,
    PaintTiles, EditTileStroke, RemoveTileStrokes, SetTiles, ClearTiles, MixTiles, MorphTiles,
    CoverWithTiles, MaskTiles, RemoveTileMasks, AddHeights, SetHeights, Displace, AddVoxels,
    SetVoxels, Unwrap, ClearUnwrap, Shade, Split, ClearSplit, CutThrough, RemoveCut, ClearCuts,
    Incise, EditIncision, LayerIncisions, RemoveIncision, ClearIncisions, SwapIncisions, PeelFlap,
    LayFlap, SetLineDrawing, ClearLineDrawing, Bind>;

// A Command is everything that a person can do to a document, by value. It is a variant and is
// visited as one; copying and comparing it is compiled once, and not wherever a command is copied.
struct Command : AnyCommand {
    template <class C>
    requires is_one_of<std::remove_cvref_t<C>, AnyCommand> Command(C&& command)
        : AnyCommand(std::in_place_type<std::remove_cvref_t<C>>, std::forward<C>(command))
    {
    }
    Command();
    Command(const Command&);
    Command(Command&&) noexcept;
    Command& operator=(const Command&);
    Command& operator=(Command&&) noexcept;
    ~Command();
    bool operator==(const Command&) const;
};
constexpr std::size_t command_count = std::variant_size_v<AnyCommand>;
template <std::size_t I> using CommandAt = std::variant_alternative_t<I, AnyCommand>;

// One command of each kind in the variant's order, with default fields.
std::vector<Command> every_command();

// Throws Rejected, naming the field, unless every number is finite and within its rule, every text
// is UTF-8 of sensible length and one of its choices, and no list is absurdly long. It does not
// look at a document.
void check(const Command& command);

// Does check() and, for the kinds of commands that have one, check_effect(), which throws Rejected
// for a command that would do nothing in this document. after() takes such a command, because older
// scenes hold some; new commands are checked first.
void check_new(const Document& document, const Command& command);

// The document after the command; objects that the command does not touch keep their pointer. Pure:
// reads no file. Throws Rejected (the field, what is wrong, what would be right), and nothing
// happened. The id of a new object is the old document's next_id.
Document after(const Document& document, const Command& command);

// The title of a step in the words of the panels: what changed, and not the whole value that the
// command holds. Pure: `before` is the document before the command, `after` the one after it.
StepTitle step_title(const Command& command, const Document& before, const Document& after);

CommandNature nature_of(const Command& command);

// Fills in what a document cannot know before a command is proposed: for an import and its edit the
// hash, the path relative to the store's folder and the name. Throws Rejected if the file cannot be
// read.
Command prepare(Command command, const AssetStore& assets, const Progress& progress = {});

// One line of JSON without its line break: {"do":"rename","object":3,"name":"Snake"}. Every field
// is written, numbers as the shortest decimals that read back as the same bits.
std::string to_json_line(const Command& command);
// Reads strictly: unknown verbs and fields, missing required fields, wrong types and numbers out of
// range are Rejected by the field's name.
Command command_from_json_line(std::string_view line);

std::string_view verb(const Command& command);

// The reference of all commands with their fields, defaults and ranges; the text form says only
// what each command does and takes.
std::string commands_text();
std::string commands_markdown();
std::string commands_json();

} // namespace trivar
