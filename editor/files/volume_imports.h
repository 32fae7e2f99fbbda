// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <deque>
#include <functional>
#include <memory>
#include <string>

namespace trivar {

struct VolumeOffer;
template <class Shape> struct AddShape;
using AddVoxels = AddShape<VoxelShape>;

// VolumeImports reads volume data beside the window and keeps them until a person has decided
// whether they come into the scene.
class VolumeImports {
public:
    explicit VolumeImports(Session& session);
    ~VolumeImports();

    // Data that take more are offered coarsened.
    std::uint64_t memory_bytes;

    // Starts the job. `done` is called when it is over: with why the data could not be read, or
    // with nothing where they are offered now.
    void read(const std::string& path, std::function<void(const std::string& why)> done);
    VolumeOffer* offered()
    {
        return offers_.empty() ? nullptr : offers_.front().get();
    } // null: none
    bool offering() const { return !offers_.empty(); }
    // Counts up with every offer and every change of the first one by read_again().
    long number() const { return number_; }
    // Reads the first one again, with the reading that its command has now.
    void read_again();
    bool reading_again() const { return again_; }
    void add();   // the first one comes into the scene, in one step, and the view shows it
    void leave(); // the first one does not
    void poll();  // once a frame: the view goes to what came

private:
    void run(const AddVoxels& command);
    Session* session_;
    std::deque<std::unique_ptr<VolumeOffer>> offers_;
    long number_ = 0;
    bool again_ = false;
    Id to_frame_ = 0;
};

} // namespace trivar
