// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/attachment_fields.h"
#include "core/document/fields/placement_fields.h"

namespace trivar {

struct Place {
    static constexpr std::string_view verb = "place",
                                      summary = "Lay an object along a stroke over the scene.";
    static constexpr CommandNature nature{.icon = CommandIcon::place,
                                          .asked = Invocation::by_actions};
    Id object = 0;
    Sketch sketch;
    PlacementParameters parameters;
    std::vector<Id> onto;
    std::optional<Attachment> attach = {};
    bool copy = false; // a copy of the object is laid, under the next id
    bool operator==(const Place&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of the object to place", required.names_object());
        field("camera", c.sketch.camera, "the view the stroke was drawn in", required);
        field("samples", c.sketch.samples, "the stroke, [x px, y px, seconds, pressure] each",
              required);
        field("parameters", c.parameters, "how it lies");
        field("onto", c.onto,
              "ids of objects to lie on; empty: every visible object that does not lie on it",
              any_value.names_object());
        field("attach", c.attach,
              "its hosts, with which it moves; left out: it stays in the world");
        field("copy", c.copy, "lay a copy of the object, which itself stays as it is");
    }
};
Document applied(Document document, const Place& command);
StepTitle title(const Place& c, const StepDocuments& step);

// Every visible object on which a stroke of this object could fall: no group, not the object
// itself, nor what lies on it.
std::vector<Id> possible_bases(const Document& document, Id id);

struct PlaceRound {
    static constexpr std::string_view verb = "place_round",
                                      summary = "Lay an object round a body, on a closed path: "
                                                "round a cylinder, a sphere, a torus or a Moebius "
                                                "band, or round anything where a plane cuts it.";
    static constexpr CommandNature nature{.icon = CommandIcon::place};
    Id object = 0, around = 0;
    double level = 0;
    PlacementParameters parameters;
    std::optional<glm::dvec3> normal = {};
    bool operator==(const PlaceRound&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of the object to lay down", required.names_object());
        field("around", c.around, "id of the object it goes round", required.names_object());
        field("level", c.level,
              "metres across from the widest circle of that object; with a plane, along its normal "
              "from "
              "the origin of that");
        field("parameters", c.parameters,
              "how it lies; springs, misses and clearance have no effect here");
        field("normal", c.normal,
              "normal of the plane that cuts it, in its own space; left out: round the Z axis of a "
              "cylinder, a sphere, a torus or a Moebius band");
    }
};
Document applied(Document document, const PlaceRound& command);
StepTitle title(const PlaceRound& c, const StepDocuments& step);

struct EditPlacement {
    static constexpr std::string_view verb = "edit_placement",
                                      summary = "Change how a placed object lies.";
    static constexpr CommandNature nature{.icon = CommandIcon::place};
    Id object = 0;
    PlacementParameters parameters;
    std::optional<Sketch> sketch;          // empty: the stroke stays
    std::optional<std::vector<Id>> onto;   // no value: unchanged; an empty list: chosen anew
    std::optional<Attachment> attach = {}; // no value: unchanged, but none for a new stroke
    bool operator==(const EditPlacement&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required.names_object());
        field("parameters", c.parameters, "all parameters; those left out have their defaults",
              required);
        field("sketch", c.sketch, "a new stroke; left out: as it was");
        field("onto", c.onto, "ids of objects to lie on; left out: as before; empty: chosen again",
              any_value.names_object());
        field("attach", c.attach,
              "its hosts, with which it moves; left out: as before, but none where the stroke is "
              "new");
    }
    // The command that changes nothing of the object; none: it has nothing of the kind.
    static std::optional<EditPlacement> as_it_is(const Object& object, Id id)
    {
        if (!object.stroke) return std::nullopt;
        return EditPlacement{id, object.stroke->parameters, {}, {}};
    }
};
Document applied(Document document, const EditPlacement& command);
StepTitle title(const EditPlacement& c, const StepDocuments& step);

struct Attach {
    static constexpr std::string_view verb = "attach",
                                      summary = "Attach placed objects to the objects they lie on, "
                                                "so that they move along. They stay in place.";
    static constexpr CommandNature nature{.icon = CommandIcon::place,
                                          .asked = Invocation::by_actions};
    Id object = 0;
    std::optional<Attachment> attach = {};
    bool operator==(const Attach&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required.names_object());
        field("attach", c.attach,
              "its hosts and where it lies on them; left out: all objects that it lies on, if none "
              "of them lies on a stroke itself");
    }
};
Document applied(Document document, const Attach& command);
StepTitle title(const Attach& c, const StepDocuments& step);

struct Unplace {
    static constexpr std::string_view verb = "unplace",
                                      summary =
                                          "Remove an object from its stroke; it is straight again.";
    static constexpr CommandNature nature{.icon = CommandIcon::place,
                                          .asked = Invocation::by_actions};
    Id object = 0;
    bool operator==(const Unplace&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id", required.names_object());
    }
};
Document applied(Document document, const Unplace& command);
StepTitle title(const Unplace& c, const StepDocuments& step);

} // namespace trivar
