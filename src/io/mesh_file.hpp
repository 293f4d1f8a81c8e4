// Triangle meshes as files that other programs read.
//   NamedMesh       a mesh and what it is called
//   obj_text        Wavefront OBJ: names, normals, coordinates that read back as the same doubles
//   stl_bytes       binary STL: triangles in single precision, no names
//   gltf_text       glTF 2.0, one JSON file       glb_bytes       the same in binary form
#pragma once

#include <string>
#include <vector>

#include "torse/developable/mesh.hpp"

namespace torse {

/// A mesh with its name, any UTF-8.
struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

/// An object for each mesh; blanks in names become underscores, since readers take a word.
std::string obj_text(const std::vector<NamedMesh>& meshes);

/// All triangles in one list. Coordinates must be numbers of single precision.
std::string stl_bytes(const std::vector<NamedMesh>& meshes);

/// A node and a mesh for each mesh with triangles, below one that turns z upwards into glTF's y. Coordinates must be
/// numbers of single precision, in metres by glTF's definition. The buffer is a data URI.
std::string gltf_text(const std::vector<NamedMesh>& meshes);

/// The same scene with its buffer as the binary chunk. Throws Error beyond 4 GiB.
std::string glb_bytes(const std::vector<NamedMesh>& meshes);

}  // namespace torse
