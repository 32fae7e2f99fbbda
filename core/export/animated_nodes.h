// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film_certificate.h"
#include "core/certificate/kept_clip.h"
#include "core/certificate/target_keys.h"
#include "core/export/curve_strips.h"

namespace trivar {

// Returns whether the part is shown, at each moment.
std::vector<bool> shown_at(const FilmStrip& strip);

// AnimatedNodes puts strips into a model, each at a node of its own, and says how near the model is
// to the scene.
class AnimatedNodes {
public:
    AnimatedNodes(const Film& film, const Document& document, const AssetStore& assets,
                  std::vector<float> times_s, double tolerance);

    // Adds a strip that rests, moves as a whole or is posed; false where nodes cannot express that,
    // because it shears.
    bool add_moving(const FilmStrip& strip, FilmCertificate::PartClaim& claim);
    void add_targets(const FilmStrip& strip, TargetKeys&& keys, FilmCertificate::PartClaim& claim);
    // Adds curves that rest or move as a whole; false where they do neither.
    bool add_curves(const CurveStrip& strip);
    // Adds the render camera, if the scene has one. Returns a sentence on the part of its motion
    // that the format cannot hold; empty: none.
    std::string add_camera();
    Model finished();

private:
    int node(const std::string& name, int parent);
    int group(Id id);
    // The node that holds the parts of an object: its own, or if it has only one part, its group's.
    int home(Id object);
    std::string name_of(const FilmStrip& strip) const; // its node's
    // The node for something that is shown only at some moments; or else the parent.
    int holder(int parent, const std::string& name, const std::vector<bool>& shown);
    std::uint32_t first_material(const Ref<std::vector<Material>>& materials);
    int mesh(const FilmStrip& strip, Mesh mesh);
    // A Tree is the nodes of an object's model below one node for the object, with the same
    // parents.
    struct Tree {
        Ref<Model> from;    // null: the model has only one node, and no clips
        bool whole = false; // false: it shears and was not added
        int object = 0;     // the object's node
        int first = 0;      // the node for the model's first node; the others follow in their order
        std::vector<int> with_mesh;       // the model's nodes with a mesh, by PartKey::mesh
        FilmCertificate::PartClaim claim; // on the motion of the object
        std::map<int, int> skins;         // by the model's number
    };
    // Whether a strip is a part of its object's model as it is, which moves with the model's nodes.
    bool is_of_its_model(const FilmStrip& strip) const;
    Tree& tree(const FilmStrip& strip);
    void add_clip(Tree& tree, const Object& source);
    bool add_motion_of_object(Tree& tree, const FilmStrip& strip);
    void hang(const FilmStrip& strip, Tree& tree, FilmCertificate::PartClaim& claim);
    int skin(Tree& tree, int index);
    bool add_motion(int node, const std::vector<glm::dmat4>& matrices, const Box& box,
                    FilmCertificate::PartClaim& claim);
    // A value per moment; where the object is not shown, that of the moment before, or the first
    // one.
    template <class Value>
    std::vector<Value> each_moment(const FilmStrip& strip, const auto& value) const;

    const Film& film_;
    const Document& document_;
    const AssetStore& assets_;
    std::vector<float> times_s_;
    double tolerance_;
    Model model_;
    Clip clip_;
    std::map<Id, int> groups_; // and of objects with several parts
    std::map<Id, Tree> trees_;
    std::map<Ref<std::vector<Material>>, std::uint32_t> first_material_; // looked up only
};

} // namespace trivar
