// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/files/volume_imports.h"
#include "editor/session/recovery.h"
#include "ui/dialog.h"
#include "ui/file_dialog.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

const std::vector<std::string>& model_extensions(); // that can be imported
bool is_model(const std::string& path);             // of a file, by its extension
bool is_picture(const std::string& path);           // of a file, by its extension
const std::vector<std::string>& export_extensions();
const std::vector<std::string>& image_extensions(); // that can be read as masks and heights
inline constexpr const char* scene_extension = ".trivar";

// Files is everything that a person reads and writes: dialogs, drops, questions. Reading and
// writing run as jobs; a file that cannot be read changes nothing.
class Files {
public:
    Files(Session& session, Recovery& recovery);

    void new_scene(std::function<void()> then = nullptr);
    void recover(); // the scene without a name that an ended program left
    void ask_open();
    void ask_discarded(); // which of them comes back
    void ask_import();
    // A picture; `then` is called with its path.
    void ask_image(const std::string& title, std::function<void(const std::string&)> then);
    void ask_relink(Id object);                    // another file for an imported model
    void ask_missing();                            // for the first whose file is not there
    void ask_export(const std::string& path = {}); // to that file, at first
    void save(); // a scene with a name is on disk already: says so; else asks for one
    void ask_save_as();
    void ask_save_compact();
    void save_numbered_copy(); // beside the scene, which stays what is worked on
    void collect();            // every model's file into NAME.assets beside the scene
    void open_scene(const std::string& path); // asks first if the present one has no name
    // Opens a copy, and the file stays unchanged; `then` is called when the copy is the scene.
    void open_copy(const std::string& path, std::function<void()> then);
    // Imports a model, or reads volume data, which are offered then. The first model of a scene is
    // framed, and with `frame_all` the whole scene. `then` is called with the id of the model when
    // it is there. `name`: of the object; empty: the file's.
    void import(const std::string& path, bool frame_all = false,
                std::function<void(Id)> then = nullptr, std::string name = {});
    // Reads a model that somebody else brings into the scene: `take` is called with its import.
    void read_model(const std::string& path, std::function<void(const ImportModel&)> take,
                    std::string name = {});
    // Writes what is visible, as committed; with a certificate where something is refined. With
    // instances, a .glb has one mesh per tile type.
    void write_lines_to(const std::string& path);
    void write_model_to(const std::string& path, bool instances = false);
    // Scenes open, models are imported, a picture is used.
    void take_dropped(const std::vector<std::string>& paths);
    // The same in the next frame in which no dialog or menu is open.
    void drop(const std::vector<std::string>& paths);
    void ask_close();

    void draw(const ui::Theme& theme); // whatever is asked at present
    // Whether a scene is being read that replaces the present one: keys do not count for the
    // present one then.
    bool opening() const { return !opening_.expired(); }
    bool asking() const; // something is asked, or a scene is being read
    bool close_agreed() const { return close_agreed_; }
    VolumeImports volumes;

    // Scenes to try, offered over an empty viewport: a copy is opened, they stay unchanged.
    std::vector<std::string> samples;
    std::string own_models_folder; // of the models that come with the program; empty: not found
    // Copied from the preferences: the folders in which dialogs begin that have no better place,
    // and whether it is asked what becomes of a scene without a name.
    std::string scenes_folder, models_folder;
    // Uses a picture that was dropped on the window.
    std::function<void(const std::string&)> use_dropped_image;
    bool ask_to_keep = true;

private:
    enum class Purpose { open, take_up, import, image, relink, write_model, save_as, save_compact };
    // A Batch is files that came together: what cannot be read of them is told once, at the end.
    struct Batch {
        std::size_t coming = 0;
        struct LostFile {
            std::string name, why;
        };
        std::vector<LostFile> lost;
        std::function<void(Id)> then = nullptr; // for each that came
        std::string name = {};                  // of each object; empty: its file's
    };
    struct PendingQuestion {
        ui::Question question;
        std::function<void(int)> answer;
    };
    struct Present { // how far the present scene is
        long scene = 0;
        std::size_t lines = 0;
        bool operator==(const Present&) const = default;
    };
    Present present() const { return {session_->scenes(), session_->scene().lines().size()}; }
    void open(const std::string& path, bool copy, std::function<void()> then);
    SceneFile read_scene(const std::string& path, bool copy) const;
    // Takes in a scene that was read; asks once more if something was done since the request.
    void take_opened(const Present& since, const std::shared_ptr<SceneFile>& scene,
                     const std::function<void()>& then);
    void show(SceneFile scene); // where it is a copy, its notice offers to save it
    void
    ask_how_to_open(const std::shared_ptr<SceneFile>& copy); // of a file that is open elsewhere
    void ask_for_file(Purpose purpose, ui::FileRequest request);
    void use_file(const std::string& path);
    void read_model_of(const std::string& path, bool frame_all,
                       const std::shared_ptr<Batch>& batch);
    void read_volume_of(const std::string& path, const std::shared_ptr<Batch>& batch);
    // The notices of its reader are told once it was taken, where `take` says that it was.
    void read_in_background(const std::string& path, const std::string& name,
                            std::function<bool(const ImportModel&)> take,
                            std::function<void(const std::string& why)> lost);
    void tell_lost(Batch& batch); // when the last of them is there
    // Once imported models are in the picture: offers to scale what is far larger or smaller than
    // what was there, and to frame what cannot be seen.
    void measure_imported();
    bool tell_of_sizes(Id id, double own_m, double scene_m); // diagonals of their boxes
    void tell_of_facets(std::vector<Id> fresh); // where scans have no normals; offers to shade them
    // Reports a failure in the dialog that asked for the file, or else in a notice.
    void write_scene(const std::string& path, bool compact, bool from_dialog = false);
    void keep_or(std::function<void()> go_on); // asks what becomes of a scene without a name

    Session* session_;
    Recovery* recovery_;
    std::weak_ptr<const Present> opening_; // its job has it
    ui::FileDialog dialog_;
    std::function<void(const std::string&)> then_image_;
    std::string image_folder_;  // of the last picture that was chosen
    std::string import_folder_; // of the last model that was imported by the dialog
    std::string scene_folder_;  // of the last scene that was opened or saved
    std::vector<Id> to_measure_;
    std::vector<std::string> waiting_; // files that were dropped
    Purpose purpose_ = Purpose::open;
    Id relinked_ = 0;
    std::optional<PendingQuestion> question_;
    std::function<void()> after_save_;
    bool close_agreed_ = false;
};

} // namespace trivar
