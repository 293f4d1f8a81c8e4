// glTF 2.0: one buffer with positions, normals and indices; a JSON text that says where they are.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "torse/io/bytes.hpp"
#include "torse/io/mesh_file.hpp"

namespace torse {
namespace {

using Json = nlohmann::ordered_json;

// Of the specification, section 3.6 and 5.
constexpr int component_float = 5126;
constexpr int component_unsigned_int = 5125;
constexpr int target_array = 34962;
constexpr int target_elements = 34963;
constexpr std::size_t glb_magic = 0x46546C67;
constexpr std::size_t chunk_json = 0x4E4F534A;
constexpr std::size_t chunk_binary = 0x004E4942;

/// A point with one normal is a vertex of glTF.
struct Vertices {
  std::vector<MeshVector> points;
  std::vector<MeshVector> normals;
  std::vector<std::size_t> indices;
};

Vertices vertices_of(const TriangleMesh& mesh) {
  Vertices vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> index;
  for (const auto& triangle : mesh.triangles) {
    for (const MeshCorner& at : triangle) {
      const auto [entry, inserted] = index.try_emplace({at.point, at.normal}, vertices.points.size());
      if (inserted) {
        vertices.points.push_back(mesh.points[at.point]);
        vertices.normals.push_back(mesh.normals[at.normal]);
      }
      vertices.indices.push_back(entry->second);
    }
  }
  return vertices;
}

class Scene {
 public:
  void add(const NamedMesh& named) {
    if (named.mesh.triangles.empty()) return;
    const Vertices vertices = vertices_of(named.mesh);
    const int position = add_vectors(vertices.points);
    bound(accessors_.back(), vertices.points);
    const int normal = add_vectors(vertices.normals);
    const int indices = add_indices(vertices.indices);
    const Json primitive{
        {"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"indices", indices}, {"material", 0}};
    meshes_.push_back({{"name", named.name}, {"primitives", Json::array({primitive})}});
    nodes_.push_back({{"name", named.name}, {"mesh", meshes_.size() - 1}});
  }

  const std::string& buffer() const { return buffer_; }

  /// The JSON text; `uri` is empty for a buffer that follows in the file.
  std::string text(const std::string& uri) const {
    Json nodes = nodes_;
    Json children = Json::array();
    for (std::size_t i = 0; i < nodes_.size(); ++i) children.push_back(i);
    constexpr double half_root = 0.70710678118654752;
    Json root{{"name", "z up"}, {"rotation", Json::array({-half_root, 0, 0, half_root})}};
    if (!children.empty()) root["children"] = children;
    nodes.push_back(root);
    const Json scene{{"nodes", Json::array({nodes_.size()})}};
    Json json{{"asset", {{"version", "2.0"}, {"generator", "torse"}}},
              {"scene", 0},
              {"scenes", Json::array({scene})},
              {"nodes", nodes}};
    if (meshes_.empty()) return json.dump();
    Json buffer{{"byteLength", buffer_.size()}};
    if (!uri.empty()) buffer["uri"] = uri;
    const Json sheet{{"doubleSided", true}, {"pbrMetallicRoughness", {{"metallicFactor", 0}}}};
    json["materials"] = Json::array({sheet});
    json["meshes"] = meshes_;
    json["accessors"] = accessors_;
    json["bufferViews"] = views_;
    json["buffers"] = Json::array({buffer});
    return json.dump();
  }

 private:
  int add_accessor(int component, const char* type, std::size_t count, std::size_t begin, int target) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", buffer_.size() - begin}, {"target", target}});
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(accessors_.size() - 1);
  }

  int add_vectors(const std::vector<MeshVector>& list) {
    const std::size_t begin = buffer_.size();
    for (const MeshVector& x : list) {
      for (double v : x) append_float(buffer_, v);
    }
    return add_accessor(component_float, "VEC3", list.size(), begin, target_array);
  }

  int add_indices(const std::vector<std::size_t>& list) {
    const std::size_t begin = buffer_.size();
    for (std::size_t i : list) append_word(buffer_, i);
    return add_accessor(component_unsigned_int, "SCALAR", list.size(), begin, target_elements);
  }

  /// The least and largest coordinates, which a reader wants for positions.
  static void bound(Json& accessor, const std::vector<MeshVector>& points) {
    MeshVector least = points.front();
    MeshVector most = points.front();
    for (const MeshVector& x : points) {
      for (std::size_t j = 0; j < 3; ++j) {
        least[j] = std::min(least[j], x[j]);
        most[j] = std::max(most[j], x[j]);
      }
    }
    accessor["min"] = least;
    accessor["max"] = most;
  }

  std::string buffer_;
  Json nodes_ = Json::array();
  Json meshes_ = Json::array();
  Json accessors_ = Json::array();
  Json views_ = Json::array();
};

Scene scene_of(const std::vector<NamedMesh>& meshes) {
  Scene scene;
  for (const NamedMesh& named : meshes) scene.add(named);
  return scene;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    unsigned word = 0;
    for (std::size_t j = 0; j < 3; ++j) word = word << 8 | (j < left ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j) text += j > left ? '=' : digits[word >> (18 - 6 * j) & 63U];
  }
  return text;
}

void append_chunk(std::string& bytes, std::size_t type, std::string content, char padding) {
  content.resize((content.size() + 3) / 4 * 4, padding);
  append_word(bytes, content.size());
  append_word(bytes, type);
  bytes += content;
}

}  // namespace

std::string gltf_text(const std::vector<NamedMesh>& meshes) {
  const Scene scene = scene_of(meshes);
  return scene.text("data:application/octet-stream;base64," + base64(scene.buffer())) + '\n';
}

std::string glb_bytes(const std::vector<NamedMesh>& meshes) {
  const Scene scene = scene_of(meshes);
  std::string chunks;
  append_chunk(chunks, chunk_json, scene.text(""), ' ');
  if (!scene.buffer().empty()) append_chunk(chunks, chunk_binary, scene.buffer(), '\0');
  std::string bytes;
  append_word(bytes, glb_magic);
  append_word(bytes, 2);
  append_word(bytes, chunks.size() + 12);
  return bytes + chunks;
}

}  // namespace torse
