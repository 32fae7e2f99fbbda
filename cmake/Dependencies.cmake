# SPDX-License-Identifier: GPL-3.0-or-later
# Everything comes from the system's packages; packages.txt is the list the set-up script installs.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(glm CONFIG REQUIRED)
find_package(glfw3 3.3 CONFIG REQUIRED)
find_package(OpenMesh CONFIG REQUIRED)
find_package(TinyGLTF CONFIG REQUIRED)
# OpenImageIO pulls Imath's configuration, which talks about Python parts that nobody asked for; CGAL's
# talks about the compiler, and warns of any build type that is not its own Release.
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(OpenImageIO CONFIG REQUIRED)
find_package(CGAL 5.5 CONFIG REQUIRED)
unset(CMAKE_MESSAGE_LOG_LEVEL)
find_package(embree 3 CONFIG REQUIRED)
find_package(TBB CONFIG REQUIRED COMPONENTS tbb)
find_package(hwy CONFIG REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(fmt CONFIG REQUIRED)
find_package(pugixml CONFIG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(BZip2 REQUIRED)
find_package(GTest CONFIG REQUIRED)
find_package(benchmark CONFIG REQUIRED)
find_package(X11 REQUIRED) # libgl-dev brings it; tests strike keys with it
find_package(OpenGL REQUIRED COMPONENTS OpenGL EGL)
pkg_check_modules(OPENMESH REQUIRED openmesh) # its number, which its configuration does not tell
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo-pdf cairo)
pkg_check_modules(FREETYPE REQUIRED IMPORTED_TARGET freetype2)
pkg_check_modules(FONTCONFIG REQUIRED IMPORTED_TARGET fontconfig)
pkg_check_modules(HARFBUZZ REQUIRED IMPORTED_TARGET harfbuzz)
pkg_check_modules(FRIBIDI REQUIRED IMPORTED_TARGET fribidi)
pkg_check_modules(POLYCLIPPING REQUIRED IMPORTED_TARGET polyclipping)
pkg_check_modules(MD4C REQUIRED IMPORTED_TARGET md4c)
pkg_check_modules(PNG REQUIRED IMPORTED_TARGET libpng)
pkg_check_modules(JPEG REQUIRED IMPORTED_TARGET libjpeg)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)

# OpenImageIO's target names an OpenCV folder that its package does not bring.
set_target_properties(OpenImageIO::OpenImageIO OpenImageIO::OpenImageIO_Util PROPERTIES
                      INTERFACE_INCLUDE_DIRECTORIES "")

# OpenSubdiv's shipped configuration names a static library that is not shipped.
find_path(OPENSUBDIV_INCLUDE opensubdiv/far/topologyRefiner.h REQUIRED)
find_library(OPENSUBDIV_CPU osdCPU REQUIRED)
add_library(opensubdiv INTERFACE)
target_include_directories(opensubdiv SYSTEM INTERFACE ${OPENSUBDIV_INCLUDE})
target_link_libraries(opensubdiv INTERFACE ${OPENSUBDIV_CPU})

# teem has no configuration.
find_path(TEEM_INCLUDE teem/nrrd.h REQUIRED)
find_library(TEEM_LIBRARY teem REQUIRED)
add_library(teem INTERFACE)
target_include_directories(teem SYSTEM INTERFACE ${TEEM_INCLUDE})
target_link_libraries(teem INTERFACE ${TEEM_LIBRARY})

# pkg-config wants for DCMTK what its package does not bring. Of its libraries these read files and
# decode pixels.
find_path(DCMTK_INCLUDE dcmtk/dcmdata/dctk.h REQUIRED)
add_library(dcmtk INTERFACE)
target_include_directories(dcmtk SYSTEM INTERFACE ${DCMTK_INCLUDE})
foreach(library dcmjpeg dcmjpls dcmdata oflog ofstd)
  find_library(DCMTK_${library} ${library} REQUIRED)
  target_link_libraries(dcmtk INTERFACE ${DCMTK_${library}})
