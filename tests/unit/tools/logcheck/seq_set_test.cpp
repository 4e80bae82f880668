#include "tools/logcheck/seq_set.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include <gmock/gmock.h>

namespace perceptor {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(SeqSet, WithoutGapsThereIsNoGap) {
  SeqSet set;
  EXPECT_TRUE(set.empty());
  EXPECT_THAT(set.gaps(), IsEmpty());
  for (int i = 5; i < 100; ++i) EXPECT_TRUE(set.add(i));
  EXPECT_EQ(set.first(), 5);
  EXPECT_EQ(set.last(), 99);
  EXPECT_THAT(set.gaps(), IsEmpty());
}

TEST(SeqSet, NamesEachGap) {
  SeqSet set;
  for (const int seq : {0, 1, 3, 4, 9}) set.add(seq);
  EXPECT_THAT(set.gaps(), ElementsAre(SeqRange{2, 2}, SeqRange{5, 8}));
  EXPECT_EQ((SeqRange{5, 8}).size(), 4);
}

TEST(SeqSet, KnowsARepeatedNumber) {
  SeqSet set;
  for (const int seq : {3, 4, 5}) set.add(seq);
  EXPECT_FALSE(set.add(3));
  EXPECT_FALSE(set.add(4));
  EXPECT_FALSE(set.add(5));
  EXPECT_TRUE(set.add(6));
}

TEST(SeqSet, OrderDoesNotMatter) {
  std::vector<int> numbers(200);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::erase(numbers, 77);
  std::mt19937_64 random(3);
  for (int round = 0; round < 20; ++round) {
    std::ranges::shuffle(numbers, random);
    SeqSet set;
    for (const int seq : numbers) EXPECT_TRUE(set.add(seq));
    EXPECT_EQ(set.first(), 0);
    EXPECT_EQ(set.last(), 199);
    EXPECT_THAT(set.gaps(), ElementsAre(SeqRange{77, 77}));
  }
}

}  // namespace
}  // namespace perceptor
