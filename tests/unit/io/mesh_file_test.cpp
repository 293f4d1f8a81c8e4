// Mesh files read back by readers of a few lines each, written after the formats' definitions.
#include "torse/io/mesh_file.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace torse {
namespace {

using nlohmann::json;
using Triangles = std::vector<std::array<MeshVector, 3>>;

/// Two triangles that share an edge, with two normals, and one triangle.
std::vector<NamedMesh> two_meshes() {
  TriangleMesh sheet;
  sheet.points = {{0, 0, 0}, {0.1, 0, 1.0 / 3}, {0, 2, 0}, {1e-7, 2, -1e22}};
  sheet.normals = {{0, 0, 1}, {0.6, 0, 0.8}};
  sheet.triangles = {{{{0, 0}, {1, 1}, {2, 0}}}, {{{1, 1}, {3, 1}, {2, 0}}}};
  TriangleMesh tip;
  tip.points = {{5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
  tip.normals = {{0, 0, 1}};
  tip.triangles = {{{{0, 0}, {1, 0}, {2, 0}}}};
  return {{"port side", sheet}, {"Stra\u00dfe", tip}};
}

MeshVector in_single(const MeshVector& x) {
  MeshVector y{};
  for (std::size_t j = 0; j < 3; ++j) y[j] = in_single_precision(x[j]);
  return y;
}

Triangles triangles_of(const TriangleMesh& mesh) {
  Triangles list;
  for (const auto& t : mesh.triangles) {
    list.push_back({mesh.points[t[0].point], mesh.points[t[1].point], mesh.points[t[2].point]});
  }
  return list;
}

Triangles in_single(Triangles list) {
  for (auto& t : list) {
    for (MeshVector& x : t) x = in_single(x);
  }
  return list;
}

TEST(MeshFile, ObjReadsBackAsTheSameDoubles) {
  const std::vector<NamedMesh> meshes = two_meshes();
  std::istringstream text(obj_text(meshes));
  std::vector<MeshVector> points{{}};
  std::vector<MeshVector> normals{{}};
  std::vector<std::string> names;
  std::vector<Triangles> faces;
  std::vector<std::vector<MeshVector>> face_normals;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "o") {
      names.push_back(line.substr(2));
      faces.emplace_back();
      face_normals.emplace_back();
    } else if (key == "v" || key == "vn") {
      std::string x, y, z;
      words >> x >> y >> z;
      (key == "v" ? points : normals).push_back({std::stod(x), std::stod(y), std::stod(z)});
    } else if (key == "f") {
      std::array<MeshVector, 3> t;
      for (MeshVector& corner : t) {
        std::size_t point = 0;
        std::size_t normal = 0;
        char slash = 0;
        words >> point >> slash >> slash >> normal;
        corner = points.at(point);
        face_normals.back().push_back(normals.at(normal));
      }
      faces.back().push_back(t);
    } else {
      EXPECT_EQ(key, "#");
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"port_side", "Stra\u00dfe"}));
  EXPECT_EQ(faces.at(0), triangles_of(meshes[0].mesh));
  EXPECT_EQ(faces.at(1), triangles_of(meshes[1].mesh));
  const MeshVector up{0, 0, 1};
  const MeshVector tilted{0.6, 0, 0.8};
  EXPECT_EQ(face_normals.at(0), (std::vector<MeshVector>{up, tilted, up, tilted, tilted, up}));
}