endforeach()

# The lines NAME|VERSION|LICENCE that the program tells of itself.
# pkg-config knows FreeType by the number of its interface only.
file(STRINGS ${FREETYPE_INCLUDEDIR}/freetype2/freetype/freetype.h FREETYPE_VERSION REGEX "define FREETYPE_(MAJOR|MINOR|PATCH)")
string(REGEX REPLACE "[^0-9;]" "" FREETYPE_VERSION "${FREETYPE_VERSION}")
string(REPLACE ";" "." FREETYPE_VERSION "${FREETYPE_VERSION}")
file(STRINGS ${OPENSUBDIV_INCLUDE}/opensubdiv/version.h OPENSUBDIV_VERSION REGEX "define OPENSUBDIV_VERSION v")
string(REGEX REPLACE ".*v([0-9_]+)" "\\1" OPENSUBDIV_VERSION "${OPENSUBDIV_VERSION}")
string(REPLACE "_" "." OPENSUBDIV_VERSION "${OPENSUBDIV_VERSION}")
file(STRINGS ${DCMTK_INCLUDE}/dcmtk/config/osconfig.h DCMTK_VERSION REGEX "define PACKAGE_VERSION ")
string(REGEX REPLACE ".*\"(.*)\".*" "\\1" DCMTK_VERSION "${DCMTK_VERSION}")
file(STRINGS ${TEEM_INCLUDE}/teem/air.h TEEM_VERSION REGEX "define TEEM_VERSION_STRING")
string(REGEX REPLACE ".*\"(.*)\".*" "\\1" TEEM_VERSION "${TEEM_VERSION}")
set(TRIVAR_LIBRARIES "Dear ImGui|${IMGUI_VERSION}|MIT
GLFW|${glfw3_VERSION}|Zlib
GLM|${glm_VERSION}|MIT
OpenMesh|${OPENMESH_VERSION}|BSD-3-Clause
libepoxy|${EPOXY_VERSION}|MIT
FreeType|${FREETYPE_VERSION}|FTL
Fontconfig|${FONTCONFIG_VERSION}|HPND
HarfBuzz|${HARFBUZZ_VERSION}|MIT
FriBidi|${FRIBIDI_VERSION}|LGPL-2.1-or-later
Clipper|${POLYCLIPPING_VERSION}|BSL-1.0
CGAL|${CGAL_VERSION}|GPL-3.0-or-later
Embree|${embree_VERSION}|Apache-2.0
oneTBB|${TBB_VERSION}|Apache-2.0
Highway|${hwy_VERSION}|Apache-2.0
Eigen|${Eigen3_VERSION}|MPL-2.0
OpenSubdiv|${OPENSUBDIV_VERSION}|Apache-2.0, modified
libpng|${PNG_VERSION}|PNG-2.0
libjpeg-turbo|${JPEG_VERSION}|IJG and BSD-3-Clause
OpenImageIO|${OpenImageIO_VERSION}|BSD-3-Clause
TinyGLTF|${TinyGLTF_VERSION}|MIT
teem|${TEEM_VERSION}|LGPL-2.1-or-later, with exceptions
DCMTK|${DCMTK_VERSION}|BSD-3-Clause
pugixml|${pugixml_VERSION}|MIT
zlib|${ZLIB_VERSION_STRING}|Zlib
bzip2|${BZIP2_VERSION_STRING}|bzip2-1.0.6
JSON for Modern C++|${nlohmann_json_VERSION}|MIT
CLI11|${CLI11_VERSION}|BSD-3-Clause
fmt|${fmt_VERSION}|MIT
MD4C|${MD4C_VERSION}|MIT
xxHash|${XXHASH_VERSION}|BSD-2-Clause
Inter (font)||OFL-1.1
Font Awesome (font)|4.7|OFL-1.1
DejaVu (font)||Bitstream Vera")
