#pragma once
// A project of two files, a square of cloth over a post, for the tests of this folder.

#include <memory>
#include <string>

#include "server/documents/assets.h"
#include "server/documents/projects.h"
#include "tests/server/owners.h"
#include "tests/server/store/store_folder.h"

namespace toile {

/// A square of 300 mm on layer CUT, with the name CLOTH in it.
inline std::string cloth_dxf(const std::string& side = "300") {
  std::string text = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nCUT\n90\n4\n70\n1\n";
  for (const std::string& corner :
       {std::string("0\n20\n0"), side + "\n20\n0", side + "\n20\n" + side, "0\n20\n" + side}) {
    text += "10\n" + corner + "\n";
  }
  return text + "0\nTEXT\n8\nCUT\n10\n150\n20\n150\n40\n5\n1\nCLOTH\n0\nENDSEC\n0\nEOF\n";
}

/// A closed box of 0.2 × 0.5 × 0.2 m.
inline constexpr const char* kPostObj =
    "v -0.1 0 -0.1\nv 0.1 0 -0.1\nv 0.1 0 0.1\nv -0.1 0 0.1\n"
    "v -0.1 0.5 -0.1\nv 0.1 0.5 -0.1\nv 0.1 0.5 0.1\nv -0.1 0.5 0.1\n"
    "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

inline constexpr const char* kClothDocument = R"({
  "toile": 1,
  "name": "Cloth over a post",
  "pieces": [
    {"id": "cloth", "from": {"dxf": "cut/cloth.dxf", "piece": "CLOTH", "units": "mm"}, "fabric": "cotton",
     "placement": {"rigid": {"translation": [-0.15, 0.52, 0.15], "rotation": [-90, 0, 0]}}}
  ],
  "fabrics": [
    {"id": "cotton", "areal_mass_g_m2": 150, "stretch_warp_n_m": 2000, "stretch_weft_n_m": 1500,
     "stretch_shear_n_m": 500, "bend_warp_un_m": 10, "bend_weft_un_m": 8, "bend_bias_un_m": 7, "thickness_mm": 0.4}
  ],
  "seams": [],
  "bodies": [{"id": "post", "file": "post.obj", "unit": "m"}]
})";

/// kClothDocument with the one place of `from` changed to `to`.
inline std::string cloth_document(const std::string& from = "", const std::string& to = "") {
  std::string text = kClothDocument;
  const std::size_t at = text.find(from);
  return at == std::string::npos ? "nothing to change: " + from : text.replace(at, from.size(), to);
}

/// A store and its documents, until a test closes it or opens the folder again.
class OpenedDocuments {
 public:
  explicit OpenedDocuments(const std::string& folder)
      : store_(opened(folder)), documents_(std::make_unique<documents::Documents>(*store_)) {}

  documents::Documents& documents() const { return *documents_; }
  store::Store* operator->() const { return store_.get(); }
  void reset() {
    documents_.reset();
    store_.reset();
  }

 private:
  std::unique_ptr<store::Store> store_;
  std::unique_ptr<documents::Documents> documents_;  // goes first when this is destroyed
};

inline OpenedDocuments opened_documents(const std::string& folder) { return OpenedDocuments(folder); }

/// A store with the two files uploaded.
struct ClothStore {
  TemporaryFolder folder;
  OpenedDocuments store = opened_documents(folder.path());
  std::string dxf = documents::add_asset(store.documents(), kMe, "dxf", "cloth.dxf", cloth_dxf())->id;
  std::string body = documents::add_asset(store.documents(), kMe, "body", "post.obj", kPostObj)->id;
  documents::ProjectFileMap files{{"cut/cloth.dxf", dxf}, {"post.obj", body}};
};

}  // namespace toile
