#include "server/documents/bodies.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "tests/server/documents/documents_fixture.h"

namespace toile {
namespace {

constexpr std::size_t kPostBytes = 8 * sizeof(Vec3) + 12 * sizeof(Tri);

store::AssetRow body(const OpenedDocuments& store, const std::string& name) {
  return *documents::add_asset(store.documents(), kMe, "body", name, kPostObj);
}

TEST(BodyCache, ReadsABodyOnceForEachSetting) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  documents::BodyCache cache(10 * kPostBytes);
  const std::string id = body(store, "a.obj").id;
  const auto first = cache.mesh(store.documents().store(), kMe, id, {});
  const auto again = cache.mesh(store.documents().store(), kMe, id, {});
  const auto in_cm = cache.mesh(store.documents().store(), kMe, id, {.unit_in_m = 0.01});
  const auto z_up = cache.mesh(store.documents().store(), kMe, id, {.z_up = true});
  ASSERT_TRUE(first && again && in_cm && z_up);
  EXPECT_EQ(*first, *again) << "the same object";
  EXPECT_NEAR((*in_cm)->mesh.vertices[0].x, (*first)->mesh.vertices[0].x / 100, 1e-9);
  EXPECT_NE(*z_up, *first);
  EXPECT_EQ(cache.bytes(), 3 * kPostBytes);
}

TEST(BodyCache, LetsGoOfWhatWasUsedLongestAgo) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  documents::BodyCache cache(2 * kPostBytes);
  const std::string a = body(store, "a.obj").id, b = body(store, "b.obj").id, c = body(store, "c.obj").id;
  const auto first_a = *cache.mesh(store.documents().store(), kMe, a, {});
  const auto first_b = *cache.mesh(store.documents().store(), kMe, b, {});
  EXPECT_EQ(*cache.mesh(store.documents().store(), kMe, a, {}), first_a);
  ASSERT_TRUE(cache.mesh(store.documents().store(), kMe, c, {}));  // pushes b out
  EXPECT_EQ(cache.bytes(), 2 * kPostBytes);
  EXPECT_EQ(*cache.mesh(store.documents().store(), kMe, a, {}), first_a);
  EXPECT_NE(*cache.mesh(store.documents().store(), kMe, b, {}), first_b);
}

TEST(BodyCache, HoldsNothingThatIsLargerThanItself) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  documents::BodyCache cache(kPostBytes - 1);
  EXPECT_TRUE(cache.mesh(store.documents().store(), kMe, body(store, "a.obj").id, {}));
  EXPECT_EQ(cache.bytes(), 0u);
}

TEST(BodyCache, GivesNobodyAnothersBody) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  documents::BodyCache cache(10 * kPostBytes);
  const std::string id = body(store, "a.obj").id;
  ASSERT_TRUE(cache.mesh(store.documents().store(), kMe, id, {}));
  EXPECT_EQ(code_of(cache.mesh(store.documents().store(), kStranger, id, {})), "store.not_found");
}

TEST(BodyCache, ServesManyThreads) {
  const TemporaryFolder folder;
  const auto store = opened_documents(folder.path());
  documents::BodyCache cache(2 * kPostBytes);
  const std::vector<std::string> ids{body(store, "a.obj").id, body(store, "b.obj").id,
                                     body(store, "c.obj").id};
  std::atomic<int> faults{0};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = 0; i < 30; ++i) {
        const auto mesh = cache.mesh(store.documents().store(), kMe, ids[(t + i) % ids.size()], {});
        if (!mesh || (*mesh)->mesh.vertices.size() != 8) ++faults;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(faults, 0);
  EXPECT_LE(cache.bytes(), 2 * kPostBytes);
}

}  // namespace
}  // namespace toile
