// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/mistake.h"
#include "core/base/progress.h"
#include "core/commands/words/command_nature.h"
#include "core/commands/words/step_title.h"
#include "core/document/document.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace trivar {

class AssetStore;
template <class Shape> struct AddShape;
template <class Shape> struct SetShape;
template <class Of> struct OnObjects;

// A list of types with their numbers, 0, 1, ... The types need not be known.
template <class... All> struct Types {
    static constexpr std::size_t count = sizeof...(All);
    template <class T> static constexpr bool has = (std::is_same_v<T, All> || ...);
    template <class T> static constexpr std::size_t number()
    {
        std::size_t before = 0;
        (void)((std::is_same_v<T, All> || (++before, false)) || ...);
        return before;
    }
};

// The kinds of commands.
using CommandKinds = Types<
    struct ImportModel, struct EditImport, struct Relink, AddShape<PlaneShape>, AddShape<BoxShape>,
    AddShape<SphereShape>, AddShape<CylinderShape>, AddShape<TorusShape>, AddShape<MoebiusShape>,
    AddShape<TeapotShape>, AddShape<TextShape>, SetShape<TextShape>, struct SetTransform,
    struct Arrange, struct SetMaterial, struct ClearMaterial, struct Rename,
    OnObjects<struct OfHide>, struct Show, OnObjects<struct OfLock>, OnObjects<struct OfUnlock>,
    OnObjects<struct OfDelete>, struct Duplicate, struct Group, struct Ungroup, struct Reorder,
    struct Place, struct PlaceRound, struct EditPlacement, struct Unplace, struct SetTravel,
    struct PlayClip, struct Animate, struct Refine, OnObjects<struct OfClearRefine>,
    struct PressVolume, struct MovePoints, struct InsertKnots, struct CoarsenVolume,
    struct MendVolume, struct AllowFolds, struct Unshape, struct Paste, struct KeepView,
    struct ForgetView, struct SetRender, struct SetTime, struct AddLattice, SetShape<LatticeShape>,
    struct ConvertLattice, struct AddTetrahedra, SetShape<TetrahedraShape>, struct EditTetrahedra,
    struct RemoveTetrahedraEdit, AddShape<SimplexSheetShape>, SetShape<SimplexSheetShape>,
    struct WarpVolume, struct KeepShape, struct Simplify, OnObjects<struct OfClearSimplify>,
    struct SetWarp, struct Attach, struct SetParent, struct ApplyShape, struct PaintTiles,
    struct EditTileStroke, struct RemoveTileStrokes, struct SetTiles,
    OnObjects<struct OfClearTiles>, struct MixTiles, struct MorphTiles, struct CoverWithTiles,
    struct MaskTiles, struct RemoveTileMasks, AddShape<HeightShape>, SetShape<HeightShape>,
    struct Displace, AddShape<VoxelShape>, SetShape<VoxelShape>, struct Unwrap,
    OnObjects<struct OfClearUnwrap>, struct Shade, struct Split, OnObjects<struct OfClearSplit>,
    struct CutThrough, struct RemoveCut, OnObjects<struct OfClearCuts>, struct Incise,
    struct EditIncision, struct LayerIncisions, struct RemoveIncision,
    OnObjects<struct OfClearIncisions>, struct SwapIncisions, struct PeelFlap, struct LayFlap,
    struct SetLineDrawing, OnObjects<struct OfClearLineDrawing>, struct Bind>;

// A Command is everything that a person can do to a document, by value: a value of one of the
// kinds above. Copies share that value. Who names a kind includes the header of that kind alone;
// who does the same to all kinds includes every_command.h.
class Command {
public:
    template <class C>
    requires(CommandKinds::has<std::remove_cvref_t<C>>) Command(C&& command)
        : kind_(CommandKinds::number<std::remove_cvref_t<C>>()),
          value_(std::make_shared<std::remove_cvref_t<C>>(std::forward<C>(command)))
    {
    }
    Command(); // of the first kind
    bool operator==(const Command& other) const;

    std::size_t kind() const { return kind_; }
    template <class C> bool is() const { return kind_ == CommandKinds::number<C>(); }
    // The value of that kind; null: the command is of another kind.
    template <class C> const C* as() const
    {
        return is<C>() ? static_cast<const C*>(value_.get()) : nullptr;
    }
    // The same, to be changed; no other Command shares it then. The pointer holds until the command
    // is copied.
    template <class C> C* edit()
    {
        if (!is<C>()) return nullptr;
        if (value_.use_count() != 1) value_ = std::make_shared<C>(*as<C>());
        return static_cast<C*>(value_.get());
    }
    // The value of that kind. Throws Mistake where the command is of another kind.
    template <class C> const C& get() const
    {
        ensure(is<C>(), "a command of this kind");
        return *as<C>();
    }

private:
    std::size_t kind_;
    std::shared_ptr<void> value_;
};

// One command of each kind, in their order, with default fields.
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
