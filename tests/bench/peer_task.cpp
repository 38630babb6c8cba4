#include "tests/bench/peer_task.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <random>
#include <sstream>

#include "core/base/units.h"

namespace toile::peers {

namespace fs = std::filesystem;

namespace {

Error bad_line(const fs::path& file, int line) {
  return {"bench.bad_file", "a line of the task's file cannot be read",
          file.string() + " line " + std::to_string(line)};
}

Result<geometry::TriangleMesh> read_obj(const fs::path& file) {
  std::ifstream in(file);
  if (!in)
    return Error{"bench.missing", "the task's file is not there; say where with --tasks", file.string()};
  geometry::TriangleMesh mesh;
  std::string text, word;
  for (int line = 1; std::getline(in, text); ++line) {
    std::istringstream words(text);
    words >> word;
    if (text.starts_with("v ")) {
      Vec3 p;
      if (!(words >> p.x >> p.y >> p.z) || !is_finite(p)) return bad_line(file, line);
      mesh.vertices.push_back(p);
    } else if (text.starts_with("f ")) {
      Tri t{};
      if (!(words >> t[0] >> t[1] >> t[2])) return bad_line(file, line);
      for (Index& v : t) --v;
      mesh.triangles.push_back(t);
    }
  }
  const auto count = static_cast<Index>(mesh.vertices.size());
  for (const Tri& t : mesh.triangles) {
    for (const Index v : t) {
      if (v < 0 || v >= count) return Error{"bench.bad_file", "a face names no vertex", file.string()};
    }
  }
  return mesh;
}

/// Lines of numbers, `width` each, the first `indices` of them vertices below `count`. No file: no lines.
Result<std::vector<std::vector<double>>> read_numbers(const fs::path& file, std::size_t width,
                                                      std::size_t indices, std::size_t count) {
  std::vector<std::vector<double>> rows;
  std::ifstream in(file);
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    std::istringstream words(text);
    std::vector<double> row(width);
    for (double& number : row) {
      if (!(words >> number)) return bad_line(file, line);
    }
    for (std::size_t k = 0; k < indices; ++k) {
      if (!(row[k] >= 0 && row[k] < static_cast<double>(count))) return bad_line(file, line);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// A number below n; std::uniform_int_distribution differs between libraries.
std::size_t below(std::size_t n, std::mt19937_64& random) { return static_cast<std::size_t>(random() % n); }

std::vector<Index> shuffled(std::size_t count, std::mt19937_64& random) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[below(i, random)]);
  return order;
}

Vec3 turned(Vec3 p, double degrees) {
  const double a = radians_from_degrees(degrees), c = std::cos(a), s = std::sin(a);
  return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

Vec3 disguised(Vec3 p, const Disguise& d) {
  if (d.flip) p.z = -p.z;
  return d.turn_degrees == 0 ? p : turned(p, d.turn_degrees);
}

Vec3 undisguised(Vec3 p, const Disguise& d) {
  if (d.turn_degrees != 0) p = turned(p, -d.turn_degrees);
  if (d.flip) p.z = -p.z;
  return p;
}

geometry::TriangleMesh disguised(geometry::TriangleMesh mesh, const Disguise& d) {
  for (Vec3& p : mesh.vertices) p = disguised(p, d);
  if (d.flip) {
    for (Tri& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

void shuffle_cloth(DisguisedTask& out, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  geometry::TriangleMesh& cloth = out.task.cloth;
  out.place = shuffled(cloth.vertices.size(), random);
  geometry::TriangleMesh mixed = cloth;
  for (std::size_t i = 0; i < out.place.size(); ++i) mixed.vertices[out.place[i]] = cloth.vertices[i];
  const std::vector<Index> triangle_place = shuffled(cloth.triangles.size(), random);
  for (std::size_t t = 0; t < triangle_place.size(); ++t) {
    Tri& to = mixed.triangles[triangle_place[t]];
    to = cloth.triangles[t];
    for (Index& v : to) v = out.place[v];
  }
  cloth = std::move(mixed);
  for (auto& pair : out.task.sewn) {
    for (Index& v : pair) v = out.place[v];
  }
  for (LedVertex& led : out.task.led) led.v = out.place[led.v];
}

/// Corners in the triangle's plane, x along what the world's x (or z) axis is there.
solver::RestTriangle flat(const geometry::TriangleMesh& cloth, const Tri& t) {
  const Vec3 a = cloth.vertices[t[0]], ab = cloth.vertices[t[1]] - a, ac = cloth.vertices[t[2]] - a;
  const Vec3 n = normalized(cross(ab, ac));
  const Vec3 axis = std::abs(n.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 u = normalized(axis - n * dot(axis, n)), v = cross(n, u);
  return {Vec2{0, 0}, Vec2{dot(ab, u), dot(ab, v)}, Vec2{dot(ac, u), dot(ac, v)}};
}

}  // namespace

Result<PeerTask> read_task(const fs::path& folder, const std::string& name) {
  PeerTask task;
  task.name = name;
  auto cloth = TRY(read_obj(folder / (name + "_cloth.obj")));
  auto body = TRY(read_obj(folder / (name + "_body.obj")));
  task.cloth = std::move(cloth);
  task.body = std::move(body);
  const std::size_t count = task.cloth.vertices.size();
  const auto seams = TRY(read_numbers(folder / (name + "_seams.txt"), 2, 2, count));
  for (const auto& row : seams) task.sewn.push_back({static_cast<Index>(row[0]), static_cast<Index>(row[1])});
  const auto pins = TRY(read_numbers(folder / (name + "_pins.txt"), 4, 1, count));
  for (const auto& row : pins) task.led.push_back({static_cast<Index>(row[0]), {row[1], row[2], row[3]}});
  return task;
}

std::vector<Vec3> DisguisedTask::undo(std::span<const Vec3> positions) const {
  std::vector<Vec3> out(place.size());
  for (std::size_t i = 0; i < place.size(); ++i) out[i] = undisguised(positions[place[i]], disguise);
  return out;
}

DisguisedTask put_on(const PeerTask& task, const Disguise& disguise) {
  DisguisedTask out{task, std::vector<Index>(task.cloth.vertices.size()), disguise};
  std::iota(out.place.begin(), out.place.end(), 0);
  out.task.cloth = disguised(task.cloth, disguise);
  out.task.body = disguised(task.body, disguise);
  for (LedVertex& led : out.task.led) led.target = disguised(led.target, disguise);
  if (disguise.shuffle) shuffle_cloth(out, *disguise.shuffle);
  return out;
}

material::Fabric bench_fabric() {
  constexpr double kYoung = 2000, kPoisson = 0.3, kBending = 1.3e-5;
  material::Fabric fabric;
  fabric.id = fabric.name = "bench";
  fabric.areal_mass = 0.2;
  fabric.stretch_warp = fabric.stretch_weft = kYoung / (1 - kPoisson * kPoisson);
  fabric.stretch_coupling = kPoisson * fabric.stretch_warp;
  fabric.stretch_shear = kYoung / (2 * (1 + kPoisson));
  fabric.bend_warp = fabric.bend_weft = fabric.bend_bias = kBending;
  fabric.thickness = 1e-3;
  fabric.friction = 0.3;
  return fabric;
}

std::vector<Index> sewn_classes(const PeerTask& task) {
  std::vector<Index> least(task.cloth.vertices.size());
  std::iota(least.begin(), least.end(), 0);
  const auto root = [&](Index v) {
    while (least[v] != v) v = least[v];
    return v;
  };
  for (const auto& [i, j] : task.sewn) {
    const Index a = root(i), b = root(j);
    least[std::max(a, b)] = std::min(a, b);
  }
  for (Index& v : least) v = root(v);
  return least;
}

solver::ClothModel task_model(const PeerTask& task, const material::Fabric& fabric,
                              std::span<const Index> vertex_of, Index vertex_count) {
  solver::ClothModel model;
  model.fabrics = {fabric};
  model.mass.assign(static_cast<std::size_t>(vertex_count), 0);
  for (const Tri& t : task.cloth.triangles) {
    model.rest.push_back(flat(task.cloth, t));
    model.fabric_of_triangle.push_back(0);
    Tri& solved = model.triangles.emplace_back(t);
    for (Index& v : solved) {
      v = vertex_of[v];
      model.mass[v] += solver::rest_area(model.rest.back()) * fabric.areal_mass / 3;
    }
  }
  model.vertex_class.resize(model.mass.size());
  const std::vector<Index> classes = sewn_classes(task);
  for (std::size_t i = 0; i < classes.size(); ++i) model.vertex_class[vertex_of[i]] = vertex_of[classes[i]];
  return model;
}

double mean_edge_of(const geometry::TriangleMesh& cloth) {
  double sum = 0;
  for (const Tri& t : cloth.triangles) {
    for (int k = 0; k < 3; ++k) sum += length(cloth.vertices[t[(k + 1) % 3]] - cloth.vertices[t[k]]);
  }
  return cloth.triangles.empty() ? 0 : sum / (3.0 * static_cast<double>(cloth.triangles.size()));
}

}  // namespace toile::peers
