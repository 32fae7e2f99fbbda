// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/deformed_meshes.h"

#include "core/base/rejected.h"
#include "core/base/single_precision.h"
#include "gpu/context.h"

#include <set>

namespace trivar::gpu {
namespace {

VertexSource source_of(const MirroredMesh& mesh, const Mesh& values)
{
    VertexSource out;
    out.positions = mesh.attribute(0);
    out.normals = mesh.attribute(1);
    out.tangents = mesh.attribute(2);
    out.count = values.vertex_count();
    out.bounds = bounding_box(values);
    return out;
}

// The undeformed mesh's faces and colours with other vertices; what is not in `vertices` is as it
// was.
MirroredMesh with_vertices(const MirroredMesh& rest, const DeviceVertices* vertices)
{
    MirroredMesh out;
    for (const MirroredMesh::Attribute& a : rest.attributes) {
        const Buffer* buffer = &rest.buffers[a.buffer];
        if (vertices) {
            const Buffer* moved = a.location == 0   ? &vertices->positions
                                  : a.location == 1 ? &vertices->normals
                                  : a.location == 2 ? &vertices->tangents
                                                    : nullptr;
            if (moved && moved->bytes() > 0) buffer = moved;
        }
        out.vertices.attribute(a.location, *buffer, a.components,
                               a.components * static_cast<int>(sizeof(float)));
    }
    out.vertices.indices(rest.faces->indices);
    out.faces = rest.faces;
    out.colored = rest.colored;
    return out;
}

// A mesh whose normals the renderer would make up gets them before it is deformed.
Ref<Mesh> with_normals(const Ref<Mesh>& mesh)
{
    if (!mesh->normals.empty()) return mesh;
    Mesh out = *mesh;
    out.normals = smooth_normals(*mesh);
    return make_ref(std::move(out));
}

bool deforms(const Instance& instance)
{
    return !instance.tiles && (!instance.stages.empty() || instance.posed) && instance.mesh &&
           instance.mesh->face_count() > 0;
}

} // namespace

std::optional<DeformBy> deform_named(std::string_view name)
{
    for (std::size_t i = 0; i < deform_names.size(); ++i)
        if (deform_names[i] == name) return static_cast<DeformBy>(i);
    return std::nullopt;
}

DeformBy usual_deform_by()
{
    const bool can = device_limits().gl_version >= 43;
    return !can || is_software() ? DeformBy::processor : DeformBy::two_phases;
}

bool DeformedMeshes::current(const Entry& entry, const Instance& instance, const Picture& picture)
{
    return entry.alive.lock() == instance.mesh && entry.posed == instance.posed &&
           entry.stages == instance.stages && entry.by == picture.deform_by &&
           entry.wire == picture.settings.wire;
}

std::vector<DeformedMeshes::Key> DeformedMeshes::keys_of(const Picture& picture)
{
    std::map<std::pair<int, PartKey>, int> met;
    std::vector<Key> keys;
    for (const Instance& each : picture.instances)
        if (deforms(each)) keys.push_back({each.id, each.part, met[{each.id, each.part}]++});
    return keys;
}

std::size_t DeformedMeshes::stale_vertices(const Picture& picture) const
{
    std::size_t count = 0;
    const std::vector<Key> keys = keys_of(picture);
    auto key = keys.begin();
    for (const Instance& instance : picture.instances) {
        if (!deforms(instance)) continue;
        const auto found = entries_.find(*key++);
        if (found == entries_.end() || !current(found->second, instance, picture))
            count += instance.mesh->vertex_count();
    }
    return count;
}

void DeformedMeshes::update(const Picture& picture, Mirror& mirror)
{
    notice_.clear();
    of_instance_.assign(picture.instances.size(), nullptr);
    const std::vector<Key> keys = keys_of(picture);
    const std::set<Key> wanted(keys.begin(), keys.end());
    std::erase_if(entries_, [&](const auto& item) { return !wanted.contains(item.first); });
    if (device_) device_->lattices().drop_dead();
    if (poser_) poser_->drop_dead();
    auto key = keys.begin();
    for (std::size_t i = 0; i < picture.instances.size(); ++i) {
        const Instance& instance = picture.instances[i];
        if (!deforms(instance)) continue;
        Entry& entry = entries_[*key++];
        of_instance_[i] = &entry;
        if (current(entry, instance, picture)) continue;
        if (entry.alive.lock() != instance.mesh || entry.posed != instance.posed)
            entry.on_processor.reset();
        entry.alive.reset(); // should there be no room
        entry.by = picture.deform_by;
        entry.wire = picture.settings.wire;
        deform(entry, instance, mirror);
        entry.alive = instance.mesh;
        entry.posed = instance.posed;
        entry.stages = instance.stages;
    }
    for (const auto& [instance, entry] : entries_)
        if (notice_.empty()) notice_ = entry.notice;
}

const DeformedMesh* DeformedMeshes::of(std::size_t instance) const
{
    const Entry* entry = of_instance_.at(instance);
    return entry ? &entry->drawn : nullptr;
}

void DeformedMeshes::bind(const DeformedMesh& mesh)
{
    device().bind(*mesh.stage, mesh.undeformed, mesh.origin_world);
}

DeviceDeformer& DeformedMeshes::device()
{
    if (!device_) {
        device_ = std::make_unique<DeviceDeformer>();
        device_->programs().take(texts_);
    }
    return *device_;
}

void DeformedMeshes::take(const Ref<ShaderTexts>& texts)
{
    texts_ = texts;
    if (device_) device_->programs().take(texts);
    for (auto& [instance, entry] : entries_) entry.alive.reset();
}

std::string DeformedMeshes::shader_trouble() const
{
    return device_ ? device_->programs().trouble() : std::string();
}

void DeformedMeshes::deform(Entry& entry, const Instance& instance, Mirror& mirror)
{
    const MirroredMesh& rest = mirror.mesh(instance.mesh);
    entry.drawn = {};
    entry.notice.clear();
    bool done = false;
    if (entry.by != DeformBy::processor) try {
            deform_on_device(entry, instance, mirror);
            done = true;
        } catch (const Rejected& error) {
            entry.notice = error.what();
            entry.drawn = {};
        }
    if (!done) deform_on_processor(entry, instance);
    DeformedMesh& drawn = entry.drawn;
    const bool in_buffers = !drawn.stage || instance.stages.size() > 1 || instance.posed;
    drawn.mirrored = with_vertices(rest, in_buffers ? &entry.vertices : nullptr);
    drawn.mirrored.serial = mirror.next_serial();
    if (!entry.wire) return;
    drawn.edges.indices = mirror.edge_indices(instance.mesh);
    drawn.edges.vertices.attribute(0, entry.vertices.positions, 3, sizeof(glm::vec3));
    drawn.edges.vertices.attribute(1, entry.vertices.normals, 3, sizeof(glm::vec3));
    drawn.edges.vertices.indices(drawn.edges.indices->buffer);
}

void DeformedMeshes::deform_on_device(Entry& entry, const Instance& instance, Mirror& mirror)
{
    const std::span<const Stage> stages(instance.stages);
    VertexSource from = source_of(mirror.mesh(instance.mesh), *instance.mesh);
    DeformedMesh& drawn = entry.drawn;
    DeviceDeformer& deformer = device();
    if (instance.posed) {
        if (!poser_) poser_ = std::make_unique<DevicePoser>(deformer.programs());
        poser_->pose(from, entry.vertices, *instance.posed);
        from = VertexSource(entry.vertices); // which volumes deform in place
        if (stages.empty()) {
            drawn.box = deformer.box_of(from);
            return;
        }
    }
    Box box = from.bounds;
    for (const Stage& stage : stages) box = deformed_bounds(stage, box);
    // A number of few digits, so that taking it off and adding it again is exact.
    drawn.origin_world = glm::dvec3(in_single_precision(box.center()));
    const bool one_phase = entry.by == DeformBy::one_phase && !entry.wire;
    const std::span<const Stage> first = one_phase ? stages.first(stages.size() - 1) : stages;
    if (!first.empty())
        deformer.deform(from, entry.vertices, first, method_of(entry.by),
                        one_phase ? glm::dvec3(0) : drawn.origin_world);
    if (!one_phase) {
        drawn.box = deformer.box_of(entry.vertices);
    } else {
        const VertexSource last = first.empty() ? from : VertexSource(entry.vertices);
        drawn.box = deformer.box_of(last, &stages.back(), drawn.origin_world);
        drawn.stage = stages.back();
        drawn.undeformed = last.bounds;
        drawn.defines =
            volume_defines(deformer.lattices().lattice(stages.back().lattice).axes->packed.order,
                           deformer.reads_texels());
    }
    drawn.box.lo += drawn.origin_world;
    drawn.box.hi += drawn.origin_world;
}

void DeformedMeshes::deform_on_processor(Entry& entry, const Instance& instance)
{
    DeformedArrays out;
    const auto mesh = [&] {
        return with_normals(instance.posed ? *instance.posed->mesh : instance.mesh);
    };
    if (instance.stages.empty()) out = {mesh()->positions, mesh()->normals, mesh()->tangents};
    for (std::size_t i = 0; i < instance.stages.size(); ++i) {
        const Stage& stage = instance.stages[i];
        const std::array<Knots, 3>& axes = stage.lattice->displacement.axes;
        if (i == 0) {
            const OnProcessor* kept = entry.on_processor.get();
            if (!kept || kept->axes != axes || kept->embedding != stage.embedding)
                entry.on_processor = std::make_unique<OnProcessor>(
                    OnProcessor{stage.embedding, axes, Deformer(mesh(), stage.embedding, axes)});
            out = entry.on_processor->deformer.arrays(*stage.lattice);
            continue;
        }
        Mesh between;
        between.positions = std::move(out.positions);
        between.normals = std::move(out.normals);
        between.tangents = std::move(out.tangents);
        out = Deformer(make_ref(std::move(between)), stage.embedding, axes).arrays(*stage.lattice);
    }
    entry.vertices.positions.write(std::as_bytes(std::span(out.positions)));
    entry.vertices.normals.write(std::as_bytes(std::span(out.normals)));
    entry.vertices.tangents.write(std::as_bytes(std::span(out.tangents)));
    entry.vertices.count = out.positions.size();
    entry.drawn.box = {};
    for (const glm::vec3& p : out.positions) entry.drawn.box.add(p);
}

} // namespace trivar::gpu