/// Little-endian numbers of a text.
class Bytes {
 public:
  explicit Bytes(std::string text) : text_(std::move(text)) {}
  std::uint32_t word(std::size_t at) const {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(text_.at(at + i));
    return value;
  }
  MeshVector vector(std::size_t at) const {
    const auto number = [&](std::size_t i) { return static_cast<double>(std::bit_cast<float>(word(at + 4 * i))); };
    return {number(0), number(1), number(2)};
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

TEST(MeshFile, StlHasEveryTriangle) {
  const std::vector<NamedMesh> meshes = two_meshes();
  const Bytes stl(stl_bytes(meshes));
  ASSERT_EQ(stl.word(80), 3U);
  ASSERT_EQ(stl.text().size(), 84 + 3 * 50U);
  EXPECT_NE(stl.text().substr(0, 5), "solid");
  Triangles expected = triangles_of(meshes[0].mesh);
  expected.push_back(triangles_of(meshes[1].mesh)[0]);
  Triangles found;
  for (std::size_t at = 84; at < stl.text().size(); at += 50) {
    found.push_back({stl.vector(at + 12), stl.vector(at + 24), stl.vector(at + 36)});
  }
  EXPECT_EQ(found, in_single(expected));
  EXPECT_EQ(stl.vector(84 + 100), (MeshVector{0, 0, 1}));
  for (std::size_t i = 0; i < found.size(); ++i) {
    const MeshVector normal = stl.vector(84 + 50 * i);
    EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, 1e-6);
    for (std::size_t corner = 1; corner < 3; ++corner) {
      MeshVector edge{};
      for (std::size_t j = 0; j < 3; ++j) edge[j] = found[i][corner][j] - found[i][0][j];
      const double along = normal[0] * edge[0] + normal[1] * edge[1] + normal[2] * edge[2];
      EXPECT_NEAR(along / std::hypot(edge[0], edge[1], edge[2]), 0, 1e-6);
    }
  }
}

/// Three corners on a line, two in one place, and a triangle whose square is no double.
TEST(MeshFile, StlHasNoNormalWhereThereIsNone) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 1e200, 0}, {1e200, 0, 0}};
  mesh.triangles = {{{{0, 0}, {1, 0}, {2, 0}}}, {{{0, 0}, {0, 0}, {2, 0}}}, {{{0, 0}, {3, 0}, {4, 0}}}};
  const Bytes stl(stl_bytes({{"flat", mesh}}));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(stl.vector(84 + 50 * i), (MeshVector{0, 0, 0})) << i;
}

std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned word = 0;
  int bits = 0;
  for (char c : text) {
    if (c == '=') break;
    word = word << 6 | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits >= 8) bytes += static_cast<char>(word >> (bits -= 8) & 0xFF);
  }
  return bytes;
}

/// The triangles of the mesh of node i, with the claims of its accessors checked.
Triangles read_mesh(const json& gltf, const Bytes& buffer, std::size_t i) {
  const json primitive =
      gltf.at("meshes").at(gltf.at("nodes").at(i).at("mesh").get<std::size_t>()).at("primitives").at(0);
  const auto accessor = [&](const json& index) { return gltf.at("accessors").at(index.get<std::size_t>()); };
  const auto begin = [&](const json& a) {
    const json view = gltf.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
    EXPECT_EQ(view.at("buffer"), 0);
    EXPECT_LE(view.at("byteOffset").get<std::size_t>() + view.at("byteLength").get<std::size_t>(),
              buffer.text().size());
    return view.at("byteOffset").get<std::size_t>();
  };
  const json positions = accessor(primitive.at("attributes").at("POSITION"));
  const json normals = accessor(primitive.at("attributes").at("NORMAL"));
  const json indices = accessor(primitive.at("indices"));
  const json material = gltf.at("materials").at(primitive.at("material").get<std::size_t>());
  const json metallic = material.at("pbrMetallicRoughness").at("metallicFactor");
  EXPECT_TRUE(metallic >= 0 && metallic <= 1) << metallic;
  EXPECT_EQ(positions.at("count"), normals.at("count"));
  EXPECT_EQ(positions.at("componentType"), 5126);
  EXPECT_EQ(indices.at("componentType"), 5125);
  Triangles list;
  MeshVector most{-1e300, -1e300, -1e300};
  for (std::size_t j = 0; j < indices.at("count").get<std::size_t>(); ++j) {
    const std::size_t vertex = buffer.word(begin(indices) + 4 * j);
    EXPECT_LT(vertex, positions.at("count").get<std::size_t>());
    const MeshVector normal = buffer.vector(begin(normals) + 12 * vertex);
    EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, 1e-6);
    if (j % 3 == 0) list.emplace_back();
    list.back()[j % 3] = buffer.vector(begin(positions) + 12 * vertex);
    for (std::size_t k = 0; k < 3; ++k) most[k] = std::max(most[k], list.back()[j % 3][k]);
  }
  EXPECT_EQ(positions.at("max").get<MeshVector>(), most);
  return list;
}

std::vector<NamedMesh> single_meshes() {
  std::vector<NamedMesh> meshes = two_meshes();
  for (NamedMesh& named : meshes) {
    for (MeshVector& x : named.mesh.points) x = in_single(x);
  }
  return meshes;
}

