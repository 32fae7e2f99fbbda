// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <vector>

namespace trivar {

// A Selection holds the chosen objects in the order in which they were chosen. The last one is the
// active one: the inspector shows it, and others are aligned to it. Where one object is meant the
// selection reads as the active one's id, and an assigned id becomes the whole selection; 0: none.
class Selection {
public:
    operator Id() const { return active(); } // NOLINT(google-explicit-constructor)
    Selection& operator=(Id id);
    bool operator==(const Selection&) const = default;

    Id active() const { return ids_.empty() ? 0 : ids_.back(); }
    const std::vector<Id>& ids() const { return ids_; }
    std::size_t size() const { return ids_.size(); }
    bool contains(Id id) const;
    std::vector<Id> but_the_active() const; // the others, in their order

    void set(const std::vector<Id>& ids); // one that is named twice counts once
    void add(const std::vector<Id>& ids); // the last of them becomes the active one
    void toggle(Id id);                   // one that is added becomes the active one
    void keep_those_in(const Document& document);

private:
    std::vector<Id> ids_;
};

// Members tells which objects are chosen or lie in a chosen group, at any depth. An object that the
// document does not have (the picture may be older) is none of them.
class Members {
public:
    Members(const Document& document, const std::vector<Id>& ids);
    bool contain(Id id) const; // O(depth log #ids)

private:
    const Document* document_;
    std::vector<Id> ids_; // ascending
};

// Returns the objects without a selected group above them, in their order: edits of a group apply
// to its contents.
std::vector<Id> topmost(const Document& document, const std::vector<Id>& ids);

} // namespace trivar
