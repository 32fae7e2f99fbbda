// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// An ObjCorner holds indices from 0, or below 0. A relative index is stored as its distance from
// the first element of its block plus `relative`, because the elements before the block are not
// counted yet.
struct ObjCorner {
    std::int32_t v, vt, vn;
    static constexpr std::int32_t none = -1;
    static constexpr std::int32_t absent = -2; // named, but missing
    static constexpr std::int32_t relative = 3 << 29;
    static constexpr std::int32_t limit = 1 << 30; // more lines than the largest file has
};

// An ObjEvent is a statement that sets something for the faces and lines after it.
struct ObjEvent {
    enum class Kind { object, group, material, library, tag, smoothing } kind;
    std::uint32_t face, line; // the numbers of faces and lines of the block before it
    std::string_view text;
};

// An ObjBlock is the content of a range of whole lines.
struct ObjBlock {
    std::vector<glm::vec3> v, vn, colors; // as many colors as v, or none
    std::vector<glm::vec2> vt;            // vt and vn that cannot be read begin with NaN
    struct {
        std::size_t v, vt, vn;
    } counts{}; // of the elements, also after they were taken out
    std::vector<ObjCorner> corners;
    std::vector<std::uint32_t> face_end; // into corners
    std::vector<std::uint32_t> left_out; // faces, rising
    // Vertex numbers as in ObjCorner::v; absent also if the word is no index.
    std::vector<std::int32_t> line_vertices;
    std::vector<std::uint32_t> line_end;       // into line_vertices
    std::vector<std::uint32_t> lines_left_out; // rising
    std::vector<ObjEvent> events;
    std::size_t points = 0, free_forms = 0; // elements left out
    std::size_t bad_lines = 0;              // of vt and vn
    struct Trouble {
        const char* at = nullptr; // the line; null: none
        std::string what;
    } error, first_bad; // the line that ended the block; the first of bad_lines
};

// Reads whole lines up to the first wrong one; positions relative to `origin`. Throws nothing.
ObjBlock read_obj_block(std::string_view text, const glm::dvec3& origin = glm::dvec3(0));

// The place in the text where a face, or a drawn line, begins; counted from 0.
const char* line_of_face(std::string_view text, std::size_t face);
const char* line_of_line(std::string_view text, std::size_t line);

} // namespace trivar