TEST(MeshFile, GltfHasNamesTrianglesAndNormals) {
  const std::vector<NamedMesh> meshes = single_meshes();
  const json gltf = json::parse(gltf_text(meshes));
  EXPECT_EQ(gltf.at("asset").at("version"), "2.0");
  const std::string uri = gltf.at("buffers").at(0).at("uri");
  const Bytes buffer(from_base64(uri.substr(uri.find(',') + 1)));
  EXPECT_EQ(buffer.text().size(), gltf.at("buffers").at(0).at("byteLength").get<std::size_t>());
  const json root = gltf.at("nodes").at(gltf.at("scenes").at(0).at("nodes").at(0).get<std::size_t>());
  EXPECT_EQ(root.at("children"), json({0, 1}));
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    EXPECT_EQ(gltf.at("nodes").at(i).at("name"), meshes[i].name);
    EXPECT_EQ(read_mesh(gltf, buffer, i), triangles_of(meshes[i].mesh));
  }
}

/// Two triangles at a kink: the points of the edge between them have two normals each, and are two vertices.
TEST(MeshFile, GltfHasAVertexForEachNormalOfAPoint) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.normals = {{0, 0, 1}, {0, 1, 0}};
  mesh.triangles = {{{{0, 0}, {1, 0}, {2, 0}}}, {{{1, 1}, {0, 1}, {3, 1}}}};
  const json gltf = json::parse(gltf_text({{"kink", mesh}}));
  const std::string uri = gltf.at("buffers").at(0).at("uri");
  const Bytes buffer(from_base64(uri.substr(uri.find(',') + 1)));
  const json primitive = gltf.at("meshes").at(0).at("primitives").at(0);
  const auto begin = [&](const json& index) {
    return gltf.at("bufferViews")
        .at(gltf.at("accessors").at(index.get<std::size_t>()).at("bufferView").get<std::size_t>())
        .at("byteOffset")
        .get<std::size_t>();
  };
  for (std::size_t j = 0; j < 6; ++j) {
    const std::size_t vertex = buffer.word(begin(primitive.at("indices")) + 4 * j);
    const MeshCorner& corner = mesh.triangles[j / 3][j % 3];
    EXPECT_EQ(buffer.vector(begin(primitive.at("attributes").at("POSITION")) + 12 * vertex), mesh.points[corner.point]);
    EXPECT_EQ(buffer.vector(begin(primitive.at("attributes").at("NORMAL")) + 12 * vertex), mesh.normals[corner.normal]);
  }
}

TEST(MeshFile, GlbIsTheSameSceneInChunks) {
  const std::vector<NamedMesh> meshes = single_meshes();
  const Bytes glb(glb_bytes(meshes));
  EXPECT_EQ(glb.text().substr(0, 4), "glTF");
  EXPECT_EQ(glb.word(4), 2U);
  EXPECT_EQ(glb.word(8), glb.text().size());
  const std::size_t length = glb.word(12);
  EXPECT_EQ(length % 4, 0U);
  EXPECT_EQ(glb.text().substr(16, 4), "JSON");
  json scene = json::parse(glb.text().substr(20, length));
  EXPECT_EQ(glb.text().substr(24 + length, 4), std::string("BIN\0", 4));
  json gltf = json::parse(gltf_text(meshes));
  const std::string uri = gltf.at("buffers").at(0).at("uri");
  EXPECT_EQ(glb.text().substr(28 + length), from_base64(uri.substr(uri.find(',') + 1)));
  gltf.at("buffers").at(0).erase("uri");
  EXPECT_EQ(scene, gltf);
}

/// The specification of binary glTF has blanks behind the scene and zeros behind the numbers.
TEST(MeshFile, TheSceneInAGlbEndsWithBlanks) {
  std::vector<NamedMesh> meshes = single_meshes();
  for (int i = 0; i < 4; ++i) {
    meshes[0].name += 'x';
    const Bytes glb(glb_bytes(meshes));
    const std::string scene = glb.text().substr(20, glb.word(12));
    EXPECT_EQ(scene.find('\0'), std::string::npos);
    EXPECT_EQ(scene.size() - scene.find_last_not_of(' ') - 1, 3 - (scene.find_last_not_of(' ') % 4));
  }
}

TEST(MeshFile, SinglePrecisionInALoop) {
  MeshVector x = two_meshes()[0].mesh.points[1];
  x = in_single(x);
  EXPECT_EQ(x[0], 0x1.99999ap-4);
  EXPECT_EQ(x[2], 0x1.555556p-2);
}

TEST(MeshFile, NothingIsAFileToo) {
  EXPECT_EQ(obj_text({}), "# torse\n");
  EXPECT_EQ(Bytes(stl_bytes({})).word(80), 0U);
  EXPECT_FALSE(json::parse(gltf_text({})).contains("buffers"));
}

}  // namespace
}  // namespace torse
