// Publishing while memory runs out: what was missed comes with the next map.

#include "ros/mapping/map_publishers.h"

#include <gtest/gtest.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>

#include <new>
#include <optional>
#include <string>

#include "failing_allocations.h"
#include "memory_limit.h"
#include "ros/conversion/message_conversion.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

using namespace test;
using Updates = MapPublishers::Updates;

class MapPublishersTest : public testing::TestWithParam<Updates> {
 protected:
  using Grid = nav_msgs::OccupancyGrid;

  void SetUp() override {
    if (!MemoryLimit::isPossible()) {
      GTEST_SKIP() << "a sanitizer has allocations of its own";
    }
    publishers_.emplace(node_, "map", rawConfig(), GetParam());
    map_subscriber_ =
        node_.subscribe<Grid>("map", 10, [this](const Grid::ConstPtr& map) { seen_ = *map; });
    updates_subscriber_ = node_.subscribe<map_msgs::OccupancyGridUpdate>(
        "map_updates", 10,
        [this](const map_msgs::OccupancyGridUpdate::ConstPtr& update) { apply(*update); });
    probability_subscriber_ = node_.subscribe<Grid>(
        "map_probability", 10, [this](const Grid::ConstPtr& map) { probability_ = *map; });
    path_subscriber_ = node_.subscribe<nav_msgs::Path>(
        "path", 10, [this](const nav_msgs::Path::ConstPtr& path) { path_ = *path; });
    publish(few_);
  }

  void apply(const map_msgs::OccupancyGridUpdate& update) {
    for (std::uint32_t y = 0; y < update.height; ++y) {
      for (std::uint32_t x = 0; x < update.width; ++x) {
        const auto cell = (static_cast<std::size_t>(update.y) + y) * seen_.info.width +
                          static_cast<std::size_t>(update.x) + x;
        seen_.data.at(cell) = update.data.at(std::size_t{y} * update.width + x);
      }
    }
  }

  /// Publishes a map, and waits until all of it was seen.
  void publish(const std::shared_ptr<const Snapshot>& snapshot) {
    publishers_->publish(snapshot);
    const std_msgs::Header header;
    const auto map = toTrinaryGrid(snapshot->belief, header).data;
    const auto probability = toProbabilityGrid(snapshot->probability, header).data;
    const ros::SteadyTime deadline = ros::SteadyTime::now() + ros::WallDuration(5.0);
    const auto is_seen = [&] {
      return seen_.data == map && probability_.data == probability &&
             path_.poses.size() == snapshot->path.size();
    };
    while (!is_seen() && ros::SteadyTime::now() < deadline) {
      ros::spinOnce();
      ros::WallDuration(0.0005).sleep();
    }
    EXPECT_TRUE(seen_.data == map);
    EXPECT_TRUE(probability_.data == probability);
    EXPECT_EQ(path_.poses.size(), snapshot->path.size());
  }

  ros::NodeHandle node_;
  const std::shared_ptr<const Snapshot> few_ =
      mapperOf({reading(0, 0.03, 1.02, -40), reading(1, 0.13, 1.02, -40)}).infer();
  const std::shared_ptr<const Snapshot> many_ = mapperOf(drive()).infer();
  std::optional<MapPublishers> publishers_;
  Grid seen_, probability_;
  nav_msgs::Path path_;
  ros::Subscriber map_subscriber_, updates_subscriber_, probability_subscriber_, path_subscriber_;
};

TEST_P(MapPublishersTest, AfterAFailureAnywhereTheNextCallPublishesEverything) {
  bool has_failed = true;
  int failures = 0;
  for (int nth = 1; has_failed && !HasFailure(); nth += 1 + nth / 8) {
    try {
      const FailingAllocations shortage = FailingAllocations::ofNth(nth);
      publishers_->publish(many_);
      has_failed = false;
    } catch (const std::bad_alloc&) {
      ++failures;
    }
    SCOPED_TRACE("allocation " + std::to_string(nth));
    publish(many_);
    publish(few_);
  }
  EXPECT_FALSE(has_failed);
  EXPECT_GT(failures, 20);
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutUpdates, MapPublishersTest,
                         testing::Values(Updates::kNone, Updates::kRectangles));

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "map_publishers_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
