// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/base/ref.h"
#include "core/mesh/mesh.h"

#include <utility>

namespace trivar {

// A LaterMesh is a mesh that is there already, or that is made when somebody first asks for it.
class LaterMesh {
public:
    LaterMesh() = default;
    LaterMesh(Ref<Mesh> mesh) : mesh_(std::move(mesh)) {} // NOLINT: a Ref is one
    explicit LaterMesh(Lazy<Ref<Mesh>> made) : later_(std::move(made)), is_later_(true) {}

    // Null where neither was given.
    const Ref<Mesh>& ref() const { return is_later_ ? *later_ : mesh_; }
    operator const Ref<Mesh>&() const { return ref(); } // NOLINT: and it is one to whoever asks
    const Mesh& operator*() const { return *ref(); }
    const Mesh* operator->() const { return ref().get(); }
    bool ready() const { return !is_later_ || later_.ready(); } // true: ref() costs nothing

    // Asks for nothing: two that are not there yet are equal if they are copies of one.
    friend bool operator==(const LaterMesh& a, const LaterMesh& b)
    {
        if (a.ready() && b.ready()) return a.ref() == b.ref();
        return a.is_later_ && b.is_later_ && a.later_ == b.later_;
    }

private:
    Ref<Mesh> mesh_;
    Lazy<Ref<Mesh>> later_;
    bool is_later_ = false;
};

} // namespace trivar
