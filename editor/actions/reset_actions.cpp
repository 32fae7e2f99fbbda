// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/reset_actions.h"

#include "editor/editor.h"
#include "editor/tools/motion.h"

namespace trivar {
namespace {

template <glm::dvec3 Transform::*part> void reset(Editor& e)
{
    std::vector<Id> ids;
    std::vector<Transform> transforms;
    for (const Stand& stand : stands_of(e.session.document(), e.session.selected.ids())) {
        if (stand.transform.*part == Transform{}.*part) continue;
        ids.push_back(stand.id);
        transforms.push_back(stand.transform);
        transforms.back().*part = Transform{}.*part;
    }
    if (!ids.empty()) e.session.run(arranged(ids, transforms));
}

template <glm::dvec3 Transform::*part> bool can_be_reset(const Editor& e)
{
    for (const Stand& stand : stands_of(e.session.document(), e.session.selected.ids()))
        if (stand.transform.*part != Transform{}.*part) return true;
    return false;
}

template <glm::dvec3 Transform::*part> Action reset_action(const std::string& name, int key)
{
    return {"Reset",
            name,
            {{.key = key, .alt = true}},
            reset<part>,
            {can_be_reset<part>, "select an object where it was changed first"}};
}

} // namespace

void add_reset_actions(std::vector<Action>& a)
{
    a.push_back(reset_action<&Transform::translation>("Reset position", 'G'));
    a.push_back(reset_action<&Transform::rotation_deg>("Reset rotation", 'R'));
    a.push_back(reset_action<&Transform::scale>("Reset scale", 'S'));
}

} // namespace trivar
