// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar {

// These functions give values as a text file of Universal Scene Description has them.
std::string usd_number(float value); // no -0
std::string usd_tuple(const glm::vec2& v);
std::string usd_tuple(const glm::vec3& v);
std::string usd_list(const std::vector<glm::vec2>& values);
std::string usd_list(const std::vector<glm::vec3>& values);
std::string usd_list(const std::vector<std::uint32_t>& values);
std::string usd_matrix(const glm::dmat4& m);
// A valid USD name made from a person's name; the number makes it unique.
std::string usd_name(const std::string& name, std::size_t number);

} // namespace trivar
