// OBJ by lines and STL by records.
#include "torse/io/mesh_file.hpp"

#include <bit>
#include <charconv>
#include <cstdint>

#include "torse/algebra/triple.hpp"
#include "torse/io/bytes.hpp"
#include "torse/io/text.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {
namespace {

constexpr std::size_t stl_header = 80;

std::string word_of(const std::string& name) {
  std::string word = printable(name);
  for (char& c : word) c = c == ' ' ? '_' : c;
  return word.empty() ? "_" : word;
}

/// The shortest decimal that reads back as x.
void append_number(std::string& text, double x) {
  char buffer[32];
  text += ' ';
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr);
}

void append_vectors(std::string& text, const char* key, const std::vector<MeshVector>& list) {
  for (const MeshVector& x : list) {
    text += key;
    for (double v : x) append_number(text, v);
    text += '\n';
  }
}

/// The unit normal of a triangle, zero where it has none: readers then take the order of the corners.
MeshVector facet_normal(const MeshVector& p, const MeshVector& q, const MeshVector& r) {
  const MeshVector a{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  const MeshVector b{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  const MeshVector n = cross(a, b);
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
  return {n[0] / length, n[1] / length, n[2] / length};
}

void append_vector(std::string& bytes, const MeshVector& x) {
  for (double v : x) append_float(bytes, v);
}

}  // namespace

std::string obj_text(const std::vector<NamedMesh>& meshes) {
  std::string text = "# torse\n";
  std::size_t points = 1;
  std::size_t normals = 1;
  for (const NamedMesh& named : meshes) {
    const TriangleMesh& mesh = named.mesh;
    text += "o " + word_of(named.name) + '\n';
    append_vectors(text, "v", mesh.points);
    append_vectors(text, "vn", mesh.normals);
    for (const auto& triangle : mesh.triangles) {
      text += 'f';
      for (const MeshCorner& at : triangle) {
        text += ' ' + std::to_string(points + at.point) + "//" + std::to_string(normals + at.normal);
      }
      text += '\n';
    }
    points += mesh.points.size();
    normals += mesh.normals.size();
  }
  return text;
}

std::string stl_bytes(const std::vector<NamedMesh>& meshes) {
  std::string bytes = "binary STL by torse";
  bytes.resize(stl_header, ' ');
  std::size_t count = 0;
  for (const NamedMesh& named : meshes) count += named.mesh.triangles.size();
  append_word(bytes, count);
  for (const NamedMesh& named : meshes) {
    for (const auto& t : named.mesh.triangles) {
      const MeshVector& p = named.mesh.points[t[0].point];
      const MeshVector& q = named.mesh.points[t[1].point];
      const MeshVector& r = named.mesh.points[t[2].point];
      append_vector(bytes, facet_normal(p, q, r));
      append_vector(bytes, p);
      append_vector(bytes, q);
      append_vector(bytes, r);
      bytes.append(2, '\0');
    }
  }
  return bytes;
}

}  // namespace torse
