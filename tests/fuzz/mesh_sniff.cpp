// The first look at mesh files. The first byte says under which name the rest comes.

#include "core/body/mesh_import/formats.h"
#include "core/body/mesh_import/sniff.h"
#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  std::string stl(84, '\0');
  stl[80] = 1;
  stl.append(50, '\0');
  return {std::string(1, '\0') + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
          '\1' + stl,
          "\1solid a\nfacet normal 0 0 1\nouter loop\n",
          "\2ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n0\n",
          "\3{\"asset\": {\"version\": \"2.0\"}}\n",
          std::string("\4glTF\2\0\0\0", 9),
          "\5; FBX 7.4.0\n",
          "\6<?xml version=\"1.0\"?>\n<COLLADA>\n",
          "\7MM",
          "\x08OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"};
}

void try_input(std::string_view bytes) {
  if (bytes.empty()) return;
  const auto formats = mesh_import::mesh_formats();
  const std::size_t which = static_cast<unsigned char>(bytes[0]) % (formats.size() + 1);
  const std::string ending = which < formats.size() ? std::string(formats[which].ending) : ".xyz";
  for (const bool any : {false, true}) {
    const Status status = mesh_import::sniff_mesh_bytes("body" + ending, bytes.substr(1), any);
    expect(status.ok() || status.error().code == "mesh.unreadable", "a refusal says so");
  }
}

}  // namespace toile::fuzz
