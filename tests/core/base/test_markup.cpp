#include "core/base/markup.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(InMarkup, WritesByNameWhatWouldBeRead) {
  EXPECT_EQ(in_markup("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  EXPECT_EQ(in_markup("ä\n\x01"), "ä  ");
}

}  // namespace
}  // namespace toile
