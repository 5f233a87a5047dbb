// Random messages, one of a hundred hostile, into a loaded nodelet: it maps as if only the good
// ones had come.
//
// SFW_MESSAGES is their number. scripts/soak --messages runs a million.

#include "hostile_messages.h"

#include <gtest/gtest.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>
#include <type_traits>

#include "mapping_nodelet_world.h"
#include "ros/service_call.h"
#include "shape_of.h"
#include "support/slowdown.h"

namespace sfw {
namespace {

constexpr int kBurst = 500;         // messages that the nodelet takes before the next ones
constexpr double kBurstS = 0.5;     // from one burst to the next
constexpr int kHostileShare = 100;  // one of so many

int messageCount() {
  const char* count = std::getenv("SFW_MESSAGES");
  return count == nullptr ? static_cast<int>(100'000 / kSlowdown) : std::atoi(count);
}

/// The first line that two files do not share, of each; empty if they are equal.
std::string firstDifference(const std::string& a, const std::string& b) {
  std::istringstream left(a), right(b);
  std::string of_left, of_right;
  for (int line = 1; left || right; ++line) {
    of_left = of_right = "(end)";
    std::getline(left, of_left);
    std::getline(right, of_right);
    if (of_left != of_right) {
      return "line " + std::to_string(line) + ": " + of_left + " instead of " + of_right;
    }
  }
  return "";
}

class HostileMessagesTest : public NodeletWorld {
 protected:
  enum class Hostile { kNo, kYes };

  void SetUp() override {
    NodeletWorld::SetUp();
    ros::NodeHandle node(name_);
    links_ = node.advertise<wireless_msgs::Connection>("connection", 10);
    bumpers_ = node.advertise<std_msgs::Bool>("contact", 10);
    clouds_ = node.advertise<sensor_msgs::PointCloud2>("contact_points", 10);
    ros::param::set(name_ + "/mapping/ros/publish_rate", 0.5);
    ros::param::set(name_ + "/mapping/ros/max_waiting", 50'000);
    ros::param::set(name_ + "/mapping/ros/autosave_period", 0.0);
  }

  /// Publishes without a copy, so that the message's owners tell whether the nodelet is done with
  /// it.
  template <class Message>
  void send(const ros::Publisher& publisher, const Message& message) {
    if constexpr (std::is_same_v<Message, tf2_msgs::TFMessage>) {
      publishShared(publisher, boost::make_shared<Message>(message));
    } else {
      publishShared(publisher, shapeOf(message));
    }
  }

  void send(const HostileMessages::Message& message) {
    std::visit(
        [this](const auto& content) {
          using Content = std::decay_t<decltype(content)>;
          if constexpr (std::is_same_v<Content, structure_from_wifi::WifiScan>) {
            send(scans_, content);
          } else if constexpr (std::is_same_v<Content, wireless_msgs::Connection>) {
            send(links_, content);
          } else if constexpr (std::is_same_v<Content, sensor_msgs::PointCloud2>) {
            send(clouds_, content);
          } else {
            send(transforms_, content);
          }
        },
        message);
  }

  template <class Message>
  void publishShared(const ros::Publisher& publisher, const boost::shared_ptr<Message>& message) {
    publisher.publish(message);
    under_way_.push_back(message);
  }

  /// Waits until the nodelet has taken all messages, and tried to locate their readings.
  void awaitTaken() {
    for (const auto& message : under_way_) {
      ASSERT_TRUE(spinUntil([&] { return message.use_count() == 1; }, 20.0 * kSlowdown));
    }
    under_way_.clear();
    // Its locating thread answers between two of its steps, so a whole step lies between two calls.
    for (int i = 0; i < 2; ++i) {
      std_srvs::SetBool pause;
      ASSERT_TRUE(callService(name_ + "/mapping/pause", pause));
    }
  }

  void pose(double seconds) {
    tf2_msgs::TFMessage message;
    message.transforms = {transform(seconds, "map", "base_link",
                                    4.0 + 3.0 * std::sin(0.05 * seconds),
                                    3.0 + 2.0 * std::sin(0.083 * seconds))};
    send(transforms_, message);
  }

  void sendGood(std::mt19937_64& random, double seconds) {
    const auto rssi_dbm = static_cast<float>(-40 - static_cast<int>(random() % 40));
    switch (random() % 20) {
      case 0: {
        wireless_msgs::Connection link;
        link.bssid = kNear;
        link.signal_level = static_cast<std::int16_t>(rssi_dbm);
        send(links_, link);
        break;
      }
      case 1: {
        std_msgs::Bool contact;
        contact.data = random() % 50 == 0 ? 1 : 0;
        send(bumpers_, contact);
        break;
      }
      default: {
        structure_from_wifi::WifiScan scan =
            scanOf({{kNear, rssi_dbm}, {kFar, -100.0F - rssi_dbm}});
        scan.header.stamp = at(seconds);
        send(scans_, scan);
      }
    }
  }

  /// Maps a drive with all messages, and saves it.
  struct Files {
    std::string readings, contacts, map, octomap;
  };
  Files mapped(int messages, Hostile hostile) {
    load();
    EXPECT_TRUE(spinUntil(
        [&] {
          return links_.getNumSubscribers() > 0 && bumpers_.getNumSubscribers() > 0 &&
                 clouds_.getNumSubscribers() > 0;
        },
        5.0));
    std::mt19937_64 random(1);
    HostileMessages broken(kNear, 2);
    const int bursts = messages / kBurst;
    pose(0.0);
    for (int burst = 0; burst < bursts && !HasFailure(); ++burst) {
      const double start_s = kBurstS * burst;
      ros::Time::setNow(at(start_s + kBurstS));
      pose(start_s + kBurstS);
      awaitTaken();
      for (int i = 0; i < kBurst; ++i) {
        // Hostile ones come beside good ones and take no random number from them.
        const double seconds = start_s + kBurstS * i / kBurst;
        if (i % kHostileShare != kHostileShare / 2) {
          sendGood(random, seconds);
        } else if (hostile == Hostile::kYes) {
          send(broken.next(at(seconds)));
        }
      }
      awaitTaken();
    }
    Files files{savedFile("readings.csv"), savedFile("contacts.csv"), savedFile("map.pgm"),
                savedFile("map.bt")};
    secondsToUnload();
    ros::Time::setNow(start_);
    return files;
  }

  ros::Publisher links_, bumpers_, clouds_;
  std::vector<boost::shared_ptr<const void>> under_way_;
};

TEST_F(HostileMessagesTest, ChangeNoMap) {
  const int messages = messageCount();
  const ros::SteadyTime start = ros::SteadyTime::now();
  const Files mixed = mapped(messages, Hostile::kYes);
  std::printf("%d messages took %.1f s\n", messages, (ros::SteadyTime::now() - start).toSec());
  const Files good = mapped(messages, Hostile::kNo);
  EXPECT_GT(std::count(good.readings.begin(), good.readings.end(), '\n'), messages);
  EXPECT_EQ(firstDifference(mixed.readings, good.readings), "");
  EXPECT_EQ(firstDifference(mixed.contacts, good.contacts), "");
  EXPECT_TRUE(mixed.map == good.map) << "the maps differ";
  EXPECT_TRUE(mixed.octomap == good.octomap) << "the OctoMaps differ";
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "hostile_messages_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
